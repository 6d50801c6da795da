// The dimensions of what the generators make, measured, against those that are known.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "dimension/dimension.hpp"
#include "nature/detail/aggregates.hpp"
#include "nature/detail/height_field.hpp"
#include "nature/nature.hpp"

using namespace algae;

namespace {

BoxFit boxes(const Figure& figure) {
    BoxScales scales = scales_of(figure.box(), 2, 1);
    scales.count = static_cast<std::size_t>(std::log2(scales.coarsest / figure.facts().step)) + 1;
    return fit_dimension(box_counts(figure, scales, even_offsets(16), {}));
}

}  // namespace

TEST_CASE("the graph of Weierstrass's function has its box dimension 2 + log a / log b") {
    WeierstrassFunction function;
    for (const auto& [a, b] : {std::pair(0.5, 3.0), {0.7, 2.0}, {0.5, 2.5}}) {
        function.a = a;
        function.b = b;
        CAPTURE(a);
        CAPTURE(b);
        const BoxFit fit = boxes(*function.measured_figure({}).figure);
        REQUIRE(fit.estimate.has_value());
        CAPTURE(fit.estimate->value);
        CAPTURE(fit.estimate->low);
        CAPTURE(fit.estimate->high);
        // Where a b is near 1, finer scales than doubles can draw decide: the interval ends below.
        if (a * b > 1.3) {
            CHECK(fit.estimate->low <= function.dimension());
            CHECK(function.dimension() <= fit.estimate->high);
        }
        CHECK(std::abs(fit.estimate->value - function.dimension()) < 0.1);
    }
    CHECK(WeierstrassFunction().dimension() == doctest::Approx(1.369070246).epsilon(1e-9));
}

TEST_CASE("a cluster of 50,000 discs has a dimension near 1.71, by mass and radius and by boxes") {
    Aggregates cluster;
    cluster.off_lattice = true;
    const std::vector<Link>& links = cluster.links(50'000, {});
    // The mass within discs around the seed, which grows as the radius to the dimension.
    const double whole = std::hypot(links.back().to.x, links.back().to.y);
    double n = 0, x = 0, y = 0, xx = 0, xy = 0;
    for (double radius = whole / 24; radius < whole / 2; radius *= 1.25) {
        double mass = 0;
        for (const Link& link : links) mass += std::hypot(link.to.x, link.to.y) <= radius;
        const double a = std::log(radius), b = std::log(mass);
        n += 1, x += a, y += b, xx += a * a, xy += a * b;
    }
    const double by_radius = (n * xy - x * y) / (n * xx - x * x);
    CAPTURE(by_radius);
    CHECK(std::abs(by_radius - 1.71) < 0.1);
    const GeneratorFigure figure = [&] {
        cluster.particles = {50'000};
        return cluster.measured_figure({});
    }();
    const BoxFit fit = boxes(*figure.figure);
    REQUIRE(fit.estimate.has_value());
    CAPTURE(fit.estimate->value);
    CAPTURE(fit.estimate->low);
    CAPTURE(fit.estimate->high);
    // Boxes see less than the mass does at this size, as is known of small clusters.
    CHECK(fit.estimate->low <= 1.71);
    CHECK(1.71 <= fit.estimate->high);
    CHECK(std::abs(fit.estimate->value - 1.71) < 0.15);
}

TEST_CASE("coasts have the dimension 2 - H, by dividers and by boxes") {
    Terrain land;
    land.exact = true;
    land.surface = {0.8, 0.3, 9};
    land.water = 0.5;
    double by_dividers = 0, by_boxes = 0;
    const int seeds = 6;
    for (land.seed = 1; land.seed <= seeds; ++land.seed) {
        const GeneratorFigure coast = land.measured_figure({});
        by_dividers += divider(*coast.figure, {}).estimate.value().value / seeds;
        by_boxes += boxes(*coast.figure).estimate.value().value / seeds;
    }
    CAPTURE(by_dividers);
    CAPTURE(by_boxes);
    CHECK(std::abs(by_dividers - 1.2) < 0.1);
    CHECK(std::abs(by_boxes - 1.2) < 0.1);
}

TEST_CASE("the facts of a landscape") {
    Terrain land;
    land.surface = {0.7, 0.3, 5};
    land.water = 0.25;
    const HeightField heights = land.field(5, {});
    CHECK(heights.side == 33);
    nlohmann::ordered_json facts;
    for (const GeneratorFact& fact : land.facts({})) facts[fact.key] = *fact.value;
    CHECK(facts["points"] == 33);
    CHECK(facts["dimension"]["surface"] == doctest::Approx(2.3));
    CHECK(facts["dimension"]["coast"] == doctest::Approx(1.3));
    std::size_t below = 0;
    for (const double height : heights.heights) below += height < facts["heights"]["water"];
    CHECK(static_cast<double>(below) / static_cast<double>(heights.heights.size()) ==
          doctest::Approx(0.25).epsilon(0.02));
    CHECK(facts["heights"]["low"] ==
          *std::min_element(heights.heights.begin(), heights.heights.end()));
    const Scene scene = land.scene({}).value();
    CHECK(scene.faces.size() == 2 * 32 * 32);
    for (const Vector& corner : scene.corners)
        CHECK(corner.z >= facts["heights"]["water"].get<double>());
}
