#include "exact/exact.hpp"

#include <algorithm>
#include <ostream>

#include "exact/detail/flint.hpp"

namespace algae {

namespace {

void require_square(const IntegerMatrix& matrix) {
    if (!matrix.is_square())
        throw Error("expected a square matrix, found one of size " + std::to_string(matrix.rows()) +
                    " x " + std::to_string(matrix.columns()));
}

void require_divisor(const Polynomial& divisor) {
    if (divisor.is_zero()) throw Error("expected a divisor other than 0, found 0");
}

std::uint64_t longest_coefficient(const Polynomial& value) {
    std::uint64_t longest = 0;
    for (const Integer& x : value.coefficients()) longest = std::max(longest, bit_length(x));
    return longest;
}

/// Orders polynomials by degree, then by coefficients from the top.
bool stands_before(const Polynomial& left, const Polynomial& right) {
    if (left.degree() != right.degree()) return left.degree() < right.degree();
    return std::lexicographical_compare(left.coefficients().rbegin(), left.coefficients().rend(),
                                        right.coefficients().rbegin(), right.coefficients().rend());
}

/// Horner's rule in any ring that the integers map to.
template <class Number, class Constant>
Number horner(const Polynomial& value, const Number& x, Constant constant) {
    Number result = constant(Integer());
    for (auto c = value.coefficients().rbegin(); c != value.coefficients().rend(); ++c)
        result = std::move(result) * x + constant(*c);
    return result;
}

/// The roots of each factor, isolated from the other roots of the same factor.
std::vector<Root> enclosed_roots(const Factorisation& factors, long bits) {
    std::vector<Root> result;
    for (const auto& [factor, multiplicity] : factors.powers) {
        const slong count = factor.degree();
        acb_ptr found = _acb_vec_init(count);
        arb_fmpz_poly_complex_roots(found, PolynomialView(factor).value, 0, bits);
        for (slong i = 0; i < count; ++i) {
            Root root{ball(bits), ball(bits), multiplicity,
                      arb_is_zero(acb_imagref(found + i)) != 0};
            arb_swap(arb(root.real), acb_realref(found + i));
            arb_swap(arb(root.imaginary), acb_imagref(found + i));
            result.push_back(std::move(root));
        }
        _acb_vec_clear(found, count);
    }
    return result;
}

bool are_apart(const std::vector<Root>& roots) {
    for (std::size_t i = 0; i < roots.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            if (roots[i].real.overlaps(roots[j].real) &&
                roots[i].imaginary.overlaps(roots[j].imaginary))
                return false;
    return true;
}

}  // namespace

Polynomial::Polynomial(const Integer& constant) {
    if (!constant.is_zero()) coefficients_.push_back(constant);
}

Polynomial::Polynomial(std::vector<Integer> coefficients) : coefficients_(std::move(coefficients)) {
    drop_leading_zeros();
}

Polynomial Polynomial::monomial(const Integer& coefficient, std::size_t exponent) {
    if (coefficient.is_zero()) return {};
    std::vector<Integer> coefficients(exponent + 1);
    coefficients.back() = coefficient;
    return Polynomial(std::move(coefficients));
}

void Polynomial::drop_leading_zeros() {
    while (!coefficients_.empty() && coefficients_.back().is_zero()) coefficients_.pop_back();
}

Polynomial& Polynomial::operator+=(const Polynomial& right) {
    if (coefficients_.size() < right.coefficients_.size())
        coefficients_.resize(right.coefficients_.size());
    for (std::size_t i = 0; i < right.coefficients_.size(); ++i)
        coefficients_[i] += right.coefficients_[i];
    drop_leading_zeros();
    return *this;
}

Polynomial& Polynomial::operator-=(const Polynomial& right) {
    if (coefficients_.size() < right.coefficients_.size())
        coefficients_.resize(right.coefficients_.size());
    for (std::size_t i = 0; i < right.coefficients_.size(); ++i)
        coefficients_[i] -= right.coefficients_[i];
    drop_leading_zeros();
    return *this;
}

Polynomial& Polynomial::operator*=(const Polynomial& right) {
    const std::uint64_t bits = longest_coefficient(*this) + longest_coefficient(right);
    if (bits > Integer::largest_bit_length)
        throw BoundReached(Bound::digits,
                           "a product of polynomials would have coefficients of about " +
                               std::to_string(bits) + " binary digits, more than " +
                               std::to_string(Integer::largest_bit_length));
    FlintPolynomial product;
    fmpz_poly_mul(product.value, PolynomialView(*this).value, PolynomialView(right).value);
    return *this = product.take();
}

Polynomial operator-(Polynomial value) {
    for (Integer& coefficient : value.coefficients_) coefficient.negate();
    return value;
}

Integer Polynomial::operator()(const Integer& x) const {
    return horner(*this, x, [](const Integer& c) { return c; });
}

Rational Polynomial::operator()(const Rational& x) const {
    return horner(*this, x, [](const Integer& c) { return Rational(c); });
}

Ball Polynomial::operator()(const Ball& x) const {
    return horner(*this, x, [&](const Integer& c) { return Ball(c, x.bits()); });
}

Polynomial power(const Polynomial& base, std::uint64_t exponent) {
    // Constants and x^k apart, a power has about as many coefficients as the exponent says.
    if (base.degree() > 0 &&
        exponent > (std::uint64_t{1} << 33) / static_cast<std::uint64_t>(base.degree()))
        throw BoundReached(Bound::method, "a power of a polynomial would have a degree of " +
                                              std::to_string(base.degree()) + " times " +
                                              std::to_string(exponent) + ", more than " +
                                              std::to_string(std::uint64_t{1} << 33));
    Polynomial result = 1;
    Polynomial square = base;
    for (std::uint64_t rest = exponent; rest != 0; rest >>= 1) {
        if (rest & 1) result *= square;
        if (rest > 1) square *= square;
    }
    return result;
}

Polynomial derivative(const Polynomial& value) {
    std::vector<Integer> coefficients;
    for (std::size_t i = 1; i < value.coefficients().size(); ++i)
        coefficients.push_back(value.coefficients()[i] * i);
    return Polynomial(std::move(coefficients));
}

Polynomial reversed(const Polynomial& value) {
    return Polynomial(
        std::vector<Integer>(value.coefficients().rbegin(), value.coefficients().rend()));
}

Integer content(const Polynomial& value) {
    Integer result;
    for (const Integer& coefficient : value.coefficients()) result = gcd(result, coefficient);
    return result;
}

Polynomial primitive_part(const Polynomial& value) {
    if (value.is_zero()) return value;
    const Integer divisor =
        sign(value.leading_coefficient()) < 0 ? -content(value) : content(value);
    std::vector<Integer> coefficients;
    for (const Integer& coefficient : value.coefficients())
        coefficients.push_back(exact_divide(coefficient, divisor));
    return Polynomial(std::move(coefficients));
}

Polynomial gcd(const Polynomial& left, const Polynomial& right) {
    FlintPolynomial result;
    fmpz_poly_gcd(result.value, PolynomialView(left).value, PolynomialView(right).value);
    return result.take();
}

std::optional<Polynomial> exact_divide(const Polynomial& dividend, const Polynomial& divisor) {
    require_divisor(divisor);
    if (dividend.is_zero()) return dividend;
    FlintPolynomial quotient;
    if (fmpz_poly_divides(quotient.value, PolynomialView(dividend).value,
                          PolynomialView(divisor).value) == 0)
        return std::nullopt;
    return quotient.take();
}

Polynomial remainder(const Polynomial& dividend, const Polynomial& divisor) {
    require_divisor(divisor);
    if (abs(divisor.leading_coefficient()) != 1)
        throw Error("expected a divisor with leading coefficient 1 or -1, found " +
                    to_string(divisor));
    if (dividend.degree() < divisor.degree()) return dividend;
    FlintPolynomial quotient, rest;
    fmpz_poly_divrem(quotient.value, rest.value, PolynomialView(dividend).value,
                     PolynomialView(divisor).value);
    return rest.take();
}

bool is_squarefree(const Polynomial& value) {
    return !value.is_zero() && gcd(value, derivative(value)).degree() <= 0;
}

Factorisation factorise(const Polynomial& value) {
    if (value.is_zero()) throw Error("expected a polynomial other than 0, found 0");
    if (value.degree() == 0) return {value.leading_coefficient(), {}};
    fmpz_poly_factor_t factors;
    fmpz_poly_factor_init(factors);
    fmpz_poly_factor(factors, PolynomialView(value).value);
    Factorisation result;
    fmpz_swap(flint(result.content), &factors->c);
    for (slong i = 0; i < factors->num; ++i)
        result.powers.push_back(
            {FlintPolynomial::take(factors->p + i), static_cast<unsigned>(factors->exp[i])});
    fmpz_poly_factor_clear(factors);
    for (auto& [factor, exponent] : result.powers)
        if (sign(factor.leading_coefficient()) < 0) {
            factor = -factor;
            if (exponent % 2 == 1) result.content.negate();
        }
    std::sort(result.powers.begin(), result.powers.end(), [](const auto& left, const auto& right) {
        return stands_before(left.factor, right.factor);
    });
    return result;
}

Polynomial cyclotomic_polynomial(long order) {
    if (order < 1 || order > 1'000'000)
        throw Error("expected an order from 1 to 1000000, found " + std::to_string(order));
    FlintPolynomial result;
    fmpz_poly_cyclotomic(result.value, static_cast<ulong>(order));
    return result.take();
}

std::optional<unsigned long> cyclotomic_order(const Polynomial& value) {
    if (value.degree() < 1) return std::nullopt;
    const ulong order = fmpz_poly_is_cyclotomic(PolynomialView(value).value);
    if (order == 0) return std::nullopt;
    return order;
}

std::vector<Root> roots(const Polynomial& value, long bits) {
    if (value.is_zero()) throw Error("expected a polynomial other than 0, found 0");
    if (bits < 2 || bits > 1'000'000)
        throw Error("expected a precision of 2 to 1000000 bits, found " + std::to_string(bits));
    // Irreducible factors are squarefree, which is what isolation needs, and have no common roots:
    // the roots of different factors come apart as the precision rises.
    const Factorisation factors = factorise(value);
    std::vector<Root> result = enclosed_roots(factors, bits);
    while (!are_apart(result)) result = enclosed_roots(factors, bits *= 2);
    return result;
}

Polynomial characteristic_polynomial(const IntegerMatrix& matrix) {
    require_square(matrix);
    if (matrix.rows() == 0) return 1;
    FlintPolynomial result;
    fmpz_mat_charpoly(result.value, MatrixView(matrix).value);
    return result.take();
}

Polynomial minimal_polynomial(const IntegerMatrix& matrix) {
    require_square(matrix);
    if (matrix.rows() == 0) return 1;
    if (matrix.is_zero()) return Polynomial({0, 1});  // FLINT 2.9 would say 1
    FlintPolynomial result;
    fmpz_mat_minpoly(result.value, MatrixView(matrix).value);
    return result.take();
}

std::string to_string(const Polynomial& value, const std::string& variable) {
    if (value.is_zero()) return "0";
    std::string text;
    for (std::size_t exponent = value.coefficients().size(); exponent-- > 0;) {
        const Integer& coefficient = value.coefficients()[exponent];
        if (coefficient.is_zero()) continue;
        if (text.empty())
            text += sign(coefficient) < 0 ? "-" : "";
        else
            text += sign(coefficient) < 0 ? " - " : " + ";
        const Integer size = abs(coefficient);
        if (size != 1 || exponent == 0) text += to_string(size);
        if (exponent > 0) text += variable;
        if (exponent > 1) text += '^' + std::to_string(exponent);
    }
    return text;
}

std::ostream& operator<<(std::ostream& out, const Polynomial& value) {
    return out << to_string(value);
}

}  // namespace algae
