#include "nature/cell_figure.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace algae {

namespace {

/// Cells of one state side by side, from `first` up to `last`, which is not one of them.
struct Run {
    std::size_t first, last;
    std::uint8_t state;
};

std::vector<Run> runs(const CellGrid& grid, std::size_t row) {
    std::vector<Run> found;
    for (std::size_t x = 0; x < grid.columns;) {
        const std::uint8_t state = grid.at(x, row);
        std::size_t end = x + 1;
        while (end < grid.columns && grid.at(end, row) == state) ++end;
        if (state != 0) found.push_back({x, end, state});
        x = end;
    }
    return found;
}

}  // namespace

CellFigure::CellFigure(CellGrid grid, std::vector<Path> besides, Settings settings)
    : grid_(std::move(grid)), besides_(std::move(besides)), settings_(std::move(settings)) {
    box_.add(Point{0, -static_cast<double>(grid_.rows)});
    box_.add(Point{static_cast<double>(grid_.columns), 0});
    for (std::size_t row = 0; row < grid_.rows; ++row) strokes_ += runs(grid_, row).size();
    for (const Path& path : besides_) {
        for (const Point& point : path.points) box_.add(point);
        strokes_ += path.points.size();
    }
    facts_.segments = Integer(0);
    facts_.step = 1;
    facts_.low = {Coordinate(box_.low.x), Coordinate(box_.low.y)};
    facts_.high = {Coordinate(box_.high.x), Coordinate(box_.high.y)};
}

void CellFigure::draw(Canvas& canvas, double resolution, const Budget& budget) const {
    constexpr double tie = 0.25;  // how far ties reach into the cells on both sides
    std::uint32_t colour = 0;
    const auto rectangle = [&](double left, double right, double low, double high,
                               std::uint8_t state) {
        if (state - 1u != colour) canvas.colour(colour = state - 1u);
        const std::array<Point, 4> corners{
            {{left, low}, {right, low}, {right, high}, {left, high}}};
        canvas.polygon(corners);
    };
    std::vector<Run> above;
    for (std::size_t row = 0; row < grid_.rows; ++row) {
        if ((row & 0x3f) == 0) budget.check();
        if (canvas.wants_position())
            canvas.position(static_cast<double>(row) / static_cast<double>(grid_.rows));
        const double top = -static_cast<double>(row);
        std::vector<Run> here = runs(grid_, row);
        for (const Run& run : here)
            rectangle(static_cast<double>(run.first), static_cast<double>(run.last), top - 1, top,
                      run.state);
        if (resolution <= 0) {
            std::size_t i = 0;
            for (const Run& run : here) {
                while (i < above.size() && above[i].last <= run.first) ++i;
                for (std::size_t k = i; k < above.size() && above[k].first < run.last; ++k)
                    if (above[k].state == run.state)
                        rectangle(static_cast<double>(std::max(run.first, above[k].first)),
                                  static_cast<double>(std::min(run.last, above[k].last)), top - tie,
                                  top + tie, run.state);
            }
        }
        above = std::move(here);
    }
    if (colour != 0) canvas.colour(0);
    if (!besides_.empty()) PathFigure(besides_, settings_).draw(canvas, resolution, budget);
}

}  // namespace algae
