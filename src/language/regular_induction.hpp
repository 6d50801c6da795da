#pragma once

#include <optional>
#include <vector>

#include "base/budget.hpp"
#include "language/regular_language.hpp"
#include "system/ol.hpp"

namespace algae {

/// A proof by induction on the length that a regular language R is contained in L(G): every word of R but those
/// of `base`, which are in L(G), is derived in one step from a shorter word of R, by successors that are not empty
/// and at least once one of two letters or more.
struct RegularInduction {
    std::vector<Word> base;
};

/// The words of R that no step as above gives are regular again, as is the image of R under a substitution
/// with one marked letter; if they are at most `most` they are the base, whose membership is left to the caller.
/// Nothing if there are more: then R may be contained in L(G) all the same.
///
/// Example: regular_induction(plus(finite_set({{0}})), ol("a", {{'a', "a"}, {'a', "aa"}}))->base == std::vector<Word>{{0}}
std::optional<RegularInduction> regular_induction(const RegularLanguage& language, const OL& system,
                                                  std::size_t most = 100, const Budget& budget = {});

}  // namespace algae
