#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "base/budget.hpp"
#include "system/et0l.hpp"

namespace algae {

/// The words of L(G) that the axiom derives in at most n steps, each once, in shortlex order of their
/// names: those of all generations up to n, by all tables, that have terminals only. With `longest`
/// only words of at most so many letters. All words on the way are kept; where erasing rules may
/// shorten them, long ones too. Throws BoundReached if they take more than budget.memory.
///
/// Example: terminal_words(et0l("S", {{{'S', "aS"}, {'S', "b"}}}, "ab"), 3).size() == 3
std::vector<Word> terminal_words(const ET0L& system, std::uint64_t n,
                                 std::optional<std::size_t> longest = std::nullopt,
                                 const Budget& budget = {});

/// The names of the tables in a text, as their numbers: names or numbers from 1 on with commas
/// between, or, where each is one character, without: "light,dark", "1,2", "abab", "1212". Throws
/// Error if one is no table.
std::vector<std::size_t> table_sequence(const std::vector<std::string>& tables,
                                        const std::string& text);

}  // namespace algae
