#include <algorithm>
#include <numeric>
#include <ostream>

#include "growth/growth.hpp"

// Rates of growth as exact algebraic numbers, and the class of a growth function.
//
// A rate is the largest root of an irreducible polynomial, in size at least as large as all its other roots (Perron
// and Frobenius), so two rates are equal exactly if their minimal polynomials are; no floating point decides. Where
// its degree allows it, a rate is written by radicals. The class is read off the components of the graph of letters:
// bounded, polynomial of a degree, or exponential. Two growth functions are equal for all n if they are equal for
// as many generations as both systems have accessible letters together.

namespace algae {

namespace {

const Polynomial variable({0, 1});

long longest_coefficient(const Polynomial& value) {
    std::uint64_t longest = 0;
    for (const Integer& x : value.coefficients()) longest = std::max(longest, bit_length(x));
    return static_cast<long>(longest);
}

/// The least multiple of 2^-bits that is not below.
Rational rounded_up(const Rational& value, long bits) {
    const Integer scale = power(Integer(2), static_cast<std::uint64_t>(bits));
    return Rational(ceiling(value * Rational(scale)), scale);
}

/// p(x^step) == value for the largest step, and p.
std::pair<Polynomial, std::size_t> deflated(const Polynomial& value) {
    std::uint64_t step = 0;
    for (std::size_t k = 1; k < value.coefficients().size(); ++k)
        if (!value.coefficients()[k].is_zero()) step = gcd(Integer(step), Integer(k)).to_uint64();
    std::vector<Integer> coefficients;
    for (std::size_t k = 0; k < value.coefficients().size(); k += step)
        coefficients.push_back(value.coefficients()[k]);
    return {Polynomial(std::move(coefficients)), step};
}

}  // namespace

std::pair<Rational, Rational> largest_root(const Polynomial& value, const Rational& above,
                                           long bits) {
    const Polynomial slope = derivative(value);
    Rational width(1, power(Integer(2), static_cast<std::uint64_t>(bits)));
    Rational x = above;
    for (long working = 64 + bits;; working *= 2) {
        const long precision = working + longest_coefficient(value) + 4 * value.degree();
        for (;;) {
            const Ball here(x, precision);
            const Ball step = value(here) / slope(here);
            if (!step.is_finite()) break;
            // Newton's point is not below the root, so neither is the upper end of its enclosure.
            const Rational next = rounded_up((here - step).upper(), working);
            const bool close = x - next <= width * Rational(1, 8);
            if (next < x) x = next;
            if (!close) continue;
            const Rational low = x - width;
            const auto side = sign(value(Ball(low, precision)));
            if (side && *side <= 0) return {low, x};
            if (side) width = width * Rational(1, 16);  // other roots may lie so near, too
            break;
        }
    }
}

Rate::Rate(const Integer& value) : minimal_({-value, 1}), above_(value) {}

Rate::Rate(Polynomial minimal_polynomial, Rational above)
    : minimal_(std::move(minimal_polynomial)), above_(std::move(above)) {}

std::optional<Integer> Rate::integer() const {
    if (degree() != 1) return std::nullopt;
    return -minimal_.coefficient(0);
}

Ball Rate::enclosure(long bits) const {
    if (const auto exactly = integer()) return Ball(*exactly, bits + 64);
    const long precision = bits + 64 + longest_coefficient(minimal_);
    if (degree() == 2) {
        const Integer b = minimal_.coefficient(1), c = minimal_.coefficient(0);
        return (sqrt(Ball(b * b - 4 * c, precision)) - Ball(b, precision)) / Ball(2, precision);
    }
    const auto [low, high] = largest_root(minimal_, above_, bits + 1);
    return hull(Ball(low, precision), Ball(high, precision));
}

std::string Rate::exact() const {
    const auto [core, step] = deflated(minimal_);
    std::string text;
    if (core.degree() == 1) {
        text = to_string(-core.coefficient(0));
    } else if (core.degree() == 2) {
        text = to_string(larger_root(core));
    } else {
        return "the largest real root of " + to_string(minimal_);
    }
    if (step == 1) return text;
    if (core.degree() == 1 && step == 2) return "sqrt(" + text + ")";
    if (core.degree() == 2) text = "(" + text + ")";
    return text + "^(1/" + std::to_string(step) + ")";
}

std::string Rate::decimal(int digits) const {
    if (const auto exactly = integer()) return to_string(*exactly);
    return significant_decimal([this](long bits) { return enclosure(bits); }, digits);
}

std::strong_ordering operator<=>(const Rate& left, const Rate& right) {
    if (left == right) return std::strong_ordering::equal;
    for (long bits = 32;; bits *= 2) {
        const Order order = compare(left.enclosure(bits), right.enclosure(bits));
        if (order == Order::less) return std::strong_ordering::less;
        if (order == Order::greater) return std::strong_ordering::greater;
    }
}

Rate spectral_radius(const std::vector<Factorisation::Power>& factors, const Rational& above) {
    std::vector<Polynomial> candidates;
    Polynomial product = 1;
    for (const auto& [factor, exponent] : factors) {
        if (factor == variable) continue;
        candidates.push_back(factor);
        product *= factor;
    }
    for (long bits = 16; candidates.size() > 1; bits *= 2) {
        const auto [low, high] = largest_root(product, above, bits);
        const long precision = 2 * bits + longest_coefficient(product) + 4 * product.degree();
        const Ball root = hull(Ball(low, precision), Ball(high, precision));
        std::erase_if(candidates, [&](const Polynomial& factor) {
            return !factor(root).contains(Rational(0));
        });
    }
    return Rate(candidates.front(), above);
}

std::ostream& operator<<(std::ostream& out, const Rate& rate) { return out << rate.exact(); }

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
    const Integer a = irreducible.coefficient(2), b = irreducible.coefficient(1),
                  c = irreducible.coefficient(0);
    const auto [square, rest] = without_squares(b * b - 4 * a * c);
    return {Rational(-b, 2 * a), Rational(square, 2 * a), rest};
}

QuadraticNumber combination(const Rational& first, const Rational& second,
                            const QuadraticNumber& number) {
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

namespace {

Polynomial divided(const Polynomial& value, const Integer& divisor) {
    std::vector<Integer> coefficients;
    for (const Integer& x : value.coefficients()) coefficients.push_back(exact_divide(x, divisor));
    return Polynomial(std::move(coefficients));
}

}  // namespace

Polynomial NumberField::power(Polynomial base, std::size_t exponent) const {
    Polynomial result = reduced(1);
    for (base = reduced(base); exponent != 0; exponent >>= 1) {
        if (exponent & 1) result = multiply(result, base);
        if (exponent > 1) base = multiply(base, base);
    }
    return result;
}

AlgebraicNumber NumberField::simplified(const AlgebraicNumber& value) const {
    Polynomial numerator = reduced(value.numerator);
    Integer denominator = 1;
    const Polynomial below = reduced(value.denominator);
    if (below.degree() <= 0) {
        denominator = below.coefficient(0);
    } else {
        // The matrix of multiplication by the denominator d has a characteristic polynomial
        // x c(x) + c0 with d c(d) == -c0.
        const auto degree = static_cast<std::size_t>(modulus_.degree());
        IntegerMatrix matrix(degree, degree);
        Polynomial row = below;
        for (std::size_t i = 0; i < degree; ++i) {
            for (std::size_t j = 0; j < degree; ++j) matrix(i, j) = row.coefficient(j);
            row = multiply(row, Polynomial({0, 1}));
        }
        const Polynomial characteristic = characteristic_polynomial(matrix);
        Polynomial others;
        for (std::size_t k = degree; k >= 1; --k)
            others = multiply(others, below) + characteristic.coefficient(k);
        numerator = multiply(numerator, others);
        denominator = -characteristic.coefficient(0);
    }
    Integer divisor = gcd(content(numerator), denominator);
    if (sign(denominator) < 0) divisor.negate();
    return {divided(numerator, divisor), exact_divide(denominator, divisor)};
}

namespace {

/// The order of a component with what it reaches, given those of the components below it.
GrowthOrder order_of(const Component& component, const std::vector<GrowthOrder>& found) {
    GrowthOrder most;
    for (const std::size_t below : component.below)
        if (grows_slower(most, found[below])) most = found[below];
    if (!component.rate) return most;
    const bool exponential = *component.rate != Rate(1);
    const GrowthOrder alone{exponential ? GrowthKind::exponential : GrowthKind::bounded, 0,
                            *component.rate};
    if (most.kind == GrowthKind::zero || most.rate < alone.rate) return alone;
    if (most.rate == alone.rate) {
        ++most.degree;
        if (most.kind == GrowthKind::bounded) most.kind = GrowthKind::polynomial;
    }
    return most;
}

/// exp(2 pi i turn) * rho
ComplexBall turned(const Ball& rho, const Rational& turn, long bits) {
    return {rho * cos_pi(2 * turn, bits), rho * sin_pi(2 * turn, bits)};
}

/// The one of the polynomials, irreducible and different, that has this root.
std::size_t with_root(const std::vector<Polynomial>& polynomials, const Rate& rho,
                      const Rational& turn) {
    std::vector<std::size_t> left(polynomials.size());
    std::iota(left.begin(), left.end(), 0);
    for (long bits = 64; left.size() > 1; bits *= 2) {
        const Ball size = rho.enclosure(bits);
        const ComplexBall root = turned(size, turn, size.bits());
        std::erase_if(
            left, [&](std::size_t i) { return !value_at(polynomials[i], root).contains_zero(); });
    }
    return left.front();
}

/// How often a factor divides.
unsigned multiplicity(Polynomial value, const Polynomial& factor) {
    unsigned times = 0;
    while (const auto quotient = exact_divide(value, factor)) {
        value = *quotient;
        ++times;
    }
    return times;
}

}  // namespace

std::string to_string(GrowthKind kind) {
    switch (kind) {
        case GrowthKind::zero:
            return "zero";
        case GrowthKind::bounded:
            return "bounded";
        case GrowthKind::polynomial:
            return "polynomial";
        case GrowthKind::exponential:
            return "exponential";
    }
    return {};
}

std::string GrowthOrder::text() const {
    if (kind == GrowthKind::zero) return "0 from some n on";
    if (kind == GrowthKind::bounded) return "bounded";
    const std::string power = degree == 0 ? "" : degree == 1 ? "n" : "n^" + std::to_string(degree);
    if (kind == GrowthKind::polynomial) return power;
    const std::string base = rate.integer() ? to_string(*rate.integer()) : rate.exact();
    const bool atom =
        rate.integer() || (base.starts_with("sqrt(") && base.find(')') == base.size() - 1);
    return (degree == 0 ? "" : power + "*") + (atom ? base : "(" + base + ")") + "^n";
}

bool grows_slower(const GrowthOrder& a, const GrowthOrder& b) {
    if (a.kind != b.kind) return a.kind < b.kind;
    if (a.rate != b.rate) return a.rate < b.rate;
    return a.degree < b.degree;
}

std::vector<GrowthOrder> letter_orders(const Components& components) {
    std::vector<GrowthOrder> found;
    for (const Component& component : components.list) found.push_back(order_of(component, found));
    std::vector<GrowthOrder> letters;
    for (const std::size_t component : components.of_letter) letters.push_back(found[component]);
    return letters;
}

GrowthOrder growth_order(const D0L& system, const std::vector<GrowthOrder>& letters) {
    GrowthOrder most;
    const std::vector<Integer> counts = axiom_counts(system);
    for (std::size_t i = 0; i < counts.size(); ++i)
        if (!counts[i].is_zero() && grows_slower(most, letters[i])) most = letters[i];
    return most;
}

Integer limit_period(const Polynomial& annihilator, const GrowthOrder& order,
                     const Components& components) {
    if (order.kind == GrowthKind::zero) return 1;
    Integer period = 1;
    if (order.kind != GrowthKind::exponential) {
        for (const auto& [factor, times] : factorise(annihilator).powers)
            if (times == order.degree + 1)
                if (const auto root = cyclotomic_order(factor))
                    period = lcm(period, Integer(*root));
        return period;
    }
    // The other roots of the size of rho are rho times roots of unity (Perron and Frobenius): the
    // h-th ones for a component of rate rho and cyclicity h. Each is a root of one of its factors.
    for (const Component& component : components.list) {
        if (!component.rate || *component.rate != order.rate) continue;
        std::vector<Polynomial> factors;
        for (const auto& power : component.characteristic.powers) factors.push_back(power.factor);
        const std::uint64_t h = component.cyclicity;
        for (std::uint64_t j = 1; 2 * j <= h; ++j) {
            const std::uint64_t primitive = h / std::gcd(h, j);
            if (remainder(period, Integer(primitive)).is_zero()) continue;
            const std::size_t found = with_root(factors, order.rate, Rational(j, h));
            if (multiplicity(annihilator, factors[found]) == order.degree + 1)
                period = lcm(period, Integer(primitive));
        }
    }
    return period;
}

GrowthClass growth_class(const D0L& system, const Components& components,
                         const Recurrence& recurrence) {
    GrowthClass found;
    found.order = growth_order(system, letter_orders(components));
    if (found.order.kind == GrowthKind::zero || found.order.kind == GrowthKind::bounded)
        found.preperiod = recurrence.exceptions;
    found.period = limit_period(recurrence.polynomial, found.order, components);
    return found;
}

GrowthClass growth_class(const D0L& system, const Budget& budget) {
    return growth_class(system, components(growth_matrix(system), budget),
                        shortest_recurrence(system, budget));
}

GrowthComparison equal_growth(const D0L& left, const D0L& right, const Budget& budget) {
    const GrowthMatrix matrices[] = {growth_matrix(left), growth_matrix(right)};
    std::vector<Integer> counts[] = {axiom_counts(left), axiom_counts(right)};
    GrowthComparison found;
    found.bound = matrices[0].size() + matrices[1].size();
    for (std::uint64_t n = 0; n < found.bound; ++n) {
        budget.check();
        Integer lengths[2];
        for (int side = 0; side < 2; ++side) {
            for (const Integer& count : counts[side]) lengths[side] += count;
            counts[side] = counts[side] * matrices[side];
        }
        if (lengths[0] != lengths[1]) {
            found.difference = {n, lengths[0], lengths[1]};
            return found;
        }
    }
    found.equal = true;
    return found;
}

GrowthAnalysis growth_analysis(const D0L& system, const Budget& budget) {
    constexpr std::uint64_t shown = 11;
    GrowthMatrix matrix = growth_matrix(system);
    Components parts = components(matrix, budget);
    Recurrence recurrence = shortest_recurrence(system, budget);
    return {lengths(system, shown, budget),
            matrix,
            parts,
            matrix_polynomials(matrix, parts, budget),
            recurrence,
            generating_function(recurrence),
            ClosedForm(recurrence, budget),
            growth_class(system, parts, recurrence),
            letter_orders(parts),
            lifetimes(matrix),
            letter_frequencies(axiom_counts(system), matrix, parts, budget),
            primitivity(matrix),
            prolongations(system)};
}

}  // namespace algae
