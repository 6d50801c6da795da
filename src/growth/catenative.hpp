#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "base/budget.hpp"
#include "system/d0l.hpp"

namespace algae {

/// w_n = w_(n-i1) w_(n-i2) ... w_(n-ik) for all n >= from, where w_n = h^n(w).
struct CatenativeFormula {
    std::vector<std::size_t> back;  // i1, i2, ..., ik
    std::size_t from = 0;

    /// "w(n) = w(n-1) w(n-2) for n >= 2".
    std::string text() const;
};

/// What a search for locally catenative formulas found.
struct CatenativeAnswer {
    enum class Kind { found, none, not_found };
    Kind kind = Kind::not_found;
    std::optional<CatenativeFormula> formula;
    std::string because;
};

/// A locally catenative formula of at most `depth` (its greatest i), two words or more on its right
/// side; the one of least depth, then from the least n, then with the fewest words (Rozenberg and
/// Lindenmayer 1973).
///
/// A formula that holds for one n >= depth holds for all later ones: h maps w_m to w_(m+1), so it maps
/// the equation for n to the one for n + 1. That is the whole proof, so one comparison of words
/// decides, and `from` is where it was made. None is proved where the lengths are bounded or grow
/// like a polynomial: |w_n| >= 2 |w_(n-depth)| from some n on would make them grow exponentially, or
/// bounded ones that are not 0 double. Otherwise the search ends at generation depth + `further`, or
/// when the words together have more than a million letters (or budget.letters), and says so.
///
/// Example: locally_catenative(d0l("a", {{'a', "ab"}, {'b', "a"}}), 4).formula->text() ==
///     "w(n) = w(n-1) w(n-2) for n >= 2"
CatenativeAnswer locally_catenative(const D0L& system, std::size_t depth, std::size_t further = 24,
                                    const Budget& budget = {});

}  // namespace algae
