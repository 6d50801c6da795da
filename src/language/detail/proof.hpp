#pragma once

// How it is known that a statement is true or false: a tree of named steps, whose parts are the proofs that a step
// rests on.
//
// The judges make proofs and write no text. A proof has three readers: sentences (sentences.cpp), the certificate
// (certificate.cpp) and LaTeX (latex.cpp). A new kind of step is a new alternative of `Proof`; the compiler lists
// the readers that miss it. A step whose certificate is the name of a rule and nothing else says that name in
// `rule` (CERTIFICATES.md lists the rules).

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "automatic/automatic.hpp"
#include "exact/exact.hpp"
#include "growth/growth.hpp"
#include "language/detail/powers.hpp"
#include "language/detail/progressions.hpp"
#include "language/language.hpp"
#include "system/system.hpp"

namespace algae {

struct DimensionBounds;

struct Dfa;
struct ExactDimension;
struct FamilyAnswer;

/// A proof within a proof.
using Part = std::shared_ptr<const Proof>;

/// An ET0L system for the language of an expression, and the operations that it is constructed by.
struct TableValue {
    ET0L system;
    Language language;
    std::vector<std::string> operations;
};

/// What the letters derive in `step` steps is what they derive in `earlier` steps; by several tables, in
/// fewer.
struct Repeated {
    std::uint64_t step = 0, earlier = 0;
    bool one_table = true;
};

/// What stands in the place of a bound name: a language, a system, a morphism, a finite substitution, a word (a letter is
/// one) or a number.
struct BoundValue {
    std::size_t variable = 0;
    std::string name;
    std::optional<Symbol> letter;  // by which it stands in texts
    std::variant<Language, std::shared_ptr<const SourceSystem>, Morphism,
                 std::vector<std::pair<Symbol, std::vector<Word>>>, Word, Integer>
        is;
};

namespace steps {

// --- The words of finite languages ---

/// The language has these words; of more than `most_shown` only how many.
struct Value {
    static constexpr const char* rule = "values";
    static constexpr std::size_t most_shown = 40;
    Language language;
    std::vector<Word> words;
    std::size_t count = 0;
};

/// Which words of a finite language are in another one, word by word.
struct Sifted {
    static constexpr const char* rule = "values";
    static constexpr std::size_t most_shown = 40;  // sentences, so of no more words is a proof kept
    std::vector<Part> members;
};

// --- Words and languages ---

/// The word is one of a finite set or not; or it is the empty word, in a star.
struct Listed {
    static constexpr const char* rule = "membership";
    Language language;
    Word word;
    bool in = false;
};

/// The derivation ends with the word, so it is in L(G).
struct Generated {
    std::string system;
    Derivation derivation;
};

struct NotGenerated {
    static constexpr const char* rule = "membership";
    std::string system;
    Word word;
    Membership why;
};

/// The word is cut at `ends` into words of the parts of a concatenation, star or plus.
struct Factored {
    static constexpr const char* rule = "membership";
    Language language;
    Word word;
    std::vector<std::size_t> ends;
};

/// It cannot be cut so.
struct NotFactored {
    static constexpr const char* rule = "membership";
    Language language;
    Word word;
};

/// The word is the image of `source`, which is in the part of an image.
struct HasPreimage {
    Language language;
    Word word, source;
};

struct HasNoPreimage {
    static constexpr const char* rule = "membership";
    Language language;
    Word word;
};

/// The word has the powers of the language for these values of its numbers; nothing: for none.
struct OfPowers {
    static constexpr const char* rule = "membership";
    Language language;
    Word word;
    std::optional<std::vector<std::uint64_t>> values;
};

/// A complement is over other letters.
struct OtherLetters {
    std::vector<Symbol> letters;  // of the complement
    static constexpr const char* rule = "membership";
    Symbol letter = 0;
};

/// A letter of the word has no image.
struct HasNoImage {
    static constexpr const char* rule = "membership";
    Word word;
};

/// Whether the word is in the language follows from whether it, or its image, is in the parts.
struct FromParts {
    Language language;
    Word word;
    bool in = false;
    std::vector<Part> parts;
    std::optional<Word> image = {};  // of an inverse image
};

// --- Derivations ---

/// The system derives the last word of the derivation from the first.
struct Derives {
    std::string system;
    Derivation derivation;
    bool with_context = false;
};

/// It does not derive the word: in so many steps, or any number of them.
struct DerivesNot {
    static constexpr const char* rule = "exhausted";
    std::string system;
    Word from, word;
    std::optional<std::uint64_t> steps = {};
    std::optional<Word> reached = {};  // the one word that it derives
    bool with_context = false;
    bool several_tables = false;
};

/// The word is in the language of the system or not, so the system derives it or does not.
struct InSomeStep {
    Part membership;
};

/// A system derives one word of modules in so many steps. The words are written as modules.
struct Rewrites {
    static constexpr const char* rule = "rewriting";
    std::string system;
    std::uint64_t steps = 0;
    std::vector<std::string> words;  // the first and the last, and all between unless they are long
    bool all_shown = false;
    bool holds = false;  // the last is the word of the statement
};

/// The same of an open system, whose communication modules its environments fill.
struct Develops {
    static constexpr const char* rule = "environment";
    std::string system;
    std::vector<std::string> words;
    bool holds = false;
};

/// A system with probabilities derives `to` with this one, of so many words.
struct Likely {
    static constexpr const char* rule = "rewriting";
    std::string system, from, to;
    std::uint64_t steps = 0;
    std::size_t words = 0;
    Rational probability;
};

// --- Sequences, growth and dimension ---

struct SameSequence {
    std::string left, right;
    Balance balance;
};

struct OtherSequence {
    std::string left, right;
    SequenceDifference difference;
};

/// So many first lengths are the same.
struct SameGrowth {
    static constexpr const char* rule = "terms";
    std::uint64_t bound = 0;
};

struct OtherGrowth {
    GrowthComparison::Difference difference;
};

/// The first `terms` lengths are the values of the function, and no recurrence of either is longer.
/// Both sides of a comparison of numbers, worked out.
struct ComparedNumbers {
    static constexpr const char* rule = "values";
    ComparesNumbers said;
    std::string left, right;  // the numbers
};

/// The difference of both sides has these orders in the bound numbers, and is 0 at so many points that it is 0 everywhere.
struct ByRecurrences {
    std::vector<std::pair<std::string, std::uint64_t>> orders;
    std::uint64_t points = 0;
};

/// The difference u of both sides, from the least value of the number on, is never negative, or always positive: of its first
/// `from` terms that was looked up; behind them it is true of the last of the sequences u_i(n) = u_{i-1}(n+1) - c_i
/// u_{i-1}(n), c_i being the roots, by a recurrence without negative coefficients, and of the first term of each.
struct StaysPositive {
    std::uint64_t order = 0, from = 0;
    bool left_is_larger = false, strictly = false;
    std::vector<Rational> roots, recurrence;
};

struct Grows {
    static constexpr const char* rule = "components";
    std::string system;
    GrowthOrder order;
};

/// No letter is erased, so no length falls; strictly: each of so many sets of letters that occur together has one with a
/// longer successor.
struct Rises {
    static constexpr const char* rule = "letters";
    std::string system;
    bool strictly = false;
    std::size_t sets = 0;
};

/// No length falls (strictly: all rise) up to a generation, which has no letter more often than the next one has; so it is for ever.
/// Strictly: the next one has more of a letter whose descendants never vanish.
struct RisesByLetters {
    static constexpr const char* rule = "vectors";
    std::string system;
    bool strictly = false;
    std::uint64_t generation = 0;
};

/// A first-order statement about the infinite word of a system, by automata.
struct ByAutomata {
    std::string system;
    bool holds = false;
    std::vector<std::pair<std::string, Integer>> witness;  // or a counterexample
    std::size_t largest = 0;                               // states of the largest automaton
    std::uint32_t base = 1;                                // of the digits
    AutomaticRelation addition;  // x + y = z; without edges where it is not known
    std::size_t rows = 0;        // of the matrices, where places are counted
};

/// The number of factors of n letters of the infinite word of a system, by its bispecial factors: they make p(n) linear.
struct ByBispecialFactors {
    std::string system;
    std::size_t letters = 0;
    std::vector<std::pair<Integer, std::int64_t>>
        sums;                       // p(n+2) - 2 p(n+1) + p(n) where it is not 0
    Integer slope, constant, from;  // p(n) = slope n + constant for n >= from
};

/// The critical exponent of the infinite word of a system, by the repetitions of the words that are derived of it by returns.
struct ByRepetitions {
    static constexpr const char* rule = "repetitions";
    std::string system;
    ClaimedNumber exponent;
    std::optional<std::pair<Integer, Integer>> factor;  // length and period, if one has it
};

/// The critical exponent is infinite and, if the morphism maps different letters to different words, the system is not circular: all powers
/// of a word are factors, for an image of it under a power of the morphism is a power of a conjugate of it.
struct RepeatsForEver {
    static constexpr const char* rule = "repetition";
    std::string system;
    Word word;  // empty where its letters do not grow
    std::uint64_t power = 1;
};

/// All factors of more than `delay` letters have a place where each word whose image they stand in is cut.
struct Synchronised {
    static constexpr const char* rule = "windows";
    std::string system;
    std::size_t delay = 0;
};

struct Falls {
    std::string system;
    std::uint64_t generation = 0;
    Integer before, after;
    bool strictly = false;
};

struct ComparedWords {
    static constexpr const char* rule = "words";
    std::string left, right;  // the words, or their lengths where they are long
};

/// The morphism takes both sides of a comparison of words to the next ones, and it is true for the first number.
struct ByMorphism {
    Morphism step;
    std::uint64_t first = 0;
};

/// How what the rules say of the dimension, or of that of the boundary, compares with the claimed number.
struct LimitSet {
    std::string system;
    std::shared_ptr<const ExactDimension> found;
    bool boundary = false;
    bool has_turtle = false;  // that a certificate can tell
    ClaimedDimension claimed;
    Order order = Order::unknown;
    std::shared_ptr<const DimensionBounds> bounds = {};  // where they decide
    std::shared_ptr<const Model> model =
        {};  // whose letters those of `found` are; a certificate names them
};

// --- Equality and inclusion ---

/// Both sides are the same expression.
struct Identical {
    static constexpr const char* rule = "identical";
};

/// Both sides have the same finitely many words.
struct SameValues {
    static constexpr const char* rule = "values";
    std::vector<Part> left, right;
};

/// Each word of the finite left side is in the right one.
struct ValuesWithin {
    static constexpr const char* rule = "values";
    static constexpr std::size_t most_shown = 40;
    std::vector<Part> left, members;
};

/// A word of one finite side only.
struct OtherValues {
    std::vector<Part> left, right;
    Word word;
};

/// The minimal automata are the same, with so many states.
struct SameAutomata {
    static constexpr const char* rule = "derivatives";
    std::size_t states = 0;
};

/// The automaton of the left side without the right one accepts nothing.
struct NothingOutside {
    static constexpr const char* rule = "derivatives";
    Language left, right;
};

/// The word is in one of the languages only.
struct Distinguished {
    Word word;
    Answer in_left, in_right;
};

struct SameDeterministic {
    LanguageEquality equality;
};

/// Of two D0L systems: each word of the left language is one of the right one, by words and sections of the sequences.
struct WithinDeterministic {
    Language left, right;
    std::vector<std::pair<std::uint64_t, std::uint64_t>> words;
    std::vector<SectionMatch> sections;
};

/// L(G) of a D0L system is regular, and its minimal automaton that of `other`: from generation `first` on, what a word has more
/// than that of `period` generations before is one factor, at one place, again and again.
struct SameProgressions {
    Language language, other;
    std::uint64_t first = 0, period = 1;
};

/// No generation of a system for the left side leaves the regular right side.
struct WithinRegular {
    static constexpr const char* rule = "relations";
    Language left, right;
    Repeated letters;
    std::shared_ptr<const TableValue>
        constructed;  // unless the left side is L(G), and the right without systems
};

/// The words of the base are in L(G); each other word of the left side comes in one step from a shorter one, or from one with
/// fewer of the letters `counted`.
struct ByInduction {
    Language left;
    std::vector<Word> base;
    std::vector<Answer> members;
    std::vector<Symbol> counted;  // none: all letters
    // Over one letter: shorter words of the left side, one by one up to this length, and by which tables beyond (LengthInduction).
    std::optional<std::size_t> from = {};
    std::vector<std::size_t> tables = {};
};

/// All rules of the system of the left side are rules of that of the right one, which derives the axiom of the left one, perhaps in no step.
struct ByRules {
    static constexpr const char* rule = "rules";
    Language left, right;
};

/// Both are the same sequence of words, which is written with powers that depend on n; `system`: one side is L(G) of this
/// D0L system, whose word number n is that of the sequence by induction.
struct SamePowers {
    static constexpr const char* rule = "powers";
    Language left, right;
    std::string sequence, system;
};

/// Each automaton accepts the axiom of its system with context and what every word that it accepts may become in one step, so all
/// words of L(G). With the automata in the place of their systems no word of the left side is outside the right one: each is in
/// `right`, or none is `word`, or there is none.
struct Invariant {
    struct Closed {
        std::shared_ptr<const SourceSystem> system;
        std::shared_ptr<const Dfa> automaton;
    };
    Language left, right;
    std::optional<Word> word;
    std::vector<Closed> closed;
};

struct BothInclusions {
    Part there, back;
};

/// In each word of the systems at most one letter is not constant, the first or the last one, so their languages are regular.
struct LinearSystems {
    static constexpr const char* rule = "linear";
    Language left, right;
    bool equal = false;  // otherwise left <= right
};

/// The statement with equal languages in the place of others.
struct ByFacts {
    struct Fact {
        Language language, equal;
        bool is_right = false;  // in the equality that is proved, `language` is the right side
        Part proof;
    };
    std::vector<Fact> facts;
    Part proof;
};

// --- Finite, empty, size ---

/// The language has so many words: they are listed, or its automaton accepts so many.
struct Counted {
    static constexpr const char* rule = "values";
    std::vector<Part> known;
    Language language;
    Integer count;
    bool by_automaton = false;
};

struct NoWord {
    static constexpr const char* rule = "values";
    std::vector<Part> known;
    Language language;
    bool by_automaton = false;
};

/// The constructed system has a finite language.
struct FiniteConstruction {
    static constexpr const char* rule = "values";
    TableValue tables;
};

/// The language has this word; the derivation ends with it.
struct FoundWord {
    Language language;
    Word word;
    std::optional<Derivation> derivation = {};
};

/// No word of L(G), or of a language of powers, is in the other part of the intersection.
struct Disjoint {
    static constexpr const char* rule = "relations";
    Language language;
    Language other;
    Repeated letters;
};

/// Nothing makes terminals of all letters of the axiom.
struct NoTerminals {
    static constexpr const char* rule = "relations";
    TableValue tables;
};

/// L(G) of an 0L system is infinite (see EndlessRound): the letters with the successors of the round.
struct InfiniteRound {
    std::string system;
    std::vector<std::pair<Symbol, Word>> rules;
    Symbol other = 0;
};

/// L(G) of a system with context is infinite. The automaton accepts the last word of the derivation and what each word that
/// it accepts becomes by `rules`, one for each choice; each such step raises the sum of the weights of the transitions that a word
/// takes. So no word comes twice.
struct Measured {
    std::string system;
    Derivation start;
    std::vector<std::pair<Symbol, IL::Rule>> rules;
    std::shared_ptr<const Dfa> automaton;
    std::vector<std::int64_t> weights;  // of its transitions, in their order; all 1: by the length
};

/// The language of a system with tables, its own or constructed, is infinite.
struct InfiniteTables {
    std::string system;
    std::shared_ptr<const TableValue> tables;
    bool constructed = false;
    EndlessTables endless;
};

/// The words prefix middle^n suffix are all in the regular language.
struct Pumped {
    Language language;
    Word prefix, middle, suffix;
};

/// Words with powers get longer with their numbers.
struct LongerPowers {
    static constexpr const char* rule = "powers";
    Language language;
};

/// Part `index` of an operation is infinite, so the whole is.
struct InfinitePart {
    Language whole;
    std::size_t index = 0;
    Part part;
};

/// The language has not so many words, as it is infinite.
struct InfiniteSize {
    Part infinite;
};

// --- Families ---

/// The language is given by a system of the family.
struct HasForm {
    static constexpr const char* rule = "form";
    Language language;
    std::string family;
};

/// The language is finite, and the family has all finite languages.
struct FiniteOfFamily {
    static constexpr const char* rule = "finite";
    std::vector<Part> known;
    std::string family;
};

/// Finite languages under operations that keep languages regular.
struct RegularOperations {
    static constexpr const char* rule = "regular";
    Language language;
    std::string family;
};

/// Context-free grammars, languages of powers and finite ones, under operations that keep languages context-free.
struct ContextFree {
    static constexpr const char* rule = "context-free";
    Language language;
};

/// The language of powers is not REG or not CF.
struct PowersBeyond {
    static constexpr const char* rule = "powers";
    Language language;
    std::string family;
    BeyondFamily why;
};

/// The empty word is in the language, and no system of the family derives it.
struct HasEmptyWord {
    static constexpr const char* rule = "empty word";
    Language language;
    std::string family;
    Part member;
};

/// A D0L language that grows faster than linearly has too few lengths.
struct Sparse {
    static constexpr const char* rule = "sparse";
    Language language;
    std::string family;
    GrowthOrder order;
};

/// L(G) of a D0L system is regular, as in SameProgressions.
struct RegularProgressions {
    Language language;
    std::string family;
    std::uint64_t first = 0, period = 1;
};

/// L(G) of a D0L system of linear growth is not regular: the powers in the words of a section (see `SectionOfPowers`) are not of one
/// period.
struct UnequalPowers {
    Language language;
    std::string family;
    SectionOfPowers section;
};

/// A system that generates the finite language, or the cases by which there is none.
struct FiniteFamily {
    std::vector<Part> known;
    std::shared_ptr<const FamilyAnswer> answer;
};

/// A system of the claim is of the family and generates the language.
struct GeneratedBy {
    std::shared_ptr<const SourceSystem> system;
    std::string family;
    Language language;
    Part equal;
    bool found = false;  // the system is not one of the claim
};

/// No system of the family generates the regular language. Words are of one class if they do the same to its minimal automaton;
/// the empty word is a class of its own. A map gives each letter the classes that its successors may be of.
struct ByClasses {
    static constexpr std::size_t most_shown = 40;  // cases in sentences
    struct Case {
        // The map leads out of the language: each letter of `word`, one of the language, becomes a word of a class of the map,
        // and the product is not in the language. Each of `cases` is the map without one of these pairs of a letter and a class,
        // in the order in which they first stand in the word.
        Word word;
        std::vector<Word> images;
        std::vector<Case> cases;
        // Or the map has no class for a letter; or, of one table, two words of the language have no ancestor in common; or, of
        // tables, nothing of all this: it is one of the maps that are left.
        std::optional<Symbol> letter = {};
        std::vector<Word> apart = {};
    };
    Language language;
    std::string family;
    std::vector<Word> classes;  // a first word of each
    std::vector<Word>
        apart;  // of tables: two words that have no ancestor in common by the maps that are left
    Case root;
    std::size_t size = 0;  // cases
};

/// No system of the family generates the infinite regular language over one letter, by its lengths (regular_family.cpp). p is the period of
/// these; numbers stand for classes of lengths.
struct ByLengths {
    using Rest = std::pair<std::size_t, std::size_t>;  // and the modulus
    struct Case {
        // Lengths of successors, one for each letter of a word, whose sum is not a length. Each of `cases` is without one of them,
        // increasing, and has those before it.
        std::vector<std::size_t> sum = {};
        std::vector<Case> cases = {};
        // Or a length that the rest of them does not make of a shorter one; or long lengths that finitely many do not make of long ones.
        std::optional<std::size_t> length = {};
        std::optional<Rest> rest = {};
    };
    /// Tables whose lengths all have one rest: p has the modulus as its divisor.
    struct Frame {
        std::size_t modulus = 1, rest = 0;
        Case root;
    };
    /// A length, or rest, that no table makes; with one table, that no table makes all.
    struct Target {
        std::optional<std::size_t> length = {};
        std::optional<Rest> rest = {};
        std::vector<Frame> frames;
    };
    static constexpr std::size_t most_shown = 40;  // cases in sentences
    Language language;
    std::string family;
    std::size_t period = 1;
    std::vector<Target> targets;
    // Where the one table has the empty word: two lengths whose sum is none, and the same without the first and the second of them.
    std::vector<std::pair<std::size_t, std::size_t>> sums;
    std::size_t size = 0;  // cases
};

/// A regular language has too many words for the family: infinite D0L languages have at most c N words up to the length N.
struct Dense {
    static constexpr const char* rule = "dense";
    Language language;
    std::string family;
};

/// The word of the infinite regular language has letters only that stand on cycles of its automaton.
struct LettersOnCycles {
    Language language;
    std::string family;
    Word word;
};

/// In the words a^e b^f ... of two or more letters all exponents grow with one number, linearly.
struct LinearBlocks {
    static constexpr const char* rule = "blocks";
    Language language;
    std::string family;
};

/// The lengths of an infinite language over one letter are so few that each table of a system has one rule, a -> a^s. By such tables
/// the word of this length comes of no shorter one; without tables, the lengths up to it are no geometric sequence.
struct NotGeometric {
    Language language;
    std::string family;
    Part infinite;
    std::uint64_t length = 0;
    std::vector<std::uint64_t> lengths;  // up to it
    bool tables = false;
};

/// The numbers of letters in the words of the infinite regular language are multiples of one vector, by factors with an
/// arithmetic progression among them.
struct Proportional {
    static constexpr const char* rule = "proportional";
    Language language;
    std::string family;
};

/// What is reversed is of the family or not, so the reversal is or is not.
struct OfReversal {
    Language language;
    std::string family;
    bool holds = false;
    Part part;
};

/// A constructed system is of the family.
struct Constructed {
    static constexpr const char* rule = "closed";
    TableValue tables;
};

// --- Codes and palindromes ---

/// No word is a product in two ways; `prefix`: no word of the language begins with another.
struct Code {
    static constexpr const char* rule = "code";
    Language language;
    bool prefix = false;
    std::size_t words = 0;  // 0: the language is infinite, and regular
};

/// The word is cut into words of the language in two ways.
struct TwoFactorisations {
    Language language;
    Word word;
    std::vector<std::size_t> left, right;  // where the factors end
};

/// Both words are in the language, and one begins with the other.
struct Beginning {
    Language language;
    Word word, beginning;
};

/// The letter at `place` is not the one at the same place from the end; nothing: there is no such letter.
struct Palindrome {
    static constexpr const char* rule = "letters";
    Word word;
    std::optional<std::size_t> place;
};

// --- Several statements, and statements about all values ---

/// What is known of parts decides the whole.
struct FromStatements {
    struct Known {
        std::size_t index = 0;
        std::string text;  // of the part
        Answer answer;
    };
    Joint::Kind kind = Joint::Kind::all;
    std::vector<Known> parts;
};

/// The values of an instance meet the conditions, and of them the body is true (an example) or false (a
/// counterexample).
struct ByInstance {
    bool universal = true;
    std::vector<BoundValue> values;
    std::uint64_t size = 0;
    std::vector<Answer> members;  // of those names that range over languages of a family
    std::vector<Answer> conditions;
    Statement statement;  // the body with the values
    Answer body;
    Searched searched = {};
    std::shared_ptr<const ByInstance> other =
        {};  // a larger one whose language has a word that is not empty
};

/// Every instance was decided.
struct ByCases {
    static constexpr const char* rule = "cases";
    static constexpr std::uint64_t most_kept =
        10'000;  // cases with their proofs, those within cases too
    /// A tuple of values: the body is as the statement says, or a value is not of its family, or a condition does not hold.
    struct Case {
        std::vector<BoundValue> values;
        std::optional<std::size_t> member, condition;  // the one that fails, by its number
        Answer answer;
    };
    Quantified statement;
    std::uint64_t instances = 0;   // that meet the conditions
    std::vector<Case> cases = {};  // none where there are more than are kept
};

/// The body is several statements joined by `and`, and each of them is true of all values.
struct ByEach {
    std::vector<std::string> texts;
    std::vector<Part> proofs;
};

/// What follows of derivations that are given: a tree of rules, each of which makes one derivation `from` ==> `to` of
/// those of its parts. Steps are sums of multiples of names: bound numbers, "1", and "#i" for those of condition i where it
/// does not say how many.
struct DerivationRule {
    enum class Kind {
        given,     // condition `index`
        part,      // what symbol `index` of the condition that is split becomes
        identity,  // `word` derives itself in no step
        empty,     // the empty word derives itself in `steps` steps
        product,   // x derives y and u derives v in as many steps, so xu derives yv
        chain      // x derives y and y derives z, so x derives z in as many steps as both
    } kind = Kind::given;
    std::size_t index = 0;
    Word word = {};
    std::map<std::string, std::int64_t> steps = {};
    std::vector<DerivationRule> parts = {};
};

/// The conditions are derivations of one system without tables, and the statement follows from them: it is a derivation
/// (one tree); or a word that derives another one without erasing is not longer (one tree, of the derivation); or a deterministic
/// system derives one word only (two trees). If `split` is a condition, each way in which its word can be cut into what the
/// symbols become is a case with trees of its own.
struct ByDerivations {
    std::vector<std::string> conditions;  // as written
    std::optional<std::size_t> split;
    std::vector<std::vector<DerivationRule>> cases;
    enum class Shows { derivation, length, uniqueness } shows = Shows::derivation;
};

/// The family of a language follows from those of the names, by the form of systems and by reversal.
struct ByFamilyRules {
    static constexpr const char* rule = "families";
    std::vector<std::string> lines;
};

/// Of all D0L systems whose lengths grow faster than linearly: their languages are not of the family, REG or CF.
struct AllSparse {
    static constexpr const char* rule = "sparse";
    std::string system, family;
};

/// Of all systems without erasing rules and choices whose first word begins the second one, which is another one: each word
/// begins the next one and is shorter, so their languages are infinite.
struct AllLonger {
    static constexpr const char* rule = "longer";
    std::string system;
};

/// The statement is true with different letters in the place of names, "A^R" being one of its own; so it is true of all
/// languages.
struct ByLetters {
    std::map<std::string, Symbol> letters;
    Part proof;
};

}  // namespace steps

struct Proof {
    std::variant<
        steps::Value, steps::Sifted, steps::Listed, steps::Generated, steps::NotGenerated,
        steps::Factored, steps::NotFactored, steps::HasPreimage, steps::HasNoPreimage,
        steps::OfPowers, steps::OtherLetters, steps::HasNoImage, steps::FromParts, steps::Derives,
        steps::DerivesNot, steps::InSomeStep, steps::Rewrites, steps::Develops, steps::Likely,
        steps::SameSequence, steps::OtherSequence, steps::SameGrowth, steps::OtherGrowth,
        steps::ComparedNumbers, steps::ByRecurrences, steps::StaysPositive, steps::Grows,
        steps::Rises, steps::RisesByLetters, steps::Falls, steps::ByAutomata,
        steps::ByBispecialFactors, steps::ByRepetitions, steps::RepeatsForEver, steps::Synchronised,
        steps::ComparedWords, steps::ByMorphism, steps::LimitSet, steps::Identical,
        steps::SameValues, steps::ValuesWithin, steps::OtherValues, steps::SameAutomata,
        steps::NothingOutside, steps::Distinguished, steps::SameDeterministic, steps::WithinRegular,
        steps::ByInduction, steps::SamePowers, steps::Invariant, steps::BothInclusions,
        steps::LinearSystems, steps::ByFacts, steps::Counted, steps::NoWord,
        steps::FiniteConstruction, steps::FoundWord, steps::Disjoint, steps::NoTerminals,
        steps::InfiniteRound, steps::Measured, steps::InfiniteTables, steps::Pumped,
        steps::LongerPowers, steps::InfinitePart, steps::InfiniteSize, steps::HasForm,
        steps::FiniteOfFamily, steps::RegularOperations, steps::ContextFree, steps::PowersBeyond,
        steps::HasEmptyWord, steps::Sparse, steps::FiniteFamily, steps::GeneratedBy,
        steps::ByClasses, steps::ByLengths, steps::Dense, steps::LettersOnCycles,
        steps::LinearBlocks, steps::NotGeometric, steps::Proportional, steps::OfReversal,
        steps::Constructed, steps::Code, steps::TwoFactorisations, steps::Beginning,
        steps::Palindrome, steps::FromStatements, steps::ByInstance, steps::ByCases,
        steps::ByFamilyRules, steps::AllSparse, steps::AllLonger, steps::ByLetters, steps::ByEach,
        steps::ByDerivations, steps::WithinDeterministic, steps::SameProgressions,
        steps::RegularProgressions, steps::UnequalPowers, steps::ByRules>
        step;
};

template <class Step>
Part proof_by(Step step) {
    return std::make_shared<const Proof>(Proof{std::move(step)});
}

template <class Step>
Answer proved(Step step) {
    return {Truth::proved, proof_by(std::move(step)), {}};
}

template <class Step>
Answer refuted(Step step) {
    return {Truth::refuted, proof_by(std::move(step)), {}};
}

/// Proved if it holds, otherwise refuted.
template <class Step>
Answer decided(bool holds, Step step) {
    return holds ? proved(std::move(step)) : refuted(std::move(step));
}

inline Answer undecided(std::string tried) {
    return {Truth::undecided, nullptr, {std::move(tried)}};
}

// --- What the readers of proofs share ---

/// The sentences with what is not prose between marks, control characters that no notation has: words between
/// `word_begins` and `mark_ends`, languages, rules, names and numbers between `term_begins` and `mark_ends`.
constexpr char word_begins = '\1', term_begins = '\2', mark_ends = '\3';
std::string marked_word(const Alphabet& alphabet, const Word& word);
std::string marked(const std::string& term);
std::vector<std::string> marked_sentences(const Answer& answer, const Alphabet& alphabet);

/// The sentence without its marks.
std::string plain(std::string sentence);

}  // namespace algae
