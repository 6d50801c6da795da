#include <numeric>

#include "dimension/dimension.hpp"

// The field Q(zeta_m), as integers of Z[zeta_m] over a common denominator.
//
// The square root of a prime p lies in Q(zeta_p) or, times i, in it: Gauss's sum of the Legendre
// symbols (k/p) zeta_p^k is sqrt p where p = 1 modulo 4, and i sqrt p where p = 3 modulo 4; sqrt 2
// is zeta_8 + 1/zeta_8. So every square root of a rational number lies in a cyclotomic field, and
// with the sines of rational degrees all numbers that people write down for maps of the plane.

namespace algae {

namespace {

using Kind = Expression::Kind;

/// A square root of the rational number, as root * sqrt(primes...) over a denominator.
struct RootParts {
    Rational factor = 1;
    std::vector<long> primes;
};

std::optional<RootParts> root_parts(const Rational& value) {
    RootParts found;
    Integer rest = value.numerator() * value.denominator();
    found.factor = Rational(Integer(1), value.denominator());
    for (long p = 2; p <= CyclotomicRing::largest_order && Integer(p) * Integer(p) <= rest; ++p) {
        bool odd = false;
        while (remainder(rest, Integer(p)).is_zero()) {
            rest = exact_divide(rest, Integer(p));
            if (odd) found.factor *= Rational(p);
            odd = !odd;
        }
        if (odd) found.primes.push_back(p);
    }
    if (Integer(CyclotomicRing::largest_order) < rest) return std::nullopt;
    if (rest != 1) found.primes.push_back(static_cast<long>(rest.to_int64()));
    return found;
}

/// The power of p modulo q.
long power_modulo(long base, long exponent, long modulus) {
    long result = 1;
    for (base %= modulus; exponent > 0; exponent /= 2, base = base * base % modulus)
        if (exponent % 2 == 1) result = result * base % modulus;
    return result;
}

/// The order of the root of unity that e^(i degrees) is.
std::optional<long> order_of(const Rational& degrees) {
    const Integer below = (degrees / Rational(360)).denominator();
    if (Integer(CyclotomicRing::largest_order) < below) return std::nullopt;
    return static_cast<long>(below.to_int64());
}

bool is_angle_function(const Expression& call) {
    return call.kind == Kind::call && call.operands.size() == 1 &&
           (call.name == "sin" || call.name == "cos" || call.name == "tan");
}

/// What stands below a square root, of `sqrt(x)`, `x^0.5` and `x^(-1/2)`; and whether it is one over
/// it.
std::optional<std::pair<Rational, bool>> radicand(const Expression& expression) {
    const auto plain = [](const Expression& part) -> std::optional<Rational> {
        if (const auto value = rational_value(shortened(part))) return value;
        const auto order = cyclotomic_order({&part});  // (sqrt(3)/6)^2 is rational
        if (!order) return std::nullopt;
        const CyclotomicField field(*order);
        const auto value = field.value_of(part);
        return value ? field.as_rational(*value) : std::nullopt;
    };
    if (expression.kind == Kind::call && expression.name == "sqrt" &&
        expression.operands.size() == 1) {
        if (const auto value = plain(expression.operands[0])) return std::pair(*value, false);
    }
    if (expression.kind == Kind::binary && expression.name == "^") {
        const auto base = plain(expression.operands[0]), power = plain(expression.operands[1]);
        if (base && power && abs(*power) == Rational(1, 2))
            return std::pair(*base, *power < Rational(0));
    }
    return std::nullopt;
}

/// Makes `order` a multiple of what an expression needs; false beyond the largest order.
bool widen(long& order, const Expression& expression) {
    const auto add = [&](long other) {
        order = std::lcm(order, other);
        return order <= CyclotomicRing::largest_order;
    };
    if (const auto below = radicand(expression)) {
        const auto parts = root_parts(abs(below->first));
        if (!parts) return true;
        for (const long prime : parts->primes)
            if (!add(prime == 2 ? 8 : prime)) return false;
        return true;
    }
    if (is_angle_function(expression)) {
        const auto degrees = rational_value(shortened(expression.operands[0]));
        const auto needed = degrees ? order_of(*degrees) : std::nullopt;
        return !needed || add(*needed);
    }
    for (const Expression& part : expression.operands)
        if (!widen(order, part)) return false;
    return true;
}

}  // namespace

std::optional<long> cyclotomic_order(const std::vector<const Expression*>& constants) {
    long order = 4;
    for (const Expression* constant : constants)
        if (!widen(order, *constant)) return std::nullopt;
    return order;
}

CyclotomicNumber CyclotomicField::lowest(CyclotomicInteger above, Integer below) const {
    Integer common = below;
    for (const Integer& coefficient : above.coefficients) {
        if (common == 1) break;
        common = gcd(common, coefficient);
    }
    if (sign(below) < 0) common = sign(common) < 0 ? common : -common;
    if (common != 1) {
        for (Integer& coefficient : above.coefficients)
            coefficient = exact_divide(coefficient, common);
        below = exact_divide(below, common);
    }
    return {std::move(above), std::move(below)};
}

CyclotomicNumber CyclotomicField::rational(const Rational& value) const {
    return {ring_.integer(value.numerator()), value.denominator()};
}

CyclotomicNumber CyclotomicField::zeta(std::int64_t exponent) const {
    return {ring_.zeta(exponent), 1};
}

std::optional<CyclotomicNumber> CyclotomicField::direction(const Rational& degrees) const {
    const Rational exponent = degrees / Rational(360) * Rational(order());
    if (!exponent.is_integer()) return std::nullopt;
    const Integer turn = remainder(exponent.numerator(), Integer(order()));
    return zeta(turn.to_int64());
}

std::optional<CyclotomicNumber> CyclotomicField::square_root(const Rational& value) const {
    if (value.is_zero()) return rational(0);
    const auto parts = root_parts(abs(value));
    if (!parts) return std::nullopt;
    CyclotomicNumber found = rational(parts->factor);
    for (const long prime : parts->primes) {
        CyclotomicInteger root = ring_.zero();
        if (order() % (prime == 2 ? 8 : prime) != 0) return std::nullopt;
        if (prime == 2) {
            ring_.add(root, ring_.zeta(order() / 8));
            ring_.add(root, ring_.zeta(-order() / 8));
        } else {
            for (long k = 1; k < prime; ++k) {
                const CyclotomicInteger term = ring_.zeta(order() / prime * k);
                if (power_modulo(k, (prime - 1) / 2, prime) == 1)
                    ring_.add(root, term);
                else
                    ring_.subtract(root, term);
            }
            // Gauss's sum is i times the root.
            if (prime % 4 == 3) root = ring_.rotate(root, -order() / 4);
        }
        found = product(found, {std::move(root), 1});
    }
    return sign(value) < 0 ? product(found, zeta(order() / 4)) : found;
}

std::optional<CyclotomicNumber> CyclotomicField::value_of(const Expression& constant) const {
    if (constant.kind == Kind::number) return rational(constant.value);
    if (const auto below = radicand(constant)) {
        if (below->first < Rational(0)) return std::nullopt;
        const auto root = square_root(below->first);
        if (!root || !below->second) return root;
        return is_zero(*root) ? std::nullopt : std::optional(inverse(*root));
    }
    if (is_angle_function(constant)) {
        const auto degrees = rational_value(shortened(constant.operands[0]));
        const auto turn = degrees ? direction(*degrees) : std::nullopt;
        if (!turn) return std::nullopt;
        const CyclotomicNumber half = rational(Rational(1, 2));
        const CyclotomicNumber cosine = product(half, sum(*turn, conjugate(*turn)));
        const CyclotomicNumber sine =
            product(product(half, zeta(-order() / 4)), difference(*turn, conjugate(*turn)));
        if (constant.name == "cos") return cosine;
        if (constant.name == "sin") return sine;
        return is_zero(cosine) ? std::nullopt : std::optional(product(sine, inverse(cosine)));
    }
    std::vector<CyclotomicNumber> parts;
    for (const Expression& part : constant.operands) {
        const auto value = value_of(part);
        if (!value) return std::nullopt;
        parts.push_back(*value);
    }
    if (constant.kind == Kind::unary && constant.name == "-")
        return difference(rational(0), parts[0]);
    if (constant.kind != Kind::binary) return std::nullopt;
    if (constant.name == "+") return sum(parts[0], parts[1]);
    if (constant.name == "-") return difference(parts[0], parts[1]);
    if (constant.name == "*") return product(parts[0], parts[1]);
    if (constant.name == "/")
        return is_zero(parts[1]) ? std::nullopt
                                 : std::optional(product(parts[0], inverse(parts[1])));
    if (constant.name == "^") {
        const auto exponent = as_rational(parts[1]);
        if (!exponent || !exponent->is_integer() || Rational(64) < abs(*exponent))
            return std::nullopt;
        const long times = static_cast<long>(abs(*exponent).numerator().to_int64());
        CyclotomicNumber found = rational(1);
        for (long k = 0; k < times; ++k) found = product(found, parts[0]);
        if (sign(*exponent) >= 0) return found;
        return is_zero(found) ? std::nullopt : std::optional(inverse(found));
    }
    return std::nullopt;
}

CyclotomicNumber CyclotomicField::sum(const CyclotomicNumber& left,
                                      const CyclotomicNumber& right) const {
    CyclotomicInteger above = left.above, other = right.above;
    if (left.below != right.below) {
        ring_.scale(above, right.below);
        ring_.scale(other, left.below);
    }
    ring_.add(above, other);
    return lowest(std::move(above),
                  left.below == right.below ? left.below : left.below * right.below);
}

CyclotomicNumber CyclotomicField::difference(const CyclotomicNumber& left,
                                             const CyclotomicNumber& right) const {
    CyclotomicNumber negative = right;
    ring_.negate(negative.above);
    return sum(left, negative);
}

CyclotomicNumber CyclotomicField::product(const CyclotomicNumber& left,
                                          const CyclotomicNumber& right) const {
    return lowest(ring_.multiply(left.above, right.above), left.below * right.below);
}

CyclotomicNumber CyclotomicField::conjugate(const CyclotomicNumber& value) const {
    return {ring_.conjugate(value.above), value.below};
}

bool CyclotomicField::is_zero(const CyclotomicNumber& value) const {
    return value.above == ring_.zero();
}

std::optional<Rational> CyclotomicField::as_rational(const CyclotomicNumber& value) const {
    const auto& coefficients = value.above.coefficients;
    for (std::size_t k = 1; k < coefficients.size(); ++k)
        if (!coefficients[k].is_zero()) return std::nullopt;
    return Rational(coefficients.front(), value.below);
}

// Where |value|^2 is rational, the inverse is the conjugate over it; otherwise multiplication by the
// number is a matrix over the integers, in whose inverse the coordinates stand.
CyclotomicNumber CyclotomicField::inverse(const CyclotomicNumber& value) const {
    if (is_zero(value)) throw Error("0 has no inverse");
    const CyclotomicNumber other = conjugate(value);
    if (const auto square = as_rational(product(value, other)))
        return product(other, rational(Rational(1) / *square));
    IntegerMatrix times(degree(), degree());
    for (std::size_t k = 0; k < degree(); ++k) {
        const CyclotomicInteger column = ring_.rotate(value.above, static_cast<std::int64_t>(k));
        for (std::size_t i = 0; i < degree(); ++i) times(i, k) = column.coefficients[i];
    }
    const auto inverse = algae::inverse(times);
    if (!inverse) throw Error("a number of a field has no inverse");
    CyclotomicInteger above = ring_.zero();
    for (std::size_t i = 0; i < degree(); ++i) above.coefficients[i] = inverse->numerator(i, 0);
    ring_.scale(above, value.below);
    return lowest(std::move(above), inverse->denominator);
}

std::complex<double> CyclotomicField::to_complex(const CyclotomicNumber& value) const {
    return ring_.to_complex(value.above) / value.below.to_double();
}

std::weak_ordering CyclotomicField::compare(const CyclotomicNumber& left,
                                            const CyclotomicNumber& right) const {
    return ring_.real_part_sign(difference(left, right).above) <=> 0;
}

}  // namespace algae
