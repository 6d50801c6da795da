#include "turtle/turtle.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "model/model.hpp"
#include "turtle/detail/module_turtle.hpp"

// A turtle's walk in words, symbol by symbol.
//
// The words are about what happened, not about what the symbol is called: an Explainer hears the events
// of the walk and compares the turtle before and after each symbol. So a symbol with an interpretation
// says all that comes of it, and one that changes nothing says why (a cut branch, a corner of a polygon).
// A turn is named after the axis that stays, if one does; its amount is the one that the file or the
// module says if that is the same turn, so that 270 degrees to the left are not told as 90 to the right.

namespace algae {

namespace {

constexpr double same = 1e-9;  // of unit vectors: far more than rounding, far less than any turn

std::string place(const Vector& at, bool in_space) {
    return "(" + rounded(at.x) + ", " + rounded(at.y) + (in_space ? ", " + rounded(at.z) : "") +
           ")";
}

double degrees(double cosine, double sine) {
    return std::atan2(sine, cosine) * (180 / std::numbers::pi);
}

bool close(const Vector& a, const Vector& b) { return length(a - b) < same; }

/// The turn between two attitudes about one of the first one's axes, if it is about one.
struct AxisTurn {
    const char *positive, *negative;
    double degrees;
};
std::optional<AxisTurn> axis_turn(const Attitude& a, const Attitude& b) {
    const Vector &h = b.heading(), &l = b.left();
    if (close(a.up(), b.up()))
        return AxisTurn{"turn left", "turn right", degrees(dot(h, a.heading()), dot(h, a.left()))};
    if (close(a.left(), b.left()))
        return AxisTurn{"pitch up", "pitch down", degrees(dot(h, a.heading()), dot(h, a.up()))};
    if (close(a.heading(), b.heading()))
        return AxisTurn{"roll right", "roll left", degrees(dot(l, a.left()), dot(l, a.up()))};
    return std::nullopt;
}

/// Keeps what a turtle does, and puts it into words.
class Explainer : public TurtleEvents {
public:
    Explainer(const Model& system, const ModuleKinds& kinds, const ModuleString& word)
        : system_(system), kinds_(kinds), word_(word), text_(system.alphabet, kinds) {}

    bool wants_modules() const override { return true; }
    void before(std::size_t, const TurtleState& state) override {
        finish(state);
        ExplainedStep& step = steps_.emplace_back();
        step.before = known_ = state;
        module_ = steps_.size() - 1;
        step.symbol = text_.text(word_.kinds[module_], values());
    }

    void stroke(const Vector& from, const TurtleState& state) override { line(from, state, true); }
    void move(const Vector& from, const TurtleState& state) override { line(from, state, false); }
    void branched(const TurtleState& state) override {
        note_turn(state);
        note("remember position and heading");
        open_.push_back(module_);
    }
    void returned(const TurtleState& state) override {
        if (open_.empty()) return;
        steps_.back().returns_to = open_.back();
        note("go back to where step " + std::to_string(open_.back() + 1) + " was");
        open_.pop_back();
        known_ = state;
    }
    void polygon(std::span<const Vector> corners) override {
        note("fill the polygon of " + std::to_string(corners.size()) + " corners");
        steps_.back().polygons.emplace_back(corners.begin(), corners.end());
    }
    void stamp(StampShape shape, double size, const TurtleState& state) override {
        note_turn(state);
        const char* const what = shape == StampShape::square   ? "square of side "
                                 : shape == StampShape::circle ? "disc of diameter "
                                                               : "triangle of side ";
        note("leave a " + (what + rounded(size)));
        steps_.back().polygons.push_back(stamp_corners(shape, size, state));
    }
    void solid(SolidShape shape, const Vector& size, const TurtleState& state) override {
        note_turn(state);
        switch (shape) {
            case SolidShape::box:
                return note("leave a box, " + rounded(size.x) + " by " + rounded(size.y) + " by " +
                            rounded(size.z));
            case SolidShape::cylinder:
                return note("leave a cylinder of height " + rounded(size.x) + " and radius " +
                            rounded(size.y));
            case SolidShape::cone:
                return note("leave a cone of height " + rounded(size.x) + " and radius " +
                            rounded(size.y));
            case SolidShape::sphere:
                return note("leave a sphere of radius " + rounded(size.x));
        }
    }
    void width(const StrokeWidth& width) override {
        if (width == known_.width) return;
        known_.width = width;
        note(width.is_length ? "lines " + rounded(width.amount) + " wide"
                             : "lines " + rounded(width.amount) + " times as wide as at first");
    }
    void colour(std::uint32_t index) override {
        if (index == known_.colour && !known_.paint) return;
        known_.colour = index;
        known_.paint.reset();
        const auto& list = system_.drawing.colours;
        note("colour " + std::to_string(index) +
             (list.empty() ? "" : ", " + list[index % list.size()]));
    }
    void paint(const Colour& colour) override {
        known_.paint = colour;
        note("colour (" + rounded(colour.red) + ", " + rounded(colour.green) + ", " +
             rounded(colour.blue) + ")");
    }

    std::vector<ExplainedStep> finished(const TurtleState& end) {
        finish(end);
        return std::move(steps_);
    }

private:
    const double* values() {
        const double* at = word_.values.data() + offset_;
        offset_ += kinds_.arity(word_.kinds[module_]);
        return at;
    }
    const std::string& name() const {
        return system_.alphabet.name(kinds_.letter(word_.kinds[module_]));
    }
    bool is_interpreted() const {
        const Symbol letter = kinds_.letter(word_.kinds[module_]);
        return std::any_of(
            system_.interpretation.begin(), system_.interpretation.end(),
            [&](const Production& rule) { return rule.predecessor.symbol == letter; });
    }
    /// What + or - says by itself.
    double said(double turn) const {
        const std::uint32_t arity = kinds_.arity(word_.kinds[module_]);
        double amount = arity > 0               ? word_.values[offset_ - arity]
                        : system_.drawing.angle ? system_.drawing.angle->value
                                                : 90;
        if (is_interpreted()) return turn;
        for (const double own : {amount, -amount})
            if (std::fabs(std::remainder(own - turn, 360)) < 1e-6 &&
                (std::fabs(std::fabs(turn) - 180) > 1e-6 || (own > 0) == (name() != "-")))
                return own;
        return turn;
    }

    void note(const std::string& what) {
        std::string& meaning = steps_.back().meaning;
        if (!meaning.empty()) meaning += "; ";
        meaning += what;
    }

    void note_turn(const TurtleState& state) {
        const Attitude from = known_.attitude;
        known_.attitude = state.attitude;
        const Attitude& to = state.attitude;
        if (close(from.heading(), to.heading()) && close(from.left(), to.left())) return;
        const std::optional<AxisTurn> turn = axis_turn(from, to);
        if (!turn) return note("turn to " + place(to.heading(), true));
        if (name() == "|" && std::fabs(std::fabs(turn->degrees) - 180) < 1e-6)
            return note("turn back");
        const double by = said(turn->degrees);
        note((by > 0 ? turn->positive : turn->negative) + std::string(" by ") +
             rounded(std::fabs(by)) + "°");
    }

    void line(const Vector& from, const TurtleState& state, bool drawn) {
        // What bends the turtle after a stroke comes after it.
        TurtleState at = state;
        note_turn(at);
        const Vector way = state.position - from;
        const double ahead = dot(way, state.attitude.heading());
        const double slack = same * std::max(1.0, length(way));
        const bool straight = length(way - ahead * state.attitude.heading()) < slack;
        const std::string pen = drawn ? ", drawing" : ", pen up";
        if (straight)
            note((ahead < 0 ? "back " : "forward ") + rounded(std::fabs(ahead)) + pen);
        else
            note("to " + place(state.position, state.position.z != 0) + pen);
        steps_.back().lines.push_back({from, state.position, drawn, state});
        known_.position = state.position;
    }

    /// Says what the last symbol did that no event tells.
    void finish(const TurtleState& after) {
        if (steps_.empty()) return;
        ExplainedStep& step = steps_.back();
        note_turn(after);
        if (after.susceptibility != known_.susceptibility)
            note("the susceptibility to the tropism is now " + rounded(after.susceptibility));
        if (after.step != known_.step) note("steps are now " + rounded(after.step) + " long");
        step.after = after;
        step.open = open_.size();
        const bool begins = name() == "%" && !is_interpreted();
        if (step.meaning.empty()) step.meaning = quiet(begins);
        if (begins) cut_ = true;
        if (step.returns_to) cut_ = false;
    }

    /// For symbols after which nothing has changed.
    std::string quiet(bool cuts) const {
        if (cut_) return "left out: the branch was cut";
        if (cuts) return "leave out the rest of the branch";
        if (!is_interpreted() && name() == "{") return "begin a polygon, its first corner here";
        if (!is_interpreted() && name() == "}") return "end the polygon: too few corners to fill";
        if (!is_interpreted() && name() == ".") return "a corner of the polygon here";
        return "nothing";
    }

    const Model& system_;
    const ModuleKinds& kinds_;
    const ModuleString& word_;
    ModuleText text_;
    std::vector<ExplainedStep> steps_;
    std::vector<std::size_t> open_;  // the steps that began the open branches
    TurtleState known_;              // the turtle as the words so far have it
    std::size_t module_ = 0, offset_ = 0;
    bool cut_ = false;
};

}  // namespace

std::string rounded(double value) {
    if (std::fabs(value) >= 1e15) return rounded_decimal(value, 6);
    char text[64];
    std::snprintf(text, sizeof text, "%.4f", value);
    std::string out = text;
    while (out.ends_with('0')) out.pop_back();
    if (out.ends_with('.')) out.pop_back();
    return out == "-0" ? "0" : out;
}

std::optional<double> heading_angle(const TurtleState& state) {
    const Vector& heading = state.attitude.heading();
    if (std::fabs(heading.z) > same) return std::nullopt;
    const double angle = degrees(heading.x, heading.y);
    return angle < -1e-9 ? angle + 360 : std::max(angle, 0.0);
}

Explanation explanation(const Model& system, const ModuleKinds& kinds, const ModuleString& word,
                        std::uint64_t generation, std::uint64_t seed, const Budget& budget) {
    const ModuleTurtle turtle(system, kinds, generation, seed);
    Explainer explainer(system, kinds, word);
    const TurtleState end = turtle.walk(word, explainer, budget);
    Explanation result;
    result.name = turtle.name();
    result.word = ModuleText(system.alphabet, kinds).text(word);
    result.start = turtle.start();
    result.steps = explainer.finished(end);
    return result;
}

}  // namespace algae
