#pragma once

#include <cctype>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "notation/notation.hpp"

namespace algae {

struct Model;

// What the readers of cpfg, L-Py and lpfg share: texts whose characters know where they stood, the preprocessor, expressions, modules and
// rules, and the notation that says what was read.

/// Which of the three programs: cpfg, L-Py or lpfg, whose language is L+C.
struct CpfgDialect {
    bool python = false;
    const char* name = "cpfg";
    double angle = 45;
    bool plus = false;  // lpfg
};

/// The first letter of an axiom that stands the turtle up along z, where the notation looks for what is level.
inline constexpr const char* cpfg_upward = "X_118";

/// The letters that change the elasticity of a tropism, with its number in the view file: E_1.
inline constexpr const char* cpfg_elastic = "E_";

/// A text whose characters know where they stood.
struct Placed {
    std::string text;
    std::vector<std::size_t> at;

    void add(char c, std::size_t place) {
        text += c;
        at.push_back(place);
    }
    void append(const Placed& more) {
        text += more.text;
        at.insert(at.end(), more.at.begin(), more.at.end());
    }
    Placed part(std::size_t from, std::size_t to) const {
        to = std::min(to, text.size());
        from = std::min(from, to);
        return {text.substr(from, to - from),
                {at.begin() + static_cast<std::ptrdiff_t>(from),
                 at.begin() + static_cast<std::ptrdiff_t>(to)}};
    }
    Placed trimmed() const {
        std::size_t from = 0, to = text.size();
        while (from < to && std::isspace(static_cast<unsigned char>(text[from]))) ++from;
        while (to > from && std::isspace(static_cast<unsigned char>(text[to - 1]))) --to;
        return part(from, to);
    }
    std::size_t place(std::size_t i) const {
        return at.empty() ? 0 : i < at.size() ? at[i] : at.back() + 1;
    }
};

inline bool is_name_start(char c) {
    return std::isalpha(static_cast<unsigned char>(c)) || c == '_';
}
inline bool is_name_part(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; }

/// A finding at a byte of the text, with its place in the file that a line `# 1 "NAME"` before it names.
Diagnostic cpfg_finding(const Source& source, std::size_t place, const std::string& message);

/// Throw Diagnostics with that finding; `what` has no meaning here, and `why` says why.
[[noreturn]] void cpfg_fail(const Source& source, std::size_t place, const std::string& message);
[[noreturn]] void cpfg_refuse(const Source& source, std::size_t place, const std::string& what,
                              const std::string& why);

/// Names of L-Py's own modules, with the symbols that say the same.
const std::vector<std::pair<std::string, std::string>>& lpy_names();

/// The text without comments, with macros replaced; of L-Py without what its editor saves. Throws Diagnostics for directives other than #define and #if, for
/// macros that go round in circles and comments that are never closed.
Placed preprocessed(const Source& source, const CpfgDialect& dialect);

/// Names that are no parameters, with what the notation says for them; nothing for one that it cannot say.
using CpfgNames = std::map<std::string, std::string>;

/// What is a whole number in C by its type: names, and the expression where it stands for such a parameter.
struct CpfgIntegers {
    std::set<std::string> names;
    bool wanted = false;
};

/// An expression in the notation, with the brackets that keep the grouping of the program. Names are those of parameters and `known` ones;
/// others are 0 in cpfg. Throws Diagnostics with the place of what is wrong or has no meaning in the notation.
std::string cpfg_expression(const Source& source, const CpfgDialect& dialect, const Placed& text,
                            const std::set<std::string>& names, const CpfgNames& known,
                            const CpfgIntegers& integers = {});

/// A module: its symbol and the texts of its arguments.
struct CpfgModule {
    std::string symbol;
    std::size_t place = 0;
    std::vector<Placed> arguments;
    bool has_arguments = false;
    bool open = false;  // in a context: `=` stands behind it

    /// What tells it from others: the symbol and the number of arguments.
    std::string kind() const { return symbol + "/" + std::to_string(arguments.size()); }
};

struct CpfgRule {
    std::vector<CpfgModule> left, right;
    CpfgModule predecessor;
    std::vector<CpfgModule> several;  // a predecessor of more than one module
    std::optional<Placed> condition, weight;
    Placed successor;
    std::size_t place = 0;
    std::vector<CpfgModule> elsewhere;  // modules that the notation looks for in the whole word
    std::set<std::string> assigned;     // names that its blocks assign
    enum class Part { all, first, last } part = Part::all;  // of the successor, as a letter for it

    std::string letter() const { return predecessor.kind(); }
    /// Modules of both contexts and elsewhere; brackets do not count where the longest context is chosen.
    std::size_t reach() const {
        std::size_t count = elsewhere.size();
        for (const auto* side : {&left, &right})
            for (const CpfgModule& module : *side)
                count += module.symbol == "[" || module.symbol == "]" ? 0 : 1;
        return count;
    }
};

/// What a file says, before the notation says it.
struct CpfgSystem {
    std::vector<std::pair<std::string, Placed>> constants;
    std::set<std::string> integers;    // constants of lpfg that are whole numbers
    std::vector<std::string> modules;  // declared names
    std::map<std::string, std::vector<std::string>> types;  // of the parameters of lpfg's modules
    Placed axiom;
    std::vector<CpfgRule> rules, decomposition, interpretation;
    std::uint64_t depth = 1;        // of the decomposition
    std::uint64_t drawn_depth = 1;  // of the homomorphism
    std::optional<Placed> ignored, considered;
    std::string generation;  // empty where none is said
    bool stochastic = false;
    std::map<std::string, Placed> started;  // what the block Start assigns
    std::map<std::string, Placed> growing;  // what StartEach adds to a name in each step
    std::set<std::string> kept;             // names that keep what blocks of rules assign
    std::optional<std::size_t> ring;        // where the file says that the ends of words are joined
};

/// What the readers of the three kinds of files share.
class CpfgReader {
protected:
    /// The source must outlive it.
    CpfgReader(const Source& source, const CpfgDialect& dialect, CpfgSystem system = {})
        : dialect_(dialect), source_(source), system_(std::move(system)) {}

    [[noreturn]] void fail(std::size_t place, const std::string& message) const;
    [[noreturn]] void refuse(std::size_t place, const std::string& what,
                             const std::string& why) const;

    // Lines and words.

    /// Lines, joined where the next one begins with a tabulator, or of L-Py within brackets.
    std::vector<Placed> statements(const Placed& whole) const;
    /// The size of the first of these keywords with which a text begins; nothing if it begins with none. A blank in a keyword may be left out,
    /// but in L+C, where lines may end there too, and before a colon.
    std::optional<std::size_t> keyword_size(const Placed& text,
                                            std::initializer_list<const char*> keywords) const;
    /// What stands behind that keyword.
    std::optional<Placed> behind(const Placed& line,
                                 std::initializer_list<const char*> keywords) const;
    /// Where something stands from here on that is no white space.
    static std::size_t next(const Placed& text, std::size_t at);
    /// Where the bracket closes that stands at this place.
    std::size_t closing(const Placed& text, std::size_t at) const;
    /// The name at this place; empty if there is none.
    static std::string name_at(const Placed& text, std::size_t at);
    /// How errors name what stands there.
    static std::string shown(const Placed& text, std::size_t at);
    /// The first of these characters outside brackets.
    static std::size_t outside(const std::string& text, char wanted);
    /// The whole number from 0 on that an expression of constants is.
    std::uint64_t number(const Placed& text, const char* what) const;

    // Statements.

    /// Whether a line is one of the header of cpfg, or of the declarations of L-Py, which is then read.
    bool read_header(const Placed& said);
    /// `left < A(x) > right : condition --> successor : weight`
    CpfgRule rule(const Placed& line) const;
    /// The contexts and the predecessor of a rule.
    CpfgRule head_of(Placed head) const;
    /// A rule for each `produce`, with the conditions that lead to it; the first that applies is used there too, and where none
    /// does the block falls through and the rule is not used.
    void add_produced(std::vector<CpfgRule>& all, const CpfgRule& head,
                      const std::vector<Placed>& path, Placed successor, std::size_t place) const;
    /// The condition in brackets, or its negation.
    Placed side(const Placed& condition, bool holds) const;
    /// A module of this name is declared there. Fails where the notation gives the name a meaning.
    void declare(const std::string& name, std::size_t place);
    /// Modules, each command of several symbols being one: `@v`, `~l`, `?P`.
    std::vector<CpfgModule> modules(const Placed& text) const;

    // Blocks.

    /// `Start: { x = 1; }`, which is then read. Refuses what is no assignment.
    bool read_header_block(const Placed& said);
    /// Takes the blocks from the condition of a rule, `{x = 1;} x > y {z = 2;}`, and puts what they assign where it is read.
    void read_blocks(CpfgRule& rule) const;
    /// Adds what the statements of a block assign, in terms of what stood there before.
    void assign(const Placed& block, std::map<std::string, Placed>& values) const;

    CpfgDialect dialect_;
    const Source& source_;
    CpfgSystem system_;  // what was read so far

private:
    std::vector<CpfgModule> context(const Placed& text) const;
    void check_formals(const CpfgModule& module) const;
    void refuse_brackets(const std::vector<CpfgModule>& modules, const char* where) const;
    std::size_t plus_name(const Placed& text, std::size_t at, CpfgModule& module) const;
    std::vector<CpfgModule> single_modules(const Placed& text) const;
};

/// A text in which names stand for others, those of the same places, in brackets.
Placed cpfg_with(const Placed& text, const std::map<std::string, Placed>& values);
/// The same of a word, in the numbers of its modules.
Placed cpfg_with_in_numbers(const Placed& word, const std::map<std::string, Placed>& values);
/// The same system with what its blocks assign as constants, and in terms of the step where it grows.
CpfgSystem with_assigned(CpfgSystem system);

/// Whether a symbol is a command of several characters, `@v`.
inline bool is_cpfg_command(const std::string& symbol) {
    return std::string_view("@~?").find(symbol[0]) != std::string_view::npos;
}

/// The axiom, whose owner is empty, or a successor of its owner, by symbols.
struct CpfgWord {
    std::string owner;
    std::vector<std::string> letters;
};

/// Whether each branch that a right context names can only be the first of the branches that stand together in words, as it is meant
/// there. Contexts skip these symbols. False where a bracket has no partner in its word.
bool only_first_branches_match(const std::vector<CpfgModule>& context,
                               const std::vector<CpfgWord>& words,
                               const std::set<std::string>& skipped);

/// The same system with one module as predecessor of each rule, and with rules for commands where a rule rewrites a part of one. Throws
/// Diagnostics where that cannot be said by rules of the notation.
CpfgSystem with_single_predecessors(const Source& source, const CpfgDialect& dialect,
                                    CpfgSystem system);

/// The model that a system is in the notation. Throws Diagnostics with the place of what it cannot say.
Model cpfg_model(const Source& source, const CpfgDialect& dialect, CpfgSystem system);

}  // namespace algae
