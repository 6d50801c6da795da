// Certified bounds against the exact dimensions that types of parts give, which they do without here.

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

#include "dimension/detail/recurrent_set.hpp"
#include "model/model.hpp"
#include "notation/notation.hpp"

using namespace algae;

namespace {

Budget seconds(int count) {
    Budget budget;
    budget.deadline = std::chrono::steady_clock::now() + std::chrono::seconds(count);
    return budget;
}

DimensionBounds without_types(const Model& system, const char* within, std::uint64_t steps) {
    BoundsSearch search = BoundsSearch::until_within(Rational(within));
    search.steps = steps;
    return dimension_bounds(RecurrentSet(system, *as_d0l(system)), search, false, {});
}

double exactly_known(const Model& system) {
    const ExactDimension found = exact_dimension(system, seconds(60));
    REQUIRE(found.status == ExactDimension::Status::exact);
    return found.value->enclosure(64).midpoint();
}

}  // namespace

TEST_CASE("bounds without types hold the exact dimension, and come near to it") {
    struct Known {
        const char* system;
        double low, high;  // how near they come
    };
    const Known known[] = {
        {"axiom F; F -> F+F--F+F; angle 60", 1.22, 1.2619},             // Koch
        {"axiom F; F -> FfF; f -> fff", 0.6, 0.631},                    // Cantor
        {"axiom F; F -> F+F-F; angle 120", 1.3, 2},                     // terdragon
        {"axiom F; F -> FF-F-F-F-F-F+F; angle 90", 1.1, 1.5564},        // parts coincide
        {"axiom F; F -> F[+F]F[-F][F]; angle 90", 1.7, 1.99},           // twigs in one place
        {"axiom X; X -> F[+X]F[-X]+X; F -> FF; angle 20", 1.4, 1.585},  // plant
    };
    for (const auto& [text, low, high] : known) {
        INFO(text);
        const Model system = read_lsystem(text, "a.lsys");
        const DimensionBounds found = without_types(system, "0.02", 600'000'000);
        if (text != std::string(known[5].system)) {
            const double exact = exactly_known(system);
            CHECK(found.low.to_double() <= exact + 1e-8);
            CHECK(found.high.to_double() >= exact - 1e-8);
        }
        CHECK(found.low.to_double() > low);
        CHECK(found.high.to_double() < high + 1e-6);
        MESSAGE(found.low.to_double(), " to ", found.high.to_double());
    }
}

TEST_CASE("bounds of random systems hold the dimension that types of parts give") {
    int compared = 0, coincide = 0;
    CHECK(rc::check([&] {
        const auto pieces = *rc::gen::suchThat(
            rc::gen::container<std::vector<std::string>>(
                rc::gen::element<std::string>("F", "F", "+F", "-F", "[+F]", "[-F]", "[F]", "f")),
            [](const auto& list) { return list.size() >= 2 && list.size() <= 5; });
        std::string word;
        long turns = 0;
        for (const std::string& piece : pieces) {
            word += piece;
            turns += piece == "+F" ? 1 : piece == "-F" ? -1 : 0;
        }
        word += std::string(static_cast<std::size_t>(std::abs(turns)), turns > 0 ? '-' : '+');
        std::string moves;
        for (const char c : word) moves += c == 'F' ? 'f' : c;
        const Model system = read_lsystem("axiom F; F -> " + word + "; f -> " + moves + "; angle " +
                                              *rc::gen::element<std::string>("60", "90", "45"),
                                          "random.lsys");
        ExactDimension exact;
        Budget brief;
        brief.deadline = std::chrono::steady_clock::now() + std::chrono::milliseconds(300);
        try {
            exact = exact_dimension(system, brief);
        } catch (const BoundReached&) {
            return;
        }
        if (exact.status != ExactDimension::Status::exact || !exact.limit) return;
        brief.deadline = std::chrono::steady_clock::now() + std::chrono::milliseconds(300);
        const DimensionBounds found =
            dimension_bounds(RecurrentSet(system, *as_d0l(system)),
                             BoundsSearch::until_within(Rational("0.1")), false, brief);
        const double value = exact.value->enclosure(64).midpoint();
        CAPTURE(value);
        RC_ASSERT(found.low.to_double() <= value + 1e-8);
        RC_ASSERT(found.high.to_double() >= value - 1e-8);
        ++compared;
        coincide += exact.value->text() != exact.similarity->text();
    }));
    MESSAGE(compared, " compared, parts coincide in ", coincide);
    CHECK(compared > 25);
    CHECK(coincide > 1);
}

TEST_CASE("a plant whose parts meet in ever new ways is bounded below 2, and from below") {
    const Model plant =
        read_lsystem("axiom X; X -> F-[[X]+X]+F[+FX]-X; F -> FF; angle 90", "f.lsys");
    BoundsSearch search = BoundsSearch::until_within(Rational("0.01"));
    search.steps = 1'000'000'000;
    const DimensionBounds found = dimension_bounds(plant, search);
    CHECK(found.high < Rational("1.95"));
    CHECK(found.low >= Rational(1));
    CHECK(found.high_by.find("different parts") != std::string::npos);
    MESSAGE(found.low.to_double(), " to ", found.high.to_double());
}

TEST_CASE("bounds are the same whenever they are searched for, and end with their steps") {
    const Model plant =
        read_lsystem("axiom X; X -> F-[[X]+X]+F[+FX]-X; F -> FF; angle 90", "f.lsys");
    BoundsSearch search;
    search.steps = 0;
    const DimensionBounds none = dimension_bounds(plant, search);
    CHECK(none.high == Rational(2));
    search.steps = 60'000'000;
    const DimensionBounds some = dimension_bounds(plant, search),
                          again = dimension_bounds(plant, search);
    CHECK(some.low == again.low);
    CHECK(some.high == again.high);
    CHECK(some.high < none.high);
    int asked = 0;
    search.is_enough = [&](const DimensionBounds& found) {
        ++asked;
        return found.low >= Rational(1);
    };
    CHECK(dimension_bounds(plant, search).low >= Rational(1));
    CHECK(asked > 1);
}

TEST_CASE("a sum beyond the last digit is not swallowed") {
    // 1 + 2^-60 is no double: the nearest one is 1.
    const std::vector<std::vector<std::size_t>> rows{{0, 1}, {1}};
    const auto [above, below] = quotients_around(rows, {1, 0x1p-60});
    CHECK(exactly(above) >= Rational(1) + exactly(0x1p-60));
    CHECK(exactly(below) <= Rational(1));
    CHECK(above < 1 + 1e-15);
    CHECK(below > 1 - 1e-15);
    // A thousand parts that each add less than half of the last digit.
    std::vector<std::vector<std::size_t>> many(2);
    many[0].assign(1000, 1);
    many[0].insert(many[0].begin(), 0);
    many[1] = {1};
    CHECK(exactly(quotients_around(many, {1, 0x1p-54}).first) >=
          Rational(1) + Rational(1000) * exactly(0x1p-54));
}

TEST_CASE("quotients of sums are enclosed, as exact arithmetic says") {
    int inexact = 0;
    CHECK(rc::check([&] {
        const auto size = *rc::gen::inRange<std::size_t>(1, 6);
        std::vector<std::vector<std::size_t>> rows;
        std::vector<double> weights;
        for (std::size_t k = 0; k < size; ++k) {
            rows.push_back(*rc::gen::container<std::vector<std::size_t>>(
                rc::gen::inRange<std::size_t>(0, size)));
            weights.push_back(std::ldexp(1.0 + *rc::gen::inRange(0, 1 << 30) * 0x1p-30,
                                         *rc::gen::inRange(-600, 1)));
        }
        Rational largest, least;
        for (std::size_t k = 0; k < size; ++k) {
            Rational sum;
            for (const std::size_t column : rows[k]) sum += exactly(weights[column]);
            const Rational quotient = sum / exactly(weights[k]);
            if (k == 0 || largest < quotient) largest = quotient;
            if (k == 0 || quotient < least) least = quotient;
        }
        const auto [above, below] = quotients_around(rows, weights);
        RC_ASSERT(exactly(above) >= largest);
        RC_ASSERT(exactly(below) <= least);
        RC_ASSERT(largest.is_zero() || above <= largest.to_double() * (1 + 1e-12));
        inexact += exactly(largest.to_double()) == largest ? 0 : 1;
    }));
    MESSAGE(inexact, " largest quotients are no doubles");
    CHECK(inexact > 10);
}

TEST_CASE("discs hold the pieces that they are said to hold") {
    for (const char* text : {"axiom F; F -> F+F--F+F; angle 60", "axiom F; F -> F+F-F; angle 120",
                             "axiom FX; X -> X+YF+; Y -> -FX-Y; angle 90",
                             "axiom X; X -> F-[[X]+X]+F[+FX]-X; F -> FF; angle 22.5"}) {
        INFO(text);
        const Model system = read_lsystem(text, "a.lsys");
        const RecurrentSet set(system, *as_d0l(system));
        // Places in late levels of a piece, as sums over the way down.
        const auto scale = set.displacement().factor();
        for (std::size_t p = 0; p < set.size(); ++p) {
            if (set.parts(p).empty()) continue;
            for (std::size_t way = 0; way < 200; ++way) {
                std::complex<double> place = 0, unit = 1;
                std::size_t piece = p, choice = way;
                for (int level = 0; level < 40; ++level) {
                    const auto& parts = set.parts(piece);
                    const auto& part = parts[choice % parts.size()];
                    choice = choice / parts.size() + 7 * way + static_cast<std::size_t>(level);
                    unit /= scale;
                    place += unit * set.displacement().value(part.offset);
                    unit *= set.direction(part.heading);
                    piece = part.piece;
                }
                CHECK(std::abs(place - set.disc(p).centre) <= set.disc(p).radius + 1e-9);
            }
        }
    }
}

TEST_CASE("what has no lattice has the bound of its ratios") {
    const DimensionBounds curve =
        dimension_bounds(read_lsystem("axiom F; F -> F+F--F+F; angle 45.5", ""),
                         BoundsSearch::until_within(Rational("0.01")), seconds(20));
    CHECK(curve.width() < Rational("0.00001"));
    CHECK(curve.low_by == "the exact value");
    const DimensionBounds plant =
        dimension_bounds(read_lsystem("axiom F; F -> F[+F]F; angle sqrt(2)", ""),
                         BoundsSearch::until_within(Rational("0.01")), seconds(20));
    CHECK(plant.high_by == "the similarity dimension");
    CHECK(plant.high < Rational("1.5851"));
    CHECK_THROWS_AS(
        dimension_bounds(read_lsystem("axiom F; F -> F*F; scale 1/2", ""), BoundsSearch(), {}),
        Error);
}

TEST_CASE("a dust whose parts are near each other but never meet has bounds that close") {
    // The discs of the first two parts meet, those of their parts do not. No smaller cells change anything
    // then, so the search ends where they are too many, whatever is asked for.
    const Model dust = read_lsystem("axiom F; F -> FF[ffffff+F]ff; f -> ffff; angle 60", "a.lsys");
    const double exact = std::log(3) / std::log(4);
    BoundsSearch search;
    search.is_enough = [](const DimensionBounds&) { return false; };
    const DimensionBounds found =
        dimension_bounds(RecurrentSet(dust, *as_d0l(dust)), search, false, {});
    CHECK(found.low.to_double() <= exact);
    CHECK(found.high.to_double() >= exact);
    CHECK(found.width() <= Rational("0.000000002"));
}
