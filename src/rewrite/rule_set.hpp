#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/budget.hpp"
#include "rewrite/module_string.hpp"
#include "rewrite/program.hpp"
#include "system/lsystem.hpp"

namespace algae {

/// A successor ready to be copied: the kinds of its modules, their parameters as far as they are
/// constant, and programs for the others.
struct Successor {
    struct Slot {
        std::uint32_t at;  // index into values
        Program value;
    };
    /// A word that is written in between.
    struct Splice {
        std::uint32_t at, values_at;  // how many kinds and values stand before
        Program word;
        const Expression* expression;
    };
    std::vector<ModuleKind> kinds;
    std::vector<double> values;
    std::vector<Slot> slots;
    std::vector<Splice> splices;
    const Production* rule = nullptr;

    /// Whether every module gets the same modules from the same parameters.
    bool same_as(const Successor& other) const;
};

/// Writes a successor's modules behind a word, with these parameters of its rule. `words` are those that
/// parameters stand for. Throws `Undefined`, also where a splice gives no word.
void append(const Successor& successor, const double* parameters, const WordValues* words,
            ModuleString& to);

/// Rules with the same left side: they apply to the same modules in the same places. One of them
/// is used, picked by its probability where they have some.
struct Alternatives {
    /// A conjunct of the condition, looked at as soon as so many modules elsewhere are found.
    struct Conjunct {
        std::size_t elsewhere;
        Program holds;
    };
    std::vector<ModuleKind> left, right, elsewhere;
    std::size_t context = 0;                // modules in all three; brackets do not count
    std::size_t parameters = 0;             // of the predecessor and all three
    std::optional<Program> condition;       // over the parameters of all
    std::vector<Conjunct> conjuncts;        // the condition where there are modules elsewhere
    std::vector<std::uint32_t> successors;  // numbers of successors
    std::vector<Rational> probabilities;    // as many, or none
    std::vector<std::uint64_t> thresholds;  // see Draws; as many as probabilities

    bool has_same_context(const Alternatives& other) const {
        return left == other.left && right == other.right && elsewhere == other.elsewhere;
    }
};

/// The rules of a system, or of one of its tables, compiled: by kind of predecessor, those with
/// the longest context first and equally long ones in the order of the file.
struct RuleSet {
    std::vector<std::vector<Alternatives>> of;  // by kind; none: the module stays as it is
    bool has_contexts = false;                  // some rule looks at other modules
    bool has_conditions = false;
    bool has_probabilities = false;
};

/// The whole of a system, compiled.
struct CompiledRules {
    std::shared_ptr<const LSystem> system;  // the expressions that programs point into
    ModuleKinds kinds;
    std::vector<Successor> successors;  // number 0 is no successor: the module stays
    std::vector<RuleSet> tables;        // one where the system has no tables
    std::vector<char> ignored;          // by kind
    std::vector<char> opens, closes;    // by kind: [ and ]
    std::vector<char> sought;           // by kind: some rule looks for it elsewhere
    ModuleString axiom;
    std::string of;  // of a system within another: " of leaf", for messages
    std::shared_ptr<InnerSystems> inner;  // where parameters may be words; one within does not own it
};

/// Compiles a system. Throws Error for shape rules, `Diagnostics` for constant expressions without
/// a value and, where words stand in the axiom, what InnerSystems::word throws. Of rules that are the same twice only the first is kept, unless they have
/// probabilities. With `seen`, the kinds of words that other rules make, these keep their numbers and
/// their words. O(size of the system).
CompiledRules compiled_rules(const LSystem& system, const Budget& budget = {},
                             const ModuleKinds* seen = nullptr);

}  // namespace algae
