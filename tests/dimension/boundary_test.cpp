// The boundary of the whole limit set.

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <array>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "dimension/detail/recurrent_set.hpp"
#include "dimension/dimension.hpp"
#include "exact/exact.hpp"
#include "model/model.hpp"
#include "notation/notation.hpp"
#include "system/system.hpp"

using namespace algae;

namespace {

using Cell = std::pair<int, int>;

/// Moves to a cell, does something there and comes back.
std::string at(Cell cell, const std::string& what) {
    const auto steps = [](int count) { return std::string(static_cast<std::size_t>(count), 'f'); };
    const auto [x, y] = cell;
    return "[" + (x < 0 ? "|" + steps(-x) + "|" : steps(x)) +
           (y < 0 ? "-" + steps(-y) + "+" : "+" + steps(y) + "-") + what + "]";
}

/// The rule of a tile of cells that are each half as wide.
std::string rule(char name, const std::vector<Cell>& cells) {
    std::string text = std::string(1, name) + " ->";
    for (const Cell& cell : cells) text += " " + at(cell, std::string(1, name));
    return text + "\ninterpret " + name + " -> F\n";
}

ExactDimension tiles(const std::string& axiom, const std::string& rules) {
    return exact_dimension(
        read_lsystem("axiom " + axiom + "\n" + rules + "f -> ff\nangle 90\n", "tiles.lsys"));
}

const std::vector<Cell> square{{0, 0}, {1, 0}, {0, 1}, {1, 1}};
const std::vector<Cell> triangle{{0, 0}, {1, 0}, {0, 1}, {-1, -1}};  // log 3 / log 2

/// The rate at which the neighbours T + g of T, g not 0, meet T in finer and finer parts, where
/// 2 T = union of T + d over the cells d: differences that stay within the widest of sets of points
/// sum d / 2^k (Strichartz and Wang, Geometry of self-affine tiles, 1999). By powers of a matrix of
/// doubles. 4 if the copies of T overlap.
double rate_of_neighbours(const std::vector<Cell>& cells) {
    std::array<int, 2> reach{0, 0};
    for (const auto& [ax, ay] : cells)
        for (const auto& [bx, by] : cells)
            reach = {std::max(reach[0], ax - bx), std::max(reach[1], ay - by)};
    std::map<Cell, std::vector<Cell>> next;
    for (int x = -reach[0]; x <= reach[0]; ++x)
        for (int y = -reach[1]; y <= reach[1]; ++y) {
            if (x == 0 && y == 0) continue;
            for (const auto& [ax, ay] : cells)
                for (const auto& [bx, by] : cells) {
                    const Cell to{2 * x + bx - ax, 2 * y + by - ay};
                    if (to == Cell{0, 0} || std::abs(to.first) > reach[0] ||
                        std::abs(to.second) > reach[1])
                        continue;
                    next[{x, y}].push_back(to);
                }
        }
    std::map<Cell, double> paths;
    for (const auto& [from, to] : next) paths[from] = 1;
    constexpr int levels = 400;
    double grown = 0;  // logarithm
    for (int level = 0; level < levels; ++level) {
        std::map<Cell, double> longer;
        double most = 0;
        for (const auto& [from, to] : next) {
            double sum = 0;
            for (const Cell& cell : to) sum += paths[cell];
            if (sum > 0) longer[from] = sum;
            most = std::max(most, sum);
        }
        for (auto& [from, sum] : longer) sum /= most;
        if (level >= levels / 2) grown += std::log(most);
        paths = std::move(longer);
    }
    return std::exp(grown / (levels / 2));
}

}  // namespace

TEST_CASE("of components with equal rates, all count for the boundary") {
    const std::string rules = rule('P', square) + rule('Q', triangle);
    for (const char* axiom : {"PffffffffffQ", "QffffffffffP"}) {
        CAPTURE(axiom);
        const ExactDimension found = tiles(axiom, rules);
        CHECK(found.value->rational() == Rational(2));
        REQUIRE(found.boundary);
        CHECK(found.boundary->text() == "log 3 / log 2");
    }
    CHECK(tiles("PffffffffffP", rules).boundary->rational() == Rational(1));
}

TEST_CASE("the boundary is that of the union, also where parts cover each other's boundaries") {
    const std::string rules = rule('P', square) + rule('Q', triangle);
    std::string cover = at({0, 0}, "Q");
    for (int x = -2; x < 2; ++x)
        for (int y = -2; y < 2; ++y) cover += at({x, y}, "P");
    const ExactDimension found = tiles(cover, rules);
    CHECK(found.value->rational() == Rational(2));
    REQUIRE(found.boundary);
    CHECK(found.boundary->rational() == Rational(1));
    // A square whose parts are the squares themselves and a fractal tile within them.
    const ExactDimension mixed =
        tiles("P", "P -> " + at({0, 0}, "P") + at({1, 0}, "P") + at({0, 1}, "P") + at({1, 1}, "P") +
                       at({0, 0}, "R") + "\nR -> " + at({1, 1}, "Q") + "\nQ -> " + at({0, 0}, "Q") +
                       at({1, 0}, "Q") + at({0, 1}, "Q") + at({-1, -1}, "Q") +
                       "\ninterpret P -> F\ninterpret Q -> F\ninterpret R -> F\n");
    REQUIRE(mixed.boundary);
    CHECK(mixed.boundary->rational() == Rational(1));
}

TEST_CASE("a boundary of sets that late generations approach in turn is not known, and said so") {
    const ExactDimension found =
        exact_dimension(read_lsystem("axiom F+F+F; F -> F+F-F+F; angle 60", ""));
    CHECK(found.value->rational() == Rational(2));
    CHECK_FALSE(found.boundary);
    CHECK(found.conditions.back() ==
          "the boundary is not known: late generations approach 3 sets in turn");
}

TEST_CASE("the boundary of a tile is that of where it meets its translates") {
    int compared = 0, curved = 0;
    CHECK(rc::check([&] {
        // A complete system of residues modulo 2.
        std::vector<Cell> cells;
        for (const Cell& residue : square)
            cells.emplace_back(residue.first + 2 * *rc::gen::inRange(-1, 2),
                               residue.second + 2 * *rc::gen::inRange(-1, 2));
        const double expected = rate_of_neighbours(cells);
        if (expected > 3.95) return;  // its copies overlap, or nearly so
        const ExactDimension found = tiles("P", rule('P', cells));
        RC_ASSERT(found.value->rational() == Rational(2));
        RC_ASSERT(found.boundary);
        const double rate = std::exp2(found.boundary->enclosure(64).midpoint());  // of the ratio 2
        RC_ASSERT(std::abs(rate - expected) < 1e-3);
        ++compared;
        if (rate > 2.01) ++curved;
    }));
    CHECK(compared > 40);
    CHECK(curved > 20);
}
