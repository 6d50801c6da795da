#pragma once
// system: the L-system as written, its classes as checked views, and predicates on them.

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/place.hpp"
#include "system/environment_setting.hpp"
#include "system/expression.hpp"
#include "system/settings.hpp"
#include "word/alphabet.hpp"

namespace algae {

/// A word whose letters may carry parameters: `CB(1)A(x*2,x+y)`. Most words have none, so the
/// letters stand in one Word and only the positions that carry arguments are kept beside it. Where
/// `<w>` stands, the word comes that w gives: `[<w>]B(w)`.
struct ModuleWord {
    Word letters;
    std::map<std::size_t, std::vector<Expression>> arguments;  // by position in letters
    std::map<std::size_t, std::vector<Expression>> splices = {};  // by how many letters stand before

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

/// What a file says must come out: `expect length 3: 148`. The value is kept as written.
struct Expectation {
    std::string kind;         // length, word, segments, distinct, vertices, end, box, ...
    std::uint64_t generation = 0;
    std::string value;
    Place place;

    bool operator==(const Expectation& other) const {
        return kind == other.kind && generation == other.generation && value == other.value;
    }
};

struct InnerSystem;

/// The L-system as its file says it: every construct of the notation, none interpreted.
/// What a theorem needs is a view of it (system/d0l.hpp, system/ol.hpp, ...), or a reason why not.
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
    std::vector<std::string> tables;     // names of T0L tables; empty where there are none
    std::vector<std::size_t> schedule;   // `schedule`: tables of the steps, repeated; or empty
    std::vector<Symbol> ignored;         // `ignore`: skipped when contexts are matched
    std::vector<Symbol> terminals;       // `terminals`: E0L
    std::vector<Production> interpretation;  // `interpret L -> F`
    std::vector<EnvironmentSetting> environments;  // at most one for each module
    Settings settings;
    std::vector<Expectation> expectations;

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

}  // namespace algae
