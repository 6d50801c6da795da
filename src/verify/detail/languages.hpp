#pragma once

#include <compare>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "exact/exact.hpp"
#include "verify/verify.hpp"

namespace algae::verify {

class BooleanMatrix;

/// Regular expressions with complement, intersection, images and inverse images, each known by a number,
/// and their derivatives (Brzozowski 1964): the derivative by a letter is the set of words that may follow it.
class Derivatives {
public:
    using Term = std::size_t;

    /// Both must outlive this.
    Derivatives(const Alphabet& alphabet, const Budget& budget);

    /// The expression, in which all systems must have finite languages: throws BoundReached if that
    /// cannot be shown.
    Term term(const Language& language) { return convert(*language, false); }

    /// Whether the language has the empty word.
    bool nullable(Term term);
    Term derivative(Term term, Symbol letter);
    Term derivative(Term term, const Word& word);
    /// Whether every word of the left language is in the right one, computed by comparing all reachable
    /// derivatives of both.
    bool included(Term left, Term right);
    bool equal(Term left, Term right);

    /// All derivatives of a term, itself first, and where each letter leads.
    struct Automaton {
        std::vector<char> accepting;
        std::vector<std::vector<std::size_t>> next;  // by state and symbol
    };
    Automaton automaton(Term term);

private:
    enum class Kind {
        none,
        empty_word,
        letter,
        product,
        star,
        any,
        all,
        complement,
        image,
        inverse_image
    };
    struct Node {
        Kind kind = Kind::none;
        std::size_t number = 0;  // of the letter or morphism
        std::vector<Term> parts;
        bool operator==(const Node&) const = default;
        bool operator<(const Node& other) const {
            return std::tie(kind, number, parts) < std::tie(other.kind, other.number, other.parts);
        }
    };
    using Morphism = std::map<Symbol, Word>;

    Term made(Node node);
    Term letter(Symbol a) { return made({Kind::letter, a, {}}); }
    Term product(Term left, Term right);
    Term star(Term part);
    Term any(std::vector<Term> parts);
    Term all(std::vector<Term> parts);
    Term combined(Kind kind, const std::vector<Term>& parts, Term neutral, Term absorbing);
    Term complement(Term part);
    Term word(const Word& word, Term rest);
    Term convert(const Tree& tree, bool reversed);
    Term convert_morphism(const Tree& tree, bool reversed);
    std::vector<Term> after_erased(Term part, std::size_t morphism);
    bool find_nullable(Term term);
    Term find_derivative(Term term, Symbol letter);

    const Alphabet& alphabet_;
    const Budget& budget_;
    std::vector<Node> nodes_;
    std::map<Node, Term> numbers_;
    std::vector<Morphism> morphisms_;
    std::map<Term, bool> nullable_;
    std::map<std::pair<Term, Symbol>, Term> derivatives_;
    Term none_ = 0, empty_word_ = 0;
};

/// Whether a word is in a language, by the definition of each operation: for an L(G) without context by
/// tables of which letters derive which factors of the word, until the tables repeat; with context by
/// deriving. Throws BoundReached if that takes more than the budget.
bool contains(const Language& language, const Word& word, const Alphabet& alphabet,
              const Budget& budget);

/// The image of a word under a morphism; nothing if a letter has none.
std::optional<Word> image_of(const Word& word, const std::map<Symbol, Word>& morphism,
                             const Budget& budget);

/// Whether all letters of the word are terminals of the system.
bool is_terminal(const System& system, const Word& word);

/// Whether the system derives a word, from here, in this number of steps, or in any. Terminals do not matter.
bool derives(const System& system, const Word& from, const Word& to,
             const std::optional<Integer>& steps, const Budget& budget);

/// Whether every word of the left language is in the right one, a regular expression. The left language is made of
/// languages of systems, powers and regular expressions by union, concatenation, star, plus, image, reversal, and intersection and difference
/// with regular expressions. Throws Error if it is something else, BoundReached if systems in the right one are not finite. The
/// words of a system in `invariants` are all that its automaton accepts.
using Invariants = std::map<const System*, Derivatives::Automaton>;
bool within_regular(const Language& left, const Language& right, const Alphabet& alphabet,
                    const Budget& budget, const Invariants& invariants = {});

// Languages of powers.

/// Whether the exponent depends on a number.
bool varies(const Powers::Block& block);

/// Whether every exponent is a sum of multiples of the numbers and a constant.
bool is_linear(const Powers& powers);

/// Whether the powers make this word for some values of the numbers.
bool has_word(const Powers& powers, const Word& word, const Budget& budget);

/// The same language as a regular expression: where exponents are linear and no number stands in two of them; otherwise
/// null.
Language regular_form(const Powers& powers);

/// The powers of the images of the words; nothing where a number stands in no exponent any more. Throws BoundReached if a
/// letter has no image.
std::optional<Powers> image_of_powers(const Powers& powers, const std::map<Symbol, Word>& morphism,
                                      const Budget& budget);

/// Between which of these states the words that the powers make lead, by what each letter does.
BooleanMatrix paths_of(const Powers& powers, const std::vector<BooleanMatrix>& letters,
                       std::size_t states, const Budget& budget);

/// The language in words, each word as `word_text` says it.
std::string powers_text(const Powers& powers,
                        const std::function<std::string(const Word&)>& word_text);

/// All words of a language, by the definition of each operation; nothing if it is infinite. Throws
/// BoundReached if that cannot be decided or takes more than the budget.
std::optional<std::set<Word>> finite_values(const Language& language, const Alphabet& alphabet,
                                            const Budget& budget);

/// The words of a finite set, or of a system with finitely many words; throws BoundReached if
/// they are not found within the budget.
std::vector<Word> finite_values_of_leaf(const Tree& leaf, const Budget& budget);

}  // namespace algae::verify
