#pragma once

#include <map>
#include <vector>

#include "base/budget.hpp"
#include "system/et0l.hpp"

namespace algae {

/// A finite substitution: the words that may stand for each letter. A homomorphism has one each.
using Substitution = std::map<Symbol, std::vector<Word>>;

/// Example: substitution({{0, {1, 1}}}).at(0) == std::vector<Word>{{1, 1}}
Substitution substitution(const std::map<Symbol, Word>& morphism);

/// E0L languages are closed under finite substitution, with that under homomorphisms, erasing or not
/// (Herman and Rozenberg 1975; Rozenberg and Salomaa 1980, II.1). With letter-to-letter images and a
/// system all of whose letters are terminals: a coding of an 0L language is E0L. The tables keep their
/// number.
///
/// Synchronised, all letters of a word become terminals in one step, in successors that have terminals
/// only: those are replaced by their images. Where images are empty, terminals that vanish could hide
/// that other letters are not done: first the rules that erase are eliminated together with the letters
/// that have empty images (`thinned`), and the empty word is added to the axiom if it is an image.
/// O(size of the rules * ways to choose images in a successor) where no image is empty, otherwise as
/// `thinned`.
///
/// Throws Error if a letter that may occur in L(G) has no images, and what `thinned` throws.
///
/// Example: e0l_image(et0l("ab", {{{'a', "aa"}}}), substitution({{0, {1}}, {1, {}}})).tables.size() == 1
ET0L e0l_image(const ET0L& system, const Substitution& images, const Budget& budget = {});

/// ET0L languages are closed under finite substitution, EDT0L languages under homomorphisms (Rozenberg and
/// Salomaa 1980, IV.1 and V.1). The letters are copied as letters that are no terminals, and a further table
/// rewrites those of terminals to the images; deterministic tables stay deterministic if each letter has
/// one image. O(size of the rules).
///
/// Throws Error if a letter that may occur in L(G) has no images.
///
/// Example: is_deterministic(table_image(et0l("ab", {{{'a', "aa"}}}), substitution({{0, {1}}, {1, {}}})))
ET0L table_image(const ET0L& system, const Substitution& images);

}  // namespace algae
