#pragma once

#include <optional>
#include <string>

#include "exact/cyclotomic.hpp"
#include "exact/rational.hpp"

namespace algae {

/// One coordinate of a point of a figure: an algebraic number, or a double where the system does not
/// allow more. Prints correctly rounded decimals.
class Coordinate {
public:
    enum class Part { real, imaginary };

    /// offset + factor * part of `number`, exact.
    Coordinate(const CyclotomicRing& ring, CyclotomicInteger number, Part part, Rational factor,
               Rational offset);
    explicit Coordinate(double value) : value_(value) {}

    bool is_exact() const { return exact_.has_value(); }
    double value() const { return value_; }
    /// The rational number it is, if it is known to be one.
    std::optional<Rational> rational() const;
    /// Rounded to so many digits after the point.
    std::string decimal(int digits) const;
    /// An integer or a decimal of at most `digits` digits after the point, without trailing zeros.
    std::string text(int digits = 6) const;

private:
    struct Exact {
        CyclotomicRing ring;
        CyclotomicInteger number;
        Part part;
        Rational factor, offset;
    };
    std::optional<Exact> exact_;
    double value_ = 0;
};

}  // namespace algae
