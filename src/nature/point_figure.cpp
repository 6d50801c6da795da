#include "nature/point_figure.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/error.hpp"

namespace algae {

namespace {

constexpr std::uint64_t dots_between_checks = 1 << 16;

void draw_dot(Canvas& canvas, Point place) {
    canvas.move_to(place);
    canvas.line_to(place);
}

}  // namespace

PointFigure::PointFigure(std::vector<Dot> dots, Settings settings)
    : count_(dots.size()), settings_(std::move(settings)) {
    for (const Dot& dot : dots) box_.add(dot.place);
    send_ = [kept = std::make_shared<const std::vector<Dot>>(std::move(dots))](
                const TakeDots& take, const Budget& budget) {
        for (std::size_t i = 0; i < kept->size(); i += dots_between_checks) {
            budget.check();
            take(std::span(*kept).subspan(
                i, std::min<std::size_t>(dots_between_checks, kept->size() - i)));
        }
    };
    find_facts();
}

PointFigure::PointFigure(SendDots send, std::uint64_t count, const Box& box, Settings settings)
    : send_(std::move(send)), count_(count), box_(box), settings_(std::move(settings)) {
    find_facts();
}

void PointFigure::find_facts() {
    facts_.segments = Integer(count_);
    facts_.step = 0;
    if (box_.empty) return;
    facts_.low = {Coordinate(box_.low.x), Coordinate(box_.low.y)};
    facts_.high = {Coordinate(box_.high.x), Coordinate(box_.high.y)};
}

void PointFigure::draw(Canvas& canvas, double resolution, const Budget& budget) const {
    if (resolution > 0) return draw_cells(canvas, resolution, budget);
    const bool position = canvas.wants_position();
    std::uint64_t done = 0;
    std::uint32_t colour = 0;
    send_(
        [&](std::span<const Dot> dots) {
            for (const Dot& dot : dots) {
                if (position)
                    canvas.position(static_cast<double>(done) / static_cast<double>(count_));
                if (dot.colour != colour) canvas.colour(colour = dot.colour);
                draw_dot(canvas, dot.place);
                ++done;
            }
        },
        budget);
}

void PointFigure::draw_cells(Canvas& canvas, double resolution, const Budget& budget) const {
    if (box_.empty) return;
    const auto cells = [&](double length) {
        return static_cast<std::uint64_t>(length / resolution) + 1;
    };
    if (!(box_.breadth() / resolution < 1e9 && box_.height() / resolution < 1e9))
        throw Error("a picture of points has more than 10^9 cells a side");
    const std::uint64_t columns = cells(box_.breadth()), rows = cells(box_.height());
    budget.check_memory(columns * rows, "the cells of a picture of points");
    std::vector<std::uint8_t> grid(columns * rows);  // 0: blank, otherwise 1 + the colour
    const double inverse = 1 / resolution, left = box_.low.x, low = box_.low.y;
    bool colours_used[256] = {};
    send_(
        [&](std::span<const Dot> dots) {
            for (const Dot& dot : dots) {
                const double x = (dot.place.x - left) * inverse, y = (dot.place.y - low) * inverse;
                if (!(x >= 0 && y >= 0)) continue;
                const auto column = static_cast<std::uint64_t>(x),
                           row = static_cast<std::uint64_t>(y);
                if (column >= columns || row >= rows) continue;
                const auto kept = static_cast<std::uint8_t>(
                    dot.colour < 255 ? dot.colour + 1 : (dot.colour - 255) % 254 + 2);
                grid[row * columns + column] = kept;
                colours_used[kept] = true;
            }
        },
        budget);
    for (std::size_t kept = 1; kept < 256; ++kept) {
        if (!colours_used[kept]) continue;
        canvas.colour(static_cast<std::uint32_t>(kept - 1));
        for (std::uint64_t row = 0; row < rows; ++row) {
            if ((row & 0x3f) == 0) budget.check();
            const std::uint8_t* const line = grid.data() + row * columns;
            for (std::uint64_t column = 0; column < columns; ++column)
                if (line[column] == kept)
                    draw_dot(canvas, {left + (static_cast<double>(column) + 0.5) * resolution,
                                      low + (static_cast<double>(row) + 0.5) * resolution});
        }
    }
}

}  // namespace algae
