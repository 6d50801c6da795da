#include "turtle/plane_figure.hpp"

#include <cmath>
#include <numeric>

#include "base/error.hpp"
#include "fold/lifts.hpp"
#include "turtle/lattice_blocks.hpp"

namespace algae {

namespace {

double value_or(const std::optional<Quantity>& setting, double otherwise) {
    return setting ? setting->value : otherwise;
}

std::optional<Rational> exact_or(const std::optional<Quantity>& setting, long otherwise) {
    return setting ? setting->exact : Rational(otherwise);
}

PenSettings pen_settings(const Settings& settings, std::uint64_t generation, const std::string& name) {
    PenSettings pen;
    if (settings.start) pen.start = {settings.start->x.value, settings.start->y.value};
    pen.unit = value_or(settings.step, 1) *
               std::pow(value_or(settings.shrink, 1), static_cast<double>(generation));
    pen.scale = value_or(settings.scale, 1);
    pen.narrow = value_or(settings.narrow, 1);
    pen.figure = "generation " + std::to_string(generation) + (name.empty() ? "" : " of " + name);
    if (!std::isfinite(pen.unit) || pen.unit == 0)
        throw Error(pen.figure + ": the step of the turtle is " + std::to_string(pen.unit) +
                    ", expected a length that a drawing can have; see step and shrink");
    return pen;
}

/// How many letters the word has; throws BoundReached, soon, if no drawing could hold them.
double letters_for_drawing(const D0L& rules, std::uint64_t steps, const std::string& figure, const Budget& budget) {
    std::vector<double> counts(rules.alphabet->size(), 0);
    for (const Symbol a : rules.axiom) counts[a] += 1;
    double sum = static_cast<double>(rules.axiom.size());
    for (; steps > 0; --steps) {
        budget.check();
        std::vector<double> next(counts.size(), 0);
        for (const Symbol a : rules.letters)
            if (counts[a] > 0)
                for (const Symbol b : rules.successor(a)) next[b] += counts[a];
        if (next == counts) break;  // and so for ever
        counts = std::move(next);
        sum = std::accumulate(counts.begin(), counts.end(), 0.0);
        if (!std::isfinite(sum))
            throw BoundReached(Bound::method,
                               figure + " has more than 10^308 letters: no drawing can hold them");
    }
    return sum;
}

}  // namespace

PlaneFigure::PlaneFigure(const LSystem& system, D0L rules, std::uint64_t steps,
                         std::uint64_t generation, const Budget& budget)
    : settings_(system.settings), rules_(std::move(rules)), steps_(steps),
      compass_(system.settings, generation), commands_(system, rules_.letters), fates_(rules_),
      pen_(pen_settings(system.settings, generation, system.name)) {
    const auto step = exact_or(settings_.step, 1), shrink = exact_or(settings_.shrink, 1);
    if (step && shrink && generation < 100'000) exact_unit_ = *step * power(*shrink, static_cast<long>(generation));
    pen_.letters = letters_for_drawing(rules_, steps_, pen_.figure, budget);
    facts_.step = std::abs(pen_.unit);
    count_segments(budget);
    if (is_lattice()) {
        measure_by_folding(budget);
    } else {
        measure_by_walking(budget);
    }
}

bool PlaneFigure::is_foldable() const {
    if (commands_.uses(Command::cut)) return false;
    const auto& brackets = rules_.rules.brackets;
    bool pushes = false;
    for (const Symbol a : rules_.letters) {
        const auto& commands = commands_.of(a);
        if (brackets && (a == brackets->open || a == brackets->close)) {
            // An interpretation may make something else of them.
            if (commands != std::vector{a == brackets->open ? Command::push : Command::pop}) return false;
            continue;
        }
        std::size_t depth = 0;
        for (const Command command : commands) {
            if (command == Command::push) ++depth;
            if (command == Command::pop && depth-- == 0) return false;
            pushes = pushes || command == Command::push || command == Command::pop;
        }
        if (depth != 0) return false;
    }
    return brackets || !pushes || !brackets_of(*rules_.alphabet);
}

bool PlaneFigure::is_lattice() const {
    return is_foldable() && compass_.is_exact() && !commands_.uses(Command::scale) &&
           !has_polygons();
}

bool PlaneFigure::has_polygons() const {
    return commands_.uses(Command::open_polygon) || commands_.uses(Command::close_polygon);
}

std::optional<std::uint64_t> PlaneFigure::strokes() const {
    if (has_polygons() || !facts_.segments.fits_uint64()) return std::nullopt;
    return facts_.segments.to_uint64();
}

void PlaneFigure::draw(Canvas& canvas, double resolution, const Budget& budget) const {
    if (resolution > 0 && is_foldable() && !has_polygons())
        draw_pieces(canvas, resolution, budget);
    else if (!is_foldable() ||
             !draw_lattice_blocks(rules_, fates_, steps_, commands_, compass_, pen_, canvas, budget))
        draw_letters(canvas, budget);
}

namespace {

template <class Position>
Point walk_letters(const D0L& rules, const Fates& fates, std::uint64_t steps, const Commands& commands,
                   Pen<Position> pen, const Budget& budget) {
    std::uint64_t letters = 0;
    walk(rules, fates, steps, [&](Symbol a, std::uint64_t left) {
        if (left > 0) return true;
        pen.letter(commands.of(a));
        if (++letters % 65536 == 0) budget.check();
        return true;
    });
    pen.finish();
    return pen.point();
}

}  // namespace

Point PlaneFigure::draw_letters(Canvas& canvas, const Budget& budget) const {
    if (compass_.is_exact() && !commands_.uses(Command::scale))
        return walk_letters(rules_, fates_, steps_, commands_, Pen<LatticePosition>(canvas, compass_, pen_), budget);
    return walk_letters(rules_, fates_, steps_, commands_, Pen<FloatingPosition>(canvas, compass_, pen_), budget);
}

}  // namespace algae
