#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "rewrite/rule_set.hpp"

namespace algae {

/// What modules of each kind may become by rules without contexts, ready to be copied, and how it is
/// found for a module.
struct OutcomeTable {
    /// What a module becomes: copied, or a successor.
    struct Outcome {
        std::uint32_t successor = 0;  // 0: the module itself
        std::uint32_t letters = 1, values = 0;
        std::uint32_t arity = 0;  // of the module that is rewritten
        const ModuleKind* kinds = nullptr;
    };
    using Number = std::uint16_t;            // of an outcome
    static constexpr std::size_t near = 16;  // successors as long as this are copied in one go

    /// How a kind of modules finds its outcome: by comparing a random number with up to three
    /// thresholds, or by looking closer.
    struct Way {
        std::array<std::uint64_t, 3> thresholds{};
        std::array<Number, 4> outcomes{};
    };

    /// Of one of the tables of these rules. Throws BoundReached for more than 65,535 rules and letters.
    OutcomeTable(const CompiledRules& rules, const RuleSet& set);
    OutcomeTable(const OutcomeTable&) = delete;
    OutcomeTable& operator=(const OutcomeTable&) = delete;

    std::vector<Outcome> outcomes;  // those of modules that stay first, by kind
    std::vector<Way> ways;          // by kind
    std::vector<char> closer;       // by kind: has conditions, or choices to be checked
    std::vector<Number> number_of;  // by successor: its outcome
    bool random = false;            // some way has thresholds
    bool any_closer = false;

private:
    void add(std::uint32_t successor, const ModuleKind* kinds, std::size_t size, std::size_t values,
             std::uint32_t arity);

    std::vector<ModuleKind> padded_;  // the letters of all outcomes, each with `near` to spare
};

}  // namespace algae
