#include "space/space_figure.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>

#include "environment/open_modules.hpp"
#include "shape/boxes.hpp"
#include "space/box_scene.hpp"
#include "space/scene_builder.hpp"
#include "system/accessible.hpp"
#include "system/classes.hpp"
#include "turtle/segment_set.hpp"
#include "turtle/surface.hpp"

namespace algae {

namespace {

/// Whether the turtle leaves the plane for a symbol that interpretations leave alone.
bool leaves_plane(const LSystem& system, Symbol symbol) {
    const Settings& settings = system.settings;
    for (const SolidSetting& solid : settings.solids)
        if (solid.symbol == symbol) return true;
    for (const SurfaceSetting& surface : settings.surfaces)
        if (surface.symbol == symbol) return !is_flat(surface);
    const std::string& name = system.alphabet.name(symbol);
    return name == "&" || name == "^" || name == "\\" || name == "/" || name == "$";
}

/// Whether a symbol of `plot` is written with three coordinates.
bool plots_in_space(const LSystem& system) {
    const auto& plotters = system.settings.plotters;
    const auto plots = [&](const ModuleWord& word) {
        return std::any_of(word.arguments.begin(), word.arguments.end(), [&](const auto& module) {
            const Symbol symbol = word.letters[module.first];
            return module.second.size() == 3 &&
                   std::count(plotters.begin(), plotters.end(), symbol) > 0;
        });
    };
    if (plotters.empty()) return false;
    if (plots(system.axiom)) return true;
    for (const auto* all : {&system.rules, &system.interpretation})
        for (const Production& rule : *all)
            if (plots(rule.successor)) return true;
    return false;
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
    if (system.settings.tropism && system.settings.tropism->z.value != 0) return true;
    if (plots_in_space(system) || class_of(system).shape) return true;
    const std::vector<Symbol> letters = walked_letters(system);
    return std::any_of(letters.begin(), letters.end(),
                       [&](Symbol symbol) { return leaves_plane(system, symbol); });
}

SpaceDerivation scene(const LSystem& system, std::uint64_t n, const Budget& budget,
                      const FigureChoices& choices, std::shared_ptr<Environment> external) {
    if (class_of(system).shape) {
        const View<ShapeSystem> shapes = as_shape(system);
        SpaceDerivation out;
        out.scene = box_scene(system, boxes_after(*shapes, shapes->axiom, n, budget));
        out.scene.name = figure_name(system, n);
        out.facts.box = box_of(out.scene);
        return out;
    }
    const DerivedModules derived = open_modules(system, n, choices, std::move(external), budget);
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
    for (const Rod& rod : out.scene.rods)
        if (const double size = length(rod.to - rod.from); size > 0)
            out.facts.step = std::min(out.facts.step, size);
    // Rounding over a long walk is far less than a millionth of this.
    out.facts.step = std::max(out.facts.step, out.facts.box.diagonal() * 1e-5);
    return out;
}

Trace trace(const SpaceDerivation& derivation, const Budget& budget) {
    SegmentSet segments(derivation.facts.step * 1e-6, budget);
    for (const Rod& rod : derivation.scene.rods) {
        const std::uint32_t from = segments.number(rod.from);
        segments.add(from, segments.number(rod.to));
    }
    return segments.result();
}

}  // namespace algae
