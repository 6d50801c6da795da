#pragma once
// oracle: slow second routes. Rewriting letter by letter, walking step by step, listing every word;
// nothing here includes fold, and nothing here is clever.

#include <cstddef>
#include <iosfwd>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "system/system.hpp"

namespace algae::oracle {

/// A system as on paper, one character a letter. A letter that has no successors stays.
struct WrittenSystem {
    std::string axiom;
    std::map<char, std::vector<std::string>> successors;

    bool is_deterministic() const;
    /// Every letter that is written anywhere, once.
    std::set<char> letters() const;
};
std::ostream& operator<<(std::ostream& out, const WrittenSystem& system);

/// The word of generation n of a deterministic system: every letter replaced, n times.
std::string rewritten(const WrittenSystem& system, unsigned n);

/// The last generation, no later than `most`, of which all up to it have at most `letters` letters.
unsigned last_generation_within(const WrittenSystem& system, std::size_t letters, unsigned most);

/// All words of generation n, by trying every choice for every letter.
std::set<std::string> words_of_generation(const WrittenSystem& system, unsigned n);

/// The words of at most `longest` letters that are reached by words of at most `on_the_way`.
std::set<std::string> words_up_to(const WrittenSystem& system, std::size_t longest,
                                  std::size_t on_the_way);

/// The same system in the types of the library.
LSystem lsystem_of(const WrittenSystem& system);
D0L d0l_of(const WrittenSystem& system);
OL ol_of(const WrittenSystem& system);

/// A word of one-character names as a string.
std::string text_of(const Alphabet& alphabet, const Word& word);

/// n steps of rules given by symbol, letter by letter.
Word rewritten(Word word, const std::vector<Word>& images, unsigned n);

/// The names in a text as a person reads it: blanks separate; otherwise the longest of the declared
/// names, or a letter with its subscript, or one character.
std::vector<std::string> names_in(const std::string& text, const std::set<std::string>& declared);

}  // namespace algae::oracle
