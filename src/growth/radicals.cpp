#include "growth/radicals.hpp"

namespace algae {

namespace {

/// value == square^2 * rest: divides by the squares of numbers up to 100,000, which leaves a larger
/// square only under the root of a number beyond 10^10.
std::pair<Integer, Integer> without_squares(Integer rest) {
    Integer square = 1;
    for (std::uint64_t d = 2; d < 100'000 && Integer(d) * d <= abs(rest); ++d)
        while (remainder(rest, Integer(d) * d).is_zero()) {
            rest = exact_divide(rest, Integer(d) * d);
            square *= d;
        }
    return {square, rest};
}

/// "3*sqrt(5)", "sqrt(5)", "i*sqrt(3)", "2*i", for a positive factor.
std::string root_text(const Integer& factor, const Integer& radicand) {
    std::string text = factor == 1 ? "" : to_string(factor) + "*";
    if (radicand == -1) return text + "i";
    if (sign(radicand) < 0) text += "i*";
    return text + "sqrt(" + to_string(abs(radicand)) + ")";
}

}  // namespace

QuadraticNumber larger_root(const Polynomial& irreducible) {
    const Integer a = irreducible.coefficient(2), b = irreducible.coefficient(1), c = irreducible.coefficient(0);
    const auto [square, rest] = without_squares(b * b - 4 * a * c);
    return {Rational(-b, 2 * a), Rational(square, 2 * a), rest};
}

QuadraticNumber combination(const Rational& first, const Rational& second, const QuadraticNumber& number) {
    return {first + second * number.rational, second * number.factor, number.radicand};
}

std::string to_string(const QuadraticNumber& number) {
    if (number.factor.is_zero()) return to_string(number.rational);
    const Integer below = lcm(number.rational.denominator(), number.factor.denominator());
    const Integer rational = (number.rational * Rational(below)).numerator();
    const Integer factor = (number.factor * Rational(below)).numerator();
    const bool minus = sign(factor) < 0;
    std::string text = root_text(abs(factor), number.radicand);
    if (rational.is_zero()) {
        if (minus) text = "-" + text;
    } else {
        text = to_string(rational) + (minus ? "-" : "+") + text;
        if (below != 1) text = "(" + text + ")";
    }
    return below == 1 ? text : text + "/" + to_string(below);
}

}  // namespace algae
