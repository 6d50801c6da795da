#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "word/alphabet.hpp"

namespace algae::verify {

/// An L-system as a certificate has it: a word and tables of successors, with terminals; or
/// deterministic rules with context.
struct System {
    /// The successors of each letter, by symbol: at least one.
    using Successors = std::vector<std::vector<Word>>;
    struct Rule {
        Word left;
        Symbol letter = 0;
        Word right, successor;
        bool operator==(const Rule&) const = default;
    };

    Word axiom;
    std::vector<Successors> tables;  // at least one where there is no context
    std::vector<char> terminal;      // by symbol
    bool context = false;
    std::vector<Rule> rules;    // with context
    std::vector<char> ignored;  // with context, by symbol

    bool operator==(const System&) const = default;
};

/// The letters that can occur in a word derived from this one, in increasing order.
std::vector<Symbol> accessible_letters(const System& system, const Word& from);

/// Whether every letter that is accessible from the axiom is a terminal.
bool has_only_terminals(const System& system);
/// Whether it is a D0L system: no context, one table, one successor for each accessible letter, no
/// letter that is no terminal.
bool is_d0l(const System& system);

/// The letters from which some derivation by this table goes on for ever without becoming empty.
std::set<Symbol> lasting_letters(const System::Successors& table);

/// Whether an 0L system derives words without end: some letter derives a word with itself in it, where the first
/// rule has a lasting letter besides. Only systems with one table and terminals only are said to.
bool is_endless(const System& system);

/// What keeps the system from having the form of a family, in words; nothing if it has it. The families are
/// 0L, T0L, E0L and ET0L with P and D before, and IL. `empty_axiom`: whether the empty word may be
/// the axiom.
std::optional<std::string> beyond_form(const System& system, const std::string& family,
                                       bool empty_axiom);

/// The next word of a system with context.
Word next_word(const System& system, const Word& word);
/// Whether a step by this table can take one word to the other.
bool may_give(const System::Successors& table, const Word& from, const Word& to);
/// Whether no rule has the empty successor.
bool never_shrinks(const System& system);

}  // namespace algae::verify
