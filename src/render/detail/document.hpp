#pragma once

#include <functional>
#include <iosfwd>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "exact/exact.hpp"
#include "render/render.hpp"

typedef struct _cairo cairo_t;
typedef struct _cairo_surface cairo_surface_t;

namespace algae {

/// The extension of a file name, in small letters; empty if there is none.
///
/// Example: ending_of("figures.d/koch.SVG") == "svg"
/// Example: ending_of("figures.d/koch").empty()
std::string ending_of(std::string_view path);

/// The longest side of a format: pixels in png; in other formats points, as PDF readers accept (ISO 32000).
inline constexpr double largest_png = 20'000, largest_vector = 14'400;
inline double largest(PictureFormat format) {
    return format == PictureFormat::png ? largest_png : largest_vector;
}

/// The colour behind a picture: the one wanted, or none if that is `transparent`. By default white in png and none in
/// other formats.
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

/// Opens the file or the stream, calls `write` and completes the output. If `write` throws, no file appears.
void write_to(const Target& target, const std::function<void(Output&)>& write);

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
/// always the same: without dates and numbers of the process.
class Document {
public:
    /// `background`: nothing for none. In png, sizes are whole pixels.
    Document(PictureFormat format, double width, double height, std::optional<Colour> background,
             Output& output, const Budget& budget);
    Document(const Document&) = delete;
    Document& operator=(const Document&) = delete;
    /// Without `finish` the output stays incomplete.
    ~Document();

    cairo_t* context() const { return context_; }
    PictureFormat format() const { return format_; }
    /// What a pdf says of itself; nothing in other formats. Empty texts are left out.
    void say(const std::string& title, const std::string& author);
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

void set_colour(cairo_t* context, const Colour& colour, double opacity = 1);

/// Chooses the letters of texts: their family and their size.
void choose_font(cairo_t* context, const char* family, double size, bool bold = false);

/// The width of a text in the chosen letters.
double text_width(cairo_t* context, const std::string& text);

/// Writes a text that begins at a point of its base line.
void show_text(cairo_t* context, const std::string& text, double x, double y);

/// A line from one point to another, stroked.
void draw_line(cairo_t* context, const Point& from, const Point& to);

/// Fills the path in one colour and strokes it in another.
void fill_and_outline(cairo_t* context, const Colour& fill, const Colour& outline, double width);

/// Throws Error if a coordinate, or a sum of some, is not a number.
void must_be_finite(double coordinates);

/// The index of the extension of a file name among these names, in any case; nothing if it is not among them.
std::optional<std::size_t> format_of(std::span<const char* const> names, std::string_view path);

/// Throws Error if Cairo is in a state of error on this context.
void check_cairo(cairo_t* context);

/// Cairo objects that end with their owners.
struct CairoRelease {
    void operator()(cairo_t* context) const;
    void operator()(cairo_surface_t* surface) const;
};
using OwnedContext = std::unique_ptr<cairo_t, CairoRelease>;
using OwnedSurface = std::unique_ptr<cairo_surface_t, CairoRelease>;

/// An image of this size in whole pixels: black if it is opaque, otherwise transparent.
OwnedSurface blank_image(double width, double height, bool opaque);

/// A text for HTML and XML, between tags or within double quotes.
///
/// Example: escaped_markup("a<b & \"c\"") == "a&lt;b &amp; &quot;c&quot;"
std::string escaped_markup(std::string_view text);

}  // namespace algae
