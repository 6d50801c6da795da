#pragma once

#include <optional>
#include <set>
#include <vector>

#include "base/budget.hpp"
#include "verify/certificate.hpp"

namespace algae::verify {

/// All words of a language, by the definition of each operation; nothing if it is infinite. Throws
/// BoundReached where that cannot be found out or takes more than the budget.
std::optional<std::set<Word>> finite_values(const Language& language, const Alphabet& alphabet,
                                            const Budget& budget);

/// The words of a finite set or of a system whose derivations come to an end; throws BoundReached if
/// they do not within the budget.
std::vector<Word> finite_values_of_leaf(const Tree& leaf, const Budget& budget);

}  // namespace algae::verify
