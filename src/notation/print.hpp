#pragma once

#include <string>

#include "system/lsystem.hpp"
#include "word/spelling.hpp"

namespace algae {

/// The canonical text of a system: title, source, id, alphabet, let, systems within, axiom, tables and
/// rules, schedule, ignore, terminals, interpret, environment, settings, expectations; one statement a line, with a line break at
/// the end of each. It reads back as the same system, and its own canonical text is itself.
/// Throws nothing on systems that were read; title, source, names and values of a system made
/// otherwise must be such as can be written in the notation.
std::string print_lsystem(const LSystem& system);

/// One rule, as in the canonical text, without a line break.
std::string print_rule(const Alphabet& alphabet, const Production& rule);

/// A word with its arguments, without blanks unless a symbol's name needs them; `ε` if empty.
///
/// Example: print_word(Alphabet(), ModuleWord()) == "ε"
std::string print_word(const Alphabet& alphabet, const ModuleWord& word);

/// Prints many words and rules over one alphabet, which must outlive it and must not grow.
class Printer {
public:
    explicit Printer(const Alphabet& alphabet) : alphabet_(alphabet), spellings_(alphabet) {}

    std::string word(const ModuleWord& word) const;
    std::string rule(const Production& rule) const;
    /// Symbols with a blank between any two.
    std::string apart(const Word& symbols) const;

private:
    std::string pattern(const Pattern& pattern, const char* separator) const;
    std::string shape(const ShapeSuccessor& shape) const;

    const Alphabet& alphabet_;
    Spellings spellings_;
};

}  // namespace algae
