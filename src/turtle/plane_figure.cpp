#include "turtle/detail/plane_figure.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <unordered_set>

#include "model/model.hpp"
#include "turtle/detail/module_turtle.hpp"

// Figures in the plane: what a generation of a D0L system draws and measures, without its word.
//
// The word of a generation may be longer than any memory. Three ways around it:
//
// Measuring. On the lattice, facts are exact: a fold of LatticeMotions over the rules gives the end, the
// number of segments and the box in as many steps as there are generations. It needs brackets that every
// letter leaves as it found them (is_foldable), an exact compass, steps of one length and no polygons. Else
// the figure is walked once with a canvas that measures. Where that would be too long, the walk goes over
// parts: a part whose disc (see Pieces) lies in the box so far is not looked into.
//
// Drawing every stroke. A walk over the derivation keeps one path down to the letter at hand, and a Pen
// does the letter's commands. Positions are exact integers over a root of unity where the compass is exact
// (LatticePosition), else sums of doubles (FloatingPosition). lattice_blocks.cpp does the same faster.
//
// Drawing for a resolution. The tower of Pieces tells of every letter and number of steps what the part
// does to the turtle and the disc that its drawing lies in. A part within the resolution of the straight
// way from its start to its end becomes that stroke; a part that was drawn at the same place before, in
// the same direction, is left out (VisitedParts). Then the work depends on box and resolution.

namespace algae {

namespace {

using Value = Pieces::value_type;

/// Grows the disc of `left` to hold another one.
void enclose(Value& left, std::complex<double> centre, double radius) {
    if (radius < 0) return;
    if (left.radius < 0) {
        left.centre = centre;
        left.radius = radius;
        return;
    }
    const std::complex<double> way = centre - left.centre;
    const double distance = std::abs(way);
    if (distance + radius <= left.radius) return;
    if (distance + left.radius <= radius) {
        left.centre = centre;
        left.radius = radius;
        return;
    }
    const double grown = (distance + left.radius + radius) / 2;
    left.centre += way * ((grown - left.radius) / distance);
    left.radius = grown;
}

}  // namespace

void Pieces::append(Value& left, const Value& right) const {
    const std::complex<double> look = left.size * compass_->direction(left.turn);
    enclose(left, left.move + look * right.centre,
            right.radius < 0 ? right.radius : left.size * right.radius);
    left.move += look * right.move;
    left.turn = compass_->sum(left.turn, right.turn);
    left.size *= right.size;
    left.width *= right.width;
    left.colours += right.colours;
    left.letters += right.letters;
}

Value Pieces::branch(const Value& twig) const {
    Value value;
    value.centre = twig.centre;
    value.radius = twig.radius;
    value.letters = twig.letters + 2;
    return value;
}

namespace {

/// Where a turtle is: exact coordinates over a root of unity, as machine numbers. They stay below
/// the number of steps walked, so they cannot overflow in a walk that ends.
class LatticePosition {
public:
    explicit LatticePosition(const Compass& compass)
        : degree_(0), ring_(static_cast<long>(compass.order())) {
        degree_ = ring_.degree();
        here_.assign(degree_, 0);
        for (long k = 0; k < ring_.order(); ++k) powers_.push_back(ring_.power(k));
        for (std::size_t i = 0; i < degree_; ++i)
            basis_.push_back(compass.direction(static_cast<Compass::Heading>(i)));
    }

    void step(Compass::Heading heading, double) {
        const std::int64_t* unit = powers_[static_cast<std::size_t>(heading)].data();
        for (std::size_t i = 0; i < degree_; ++i) here_[i] += unit[i];
    }
    std::complex<double> point() const {
        double x = 0, y = 0;
        for (std::size_t i = 0; i < degree_; ++i) {
            x += static_cast<double>(here_[i]) * basis_[i].real();
            y += static_cast<double>(here_[i]) * basis_[i].imag();
        }
        return {x, y};
    }
    void push() { saved_.insert(saved_.end(), here_.begin(), here_.end()); }
    void pop() {
        std::copy(saved_.end() - static_cast<std::ptrdiff_t>(degree_), saved_.end(), here_.begin());
        saved_.resize(saved_.size() - degree_);
    }

private:
    std::size_t degree_;
    std::vector<std::span<const std::int64_t>> powers_;
    std::vector<std::complex<double>> basis_;
    CyclotomicRing ring_;
    std::vector<std::int64_t> here_, saved_;
};

/// Where a turtle is, in doubles.
class FloatingPosition {
public:
    explicit FloatingPosition(const Compass& compass) : compass_(&compass) {}

    void step(Compass::Heading heading, double size) {
        here_ += size * compass_->direction(heading);
    }
    void jump(Compass::Heading heading, double size, std::complex<double> move) {
        here_ += size * compass_->direction(heading) * move;
    }
    std::complex<double> point() const { return here_; }
    void push() { saved_.push_back(here_); }
    void pop() {
        here_ = saved_.back();
        saved_.pop_back();
    }

private:
    const Compass* compass_;
    std::complex<double> here_;
    std::vector<std::complex<double>> saved_;
};

/// A turtle with a canvas: does the commands of one letter after the other.
template <class Position>
class Pen {
public:
    Pen(Canvas& canvas, const Compass& compass, const PenSettings& settings)
        : canvas_(canvas), compass_(compass), settings_(settings), position_(compass) {
        state_.heading = compass.start();
    }

    /// Does what the letter says. Throws Error on an unmatched ']' or '}'.
    void letter(const std::vector<Command>& commands) {
        for (const Command command : commands) run(command);
        ++letters_;
    }

    /// Goes to the end of a part without drawing what is in it: a straight stroke there if it draws.
    void jump(const Pieces::value_type& part, bool stroke) {
        stroke = stroke && part.draws();
        if (stroke && !at_pen_) canvas_.move_to(point());
        position_.jump(state_.heading, state_.size, part.move);
        letters_ += part.letters;
        if (stroke) {
            tell_position();
            canvas_.line_to(point());
        }
        at_pen_ = stroke;
        State state = state_;
        state.heading = compass_.sum(state.heading, part.turn);
        state.size *= part.size;
        state.width *= part.width;
        state.colour += static_cast<std::uint32_t>(std::fmod(part.colours, 4294967296.0));
        restore(state);
    }

    /// Throws Error if a '[' or '{' is still open.
    void finish() const {
        if (!polygons_.empty() && !cut_) unmatched("'{' is never closed");
        if (!saved_.empty()) unmatched("'[' is never closed");
    }

    Point point() const {
        const std::complex<double> at = position_.point();
        return {settings_.start.x + settings_.unit * at.real(),
                settings_.start.y + settings_.unit * at.imag()};
    }
    Compass::Heading heading() const { return state_.heading; }
    double size() const { return state_.size; }

private:
    struct State {
        Compass::Heading heading = 0;
        double size = 1;
        double width = 1;
        std::uint32_t colour = 0;
        std::size_t polygons = 0;  // open when a branch began
    };

    void run(Command command) {
        if (cut_ && command != Command::push && command != Command::pop) return;
        switch (command) {
            case Command::draw:
                line();
                if (!polygons_.empty()) corner();
                break;
            case Command::draw_unmarked:
                line();
                break;
            case Command::move:
                position_.step(state_.heading, state_.size);
                at_pen_ = false;
                if (!polygons_.empty()) corner();
                break;
            case Command::left:
            case Command::right:
            case Command::back:
                state_.heading = compass_.sum(state_.heading, compass_.turn_of(command));
                break;
            case Command::push:
                if (cut_) {
                    ++cut_depth_;
                    break;
                }
                saved_.push_back(state_);
                saved_.back().polygons = polygons_.size();
                position_.push();
                break;
            case Command::pop:
                if (cut_ && cut_depth_ > 0) {
                    --cut_depth_;
                    break;
                }
                if (saved_.empty()) unmatched("unmatched ']'");
                if (cut_) polygons_.resize(std::min(polygons_.size(), saved_.back().polygons));
                cut_ = false;
                restore(saved_.back());
                saved_.pop_back();
                position_.pop();
                at_pen_ = false;
                break;
            case Command::open_polygon:
                polygons_.emplace_back();
                corner();
                break;
            case Command::close_polygon:
                if (polygons_.empty()) unmatched("unmatched '}'");
                tell_position();
                if (polygons_.back().size() > 2) canvas_.polygon(polygons_.back());
                polygons_.pop_back();
                at_pen_ = false;
                break;
            case Command::vertex:
                if (!polygons_.empty()) corner();
                break;
            case Command::scale:
                state_.size *= settings_.scale;
                break;
            case Command::narrow:
                canvas_.width(state_.width *= settings_.narrow);
                break;
            case Command::next_colour:
                canvas_.colour(++state_.colour);
                break;
            case Command::cut:
                cut_ = true;
                cut_depth_ = 0;
                break;
        }
    }

    void line() {
        if (!at_pen_) canvas_.move_to(point());
        position_.step(state_.heading, state_.size);
        tell_position();
        canvas_.line_to(point());
        at_pen_ = true;
    }

    void corner() { polygons_.back().push_back(point()); }

    void restore(const State& state) {
        if (state.width != state_.width) canvas_.width(state.width);
        if (state.colour != state_.colour) canvas_.colour(state.colour);
        state_ = state;
    }

    void tell_position() {
        if (canvas_.wants_position()) canvas_.position(letters_ / settings_.letters);
    }

    [[noreturn]] void unmatched(const char* what) const {
        std::string place = settings_.figure;
        if (what[0] == 'u')
            place += ", position " + std::to_string(static_cast<std::uint64_t>(letters_));
        throw Error(place + ": " + what);
    }

    Canvas& canvas_;
    const Compass& compass_;
    const PenSettings& settings_;
    Position position_;
    State state_;
    std::vector<State> saved_;
    std::vector<std::vector<Point>> polygons_;  // open ones, the innermost last
    double letters_ = 0;
    bool at_pen_ = false;  // whether the canvas' pen stands where the turtle is
    bool cut_ = false;
    std::size_t cut_depth_ = 0;
};

/// Which parts of a derivation were drawn where: letter, steps to go, heading, and the place on a
/// grid. Forgets nothing, but stops remembering when the budget's memory is used up; then parts
/// are drawn again, which costs time and changes nothing.
class VisitedParts {
public:
    VisitedParts(double grid, const Budget& budget) : grid_(grid), most_(budget.memory / 128) {}

    /// Notes the part; false if it was noted before.
    bool insert(Symbol letter, std::uint64_t steps, Compass::Heading heading, Point place) {
        const Key key{letter, steps, heading, std::llround(place.x / grid_),
                      std::llround(place.y / grid_)};
        if (parts_.size() >= most_) return !parts_.contains(key);
        return parts_.insert(key).second;
    }

private:
    struct Key {
        Symbol letter;
        std::uint64_t steps;
        Compass::Heading heading;
        long long x, y;
        bool operator==(const Key&) const = default;
    };
    struct Hash {
        std::size_t operator()(const Key& key) const {
            std::uint64_t hash = key.letter;
            for (const std::uint64_t part :
                 {key.steps, static_cast<std::uint64_t>(key.heading),
                  static_cast<std::uint64_t>(key.x), static_cast<std::uint64_t>(key.y)}) {
                hash = (hash ^ part) * 0x9E3779B97F4A7C15u;
                hash ^= hash >> 29;
            }
            return hash;
        }
    };
    double grid_;
    std::size_t most_;
    std::unordered_set<Key, Hash> parts_;
};

std::optional<Rational> exact_or(const std::optional<Quantity>& setting, long otherwise) {
    return setting ? setting->exact : Rational(otherwise);
}

PenSettings pen_settings(const Model& system, std::uint64_t generation) {
    const Drawing& drawing = system.drawing;
    PenSettings pen;
    if (drawing.start) pen.start = {drawing.start->x.value, drawing.start->y.value};
    pen.figure = figure_name(system, generation);
    pen.unit = step_length(drawing, generation, pen.figure);
    if (drawing.scale) pen.scale = drawing.scale->value;
    if (drawing.narrow) pen.narrow = drawing.narrow->value;
    return pen;
}

/// How many letters the word has; throws BoundReached, soon, if no drawing could hold them.
double letters_for_drawing(const D0L& rules, std::uint64_t steps, const std::string& figure,
                           const Budget& budget) {
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

// Words longer than the first are measured by their parts, as far as doubles tell them apart, and those longer than the second
// to a share of the reach that no picture shows.
constexpr double walked_letters = 3e5, finely_measured_letters = 3e7;
constexpr double fine_share = 1e-12, coarse_share = 1e-5;

bool draws(Command command) {
    return command == Command::draw || command == Command::draw_unmarked;
}

/// What a row of parts for each of so many steps takes, or the largest number.
std::uint64_t table_bytes(std::uint64_t steps, std::size_t letters) {
    const std::uint64_t row = letters * sizeof(Pieces::value_type) + sizeof(Hom<Pieces>);
    return steps >= UINT64_MAX / row - 1 ? UINT64_MAX : (steps + 1) * row;
}

template <class Position>
Point walk_letters(const D0L& rules, const Fates& fates, std::uint64_t steps,
                   const Commands& commands, Pen<Position> pen, const Budget& budget) {
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

/// A generation of a D0L system in the plane. Facts come from folds where brackets and commands
/// allow it, otherwise from one walk; drawing is always a walk.
class PlaneFigure : public Figure {
public:
    /// `steps` of `rules` from its axiom, drawn as generation `generation` of `system`.
    PlaneFigure(const Model& system, D0L rules, std::uint64_t steps, std::uint64_t generation,
                const Budget& budget, const std::string& rounded)
        : style_(style_of(system.drawing)),
          start_(system.drawing.start),
          rules_(std::move(rules)),
          steps_(steps),
          compass_(system.drawing, generation),
          commands_(system, rules_.letters),
          fates_(rules_),
          pen_(pen_settings(system, generation)) {
        const auto step = exact_or(system.drawing.step, 1),
                   shrink = exact_or(system.drawing.shrink, 1);
        if (step && shrink && generation < 100'000)
            exact_unit_ = *step * power(*shrink, static_cast<long>(generation));
        pen_.letters = letters_for_drawing(rules_, steps_, pen_.figure, budget);
        facts_.step = std::abs(pen_.unit);
        facts_.rounded = rounded;
        count_segments(budget);
        if (is_lattice()) {
            measure_by_folding(budget);
        } else {
            measure_by_walking(budget);
        }
    }

    const Box& box() const override { return box_; }
    const Integer& segments() const override { return facts_.segments; }
    const Facts& facts() const override { return facts_; }

    std::optional<std::uint64_t> strokes() const override {
        const Integer all = facts_.segments + polygons_;
        if (!all.fits_uint64()) return std::nullopt;
        return all.to_uint64();
    }

    const FigureStyle& style() const override { return style_; }

    void draw(Canvas& canvas, double resolution, const Budget& budget) const override {
        if (resolution > 0 && is_foldable() && !has_polygons())
            draw_pieces(canvas, resolution, budget);
        else if (!is_foldable() || !draw_lattice_blocks(rules_, fates_, steps_, commands_, compass_,
                                                        pen_, canvas, budget)) {
            // An empty block tells a canvas that the strokes keep their style.
            if (auto* const blocks = keeps_style() && !canvas.wants_position()
                                         ? dynamic_cast<BlockCanvas*>(&canvas)
                                         : nullptr)
                blocks->block({}, pen_.start);
            draw_letters(canvas, budget);
        }
    }

private:
    /// Whether every letter leaves the stack as it found it, brackets apart: then folds apply.
    bool is_foldable() const {
        if (commands_.uses(Command::cut)) return false;
        const auto& brackets = rules_.brackets;
        bool pushes = false;
        for (const Symbol a : rules_.letters) {
            const auto& commands = commands_.of(a);
            if (brackets && (a == brackets->open || a == brackets->close)) {
                // An interpretation may make something else of them.
                if (commands != std::vector{a == brackets->open ? Command::push : Command::pop})
                    return false;
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

    bool is_lattice() const {
        return is_foldable() && compass_.is_exact() && !commands_.uses(Command::scale) &&
               !has_polygons();
    }

    bool has_polygons() const {
        return commands_.uses(Command::open_polygon) || commands_.uses(Command::close_polygon);
    }

    bool keeps_style() const {
        return !has_polygons() && !commands_.uses(Command::narrow) &&
               !commands_.uses(Command::next_colour);
    }

    void count_segments(const Budget& budget) {
        // Even where brackets cannot be folded, segments can: they do not care where they are drawn.
        // Only where branches are cut this counts too much; then the walk counts what it draws.
        const auto count = [&](Symbol a) {
            long drawn = 0, closed = 0;
            for (const Command command : commands_.of(a)) {
                drawn += draws(command) ? 1 : 0;
                closed += command == Command::close_polygon ? 1 : 0;
            }
            return std::vector<Integer>{Integer(drawn), Integer(closed)};
        };
        const auto counts = fold(rules_, steps_, Lift{Vectors{2}, count}, budget);
        facts_.segments = counts[0];
        polygons_ = counts[1];
    }

    void measure_by_folding(const Budget& budget) {
        const LatticeMotions motions(compass_.order());
        const auto letter = [&](Symbol a) {
            return product(motions, commands_.of(a),
                           [&](Command command) { return motions.of(command, compass_); });
        };
        auto motion = motions.turned(compass_.start());
        motions.append(motion, fold(rules_, steps_, Lift{motions, letter}, budget));

        // Directions are exact; the unit and the start may be doubles all the same.
        facts_.exact = exact_unit_ && (!start_ || (start_->x.exact && start_->y.exact));
        const CyclotomicRing& ring = motions.ring();
        const auto coordinate = [&](const CyclotomicInteger& number, Coordinate::Part part,
                                    const Rational& factor, bool vertical) {
            if (facts_.exact) {
                const Rational offset = !start_    ? Rational(0)
                                        : vertical ? *start_->y.exact
                                                   : *start_->x.exact;
                return Coordinate(ring, number, part, *exact_unit_ * factor, offset);
            }
            const auto point = ring.to_complex(number);
            return Coordinate((vertical ? pen_.start.y : pen_.start.x) +
                              pen_.unit * factor.to_double() *
                                  (part == Coordinate::Part::real ? point.real() : point.imag()));
        };
        facts_.end = {coordinate(motion.move, Coordinate::Part::real, 1, false),
                      coordinate(motion.move, Coordinate::Part::imaginary, 1, true)};
        if (motion.reach.empty()) return;
        // Reach is twice the real part towards a direction: +x, +y, -x, -y are quarters of the order.
        // A negative unit turns the drawing round.
        const int around = pen_.unit < 0 ? 2 : 0;
        const auto side = [&](int quarter, long sign) {
            const auto direction =
                static_cast<std::size_t>(compass_.order() / 4 * ((quarter + around) % 4));
            return coordinate(motion.reach[direction], Coordinate::Part::real,
                              Rational(around ? -sign : sign, 2), quarter % 2 == 1);
        };
        facts_.high = {side(0, 1), side(1, 1)};
        facts_.low = {side(2, -1), side(3, -1)};
        box_.add(Point{facts_.low[0].value(), facts_.low[1].value()});
        box_.add(Point{facts_.high[0].value(), facts_.high[1].value()});
    }

    void measure_by_walking(const Budget& budget) {
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

    std::vector<Hom<Pieces>> pieces(const Budget& budget) const {
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
                case Command::move:
                    value.move = 1;
                    break;
                case Command::left:
                case Command::right:
                case Command::back:
                    value.turn = compass_.normal(compass_.turn_of(command));
                    break;
                case Command::scale:
                    value.size = pen_.scale;
                    break;
                case Command::narrow:
                    value.width = pen_.narrow;
                    break;
                case Command::next_colour:
                    value.colours = 1;
                    break;
                default:
                    break;
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

    void survey_pieces(Surveyor& surveyor, const std::vector<Hom<Pieces>>& rows,
                       const Budget& budget) const {
        // A part that cannot stick out of the box known so far is not looked into, and neither is one
        // that sticks out so little that it cannot be told from the right one: of long words, a box that is wrong by
        // less than a thousandth of the line width.
        Pen<FloatingPosition> pen(surveyor, compass_, pen_);
        const double share = pen_.letters > finely_measured_letters ? coarse_share : fine_share;
        const double tolerance = std::abs(pen_.unit) * rows.back()(rules_.axiom).reach() * share;
        walk_parts(pen, rows, budget, [&](Symbol, std::uint64_t, const Pieces::value_type& part) {
            const double size = pen_.unit * pen.size();
            const auto centre = size * compass_.direction(pen.heading()) * part.centre;
            const double radius = std::abs(size) * part.radius - tolerance;
            const Point at = pen.point();
            const Box& box = surveyor.box;
            const bool inside = !box.empty && at.x + centre.real() - radius >= box.low.x &&
                                at.x + centre.real() + radius <= box.high.x &&
                                at.y + centre.imag() - radius >= box.low.y &&
                                at.y + centre.imag() + radius <= box.high.y;
            if (part.draws() && !inside) return true;
            pen.jump(part, false);
            return false;
        });
    }

    /// Draws the letters of the word with a pen. Of a letter with steps to go, `looks_into(letter, steps, part)` says
    /// whether to draw what it becomes.
    template <class LooksInto>
    void walk_parts(Pen<FloatingPosition>& pen, const std::vector<Hom<Pieces>>& rows,
                    const Budget& budget, LooksInto looks_into) const {
        std::uint64_t visits = 0;
        walk(rules_, fates_, steps_, [&](Symbol a, std::uint64_t left) {
            if (++visits % 65536 == 0) budget.check();
            if (left > 0) return looks_into(a, left, rows[left].images[a]);
            pen.letter(commands_.of(a));
            return true;
        });
        pen.finish();
    }

    Point draw_letters(Canvas& canvas, const Budget& budget) const {
        if (compass_.is_exact() && !commands_.uses(Command::scale))
            return walk_letters(rules_, fates_, steps_, commands_,
                                Pen<LatticePosition>(canvas, compass_, pen_), budget);
        return walk_letters(rules_, fates_, steps_, commands_,
                            Pen<FloatingPosition>(canvas, compass_, pen_), budget);
    }

    void draw_pieces(Canvas& canvas, double resolution, const Budget& budget) const {
        const auto rows = pieces(budget);
        Pen<FloatingPosition> pen(canvas, compass_, pen_);
        const double limit = resolution / std::abs(pen_.unit);
        // The same part at the same place in the same direction draws the same, if nothing else about
        // the pen can differ; of a hue that runs with the word, the first one stays. The smallest parts
        // cost less to draw than to look up.
        const bool plain = !commands_.uses(Command::next_colour) &&
                           !commands_.uses(Command::narrow) && !commands_.uses(Command::scale);
        VisitedParts visited(resolution * 1e-3, budget);
        walk_parts(pen, rows, budget, [&](Symbol a, std::uint64_t left, const auto& part) {
            const double extent = part.extent() * std::abs(pen.size());
            if (extent <= limit) {
                pen.jump(part, true);
                return false;
            }
            if (plain && extent > 4 * limit &&
                !visited.insert(a, left, pen.heading(), pen.point())) {
                pen.jump(part, false);
                return false;
            }
            return true;
        });
    }

    FigureStyle style_;
    std::optional<Drawing::Start> start_;
    D0L rules_;
    std::uint64_t steps_;
    Compass compass_;
    Commands commands_;
    Fates fates_;
    PenSettings pen_;
    std::optional<Rational> exact_unit_;
    Facts facts_;
    Integer polygons_;  // at most
    Box box_;
};

}  // namespace

std::unique_ptr<Figure> plane_figure(const Model& system, D0L rules, std::uint64_t steps,
                                     std::uint64_t generation, const Budget& budget,
                                     const std::string& rounded) {
    return std::make_unique<PlaneFigure>(system, std::move(rules), steps, generation, budget,
                                         rounded);
}

}  // namespace algae
