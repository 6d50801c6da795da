#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "base/budget.hpp"
#include "exact/rational.hpp"
#include "rewrite/draws.hpp"
#include "rewrite/rule_set.hpp"
#include "system/lsystem.hpp"

namespace algae {

/// How a derivation goes where the system leaves a choice.
struct RewritingChoices {
    std::uint64_t seed = 1;
    bool evenly = false;   // rules with the same left side and no probabilities are equally likely
    bool random_tables = false;  // in place of the schedule of the system
    unsigned threads = 0;  // 0: as many as the machine has. The word does not depend on it
};

/// Derivation of parametric, stochastic and conditional systems, with and without contexts: any
/// LSystem but shape rules (Prusinkiewicz and Lindenmayer 1990, 1.7 to 1.10).
///
/// - A rule matches a module with the same letter and as many parameters, in its contexts (see IL),
///   with modules elsewhere that make its condition true (see Surroundings). A module that no rule
///   matches stays, with its parameters.
/// - Of the rules that match, those with the most modules in contexts and elsewhere come first, of
///   equally many the first in the file.
/// - Rules with the same contexts that match the same module are a choice. It is made by their
///   probabilities if these add up to 1 (see Draws), and is an Error otherwise.
/// - Parameters are doubles, computed as Program says; all are finite. What has no value, such as a
///   division by 0, is an Error. Errors name the rule, the module with its parameters, the
///   generation that is rewritten and the position in it.
class Rewriting {
public:
    /// Throws what `compiled_rules` throws.
    /// The budget is for the words of systems within it that the axiom needs.
    explicit Rewriting(const LSystem& system, const RewritingChoices& choices = {},
                       const Budget& budget = {});
    explicit Rewriting(CompiledRules rules) : rules_(std::move(rules)) {}

    const ModuleString& axiom() const { return rules_.axiom; }
    const CompiledRules& rules() const { return rules_; }

    /// The word after a step from the word of `generation`, by the rules of a table. Linear in both
    /// words where there are no modules elsewhere. Throws as said above, and BoundReached if the word
    /// has more than budget.letters modules or takes more than budget.memory.
    ModuleString next(const ModuleString& word, std::uint64_t generation, std::size_t table = 0,
                      const Budget& budget = {}) const;

    /// The table that a step from this generation picks at random, all equally likely.
    std::size_t random_table(std::uint64_t generation) const;
    /// The table of the step from this generation where nobody says which: the schedule's, a random
    /// one where there is none or the choices want it.
    std::size_t own_table(std::uint64_t generation) const;

    /// A successor and how likely it is, exactly; number 0 means that the module stays.
    struct Outcome {
        std::uint32_t successor;
        Rational probability;
        std::vector<double> parameters;  // for the successor's programs
    };
    /// By position, what may become of each module of the word. Throws as `next` does.
    std::vector<std::vector<Outcome>> outcomes(const ModuleString& word, std::uint64_t generation,
                                               std::size_t table = 0,
                                               const Budget& budget = {}) const;
    /// Writes the modules of an outcome behind a word. Throws as `next` does.
    void append(const Outcome& outcome, const ModuleString& from, std::size_t position,
                std::size_t offset, std::uint64_t generation, ModuleString& to) const;

private:
    /// The word of a generation: `name` is how messages call it.
    std::string name_of(std::uint64_t generation) const;
    [[noreturn]] void refuse(const std::string& what, const Production& rule, ModuleKind kind,
                             const double* values, std::size_t position,
                             std::uint64_t generation) const;
    [[noreturn]] void refuse_both(const Alternatives& first, const Alternatives& second,
                                  ModuleKind kind, const double* values, std::size_t position,
                                  std::uint64_t generation) const;
    const Alternatives* matching(const RuleSet& set, const class Surroundings& around,
                                 ModuleKind kind, std::size_t position, std::uint64_t generation,
                                 std::vector<double>& parameters,
                                 std::vector<double>& others) const;
    std::uint32_t pick(const Alternatives& alternatives, std::uint64_t number) const;
    void check_choice(const Alternatives& alternatives, ModuleKind kind, const double* values,
                      std::size_t position, std::uint64_t generation) const;
    ModuleString next_in_context(const RuleSet& set, const ModuleString& word,
                                 std::uint64_t generation, const Budget& budget) const;

    friend class FreeStep;

    CompiledRules rules_;
    RewritingChoices choices_;
};

/// The word of generation n: of a system with tables by those in `tables`, one for each step, or by
/// its own ones where there are none. Throws as Rewriting::next does.
///
/// Example: derive(Rewriting(read_lsystem("axiom A(1); A(x) -> A(x*2)A(x)", "")), 3).kinds.size() == 8
ModuleString derive(const Rewriting& rewriting, std::uint64_t n,
                    const std::vector<std::size_t>& tables = {}, const Budget& budget = {});

}  // namespace algae
