#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <map>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "exact/ball.hpp"
#include "exact/cyclotomic.hpp"

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

}  // namespace algae
