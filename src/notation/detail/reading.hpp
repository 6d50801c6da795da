#pragma once
// A `.lsys` file on its way from its text: its clauses, and what the readers of single statements share.

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "notation/detail/expression_grammar.hpp"
#include "notation/notation.hpp"

namespace algae {

struct Coding;
struct Expectation;

/// One setting or rule, cut out of its line: without comment, without blanks at its ends.
struct Clause {
    std::string_view text;
    std::string_view keyword;        // the letters it begins with
    const char* arrow = nullptr;     // its first `->` or `→`; nullptr if it has none
    const char* comments = nullptr;  // where the blank lines and comments before it begin

    /// Whether the keyword is all up to the first blank.
    bool has_word(std::string_view word) const;
    /// What stands behind the keyword, without blanks.
    std::string_view value() const;
};

/// The clauses of a text: `;` and line breaks separate them, `#` at the start of a line or
/// behind white space opens a comment (but in `colour #ff8000` it opens a colour). A system within the
/// system, `system leaf { ... }`, and a coding, `coding { a -> 0 }`, are one clause each. Linear.
///
/// In a system that is `typed` on one line a comma outside brackets separates too, if the clause before it has an arrow or is a
/// setting and what follows up to the next such comma is one as well: `a -> ab, b -> a`; and so does a blank before one word with an
/// arrow, `0->01 1->10`.
std::vector<Clause> clauses(std::string_view text, bool typed = false);

/// Whether a clause is a rule: it has an arrow that is not part of a title, a source or an
/// interpretation.
bool is_rule(const Clause& clause);

/// The pieces of a text between blanks outside brackets.
std::vector<std::string_view> pieces(std::string_view text);

/// The comments in a stretch of text without clauses, each with its `#`, without the line break.
std::vector<std::string_view> comments(std::string_view text);

/// A system within another as its text has it: `system leaf { axiom F; F -> F[+F] }`.
struct SystemBlock {
    std::string_view name;
    std::string_view body;  // between the braces; up to the end of the text if they do not match
    bool closed = true;
};

/// The block at the start of a text, if there is one, and how many bytes it takes: up to the brace that
/// matches its first, those in comments not counted. Linear in the bytes of the block.
std::optional<SystemBlock> system_block(std::string_view text, std::size_t& bytes);

/// What a textbook writes in place of a word and a word here does not mean: `a^n`, `...`, or λ alone.
struct Slip {
    const char* where;
    std::string message;
    std::vector<std::string_view> signs;  // which would be letters: `^` and n
};

/// A system on its way from a text: what the readers of the single statements share.
struct Reading {
    const Source& source;
    Findings& findings;
    Lexicon& lexicon;
    LSystem& system;
    Drawing& drawing;  // of the whole file, as expectations are
    std::vector<Expectation>& expectations;
    Coding& coding;
    OwnFunctions& functions;

    std::unordered_map<std::string, std::size_t> constants;  // to their index in the system
    std::unordered_set<std::string> broken;  // names whose statement was wrong: no further findings
    std::map<std::string, const char*, std::less<>> given;  // settings so far
    std::unordered_set<std::string> tables;                 // opened so far
    bool broken_rules = false;                              // some rule could not be read
    bool is_inner = false;                                  // it is a system within another
    const ConstantValues* replaced = nullptr;               // constants with other values
    std::vector<Expression> distances = {};  // in conditions, until all symbols are known
    std::vector<std::string> letters = {};   // that `alphabet` declares, here or around the system
    bool spaced = false;  // some of them are longer, so blanks separate symbols and `|` is one
    std::vector<Slip> slips = {};  // in words, until all symbols are known

    const Quantity* constant(const std::string& name) const;

    /// The value of an expression over constants. Throws `SyntaxError` or `DependsOnError`.
    Quantity quantity(const Expression& expression) const;

    /// Adds a finding for each name in the expression that is neither a constant nor one of these
    /// parameters, and for each distance unless the expression is `of_boxes`, a condition of a shape rule.
    void check_names(const Expression& expression, const std::vector<std::string>& parameters,
                     bool of_boxes = false);

    /// Adds a finding unless the expression has the same value everywhere: an argument in a word in
    /// quotes.
    void check_fixed(const Expression& expression);

    /// Adds a finding for each distance to something that is no symbol of the system.
    void check_distances();

    /// From now on `name` is a letter because `alphabet` declares it.
    void declare(const std::string& name);

    /// Keeps the slips of a word, of a rule's successor if `of_rule`, for `check_slips`.
    void gather_slips(std::string_view word, bool of_rule);

    /// Adds a finding for each slip of which no sign is a letter of the system otherwise.
    void check_slips();
};

/// The slips in the text of a word that can be read; λ alone counts in rules only. Linear.
std::vector<Slip> slips(std::string_view word, const Lexicon& lexicon, bool of_rule);

/// Throws `SyntaxError` at the first slip in the text of a word of which the lexicon knows no sign; λ alone
/// counts if `of_rule`.
void refuse_slips(std::string_view word, const Lexicon& lexicon, bool of_rule = false);

/// How a statement that begins as comments of other notations do, `// text`, is said here, for a message; empty for all others.
std::string comment_hint(std::string_view text);

/// Whether a name is a symbol only if declared, and longer than one character: blanks separate symbols where
/// there is one.
bool is_declared_only(std::string_view name);

/// The successors of a rule that `|` between blanks separates, without blanks at their ends; empty ones are
/// faults. Throws `SyntaxError` at such a `|` in brackets.
std::vector<std::string_view> separate_successors(std::string_view text);

/// How many rules a rule or an interpretation stands for: its successors, but one in a `spaced` text.
std::size_t successor_count(const Clause& clause, bool spaced);

/// Reads a rule into the system. Throws `SyntaxError`.
void read_rule(const Clause& clause, Reading& reading);

/// Reads `interpret L -> F` into the system. Throws `SyntaxError`.
void read_interpretation(const Clause& clause, Reading& reading);

/// Reads `coding { a -> 0; b -> 1 }` into the system. Throws `SyntaxError`.
void read_coding(const Clause& clause, Reading& reading);

/// Adds a finding for each left side whose rules have probabilities that do not add up to 1, or for
/// which only some rules have one.
void check_probabilities(const std::vector<Production>& rules, Reading& reading);

/// When a statement is read: names before the words they occur in, constants before the expressions.
enum class Stage {
    alphabet,
    constant,
    inner,  // systems within
    axiom,
    rule,
    ignore,
    terminals,
    interpretation,
    plot,
    stamp,
    solid,
    surface,
    other,
    unknown
};

/// What the values of statements are printed from.
struct Printing {
    const LSystem& system;
    const Drawing& drawing;  // of the whole file, as expectations are
    const std::vector<Expectation>& expectations;
    const Coding& coding;
    const Printer& printer;
    const OwnFunctions* functions;  // whose calls were kept; null for none
};

/// A statement that begins with a keyword: what users are told of it, when and how it is read, and how it is printed.
struct Setting {
    StatementHelp help;
    Stage stage;
    bool repeats;  // a file may have several
    bool within;   // it may stand in a system within another
    /// Reads it into the system. Throws `SyntaxError` or `DependsOnError`.
    void (*read)(const Clause&, Reading&);
    /// What stands behind the keyword, for each line of it; an empty text makes no line. Null for systems within and
    /// for tables, which are printed with their rules.
    std::vector<std::string> (*print)(const Printing&);

    const std::string& name() const { return help.keyword; }
};

/// All of them, in the order in which they are printed.
///
/// Example: settings().front().name() == "title"
const std::vector<Setting>& settings();

/// Reads `system leaf { ... }` into the system. Throws `SyntaxError`.
void read_inner(const Clause& clause, Reading& reading);

/// Throws `SyntaxError` where a name that is declared is too long, or has a character from `begin` on that
/// is reserved or one of `more`.
void check_symbol_name(std::string_view name, std::size_t begin, std::string_view more);

/// What `read(source, findings)` makes of a whole text; a `SyntaxError` becomes the last finding. Throws
/// `Diagnostics`.
template <class Read>
auto read_whole(std::string_view text, const std::string& name, Read read) {
    const Source source(text, name);
    Findings findings(source);
    findings.throw_if_no_text();
    try {
        return read(source, findings);
    } catch (const SyntaxError& error) {
        findings.add(error);
        findings.throw_if_any();
        throw;
    }
}

/// The system that a part of a source describes, in the notation of `.lsys` files, with findings at their
/// places in the source. `declared` are names of more than one character that are symbols there without
/// having been declared, `letters` those that an `alphabet` around it declares. The system is meaningless if
/// findings were added. `replaced` are constants that have these values instead of those of their `let`. In a system that is `typed` on one
/// line commas separate (`clauses`), and without an axiom it is the letter of the first rule. `functions` gets those that it makes for
/// itself, if the caller wants to know them.
Model read_system(std::string_view text, const Source& source, Findings& findings,
                  const std::string& name, const std::vector<std::string>& declared,
                  const std::vector<std::string>& letters, const ConstantValues& replaced = {},
                  bool typed = false, OwnFunctions* functions = nullptr);

}  // namespace algae
