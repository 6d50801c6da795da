#pragma once

#include <cstdint>
#include <vector>

#include "rewrite/outcome_table.hpp"
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
