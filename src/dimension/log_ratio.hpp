#pragma once

#include <optional>
#include <string>

#include "dimension/algebraic_integer.hpp"
#include "dimension/displacement.hpp"
#include "exact/ball.hpp"
#include "exact/rational.hpp"
#include "growth/rate.hpp"

namespace algae {

/// The size of a scaling factor mu, exactly.
class ScalingRatio {
public:
    explicit ScalingRatio(const Displacement& displacement);
    /// A natural number.
    explicit ScalingRatio(const Integer& value);
    /// The square root of a natural number.
    static ScalingRatio square_root(const Integer& square);

    /// |mu|^2, if the degree of mu is at most 12.
    const std::optional<AlgebraicInteger>& square() const { return square_; }
    /// |mu|^2, if it is rational; it is then an integer.
    std::optional<Integer> integer_square() const;
    Ball enclosure(long bits) const;
    /// "3", "sqrt 10", "(1+sqrt(5))/2", otherwise "2.61803, the square root of a root of ...".
    std::string text() const;

private:
    Polynomial factor_;
    std::complex<double> near_;
    std::optional<AlgebraicInteger> square_;
};

/// log rate / log ratio.
class LogRatio {
public:
    LogRatio(Rate rate, ScalingRatio ratio) : rate_(std::move(rate)), ratio_(std::move(ratio)) {}

    const Rate& rate() const { return rate_; }
    const ScalingRatio& ratio() const { return ratio_; }
    /// The number itself, if it is rational, in lowest terms with numbers up to 24 for half of it
    /// (`exponent_between`).
    std::optional<Rational> rational() const;
    Ball enclosure(long bits) const;
    /// "log 4 / log 3", "log 8 / log 4 = 3/2", "log 6 / log sqrt 10", "log 6 / log ((3+sqrt(5))/2)".
    std::string text() const;
    /// Correctly rounded to so many digits after the point.
    std::string decimal(int digits) const;

private:
    Rate rate_;
    ScalingRatio ratio_;
};

}  // namespace algae
