// Certified bounds against the exact dimensions that types of parts give, which they do without here.

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <chrono>
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

DimensionBounds without_types(const Model& system, const char* within, int time) {
    const Budget budget = seconds(time);
    return dimension_bounds(RecurrentSet(system, *as_d0l(system)), Rational(within), false, budget);
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
        {"axiom F; F -> F[+F]F[-F][F]; angle 90", 1.8, 1.99},           // twigs in one place
        {"axiom X; X -> F[+X]F[-X]+X; F -> FF; angle 20", 1.4, 1.585},  // plant
    };
    for (const auto& [text, low, high] : known) {
        INFO(text);
        const Model system = read_lsystem(text, "a.lsys");
        const DimensionBounds found = without_types(system, "0.02", 30);
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
            dimension_bounds(RecurrentSet(system, *as_d0l(system)), Rational("0.1"), false, brief);
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
    const DimensionBounds found = dimension_bounds(plant, Rational("0.01"), seconds(60));
    CHECK(found.high < Rational("1.95"));
    CHECK(found.low >= Rational(1));
    CHECK(found.high_by.find("different parts") != std::string::npos);
    MESSAGE(found.low.to_double(), " to ", found.high.to_double());
}

TEST_CASE("what has no lattice has the bound of its ratios") {
    const DimensionBounds curve = dimension_bounds(
        read_lsystem("axiom F; F -> F+F--F+F; angle 45.5", ""), Rational("0.01"), seconds(20));
    CHECK(curve.width() < Rational("0.00001"));
    CHECK(curve.low_by == "the exact value");
    const DimensionBounds plant = dimension_bounds(
        read_lsystem("axiom F; F -> F[+F]F; angle sqrt(2)", ""), Rational("0.01"), seconds(20));
    CHECK(plant.high_by == "the similarity dimension");
    CHECK(plant.high < Rational("1.5851"));
    CHECK_THROWS_AS(
        dimension_bounds(read_lsystem("axiom F; F -> F*F; scale 1/2", ""), Rational("0.01"), {}),
        Error);
}
