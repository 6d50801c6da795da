#include "space/partial_view.hpp"

#include <algorithm>

#include "space/scene_builder.hpp"
#include "space/space_figure.hpp"
#include "turtle/watched_walk.hpp"

namespace algae {

namespace {

/// Builds what comes of the first symbols of a word.
class PartBuilder : public SceneBuilder {
public:
    PartBuilder(const Settings& settings, const ModuleTurtle& turtle, std::size_t modules,
                std::size_t part, const Budget& budget)
        : SceneBuilder(settings, turtle.name(), modules, budget), part_(part) {}

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
    LSystem system;
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

class PartialView : public Figure {
public:
    PartialView(std::shared_ptr<const Stage> stage, std::size_t part, const TurtleState& turtle)
        : stage_(std::move(stage)), part_(part), turtle_(turtle) {}

    const Box& box() const override { return stage_->room; }
    const Integer& segments() const override { return stage_->whole->segments(); }
    const Facts& facts() const override { return stage_->whole->facts(); }
    std::optional<std::uint64_t> strokes() const override { return stage_->whole->strokes(); }
    const Settings& settings() const override { return stage_->whole->settings(); }
    bool is_layered() const override { return true; }
    std::optional<Point> place(const Vector& point) const override {
        return stage_->whole->place(point);
    }
    bool has_scale() const override { return stage_->whole->has_scale(); }
    void draw(Canvas& canvas, double resolution, const Budget& budget) const override {
        const Stage& stage = *stage_;
        const ModuleTurtle turtle(stage.system, stage.derived.kinds, stage.n, stage.derived.seed);
        PartBuilder builder(stage.system.settings, turtle, stage.derived.word.kinds.size(), part_,
                            budget);
        turtle.walk(stage.derived.word, builder, budget);
        Scene part = builder.finished();
        add_turtle(part, turtle_, stage.size);
        SpaceView(std::move(part), stage.system.settings, {}, stage.choices, budget)
            .draw(canvas, resolution, budget);
    }

private:
    std::shared_ptr<const Stage> stage_;
    std::size_t part_;
    TurtleState turtle_;
};

}  // namespace

std::vector<std::unique_ptr<Figure>> partial_views(const LSystem& system,
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
    const WatchedWalk watched = watched_walk(turtle, derived.word, symbols, budget);

    // The camera and the gaps are those of the whole, with the turtle in it.
    SpaceBox room = box_of(all.scene);
    room.add(watched.low);
    room.add(watched.high);
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
    stage->whole = std::make_unique<SpaceView>(std::move(all.scene), system.settings,
                                               SceneFacts{all.end.position, all.facts.step},
                                               stage->choices, budget);
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

}  // namespace algae
