#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "turtle/turtle.hpp"

namespace algae {

/// Where a figure lies in a picture: its units are scaled and its y axis points up, the picture's
/// points down.
struct Frame {
    double scale = 1, x = 0, y = 0;
    Point operator()(Point point) const { return {x + scale * point.x, y - scale * point.y}; }
};

/// A place for one figure and its caption, in the units of the picture.
struct Cell {
    double left = 0, top = 0, width = 0, height = 0;
    Frame frame;
    double caption_top = 0;
};

/// The inputs of a layout. Lengths are those of the picture.
struct LayoutWishes {
    std::optional<double> width, height;
    double longest = 600;  // of the two sides if neither is given
    double margin = 10;    // around the picture; between cells, twice that across
    double gap = 0;        // more of it between cells
    double caption = 0;    // height of the strip under each cell
    std::size_t columns = 1;
    bool common_scale = false;
};

/// The size of a picture and the place of each figure in it.
struct Layout {
    double width = 0, height = 0;
    std::vector<Cell> cells;
};

/// The layout of figures with these boxes in rows of cells of one size. Each figure is in the middle
/// of its cell, or, with one scale for all, in the middle of the lower side. Cells of a row of several
/// are at most twice as high as wide unless the wishes say otherwise.
Layout layout(std::span<const Box> boxes, const LayoutWishes& wishes);

/// One page for each figure, all of the size that holds the largest in each direction.
std::vector<Layout> page_layouts(std::span<const Box> boxes, LayoutWishes wishes);

/// How many of these panels stand in a row: all if there are up to 5, otherwise rows as equal as possible. Figures much
/// wider than high stand below each other, in as few columns as keep the picture from becoming too high.
std::size_t panel_columns(std::span<const Box> boxes);

/// A rectangle for a label, by its middle; x to the right, y downward, as in a picture.
struct LabelPlace {
    Point middle;
    double width = 0, height = 0;
};

/// Finds places for labels in a picture where they cover little. Obstacles are added
/// first, and every label that is placed is an obstacle for the next.
class LabelPlaces {
public:
    LabelPlaces(Point low, Point high) : low_(low), high_(high) {}

    /// A line that labels should not cover.
    void avoid(Point from, Point to) { lines_.emplace_back(from, to); }
    /// A disc that labels should not cover.
    void avoid(Point middle, double radius) { discs_.emplace_back(middle, radius); }

    /// The middle, of those offered, at which a label of this size covers least; earlier ones are preferred.
    /// O(places * obstacles).
    LabelPlace place(const std::vector<Point>& middles, double width, double height);

private:
    double cost(const LabelPlace& label) const;

    Point low_, high_;
    std::vector<std::pair<Point, Point>> lines_;
    std::vector<std::pair<Point, double>> discs_;
    std::vector<LabelPlace> labels_;
};

}  // namespace algae
