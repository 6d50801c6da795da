#include "space/space_figure.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include "space/scene_builder.hpp"
#include "system/accessible.hpp"

namespace algae {

namespace {

bool turns_out(const LSystem& system, Symbol symbol) {
    const std::string& name = system.alphabet.name(symbol);
    return name == "&" || name == "^" || name == "\\" || name == "/" || name == "$";
}

/// The letters that words and what the turtle makes of them may have.
std::vector<Symbol> walked_letters(const LSystem& system) {
    std::map<Symbol, std::vector<const Production*>> rules;
    for (const auto* all : {&system.rules, &system.interpretation})
        for (const Production& rule : *all) rules[rule.predecessor.symbol].push_back(&rule);
    // A word that is a parameter or comes from a system within may have any letter.
    if (holds_words(system)) {
        std::vector<Symbol> every(system.alphabet.size());
        for (Symbol a = 0; a < every.size(); ++a) every[a] = a;
        return every;
    }
    return accessible(system.axiom.letters, system.alphabet.size(), [&](Symbol a, auto see) {
        const auto found = rules.find(a);
        if (found == rules.end()) return;
        for (const Production* rule : found->second) see(rule->successor.letters);
    });
}

}  // namespace

bool leaves_plane(const LSystem& system) {
    const std::vector<Symbol> letters = walked_letters(system);
    return std::any_of(letters.begin(), letters.end(),
                       [&](Symbol symbol) { return turns_out(system, symbol); });
}

SpaceDerivation scene(const LSystem& system, std::uint64_t n, const Budget& budget,
                      const FigureChoices& choices) {
    const DerivedModules derived = derived_modules(system, n, choices, budget);
    return scene(system, derived.kinds, derived.word, n, derived.seed, budget);
}

SpaceDerivation scene(const LSystem& system, const ModuleKinds& kinds, const ModuleString& word,
                      std::uint64_t n, std::uint64_t seed, const Budget& budget) {
    const ModuleTurtle turtle(system, kinds, n, seed);
    SceneBuilder builder(system.settings, turtle.name(), word.kinds.size(), budget);
    SpaceDerivation out;
    out.end = turtle.walk(word, builder, budget);
    out.scene = builder.finished();
    out.facts.segments = out.scene.rods.size();
    out.facts.length = total_length(out.scene);
    out.facts.box = box_of(out.scene);
    out.facts.step = std::fabs(turtle.start().step);
    return out;
}

}  // namespace algae
