#include "dimension/dimension.hpp"
#include "nature/nature.hpp"
#include "turtle/turtle.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>
#include <rapidcheck.h>
#include <set>
#include <string>
#include <vector>

#include <cmath>
#include <map>

#include "exact/exact.hpp"
#include "nature/detail/iterated_functions.hpp"
#include "notation/notation.hpp"
#include "oracle/addresses.hpp"

using namespace algae;

namespace {

const char* const fern =
    "map 0 0 0 0.16 0 0 0.01\n"
    "map 0.85 0.04 -0.04 0.85 0 1.6 0.85\n"
    "map 0.2 -0.26 0.23 0.22 0 1.6 0.07\n"
    "map -0.15 0.28 0.26 0.24 0 0.44 0.07\n";
const char* const gasket =
    "map 1/2 0 0 1/2 0 0\nmap 1/2 0 0 1/2 1/2 0\nmap 1/2 0 0 1/2 1/4 sqrt(3)/4\n";

IteratedFunctions functions(const std::string& text) {
    return dynamic_cast<const IteratedFunctions&>(*read_generator(text, "maps.ifs"));
}

std::string message(const std::string& text) {
    try {
        functions(text);
    } catch (const Error& error) {
        return error.what();
    }
    return "none";
}

std::vector<oracle::Placed> placed(const IteratedFunctions& system) {
    std::vector<oracle::Placed> found;
    for (const auto& [numbers, map, from, to, chance, ratio, name, similar] : system.maps)
        found.push_back({{map.a, map.b, map.c, map.d, map.e, map.f}, from, to});
    return found;
}

std::vector<std::pair<double, double>> sent(const IteratedFunctions& system, double accuracy) {
    std::vector<std::pair<double, double>> found;
    send_attractor(system, accuracy,
                   [&](std::span<const Dot> dots) {
                       for (const Dot& dot : dots) found.emplace_back(dot.place.x, dot.place.y);
                   },
                   {});
    return found;
}

}  // namespace

TEST_CASE("Barnsley's fern: norms, fixed points and box") {
    const IteratedFunctions system = functions(fern);
    const std::vector<double> norms{0.16, 0.850941, 0.340712, 0.379152};
    const std::vector<Point> fixed{
        {0, 0}, {2.655602, 9.958506}, {-0.608365, 1.871892}, {0.153769, 0.631553}};
    for (std::size_t m = 0; m < 4; ++m) {
        CHECK(norm(system.maps[m].map) == doctest::Approx(norms[m]).epsilon(1e-5));
        CHECK(fixed_point(system.maps[m].map).x == doctest::Approx(fixed[m].x).epsilon(1e-5));
        CHECK(fixed_point(system.maps[m].map).y == doctest::Approx(fixed[m].y).epsilon(1e-5));
    }
    // Only the second map is a similarity.
    for (std::size_t m = 0; m < 4; ++m) {
        const AffineMap& map = system.maps[m].map;
        CHECK((std::fabs(norm(map) - least_stretch(map)) < 1e-12) == (m == 1));
        CHECK(system.maps[m].ratio.has_value() == (m == 1));
    }
    const Box box = attractor_boxes(system).front();
    CHECK(box.low.x == doctest::Approx(-2.182).epsilon(0.003));
    CHECK(box.high.x == doctest::Approx(2.656).epsilon(0.003));
    CHECK(std::fabs(box.low.y) < 0.02);
    CHECK(box.high.y == doctest::Approx(9.998).epsilon(0.003));
}

TEST_CASE("the chaos game plots so many points, each map as often as its chance says") {
    const auto figure = chaos_game(functions(fern), 50'000, {});
    CHECK(figure->segments() == Integer(50'000));
    struct Counting : Canvas {
        std::map<std::uint32_t, int> dots;
        std::uint32_t now = 0;
        void move_to(Point) override {}
        void line_to(Point) override { ++dots[now]; }
        void polygon(std::span<const Point>) override {}
        void width(double) override {}
        void width_as_length(double) override {}
        void colour(std::uint32_t index) override { now = index; }
        void paint(const Colour&) override {}
        void position(double) override {}
    } canvas;
    figure->draw(canvas, 0, {});
    const std::vector<double> chances{0.01, 0.85, 0.07, 0.07};
    for (std::uint32_t m = 0; m < 4; ++m) {
        const double expected = 50'000 * chances[m];
        CHECK(std::fabs(canvas.dots[m] - expected) < 5 * std::sqrt(expected));
    }
}

TEST_CASE("points sent of an attractor lie on it and leave no gaps") {
    CHECK(rc::check([] {
        const auto number = [](int size) { return *rc::gen::inRange(-size, size + 1) / 100.0; };
        IteratedFunctions system;
        system.states = *rc::gen::arbitrary<bool>() ? std::vector<std::string>{""}
                                                    : std::vector<std::string>{"a", "b"};
        const auto state = [&] {
            return static_cast<std::size_t>(
                *rc::gen::inRange(0, static_cast<int>(system.states.size())));
        };
        for (std::size_t m = 0; m < 3; ++m) {
            IteratedFunctions::Map map;
            map.map = {number(30), number(30), number(30), number(30), number(100), number(100)};
            map.from = m < system.states.size() ? m : state();
            map.to = state();
            map.name = "map";
            system.maps.push_back(map);
        }
        system.check();
        constexpr double accuracy = 0.02;
        const auto mine = sent(system, accuracy);
        const auto all = oracle::addressed_points(placed(system), 8, 0, 0);
        // After 8 maps of norm at most 0.6 an address is within 0.6^8 of the set's size, below 4.
        const double rest = 4 * std::pow(0.6, 8);
        RC_ASSERT(oracle::farthest_from(all, mine) <= accuracy + rest);
        RC_ASSERT(oracle::farthest_from(mine, all) <= rest);
        const Box box = attractor_boxes(system).front();
        for (const auto& [x, y] : mine) {
            RC_ASSERT(x >= box.low.x - 1e-9);
            RC_ASSERT(x <= box.high.x + 1e-9);
            RC_ASSERT(y >= box.low.y - 1e-9);
            RC_ASSERT(y <= box.high.y + 1e-9);
        }
    }));
}

TEST_CASE("copies come nearer to the attractor with every generation") {
    const IteratedFunctions system = functions(gasket);
    CHECK(copies(system, 5, {})->paths().size() == 243);
    const auto points = sent(system, 0.005);
    double before = INFINITY;
    for (std::uint64_t n = 0; n < 5; ++n) {
        std::vector<std::pair<double, double>> corners;
        const auto figure = copies(system, n, {});
        for (const Path& path : figure->paths())
            for (const Point& point : path.points) corners.emplace_back(point.x, point.y);
        const double distance = std::max(oracle::farthest_from(corners, points), 0.0);
        CHECK(distance <= before / 2 + 0.01);
        before = distance;
    }
}

TEST_CASE("similarity dimensions") {
    const auto text = [](const std::string& maps) {
        return similarity_dimension(functions(maps)).value->text();
    };
    CHECK(text(gasket) == "log 3 / log 2");
    CHECK(text("similarity 1/3 0 0 0\nsimilarity 1/3 60 1/3 0\nsimilarity 1/3 -60 1/2 sqrt(3)/6\n"
               "similarity 1/3 0 2/3 0\n") == "log 4 / log 3");
    CHECK(text("similarity sqrt(1/2) 45 0 0\nsimilarity sqrt(1/2) 135 1 0\n") ==
          "log 2 / log sqrt 2 = 2");
    CHECK(text("map 0.5 0 0 0.5 0 0\nmap 0.25 0 0 0.25 0.75 0\n") == "0.5^s + 0.25^s = 1");
    const auto unequal =
        similarity_dimension(functions("map 0.5 0 0 0.5 0 0\nmap 0.25 0 0 0.25 0.75 0\n"));
    CHECK(unequal.value->decimal(6) == "0.694242");  // log of the golden section over log 2
    CHECK(similarity_dimension(functions(fern)).status == ExactDimension::Status::none);
}

TEST_CASE("parts that are proved to lie apart make the similarity dimension exact") {
    using Status = ExactDimension::Status;
    const auto found = [](const std::string& maps) {
        return similarity_dimension(functions(maps));
    };
    const ExactDimension triangle =
        found("map 1/2 0 0 1/2 0 0\nmap 1/2 0 0 1/2 1/2 0\nmap 1/2 0 0 1/2 0 1/2\n");
    CHECK(triangle.status == Status::exact);
    CHECK(triangle.conditions.back() ==
          "parts meet in finitely many ways and no two coincide, so the open set condition holds");
    // Unequal ratios, quarter turns, a square in four parts.
    CHECK(found("map 0.5 0 0 0.5 0 0\nmap 0.25 0 0 0.25 0.75 0\n").status == Status::exact);
    CHECK(found("similarity 1/2 90 1/2 0\nsimilarity 1/2 0 0 1/2\nsimilarity 1/2 0 1/2 1/2\n"
                "similarity 1/2 -90 1/2 1/2\n")
              .value->rational() == Rational(2));
    // f_1 f_2 = f_3 f_1: exact overlaps.
    const ExactDimension overlaps =
        found("map 1/3 0 0 1/3 0 0\nmap 1/3 0 0 1/3 3 0\nmap 1/3 0 0 1/3 1 0\n");
    CHECK(overlaps.status == Status::upper_bound);
    CHECK(overlaps.conditions.back() == "two parts coincide, so the dimension is smaller");
    // Numbers outside every cyclotomic field: not decided.
    CHECK(found("similarity 2^(-1/3) 45 0 0\nsimilarity 2^(-1/3) 135 1 0\n").status ==
          Status::upper_bound);
}

TEST_CASE("curves written with square roots and turns have their exact dimensions") {
    using Status = ExactDimension::Status;
    const std::pair<const char*, const char*> known[] = {
        {"similarity 1/3 0 0 0\nsimilarity 1/3 60 1/3 0\nsimilarity 1/3 -60 1/2 sqrt(3)/6\n"
         "similarity 1/3 0 2/3 0\n",
         "log 4 / log 3"},
        {"map 1/3 0 0 1/3 0 0\nmap 1/6 -sqrt(3)/6 sqrt(3)/6 1/6 1/3 0\n"
         "map 1/6 sqrt(3)/6 -sqrt(3)/6 1/6 1/2 sqrt(3)/6\nmap 1/3 0 0 1/3 2/3 0\n",
         "log 4 / log 3"},
        {"similarity sqrt(1/2) 45 0 0\nsimilarity sqrt(1/2) 135 1 0\n", "log 2 / log sqrt 2 = 2"},
        {"similarity 2^(-1/2) 45 0 0\nsimilarity 0.5^0.5 -45 1/2 1/2\n", "log 2 / log sqrt 2 = 2"},
        {"similarity 1/sqrt(3) 30 0 0\nsimilarity 1/sqrt(3) -90 1/2 1/(2*sqrt(3))\n"
         "similarity 1/sqrt(3) 30 1/2 -1/(2*sqrt(3))\n",
         "log 3 / log sqrt 3 = 2"},
        {"similarity (3-sqrt(5))/2 0 1 0\nsimilarity (3-sqrt(5))/2 0 cos(72) sin(72)\n"
         "similarity (3-sqrt(5))/2 0 cos(144) sin(144)\n"
         "similarity (3-sqrt(5))/2 0 cos(144) -sin(144)\n"
         "similarity (3-sqrt(5))/2 0 cos(72) -sin(72)\n",
         nullptr},
        // Mirror images: Levy's curve has none, the right triangle in two halves does.
        {"map 1/2 1/2 1/2 -1/2 0 0\nmap 1/2 -1/2 -1/2 -1/2 1/2 1/2\n", "log 2 / log sqrt 2 = 2"},
        {"similarity 1/3 45.5 0 0\nsimilarity 1/3 0 1 0\n", "log 2 / log 3"},
        // Two states: segments in halves and Cantor's set of them.
        {"state A\nmap 1/3 0 0 1/3 0 0 -> A\nmap 1/3 0 0 1/3 2/3 0 -> B\nstate B\n"
         "map 1/3 0 0 1/3 0 0 -> A\nmap 1/3 0 0 1/3 2/3 0 -> B\n",
         "log 2 / log 3"},
    };
    for (const auto& [maps, formula] : known) {
        INFO(maps);
        const ExactDimension found = similarity_dimension(functions(maps));
        CHECK(found.status == Status::exact);
        if (formula)
            CHECK(found.value->text() == formula);
        else  // Sierpinski's pentagon
            CHECK(found.value->decimal(6) == "1.672276");
    }
    // Both states are one set: their parts lie in the same places, but no part is there twice.
    const char* const twice =
        "state A\nmap 1/2 0 0 1/2 0 0 -> A\nmap 1/2 0 0 1/2 0 0 -> A\nmap 1/2 0 0 1/2 1/2 0 -> B\n"
        "state B\nmap 1/2 0 0 1/2 0 0 -> A\n";
    CHECK(similarity_dimension(functions(twice)).conditions.back() ==
          "two parts coincide, so the dimension is smaller");
}

TEST_CASE("maps to points add nothing to the dimension") {
    const ExactDimension found = similarity_dimension(
        functions("map 0 0 0 0 3 3\nmap 1/3 0 0 1/3 0 0\nmap 1/3 0 0 1/3 2/3 0\n"));
    CHECK(found.status == ExactDimension::Status::exact);
    CHECK(found.value->text() == "log 2 / log 3");
    CHECK(similarity_dimension(functions("map 0 0 0 0 3 3\n")).conditions.front() ==
          "a map takes everything to one point");
}

TEST_CASE("numbers of a cyclotomic field are those of floating point") {
    int compared = 0;
    CHECK(rc::check([&] {
        const long n = *rc::gen::inRange(1, 30), m = *rc::gen::inRange(1, 30);
        const long degrees = *rc::gen::inRange(-40, 40) * 9;
        const std::string text = "(sqrt(" + std::to_string(n) + "/" + std::to_string(m) +
                                 ")-1/3*cos(" + std::to_string(degrees) + "))/(2+sin(" +
                                 std::to_string(degrees) + "))^2*" + std::to_string(m) + "^(-0.5)";
        const IteratedFunctions maps = functions("map 1/2 0 0 1/2 " + text + " 0\n");
        const Expression& number = maps.maps[0].numbers[4].expression;
        const auto order = cyclotomic_order({&number});
        if (!order) return;
        const CyclotomicField field(*order);
        const auto value = field.value_of(number);
        RC_ASSERT(value.has_value());
        const std::complex<double> found = field.to_complex(*value);
        RC_ASSERT(std::abs(found - maps.maps[0].numbers[4].value) < 1e-9);
        if (!field.is_zero(*value))
            RC_ASSERT(field.product(*value, field.inverse(*value)) == field.rational(1));
        ++compared;
    }));
    CHECK(compared > 50);
}

TEST_CASE("parts of random maps in an exact lattice coincide exactly where words written out do") {
    // z -> zeta_6^a (z + d) / b with d in the lattice of zeta_6; all words of up to five maps.
    int apart = 0, coincide = 0;
    CHECK(rc::check([&] {
        const long base = *rc::gen::inRange(2, 4);
        using Map = std::array<long, 3>;  // turn, and the shift in the basis 1, zeta
        const auto turned = [](long x, long y, long turn) {
            for (; turn > 0; --turn) std::tie(x, y) = std::pair(-y, x + y);
            return std::pair(x, y);
        };
        std::vector<Map> maps;
        std::string text;
        for (int k = 0; k < 3; ++k) {
            const long turn = *rc::gen::inRange(0, 6), x = *rc::gen::inRange(0, 3),
                       y = *rc::gen::inRange(0, 3);
            maps.push_back({turn, x, y});
            text += fmt::format("similarity 1/{0} {1} ({2}+{3}/2)/{0} {3}*sqrt(3)/2/{0}\n", base,
                                60 * turn, x, y);
        }
        std::set<Map> words{{0, 0, 0}};
        std::size_t all = 1;
        for (int level = 0; level < 5 && words.size() == all; ++level, all *= 3) {
            std::set<Map> next;  // w then a map inside: w(z) = zeta^t z + base^-n s
            for (const auto& [t, x, y] : words)
                for (const auto& [turn, u, v] : maps) {
                    const auto [p, q] = turned(u, v, t);
                    next.insert({(t + turn) % 6, base * x + p, base * y + q});
                }
            words = std::move(next);
        }
        const bool lost = words.size() < all;
        const Separation found = separation(functions(text), {0}, Budget());
        if (lost) RC_ASSERT(found == Separation::coincide);
        if (found == Separation::apart) RC_ASSERT(!lost);
        RC_ASSERT(found != Separation::unknown);
        ++(lost ? coincide : apart);
    }));
    CHECK(apart > 20);
    CHECK(coincide > 5);
}

TEST_CASE("parts coincide exactly where sums of digits do") {
    int apart = 0, coincide = 0;
    CHECK(rc::check([&] {
        const std::vector<int> digits{0, *rc::gen::inRange(1, 4), *rc::gen::inRange(4, 8)};
        const int base = *rc::gen::inRange(3, 5);
        std::string maps;
        for (const int digit : digits)
            maps += "map 1/" + std::to_string(base) + " 0 0 1/" + std::to_string(base) + " " +
                    std::to_string(digit) + " 0\n";
        // All sums of so many digits times powers: differences stay below 8, so 8 levels suffice.
        std::set<long> sums{0};
        std::size_t words = 1;
        for (int level = 0; level < 8 && sums.size() == words; ++level) {
            std::set<long> next;
            for (const long sum : sums)
                for (const int digit : digits) next.insert(sum * base + digit);
            sums = std::move(next);
            words *= digits.size();
        }
        const bool lost = sums.size() < words;
        const Separation found = separation(functions(maps), {0}, Budget());
        RC_ASSERT(found == (lost ? Separation::coincide : Separation::apart));
        ++(lost ? coincide : apart);
    }));
    CHECK(apart > 20);
    CHECK(coincide > 5);
}

TEST_CASE("what is wrong with a file of maps") {
    CHECK(message("map 1.5 0 0 0.5 0 0\n") ==
          "maps.ifs: map 1 (line 1) does not contract: its norm is 1.5, expected less than 1");
    CHECK(message("map 0.5 0 0 0.5 0 0 0.5\nmap 0.5 0 0 0.5 1 0 0.4\n") ==
          "maps.ifs: the probabilities add up to 0.9, expected 1");
    CHECK(message("map 0.5 0 0 0.5 0 0 0.5\nmap 0.5 0 0 0.5 1 0\n") ==
          "maps.ifs: map 2 (line 2) has no probability, others do");
    CHECK(message("map 0.5 0 0 0.5 0\n") ==
          "maps.ifs:1:1: error: expected map a b c d e f [probability], found 5 values\n"
          "  map 0.5 0 0 0.5 0\n  ^");
    CHECK(message("map 0.5 0 x 0.5 0 0\n") ==
          "maps.ifs:1:11: error: expected a number or a constant, found 'x'\n"
          "  map 0.5 0 x 0.5 0 0\n            ^");
    CHECK(message("title t\n") ==
          "maps.ifs: has no maps; expected lines such as `map 0.5 0 0 0.5 0 0`");
    CHECK(message("mapp 1 2\n") ==
          "maps.ifs:1:1: error: unknown statement 'mapp'; did you mean 'map'?; expected one of "
          "title, source, colour, width, state, map, similarity, points, generation, seed, from, "
          "start\n  mapp 1 2\n  ^");
    CHECK(message("state a\nmap 0.5 0 0 0.5 0 0 -> b\n") ==
          "maps.ifs:2:24: error: no state of that name; expected one that a line `state b` begins\n"
          "  map 0.5 0 0 0.5 0 0 -> b\n                         ^");
    CHECK(message("points 0\nmap 0.5 0 0 0.5 0 0\n") ==
          "maps.ifs:1:8: error: expected points with a whole number from 1 to 1099511627776, found "
          "'0'\n  points 0\n         ^");
}

TEST_CASE("what is printed reads back as the same") {
    for (const std::string& text :
         {std::string(fern), std::string(gasket),
          std::string(
              "# above\ntitle  A title   # behind\nmap 1/2 0 0 (1 / 2) 0 0 # b\n# end\n")}) {
        const std::string printed = format_generator(text, "maps.ifs");
        CHECK(format_generator(printed, "maps.ifs") == printed);
        const IteratedFunctions system = functions(text);
        const GeneratorFile file = ifs_file(system);
        const IteratedFunctions again = functions(print_generator_file(file));
        CHECK(ifs_file(again) == file);
        CHECK(again.maps.size() == system.maps.size());
        for (std::size_t m = 0; m < system.maps.size(); ++m)
            CHECK(again.maps[m].map == system.maps[m].map);
    }
    CHECK(rc::check([] {
        GeneratorFile file;
        const auto count = *rc::gen::inRange(0, 6);
        for (int i = 0; i < count; ++i) {
            std::vector<std::string> words;
            const auto length = *rc::gen::inRange(1, 5);
            for (int k = 0; k < length; ++k)
                words.push_back(*rc::gen::element<std::string>("1", "-2.5", "1/3", "(0,1)", "->",
                                                               "a", "sqrt(3)/4"));
            file.add("map", words);
        }
        RC_ASSERT(read_generator_file(print_generator_file(file), "f.ifs", ifs_kind().keys) ==
                  file);
    }));
}

namespace {

/// A grid of m lines of n cells, some of them kept, on a rectangle anywhere; lines stand upright if `turned`.
struct Carpet {
    long m, n;
    std::vector<std::vector<long>> lines;  // the cells that are kept
    bool turned;
    std::string text() const {
        const Rational left(7, 3), width(5, 4), low(-2), height(3, 7);
        std::string found;
        for (std::size_t line = 0; line < lines.size(); ++line)
            for (const long cell : lines[line]) {
                const auto [over, under] = turned ? std::pair(m, n) : std::pair(n, m);
                const auto [i, k] = turned ? std::pair(static_cast<long>(line), cell)
                                           : std::pair(cell, static_cast<long>(line));
                const Rational x =
                    left * (Rational(1) - Rational(1, over)) + width * Rational(i, over);
                const Rational y =
                    low * (Rational(1) - Rational(1, under)) + height * Rational(k, under);
                found += "map 1/" + std::to_string(over) + " 0 0 1/" + std::to_string(under) + " " +
                         to_string(x) + " " + to_string(y) + "\n";
            }
        return found;
    }
};

/// The largest dimension of a measure that gives each line a share q and divides it evenly among its cells: entropy over the
/// exponents of Lyapunov (Ledrappier and Young 1985). By going up along the gradient; the shares are the only unknowns.
double largest_dimension(const Carpet& of) {
    const double m = std::log(static_cast<double>(of.m)), n = std::log(static_cast<double>(of.n));
    std::vector<double> share, cells;
    for (const auto& line : of.lines)
        if (!line.empty()) cells.push_back(static_cast<double>(line.size()));
    share.assign(cells.size(), 1 / static_cast<double>(cells.size()));
    const auto value = [&] {
        double found = 0;
        for (std::size_t k = 0; k < cells.size(); ++k)
            found += share[k] * (-std::log(share[k]) / m + std::log(cells[k]) / n);
        return found;
    };
    for (int round = 0; round < 4000; ++round) {
        double sum = 0;
        for (std::size_t k = 0; k < cells.size(); ++k) {
            share[k] *= std::exp(0.05 * (-std::log(share[k]) / m + std::log(cells[k]) / n));
            sum += share[k];
        }
        for (double& each : share) each /= sum;
    }
    return value();
}

}  // namespace

TEST_CASE("dimensions of random self-affine carpets are those of the best measures on them") {
    std::size_t compared = 0, uneven = 0;
    CHECK(rc::check("carpets", [&] {
        Carpet carpet;
        carpet.m = *rc::gen::inRange<long>(2, 6);
        carpet.n = *rc::gen::inRange<long>(carpet.m + 1, 9);
        carpet.turned = *rc::gen::arbitrary<bool>();
        std::set<std::size_t> sizes;
        for (long line = 0; line < carpet.m; ++line) {
            auto& kept = carpet.lines.emplace_back();
            for (long cell = 0; cell < carpet.n; ++cell)
                if (*rc::gen::inRange(0, 3) == 0) kept.push_back(cell);
            if (!kept.empty()) sizes.insert(kept.size());
        }
        if (sizes.empty()) return;
        const auto found = functions(carpet.text()).exact_dimension({});
        RC_ASSERT(found && found->status == ExactDimension::Status::exact);
        const double value = found->value->enclosure(64).midpoint();
        RC_ASSERT(std::fabs(value - largest_dimension(carpet)) < 1e-6);
        RC_ASSERT(found->is_regular == (sizes.size() == 1));
        RC_ASSERT(found->others.has_value() == (sizes.size() > 1));
        ++compared;
        if (!found->others) return;
        ++uneven;
        const auto of = [](const DimensionFormula& formula) {
            return formula.enclosure(64).midpoint();
        };
        // Boxes of the size n^-k: k cells, then lines only; Assouad and lower by the fullest and the emptiest line.
        double all = 0, lines = 0;
        for (const auto& line : carpet.lines) {
            all += static_cast<double>(line.size());
            lines += !line.empty();
        }
        const double m = std::log(static_cast<double>(carpet.m)),
                     n = std::log(static_cast<double>(carpet.n));
        const int k = 1000;
        const double deeper = k * n / m - k;
        RC_ASSERT(std::fabs(of(found->others->box) -
                            (k * std::log(all) + deeper * std::log(lines)) / (k * n)) < 1e-9);
        const auto with = [&](std::size_t cells) {
            return std::log(lines) / m + std::log(static_cast<double>(cells)) / n;
        };
        RC_ASSERT(std::fabs(of(found->others->assouad) - with(*sizes.rbegin())) < 1e-9);
        RC_ASSERT(std::fabs(of(found->others->lower) - with(*sizes.begin())) < 1e-9);
        RC_ASSERT(of(found->others->lower) < value && value < of(found->others->box) &&
                  of(found->others->box) < of(found->others->assouad));
    }));
    CHECK(compared >= 90);
    CHECK(uneven >= 50);
    MESSAGE(compared << " carpets, " << uneven << " with uneven lines");
}

TEST_CASE("the carpets of the books, and what is no carpet") {
    // McMullen 1984: log_2(1 + 2^(log_3 2)).
    const auto text = "map 1/2 0 0 1/3 0 0\nmap 1/2 0 0 1/3 1/2 1/3\nmap 1/2 0 0 1/3 0 2/3\n";
    const auto found = functions(text).exact_dimension({});
    REQUIRE(found);
    CHECK(found->value->text() == "log (2^(log 2 / log 3) + 1) / log 2");
    CHECK(found->value->decimal(12) == "1.349683820196");
    REQUIRE(found->others);
    CHECK(found->others->box.text() == "1 + log (3/2) / log 3");
    CHECK(found->others->assouad.text() == "1 + log 2 / log 3");
    CHECK(found->others->lower.text() == "1");
    const auto dimension = [](const std::string& maps) {
        const auto exact = functions(maps).exact_dimension({});
        return exact && exact->value ? exact->value->text() : std::string("none");
    };
    // All cells, and as many cells in both lines: all dimensions are the same.
    CHECK(dimension("map 1/2 0 0 1/4 0 0\nmap 1/2 0 0 1/4 0 1/2\nmap 1/2 0 0 1/4 1/2 0\n"
                    "map 1/2 0 0 1/4 1/2 1/4\n") == "1 + log 2 / log 4 = 3/2");
    // A cell twice counts once.
    CHECK(dimension("map 1/2 0 0 1/3 0 0\nmap 1/2 0 0 1/3 0 0\n") == "log 1 / log 3 = 0");
    // Not on a grid, turned, and of different sizes.
    CHECK(dimension("map 1/2 0 0 1/3 0 0\nmap 1/2 0 0 1/3 1/2 1/3\nmap 1/2 0 0 1/3 1/3 2/3\n") ==
          "none");
    CHECK(dimension("map 1/2 0 0 1/3 0 0\nmap -1/2 0 0 1/3 1/2 1/3\n") == "none");
    CHECK(dimension("map 1/2 0 0 1/3 0 0\nmap 1/2 0 0 1/4 1/2 1/3\n") == "none");
}

TEST_CASE("exact spectra of maps with chances: binomial cascades, and what they tend to") {
    std::size_t compared = 0;
    CHECK(rc::check("binomial", [&] {
        const long share = *rc::gen::inRange<long>(1, 100);
        const Rational p(share, 100), rest = Rational(1) - p;
        const auto system = functions("map 1/2 0 0 1/2 0 0 " + to_string(p) +
                                      "\nmap 1/2 0 0 1/2 1/2 0 " + to_string(rest) + "\n");
        const std::vector<double> orders{-5, -1, 0, 0.5, 1, 2, 5};
        const auto found = system.exact_spectrum(orders, {});
        RC_ASSERT(found.has_value());
        const double a = p.to_double(), b = rest.to_double();
        for (std::size_t k = 0; k < orders.size(); ++k) {
            const double q = orders[k];
            const double known = q == 1 ? -(a * std::log2(a) + b * std::log2(b))
                                        : std::log2(std::pow(a, q) + std::pow(b, q)) / (1 - q);
            RC_ASSERT(std::fabs((*found)[k] - known) < 1e-9);
            ++compared;
        }
    }));
    CHECK(compared >= 700);
    // With the natural chances all orders are the dimension, also where ratios differ: 1/2^s + 1/3^s = 1 has s = 0.787885.
    const auto natural = functions("map 1/2 0 0 1/2 0 0 0.579190\nmap 1/3 0 0 1/3 2/3 0 0.420810\n")
                             .exact_spectrum(std::vector<double>{-3, 0, 1, 4}, {});
    REQUIRE(natural);
    for (const double value : *natural) CHECK(value == doctest::Approx(0.787885).epsilon(1e-4));
    const std::vector<double> zero{0};
    CHECK(!functions(gasket).exact_spectrum(zero, {}));  // no chances
    CHECK(!functions(fern).exact_spectrum(zero, {}));    // no similarities
    CHECK(!functions("map 1/2 0 0 1/2 0 0 0.5\nmap 1/2 0 0 1/2 0 0 0.5\n")
               .exact_spectrum(zero, {}));  // parts coincide
}

TEST_CASE(
    "maps of one linear map after turns and reflections are a set of a lattice, and tiles are "
    "known") {
    using Answer = Tile::Answer;
    const struct {
        const char *name, *text, *area;
        std::size_t neighbours;
        Answer disk_like;
    } known[] = {
        {"square",
         "map 1/2 0 0 1/2 0 0\nmap 1/2 0 0 1/2 1/2 0\nmap 1/2 0 0 1/2 0 1/2\nmap 1/2 0 0 1/2 1/2 "
         "1/2\n",
         "1", 8, Answer::yes},
        {"twindragon", "map 1/2 -1/2 1/2 1/2 0 0\nmap 1/2 -1/2 1/2 1/2 1/2 1/2\n", "1", 6,
         Answer::yes},
        {"twindragon as similarities", "similarity sqrt(1/2) 45 5 7\nsimilarity sqrt(1/2) 45 6 7\n",
         "2", 6, Answer::yes},
        {"dragon of Heighway", "similarity sqrt(1/2) 45 0 0\nsimilarity sqrt(1/2) 135 1 0\n", "1/2",
         11, Answer::no},
        {"triangle",
         "map 1/2 0 0 1/2 0 0\nmap 1/2 0 0 1/2 1/2 0\nmap 1/2 0 0 1/2 1/4 sqrt(3)/4\nmap -1/2 0 0 "
         "-1/2 3/4 sqrt(3)/4\n",
         "sqrt(3)/4", 12, Answer::yes},
        // Twelve neighbours: Bandt and Wang.
        {"not a disc",
         "map 1/2 0 0 1/2 0 0\nmap 1/2 0 0 1/2 1/2 0\nmap 1/2 0 0 1/2 0 1/2\nmap 1/2 0 0 1/2 -1/2 "
         "-1/2\n",
         "1", 12, Answer::no},
        {"oblong in cells of a carpet",
         "map 1/2 0 0 1/3 0 0\nmap 1/2 0 0 1/3 1/2 0\n"
         "map 1/2 0 0 1/3 0 1/3\nmap 1/2 0 0 1/3 1/2 1/3\nmap 1/2 0 0 1/3 0 2/3\n"
         "map 1/2 0 0 1/3 1/2 2/3\n",
         "1", 8, Answer::yes},
        {"halves of a right triangle", "map 1/2 1/2 1/2 -1/2 0 0\nmap -1/2 1/2 -1/2 -1/2 1 1\n",
         nullptr, 0, Answer::yes},
        {"two states",
         "state A\nmap 1/2 0 0 1/2 0 0 -> B\nmap 1/2 0 0 1/2 1/2 0 -> B\nmap 1/2 0 0 1/2 0 1/2 -> "
         "A\nmap 1/2 0 0 1/2 1/2 1/2 -> A\nstate B\nmap 1/2 0 0 1/2 0 0 -> A\nmap 1/2 0 0 1/2 1/2 "
         "0 "
         "-> A\nmap 1/2 0 0 1/2 0 1/2 -> A\nmap 1/2 0 0 1/2 1/2 1/2 -> B\n",
         "1", 8, Answer::yes},
    };
    for (const auto& one : known) {
        CAPTURE(one.name);
        const Tile found = tile(lattice_set(functions(one.text)));
        CHECK(found.is_tile.answer == Answer::yes);
        CHECK(found.connected.answer == Answer::yes);
        CHECK(found.disk_like.answer == one.disk_like);
        if (!one.area) continue;
        REQUIRE(found.area_square);
        CHECK(square_root_text(*found.area_square) == one.area);
        CHECK(found.most_neighbours == one.neighbours);
    }
    CHECK(tile(lattice_set(functions(gasket))).cells == Rational(0));
}

TEST_CASE("maps that lead to no lattice say why") {
    const auto reason = [](const std::string& text) {
        try {
            lattice_set(functions(text));
        } catch (const Error& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    CHECK(reason("map 0.5 0 0 0.5 0 0\nmap 0.4 0 0 0.4 1 0\nmap 0.5 0 0 0.5 0 1\n") ==
          "maps differ by more than turns and reflections of a finite group");
    CHECK(reason("map 1/2 0 0 1/2 0 0\nmap 1/2 0 0 1/2 1 0\n") == "all parts lie on a line");
    CHECK(reason("map 1/2 0 0 1/2 0 0\nmap 1/2 0 0 1/2 1 0\nmap 1/2 0 0 1/2 sqrt(2) 1\n"
                 "map 1/2 0 0 1/2 0 sqrt(2)\n") == "positions lie in no lattice of the plane");
    CHECK(reason(fern) == "map 1 (line 1) makes a line or a point of the plane");
    CHECK(reason("map exp(-1) 0 0 1/2 0 0\nmap 1/2 0 0 1/2 1 0\n") ==
          "map 1 (line 1) has a number that is not known exactly");
}
