#pragma once
// Bracketed words taken apart by recursion, without any tree in between.

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <utility>

namespace algae::oracle {

/// What grows from the vertex at the beginning of a word, in a form in which the order of lateral
/// branches and empty brackets no longer show: text that is equal for equal trees only.
std::string branches(const std::string& word);

/// A word for the same tree: lateral branches in another order, empty brackets added.
std::string shuffled(const std::string& word, std::uint64_t seed);

/// For each order that has edges, how many axes and edges there are.
std::map<std::size_t, std::pair<std::uint64_t, std::uint64_t>> axes(const std::string& word);

}  // namespace algae::oracle
