#pragma once

#include <vector>

#include "base/budget.hpp"
#include "language/regular_language.hpp"

namespace algae {

/// h(L) for the homomorphism with these images, by symbol. Throws Error if a letter of L has no image.
///
/// Example: image(plus(finite_set({{0}})), std::vector<Word>{{1, 1}}) == plus(finite_set({{1, 1}}))
RegularLanguage image(const RegularLanguage& language, const std::vector<Word>& images, const Budget& budget = {});

/// The words in which every letter of a word of L is replaced by some word of its language, by
/// symbol: the image under a regular substitution. Throws Error if a letter of L has no language.
///
/// Example: image(finite_set({{0}}), std::vector<RegularLanguage>{all_words({0, 1})}) == all_words({0, 1})
RegularLanguage image(const RegularLanguage& language, const std::vector<RegularLanguage>& images, const Budget& budget = {});

/// h^-1(L): the words over the letters of `domain` whose images are in L. `images` is by symbol.
/// Throws Error if a letter of the domain has no image. O(states * size of the images).
///
/// Example: inverse_image(finite_set({{0, 0, 0}}), {{0}, {0, 0}}, {0, 1}) == finite_set({{0, 1}, {1, 0}, {0, 0, 0}})
RegularLanguage inverse_image(const RegularLanguage& language, const std::vector<Word>& images,
                              const std::vector<Symbol>& domain);

}  // namespace algae
