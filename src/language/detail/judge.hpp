#pragma once

// What the judges of statements share: the words of finite expressions, automata of regular ones, systems that
// constructions make, systems and words as certificates write them; and the judges themselves, one for each
// kind of statement.

#include <map>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "exact/exact.hpp"
#include "language/detail/letters.hpp"
#include "language/detail/proof.hpp"
#include "language/detail/regular.hpp"
#include "language/language.hpp"
#include "system/system.hpp"

namespace algae {

// --- What is known of a language ---

/// All words of a language, and what was worked out on the way.
struct FiniteValue {
    std::vector<Word> words;  // shorter ones first, then by symbol numbers
    std::vector<Part> known;  // how
};

/// The words of a language that is found to be finite and has at most 100,000 words: finite sets, finite
/// languages of systems, what operations make of these, and what intersection and difference leave of a
/// finite set, word by word. Nothing if it is not found to be finite, or a word could not be decided.
/// Throws what budget.check throws, BoundReached where a table is too large.
std::optional<FiniteValue> finite_value(const Language& language, const Alphabet& alphabet,
                                        const Budget& budget = {});

/// The minimal automaton of an expression whose parts are regular: finite sets, finite languages of systems,
/// and all operations on them. Nothing if a part is an infinite language of a system.
std::optional<RegularLanguage> regular_value(const Language& language, const Alphabet& alphabet,
                                             const Budget& budget = {});

/// What the operation of an expression makes of the automata of its parts.
RegularLanguage operated(const LanguageTree& operation, const std::vector<RegularLanguage>& parts,
                         const Budget& budget = {});

/// Whether a system occurs in the expression.
bool has_system(const Language& language);

/// Of a language of a system without context, that system; of operations under which E0L or ET0L languages are
/// closed, the system that the construction makes: with one table as long as the parts have one
/// and the operation keeps it, or with deterministic tables if that is asked for. Nothing where some part is
/// not known to be one. Throws what the constructions throw.
std::optional<TableValue> table_value(const Language& language, const Alphabet& alphabet,
                                      const Budget& budget = {}, bool deterministic = false);

/// What a meeting that there is none of repeats.
Repeated repeated(const Meeting& meeting, const ET0L& system);

// --- Systems, languages and statements as a certificate writes them (CERTIFICATES.md) ---

nlohmann::ordered_json to_json(const ET0L& system, const Alphabet& alphabet,
                               const Word& other = {});

/// With the rules for `other` letters too, and those derived from them.
nlohmann::ordered_json to_json(const SourceSystem& system, const Alphabet& alphabet,
                               const Word& other = {});

nlohmann::ordered_json to_json(const Language& language, const Alphabet& alphabet);
nlohmann::ordered_json to_json(const Statement& statement, const Alphabet& alphabet);

/// The axiom and the rules of a system whose words are derived module by module; constants are in them as numbers.
nlohmann::ordered_json to_json(const LSystem& system);

// --- Languages and systems in sentences ---

/// The expression that a name stands for.
std::string unnamed_text(const Language& language, const Alphabet& alphabet);

/// A system as sentences speak of it: "the 0L system with axiom a; a -> ab | ε".
std::string system_text(const SourceSystem& system, const Alphabet& alphabet);

/// A system whose words are derived module by module as sentences speak of it: "the parametric D0L system
/// with axiom A(1); A(x) : x < 3 -> A(x+1)", constants behind.
std::string rewriting_text(const LSystem& system);

// --- Judges of languages ---

/// Whether a system derives the word as a word of its language. Tables are followed exactly. A system with
/// context is derived until its words repeat or, where no rule erases, are longer than the word; the answer is
/// undecided where neither happens within a bound, which is a small one unless the search is to be `thorough`.
Answer judge_generated(const SourceSystem& system, const Word& word, const Alphabet& alphabet,
                       const Budget& budget = {}, bool thorough = true);

/// Whether the word is in the language, by the definition of each operation: of a star all ways to cut the
/// word, of an image all words with this image. Complete where the parts can be decided: undecided are
/// words that a system with context neither derives nor is seen to leave out within a bound, and images
/// under morphisms that erase letters of languages that are neither regular nor of L-systems without
/// context. What systems with context do not decide an invariant may, if the search is to be `thorough`; it is not where many words
/// are asked for.
///
/// Throws what budget.check throws, BoundReached where a table is too large.
Answer judge_membership(const Language& language, const Word& word, const Alphabet& alphabet,
                        const Budget& budget = {}, bool thorough = true);

// What languages have in common with others. Decided where both sides are finite or regular, where the left
// side of an inclusion is a language of a system without context (or made of such by operations under which
// these are closed) and the right side regular, where both are languages of D0L systems (of an
// inclusion: where sections of the sequences show it); otherwise a difference
// is looked for among short words and first generations, and a proof of a regular side within L(G) by induction
// on the length. Both throw what budget.check throws, BoundReached where a table is too large.

/// Whether every word of the first is in the second.
Answer judge_inclusion(const Language& inner, const Language& outer, const Alphabet& alphabet,
                       const Budget& budget = {});

/// Whether they have the same words.
Answer judge_equality(const Language& left, const Language& right, const Alphabet& alphabet,
                      const Budget& budget = {});

/// Whether an infinite regular language is of a family of L-systems without context and without nonterminals: proved by a small
/// system, refuted by what the successors of letters may be (regular_family.cpp); undecided where neither is found. Throws
/// BoundReached if the words make too many classes, and what budget.check throws.
Answer judge_regular_family(const Language& language, const RegularLanguage& value,
                            const FamilyQuestion& question, const Alphabet& alphabet,
                            const Budget& budget = {});

/// Whether no word is a product of words of the language in two ways; `prefix`: nor does one of its words begin with
/// another. Decided for regular languages. Throws what budget.check throws.
Answer judge_code(const Language& language, bool prefix, const Alphabet& alphabet,
                  const Budget& budget = {});

/// Whether the word read backwards is the same.
Answer judge_palindrome(const Word& word);

/// Languages without systems that a language of a system is likely to be, which is not proved: of a linear system a regular
/// expression, of a D0L system whose lengths grow linearly one, or powers.
std::vector<Language> likely_forms(const Language& generated, const Budget& budget = {});

// --- Judges of systems ---

// What statements say of systems themselves. All throw what budget.check throws and BoundReached; Error if
// the statement cannot be about a system of this class.

/// Whether the system derives the word: from a word or its axiom, in so many steps or any number of them. For a
/// system without context decided by the table of factors, for one with context by deriving.
Answer judge_derivation(const Derives& said, const Alphabet& alphabet, const Budget& budget = {});

/// Whether two D0L systems have the same word in every generation.
Answer judge_sequences(const SourceSystem& left, const SourceSystem& right,
                       const Budget& budget = {});

/// Whether two D0L systems have words of the same length in every generation.
Answer judge_growth(const SourceSystem& left, const SourceSystem& right, const Budget& budget = {});

/// Whether the growth of a D0L system is of this class: zero, bounded, polynomial (of this degree), exponential.
Answer judge_growth_class(const HasGrowthClass& said, const Budget& budget = {});

/// Whether the lengths of a D0L system never fall, or always rise. Decided where no letter is erased, by the sets of letters of
/// the generations until one comes again; otherwise a fall is looked for among the first 1000 lengths.
Answer judge_increasing(const IsIncreasing& said, const Budget& budget = {});

/// How many different segments the turtle draws in generation n, and how many squares of a side of so many steps, each with its
/// left and lower edge and without the others, these segments meet: of the grid that has the start of the turtle as a corner. Exact.
/// Both throw Error as check_lattice_turtle does, and where brackets do not match; BoundReached beyond a million segments or squares.
Integer distinct_segments(const Model& system, std::uint64_t n, const Budget& budget = {});
Integer met_boxes(const Model& system, std::uint64_t n, const Rational& side,
                  const Budget& budget = {});

/// What each letter tells the turtle of such a system, and how it turns, as a certificate has it.
nlohmann::ordered_json turtle_certificate(const Model& system);
/// Whether that can be written: a D0L system whose turtle turns by parts of a full turn and does nothing else than segments
/// and branches.
bool has_lattice_turtle(const Model& system);

/// Whether a comparison of numbers holds, in which no number is bound; exactly.
Answer judge_numbers(const ComparesNumbers& said, const Budget& budget = {});

/// Whether a comparison of words holds, in which no number is bound. Throws BoundReached if they have more than budget.letters
/// letters.
Answer judge_words(const ComparesWords& said, const Alphabet& alphabet, const Budget& budget = {});

/// Whether a comparison of numbers, or of words, holds for all values of bound numbers, or for some; nothing if no method
/// decides it, or it is another statement. Equations of numbers are always decided.
std::optional<Answer> judge_all_numbers(const Quantified& said, const Claim& claim,
                                        const Budget& budget);
std::optional<Answer> judge_all_words(const Quantified& said, const Claim& claim,
                                      const Budget& budget);

/// The answer by these values of the bound numbers, by name, of which the opposite of a statement for all numbers is true.
Answer by_values(const Quantified& said, const std::map<std::string, Integer>& point,
                 const Claim& claim, const Budget& budget);

/// a and b, if the term is a n + b, n being `name`.
std::optional<std::pair<Rational, Rational>> slope_and_start(const Expression& term,
                                                             const std::string& name);

/// By name how often each bound number is taken in a term that is a sum of whole multiples of them; the constant goes by "1".
std::optional<std::map<std::string, std::int64_t>> integral_slopes(const Expression& term);

/// The least value of the only bound number, if its conditions say no more than that.
std::optional<std::uint64_t> least_value(const Quantified& said);

/// The system as a D0L system. Throws Error that names it if it is not one.
D0L as_d0l(const SourceSystem& system);

/// Whether a system with parameters, probabilities or contexts of trees derives a word of modules in so
/// many steps: by deriving; where there are probabilities, whether the word has one above 0. Parameters
/// are numbers as Program computes them, and the same only where all their digits are. Throws what
/// Rewriting::next throws.
Answer judge_rewriting(const Rewrites& said, const Budget& budget = {});

/// Whether the word has exactly this probability in that generation (see distribution). Throws the same.
Answer judge_chance(const HasChance& said, const Budget& budget = {});

/// Whether the limit set that the system draws has this dimension, or one at most as large: by
/// `exact_dimension`, and exactly. Where the rules give an upper bound only, nothing below it is said
/// to be the dimension, nor that it is one. Undecided with the reasons where the rules give no
/// formula, and where two logarithms agree in 200 digits but no proof of their equality was found.
Answer judge_dimension(const HasDimension& claimed, const Budget& budget = {});

/// Whether what the rules say of the dimension is more than that of the plane.
bool exceeds_plane(const ExactDimension& found);

/// The same of the boundary of a limit set with interior points.
Answer judge_boundary(const BoundaryHasDimension& claimed, const Budget& budget = {});

/// Whether a first-order statement holds in the infinite word of a D0L system, by automata. Undecided where addition is not
/// regular in its numeration; throws Error where there is no such word.
Answer judge_counts(const CountsInWord& said, const Alphabet& alphabet, const Budget& budget);
Answer judge_infinite_word(const HoldsInWord& said, const Alphabet& alphabet,
                           const Budget& budget = {});

/// Whether numbers that stand in an order are as a comparison says.
bool is_so(Comparison comparison, std::strong_ordering order);

/// How the critical exponent of an infinite word compares with a number. Throws Error where there is no such word.
Answer judge_critical_exponent(const HasCriticalExponent& said, const Alphabet& alphabet,
                               const Budget& budget);

/// Whether a D0L system is circular. Undecided where its morphism is not injective and short windows do not show it.
Answer judge_circular(const IsCircular& said, const Budget& budget);

// --- Judges of statements made of others ---

/// `decide` for a part of a statement, of an instance for example: it is undecided where a bound of steps or memory is
/// reached, but where the time is over the whole is, so that no result depends on the speed of the machine.
Answer decide_part(const Statement& statement, const Claim& claim, const Budget& budget,
                   const SearchLimits& limits);

/// Whether the statement holds for all values, or for some: by the first instance that decides it, or by all of them
/// where the bounds leave finitely many. Throws what budget.check throws.
Answer judge_quantified(const Quantified& said, const Claim& claim, const Budget& budget,
                        const SearchLimits& limits);

/// The proof of a statement about all languages that needs no instance; nothing if none is known.
std::optional<Answer> judge_symbolic(const Quantified& said, const Claim& claim,
                                     const Budget& budget);

/// What follows of given derivations of one system without tables: that another derivation is one, that a word is not longer
/// than what it derives, or that it derives one word only; nothing if no proof by a few rules is found.
std::optional<Answer> judge_derivations(const Quantified& said, const Claim& claim,
                                        const Budget& budget);

/// Whether a statement is true of all values whose body is several joined by `and`, each on its own by a method that needs no
/// instances; nothing if one of them is not decided so.
std::optional<Answer> judge_each(const Quantified& said, const Claim& claim, const Budget& budget);

// --- Instances of bound names ---

/// What the bound names range over.
Tuple tuple_of(const Quantified& said);

/// The values of an instance, whose letter i is called letters[i].
std::vector<BoundValue> values_of(const Instance& instance, const Quantified& said,
                                  const Claim& claim, const std::vector<Symbol>& letters);

/// The statement with values in the place of bound names. Throws Error if a morphism has no image for a letter of the
/// language that it is applied to.
Statement with_values(const Statement& statement, const std::vector<BoundValue>& values);

/// Several statements as one, in three-valued logic.
Answer judge_joint(const Joint& said, const Claim& claim, const Budget& budget,
                   const SearchLimits& limits);

}  // namespace algae
