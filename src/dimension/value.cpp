#include <algorithm>
#include <cmath>

#include "dimension/detail/ratio_graph.hpp"

// The numbers that exact dimensions are made of: log rate / log |mu|, its text, and comparison with
// other such numbers.
//
// Rates and scaling factors are algebraic integers, so a dimension is a quotient of two logarithms
// of algebraic integers. Such a number is rational, or equal to another one, exactly where powers
// of the integers are equal with matching exponents; that there is no other way follows from
// Schanuel's conjecture only. So the plan is:
//
// - An `AlgebraicInteger` is a minimal polynomial and the place of the number among its real roots.
//   It is found among the roots of some irreducible candidates by enclosing ever more tightly until
//   one root is left.
// - A power of it is a root of the characteristic polynomial of the power of its companion matrix.
// - `exponent_between` guesses log a / log b from doubles, with exponents up to 24, and proves it
//   by equality of powers. Values are first freed of roots: a root of p(x^k) is the k-th root of a
//   root of p (`without_root`), so that small exponents suffice.
// - Where two values are different, enclosures differ at some precision; where they agree in 200
//   digits and no equality of powers is found, the answer is `unknown`.
//
// |mu|^2 is a root of the polynomial whose roots are the products of two roots of that of mu (the
// characteristic polynomial of the Kronecker product of companion matrices): mu and its conjugate
// are roots of one real polynomial.

namespace algae {

namespace {

constexpr long first_bits = 64, most_bits = 1L << 16;
constexpr long largest_power = 400;  // degree times exponent of which powers are worked out
constexpr long largest_exponent = 24;

/// The real roots, the largest one first.
std::vector<Ball> real_roots(const Polynomial& polynomial, long bits) {
    std::vector<Ball> found;
    for (const Root& root : roots(polynomial, bits))
        if (root.is_real) found.push_back(root.real);
    std::sort(found.begin(), found.end(), [](const Ball& left, const Ball& right) {
        return compare(left, right) == Order::greater;
    });
    return found;
}

std::vector<Polynomial> irreducible_factors(const Polynomial& polynomial) {
    std::vector<Polynomial> found;
    for (const auto& [factor, exponent] : factorise(polynomial).powers)
        if (factor.degree() > 0) found.push_back(factor);
    return found;
}

bool can_be_raised(const AlgebraicInteger& base, long exponent) {
    const long degree = base.minimal_polynomial().degree();
    return degree == 1 || exponent == 1 || degree * exponent <= largest_power;
}

Ball power_of(const Ball& base, unsigned exponent) {
    Ball result(1, base.bits());
    for (unsigned i = 0; i < exponent; ++i) result *= base;
    return result;
}

}  // namespace

IntegerMatrix companion(const Polynomial& polynomial) {
    const auto degree = static_cast<std::size_t>(polynomial.degree());
    IntegerMatrix matrix(degree, degree);
    for (std::size_t i = 0; i + 1 < degree; ++i) matrix(i + 1, i) = 1;
    for (std::size_t i = 0; i < degree; ++i) matrix(i, degree - 1) = -polynomial.coefficient(i);
    return matrix;
}

AlgebraicInteger::AlgebraicInteger(const Integer& value) : minimal_({-value, Integer(1)}) {}

AlgebraicInteger::AlgebraicInteger(const std::vector<Polynomial>& candidates,
                                   const std::function<Ball(long bits)>& enclose) {
    for (long bits = first_bits; bits <= most_bits; bits *= 2) {
        const Ball number = enclose(bits);
        std::size_t found = 0;
        for (const Polynomial& candidate : candidates) {
            const std::vector<Ball> all = real_roots(candidate, bits);
            for (std::size_t above = 0; above < all.size(); ++above) {
                if (!all[above].overlaps(number)) continue;
                ++found;
                minimal_ = candidate;
                above_ = above;
            }
        }
        if (found == 1) return;
    }
    throw BoundReached(Bound::digits, "a number cannot be told from other roots of polynomials");
}

std::optional<AlgebraicInteger> AlgebraicInteger::largest_root(const Polynomial& polynomial) {
    const std::vector<Polynomial> factors = irreducible_factors(polynomial);
    for (long bits = first_bits; bits <= most_bits; bits *= 2) {
        std::optional<Ball> largest;
        const Polynomial* of = nullptr;
        bool certain = true;
        for (const Polynomial& factor : factors) {
            const std::vector<Ball> all = real_roots(factor, bits);
            if (all.empty()) continue;
            const Order order = largest ? compare(all.front(), *largest) : Order::greater;
            if (order == Order::unknown) certain = false;
            if (order != Order::greater) continue;
            largest = all.front();
            of = &factor;
        }
        if (!certain) continue;
        if (!largest || compare(*largest, Ball(0, bits)) != Order::greater) return std::nullopt;
        return AlgebraicInteger(*of, 0);
    }
    throw BoundReached(Bound::digits, "the largest root cannot be told from others");
}

std::optional<Integer> AlgebraicInteger::integer() const {
    if (minimal_.degree() != 1) return std::nullopt;
    return -minimal_.coefficient(0);
}

Ball AlgebraicInteger::enclosure(long bits) const {
    if (const auto number = integer()) return Ball(*number, bits);
    return real_roots(minimal_, bits).at(above_);
}

AlgebraicInteger power(const AlgebraicInteger& base, unsigned exponent) {
    if (const auto number = base.integer()) return AlgebraicInteger(power(*number, exponent));
    if (exponent == 1) return base;
    if (!can_be_raised(base, exponent))
        throw BoundReached(Bound::digits, "the power " + std::to_string(exponent) +
                                              " of a root of a polynomial of degree " +
                                              std::to_string(base.minimal_polynomial().degree()) +
                                              " is not worked out");
    const IntegerMatrix matrix = companion(base.minimal_polynomial());
    return AlgebraicInteger(
        irreducible_factors(characteristic_polynomial(power(matrix, exponent))),
        [&](long bits) { return power_of(base.enclosure(bits + 64), exponent); });
}

std::optional<Rational> exponent_between(const AlgebraicInteger& left,
                                         const AlgebraicInteger& right) {
    constexpr long bits = 256;
    if (right.integer() == Integer(1)) return std::nullopt;
    if (left.integer() == Integer(1)) return Rational(0);
    const Ball exponent = log(left.enclosure(bits)) / log(right.enclosure(bits));
    const double near = exponent.midpoint();
    for (long b = 1; b <= largest_exponent; ++b) {
        const double a = std::round(near * static_cast<double>(b));
        if (a < 1 || a > largest_exponent) continue;
        const Rational candidate(static_cast<long>(a), b);
        if (!exponent.contains(candidate) || !can_be_raised(left, b) ||
            !can_be_raised(right, static_cast<long>(a)))
            continue;
        if (power(left, static_cast<unsigned>(b)) == power(right, static_cast<unsigned>(a)))
            return candidate;
    }
    return std::nullopt;
}

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

/// The root of this degree of a number above 0, of as small a number as can be: 14^(1/3) for 196 and
/// 6. The polynomial x^(degree/2) - number is irreducible, of a degree above 1, so the root is neither
/// whole nor a square root.
std::string root_text(Integer number, long degree) {
    for (long part = degree; part > 1; --part) {
        if (degree % part != 0) continue;
        const double near = std::round(std::pow(number.to_double(), 1 / static_cast<double>(part)));
        if (!(near < 1e15)) continue;
        const Integer root(static_cast<long>(near));
        if (!(algae::power(root, static_cast<std::uint64_t>(part)) == number)) continue;
        number = root;
        degree /= part;
        break;
    }
    return to_string(number) + "^(1/" + std::to_string(degree) + ")";
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
    square_ = AlgebraicInteger(irreducible_factors(products_of_roots(factor_)), [&](long bits) {
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
        return root_text(power->first, 2 * power->second);
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
    // A power b of a number of degree d has at least the degree d/b, and a power of the square at most that of the square.
    if (rate_.minimal_polynomial().degree() >
        largest_exponent * square->minimal_polynomial().degree())
        return std::nullopt;
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

std::optional<Rate> quotient(const Rate& rate, const Integer& divisor) {
    const Polynomial& polynomial = rate.minimal_polynomial();
    std::vector<Integer> coefficients;
    Integer above = 1;  // no root is as large as 1 and the largest coefficient (Cauchy)
    const auto degree = static_cast<std::uint64_t>(polynomial.degree());
    for (std::uint64_t i = 0; i <= degree; ++i) {
        const Integer power = algae::power(divisor, degree - i);
        if (!remainder(polynomial.coefficient(i), power).is_zero()) return std::nullopt;
        coefficients.push_back(exact_divide(polynomial.coefficient(i), power));
        above = std::max(above, abs(coefficients.back()) + 1);
    }
    return Rate(Polynomial(std::move(coefficients)), Rational(above));
}

ExpectedRatio::ExpectedRatio(Rate rate, Integer divisor, ScalingRatio ratio)
    : rate_(std::move(rate)), divisor_(std::move(divisor)), ratio_(std::move(ratio)) {
    if (sign(divisor_) <= 0)
        throw Error("expected a number above 0 to divide by, found " + to_string(divisor_));
    if (const auto whole = rate_.integer()) {
        const Rational average(*whole, divisor_);
        rate_ = Rate(average.numerator());
        divisor_ = average.denominator();
        return;
    }
    constexpr long most = 1000;
    for (long factor = 2; factor <= most && Integer(factor) <= divisor_; ++factor)
        while (remainder(divisor_, factor).is_zero()) {
            auto smaller = quotient(rate_, factor);
            if (!smaller) break;
            rate_ = std::move(*smaller);
            divisor_ = exact_divide(divisor_, factor);
        }
}

std::string ExpectedRatio::average() const {
    if (divisor_ == Integer(1)) return rate_.exact();
    if (const auto whole = rate_.integer()) return to_string(Rational(*whole, divisor_));
    return bracketed(rate_.exact()) + "/" + to_string(divisor_);
}

std::optional<Rational> ExpectedRatio::rational() const {
    // No power of a number that is no algebraic integer is one.
    if (divisor_ != Integer(1)) return std::nullopt;
    return LogRatio(rate_, ratio_).rational();
}

Ball ExpectedRatio::enclosure(long bits) const {
    const Ball average = rate_.enclosure(bits + 16) / Ball(divisor_, bits + 16);
    return log(average) / log(ratio_.enclosure(bits + 16));
}

std::string ExpectedRatio::text() const {
    if (divisor_ == Integer(1)) return LogRatio(rate_, ratio_).text();
    return "log " + bracketed(average()) + " / log " + bracketed(ratio_.text());
}

std::string ExpectedRatio::decimal(int digits) const {
    if (const auto value = rational()) return algae::decimal(*value, digits);
    return algae::decimal([&](long bits) { return enclosure(bits); }, digits);
}

namespace {

/// A number and the k for which it is the k-th root of it, as large as can be seen from the
/// polynomial.
struct Power {
    AlgebraicInteger of;
    long root = 1;
};

/// For a root of p(x^k) the root of p.
Power without_root(const AlgebraicInteger& number) {
    const Polynomial& polynomial = number.minimal_polynomial();
    for (long k = polynomial.degree(); k > 1; --k) {
        std::vector<Integer> coefficients;
        bool fits = true;
        for (long i = 0; i <= polynomial.degree() && fits; ++i) {
            const Integer coefficient = polynomial.coefficient(static_cast<std::size_t>(i));
            if (i % k == 0)
                coefficients.push_back(coefficient);
            else
                fits = coefficient.is_zero();
        }
        if (!fits) continue;
        const auto enclose = [&](long bits) {
            return power_of(number.enclosure(bits + 64), static_cast<unsigned>(k));
        };
        return {AlgebraicInteger({Polynomial(std::move(coefficients))}, enclose), k};
    }
    return {number, 1};
}

template <class Enclose>
Order by_enclosures(const Enclose& difference) {
    constexpr long enough = digits_compared * 10 / 3 + 8;
    for (long bits = 64; bits <= 2 * enough; bits *= 2)
        if (const auto known = sign(difference(bits)))
            if (*known != 0) return *known < 0 ? Order::less : Order::greater;
    return Order::unknown;
}

}  // namespace

DimensionValue::DimensionValue(const Rational& factor, const AlgebraicInteger& over,
                               const AlgebraicInteger& under) {
    const Power above = without_root(over), below = without_root(under);
    factor_ = factor * Rational(below.root, above.root);
    over_ = above.of;
    under_ = below.of;
}

std::optional<DimensionValue> DimensionValue::of(const LogRatio& ratio) {
    if (const auto value = ratio.rational()) return DimensionValue(*value);
    const auto& square = ratio.ratio().square();
    const auto rate = AlgebraicInteger::largest_root(ratio.rate().minimal_polynomial());
    if (!square || !rate) return std::nullopt;
    return DimensionValue(Rational(2), *rate, *square);
}

std::optional<Rational> DimensionValue::rational() const {
    if (!over_) return factor_;
    const auto exponent = exponent_between(*over_, *under_);
    if (!exponent) return std::nullopt;
    return factor_ * *exponent;
}

Ball DimensionValue::enclosure(long bits) const {
    const Ball factor(factor_, bits);
    if (!over_) return factor;
    return factor * log(over_->enclosure(bits + 16)) / log(under_->enclosure(bits + 16));
}

Order compare(const DimensionValue& left, const DimensionValue& right) {
    const Order order =
        by_enclosures([&](long bits) { return left.enclosure(bits) - right.enclosure(bits); });
    if (order != Order::unknown) return order;
    const auto first = left.rational(), second = right.rational();
    if (first && second) return *first == *second ? Order::equal : Order::unknown;
    if (first || second) return Order::unknown;
    const auto above = exponent_between(*left.over_, *right.over_);
    const auto below = exponent_between(*left.under_, *right.under_);
    if (above && below && left.factor_ * *above == right.factor_ * *below) return Order::equal;
    return Order::unknown;
}

Order compare(const LogRatio& left, const DimensionValue& right) {
    if (const auto value = DimensionValue::of(left)) return compare(*value, right);
    return by_enclosures([&](long bits) { return left.enclosure(bits) - right.enclosure(bits); });
}

CarpetDimension::CarpetDimension(Kind kind, long m, long n, std::vector<long> lines)
    : kind_(kind), m_(m), n_(n), lines_(std::move(lines)) {
    const bool fit = std::all_of(lines_.begin(), lines_.end(),
                                 [&](long cells) { return cells >= 1 && cells <= n_; });
    if (m < 2 || n <= m || lines_.empty() || lines_.size() > static_cast<std::size_t>(m) || !fit)
        throw Error("expected a carpet of 2 <= m < n, and 1 to m lines of 1 to n cells");
    std::sort(lines_.begin(), lines_.end(), std::greater<>());
}

// With as many cells in all lines, all dimensions are that of boxes.
bool CarpetDimension::is_sum() const {
    return kind_ == Kind::hausdorff && lines_.front() != lines_.back();
}

Rational CarpetDimension::in_line() const {
    if (kind_ == Kind::assouad) return Rational(lines_.front());
    if (kind_ == Kind::lower) return Rational(lines_.back());
    long all = 0;
    for (const long cells : lines_) all += cells;
    return Rational(all) / Rational(static_cast<long>(lines_.size()));
}

std::optional<Rational> CarpetDimension::rational() const {
    if (is_sum()) return std::nullopt;
    const auto exponent = [](const Integer& of, long base) {
        return exponent_between(AlgebraicInteger(of), AlgebraicInteger(Integer(base)));
    };
    const auto across = exponent(Integer(static_cast<long>(lines_.size())), m_);
    const auto above = exponent(in_line().numerator(), n_);
    const auto below = exponent(in_line().denominator(), n_);
    if (!across || !above || !below) return std::nullopt;
    return *across + *above - *below;
}

Ball CarpetDimension::enclosure(long bits) const {
    const long more = bits + 32;
    const auto logarithm = [&](const Rational& of) { return log(Ball(of, more)); };
    const Ball m = logarithm(Rational(m_)), n = logarithm(Rational(n_));
    if (!is_sum())
        return logarithm(Rational(static_cast<long>(lines_.size()))) / m + logarithm(in_line()) / n;
    Ball sum(0, more);
    for (const long cells : lines_) sum += exp(logarithm(Rational(cells)) * m / n);
    return log(sum) / m;
}

std::string CarpetDimension::text() const {
    const std::string m = "log " + std::to_string(m_), n = "log " + std::to_string(n_);
    if (is_sum()) {
        std::string sum;
        for (std::size_t k = 0; k < lines_.size();) {
            std::size_t times = 0;
            const long cells = lines_[k];
            for (; k < lines_.size() && lines_[k] == cells; ++k) ++times;
            if (!sum.empty()) sum += " + ";
            if (cells == 1)
                sum += std::to_string(times);
            else
                sum += (times > 1 ? std::to_string(times) + "*" : "") + std::to_string(cells) +
                       "^(" + m + " / " + n + ")";
        }
        return "log (" + sum + ") / " + m;
    }
    std::string text;
    if (lines_.size() == static_cast<std::size_t>(m_))
        text = "1";
    else if (lines_.size() > 1)
        text = "log " + std::to_string(lines_.size()) + " / " + m;
    const Rational inner = in_line();
    if (inner != Rational(1) || text.empty())
        text += (text.empty() ? "log " : " + log ") + bracketed(to_string(inner)) + " / " + n;
    const auto value = rational();
    const std::string known = value ? to_string(*value) : "";
    return value && known != text ? text + " = " + known : text;
}

std::string CarpetDimension::decimal(int digits) const {
    if (const auto value = rational()) return algae::decimal(*value, digits);
    return algae::decimal([&](long bits) { return enclosure(bits); }, digits);
}

std::optional<Rational> DimensionFormula::rational() const {
    return std::visit(
        [](const auto& formula) -> std::optional<Rational> {
            if constexpr (requires { formula.rational(); }) return formula.rational();
            return std::nullopt;
        },
        formula_);
}

Ball DimensionFormula::enclosure(long bits) const {
    return std::visit([&](const auto& formula) { return formula.enclosure(bits); }, formula_);
}

std::string DimensionFormula::text() const {
    return std::visit([](const auto& formula) { return formula.text(); }, formula_);
}

std::string DimensionFormula::decimal(int digits) const {
    return std::visit([&](const auto& formula) { return formula.decimal(digits); }, formula_);
}

}  // namespace algae
