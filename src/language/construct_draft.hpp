#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "base/budget.hpp"
#include "system/et0l.hpp"
#include "word/renaming.hpp"

namespace algae {

/// Gives out symbols of an alphabet for new letters: `a_1`, `a_2`, ... for those to be named like `a`.
class NewNames {
public:
    /// The alphabet must outlive this.
    explicit NewNames(Alphabet& alphabet) : alphabet_(&alphabet) {}

    Symbol symbol(const std::string& like);

private:
    Alphabet* alphabet_;
    std::map<std::string, std::size_t> last_;  // numbers in use, by beginning of the name
};

/// An ET0L system while it is constructed. Its letters are numbers of its own: each stands for a terminal
/// of the result or is a new letter, which gets a name only when the system is done.
class Draft {
public:
    /// `base` is what the alphabet of the result begins with: its symbols keep their numbers and names.
    explicit Draft(const Alphabet& base, std::size_t tables = 1);

    /// The letter that stands for the terminal of this name.
    Symbol terminal(const std::string& name);
    /// A new letter that is no terminal, to be named like this: `a` becomes `a_1` or `a_2`.
    Symbol fresh(const std::string& like);
    /// The number of a further table.
    std::size_t add_table(std::string name = {});
    /// The number of the first of the further tables, one for each table of the system.
    std::size_t add_tables(const ET0L& system);
    void add_rule(std::size_t table, Symbol letter, Word successor);
    /// The letter stays as it is, in every table there is.
    void keep(Symbol letter);
    /// All letters that stand for terminals so far stay as they are, in every table there is.
    void keep_terminals();

    /// New letters for all letters of a system, by its symbols.
    std::vector<Symbol> copies(const ET0L& system);
    /// The same, but its terminals stand for themselves.
    std::vector<Symbol> letters(const ET0L& system);
    /// A word over the symbols of an alphabet, its letters terminals.
    Word terminals(const Alphabet& alphabet, const Word& word);
    /// The rules of table number `from` of a system, its letters replaced.
    void add_rules(std::size_t table, const ET0L& system, std::size_t from,
                   const std::vector<Symbol>& letters);

    std::size_t tables() const { return tables_.size(); }
    /// Throws what budget.check throws, and BoundReached if what is written takes more than budget.memory.
    void check(const Budget& budget) const;

    /// The system. A letter without a rule in a table becomes a letter there that fails: it derives
    /// itself only. New letters that the axiom does not reach or from which no terminal word is derived
    /// are left out, and with these the successors that have them (Rozenberg and Salomaa 1980, II.1):
    /// every letter of a derivation of a terminal word derives a part of it. O(size of the rules *
    /// number of letters).
    ET0L system(const Word& axiom, std::string name) const;

private:
    struct Letter {
        std::string name;
        bool terminal = false;
    };
    std::vector<char> productive() const;
    std::vector<char> accessible(const Word& axiom, const std::vector<char>& useful) const;

    Alphabet base_;
    std::vector<Letter> letters_;
    std::vector<Symbol> by_symbol_;  // the letters of terminals, by symbol of `base_`
    std::vector<Table> tables_;
    std::vector<std::string> table_names_;
    std::size_t size_ = 0;
};

/// Whether the word has terminals only.
bool is_terminal_word(const ET0L& system, const Word& word);

/// The same language over an alphabet that begins with `base`: new letters get new names, useless ones
/// are left out. For the last of several constructions.
ET0L trimmed(const ET0L& system, const Alphabet& base, std::string name);

/// Throws Error if the system has several tables: `what` says what needs an E0L system.
void require_one_table(const ET0L& system, const char* what);

}  // namespace algae
