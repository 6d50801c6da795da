#pragma once
// render: figures to pictures. The only room that knows picture formats; Cairo in .cpp files only.

#include <cstddef>
#include <cstdint>
#include <iosfwd>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/budget.hpp"
#include "turtle/figure.hpp"

namespace algae {

enum class PictureFormat { svg, pdf, png, ps, eps };

/// The format that the end of a file's name stands for, in any case.
///
/// Throws Error, listing the formats, if it stands for none.
///
/// Example: picture_format("figures/koch.SVG") == PictureFormat::svg
PictureFormat picture_format(std::string_view path);

/// The name of the format, as at the end of a file's name.
///
/// Example: format_name(PictureFormat::svg) == std::string("svg")
const char* format_name(PictureFormat format);

/// A text at a point of a figure, in the units of the file.
struct PointLabel {
    std::string text;
    Vector place;
};

/// How a picture is made. Lengths are points (1/72 inch) in svg, pdf, ps and eps, pixels in png.
struct PictureOptions {
    /// The size of the whole picture. With one of the two, the other follows from the figure; with
    /// neither, the longer side is 600 points or 1000 pixels.
    std::optional<double> width, height;
    /// The blank border, at least half a line width so that no stroke is cut off.
    double margin = 10;
    /// Instead of the figure's own `width`, or of 1 (0.6 points in a row of panels).
    std::optional<double> line_width;
    /// Instead of the figure's own `colour`: names, `#rrggbb` or `along`.
    std::vector<std::string> colours;
    /// A colour or `transparent`. Nothing: white in png, no background elsewhere.
    std::optional<std::string> background;
    /// The height of the letters of captions. Nothing: 1/50 of the picture's longer side, down to
    /// 1/80 where panels share a row.
    std::optional<double> font_size;
    /// Pages and panels: one scale for all, as large as the largest figure allows, and all figures
    /// standing on one line.
    bool common_scale = false;
    /// Panels: how many in a row. Nothing: up to 5 in one row, then rows of equal length.
    std::optional<std::size_t> columns;
    /// A bar below the figure that shows a round length in the units of the file.
    bool scale_bar = false;
    std::vector<PointLabel> labels;
    /// Strokes end flat at their ends instead of round.
    bool flat_ends = false;

    enum class Route {
        automatic,  // strokes; cells where segments are finer than the picture can show
        strokes,    // every stroke by Cairo
        cells,      // cells in png, an image in the other formats
    };
    Route route = Route::automatic;
    /// A vector format holds at most this many strokes; a figure with more is put in as an image
    /// of 4 pixels a point.
    std::uint64_t most_strokes = 5'000'000;
};

/// A figure of a picture: what messages call it ("generation 3 of koch.lsys"), and what is
/// written underneath.
struct Plate {
    const Figure* figure = nullptr;
    std::string name;
    std::string caption;
};

/// What was drawn.
struct Drawn {
    double width = 0, height = 0;  // of the picture or of each page
    std::uint64_t lines = 0;       // lines and polygons drawn, after parts were joined
    std::uint64_t polygons = 0;
    bool as_image = false;           // a vector format that holds an image
    bool fine = false;               // some segments were finer than the picture can show
    std::vector<std::size_t> blank;  // plates in which nothing is drawn
};

/// Writes the picture of one figure to a file. The file appears complete or not at all, and equal
/// figures make equal files, byte for byte.
///
/// Throws Error on options out of range, an unknown colour, a figure without strokes, or a file
/// that cannot be written; BoundReached if the picture needs more memory than the budget has, or
/// past its deadline; Interrupted. One pass over the figure: O(strokes) time; where they are finer
/// than the picture can show, O(pixels) time and memory.
Drawn draw_picture(const Plate& plate, const std::string& path, PictureFormat format,
                   const PictureOptions& options, const Budget& budget,
                   Progress* progress = nullptr);
/// The same to a stream.
Drawn draw_picture(const Plate& plate, std::ostream& stream, PictureFormat format,
                   const PictureOptions& options, const Budget& budget,
                   Progress* progress = nullptr);

/// One page a figure, all pages of one size. Only pdf and ps have pages: Error otherwise. Figures
/// without strokes leave their page blank unless all are without.
Drawn draw_pages(std::span<const Plate> plates, const std::string& path, PictureFormat format,
                 const PictureOptions& options, const Budget& budget, Progress* progress = nullptr);
Drawn draw_pages(std::span<const Plate> plates, std::ostream& stream, PictureFormat format,
                 const PictureOptions& options, const Budget& budget, Progress* progress = nullptr);

/// All figures side by side, in one row or several, each scaled to fill its cell.
Drawn draw_panels(std::span<const Plate> plates, const std::string& path, PictureFormat format,
                  const PictureOptions& options, const Budget& budget,
                  Progress* progress = nullptr);
Drawn draw_panels(std::span<const Plate> plates, std::ostream& stream, PictureFormat format,
                  const PictureOptions& options, const Budget& budget,
                  Progress* progress = nullptr);

}  // namespace algae
