#pragma once

#include "turtle/figure.hpp"
#include "turtle/module_turtle.hpp"

namespace algae {

/// A word of modules in the plane. It keeps the word and walks it whenever it is drawn; coordinates
/// are doubles.
class ModuleFigure : public Figure {
public:
    /// Walks the word once. Throws Error if a symbol or a tropism leaves the plane, and as
    /// ModuleTurtle does. `seed` is for interpretations with probabilities.
    ModuleFigure(const LSystem& system, const ModuleKinds& kinds, ModuleString word,
                 std::uint64_t generation, std::uint64_t seed, const Budget& budget);

    const Box& box() const override { return box_; }
    const Integer& segments() const override { return facts_.segments; }
    const Facts& facts() const override { return facts_; }
    std::optional<std::uint64_t> strokes() const override { return strokes_; }
    const Settings& settings() const override { return settings_; }
    /// Draws every stroke, whatever the resolution.
    void draw(Canvas& canvas, double resolution, const Budget& budget) const override;

private:
    Settings settings_;
    ModuleTurtle turtle_;
    ModuleString word_;
    Facts facts_;
    Box box_;
    std::uint64_t strokes_ = 0;
};

}  // namespace algae
