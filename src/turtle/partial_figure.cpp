#include "turtle/turtle.hpp"

#include <algorithm>
#include <cmath>

#include "model/model.hpp"
#include "turtle/detail/scene.hpp"

// Figures as far as a turtle has come, with the turtle where it is: the frames of a film of the walk.
//
// All frames have one box, that of the whole figure and of every place of the turtle, so that nothing
// moves from frame to frame. In the plane a frame draws the whole figure on a canvas that lets through
// what comes before a share of the word. In space a frame builds the scene of the first symbols anew, so
// that there is memory for two scenes at a time, and looks at it with the camera of the whole.
//
// The frames of a turntable show one scene from several sides. Boxes of one size around the middle of the scene keep it in its place.

namespace algae {

namespace {

/// Sees a turtle after some numbers of symbols, which rise (0 is its start), and the box around all
/// places where it comes to a symbol.
class Watcher : public TurtleEvents {
public:
    /// Walks the whole word. Linear in its length.
    Watcher(const ModuleTurtle& turtle, const ModuleString& word,
            const std::vector<std::size_t>& symbols, const Budget& budget)
        : symbols_(symbols) {
        room.add(turtle.start().position);
        const TurtleState end = turtle.walk(word, *this, budget);
        room.add(end.position);
        states.resize(symbols.size(), end);
    }
    void before(std::size_t module, const TurtleState& state) override {
        room.add(state.position);
        if (states.size() < symbols_.size() && symbols_[states.size()] == module)
            states.push_back(state);
    }
    bool wants_modules() const override { return true; }

    std::vector<TurtleState> states;
    SpaceBox room;

private:
    const std::vector<std::size_t>& symbols_;
};

/// The turtle where it is, and of the whole figure what all its frames have in common.
class Frame : public Figure {
public:
    const Integer& segments() const override { return whole().segments(); }
    const Facts& facts() const override { return whole().facts(); }
    std::optional<std::uint64_t> strokes() const override { return whole().strokes(); }
    const FigureStyle& style() const override { return whole().style(); }
    bool is_layered() const override { return whole().is_layered(); }
    std::optional<Point> place(const Vector& point) const override { return whole().place(point); }
    bool has_scale() const override { return whole().has_scale(); }

protected:
    explicit Frame(const TurtleState& turtle) : turtle_(turtle) {}
    virtual const Figure& whole() const = 0;

    TurtleState turtle_;
};

/// Passes on what comes before a part of the word.
class CutCanvas : public Canvas {
public:
    CutCanvas(Canvas& canvas, double part) : canvas_(canvas), part_(part) {}

    void move_to(Point point) override { canvas_.move_to(point); }
    void line_to(Point point) override {
        if (open_) canvas_.line_to(point);
    }
    void polygon(std::span<const Point> corners) override {
        if (open_) canvas_.polygon(corners);
    }
    void width(double factor) override { canvas_.width(factor); }
    void width_as_length(double length) override { canvas_.width_as_length(length); }
    void colour(std::uint32_t index) override { canvas_.colour(index); }
    void paint(const Colour& colour) override { canvas_.paint(colour); }
    void position(double fraction) override {
        open_ = fraction < part_;
        if (open_ && canvas_.wants_position()) canvas_.position(fraction);
    }
    bool wants_position() const override { return true; }
    double line_width() const override { return canvas_.line_width(); }

private:
    Canvas& canvas_;
    double part_;
    bool open_ = true;
};

/// A figure in the plane as far as a turtle has come.
class PartialFigure : public Frame {
public:
    /// What is drawn before this part of the word, from 0 to 1. `room` holds every part of the whole
    /// figure, and the turtle wherever it is.
    PartialFigure(std::shared_ptr<const Figure> whole, double part, const TurtleState& turtle,
                  double size, const Box& room)
        : Frame(turtle), whole_(std::move(whole)), part_(part), size_(size), room_(room) {}

    const Box& box() const override { return room_; }
    void draw(Canvas& canvas, double resolution, const Budget& budget) const override {
        CutCanvas cut(canvas, part_);
        whole_->draw(cut, resolution, budget);
        const auto glyph = [&](double size, const Colour& colour) {
            std::vector<Point> corners;
            for (const Vector& corner : turtle_glyph(turtle_, size))
                corners.push_back({corner.x, corner.y});
            canvas.paint(colour);
            canvas.polygon(corners);
        };
        glyph(1.35 * size_, {1, 1, 1});  // so that it is seen on lines
        glyph(size_, turtle_green);
    }

private:
    const Figure& whole() const override { return *whole_; }

    std::shared_ptr<const Figure> whole_;
    double part_, size_;
    Box room_;
};

/// Builds what comes of the first symbols of a word.
class PartBuilder : public SceneBuilder {
public:
    PartBuilder(const Drawing& drawing, const ModuleTurtle& turtle, std::size_t modules,
                std::size_t part, const Budget& budget)
        : SceneBuilder(drawing, turtle.name(), modules, budget), part_(part) {}

    void before(std::size_t module, const TurtleState& state) override {
        open_ = module < part_;
        SceneBuilder::before(module, state);
    }
    bool wants_modules() const override { return true; }
    void stroke(const Vector& from, const TurtleState& state) override {
        if (open_) SceneBuilder::stroke(from, state);
    }
    void polygon(std::span<const Vector> corners) override {
        if (open_) SceneBuilder::polygon(corners);
    }
    void solid(SolidShape shape, const Vector& size, const TurtleState& state) override {
        if (open_) SceneBuilder::solid(shape, size, state);
    }

private:
    std::size_t part_;
    bool open_ = false;
};

/// What all parts have in common.
struct Stage {
    Model system;
    DerivedModules derived;
    std::uint64_t n = 0;
    ViewChoices choices;
    std::unique_ptr<SpaceView> whole;
    Box room;
    double size = 0;  // of the turtle
};

/// Two crossed arrowheads, so that the turtle is seen from everywhere.
void add_turtle(Scene& scene, TurtleState turtle, double size) {
    const Paint paint{0, turtle_green};
    for (int upright = 0; upright < 2; ++upright) {
        const std::vector<Vector> at = turtle_glyph(turtle, size);
        scene.add_face(std::vector{at[0], at[1], at[2]}, paint);
        scene.add_face(std::vector{at[0], at[2], at[3]}, paint);
        turtle.attitude.roll(turn_by(90));
    }
}

/// A figure in space as far as a turtle has come, made anew when it is drawn.
class PartialView : public Frame {
public:
    PartialView(std::shared_ptr<const Stage> stage, std::size_t part, const TurtleState& turtle)
        : Frame(turtle), stage_(std::move(stage)), part_(part) {}

    const Box& box() const override { return stage_->room; }
    void draw(Canvas& canvas, double resolution, const Budget& budget) const override {
        const Stage& stage = *stage_;
        const ModuleTurtle turtle(stage.system, stage.derived.kinds, stage.n, stage.derived.seed);
        PartBuilder builder(stage.system.drawing, turtle, stage.derived.word.kinds.size(), part_,
                            budget);
        turtle.walk(stage.derived.word, builder, budget);
        Scene part = builder.finished();
        add_turtle(part, turtle_, stage.size);
        SpaceView(std::move(part), style_of(stage.system.drawing), {}, stage.choices, budget)
            .draw(canvas, resolution, budget);
    }

private:
    const Figure& whole() const override { return *stage_->whole; }

    std::shared_ptr<const Stage> stage_;
    std::size_t part_;
};

/// A scene from one of several sides, made anew when it is drawn.
class TurnedView : public Figure {
public:
    TurnedView(std::shared_ptr<const SpaceView> whole, SceneFacts facts, ViewChoices choices,
               const Box& box)
        : whole_(std::move(whole)),
          about_(std::move(facts)),
          choices_(std::move(choices)),
          projection_(choices_.camera, box_of(whole_->scene())),
          box_(box) {}

    const Box& box() const override { return box_; }
    const Integer& segments() const override { return whole_->segments(); }
    const Facts& facts() const override { return whole_->facts(); }
    std::optional<std::uint64_t> strokes() const override { return whole_->strokes(); }
    const FigureStyle& style() const override { return whole_->style(); }
    bool is_layered() const override { return true; }
    bool has_scale() const override { return whole_->has_scale(); }
    std::optional<Point> place(const Vector& point) const override {
        const Seen seen = projection_(point);
        if (!std::isfinite(seen.x + seen.y) || !(seen.scale > 0)) return std::nullopt;
        return Point{seen.x, seen.y};
    }
    void draw(Canvas& canvas, double resolution, const Budget& budget) const override {
        SpaceView(whole_->scene(), whole_->style(), about_, choices_, budget)
            .draw(canvas, resolution, budget);
    }

private:
    std::shared_ptr<const SpaceView> whole_;
    SceneFacts about_;
    ViewChoices choices_;
    Projection projection_;
    Box box_;
};

}  // namespace

std::vector<Vector> turtle_glyph(const TurtleState& turtle, double size) {
    const Vector ahead = (size / 2) * turtle.attitude.heading();
    const Vector aside = (size * 0.36) * turtle.attitude.left();
    const Vector& at = turtle.position;
    return {at + ahead, at - ahead + aside, at - 0.55 * ahead, at - ahead - aside};
}

std::vector<std::size_t> frames_of_progress(std::size_t symbols, std::size_t most) {
    const std::size_t steps = std::max<std::size_t>(most, 2) - 1;
    const std::size_t stride = std::max<std::size_t>(1, (symbols + steps - 1) / steps);
    std::vector<std::size_t> found;
    for (std::size_t at = 0; at < symbols; at += stride) found.push_back(at);
    found.push_back(symbols);
    return found;
}

std::vector<std::unique_ptr<Figure>> partial_figures(const Model& system,
                                                     const DerivedModules& derived, std::uint64_t n,
                                                     const std::vector<std::size_t>& symbols,
                                                     const Budget& budget) {
    const std::shared_ptr<const Figure> whole =
        figure(system, derived.kinds, derived.word, n, derived.seed, budget);
    const ModuleTurtle turtle(system, derived.kinds, n, derived.seed);
    const Watcher watched(turtle, derived.word, symbols, budget);
    const std::size_t length = derived.word.kinds.size();
    Box room = whole->box();
    room.add(Point{watched.room.low.x, watched.room.low.y});
    room.add(Point{watched.room.high.x, watched.room.high.y});
    double size = 0.04 * std::max(room.breadth(), room.height());
    if (size == 0) size = std::abs(turtle.start().step);
    room.add(Point{room.low.x - 0.7 * size, room.low.y - 0.7 * size});
    room.add(Point{room.high.x + 0.7 * size, room.high.y + 0.7 * size});
    std::vector<std::unique_ptr<Figure>> figures;
    for (std::size_t i = 0; i < symbols.size(); ++i) {
        // As canvases are told: the symbols before, as a part of all.
        const double part = symbols[i] >= length
                                ? 2
                                : static_cast<double>(symbols[i]) / static_cast<double>(length);
        figures.push_back(
            std::make_unique<PartialFigure>(whole, part, watched.states[i], size, room));
    }
    return figures;
}

std::vector<std::unique_ptr<Figure>> partial_views(const Model& system,
                                                   const DerivedModules& derived, std::uint64_t n,
                                                   const std::vector<std::size_t>& symbols,
                                                   const ViewChoices& choices,
                                                   const Budget& budget) {
    const auto stage = std::make_shared<Stage>();
    stage->system = system;
    stage->derived = derived;
    stage->n = n;
    stage->choices = choices;
    SpaceDerivation all = scene(system, derived.kinds, derived.word, n, derived.seed, budget);
    const ModuleTurtle turtle(system, derived.kinds, n, derived.seed);
    const Watcher watched(turtle, derived.word, symbols, budget);

    // The camera and the gaps are those of the whole, with the turtle in it.
    SpaceBox room = box_of(all.scene);
    room.add(watched.room);
    const Vector across = room.high - room.low;
    stage->size = 0.05 * std::max({across.x, across.y, across.z});
    if (stage->size == 0) stage->size = all.facts.step;
    double radius = 0.6 * stage->size;
    bool branches = false;
    for (const Rod& rod : all.scene.rods) {
        radius = std::max(radius, rod.radius);
        branches = branches || rod.branch;
    }
    const Vector around{radius, radius, radius};
    const Vector low = room.low - around, high = room.high + around;
    room.add(low);
    room.add(high);
    stage->choices.sight = room;
    if (!stage->choices.gap) stage->choices.gap = branches ? 0 : 1;
    stage->whole = std::make_unique<SpaceView>(
        std::move(all.scene), style_of(system.drawing),
        SceneFacts{all.end.position, all.facts.step, all.facts.rounded}, stage->choices, budget);
    stage->room = stage->whole->box();
    for (TurtleState state : watched.states)
        for (int upright = 0; upright < 2; ++upright) {
            for (const Vector& corner : turtle_glyph(state, stage->size))
                if (const auto at = stage->whole->place(corner)) stage->room.add(*at);
            state.attitude.roll(turn_by(90));
        }
    // What is left of lines and gaps around them at the edge.
    const double edge = 0.2 * stage->size;
    stage->room.add(Point{stage->room.low.x - edge, stage->room.low.y - edge});
    stage->room.add(Point{stage->room.high.x + edge, stage->room.high.y + edge});
    std::vector<std::unique_ptr<Figure>> figures;
    for (std::size_t i = 0; i < symbols.size(); ++i)
        figures.push_back(std::make_unique<PartialView>(stage, symbols[i], watched.states[i]));
    return figures;
}

std::vector<std::unique_ptr<Figure>> turned_views(const SpaceDerivation& derivation,
                                                  const FigureStyle& style,
                                                  const ViewChoices& choices,
                                                  const std::vector<Camera>& cameras,
                                                  const Budget& budget) {
    const SceneFacts facts{derivation.end.position, derivation.facts.step,
                           derivation.facts.rounded};
    const SpaceBox around = box_of(derivation.scene);
    const Vector middle = around.empty ? Vector{} : 0.5 * (around.low + around.high);
    std::shared_ptr<const SpaceView> whole;
    std::vector<ViewChoices> each;
    std::vector<Point> middles;
    double wide = 0, high = 0;  // halves of the boxes
    for (const Camera& camera : cameras) {
        budget.check();
        ViewChoices& own = each.emplace_back(choices);
        own.camera = camera;
        const auto view = std::make_shared<SpaceView>(derivation.scene, style, facts, own, budget);
        const Point at = view->place(middle).value_or(Point{});
        const Box& box = view->box();
        if (!box.empty) {
            wide = std::max({wide, box.high.x - at.x, at.x - box.low.x});
            high = std::max({high, box.high.y - at.y, at.y - box.low.y});
        }
        middles.push_back(at);
        if (!whole) whole = view;
    }
    std::vector<std::unique_ptr<Figure>> figures;
    for (std::size_t i = 0; i < each.size(); ++i) {
        Box box;
        if (!whole->box().empty) {
            box.add(Point{middles[i].x - wide, middles[i].y - high});
            box.add(Point{middles[i].x + wide, middles[i].y + high});
        }
        figures.push_back(std::make_unique<TurnedView>(whole, facts, each[i], box));
    }
    return figures;
}

}  // namespace algae
