#include "turtle/module_turtle.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/error.hpp"
#include "rewrite/draws.hpp"
#include "rewrite/module_text.hpp"
#include "rewrite/word_values.hpp"
#include "turtle/surface.hpp"

namespace algae {

namespace {

constexpr std::size_t deepest_interpretation = 1000;
constexpr std::uint64_t longest_interpretation = 1'000'000;  // modules for one of the word

double value_or(const std::optional<Quantity>& setting, double otherwise) {
    return setting ? setting->value : otherwise;
}

/// A system whose rules are the interpretation of this one.
LSystem interpretation_of(const LSystem& system) {
    LSystem out = system;
    out.axiom = {};
    out.tables.clear();
    out.schedule.clear();
    out.rules = std::move(out.interpretation);
    out.interpretation.clear();
    for (Production& rule : out.rules) {
        rule.table = 0;
        if (!rule.left.empty() || !rule.right.empty() || !rule.elsewhere.empty() || rule.shape)
            throw Error(to_string(rule.place) + ": the interpretation of " +
                        out.alphabet.name(rule.predecessor.symbol) +
                        (rule.shape ? " is a shape rule" : " has a context") +
                        ": the turtle sees one module at a time");
    }
    return out;
}

}  // namespace

void TurtleEvents::stamp(StampShape shape, double size, const TurtleState& state) {
    polygon(stamp_corners(shape, size, state));
}

std::vector<Vector> stamp_corners(StampShape shape, double size, const TurtleState& state) {
    constexpr int round = 64;
    const int corners = shape == StampShape::square ? 4 : shape == StampShape::triangle ? 3 : round;
    const double first = shape == StampShape::square ? 45 : 0;
    const double radius = shape == StampShape::square     ? size * (std::numbers::sqrt2 / 2)
                          : shape == StampShape::triangle ? size / std::numbers::sqrt3
                                                          : size / 2;
    std::vector<Vector> out;
    for (int i = 0; i < corners; ++i) {
        const Turn turn = turn_by(first + 360.0 * i / corners);
        double ahead = radius * turn.cosine, aside = radius * turn.sine;
        if (shape == StampShape::square) {
            ahead = std::copysign(size / 2, ahead);
            aside = std::copysign(size / 2, aside);
        }
        out.push_back(state.position + ahead * state.attitude.heading() +
                      aside * state.attitude.left());
    }
    return out;
}

std::string figure_name(const LSystem& system, std::uint64_t generation) {
    return "generation " + std::to_string(generation) +
           (system.name.empty() ? "" : " of " + system.name);
}

ModuleTurtle::ModuleTurtle(const LSystem& system, const ModuleKinds& kinds,
                           std::uint64_t generation, std::uint64_t seed)
    : rules_(compiled_rules(interpretation_of(system), {}, &kinds)),
      susceptibility_(value_or(system.settings.susceptibility, 1)),
      name_(figure_name(system, generation)),
      angle_(value_or(system.settings.angle, 90)),
      scale_(value_or(system.settings.scale, 1)),
      narrow_(value_or(system.settings.narrow, 1)),
      generation_(generation),
      seed_(seed) {
    const Settings& settings = system.settings;
    for (const SolidSetting& solid : settings.solids) solids_.emplace(solid.symbol, solid);
    for (const SurfaceSetting& surface : settings.surfaces)
        surfaces_.emplace(surface.symbol, surface_faces(surface));
    if (const auto& to = settings.tropism) tropism_ = Vector{to->x.value, to->y.value, to->z.value};
    for (std::size_t kind = 0; kind < kinds.size(); ++kind)
        own_kinds_.push_back(rules_.kinds.kind(kinds.letter(static_cast<ModuleKind>(kind)),
                                               kinds.arity(static_cast<ModuleKind>(kind))));
    for (std::size_t kind = 0; kind < rules_.kinds.size(); ++kind)
        operations_.push_back(operation_of(static_cast<ModuleKind>(kind)));
    for (std::size_t kind = 0; kind < rules_.kinds.size(); ++kind)
        interpreted_.push_back(has_interpretation(static_cast<ModuleKind>(kind)));
    if (settings.clockwise) angle_ = -angle_;
    start_.step = value_or(settings.step, 1) *
                  std::pow(value_or(settings.shrink, 1), static_cast<double>(generation));
    if (!std::isfinite(start_.step) || start_.step == 0)
        throw Error(name_ + ": the step of the turtle is " + std::to_string(start_.step) +
                    ", expected a length that a drawing can have; see step and shrink");
    double heading = std::fmod(value_or(settings.spin, 0) * static_cast<double>(generation), 360.0);
    if (settings.start) {
        start_.position = {settings.start->x.value, settings.start->y.value, 0};
        heading += settings.start->heading.value;
    }
    if (!std::isfinite(heading))
        throw Error(name_ + ": the heading of the start is no number; see start and spin");
    start_.attitude.yaw(turn_by(heading));
}

bool ModuleTurtle::has_interpretation(ModuleKind kind) const {
    const auto& of = rules_.tables.front().of;
    return kind < of.size() && !of[kind].empty();
}

ModuleTurtle::Operation ModuleTurtle::operation_of(ModuleKind kind) const {
    const LSystem& system = *rules_.system;
    const Settings& settings = system.settings;
    const Symbol letter = rules_.kinds.letter(kind);
    const std::uint32_t arity = rules_.kinds.arity(kind);
    if ((arity == 2 || arity == 3) &&
        std::count(settings.plotters.begin(), settings.plotters.end(), letter) > 0)
        return Operation::plot;
    for (const Settings::Stamp& stamp : settings.stamps)
        if (stamp.symbol == letter) return Operation::stamp;
    if (solids_.contains(letter)) return Operation::solid;
    if (surfaces_.contains(letter)) return Operation::surface;
    const std::string& name = system.alphabet.name(letter);
    if (name == "F" || name.starts_with("F_")) return Operation::draw;
    if (name == "f" || name.starts_with("f_")) return Operation::move;
    if (name.size() != 1) return Operation::nothing;
    switch (name[0]) {
        case 'G':
            return Operation::draw_unmarked;
        case '+':
            return Operation::left;
        case '-':
            return Operation::right;
        case '&':
            return Operation::down;
        case '^':
            return Operation::up;
        case '\\':
            return Operation::roll_left;
        case '/':
            return Operation::roll_right;
        case '|':
            return Operation::back;
        case '$':
        case '@':
            return Operation::level;
        case '[':
            return Operation::push;
        case ']':
            return Operation::pop;
        case '{':
            return Operation::open_polygon;
        case '}':
            return Operation::close_polygon;
        case '.':
            return Operation::vertex;
        case '\'':
            return Operation::colour;
        case '%':
            return Operation::cut;
        case '*':
            return arity > 0 || settings.scale ? Operation::scale : Operation::nothing;
        case '!':
            return arity > 0 || settings.narrow ? Operation::width : Operation::nothing;
        default:
            return Operation::nothing;
    }
}

std::optional<Symbol> ModuleTurtle::symbol_of_space(const ModuleString& word) const {
    std::vector<char> seen(rules_.kinds.size());
    std::vector<ModuleKind> open;
    const auto is_hollow = [&](Symbol letter) {
        for (const SurfaceSetting& surface : rules_.system->settings.surfaces)
            if (surface.symbol == letter) return !is_flat(surface);
        return false;
    };
    const auto meet = [&](ModuleKind kind) {
        if (!seen[kind]) open.push_back(kind);
        seen[kind] = 1;
    };
    for (const ModuleKind kind : word.kinds) meet(own_kinds_.at(kind));
    while (!open.empty()) {
        const ModuleKind kind = open.back();
        open.pop_back();
        const Operation operation = operations_[kind];
        const Symbol letter = rules_.kinds.letter(kind);
        const bool turns = operation >= Operation::down && operation <= Operation::roll_right;
        if (turns || operation == Operation::solid || is_hollow(letter) ||
            (operation == Operation::plot && rules_.kinds.arity(kind) > 2) ||
            (operation == Operation::level && rules_.system->alphabet.name(letter) == "$"))
            return letter;
        if (!interpreted_[kind]) continue;
        for (const Alternatives& alternatives : rules_.tables.front().of[kind])
            for (const std::uint32_t successor : alternatives.successors) {
                for (const ModuleKind part : rules_.successors[successor].kinds) meet(part);
                if (rules_.successors[successor].splices.empty()) continue;
                for (std::size_t part = 0; part < rules_.kinds.size(); ++part)
                    meet(static_cast<ModuleKind>(part));  // a word may have any of them
            }
    }
    return std::nullopt;
}

/// One walk.
class ModuleTurtle::Walk {
public:
    Walk(const ModuleTurtle& turtle, TurtleEvents& events)
        : turtle_(turtle),
          events_(events),
          state_(turtle.start_),
          draws_(~turtle.seed_, turtle.generation_),
          default_turn_(turn_by(turtle.angle_)),
          clockwise_(turtle.rules_.system->settings.clockwise) {}

    TurtleState all(const ModuleString& word, const Budget& budget) {
        const bool wanted = events_.wants_modules();
        const double* values = word.values.data();
        for (position_ = 0; position_ < word.kinds.size(); ++position_) {
            if (position_ % 65536 == 0) budget.check();
            if (wanted) events_.before(position_, state_);
            const ModuleKind kind = turtle_.own_kinds_[word.kinds[position_]];
            if (turtle_.interpreted_[kind]) {
                interpreted_ = 0;
                top_ = kind;
                top_values_ = values;
                interpret(kind, values, 0, budget);
                top_values_ = nullptr;
            } else {
                run(turtle_.operations_[kind], kind, values);
            }
            values += turtle_.rules_.kinds.arity(kind);
        }
        if (!polygons_.empty() && !cut_) throw Error(turtle_.name_ + ": '{' is never closed");
        if (!saved_.empty()) throw Error(turtle_.name_ + ": '[' is never closed");
        return state_;
    }

private:
    struct Saved {
        TurtleState state;
        std::size_t polygons;
    };

    [[noreturn]] void fail(ModuleKind kind, const double* values, const std::string& what) const {
        const ModuleText text(turtle_.rules_.system->alphabet, turtle_.rules_.kinds);
        std::string where = turtle_.name_ + ", position " + std::to_string(position_);
        if (top_values_) where += ", in the interpretation of " + text.text(top_, top_values_);
        throw Error(where + ": " + text.text(kind, values) + ": " + what);
    }

    double amount(ModuleKind kind, const double* values, double otherwise) const {
        return turtle_.rules_.kinds.arity(kind) > 0 ? *values : otherwise;
    }
    bool has_amount(ModuleKind kind) const { return turtle_.rules_.kinds.arity(kind) > 0; }

    /// The turn that a module asks for, the other way if `mirrored`.
    Turn turn(ModuleKind kind, const double* values, bool mirrored) {
        Turn turn = has_amount(kind) ? turns_.by(*values) : default_turn_;
        if (mirrored) turn.sine = -turn.sine;
        return turn;
    }
    /// Turns about up go the other way round after `turn clockwise`, which the file's own angle
    /// has in it.
    Turn yaw(ModuleKind kind, const double* values, bool mirrored) {
        return turn(kind, values, mirrored != (clockwise_ && has_amount(kind)));
    }
    /// Other turns do not, whether or not they have an amount.
    Turn tilt(ModuleKind kind, const double* values, bool mirrored) {
        return turn(kind, values, mirrored != (clockwise_ && !has_amount(kind)));
    }

    void go_to(const Vector& to, bool drawn, bool marked, ModuleKind kind, const double* values) {
        if (!std::isfinite(to.x + to.y + to.z))
            fail(kind, values, "leads to a place that is not finite");
        const Vector from = state_.position;
        state_.position = to;
        if (drawn)
            events_.stroke(from, state_);
        else
            events_.move(from, state_);
        if (marked && !polygons_.empty()) polygons_.back().push_back(to);
    }
    void go(bool drawn, bool marked, ModuleKind kind, const double* values) {
        const double way = state_.step * amount(kind, values, 1);
        go_to(state_.position + way * state_.attitude.heading(), drawn, marked, kind, values);
        if (!drawn || !turtle_.tropism_) return;
        const Vector& to = *turtle_.tropism_;
        const double pull = length(cross(state_.attitude.heading(), to));
        state_.attitude.bend(to, turtle_.susceptibility_ * pull);
    }

    void restore(const TurtleState& state) {
        const bool wider = state.width != state_.width,
                   other = state.colour != state_.colour || state.paint != state_.paint;
        state_ = state;
        if (wider) events_.width(state_.width);
        if (other) tell_colour();
        events_.returned(state_);
    }

    void set_width(ModuleKind kind, const double* values) {
        if (has_amount(kind)) {
            if (*values < 0) fail(kind, values, "expected a width of at least 0");
            state_.width = {*values, true};
        } else {
            state_.width.amount *= turtle_.narrow_;
        }
        events_.width(state_.width);
    }

    void tell_colour() {
        if (state_.paint)
            events_.paint(*state_.paint);
        else
            events_.colour(state_.colour);
    }

    void set_paint(ModuleKind kind, const double* values) {
        if (std::any_of(values, values + 3, [](double part) { return !(part >= 0 && part <= 1); }))
            fail(kind, values, "expected red, green and blue, each from 0 to 1");
        state_.paint = Colour{values[0], values[1], values[2]};
        tell_colour();
    }

    std::uint32_t colour_number(double number, ModuleKind kind, const double* values) const {
        constexpr double most = 4294967295;
        if (!(number >= 0 && number <= most && number == std::floor(number)))
            fail(kind, values, "expected the number of a colour, counted from 0");
        return static_cast<std::uint32_t>(number);
    }

    void set_colour(ModuleKind kind, const double* values) {
        if (turtle_.rules_.kinds.arity(kind) == 3) return set_paint(kind, values);
        state_.colour = has_amount(kind) ? colour_number(*values, kind, values) : state_.colour + 1;
        state_.paint.reset();
        tell_colour();
    }

    void leave_stamp(ModuleKind kind, const double* values) {
        const double size = amount(kind, values, 2);
        if (size < 0) fail(kind, values, "expected a size of at least 0");
        const Symbol letter = turtle_.rules_.kinds.letter(kind);
        for (const Settings::Stamp& stamp : turtle_.rules_.system->settings.stamps)
            if (stamp.symbol == letter) {
                events_.stamp(stamp.shape, size * std::fabs(state_.step), state_);
                return;
            }
    }

    /// Turns or moves the turtle, or leaves a solid.
    void do_solid(ModuleKind kind, const double* values) {
        const std::uint32_t count = turtle_.rules_.kinds.arity(kind);
        const SolidModule& module = turtle_.solids_.at(turtle_.rules_.kinds.letter(kind));
        Vector size = module.size(values, count);
        if (module.is_rotation()) {
            state_.attitude.roll(turns_.by(-size.x));  // to the left is clockwise about the heading
            state_.attitude.pitch(turns_.by(size.y));
            state_.attitude.yaw(turns_.by(size.z));
            return;
        }
        size = std::fabs(state_.step) * size;
        const auto shape = module.shape();
        if (!shape) {
            const Attitude& look = state_.attitude;
            go_to(state_.position + size.x * look.heading() + size.y * look.left() +
                      size.z * look.up(),
                  false, true, kind, values);
            return;
        }
        if (!std::isfinite(size.x + size.y + size.z) || std::min({size.x, size.y, size.z}) < 0)
            fail(kind, values, "expected measures of at least 0");
        if (const auto number = module.colour(values, count))
            events_.colour(colour_number(*number, kind, values));
        events_.solid(*shape, size, state_);
        tell_colour();
    }

    void leave_surface(ModuleKind kind, const double* values) {
        const double size = amount(kind, values, 1) * std::fabs(state_.step);
        if (!(size >= 0 && std::isfinite(size)))
            fail(kind, values, "expected a size of at least 0");
        const Attitude& look = state_.attitude;
        for (const auto& face : turtle_.surfaces_.at(turtle_.rules_.kinds.letter(kind))) {
            corners_.clear();
            for (const Vector& at : face)
                corners_.push_back(state_.position + size * at.x * look.heading() +
                                   size * at.y * look.left() + size * at.z * look.up());
            events_.polygon(corners_);
        }
    }

    void rescale(ModuleKind kind, const double* values) {
        state_.step *= amount(kind, values, turtle_.scale_);
        if (!std::isfinite(state_.step))
            fail(kind, values, "makes the step longer than any number");
    }

    void close_branch(ModuleKind kind, const double* values) {
        if (cut_ && cut_depth_ > 0) {
            --cut_depth_;
            return;
        }
        if (saved_.empty()) unmatched(kind, values, "unmatched ']'");
        if (cut_) polygons_.resize(std::min(polygons_.size(), saved_.back().polygons));
        cut_ = false;
        restore(saved_.back().state);
        saved_.pop_back();
    }

    void close_polygon(ModuleKind kind, const double* values) {
        if (polygons_.empty()) unmatched(kind, values, "unmatched '}'");
        if (polygons_.back().size() > 2) events_.polygon(polygons_.back());
        polygons_.pop_back();
    }

    [[noreturn]] void unmatched(ModuleKind kind, const double* values, const char* what) const {
        if (top_values_) fail(kind, values, what);
        throw Error(turtle_.name_ + ", position " + std::to_string(position_) + ": " + what);
    }

    /// Where parameters may be words.
    void check_numbers(Operation operation, ModuleKind kind, const double* values) const {
        const std::uint32_t arity = turtle_.rules_.kinds.arity(kind);
        const bool all = operation == Operation::plot || operation == Operation::colour ||
                         operation == Operation::solid;
        const std::uint32_t read = all ? arity : std::min(arity, 1U);
        if (std::any_of(values, values + read, WordValues::is_word))
            fail(kind, values, "expected a number for the turtle, found a word");
    }

    void run(Operation operation, ModuleKind kind, const double* values) {
        if (cut_ && operation != Operation::push && operation != Operation::pop) return;
        if (turtle_.rules_.inner && operation != Operation::nothing)
            check_numbers(operation, kind, values);
        switch (operation) {
            case Operation::nothing:
                break;
            case Operation::draw:
                go(true, true, kind, values);
                break;
            case Operation::draw_unmarked:
                go(true, false, kind, values);
                break;
            case Operation::move:
                go(false, true, kind, values);
                break;
            case Operation::left:
                state_.attitude.yaw(yaw(kind, values, false));
                break;
            case Operation::right:
                state_.attitude.yaw(yaw(kind, values, true));
                break;
            case Operation::down:
                state_.attitude.pitch(tilt(kind, values, false));
                break;
            case Operation::up:
                state_.attitude.pitch(tilt(kind, values, true));
                break;
            case Operation::roll_left:
                state_.attitude.roll(tilt(kind, values, false));
                break;
            case Operation::roll_right:
                state_.attitude.roll(tilt(kind, values, true));
                break;
            case Operation::back:
                state_.attitude.turn_back();
                break;
            case Operation::level:
                if (!state_.attitude.level())
                    fail(kind, values,
                         "the heading is vertical, so that there is no level direction to roll to");
                break;
            case Operation::push:
                if (cut_) {
                    ++cut_depth_;
                } else {
                    saved_.push_back({state_, polygons_.size()});
                    events_.branched(state_);
                }
                break;
            case Operation::pop:
                close_branch(kind, values);
                break;
            case Operation::open_polygon:
                polygons_.push_back({state_.position});
                break;
            case Operation::close_polygon:
                close_polygon(kind, values);
                break;
            case Operation::vertex:
                if (!polygons_.empty()) polygons_.back().push_back(state_.position);
                break;
            case Operation::scale:
                rescale(kind, values);
                break;
            case Operation::width:
                set_width(kind, values);
                break;
            case Operation::colour:
                set_colour(kind, values);
                break;
            case Operation::cut:
                cut_ = true;
                cut_depth_ = 0;
                break;
            case Operation::plot: {
                const double height = turtle_.rules_.kinds.arity(kind) > 2 ? values[2] : 0;
                go_to({values[0], values[1], height}, true, true, kind, values);
                break;
            }
            case Operation::stamp:
                leave_stamp(kind, values);
                break;
            case Operation::solid:
                do_solid(kind, values);
                break;
            case Operation::surface:
                leave_surface(kind, values);
                break;
        }
    }

    /// The rules that a module matches, if any.
    const Alternatives* matching(ModuleKind kind, const double* values) const {
        const Alternatives* found = nullptr;
        for (const Alternatives& next : turtle_.rules_.tables.front().of[kind]) {
            try {
                if (next.condition && next.condition->run(values) == 0) continue;
            } catch (const Undefined& undefined) {
                fail(kind, values, undefined.reason);
            }
            if (found)
                fail(kind, values,
                     "the interpretations at " + place(*found) + " and at " + place(next) +
                         " both apply, expected one");
            found = &next;
        }
        if (found && found->successors.size() > 1 && found->probabilities.empty())
            fail(kind, values,
                 "has two interpretations without probabilities, that at " + place(*found) +
                     " is one; expected one");
        return found;
    }
    std::string place(const Alternatives& alternatives) const {
        return to_string(turtle_.rules_.successors[alternatives.successors.front()].rule->place);
    }

    std::uint32_t pick(const Alternatives& alternatives) {
        const std::size_t count = alternatives.successors.size();
        if (count == 1) return alternatives.successors.front();
        const std::uint64_t number = draws_.at(choices_++);
        std::size_t i = 0;
        while (i + 1 < count && number >= alternatives.thresholds[i]) ++i;
        return alternatives.successors[i];
    }

    void interpret(ModuleKind kind, const double* values, std::size_t depth, const Budget& budget) {
        const Alternatives* const rules = matching(kind, values);
        if (!rules) return run(turtle_.operations_[kind], kind, values);
        if (depth == deepest_interpretation)
            fail(kind, values,
                 "is interpreted again and again, " + std::to_string(deepest_interpretation) +
                     " times within itself, without an end");
        const Successor& successor = turtle_.rules_.successors[pick(*rules)];
        ModuleString spliced;
        if (rooms_.size() == depth) rooms_.emplace_back();
        try {
            if (!successor.splices.empty()) {
                append(successor, values, turtle_.rules_.kinds.words(), spliced);
            } else {
                rooms_[depth] = successor.values;
                for (const Successor::Slot& slot : successor.slots)
                    rooms_[depth][slot.at] = slot.value.run(values);
            }
        } catch (const Undefined& undefined) {
            fail(kind, values, undefined.reason);
        }
        const bool is_plain = successor.splices.empty();
        // Rooms stay where they are when there come more.
        const double* next = is_plain ? rooms_[depth].data() : spliced.values.data();
        const ModuleKind* const parts = is_plain ? successor.kinds.data() : spliced.kinds.data();
        const std::size_t count = is_plain ? successor.kinds.size() : spliced.kinds.size();
        for (const ModuleKind part : std::span(parts, count)) {
            if (++interpreted_ > longest_interpretation)
                fail(kind, values,
                     "its interpretation has more than " + std::to_string(longest_interpretation) +
                         " modules");
            if (interpreted_ % 65536 == 0) budget.check();
            if (turtle_.interpreted_[part])
                interpret(part, next, depth + 1, budget);
            else
                run(turtle_.operations_[part], part, next);
            next += turtle_.rules_.kinds.arity(part);
        }
    }

    const ModuleTurtle& turtle_;
    TurtleEvents& events_;
    TurtleState state_;
    Draws draws_;
    Turns turns_;
    Turn default_turn_;
    bool clockwise_;
    std::size_t position_ = 0;
    std::vector<Saved> saved_;
    std::vector<std::vector<Vector>> polygons_;  // open ones, the innermost last
    std::vector<Vector> corners_;                // of a surface's face
    std::vector<std::vector<double>> rooms_;     // parameters of interpretations, by depth
    std::uint64_t interpreted_ = 0, choices_ = 0;
    ModuleKind top_ = 0;
    const double* top_values_ = nullptr;  // of the module of the word that is interpreted
    bool cut_ = false;
    std::size_t cut_depth_ = 0;
};

TurtleState ModuleTurtle::walk(const ModuleString& word, TurtleEvents& events,
                               const Budget& budget) const {
    return Walk(*this, events).all(word, budget);
}

}  // namespace algae
