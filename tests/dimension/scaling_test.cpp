#include "dimension/detail/measures.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "exact/exact.hpp"

using namespace algae;

namespace {

Scaling of_law(double dimension, std::size_t count) {
    Scaling scaling;
    scaling.sizes = halved_sizes(1, 0, count);
    scaling.values = scaling.sizes;
    std::vector<double> powers;
    for (const double size : scaling.sizes) powers.push_back(dimension * std::log(size));
    fit_scaling(scaling, powers, ScaleRange{1.0 / 1024, 1.0 / 8}, {1, 1, 0}, 3);
    return scaling;
}

}  // namespace

TEST_CASE("a power law gives its exponent, of the seven finest scales in the range") {
    const Scaling scaling = of_law(1.5, 14);
    REQUIRE(scaling.estimate);
    CHECK(scaling.estimate->value == doctest::Approx(1.5));
    CHECK(scaling.estimate->low == doctest::Approx(1.5));
    CHECK(scaling.estimate->high == doctest::Approx(1.5));
    CHECK(scaling.first == 4);
    CHECK(scaling.last == 10);
    CHECK(scaling.because.starts_with("scales from 0.0625 down to 0.000977: coarser ones see"));
}

TEST_CASE("too few scales give no estimate, and none at all are refused") {
    const Scaling scaling = of_law(1.5, 5);
    CHECK(!scaling.estimate);
    CHECK(scaling.because ==
          "too little to measure: 2 of the scales lie between an eighth of the whole and 4 "
          "segments, expected at least 4");
    Scaling empty;
    CHECK_THROWS_WITH_AS(fit_scaling(empty, {}, {}, {}, 2),
                         "expected one value for each of at least one scale, found 0 for 0", Error);
}
