#pragma once

// language: languages as values, what can be decided about them and how it is known, and claims: statements
// about languages, systems and what they draw, each with its verdict, an argument in sentences and a proof that
// the room verify checks again.

#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <variant>
#include <vector>

#include "exact/exact.hpp"
#include "search/search.hpp"
#include "system/system.hpp"
#include "word/word.hpp"

namespace algae {

class DimensionValue;
struct CountingStatement;
class FirstOrderStatement;
struct GeneratingFunction;
class Rewriting;
struct Model;
struct ModuleTrace;

// --- Languages as values ---

/// An L-system that a language or a statement speaks of: without context (ET0L and all that it
/// includes) or with context (IL), over the symbols of a common alphabet.
struct SourceSystem {
    std::string name;  // as it is called in text
    std::optional<ET0L> tables;
    std::optional<IL> interactive;  // where `tables` is empty
    /// A name that a quantifier binds, by its number, instead of a system.
    std::optional<std::size_t> variable = {};
    /// Where the system stands for a context-free grammar, that grammar as claims write it: `CF { S -> aSb | ε }`. The
    /// rules of the grammar and A -> A for each of its letters generate its language as an E0L system.
    std::string grammar = {};
};

/// The words u1^e1 u2^e2 ... for all values of one or two numbers: {a^n b^(2n+1) : n >= 0}. Each number stands in an
/// exponent; the exponents grow with every number that stands in them.
struct Powers {
    /// coefficient * number^power * base^number, with coefficient and base at least 1; without a number the coefficient.
    struct Term {
        Integer coefficient = 1;
        std::optional<std::size_t> number = {};  // place in `numbers`
        std::uint64_t power = 0;
        Integer base = 1;
        bool operator==(const Term&) const = default;
    };
    /// The sum of its terms, no two of which differ in their coefficients only.
    struct Block {
        Word word;  // not empty
        std::vector<Term> exponent;
        bool operator==(const Block&) const = default;
    };
    struct Number {
        std::string name;
        std::uint64_t least = 0;  // it is this number or a larger one
        bool operator==(const Number&) const = default;
    };
    std::vector<Block> blocks;
    std::vector<Number> numbers;
    bool operator==(const Powers&) const = default;
};

struct LanguageTree;

/// A name that a quantifier binds: their numbers tell bound names apart.
struct BoundName {
    std::size_t number = 0;
    std::string name;
};

/// A language as a value: an expression whose parts are languages. All parts are over the symbols of
/// one alphabet that the caller knows. Cheap to copy.
using Language = std::shared_ptr<const LanguageTree>;

/// One node of such an expression. Regular expressions are expressions like any other: finite sets under
/// union, concatenation, star and plus.
struct LanguageTree {
    enum class Kind {
        words,      // a finite set
        generated,  // L(G)
        united,     // the rest: of `parts`
        intersected,
        difference,
        concatenated,
        star,
        plus,
        complement,  // the words over `letters` that are not in the part
        reversed,
        image,          // under `morphism`
        inverse_image,  // the words over the letters that have an image whose image is in the part
        variable,       // a name that a quantifier binds
        powers,         // {a^n b^n : n >= 0}
    };
    Kind kind = Kind::words;
    std::vector<Word> words;  // sorted: shorter ones first, then by symbol numbers
    std::shared_ptr<const SourceSystem> system;  // of L(G), or of a grammar
    /// Two of a union, intersection, difference, concatenation; otherwise one.
    std::vector<Language> parts;
    Morphism morphism;
    std::vector<Symbol> letters;             // increasing
    std::string name;                        // what the text calls it, where it has a name
    std::optional<BoundName> variable = {};  // that this is, or that the morphism of an image is
    std::shared_ptr<const Powers> powers = {};
};

/// The finite set of these words, in any order and with repetitions.
Language words_language(std::vector<Word> words);
/// L(G).
Language generated_language(std::shared_ptr<const SourceSystem> system);
/// The words that the blocks make for all values of the numbers. Throws Error if an exponent with two numbers is not
/// linear, or a number stands in no exponent.
Language powers_language(Powers powers);
/// Any kind with parts and nothing else.
Language combined(LanguageTree::Kind kind, std::vector<Language> parts);
/// The words over `letters` that are not in the language.
Language complement_language(Language language, std::vector<Symbol> letters);
/// The images of the words all of whose letters have an image.
Language image_language(Language language, Morphism morphism);
/// The words over the letters that have an image whose images are in the language.
Language inverse_image_language(Language language, Morphism morphism);
/// The same language with a name, by which texts call it.
Language named(Language language, std::string name);

/// The letters that may occur in words of the language, in increasing order: none is missing, but one
/// may be there that occurs in no word.
std::vector<Symbol> letters_of(const Language& language);

/// The expression as claims write it; parts that have names by name.
///
/// Example: to_string(words_language({{}}), Alphabet()) == "{ε}"
std::string to_string(const Language& language, const Alphabet& alphabet);

/// "~ is over the letters a, b." for the letters that complements are over; empty where there are none.
std::string complement_text(const std::vector<Symbol>& letters, const Alphabet& alphabet);

/// What the name of a family says of the form of its systems: E extended, P propagating, D deterministic,
/// T with tables, then 0L, or with context IL, 1L, 2L, (k,l)L.
struct SystemForm {
    bool extended = false, propagating = false, deterministic = false, tables = false;
    bool interactive = false;
    std::optional<std::pair<std::size_t, std::size_t>> context;  // longest contexts, left and right
    bool one_sided = false;                                      // 1L: (1,0) or (0,1)
};

/// The form that a family's name says; nothing if it is not such a name.
///
/// Example: system_form("PD0L")->deterministic
/// Example: !system_form("DOL")
std::optional<SystemForm> system_form(std::string_view name);

/// Whether the rules of the system have the form. Rules of letters that never occur do not matter.
bool has_form(const SourceSystem& system, const SystemForm& form);

// --- Membership ---

/// A derivation: every letter of a word is replaced by one of its successors, which makes the next
/// word. words.front() is the axiom; letter i of words[t] becomes its successor number choices[t][i].
struct Derivation {
    std::vector<Word> words;
    std::vector<std::vector<std::uint32_t>> choices;  // one fewer than words; none with context
    std::vector<std::uint32_t> tables = {};  // of each step; empty where the system has one table
};

/// Whether the derivation begins with the axiom and each step does what the rules, or those of its table, say.
/// (Its last word is in L(G) if its letters are terminals.) Linear time.
bool is_derivation(const OL& system, const Derivation& derivation);
bool is_derivation(const ET0L& system, const Derivation& derivation);

/// Whether a word is in the language of a system, and how that is known.
struct Membership {
    enum class Reason {
        derived,  // yes: it is a word of generation `step`, and of none before
        foreign,  // no: letter number `position` of the word is in no word of the language
        repeated,  // no: what the letters derive within the word in `step` steps is what they derive in
        // `earlier` steps, so nothing new is derived afterwards, and no generation before had it
        outgrown,  // no: from generation `step` on all words are longer, and no generation before had it
        periodic,  // no: generation `step` is the same word as generation `earlier` (D0L systems)
        nonterminal,  // no: letter number `position` of the word is not a terminal
        exhausted,  // no: what the letters derive within the word by any `step` tables is what they derive
                    // by fewer, so nothing new comes, and none of the `states` families seen has it
        short_words,  // no: none of the `states` words with at most as many letters is it, and rules erase nothing (IL)
        all_words,  // no: none of the `states` words of the language is it (IL)
    };
    bool member = false;
    Reason reason = Reason::derived;
    std::uint64_t step = 0;
    std::uint64_t earlier = 0;
    std::uint64_t position = 0;
    std::uint64_t states = 0;
    std::vector<std::uint32_t> tables = {};  // of a member's steps, where there are several
};

/// Whether the word is in L(G), decided: complete, with erasing rules too. Time O(|word|^3 / 64 * size of the
/// rules) a step; the steps are O(|word|) times a number that depends on the rules, which can be as large as
/// the least common multiple of the lengths of cycles of letters. With one rule a letter O(size of the rules) a
/// step, until every letter that grows has outgrown the word.
///
/// Throws what budget.check throws, and BoundReached if two tables of factors take more than budget.memory.
///
/// Example: membership(ol("a", {{'a', "a"}, {'a', "aa"}}), {0, 0, 0}).step == 2
Membership membership(const OL& system, const Word& word, const Budget& budget = {});

/// The same for tables and terminals. With several tables the problem is NP-complete for some fixed systems
/// (van Leeuwen 1975): there may be exponentially many families of factors. All are kept, and BoundReached is
/// thrown where they take more than budget.memory.
///
/// Example: membership(et0l("a", {{{'a', "aa"}}, {{'a', "aaa"}}}), Word(6, 0)).step == 2
Membership membership(const ET0L& system, const Word& word, const Budget& budget = {});

/// A derivation of the word in exactly `step` steps, if there is one, with tables kept only here and there on the
/// way and worked out again in between: O(sqrt(step)) tables. What is erased is erased as soon as the
/// rules can. Throws BoundReached if its words have more than budget.letters letters together.
///
/// Example: !find_derivation(ol("a", {{'a', "aa"}}), {0, 0, 0}, 2)
std::optional<Derivation> find_derivation(const OL& system, const Word& word, std::uint64_t step,
                                          const Budget& budget = {});

/// The same of a word that has one. Throws Error if there is none.
///
/// Example: derivation(ol("a", {{'a', "a"}, {'a', "aa"}}), {0, 0, 0}, 2).words.size() == 3
Derivation derivation(const OL& system, const Word& word, std::uint64_t step,
                      const Budget& budget = {});

/// The derivation of a member as `membership` found it. Throws Error if it is not one, BoundReached
/// if the words have more than budget.letters letters together.
///
/// Example: derivation(et0l("S", {{{'S', "a"}}}, "a"), {1}, membership(et0l("S", {{{'S', "a"}}}, "a"), {1})).words.size() == 2
Derivation derivation(const ET0L& system, const Word& word, const Membership& found,
                      const Budget& budget = {});

/// The 0L system of the only table, in which every letter is a terminal. Throws Error if there are
/// several tables.
///
/// Example: without_terminals(et0l("S", {{{'S', "a"}}}, "a")).letters.size() == 2
OL without_terminals(const ET0L& system);

// --- Finiteness ---

/// Whether every accessible letter has one successor, so that the system is a D0L system.
bool is_deterministic(const OL& system);

/// One use of a rule: successor number `choice` of a letter.
struct RuleUse {
    Symbol letter = 0;
    std::size_t choice = 0;
    bool operator==(const RuleUse&) const = default;
};

/// Why the language of an 0L system is infinite: starting with rules.front(), the successor of each rule has
/// the letter of the next one, that of the last has the first letter again; and the successor of the first rule
/// has `other` besides, which can go on for ever. So n rounds give a word with n letters and more.
struct EndlessRound {
    std::vector<RuleUse> rules;
    Symbol other = 0;
};

/// Whether L(G) is finite: a proof if it is not.
struct Finiteness {
    bool finite = false;
    std::optional<EndlessRound> round;  // where it is infinite
};

/// Decided, in the time of the components of letters.
///
/// Example: !finiteness(ol("a", {{'a', "ab"}})).finite
Finiteness finiteness(const OL& system);

/// The number of words of a finite L(G): for D0L systems by `repetition`, otherwise as the words that
/// the minimal automaton of the language accepts, so there may be far more words than could be listed.
/// Throws Error if the language is infinite, BoundReached if an automaton needs more than
/// budget.memory.
///
/// Example: number_of_words(ol("aa", {{'a', ""}, {'a', "a"}})) == 3
Integer number_of_words(const OL& system, const Budget& budget = {});

/// From generation `preperiod` on every generation is the same word as the one `period` later; both
/// are least.
struct Repetition {
    std::uint64_t preperiod = 0;
    Integer period = 1;
    bool operator==(const Repetition&) const = default;
};

/// When the words of a D0L system with a finite language repeat. Once every lasting letter lies on a
/// cycle of letters, a word is back when all of them are, so the period is the least common multiple of
/// the lengths of their cycles; generations are compared across it by squaring h^period.
/// Throws Error if a letter has several successors or the language is infinite.
///
/// Example: repetition(ol("ca", {{'a', "b"}, {'b', "a"}, {'c', "d"}})) == Repetition{1, 2}
Repetition repetition(const OL& system, const Budget& budget = {});

/// One step of one letter: by a table it becomes successor number `choice`, and the letter at
/// `place` of that is the one that is followed.
struct TableUse {
    std::uint32_t table = 0;
    Symbol letter = 0;
    std::uint32_t choice = 0;
    std::uint32_t place = 0;
    bool operator==(const TableUse&) const = default;
};
using Course = std::vector<TableUse>;

/// Why L(G) is infinite. By the tables of `round` the letter `again` becomes a word with itself
/// and, at another place, `other`, which becomes a word with itself by the same tables; so n rounds
/// give a word with n letters `other` and more. By the tables of `after` each of these becomes a
/// word of terminals that is not empty, and the other letters finish too.
struct EndlessTables {
    Symbol again = 0, other = 0;
    Course before;  // from a letter of the axiom to `again`
    Course round;   // from `again` to itself
    Course beside;  // from `again` to `other`: as `round` up to a step where only the place differs
    Course kept;    // from `other` to itself
    Course after;   // from `other` to a terminal
};

/// Whether the proof holds: it only follows the courses and works out backwards which letters finish. Linear time.
bool is_proof(const ET0L& system, const EndlessTables& proof);

/// Whether L(G) is finite: a proof if it is not.
struct TablesFiniteness {
    bool finite = false;
    std::optional<EndlessTables> endless;  // where it is infinite
};

/// Decided for every ET0L system. Time and memory: the number of finishing sets (one for T0L systems, at most
/// 2^letters) * letters^3 * tables * the product of the numbers of letters that three letters can become.
/// Throws BoundReached if that takes more than budget.memory.
///
/// Example: !finiteness(et0l("a", {{{'a', "b"}}, {{'b', "aa"}}})).finite
TablesFiniteness finiteness(const ET0L& system, const Budget& budget = {});

/// The number of words of a finite L(G), by the minimal automaton of its words. Throws Error if the language is
/// infinite, BoundReached if automata or families of them take more than budget.memory.
///
/// Example: number_of_words(et0l("aa", {{{'a', "b"}, {'a', "c"}}, {{'a', ""}}})) == 6
Integer number_of_words(const ET0L& system, const Budget& budget = {});

// --- The words of a language ---
//
// Regular languages are listed, counted and drawn from by their minimal automaton. Of other languages all words up to a length are
// worked out from those of their parts: of a system without context by what each letter derives within that length, until nothing
// new comes. What cannot be worked out so is left open: words that are found are words of the language, and it is said from
// which length on others may be missing. All functions throw Interrupted.

/// How far words are wanted.
struct ListLimits {
    std::uint64_t length = 100;  // letters of the longest
    std::uint64_t words = 100;
};

/// The first words of a language: shorter ones first, those of one length in the order of the names of their letters.
struct WordList {
    std::vector<Word> words;
    /// So many lengths 0, 1, 2, ... are decided: the list has all words of these lengths, or the first of them where it is full.
    /// Longer words of the list are words of the language too, but others may be missing.
    std::uint64_t decided = 0;
    bool full = false;   // there are as many words as were wanted
    bool whole = false;  // the language has no other words
    std::string stopped =
        {};  // why no more lengths are decided; empty where as many are as were wanted
};

/// Time and memory: those of the words of each part up to this length, for complements of what is not regular of all words.
///
/// Example: list_words(words_language({{1}, {0, 0}, {}}), *ol("ab", {}).alphabet, {1, 10}).words.size() == 2
WordList list_words(const Language& language, const Alphabet& alphabet,
                    const ListLimits& limits = {}, const Budget& budget = {});

/// How many words of each length a language has.
struct WordCounts {
    std::vector<Integer> counts;  // of lengths 0, 1, 2, ... as far as they are decided
    bool whole = false;           // no word is longer
    std::shared_ptr<const GeneratingFunction> function =
        {};                    // of all counts; of a regular language only
    std::string stopped = {};  // as in WordList
};

/// Up to this length. Of a regular language O(length * size of the automaton) additions, and the function from the
/// shortest recurrence of the counts.
///
/// Example: count_words(words_language({{1}, {0, 0}, {}}), *ol("ab", {}).alphabet, 5).counts[2] == 1
WordCounts count_words(const Language& language, const Alphabet& alphabet, std::uint64_t longest,
                       const Budget& budget = {});

/// Words of this length, each drawn by itself and all equally likely; none if there is no word of this length. The same on every
/// machine. Throws BoundReached if it is not known which words of this length the language has.
///
/// Example: draw_words(words_language({{1}, {0, 0}, {}}), *ol("ab", {}).alphabet, 2, 3, 1).size() == 3
std::vector<Word> draw_words(const Language& language, const Alphabet& alphabet,
                             std::uint64_t length, std::uint64_t count, std::uint64_t seed,
                             const Budget& budget = {});

// --- Systems with context ---

/// What is known of the sequence of words of a deterministic system with context: one of the three, or nothing where no proof
/// is found.
struct ContextGrowth {
    std::optional<Repetition> repetition;  // the words repeat, so lengths are bounded
    /// From this generation on every word is longer than the one before.
    std::optional<std::uint64_t> rises_from;
    bool endless = false;  // no word comes twice, so lengths have no bound
};

/// Found by deriving words until one comes again, otherwise by a measure of words that every step raises, over an automaton that
/// accepts all words from some generation on. Throws Error if the system is not deterministic or has brackets, and what budget.check
/// throws; bounds of letters and memory only end the search.
///
/// Example: context_growth(il("ab", {"a > b -> aa"})).rises_from == 0
ContextGrowth context_growth(const IL& system, const Budget& budget = {});

// --- Equality of D0L sequences and languages ---

/// Two D0L systems over one alphabet, so that their words can be compared. Letters are the same if their
/// names are.
struct SequencePair {
    std::shared_ptr<const Alphabet> alphabet;
    D0L left, right;
};

/// The same systems over the letters of both, those of the left one first with the numbers they have. A
/// letter that only the other system has stays as it is.
///
/// Example: over_common_alphabet(d0l("a", {{'a', "b"}}), d0l("b", {{'b', "a"}})).right.axiom == Word{1}
SequencePair over_common_alphabet(const D0L& left, const D0L& right);

/// What one image of a word has beyond the other: where g and h are the rules of the left and the right
/// system, g(u) = h(u) word if the left is ahead, and g(u) word = h(u) if the right is. The empty
/// overflow counts as the left's.
struct Overflow {
    enum class Ahead { left, right };
    Ahead ahead = Ahead::left;
    Word word;
    bool operator==(const Overflow&) const = default;
    bool operator<(const Overflow& other) const {
        return std::tie(ahead, word) < std::tie(other.ahead, other.word);
    }
};

/// A proof that two D0L systems with the same axiom w have the same sequence. g and h are their rules.
///
/// The states and a state of refusal form an automaton: letter a leads from overflow v to
/// overflow_step(v, a) if that is a state, otherwise to refusal. Let T_k(a) be the map of states by the word
/// g^k(a); T_0 is the automaton's, and T_{k+1}(a) the product of T_k over the letters of g(a). T_steps =
/// T_earlier, so no map comes after them that did not come before; and for every k < steps the word g^k(w)
/// leads from the empty overflow to itself. So g and h have the same value on every word g^k(w), and by
/// induction g^k(w) = h^k(w) for all k.
struct Balance {
    std::size_t bound = 0;         // no overflow is longer
    std::vector<Overflow> states;  // the empty one first
    std::uint64_t steps = 0;
    std::uint64_t earlier = 0;
};

/// The first generation in which two sequences of words differ, and where.
struct SequenceDifference {
    std::uint64_t generation = 0;
    /// Of the first letter, counted from 0, that is not the same or that only one word has.
    Integer position;
    Integer from;      // where the letters shown begin: a little before the position
    Word left, right;  // the letters of both words from there on, over the alphabet of both systems
    Integer left_length, right_length;
};

/// Whether two D0L systems have the same word in every generation, and how that is known.
struct SequenceEquality {
    bool equal = false;
    std::optional<Balance> balance;                // if they have
    std::optional<SequenceDifference> difference;  // if they have not
};

/// D0L sequence equivalence, decided (Culik and Fris 1977; Ehrenfeucht and Rozenberg 1978). Throws
/// BoundReached, and says what was tried, if the overflows take more than budget.memory or time is up.
///
/// Example: equal_sequences(d0l("ab", {{'a', "abb"}, {'b', "aabba"}}),
///     d0l("ab", {{'a', "abbaabb"}, {'b', "a"}})).difference->generation == 3
SequenceEquality equal_sequences(const D0L& left, const D0L& right, const Budget& budget = {});

/// For all n: word number left + n step of one sequence and number right + n stride of the other.
struct Section {
    std::uint64_t left = 0, step = 1, right = 0, stride = 1;
    bool operator==(const Section&) const = default;
};

/// A section of the one sequence that is the same sequence of words as one of the other: the rules of the
/// section are the powers h^step and h^stride of the rules of the systems.
struct SectionMatch {
    Section section;
    Balance balance;  // of (w_left, g^step) and (v_right, h^stride)
};

/// A word that only one of two languages has.
struct LanguageDifference {
    bool in_left = false;          // the language that has it
    std::uint64_t generation = 0;  // of which it is the word
    Integer length;
    std::optional<Word> word;  // over the alphabet of both, unless it is too long to be written out
    /// The only generation of the other with as many of each letter, if there is one.
    std::optional<std::uint64_t> alike;
};

/// Whether two D0L systems generate the same language, and how that is known.
struct LanguageEquality {
    bool equal = false;
    bool finite = false;             // both languages: then they were compared word by word
    std::uint64_t words_in_all = 0;  // of equal finite languages
    /// Of equal infinite languages: the same words, by generation.
    std::vector<std::pair<std::uint64_t, std::uint64_t>> words;
    std::vector<SectionMatch> sections;            // and all others
    std::optional<LanguageDifference> difference;  // if they are not equal
};

/// D0L language equivalence, decided by sequence equivalence (after Nielsen 1974). Throws BoundReached, and
/// says what was tried, if this takes more than budget.memory or time is up.
///
/// Example: equal_languages(d0l("a", {{'a', "b"}, {'b', "aa"}}), d0l("a", {{'a', "b"}, {'b', "aa"}})).equal
LanguageEquality equal_languages(const D0L& left, const D0L& right, const Budget& budget = {});

// The proofs as a certificate writes them (CERTIFICATES.md).

/// Equal sequences: by `balance`. The alphabet is that of both systems.
nlohmann::ordered_json balance_certificate(const Balance& balance, const Alphabet& alphabet);

/// Sequences that differ: by `generation`, with the position of the first difference.
nlohmann::ordered_json difference_certificate(const SequenceDifference& difference);

/// Equal languages: by `values` if they are finite, otherwise by `sections`. The alphabet is that of both
/// systems; the languages must be equal.
nlohmann::ordered_json language_certificate(const LanguageEquality& equality,
                                            const Alphabet& alphabet);

// --- Derivation trees ---

/// A derivation as a tree; as several trees side by side where the axiom has several letters. The
/// children of a letter are the letters of its successor.
struct DerivationTree {
    struct Node {
        enum class Kind {
            letter,
            erased,   // the empty word, below a letter whose successor it is
            omitted,  // everything below a letter at which the tree was cut
        };
        Kind kind = Kind::letter;
        Symbol letter = 0;             // omitted: the letter above; erased: 0
        std::uint64_t generation = 0;  // of the letter; erased and omitted: one more than above
        Integer leaves = 0;  // omitted: letters of the last generation, -1 if beyond count
        std::vector<std::size_t> children;  // from left to right, as places in `nodes`
        std::string text = {};              // the letter with its parameters; empty without them
        /// Nodes of the same generation that the rule of this one looked at: its contexts.
        std::vector<std::size_t> seen = {};
        bool operator==(const Node&) const = default;
    };
    std::shared_ptr<const Alphabet> alphabet;
    std::vector<std::size_t> roots;  // the letters of the axiom
    std::vector<Node> nodes;         // generation after generation, in each from left to right
    /// The names of the tables that the steps use; empty with one table.
    std::vector<std::string> tables;
};

/// How a derivation is shown.
struct TreeShape {
    std::optional<std::uint64_t>
        depth;            // the last generation shown, one mark below each of its letters
    bool shared = false;  // equal subtrees of one generation are one: no tree any more
};

/// How many nodes the tree of generation n has, without the tree: the length of a generation of a
/// system in which every letter leaves one more letter behind. Of a tree with shared subtrees by
/// the sets of letters of each generation, until they repeat. Throws what `length` throws.
///
/// Example: tree_size(d0l("b", {{'a', "ab"}, {'b', "a"}}), 31) == 5702886
Integer tree_size(const D0L& system, std::uint64_t n, const TreeShape& shape = {},
                  const Budget& budget = {});

/// The tree of generation n. Throws BoundReached if it has more nodes than budget.letters.
///
/// Example: derivation_tree(d0l("b", {{'a', "ab"}, {'b', "a"}}), 3).nodes.size() == 7
DerivationTree derivation_tree(const D0L& system, std::uint64_t n, const TreeShape& shape = {},
                               const Budget& budget = {});

/// The same of a derivation. Linear time, n log n with shared subtrees.
Integer tree_size(const ET0L& system, const Derivation& derivation, const TreeShape& shape = {},
                  const Budget& budget = {});
DerivationTree derivation_tree(const ET0L& system, const Derivation& derivation,
                               const TreeShape& shape = {}, const Budget& budget = {});

/// The same of a derivation of modules, by the rewriting that made it. Below a cut, letters of the last
/// generation are not counted where the trace ends before it. Throws BoundReached for the size at a depth where the
/// trace ends before.
Integer tree_size(const Rewriting& rewriting, const ModuleTrace& trace, const TreeShape& shape = {},
                  const Budget& budget = {});
DerivationTree derivation_tree(const Rewriting& rewriting, const ModuleTrace& trace,
                               const TreeShape& shape = {}, const Budget& budget = {});

/// A depth below n at which a tree is small enough to show, and the next depth is not, if depth 0
/// is: `size` gives the size of the tree in a shape. O(log n) calls.
///
/// Example: depth_within(30, 100, [](const TreeShape& shape) { return Integer(*shape.depth + 1); }) == 29
std::optional<std::uint64_t> depth_within(std::uint64_t n, std::uint64_t most_nodes,
                                          const std::function<Integer(const TreeShape&)>& size,
                                          bool shared = false);

/// The same tree with equal subtrees of one generation made one, each at its first place.
DerivationTree with_shared_subtrees(const DerivationTree& tree, const Budget& budget = {});

/// How many generations there are below the axiom, marks of erased letters and of cuts not counted.
std::uint64_t depth(const DerivationTree& tree);

/// How many edges there are; a letter twice in a successor counts twice.
std::uint64_t edge_count(const DerivationTree& tree);

/// How many modules of contexts rules looked at: pairs of nodes of one generation.
std::uint64_t context_count(const DerivationTree& tree);

/// The word that the leaves spell from left to right, erased letters left out. Throws Error if the
/// tree is cut or has more leaves than budget.letters.
///
/// Example: leaves(derivation_tree(d0l("a", {{'a', "ab"}, {'b', ""}}), 2)) == Word{0, 1}
Word leaves(const DerivationTree& tree, const Budget& budget = {});

// --- All derivations of a word ---

/// How many derivations of a word in L(G) there are. A derivation of n steps is a choice of a table for each step and of a
/// rule for each letter of each word before the last; equal rules are one. Without tables that is a derivation tree of depth n.
struct DerivationCounts {
    struct Steps {
        std::uint64_t steps = 0;
        Integer count;
        bool operator==(const Steps&) const = default;
    };
    /// The numbers of steps in which there are derivations, fewest first: all of them, or the first
    /// ones where they are infinitely many.
    std::vector<Steps> by_steps;
    std::optional<Integer> total;  // nothing: there are infinitely many derivations
};

/// The number of derivations of exactly n steps, by the numbers of derivation trees of all factors of the word from
/// all letters (Earley 1970 and others count parses so): O(n |word|^3 * size of the rules) operations on numbers with one table. With
/// several tables all sequences of them are followed, those with equal numbers as one. Throws BoundReached if that
/// takes more than budget.memory.
///
/// Example: number_of_derivations(as_et0l(ol("a", {{'a', "a"}, {'a', "aa"}})), {0, 0}, 5) == 5
Integer number_of_derivations(const ET0L& system, const Word& word, std::uint64_t n,
                              const Budget& budget = {});

/// The derivations of a word by their numbers of steps. Which factors letters derive by a sequence of tables
/// is one of finitely many relations, a state; there are infinitely many derivations if and only if a
/// state comes again on the way to one in which the axiom derives the word. Where they are infinitely many, the first `listed` numbers of
/// steps are counted. Throws as number_of_derivations does.
///
/// Example: *derivation_counts(as_et0l(ol("aa", {{'a', "b"}, {'a', "bb"}, {'b', "bb"}})), {1, 1, 1, 1}).total == 2
DerivationCounts derivation_counts(const ET0L& system, const Word& word, std::size_t listed = 10,
                                   const Budget& budget = {});

/// Different derivations of exactly n steps, at most so many, in a fixed order: by tables, then by the rules of the letters
/// as the tree is gone through from left to right. Throws as number_of_derivations does.
///
/// Example: derivations(as_et0l(ol("a", {{'a', "a"}, {'a', "aa"}})), {0, 0}, 5, 100).size() == 5
std::vector<Derivation> derivations(const ET0L& system, const Word& word, std::uint64_t n,
                                    std::size_t most, const Budget& budget = {});

/// The same of systems with context, by the graph of the words that lead to this one. Exact, and always to the end where no rule is
/// erasing, as words do not get shorter then; with erasing rules they may be infinitely many, and BoundReached is thrown where
/// they take more than the budget's memory. A choice is the number of a successor among those that ContextStep::successors gives.
///
/// Example: number_of_derivations(il("ab", {"a > b -> aa", "a > b -> b"}), {0, 0, 1}, 1) == 1
Integer number_of_derivations(const IL& system, const Word& word, std::uint64_t n,
                              const Budget& budget = {});
DerivationCounts derivation_counts(const IL& system, const Word& word, std::size_t listed = 10,
                                   const Budget& budget = {});
std::vector<Derivation> derivations(const IL& system, const Word& word, std::uint64_t n,
                                    std::size_t most, const Budget& budget = {});

/// A derivation of the word in as few steps as possible; nothing if it is not in the language.
std::optional<Derivation> shortest_derivation(const IL& system, const Word& word,
                                              const Budget& budget = {});

/// The trace of a derivation, for its tree. `rewriting` is of the same system with choices that are all equally likely.
ModuleTrace traced(const Rewriting& rewriting, const IL& system, const Derivation& derivation,
                   const Budget& budget = {});

// --- Claims ---

/// How two numbers are compared.
enum class Comparison { equal, unequal, less, at_most, greater, at_least };
/// "=", "!=", "<", "<=", ">", ">=".
std::string to_string(Comparison comparison);

/// What a dimension is compared with.
struct ClaimedDimension {
    std::shared_ptr<const DimensionValue> value;
    std::string text;                           // as written
    Comparison comparison = Comparison::equal;  // or at_most, at_least
};

// What a statement says: one struct for each form, true or false.

/// The language is of the family.
struct InFamily {
    Language language;
    std::string family;
};

struct IsFinite {
    Language language;
};

/// The language has no word.
struct IsEmpty {
    Language language;
};

/// left == right.
struct EqualLanguages {
    Language left, right;
};

/// inner <= outer.
struct IncludedIn {
    Language inner, outer;
};

struct HasWord {
    Language language;
    Word word;
};

/// The language has exactly so many words.
struct HasSize {
    Language language;
    Integer size;
};

/// No word is a product of words of the language in two ways; `prefix`: nor does one of its words begin with another.
struct IsCode {
    Language language;
    bool prefix = false;
};

/// The word read backwards is the same.
struct IsPalindrome {
    Word word;
};

/// The system derives the word: from `from` or its axiom, in so many steps or some number of them.
struct Derives {
    std::shared_ptr<const SourceSystem> system;
    Word word;
    std::optional<Word> from = {};
    std::optional<std::uint64_t> steps = {};
    /// Instead of `steps` where the number of steps depends on bound numbers: n + m.
    std::optional<Expression> bound_steps = {};
    std::vector<BoundName> numbers = {};  // in it
};

/// Two D0L systems have the same word in every generation.
struct EqualSequences {
    std::shared_ptr<const SourceSystem> left, right;
};

/// Two D0L systems have words of the same length in every generation.
struct EqualGrowth {
    std::shared_ptr<const SourceSystem> left, right;
};

/// The growth is zero, bounded, polynomial (of this degree, if one is given) or exponential.
struct HasGrowthClass {
    std::shared_ptr<const SourceSystem> system;
    std::string growth;
    std::optional<Integer> degree = {};
};

/// The lengths of a D0L system never fall; strictly: they rise from each generation to the next.
struct IsIncreasing {
    std::shared_ptr<const SourceSystem> system;
    bool strictly = false;
};

/// Two numbers are compared that depend on bound numbers: `length(G, n + 2) = length(G, n + 1) + length(G, n)`. The terms
/// are made by + - * / ^ and `sqrt` from numbers, names of bound numbers, and of D0L systems `length(G, E)`, the number of
/// letters of generation E, and `count(G, a, E)`, how many of them are the letter; `length(w)` is the length of a bound word.
/// Of the figure of a generation, whose number no name stands in when it is worked out: `distinct segments(G, E)`, how many
/// different segments are drawn, and `boxes(G, E, S)`, how many squares of side S steps they meet.
struct ComparesNumbers {
    Expression left, right;
    Comparison comparison = Comparison::equal;
    std::vector<std::shared_ptr<const SourceSystem>> systems = {};  // that the terms name
    std::vector<BoundName> numbers = {};                            // likewise
    /// Of the systems of whose figures the terms speak, by name: with their turtles.
    std::map<std::string, std::shared_ptr<const Model>> turtles = {};
};

/// Throws Error, which says what to write instead, unless the different segments of all figures of the system can be counted: it
/// is D0L, its turtle in the plane makes steps of one length, turns by a part of a full turn with a denominator up to 360, and does
/// nothing else but to branch. With `boxes` unless it walks along the axes, so that squares that it meets can be counted.
void check_lattice_turtle(const Model& system, bool boxes);

/// A factor of a word that depends on bound numbers: a generation of a D0L system or a fixed word, then its images under
/// morphisms, the first one first, and in the end perhaps written backwards.
struct WordFactor {
    std::shared_ptr<const SourceSystem> system;  // null: the fixed word
    Expression generation = {};
    Word word = {};
    std::vector<Morphism> images = {};
    bool reversed = false;
};

/// Two words that depend on bound numbers, each a product of factors, are the same or different, or the left one begins or
/// ends with the right one: `word(F, n + 2) == word(F, n + 1) word(F, n)`.
struct ComparesWords {
    enum class Kind { equal, unequal, begins, ends };
    std::vector<WordFactor> left, right;
    Kind kind = Kind::equal;
    std::vector<BoundName> numbers = {};
};
/// "==", "!=", "begins with", "ends with".
std::string to_string(ComparesWords::Kind kind);

/// A system whose words are derived module by module derives the word: from `from` or its axiom, in so many
/// steps. The alphabet of the system has all letters of both words.
struct Rewrites {
    std::shared_ptr<const LSystem> system;
    ModuleWord word;
    std::optional<ModuleWord> from = {};
    std::uint64_t steps = 0;
    /// The system with its turtle, which environments follow.
    std::shared_ptr<const Model> written = {};
};

/// The derivation has exactly this probability.
struct HasChance {
    Rewrites derivation;
    Rational probability;
};

/// The limit set that the system draws has this dimension, or one at most as large.
struct HasDimension {
    std::shared_ptr<const Model> system;  // with the turtle
    ClaimedDimension dimension;
    std::string name = {};  // of the system
};

/// The boundary of the limit set has.
struct BoundaryHasDimension {
    std::shared_ptr<const Model> system;
    ClaimedDimension dimension;
    std::string name = {};
};

/// A first-order statement holds in the infinite word of a D0L system.
struct HoldsInWord {
    std::shared_ptr<const SourceSystem> system;
    std::shared_ptr<const FirstOrderStatement> says;
    std::map<std::string, std::string> coding =
        {};  // what letters are called that have other names
};

/// Numbers of places in the infinite word of a D0L system are in a linear relation.
struct CountsInWord {
    std::shared_ptr<const SourceSystem> system;
    std::shared_ptr<const CountingStatement> says;
    std::map<std::string, std::string> coding = {};
};

/// A real algebraic number that a claim names.
struct ClaimedNumber {
    Polynomial polynomial;  // irreducible, the leading coefficient above 0
    std::size_t root = 0;   // which of its real roots, in increasing order
    std::string text = {};  // as written
};

/// The critical exponent of the infinite word of a D0L system, compared with a number.
struct HasCriticalExponent {
    std::shared_ptr<const SourceSystem> system;
    Comparison comparison = Comparison::equal;
    ClaimedNumber number;
    std::map<std::string, std::string> coding = {};
};

/// Long factors of the words of a D0L system have a place where each word whose image they stand in is cut: the system is circular, with
/// a synchronising delay (Klouda and Starosta, Characterization of circular D0L-systems, 2019).
struct IsCircular {
    std::shared_ptr<const SourceSystem> system;
};

struct Statement;

/// Several statements as one.
struct Joint {
    enum class Kind {
        all,
        any,
        implies,
        iff
    } kind = Kind::all;  // `implies` and `iff` have two parts
    std::vector<Statement> parts;
};

/// A name that a quantifier binds, and what it ranges over.
struct QuantifiedName {
    std::string name;
    Domain domain;
    /// The family that a value must be of, beyond what the domain says: languages of a family are searched among
    /// finite ones.
    std::string family = {};
    /// A letter or a word stands in texts as this letter of the alphabet.
    std::optional<Symbol> letter = {};
    std::string text = {};  // what it ranges over, as the claim writes it: "0L languages"
};

/// A statement for all values of the bound names that meet conditions, or for some. The bound names are numbered
/// from `first` on; a quantifier inside another one goes on counting.
struct Quantified {
    bool universal = true;
    std::size_t first = 0;
    std::vector<QuantifiedName> bindings;
    bool disjoint = false;  // values have no letters in common
    /// Over these letters and no others; otherwise values are over any letters, and one of those that differ by a
    /// renaming stands for all.
    std::optional<std::vector<Symbol>> over = {};
    std::vector<Statement> conditions;
    std::vector<Statement> body;  // one
};

/// One thing that is said of languages and systems, true or false. A new form is a new alternative: the compiler
/// lists the judges and readers that miss it.
struct Statement {
    std::variant<InFamily, IsFinite, IsEmpty, EqualLanguages, IncludedIn, HasWord, HasSize, IsCode,
                 IsPalindrome, Derives, EqualSequences, EqualGrowth, HasGrowthClass, IsIncreasing,
                 ComparesNumbers, ComparesWords, Rewrites, HasChance, HasDimension,
                 BoundaryHasDimension, HoldsInWord, CountsInWord, HasCriticalExponent, IsCircular,
                 Joint, Quantified>
        says;
    bool negated = false;
    std::string text = {};  // as written
    Place place = {};
};

/// A statement and what the claim says of it: `theorem` is what the title puts into words, of which a claim has at
/// most one; the others are examples and steps, `refute` of what is false.
struct ClaimedStatement {
    Statement statement;
    enum class Purpose { show, lemma, refute, theorem } purpose = Purpose::show;
    std::string citation;  // `by ...`: the source it rests on where it is not decided
};

/// What a claim settles in the table of closure: families closed, or not closed, under an operation.
struct ClosureFact {
    bool closed = false;
    std::string operation;  // "union", "intersection with regular", ...
    std::vector<std::string> families;
    Place place;
    /// The theorem of theory/formal that says so of these families, "formal/OneTable.v:extended_union"; empty where the claim
    /// names none. It is not compiled here.
    std::string theorem = {};
};

/// A `.claim` file: definitions and statements about them.
struct Claim {
    std::string name;  // of the file
    std::string title, source;
    std::vector<std::string> notes;  // `note`, in the order of the file, printed by explanations
    bool empty_axiom = false;        // whether families of systems may have the empty word as axiom
    std::shared_ptr<const Alphabet> alphabet;
    /// By which values of bound names are written, where the claim binds names: a, b, ..., and x, y, ... for the letters
    /// that the inverse of a morphism leads to.
    std::vector<Symbol> instance_letters, inverse_letters;
    std::vector<std::shared_ptr<const SourceSystem>> systems;  // defined by the claim, in order
    /// Defined by the claim: systems whose words are derived module by module.
    std::vector<std::shared_ptr<const LSystem>> rewritings;
    std::vector<Language> languages;  // defined by the claim, each with its name
    std::vector<ClaimedStatement> statements;
    std::vector<ClosureFact> closure;
    /// The letters that complements are over: all of the file; none where nothing is a complement. In an instance of a
    /// statement about all values those of the values are added.
    std::vector<Symbol> letters = {};
};

struct Proof;

/// How far the instances of a quantified statement were gone through, in their order.
struct Searched {
    std::uint64_t instances = 0;  // that meet the conditions
    std::uint64_t visited = 0;    // with those that do not
    std::uint64_t size = 0;       // of the last one
    std::uint64_t undecided = 0;  // of the instances before the witness
    bool all = false;             // there are no others
    bool finite_only =
        false;             // names range over languages, of which only finite ones are instances
    bool witness = false;  // the last one is a counterexample or an example
};

/// What is known of a statement, and how. The proof is of the statement where it is proved and of its opposite
/// where it is refuted; there is none where it is undecided. Three functions read it: `sentences`,
/// `certificate` and `latex`.
struct Answer {
    Truth truth = Truth::undecided;
    std::shared_ptr<const Proof> proof;
    std::vector<std::string> tried;         // where it is undecided
    std::optional<Searched> searched = {};  // of a quantified statement
    bool out_of_time = false;               // undecided because the time was over
};

/// How far a search has come without a witness: of the instances up to here none is one.
struct SearchedSoFar {
    std::uint64_t visited = 0;    // the instances
    std::uint64_t instances = 0;  // that meet the conditions
    std::uint64_t undecided = 0;
    std::uint64_t size = 0;   // of the last one
    bool is_partial = false;  // some morphisms were not tried
};

/// How far instances are searched where a quantifier has no bounds: up to a number of them and a size, whichever
/// comes first.
struct SearchLimits {
    std::uint64_t instances = 100'000;
    std::uint64_t size = 10;
    unsigned threads = 0;          // 0: as many as the machine has; the answer is the same
    Progress* progress = nullptr;  // told how many of the instances were looked at
    std::optional<SearchedSoFar> from = {};  // a search of the same statement goes on from here
    std::function<void(const SearchedSoFar&)> on_searched = {};  // when more are looked at
    bool is_instance =
        false;  // the statement is one instance: systems that are found need not be small
};

/// The answer to the opposite statement, by the same proof.
Answer opposite(Answer answer);

/// The argument, or what was tried, over the alphabet of the languages: one sentence or line each; an indented
/// line belongs to the one before.
std::vector<std::string> sentences(const Answer& answer, const Alphabet& alphabet);

/// The proof as a certificate holds it (CERTIFICATES.md), which the room `verify` checks again; null where there
/// is none.
nlohmann::ordered_json certificate(const Answer& answer, const Alphabet& alphabet);

/// The argument as LaTeX: paragraphs with words, systems, languages and numbers in mathematics, for documents that
/// load amsmath. Indented lines are indented paragraphs.
std::string latex(const Answer& answer, const Alphabet& alphabet);

/// An answer that has been put into sentences.
struct Judgement {
    Truth truth = Truth::undecided;
    std::vector<std::string> argument;
};
Judgement in_sentences(const Answer& answer, const Alphabet& alphabet);

/// What is known of a statement of a claim. A bound that is reached makes it undecided, and the answer says
/// which. Throws Interrupted if the work was asked to stop, Error where the statement cannot be about its systems.
Answer decide(const Statement& statement, const Claim& claim, const Budget& budget = {},
              const SearchLimits& limits = {});

/// What may be used besides the language itself.
struct FamilyQuestion {
    std::string family;        // REG, CF or a family of L-systems, as `system_form` reads it
    bool empty_axiom = false;  // whether the empty word may be an axiom
    std::vector<std::shared_ptr<const SourceSystem>> systems;  // that may generate the language
    bool small = true;  // rules that are not needed are left out of a system that is found
};

/// Whether the language is of the family. Finite languages are decided for 0L, P0L, D0L, PD0L, T0L, PT0L, DT0L,
/// PDT0L; families that have all finite languages, and regular expressions for REG and CF, by theorem. Another
/// language is proved to be of the family if it is given by a system of the form, equal to the language of one of
/// `systems`, or made by operations under which the family is closed. Of an infinite regular language a small system for these eight families is looked
/// for, and some are refuted (regular_family.cpp), as are some languages of powers and languages over one letter; for REG and CF
/// the language of a D0L system that is too sparse. Otherwise the question is undecided.
///
/// Throws Error if the family has no such name, what budget.check throws, BoundReached where a table is too large.
Answer judge_family(const Language& language, const FamilyQuestion& question,
                    const Alphabet& alphabet, const Budget& budget = {});

// How many words a language has. All throw what budget.check throws, BoundReached where a table is too large.

/// Whether the language is finite: worked out where it can be, otherwise by a part of it that is not.
Answer judge_finite(const Language& language, const Alphabet& alphabet, const Budget& budget = {});

/// Whether it has no word.
Answer judge_empty(const Language& language, const Alphabet& alphabet, const Budget& budget = {});

/// Whether it has exactly so many words.
Answer judge_size(const Language& language, const Integer& size, const Alphabet& alphabet,
                  const Budget& budget = {});

/// The result for one statement of a claim. It holds if it is as the claim says: proved, or refuted where the claim
/// says `refute`. A statement is cited if it is undecided here, not as the time was over, and rests on a source that the claim names.
struct CheckedStatement {
    /// `formally`: what is cited is a theorem in Coq, whose compiled proof stands beside. `check` never says that; who finds the
    /// proof does.
    enum class Outcome { holds, formally, cited, undecided, fails };
    Outcome outcome = Outcome::undecided;
    Answer answer;

    /// Whether it rests on what the claim cites, and not on its answer.
    bool is_by_citation() const {
        return outcome == Outcome::cited || outcome == Outcome::formally;
    }

    /// Whether it is about all values that meet conditions, and none was found that does.
    bool is_vacuous() const;
};

/// What a claim comes to: the verdict on its theorem, or `examples` where it has none and its statements hold.
/// `refuted` if anything in it fails, `vacuous` if no instance of the theorem meets its conditions.
enum class ClaimVerdict { proved, formally, examples, cited, vacuous, undecided, refuted };

/// "proved", "proved formally", "examples", ...
std::string_view to_string(ClaimVerdict verdict);

/// The result for a claim: one entry for each of its statements.
struct CheckedClaim {
    Claim claim;
    std::vector<CheckedStatement> statements;

    ClaimVerdict verdict() const;
    /// Which of the statements is the theorem, if the claim has one.
    std::optional<std::size_t> theorem() const;
    /// How many statements that are not the theorem hold, and how many there are.
    std::pair<std::size_t, std::size_t> examples() const;
    /// The worst of all statements, of `fails`, `undecided`, `cited`, `formally`, `holds`.
    CheckedStatement::Outcome worst() const;
};

/// Decides all statements of a claim. One that cannot be about its systems is undecided, and its answer says why. Throws
/// what `decide` throws beside Error.
CheckedClaim check(Claim claim, const Budget& budget = {}, const SearchLimits& limits = {});

/// "proved", "refuted", "proved formally", "cited", "vacuous" or "undecided": what is known of the statement, whatever the claim says of it.
std::string verdict_text(const CheckedStatement& checked);

/// The name of the method by which a certificate calls the proof: "instance", "cases", "form", ...; empty where there
/// is none.
std::string method_of(const Answer& answer, const Alphabet& alphabet);

/// The values that refute a universal statement, or prove that there are some: names and texts, as "A" and "{a}".
/// `other`: the first ones that make a language with a word that is not empty, where the least do not.
std::vector<std::pair<std::string, std::string>> witness_of(const Answer& answer,
                                                            const Alphabet& alphabet,
                                                            bool other = false);

/// The claim as a page: its title and source, the definitions, its notes, then each statement with its verdict
/// and the argument in sentences, in lines of at most 100 characters. With a family, what is said of a language
/// and other families is left out where the same is said of this one.
std::string explanation(const CheckedClaim& checked, const std::string& family = {});

/// The claim as a certificate (CERTIFICATES.md).
nlohmann::ordered_json certificate(const CheckedClaim& checked);

/// The claim as LaTeX, a section for a document that loads amsmath and amsthm: each statement as a numbered
/// paragraph with its verdict, and a `proof` environment with the argument where it stands.
std::string latex(const CheckedClaim& checked);

// --- Censuses ---
//
// A census asks the same of all instances up to a size. They are cut into chunks: stretches of a fixed number of instances of
// one size, in the order of the room search, numbered from 0 on through all sizes; each size has at least one chunk. How the
// chunks are cut depends on nothing else, so any threads and processes may take any of them, and the sum is the same.

/// How many instances of each size there are, and of how many each of some statements is true. Or, if languages are
/// counted: of how many languages, up to renaming, a system of this size is a smallest one.
struct Census {
    struct Row {
        std::uint64_t size = 0;
        Integer instances = 0;
        /// By statement: of how many it is proved, refuted, undecided.
        std::vector<std::array<std::uint64_t, 3>> verdicts;
        /// If languages are counted: systems of this size with an infinite language, which are not told apart, and
        /// those of which it is not known whether it is.
        std::uint64_t infinite = 0, open = 0;
    };
    std::vector<Row> rows;  // sizes 1, 2, ...
    std::vector<std::vector<std::string>>
        first;             // by statement: the first instances of which it is proved
    bool is_whole = true;  // no chunk is missing
};

/// What is found of the instances of one chunk.
struct CensusChunk {
    std::uint64_t number = 0, size = 0;
    bool is_last = false;  // of its size
    Integer instances = 0;
    std::vector<std::array<std::uint64_t, 3>> verdicts = {};
    std::vector<std::vector<std::string>> first = {};
    /// If languages are counted: the finite ones, each once, as texts of `Instance` that are the same up to renaming,
    /// and a letter p, r or u for each statement.
    std::vector<std::pair<std::string, std::string>> languages = {};
    std::uint64_t infinite = 0, open = 0;
    bool operator==(const CensusChunk&) const = default;
};

/// A chunk as a line of JSON, without the end of the line.
///
/// Example: census_chunk(census_line({.number = 3, .size = 2}))->number == 3
std::string census_line(const CensusChunk& chunk);
/// The chunk of such a line; nothing where it is torn.
///
/// Example: !census_chunk(census_line({}).substr(0, 20))
std::optional<CensusChunk> census_chunk(const std::string& line);

struct CensusOptions {
    std::size_t first = 0;  // how many instances of each statement are kept, as texts of `Instance`
    bool languages = false;      // languages of systems are counted, each once
    std::uint64_t chunk = 1000;  // instances of a chunk
    unsigned threads = 0;        // 0: as many as the machine has; the result is the same
    /// The number of the chunk to be taken next, greater than those before; nothing if there are no more to take.
    /// Otherwise all are taken that are not known yet.
    std::function<std::optional<std::uint64_t>()> next = {};
    std::function<void(const CensusChunk&)> on_chunk = {};  // when one is done
    bool finishes_chunks = false;  // a chunk that is begun is done before the work stops
};

/// The sum of chunks, which may come in any order, and more than once. Memory: a few bytes a chunk; where languages are counted,
/// each of them once.
class CensusTotals {
public:
    /// `size` is the largest size, `properties` the number of statements.
    CensusTotals(std::uint64_t size, std::size_t properties, const CensusOptions& options);

    void add(const CensusChunk& chunk);
    bool has(std::uint64_t number) const;
    /// The number of the last chunk of a size, where that chunk is known.
    std::optional<std::uint64_t> last_chunk(std::uint64_t size) const;
    /// Whether all chunks of a size are known, and of all sizes before it.
    bool has_size(std::uint64_t size) const;
    Census census() const;

private:
    struct Found {
        std::uint64_t chunk = 0, place = 0, size = 0;
        std::string verdicts;
    };
    std::size_t kept_;
    bool languages_;
    std::vector<char> known_;  // by number of a chunk
    std::uint64_t first_unknown_ = 0;
    std::vector<std::optional<std::uint64_t>> last_;  // by size
    std::vector<Census::Row> rows_;
    /// By statement: chunk, place and text, the first ones.
    std::vector<std::vector<std::tuple<std::uint64_t, std::size_t, std::string>>> first_;
    std::map<std::string, Found> found_;  // languages
};

/// The largest size of the census of these names. Throws Error if nothing bounds it.
std::uint64_t census_size(const Quantified& said);

/// Takes the chunks that `options.next` names and adds them to `totals`. The properties are statements in which the names
/// stand; without any, D0L and PD0L systems are counted and not visited. Languages are counted of one system, by statements
/// about L(X): that it is finite, empty, of a family. Where finite languages decide a statement there is a verdict and no
/// proof.
///
/// Throws Error where languages cannot be counted, and what budget.check throws. Every caller of chunks goes through the
/// instances before them, about 10^6 a second, but for plain D0L systems and sizes that `totals` knows.
void take_census(const Quantified& said, const std::vector<Statement>& properties,
                 const Claim& claim, const CensusOptions& options, CensusTotals& totals,
                 const Budget& budget = {});

/// Instances drawn by a seed from those that a census of all chunks counted, all equally likely, each once; and for each
/// the properties as statements, decided with proofs: a claim for a certificate. Not of a census of languages. Throws Error if
/// there are no statements or a chunk is missing, or if a verdict differs from that of the census, which is a defect of this
/// room; and what `decide` throws.
CheckedClaim census_sample(const Quantified& said, const std::vector<Statement>& properties,
                           const Claim& claim, const Census& census, std::uint64_t count,
                           std::uint64_t seed, const Budget& budget = {});

// --- The table of closure ---

/// The operations and the families of the table of closure, in its order.
///
/// Example: closure_operations().front() == "union"
const std::vector<std::string>& closure_operations();
/// Example: closure_families().front() == "REG"
const std::vector<std::string>& closure_families();

/// The statement that a family is closed under an operation: `for all 0L languages A, B: A | B is 0L`, whose names have
/// numbers from `first` on. Where that it is not `closed` is to be shown, it may be about a special case: homomorphisms for gsm
/// mappings. Nothing for complement, whose letters are those of no instance, and for operations of which only a special
/// case can be said.
///
/// Example: closure_statement("0L", "star", true, 0)->text == "for all 0L languages A: A* is 0L"
/// Example: !closure_statement("0L", "gsm mapping", true, 0)
std::optional<Statement> closure_statement(const std::string& family, const std::string& operation,
                                           bool closed, std::size_t first);

/// The claim that a family is closed under an operation, or that it is not, with that statement as its theorem. That it is not
/// may be proved by a finite counterexample: nothing for families that have all finite languages.
///
/// Example: closure_claim("0L", "union", false)->statements.at(0).statement.negated
std::optional<Claim> closure_claim(const std::string& family, const std::string& operation,
                                   bool closed);

/// Which families of languages are closed under which operations, and which claim is about it.
class ClosureTable {
public:
    struct Cell {
        bool closed = false;
        std::size_t claim = 0;  // index into the claims
    };

    /// Throws Error if two claims settle one cell, with the places of both.
    explicit ClosureTable(const std::vector<Claim>& claims);

    /// What is settled about a family and an operation, if anything is.
    std::optional<Cell> cell(std::string_view family, std::string_view operation) const;

private:
    std::map<std::pair<std::string, std::string>, Cell, std::less<>> cells_;
};

}  // namespace algae
