#pragma once

#include <memory>
#include <string>
#include <vector>

#include "system/ol.hpp"

namespace algae {

/// The successors of each letter, by symbol: one or more for each. A step of derivation uses one table.
using Table = std::vector<std::vector<Word>>;

/// An extended 0L system with tables: a word, tables of finite substitutions, and terminals. Its
/// language are the derived words that have terminals only (Rozenberg and Salomaa 1980, V.1). With one
/// table it is an E0L system; where every letter is a terminal it is a T0L or 0L system.
struct ET0L {
    std::shared_ptr<const Alphabet> alphabet;
    Word axiom;
    std::vector<Table> tables;             // at least one
    std::vector<char> terminal;            // by symbol
    std::vector<std::string> table_names;  // one for each table, empty where it has no name
    std::string name;                      // for messages
};

/// The system as an ET0L system, if it is one: no contexts, conditions, parameters or probabilities.
/// Where it has no tables its rules are the one table; a letter without a rule in a table stays as it
/// is there; without terminals every letter is one. O(size of the system).
View<ET0L> as_et0l(const LSystem& system);

/// The same system with one table in which every letter is a terminal.
///
/// Example: as_et0l(ol("a", {{'a', "aa"}})).tables.size() == 1
ET0L as_et0l(const OL& system);

/// Every letter is a terminal: a T0L system.
bool has_only_terminals(const ET0L& system);
/// In each table every accessible letter has one successor: an EDT0L system.
bool is_deterministic(const ET0L& system);
/// No accessible letter has the empty successor in any table: an EPT0L system.
bool is_propagating(const ET0L& system);

/// The letters that occur in some derived word, in order of first access.
std::vector<Symbol> accessible_letters(const ET0L& system);

/// The family that the form of the system shows, with the letters of Rozenberg and Salomaa: "D0L",
/// "PT0L", "E0L", "EDT0L".
///
/// Example: family_name(as_et0l(ol("a", {{'a', "aa"}}))) == "PD0L"
std::string family_name(const ET0L& system);

/// The same system over another alphabet that has all its symbols by name: letters that it does not
/// know stay as they are and are no terminals. Throws Error if a symbol is missing there.
ET0L over(const ET0L& system, std::shared_ptr<const Alphabet> alphabet);

/// An ET0L system with one character a letter, for tests and examples: tables of rules, and the
/// terminals; no terminals means all letters.
ET0L et0l(const std::string& axiom,
          const std::vector<std::vector<std::pair<char, std::string>>>& tables,
          const std::string& terminals = "");

}  // namespace algae
