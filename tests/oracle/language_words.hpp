#pragma once

#include <cstddef>
#include <optional>
#include <set>

#include "language/language.hpp"

namespace algae::oracle {

/// All words of at most `longest` letters of a language, by the definition of each operation on sets of such words:
/// of images with erasing rules too, as far as they can be taken on to what the parts are made of. Nothing where
/// longer words would have to be known than can be: under inverse images, or complements and the like under an
/// image that erases, and of systems with context.
std::optional<std::set<Word>> language_words(const Language& language, std::size_t longest);

}  // namespace algae::oracle
