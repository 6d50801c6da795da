#pragma once

#include <algorithm>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <tuple>
#include <vector>

#include "exact/exact.hpp"
#include "verify/verify.hpp"

namespace algae::verify {

/// Whether the word has this part at the position.
inline bool stands_at(const Word& part, const Word& word, std::size_t position) {
    return part.size() <= word.size() - position &&
           std::equal(part.begin(), part.end(),
                      word.begin() + static_cast<std::ptrdiff_t>(position));
}

/// A relation on the numbers below `size`, row after row.
class BooleanMatrix {
public:
    explicit BooleanMatrix(std::size_t size = 0)
        : size_(size), words_((size + 63) / 64), bits_(size_of(size)) {}

    static BooleanMatrix identity(std::size_t size) {
        BooleanMatrix one(size);
        for (std::size_t i = 0; i < size; ++i) one.set(i, i);
        return one;
    }

    std::size_t size() const { return size_; }
    bool at(std::size_t row, std::size_t column) const {
        return (bits_[row * words_ + column / 64] >> (column % 64)) & 1;
    }
    void set(std::size_t row, std::size_t column) {
        bits_[row * words_ + column / 64] |= std::uint64_t{1} << (column % 64);
    }
    BooleanMatrix& operator|=(const BooleanMatrix& other) {
        for (std::size_t i = 0; i < bits_.size(); ++i) bits_[i] |= other.bits_[i];
        return *this;
    }
    /// This relation first, then the other.
    BooleanMatrix then(const BooleanMatrix& other) const {
        BooleanMatrix product(size_);
        for (std::size_t row = 0; row < size_; ++row)
            for (std::size_t middle = 0; middle < size_; ++middle)
                if (at(row, middle))
                    for (std::size_t k = 0; k < words_; ++k)
                        product.bits_[row * words_ + k] |= other.bits_[middle * words_ + k];
        return product;
    }
    std::size_t bytes() const { return sizeof(*this) + 8 * bits_.size(); }

    bool operator==(const BooleanMatrix&) const = default;
    bool operator<(const BooleanMatrix& other) const {
        return std::tie(size_, bits_) < std::tie(other.size_, other.bits_);
    }

private:
    static std::size_t size_of(std::size_t size) { return size * ((size + 63) / 64); }

    std::size_t size_;
    std::size_t words_;
    std::vector<std::uint64_t> bits_;
};

/// How letters act on the states of an automaton after some number of steps: for each accessible letter, the pairs of
/// states such that some derived word leads from the first to the second.
using Relations = std::map<Symbol, BooleanMatrix>;

/// How a word acts, if its letters act like this.
BooleanMatrix relation_of(const Word& word, const Relations& relations, std::size_t states);

/// The relations after one more step, which comes first, by a table.
Relations one_step_earlier(const Relations& relations, const System::Successors& table,
                           std::size_t states);

/// Computes the relations for all sequences of tables, beginning with `start` for the empty sequence, until
/// no new relations appear. Returns true as soon as `stop` is true for one of them. Throws BoundReached
/// if they take more than the budget's memory.
bool some_relations(const System& system, const Relations& start, std::size_t states,
                    const std::function<bool(const Relations&)>& stop, const Budget& budget);

/// The same for all sequences of exactly this number of tables.
bool some_relations_after(const System& system, const Relations& start, std::size_t states,
                          const Integer& steps, const std::function<bool(const Relations&)>& stop,
                          const Budget& budget);

/// The lengths of the words of a D0L system, one generation after the other, computed by counting letters.
class Lengths {
public:
    /// `system` must outlive this.
    explicit Lengths(const System& system);

    /// The number of letters that are accessible.
    std::size_t letters() const { return counts_.size(); }
    /// The length of the present generation, at first the axiom's.
    Integer length() const;
    void next();

private:
    const System& system_;
    std::vector<Symbol> symbols_;
    std::vector<Integer> counts_;  // by place in symbols_
};

/// The length of one generation. Throws BoundReached for generations beyond 100,000.
Integer length_of_generation(const System& system, const Integer& generation, const Budget& budget);

/// The letter at a position, counted from 0, of a generation of a D0L system, found without writing
/// the word; nothing if the word is shorter. Throws BoundReached if the lengths of the images of letters
/// take more than the budget.
std::optional<Symbol> letter_of_generation(const System& system, std::uint64_t generation,
                                           Integer position, const Budget& budget);

/// A proof, and what it has to show: its statement, or the opposite where that does not hold. The
/// statement's own `negated` does not matter. Functions that check it return if the proof shows that; they throw
/// Flaw if it does not, Error if it is not as CERTIFICATES.md says, BoundReached if it cannot be checked
/// within the budget.
struct Obligation {
    const Certificate& certificate;
    Reader reader;
    const Budget& budget;
    const Statement& statement;
    bool holds = true;
    Field proof;

    const Alphabet& alphabet() const { return *certificate.alphabet; }
    const Language& language(std::size_t i = 0) const { return statement.languages[i]; }
    const System& system(std::size_t i = 0) const { return *statement.systems[i].system; }
    Word word(std::string_view field) const { return reader.word(proof.at(field)); }
    Symbol letter(std::string_view field) const { return reader.letter(proof.at(field)); }
    bool contains(const Language& in, const Word& word) const;
    /// All words of a language; nothing if it is infinite.
    std::optional<std::set<Word>> values(const Language& of) const;

    /// What a part of the proof has to show.
    Obligation part(const Statement& shown, bool so, Field by) const {
        return {certificate, reader, budget, shown, so, std::move(by)};
    }
    [[noreturn]] void refuse(const std::string& why) const { proof.refuse(why); }
    /// The proof is of no kind that shows such a statement: throws Flaw.
    [[noreturn]] void wrong_kind() const;
};

/// What the statements speak of, from the fields before them. Throws Error.
void read_header(Certificate& read, JsonValue header);

/// One statement. Throws Error.
Entry read_entry(const Field& field, const Reader& reader);

/// Checks a proof of any kind.
void check_proof(const Obligation& task);

/// Whether a name may be bound: a letter or _, then letters, digits, _ and '. Terms and sums are written with names, so
/// none may look like one.
bool is_name(std::string_view text);
/// Such a name. Throws Error where it is none.
const std::string& name_in(const Field& field);
/// Whether the letter stands for a word, with or without a value.
bool is_bound_word(const BoundNames& bound, Symbol letter);

/// The name of a letter, which need not be one of the alphabet: without blanks, controls and quotes, in which it is printed.
std::string letter_name(const Field& field);

/// The name of a system as it is printed: in quotes if it is none that may be bound, but for - and ., such as 'CF { S -> aS | b }'.
std::string system_name(std::string name);

/// The name of a letter as it is printed: in quotes if it is longer than one character, so that it is not read as several
/// letters, or is a sign of the text around it.
std::string letter_text(const std::string& name);

/// The text on one line, without characters that steer a terminal: they stand as \x1b or \u2028.
std::string plain(std::string_view text);

/// The names of a quantifier without values, as its statement is read with them; words are letters there.
BoundNames open_names(const Quantified& said, const Alphabet& alphabet);

/// Whether this is a family that proofs can be about.
bool is_checked_family(std::string_view name);
/// Whether claims may speak of this family, of systems with such a form: 1L, PDIL, (1,2)L, EP0L, ...
bool is_family_of_forms(std::string_view name);

// The same for one kind of proof each. Of families:
void check_reversal(const Obligation& task);
void check_empty_word(const Obligation& task);
void check_sparse(const Obligation& task);
void check_regular_progressions(const Obligation& task);
void check_unequal_powers(const Obligation& task);
void check_cases(const Obligation& task);
void check_finite_system(const Obligation& task);
void check_form(const Obligation& task);
void check_equal_to_form(const Obligation& task);
void check_all_finite(const Obligation& task);
void check_regular_family(const Obligation& task);
void check_closed(const Obligation& task);
void check_context_free(const Obligation& task);
void check_powers_beyond(const Obligation& task);
void check_classes(const Obligation& task);
void check_lengths(const Obligation& task);
void check_dense(const Obligation& task);
void check_cycles(const Obligation& task);
void check_proportional(const Obligation& task);
void check_blocks(const Obligation& task);
void check_geometric(const Obligation& task);
// Of the size of a language:
void check_size_of_values(const Obligation& task);
void check_no_word(const Obligation& task);
void check_a_word(const Obligation& task);
void check_infinite_part(const Obligation& task);
void check_endless_round(const Obligation& task);
void check_endless_tables(const Obligation& task);
void check_pumping(const Obligation& task);
void check_measure(const Obligation& task);
void check_endless_powers(const Obligation& task);
void check_part(const Obligation& task);
// Of equality and inclusion:
void check_values(const Obligation& task);
void check_linear(const Obligation& task);
void check_facts(const Obligation& task);
void check_word_in_one(const Obligation& task);
void check_derivatives(const Obligation& task);
void check_identical(const Obligation& task);
void check_same_sequences(const Obligation& task);
void check_sections(const Obligation& task);
void check_same_progressions(const Obligation& task);
void check_induction(const Obligation& task);
void check_rules(const Obligation& task);
void check_relations(const Obligation& task);
void check_invariant(const Obligation& task);
/// Induction on the length, where the right language is that of a system with context; the words of the base are in it.
void check_context_induction(const Obligation& task, const std::vector<Word>& base);
/// Induction on the length over one letter, where the right language is that of tables.
void check_length_induction(const Obligation& task, const std::vector<Word>& base);
void check_both(const Obligation& task);
void check_same_powers(const Obligation& task);
// Of codes and palindromes:
void check_code(const Obligation& task);
void check_factorisations(const Obligation& task);
void check_beginning(const Obligation& task);
void check_palindrome(const Obligation& task);
// Of words and derivations:
void check_membership(const Obligation& task);
void check_derivation(const Obligation& task);
void check_not_derived(const Obligation& task);
void check_rewriting(const Obligation& task);
// Of sequences and growth:
void check_balance(const Obligation& task);
void check_finite_sequences(const Obligation& task);
void check_difference(const Obligation& task);
void check_equal_terms(const Obligation& task);
void check_other_length(const Obligation& task);
// Of numbers and words that may depend on numbers:
void check_numbers(const Obligation& task);
void check_recurrences(const Obligation& task);
void check_positive(const Obligation& task);
void check_words(const Obligation& task);
void check_step_of_words(const Obligation& task);
/// The bound word of which the term is the length; nothing if it is another term.
std::optional<Symbol> word_measured(const Field& field, const Reader& reader);
/// How a turtle turns and what letters tell it, as the certificate has it.
struct Turtle {
    Rational turn, heading,
        spin;  // parts of a full turn; spin is added to the heading by each generation
    std::map<Symbol, std::string> letters;  // F f + - | [ ]
};
Turtle read_turtle(const Field& field, const Alphabet& alphabet);
/// Of each turtle of the certificate a line for people.
std::vector<std::string> turtle_texts(const Certificate& certificate);
/// How many different segments the turtle of a D0L system draws in a generation, and how many squares of this side they meet, of which
/// the left and the lower edge are part, in the grid through the turtle's start. Both are exact. They throw Flaw at `where` if brackets
/// do not match, BoundReached beyond a million segments or squares and where the turtle turns otherwise than is checked.
Integer distinct_segments(const System& system, const Turtle& turtle, std::uint64_t generation,
                          const Field& where, const Budget& budget);
Integer met_boxes(const System& system, const Turtle& turtle, std::uint64_t generation,
                  const Rational& side, const Field& where, const Budget& budget);
void check_growth_class(const Obligation& task);
void check_limit_set(const Obligation& task);
void check_rises(const Obligation& task);
void check_rises_by_letters(const Obligation& task);
void check_falls(const Obligation& task);
/// Of an infinite word.
void check_first_order(const Obligation& task);
void check_counts(const Obligation& task);
/// A first-order statement without free names. Throws Error if it is none.
Formula read_formula(const Field& field);
/// A sum of numbers of places. Throws Error if it is none.
CountedPlaces read_counts(const Field& field);
/// A root of an irreducible polynomial. Throws Error if it is none.
RealRoot read_real_root(const Field& field);
/// The same as text, with its word.
std::string formula_text(const Statement& statement, const Alphabet& alphabet);
/// Statements made of others, and quantified ones.
void check_parts(const Obligation& task);
void check_instance(const Obligation& task);
void check_all_instances(const Obligation& task);
void check_by_families(const Obligation& task);
void check_all_sparse(const Obligation& task);
void check_longer(const Obligation& task);
void check_by_letters(const Obligation& task);
void check_by_each(const Obligation& task);
void check_derivations(const Obligation& task);

/// Checks that a language is infinite, by one of the kinds of proof that show only this.
void check_infinite(const Obligation& task, const Language& language, const Field& proof);

/// Throws Flaw if two words of D0L systems in a generation have the same length.
void check_lengths_differ(const Obligation& task);

/// Throws Flaw if a system occurs in the expression whose language is not finite.
void check_regular(const Obligation& task, const Language& language);

/// How the lengths of a D0L system grow: "zero", "bounded", "polynomial" or "exponential", and the degree.
struct Growth {
    std::string name;
    std::size_t degree = 0;
};
Growth growth_of(const System& system);

/// A statement, or its opposite, on one line. Long expressions are shortened in the middle.
std::string statement_text(const Statement& statement, bool refuted, const Alphabet& alphabet);

}  // namespace algae::verify
