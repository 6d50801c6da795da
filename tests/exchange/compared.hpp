#pragma once
// What is compared of two systems: their words and what their turtles leave.

#include <cmath>
#include <string>
#include <vector>

#include "exact/exact.hpp"
#include "model/model.hpp"
#include "oracle/written_system.hpp"
#include "turtle/turtle.hpp"

namespace algae::exchange_tests {

/// What an attempt says when it fails, or "".
template <class Attempt>
std::string refusal(Attempt attempt) {
    try {
        attempt();
        return {};
    } catch (const Error& error) {
        return error.what();
    }
}

/// The names of the letters of generation n, a blank behind each.
inline std::string word_of(const Model& system, std::uint64_t n, std::uint64_t seed = 1) {
    FigureChoices choices;
    choices.seed = seed;
    const DerivedModules derived = derived_modules(system, n, choices);
    std::string out;
    for (const Symbol symbol : letters(derived.kinds, derived.word))
        out += system.alphabet.name(symbol) + ' ';
    return out;
}

inline bool near(double a, double b) { return std::fabs(a - b) <= 1e-9 * (1 + std::fabs(a)); }
inline bool near(const Vector& a, const Vector& b) {
    return near(a.x, b.x) && near(a.y, b.y) && near(a.z, b.z);
}

/// Whether strokes, polygons and solids are the same, one after the other, but for colours.
inline bool same_scene(const Scene& a, const Scene& b) {
    if (a.rods.size() != b.rods.size() || a.solids.size() != b.solids.size() ||
        a.faces.size() != b.faces.size() || a.corners.size() != b.corners.size())
        return false;
    for (std::size_t i = 0; i < a.rods.size(); ++i)
        if (!near(a.rods[i].from, b.rods[i].from) || !near(a.rods[i].to, b.rods[i].to) ||
            !near(a.rods[i].radius, b.rods[i].radius))
            return false;
    for (std::size_t i = 0; i < a.corners.size(); ++i)
        if (!near(a.corners[i], b.corners[i])) return false;
    for (std::size_t i = 0; i < a.solids.size(); ++i)
        if (a.solids[i].shape != b.solids[i].shape ||
            !near(a.solids[i].middle, b.solids[i].middle) ||
            !near(a.solids[i].size, b.solids[i].size))
            return false;
    return true;
}

inline SpaceDerivation scene_of(const Model& system, std::uint64_t n, std::uint64_t seed = 1) {
    FigureChoices choices;
    choices.seed = seed;
    return scene(system, n, {}, choices);
}

}  // namespace algae::exchange_tests
