#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "rewrite/rewrite.hpp"

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

/// One step where no rule looks at other modules: the word is cut into parts, which are rewritten by
/// several threads. First all parts choose rules and count what comes of it, then all write their
/// successors where they belong. Within a part programs run over all modules with the same rule at
/// once, so an instruction is looked at once for many modules.
class FreeStep {
public:
    FreeStep(const Rewriting& rewriting, const RuleSet& set, const ModuleString& word,
             std::uint64_t generation, const Budget& budget);

    /// The next word. Throws as Rewriting::next does.
    ModuleString next();

private:
    static constexpr std::size_t part_size = 2048;

    struct Part {
        std::size_t begin, end;  // positions in the word
        std::uint64_t values;    // where its parameters begin
        std::uint64_t letters_out = 0,
                      values_out = 0;  // how many come of it, then where they begin
    };
    /// A module that programs run for.
    struct Row {
        std::size_t position;
        std::uint64_t values, out;  // where its parameters begin, and those of its successor
    };
    struct Room;

    void cut();
    void all(void (FreeStep::*work)(Part&, Room&));
    void choose(Part& part, Room& room);
    void look_closer(ModuleKind kind, const std::vector<Row>& rows, Room& room);
    bool look_at_all(ModuleKind kind, const std::vector<Row>& rows, Room& room);
    void look_at(ModuleKind kind, const Row& row);
    OutcomeTable::Number outcome_of(const Alternatives& alternatives, ModuleKind kind,
                                    const Row& row) const;
    void write(Part& part, Room& room);
    void compute(const OutcomeTable::Outcome& outcome, const std::vector<Row>& rows, Room& room);
    void gather(const Program& program, const std::vector<Row>& rows, Room& room) const;

    const Rewriting& rewriting_;
    const CompiledRules& rules_;
    const RuleSet& set_;
    const ModuleString& word_;
    std::uint64_t generation_;
    const Budget& budget_;
    Draws draws_;
    OutcomeTable table_;
    std::vector<Part> parts_;
    std::vector<OutcomeTable::Number, Uncleared<OutcomeTable::Number>> chosen_;  // by position
    ModuleString out_;
};

}  // namespace algae
