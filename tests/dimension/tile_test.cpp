// Tiles against what is published, and against points, differences and chains that share nothing with the search.

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <complex>
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

using Answer = Tile::Answer;
using Cell = std::pair<std::int64_t, std::int64_t>;
using Complex = std::complex<double>;

LatticeSet limit(const std::string& text) {
    const Model system = read_lsystem(text, "tile.lsys");
    return lattice_set(RecurrentSet(system, *as_d0l(system)));
}

Tile tile_of(const std::string& text) { return tile(limit(text)); }

/// M = multiplication by nu, of x^2 + p x + q, in the basis 1, nu; one state with these digits.
struct Digits {
    std::int64_t p = 0, q = 2;
    std::vector<Cell> cells;

    Complex factor() const {
        return {-static_cast<double>(p) / 2, std::sqrt(static_cast<double>(4 * q - p * p)) / 2};
    }
    Cell scaled(Cell at) const { return {-q * at.second, at.first - p * at.second}; }
    Complex value(Cell at) const {
        return static_cast<double>(at.first) + static_cast<double>(at.second) * factor();
    }
    LatticeSet set() const {
        LatticeSet out;
        const Complex nu = factor();
        out.scale[0] = {0, 1, 0};
        out.scale[1] = {-q, -p, 0};
        out.places[0] = {1, 0};
        out.places[1] = {nu.real(), nu.imag()};
        out.linear = {nu.real(), -nu.imag(), nu.imag(), nu.real()};
        out.parts.emplace_back();
        for (const auto& [x, y] : cells) out.parts[0].push_back({0, {x, y, 0}});
        out.shapes = {0};
        out.whole = {{0, {}}};
        return out;
    }
    double reach() const {
        double farthest = 0;
        for (const Cell& cell : cells) farthest = std::max(farthest, std::abs(value(cell)));
        return farthest / (std::abs(factor()) - 1);
    }
};

Cell operator+(Cell a, Cell b) { return {a.first + b.first, a.second + b.second}; }
Cell operator-(Cell a, Cell b) { return {a.first - b.first, a.second - b.second}; }

/// All z such that K meets K + z: those from which z -> nu z + d - e stays within twice the reach for ever.
std::set<Cell> meeting_translates(const Digits& of) {
    const double most = 2 * of.reach() + 1e-9;
    std::set<Cell> alive;
    for (std::int64_t x = -60; x <= 60; ++x)
        for (std::int64_t y = -60; y <= 60; ++y)
            if (std::abs(of.value({x, y})) <= most) alive.insert({x, y});
    for (bool changed = true; changed;) {
        changed = false;
        for (auto at = alive.begin(); at != alive.end();) {
            bool goes_on = false;
            for (const Cell& d : of.cells)
                for (const Cell& e : of.cells)
                    goes_on = goes_on || alive.contains(of.scaled(*at) + d - e);
            if (goes_on) {
                ++at;
            } else {
                at = alive.erase(at);
                changed = true;
            }
        }
    }
    alive.erase({0, 0});
    return alive;
}

/// The points of the grid with this denominator that lie in K, times it: x does if some nu x - d does, and so on.
std::set<Cell> grid_points(const Digits& of, std::int64_t denominator) {
    const double most = (of.reach() + 1e-9) * static_cast<double>(denominator);
    std::set<Cell> alive;
    const auto across = static_cast<std::int64_t>(4 * most);
    for (std::int64_t x = -across; x <= across; ++x)
        for (std::int64_t y = -across; y <= across; ++y)
            if (std::abs(of.value({x, y})) <= most) alive.insert({x, y});
    const auto parts = [&](Cell at) {
        std::vector<Cell> found;
        for (const Cell& d : of.cells)
            found.push_back(of.scaled(at) - Cell{d.first * denominator, d.second * denominator});
        return found;
    };
    std::vector<Cell> dead;
    std::map<Cell, int> left;
    std::map<Cell, std::vector<Cell>> before;
    for (const Cell& at : alive) {
        int count = 0;
        for (const Cell& next : parts(at))
            if (alive.contains(next)) {
                ++count;
                before[next].push_back(at);
            }
        left[at] = count;
        if (count == 0) dead.push_back(at);
    }
    while (!dead.empty()) {
        const Cell at = dead.back();
        dead.pop_back();
        alive.erase(at);
        for (const Cell& other : before[at])
            if (--left[other] == 0) dead.push_back(other);
    }
    return alive;
}

/// Whether the parts of a level hang together, where those meet that are moved by one of these steps.
bool is_chained(const Digits& of, const std::set<Cell>& steps, int level) {
    std::vector<Cell> points{{0, 0}};
    for (int n = 0; n < level; ++n) {
        std::set<Cell> next;
        for (const Cell& at : points)
            for (const Cell& d : of.cells) next.insert(of.scaled(at) + d);
        points.assign(next.begin(), next.end());
    }
    std::set<Cell> rest(points.begin(), points.end());
    std::vector<Cell> open{points.front()};
    rest.erase(points.front());
    while (!open.empty()) {
        const Cell at = open.back();
        open.pop_back();
        for (const Cell& step : steps)
            if (rest.erase(at + step) > 0) open.push_back(at + step);
    }
    return rest.empty();
}

std::set<Cell> places(const Tile& of) {
    std::set<Cell> found;
    for (const auto& neighbour : of.neighbours) found.insert({neighbour.by[0], neighbour.by[1]});
    return found;
}

/// From the first number to the one before the last, evenly from the first case on.
std::int64_t drawn(std::int64_t first, std::int64_t last) {
    constexpr int full_size = 100;
    return *rc::gen::resize(full_size, rc::gen::inRange<std::int64_t>(first, last));
}

/// A complete system of residues modulo nu, 0 first, each moved at random.
Digits random_residues(std::int64_t p, std::int64_t q, std::int64_t farthest) {
    Digits out{p, q, {}};
    for (std::int64_t k = 0; k < q; ++k) {
        const Cell move{drawn(-farthest, farthest + 1), drawn(-farthest, farthest + 1)};
        out.cells.push_back(Cell{k, 0} + (k == 0 ? Cell{0, 0} : out.scaled(move)));
    }
    return out;
}

constexpr std::size_t few = 3'000;  // ways, for random sets

const char* const dragon = "axiom FX; X -> X+YF+; Y -> -FX-Y; angle 90";

}  // namespace

TEST_CASE("the tiles of the literature") {
    const struct {
        const char *name, *text;
        const char *area, *unit;
        std::size_t neighbours;
        Answer disk_like, infinitely_many;
    } known[] = {
        // Heighway's dragon: Ngai and Nguyen, The Heighway dragon revisited, 2003.
        {"dragon", dragon, "1/2", "the square of the distance from its beginning to its end", 11,
         Answer::no, Answer::yes},
        {"terdragon", "axiom F; F -> F+F-F; angle 120", "sqrt(3)/6",
         "the square of the distance from its beginning to its end", 10, Answer::yes, Answer::no},
        {"gosper",
         "axiom A; A -> A-B--B+A++AA+B-; B -> +A-BB--B-A++A+B; interpret A -> F; interpret B -> F; "
         "angle 60",
         "sqrt(3)/2", "the square of the distance from its beginning to its end", 6, Answer::yes,
         Answer::no},
        {"hilbert", "axiom X; X -> -YF+XFX+FY-; Y -> +XF-YFY-FX+; angle 90", "1",
         "the square of the distance from its beginning to its end", 8, Answer::yes, Answer::no},
    };
    for (const auto& one : known) {
        CAPTURE(one.name);
        const Tile found = tile_of(one.text);
        CHECK(found.is_tile.answer == Answer::yes);
        REQUIRE(found.area_square);
        CHECK(square_root_text(*found.area_square) == one.area);
        CHECK(found.unit == one.unit);
        CHECK(found.least_neighbours == one.neighbours);
        CHECK(found.most_neighbours == one.neighbours);
        CHECK(found.neighbours.size() == one.neighbours);
        CHECK(found.connected.answer == Answer::yes);
        CHECK(found.disk_like.answer == one.disk_like);
        CHECK(found.interior_connected.answer == one.disk_like);
        CHECK(found.infinitely_many.answer == one.infinitely_many);
    }
}

TEST_CASE("the dragon of Levy has the area 1/4 and is parted by points") {
    // Bailey, Kim and Strichartz, Inside the Levy dragon, 2002.
    const Tile found = tile_of("axiom F; F -> +F--F+; angle 45");
    CHECK(found.is_tile.answer == Answer::yes);
    REQUIRE(found.area_square);
    CHECK(square_root_text(*found.area_square) == "1/4");
    CHECK(found.connected.answer == Answer::yes);
    CHECK(found.disk_like.answer == Answer::no);
    CHECK(found.interior_connected.answer == Answer::no);
}

TEST_CASE("curves without area and parts that overlap are no tiles") {
    const Tile thin = tile_of("axiom F; F -> F+F--F+F; angle 60");
    CHECK(thin.is_tile.answer == Answer::no);
    CHECK(thin.cells == Rational(0));
    // Nine squares of half the side that cover the square of twice it, the inner ones more than once.
    std::string rule;
    for (int x = 0; x < 3; ++x)
        for (int y = 0; y < 3; ++y)
            rule += "[" + std::string(static_cast<std::size_t>(x), 'f') + "+" +
                    std::string(static_cast<std::size_t>(y), 'f') + "-P]";
    const Tile over = tile_of("axiom Pf; P -> " + rule + "; f -> ff; angle 90; interpret P -> F");
    CHECK(over.is_tile.answer == Answer::no);
    CHECK(over.is_tile.because == "parts overlap in sets with area");
    CHECK(over.cells == Rational(4));
}

TEST_CASE("a union of tiles has an area, and its likeness to a disc is left open") {
    const Tile found =
        tile_of("axiom X-X; X -> X+Y+; Y -> -X-Y; interpret X -> F; interpret Y -> F; angle 90");
    CHECK(found.is_tile.answer == Answer::yes);
    CHECK(found.cells == Rational(1));
    CHECK(found.disk_like.answer == Answer::undecided);
    CHECK(found.disk_like.because == "the whole is a union of several tiles");
    CHECK(found.least_neighbours == 0);
}

TEST_CASE("consecutive collinear digits make a disc exactly if 2|p| <= |q + 2|") {
    // Leung and Lau, Disklikeness of planar self-affine tiles, 2007: six neighbours, or eight if p = 0.
    int discs = 0, others = 0;
    for (std::int64_t q = 2; q <= 9; ++q)
        for (std::int64_t p = -5; p <= 5; ++p) {
            if (p * p >= 4 * q) continue;
            CAPTURE(p);
            CAPTURE(q);
            Digits digits{p, q, {}};
            for (std::int64_t k = 0; k < q; ++k) digits.cells.emplace_back(k, 0);
            const Tile found = tile(digits.set());
            CHECK(found.is_tile.answer == Answer::yes);
            CHECK(found.is_periodic);
            CHECK(found.cells == Rational(1));
            CHECK(found.connected.answer == Answer::yes);
            const bool disc = 2 * std::abs(p) <= q + 2;
            CHECK((found.disk_like.answer == Answer::yes) == disc);
            CHECK(found.disk_like.answer != Answer::undecided);
            CHECK(found.interior_connected.answer == found.disk_like.answer);
            if (disc) CHECK(found.most_neighbours == (p == 0 ? 8 : 6));
            ++(disc ? discs : others);
        }
    CHECK(discs > 40);
    CHECK(others == 6);
}

TEST_CASE("neighbours are the translates that meet it") {
    int compared = 0, many = 0;
    CHECK(rc::check([&] {
        if (compared == 30) return;
        const auto p = drawn(-2, 3);
        const auto q = drawn(2, 5);
        if (p * p >= 4 * q) return;
        const Digits digits = random_residues(p, q, 1);
        const Tile found = tile(digits.set(), {}, few);
        if (found.is_tile.answer != Answer::yes || !found.is_periodic) return;
        const std::set<Cell> expected = meeting_translates(digits);
        RC_ASSERT(places(found) == expected);
        RC_ASSERT(found.most_neighbours == expected.size());
        ++compared;
        if (expected.size() > 8) ++many;
    }));
    CHECK(compared > 15);
    CHECK(many > 5);
}

TEST_CASE("the area of complete residues is how often a point is covered") {
    int compared = 0;
    CHECK(rc::check([&] {
        if (compared == 25) return;
        const auto p = drawn(-1, 2);
        const auto q = drawn(2, 4);
        const Digits digits = random_residues(p, q, 1);
        const Tile found = tile(digits.set(), {}, few);
        if (!found.cells) return;  // parts meet in too many ways
        // Points of the boundary are covered more often, and some small grids have no others.
        std::int64_t least = 1'000'000;
        for (const std::int64_t denominator : {7, 13}) {
            std::map<Cell, std::int64_t> covered;
            for (std::int64_t x = 0; x < denominator; ++x)
                for (std::int64_t y = 0; y < denominator; ++y) covered[{x, y}] = 0;
            const auto modulo = [&](std::int64_t x) {
                return (x % denominator + denominator) % denominator;
            };
            for (const auto& [x, y] : grid_points(digits, denominator))
                ++covered[{modulo(x), modulo(y)}];
            for (const auto& [at, times] : covered) least = std::min(least, times);
        }
        RC_ASSERT(*found.cells == Rational(least));
        RC_ASSERT(found.is_tile.answer == Answer::yes);
        ++compared;
    }));
    CHECK(compared == 25);
}

TEST_CASE("areas are near the share of a grid, also where parts overlap") {
    int compared = 0, overlapping = 0;
    CHECK(rc::check([&] {
        if (compared == 30) return;
        // All residues modulo 2i, and some digits more.
        Digits digits{0, 4, {{0, 0}, {1, 0}, {2, 0}, {3, 0}}};
        const std::int64_t more = drawn(0, 64);
        for (int k = 0; k < 6; ++k)
            if ((more >> k & 1) != 0) digits.cells.emplace_back(k % 3, 1 + k / 3);
        const Tile found = tile(digits.set());
        RC_ASSERT(found.cells);
        constexpr std::int64_t denominator = 23;
        const double near = static_cast<double>(grid_points(digits, denominator).size()) /
                            static_cast<double>(denominator * denominator);
        const double area = found.cells->to_double();
        RC_ASSERT(std::abs(area - near) < 0.15 * (1 + area));
        RC_ASSERT((found.is_tile.answer == Answer::yes) == (digits.cells.size() == 4));
        if (digits.cells.size() > 4) ++overlapping;
        ++compared;
    }));
    CHECK(compared == 30);
    CHECK(overlapping > 20);
}

TEST_CASE("a tile is connected exactly if its parts of a deep level hang together") {
    int connected = 0, apart = 0;
    CHECK(rc::check([&] {
        if (connected + apart == 20) return;
        const auto p = drawn(-2, 3);
        const auto q = drawn(3, 5);
        if (p * p >= 4 * q) return;
        const Digits digits = random_residues(p, q, 1);
        const Tile found = tile(digits.set(), {}, few);
        if (found.connected.answer == Answer::undecided) return;
        const bool is = is_chained(digits, meeting_translates(digits), 4);
        RC_ASSERT((found.connected.answer == Answer::yes) == is);
        ++(is ? connected : apart);
    }));
    CHECK(connected > 8);
    CHECK(apart > 0);
}

TEST_CASE("a tile of a lattice has the same neighbours in the tiling that it makes") {
    // A second state, the same tile again, hides that there is one only.
    int compared = 0;
    CHECK(rc::check([&] {
        if (compared == 30) return;
        const auto p = drawn(-2, 3);
        const auto q = drawn(2, 4);
        if (p * p >= 4 * q) return;
        const Digits digits = random_residues(p, q, 1);
        const Tile periodic = tile(digits.set(), {}, few);
        if (periodic.is_tile.answer != Answer::yes || !periodic.is_periodic) return;
        LatticeSet two = digits.set();
        two.parts.push_back(two.parts[0]);
        for (auto& part : two.parts[0]) part.state = 1;
        two.shapes = {0, 0};
        const Tile found = tile(two, {}, few);
        RC_ASSERT(!found.is_periodic);
        if (found.most_neighbours == 0) return;  // more ways than are looked at
        RC_ASSERT(found.cells == periodic.cells);
        RC_ASSERT(found.least_neighbours == periodic.most_neighbours);
        RC_ASSERT(found.most_neighbours == periodic.most_neighbours);
        RC_ASSERT(places(found) == places(periodic));
        // What is decided in another way must agree.
        if (found.disk_like.answer != Answer::undecided)
            RC_ASSERT(found.disk_like.answer == periodic.disk_like.answer);
        RC_ASSERT(found.connected.answer == periodic.connected.answer);
        ++compared;
    }));
    CHECK(compared > 15);
}

TEST_CASE("square roots of rational numbers are written shortly") {
    CHECK(square_root_text(Rational(0)) == "0");
    CHECK(square_root_text(Rational(1, 4)) == "1/2");
    CHECK(square_root_text(Rational(3, 4)) == "sqrt(3)/2");
    CHECK(square_root_text(Rational(27, 196)) == "3*sqrt(3)/14");
    CHECK(square_root_text(Rational(2, 3)) == "sqrt(6)/3");
    CHECK(square_root_text(Rational(8)) == "2*sqrt(2)");
}

TEST_CASE("outlines are polygons as large as the area, and do not overlap") {
    const Tile found = tile_of(
        "axiom A; A -> A-B--B+A++AA+B-; B -> +A-BB--B-A++A+B; interpret A -> F; interpret B -> F; "
        "angle 60");
    const auto outlines = tile_outlines(found, 200);
    REQUIRE(outlines.size() == 7);
    const auto area = [](const std::vector<Point>& polygon) {
        double sum = 0;
        for (std::size_t i = 0; i < polygon.size(); ++i) {
            const Point a = polygon[i], b = polygon[(i + 1) % polygon.size()];
            sum += a.x * b.y - a.y * b.x;
        }
        return sum / 2;
    };
    const LatticeSet& set = found.set;
    const double cell =
        std::abs(set.places[0].x * set.places[1].y - set.places[0].y * set.places[1].x);
    for (const auto& outline : outlines)
        CHECK(area(outline) == doctest::Approx(cell).epsilon(0.05));
}

TEST_CASE("each neighbour of a periodic tile has its own outline") {
    Digits digits{1, 3, {{0, 0}, {1, 0}, {2, 0}}};
    const Tile found = tile(digits.set());
    REQUIRE(found.is_periodic);
    REQUIRE(found.neighbours.size() == 6);
    const auto outlines = tile_outlines(found, 300);
    REQUIRE(outlines.size() == 7);
    const auto middle = [](const std::vector<Point>& polygon) {
        double x = 0, y = 0, sum = 0;
        for (std::size_t i = 0; i < polygon.size(); ++i) {
            const Point a = polygon[i], b = polygon[(i + 1) % polygon.size()];
            const double part = a.x * b.y - a.y * b.x;
            sum += part;
            x += (a.x + b.x) * part;
            y += (a.y + b.y) * part;
        }
        return Point{x / (3 * sum), y / (3 * sum)};
    };
    const Point own = middle(outlines[0]);
    const LatticeSet& set = found.set;
    for (std::size_t k = 0; k < found.neighbours.size(); ++k) {
        const Point its = middle(outlines[k + 1]);
        const auto& by = found.neighbours[k].by;
        const double x = static_cast<double>(by[0]) * set.places[0].x +
                         static_cast<double>(by[1]) * set.places[1].x,
                     y = static_cast<double>(by[0]) * set.places[0].y +
                         static_cast<double>(by[1]) * set.places[1].y;
        CHECK(std::hypot(its.x - own.x - x, its.y - own.y - y) < 0.1);
    }
}

TEST_CASE("a tile that lies far from the origin has the outline of the same tile nearby") {
    // With c more in each digit all moves by c / (nu - 1).
    const std::int64_t more = 50;
    const Digits near{2, 2, {{0, 0}, {1, 0}}}, far{2, 2, {{more, 0}, {more + 1, 0}}};
    const Complex by = static_cast<double>(more) / (near.factor() - 1.0);
    const Tile first = tile(near.set()), second = tile(far.set());
    const auto sides = [](const std::vector<Point>& polygon) {
        std::array<double, 4> found{INFINITY, -INFINITY, INFINITY, -INFINITY};
        for (const Point at : polygon)
            found = {std::min(found[0], at.x), std::max(found[1], at.x), std::min(found[2], at.y),
                     std::max(found[3], at.y)};
        return found;
    };
    const auto own = sides(tile_outlines(first, 100).front());
    const auto moved = sides(tile_outlines(second, 100).front());
    const double pixels = 3 * (own[1] - own[0]) / 100;
    for (std::size_t k = 0; k < 4; ++k)
        CHECK(std::abs(moved[k] - own[k] - (k < 2 ? by.real() : by.imag())) < pixels);
}

TEST_CASE("outlines stop when they are asked to") {
    const Tile found = tile(Digits{2, 2, {{0, 0}, {1, 0}}}.set());
    std::atomic<bool> stop = true;
    Budget budget;
    budget.stop = &stop;
    CHECK_THROWS_AS(tile_outlines(found, 200, budget), Interrupted);
}

TEST_CASE("a product of two linear tiles with gaps is not connected") {
    // nu = sqrt(-3) makes A x A, where A has the digits 0, 1 and 5 to the base -3 and is no interval.
    const Tile found = tile(Digits{0, 3, {{0, 0}, {1, 0}, {5, 0}}}.set());
    CHECK(found.is_tile.answer == Answer::yes);
    CHECK(found.connected.answer == Answer::no);
}

TEST_CASE("a tile that is very much smaller than a cell is not said to have no inner points") {
    // Each of many states is half as large as the next one, and the last is the twindragon.
    LatticeSet set = Digits{2, 2, {{0, 0}, {1, 0}}}.set();
    constexpr std::size_t count = 410;
    const std::vector<LatticeSet::Part> twindragon = set.parts.front();
    set.parts.clear();
    set.shapes.clear();
    for (std::size_t k = 0; k < count; ++k) {
        set.parts.push_back({{std::min(k + 1, count - 1), {}}});
        set.shapes.push_back(k);
    }
    set.parts.back() = {{count - 1, twindragon[0].by}, {count - 1, twindragon[1].by}};
    const Tile found = tile(set);
    CHECK(found.is_tile.answer == Answer::undecided);
    CHECK(found.is_tile.because == "whether it has inner points is not seen");
    REQUIRE(found.cells_between);
    CHECK(found.cells_between->first.is_zero());
    CHECK_FALSE(found.cells_between->second.is_zero());
}

TEST_CASE("a triangle with a line on it is no tile") {
    const Tile found =
        tile_of("axiom FL; F -> [F][+f-F][f+f++F]fF; f -> ff; L -> LL; angle 60; interpret L -> F");
    CHECK(found.is_tile.answer != Answer::yes);
}

TEST_CASE("squares that touch at a corner are no disc") {
    const Tile found = tile_of("axiom F; F -> [F][ff+F][ff+ff-F][ffff+ffF]ff; f -> ff; angle 90");
    CHECK(found.is_tile.answer == Answer::yes);
    CHECK(found.connected.answer == Answer::yes);
    CHECK(found.disk_like.answer == Answer::no);
    CHECK(found.disk_like.because == "without one of its points it is not connected");
    CHECK(found.interior_connected.answer == Answer::no);
}

TEST_CASE("the disc around discs has the middle of their box") {
    const auto found = around({{{0, 1}, 0}, {{0, 3}, 0}, {{4, 2}, 1}});
    CHECK(std::abs(found.centre - Complex{2.5, 2}) < 1e-12);
    CHECK(found.radius == doctest::Approx(std::hypot(2.5, 1)));
}

TEST_CASE("the disc of a square is hardly larger than the square") {
    LatticeSet square;
    square.scale = {{{2, 0, 0}, {0, 2, 0}, {}}};
    square.places = {{{1, 0}, {0, 1}, {}}};
    square.linear = {2, 0, 0, 2};
    square.parts = {{{0, {0, 0, 0}}, {0, {1, 0, 0}}, {0, {0, 1, 0}}, {0, {1, 1, 0}}}};
    const auto discs = discs_of(square);
    REQUIRE(discs.size() == 1);
    CHECK(std::abs(discs[0].centre - Complex{0.5, 0.5}) < 1e-3);
    CHECK(discs[0].radius >= std::sqrt(0.5));
    CHECK(discs[0].radius < 0.71);

    square.linear = {3, 0, 0, 0.9};
    CHECK_THROWS_WITH_AS(discs_of(square), "some distances do not become smaller in parts", Error);
    square.linear = {2, 0, 0, 2};
    square.rank = 3;
    CHECK_THROWS_WITH_AS(boundary_dimension(square), "the lattice lies densely in the plane",
                         Error);
}

TEST_CASE("a set without interior, and one that is sheared, have no dimension of the boundary") {
    LatticeSet set;
    set.scale = {{{2, 0, 0}, {0, 2, 0}, {}}};
    set.places = {{{1, 0}, {0, 1}, {}}};
    set.linear = {2, 0, 0, 2};
    set.parts = {{{0, {0, 0, 0}}, {0, {1, 0, 0}}, {0, {0, 1, 0}}}};
    set.shapes = {0};
    set.whole = {{0, {}}};
    CHECK_FALSE(boundary_dimension(set));  // a triangle of Sierpinski
    set.parts[0].push_back({0, {1, 1, 0}});
    CHECK(boundary_dimension(set));  // a square
    set.scale[1] = {1, 2, 0};
    set.linear = {2, 1, 0, 2};
    CHECK_THROWS_WITH_AS(boundary_dimension(set), "the whole is not similar to what it is made of",
                         Error);
}

TEST_CASE("a cell is measured by the axiom's first part where its way is closed by a branch") {
    const std::string rules = "; A -> A+B; B -> A-B; interpret A -> F; interpret B -> F; angle 90";
    const LatticeSet open = limit("axiom A" + rules), closed = limit("axiom [A]" + rules);
    REQUIRE(open.cell_square);
    REQUIRE(closed.cell_square);
    CHECK(*closed.cell_square == *open.cell_square);
    CHECK(closed.unit ==
          "the square of the distance from the beginning of its first part to its end");
}

TEST_CASE("parallelograms lie in a lattice that does not turn, whose basis is short") {
    // The lattice is that of 7 + z and 17 + 2z, with z = e^(72 i); its shortest vectors are not those.
    const std::string one = "fffffff+f-", two = "fffffffffffffffff+ff-";
    const LatticeSet found = limit("axiom A; A -> [A][" + one + "A][" + two + "A][" + one + two +
                                   "A]; f -> ff; interpret A -> F; angle 72");
    const Complex first{found.places[0].x, found.places[0].y};
    const Complex second{found.places[1].x, found.places[1].y};
    CHECK(std::abs(found.determinant()) == 4);
    CHECK(std::abs(second) >= std::abs(first) * (1 - 1e-6));
    CHECK(2 * std::abs((second / first).real()) <= 1 + 1e-6);
}

TEST_CASE("a lattice with one vector much longer than the other is one of the plane") {
    const std::string one = "f", two = "+" + std::string(1100, 'f') + "-";
    const LatticeSet found = limit("axiom A; A -> [A][" + one + "A][" + two + "A][" + one + two +
                                   "A]; f -> ff; interpret A -> F; angle 90");
    const Complex first{found.places[0].x, found.places[0].y};
    const Complex second{found.places[1].x, found.places[1].y};
    CHECK(std::abs(found.determinant()) == 4);
    CHECK(std::abs(second) == doctest::Approx(1100 * std::abs(first)));
}

TEST_CASE("a set whose parts are all in one place lies in no lattice") {
    CHECK_THROWS_WITH_AS(limit("axiom A; A -> [A]f; f -> ff; interpret A -> F"),
                         "positions lie in no lattice of the plane", Error);
}
