#pragma once

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

/// What a letter, and all that it derives in some number of steps, does to the states of an automaton:
/// for each accessible letter the pairs of states that some derived word leads from one to the other.
using Relations = std::map<Symbol, BooleanMatrix>;

/// What a word does, where its letters do this.
BooleanMatrix relation_of(const Word& word, const Relations& relations, std::size_t states);

/// The relations of one more step, done first, by a table.
Relations one_step_earlier(const Relations& relations, const System::Successors& table,
                           std::size_t states);

/// Goes through the relations for all sequences of tables, beginning with `start` for none, until
/// nothing new comes; ends as soon as `stop` is true of one, and tells whether it was. Throws BoundReached
/// where they would take more than the budget's memory.
bool some_relations(const System& system, const Relations& start, std::size_t states,
                    const std::function<bool(const Relations&)>& stop, const Budget& budget);

/// The same for all sequences of exactly so many tables.
bool some_relations_after(const System& system, const Relations& start, std::size_t states,
                          const Integer& steps, const std::function<bool(const Relations&)>& stop,
                          const Budget& budget);

/// The lengths of the words of a D0L system, one generation after the other, by counting letters.
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
/// the word; nothing if the word is not so long. Throws BoundReached where the lengths of what letters
/// become take more than the budget.
std::optional<Symbol> letter_of_generation(const System& system, std::uint64_t generation,
                                           Integer position, const Budget& budget);

/// What a proof is checked with.
struct Checking {
    const Certificate& certificate;
    Reader reader;
    const Budget& budget;

    const Alphabet& alphabet() const { return *certificate.alphabet; }
};

/// Checks that a proof shows a statement (`holds`) or its opposite. Returns if it does; throws Flaw if
/// it does not, Error if the proof is not as CERTIFICATES.md says, BoundReached if it cannot be
/// checked within the budget. The statement's own `negated` does not matter.
void check_proof(const Checking& with, const Statement& statement, bool holds, const Field& proof);

// The same for statements of these kinds; `by` is what the proof says of itself.
void check_family(const Checking& with, const Statement& statement, bool holds, const Field& proof,
                  const std::string& by);
void check_size(const Checking& with, const Statement& statement, bool holds, const Field& proof,
                const std::string& by);  // finite, empty, size
void check_comparison(const Checking& with, const Statement& statement, bool holds,
                      const Field& proof, const std::string& by);  // equal, included
void check_membership(const Checking& with, const Statement& statement, bool holds,
                      const Field& proof, const std::string& by);
void check_derivation(const Checking& with, const Statement& statement, bool holds,
                      const Field& proof, const std::string& by);
void check_rewriting(const Checking& with, const Statement& statement, bool holds,
                     const Field& proof, const std::string& by);  // rewrites, chance
void check_sequences(const Checking& with, const Statement& statement, bool holds,
                     const Field& proof, const std::string& by);
void check_growth(const Checking& with, const Statement& statement, bool holds, const Field& proof,
                  const std::string& by);  // equal growth, formula, class

/// How the lengths of a D0L system grow: "zero", "bounded", "polynomial" or "exponential", and the degree.
struct Growth {
    std::string name;
    std::size_t degree = 0;
};
Growth growth_of(const System& system);

/// Checks that a language is infinite.
void check_infinite(const Checking& with, const Language& language, const Field& proof,
                    const std::string& by);
/// Checks that two D0L systems have the same sequence, by the automaton of overflows in the proof.
void check_balance(const Checking& with, const System& left, const System& right,
                   const Field& proof);
/// Checks that two D0L systems generate the same language, by the sections of their sequences in the proof.
void check_sections(const Checking& with, const System& left, const System& right,
                    const Field& proof);
/// Throws Flaw if a system occurs in the expression whose language is not finite.
void check_regular(const Checking& with, const Language& language, const Field& proof);

/// Checks by induction on the length that a regular language is within that of a system.
void check_induction(const Checking& with, const Language& left, const Language& right,
                     const Field& proof);

/// The proof is of no kind that shows such a statement: throws Flaw.
[[noreturn]] void wrong_kind(const Field& proof, const std::string& by);

/// Checks a derivation from one word to the other: the fields `words` and `tables` of a proof.
void check_steps(const Checking& with, const System& system, const Word& from, const Word& to,
                 const Field& field);

/// A statement, or its opposite, on one line. Long expressions are shortened in the middle.
std::string statement_text(const Statement& statement, bool refuted, const Alphabet& alphabet);

}  // namespace algae::verify
