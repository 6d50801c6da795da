#pragma once
// A turtle in the plane that does one letter after the other, in long double, and beside it counts
// its steps by direction, which is its place as a polynomial in a root of unity.

#include <complex>
#include <cstdint>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "model/model.hpp"

#include "system/system.hpp"

namespace algae::oracle {

using Real = long double;
using Spot = std::complex<Real>;
/// The coefficients of 1, x, x^2, ...
using Polynomial = std::vector<long>;

struct Fraction {
    long numerator = 0;
    long denominator = 1;
    Real value() const { return static_cast<Real>(numerator) / static_cast<Real>(denominator); }
};

/// What a file says of its turtle; degrees and lengths as fractions.
struct TurtleSettings {
    Fraction angle{90, 1};
    Fraction x, y, heading, spin;
    Fraction step{1, 1}, shrink{1, 1};
    bool clockwise = false;
    std::optional<Fraction> scale, narrow;
};
std::ostream& operator<<(std::ostream& out, const TurtleSettings& settings);

/// The same for the library.
algae::Drawing settings_of(const TurtleSettings& settings);

struct Stroke {
    Spot from, to;
    Real width = 1;
    unsigned colour = 0;
};

/// Everything a word draws.
struct Drawing {
    std::vector<Stroke> strokes;
    std::vector<std::vector<Spot>> polygons;
    std::vector<Polynomial> touched;  // both ends of every stroke, in steps over a root of unity
    std::vector<Spot> points;         // the same places and the corners of polygons
    Spot end;
    Polynomial exact_end;  // without start, step and shrink; of the order below
    long order = 1;
};

/// The drawing of a word of generation n. Brackets and braces must match.
Drawing drawing_of(const std::string& word, const TurtleSettings& settings, unsigned n);

/// The m-th cyclotomic polynomial: x^m - 1 divided by those of all proper divisors of m.
Polynomial cyclotomic_polynomial(long m);

/// Twice the real part of p at exp(2 pi i / m), if that is a rational number (then an integer):
/// p(x) + p(1/x) leaves a constant when divided by the m-th cyclotomic polynomial.
std::optional<long> twice_real_part(const Polynomial& p, long m);
/// The same for the imaginary part; m must be a multiple of 4.
std::optional<long> twice_imaginary_part(const Polynomial& p, long m);

/// The distance of a point from a stroke.
Real distance(Spot point, Spot from, Spot to);

}  // namespace algae::oracle
