#include "dimension/detail/measures.hpp"

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <cmath>

#include "dimension/measured.hpp"
#include "exact/exact.hpp"

using namespace algae;

namespace {

const double koch_dimension = std::log(4) / std::log(3);

/// Goes along the stroke in very small steps and counts where it has come an opening away.
double steps_by_small_steps(const Stroke& stroke, double opening) {
    double steps = 0;
    Point leg = stroke.front(), here = leg;
    for (std::size_t i = 0; i + 1 < stroke.size(); ++i)
        for (int k = 1; k <= 20'000; ++k) {
            const double share = k / 20'000.0;
            here = {stroke[i].x + share * (stroke[i + 1].x - stroke[i].x),
                    stroke[i].y + share * (stroke[i + 1].y - stroke[i].y)};
            if (std::hypot(here.x - leg.x, here.y - leg.y) >= opening) {
                leg = here;
                steps += 1;
            }
        }
    return steps + std::hypot(here.x - leg.x, here.y - leg.y) / opening;
}

}  // namespace

TEST_CASE("dividers on lines and corners take the steps that geometry gives") {
    const Budget budget;
    CHECK(divider_steps(Stroke{{0, 0}, {10, 0}}, 2, budget) == doctest::Approx(5));
    CHECK(divider_steps(Stroke{{0, 0}, {10, 0}}, 3, budget) == doctest::Approx(10.0 / 3));
    // From (3, 0) the circle of radius 5 meets the upright line at a height of 4.
    CHECK(divider_steps(Stroke{{0, 0}, {3, 0}, {3, 4}}, 5, budget) == doctest::Approx(1));
    CHECK(divider_steps(Stroke{{0, 0}, {3, 0}, {3, 9}}, 5, budget) == doctest::Approx(2));
    CHECK(divider_steps(Stroke{{0, 0}, {1, 0}, {0, 0}}, 5, budget) == 0);
    CHECK(divider_steps(Stroke{{1, 1}}, 5, budget) == 0);
    CHECK_THROWS_AS(divider_steps(Stroke{{0, 0}, {1, 0}}, 0, budget), Error);
    CHECK_THROWS_AS(divider_steps(Stroke{{1e17, 0}, {1e17 + 1024, 0}}, 1, budget), Error);
}

TEST_CASE("the Koch curve has four times the steps for a third of the opening") {
    const auto strokes = strokes_of(*drawn("axiom F; F -> F+F--F+F; angle 60", 7), Budget());
    REQUIRE(strokes.size() == 1);
    for (int k = 0; k <= 5; ++k)
        CHECK(divider_steps(strokes[0], std::pow(3, 7 - k) * (1 - 1e-12), Budget()) ==
              doctest::Approx(std::pow(4, k)));
}

TEST_CASE("steps are those found by going along the stroke a little at a time") {
    CHECK(rc::check("steps", [] {
        const auto coordinate =
            rc::gen::map(rc::gen::inRange(0, 1000), [](int k) { return k / 97.0; });
        Stroke stroke;
        for (int i = *rc::gen::inRange(2, 6); i > 0; --i)
            stroke.push_back({*coordinate, *coordinate});
        const double opening = *rc::gen::inRange(100, 400) / 101.0;
        const double slow = steps_by_small_steps(stroke, opening);
        const double steps = divider_steps(stroke, opening, Budget());
        // Where the stroke just touches the circle one of the two may miss it; else they agree.
        RC_CLASSIFY(std::abs(steps - slow) > 0.01, "touching");
        RC_ASSERT(std::abs(steps - slow) < 0.01 || std::abs(steps - slow) <= 2);
    }));
}

TEST_CASE("dividers find the dimension of curves") {
    const Scaling koch = divider(*drawn("axiom F; F -> F+F--F+F; angle 60", 9), Budget());
    REQUIRE(koch.estimate);
    CHECK(koch.estimate->low <= koch_dimension);
    CHECK(koch.estimate->high >= koch_dimension);
    CHECK(std::abs(koch.estimate->value - koch_dimension) < 0.02);
    const Scaling line = divider(*drawn("axiom F; F -> FF; angle 60", 12), Budget());
    REQUIRE(line.estimate);
    CHECK(line.estimate->value == doctest::Approx(1));
    for (const double length : line.values) CHECK(length == doctest::Approx(4096));
}

TEST_CASE("strokes less wide than the openings are left out, and said so") {
    const Scaling comb =
        divider(std::vector<Stroke>{{{0, 0}, {64, 0}}, {{3, 0}, {3, 1}}}, 0.125, Budget());
    REQUIRE(comb.estimate);
    CHECK(comb.estimate->value == doctest::Approx(1));
    CHECK(comb.because.ends_with("; 1 stroke less wide than an eighth of the widest left out"));
}

TEST_CASE("dividers refuse what has no width") {
    CHECK_THROWS_WITH_AS(divider(*drawn("axiom f; f -> ff", 3), Budget()),
                         "nothing is drawn: expected something to measure", Error);
    CHECK_THROWS_WITH_AS(
        divider(std::vector<Stroke>{{{1, 1}, {1, 1}}}, 1, Budget()),
        "expected a stroke that is wider or higher than a point, found a size of 0", Error);
    CHECK(!divider(*drawn("axiom F; F -> F+F--F+F; angle 60", 2), Budget()).estimate);
    Budget small;
    small.memory = 1000;
    CHECK_THROWS_AS(strokes_of(*drawn("axiom F; F -> F+F--F+F; angle 60", 3), small), BoundReached);
}
