#pragma once

#include <nlohmann/json_fwd.hpp>
#include <tuple>

#include <algorithm>
#include <array>
#include <compare>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "exact/exact.hpp"
#include "word/word.hpp"

// verify: certificates, checked again by means that share nothing with the search that found them. This room reads the JSON of
// CERTIFICATES.md into statements and proofs, each with the path and line of its field, and checks each proof by definitions
// only: it has its own reader, languages, derivations and matrices. If a proof does not show its statement, the flaw is reported
// with its place; if the work is stopped, nothing is judged.

namespace algae::verify {

/// A value of a JSON text with the line where it stands. Objects keep their members in order.
struct JsonValue {
    enum class Kind { null, truth, number, real, text, list, object, too_large };
    Kind kind = Kind::null;
    bool truth = false;
    std::uint64_t number = 0;  // whole and not negative; other numbers are `real`
    std::string text;
    std::vector<JsonValue> items;   // of a list or object
    std::vector<std::string> keys;  // of an object, one for each item
    std::size_t line = 0;           // counts from 1
};

/// Whether two values are the same, wherever they stand.
bool same_value(const JsonValue& left, const JsonValue& right);

/// A text that comes in pieces: puts at most so many characters there and gives their number, 0 at the end.
using TextSource = std::function<std::size_t(char* to, std::size_t most)>;

/// A text as a source, which it must outlive.
TextSource source_of(std::string_view text);

/// One list of the outermost object whose elements are handed over one by one and then forgotten. It must be the last
/// field of the object.
struct Elements {
    std::string_view list;
    std::function<void(JsonValue)> before;  // takes the fields before the list
    std::function<void(const JsonValue&)> each =
        {};  // `too_large` where the memory does not hold the element
};

/// The value of a JSON text, without the elements that were handed over. Reads 64 KiB at a time. Throws Error, which names
/// the line, if the text is not JSON, has a member twice in one object or is followed by something else; BoundReached
/// where lists and objects are nested deeper than 1000 levels, or where what is kept takes more than a quarter of the memory of the
/// budget.
///
/// Example: algae::verify::parse_json(algae::verify::source_of("[1,\n\"a\"]"), "x").items.at(1).line == 2
JsonValue parse_json(const TextSource& text, const std::string& file, const Budget& budget = {},
                     const Elements& elements = {});

/// What is wrong with a proof, and where.
struct Flaw {
    std::string path;
    std::size_t line = 0;
    std::string reason;
};

/// A value of a certificate and its path: "statements[2].proof.cases[0]". If the value is not what is asked for, an Error
/// names the path and the line.
class Field {
public:
    Field(const JsonValue& value, std::string path, const std::string& file)
        : value_(&value), path_(std::move(path)), file_(&file) {}

    const std::string& path() const { return path_; }
    std::size_t line() const { return value_->line; }
    JsonValue::Kind kind() const { return value_->kind; }
    const JsonValue& value() const { return *value_; }

    /// Throws Error if this is not an object or has a field that is not named here.
    void only(const std::vector<std::string_view>& names) const;
    bool has(std::string_view name) const;
    /// A field of an object. Throws Error if it is missing.
    Field at(std::string_view name) const;
    /// The elements of a list.
    std::vector<Field> list() const;
    /// The two elements of a list of two.
    std::pair<Field, Field> pair() const;
    /// The fields of an object.
    std::vector<std::pair<std::string, Field>> object() const;
    const std::string& text() const;
    bool truth() const;
    std::uint64_t number() const;
    /// A number or a string of digits; a minus sign before the digits only where `negative`.
    Integer integer(bool negative = false) const;

    /// The certificate is not well formed: throws Error.
    [[noreturn]] void fail(const std::string& what) const;
    /// The proof is wrong: throws Flaw.
    [[noreturn]] void refuse(const std::string& why) const;

private:
    Field inside(const JsonValue& value, const std::string& step) const {
        return {value, path_ + step, *file_};
    }
    void expect(JsonValue::Kind kind, const char* what) const;

    const JsonValue* value_;
    std::string path_;
    const std::string* file_;
};

/// An L-system as a certificate has it: a word and tables of successors, with terminals; or
/// rules with context, of which those with the same contexts are a choice.
struct System {
    /// The successors of each letter, by symbol: at least one.
    using Successors = std::vector<std::vector<Word>>;
    struct Rule {
        Word left;
        Symbol letter = 0;
        Word right, successor;
        bool operator==(const Rule&) const = default;
    };

    Word axiom;
    std::vector<Successors> tables;  // at least one where there is no context
    std::vector<char> terminal;      // by symbol
    bool context = false;
    std::vector<Rule> rules;    // with context
    std::vector<char> ignored;  // with context, by symbol

    bool operator==(const System&) const = default;
};

/// The letters that can occur in a word derived from this one, in increasing order.
std::vector<Symbol> accessible_letters(const System& system, const Word& from);

/// Whether every letter that is accessible from the axiom is a terminal.
bool has_only_terminals(const System& system);
/// Whether it is a D0L system: no context, one table, one successor for each accessible letter, and all
/// accessible letters are terminals.
bool is_d0l(const System& system);

/// The letters from which some derivation by this table goes on for ever without becoming empty.
std::set<Symbol> lasting_letters(const System::Successors& table);

/// Whether an 0L system is found to derive infinitely many words: some letter derives a word that contains it again, and the
/// successor of the first rule also contains a lasting letter. False for systems with several tables or with letters
/// that are not terminals.
bool is_endless(const System& system);

/// Whether there is one table without contexts by which each accessible letter may stay as it is, so that letters may be
/// rewritten one at a time: the system is a context-free grammar.
bool rewrites_singly(const System& system);

/// Why the system does not have the form of a family, in words; nothing if it has that form. The families are
/// 0L, T0L, E0L and ET0L, with or without P and D in front, and IL. `empty_axiom`: whether the empty word may be
/// the axiom.
std::optional<std::string> beyond_form(const System& system, const std::string& family,
                                       bool empty_axiom);

/// What the letter at this place of a word may become by a system with context: its successors, each once.
std::vector<Word> successors_at(const System& system, const Word& word, std::size_t place);
/// The next words of a system with context, those of at most so many letters. Throws BoundReached if they take more than the budget.
std::set<Word> next_words(const System& system, const Word& word, std::size_t most,
                          const Budget& budget);
/// Whether a step of a system with context can take one word to the other.
bool may_give(const System& system, const Word& from, const Word& to);
/// Whether a step by this table can take one word to the other.
bool may_give(const System::Successors& table, const Word& from, const Word& to);
/// Whether no rule has the empty successor.
bool never_shrinks(const System& system);

/// A letter with its parameters.
struct Module {
    std::string letter;
    std::vector<QuadraticNumber> values;
    bool operator==(const Module&) const = default;
    bool operator<(const Module& other) const {
        if (letter != other.letter) return letter < other.letter;
        const auto before = [](const QuadraticNumber& a, const QuadraticNumber& b) {
            return std::tie(a.rational, a.factor, a.radicand) <
                   std::tie(b.rational, b.factor, b.radicand);
        };
        return std::lexicographical_compare(values.begin(), values.end(), other.values.begin(),
                                            other.values.end(), before);
    }
};
using Modules = std::vector<Module>;

/// An expression as a tree.
struct Term {
    enum class Kind { number, parameter, operation };
    Kind kind = Kind::number;
    Rational number;
    std::string name;  // of a parameter or an operation
    std::vector<Term> parts;
};

/// A word of modules as it is written: numbers may be expressions.
using WrittenModules = std::vector<std::pair<std::string, std::vector<Term>>>;

/// A system whose words are derived module by module.
struct ModuleSystem {
    /// A module in a rule: a letter and the names of its parameters.
    struct Pattern {
        std::string letter;
        std::vector<std::string> parameters;
        bool operator==(const Pattern&) const = default;
    };
    struct Rule {
        Pattern module;
        std::vector<Pattern> left, right, elsewhere;
        std::optional<Term> condition;
        std::optional<Rational> probability;
        WrittenModules successor;
    };
    WrittenModules axiom;
    std::vector<Rule> rules;
    std::set<std::string> ignored;  // not seen when contexts are matched
};

/// Throw Error if the field is not as CERTIFICATES.md says.
ModuleSystem module_system(const Field& field);
WrittenModules modules(const Field& field);
Rational probability(const Field& field);

/// What the names in the expressions of a rule stand for.
using Bindings = std::map<std::string, QuadraticNumber>;

/// The value of an expression. Throws Flaw (at `proof`) if it does not exist, BoundReached if it
/// uses a function that is not arithmetic.
QuadraticNumber value(const Term& term, const Bindings& names, const Field& proof);
/// The same for all numbers of a word.
Modules values(const WrittenModules& word, const Bindings& names, const Field& proof);

/// The possible successors of a module with their probabilities; empty if the module stays.
using Choices = std::vector<std::pair<Rational, Modules>>;

/// The choices of the module at a position of a word: of the rules that match there, the first of those with the most
/// modules in their contexts, and all rules with the same contexts. Throws what `value` throws, and Flaw if their
/// probabilities do not add up to 1.
Choices choices(const ModuleSystem& system, const Modules& word, std::size_t position,
                const Field& proof);

/// The probability that a word derives the other in this number of steps. If no rule has a context, it is computed by
/// recursion: the probability that a module derives a part of the other word is a sum over its rules, of the probability
/// that the successor derives it in one step less; that of a word is a sum over all places where the part of its first
/// modules may end. This is cubic in the length of the other word. If some rule has a context, all words are
/// derived; BoundReached if there are more than 10,000. Throws what `choices` throws.
Rational chance(const ModuleSystem& system, const Modules& from, const Modules& to,
                const Integer& steps, const Field& proof, const Budget& budget);

/// The words made of powers of words, for all values of one or two numbers from their least ones on.
struct Powers {
    /// coefficient * number^power * base^number; the number is 0 or 1.
    struct Term {
        Integer coefficient = 1;
        std::size_t number = 0;
        std::uint64_t power = 0;
        Integer base = 1;
        bool operator==(const Term&) const = default;
    };
    struct Block {
        Word word;
        std::vector<Term> exponent;
        bool operator==(const Block&) const = default;
    };
    std::vector<Block> blocks;
    std::vector<std::string> names;    // of the numbers
    std::vector<std::uint64_t> least;  // of each
    bool operator==(const Powers&) const = default;
};

struct Tree;
/// An expression for a language.
using Language = std::shared_ptr<const Tree>;

/// One node of such an expression.
struct Tree {
    enum class Kind {
        words,
        generated,
        united,
        intersection,
        difference,
        concatenation,
        star,
        plus,
        reversal,
        complement,
        image,
        inverse_image,
        variable,  // a bound name without a value
        powers
    };
    Kind kind = Kind::words;
    std::vector<Word> words;               // in shortlex order, each once
    std::shared_ptr<const System> system;  // of `generated`; null for a bound name without a value
    std::string name;                      // of the system, or bound
    std::vector<Language> parts;
    std::vector<Symbol> letters;      // of a complement, increasing
    std::map<Symbol, Word> morphism;  // of an image or inverse image
    std::shared_ptr<const Powers> powers;
    std::size_t depth = 1;  // of what was combined
};

Language words_of(std::vector<Word> words);
Language generated_by(std::shared_ptr<const System> system, std::string name);
Language combination(Tree::Kind kind, std::vector<Language> parts,
                     std::map<Symbol, Word> morphism = {});

/// Whether the expressions are the same, whatever their systems are called.
bool same(const Language& left, const Language& right);
/// Whether no system occurs in the expression.
bool is_regular(const Language& language);

/// One system of the certificate.
struct NamedSystem {
    std::string name;
    std::shared_ptr<const System> system;
};

/// A statement about all values of bound names, or some. Its conditions and its body are read again for each instance.
struct Quantified {
    struct Name {
        std::string name, of;                       // what it ranges over: "0L languages"
        std::optional<std::uint64_t> size, length;  // at most: of the value, of each word
        std::optional<std::uint64_t> most = {};     // of a number
    };
    bool universal = true;
    std::vector<Name> names;
    bool different_letters = false;
    std::optional<std::vector<Symbol>> over;
    std::vector<Field> conditions;
    std::vector<Field> body;  // one
};

/// A factor of a word that depends on bound numbers: a generation of a system, or a fixed word; then its images, the first one
/// first; in the end perhaps written backwards.
struct WordFactor {
    NamedSystem system;               // of a generation
    std::optional<Field> generation;  // a term
    Word word;
    std::vector<std::map<Symbol, Word>> images;
    bool reversed = false;
};

/// A linear term.
struct LinearSum {
    std::map<std::string, Integer> of;  // how often each number is taken; none of them 0
    Integer plus = 0;
};

/// A first-order statement about an infinite word. Every name is bound by one quantifier.
struct Formula {
    enum class Kind {
        equation,     // terms[0] is 0
        less,         // terms[0] is below 0
        same_letter,  // the letters at terms[0] and terms[1] are the same
        letter,       // the letter at terms[0] is `letter`
        equal,        // the factors of terms[2] letters at terms[0] and terms[1] are the same
        palindrome,   // the factor of terms[1] letters at terms[0] is one
        negation,
        conjunction,
        disjunction,
        implication,
        equivalence,  // of any number of parts, from left to right
        exists,
        for_all
    };
    Kind kind;
    std::vector<LinearSum> terms = {};
    std::string letter = {};
    std::vector<std::string> names = {};  // that a quantifier binds
    std::vector<Formula> parts = {};
};

/// For all n >= from, the sum of so many times the number of i that make a statement true, and slope n + plus, is 0. Free in the statements
/// are i and n.
struct CountedPlaces {
    std::vector<std::pair<Integer, Formula>> parts;
    Integer slope = 0, plus = 0, from = 0;
};

/// One of the real roots of an irreducible polynomial, by its place among them in increasing order.
struct RealRoot {
    Polynomial polynomial;
    std::size_t root = 0;
};

/// A statement, without any "not" in front of it.
struct Statement {
    enum class Kind {
        family,
        finite,
        empty,
        equal,
        included,
        member,
        size,
        code,
        prefix_code,
        palindrome,
        derives,
        rewrites,
        chance,
        equal_sequences,
        equal_growth,
        growth_class,
        increasing,
        numbers,
        words,
        dimension,
        boundary,
        first_order,
        counts,
        critical_exponent,
        circular,
        joint,
        quantified
    };
    Kind kind = Kind::family;
    bool negated = false;
    std::string
        family;  // or class of growth; how numbers or words are compared; of a dimension, the system
    std::vector<Language> languages;
    std::vector<NamedSystem> systems;
    Word word;
    std::optional<Word> from;
    std::optional<Integer> steps;
    /// Instead of `steps` where their number depends on bound numbers: how often each is taken; the constant goes by "1".
    std::optional<std::map<std::string, Integer>> bound_steps = {};
    std::optional<Integer> size;      // or degree of growth
    std::optional<Field> formula;     // the value of a dimension
    std::string compared = "equals";  // or "at most", "at least": how the dimension is to it
    std::shared_ptr<const ModuleSystem> rewriting;  // called `family`
    WrittenModules modules;
    std::optional<WrittenModules> modules_from;
    std::optional<Rational> probability;
    bool strictly = false;                       // of increasing lengths
    std::vector<Field> terms;                    // two numbers that are compared
    std::vector<std::vector<WordFactor>> sides;  // two words that are compared
    std::vector<Statement>
        parts;  // joined as `family` says; of a quantified statement, conditions and body as they stand
    std::shared_ptr<const Quantified> quantified;
    std::shared_ptr<const Formula> first_order;
    std::shared_ptr<const CountedPlaces> counted;
    std::shared_ptr<const RealRoot> number;  // that a critical exponent is compared with
    std::map<Symbol, std::string>
        coding;  // what letters of its word are called, if not their names
};

/// One statement of a certificate and its verdict.
struct Entry {
    Field field;
    std::string text;
    Statement statement;
    enum class Verdict { proved, refuted, undecided, cited } verdict = Verdict::undecided;
    std::optional<Field> proof;  // of one proved or refuted
    std::string citation;
};

/// What the statements of a certificate speak of. The fields refer to `header` and `file`.
struct Certificate {
    std::string file;
    JsonValue header;  // all but the statements
    std::string claim, source;
    bool empty_axiom = false;  // whether the empty word may be the axiom of a system
    std::shared_ptr<const Alphabet> alphabet;
    std::map<std::string, std::shared_ptr<const System>> systems;
    std::map<std::string, std::shared_ptr<const ModuleSystem>> rewritings;
};

/// What bound names stand for while a quantified statement is read; those without a value stay names.
struct BoundNames {
    using Images = std::map<Symbol, std::vector<Word>>;

    std::map<std::string, Language> languages;
    std::map<std::string, std::shared_ptr<const System>> systems;
    std::map<std::string, std::optional<Images>> morphisms;
    std::map<Symbol, Word> words;  // by the letter that a bound word is in texts
    std::set<Symbol> open_words;   // those without a value
    std::map<std::string, std::optional<Integer>> numbers;
};

/// Reads the parts of a certificate. All functions throw Error if the text is not as CERTIFICATES.md says.
class Reader {
public:
    using Systems = std::map<std::string, std::shared_ptr<const System>>;

    using Rewritings = std::map<std::string, std::shared_ptr<const ModuleSystem>>;

    /// All must outlive this.
    Reader(const Alphabet& alphabet, const Systems& systems, const Rewritings& rewritings)
        : alphabet_(alphabet), systems_(systems), rewritings_(rewritings) {}

    const Alphabet& alphabet() const { return alphabet_; }
    const BoundNames& bound() const { return bound_; }

    Symbol letter(const Field& field) const;
    Word word(const Field& field) const;
    std::vector<Word> words(const Field& field) const;
    System system(const Field& field) const;
    NamedSystem named_system(const Field& field) const;
    /// The system of a name within the text of the field.
    NamedSystem named_system(const Field& field, const std::string& name) const;
    Language language(const Field& field) const;
    /// Powers of words, as a language.
    Language powers(const Field& field) const;
    Statement statement(const Field& field) const;
    /// The images of letters, as a certificate has those of a morphism or a substitution.
    BoundNames::Images images(const Field& field, bool several) const;

    /// A reader that knows these names besides its own.
    Reader with(const BoundNames& names) const;

private:
    Symbol symbol(const Field& field, std::string_view name) const;
    /// One that no word is bound to: what stands for a word stands for it in words only.
    Symbol free_symbol(const Field& field, std::string_view name) const;
    bool is_bound(const std::string& name) const;
    /// Throws BoundReached where a word is bound.
    void must_have_no_words(const char* what) const;
    /// Distinct letters, increasing.
    std::vector<Symbol> letters(const Field& field) const;
    /// The letters of the values of bound names.
    std::set<Symbol> letters_of_values() const;
    std::map<Symbol, Word> morphism(const Field& field) const;
    System::Successors table(const Field& field) const;
    System with_context(const Field& field) const;
    bool of_languages(const Field& field, Statement& read) const;
    bool of_pairs(const Field& field, Statement& read) const;
    Statement of_modules(const Field& field, Statement read) const;
    Statement of_dimension(const Field& field, Statement read) const;
    Statement of_systems(const Field& field, Statement read) const;
    bool of_numbers(const Field& field, Statement& read) const;
    void steps_of(const Field& field, Statement& read) const;
    std::vector<WordFactor> word_factors(const Field& field) const;
    Statement joint(const Field& field, std::string_view kind) const;
    Statement quantified(const Field& field) const;
    Language bound_image(Tree::Kind kind, const Field& field) const;

    BoundNames bound_;
    const Alphabet& alphabet_;
    const Systems& systems_;
    const Rewritings& rewritings_;
};

}  // namespace algae::verify

namespace algae {

/// A family of languages of L-systems without context: 0L, with T (tables), D (deterministic: one
/// successor a letter, in each table) and P (propagating: no empty successor), as in Rozenberg and
/// Salomaa 1980.
struct Family {
    bool propagating = false;
    bool deterministic = false;
    bool tables = false;

    bool operator==(const Family&) const = default;
};

/// The name as the textbooks write it.
///
/// Example: to_string(Family{.propagating = true, .tables = true}) == "PT0L"
std::string to_string(Family family);

/// The family of this name. Throws Error if there is no such family.
///
/// Example: family_named("PD0L") == Family{true, true, false}
Family family_named(std::string_view name);

/// 0L, P0L, D0L, PD0L, T0L, PT0L, DT0L, PDT0L.
const std::array<Family, 8>& all_families();

/// A finite set of words: each once, shorter words first, then by symbol numbers.
struct FiniteLanguage {
    std::shared_ptr<const Alphabet> alphabet;
    std::vector<Word> words;

    bool contains(const Word& word) const;
    bool operator==(const FiniteLanguage& other) const {
        return *alphabet == *other.alphabet && words == other.words;
    }
};

/// The language of these words, in any order and with any repetitions.
FiniteLanguage make_finite_language(std::shared_ptr<const Alphabet> alphabet,
                                    std::vector<Word> words);

/// The same with one character a letter, for tests and examples; letters are numbered in code order.
///
/// Example: to_string(finite_language({"aa", "", "a"})) == "{ε, a, aa}"
FiniteLanguage finite_language(const std::vector<std::string>& words);

/// The symbols that occur in some word, in increasing order.
std::vector<Symbol> letters_of(const FiniteLanguage& language);

/// The words between braces. Symbols are printed by name, the empty word as ε.
std::string to_string(const FiniteLanguage& language);

/// One production letter -> image.
struct LetterRule {
    Symbol letter = 0;
    Word image;

    bool operator==(const LetterRule&) const = default;
    bool operator<(const LetterRule& other) const {
        return std::tie(letter, image) < std::tie(other.letter, other.image);
    }
};

/// Why a rule is not in any table that keeps the language closed, given the rules that are still possible
/// and the rules that are known to be there. Either (`images` is empty) no choice of one possible rule for each letter of
/// `word`, this rule among them, sends `word` into the language; or `images`, letter by
/// letter, is a derivation step that leaves the language and uses this rule and otherwise only rules that are there.
struct ExcludedRule {
    LetterRule rule;
    Word word;
    std::vector<Word> images;
};

/// A proof by cases that no rules left over can generate the language (or, for a table, keep it closed).
struct ObstructionCase {
    enum class End {
        no_image,  // `letter` has no possible rule left
        needed,    // the rule excluded last is known to be there
        sources,   // two disjoint sets of words, neither reached from outside it, or {ε} alone
        conflict,  // a step from `word` leaves the language: one of `rules`, the rules it uses that
        // are not known to be there, is missing. In case i it is rules[i], and the rules before it are there
        choice  // one of `rules`, the possible rules of `letter`, is its only one
    };
    std::vector<ExcludedRule> excluded;  // one after the other
    End end = End::no_image;
    Symbol letter = 0;
    std::vector<std::vector<Word>> sources;
    Word word;  // of a conflict: `word` and what each of its letters becomes
    std::vector<Word> images;
    std::vector<LetterRule> rules;
    std::vector<ObstructionCase> cases;  // one for each of `rules`
};

/// Rules that are together in no table that keeps the language closed.
struct ImpossibleTable {
    std::vector<LetterRule> rules;
    ObstructionCase why;
};

/// Why a finite language is not in a family: data that can be checked without any search. At first
/// all factors of words of the language are possible images of every letter (in a propagating
/// family, all but ε): what the letter becomes is a factor of a word of the language.
///
/// Without tables `root` speaks of the rules of the system. With tables it speaks of all tables at
/// once, and every step into its `sources` from outside uses all rules of one of `impossible`.
struct FamilyObstruction {
    Family family;
    bool empty_axiom = false;  // whether the empty word is allowed as an axiom
    FiniteLanguage language;
    ObstructionCase root;
    std::vector<ImpossibleTable> impossible;
};

/// A word as it stands in certificates: the names of its symbols, separated by blanks.
///
/// Example: certificate_text(*finite_language({"ab"}).alphabet, {0, 1, 0}) == "a b a"
std::string certificate_text(const Alphabet& alphabet, const Word& word);

/// A proof by cases as it stands in a certificate (CERTIFICATES.md): the cases and the impossible tables. The
/// family and the language are those of the statement that it proves.
nlohmann::ordered_json to_json(const FamilyObstruction& obstruction);

namespace verify {

/// The proof by cases in a certificate; its family and its language are not set.
FamilyObstruction read_obstruction(const Reader& reader, const Field& field);

}  // namespace verify

/// The flaw of a proof that a finite language is not in a family, in words; nothing if the proof is correct.
/// Checks every step again, on words and sets of words, and shares nothing with the search.
/// Exponential in the worst case; throws BoundReached if it takes more than the budget.
///
/// Example: flaw_in(*decide_family(finite_language({"a", "aa"}), Family{}).obstruction) == std::nullopt
std::optional<std::string> flaw_in(const FamilyObstruction& obstruction, const Budget& budget = {});

namespace verify {

/// The result of checking one statement of a certificate.
struct Finding {
    enum class Outcome {
        checked,      // its proof shows it, or its opposite if the verdict is "refuted"
        cited,        // it rests on a source: not checked
        undecided,    // the certificate does not decide it
        not_checked,  // a bound was reached: see `reason`
        wrong         // its proof does not show it: see `path`, `line` and `reason`
    };
    Outcome outcome = Outcome::undecided;
    std::string statement;  // in words, written from the statement itself and not from its text
    std::string citation;
    std::string path;
    std::size_t line = 0;
    std::string reason;
};

/// What is told while a certificate is checked, in this order; each may be left out.
struct CertificateEvents {
    std::function<void(const Certificate&)> on_start = {};
    std::function<void(const Field&)> on_statement = {};  // before it is checked
    std::function<void(const Finding&)> on_finding = {};
};

/// Checks every statement of a certificate (CERTIFICATES.md), each by itself and as soon as it is read, and forgets it; so
/// the memory is that of the largest statement, and a statement that takes too much is not checked. Throws Error, which names the
/// path and the line, at the first field that is missing, unexpected or of the wrong type; Interrupted if the work
/// was asked to stop; BoundReached if the letters and systems take more memory than the budget allows.
void check_certificate(const TextSource& text, const std::string& file, const Budget& budget,
                       const CertificateEvents& events);

/// The same for a text, with all that is found.
std::vector<Finding> check_certificate(const std::string& text, const std::string& file = "text",
                                       const Budget& budget = {});

/// What the statements of a certificate speak of, line by line: its letters, and each system with its axiom and rules.
/// Names longer than one character stand in quotes.
std::vector<std::string> definitions(const Certificate& certificate);

/// "checked", "cited: not checked", "undecided", "not checked" or "WRONG".
std::string to_string(Finding::Outcome outcome);

}  // namespace verify

}  // namespace algae
