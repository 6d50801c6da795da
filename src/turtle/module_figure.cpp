#include "turtle/module_figure.hpp"

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "turtle/commands.hpp"
#include "turtle/surveyor.hpp"

namespace algae {

namespace {

Point in_plane(const Vector& place) { return {place.x, place.y}; }

/// Passes a walk in the plane on to a canvas.
class PlaneEvents : public TurtleEvents {
public:
    PlaneEvents(Canvas& canvas, std::size_t modules)
        : canvas_(canvas), modules_(static_cast<double>(modules)) {}

    void before(std::size_t module, const TurtleState&) override {
        fraction_ = static_cast<double>(module) / modules_;
    }
    bool wants_modules() const override { return canvas_.wants_position(); }

    void stroke(const Vector& from, const TurtleState& state) override {
        if (!at_pen_) canvas_.move_to(in_plane(from));
        if (canvas_.wants_position()) canvas_.position(fraction_);
        canvas_.line_to(in_plane(state.position));
        at_pen_ = true;
    }
    void move(const Vector&, const TurtleState&) override { at_pen_ = false; }
    void returned(const TurtleState&) override { at_pen_ = false; }
    void polygon(std::span<const Vector> corners) override {
        corners_.clear();
        for (const Vector& corner : corners) corners_.push_back(in_plane(corner));
        if (canvas_.wants_position()) canvas_.position(fraction_);
        canvas_.polygon(corners_);
        at_pen_ = false;
    }
    void width(const StrokeWidth& width) override {
        if (width.is_length)
            canvas_.width_as_length(width.amount);
        else
            canvas_.width(width.amount);
    }
    void colour(std::uint32_t index) override { canvas_.colour(index); }
    void paint(const Colour& colour) override { canvas_.paint(colour); }

private:
    Canvas& canvas_;
    double modules_, fraction_ = 0;
    bool at_pen_ = false;  // whether the canvas' pen stands where the turtle is
    std::vector<Point> corners_;
};

}  // namespace

ModuleFigure::ModuleFigure(const LSystem& system, const ModuleKinds& kinds, ModuleString word,
                           std::uint64_t generation, std::uint64_t seed, const Budget& budget)
    : settings_(system.settings), turtle_(system, kinds, generation, seed), word_(std::move(word)) {
    if (const auto symbol = turtle_.symbol_of_space(word_)) refuse_space(system, *symbol);
    if (settings_.tropism && settings_.tropism->z.value != 0)
        throw Error("the tropism of " + turtle_.name() +
                    " bends it out of the plane: expected a figure in the plane");
    Surveyor surveyor;
    PlaneEvents events(surveyor, word_.kinds.size());
    const TurtleState end = turtle_.walk(word_, events, budget);
    facts_.segments = Integer(surveyor.lines);
    facts_.end = {Coordinate(end.position.x), Coordinate(end.position.y)};
    facts_.widest = surveyor.widest_length;
    strokes_ = surveyor.lines + surveyor.polygons;
    box_ = surveyor.box;
    facts_.step = std::fabs(turtle_.start().step);
    if (box_.empty) return;
    facts_.low = {Coordinate(box_.low.x), Coordinate(box_.low.y)};
    facts_.high = {Coordinate(box_.high.x), Coordinate(box_.high.y)};
    // Rounding over a long walk is far less than a millionth of this.
    const double least = std::max(box_.breadth(), box_.height()) * 1e-5;
    if (least > 0) facts_.step = std::max(std::min(facts_.step, surveyor.shortest()), least);
}

void ModuleFigure::draw(Canvas& canvas, double /*resolution*/, const Budget& budget) const {
    PlaneEvents events(canvas, word_.kinds.size());
    turtle_.walk(word_, events, budget);
}

}  // namespace algae
