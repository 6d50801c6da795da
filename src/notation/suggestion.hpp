#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace algae {

/// The fewest insertions, deletions, replacements and exchanges of neighbours that turn one text
/// into the other (restricted Damerau-Levenshtein distance). Time the product of the lengths.
///
/// Example: edit_distance("angel", "angle") == 1
std::size_t edit_distance(std::string_view left, std::string_view right);

/// "; did you mean 'angle'?" if one of the candidates is close to what was written, otherwise "".
std::string did_you_mean(std::string_view written, const std::vector<std::string>& candidates);

}  // namespace algae
