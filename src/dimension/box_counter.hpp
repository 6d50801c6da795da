#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/budget.hpp"
#include "dimension/cell_set.hpp"
#include "dimension/grid.hpp"
#include "turtle/canvas.hpp"

namespace algae {

/// The cells of one grid that segments touch.
class TouchedCells {
public:
    /// Everything touched must have coordinates of at most `reach` cells from the grid's origin to
    /// the right and upward. Dense if that is small. Throws BoundReached if it is 2^31 or more.
    TouchedCells(const Grid& grid, double reach, const Budget& budget);
    TouchedCells(const Grid& grid, int bits, CellSet::Storage storage, const Budget& budget);

    /// Where the next segment starts; marks its cell.
    void start(Point point) {
        here_ = at(point);
        cell_ = Morton(static_cast<std::uint64_t>(here_.column()),
                       static_cast<std::uint64_t>(here_.row()));
        cells_.mark(cell_);
    }
    /// Marks the cells of the segment from where the last one ended.
    void line_to(Point point) {
        const GridPoint to = at(point);
        if (((to.x ^ here_.x) | (to.y ^ here_.y)) >> Grid::fraction_bits != 0) cross(to);
        here_ = to;
    }
    CellSet& cells() { return cells_; }

private:
    GridPoint at(Point point) const {
        // The comparison also holds back what is not a number.
        const double x = (point.x - grid_.origin.x) * scale_ + 0.5;
        const double y = (point.y - grid_.origin.y) * scale_ + 0.5;
        if (!(x >= 0 && x < end_ && y >= 0 && y < end_)) [[unlikely]]
            outside(point);
        return {static_cast<std::int64_t>(x), static_cast<std::int64_t>(y)};
    }
    /// Marks the cells after the one of `here_` up to the one of `to`.
    void cross(GridPoint to);
    void cross_many(GridPoint to);
    [[noreturn]] void outside(Point point) const;

    Grid grid_;
    double scale_;  // from the figure's units to parts of a cell
    double end_;
    GridPoint here_;
    Morton cell_;  // of here_
    CellSet cells_;
};

/// Counts cells for several grids in one pass: a canvas on which a figure is drawn.
class BoxCounter final : public Canvas {
public:
    explicit BoxCounter(std::vector<TouchedCells> grids) : grids_(std::move(grids)) {}

    void move_to(Point point) override {
        here_ = point;
        lifted_ = true;
    }
    void line_to(Point point) override {
        if (lifted_) {
            for (TouchedCells& grid : grids_) grid.start(here_);
            lifted_ = false;
        }
        for (TouchedCells& grid : grids_) grid.line_to(point);
        ++segments_;
    }
    /// Its outline.
    void polygon(std::span<const Point> corners) override;
    void width(double) override {}
    void width_as_length(double) override {}
    void colour(std::uint32_t) override {}
    void position(double) override {}

    std::vector<TouchedCells>& grids() { return grids_; }
    /// How many segments were drawn.
    std::uint64_t segments() const { return segments_; }

private:
    std::vector<TouchedCells> grids_;
    Point here_;
    bool lifted_ = true;
    std::uint64_t segments_ = 0;
};

}  // namespace algae
