#include "turtle/detail/plane_figure.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "model/model.hpp"
#include "turtle/detail/module_turtle.hpp"

// Which figure in the plane a system has, and the figure of a word of modules.
//
// A system without contexts, choices and parameters is drawn from its rules (plane_figure.cpp), exactly
// where its angles and steps allow it. One with contexts is derived first, and the word is drawn in the
// same way, as a D0L system that rewrites nothing. Words with parameters, and systems whose stamps,
// solids, surfaces, tropism or interpretations need them, are walked by a ModuleTurtle in doubles: the
// figure keeps the word and walks it whenever it is drawn. Where a choice is left that nobody made
// (tables, several rules for a letter), the figure is refused and not guessed.

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

/// A word of modules in the plane. It keeps the word and walks it whenever it is drawn; coordinates
/// are doubles.
class ModuleFigure : public Figure {
public:
    /// Walks the word once. Throws Error if a symbol or a tropism leaves the plane, and as
    /// ModuleTurtle does. `seed` is for interpretations with probabilities.
    ModuleFigure(const Model& system, const ModuleKinds& kinds, ModuleString word,
                 std::uint64_t generation, std::uint64_t seed, const Budget& budget,
                 const std::string& rounded);

    const Box& box() const override { return box_; }
    const Integer& segments() const override { return facts_.segments; }
    const Facts& facts() const override { return facts_; }
    std::optional<std::uint64_t> strokes() const override { return strokes_; }
    const FigureStyle& style() const override { return style_; }
    /// Draws every stroke, whatever the resolution.
    void draw(Canvas& canvas, double resolution, const Budget& budget) const override;

private:
    FigureStyle style_;
    ModuleTurtle turtle_;
    ModuleString word_;
    Facts facts_;
    Box box_;
    std::uint64_t strokes_ = 0;
};

/// Whether commands without parameters say all that a turtle is to do with words of letters.
bool is_plain(const Model& system) {
    const Drawing& drawing = system.drawing;
    if (!drawing.stamps.empty() || !drawing.solids.empty() || !drawing.surfaces.empty() ||
        drawing.tropism)
        return false;
    return std::all_of(
        system.interpretation.begin(), system.interpretation.end(), [](const Production& rule) {
            return !rule.condition && !rule.probability && rule.predecessor.parameters.empty() &&
                   rule.successor.arguments.empty() && rule.successor.splices.empty();
        });
}

}  // namespace

ModuleFigure::ModuleFigure(const Model& system, const ModuleKinds& kinds, ModuleString word,
                           std::uint64_t generation, std::uint64_t seed, const Budget& budget,
                           const std::string& rounded)
    : style_(style_of(system.drawing)),
      turtle_(system, kinds, generation, seed),
      word_(std::move(word)) {
    if (const auto symbol = turtle_.symbol_of_space(word_)) refuse_space(system, *symbol);
    if (system.drawing.tropism && system.drawing.tropism->z.value != 0)
        throw Error("the tropism of " + turtle_.name() +
                    " bends it out of the plane: expected a figure in the plane");
    Surveyor surveyor;
    PlaneEvents events(surveyor, word_.kinds.size());
    const TurtleState end = turtle_.walk(word_, events, budget);
    facts_.segments = Integer(surveyor.lines);
    facts_.end = {Coordinate(end.position.x), Coordinate(end.position.y)};
    facts_.widest = surveyor.widest_length;
    facts_.rounded = rounded;
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

std::unique_ptr<Figure> module_figure(const Model& system, const ModuleKinds& kinds,
                                      ModuleString word, std::uint64_t generation,
                                      std::uint64_t seed, const Budget& budget,
                                      const std::string& rounded) {
    return std::make_unique<ModuleFigure>(system, kinds, std::move(word), generation, seed, budget,
                                          rounded);
}

namespace {

std::unique_ptr<Figure> letters_figure(const Model& system, const Word& word, std::uint64_t n,
                                       const Budget& budget, const std::string& rounded) {
    std::vector<Word> images;
    for (Symbol a = 0; a < system.alphabet.size(); ++a) images.push_back(Word{a});
    D0L rules = make_d0l(std::make_shared<const Alphabet>(system.alphabet), word, std::move(images),
                         system.name);
    return plane_figure(system, std::move(rules), 0, n, budget, rounded);
}

}  // namespace

std::unique_ptr<Figure> figure(const Model& system, DerivedModules derived, std::uint64_t n,
                               const Budget& budget) {
    if (is_plain(system) && derived.word.values.empty())
        return letters_figure(system, letters(derived.kinds, derived.word), n, budget,
                              derived.rounded);
    return module_figure(system, derived.kinds, std::move(derived.word), n, derived.seed, budget,
                         derived.rounded);
}

std::unique_ptr<Figure> figure(const Model& system, std::uint64_t n, const Budget& budget,
                               const FigureChoices& choices) {
    const bool plain = is_plain(system);
    if (const View<D0L> rules = as_d0l(system); rules && plain)
        return plane_figure(system, *rules, n, n, budget);
    const bool picked = choices.seed || !choices.tables.empty();
    if (const View<IL> rules = as_dil(system); rules && plain && !picked) {
        check_choices(system, n, choices);
        return figure(system, derive(*rules, n, budget), n, budget);
    }
    return figure(system, derived_modules(system, n, choices, budget), n, budget);
}

std::unique_ptr<Figure> figure(const Model& system, const Word& word, std::uint64_t n,
                               const Budget& budget) {
    return letters_figure(system, word, n, budget, {});
}

std::unique_ptr<Figure> figure(const Model& system, const ModuleKinds& kinds, ModuleString word,
                               std::uint64_t n, std::uint64_t seed, const Budget& budget) {
    return figure(system, DerivedModules{kinds, std::move(word), seed, {}}, n, budget);
}

std::unique_ptr<Figure> open_figure(const Model& system, std::uint64_t n, const Budget& budget,
                                    const FigureChoices& choices,
                                    std::shared_ptr<Environment> external) {
    if (!class_of(system).open) return figure(system, n, budget, choices);
    return figure(system, open_modules(system, n, choices, std::move(external), budget), n, budget);
}

}  // namespace algae
