#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "turtle/figure.hpp"

namespace algae {

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

/// Lines and polygons, drawn in order. With a resolution, points of a line that lie nearer than that
/// to the last one drawn are left out, and all of a line that goes on within it. The length of a
/// segment among its facts is the mean of all.
class PathFigure : public Figure {
public:
    explicit PathFigure(std::vector<Path> paths, Settings settings = {});

    const Box& box() const override { return box_; }
    const Integer& segments() const override { return facts_.segments; }
    const Facts& facts() const override { return facts_; }
    std::optional<std::uint64_t> strokes() const override { return strokes_; }
    const Settings& settings() const override { return settings_; }
    void draw(Canvas& canvas, double resolution, const Budget& budget) const override;

    const std::vector<Path>& paths() const { return paths_; }

private:
    std::vector<Path> paths_;
    Settings settings_;
    Facts facts_;
    Box box_;
    std::uint64_t strokes_ = 0;
};

}  // namespace algae
