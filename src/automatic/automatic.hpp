#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "exact/exact.hpp"
#include "growth/growth.hpp"
#include "system/system.hpp"
#include "word/word.hpp"

// automatic: first-order statements about the infinite word of a substitution, decided by automata.
//
// Positions are written in the numeration of Dumont and Thomas (Systemes de numeration et fonctions fractales relatifs aux substitutions,
// Theoretical Computer Science 65, 1989) of the substitution itself, in which the word is automatic whatever the substitution. Where addition
// is regular there too, the truth of statements with +, <, quantifiers and letters of the word is decidable (Buchi; Bruyere, Hansel,
// Michaux and Villemaire, Logic and p-recognizable sets of integers, 1994): each formula becomes an automaton that reads all its variables at
// once, greatest digits first. It is regular where the lengths of the images follow a recurrence whose polynomial is X^k times the minimal
// polynomial of a Pisot number (Carton, Couvreur, Delacourt and Ollinger, Linear recurrence sequence automata and the addition of abstract
// numeration systems, 2024). Each automaton of a linear equation is checked to give a sum to all numbers before it is used.

namespace algae {

/// The numeration of Dumont and Thomas of a substitution h with h(a) = a x: a number n is the path to the letter at position n of the
/// infinite word h^omega(a); the digit d under a letter b skips d letters of h(b) and goes down into the next one. States are letters, 0 is a.
class Numeration {
public:
    /// Of the infinite word that all words of the system from some one on begin: its first letter a is the one that the first letters of the
    /// words come to. Throws Error that names the condition where there is none: letters vanish, first letters go round in a
    /// circle, or the word does not grow.
    explicit Numeration(const D0L& system);

    /// The letters of the word, a first; states are their numbers here.
    const std::vector<Symbol>& letters() const { return letters_; }
    /// Digits are 0 up to one less: the length of the longest image.
    std::uint32_t base() const { return base_; }
    /// The letters of the image of a state, as states.
    const std::vector<std::uint32_t>& image(std::uint32_t state) const { return images_[state]; }

    /// The digits of a number, greatest first, without zeros before them; none of 0.
    ///
    /// Throws Error if n is negative. O(digits) of big-number steps.
    std::vector<std::uint32_t> digits(const Integer& n) const;
    /// The number of digits that are a path; nothing if they are none.
    std::optional<Integer> value(const std::vector<std::uint32_t>& digits) const;
    /// The state where the digits of a number end: the letter at that position.
    std::uint32_t state(const Integer& n) const;

private:
    const Integer& length(std::uint32_t state, std::size_t power) const;

    std::vector<Symbol> letters_;
    std::vector<std::vector<std::uint32_t>> images_;
    std::uint32_t base_ = 1;
    mutable std::vector<std::vector<Integer>>
        lengths_;  // of h^i of each state, as far as they were needed
};

/// A set of tuples of numbers whose digits, read all at once and greatest first, an automaton accepts. It is the minimal one among those without a
/// state from which nothing is accepted, so a transition may be missing; zeros before the digits change nothing. State 0 is the first one.
struct AutomaticRelation {
    struct Edge {
        std::uint32_t column;  // digit of variable i times base^i, summed
        std::uint32_t target;
        auto operator<=>(const Edge&) const = default;
    };
    std::vector<std::string> variables;  // in increasing order
    std::vector<std::uint32_t> first;    // edges of state s are first[s] up to first[s + 1]
    std::vector<Edge> edges;             // of each state by column
    std::vector<char> accepting;         // by state

    std::size_t states() const { return accepting.size(); }
    /// Whether no tuple is in it.
    bool empty() const;
    bool operator==(const AutomaticRelation&) const = default;
};

/// An infinite word under a letter-to-letter coding, and what the letters are called.
struct AutomaticWord {
    Numeration numeration;
    std::vector<std::string> letters;  // by state of the numeration: the name of its image
};

/// The word of a system; `coded` gives the name of what stands for a letter.
AutomaticWord automatic_word(const D0L& system, const std::function<std::string(Symbol)>& coded);

/// A first-order statement, read.
class FirstOrderStatement;
struct FirstOrderNode;

/// Reads a statement such as `for all i, n with n >= 1: not (for all k < n: T[i+k] = T[i+n+k])`.
///
/// Variables are numbers 0, 1, ...; terms are linear, with + - and multiples; `T[term]` is a letter of the word, compared with another or with the
/// name of a letter; comparisons may be chained. `for all x, y with CONDITION:` and `for some`, `there is`; `not`, `and`, `or`,
/// `implies`, `iff` in this order of binding; `equal(i, j, n)` says that the factors of n letters at i and at j are equal, and `palindrome(i, n)`
/// that the one at i is a palindrome. `word` is the name of the word, `letters` are those it may have. Throws Diagnostics.
FirstOrderStatement read_first_order(std::string_view text, const std::string& name,
                                     const std::string& word,
                                     const std::vector<std::string>& letters);

class FirstOrderStatement {
public:
    explicit FirstOrderStatement(std::shared_ptr<const FirstOrderNode> root)
        : root_(std::move(root)) {}
    const FirstOrderNode& root() const { return *root_; }
    /// The variables that no quantifier binds, in increasing order.
    const std::vector<std::string>& free() const { return free_; }

private:
    friend FirstOrderStatement read_first_order(std::string_view, const std::string&,
                                                const std::string&,
                                                const std::vector<std::string>&);
    std::shared_ptr<const FirstOrderNode> root_;
    std::vector<std::string> free_;
};

/// As certificates have it (CERTIFICATES.md): each quantifier binds names of its own.
nlohmann::ordered_json to_json(const FirstOrderStatement& statement);
/// Whether numbers are added in it.
bool adds(const FirstOrderStatement& statement);

/// What was decided.
struct FirstOrderAnswer {
    AutomaticRelation
        relation;        // over the free variables: all tuples for which the statement holds
    bool holds = false;  // where there are no free variables
    /// Of a statement that begins with `for some` and holds: numbers for which it does. Of one that begins with `for all` and does not hold: numbers
    /// for which it does not. With `not` before it the other way round. Those with the fewest digits.
    std::vector<std::pair<std::string, Integer>> witness;
    std::size_t largest = 0;  // states of the largest automaton on the way
};

/// Decides a statement about a word.
///
/// The time is not elementary in the number of changes of quantifiers, and mostly short. Throws Error where addition is not known to be regular in
/// the numeration of the word, BoundReached at the end of the time or memory.
FirstOrderAnswer decide_first_order(const FirstOrderStatement& statement, const AutomaticWord& word,
                                    const Budget& budget,
                                    const std::function<void(std::size_t states)>& progress = {});

/// A sequence of integers by matrices: the value at n is begin times the matrices of the digits of n, greatest first, times end. Digits that are
/// no path give anything.
struct LinearRepresentation {
    std::vector<Integer> begin, end;
    std::vector<std::vector<std::vector<Integer>>> matrices;  // by digit, row, column

    std::size_t size() const { return begin.size(); }
    /// The value at n. O(digits size^2) big-number steps.
    Integer value(const Numeration& numeration, const Integer& n) const;
};

/// How many numbers make a tuple with n, for each n: of a relation of two variables, of which `n` names one. For each n there have to
/// be finitely many. Throws Error otherwise, or if the relation has other variables.
LinearRepresentation counts(const AutomaticRelation& relation, const std::string& n,
                            const Numeration& numeration);

/// That numbers of places in an infinite word are in a linear relation: for all n from some one on, the sum of so many times the number of
/// i for which a statement about i and n holds, plus slope n + constant, is 0.
struct CountingStatement {
    struct Part {
        Integer times;
        FirstOrderStatement places;  // no other variables than i and n are free
    };
    std::vector<Part> parts;
    Integer slope = 0, constant = 0, from = 0;
};

/// As certificates have it, without the word.
nlohmann::ordered_json to_json(const CountingStatement& statement);

struct CountingAnswer {
    std::optional<Integer> fails;  // for this n, if it does not hold
    Integer sum = 0;               // what is not 0 then
    std::size_t size = 0;          // rows of the matrices
};

/// Decides a statement about numbers of places.
///
/// Each number is a product of matrices, one for each digit of n (Charlier, Rampersad and Shallit, Enumeration and decidable properties of automatic
/// sequences, 2012); a sum of such products is 0 for all n if it is where the products span what all of them do (Schutzenberger 1961).
/// Throws as `decide_first_order`, and Error where infinitely many places belong to some n.
CountingAnswer decide_counting(const CountingStatement& statement, const AutomaticWord& word,
                               const Budget& budget);

/// What is proved of a sequence of numbers, for all n.
struct ComplexityProof {
    LinearRepresentation sequence;
    /// For n >= from: slope n + constant.
    struct Linear {
        Integer slope, constant, from;
    };
    std::optional<Linear> linear;
    /// For n >= from: values[n mod period].
    struct Periodic {
        std::vector<Integer> values;
        Integer from;
    };
    std::optional<Periodic> periodic;
    /// The values that a(n + 1) - a(n) takes, if they are finitely many.
    std::vector<Integer> differences;
};

/// Of the numbers of different factors of n letters, and of palindromes among them.
struct ComplexityProofs {
    ComplexityProof factors, palindromes;
};

/// The complexities of the word. Throws as `decide_first_order`.
///
/// The factors of n letters are counted where they occur first (Charlier, Rampersad and Shallit, Enumeration and decidable properties of automatic
/// sequences, 2012).
ComplexityProofs complexity_proofs(const AutomaticWord& word, const Budget& budget);

/// The least upper bound of the exponents of the factors of an infinite word; that of a factor is its length by its least period.
struct CriticalExponent {
    /// Some word has all its powers among the factors; then nothing else is here.
    bool infinite = false;
    std::optional<Frequency> value;  // in the field of the rate of the lengths
    bool attained = false;
    std::optional<std::pair<Integer, Integer>>
        factor;  // length and period of a shortest one, if it is attained
    /// The limit superior of the exponents as periods grow, if it was found.
    std::optional<Frequency> asymptotic;
};

/// By the greatest length of a factor with period p, an automaton for all p, and limits along its paths. Throws as `decide_first_order`, and
/// BoundReached where too many repetitions have nearly the greatest exponent.
///
/// Example: critical_exponent(automatic_word(d0l("a", {{'a', "ab"}, {'b', "a"}}), [](Symbol a) { return std::to_string(a); }), Budget()).value->exact() == "(5+sqrt(5))/2"
CriticalExponent critical_exponent(const AutomaticWord& word, const Budget& budget);

/// The same of the infinite word of a morphism, without automata and whatever its numeration: by repetitions of the words derived by returns, which
/// repeat for primitive morphisms (`greatest_repetitions`). Whether it is infinite is decided first, for every word. Throws Error if the word is none or its first letter does not come back in it, and
/// BoundReached where the derived words get too many or too large, or where roots of equal size decide.
///
/// Example: critical_exponent(d0l("a", {{'a', "aab"}, {'b', "a"}}), Budget()).value->exact() == "3+sqrt(2)"
CriticalExponent critical_exponent(const D0L& system, const Budget& budget);

/// A property of infinite words, and the statement that says it of T.
struct WordProperty {
    std::string_view name, says;
};
/// square-free, overlap-free, cube-free, aperiodic, recurrent, uniformly recurrent, closed under reversal, rich.
std::span<const WordProperty> word_properties();
/// Whether the word has the property of this name. Throws Error if there is none, and as `decide_first_order`.
///
/// Example: has_property(automatic_word(d0l("a", {{'a', "ab"}, {'b', "a"}}), [](Symbol a) { return std::to_string(a); }), "cube-free", Budget()) == false
bool has_property(const AutomaticWord& word, std::string_view name, const Budget& budget);

/// How far apart equal factors of an infinite word are.
struct FactorRecurrence {
    /// R(0), R(1), ...: every factor of R(n) letters has all factors of n letters, and R(n) is least. Only as far as they were found.
    std::vector<std::uint64_t> values;
    /// Of each letter, in the order of names, the words from one occurrence to before the next, shorter ones first; none if R(1) was not found.
    std::vector<std::pair<std::string, std::vector<std::vector<std::string>>>> return_words;
};

/// By a beginning of the word that holds all its factors of R(n) + 1 letters, at most two million letters long: where
/// letters do not grow, or factors do not come back within bounded distance, the values end. Throws BoundReached at the end of the time.
///
/// Example: factor_recurrence(automatic_word(d0l("a", {{'a', "ab"}, {'b', "a"}}), [](Symbol a) { return std::to_string(a); }), 3, Budget()).values == std::vector<std::uint64_t>{0, 3, 6, 10}
FactorRecurrence factor_recurrence(const AutomaticWord& word, std::size_t to, const Budget& budget);

/// Whether a tuple, numbers from 0 on in the order of the variables, is in a relation. O(digits).
bool contains(const AutomaticRelation& relation, const Numeration& numeration,
              const std::vector<Integer>& numbers);

/// The tuples of a relation with numbers of at most so many digits, at most `most` of them, in order of length, then of digits.
std::vector<std::vector<Integer>> members(const AutomaticRelation& relation,
                                          const Numeration& numeration, std::size_t most);

}  // namespace algae
