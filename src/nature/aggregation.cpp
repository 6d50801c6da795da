#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>

#include "nature/detail/aggregates.hpp"
#include "nature/detail/checks.hpp"
#include "nature/detail/random.hpp"

// Diffusion-limited aggregation (Witten and Sander 1981): particles walk at random from far away
// and stay where they touch the cluster.
//
// Single steps would take the square of the distance in time, so particles jump. `Occupancy` knows,
// from bit grids of cells 1, 2, 4, ... wide, a large empty square around a place at once. On the
// square grid a walk from the middle of an empty square leaves it at a border cell with the
// discrete Poisson kernel (`square_exit_chance`: McCrea and Whipple 1940), drawn in constant time
// from tables (Walker's alias method). Off the grid, a disc jumps to a random point of a free
// circle (Muller's walk on spheres, 1956). Both have exactly the distribution of the walk.
//
// A particle that goes far beyond the cluster would take long to come back. It always does, and
// where it meets a circle around the cluster first has the Poisson kernel of the circle as
// distribution (Kaufman, Vespignani, Mandelbrot and Woog 1995), which is drawn by one tangent. On
// the grid this is an approximation of the walk by Brownian motion, from twice the distance.
//
// With a region the rules are other ones: particles begin on a random free cell and are lost at the
// border; squares never reach beyond it, so the jumps again have the chances of single steps
// (`grow_by_steps` is the algorithm as it is written).
//
// Which random numbers a particle uses depends on the seed and on how many came before it, so a
// cluster of n particles is the beginning of a larger one.

namespace algae {

Occupancy::Occupancy(int half_exponent, const Budget& budget)
    : exponent_(half_exponent), half_(std::int64_t{1} << half_exponent) {
    const std::size_t cells = std::size_t{4} << (2 * exponent_);
    budget.check_memory(cells / 3, "the grid of an aggregate");
    for (int level = 0; level <= exponent_; ++level) {
        taken_.emplace_back((cells >> (2 * level)) / 64 + 1);
        near_.emplace_back((cells >> (2 * level)) / 64 + 1);
    }
}

void Occupancy::take(std::int64_t x, std::int64_t y) {
    const std::int64_t column = x + half_, row = y + half_;
    for (std::size_t level = 0; level < near_.size(); ++level) {
        const std::size_t here = index(static_cast<int>(level), column, row);
        if (bit(taken_[level], here)) break;  // then also on all coarser grids
        set(taken_[level], here);
        const std::int64_t side = std::int64_t{2} << (exponent_ - static_cast<int>(level));
        const std::int64_t c = column >> level, r = row >> level;
        for (std::int64_t y_near = r - 1; y_near <= r + 1; ++y_near)
            for (std::int64_t x_near = c - 1; x_near <= c + 1; ++x_near)
                if (x_near >= 0 && y_near >= 0 && x_near < side && y_near < side)
                    set(near_[level], static_cast<std::size_t>(y_near * side + x_near));
    }
}

double square_exit_chance(std::int64_t r, std::int64_t y) {
    require(r >= 1 && y > -r && y < r,
            "a side of a square: expected |y| < r, found r = {} and y = {}", {r, y});
    const double n = 2 * static_cast<double>(r);
    double sum = 0, sign = 1;
    for (std::int64_t k = 1; k < 2 * r; k += 2, sign = -sign) {
        const double part = std::numbers::pi * static_cast<double>(k) / n;
        // cosh a = 2 - cos(part) = 1 + 2 sin(part / 2)^2, so sinh(a / 2) = sin(part / 2).
        const double growth = std::asinh(std::sin(part / 2)) * n;
        if (growth > 50) break;  // from here on all terms are below 1e-21
        sum += sign * std::sin(part * static_cast<double>(y + r)) / std::cosh(growth);
    }
    return std::max(sum / n, 0.0);
}

const SquareExits& SquareExits::tables() {
    static const SquareExits made;
    return made;
}

SquareExits::SquareExits() {
    for (int exponent = 0; exponent <= most; ++exponent) {
        const std::int64_t r = std::int64_t{1} << exponent;
        const std::size_t count = static_cast<std::size_t>(2 * r - 1);
        std::vector<double> share(count);  // of what each entry would have if all had the same
        double sum = 0;
        for (std::size_t i = 0; i < count; ++i)
            sum += share[i] = square_exit_chance(r, static_cast<std::int64_t>(i) + 1 - r);
        std::vector<std::uint32_t> poor, rich;
        for (std::size_t i = 0; i < count; ++i) {
            share[i] *= static_cast<double>(count) / sum;
            (share[i] < 1 ? poor : rich).push_back(static_cast<std::uint32_t>(i));
        }
        std::vector<Entry> table(count);
        for (std::size_t i = 0; i < count; ++i)
            table[i] = {std::uint64_t{1} << 62, static_cast<std::uint32_t>(i)};
        while (!poor.empty() && !rich.empty()) {
            const std::uint32_t taker = poor.back(), giver = rich.back();
            poor.pop_back();
            table[taker] = {static_cast<std::uint64_t>(share[taker] * 0x1p62), giver};
            share[giver] -= 1 - share[taker];
            if (share[giver] < 1) {
                rich.pop_back();
                poor.push_back(giver);
            }
        }
        tables_.push_back(std::move(table));
    }
}

SquareExits::Step SquareExits::at(int exponent, std::uint64_t first, std::uint64_t second) const {
    const std::vector<Entry>& table = tables_[static_cast<std::size_t>(exponent)];
    std::size_t entry = Draws::scaled(first, table.size());
    if (second >> 2 >= table[entry].threshold) entry = table[entry].other;
    const std::int64_t r = std::int64_t{1} << exponent;
    const std::int64_t along = static_cast<std::int64_t>(entry) + 1 - r;
    const std::int64_t across = second % 2 == 0 ? r : -r;
    return (second & 2) == 0 ? Step{across, along} : Step{along, across};
}

Point return_to_circle(Point from, double radius, std::uint64_t number) {
    const double distance = std::hypot(from.x, from.y);
    const double slope = (distance - radius) / (distance + radius) *
                         std::tan(std::numbers::pi * (unit_interval(number) - 0.5));
    // The turn by twice the angle with this tangent.
    const double cosine = (1 - slope * slope) / (1 + slope * slope);
    const double sine = 2 * slope / (1 + slope * slope);
    const double scale = radius / distance;
    return {scale * (from.x * cosine - from.y * sine), scale * (from.x * sine + from.y * cosine)};
}

namespace {

constexpr std::uint64_t widest_region = 16383;
constexpr int first_half = 7;       // exponent of the grid that a cluster begins with
constexpr double launch_room = 24;  // between the cluster and the circle where particles begin

/// How far a cell is from the middle, in the direction in which it is farther.
std::int64_t reach_of(std::int64_t x, std::int64_t y) { return std::max(std::abs(x), std::abs(y)); }

int half_exponent(std::int64_t reach) {
    return std::max(first_half,
                    static_cast<int>(std::bit_width(static_cast<std::uint64_t>(reach))));
}

}  // namespace

std::optional<std::int64_t> GridAggregate::checked(std::optional<std::uint64_t> region) {
    if (!region) return std::nullopt;
    require(*region > 0 && *region <= widest_region, "region: expected 1 to {} cells, found {}",
            {widest_region, *region});
    return static_cast<std::int64_t>(*region);
}

GridAggregate::GridAggregate(std::uint64_t seed, std::optional<std::uint64_t> region,
                             const Budget& budget)
    : seed_(seed),
      region_(checked(region)),
      budget_(budget),
      occupancy_(half_exponent(region_ ? *region_ + 2 : 0), budget) {
    add({0, 0});
}

void GridAggregate::add(GridCell cell) {
    const std::int64_t reach = reach_of(cell.x, cell.y);
    require(!region_ || reach <= *region_, "cell ({}, {}) is outside of the region of {} cells",
            {cell.x, cell.y, region_.value_or(0)});
    make_room(reach + 2);
    require(!occupancy_.taken(cell.x, cell.y), "cell ({}, {}) is in the cluster already",
            {cell.x, cell.y});
    stay(cell.x, cell.y);
}

GridCell GridAggregate::stay(std::int64_t x, std::int64_t y) {
    const GridCell cell{static_cast<std::int32_t>(x), static_cast<std::int32_t>(y)};
    extent_ = std::max(extent_, reach_of(x, y));
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
    require(cells_.size() < side * side, "no cell of the region of {} cells is free", {*region_});
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
    require(region_.has_value(), "expected a region, which single steps need");
    const Draws draws(seed_, cells_.size());
    std::uint64_t number = 0;
    GridCell here = free_cell(draws, number);
    while (!touches(here.x, here.y)) {
        if (number % 4096 == 0) budget_.check();
        const std::uint64_t direction = draws.at(number++) >> 62;
        (direction < 2 ? here.x : here.y) += direction % 2 == 0 ? 1 : -1;
        if (reach_of(here.x, here.y) > *region_) here = free_cell(draws, number);
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
            const std::int64_t left = *region_ + 1 - reach_of(x, y);
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
        if (region_ && reach_of(x, y) > *region_) {
            const GridCell again = free_cell(draws, number);
            x = again.x, y = again.y;
        }
    }
}

namespace {

constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
constexpr int first_half_of_bins = 5;  // exponent of the grid that a cluster begins with

}  // namespace

FreeAggregate::FreeAggregate(std::uint64_t seed, const Budget& budget)
    : seed_(seed), budget_(budget), occupancy_(first_half_of_bins, budget) {
    first_.assign(static_cast<std::size_t>(4 * occupancy_.half() * occupancy_.half()), none);
    add({0, 0});
}

std::int64_t FreeAggregate::cell_of(double coordinate) {
    return static_cast<std::int64_t>(std::floor(coordinate / bin));
}

std::size_t FreeAggregate::index(std::int64_t x, std::int64_t y) const {
    const std::int64_t half = occupancy_.half();
    return static_cast<std::size_t>((y + half) * 2 * half + x + half);
}

void FreeAggregate::enter(std::uint32_t disc) {
    const std::int64_t x = cell_of(centres_[disc].x), y = cell_of(centres_[disc].y);
    occupancy_.take(x, y);
    next_[disc] = first_[index(x, y)];
    first_[index(x, y)] = disc;
}

void FreeAggregate::make_room(double reach) {
    // Places up to the circle from which discs come, and a cell beside it, are inside.
    const std::int64_t needed = static_cast<std::int64_t>(reach / bin) + 4;
    if (needed < occupancy_.half()) return;
    const int exponent = static_cast<int>(std::bit_width(static_cast<std::uint64_t>(needed)));
    const std::uint64_t cells = std::uint64_t{4} << (2 * exponent);
    budget_.check_memory(cells * sizeof(std::uint32_t) + centres_.size() * 24,
                         "the grid of an aggregate");
    occupancy_ = Occupancy(exponent, budget_);
    first_.assign(cells, none);
    for (std::uint32_t disc = 0; disc < centres_.size(); ++disc) enter(disc);
}

void FreeAggregate::add(Point centre) {
    require(std::isfinite(centre.x) && std::isfinite(centre.y) && centres_.size() < none - 1,
            "expected a disc at a place in the plane, and at most 2^32 - 2 of them");
    radius_ = std::max(radius_, std::hypot(centre.x, centre.y));
    make_room(radius_ + 2);
    centres_.push_back(centre);
    next_.push_back(none);
    touched_.push_back(static_cast<std::uint32_t>(touched_.size()));
    enter(static_cast<std::uint32_t>(centres_.size() - 1));
}

FreeAggregate::Nearest FreeAggregate::nearest(Point place) const {
    const std::int64_t column = cell_of(place.x), row = cell_of(place.y);
    Nearest found{none, bin * bin};  // squared; further discs are not in the cells around
    for (std::int64_t y = row - 1; y <= row + 1; ++y)
        for (std::int64_t x = column - 1; x <= column + 1; ++x)
            for (std::uint32_t disc = first_[index(x, y)]; disc != none; disc = next_[disc]) {
                const double across = place.x - centres_[disc].x;
                const double along = place.y - centres_[disc].y;
                const double square = across * across + along * along;
                if (square < found.distance) found = {disc, square};
            }
    found.distance = std::sqrt(found.distance);
    return found;
}

Point FreeAggregate::grow() {
    const Draws draws(seed_, centres_.size());
    std::uint64_t number = 0;
    const double circle = radius_ + 1;  // no disc there touches the cluster
    const auto on_circle = [&](Point middle, double radius) -> Point {
        // Twice the angle of a point of the unit disc (von Neumann 1951).
        for (;;) {
            const std::uint64_t bits = draws.at(number++);
            const double across = static_cast<double>(bits >> 32) * 0x1p-31 - 1;
            const double along = static_cast<double>(bits & 0xFFFFFFFF) * 0x1p-31 - 1;
            const double square = across * across + along * along;
            if (square > 1 || square == 0) continue;
            const double scale = radius / square;
            return {middle.x + scale * (across * across - along * along),
                    middle.y + scale * 2 * across * along};
        }
    };
    Point place = on_circle({0, 0}, circle);
    int hint = 0;
    for (;;) {
        if (number % 4096 == 4095) budget_.check();
        const std::int64_t x = cell_of(place.x), y = cell_of(place.y);
        double free = 0;
        if (occupancy_.near(x, y)) {
            const Nearest found = nearest(place);
            free = found.distance - 1;
            if (free < touching) {
                const Point other = centres_[found.disc];
                const double share = 1 / found.distance;
                add({other.x + share * (place.x - other.x), other.y + share * (place.y - other.y)});
                touched_.back() = found.disc;
                return centres_.back();
            }
        } else {
            hint = occupancy_.empty_exponent(x, y, hint);
            free = bin * static_cast<double>(std::int64_t{1} << hint) - 1;
        }
        place = on_circle(place, free);
        if (place.x * place.x + place.y * place.y > circle * circle)
            place = return_to_circle(place, circle, draws.at(number++));
    }
}

}  // namespace algae
