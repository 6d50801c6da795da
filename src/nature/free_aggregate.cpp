#include "nature/free_aggregate.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.hpp"
#include "nature/circle_return.hpp"
#include "nature/gaussian.hpp"
#include "rewrite/draws.hpp"

namespace algae {

namespace {

constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
constexpr int first_half = 5;  // exponent of the grid that a cluster begins with

}  // namespace

FreeAggregate::FreeAggregate(std::uint64_t seed, const Budget& budget)
    : seed_(seed), budget_(budget), occupancy_(first_half, budget) {
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
    if (!std::isfinite(centre.x) || !std::isfinite(centre.y) || centres_.size() >= none - 1)
        throw Error("expected a disc at a place in the plane, and at most 2^32 - 2 of them");
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
