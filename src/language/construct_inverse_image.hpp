#pragma once

#include <map>

#include "base/budget.hpp"
#include "system/et0l.hpp"

namespace algae {

/// h^-1(L(G)): the words over the letters that have an image whose images are in L(G). ET0L languages are
/// closed under inverse homomorphisms (Rozenberg and Salomaa 1980, V.1); E0L and EDT0L languages are not.
/// Letters are symbols of the system's alphabet.
///
/// A machine reads a word letter by letter as images and writes their letters; letters with an
/// empty image are then inserted anywhere by further tables. Size and throws: as `table_gsm_image` with
/// as many states as the images have letters.
///
/// Example: table_inverse_image(et0l("ab", {{{'a', "aa"}}}), {{0, {0}}, {1, {1, 1}}}).tables.size() == 2
ET0L table_inverse_image(const ET0L& system, const std::map<Symbol, Word>& morphism,
                         const Budget& budget = {});

}  // namespace algae
