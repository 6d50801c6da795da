#pragma once
// The formats of other programs, each read and printed in a source of its own, and parts of them that examples show.

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "exchange/detail/scanner.hpp"
#include "nature/nature.hpp"
#include "notation/notation.hpp"
#include "system/system.hpp"

namespace algae {

struct Model;

// Brno: brno.cpp.

/// The system in a text file of a geometric interpreter of D0L systems (Brno, 2008): sections
/// `modules:`, `axiom:`, `angles:`, `rules:`, then `END` and notes.
///
/// Modules are letters, each with a primitive that overrides the turtle's own meaning of it: a
/// cylinder `C(diameter, height)`, a line `P(length)`, a ball `S(diameter)`; those without one do
/// nothing. `+ -` turn by the angle U, `& ^` by L, `\ /` by H. Throws `Diagnostics` with everything
/// that is wrong. Linear time.
Model read_brno(std::string_view text, const std::string& name);

/// The file of a system. Throws Error that names what no file can say: it has single letters, one
/// rule for each, whole angles, whole lengths above 0, and no turtle that starts elsewhere than at
/// the origin and looks along x. Titles stand in a comment; colours, cameras, line widths and what
/// is expected are left out.
std::string print_brno(const Model& system);

/// What a module of a Brno file looks like.
struct BrnoPrimitive {
    char kind = 0;      // C a cylinder, P a line, S a ball; 0 is not to be seen
    long diameter = 0;  // of a cylinder and a ball
    long length = 0;    // of a cylinder and a line

    bool operator==(const BrnoPrimitive&) const = default;
};

/// The letters that a turtle knows besides modules.
inline constexpr const char* brno_turtle_symbols = "+-&^\\/|[]{}!";

/// A D0L system as a Brno file says it.
struct BrnoSystem {
    std::map<char, BrnoPrimitive> modules;
    std::string axiom;
    std::map<char, long> angles;                      // by L, U, H, in degrees
    std::vector<std::pair<char, std::string>> rules;  // in the order of the file
};

/// The symbols that turn about this vector, one way and the other: "+-" of U.
///
/// Example: brno_turns('U') == std::string("+-")
const char* brno_turns(char vector);

/// The same system in the notation. All lines that draw are plain steps where they are equally
/// long; otherwise modules are interpreted with their measures.
///
/// Example: brno_notation({{{'F', {'P', 0, 1}}}, "F", {}, {}}) == "axiom F\n"
std::string brno_notation(const BrnoSystem& system);

/// Where letters stand in the words of a system: between `{` and `}`, which fence a polygon, or not.
struct PolygonLetters {
    std::set<char> inside, outside;
};

/// Of the letters that the axiom reaches. Where braces do not match within a word, all of them count
/// as outside. Linear in the size of the rules.
///
/// Example: polygon_letters("aA", {{'A', "{bc}b"}}).inside == std::set<char>{'b', 'c'}
PolygonLetters polygon_letters(const std::string& axiom, const std::map<char, std::string>& rules);

/// How many braces are open where each letter of a word stands; an unmatched `}` counts for nothing.
///
/// Example: brace_depths("a{b}}c") == std::vector<std::size_t>{0, 1, 1, 0, 0, 0}
std::vector<std::size_t> brace_depths(const std::string& word);

// Maple: maple_system.cpp, maple_print.cpp.

/// The system of a Maple worksheet with one call `Lsystem(...)` and what is assigned before it:
///
/// - `Lsystem(AXIOMA, REGRAS, INCREMENTO, N)`: a string, a flat list of predecessors and successors,
///   the angle in degrees and the generation;
/// - `Lsystem(AXIOMA, REGRAS, PROB, INCREMENTO, N)`: the same with the probabilities of the rules,
///   which have one predecessor; percentages or fractions. The turtle starts upward;
/// - `Lsystem(AXIOMA, N)`: modules `["A",[1,10]]`, whose rules are functions `A := L -> [...]`.
///
/// Throws Diagnostics with the place of what is wrong.
///
/// Example: read_maple("Lsystem(\"F\", [\"F\",\"F+F\"], 60, 3);", "").rules.size() == 1
Model read_maple(std::string_view text, const std::string& name);

/// The worksheet of a system. What figures look like (colours, camera, widths of lines) and what is
/// expected of them is not in it, nor all generations but the last. Throws Error that names what a
/// worksheet cannot say: contexts, conditions, tables, probabilities of several predecessors, rules
/// for lower-case letters with parameters, and settings that change the figure.
///
/// Example: print_maple(read_lsystem("axiom F", "")) == "Lsystem(\"F\", [], 90, N);\n"
std::string print_maple(const Model& system);

// NetLogo: netlogo.cpp.

/// The system in a setup procedure of a NetLogo model of L-systems, or in a settings file of the
/// same lines: `add-rule "F" "F-F+F" "F"` with letter, successor and command, `set chain "F"` and so on.
///
/// Commands are F, f, +, -, [ and ] as the turtle's own, * where `k` is set, S a stamp; all else is
/// ignored. Of several rules for a letter one is chosen at random, all equally likely. Headings
/// are 0 in the north and grow clockwise; k-shorten and d-delta change d and delta-0 from one
/// generation to the next. Throws `Diagnostics` with everything that is wrong. Linear time.
Model read_netlogo(std::string_view text, const std::string& name);

/// The body of a setup procedure that says a system. Throws Error that names what no such procedure
/// can say: symbols longer than a character, contexts, parameters, tables, polygons, figures in
/// space, stamps other than squares, probabilities with denominators above 100. Titles stand in a comment;
/// colours, line widths and what is expected are left out.
std::string print_netlogo(const Model& system);

/// The same written: expressions with what NetLogo knows, all else by its value.
///
/// Example: netlogo_number(evaluate(parsed("1/sqrt(2)"), {})) == "1 / sqrt 2"
std::string netlogo_number(const Quantity& number);

/// The number of the opposite sign.
///
/// Example: negated(quantity(45)) == quantity(-45)
Quantity negated(const Quantity& number);

/// 90 minus the number of degrees: a heading counted clockwise from the north for one
/// counter-clockwise from +x, and the other way round.
///
/// Example: turned_compass(quantity(25)) == quantity(65)
Quantity turned_compass(const Quantity& degrees);

// Fractint: fractint.cpp.

/// One system of a file of Fractint, `NAME { Angle 6; Axiom F--F--F; F=... }` in lines; `name` is the file's, with `:NAME` behind it where
/// there are several. Each command with its number is one symbol. Throws Diagnostics with the place of whatever the program rejects, and of
/// a symbol that depends on `!`, the difference of the headings or the colour behind a letter that goes on changing it. Linear time unless the state
/// of the turtle takes many values, of which there may be 2000.
Model read_fractint(std::string_view text, const std::string& name);

/// The entry of a system. It says neither lengths of steps nor where figures stand, as the program fits them to the screen; colours and what
/// is expected are left out. Throws Error that names what it cannot say.
std::string print_fractint(const Model& system);

/// Whether a text looks like a file of Fractint: a line `NAME {` and one with Axiom or Angle.
bool looks_like_fractint(std::string_view text);

// cpfg and L-Py: cpfg.cpp, cpfg_print.cpp.

/// The L-system in a file of cpfg, as its preprocessor leaves it. Its `/` is the notation's `\`, its turtle looks up the page. Throws Diagnostics
/// with the place of what is wrong and of what has no meaning in the notation: rings, blocks, arrays, and rules whose order decides otherwise than the
/// lengths of their contexts. Of several systems `name` has the label of one behind it, `plant.l:2`. A program of lpfg is read as one.
Model read_cpfg(std::string_view text, const std::string& name);

/// The declarative part of a file of L-Py: constants, modules, axiom and rules with `-->`. Throws Diagnostics where it is a program.
Model read_lpy(std::string_view text, const std::string& name);

/// The file of a system. Throws Error that names what it cannot say.
std::string print_cpfg(const Model& system);
std::string print_lpy(const Model& system);

/// The declarative part of a program of lpfg in L+C: constants, modules, axiom, and rules whose blocks are made of `produce`, `if` and `else`.
/// Throws Diagnostics with the place of other statements.
Model read_lpfg(std::string_view text, const std::string& name);
/// A program of lpfg with the system's words up to the names of its letters, and its figures. Throws Error for what it cannot say: chance, contexts
/// with branches, functions of angles, which take radians there, and what `print_cpfg` refuses, but for names of letters.
std::string print_lpfg(const Model& system);

/// Whether a text looks like a file of cpfg: a line begins with `Lsystem:`, outside comments.
bool looks_like_cpfg(std::string_view text);

/// Whether it looks like a program of lpfg: it declares modules as `module A(float);` or includes lpfgall.h, outside comments.
bool looks_like_lpfg(std::string_view text);

/// Whether it looks like a control panel of vlab: a line begins with `panel name:` or `target:`.
bool looks_like_panel(std::string_view text);

// Rule strings: rule_strings.cpp.

/// The fields of Inkscape's extension L-system, a line `axiom = F` for each. A to F draw there, G to L move, and + turns to the right on the
/// page. Throws Diagnostics for what Inkscape drops or never uses, and for what is random.
Model read_inkscape(std::string_view text, const std::string& name);

/// A system of the TikZ library lindenmayersystems: `\rule{F -> F-F}` and `\symbol{X}{...}` in a declaration, or `l-system={rule set={...}, ...}`. Throws
/// Diagnostics with the place of TeX that is no command of the library.
Model read_tikz(std::string_view text, const std::string& name);

/// The same written. Throw Error that names what cannot be said: parameters, contexts, figures in space, several rules for a letter.
std::string print_inkscape(const Model& system);
std::string print_tikz(const Model& system);

// JFLAP: jflap.cpp.

/// The L-system in a file of JFLAP 4 to 8. Its turtle starts upward and + turns to the right; hues are left out. Throws
/// Diagnostics with the place of what is wrong and of a symbol that reads a variable behind a letter that goes on changing it.
Model read_jflap(std::string_view text, const std::string& name);

/// The file of a system, whose figure stands upright there. Throws Error that names what it cannot say.
std::string print_jflap(const Model& system);

/// The language of a finite automaton or of a grammar of JFLAP as a claim that defines it, `let A = regular { ... }`. Throws
/// Diagnostics with the place of what is wrong, and for grammars whose left sides have several letters.
std::string language_of_jflap(std::string_view text, const std::string& name);

// Morphisms: morphisms.cpp.

/// A morphism or a word automaton of Walnut.
///
/// A morphism is a line `0 -> 01` for each letter, numbers, those of several digits in brackets, `[10]`; the axiom is its first
/// letter. An automaton with output over one number system msd_K is the K-uniform morphism of its states with the outputs as coding. Throws
/// Diagnostics: other number systems, of several inputs, and lsd say no morphism.
Model read_walnut(std::string_view text, const std::string& name);

/// The word automaton of a uniform morphism, otherwise the morphism.
/// Throws Error that names what neither can say.
std::string print_walnut(const Model& system);

/// Whether a text looks like a file of Walnut: it begins with a number system.
bool looks_like_walnut(std::string_view text);

/// `WordMorphism('a->ab,b->a')` as Sage reads it, with the axiom of `m('a', 5)` if that stands there, otherwise its first letter. Throws
/// Diagnostics as Sage refuses it.
Model read_sage(std::string_view text, const std::string& name);

/// The same written. Every letter has its image, as Sage knows no identity. Throws Error that names what it cannot say.
std::string print_sage(const Model& system);

// Tables: tables.cpp.

/// The table of a rule of cells on a line as a file of the kind `ca`: entries
///
///     000 -> 0    100 -> 1
///
/// or two lines, local configurations and below each its next state:
///
///     111 110 101 100 011 010 001 000
///      0   1   1   0   1   1   1   0
///
/// Arrows may be `→` or those of LaTeX, `\underline` and the separators of tables are passed over. The
/// number of states is one more than the greatest that occurs, the radius is that of the entries, of
/// which none may be missing. Throws Diagnostics with the place of the entry that is missing, given
/// twice or ill-formed.
GeneratorFile read_ca_table(std::string_view text, const std::string& name);

/// The table of a CellularAutomaton, an entry a line. Its cells and what its figures show are not in
/// it. Throws Error if it lies in the plane.
std::string print_ca_table(const Generator& generator);

/// A table of maps (x,y) -> (a x + b y + e, c x + d y + f), a row each, as a file of the kind `ifs`:
///
///     w     a     b     c     d     e     f     p
///     1     0     0     0  0.16     0     0  0.01
///     2  0.85  0.04 -0.04  0.85     0   1.6  0.85
///
/// Blanks, tabs, `|` and `&` separate columns, so that tables of Markdown and of LaTeX are read too. A
/// header names the columns in any order; without one they are in the order above, with or without
/// names and probabilities. Throws Diagnostics with the place of what is missing or given twice.
GeneratorFile read_ifs_table(std::string_view text, const std::string& name);

/// The table of an IteratedFunctions. What its figures show is not in it. Throws Error if it has
/// several states.
std::string print_ifs_table(const Generator& generator);

}  // namespace algae
