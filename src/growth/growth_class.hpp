#pragma once

#include <cstdint>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "base/budget.hpp"
#include "growth/components.hpp"
#include "growth/rate.hpp"
#include "growth/recurrence.hpp"

namespace algae {

/// How a sequence of lengths grows: 0 from some n on; bounded but not that; like n^k with k > 0; like
/// n^k rho^n with rho > 1.
enum class GrowthKind { zero, bounded, polynomial, exponential };

std::string to_string(GrowthKind kind);

/// f(n) lies between two positive multiples of n^degree rate^n from some n on.
struct GrowthOrder {
    GrowthKind kind = GrowthKind::zero;
    std::uint64_t degree = 0;  // k
    Rate rate = Rate(1);       // rho; 1 unless exponential

    /// "0 from some n on", "bounded", "n^2", "2^n", "n*2^n", "((1+sqrt(5))/2)^n".
    std::string text() const;
    friend bool operator==(const GrowthOrder&, const GrowthOrder&) = default;
};

/// Whether a grows more slowly than b.
bool grows_slower(const GrowthOrder& a, const GrowthOrder& b);

/// The order of |h^n(a)| for each letter a of `D0L::letters`: the largest rate of the components that
/// it reaches, and how many components of that rate follow each other on a path, less one (Salomaa
/// and Soittola 1978, II; Rozenberg and Salomaa 1980, I.3).
std::vector<GrowthOrder> letter_orders(const Components& components);

/// The order of the length of the words.
GrowthOrder growth_order(const D0L& system, const std::vector<GrowthOrder>& letters);

/// The growth of the length of a system.
struct GrowthClass {
    GrowthOrder order;
    /// Kind zero: the first n with an empty word. Kind bounded: the length is periodic from here on.
    std::uint64_t preperiod = 0;
    /// f(n)/(n^k rho^n) comes closer and closer to a function of n mod `period`; 1 if it has a limit.
    /// For kind bounded the period of the length itself; 1 for kind zero.
    Integer period = 1;
};

/// Decided with the components, the period with the roots of the shortest recurrence.
///
/// Example: growth_class(d0l("a", {{'a', "bb"}, {'b', "a"}})).period == 2
GrowthClass growth_class(const D0L& system, const Budget& budget = {});
GrowthClass growth_class(const D0L& system, const Components& components, const Recurrence& recurrence);

/// The least p for which the limits of a(pn + r)/((pn + r)^k rho^(pn + r)) exist for all r, where
/// `annihilator` is the polynomial of the shortest recurrence of a.
Integer limit_period(const Polynomial& annihilator, const GrowthOrder& order, const Components& components);

}  // namespace algae
