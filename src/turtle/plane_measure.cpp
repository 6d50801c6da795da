#include <cmath>

#include "base/error.hpp"
#include "fold/lifts.hpp"
#include "turtle/command_product.hpp"
#include "turtle/lattice_motions.hpp"
#include "turtle/plane_figure.hpp"
#include "turtle/surveyor.hpp"

namespace algae {

namespace {

constexpr double walked_letters = 3e7;  // words up to this long are measured letter by letter

bool draws(Command command) { return command == Command::draw || command == Command::draw_unmarked; }

}  // namespace

void PlaneFigure::count_segments(const Budget& budget) {
    // Even where brackets cannot be folded, segments can: they do not care where they are drawn.
    // Only where branches are cut this counts too much; then the walk counts what it draws.
    const auto count = [&](Symbol a) {
        long drawn = 0;
        for (const Command command : commands_.of(a)) drawn += draws(command) ? 1 : 0;
        return std::vector<Integer>{Integer(drawn)};
    };
    facts_.segments = fold(rules_, steps_, Lift{Vectors{1}, count}, budget).front();
}

void PlaneFigure::measure_by_folding(const Budget& budget) {
    const LatticeMotions motions(compass_.order());
    const auto value_of = [&](Command command) {
        switch (command) {
            case Command::draw:
            case Command::draw_unmarked: return motions.step(true);
            case Command::move: return motions.step(false);
            case Command::left: return motions.turned(compass_.turn());
            case Command::right: return motions.turned(-compass_.turn());
            case Command::back: return motions.turned(compass_.half());
            default: return motions.one();
        }
    };
    const auto letter = [&](Symbol a) { return product(motions, commands_.of(a), value_of); };
    auto motion = motions.turned(compass_.start());
    motions.append(motion, fold(rules_, steps_, Lift{motions, letter}, budget));

    // Directions are exact; the unit and the start may be doubles all the same.
    facts_.exact = exact_unit_ && (!settings_.start || (settings_.start->x.exact && settings_.start->y.exact));
    const CyclotomicRing& ring = motions.ring();
    const auto coordinate = [&](const CyclotomicInteger& number, Coordinate::Part part, const Rational& factor,
                                bool vertical) {
        if (facts_.exact) {
            const Rational offset =
                !settings_.start ? Rational(0) : vertical ? *settings_.start->y.exact : *settings_.start->x.exact;
            return Coordinate(ring, number, part, *exact_unit_ * factor, offset);
        }
        const auto point = ring.to_complex(number);
        return Coordinate((vertical ? pen_.start.y : pen_.start.x) +
                          pen_.unit * factor.to_double() * (part == Coordinate::Part::real ? point.real() : point.imag()));
    };
    facts_.end = {coordinate(motion.move, Coordinate::Part::real, 1, false),
                  coordinate(motion.move, Coordinate::Part::imaginary, 1, true)};
    if (motion.reach.empty()) return;
    // Reach is twice the real part towards a direction: +x, +y, -x, -y are quarters of the order.
    // A negative unit turns the drawing round.
    const int around = pen_.unit < 0 ? 2 : 0;
    const auto side = [&](int quarter, long sign) {
        const auto direction = static_cast<std::size_t>(compass_.order() / 4 * ((quarter + around) % 4));
        return coordinate(motion.reach[direction], Coordinate::Part::real, Rational(around ? -sign : sign, 2),
                          quarter % 2 == 1);
    };
    facts_.high = {side(0, 1), side(1, 1)};
    facts_.low = {side(2, -1), side(3, -1)};
    box_.add(Point{facts_.low[0].value(), facts_.low[1].value()});
    box_.add(Point{facts_.high[0].value(), facts_.high[1].value()});
}

void PlaneFigure::measure_by_walking(const Budget& budget) {
    Surveyor surveyor;
    if (is_foldable() && !has_polygons() && pen_.letters > walked_letters) {
        const auto rows = pieces(budget);
        const Pieces::value_type whole = rows.back()(rules_.axiom);
        const auto end = compass_.direction(compass_.start()) * whole.move;
        facts_.end = {Coordinate(pen_.start.x + pen_.unit * end.real()),
                      Coordinate(pen_.start.y + pen_.unit * end.imag())};
        survey_pieces(surveyor, rows, budget);
    } else if (pen_.letters > static_cast<double>(budget.letters)) {
        throw BoundReached(Bound::letters,
                           pen_.figure + " must be walked letter by letter and has more than " +
                               std::to_string(budget.letters) + " letters, the bound set" +
                               budget.by(Bound::letters));
    } else {
        const Point end = draw_letters(surveyor, budget);
        facts_.end = {Coordinate(end.x), Coordinate(end.y)};
        if (commands_.uses(Command::cut)) facts_.segments = surveyor.lines;
    }
    box_ = surveyor.box;
    if (box_.empty) return;
    facts_.low = {Coordinate(box_.low.x), Coordinate(box_.low.y)};
    facts_.high = {Coordinate(box_.high.x), Coordinate(box_.high.y)};
}

void PlaneFigure::survey_pieces(Surveyor& surveyor, const std::vector<Hom<Pieces>>& rows,
                                const Budget& budget) const {
    // A part that cannot stick out of the box known so far is not looked into, and neither is one
    // that sticks out so little that it cannot be told from the right one: a box that is wrong by
    // less than a thousandth of the line width.
    Pen<FloatingPosition> pen(surveyor, compass_, pen_);
    const double tolerance = std::abs(pen_.unit) * rows.back()(rules_.axiom).reach() * 1e-5;
    std::uint64_t visits = 0;
    walk(rules_, fates_, steps_, [&](Symbol a, std::uint64_t left) {
        if (++visits % 65536 == 0) budget.check();
        if (left == 0) {
            pen.letter(commands_.of(a));
            return true;
        }
        const auto& part = rows[left].images[a];
        const double size = pen_.unit * pen.size();
        const auto centre = size * compass_.direction(pen.heading()) * part.centre;
        const double radius = std::abs(size) * part.radius - tolerance;
        const Point at = pen.point();
        const Box& box = surveyor.box;
        const bool inside = !box.empty && at.x + centre.real() - radius >= box.low.x &&
            at.x + centre.real() + radius <= box.high.x && at.y + centre.imag() - radius >= box.low.y &&
            at.y + centre.imag() + radius <= box.high.y;
        if (part.draws() && !inside) return true;
        pen.jump(part, false);
        return false;
    });
    pen.finish();
}

}  // namespace algae
