#pragma once

#include <functional>
#include <iosfwd>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "exact/exact.hpp"
#include "render/render.hpp"

typedef struct _cairo cairo_t;
typedef struct _cairo_surface cairo_surface_t;

namespace algae {

/// What stands behind the last dot of a file's name, in small letters; empty if there is none.
///
/// Example: ending_of("figures.d/koch.SVG") == "svg"
/// Example: ending_of("figures.d/koch").empty()
std::string ending_of(std::string_view path);

/// The longest side that a format has: pixels in png; elsewhere points, what PDF readers take (ISO 32000).
inline constexpr double largest_png = 20'000, largest_vector = 14'400;
inline double largest(PictureFormat format) {
    return format == PictureFormat::png ? largest_png : largest_vector;
}

/// The colour behind a picture: the one wanted, or none if that is `transparent`. With nothing wanted, white in png and none
/// elsewhere.
std::optional<Colour> background_of(const std::optional<std::string>& wanted, PictureFormat format);

/// A stream, such as standard output.
class StreamOutput final : public Output {
public:
    explicit StreamOutput(std::ostream& stream) : stream_(stream) {}
    void write(const char* bytes, std::size_t count) override;
    /// Throws Error if the stream cannot pass on what it holds.
    void finish();

private:
    void check() const;

    std::ostream& stream_;
};

/// Opens the file or the stream, has it written and completes it. If `write` throws, no file appears.
void write_to(const std::string& path, const std::function<void(Output&)>& write);
void write_to(std::ostream& stream, const std::function<void(Output&)>& write);

/// Takes out of a PostScript document the line that says when it was made, so that equal figures
/// are equal files.
class UndatedOutput final : public Output {
public:
    explicit UndatedOutput(Output& next) : next_(next) {}
    void write(const char* bytes, std::size_t count) override;
    /// Passes on what was held back. Call once, at the end.
    void finish();

private:
    Output& next_;
    std::string header_;
    bool in_header_ = true;
};

/// Numbers the surfaces and images of an SVG document from 1 in order of appearance: Cairo's own
/// numbers count everything the process has drawn before.
class RenumberedOutput final : public Output {
public:
    explicit RenumberedOutput(Output& next) : next_(next) {}
    void write(const char* bytes, std::size_t count) override;
    /// Passes on what was held back. Call once, at the end.
    void finish();

private:
    void pass_on(bool at_end);

    Output& next_;
    std::string held_;
    std::map<std::string, std::size_t> numbers_;
};

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

/// Cairo objects that end with their owners.
struct CairoRelease {
    void operator()(cairo_t* context) const;
    void operator()(cairo_surface_t* surface) const;
};
using OwnedContext = std::unique_ptr<cairo_t, CairoRelease>;
using OwnedSurface = std::unique_ptr<cairo_surface_t, CairoRelease>;

/// An image of so many whole pixels: black if it is opaque, otherwise transparent.
OwnedSurface blank_image(double width, double height, bool opaque);

/// A text as HTML and XML have it between tags and within double quotes.
///
/// Example: escaped_markup("a<b & \"c\"") == "a&lt;b &amp; &quot;c&quot;"
std::string escaped_markup(std::string_view text);

}  // namespace algae
