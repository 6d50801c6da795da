#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <cmath>
#include <random>
#include <set>

#include "dimension/detail/measures.hpp"
#include "dimension/dimension.hpp"

using namespace algae;

namespace {

PointSet pixels_of(const CellRectangle& cells) {
    PointSet set;
    set.detail = 1;
    set.part = "pixel";
    for (std::size_t y = 0; y < cells.rows; ++y)
        for (std::size_t x = 0; x < cells.columns; ++x)
            if (cells.filled[y * cells.columns + x])
                set.points.push_back({static_cast<double>(x), static_cast<double>(y), 0});
    return set;
}

BoxFit fit_of(const CellRectangle& cells) {
    const PointSet set = pixels_of(cells);
    return fit_picture(picture_counts(filled_cells(set, Budget()), Budget()),
                       box_counts(set, 7, 16, Budget()));
}

/// A square of which some of the base * base parts are kept, and so are their parts, to the last pixel.
CellRectangle digits(std::size_t base, int levels, const std::vector<bool>& kept) {
    CellRectangle cells{1, 1, {true}, 1};
    for (int level = 0; level < levels; ++level) {
        CellRectangle next{cells.columns * base, cells.rows * base, {}, 1};
        for (std::size_t y = 0; y < next.rows; ++y)
            for (std::size_t x = 0; x < next.columns; ++x)
                next.filled.push_back(cells.filled[y / base * cells.columns + x / base] &&
                                      kept[y % base * base + x % base]);
        cells = std::move(next);
    }
    return cells;
}

}  // namespace

TEST_CASE("boxes of a picture are the mean over all places of the grid") {
    std::size_t compared = 0;
    CHECK(rc::check([&] {
        CellRectangle cells;
        cells.columns = *rc::gen::inRange<std::size_t>(1, 12);
        cells.rows = *rc::gen::inRange<std::size_t>(1, 12);
        cells.filled = *rc::gen::container<std::vector<bool>>(cells.columns * cells.rows,
                                                              rc::gen::arbitrary<bool>());
        cells.filled[*rc::gen::inRange<std::size_t>(0, cells.filled.size())] = true;
        const PictureCounts counts = picture_counts(cells, Budget());
        RC_ASSERT(counts.across == std::max(cells.columns, cells.rows));
        for (std::size_t i = 0; i < counts.sides.size(); ++i) {
            const std::size_t side = counts.sides[i];
            std::size_t touched = 0;
            for (std::size_t across = 0; across < side; ++across)
                for (std::size_t down = 0; down < side; ++down) {
                    std::set<std::pair<std::size_t, std::size_t>> boxes;
                    for (std::size_t y = 0; y < cells.rows; ++y)
                        for (std::size_t x = 0; x < cells.columns; ++x)
                            if (cells.filled[y * cells.columns + x])
                                boxes.emplace((x + across) / side, (y + down) / side);
                    touched += boxes.size();
                }
            RC_ASSERT(std::abs(counts.boxes[i] * static_cast<double>(side * side) -
                               static_cast<double>(touched)) < 1e-6);
            ++compared;
        }
    }));
    MESSAGE(compared << " means over all places compared");
    CHECK(compared > 300);
}

TEST_CASE("pictures of squares, strokes and known sets have their dimensions") {
    const std::pair<CellRectangle, double> known[] = {
        {digits(2, 8, {true, true, true, true}), 2},
        {{500, 1, std::vector<bool>(500, true), 1}, 1},
        {digits(2, 9, {true, false, true, true}), std::log2(3)},
        {digits(3, 5, {true, true, true, true, false, true, true, true, true}),
         std::log(8) / std::log(3)},
        {digits(3, 5, {false, true, false, true, true, true, false, true, false}),
         std::log(5) / std::log(3)},
        {digits(3, 5, {true, false, true, false, false, false, true, false, true}),
         std::log(4) / std::log(3)},
    };
    for (const auto& [cells, dimension] : known) {
        CAPTURE(dimension);
        const BoxFit fit = fit_of(cells);
        REQUIRE(fit.estimate);
        CAPTURE(fit.estimate->value);
        CHECK(std::abs(fit.estimate->value - dimension) < 0.06);
        CHECK(fit.estimate->low <= dimension + 1e-9);
        CHECK(fit.estimate->high >= dimension - 1e-9);
    }
}

TEST_CASE("intervals of pictures hold the dimensions of random sets of digits") {
    std::mt19937_64 random(20261127);
    int held = 0, measured = 0;
    double error = 0, plain = 0;
    for (const auto& [base, levels] : {std::pair{3u, 5}, {4u, 4}, {5u, 3}, {6u, 3}}) {
        for (int i = 0; i < 40; ++i) {
            std::vector<bool> kept(std::size_t{base} * base);
            for (std::size_t k = 0; k < kept.size(); ++k) kept[k] = random() % 5 < 3;
            kept.front() = kept.back() = true;
            const double dimension =
                std::log(static_cast<double>(std::ranges::count(kept, true))) / std::log(base);
            const CellRectangle cells = digits(base, levels, kept);
            const BoxFit fit = fit_of(cells);
            REQUIRE(fit.estimate);
            ++measured;
            held += fit.estimate->low <= dimension && dimension <= fit.estimate->high;
            error += std::abs(fit.estimate->value - dimension);
            const PictureCounts counts = picture_counts(cells, Budget());
            plain += std::abs(std::log(counts.boxes[4] / counts.boxes[8]) /
                                  std::log(static_cast<double>(counts.sides[8]) /
                                           static_cast<double>(counts.sides[4])) -
                              dimension);
        }
    }
    MESSAGE(held << " of " << measured << " intervals hold the dimension; mean error "
                 << error / measured << ", of a line through two of the boxes "
                 << plain / measured);
    CHECK(held >= measured * 95 / 100);
    CHECK(error < plain);
}

TEST_CASE("the line of a picture goes through its counts") {
    const CellRectangle cells =
        digits(3, 5, {true, true, true, true, false, true, true, true, true});
    const PointSet set = pixels_of(cells);
    const BoxCounts shown = box_counts(set, 7, 16, Budget());
    const BoxFit fit = fit_picture(picture_counts(cells, Budget()), shown);
    REQUIRE(fit.estimate);
    CHECK(fit.slopes.size() == 6);
    CHECK(shown.scales.cell(fit.first) <= 243 / 4.0);
    CHECK(shown.scales.cell(fit.last) >= 3);
    for (std::size_t scale = fit.first; scale <= fit.last; ++scale)
        CHECK(std::abs(fit.residual(shown, scale)) < 0.1);
}

TEST_CASE("a picture that is too small has no estimate, and says what is needed") {
    const BoxFit fit = fit_of(digits(2, 6, {true, false, true, true}));
    CHECK(!fit.estimate);
    CHECK(fit.because ==
          "the picture is too small: expected ink that is 96 pixels across, found 64");
    CHECK_THROWS_WITH_AS(picture_counts({2, 1, {false, false}, 1}, Budget()),
                         "expected a rectangle of pixels with ink, found 2 pixels without", Error);
    Budget small;
    small.memory = 100;
    CHECK_THROWS_AS(picture_counts(digits(2, 6, {true, true, true, true}), small), BoundReached);
}
