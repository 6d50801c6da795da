#pragma once

#include <cstdint>

#include "base/budget.hpp"
#include "exact/integer.hpp"
#include "system/d0l.hpp"

namespace algae {

/// `count` letters of generation n from position `at` on, counted from 0; fewer if the word ends
/// before. The word is not written out: lengths say where to step down the derivation.
///
/// Time O(n * size of the rules) operations on numbers of the size of `at`, memory O(sqrt(n)) rows
/// of such numbers, then O(1) amortised a further letter of a propagating system. Lengths are only
/// worked out up to `at`, so neither n nor the length of the word need be small: position 10^100
/// of generation 10^6 is answered in seconds. Throws Error if the word has no letter at `at`.
///
/// Example: letters_at(d0l("b", {{'a', "ab"}, {'b', "a"}}), 500, power(Integer(10), 100), 1).size() == 1
Word letters_at(const D0L& system, std::uint64_t n, const Integer& at, std::uint64_t count,
                const Budget& budget = {});

}  // namespace algae
