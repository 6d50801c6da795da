#pragma once

// Figures that are not drawn by a turtle: lines and polygons, points, links.

#include <cmath>

#include "nature/detail/checks.hpp"
#include "nature/nature.hpp"

namespace algae {

/// The colour so far on the way from one to the other.
///
/// Example: mixed({0, 0, 0}, {1, 1, 1}, 0.25).red == 0.25
Colour mixed(const Colour& from, const Colour& to, double share);

/// A figure that knows its box and its facts from the beginning.
class PlainFigure : public Figure {
public:
    const Box& box() const override { return box_; }
    const Integer& segments() const override { return facts_.segments; }
    const Facts& facts() const override { return facts_; }
    std::optional<std::uint64_t> strokes() const override { return strokes_; }
    const FigureStyle& style() const override { return style_; }

protected:
    explicit PlainFigure(FigureStyle style) : style_(std::move(style)) {}
    /// Makes the corners of the box, unless it is empty, those of the facts.
    void take_corners();

    FigureStyle style_;
    Box box_;
    Facts facts_;
    std::optional<std::uint64_t> strokes_;
};

/// A broken line, or a filled polygon with these corners.
struct Path {
    std::vector<Point> points;
    std::uint32_t colour = 0;  // its index in the figure's list
    bool filled = false;
    double width = 1;                         // of the line, as a multiple of the figure's own
    std::optional<Colour> paint = {};         // instead of a colour of the list
    std::optional<double> length_width = {};  // instead of `width`: a length in the plane
    bool operator==(const Path&) const = default;
};

/// Lines and polygons, drawn in order. With a resolution, points of a line that lie nearer than
/// that to the last one drawn are left out, and all of a line that goes on within it. The length of
/// a segment among its facts is the mean of all.
class PathFigure : public PlainFigure {
public:
    explicit PathFigure(std::vector<Path> paths, FigureStyle style = {});
    void draw(Canvas& canvas, double resolution, const Budget& budget) const override;

    const std::vector<Path>& paths() const { return paths_; }

private:
    std::vector<Path> paths_;
};

/// A point of a figure, with the index of its colour in the figure's list.
struct Dot {
    Point place;
    std::uint32_t colour = 0;
    bool operator==(const Dot&) const = default;
};

/// Takes some dots, in drawing order.
using TakeDots = std::function<void(std::span<const Dot>)>;

/// Sends all dots of a figure, the same ones each time; some thousands at a time are fast.
using SendDots = std::function<void(const TakeDots&, const Budget&)>;

/// Many points, each drawn as a round dot as wide as the figure's line width (one pixel, or 1 point
/// of vector formats, unless `width` says otherwise). With a resolution, each cell of that size is
/// drawn once, in the colour of its last dot: any number of dots costs their making, and the memory
/// of a byte a cell.
class PointFigure : public PlainFigure {
public:
    /// The dots are made whenever they are drawn; `count` of them, within `box`. Colours beyond 255
    /// start again from 1 where there is a resolution.
    PointFigure(SendDots send, std::uint64_t count, const Box& box, FigureStyle style = {});

    void draw(Canvas& canvas, double resolution, const Budget& budget) const override;

private:
    void draw_cells(Canvas& canvas, double resolution, const Budget& budget) const;

    SendDots send_;
};

/// Many separate strokes of one thickness with round ends, drawn in order: such as the particles of
/// an aggregate, each joined to the one that it touches.
class LinkFigure : public PlainFigure {
public:
    /// `thickness` is a length in the plane, or 0 for the line width; `detail` that of a link.
    LinkFigure(std::vector<Link> links, double thickness, double detail, FigureStyle style = {});

    void draw(Canvas& canvas, double resolution, const Budget& budget) const override;

private:
    std::vector<Link> links_;
    double thickness_;
};

/// A figure of a generator among others: messages call it by both names, and its own stands underneath.
GeneratorFigure pictured(const Generator& of, std::unique_ptr<Figure> figure,
                         const std::string& what);
GeneratorFigure pictured(const Generator& of, std::vector<Path> paths, const std::string& what);

/// The line through points with the least squares of their vertical distances from it. Where all lie
/// above each other none is best, and it is level.
struct BestLine {
    double slope = 0, height = 0;  // height at 0
    bool is_level = true;
};

/// Example: best_line({{0, 1}, {1, 3}, {2, 5}}).slope == 2
BestLine best_line(const std::vector<Point>& points);

/// The graph of evenly spaced values, as a line in a box of `breadth` by 1: its lowest value is at
/// the bottom and its highest at the top. Values that are all the same lie at the bottom.
///
/// Example: graph_path({2, 4, 3}, 2) == std::vector<Point>{{0, 0}, {1, 1}, {2, 0.5}}
std::vector<Point> graph_path(const std::vector<double>& values, double breadth);

}  // namespace algae
