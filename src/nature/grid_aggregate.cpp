#include "nature/grid_aggregate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <numbers>

#include "base/error.hpp"
#include "nature/circle_return.hpp"
#include "nature/gaussian.hpp"
#include "nature/square_exit.hpp"

namespace algae {

namespace {

constexpr std::uint64_t widest_region = 16383;
constexpr int first_half = 7;       // exponent of the grid that a cluster begins with
constexpr double launch_room = 24;  // between the cluster and the circle where particles begin

int half_exponent(std::int64_t reach) {
    return std::max(first_half,
                    static_cast<int>(std::bit_width(static_cast<std::uint64_t>(reach))));
}

std::optional<std::int64_t> checked(std::optional<std::uint64_t> region) {
    if (!region) return std::nullopt;
    if (*region == 0 || *region > widest_region)
        throw Error(
            fmt::format("region: expected 1 to {} cells, found {}", widest_region, *region));
    return static_cast<std::int64_t>(*region);
}

}  // namespace

GridAggregate::GridAggregate(std::uint64_t seed, std::optional<std::uint64_t> region,
                             const Budget& budget)
    : seed_(seed),
      region_(checked(region)),
      budget_(budget),
      occupancy_(half_exponent(region_ ? *region_ + 2 : 0), budget) {
    add({0, 0});
}

void GridAggregate::add(GridCell cell) {
    const std::int64_t reach = std::max(std::abs(cell.x), std::abs(cell.y));
    if (region_ && reach > *region_)
        throw Error(fmt::format("cell ({}, {}) is outside of the region of {} cells", cell.x,
                                cell.y, *region_));
    make_room(reach + 2);
    if (occupancy_.taken(cell.x, cell.y))
        throw Error(fmt::format("cell ({}, {}) is in the cluster already", cell.x, cell.y));
    stay(cell.x, cell.y);
}

GridCell GridAggregate::stay(std::int64_t x, std::int64_t y) {
    const GridCell cell{static_cast<std::int32_t>(x), static_cast<std::int32_t>(y)};
    extent_ = std::max({extent_, std::abs(x), std::abs(y)});
    make_room(extent_ + 2);
    occupancy_.take(x, y);
    cells_.push_back(cell);
    radius_ = std::max(radius_, std::hypot(static_cast<double>(x), static_cast<double>(y)));
    return cell;
}

void GridAggregate::make_room(std::int64_t reach) {
    if (reach < occupancy_.half()) return;
    Occupancy wider(half_exponent(reach), budget_);
    for (const GridCell& cell : cells_) wider.take(cell.x, cell.y);
    occupancy_ = std::move(wider);
}

bool GridAggregate::fills_region() const { return region_ && extent_ >= *region_; }

bool GridAggregate::touches(std::int64_t x, std::int64_t y) const {
    return occupancy_.near(x, y) && (occupancy_.taken(x + 1, y) || occupancy_.taken(x - 1, y) ||
                                     occupancy_.taken(x, y + 1) || occupancy_.taken(x, y - 1));
}

GridCell GridAggregate::free_cell(const Draws& draws, std::uint64_t& number) const {
    const std::uint64_t side = static_cast<std::uint64_t>(2 * *region_ + 1);
    if (cells_.size() >= side * side)
        throw Error(fmt::format("no cell of the region of {} cells is free", *region_));
    for (;;) {
        const auto place = [&] {
            return static_cast<std::int64_t>(Draws::scaled(draws.at(number++), side)) - *region_;
        };
        const std::int64_t x = place(), y = place();
        if (!occupancy_.taken(x, y))
            return {static_cast<std::int32_t>(x), static_cast<std::int32_t>(y)};
    }
}

GridCell GridAggregate::on_circle(double angle) const {
    const double circle = radius_ + launch_room;
    return {static_cast<std::int32_t>(std::lround(circle * std::cos(angle))),
            static_cast<std::int32_t>(std::lround(circle * std::sin(angle)))};
}

GridCell GridAggregate::grow_by_steps() {
    if (!region_) throw Error("expected a region, which single steps need");
    const Draws draws(seed_, cells_.size());
    std::uint64_t number = 0;
    GridCell here = free_cell(draws, number);
    while (!touches(here.x, here.y)) {
        if (number % 4096 == 0) budget_.check();
        switch (draws.at(number++) >> 62) {
            case 0:
                ++here.x;
                break;
            case 1:
                --here.x;
                break;
            case 2:
                ++here.y;
                break;
            default:
                --here.y;
                break;
        }
        if (std::max(std::abs(here.x), std::abs(here.y)) > *region_)
            here = free_cell(draws, number);
    }
    return stay(here.x, here.y);
}

GridCell GridAggregate::grow() {
    const SquareExits& exits = SquareExits::tables();
    const Draws draws(seed_, cells_.size());
    std::uint64_t number = 0;
    const double circle = radius_ + launch_room;
    GridCell begin = region_ ? free_cell(draws, number)
                             : on_circle(2 * std::numbers::pi * unit_interval(draws.at(number++)));
    std::int64_t x = begin.x, y = begin.y;
    int hint = 0;
    for (std::uint64_t jumps = 0;; ++jumps) {
        if (jumps % 4096 == 4095) budget_.check();
        int exponent = 0;
        bool known = false;
        if (occupancy_.inside(x, y)) {
            if (!occupancy_.near(x, y)) {
                exponent = hint = occupancy_.empty_exponent(x, y, hint);
                known = true;
            } else if (touches(x, y)) {
                return stay(x, y);
            }
        }
        if (region_) {
            const std::int64_t left = *region_ + 1 - std::max(std::abs(x), std::abs(y));
            exponent = std::min(
                exponent, static_cast<int>(std::bit_width(static_cast<std::uint64_t>(left))) - 1);
        } else if (!known || exponent == hint) {
            // Beyond the circle around all cells: squares whose corners do not reach it.
            const double away = std::hypot(static_cast<double>(x), static_cast<double>(y));
            if (away > 2 * circle) {
                const Point back = return_to_circle(
                    {static_cast<double>(x), static_cast<double>(y)}, circle, draws.at(number++));
                const GridCell cell = on_circle(std::atan2(back.y, back.x));
                x = cell.x, y = cell.y;
                continue;
            }
            const double room = (away - radius_ - 1) / std::numbers::sqrt2;
            if (room >= 2)
                exponent = std::max(
                    exponent,
                    static_cast<int>(std::bit_width(static_cast<std::uint64_t>(room))) - 1);
        }
        const auto first = draws.at(number++), second = draws.at(number++);
        const SquareExits::Step step =
            exits.at(std::min(exponent, SquareExits::most), first, second);
        x += step.x, y += step.y;
        if (region_ && std::max(std::abs(x), std::abs(y)) > *region_) {
            const GridCell again = free_cell(draws, number);
            x = again.x, y = again.y;
        }
    }
}

}  // namespace algae
