#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "rewrite/rewriting.hpp"

namespace algae {

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

    void add_outcomes();
    void cut();
    void each_part(const std::function<void(Part&, Room&)>& work);
    void choose(Part& part, Room& room);
    void look_closer(ModuleKind kind, const std::vector<Row>& rows, Room& room);
    bool look_at_all(ModuleKind kind, const std::vector<Row>& rows, Room& room);
    void look_at(ModuleKind kind, const Row& row);
    Number outcome_of(const Alternatives& alternatives, ModuleKind kind, const Row& row) const;
    void write(const Part& part, Room& room);
    void compute(const Outcome& outcome, const std::vector<Row>& rows, Room& room);
    void gather(const Program& program, const std::vector<Row>& rows, Room& room) const;

    const Rewriting& rewriting_;
    const CompiledRules& rules_;
    const RuleSet& set_;
    const ModuleString& word_;
    std::uint64_t generation_;
    const Budget& budget_;
    Draws draws_;
    bool random_ = false;  // some way has thresholds
    std::vector<Outcome> outcomes_;
    std::vector<ModuleKind> padded_;  // the letters of all outcomes, each with `near` to spare
    std::vector<Way> ways_;           // by kind
    std::vector<char> closer_;        // by kind: has conditions, or choices to be checked
    std::vector<Number> number_of_;   // by successor: its outcome
    std::vector<Part> parts_;
    std::vector<Number, Uncleared<Number>> chosen_;  // by position
    ModuleString out_;
};

}  // namespace algae
