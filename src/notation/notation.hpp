#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "exact/exact.hpp"
#include "system/system.hpp"
#include "word/word.hpp"

// notation: reading, checking and printing of algae's own text files: systems (`.lsys`), claims (`.claim`)
// and the other generators (`.ifs`, `.ca`, `.walk` and so on). A reader reports everything that is wrong with
// a text, each fault with its place, what was expected there and what was found; a printer gives the
// canonical text, which reads back as the same value. The room also checks the expectations of a file, and it
// knows the files that are built into the library.

namespace algae {

// Of other faces, by name only: who reads claims or generators includes theirs.
struct Claim;
struct LanguageTree;
using Language = std::shared_ptr<const LanguageTree>;
struct SystemForm;
struct Point;
struct Colour;
struct Drawing;
class Generator;
class IteratedFunctions;
struct Model;
struct SolidSetting;
struct SurfaceSetting;
enum class StampShape : unsigned char;

// Systems: `.lsys` files.

/// Constants and their values.
using ConstantValues = std::vector<std::pair<std::string, Quantity>>;

/// The system that the text of a `.lsys` file says. `file_name` is named in errors and becomes the
/// name of the system. Throws `Diagnostics` with everything that is wrong with the text, at most
/// twenty findings and then how many more there are. Linear time.
///
/// Symbols are numbered in the order of the canonical text (`print_lsystem`): those of `alphabet`,
/// the axiom, the rules, `ignore`, `terminals`, `interpret`.
///
/// `replaced` are constants that have these values instead of those of their `let`; throws Error if the text has no such constant.
///
/// Example: read_lsystem("axiom a; a -> ab", "thread.lsys").rules.size() == 1
Model read_lsystem(std::string_view text, const std::string& file_name,
                   const ConstantValues& replaced = {});

/// The system that somebody types on one line: `a -> ab, b -> a`. It is a text as of a `.lsys` file, in which a comma outside brackets
/// separates too, before a rule or a setting. Without an axiom it begins with the letter of the first rule. Throws as `read_lsystem`.
///
/// Example: read_typed_system("0->01,1->10", "typed").rules.size() == 2
Model read_typed_system(std::string_view text, const std::string& name,
                        const ConstantValues& replaced = {});

/// Whether a text is meant as a system rather than as the name of a file: it has an arrow, or begins with `axiom`.
///
/// Example: is_typed_system("a->ab") && !is_typed_system("koch.lsys")
bool is_typed_system(std::string_view text);

/// A word in the form in which words are printed, `F_l[+A(1,0.5)]`; `ε` is the empty word. New
/// symbols are added to the alphabet; names in it that are longer than the notation knows by
/// itself are read as one symbol. Throws `Diagnostics`.
///
/// Example: read_word("ε", *std::make_unique<Alphabet>()).letters.empty()
ModuleWord read_word(std::string_view text, Alphabet& alphabet);

/// An expression over any names: `(x+y)/2`. Throws `Diagnostics`.
///
/// Example: to_text(read_expression("((x+y)/2)")) == "(x+y)/2"
Expression read_expression(std::string_view text);

/// The canonical text of a `.lsys` file with its comments: those above the first statement stay at
/// the top, those above or behind another statement go where it goes, and those whose statement
/// is not printed, or that stand below the last one, come at the end. Formatting twice is formatting
/// once. Throws `Diagnostics` as `read_lsystem` does.
///
/// Example: format_lsystem("angle 60 # degrees\naxiom F", "koch.lsys")
///     == "axiom F\nangle 60 # degrees\n"
std::string format_lsystem(std::string_view text, const std::string& file_name);

/// The canonical text of a system: title, source, id, alphabet, let, systems within, axiom, tables and
/// rules, schedule, ignore, terminals, interpret, environment, settings, expectations; one statement a
/// line, with a line break at the end of each. It reads back as the same system, and its own canonical
/// text is itself. Throws nothing on systems that were read; title, source, names and values of a system
/// made otherwise must be such as can be written in the notation.
std::string print_lsystem(const Model& system);

/// One rule, as in the canonical text, without a line break.
std::string print_rule(const Alphabet& alphabet, const Production& rule);

/// A word with its arguments, without blanks unless a symbol's name needs them; `ε` if empty.
///
/// Example: print_word(Alphabet(), ModuleWord()) == "ε"
std::string print_word(const Alphabet& alphabet, const ModuleWord& word);

/// Prints many words and rules over one alphabet, which must outlive it and must not grow.
class Printer {
public:
    explicit Printer(const Alphabet& alphabet) : alphabet_(alphabet), spellings_(alphabet) {}

    std::string word(const ModuleWord& word) const;
    std::string rule(const Production& rule) const;
    /// Symbols with a blank between any two.
    std::string apart(const Word& symbols) const;

private:
    std::string pattern(const Pattern& pattern, const char* separator) const;
    std::string shape(const ShapeSuccessor& shape) const;

    const Alphabet& alphabet_;
    Spellings spellings_;
};

/// A statement of `.lsys` files that begins with a keyword, as the reference in NOTATION.md shows it.
struct StatementHelp {
    std::string keyword;
    std::vector<std::string> forms;  // as one writes it: "angle 60"
    std::string meaning;             // in one line, in Markdown
    std::string otherwise;  // what holds without it, likewise; empty where that goes without saying
    std::vector<std::string> words = {};  // names that may stand behind it: "box", "sphere"
};

/// All of them, in the order of the canonical text. Reading, printing and suggestions go by the same table.
///
/// Example: system_statements().front().keyword == "title"
std::vector<StatementHelp> system_statements();

/// The statements of `.claim` files in the same form.
///
/// Example: claim_statements().front().keyword == "claim"
std::vector<StatementHelp> claim_statements();

/// A file that an editor needs for `.lsys` and `.claim` files.
struct EditorFile {
    std::string path;  // "vim/syntax/lsys.vim"
    std::string text;
};

/// Grammars for Visual Studio Code and others that know TextMate's, for Vim, and for Lezer, made from both tables of statements.
std::vector<EditorFile> editor_files();

/// What fills a module, as it stands behind `environment`: `?E clip 0 0 4 3`.
std::string print_environment(const Alphabet& alphabet, const EnvironmentSetting& environment);

/// What stands behind the symbol of a solid or of a surface: `box width height`, `leaf`.
std::string print_solid(const SolidSetting& solid);
std::string print_surface(const SurfaceSetting& surface);

/// The shape of a stamp as it is written, in `stamp S square`.
///
/// Example: shape_name(StampShape::circle) == std::string("circle")
const char* shape_name(StampShape shape);

/// An expectation of a file that does not hold: where it stands, what it expected, what was found.
struct Mismatch {
    Place place;
    std::string message;  // "expected length 3: 148, found 149"
};

/// The expectations of a system that do not hold, in file order.
///
/// Kinds: length N; lengths N (the set of lengths, for 0L systems); mean N (the expected length of a
/// stochastic 0L system, an exact fraction); word N; segments N, distinct N, vertices N (drawn segments,
/// different ones, different ends of them); end N (x y); box N (x y of the lower left and the upper right
/// corner); of figures in space x y z. A decimal stands for the value rounded to its digits, in the
/// parameters of a word too; a fraction there for the double nearest to it. Systems with choices derive
/// the word of the first seed of their setting `seed`, or of seed 1. The word of a system of shape rules
/// is that of its boxes' symbols. An unknown kind, and a value that cannot be read, is a mismatch too.
std::vector<Mismatch> unmet_expectations(const Model& system, const Budget& budget = {});

// Claims: `.claim` files, and languages as claims write them.

/// The system that is known by a name: of a gallery entry, or a path, as a claim writes it. What it throws as
/// `Error` becomes a finding at the place of the name; `Stopped` is passed on.
using SystemSource = std::function<Model(const std::string& name)>;

/// The claim that the text of a `.claim` file makes (NOTATION.md), over one alphabet. Errors name
/// `file_name`. Throws `Diagnostics` with everything that is wrong with the text, at most twenty findings
/// and then how many more there are. Linear time but for the letters that images and complements are about.
///
/// Complements are over the letters of the whole text: of its languages and words, of the words of its systems, of its clause
/// `alphabet`, and `letters`, which count like that. Throws Error if one of these cannot be a letter.
///
/// Example: read_claim("claim T; show {a} is 0L", "x.claim", {}).statements.size() == 1
/// Example: read_claim("claim T; let A = {a}; let B = {b}; show ~A == ~B", "x.claim", {}, {"c"}).letters.size() == 3
Claim read_claim(std::string_view text, const std::string& file_name, const SystemSource& open,
                 const std::vector<std::string>& letters = {});

/// A language and the alphabet that its words are over.
struct WrittenLanguage {
    std::shared_ptr<const Alphabet> alphabet;
    Language language;
    std::vector<Symbol> letters = {};  // that complements are over; none if nothing is a complement
};

/// The language that an expression says, as in a claim, but that `L(NAME)` opens the system. Complements are over the letters
/// of the expression and `letters`. Throws `Diagnostics`, and Error if one of these cannot be a letter.
///
/// Example: read_language("/a*/ & {a, b}", {}).language->kind == LanguageTree::Kind::intersected
WrittenLanguage read_language(std::string_view text, const SystemSource& open,
                              const std::string& file_name = "expression",
                              const std::vector<std::string>& letters = {});

/// Names of families, from which messages suggest one.
const std::vector<std::string>& common_families();

/// Why the system is not of the form: "the rule at x.claim:3:20 is erasing"; empty if it is. Rules
/// of letters that never occur are not looked at.
std::string misfit(const LSystem& system, const SystemForm& form);

/// Whether this is the name of a family of systems that have probabilities or parameters: S0L, PS0L, parametric.
bool is_rewriting_family(std::string_view name);

/// Why the system is not of the family; empty if it is.
std::string misfit(const LSystem& system, std::string_view family);

// Other generators: `.ifs`, `.ca`, `.walk` and so on, small files of lines `key value ...`.

/// What a statement of a generator's file may begin with.
struct GeneratorKey {
    std::string name;
    std::string arguments;  // as an error shows them: "a b c d e f [probability]"
    bool repeats = false;   // more than once in a file
};

/// The part of a statement between two blanks (blanks in brackets belong to it).
struct GeneratorWord {
    std::string text;
    std::size_t offset = 0;  // of its first byte in the line
    bool operator==(const GeneratorWord& other) const { return text == other.text; }
};

/// One line of a generator's file: a key and its words. Equal if both are.
struct GeneratorStatement {
    std::string key;
    std::vector<GeneratorWord> words;
    Place place;                     // of the key
    std::string line;                // whole, for errors
    std::vector<std::string> above;  // comments on lines of their own
    std::string behind;              // the comment behind it
    bool operator==(const GeneratorStatement& other) const {
        return key == other.key && words == other.words;
    }
};

/// The small text file of a generator, such as `fern.ifs`: lines `key value ...`, `#` comments. It is
/// what readers of the kinds read from, what options of the command line change, and what is printed.
/// `title` and `source` have one word, the rest of their line.
struct GeneratorFile {
    std::string name;  // as errors call it
    std::vector<GeneratorStatement> statements;
    std::vector<std::string> below;  // comments behind the last statement

    bool operator==(const GeneratorFile& other) const { return statements == other.statements; }

    /// The statement of this key, which does not repeat; nullptr if there is none.
    const GeneratorStatement* find(std::string_view key) const;
    /// Appends a statement.
    void add(const std::string& key, const std::vector<std::string>& words);
    /// Replaces the statement of this key, or appends it; `option` is what errors call its place.
    void set(const std::string& key, const std::vector<std::string>& words,
             const std::string& option);

    /// Throws Diagnostics with this message at a word, at a statement, or about the whole file.
    [[noreturn]] void fail(const GeneratorStatement& statement, const GeneratorWord& word,
                           const std::string& message) const;
    [[noreturn]] void fail(const GeneratorStatement& statement, const std::string& message) const;
    [[noreturn]] void fail(const std::string& message) const;
    /// The same: "expected KEY `wanted`, found 'WORD'", and a hint.
    [[noreturn]] void refuse(const GeneratorStatement& statement, const GeneratorWord& word,
                             const std::string& wanted, const std::string& hint = {}) const;

    /// The number of words; throws unless from `least` to `most`.
    void check_words(const GeneratorStatement& statement, std::size_t least, std::size_t most,
                     const std::string& arguments) const;

    /// The word of a statement that has one; throws if it has not.
    const GeneratorWord& only_word(const GeneratorStatement& statement,
                                   const std::string& arguments) const;

    /// A word as a number: any expression without names, `1/3`, `sqrt(3)/6`, `cos(60)`. Exact where
    /// `evaluate` is.
    Quantity quantity(const GeneratorStatement& statement, const GeneratorWord& word) const;
    /// Throws unless it is from `least` to `most`.
    double number(const GeneratorStatement& statement, const GeneratorWord& word, double least,
                  double most) const;
    std::uint64_t natural(const GeneratorStatement& statement, const GeneratorWord& word,
                          std::uint64_t least, std::uint64_t most) const;
    /// `N` or `N..M`, both at most `most`.
    std::pair<std::uint64_t, std::uint64_t> range(const GeneratorStatement& statement,
                                                  const GeneratorWord& word,
                                                  std::uint64_t most) const;
    Colour colour(const GeneratorStatement& statement, const GeneratorWord& word) const;
    /// `(1,2)` as two numbers.
    Point point(const GeneratorStatement& statement, const GeneratorWord& word) const;

    /// The value of a statement with one word; nothing where the file has no such statement.
    std::optional<double> number(std::string_view key, double least, double most) const;
    std::optional<std::uint64_t> natural(std::string_view key, std::uint64_t least,
                                         std::uint64_t most) const;
    /// `N` or `N..M`.
    std::optional<std::pair<std::uint64_t, std::uint64_t>> range(std::string_view key,
                                                                 std::uint64_t most) const;
    std::optional<std::string> text(std::string_view key) const;
    /// The one of these words that the statement says.
    std::optional<std::string> choice(std::string_view key,
                                      const std::vector<std::string>& choices) const;

    /// Fills in name, title, source and settings (`colour`, `width`) from the file.
    void describe(Generator& generator) const;
};

/// Reads the statements of a file and checks their keys. Throws `Diagnostics` with everything that is
/// wrong: unknown keys (with the known ones), keys without words, keys said twice. Title and source
/// come first in the result.
GeneratorFile read_generator_file(std::string_view text, const std::string& name,
                                  const std::vector<GeneratorKey>& keys);

/// The text of a file with its comments, a line for each statement in their order, words one blank
/// apart. It reads back as an equal file.
///
/// Example: print_generator_file(GeneratorFile{}) == ""
std::string print_generator_file(const GeneratorFile& file);

/// A kind of generator: the ending of its files, what stands in them, and how a generator is made from one.
struct GeneratorKind {
    std::string ending;  // without the point: "ifs"
    std::string what;    // "an iterated function system"
    std::vector<GeneratorKey> keys;
    /// Throws Diagnostics or Error where values are missing, out of range or do not fit together.
    std::unique_ptr<Generator> (*make)(const GeneratorFile&);
};

/// All kinds.
const std::vector<GeneratorKind>& generator_kinds();

/// The kind of file that a name ends in; nullptr if no kind has this ending.
///
/// Example: generator_kind("figures/koch.lsys") == nullptr
const GeneratorKind* generator_kind(std::string_view file_name);

/// The generator that the text of a file describes. Throws `Diagnostics` or `Error`.
std::unique_ptr<Generator> read_generator(std::string_view text, const std::string& file_name);

/// The canonical text of a generator's file, comments kept. Throws as `read_generator` does.
std::string format_generator(std::string_view text, const std::string& file_name);

/// Files `*.ifs` of iterated function systems.
GeneratorKind ifs_kind();

/// The file that says this system.
GeneratorFile ifs_file(const IteratedFunctions& system);

// What comes with algae, built into the library.

/// One of the figures and systems that come with algae, as its file stands.
struct GalleryEntry {
    std::string_view name;  ///< the file's name without its end, by which the command line knows it
    std::string_view path;  ///< from the root of the repository, as `figures/002/koch.lsys`
    std::string_view text;  ///< the file, to be read by the notation
};

/// All figures and systems that come with algae, in order of their names; no two names are equal.
/// Built into the library, so nothing is read from disk.
std::span<const GalleryEntry> gallery();

/// The files of the other generators that come with algae, `fern.ifs`, `glider.ca`, likewise. A system
/// of `gallery()` may have the same name.
std::span<const GalleryEntry> generator_gallery();

/// The claims of the theory that come with algae, `theory/closure/union-not-0l.claim`. Two may have the
/// same name in different folders.
std::span<const GalleryEntry> theory_claims();

/// The proofs in Coq of theory/formal, `theory/formal/Spec.v`, and `theory/formal/table.txt`: a line for each cell of the table
/// of closure, `union; E0L; closed; OneTable.v:extended_union`, with the theorem that settles it, or `open; -`.
std::span<const GalleryEntry> formal_texts();

/// The lessons that come with algae, in their order, and their exercises, named as `03-2`.
std::span<const GalleryEntry> lesson_texts();
std::span<const GalleryEntry> exercise_texts();

/// The files of algae's own code that lessons show regions of.
std::span<const GalleryEntry> lesson_code();

/// The name of the file of an entry.
///
/// Example: file_name({"fern", "figures/003-fractal-notes/fern.ifs", ""}) == "fern.ifs"
std::string_view file_name(const GalleryEntry& entry);

/// The file of another generator that comes with algae, by its name, `fern` or `fern.ifs`; nullptr
/// if there is none. Time linear in the number of entries.
///
/// Example: find_generator("fern") == find_generator("fern.ifs")
/// Example: find_generator("fern.ca") == nullptr
const GalleryEntry* find_generator(std::string_view name);

// For those who read other texts: places, findings, characters. `exchange` and `lesson` report faults with them.

/// The text of a file with its places. The text itself is not copied and must outlive the source.
class Source {
public:
    /// Reads through the text once: checks that it is UTF-8 without control characters and
    /// remembers the place of every few thousandth byte.
    Source(std::string_view text, std::string file);

    std::string_view text() const { return text_; }
    const std::string& file() const { return file_; }

    /// The place of a byte. Fast for offsets that mostly grow, never more than a few thousand steps.
    Place place(std::size_t offset) const;
    Place place(const char* here) const { return place(offset(here)); }
    std::size_t offset(const char* here) const {
        return static_cast<std::size_t>(here - text_.data());
    }
    /// The byte at a place of this source.
    std::size_t offset(const Place& place) const;

    /// A finding about a byte, with its line: whole, or the part around the caret if it is long.
    Diagnostic finding(std::size_t offset, std::string message) const;

    /// Bytes that are not UTF-8 or not a character of a text, with what is wrong: one a line, and at most as
    /// many as anybody reads.
    struct BadByte {
        std::size_t offset;
        std::string message;
    };
    const std::vector<BadByte>& bad_bytes() const { return bad_bytes_; }
    std::size_t bad_lines() const { return bad_lines_; }

private:
    struct Mark {
        std::size_t offset = 0, line = 1, column = 1;
    };
    void note_bad_byte(const Mark& mark, std::string message);
    void advance(Mark& mark) const;  // over one byte

    static constexpr std::size_t mark_distance = 4096;
    static constexpr std::size_t most_bad_bytes = 20;

    std::string_view text_;
    std::string file_;
    std::vector<Mark> marks_;
    mutable Mark latest_;
    std::vector<BadByte> bad_bytes_;
    std::size_t bad_lines_ = 0, last_bad_line_ = 0;
};

/// What stopped a reader: a byte of the text and what is wrong there. `Findings::add` makes a finding of it.
struct SyntaxError {
    const char* where;
    std::string message;
    bool names_found = true;  // otherwise ", found ..." is still to be added
};

/// "expected `expectation`, found ..." with what stands at `where` or behind the blanks there.
SyntaxError unexpected(const std::string& expectation, const char* where);

/// "expected `expectation`, found 'WORD'", with the known word that could have been meant.
SyntaxError unknown_word(const std::string& expectation, std::string_view found,
                         const std::vector<std::string>& known);

/// "'KEYWORD' is given twice, first in line 3", where the first of both stands.
SyntaxError given_twice(std::string_view keyword, const char* first, const Source& source);

/// The findings about one text, gathered while it is read further.
class Findings {
public:
    explicit Findings(const Source& source) : source_(source) {}

    void add(std::size_t offset, std::string message);
    void add(const char* where, std::string message) {
        add(source_.offset(where), std::move(message));
    }
    void add(const Place& place, std::string message) {
        add(source_.offset(place), std::move(message));
    }
    void add(const SyntaxError& error);
    /// Calls `read` and adds what it throws as a `SyntaxError`.
    template <class Read>
    void gather(Read read) {
        try {
            read();
        } catch (const SyntaxError& error) {
            add(error);
        }
    }

    bool empty() const { return count_ == 0; }
    std::size_t count() const { return count_; }

    /// Throws `Diagnostics` if the source has bytes that are not text: the readers rely on whole characters.
    void throw_if_no_text();

    /// Throws `Diagnostics` if there are any: the first twenty in order of place, then one that says
    /// how many more there are.
    void throw_if_any() const;

private:
    struct Finding {
        std::size_t offset;
        std::string message;
    };
    static constexpr std::size_t most_shown = 20;
    static constexpr std::size_t most_kept = 10000;

    const Source& source_;
    std::vector<Finding> findings_;
    std::size_t count_ = 0;
};

/// The operators of a notation: how they are written, and how tightly they bind. The grammar of expressions
/// takes them as a parameter, so that our notation and those of other programs are read by the same one.
struct ExpressionDialect {
    /// Loosest first.
    enum class Binding { disjunction, conjunction, relation, sum, product, prefix, power };
    struct Operator {
        const char* written;
        const char* name;  // in an Expression; a prefix that changes nothing has none, ""
        Binding binding;
    };
    /// How a^b^c is read: as a^(b^c), as (a^b)^c, or not at all. In the last case an exponent takes
    /// one sign.
    enum class Powers { to_the_right, to_the_left, in_brackets };

    std::vector<Operator> infixes, prefixes;
    Powers powers = Powers::to_the_right;
    bool spaced = false;  // an infix operator counts only with white space behind it
};

/// What a reader of another program's text adds to the operators of its dialect.
struct ExpressionReader {
    /// Where the next token begins, behind white space and comments.
    std::function<const char*(const char* here)> next;
    /// Reads what stands between operators, brackets and calls too, and moves `here` behind it.
    std::function<Expression(const char*& here)> operand;
    /// Is told where each operator stands, from left to right.
    std::function<void(const char* where)> met;
    /// What stands for an operator and its operands, those innermost first.
    std::function<Expression(Expression)> made;
};

/// Reads operands with operators of the dialect before and between them, from `here` on up to where they
/// cannot go on, and moves `here` there. Throws `SyntaxError` where powers ask for brackets, and
/// what the reader throws. Linear.
Expression read_expression(const char*& here, const char* end, const Source& source,
                           const ExpressionDialect& dialect, const ExpressionReader& reader);

/// The fewest insertions, deletions, replacements and exchanges of neighbours that turn one text
/// into the other (restricted Damerau-Levenshtein distance). Time the product of the lengths.
///
/// Example: edit_distance("angel", "angle") == 1
std::size_t edit_distance(std::string_view left, std::string_view right);

/// "; did you mean 'angle'?" if one of the candidates is close to what was written, otherwise "".
std::string did_you_mean(std::string_view written, const std::vector<std::string>& candidates);

/// One character of a UTF-8 text: its code point and how many bytes it takes. A byte that starts no
/// valid character has the code point 0xFFFFFFFF and takes one byte.
struct Character {
    char32_t code = 0xFFFFFFFF;
    std::size_t bytes = 1;
    bool is_valid() const { return code != 0xFFFFFFFF; }
};

/// The character at the start of a text that is not empty.
Character first_character(std::string_view text);

/// White space within a line: blank, tab, carriage return and Unicode's blanks.
bool is_blank(char32_t code);

/// ASCII letters, and beyond ASCII everything but blanks, punctuation, arrows and operators.
bool is_letter(char32_t code);

inline bool is_digit(char32_t code) { return code >= '0' && code <= '9'; }

/// Whether a character looks like a minus sign but is not one.
bool is_false_minus(char32_t code);

/// The text without blanks at both ends.
std::string_view trimmed(std::string_view text);

/// "U+2212".
std::string code_point_name(char32_t code);

/// How an error speaks of what stands at the start of `rest`: "'x'", a whole name or number, "the
/// end of the line", with a hint where the character is a common mistake.
std::string found(std::string_view rest);

/// The bytes of the symbol that `text` begins with where nothing is declared; 0 if it begins with
/// none: one character, a letter with a subscript, or either behind a question mark.
///
/// Example: undeclared_length("F_lF") == 3
/// Example: undeclared_length("?E(x)") == 2
std::size_t undeclared_length(std::string_view text);

/// One definition, statement or text of a claim, cut out of its line or lines: without blanks at its ends.
struct ClaimClause {
    std::string_view text;
    std::string_view keyword;        // what it begins with, up to the first blank
    const char* unclosed = nullptr;  // its first '{' without '}'

    /// What stands behind the keyword, without blanks.
    std::string_view value() const;
};

/// The clauses of a claim: `;` and line breaks outside braces separate them; `#` at the start of a line or
/// behind white space opens a comment. Braces in the texts of `claim`, `source`, `note` and `title` are
/// not counted, and one that is never closed does not hide the lines below it. Linear.
std::vector<ClaimClause> claim_clauses(std::string_view text);

/// Statements that exercises have and claims have not, about a system called `answer`: `answer is D0L`.
struct AnswerIs {
    std::string form;
};

/// `answer has at most 2 rules`.
struct AnswerHas {
    enum class Counted { rules, letters, axiom_symbols };
    Counted counted = Counted::rules;
    bool at_most = false;
    std::uint64_t count = 0;
};

/// `figure(answer, 4) is similar to figure(koch, 4)`.
struct FiguresAre {
    enum class Relation { similar, congruent, same };
    struct Figure {
        std::string system;      // `answer`, or what a system is opened by
        std::size_t offset = 0;  // where its name stands in the statement, in bytes
        std::uint64_t generation = 0;
    };
    Figure left, right;
    Relation relation = Relation::same;
};

using OwnStatement = std::variant<AnswerIs, AnswerHas, FiguresAre>;

/// Whether a text begins as such a statement does. What begins with `answer` is a statement of claims unless the answer
/// is a system (`of_system`).
///
/// Example: is_own_statement("answer has 2 rules", true)
/// Example: !is_own_statement("growth(answer) = 2^n", true)
bool is_own_statement(std::string_view text, bool of_system);

/// The statement that a text says which begins so, without comments. Throws `SyntaxError`.
OwnStatement read_own_statement(std::string_view text);

/// The pieces of a text between blanks.
///
/// Example: blank_separated(" a  b ").size() == 2
std::vector<std::string_view> blank_separated(std::string_view text);

/// Whether a text is a name in claims: a letter, then letters, digits, `_` and `'`.
///
/// Example: is_claim_name("h_1'") && !is_claim_name("1a")
bool is_claim_name(std::string_view text);

}  // namespace algae
