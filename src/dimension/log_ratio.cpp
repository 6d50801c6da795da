#include "dimension/log_ratio.hpp"

#include <cmath>

#include "base/error.hpp"
#include "dimension/algebraic_integer.hpp"
#include "growth/complex_ball.hpp"
#include "growth/radicals.hpp"

namespace algae {

namespace {

constexpr long largest_degree = 12;  // of mu, for |mu|^2 to be written as a root

/// The monic polynomial whose roots are the products of two roots.
Polynomial products_of_roots(const Polynomial& polynomial) {
    const IntegerMatrix one = companion(polynomial);
    const std::size_t n = one.rows();
    IntegerMatrix product(n * n, n * n);
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < n; ++j)
            for (std::size_t k = 0; k < n; ++k)
                for (std::size_t l = 0; l < n; ++l)
                    product(i * n + k, j * n + l) = one(i, j) * one(k, l);
    return characteristic_polynomial(product);
}

ComplexBall root_near(const Polynomial& polynomial, std::complex<double> near, long bits) {
    std::optional<ComplexBall> best;
    double distance = INFINITY;
    for (const Root& root : roots(polynomial, bits)) {
        const double d =
            std::abs(std::complex<double>(root.real.midpoint(), root.imaginary.midpoint()) - near);
        if (d >= distance) continue;
        distance = d;
        best = ComplexBall{root.real, root.imaginary};
    }
    return *best;
}

/// r and k where the polynomial is x^k - r with r > 0.
std::optional<std::pair<Integer, long>> pure_power(const Polynomial& polynomial) {
    for (long i = 1; i < polynomial.degree(); ++i)
        if (!polynomial.coefficient(static_cast<std::size_t>(i)).is_zero()) return std::nullopt;
    const Integer number = -polynomial.coefficient(0);
    if (polynomial.degree() < 1 || polynomial.leading_coefficient() != 1 || number < 1)
        return std::nullopt;
    return std::pair(number, polynomial.degree());
}

QuadraticNumber negated(const QuadraticNumber& number) {
    return {-number.rational, -number.factor, number.radicand};
}

/// The root of an irreducible polynomial of degree 2 that lies near a real number.
QuadraticNumber quadratic_near(const Polynomial& polynomial, double near) {
    const QuadraticNumber larger = larger_root(polynomial);
    const double middle = -polynomial.coefficient(1).to_double() / 2;
    return near >= middle ? larger : larger.conjugate();
}

std::string short_decimal(const Ball& value) {
    return significant_decimal([&](long) { return value; }, 6);
}

/// In brackets where a logarithm of it would be read otherwise.
std::string bracketed(const std::string& number) {
    long depth = 0;
    for (const char c : number) {
        if (c == '(') ++depth;
        if (c == ')') --depth;
        if (depth == 0 && (c == '+' || c == '-' || c == '/' || c == 'x' || c == 'i'))
            return "(" + number + ")";
    }
    return number;
}

}  // namespace

ScalingRatio::ScalingRatio(const Integer& value)
    : factor_({-value, Integer(1)}), near_(value.to_double()), square_(value * value) {}

ScalingRatio ScalingRatio::square_root(const Integer& square) {
    const Integer root(static_cast<long>(std::llround(std::sqrt(square.to_double()))));
    ScalingRatio found(root);
    if (root * root == square) return found;
    found.factor_ = Polynomial({-square, Integer(0), Integer(1)});
    found.near_ = std::sqrt(square.to_double());
    found.square_ = AlgebraicInteger(square);
    return found;
}

ScalingRatio::ScalingRatio(const Displacement& displacement)
    : factor_(displacement.factor_polynomial()), near_(displacement.factor()) {
    if (factor_.degree() > largest_degree) return;
    std::vector<Polynomial> factors;
    for (const auto& [factor, exponent] : factorise(products_of_roots(factor_)).powers)
        factors.push_back(factor);
    square_ = AlgebraicInteger(factors, [&](long bits) {
        const Ball size = enclosure(bits);
        return size * size;
    });
}

std::optional<Integer> ScalingRatio::integer_square() const {
    return square_ ? square_->integer() : std::nullopt;
}

Ball ScalingRatio::enclosure(long bits) const {
    const ComplexBall root = root_near(factor_, near_, bits + 16);
    return sqrt(root.real * root.real + root.imaginary * root.imaginary);
}

std::string ScalingRatio::text() const {
    const double size = std::abs(near_);
    if (const auto square = integer_square()) {
        const Integer root(static_cast<long>(std::llround(size)));
        return root * root == *square ? to_string(root) : "sqrt " + to_string(*square);
    }
    if (factor_.degree() == 2 && std::abs(near_.imag()) < 1e-9)
        return to_string(near_.real() > 0 ? quadratic_near(factor_, size)
                                          : negated(quadratic_near(factor_, -size)));
    if (const auto power = square_ ? pure_power(square_->minimal_polynomial()) : std::nullopt)
        return to_string(power->first) + "^(1/" + std::to_string(2 * power->second) + ")";
    if (square_ && square_->minimal_polynomial().degree() == 2)
        return "sqrt(" + to_string(quadratic_near(square_->minimal_polynomial(), size * size)) +
               ")";
    const std::string near = short_decimal(enclosure(128));
    if (!square_) return near;
    return near + ", the square root of a root of " + to_string(square_->minimal_polynomial());
}

std::optional<Rational> LogRatio::rational() const {
    if (rate_ == Rate(1)) return Rational(0);
    const auto& square = ratio_.square();
    if (!square) return std::nullopt;
    const AlgebraicInteger rate({rate_.minimal_polynomial()},
                                [&](long bits) { return rate_.enclosure(bits); });
    const auto half = exponent_between(rate, *square);
    if (!half) return std::nullopt;
    return *half * Rational(2);
}

Ball LogRatio::enclosure(long bits) const {
    return log(rate_.enclosure(bits + 16)) / log(ratio_.enclosure(bits + 16));
}

std::string LogRatio::text() const {
    std::string text = "log " + bracketed(rate_.exact()) + " / log " + bracketed(ratio_.text());
    if (const auto value = rational()) text += " = " + to_string(*value);
    return text;
}

std::string LogRatio::decimal(int digits) const {
    if (const auto value = rational()) return algae::decimal(*value, digits);
    return algae::decimal([&](long bits) { return enclosure(bits); }, digits);
}

}  // namespace algae
