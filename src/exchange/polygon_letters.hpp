#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

namespace algae {

/// Where letters stand in the words of a system: between `{` and `}`, which fence a polygon, or not.
struct PolygonLetters {
    std::set<char> inside, outside;
};

/// Of the letters that the axiom reaches. Where braces do not match within a word, all of them count
/// as outside. Linear in the size of the rules.
///
/// Example: polygon_letters("aA", {{'A', "{bc}b"}}).inside == std::set<char>{'b', 'c'}
PolygonLetters polygon_letters(const std::string& axiom, const std::map<char, std::string>& rules);

/// How many braces are open where each letter of a word stands; an unmatched `}` counts for nothing.
///
/// Example: brace_depths("a{b}}c") == std::vector<std::size_t>{0, 1, 1, 0, 0, 0}
std::vector<std::size_t> brace_depths(const std::string& word);

}  // namespace algae
