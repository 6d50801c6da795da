#include "dimension/detail/measures.hpp"

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <cmath>

#include "dimension/measured.hpp"
#include "exact/exact.hpp"

using namespace algae;

namespace {

template <class Filled>
CellRectangle rectangle(std::size_t columns, std::size_t rows, Filled filled) {
    CellRectangle cells{columns, rows, {}, 1};
    for (std::size_t row = 0; row < rows; ++row)
        for (std::size_t column = 0; column < columns; ++column)
            cells.filled.push_back(filled(column, row));
    return cells;
}

bool in_carpet(std::size_t column, std::size_t row) {
    for (; column > 0 && row > 0; column /= 3, row /= 3)
        if (column % 3 == 1 && row % 3 == 1) return false;
    return true;
}

}  // namespace

TEST_CASE("a full rectangle has lacunarity 1 for every box") {
    const auto full = rectangle(40, 23, [](auto, auto) { return true; });
    const std::vector<std::size_t> sides{1, 2, 3, 7, 16, 23};
    for (const double value : lacunarities(full, sides, Budget())) CHECK(value == 1);
    const auto square = rectangle(512, 512, [](auto, auto) { return true; });
    CHECK(lacunarity(square, Budget()).estimate->value == doctest::Approx(2));
}

TEST_CASE("a checkerboard has the lacunarity that counting by hand gives") {
    // 6 by 6 cells, 18 filled. Boxes of 1: half hold 1 cell: (1/2) / (1/4) = 2. Of 2: all hold 2. Of
    // 3: 16 places, half hold 5 and half 4: 20.5 / 4.5^2.
    const auto board =
        rectangle(6, 6, [](auto column, auto row) { return (column + row) % 2 == 0; });
    const auto found = lacunarities(board, std::vector<std::size_t>{1, 2, 3, 6}, Budget());
    CHECK(found[0] == 2);
    CHECK(found[1] == 1);
    CHECK(found[2] == doctest::Approx(20.5 / 20.25));
    CHECK(found[3] == 1);
}

TEST_CASE("lacunarity by sums over rectangles is that of counting in every box") {
    CHECK(rc::check("lacunarity", [] {
        const auto columns = *rc::gen::inRange<std::size_t>(1, 12),
                   rows = *rc::gen::inRange<std::size_t>(1, 12);
        auto cells =
            rectangle(columns, rows, [](auto, auto) { return *rc::gen::arbitrary<bool>(); });
        cells.filled[*rc::gen::inRange<std::size_t>(0, columns * rows)] = true;
        const auto side =
            *rc::gen::inRange<std::size_t>(1, (rows == 1 ? columns : std::min(columns, rows)) + 1);
        const auto height = rows == 1 ? 1 : side;
        double places = 0, sum = 0, squares = 0;
        for (std::size_t y = 0; y + height <= rows; ++y)
            for (std::size_t x = 0; x + side <= columns; ++x) {
                double mass = 0;
                for (std::size_t row = y; row < y + height; ++row)
                    for (std::size_t column = x; column < x + side; ++column)
                        mass += cells.filled[row * columns + column];
                places += 1;
                sum += mass;
                squares += mass * mass;
            }
        RC_PRE(sum > 0);
        const double found = lacunarities(cells, std::vector{side}, Budget())[0];
        RC_ASSERT(std::abs(found - squares * places / (sum * sum)) < 1e-9);
    }));
}

TEST_CASE("lacunarity falls as the dimension less that of the space") {
    check_holds(lacunarity(rectangle(729, 729, in_carpet), Budget()), std::log(8) / std::log(3),
                0.06);
    const auto line = drawn_cells(*drawn("axiom F; F -> FF; angle 60", 11), 1024, Budget());
    check_holds(lacunarity(line, Budget()), 1, 0.05);
    const auto koch = drawn_cells(*drawn("axiom F; F -> F+F--F+F; angle 60", 9), 1024, Budget());
    check_holds(lacunarity(koch, Budget()), std::log(4) / std::log(3), 0.06);
    CellRectangle cantor{59049, 1, std::vector<bool>(59049), 1};
    for (std::size_t i = 0; i < cantor.columns; ++i) {
        std::size_t rest = i;
        while (rest > 0 && rest % 3 != 1) rest /= 3;
        cantor.filled[i] = rest == 0;
    }
    check_holds(lacunarity(cantor, Budget()), std::log(2) / std::log(3), 0.08);
}

TEST_CASE("cells of points are pixels where points have a size") {
    PointSet pixels{2, {{3.5, 1.5, 0}, {4.5, 1.5, 0}, {5.5, 4.5, 0}}, 1, "pixel"};
    const CellRectangle cells = filled_cells(pixels, Budget());
    CHECK(cells.columns == 3);
    CHECK(cells.rows == 4);
    CHECK(cells.filled == std::vector<bool>{1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1});
}

TEST_CASE("what has no cells is refused") {
    const auto empty = rectangle(4, 4, [](auto, auto) { return false; });
    const std::vector<std::size_t> one{1}, five{5};
    CHECK_THROWS_WITH_AS(lacunarities(empty, one, Budget()),
                         "no cell is filled: expected something to measure", Error);
    const auto full = rectangle(4, 4, [](auto, auto) { return true; });
    CHECK_THROWS_WITH_AS(lacunarities(full, five, Budget()),
                         "expected boxes of 1 to 4 cells, found 5", Error);
    CHECK_THROWS_WITH_AS(drawn_cells(*drawn("axiom f; f -> ff", 3), 1024, Budget()),
                         "nothing is drawn: expected something to measure", Error);
    CHECK_THROWS_AS(filled_cells(PointSet{3, {{0, 0, 0}, {1, 1, 1}}}, Budget()), Error);
    CHECK(!lacunarity(full, Budget()).estimate);
}
