#pragma once
// A claim on its way from its text: what the readers of its parts share, and what they call of each other.

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "dimension/dimension.hpp"
#include "language/language.hpp"
#include "notation/detail/reading.hpp"
#include "notation/notation.hpp"

namespace algae {

/// A language on its way from a text, with what bounds it: nothing that is read is so deep that it could
/// exhaust the stack of those who work on it.
struct LanguageOperand {
    Language language;
    std::size_t levels = 0;  // operations inside each other
    std::size_t parts = 1;   // parts of the expression, names written out
};

/// What a name stands for in a claim.
struct ClaimName {
    enum class Kind { language, system, rewriting, morphism, word, number, broken };
    Kind kind = Kind::broken;     // as long as its definition has not been read
    const char* where = nullptr;  // it begins, with the name
    const char* end = nullptr;    // it ends
    LanguageOperand language;
    std::shared_ptr<const SourceSystem> system;
    std::shared_ptr<const LSystem> rewriting;
    std::shared_ptr<const Model> written;  // of any system, with its turtle
    Morphism morphism;
    std::optional<std::size_t> variable = {};  // the number of a bound name
};

/// How a bound morphism is used, which says what letters it is about.
struct MorphismUse {
    bool applied = false, inverse = false;
};

/// A claim, or a single language, on its way from a text: what the readers of its parts share. They throw
/// `SyntaxError` or `DependsOnError`.
class ClaimReading {
public:
    ClaimReading(const Source& text_source, Findings& text_findings,
                 const SystemSource& system_source);

    const Source& source;
    Findings& findings;
    const SystemSource& open;
    std::shared_ptr<Alphabet> alphabet;  // common to all
    Lexicon lexicon;
    std::vector<Symbol> declared;  // by `alphabet`
    std::set<Symbol> letters;      // of the words of languages, as far as they are read
    std::vector<std::string>
        long_names;                 // the symbols that are read as one because they are declared
    bool opens_systems = false;     // `L(NAME)` of a name that is not defined opens a system
    std::vector<MorphismUse> uses;  // of bound names, by their numbers
    std::vector<Symbol> bound_letters;  // by which bound words and letters stand in texts
    bool binds = false;                 // some statement binds names whose values have letters
    std::vector<std::shared_ptr<const SourceSystem>> grammars;  // as systems, in order

    /// Makes a name known before its definition is read. Throws if it is known or cannot be a name.
    ClaimName& define(std::string_view name);
    /// Makes a name known that a quantifier binds, with the next number; it hides a definition of this name. Its values
    /// have letters, or are numbers. Throws if it cannot be a name.
    ClaimName& bind(std::string_view name, bool has_letters = true);
    /// How many names are bound here; at the end of a statement those behind that number are forgotten.
    std::size_t bound() const { return hidden_.size(); }
    void release(std::size_t bound);
    /// What a name stands for, if it was defined before; nullptr if it was not defined at all.
    const ClaimName* find(std::string_view name) const;
    /// The same; throws with what could have been meant if it was not defined.
    const ClaimName& expect(std::string_view name) const;
    /// The system of this name. Throws if it is a name of something else.
    std::shared_ptr<const SourceSystem> system(std::string_view name);

    /// The system that stands between quotation marks, `'a -> ab, b -> a'`; `text` is what is between them.
    std::shared_ptr<const SourceSystem> typed_system(std::string_view text);

    /// The system of this name if its words are derived module by module; nullptr if it is anything else.
    std::shared_ptr<const LSystem> rewriting(std::string_view name) const;

    /// The system of this name as it was written. Throws if it is a name of something else.
    std::shared_ptr<const Model> written(std::string_view name) const;

    /// Whether `alphabet` declares longer names, so that blanks separate symbols and `|` is always one.
    bool spaced() const;

    /// A symbol that counts as declared from now on if it has to.
    Symbol declare(std::string_view name);
    /// Adds a system, called `name` in text, over the common alphabet; `written` is what it was read from.
    std::shared_ptr<const SourceSystem> add_system(const std::string& name, const LSystem& written,
                                                   const char* where);
    /// Adds the system of a grammar, which is over an alphabet of its own; `grammar` is how claims write it.
    std::shared_ptr<const SourceSystem> add_grammar(const std::string& name, ET0L system,
                                                    const std::string& grammar);
    /// The system that `open` knows by this name, which stands at `where`.
    Model opened(const std::string& name, const char* where) const;
    /// Adds letters of the file, but those that are names of bound words.
    void add_letters(const Word& word);
    /// The complement of the language, whose letters come with `finish_complements`; the sign stands at `where`.
    Language complement(Language language, const char* where);
    /// The language with a name.
    Language with_name(Language language, std::string name);
    /// That the morphism has an image for each letter of the language is looked at when the letters are known.
    void check_images(const Language& language, const Morphism& morphism, const char* where);
    /// Puts all systems over the alphabet as it is now.
    void finish();
    /// Puts all complements over the letters of the file, those of systems' words and of `alphabet` too, and gives them; none if
    /// nothing is a complement. Throws `SyntaxError` at a complement if there are no letters, and where images are missing.
    std::vector<Symbol> finish_complements();

private:
    struct Complement {
        std::shared_ptr<LanguageTree> tree;
        const char* where;
    };
    struct Images {
        Language language;
        Morphism morphism;
        const char* where;
    };
    struct Owned {
        std::shared_ptr<SourceSystem> system;
        SourceSystem own;  // over its own alphabet
    };
    void put_over_alphabet(Owned& owned) const;
    std::string suggestion(std::string_view name) const;

    std::unordered_map<std::string, ClaimName> names_;
    struct Hidden {
        std::string name;                  // that is bound
        std::optional<ClaimName> meaning;  // before
    };
    std::vector<Hidden> hidden_;
    std::unordered_map<std::string, std::shared_ptr<const SourceSystem>> opened_;
    std::vector<Owned> systems_;
    std::vector<Complement> complements_;
    std::vector<Images> images_;
};

/// The brace that closes the one at `open`; nullptr if there is none before `end`.
const char* closing_brace(const char* open, const char* end);

/// Where `word` stands in the text between blanks (or the ends) and outside braces; npos if nowhere.
std::size_t find_word(std::string_view text, std::string_view word);

/// Whether a bound name stands in the language, whose letters are known of no instance.
bool is_open(const Language& language);

/// The word that is the whole of the text; ε is the empty word, a text without anything is none. Its letters are not counted
/// among those of the file.
Word parse_claimed_word(std::string_view text, ClaimReading& reading);

/// Whether a morphism between braces stands at `here`, not a set of words: there is an arrow between them.
bool is_morphism(const char* here, const char* end);

// What follows reads from `here` on, up to where it cannot go on, and moves `here` there.

/// Reads the morphism `{ a -> ab; b -> ε }` that stands next.
Morphism parse_morphism(const char*& here, const char* end, ClaimReading& reading);

/// Reads one language expression. Where `between_bars`, a `|` with `=` behind it ends the expression, as in
/// `|A| = 3`. Throws `SyntaxError` or `DependsOnError`. Linear, but for the letters that images and
/// complements are about; brackets nest at most 200 deep, operations 1000.
LanguageOperand parse_language(const char*& here, const char* end, ClaimReading& reading,
                               bool between_bars = false);

/// Whether a grammar stands there: `CF` or `regular` and rules between braces.
bool is_grammar(const char* here, const char* end);

/// Reads the grammar that stands next, `CF { S -> aSb | ε }` or `regular { S -> aS | b }`, as a language: of a system that
/// `name` names, or its own text if that is empty, or a regular expression. Throws `SyntaxError`.
LanguageOperand parse_grammar(const char*& here, const char* end, ClaimReading& reading,
                              const std::string& name = {});

/// Whether what stands between the braces of a set ends with a condition: `a^n b^n : n >= 0`, `a^n | n >= 0`.
bool is_set_with_condition(std::string_view inside, const ClaimReading& reading);

/// The language of such a set. Throws `SyntaxError`.
Language parse_powers(std::string_view inside, ClaimReading& reading);

/// Reads `log 4 / log 3`, a rational number, or several of them joined by `=` which have to be equal; a
/// decimal number behind a `=` is what comes before it, rounded. Throws `SyntaxError`.
DimensionValue parse_dimension_value(const char*& here, const char* end);

/// The signs that compare numbers, each before those that it begins with, and what they say.
inline constexpr std::string_view comparison_signs[] = {
    "==", "=", "!=", "≠", "<=", "≤", "<", ">=", "≥", ">"};
inline constexpr Comparison comparisons_said[] = {
    Comparison::equal,    Comparison::equal,   Comparison::unequal, Comparison::unequal,
    Comparison::at_most,  Comparison::at_most, Comparison::less,    Comparison::at_least,
    Comparison::at_least, Comparison::greater};

/// A real algebraic number at the place: `7/2`, `2 + (1+sqrt(5))/2`, or `the largest real root of 2x^3 - 12x^2 + 22x - 13`. Throws
/// `SyntaxError`.
ClaimedNumber parse_claimed_number(const char*& here, const char* end);

/// The number of these digits, of which there are at most a thousand. Throws `SyntaxError`.
Integer natural_number(std::string_view digits);

/// The statement that is the whole of the text: a single one, several joined by `and`, `or`, `implies`, `iff`, `not`, or
/// `for all ...: ...`. Throws `SyntaxError` or `DependsOnError`.
Statement parse_statement(std::string_view text, ClaimReading& reading);

/// The single statement that is the whole of the text: `A is not 0L`, `A == B`, `a in A`, `|A| = 3`,
/// `G ==> aab in 3 steps`, `growth(G) ~ exponential`, ... Throws `SyntaxError` or `DependsOnError`.
Statement parse_single_statement(std::string_view text, ClaimReading& reading);

/// The D0L system of whose infinite word a first-order statement speaks: `in T: for some n: T[n] = b`, or without the first words
/// where `T[` stands behind a quantifier; nothing if it is another statement.
std::optional<std::string_view> first_order_system(std::string_view text,
                                                   const ClaimReading& reading);
/// The first-order statement that is the whole of the text. Throws `SyntaxError` or `DependsOnError`.
Statement parse_first_order(std::string_view system, std::string_view text, ClaimReading& reading);

/// Reads `f is overlap-free`, a property of the infinite word of a system; false if the text is no property of a system. Throws
/// as the others.
bool parse_word_property(std::string_view text, Statement& statement, ClaimReading& reading);
/// Reads `critical_exponent(f) < 4`; false if it is no such statement.
bool parse_critical_exponent(std::string_view text, Statement& statement, ClaimReading& reading);
/// Reads `abba in factors(G)`: some word of the language of G has the factor; false if it is no such statement.
bool parse_factor(std::string_view text, Statement& statement, ClaimReading& reading);
/// Reads `complexity(f, 2n + 1) = 2 complexity(f, n + 1)` for all n, and with `for all n with n >= 1:` before it; false if it is no such
/// statement.
bool parse_complexities(std::string_view text, Statement& statement, ClaimReading& reading);
/// Whether the text is a single statement about complexities with a quantifier.
bool is_on_complexities(std::string_view text);

// Statements about numbers and words that may depend on numbers. A name of a number that nothing binds makes the statement one
// about all numbers. All throw `SyntaxError` or `DependsOnError`.

/// Reads `length(G, n + 1) = 2*length(G, n)`, `n < 2^n` where n is bound, ...; false if the text is no comparison of numbers.
bool parse_numbers(std::string_view text, Statement& statement, ClaimReading& reading);
/// Reads `word(F, n + 2) == word(F, n + 1) word(F, n)`, ...; false if no `word(` stands in the text.
bool parse_words(std::string_view text, Statement& statement, ClaimReading& reading);
/// The term that is the whole of the text, in which numbers are bound, and which they are.
Expression parse_number_term(std::string_view text, std::vector<BoundName>& numbers,
                             ClaimReading& reading);
/// Reads `2^n + 1` behind `growth(G) =`: length(G, n) is that for all n.
void parse_growth_formula(const std::shared_ptr<const SourceSystem>& system,
                          std::string_view formula, Statement& statement, ClaimReading& reading);

/// An example of each form of statements, as NOTATION.md has them, in the order in which the forms are tried.
std::vector<std::string> written_statements();

/// The name by which statements keep a family of languages: "REG" and "regular" are REG, "CF" and
/// "context-free" are CF, names of families of L-systems stay; nothing if there is no such family.
///
/// Example: language_family("regular") == "REG"
std::optional<std::string> language_family(std::string_view name);

/// Whether a clause says what a claim settles in the table: `closed under ...`, `not closed under ...`.
bool is_closure_fact(std::string_view text);

/// What such a clause says. Throws `SyntaxError`.
ClosureFact parse_closure_fact(std::string_view text, const ClaimReading& reading);

/// Whether a citation names a theorem of theory/formal: `formal/Star.v:not_closed_under_star`.
bool is_formal_theorem(std::string_view citation);
/// Sets the theorem of a fact. Throws `SyntaxError` unless theory/formal has it, by this name, of all families of the fact.
void set_formal_theorem(ClosureFact& fact, std::string_view citation);

}  // namespace algae
