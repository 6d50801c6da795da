#pragma once
// Figures to measure, and whether what was measured holds a known dimension.

#include <doctest/doctest.h>

#include <cmath>
#include <memory>

#include "dimension/detail/measures.hpp"
#include "dimension/dimension.hpp"
#include "model/model.hpp"
#include "notation/notation.hpp"
#include "turtle/turtle.hpp"

namespace algae {

inline std::unique_ptr<Figure> drawn(const char* text, std::uint64_t n) {
    return figure(read_lsystem(text, "test"), n, Budget());
}

/// That the interval holds the dimension, but for rounding, and the value is so near to it.
inline void check_holds(const Scaling& scaling, double dimension, double within) {
    CAPTURE(scaling.because);
    CAPTURE(dimension);
    REQUIRE(scaling.estimate);
    CAPTURE(scaling.estimate->value);
    CHECK(scaling.estimate->low <= dimension + 1e-9);
    CHECK(scaling.estimate->high >= dimension - 1e-9);
    CHECK(std::abs(scaling.estimate->value - dimension) < within);
}

}  // namespace algae
