#pragma once

#include <complex>
#include <cstdint>
#include <optional>
#include <vector>

#include "exact/rational.hpp"
#include "system/settings.hpp"

namespace algae {

/// The directions a turtle of one generation can look: multiples of a full turn divided by `order`.
/// A heading is a number of such units, counter-clockwise from +x, taken modulo the order.
///
/// Where angle, start and spin are rational parts of a turn with denominators up to 360, the order
/// is their common denominator (and a multiple of 4), and directions are powers of a root of unity:
/// positions are exact. Rational angles with larger denominators have their directions in a table
/// of doubles, others are rounded to 2^-60 of a turn.
class Compass {
public:
    using Heading = std::int64_t;

    /// The compass of generation n: settings with their defaults, the start turned by n * spin.
    Compass(const Settings& settings, std::uint64_t n);

    std::int64_t order() const { return order_; }
    /// Whether directions are exact: the ring of order `order()` is small enough to compute in.
    bool is_exact() const { return exact_; }
    Heading start() const { return start_; }
    /// What + turns by.
    Heading turn() const { return turn_; }
    Heading half() const { return order_ / 2; }

    Heading normal(Heading heading) const {
        heading %= order_;
        return heading < 0 ? heading + order_ : heading;
    }
    Heading sum(Heading left, Heading right) const { return normal(left + right); }

    /// The unit vector of a heading.
    std::complex<double> direction(Heading heading) const {
        const auto index = static_cast<std::size_t>(normal(heading));
        return table_.empty() ? computed(normal(heading)) : table_[index];
    }

private:
    std::complex<double> computed(Heading heading) const;

    std::int64_t order_ = 4;
    bool exact_ = true;
    Heading start_ = 0;
    Heading turn_ = 1;
    std::vector<std::complex<double>> table_;
};

}  // namespace algae
