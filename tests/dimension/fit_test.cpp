#include "dimension/dimension.hpp"
#include "turtle/turtle.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <random>

#include "dimension/known_curves.hpp"
#include "exact/exact.hpp"
#include "model/model.hpp"
#include "notation/notation.hpp"

using namespace algae;

namespace {

/// The fit of the last generation with at most so many segments.
BoxFit measured(const KnownCurve& curve, long most) {
    const Model system = read_lsystem(curve.system, curve.name);
    std::unique_ptr<Figure> chosen;
    for (std::uint64_t n = 1; n < 64; ++n) {
        auto next = figure(system, n, Budget());
        if (next->segments() > Integer(most)) break;
        chosen = std::move(next);
    }
    const double details =
        std::max(chosen->box().breadth(), chosen->box().height()) / chosen->facts().step;
    const auto count = std::min<std::size_t>(20, 1 + static_cast<std::size_t>(std::log2(details)));
    return fit_dimension(
        box_counts(*chosen, scales_of(chosen->box(), 2, count), even_offsets(8), Budget()));
}

BoxCounts counts_of_law(double dimension, std::size_t count, double detail) {
    BoxCounts counts;
    counts.scales = {1, 2, count};
    counts.detail = detail;
    for (std::size_t k = 0; k < count; ++k)
        counts.counts.push_back({static_cast<std::uint64_t>(
            std::llround(1e6 * std::pow(2, dimension * static_cast<double>(k))))});
    return counts;
}

}  // namespace

TEST_CASE("the interval holds the known dimension of the curves in the literature") {
    int too_low = 0;
    for (const KnownCurve& curve : known_curves()) {
        CAPTURE(curve.name);
        const BoxFit fit = measured(curve, 450'000);
        CAPTURE(fit.because);
        if (!fit.estimate) {
            CHECK(fit.because.starts_with("the generation is too low"));
            ++too_low;
            continue;
        }
        CAPTURE(fit.estimate->value);
        CHECK(fit.estimate->low <= curve.dimension + 1e-9);
        CHECK(fit.estimate->high >= curve.dimension - 1e-9);
        CHECK(std::abs(fit.estimate->value - curve.dimension) < 0.3);
    }
    CHECK(too_low <= 2);
}

TEST_CASE("the interval holds the dimension of at least 95 of 100 random curves") {
    std::mt19937_64 random(20261121);
    int held = 0, measurable = 0, drawn = 0;
    double width = 0;
    while (measurable < 100) {
        const KnownCurve curve = random_curve(random);
        ++drawn;
        const BoxFit fit = measured(curve, 40'000);
        if (!fit.estimate) continue;
        ++measurable;
        width += (fit.estimate->high - fit.estimate->low) / 100;
        const bool holds = fit.estimate->low <= curve.dimension + 1e-9 &&
                           curve.dimension - 1e-9 <= fit.estimate->high;
        held += holds;
        if (!holds)
            MESSAGE(curve.name << ": " << curve.dimension << " is not in [" << fit.estimate->low
                               << ", " << fit.estimate->high << "]");
    }
    MESSAGE("held in " << held << " of " << measurable << " cases, mean width " << width << "; "
                       << drawn - measurable << " curves with too low a generation");
    CHECK(held >= 95);
    CHECK(width < 0.2);
}

TEST_CASE("counts that follow a power are measured as that power") {
    for (const double dimension : {0.5, 1.0, 1.26, 1.9, 2.0}) {
        const BoxCounts counts = counts_of_law(dimension, 12, 1.0 / 4096);
        const BoxFit fit = fit_dimension(counts);
        REQUIRE(fit.estimate);
        CHECK(std::abs(fit.estimate->value - dimension) < 1e-5);
        CHECK(fit.estimate->high - fit.estimate->low < 0.02);
        CHECK(fit.first ==
              4);  // the seven finest of those with at least four details: 2^-4 to 2^-10
        CHECK(fit.last == 10);
        CHECK(fit.slopes.size() == 11);
        for (std::size_t scale = 0; scale < 12; ++scale)
            CHECK(std::abs(fit.residual(counts, scale)) < 1e-4);
    }
}

TEST_CASE("too few scales give no estimate, and a reason") {
    const BoxFit low = fit_dimension(counts_of_law(1.5, 9, 1.0 / 128));
    CHECK(!low.estimate);
    CHECK(low.because ==
          "the generation is too low: 3 scales lie between an eighth of the whole and 4 segments, "
          "expected at least 4; "
          "draw a higher one, or more scales");
    BoxCounts points = counts_of_law(1.5, 9, 0);
    points.part = "point";
    points.parts = 20'000'000;
    const BoxFit few = fit_dimension(points);
    CHECK(!few.estimate);
    CHECK(few.because ==
          "too few points: 0 scales lie between an eighth of the whole and the cells that hold 8 "
          "points on average, "
          "expected at least 4");
    CHECK_THROWS_WITH_AS(fit_dimension(BoxCounts{}),
                         "expected counts of at least one scale, found none", Error);
}
