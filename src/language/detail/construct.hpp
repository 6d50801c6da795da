#pragma once

// Constructions: from systems, systems for what operations make of their languages.

#include <algorithm>
#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "exact/exact.hpp"
#include "language/detail/regular.hpp"
#include "system/system.hpp"
#include "word/word.hpp"

namespace algae {

/// Whether all these letters are marked, by symbol.
bool all_marked(const auto& letters, const std::vector<char>& marks) {
    return std::all_of(letters.begin(), letters.end(), [&](Symbol a) { return marks[a] != 0; });
}

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
    /// A new letter that is not a terminal, to be named like this: `a` becomes `a_1` or `a_2`.
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

// --- Normal forms ---

/// An equivalent synchronised system (Rozenberg and Salomaa 1980, II.1 and V.1): every successor of a
/// terminal is a letter that fails, so the letters of a derived word become terminals in one and the
/// same step. Its axiom is one letter, which occurs in no successor, and a successor has terminals only
/// or none. The tables keep their number and names; deterministic ones become nondeterministic.
/// O(size of the rules).
///
/// Example: synchronised(et0l("a", {{{'a', "aa"}}})).axiom.size() == 1
ET0L synchronised(const ET0L& system);

/// A system without erasing rules for L(G) without the empty word; the tables keep their number, so E0L
/// languages are EP0L and ET0L languages EPT0L but for the empty word (Herman and Rozenberg 1975;
/// Rozenberg and Salomaa 1980, II.1 and V.1). Deterministic tables become nondeterministic.
///
/// Up to 2^letters times more letters and, for a successor with n letters that may vanish, up to 2^n times more
/// rules. Throws what budget.check throws, and BoundReached if the system takes more than budget.memory.
///
/// Example: is_propagating(propagating(et0l("ab", {{{'a', "aa"}, {'a', ""}}})))
ET0L propagating(const ET0L& system, const Budget& budget = {});

/// The same for the words that remain of words of L(G), if any letters of them that `may_go` are left
/// out, without the empty word; `may_go` is by symbol.
///
/// Example: is_propagating(thinned(et0l("ab", {{{'a', "aa"}}}), {1, 0}))
ET0L thinned(const ET0L& system, const std::vector<char>& may_go, const Budget& budget = {});

/// Whether some word of L(G) has letters only that `may_go`: decided by the sets of letters that words
/// of each set of letters derive, up to 2^letters of them. Throws as `propagating`.
///
/// Example: !can_vanish(et0l("ab", {{{'a', "aa"}}}), {1, 0})
bool can_vanish(const ET0L& system, const std::vector<char>& may_go, const Budget& budget = {});

/// An equivalent system with two tables (Rozenberg and Salomaa 1980, V.1), the system itself if it has no
/// more. Deterministic tables give deterministic ones, propagating ones propagating ones.
///
/// There is a copy of each letter for each table. The first table of the result turns copies: those for
/// table i become those for the next one, after the last those for the first. The second table rewrites
/// a copy for table i by the rules of table i and gives copies for the first, which alone are terminals.
/// All letters of a word are copies for the same table. O(tables * size of the rules).
///
/// Example: with_two_tables(et0l("a", {{{'a', "aa"}}, {{'a', "aaa"}}, {{'a', "b"}}})).tables.size() == 2
ET0L with_two_tables(const ET0L& system);

/// The k systems with rules h^k and axioms w, h(w), ..., h^(k-1)(w) of a system with rules h and axiom w:
/// system i derives the words of generations i, i + k, i + 2k, ... so the union of the k languages is
/// L(G) and their sequences, one word of each in turn, are its sequence. Letters that are not accessible
/// become themselves. O(length of the h^k(a)).
///
/// Throws Error if `power` is 0, and BoundReached if the words have more than budget.letters letters.
///
/// Example: powers(d0l("b", {{'a', "ab"}, {'b', "a"}}), 2)[1].axiom.size() == 1
std::vector<D0L> powers(const D0L& system, unsigned power, const Budget& budget = {});

/// An 0L system and a coding, a homomorphism to single letters.
struct CodedOL {
    OL system;
    Morphism coding;
};

/// An 0L system whose language has L(G) as its image under a coding: every E0L language with a non-empty
/// word is a coding of an 0L language (Ehrenfeucht and Rozenberg 1974; Rozenberg and Salomaa 1980,
/// II.2). The images of codings are E0L by `e0l_image`.
///
/// Words and blocks are listed: exponential in s + p and beyond.
///
/// Throws Error if the system has several tables or derives no non-empty word of terminals, what
/// budget.check throws, and BoundReached if words take more than budget.memory.
///
/// Example: coding_of_0l(et0l("S", {{{'S', "a"}, {'S', "aa"}, {'a', "S"}}}, "a")).system.axiom.size() == 1
CodedOL coding_of_0l(const ET0L& system, const Budget& budget = {});

// --- Operations ---

/// The system that derives the words written backwards: axiom and successors are. Same letters, tables
/// and terminals, and every property of the rules, so all families of L-systems without context are
/// closed under reversal: 0L, D0L, P0L, T0L, E0L, ET0L, EDT0L, ... O(size of the rules).
///
/// Example: spell(*reversed(et0l("ab", {{{'a', "ab"}}})).alphabet, reversed(et0l("ab", {{{'a', "ab"}}})).axiom) == "ba"
ET0L reversed(const ET0L& system);

// E0L languages are closed under union, concatenation, star and plus (Herman and Rozenberg 1975;
// Rozenberg and Salomaa 1980, II.1). All of these synchronise the systems first and are O(size of the
// rules). Words of the second operand are words by the names of their letters; the alphabet of the
// result begins with that of the first. Throw Error if a system has several tables.

/// A new axiom becomes one axiom or the other.
///
/// Example: e0l_union(et0l("a", {{{'a', "aa"}}}), et0l("b", {{{'b', "bb"}}})).tables.size() == 1
ET0L e0l_union(const ET0L& left, const ET0L& right);

/// A new axiom becomes the two axioms after each other, and each waits as long as it likes before it
/// starts. Synchronised, both parts have terminals only from the same step on, or the word fails.
///
/// Example: e0l_concatenation(et0l("a", {{{'a', "aa"}}}), et0l("b", {{{'b', "bb"}}})).tables.size() == 1
ET0L e0l_concatenation(const ET0L& left, const ET0L& right);

/// Several axioms after each other, as many as it likes, each of which waits as above.
///
/// Example: e0l_plus(et0l("a", {{{'a', "aa"}}})).tables.size() == 1
ET0L e0l_plus(const ET0L& system);

/// The same, or the empty word.
///
/// Example: e0l_star(et0l("a", {{{'a', "aa"}}})).tables.size() == 1
ET0L e0l_star(const ET0L& system);

// ET0L and EDT0L languages are closed under union, concatenation, star and plus (Rozenberg and Salomaa 1980,
// IV.1 and V.1): the same by further tables, which stay deterministic. All are O(size of the rules). Words of
// the second operand are words by the names of their letters; the alphabet of the result begins with that of
// the first.

/// A new axiom becomes the first axiom in the tables of the first system, the second in those of the
/// second, and each table lets the letters of the other system fail. One table more than both have.
///
/// Example: is_deterministic(table_union(et0l("a", {{{'a', "aa"}}}), et0l("b", {{{'b', "bb"}}})))
ET0L table_union(const ET0L& left, const ET0L& right);

/// The finishing table starts the second part. One table more than both have.
///
/// Example: is_deterministic(table_concatenation(et0l("a", {{{'a', "aa"}}}), et0l("b", {{{'b', "bb"}}})))
ET0L table_concatenation(const ET0L& left, const ET0L& right);

/// The finishing table starts another part to the right, and the last one does not. Two tables more.
///
/// Example: is_deterministic(table_plus(et0l("a", {{{'a', "aa"}}})))
ET0L table_plus(const ET0L& system);

/// The same, or the empty word.
///
/// Example: is_deterministic(table_star(et0l("a", {{{'a', "aa"}}})))
ET0L table_star(const ET0L& system);

/// A finite substitution: the words that may stand for each letter. A homomorphism has one each.
using Substitution = std::map<Symbol, std::vector<Word>>;

/// Example: substitution({{0, {1, 1}}}).at(0) == std::vector<Word>{{1, 1}}
Substitution substitution(const Morphism& morphism);

/// E0L languages are closed under finite substitution, with that under homomorphisms, erasing or not
/// (Herman and Rozenberg 1975; Rozenberg and Salomaa 1980, II.1). With letter-to-letter images and a
/// system all of whose letters are terminals: a coding of an 0L language is E0L. The tables keep their
/// number.
///
/// O(size of the rules * ways to choose images in a successor) where no image is empty, otherwise as `thinned`.
///
/// Throws Error if a letter that may occur in L(G) has no images, and what `thinned` throws.
///
/// Example: e0l_image(et0l("ab", {{{'a', "aa"}}}), substitution({{0, {1}}, {1, {}}})).tables.size() == 1
ET0L e0l_image(const ET0L& system, const Substitution& images, const Budget& budget = {});

/// ET0L languages are closed under finite substitution, EDT0L languages under homomorphisms (Rozenberg and
/// Salomaa 1980, IV.1 and V.1). The letters are copied as letters that are not terminals, and a further table
/// rewrites those of terminals to the images; deterministic tables stay deterministic if each letter has
/// one image. O(size of the rules).
///
/// Throws Error if a letter that may occur in L(G) has no images.
///
/// Example: is_deterministic(table_image(et0l("ab", {{{'a', "aa"}}}), substitution({{0, {1}}, {1, {}}})))
ET0L table_image(const ET0L& system, const Substitution& images);

/// Every letter of a word of L(G) replaced by some word of the language of its system: ET0L languages are
/// closed under substitution of ET0L languages (Rozenberg and Salomaa 1980, V.1), with that under
/// regular substitution. Words of all systems are words by the names of their letters.
///
/// A word of copies that are not terminals is derived first. A further table makes waiting letters of its
/// terminals, lets any of those start with their axiom, and makes terminals of what is derived from
/// others; what is not done fails. So letters start one after the other, and each uses tables as it likes.
/// One table more than all systems have together. O(size of all rules).
///
/// Throws Error if a letter that may occur in L(G) has no system.
///
/// Example: substituted(et0l("a", {{{'a', "aa"}}}), {{0, et0l("b", {{{'b', "bb"}}})}}).tables.size() == 3
ET0L substituted(const ET0L& system, const std::map<Symbol, ET0L>& languages);

/// A generalised sequential machine: an automaton that writes a word for each letter that it reads. It
/// relates the words that lead from the initial to an accepting state to what is written on the way.
struct Gsm {
    struct Move {
        std::size_t from = 0;
        Symbol letter = 0;
        std::size_t to = 0;
        Word output;
    };
    std::size_t initial = 0;
    std::vector<char> accepting;  // by state
    std::vector<Move> moves;

    std::size_t states() const { return accepting.size(); }
};

/// The machine that writes what it reads, if the automaton accepts it.
///
/// Example: copying(Dfa{1, 0, {1, 0}, {1, 1}}).moves.size() == 2
Gsm copying(const Dfa& automaton);

/// At most one move for each state and letter.
///
/// Example: is_deterministic(copying(Dfa{1, 0, {1, 0}, {1, 1}}))
bool is_deterministic(const Gsm& machine);

// What a generalised sequential machine writes when it reads words of L(G), and L(G) intersected with a
// regular language: what the machine writes that copies its words. E0L, ET0L and, for deterministic
// machines, EDT0L languages are closed under both (Herman and Rozenberg 1975; Rozenberg and Salomaa
// 1980, II.1 and IV.1). Words of the machine and of the regular language are over the symbols of the system.
//
// O(size of the rules * states^(letters of a successor + 1)) at most.
// All throw what budget.check throws, and BoundReached if the system takes more than budget.memory.

/// The tables keep their number. The system is synchronised first; where the machine writes nothing for
/// a letter, as `e0l_image`.
ET0L e0l_gsm_image(const ET0L& system, const Gsm& machine, const Budget& budget = {});

/// Example: e0l_intersection(et0l("a", {{{'a', "aa"}}}), finite_set({{0, 0}})).tables.size() == 1
ET0L e0l_intersection(const ET0L& system, const RegularLanguage& language,
                      const Budget& budget = {});

/// Deterministic tables stay deterministic if the machine is: up to states^(states * letters) copies of each,
/// mostly few.
ET0L table_gsm_image(const ET0L& system, const Gsm& machine, const Budget& budget = {});

/// Example: is_deterministic(table_intersection(et0l("a", {{{'a', "aa"}}}), finite_set({{0, 0}})))
ET0L table_intersection(const ET0L& system, const RegularLanguage& language,
                        const Budget& budget = {});

/// h^-1(L(G)): the words over the letters that have an image whose images are in L(G). ET0L languages are
/// closed under inverse homomorphisms (Rozenberg and Salomaa 1980, V.1); E0L and EDT0L languages are not.
/// Letters are symbols of the system's alphabet.
/// Size and throws: as `table_gsm_image` with as many states as the images have letters.
///
/// Example: table_inverse_image(et0l("ab", {{{'a', "aa"}}}), {{0, {0}}, {1, {1, 1}}}).tables.size() == 2
ET0L table_inverse_image(const ET0L& system, const Morphism& morphism, const Budget& budget = {});

}  // namespace algae
