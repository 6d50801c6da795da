#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <vector>

#include "exact/exact.hpp"
#include "nature/detail/aggregates.hpp"
#include "nature/detail/random.hpp"

using namespace algae;

namespace {

using Spot = std::pair<int, int>;

/// How unlike two lists of counts are, and the value that they should stay below.
struct ChiSquare {
    double value = 0, freedom = -1;
    bool fits() const { return value < freedom + 5 * std::sqrt(2 * freedom) + 10; }
};

ChiSquare compare(const std::map<Spot, int>& left, const std::map<Spot, int>& right) {
    // With equal totals, (a - b)^2 / (a + b) summed over the places is a chi-square; rare places
    // are counted as one.
    ChiSquare found;
    std::set<Spot> places;
    for (const auto& [place, count] : left) places.insert(place);
    for (const auto& [place, count] : right) places.insert(place);
    double rare_left = 0, rare_right = 0;
    const auto add = [&](double a, double b) {
        found.value += (a - b) * (a - b) / (a + b);
        ++found.freedom;
    };
    for (const Spot& place : places) {
        const double a = left.contains(place) ? left.at(place) : 0;
        const double b = right.contains(place) ? right.at(place) : 0;
        if (a + b < 20) {
            rare_left += a;
            rare_right += b;
        } else {
            add(a, b);
        }
    }
    if (rare_left + rare_right > 0) add(rare_left, rare_right);
    return found;
}

/// The potential kernel of the walk on the square grid, by its values on the diagonal and by its
/// being harmonic off the origin (McCrea and Whipple 1940; Spitzer, Principles of Random Walk, 15).
std::vector<std::vector<double>> potential_kernel(int size) {
    std::vector<std::vector<double>> a(static_cast<std::size_t>(size + 2),
                                       std::vector<double>(static_cast<std::size_t>(size + 2)));
    const auto at = [&](int x, int y) -> double& {
        x = std::abs(x), y = std::abs(y);
        return a[static_cast<std::size_t>(std::max(x, y))]
                [static_cast<std::size_t>(std::min(x, y))];
    };
    double odd = 0;
    for (int n = 1; n <= size + 1; ++n) {
        odd += 1.0 / (2 * n - 1);
        at(n, n) = 4 / std::numbers::pi * odd;
    }
    at(1, 0) = 1;
    for (int x = 1; x <= size; ++x) {
        // 4 a(x, y) is the sum over the neighbours; below the diagonal each gives the next a(x + 1, y).
        for (int y = 0; y < x; ++y)
            at(x + 1, y) = 4 * at(x, y) - at(x - 1, y) - at(x, y + 1) - at(x, y - 1);
        at(x + 1, x) = 2 * at(x, x) - at(x, x - 1);
    }
    return a;
}

/// The chances with which a walk from infinity first comes to each of these places: the measure h
/// with sum 1 for which the sum of a(x - y) h(y) is the same for all places x.
std::vector<double> from_infinity(const std::vector<Spot>& places) {
    const auto kernel = potential_kernel(14);
    const std::size_t n = places.size() + 1;
    std::vector<std::vector<double>> rows(n, std::vector<double>(n + 1));
    for (std::size_t i = 0; i + 1 < n; ++i) {
        for (std::size_t j = 0; j + 1 < n; ++j) {
            const int x = std::abs(places[i].first - places[j].first);
            const int y = std::abs(places[i].second - places[j].second);
            rows[i][j] = kernel[static_cast<std::size_t>(std::max(x, y))]
                               [static_cast<std::size_t>(std::min(x, y))];
        }
        rows[i][n - 1] = -1;
        rows[n - 1][i] = 1;
    }
    rows[n - 1][n] = 1;
    for (std::size_t column = 0; column < n; ++column) {
        std::size_t best = column;
        for (std::size_t i = column; i < n; ++i)
            if (std::abs(rows[i][column]) > std::abs(rows[best][column])) best = i;
        std::swap(rows[column], rows[best]);
        for (std::size_t i = 0; i < n; ++i) {
            if (i == column) continue;
            const double factor = rows[i][column] / rows[column][column];
            for (std::size_t j = column; j <= n; ++j) rows[i][j] -= factor * rows[column][j];
        }
    }
    std::vector<double> measure;
    for (std::size_t i = 0; i + 1 < n; ++i) measure.push_back(rows[i][n] / rows[i][i]);
    return measure;
}

const std::vector<GridCell> hook{{1, 0}, {2, 0}, {2, 1}, {2, 2}, {1, 2}, {0, 2}, {-1, 2}, {-1, 3}};

}  // namespace

TEST_CASE("how far from taken cells a place is, against looking at all cells") {
    CHECK(rc::check([] {
        Occupancy grid(6, Budget());
        std::set<Spot> taken;
        const int count = *rc::gen::inRange(1, 12);
        for (int i = 0; i < count; ++i) {
            const int x = *rc::gen::inRange(-64, 64), y = *rc::gen::inRange(-64, 64);
            grid.take(x, y);
            taken.insert({x, y});
        }
        int hint = 0;
        for (int look = 0; look < 50; ++look) {
            const int x = *rc::gen::inRange(-64, 64), y = *rc::gen::inRange(-64, 64);
            int distance = 1000;
            for (const auto& [u, v] : taken)
                distance = std::min(distance, std::max(std::abs(u - x), std::abs(v - y)));
            RC_ASSERT(grid.taken(x, y) == (distance == 0));
            RC_ASSERT(grid.near(x, y) == (distance <= 1));
            if (distance <= 1) continue;
            hint = grid.empty_exponent(x, y, hint);
            RC_ASSERT(1 << hint < distance);                // nothing is taken within 2^e
            RC_ASSERT(hint == 6 || distance <= 4 << hint);  // and e is not far from the greatest
        }
    }));
}

TEST_CASE("clusters grown by jumps and by single steps are equally likely") {
    // The fifth particle's place in a small region, where losses are frequent too.
    std::map<Spot, int> fast, slow;
    for (std::uint64_t seed = 0; seed < 30'000; ++seed) {
        GridAggregate jumps(seed, 9, Budget()), steps(seed + 1'000'000, 9, Budget());
        for (int i = 0; i < 4; ++i) {
            jumps.grow();
            steps.grow_by_steps();
        }
        ++fast[{jumps.cells().back().x, jumps.cells().back().y}];
        ++slow[{steps.cells().back().x, steps.cells().back().y}];
    }
    const ChiSquare chi = compare(fast, slow);
    CAPTURE(chi.value);
    CAPTURE(chi.freedom);
    CHECK(chi.freedom > 20);
    CHECK(chi.fits());
}

TEST_CASE("where the next particle stays at a given cluster, by jumps and by single steps") {
    std::map<Spot, int> fast, slow;
    for (std::uint64_t seed = 0; seed < 20'000; ++seed) {
        GridAggregate jumps(seed, 25, Budget()), steps(seed + 1'000'000, 25, Budget());
        for (const GridCell& cell : hook) {
            jumps.add(cell);
            steps.add(cell);
        }
        const GridCell one = jumps.grow(), other = steps.grow_by_steps();
        ++fast[{one.x, one.y}];
        ++slow[{other.x, other.y}];
    }
    const ChiSquare chi = compare(fast, slow);
    CAPTURE(chi.value);
    CAPTURE(chi.freedom);
    CHECK(chi.freedom >= 10);
    CHECK(chi.fits());
}

TEST_CASE("the harmonic measure from infinity by the potential kernel, where it is known") {
    const auto kernel = potential_kernel(10);
    CHECK(kernel[2][0] == doctest::Approx(4 - 8 / std::numbers::pi));
    CHECK(kernel[2][1] == doctest::Approx(8 / std::numbers::pi - 1));
    for (const double share : from_infinity({{1, 0}, {-1, 0}, {0, 1}, {0, -1}}))
        CHECK(share == doctest::Approx(0.25));
}

TEST_CASE("particles from far away stay as the harmonic measure of the grid says") {
    std::set<Spot> cells{{0, 0}}, around;
    for (const GridCell& cell : hook) cells.insert({cell.x, cell.y});
    for (const auto& [x, y] : cells)
        for (const Spot& beside : {Spot{x + 1, y}, {x - 1, y}, {x, y + 1}, {x, y - 1}})
            if (!cells.contains(beside)) around.insert(beside);
    const std::vector<Spot> places(around.begin(), around.end());
    const std::vector<double> chances = from_infinity(places);
    std::map<Spot, int> counts;
    const int count = 100'000;
    for (int seed = 0; seed < count; ++seed) {
        GridAggregate aggregate(static_cast<std::uint64_t>(seed), {}, Budget());
        for (const GridCell& cell : hook) aggregate.add(cell);
        const GridCell place = aggregate.grow();
        ++counts[{place.x, place.y}];
    }
    ChiSquare chi;
    int seen = 0;
    for (std::size_t i = 0; i < places.size(); ++i) {
        const double expected = count * chances[i];
        const double found = counts[places[i]];
        seen += counts[places[i]];
        chi.value += (found - expected) * (found - expected) / expected;
        ++chi.freedom;
    }
    CHECK(seen == count);
    CAPTURE(chi.value);
    CAPTURE(chi.freedom);
    CHECK(chi.fits());
}

TEST_CASE("Brownian motion comes back to the circle with the density of Poisson") {
    // From (d, 0): the angle t has the density (d^2 - 1) / (2 pi (1 - 2 d cos t + d^2)), so that the
    // mean of cos t is 1/d, of cos 2t 1/d^2.
    const Draws draws(3, 0);
    const int count = 200'000;
    for (const double distance : {1.01, 1.5, 4.0, 100.0}) {
        double first = 0, second = 0, across = 0;
        for (int i = 0; i < count; ++i) {
            const Point place =
                return_to_circle({2 * distance, 0}, 2, draws.at(static_cast<std::uint64_t>(i)));
            CHECK(std::abs(std::hypot(place.x, place.y) - 2) < 1e-12);
            const double cosine = place.x / 2;
            first += cosine / count;
            second += (2 * cosine * cosine - 1) / count;
            across += place.y / 2 / count;
        }
        CAPTURE(distance);
        CHECK(std::abs(first - 1 / distance) < 5 / std::sqrt(2 * count));
        CHECK(std::abs(second - 1 / distance / distance) < 5 / std::sqrt(2 * count));
        CHECK(std::abs(across) < 5 / std::sqrt(2 * count));
    }
}

TEST_CASE("the third disc lies around two discs as their harmonic measure says") {
    // Places for a third disc are two circles of radius 1 that meet in (0, +-h), h = sqrt(3) / 2. The
    // map z -> log((z - ih) / (z + ih)) takes what is outside of both to a strip of the width g = 2 pi / 3
    // and infinity to its middle: the real part x then has the density sech(pi x / g) / g.
    const double height = std::sqrt(3) / 2, width = 2 * std::numbers::pi / 3;
    std::vector<double> found;
    int right = 0;
    const int count = 40'000;
    for (int seed = 0; seed < count; ++seed) {
        FreeAggregate aggregate(static_cast<std::uint64_t>(seed), Budget());
        aggregate.add({1, 0});
        const Point place = aggregate.grow();
        const double x = place.x - 0.5;
        right += x > 0;
        CHECK(std::abs(std::hypot(std::abs(x) - 0.5, place.y) - 1) < 1e-9);
        found.push_back(
            std::log(std::hypot(x, place.y - height) / std::hypot(x, place.y + height)));
    }
    std::sort(found.begin(), found.end());
    double gap = 0;  // Kolmogorov and Smirnov's
    for (int i = 0; i < count; ++i) {
        const double share =
            2 / std::numbers::pi *
            std::atan(std::exp(std::numbers::pi * found[static_cast<std::size_t>(i)] / width));
        gap = std::max({gap, std::abs(share - static_cast<double>(i) / count),
                        std::abs(share - static_cast<double>(i + 1) / count)});
    }
    CHECK(gap * std::sqrt(count) < 2.2);  // exceeded by chance once in 8,000 times
    CHECK(std::abs(right - count / 2) < 2.5 * std::sqrt(count));
}

TEST_CASE("every particle of an aggregate touches an earlier one, and none overlaps another") {
    GridAggregate grid(3, {}, Budget());
    FreeAggregate free(3, Budget());
    for (int i = 0; i < 1500; ++i) {
        grid.grow();
        free.grow();
    }
    std::set<Spot> cells;
    for (const GridCell& cell : grid.cells()) {
        const bool touches =
            cells.contains({cell.x + 1, cell.y}) || cells.contains({cell.x - 1, cell.y}) ||
            cells.contains({cell.x, cell.y + 1}) || cells.contains({cell.x, cell.y - 1});
        CHECK((touches || cells.empty()));
        CHECK(cells.insert({cell.x, cell.y}).second);
    }
    const auto& centres = free.centres();
    for (std::size_t i = 1; i < centres.size(); ++i) {
        double least = 10;
        for (std::size_t j = 0; j < i; ++j)
            least = std::min(least,
                             std::hypot(centres[i].x - centres[j].x, centres[i].y - centres[j].y));
        CHECK(std::abs(least - 1) < 2 * FreeAggregate::touching);
    }
}

TEST_CASE("an aggregate of a seed is the same again, and the beginning of a greater one") {
    GridAggregate small(9, 40, Budget()), large(9, 40, Budget());
    FreeAggregate few(9, Budget()), many(9, Budget());
    for (int i = 0; i < 100; ++i) {
        small.grow();
        few.grow();
    }
    for (int i = 0; i < 200; ++i) {
        large.grow();
        many.grow();
    }
    CHECK(std::equal(small.cells().begin(), small.cells().end(), large.cells().begin()));
    CHECK(std::equal(few.centres().begin(), few.centres().end(), many.centres().begin()));
}

TEST_CASE("a region fills up, and then there is no room") {
    GridAggregate aggregate(1, 2, Budget());
    CHECK_FALSE(aggregate.fills_region());
    for (int i = 0; i < 24; ++i) aggregate.grow();
    CHECK(aggregate.fills_region());
    CHECK_THROWS_WITH_AS(aggregate.grow(), "no cell of the region of 2 cells is free", Error);
    CHECK_THROWS_WITH_AS(GridAggregate(1, 0, Budget()),
                         "region: expected 1 to 16383 cells, found 0", Error);
    CHECK_THROWS_WITH_AS(aggregate.add({3, 0}), "cell (3, 0) is outside of the region of 2 cells",
                         Error);
    CHECK_THROWS_WITH_AS(aggregate.add({0, 0}), "cell (0, 0) is in the cluster already", Error);
    CHECK_THROWS_WITH_AS(GridAggregate(1, {}, Budget()).grow_by_steps(),
                         "expected a region, which single steps need", Error);
}

TEST_CASE("clusters of discs have a dimension near 1.71, by their radius") {
    double gyration = 0;
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
        Aggregates cluster;
        cluster.off_lattice = true;
        cluster.seed = seed;
        gyration += gyration_dimension(cluster.links(12'000, Budget()), 6).value() / 4;
    }
    CAPTURE(gyration);
    CHECK(std::abs(gyration - 1.71) < 0.06);
}
