#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <vector>

#include "system/system.hpp"

namespace algae::oracle {

/// All words of at most `longest` letters that have terminals only and are derived through words of at
/// most `on_the_way` letters: every table and every choice is tried. All of L(G) up to that length if
/// nothing is erased. Nothing if there are more than `most` words on the way.
std::optional<std::set<Word>> table_words(const ET0L& system, std::size_t longest,
                                          std::size_t on_the_way, std::size_t most = 20000);

/// What each terminal stands for.
using Meaning = std::map<Symbol, std::set<Word>>;

/// Each terminal stands for itself.
Meaning plain(const ET0L& system);

/// All words of at most `longest` letters that the words of L(G) mean if every terminal stands for any of
/// some words, exactly, with erasing rules too. What the letters mean after 0, 1, ... tables, the last
/// table first, is followed until nothing new comes: the sets of short words are finitely many. Nothing if
/// more than `most` families of sets come.
std::optional<std::set<Word>> meant_words(const ET0L& system, const Meaning& meaning,
                                          std::size_t longest, std::size_t most = 3000);

/// The words of L(G) of at most `longest` letters, in the same way.
inline std::optional<std::set<Word>> short_words(const ET0L& system, std::size_t longest,
                                                 std::size_t most = 3000) {
    return meant_words(system, plain(system), longest, most);
}

}  // namespace algae::oracle
