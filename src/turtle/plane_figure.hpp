#pragma once

#include <memory>

#include "fold/walk.hpp"
#include "system/d0l.hpp"
#include "turtle/commands.hpp"
#include "turtle/compass.hpp"
#include "turtle/figure.hpp"
#include "turtle/pen.hpp"

namespace algae {

class Surveyor;

/// A generation of a D0L system in the plane. Facts come from folds where brackets and commands
/// allow it, otherwise from one walk; drawing is always a walk.
class PlaneFigure : public Figure {
public:
    /// `steps` of `rules` from its axiom, drawn as generation `generation` of `system`.
    PlaneFigure(const LSystem& system, D0L rules, std::uint64_t steps, std::uint64_t generation,
                const Budget& budget);

    const Box& box() const override { return box_; }
    const Integer& segments() const override { return facts_.segments; }
    const Facts& facts() const override { return facts_; }
    std::optional<std::uint64_t> strokes() const override;
    const Settings& settings() const override { return settings_; }
    void draw(Canvas& canvas, double resolution, const Budget& budget) const override;

private:
    /// Whether every letter leaves the stack as it found it, brackets apart: then folds apply.
    bool is_foldable() const;
    bool is_lattice() const;
    bool has_polygons() const;
    void count_segments(const Budget& budget);
    void measure_by_folding(const Budget& budget);
    void measure_by_walking(const Budget& budget);
    std::vector<Hom<Pieces>> pieces(const Budget& budget) const;
    void survey_pieces(Surveyor& surveyor, const std::vector<Hom<Pieces>>& rows, const Budget& budget) const;
    Point draw_letters(Canvas& canvas, const Budget& budget) const;
    void draw_pieces(Canvas& canvas, double resolution, const Budget& budget) const;

    Settings settings_;
    D0L rules_;
    std::uint64_t steps_;
    Compass compass_;
    Commands commands_;
    Fates fates_;
    PenSettings pen_;
    std::optional<Rational> exact_unit_;
    Facts facts_;
    Box box_;
};

}  // namespace algae
