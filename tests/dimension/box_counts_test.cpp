#include "dimension/dimension.hpp"

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <cmath>

#include "dimension/detail/cells.hpp"
#include "exact/exact.hpp"
#include "model/model.hpp"
#include "notation/notation.hpp"
#include "oracle/touched_cells.hpp"

using namespace algae;

namespace {

using Segments = std::vector<std::pair<Point, Point>>;

/// A path or loose segments; on a lattice of quarters of a cell, or anywhere.
rc::Gen<Segments> any_segments(bool lattice) {
    const auto coordinate =
        lattice ? rc::gen::map(rc::gen::inRange(0, 61), [](int k) { return k / 4.0; })
                : rc::gen::map(rc::gen::inRange<std::int64_t>(0, 15 * 1000003L),
                               [](std::int64_t k) { return static_cast<double>(k) / 1000003; });
    const auto point = rc::gen::apply(
        [](double x, double y) {
            return Point{x, y};
        },
        coordinate, coordinate);
    return rc::gen::nonEmpty(rc::gen::container<Segments>(rc::gen::pair(point, point)));
}

void draw(BoxCounter& counter, const Segments& segments, bool as_path) {
    for (std::size_t i = 0; i < segments.size(); ++i) {
        if (!as_path || i == 0) counter.move_to(segments[i].first);
        counter.line_to(segments[i].second);
    }
}

Segments path(const Segments& segments) {
    Segments joined = segments;
    for (std::size_t i = 1; i < joined.size(); ++i) joined[i].first = joined[i - 1].second;
    return joined;
}

Model system_of(const char* text) { return read_lsystem(text, "test"); }

const char* const koch = "axiom F; F -> F+F--F+F; angle 60";

}  // namespace

TEST_CASE("cells touched are those that an exact test of every cell finds, on every scale") {
    CHECK(rc::check("cells", [] {
        const bool lattice = *rc::gen::arbitrary<bool>(), joined = *rc::gen::arbitrary<bool>();
        const Segments some = *any_segments(lattice);
        const Segments segments = joined ? path(some) : some;
        const double offset = *rc::gen::elementOf(std::vector{0.0, 0.25, 0.3, 0.71});
        const Grid grid{{-offset, -2 * offset},
                        lattice ? *rc::gen::elementOf(std::vector{1.0, 0.5, 0.25}) : 0.37};
        for (const auto storage : {CellSet::Storage::dense, CellSet::Storage::sparse}) {
            std::vector<TouchedCells> grids;
            grids.emplace_back(grid, 7, storage, Budget());
            BoxCounter counter(std::move(grids));
            draw(counter, segments, joined);
            const auto counts = counter.grids()[0].cells().take_counts(5);
            const auto seen = oracle::seen_segments(segments, grid.origin, grid.cell);
            for (std::size_t k = 0; k <= 5; ++k)
                RC_ASSERT(counts[k] == oracle::touched_cells(seen, Rational(1L << k)).size());
        }
    }));
}

TEST_CASE("a line along a border counts once, and so does a corner") {
    const auto count = [](Point from, Point to) {
        std::vector<TouchedCells> grids;
        grids.emplace_back(Grid{}, 4, CellSet::Storage::dense, Budget());
        BoxCounter counter(std::move(grids));
        counter.move_to(from);
        counter.line_to(to);
        return counter.grids()[0].cells().take_counts(0)[0];
    };
    CHECK(count({1, 2}, {4, 2}) == 4);  // the last point is in the fourth cell
    CHECK(count({1, 2}, {3.5, 2}) == 3);
    CHECK(count({0, 0}, {3.5, 3.5}) == 4);  // through corners, along the diagonal
    CHECK(count({3.5, 3.5}, {0, 0}) == 4);
    CHECK(count({0.5, 3.5}, {3.5, 0.5}) == 7);  // corners belong to the cell above and to the right
    CHECK(count({3.5, 0.5}, {0.5, 3.5}) == 7);
    CHECK(count({2, 2}, {2, 2}) == 1);
    CHECK(count({0.1 + 0.2, 0}, {0.3, 0}) == 1);
    CHECK(count({3 - 1e-9, 1}, {5, 1}) == 3);  // closer to the border than a millionth of a cell
}

TEST_CASE("all scales and offsets of a figure in one pass are those of one pass for each") {
    CHECK(rc::check("scales", [] {
        const auto system = system_of(*rc::gen::elementOf(std::vector{
            koch, "axiom F; F -> F[+F]F[-F]F; angle 25.7", "axiom F; F -> f[+F]F[-Ff]f; angle 45",
            "axiom F; F -> F+FfF--F; angle 90; start 3 -7 20"}));
        const auto n = *rc::gen::inRange<std::uint64_t>(1, 7);
        const auto figure = algae::figure(system, n, Budget());
        const std::size_t levels = *rc::gen::inRange<std::size_t>(1, 9);
        const auto offsets = even_offsets(*rc::gen::inRange<std::size_t>(1, 4));
        const BoxScales scales = scales_of(figure->box(), 2, levels);
        const BoxCounts all = box_counts(*figure, scales, offsets, Budget());
        RC_ASSERT(Integer(all.parts) == figure->segments());
        for (std::size_t scale = 0; scale < levels; ++scale)
            for (std::size_t i = 0; i < offsets.size(); ++i) {
                const double cell = scales.cell(scale);
                std::vector<TouchedCells> grids;
                grids.emplace_back(Grid::before(figure->box(), cell, offsets[i], scales.coarsest),
                                   12, CellSet::Storage::sparse, Budget());
                BoxCounter counter(std::move(grids));
                // Stroke by stroke, where the pass for all has blocks of them.
                DrawnSegments strokes([&](Point from, Point to, bool goes_on) {
                    if (!goes_on) counter.move_to(from);
                    counter.line_to(to);
                });
                figure->draw(strokes, 0, Budget());
                RC_ASSERT(counter.grids()[0].cells().take_counts(0)[0] == all.counts[scale][i]);
            }
    }));
}

TEST_CASE("sparse and dense sets of cells hold the same") {
    CHECK(rc::check("storage", [] {
        const int bits = *rc::gen::inRange(1, 10);
        const auto cells =
            *rc::gen::container<std::vector<std::pair<std::uint64_t, std::uint64_t>>>(
                rc::gen::pair(rc::gen::inRange<std::uint64_t>(0, std::uint64_t{1} << bits),
                              rc::gen::inRange<std::uint64_t>(0, std::uint64_t{1} << bits)));
        CellSet dense(bits, CellSet::Storage::dense, Budget()),
            sparse(bits, CellSet::Storage::sparse, Budget());
        for (int round = 0; round < 2; ++round) {  // a set that was emptied is as good as a new one
            for (const auto& [column, row] : cells) {
                dense.mark({column, row});
                sparse.mark({column, row});
            }
            RC_ASSERT(dense.take_counts(bits) == sparse.take_counts(bits));
        }
    }));
}

TEST_CASE("steps in Morton order are steps on the grid") {
    CHECK(rc::check("steps", [] {
        const auto column = *rc::gen::inRange<std::uint64_t>(1, 1u << 30),
                   row = *rc::gen::inRange<std::uint64_t>(1, 1u << 30);
        const auto after = [&](void (Morton::*step)()) {
            Morton cell(column, row);
            (cell.*step)();
            return cell;
        };
        RC_ASSERT(after(&Morton::right) == Morton(column + 1, row));
        RC_ASSERT(after(&Morton::left) == Morton(column - 1, row));
        RC_ASSERT(after(&Morton::up) == Morton(column, row + 1));
        RC_ASSERT(after(&Morton::down) == Morton(column, row - 1));
    }));
}

TEST_CASE(
    "boxes of the Koch curve in powers of three are a bounded multiple of the powers of four") {
    const auto figure =
        algae::figure(system_of("axiom F; F -> F+F--F+F; angle 60; shrink 1/3"), 7, Budget());
    const BoxCounts counts =
        box_counts(*figure, scales_of(figure->box(), 3, 7), even_offsets(8), Budget());
    for (std::size_t k = 0; k < 7; ++k) {
        const double share = counts.mean(k) / std::pow(4, k);
        CHECK(share > 1);
        CHECK(share < 3);
    }
}

TEST_CASE("counting stays within its memory, and says so when it cannot") {
    const auto figure = algae::figure(system_of(koch), 6, Budget());
    Budget small;
    small.memory = 100'000;
    const auto offsets = even_offsets(1);
    CHECK_THROWS_AS(box_counts(*figure, scales_of(figure->box(), 2, 14), offsets, small),
                    BoundReached);
    CHECK_THROWS_AS(box_counts(*figure, scales_of(figure->box(), 2, 24), offsets, small),
                    BoundReached);
    CHECK_THROWS_WITH_AS(box_counts(*figure, scales_of(figure->box(), 2, 40), offsets, Budget()),
                         "the finest cells are too fine: expected at most 2^31 of them side by "
                         "side; use fewer scales",
                         BoundReached);
    small.memory = 40'000'000;
    CHECK(box_counts(*figure, scales_of(figure->box(), 2, 18), offsets, small).counts.size() == 18);
}

TEST_CASE("what cannot be measured says so") {
    const auto offsets = even_offsets(1);
    const auto nothing = algae::figure(system_of("axiom f; f -> ff"), 3, Budget());
    CHECK_THROWS_WITH_AS(scales_of(nothing->box(), 2, 12),
                         "nothing is drawn: expected something to measure", Error);
    CHECK_THROWS_WITH_AS(box_counts(*nothing, BoxScales{}, offsets, Budget()),
                         "nothing is drawn: expected something to measure", Error);
    CHECK_THROWS_WITH_AS(
        scales_of(Box{{1, 1}, {1, 1}, false}, 2, 12),
        "expected a figure that is wider or higher than a point, found a size of 0.000000", Error);
    const auto figure = algae::figure(system_of(koch), 2, Budget());
    CHECK_THROWS_WITH_AS(
        box_counts(*figure, BoxScales{1, 1, 3}, offsets, Budget()),
        "expected at least one scale and one offset, a cell wider than 0 and a ratio above 1",
        Error);
}
