#include "turtle/detail/module_turtle.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>

#include "model/model.hpp"
#include "watch/watch.hpp"

// The turtle for words of modules: its attitude in space, what it does at each command, and its walk.
//
// Each module of the word is obeyed, or interpreted if some interpretation rule of its kind matches: then
// what the rule gives is walked in its place, and interpreted again. The interpretation is compiled as the
// rules of a system of its own, so that conditions, parameters and probabilities work as in derivations.
// It sees one module at a time: rules with contexts are refused.
//
// Interpretation is recursive, at most 1000 deep and a million modules for one of the word, so that one
// that never ends is an error with a place and not a crash. Parameters of depth d live in rooms_[d], which
// stay where they are while deeper rooms are added.
//
// Turns of the attitude are rotations in a plane of two of its three vectors. Sines and cosines of
// multiples of 30 and 45 degrees come out as they should, because the angle is folded into one eighth of a
// turn first; the rounding of all others is taken out every 16 turns (Attitude::straighten), so that long
// walks stay orthonormal.
//
// What is subtle in the commands: `turn clockwise` mirrors turns about up only, and the file's own angle
// already has it (see yaw and tilt); a cut branch goes on counting brackets but does
// nothing else, and a polygon that was open at the cut is given up at the end of the branch; a bracket
// gives back position, attitude, step, width and colour, and tells of width and colour only if they change.

namespace algae {

Turn turn_by(double degrees) {
    double rest = std::fmod(degrees, 360.0);  // exact
    const bool mirrored = rest < 0;
    rest = std::fabs(rest);
    const int quarters = static_cast<int>(rest / 90);
    rest -= 90.0 * quarters;
    const bool flipped = rest > 45;
    const double part = (flipped ? 90 - rest : rest) * (std::numbers::pi / 180);
    double cosine = std::cos(part), sine = std::sin(part);
    if (rest == 30 || rest == 60) sine = 0.5;
    if (rest == 45) sine = cosine;
    if (flipped) std::swap(cosine, sine);
    switch (quarters) {
        case 1:
            cosine = -std::exchange(sine, cosine);
            break;
        case 2:
            cosine = -cosine, sine = -sine;
            break;
        case 3:
            sine = -std::exchange(cosine, sine);
            break;
        default:
            break;
    }
    return {cosine, mirrored ? -sine : sine};
}

void Attitude::bend(const Vector& to, double radians) {
    const Vector across = cross(heading_, to);
    const double size = length(across);
    if (!(size > 0)) return;
    const Vector axis = (1 / size) * across;
    const double cosine = std::cos(radians), sine = std::sin(radians);
    for (Vector* const vector : {&heading_, &left_, &up_})
        *vector = cosine * *vector + sine * cross(axis, *vector) +
                  (1 - cosine) * dot(axis, *vector) * axis;
    if (++turns_ % 16 == 0) straighten();
}

bool Attitude::level() {
    const double size = std::hypot(heading_.x, heading_.y);
    if (!(size > 1e-9)) return false;
    left_ = {-heading_.y / size, heading_.x / size, 0};
    up_ = cross(heading_, left_);
    return true;
}

namespace {

/// Turns by degrees, those that were asked for lately without working them out again.
class Turns {
public:
    const Turn& by(double degrees) {
        const auto bits = std::bit_cast<std::uint64_t>(degrees);
        Known& known = known_[bits * 0x9E3779B97F4A7C15u >> 58];
        if (known.degrees != degrees) known = {degrees, turn_by(degrees)};
        return known.turn;
    }

private:
    struct Known {
        double degrees = 0;
        Turn turn;
    };
    std::array<Known, 64> known_;
};

/// Why a turtle does not obey.
struct TurtleRefusal {
    std::string reason;
    bool is_unmatched = false;  // a bracket or brace that closes nothing
};

double amount(const TurtleCommand& command, const double* values, double otherwise) {
    return command.parameters > 0 ? *values : otherwise;
}

std::uint32_t colour_number(double number) {
    constexpr double most = 4294967295;
    if (!(number >= 0 && number <= most && number == std::floor(number)))
        throw TurtleRefusal{"expected the number of a colour, counted from 0"};
    return static_cast<std::uint32_t>(number);
}

/// A turtle that obeys commands one after another, and tells of what it does.
class Turtle {
public:
    /// Both must outlive the turtle.
    Turtle(const TurtleManner& manner, TurtleEvents& events)
        : manner_(manner),
          events_(events),
          state_(manner.start),
          default_turn_(turn_by(manner.angle)) {}

    const TurtleState& state() const { return state_; }

    /// Does what the command says with these parameters. Throws TurtleRefusal if it makes no sense here.
    void obey(const TurtleCommand& command, const double* values) {
        using enum TurtleOperation;
        if (skips(command)) return;
        switch (command.operation) {
            case nothing:
                break;
            case draw:
                go(true, true, amount(command, values, 1));
                break;
            case draw_unmarked:
                go(true, false, amount(command, values, 1));
                break;
            case move:
                go(false, true, amount(command, values, 1));
                break;
            case left:
                state_.attitude.yaw(yaw(command, values, false));
                break;
            case right:
                state_.attitude.yaw(yaw(command, values, true));
                break;
            case down:
                state_.attitude.pitch(tilt(command, values, false));
                break;
            case up:
                state_.attitude.pitch(tilt(command, values, true));
                break;
            case roll_left:
                state_.attitude.roll(tilt(command, values, false));
                break;
            case roll_right:
                state_.attitude.roll(tilt(command, values, true));
                break;
            case back:
                state_.attitude.turn_back();
                break;
            case level:
                if (!state_.attitude.level())
                    throw TurtleRefusal{
                        "the heading is vertical, so that there is no level direction to roll to"};
                break;
            case push:
                open_branch();
                break;
            case pop:
                close_branch();
                break;
            case open_polygon:
                polygons_.push_back({state_.position});
                break;
            case close_polygon:
                end_polygon();
                break;
            case vertex:
                if (!polygons_.empty()) polygons_.back().push_back(state_.position);
                break;
            case scale:
                rescale(amount(command, values, manner_.scale));
                break;
            case width:
                set_width(command, values);
                break;
            case colour:
                set_colour(command, values);
                break;
            case cut:
                cut_ = true;
                cut_depth_ = 0;
                break;
            case plot:
                go_to({values[0], values[1], command.parameters > 2 ? values[2] : 0}, true, true);
                break;
            case stamp:
                leave_stamp(command, amount(command, values, 2));
                break;
            case solid:
                do_solid(command, values);
                break;
            case surface:
                leave_surface(command, amount(command, values, 1));
                break;
            case elasticity:
                set_susceptibility(command, values);
                break;
        }
    }

    /// Whether the command is in a part of the branch that `%` cut off.
    bool skips(const TurtleCommand& command) const {
        return cut_ && command.operation != TurtleOperation::push &&
               command.operation != TurtleOperation::pop;
    }
    /// Throws TurtleRefusal if a branch or a polygon is still open.
    void finish() const {
        if (!polygons_.empty() && !cut_) throw TurtleRefusal{"'{' is never closed"};
        if (!saved_.empty()) throw TurtleRefusal{"'[' is never closed"};
    }

private:
    struct Saved {
        TurtleState state;
        std::size_t polygons;
    };

    /// The turn that a command asks for, the other way if `mirrored`.
    Turn turn(const TurtleCommand& command, const double* values, bool mirrored) {
        Turn turn = command.parameters > 0 ? turns_.by(*values) : default_turn_;
        if (mirrored) turn.sine = -turn.sine;
        return turn;
    }

    /// Turns about up go the other way round after `turn clockwise`, which the file's own angle has in it.
    Turn yaw(const TurtleCommand& command, const double* values, bool mirrored) {
        return turn(command, values, mirrored != (manner_.clockwise && command.parameters > 0));
    }

    /// Other turns do not, whether or not they have an amount.
    Turn tilt(const TurtleCommand& command, const double* values, bool mirrored) {
        return turn(command, values, mirrored != (manner_.clockwise && command.parameters == 0));
    }

    void go_to(const Vector& to, bool drawn, bool marked) {
        if (!std::isfinite(to.x + to.y + to.z))
            throw TurtleRefusal{"leads to a place that is not finite"};
        const Vector from = state_.position;
        state_.position = to;
        if (drawn)
            events_.stroke(from, state_);
        else
            events_.move(from, state_);
        if (marked && !polygons_.empty()) polygons_.back().push_back(to);
    }

    void go(bool drawn, bool marked, double steps) {
        if (manner_.tropism && manner_.bends_before) bend(1);
        const double way = state_.step * steps;
        go_to(state_.position + way * state_.attitude.heading(), drawn, marked);
        if (drawn && manner_.tropism && !manner_.bends_before)
            bend(std::numeric_limits<double>::infinity());
    }

    /// Towards the tropism, by so many radians at most.
    void bend(double most) {
        const Vector& to = *manner_.tropism;
        const double pull = length(cross(state_.attitude.heading(), to));
        state_.attitude.bend(to, std::clamp(state_.susceptibility * pull, -most, most));
    }

    void set_susceptibility(const TurtleCommand& command, const double* values) {
        const double before = command.parameters > 1 ? values[0] * state_.susceptibility : 0;
        state_.susceptibility = before + values[command.parameters > 1 ? 1 : 0];
        if (!std::isfinite(state_.susceptibility))
            throw TurtleRefusal{"makes the susceptibility larger than any number"};
    }

    void rescale(double factor) {
        state_.step *= factor;
        if (!std::isfinite(state_.step))
            throw TurtleRefusal{"makes the step longer than any number"};
    }

    void set_width(const TurtleCommand& command, const double* values) {
        if (command.parameters > 0) {
            if (*values < 0) throw TurtleRefusal{"expected a width of at least 0"};
            state_.width = {*values, true};
        } else {
            state_.width.amount *= manner_.narrow;
        }
        events_.width(state_.width);
    }

    void set_colour(const TurtleCommand& command, const double* values) {
        if (command.parameters == 3) return set_paint(values);
        state_.colour = command.parameters > 0 ? colour_number(*values) : state_.colour + 1;
        state_.paint.reset();
        tell_colour();
    }

    void set_paint(const double* values) {
        if (std::any_of(values, values + 3, [](double part) { return !(part >= 0 && part <= 1); }))
            throw TurtleRefusal{"expected red, green and blue, each from 0 to 1"};
        state_.paint = Colour{values[0], values[1], values[2]};
        tell_colour();
    }

    void tell_colour() {
        if (state_.paint)
            events_.paint(*state_.paint);
        else
            events_.colour(state_.colour);
    }

    void leave_stamp(const TurtleCommand& command, double size) {
        if (size < 0) throw TurtleRefusal{"expected a size of at least 0"};
        events_.stamp(command.shape, size * std::fabs(state_.step), state_);
    }

    /// Turns or moves the turtle, or leaves a solid.
    void do_solid(const TurtleCommand& command, const double* values) {
        const SolidModule& module = *command.solid;
        Vector size = module.size(values, command.parameters);
        Attitude& look = state_.attitude;
        if (module.is_rotation()) {
            look.roll(turns_.by(-size.x));  // to the left is clockwise about the heading
            look.pitch(turns_.by(size.y));
            look.yaw(turns_.by(size.z));
            return;
        }
        size = std::fabs(state_.step) * size;
        const auto shape = module.shape();
        if (!shape)
            return go_to(state_.position + size.x * look.heading() + size.y * look.left() +
                             size.z * look.up(),
                         false, true);
        if (!std::isfinite(size.x + size.y + size.z) || std::min({size.x, size.y, size.z}) < 0)
            throw TurtleRefusal{"expected measures of at least 0"};
        if (const auto number = module.colour(values, command.parameters))
            events_.colour(colour_number(*number));
        events_.solid(*shape, size, state_);
        tell_colour();
    }

    void leave_surface(const TurtleCommand& command, double size) {
        size *= std::fabs(state_.step);
        if (!(size >= 0 && std::isfinite(size)))
            throw TurtleRefusal{"expected a size of at least 0"};
        const Attitude& look = state_.attitude;
        for (const auto& face : command.faces) {
            corners_.clear();
            for (const Vector& at : face)
                corners_.push_back(state_.position + size * at.x * look.heading() +
                                   size * at.y * look.left() + size * at.z * look.up());
            events_.polygon(corners_);
        }
    }

    void open_branch() {
        if (cut_) {
            ++cut_depth_;
            return;
        }
        saved_.push_back({state_, polygons_.size()});
        events_.branched(state_);
    }

    void close_branch() {
        if (cut_ && cut_depth_ > 0) {
            --cut_depth_;
            return;
        }
        if (saved_.empty()) throw TurtleRefusal{"unmatched ']'", true};
        if (cut_) polygons_.resize(std::min(polygons_.size(), saved_.back().polygons));
        cut_ = false;
        restore(saved_.back().state);
        saved_.pop_back();
    }

    void end_polygon() {
        if (polygons_.empty()) throw TurtleRefusal{"unmatched '}'", true};
        if (polygons_.back().size() > 2) events_.polygon(polygons_.back());
        polygons_.pop_back();
    }

    void restore(const TurtleState& state) {
        const bool wider = state.width != state_.width,
                   other = state.colour != state_.colour || state.paint != state_.paint;
        state_ = state;
        if (wider) events_.width(state_.width);
        if (other) tell_colour();
        events_.returned(state_);
    }

    const TurtleManner& manner_;
    TurtleEvents& events_;
    TurtleState state_;
    Turns turns_;
    Turn default_turn_;
    std::vector<Saved> saved_;
    std::vector<std::vector<Vector>> polygons_;  // open ones, the innermost last
    std::vector<Vector> corners_;                // of a surface's face
    bool cut_ = false;                           // up to the end of the branch
    std::size_t cut_depth_ = 0;                  // branches opened since
};

constexpr std::size_t deepest_interpretation = 1000;
constexpr std::uint64_t longest_interpretation = 1'000'000;  // modules for one of the word

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

std::string figure_name(const LSystem& system, std::uint64_t generation) {
    return "generation " + std::to_string(generation) +
           (system.name.empty() ? "" : " of " + system.name);
}

ModuleTurtle::ModuleTurtle(const Model& system, const ModuleKinds& kinds, std::uint64_t generation,
                           std::uint64_t seed)
    : rules_(compiled_rules(interpretation_of(system), {}, &kinds)),
      name_(figure_name(system, generation)),
      manner_(turtle_manner(system, generation, name_)),
      generation_(generation),
      seed_(seed) {
    for (std::size_t kind = 0; kind < kinds.size(); ++kind)
        own_kinds_.push_back(rules_.kinds.kind(kinds.letter(static_cast<ModuleKind>(kind)),
                                               kinds.arity(static_cast<ModuleKind>(kind))));
    for (std::size_t i = 0; i < rules_.kinds.size(); ++i) {
        const auto kind = static_cast<ModuleKind>(i);
        commands_.push_back(turtle_command(rules_.system->alphabet, system.drawing,
                                           rules_.kinds.letter(kind), rules_.kinds.arity(kind)));
        interpreted_.push_back(has_interpretation(kind));
    }
}

bool ModuleTurtle::has_interpretation(ModuleKind kind) const {
    const auto& of = rules_.tables.front().of;
    return kind < of.size() && !of[kind].empty();
}

std::optional<Symbol> ModuleTurtle::symbol_of_space(const ModuleString& word) const {
    std::vector<char> seen(rules_.kinds.size());
    std::vector<ModuleKind> open;
    const auto meet = [&](ModuleKind kind) {
        if (!seen[kind]) open.push_back(kind);
        seen[kind] = 1;
    };
    for (const ModuleKind kind : word.kinds) meet(own_kinds_.at(kind));
    while (!open.empty()) {
        const ModuleKind kind = open.back();
        open.pop_back();
        if (commands_[kind].leaves_plane) return rules_.kinds.letter(kind);
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
          obedient_(turtle.manner_, events),
          draws_(~turtle.seed_, turtle.generation_) {}

    /// Writes down what would be obeyed, and obeys nothing.
    ModuleString written(const ModuleString& word, std::vector<std::uint32_t>& lengths,
                         const Budget& budget) {
        ModuleString out;
        written_ = &out;
        lengths.clear();
        const double* values = word.values.data();
        for (position_ = 0; position_ < word.kinds.size(); ++position_) {
            if (position_ % 65536 == 0) budget.check();
            const std::size_t before = out.kinds.size();
            go_past(turtle_.own_kinds_[word.kinds[position_]], values, budget);
            values += turtle_.rules_.kinds.arity(turtle_.own_kinds_[word.kinds[position_]]);
            lengths.push_back(static_cast<std::uint32_t>(out.kinds.size() - before));
            if (out.kinds.size() > budget.letters)
                throw BoundReached(Bound::letters, turtle_.name_ + " is drawn by more than " +
                                                       std::to_string(budget.letters) +
                                                       " commands");
        }
        return out;
    }

    TurtleState all(const ModuleString& word, const Budget& budget) {
        const bool wanted = events_.wants_modules();
        const double* values = word.values.data();
        WorkCount modules("module of the walk", word.kinds.size());
        for (position_ = 0; position_ < word.kinds.size(); ++position_) {
            if (position_ % 65536 == 0) budget.check();
            modules.at(position_);
            if (wanted) events_.before(position_, obedient_.state());
            const ModuleKind kind = turtle_.own_kinds_[word.kinds[position_]];
            go_past(kind, values, budget);
            values += turtle_.rules_.kinds.arity(kind);
        }
        try {
            obedient_.finish();
        } catch (const TurtleRefusal& refusal) {
            throw Error(turtle_.name_ + ": " + refusal.reason);
        }
        return obedient_.state();
    }

private:
    [[noreturn]] void fail(ModuleKind kind, const double* values, const std::string& what) const {
        const ModuleText text(turtle_.rules_.system->alphabet, turtle_.rules_.kinds);
        std::string where = turtle_.name_ + ", position " + std::to_string(position_);
        if (top_values_) where += ", in the interpretation of " + text.text(top_, top_values_);
        throw Error(where + ": " + text.text(kind, values) + ": " + what);
    }

    /// A module of the word.
    void go_past(ModuleKind kind, const double* values, const Budget& budget) {
        if (!turtle_.interpreted_[kind]) return obey(kind, values);
        interpreted_ = 0;
        top_ = kind;
        top_values_ = values;
        interpret(kind, values, 0, budget);
        top_values_ = nullptr;
    }

    void obey(ModuleKind kind, const double* values) {
        if (written_) {
            written_->kinds.push_back(kind);
            written_->values.insert(written_->values.end(), values,
                                    values + turtle_.rules_.kinds.arity(kind));
            return;
        }
        const TurtleCommand& command = turtle_.commands_[kind];
        if (turtle_.rules_.inner && command.operation != TurtleOperation::nothing &&
            !obedient_.skips(command) &&
            std::any_of(values, values + command.read(), WordValues::is_word))
            fail(kind, values, "expected a number for the turtle, found a word");
        try {
            obedient_.obey(command, values);
        } catch (const TurtleRefusal& refusal) {
            if (refusal.is_unmatched && !top_values_)
                throw Error(turtle_.name_ + ", position " + std::to_string(position_) + ": " +
                            refusal.reason);
            fail(kind, values, refusal.reason);
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
        if (!rules) return obey(kind, values);
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
                obey(part, next);
            next += turtle_.rules_.kinds.arity(part);
        }
    }

    const ModuleTurtle& turtle_;
    TurtleEvents& events_;
    Turtle obedient_;
    Draws draws_;
    std::size_t position_ = 0;
    std::vector<std::vector<double>> rooms_;  // parameters of interpretations, by depth
    std::uint64_t interpreted_ = 0, choices_ = 0;
    ModuleKind top_ = 0;
    const double* top_values_ = nullptr;  // of the module of the word that is interpreted
    ModuleString* written_ = nullptr;     // what would be obeyed, if nothing is
};

ModuleString ModuleTurtle::interpreted(const ModuleString& word,
                                       std::vector<std::uint32_t>& lengths,
                                       const Budget& budget) const {
    TurtleEvents nobody;
    return Walk(*this, nobody).written(word, lengths, budget);
}

TurtleState ModuleTurtle::walk(const ModuleString& word, TurtleEvents& events,
                               const Budget& budget) const {
    return Walk(*this, events).all(word, budget);
}

}  // namespace algae
