#pragma once

#include <exception>
#include <memory>
#include <optional>
#include <string>

#include "base/budget.hpp"
#include "render/output.hpp"
#include "render/picture.hpp"

typedef struct _cairo cairo_t;
typedef struct _cairo_surface cairo_surface_t;

namespace algae {

/// A Cairo surface of one of the formats, open to be drawn on. Its bytes go to an Output and are
/// the same whenever it is made: no dates, no numbers of the process.
class Document {
public:
    /// `background`: nothing for none. In png, sizes are whole pixels.
    Document(PictureFormat format, double width, double height, std::optional<Colour> background,
             Output& output, const Budget& budget);
    Document(const Document&) = delete;
    Document& operator=(const Document&) = delete;
    /// Without `finish` the output is left incomplete.
    ~Document();

    cairo_t* context() const { return context_; }
    PictureFormat format() const { return format_; }
    /// Opens another page of the same size.
    void next_page();
    /// Completes the document. Throws what went wrong while writing.
    void finish();

private:
    struct Sink;

    void paint_background();
    void check() const;

    PictureFormat format_;
    std::optional<Colour> background_;
    std::unique_ptr<Sink> sink_;
    cairo_surface_t* surface_ = nullptr;
    cairo_t* context_ = nullptr;
};

/// Throws Error if Cairo is in a state of error on this context.
void check_cairo(cairo_t* context);

}  // namespace algae
