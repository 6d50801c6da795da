#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "exact/exact.hpp"
#include "render/detail/drawing.hpp"
#include "render/render.hpp"

namespace algae {

/// How strokes and polygons look.
struct PathStyle {
    Colour colour;
    std::optional<std::uint32_t> listed;  // its place in the figure's list of colours
    double width = 1;                     // in points of the picture
    std::string letter;                   // that draws it; empty if it is not known
    bool operator==(const PathStyle&) const = default;
};

/// Strokes that go on from each other, or a filled polygon.
struct FigurePath {
    std::uint32_t style = 0;
    bool filled = false;
    std::vector<Point> points;  // in the units of the figure
    std::vector<std::uint64_t>
        positions;  // of the letter of each stroke; of a polygon one. Empty for a plotter
};

/// A figure as paths, in the order of its word.
struct FigurePaths {
    std::vector<PathStyle> styles;
    std::vector<FigurePath> paths;
    std::uint64_t strokes = 0, polygons = 0;
};

/// The paths of a figure whose strokes are `width` points wide where a unit is `scale` points long.
FigurePaths paths_of(const FigureSource& source, const std::vector<std::string>& colours,
                     double width, double scale, const Budget& budget);

/// Leaves out the paths of a picture of something in space that later ones hide, as far as the pixels show it that are a quarter of a
/// point wide. O(paths times the pixels of each).
void leave_out_hidden(FigurePaths& figure, const Cell& cell, const Budget& budget);

/// What a plotter draws instead: each segment once, in as few paths as there can be for each colour and width, in an order
/// with short ways between them. `grid`: points that are this near are the same. Notes in `drawn` what was left out.
///
/// Paths are trails of Euler: a component with k ends where an odd number of segments meet needs k/2 of them, or 1
/// (Hierholzer 1873). The next path begins at the end nearest to where the pen is.
FigurePaths for_plotter(const FigurePaths& figure, double grid, const Budget& budget,
                        FigureTextDrawn& drawn);

/// The way with the pen up, from the start of the first path to the last, in the order given.
double travel_of(const FigurePaths& figure);

/// The exact coordinates of points of a figure, where there are any.
class ExactPoints {
public:
    explicit ExactPoints(const FigureSource& source);
    bool known() const { return !texts_.empty(); }
    /// The two coordinates, "3*sqrt(3)/2"; empty texts for a point that is not known.
    const std::pair<std::string, std::string>& at(Point point) const;

private:
    std::pair<std::int64_t, std::int64_t> cell(Point point) const;

    double grid_ = 1;
    std::map<std::pair<std::int64_t, std::int64_t>, std::pair<std::string, std::string>> texts_;
};

/// factor times the real (or imaginary) part of a number of the ring, plus an offset, in square roots and, where these do not
/// do, cosines of parts of pi.
///
/// Example: exact_part(CyclotomicRing(12), CyclotomicRing(12).zeta(1), false, 3, 0) == "3*sqrt(3)/2"
std::string exact_part(const CyclotomicRing& ring, const CyclotomicInteger& value, bool imaginary,
                       const Rational& factor, const Rational& offset);

/// What is drawn in one style, as steps of an SVG path.
struct SvgRun {
    std::uint32_t style = 0;
    bool filled = false;
    std::vector<std::string> steps;  // one text, in pieces
};

/// Where the strokes of a figure go while it is drawn, so that they are never in memory together.
struct SvgStream {
    Output& output;
    std::function<void(std::uint32_t)> begin;  // writes what stands before strokes of this style
};

/// A figure with its place on the page.
struct PlacedFigure {
    const FigureSource* source = nullptr;
    FigurePaths paths;
    std::vector<SvgRun> runs = {};  // in place of paths where there are many strokes
    bool in_units = false;          // then they are in whole units
    double units = 100;             // in a point
    Cell cell;
    double width = 1;  // of its strokes, in points
};

/// In how many units a point of a page is divided whose longer side has so many points, for strokes of this length: a hundred, or more
/// where strokes are shorter than 16 units, as long as the page has fewer than 2^24.
///
/// Example: svg_units(600, 1) == 100
/// Example: svg_units(600, 0.03) == 1000
double svg_units(double page, double step);

/// Fills the runs of a figure of many strokes, without the letters that draw them, and the styles of its paths. Notes the numbers of strokes
/// and paths in `drawn`. Each point is within a unit of its place; `page` is the longer side.
///
/// Strokes go straight from the figure's own blocks into text; what occurs again is copied. About 5 bytes a stroke. With a stream, a figure
/// of blocks is in its one run only to the end of what has gone there.
void svg_runs(PlacedFigure& placed, const std::vector<std::string>& colours, double page,
              const Budget& budget, FigureTextDrawn& drawn, const SvgStream* stream = nullptr);

/// All that a writer of a format needs.
struct FigureDocument {
    std::vector<PlacedFigure> figures;
    const Plan* plan = nullptr;
    const FigureTextOptions* options = nullptr;
    std::string head;  // what the figures are, in a line
};

// A writer for each format.
std::string tikz_text(const FigureDocument& document);
std::string typst_text(const FigureDocument& document);
std::string csv_text(const FigureDocument& document, FigureTextDrawn& drawn);
std::string geojson_text(const FigureDocument& document, FigureTextDrawn& drawn);
std::string dxf_text(const FigureDocument& document);
std::string page_text(const FigureDocument& document);
std::string abc_text(const FigureDocument& document, FigureTextDrawn& drawn);
std::string midi_text(const FigureDocument& document, FigureTextDrawn& drawn);
/// `draw`, if there is one, calls svg_runs for the only figure.
void write_svg(const FigureDocument& document, Output& output,
               const std::function<void(const SvgStream&)>& draw = {});

/// A number with at most so many digits behind the point, without zeros at the end.
///
/// Example: fixed_text(0.25, 6) == "0.25"
/// Example: fixed_text(-1e-9, 6) == "0"
std::string fixed_text(double value, int digits);

/// The height of letters at which a text is at most so wide.
double fitting_size(const std::string& text, double size, double width);

/// "#rrggbb"
std::string hex_colour(const Colour& colour);

/// A text within a program of a page: no end of the script can stand in it.
///
/// Example: script_string("a<b") == "\"a\\u003cb\""
std::string script_string(std::string_view text);

/// A name for styles, classes and layers: other characters than letters, digits and _ become their codes.
///
/// Example: plain_name("F_l") == "F_l"
/// Example: plain_name("+") == "u2B"
std::string plain_name(std::string_view letter);

}  // namespace algae
