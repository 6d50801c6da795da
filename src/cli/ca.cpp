#include "base/error.hpp"
#include "cli/output.hpp"
#include "cli/relatives.hpp"
#include "nature/cellular_automaton.hpp"

namespace algae::cli {

namespace {

int run(const RelativeOptions& options) {
    if (!options.text) return run_relative(options);
    if (!options.output.empty() || options.json)
        throw Error("--text: expected no picture and no --json beside it");
    const Budget budget = options.bounds.budget();
    const auto relative = chosen_relative(options, budget);
    const auto& automaton = dynamic_cast<const CellularAutomaton&>(*relative);
    if (automaton.rule.dimensions == 1) {
        print(grid_text(automaton.space_time(automaton.generations.front(),
                                             automaton.generations.back(), budget)));
        return success;
    }
    std::string text;
    for (const std::uint64_t n : automaton.generations)
        text += (text.empty() ? "" : "\n") + grid_text(automaton.generation(n, budget));
    print(text);
    return success;
}

}  // namespace

void add_ca(Verbs& verbs) {
    add_relative_verb(
        verbs, "ca", "Cellular automata: space-time pictures, or generations in the plane",
        "  algae ca --rule 30 --cells 101 -n 50 --text\n"
        "  algae ca rule-126 -o rule-126.svg",
        {{"--rule", "rule", "N", "the rule by its number, 0 to 255 for two states and radius 1"},
         {"--life", "life", "B3/S23", "a rule in the plane by numbers of neighbours"},
         {"--states", "states", "K", "of a cell (default 2)"},
         {"--radius", "radius", "R", "of the neighbourhood (default 1)"},
         {"--cells", "cells", "N", "on the line, or \"COLUMNS ROWS\" (default 101)"},
         {"--start", "start", "START",
          "single (a 1 in the middle, the default), random, or the states of the cells"},
         {"--boundary", "boundary", "B", "periodic (a ring, the default), or \"fixed STATE\""},
         {"--seed", "seed", "S", "of a random start (default 1)"},
         {"-n", "generation", "N[..M]",
          "the last generation, or the first and the last (default 50)"}},
        run, "print the states, a line for each generation");
}

}  // namespace algae::cli
