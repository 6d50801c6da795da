#pragma once

#include <cstdint>
#include <vector>

#include "nature/cells.hpp"
#include "nature/path_figure.hpp"
#include "turtle/figure.hpp"

namespace algae {

/// A grid of cells as unit squares, the first row on top, its lower left corner at (0, -rows). State
/// 0 is left blank, state s has the colour of index s - 1. Other paths may be drawn besides.
class CellFigure : public Figure {
public:
    CellFigure(CellGrid grid, std::vector<Path> besides, Settings settings = {});

    const Box& box() const override { return box_; }
    /// None: cells are polygons.
    const Integer& segments() const override { return facts_.segments; }
    const Facts& facts() const override { return facts_; }
    std::optional<std::uint64_t> strokes() const override { return strokes_; }
    const Settings& settings() const override { return settings_; }
    /// Cells of one state side by side are one rectangle. Without a resolution, rectangles below each
    /// other are tied together, so that no light falls between them.
    void draw(Canvas& canvas, double resolution, const Budget& budget) const override;

private:
    CellGrid grid_;
    std::vector<Path> besides_;
    Settings settings_;
    Facts facts_;
    Box box_;
    std::uint64_t strokes_ = 0;
};

}  // namespace algae
