#include "exact/exact.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <map>
#include <mutex>
#include <numeric>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "exact/detail/flint.hpp"
#include "exact/exact.hpp"

// The ring Z[zeta_m], exactly.
//
// An element is the vector of its coordinates in the power basis 1, zeta, ..., zeta^(phi(m)-1), which is unique, so
// equality is equality of coordinates. What is subtle:
// - The table of reduced powers is that of zeta_r only, r the radical of m, because Phi_m(x) = Phi_r(x^(m/r))
//   (Lang, Algebra, VI.3). For m = 3600 this is 30 powers instead of 3600.
// - Signs and comparisons of real and imaginary parts are exact. They try doubles with a proved error bound first, then
//   ask whether the number is 0 (an exact question on coordinates), and only then enclose it with more and more
//   bits, which must end because the number is not 0.
// - The nearest double of a part is found with twice the precision of doubles (Knuth's two_sum and fused multiplications) and
//   falls back to enclosures where the last bit is not certain.

namespace algae {

/// Both parts of a number are sums of coordinates times cosines: the coordinate of zeta^j times
/// cos(2 pi (j * step + offset) / turn), where a turn has lcm(4, m) parts.
struct CyclotomicDirection {
    std::size_t offset = 0;

    bool operator==(const CyclotomicDirection&) const = default;
};

/// Everything about one order. zeta_m to the power of s = m / r is zeta_r, r the radical of m, and
/// Phi_m(x) = Phi_r(x^s) (Lang, Algebra, VI.3): so zeta_m^(q s + t) with t < s is the reduced power
/// zeta_r^q with its terms s apart, shifted by t, and only the powers of zeta_r need a table.
struct CyclotomicRing::Context {
    /// A term of a sum of powers of zeta.
    struct Term {
        std::uint16_t index;
        std::int16_t coefficient;
    };
    /// high + low is a number to about 106 bits, high the nearest double.
    struct DoubleDouble {
        double high = 0;
        double low = 0;
    };

    explicit Context(long m);

    std::size_t order;
    std::size_t degree;
    std::uint32_t stride;             // s
    std::vector<std::size_t> starts;  // where the terms of zeta_r^q begin, q from 0 to r
    std::vector<Term> terms;
    std::size_t turn;                   // lcm(4, m)
    std::size_t step;                   // turn / m
    std::vector<DoubleDouble> cosines;  // of 2 pi j / turn

    std::size_t reduced(std::int64_t exponent) const {
        const auto m = static_cast<std::int64_t>(order);
        const std::int64_t rest = exponent % m;
        return static_cast<std::size_t>(rest < 0 ? rest + m : rest);
    }
    /// left + right modulo the order, for operands below it.
    std::size_t add_exponents(std::size_t left, std::size_t right) const {
        const std::size_t sum = left + right;
        return sum >= order ? sum - order : sum;
    }
    std::size_t opposite(std::size_t exponent) const {
        return exponent == 0 ? 0 : order - exponent;
    }

    /// Calls visit(index, coefficient) for the terms of zeta^exponent, exponent below the order.
    template <class Visit>
    void for_terms(std::size_t exponent, Visit visit) const {
        if (exponent < degree) return visit(exponent, 1);
        const std::uint32_t row = static_cast<std::uint32_t>(exponent) / stride;
        const std::uint32_t shift = static_cast<std::uint32_t>(exponent) % stride;
        for (std::size_t i = starts[row]; i < starts[row + 1]; ++i)
            visit(static_cast<std::size_t>(terms[i].index * stride + shift),
                  static_cast<int>(terms[i].coefficient));
    }
    /// sum += factor * zeta^exponent.
    void add_power(std::vector<Integer>& sum, std::size_t exponent, const Integer& factor) const {
        for_terms(exponent, [&](std::size_t index, int coefficient) {
            if (coefficient == 1)
                sum[index] += factor;
            else if (coefficient == -1)
                sum[index] -= factor;
            else
                sum[index] += factor * coefficient;
        });
    }

    static constexpr CyclotomicDirection real{};
    CyclotomicDirection imaginary() const {
        return {turn - turn / 4};
    }  // sin x = cos(x - 1/4 turn)
    CyclotomicDirection along(std::size_t exponent) const { return {opposite(exponent) * step}; }

    /// Visits (coordinate number, its cosine's number).
    template <class Visit>
    void for_cosines(CyclotomicDirection direction, Visit visit) const {
        std::size_t place = direction.offset;
        for (std::size_t j = 0; j < degree; ++j) {
            visit(j, place);
            place += step;
            if (place >= turn) place -= turn;
        }
    }

    /// Twice the part of the number in a direction, as an element of the ring, except that the
    /// imaginary part comes multiplied by i where i is not in the ring.
    std::vector<Integer> doubled(const std::vector<Integer>& value,
                                 CyclotomicDirection direction) const;
    /// The part in a direction if it is rational.
    std::optional<Rational> rational(const std::vector<Integer>& value,
                                     CyclotomicDirection direction) const;
    int sign(const std::vector<Integer>& value, CyclotomicDirection direction) const;
    template <class Coefficient>
    int sign_by_doubles(CyclotomicDirection direction, Coefficient coefficient) const;
    std::weak_ordering compare(const std::vector<Integer>& left, const std::vector<Integer>& right,
                               CyclotomicDirection direction) const;
    Ball enclosure(const std::vector<Integer>& value, CyclotomicDirection direction,
                   long bits) const;
    double nearest_double(const std::vector<Integer>& value, CyclotomicDirection direction) const;
    std::optional<double> nearest_by_pairs(std::span<const std::int64_t> value,
                                           CyclotomicDirection direction) const;
    std::string decimal(const std::vector<Integer>& value, CyclotomicDirection direction,
                        int digits, const Rational& factor) const;

    const std::vector<std::int64_t>& dense_powers() const;

private:
    mutable std::mutex mutex;
    mutable std::map<std::pair<long, std::size_t>, Ball> precise_cosines;  // by bits and number
    mutable std::once_flag dense_once;
    mutable std::vector<std::int64_t> dense;
};

namespace {

/// The product of the primes that divide the order.
long radical(long order) {
    long result = 1;
    for (long p = 2; p <= order; ++p)
        if (order % p == 0) {
            result *= p;
            while (order % p == 0) order /= p;
        }
    return result;
}

}  // namespace

CyclotomicRing::Context::Context(long m)
    : order(static_cast<std::size_t>(m)),
      turn(std::lcm(std::size_t{4}, order)),
      step(turn / order) {
    const long r = radical(m);
    stride = static_cast<std::uint32_t>(m / r);
    const Polynomial phi = cyclotomic_polynomial(r);
    const auto small_degree = static_cast<std::size_t>(phi.degree());
    degree = small_degree * stride;

    std::vector<std::int64_t> modulus;
    for (std::size_t i = 0; i < small_degree; ++i) modulus.push_back(phi.coefficient(i).to_int64());
    std::vector<std::int64_t> power(small_degree);
    power[0] = 1;
    starts.push_back(0);
    for (long q = 0; q < r; ++q) {
        for (std::size_t i = 0; i < small_degree; ++i) {
            if (power[i] == 0) continue;
            assert(std::abs(power[i]) <= INT16_MAX);  // 18 is the largest up to order 3600, at 3135
            terms.push_back({static_cast<std::uint16_t>(i), static_cast<std::int16_t>(power[i])});
        }
        starts.push_back(terms.size());
        // Times zeta: shift, and replace what leaves at the top by lower powers.
        const std::int64_t top = power.back();
        for (std::size_t i = small_degree; i-- > 1;) power[i] = power[i - 1] - top * modulus[i];
        power[0] = -top * modulus[0];
    }

    cosines.reserve(turn);
    for (std::size_t j = 0; j < turn; ++j) {
        Ball value = cos_pi(Rational(2 * j, turn), 192);
        const double high = value.midpoint();
        Ball exact_high = ball(192);
        arb_set_d(arb(exact_high), high);
        cosines.push_back({high, (value - exact_high).midpoint()});
    }
}

const std::vector<std::int64_t>& CyclotomicRing::Context::dense_powers() const {
    std::call_once(dense_once, [this] {
        dense.assign(order * degree, 0);
        for (std::size_t k = 0; k < order; ++k)
            for_terms(k, [&](std::size_t index, int coefficient) {
                dense[k * degree + index] = coefficient;
            });
    });
    return dense;
}

std::vector<Integer> CyclotomicRing::Context::doubled(const std::vector<Integer>& value,
                                                      CyclotomicDirection direction) const {
    std::vector<Integer> sum(degree);
    if (direction.offset % step == 0) {  // Re(zeta^k x) = (zeta^k x + its conjugate) / 2
        const std::size_t k = direction.offset / step;
        for (std::size_t j = 0; j < degree; ++j) {
            if (value[j].is_zero()) continue;
            const std::size_t exponent = add_exponents(j, k);
            add_power(sum, exponent, value[j]);
            add_power(sum, opposite(exponent), value[j]);
        }
    } else {  // i Im(x) = (x - its conjugate) / 2
        for (std::size_t j = 0; j < degree; ++j) {
            if (value[j].is_zero()) continue;
            add_power(sum, j, value[j]);
            add_power(sum, opposite(j), -value[j]);
        }
    }
    return sum;
}

std::optional<Rational> CyclotomicRing::Context::rational(const std::vector<Integer>& value,
                                                          CyclotomicDirection direction) const {
    const std::vector<Integer> twice = doubled(value, direction);
    const auto is_zero = [](const Integer& x) { return x.is_zero(); };
    if (!std::all_of(twice.begin() + 1, twice.end(), is_zero)) return std::nullopt;
    // Where i is not in the ring, i times a rational is in it only for 0, whose coordinates are 0.
    return Rational(twice.front(), 2);
}

// The parts of a number along a direction: signs, order, enclosures, nearest doubles, decimals.

namespace {

constexpr double unit_roundoff = 0x1p-53;

/// high + low == left + right exactly (Knuth, The Art of Computer Programming 2, 4.2.2, theorem B).
std::pair<double, double> two_sum(double left, double right) {
    const double sum = left + right;
    const double part = sum - left;
    return {sum, (left - (sum - part)) + (right - part)};
}

}  // namespace

template <class Coefficient>
int CyclotomicRing::Context::sign_by_doubles(CyclotomicDirection direction,
                                             Coefficient coefficient) const {
    // With u = 2^-53, a coefficient has a relative error of u, a cosine an absolute one of u, a
    // product and each of the sums u again: n products are off by less than (n + 8) 2u times the sum
    // of their sizes. An overflow makes every comparison false, which is "not certain".
    double sum = 0;
    double size = 0;
    for_cosines(direction, [&](std::size_t j, std::size_t place) {
        const double c = coefficient(j);
        sum += c * cosines[place].high;
        size += std::abs(c);
    });
    const double bound = size * (static_cast<double>(degree) + 8) * 2 * unit_roundoff;
    return sum > bound ? 1 : sum < -bound ? -1 : 0;
}

int CyclotomicRing::Context::sign(const std::vector<Integer>& value,
                                  CyclotomicDirection direction) const {
    if (const int found =
            sign_by_doubles(direction, [&](std::size_t j) { return value[j].to_double(); }))
        return found;
    const std::vector<Integer> twice = doubled(value, direction);
    if (std::all_of(twice.begin(), twice.end(), [](const Integer& x) { return x.is_zero(); }))
        return 0;
    for (long bits = 128;; bits *= 2)  // ends: the number is not 0
        if (const auto found = algae::sign(enclosure(value, direction, bits))) return *found;
}

std::weak_ordering CyclotomicRing::Context::compare(const std::vector<Integer>& left,
                                                    const std::vector<Integer>& right,
                                                    CyclotomicDirection direction) const {
    if (const int found = sign_by_doubles(
            direction, [&](std::size_t j) { return (left[j] - right[j]).to_double(); }))
        return found <=> 0;
    if (left == right) return std::weak_ordering::equivalent;
    std::vector<Integer> difference = left;
    for (std::size_t j = 0; j < degree; ++j) difference[j] -= right[j];
    return sign(difference, direction) <=> 0;
}

Ball CyclotomicRing::Context::enclosure(const std::vector<Integer>& value,
                                        CyclotomicDirection direction, long bits) const {
    constexpr long kept_bits = 4096;  // beyond, cosines would fill the memory
    Ball sum = ball(bits);
    const std::lock_guard lock(mutex);
    for_cosines(direction, [&](std::size_t j, std::size_t place) {
        if (value[j].is_zero()) return;
        const auto found = precise_cosines.find({bits, place});
        if (found != precise_cosines.end()) {
            arb_addmul_fmpz(arb(sum), arb(found->second), flint(value[j]), bits);
        } else {
            const Ball cosine = cos_pi(Rational(2 * place, turn), bits);
            arb_addmul_fmpz(arb(sum), arb(cosine), flint(value[j]), bits);
            if (bits <= kept_bits) precise_cosines.emplace(std::pair(bits, place), cosine);
        }
    });
    return sum;
}

std::optional<double> CyclotomicRing::Context::nearest_by_pairs(
    std::span<const std::int64_t> value, CyclotomicDirection direction) const {
    // The high parts are added without error, the low parts in double: with u = 2^-53 they are
    // below (n + 3) u times the sum of the sizes and suffer 4n roundings, so the error is below
    // (4n(n + 3) + 16) u^2 times that sum. Twice this covers its own rounding.
    constexpr std::int64_t limit = std::int64_t{1} << 62;
    DoubleDouble sum;
    double size = 0;
    bool is_small = true;
    for_cosines(direction, [&](std::size_t j, std::size_t place) {
        const std::int64_t c = value[j];
        if (c == 0) return;
        if (c > limit || c < -limit) {
            is_small = false;
            return;
        }
        const auto high = static_cast<double>(c);
        const auto low = static_cast<double>(c - static_cast<std::int64_t>(high));
        const DoubleDouble cosine = cosines[place];
        const double product = high * cosine.high;
        const double lost = std::fma(high, cosine.high, -product);
        const auto [next, error] = two_sum(sum.high, product);
        sum.high = next;
        sum.low += error + (lost + (high * cosine.low + low * cosine.high));
        size += std::abs(high);
    });
    if (!is_small) return std::nullopt;
    const auto n = static_cast<double>(degree);
    const double bound = 2 * (4 * n * (n + 3) + 16) * unit_roundoff * unit_roundoff * size;
    const auto [high, low] = two_sum(sum.high, sum.low);
    if (high + (low + bound) != high) return std::nullopt;
    if (high + (low - bound) != high) return std::nullopt;
    return high;
}

double CyclotomicRing::Context::nearest_double(const std::vector<Integer>& value,
                                               CyclotomicDirection direction) const {
    if (const auto exact = rational(value, direction)) return exact->to_double();
    for (long bits = 128;; bits *= 2)  // ends: an irrational number is no midpoint of two doubles
        if (const auto found = enclosure(value, direction, bits).unique_double()) return *found;
}

std::string CyclotomicRing::Context::decimal(const std::vector<Integer>& value,
                                             CyclotomicDirection direction, int digits,
                                             const Rational& factor) const {
    if (const auto exact = rational(value, direction))
        return algae::decimal(*exact * factor, digits);
    if (factor.is_zero()) return algae::decimal(factor, digits);
    // An irrational number is no midpoint of two decimals: some precision is enough.
    const auto enclose = [&](long bits) {
        return enclosure(value, direction, bits) * Ball(factor, bits);
    };
    return algae::decimal(enclose, digits, 1L << 28);
}

namespace {

/// Contexts cost some milliseconds to build for large orders: those in use are shared, and the last
/// few stay.
template <class Context>
class Shelf {
public:
    std::shared_ptr<const Context> find(long order) {
        const std::lock_guard lock(mutex_);
        std::shared_ptr<const Context> context = known_[order].lock();
        if (!context) {
            context = std::make_shared<const Context>(order);
            known_[order] = context;
            recent_[next_++ % recent_.size()] = context;
        }
        return context;
    }

private:
    std::mutex mutex_;
    std::map<long, std::weak_ptr<const Context>> known_;
    std::array<std::shared_ptr<const Context>, 8> recent_;
    std::size_t next_ = 0;
};

}  // namespace

CyclotomicRing::CyclotomicRing(long order) {
    if (order < 1 || order > largest_order)
        throw Error("expected a cyclotomic order from 1 to " + std::to_string(largest_order) +
                    ", found " + std::to_string(order));
    static Shelf<Context> shelf;
    context_ = shelf.find(order);
}

long CyclotomicRing::order() const { return static_cast<long>(context_->order); }
std::size_t CyclotomicRing::degree() const { return context_->degree; }

CyclotomicInteger CyclotomicRing::zero() const { return {std::vector<Integer>(degree())}; }
CyclotomicInteger CyclotomicRing::one() const { return integer(1); }

CyclotomicInteger CyclotomicRing::integer(const Integer& value) const {
    CyclotomicInteger result = zero();
    result.coefficients.front() = value;
    return result;
}

CyclotomicInteger CyclotomicRing::zeta(std::int64_t exponent) const {
    CyclotomicInteger result = zero();
    context_->add_power(result.coefficients, context_->reduced(exponent), 1);
    return result;
}

std::span<const std::int64_t> CyclotomicRing::power(std::int64_t exponent) const {
    return std::span(context_->dense_powers())
        .subspan(context_->reduced(exponent) * degree(), degree());
}

void CyclotomicRing::add(CyclotomicInteger& left, const CyclotomicInteger& right) const {
    for (std::size_t i = 0; i < left.coefficients.size(); ++i)
        left.coefficients[i] += right.coefficients[i];
}

void CyclotomicRing::subtract(CyclotomicInteger& left, const CyclotomicInteger& right) const {
    for (std::size_t i = 0; i < left.coefficients.size(); ++i)
        left.coefficients[i] -= right.coefficients[i];
}

void CyclotomicRing::negate(CyclotomicInteger& value) const {
    for (Integer& coefficient : value.coefficients) coefficient.negate();
}

void CyclotomicRing::scale(CyclotomicInteger& value, const Integer& factor) const {
    for (Integer& coefficient : value.coefficients) coefficient *= factor;
}

void CyclotomicRing::add_rotated(CyclotomicInteger& left, const CyclotomicInteger& right,
                                 std::int64_t exponent) const {
    if (&left == &right) return add_rotated(left, CyclotomicInteger(right), exponent);
    const std::size_t k = context_->reduced(exponent);
    for (std::size_t j = 0; j < context_->degree; ++j)
        if (!right.coefficients[j].is_zero())
            context_->add_power(left.coefficients, context_->add_exponents(j, k),
                                right.coefficients[j]);
}

CyclotomicInteger CyclotomicRing::rotate(const CyclotomicInteger& value,
                                         std::int64_t exponent) const {
    CyclotomicInteger result = zero();
    add_rotated(result, value, exponent);
    return result;
}

CyclotomicInteger CyclotomicRing::multiply(const CyclotomicInteger& left,
                                           const CyclotomicInteger& right) const {
    const Polynomial product = Polynomial(left.coefficients) * Polynomial(right.coefficients);
    CyclotomicInteger result = zero();
    for (std::size_t j = 0; j < product.coefficients().size(); ++j)
        if (!product.coefficients()[j].is_zero())
            context_->add_power(result.coefficients, j % context_->order,
                                product.coefficients()[j]);
    return result;
}

CyclotomicInteger CyclotomicRing::conjugate(const CyclotomicInteger& value) const {
    CyclotomicInteger result = zero();
    for (std::size_t j = 0; j < context_->degree; ++j)
        context_->add_power(result.coefficients, context_->opposite(j), value.coefficients[j]);
    return result;
}

int CyclotomicRing::real_part_sign(const CyclotomicInteger& value) const {
    return context_->sign(value.coefficients, Context::real);
}

int CyclotomicRing::imaginary_part_sign(const CyclotomicInteger& value) const {
    return context_->sign(value.coefficients, context_->imaginary());
}

std::weak_ordering CyclotomicRing::compare_real(const CyclotomicInteger& left,
                                                const CyclotomicInteger& right) const {
    return context_->compare(left.coefficients, right.coefficients, Context::real);
}

std::weak_ordering CyclotomicRing::compare_imaginary(const CyclotomicInteger& left,
                                                     const CyclotomicInteger& right) const {
    return context_->compare(left.coefficients, right.coefficients, context_->imaginary());
}

std::weak_ordering CyclotomicRing::compare_along(const CyclotomicInteger& left,
                                                 const CyclotomicInteger& right,
                                                 std::int64_t exponent) const {
    return context_->compare(left.coefficients, right.coefficients,
                             context_->along(context_->reduced(exponent)));
}

std::complex<double> CyclotomicRing::to_complex(const CyclotomicInteger& value) const {
    std::vector<std::int64_t> coordinates;
    coordinates.reserve(degree());
    for (const Integer& coefficient : value.coefficients) {
        if (!coefficient.fits_int64())
            return {context_->nearest_double(value.coefficients, Context::real),
                    context_->nearest_double(value.coefficients, context_->imaginary())};
        coordinates.push_back(coefficient.to_int64());
    }
    return to_complex(coordinates);
}

std::complex<double> CyclotomicRing::to_complex(std::span<const std::int64_t> coordinates) const {
    const auto nearest = [&](CyclotomicDirection direction) {
        if (const auto found = context_->nearest_by_pairs(coordinates, direction)) return *found;
        return context_->nearest_double({coordinates.begin(), coordinates.end()}, direction);
    };
    return {nearest(Context::real), nearest(context_->imaginary())};
}

Ball CyclotomicRing::real_part(const CyclotomicInteger& value, long bits) const {
    return context_->enclosure(value.coefficients, Context::real, bits);
}

Ball CyclotomicRing::imaginary_part(const CyclotomicInteger& value, long bits) const {
    return context_->enclosure(value.coefficients, context_->imaginary(), bits);
}

std::optional<Rational> CyclotomicRing::real_rational(const CyclotomicInteger& value) const {
    return context_->rational(value.coefficients, Context::real);
}

std::optional<Rational> CyclotomicRing::imaginary_rational(const CyclotomicInteger& value) const {
    return context_->rational(value.coefficients, context_->imaginary());
}

std::string CyclotomicRing::real_decimal(const CyclotomicInteger& value, int digits_after_point,
                                         const Rational& factor) const {
    return context_->decimal(value.coefficients, Context::real, digits_after_point, factor);
}

std::string CyclotomicRing::imaginary_decimal(const CyclotomicInteger& value,
                                              int digits_after_point,
                                              const Rational& factor) const {
    return context_->decimal(value.coefficients, context_->imaginary(), digits_after_point, factor);
}

std::size_t hash_value(const CyclotomicInteger& value) {
    std::uint64_t hash = value.coefficients.size();
    for (const Integer& coefficient : value.coefficients)
        hash = hash * 0x9e3779b97f4a7c15u + hash_value(coefficient);
    return static_cast<std::size_t>(hash);
}

}  // namespace algae
