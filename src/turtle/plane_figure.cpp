#include "turtle/plane_figure.hpp"

#include <cmath>
#include <limits>

#include "base/error.hpp"
#include "fold/lifts.hpp"
#include "turtle/lattice_motions.hpp"
#include "turtle/visited.hpp"

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

/// What a row of parts for each of so many steps takes, or the largest number.
std::uint64_t table_bytes(std::uint64_t steps, std::size_t letters) {
    const std::uint64_t row = letters * sizeof(Pieces::value_type) + sizeof(Hom<Pieces>);
    return steps >= UINT64_MAX / row - 1 ? UINT64_MAX : (steps + 1) * row;
}

constexpr double walked_letters = 3e7;  // words up to this long are measured letter by letter

}  // namespace

/// Takes every point that is drawn.
class PlaneFigure::Surveyor : public Canvas {
public:
    void move_to(Point point) override { from_ = point; }
    void line_to(Point point) override {
        ++lines;
        box.add(from_);
        box.add(point);
        from_ = point;
    }
    void polygon(std::span<const Point> corners) override {
        for (const Point corner : corners) box.add(corner);
    }
    void width(double) override {}
    void colour(std::uint32_t) override {}
    void position(double) override {}
    Box box;
    std::uint64_t lines = 0;

private:
    Point from_;
};

PlaneFigure::PlaneFigure(const LSystem& system, D0L rules, std::uint64_t steps,
                         std::uint64_t generation, const Budget& budget)
    : settings_(system.settings), rules_(std::move(rules)), steps_(steps),
      compass_(system.settings, generation), commands_(system, rules_.letters), fates_(rules_),
      pen_(pen_settings(system.settings, generation, system.name)) {
    const auto step = exact_or(settings_.step, 1), shrink = exact_or(settings_.shrink, 1);
    if (step && shrink && generation < 100'000) exact_unit_ = *step * power(*shrink, static_cast<long>(generation));
    pen_.letters = fold(rules_, steps_, length_lift(), budget).to_double();
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

namespace {

/// The product of a letter's commands, branches within it included. `value_of` gives the image of
/// one command other than push and pop.
template <Branching M, class ValueOf>
typename M::value_type product(const M& monoid, const std::vector<Command>& commands, ValueOf value_of) {
    std::vector<typename M::value_type> open{monoid.one()};
    for (const Command command : commands) {
        if (command == Command::push) {
            open.push_back(monoid.one());
        } else if (command == Command::pop && open.size() > 1) {
            const auto twig = monoid.branch(open.back());
            open.pop_back();
            monoid.append(open.back(), twig);
        } else {
            monoid.append(open.back(), value_of(command));
        }
    }
    return open.front();
}

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
        throw BoundReached(pen_.figure + " must be walked letter by letter and has more than " +
                           std::to_string(budget.letters) + " letters, the bound set by --max-letters");
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

std::vector<Hom<Pieces>> PlaneFigure::pieces(const Budget& budget) const {
    const Pieces monoid(compass_);
    budget.check_memory(table_bytes(steps_, rules_.alphabet->size()),
                        "the table of parts of the drawing");
    const auto value_of = [&](Command command) {
        Pieces::value_type value;
        switch (command) {
            case Command::draw:
            case Command::draw_unmarked:
                value.centre = 0.5;
                value.radius = 0.5;
                value.move = 1;
                break;
            case Command::move: value.move = 1; break;
            case Command::left: value.turn = compass_.normal(compass_.turn()); break;
            case Command::right: value.turn = compass_.normal(-compass_.turn()); break;
            case Command::back: value.turn = compass_.half(); break;
            case Command::scale: value.size = pen_.scale; break;
            case Command::narrow: value.width = pen_.narrow; break;
            case Command::next_colour: value.colours = 1; break;
            default: break;
        }
        return value;
    };
    const auto letter = [&](Symbol a) {
        auto value = product(monoid, commands_.of(a), value_of);
        value.letters = 1;
        return value;
    };
    return tower(rules_, steps_, Lift{monoid, letter}, budget);
}

void PlaneFigure::draw(Canvas& canvas, double resolution, const Budget& budget) const {
    if (resolution > 0 && is_foldable() && !has_polygons())
        draw_pieces(canvas, resolution, budget);
    else
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

Point PlaneFigure::draw_letters(Canvas& canvas, const Budget& budget) const {
    if (compass_.is_exact() && !commands_.uses(Command::scale))
        return walk_letters(rules_, fates_, steps_, commands_, Pen<LatticePosition>(canvas, compass_, pen_), budget);
    return walk_letters(rules_, fates_, steps_, commands_, Pen<FloatingPosition>(canvas, compass_, pen_), budget);
}

void PlaneFigure::draw_pieces(Canvas& canvas, double resolution, const Budget& budget) const {
    const auto rows = pieces(budget);
    Pen<FloatingPosition> pen(canvas, compass_, pen_);
    const double limit = resolution / std::abs(pen_.unit);
    // The same part at the same place in the same direction draws the same, if nothing else about
    // the pen can differ. Parts of some size are remembered; smaller ones cost less than looking.
    const bool plain = !canvas.wants_position() && !commands_.uses(Command::next_colour) &&
                       !commands_.uses(Command::narrow) && !commands_.uses(Command::scale);
    VisitedParts visited(resolution * 1e-3, budget);
    std::uint64_t visits = 0;
    walk(rules_, fates_, steps_, [&](Symbol a, std::uint64_t left) {
        if (++visits % 65536 == 0) budget.check();
        if (left == 0) {
            pen.letter(commands_.of(a));
            return true;
        }
        const auto& part = rows[left].images[a];
        const double extent = part.extent() * std::abs(pen.size());
        if (extent <= limit) {
            pen.jump(part, true);
            return false;
        }
        if (plain && extent > 4 * limit && extent <= 16 * limit &&
            !visited.insert(a, left, pen.heading(), pen.point())) {
            pen.jump(part, false);
            return false;
        }
        return true;
    });
    pen.finish();
}

std::unique_ptr<Figure> figure(const LSystem& system, std::uint64_t n, const Budget& budget) {
    const View<D0L> rules = as_d0l(system);
    if (!rules) throw Error("cannot draw " + system.name + ": " + rules.reason());
    return std::make_unique<PlaneFigure>(system, *rules, n, n, budget);
}

std::unique_ptr<Figure> figure(const LSystem& system, const Word& word, std::uint64_t n,
                               const Budget& budget) {
    std::vector<Word> images;
    for (Symbol a = 0; a < system.alphabet.size(); ++a) images.push_back(Word{a});
    D0L rules = make_d0l(std::make_shared<const Alphabet>(system.alphabet), word, std::move(images), system.name);
    return std::make_unique<PlaneFigure>(system, std::move(rules), 0, n, budget);
}

}  // namespace algae
