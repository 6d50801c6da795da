#pragma once

#include <cstdint>
#include <optional>

#include "base/budget.hpp"
#include "exact/integer.hpp"
#include "system/d0l.hpp"

namespace algae {

/// Whether the words of two systems have the same lengths in every generation, and why.
struct GrowthComparison {
    /// The first generation whose words differ in length, with both lengths.
    struct Difference {
        std::uint64_t generation;
        Integer left, right;
    };
    bool equal = false;
    /// So many first lengths decide: the difference of two sequences that obey recurrences of orders
    /// n1 and n2, the numbers of accessible letters, obeys one of order n1 + n2; if its first n1 + n2
    /// values are 0, all are.
    std::uint64_t bound = 0;
    std::optional<Difference> difference;  // if not equal
};

/// Growth equivalence of D0L systems (Rozenberg and Salomaa 1980, I.3). O(bound * size) additions.
///
/// Example: equal_growth(d0l("a", {{'a', "ab"}, {'b', "a"}}), d0l("b", {{'a', "ab"}, {'b', "a"}})).difference->generation == 1
GrowthComparison equal_growth(const D0L& left, const D0L& right, const Budget& budget = {});

}  // namespace algae
