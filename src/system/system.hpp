#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "exact/exact.hpp"
#include "word/word.hpp"

// system: an L-system as it was written (axiom, rules and what belongs to them), its classes as views with the theory's types
// (D0L, 0L, IL, S0L, ET0L, tree systems), and the one idea of this library: `fold`.
//
// A D0L system is a morphism h and a word w. A homomorphic image of h^n(w) never needs the word: one value a letter is
// enough, and `fold(system, n, image)` computes it. Lengths, Parikh vectors, letters far into a word, the turtle's path
// and the sets of words of a system with choices are all folds into a monoid of their own.

namespace algae {

struct ModuleWord;

/// An arithmetic or logical expression over named parameters and constants, as written.
///
/// Operators, loosest first: `|`, `&`, relations (`< <= > >= = !=`), `+ -`, `* /`, unary `- !`,
/// `^` (right associative, binds tighter than unary minus: -2^2 = -4). Truth is 1, falsehood 0.
/// Values are numbers and words: `"FF[+F]"`, and of a system NAME within the file `NAME(n)`, the
/// word of its generation n, a call. length(w) is the number of a word's modules; no other function or
/// operator takes words. Functions: sin cos tan asin acos atan (degrees), sqrt exp log abs floor ceil min max; of an axis
/// and a symbol, whose names are its operands, distance.
struct Expression {
    enum class Kind { number, name, unary, binary, call, word };

    Kind kind = Kind::number;
    Rational value;                    // of a number
    std::string name;                  // the name, the operator, the function or the word's text
    std::vector<Expression> operands;  // one or two of an operator, the arguments of a call
    std::shared_ptr<const ModuleWord> word = {};  // of a word; its text says it too
    Place place;                                  // where it starts; not part of its identity

    bool operator==(const Expression& other) const {
        return kind == other.kind && value == other.value && name == other.name &&
               operands == other.operands;
    }
};

/// A number written as an expression: exact where it is made by + - * / and integral powers of
/// rationals, and a double in any case.
struct Quantity {
    Expression expression;
    std::optional<Rational> exact;
    double value = 0;

    bool operator==(const Quantity& other) const { return expression == other.expression; }
};

/// The quantity of a plain rational, written as a person would: 0.25, 1/3, -2.
Quantity quantity(const Rational& value);

/// Whether it is `distance(AXIS, SYMBOL)`.
bool is_distance(const Expression& expression);

/// Whether a word stands in it: one in quotes, one of a system, or a length.
bool reads_words(const Expression& expression);

/// What a name in an expression stands for; nullptr where it stands for nothing. A distance goes by
/// its text, `distance(X,wall)`.
using Names = std::function<const Quantity*(const std::string&)>;

/// The value of an expression: exact where all of it is made by + - * / ^, relations, logic, abs,
/// floor, ceil, min and max from exact values, or is a function of one number that is seen to be
/// rational. Throws `Diagnostics` with one finding, without its line, at the place of
/// the part that has no value: an unknown name, a division by 0, sqrt(-1), a number too large.
///
/// Example: evaluate(parsed("2^-3*6"), {}).exact == Rational(3, 4)
Quantity evaluate(const Expression& expression, const Names& names);

/// The value of a function of one number where it is seen to be rational: abs, floor, ceil, roots of squares, and
/// what is known of the others, angles in degrees. Nothing otherwise, also where there is no value.
///
/// Example: rational_value("sin", 390) == Rational(1, 2)
std::optional<Rational> rational_value(std::string_view function, const Rational& value);

/// The number of arguments that a function takes: exactly `least`, or `least` and more; nothing if
/// there is no such function.
struct Arity {
    std::size_t least;
    bool or_more;
};
std::optional<Arity> function_arity(std::string_view name);

/// All functions, by name.
const std::vector<std::string>& function_names();

/// The shortest decimal that is exactly this, "0.25" or "1e300"; "1/3" where there is none.
///
/// Example: shortest_text(Rational(257, 10)) == "25.7"
std::string shortest_text(const Rational& value);

/// The expression with as few brackets as it needs, blanks only around logical and relational
/// operators: "x+y", "(x+y)/2", "x <= 3 & y > 0". Read back, it is the same expression.
///
/// Example: to_text(parsed("((x+y)/2)")) == "(x+y)/2"
std::string to_text(const Expression& expression);

/// What fills the communication modules of one name, as a file says it: `environment ?E clip 0 0 4 3`.
struct EnvironmentSetting {
    Symbol module = 0;
    std::string kind;  // one of environment_kinds()
    std::vector<Quantity> numbers;

    bool operator==(const EnvironmentSetting&) const = default;
};

/// A kind of environments: its name and what stands behind it.
struct EnvironmentKind {
    std::string name;
    std::string numbers;              // in words: "a radius"; empty if there are none
    std::vector<std::size_t> counts;  // how many there may be
};

/// All kinds of environments that a file can name; the face of `turtle` says what they answer.
///
/// Example: environment_kinds().front().name == "x"
const std::vector<EnvironmentKind>& environment_kinds();

/// Whether modules of this name ask an environment: a question mark with something behind it.
///
/// Example: is_communication("?E") && !is_communication("?")
bool is_communication(std::string_view name);

/// A word whose letters may carry parameters: `CB(1)A(x*2,x+y)`. Most words have none, so the
/// letters stand in one Word and only the positions that carry arguments are kept beside it. Where
/// `<w>` stands, the word comes that w gives: `[<w>]B(w)`.
struct ModuleWord {
    Word letters;
    std::map<std::size_t, std::vector<Expression>> arguments;  // by position in letters
    std::map<std::size_t, std::vector<Expression>> splices =
        {};  // by how many letters stand before

    bool operator==(const ModuleWord&) const = default;
};

/// A module in a predecessor or a context: a symbol and the names of its formal parameters.
struct ModulePattern {
    Symbol symbol = 0;
    std::vector<std::string> parameters;

    bool operator==(const ModulePattern&) const = default;
};
using Pattern = std::vector<ModulePattern>;

/// A shape rule's successor: `div(Y, 3, 1r, 1r){ B C C }`, `repeat(Y, 0.3){ C }`, `I(B)`.
struct ShapeSuccessor {
    struct Size {
        Expression value;
        bool relative = false;  // written with r
        bool operator==(const Size&) const = default;
    };
    std::string operation;    // div, repeat or I
    std::string axis;         // X, Y, Z; of several, that of each size: XXZ; empty for I
    std::vector<Size> sizes;  // of div and repeat
    Word parts;               // between braces; for I the one symbol in its brackets

    bool operator==(const ShapeSuccessor&) const = default;
};

/// One rule as written: left < predecessor > right ? elsewhere : condition -(p)-> successor.
struct Production {
    Pattern left;
    ModulePattern predecessor;
    Pattern right;
    Pattern elsewhere;  // context condition: modules anywhere else in the word
    std::optional<Expression> condition;
    std::optional<Rational> probability;
    ModuleWord successor;
    std::optional<ShapeSuccessor> shape;  // then successor is empty
    std::size_t table = 0;                // index into LSystem::tables; 0 where there are none
    Place place;                          // where the rule starts; not part of its identity

    bool operator==(const Production& other) const {
        return left == other.left && predecessor == other.predecessor && right == other.right &&
               elsewhere == other.elsewhere && condition == other.condition &&
               probability == other.probability && successor == other.successor &&
               shape == other.shape && table == other.table;
    }
};

struct InnerSystem;

/// The L-system as its file says it: every construct that its words depend on, none interpreted. How
/// it is drawn is no part of it; that is said by the Model. What a theorem needs is a view of it (D0L, OL, IL, ...), or a reason why not.
struct LSystem {
    std::string name;  // of the file or gallery entry it came from, for messages; may be empty
    std::string title;
    std::string source;
    std::vector<std::string> identifiers;  // `id S-005 F-007`: where a catalogue lists it
    Alphabet alphabet;
    std::vector<Symbol> declared;  // by `alphabet`: names that may be longer than one character
    std::vector<std::pair<std::string, Quantity>> constants;  // `let`, in order
    std::vector<InnerSystem> inner;  // `system leaf { ... }`: others, whose words it uses
    ModuleWord axiom;
    Place axiom_place;
    std::vector<Production> rules;
    std::vector<std::string> tables;         // names of T0L tables; empty where there are none
    std::vector<std::size_t> schedule;       // `schedule`: tables of the steps, repeated; or empty
    std::vector<Symbol> ignored;             // `ignore`: skipped when contexts are matched
    std::vector<Symbol> terminals;           // `terminals`: E0L
    std::vector<Production> interpretation;  // `interpret L -> F`
    std::vector<EnvironmentSetting> environments;  // at most one for each module

    bool operator==(const LSystem& other) const;  // all but names and places of origin
};

/// A system within another: an axiom, rules, and what they ignore, over the alphabet and with the
/// constants of the outer one, so that its own are empty. Expressions of all of them may say
/// `leaf(3)` for its word of generation 3.
struct InnerSystem {
    std::string name;
    LSystem system;
    Place place;  // not part of its identity

    bool operator==(const InnerSystem& other) const {
        return name == other.name && system == other.system;
    }
};

/// Whether there are systems within it, or words as parameters or spliced into others.
bool holds_words(const LSystem& system);

/// Whether it has several tables and no schedule says which are used when.
bool leaves_tables_open(const LSystem& system);

/// The table of the step from this generation by the schedule, which starts again when it ends; 0
/// where there is none.
///
/// Example: scheduled_table(read_lsystem("axiom a; table s; table t; schedule s t", ""), 3) == 1
std::size_t scheduled_table(const LSystem& system, std::uint64_t generation);

/// The names in the schedule, as written.
///
/// Example: schedule_names(read_lsystem("axiom a; table s; schedule s s", "")).size() == 2
std::vector<std::string> schedule_names(const LSystem& system);

/// What kind of L-system a file describes, as read off its rules. Nothing is derived.
struct Class {
    bool deterministic = true;  // at most one rule for a letter, arity and context in each table,
                                // or several with conditions that are seen to exclude each other
    bool propagating = true;    // no rule has the empty successor
    bool stochastic = false;    // some rule has a probability
    bool parametric = false;    // some module has parameters, or some rule a condition
    bool bracketed = false;     // there are [ and ]
    bool extended = false;      // there are terminals
    bool open = false;          // there are communication modules
    bool shape = false;         // there are shape rules
    bool conditional = false;   // some rule has a context condition
    bool nested = false;        // there are systems within it, or words as parameters
    std::size_t tables = 0;
    std::pair<std::size_t, std::size_t> context = {0, 0};  // the longest left and right contexts

    /// The name of the class with the letters of Rozenberg and Salomaa: E extended, P propagating,
    /// D deterministic, T with tables, S stochastic; then 0L or (k,l)L; "parametric", "open",
    /// "shape", "with context conditions" and "with systems within" where they apply. "PD0L", "(1,0)L", "parametric D0L".
    std::string name() const;
};

/// O(size of the system), and what `overlaps` takes.
Class class_of(const LSystem& system);

/// Two rules of one table with the same modules on their left sides, which can both match one module where `both`
/// says so: then no rule of a system without probabilities says which of them is used.
struct RuleOverlap {
    std::size_t first = 0, second = 0;  // places in LSystem::rules
    /// Parameters of the first rule, by their names there, for which both conditions hold; nothing
    /// where it was not decided whether there are any.
    std::optional<std::vector<std::pair<std::string, Rational>>> both;
};

/// The pairs of rules that are not seen to exclude each other: of conditions, linear comparisons are decided
/// exactly (Fourier and Motzkin), and other terms stand for numbers of which only a little is known,
/// as floor(x) <= x. A pair with probabilities is left out, and so are equal rules without parameters. At most 1,000 pairs.
///
/// Example: overlaps(read_lsystem("axiom A(1); A(x) : x < 2 -> A(x+1); A(x) : x >= 2 -> B", "")).empty()
/// Example: overlaps(read_lsystem("axiom A(1); A(x) : x < 2 -> A(x+1); A(x) : x > 1 -> B", "")).size() == 1
std::vector<RuleOverlap> overlaps(const LSystem& system);

/// Modules that a word may have, though no rule for their letter takes so many parameters.
struct UnmatchedModule {
    Symbol letter = 0;
    std::size_t parameters = 0;
    std::vector<std::size_t> expected;  // of the rules for this letter, each once, ascending
};

/// The modules of the axiom and of successors that no rule matches because of the number of their parameters,
/// in order of first occurrence. Letters without rules stay, and are left out. O(n log n).
///
/// Example: unmatched_modules(read_lsystem("axiom A(1); A(x) -> A(x,1)", "")).front().parameters == 2
std::vector<UnmatchedModule> unmatched_modules(const LSystem& system);

/// A system seen as a narrower type, or the reason why it cannot be: "rule at a.lsys:3:1 has a
/// context". Functions of the theory take the narrow types, so what they need is checked once.
template <class T>
class View {
public:
    View(T value) : value_(std::move(value)) {}
    static View refused(std::string reason) { return View(std::move(reason), 0); }

    explicit operator bool() const { return value_.has_value(); }
    const std::string& reason() const { return reason_; }

    /// The view. Throws Error with the reason if there is none.
    const T& value() const {
        if (!value_) throw Error(reason_);
        return *value_;
    }
    const T& operator*() const { return value(); }
    const T* operator->() const { return &value(); }

private:
    View(std::string reason, int) : reason_(std::move(reason)) {}
    std::optional<T> value_;
    std::string reason_;
};

/// A D0L system: a word and a morphism (Rozenberg and Salomaa 1980, I.1). Every letter has exactly
/// one successor, a letter without a rule itself. Analyses look only at `letters`, those that
/// occur in some h^n(axiom): the others could cost without bound and mean nothing.
struct D0L {
    std::shared_ptr<const Alphabet> alphabet;
    Word axiom;
    Morphism rules;               // total on the alphabet
    std::vector<Symbol> letters;  // accessible from the axiom, in order of first access
    std::string name;             // for messages
    /// Set if brackets match in every word of the system because no rule rewrites them and every
    /// successor matches its own; then a Branching fold gives them their meaning, otherwise they are
    /// letters like any other.
    std::optional<Brackets> brackets = {};

    const Word& successor(Symbol a) const { return rules[a]; }
};

/// The system as a D0L system, if it is one: no contexts, conditions, parameters, probabilities
/// below 1, tables or terminals, and at most one rule a letter (the same rule twice is one rule).
/// Interpretation rules and turtle settings do not matter. O(size of the system).
View<D0L> as_d0l(const LSystem& system);

/// A D0L system from its parts: total rules over the alphabet.
D0L make_d0l(std::shared_ptr<const Alphabet> alphabet, Word axiom, std::vector<Word> images,
             std::string name = {});

/// The same with one character a letter, for tests and examples.
///
/// Example: d0l("b", {{'a', "ab"}, {'b', "a"}}).letters.size() == 2
D0L d0l(const std::string& axiom, const std::vector<std::pair<char, std::string>>& productions);

/// Whether no accessible letter has the empty successor (a PD0L system).
bool is_propagating(const D0L& system);

/// An 0L system: a word and a finite substitution (Rozenberg and Salomaa 1980, II.1). Every letter
/// has at least one successor, a letter without a rule itself. Successors of a letter are distinct.
struct OL {
    std::shared_ptr<const Alphabet> alphabet;
    Word axiom;
    std::vector<std::vector<Word>> successors;  // by symbol
    std::vector<Symbol> letters;  // accessible from the axiom, in order of first access
    std::string name;
};

/// The system as an 0L system, if it is one: no contexts, conditions, parameters, probabilities,
/// tables or terminals. O(size of the system).
View<OL> as_ol(const LSystem& system);

/// An 0L system with one character a letter, for tests and examples.
OL ol(const std::string& axiom, const std::vector<std::pair<char, std::string>>& productions);

/// Whether no accessible letter has the empty word among its successors (a P0L system).
bool is_propagating(const OL& system);

/// Why the rules of a system are not those of an 0L system: the first construct that goes beyond
/// them, by name and place; empty if there is none. `probabilities` says whether probabilities
/// below 1 count as such.
std::string beyond_ol(const LSystem& system, bool probabilities = true);

/// A stochastic 0L system: a word, and for each letter words with probabilities, which add up to 1;
/// every letter of a word takes one of them, independently of the others (Eichhorst and Savitch
/// 1980; Prusinkiewicz and Lindenmayer 1990, 1.7).
struct S0L {
    std::shared_ptr<const Alphabet> alphabet;
    Word axiom;
    std::vector<std::vector<std::pair<Word, Rational>>> alternatives;  // by symbol; rules in order
    std::string name;
};

/// The system as a stochastic 0L system, if it is one: no contexts, conditions, parameters, tables
/// or terminals, and probabilities wherever a letter has a choice. A letter without a rule stays.
View<S0L> as_s0l(const LSystem& system);

/// The successors of each letter, by symbol: one or more for each. A step of derivation uses one table.
using Table = std::vector<std::vector<Word>>;

/// An extended 0L system with tables: a word, tables of finite substitutions, and terminals. Its
/// language are the derived words that have terminals only (Rozenberg and Salomaa 1980, V.1). With one
/// table it is an E0L system; where every letter is a terminal it is a T0L or 0L system.
struct ET0L {
    std::shared_ptr<const Alphabet> alphabet;
    Word axiom;
    std::vector<Table> tables;             // at least one
    std::vector<char> terminal;            // by symbol
    std::vector<std::string> table_names;  // one for each table, empty where it has no name
    std::string name;                      // for messages
};

/// The system as an ET0L system, if it is one: no contexts, conditions, parameters or probabilities.
/// Where it has no tables its rules are the one table; a letter without a rule in a table stays as it
/// is there; without terminals every letter is one. O(size of the system).
View<ET0L> as_et0l(const LSystem& system);

/// The same system with one table in which every letter is a terminal.
///
/// Example: as_et0l(ol("a", {{'a', "aa"}})).tables.size() == 1
ET0L as_et0l(const OL& system);

/// Every letter is a terminal: a T0L system.
bool has_only_terminals(const ET0L& system);
/// In each table every accessible letter has one successor: an EDT0L system.
bool is_deterministic(const ET0L& system);
/// No accessible letter has the empty successor in any table: an EPT0L system.
bool is_propagating(const ET0L& system);

/// The letters that occur in some derived word, in order of first access.
std::vector<Symbol> accessible_letters(const ET0L& system);

/// The family that the form of the system shows, with the letters of Rozenberg and Salomaa: "D0L",
/// "PT0L", "E0L", "EDT0L".
///
/// Example: family_name(as_et0l(ol("a", {{'a', "aa"}}))) == "PD0L"
std::string family_name(const ET0L& system);

/// The same system over another alphabet that has all its symbols by name: letters that it does not
/// know stay as they are and are no terminals. Throws Error if a symbol is missing there.
ET0L over(const ET0L& system, std::shared_ptr<const Alphabet> alphabet);

/// An ET0L system with one character a letter, for tests and examples: tables of rules, and the
/// terminals; no terminals means all letters.
ET0L et0l(const std::string& axiom,
          const std::vector<std::vector<std::pair<char, std::string>>>& tables,
          const std::string& terminals = "");

/// A system with interactions, IL: what a letter becomes depends on the letters around it (Rozenberg and
/// Salomaa 1980, VI; Prusinkiewicz and Lindenmayer 1990, 1.8).
///
/// A rule `left < a > right -> successor` matches a letter a of a word if its left context ends
/// just before a and its right context begins just behind a. All letters are rewritten at once.
/// - Of the rules that match, the one with the most letters in its contexts is used (brackets are
///   not counted), and of equally long ones the first in the file; a letter that none matches stays.
/// - Rules of one letter with the same two contexts are a choice: each letter where they are used takes one of them,
///   whatever the others take. A system without choices is deterministic, DIL. The (k,l)-systems of the
///   literature, in which all contexts have k and l letters except near the ends of words, are systems of this kind.
/// - Beyond the ends of a word stands nothing, and no context matches there.
/// - Ignored letters are not seen when contexts are matched, but are rewritten as all others; a
///   context that names one matches nowhere.
///
/// In a system with brackets a word is an axial tree: an axis of letters, and between any two of
/// them branches, `[` tree `]`.
/// - Left context: letters alone. They are the last ones of the path from the root, that is, of
///   what is left before the letter when all branches closed before it are taken away, and the
///   brackets still open.
/// - Right context: an axial tree too. Its letters are the next ones of the axis on which the
///   letter stands; no context goes on behind the end of that axis, where its branch is closed.
///   Its branches between two letters are, each as a right context at the beginning of a branch,
///   in order, some of the branches that the word has there. Other branches are skipped, so `[]`
///   means any branch. At the end of the context the word may go on in any way.
/// - Brackets are rewritten only by rules for them. `[` sees what the first letter of its branch
///   would see on the left, and its branch on the right; `]` sees the path that ends in its branch
///   on the left, and what is behind the branch on the right. A word whose brackets do not match
///   is an error.
///
/// So `BC < S > G[H]M` matches S in ABC[DE][SG[HI[JK]L]MNO]. Where both brackets are ignored,
/// words are no trees, and brackets are ignored letters.
struct IL {
    struct Rule {
        Word left, right;  // contexts, read from left to right; empty ones match anywhere
        Word successor;
    };
    std::shared_ptr<const Alphabet> alphabet;
    Word axiom;
    /// By symbol, in the order in which they are tried; those with the same contexts stand together, each successor once.
    std::vector<std::vector<Rule>> rules;
    std::vector<char> ignored;  // by symbol: not seen when contexts are matched
    std::string name;
    std::optional<Brackets> brackets = std::nullopt;  // where words are axial trees
};

/// The system as an IL system over plain letters, if it is one. Contexts whose brackets do not fence branches are
/// refused. O(size of the system).
View<IL> as_il(const LSystem& system);

/// The same if it is deterministic: two rules with the same letter and contexts are refused.
View<IL> as_dil(const LSystem& system);

/// Whether no two rules of a letter have the same contexts (a DIL system).
bool is_deterministic(const IL& system);
/// Whether no rule has the empty successor (a PIL system).
bool is_propagating(const IL& system);

/// An IL system with one character a letter, for tests and examples: rules such as "a < b > c -> d", contexts where
/// there are any.
///
/// Example: !is_deterministic(il("ab", {"a > b -> aa", "a > b -> b"}))
IL il(const std::string& axiom, const std::vector<std::string>& rules);

/// The same system over another alphabet that has all its symbols by name: letters that it does not
/// know stay as they are. Throws Error if a symbol is missing there.
IL over(const IL& system, std::shared_ptr<const Alphabet> alphabet);

/// An axial tree (Prusinkiewicz and Lindenmayer 1990, 1.6.1): a rooted tree with labelled edges, of
/// which at most one leaving a vertex goes straight on; the others are lateral. Vertex 0 is the
/// root, and edge i ends at vertex i + 1 and starts at a vertex not above i.
struct AxialTree {
    struct Edge {
        Symbol label = 0;
        std::size_t start = 0;  // a vertex
        bool straight = true;
        bool operator==(const Edge&) const = default;
    };
    std::vector<Edge> edges;

    bool operator==(const AxialTree&) const = default;
};

/// The tree that a bracketed word describes, edges in the order of the word: in A[B]C, C goes on
/// straight after A and B is lateral. Brackets without letters leave nothing, and a bracket at the
/// beginning of another starts at the same vertex: A[[B]C] is A[B][C]. Throws Error if the brackets
/// do not match. Linear.
AxialTree axial_tree(const Word& word, const Brackets& brackets);

/// The tree without the edges whose labels are not among `labels` (by symbol): their ends fall on
/// their starts. F[+F] has two edges if + is none. Linear.
AxialTree restricted(const AxialTree& tree, const std::vector<char>& labels);

/// A word that describes the tree: at each vertex the lateral branches in the order of their first
/// edges, then what goes straight on. Linear.
Word bracketed_word(const AxialTree& tree, const Brackets& brackets);

/// The tree with the lateral branches of each vertex in a fixed order and edges in the order of the
/// word. Two trees are the same, whatever the order of their lateral branches, if and only if their
/// canonical trees are equal. O(n log n) by Aho, Hopcroft and Ullman's classes of subtrees.
AxialTree canonical(const AxialTree& tree);

/// The order of the axis of each edge: 0 for the axis at the root, n + 1 for one that starts
/// laterally on an axis of order n. Linear.
std::vector<std::size_t> axis_orders(const AxialTree& tree);

/// Axes and edges of one order.
struct OrderCount {
    std::uint64_t axes = 0, edges = 0;
    bool operator==(const OrderCount&) const = default;
};

/// How many axes and edges there are of each order, up to the greatest. Linear.
std::vector<OrderCount> order_counts(const AxialTree& tree);

/// A tree 0L-system (tree-0L; Prusinkiewicz and Lindenmayer 1990, 1.6.2), deterministic: an axial
/// tree and for each label the axial tree that replaces edges so labelled. The start of an edge
/// becomes the root of its replacement, its end the end of the replacement's axis of order 0.
struct TreeSystem {
    std::shared_ptr<const Alphabet> alphabet;
    Brackets brackets;
    AxialTree axiom;
    std::vector<AxialTree> images;  // by symbol
};

/// The tree system whose trees the words of a D0L system describe, if its brackets match in every
/// successor and are not rewritten. Without brackets trees have one axis.
View<TreeSystem> as_tree_system(const D0L& system);

/// The tree after one step: all edges replaced at once. Where a lateral edge is replaced by a tree
/// without an axis of order 0, what went straight on after it becomes lateral. Linear in the result.
/// Throws BoundReached if that has more edges than the budget's letters.
///
/// Deriving and reading commute: canonical(next_tree(s, axial_tree(w))) is
/// canonical(axial_tree(h(w))) for the morphism h of the words.
AxialTree next_tree(const TreeSystem& system, const AxialTree& tree, const Budget& budget = {});

/// The tree after n steps from the axiom.
AxialTree derived_tree(const TreeSystem& system, std::uint64_t n, const Budget& budget = {});

/// What a monoid sees in one letter; there is exactly one way to lift it to words.
template <Monoid M, std::invocable<Symbol> Letter>
struct Lift {
    M monoid;
    Letter letter;
};
template <class M, class Letter>
Lift(M, Letter) -> Lift<M, Letter>;

/// The homomorphism that a lift extends to, on the accessible letters of a system.
template <Monoid M, class Letter>
Hom<M> homomorphism(const D0L& system, const Lift<M, Letter>& lift) {
    Hom<M> phi{lift.monoid,
               std::vector<typename M::value_type>(system.alphabet->size(), lift.monoid.one()),
               system.brackets};
    for (const Symbol a : system.letters) phi.images[a] = lift.letter(a);
    return phi;
}

//> fold
/// phi(h^n(axiom)), where phi extends `lift`: in n products for each letter written in the rules,
/// however long the word is.
///
/// phi . h^n is worked out from the left, phi . h . h ..., so a letter's image after k steps is a
/// product of images after k - 1 steps (the universal property of the free monoid; Rozenberg and
/// Salomaa 1980, I.1). Throws Error if M is Branching and a successor's brackets do not match,
/// and what budget.check throws.
///
/// Example: fold(d0l("b", {{'a', "ab"}, {'b', "a"}}), 300, length_lift()) == Integer("359579325206583560961765665172189099052367214309267232255589801")
template <Monoid M, class Letter>
typename M::value_type fold(const D0L& system, std::uint64_t n, const Lift<M, Letter>& lift,
                            const Budget& budget = {}) {
    Hom<M> phi = homomorphism(system, lift);
    while (n-- > 0) {
        budget.check();
        auto next = phi.after(system.rules, system.letters);
        if (next.images == phi.images) break;  // and so for ever
        phi = std::move(next);
    }
    return phi(system.axiom);
}
//< fold

/// Every phi . h^k for k = 0..n: row k sends a letter to the image of what it becomes in k steps.
/// Takes the space of n + 1 rows.
template <Monoid M, class Letter>
std::vector<Hom<M>> tower(const D0L& system, std::uint64_t n, const Lift<M, Letter>& lift,
                          const Budget& budget = {}) {
    std::vector<Hom<M>> rows{homomorphism(system, lift)};
    for (std::uint64_t k = 0; k < n; ++k) {
        budget.check();
        rows.push_back(rows.back().after(system.rules, system.letters));
    }
    return rows;
}

/// Every letter counts 1, brackets too: fold gives the length of the word.
///
/// Example: fold(d0l("F", {{'F', "F+F--F+F"}}), 3, length_lift()) == 148
inline auto length_lift() {
    return Lift{Sums{2}, [](Symbol) { return Integer(1); }};
}

/// The letter itself: fold gives the word.
inline auto word_lift() {
    return Lift{Words{}, [](Symbol a) { return Word{a}; }};
}

/// The letter's name: fold gives the word as text.
inline auto spelling_lift(const Alphabet& alphabet) {
    const Spellings spellings(alphabet);
    return Lift{spellings, [spellings](Symbol a) { return spellings.letter(a); }};
}

/// 1 for one letter, 0 for the others: fold counts its occurrences.
///
/// Example: fold(d0l("F", {{'F', "F+F--F+F"}}), 3, count_lift(0)) == std::vector<Integer>{64}
inline auto count_lift(Symbol counted) {
    // Brackets that are counted themselves count as letters, so they are plain here.
    return Lift{Vectors{1}, [counted](Symbol a) {
                    return std::vector<Integer>{Integer(a == counted ? 1 : 0)};
                }};
}

/// What a walk needs to know of a letter's future.
class Fates {
public:
    explicit Fates(const D0L& system);

    /// Whether the letter is its own successor.
    bool is_constant(Symbol a) const { return constant_[a] != 0; }
    /// Whether nothing is left of the letter after `steps` steps.
    bool is_gone(Symbol a, std::uint64_t steps) const {
        return steps >= gone_[a] && gone_[a] != never;
    }
    /// The least number of steps after which nothing is left of the letter: it is mortal
    /// (Rozenberg and Salomaa 1980, I.3); `never` if something always is.
    std::uint64_t lifetime(Symbol a) const { return gone_[a]; }
    static constexpr std::uint64_t never = lasts;

private:
    std::vector<char> constant_;
    std::vector<std::uint64_t> gone_;
};

/// Goes through the derivation of generation n from left to right. visit(a, steps) is called for
/// letters a that have `steps` steps still to go, each before what it becomes; it returns whether
/// to go into that. A constant is visited once, with 0 steps; letters of which nothing is left are
/// not visited. Letters with 0 steps are the word's own; for them the return value is ignored.
///
/// Memory: one position for each generation. Time: one call for each letter visited.
template <class Visit>
void walk(const D0L& system, const Fates& fates, std::uint64_t n, Visit&& visit) {
    struct Frame {
        const Symbol* next;
        const Symbol* end;
        std::uint64_t steps;  // that its letters have still to go
    };
    std::vector<Frame> path;
    path.push_back({system.axiom.data(), system.axiom.data() + system.axiom.size(), n});
    while (!path.empty()) {
        Frame& here = path.back();
        if (here.next == here.end) {
            path.pop_back();
            continue;
        }
        const Symbol a = *here.next++;
        const std::uint64_t steps = here.steps;
        if (steps == 0 || fates.is_constant(a)) {
            visit(a, std::uint64_t{0});
            continue;
        }
        if (fates.is_gone(a, steps) || !visit(a, steps)) continue;
        const Word& successor = system.successor(a);
        while (here.next != here.end && fates.is_gone(*here.next, steps)) ++here.next;
        if (here.next == here.end) path.pop_back();  // a last letter leaves nothing to come back to
        path.push_back({successor.data(), successor.data() + successor.size(), steps - 1});
    }
}

/// Where text goes piece by piece. The bytes of a piece stay valid until `flush` returns, so a
/// sink may keep the view and write many pieces at once.
class TextSink {
public:
    virtual ~TextSink() = default;
    virtual void write(std::string_view piece) = 0;
    virtual void flush() = 0;
};

/// Sends the word of generation n to `sink` as text, names as `spell` writes them, nothing for the
/// empty word; says whether there was anything to send.
///
/// The words that letters become in k steps are spelled once, for the greatest k for which all of
/// them together fit about 1 MiB; the derivation is then walked depth first down to k steps to go,
/// and whole blocks are sent. So the rate does not depend on the grammar and memory does not
/// depend on the word. Throws what budget.check throws; does not check the number of letters.
///
/// Example: derived_text(d0l("b", {{'a', "ab"}, {'b', "a"}}), 5) == "abaababa"
bool derive_text(const D0L& system, std::uint64_t n, TextSink& sink, const Budget& budget = {});

/// The same as one string; for words that fit in memory.
std::string derived_text(const D0L& system, std::uint64_t n, const Budget& budget = {});

/// The word of generation n. Throws BoundReached if it has more than budget.letters letters.
///
/// Example: derive(d0l("F", {{'F', "FF"}}), 3).size() == 8
Word derive(const D0L& system, std::uint64_t n, const Budget& budget = {});

/// `count` letters of generation n from position `at` on, counted from 0; fewer if the word ends
/// before. The word is not written out: lengths say where to step down the derivation.
///
/// Time O(n * size of the rules) operations on numbers of the size of `at`, memory O(sqrt(n)) rows
/// of such numbers, then O(1) amortised a further letter of a propagating system. Lengths are only
/// worked out up to `at`, so neither n nor the length of the word need be small: position 10^100
/// of generation 10^6 is answered in seconds. Throws Error if the word has no letter at `at`.
///
/// Example: letters_at(d0l("b", {{'a', "ab"}, {'b', "a"}}), 500, power(Integer(10), 100), 1).size() == 1
Word letters_at(const D0L& system, std::uint64_t n, const Integer& at, std::uint64_t count,
                const Budget& budget = {});

/// The fold of an 0L system: a letter goes to the sum over its successors, so n generations cost n
/// products for each letter written in the rules, in a semiring.
template <Semiring S, class Letter>
typename S::value_type fold(const OL& system, std::uint64_t n, const Lift<S, Letter>& lift,
                            const Budget& budget = {}) {
    const S& semiring = lift.monoid;
    Hom<S> phi{semiring,
               std::vector<typename S::value_type>(system.alphabet->size(), semiring.one())};
    for (const Symbol a : system.letters) phi.images[a] = lift.letter(a);
    while (n-- > 0) {
        budget.check();
        Hom<S> composed = phi;
        for (const Symbol a : system.letters) {
            composed.images[a] = semiring.zero();
            for (const Word& successor : system.successors[a])
                semiring.add(composed.images[a], phi(successor));
        }
        phi = std::move(composed);
    }
    return phi(system.axiom);
}

/// All words of generation n, each once, in shortlex order of their names; with `longest`, only
/// those of at most so many letters (and then shorter words that come from longer ones are found
/// too, because words are built from what each letter becomes, not forward).
///
/// Throws BoundReached if the sets take more than budget.memory.
///
/// Example: words_of_generation(ol("aa", {{'a', ""}, {'a', "a"}}), 1).size() == 3
std::vector<Word> words_of_generation(const OL& system, std::uint64_t n,
                                      std::optional<std::size_t> longest = std::nullopt,
                                      const Budget& budget = {});

/// All words of the language with at most `longest` letters, in shortlex order. Complete, erasing
/// rules or not: what each letter becomes in k steps, cut at `longest`, is one of finitely many
/// families of finite sets, so the families repeat from some k on.
///
/// Example: words_up_to(ol("a", {{'a', "a"}, {'a', "aa"}}), 5).size() == 5
std::vector<Word> words_up_to(const OL& system, std::size_t longest, const Budget& budget = {});

/// What words of a system with interactions become in one step, where letters may have choices: the relation
/// of derivation. What rules, contexts and trees mean is said at IL.
class ContextStep {
public:
    explicit ContextStep(const IL& system);
    ~ContextStep();

    /// Of each letter of the word the successors that it may take, in the order of the rules; they live as long as this does.
    /// O(length of the word). Throws Error if the brackets of a tree do not match.
    std::vector<const std::vector<Word>*> successors(const Word& word);

    /// All words after one step, each once, in shortlex order by symbol numbers; with `longest` only those of at most so
    /// many letters. There may be exponentially many: throws BoundReached if they take more than budget.memory, and Error as
    /// `successors` does.
    ///
    /// Example: ContextStep(il("ab", {"a > b -> aa", "a > b -> b"})).next({0, 1}).size() == 2
    std::vector<Word> next(const Word& word, std::optional<std::size_t> longest = std::nullopt,
                           const Budget& budget = {});

    /// Whether the first word may become the second one in one step. O(product of both lengths).
    bool gives(const Word& from, const Word& to);

private:
    class Matcher;
    std::unique_ptr<Matcher> matcher_;
};

/// All words of generation n of a system with interactions, each once, in shortlex order of their names; with `longest`
/// only those of at most so many letters. Throws BoundReached if the sets take more than budget.memory.
///
/// Example: words_of_generation(il("ab", {"a > b -> aa", "a > b -> b"}), 1).size() == 2
std::vector<Word> words_of_generation(const IL& system, std::uint64_t n,
                                      std::optional<std::size_t> longest = std::nullopt,
                                      const Budget& budget = {});

/// All words of the language with at most `longest` letters, in shortlex order of their names. Complete where no rule is
/// erasing, as words do not get shorter then, and where the language is finite; otherwise longer words may have short
/// descendants, and no method finds all of them: throws BoundReached when the words seen take more than a part of the
/// budget's memory.
///
/// Example: words_up_to(il("ab", {"a > b -> aa", "a > b -> b"}), 3).size() == 5
std::vector<Word> words_up_to(const IL& system, std::size_t longest, const Budget& budget = {});

/// The generations of a deterministic system with interactions, one after the other, from the axiom on; what
/// rules, contexts and trees mean is said at IL. There is no fold here: what a letter becomes is no
/// function of the letter alone.
///
/// A step takes O(length of the word) whatever the contexts, by an automaton (ContextAutomaton).
/// Long words without trees over few letters are rewritten many letters at a time, as bit planes
/// where their length stays (CellPlanes), by a table of windows where it does not (WindowTable).
class Development {
public:
    /// Throws as step does, and Error if the system is not deterministic.
    explicit Development(const IL& system, const Budget& budget = {});
    ~Development();

    /// Goes to the next generation. Throws BoundReached if its word has more than budget.letters
    /// letters, and Error if the brackets of a tree do not match in the word of this one.
    void step();
    /// Takes n steps.
    void steps(std::uint64_t n);

    std::uint64_t generation() const { return generation_; }
    std::uint64_t length() const;
    const Word& word();

private:
    class Engines;
    std::uint64_t generation_ = 0;
    std::unique_ptr<Engines> engines_;
};

/// The word after one step of a deterministic system with interactions. Several steps are faster by Development.
/// Throws Error if brackets do not match, or if the system is not deterministic.
Word next_word(const IL& system, const Word& word);

/// The lengths of generations 0 to n, by deriving them. Throws as Development::step does.
std::vector<std::uint64_t> derived_lengths(const IL& system, std::uint64_t n,
                                           const Budget& budget = {});

/// The word of generation n, by deriving. Throws as Development::step does.
Word derive(const IL& system, std::uint64_t n, const Budget& budget = {});

}  // namespace algae
