#include "turtle/detail/scene.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "model/model.hpp"

// Scenes: what a turtle leaves in space.
//
// A SceneBuilder hears of the walk and writes down rods, polygons and solids. Each rod knows the rod at
// whose end it begins, so that pictures and meshes can join them. Of the rods that begin where one ends all
// but one are branches; that is known only when the word is over: it is the one in the fewest brackets,
// the first of those (name_branches). The boxes of shape rules become solids without any turtle.
//
// Whether figures of a system are scenes at all (leaves_plane) is decided from the letters that its words
// and interpretations may have, not from one word, so that it is the same for all generations.

namespace algae {

void SpaceBox::add(const Vector& point) {
    if (empty) {
        low = high = point;
        empty = false;
        return;
    }
    low = {std::min(low.x, point.x), std::min(low.y, point.y), std::min(low.z, point.z)};
    high = {std::max(high.x, point.x), std::max(high.y, point.y), std::max(high.z, point.z)};
}

void SpaceBox::add(const SpaceBox& box) {
    if (box.empty) return;
    add(box.low);
    add(box.high);
}

double SpaceBox::diagonal() const { return length(high - low); }

void Scene::add_face(std::span<const Vector> points, const Paint& paint) {
    if (corners.size() + points.size() > std::numeric_limits<std::uint32_t>::max())
        throw BoundReached(Bound::method, name + " has more than 2^32 corners of polygons");
    faces.push_back({static_cast<std::uint32_t>(corners.size()),
                     static_cast<std::uint32_t>(points.size()), paint});
    corners.insert(corners.end(), points.begin(), points.end());
}

SpaceBox box_of(const Solid& solid) {
    const Vector &h = solid.attitude.heading(), &l = solid.attitude.left(),
                 &u = solid.attitude.up();
    const Vector ahead = (solid.size.x / 2) * h;
    SpaceBox box;
    const auto add_around = [&](const Vector& middle, const Vector& half) {
        box.add(middle - half);
        box.add(middle + half);
    };
    // A disc across the heading reaches as far along an axis as its radius times the sine of the
    // angle between the two.
    const Vector disc =
        solid.size.y * Vector{std::hypot(l.x, u.x), std::hypot(l.y, u.y), std::hypot(l.z, u.z)};
    switch (solid.shape) {
        case SolidShape::box: {
            const Vector aside = (solid.size.y / 2) * l, above = (solid.size.z / 2) * u;
            const auto sum = [](double x, double y, double z) {
                return std::fabs(x) + std::fabs(y) + std::fabs(z);
            };
            add_around(solid.middle,
                       {sum(ahead.x, aside.x, above.x), sum(ahead.y, aside.y, above.y),
                        sum(ahead.z, aside.z, above.z)});
            break;
        }
        case SolidShape::cylinder:
            add_around(solid.middle + ahead, disc);
            add_around(solid.middle - ahead, disc);
            break;
        case SolidShape::cone:
            box.add(solid.middle + ahead);
            add_around(solid.middle - ahead, disc);
            break;
        case SolidShape::sphere:
            add_around(solid.middle, {solid.size.x, solid.size.x, solid.size.x});
            break;
    }
    return box;
}

SpaceBox box_of(const Scene& scene) {
    SpaceBox box;
    for (const Rod& rod : scene.rods) {
        box.add(rod.from);
        box.add(rod.to);
    }
    for (const Vector& corner : scene.corners) box.add(corner);
    for (const Solid& solid : scene.solids) box.add(box_of(solid));
    return box;
}

double total_length(const Scene& scene) {
    double sum = 0;
    for (const Rod& rod : scene.rods) sum += length(rod.to - rod.from);
    return sum;
}

Scene box_scene(const Model& system, const std::vector<ShapeBox>& boxes) {
    Scene out;
    out.colours = system.drawing.colours;
    out.solids.reserve(boxes.size());
    for (const ShapeBox& box : boxes) {
        const auto middle = [&](std::size_t axis) {
            return (box.origin[axis] + box.size[axis] / Rational(2)).to_double();
        };
        Solid solid;
        solid.middle = {middle(0), -middle(2), middle(1)};
        solid.size = {box.size[0].to_double(), box.size[2].to_double(), box.size[1].to_double()};
        solid.paint.index = box.symbol;
        out.solids.push_back(solid);
    }
    return out;
}

SceneBuilder::SceneBuilder(const Drawing& drawing, std::string name, std::size_t modules,
                           const Budget& budget)
    : budget_(budget), modules_(static_cast<double>(modules)) {
    scene_.name = std::move(name);
    scene_.colours = drawing.colours;
    for (const std::string& colour : drawing.colours) {
        schemes_.push_back(is_scheme(colour) ? colour : "");
        runs_along_ = runs_along_ || is_scheme(colour);
    }
}

void SceneBuilder::before(std::size_t module, const TurtleState&) {
    fraction_ = static_cast<double>(module) / modules_;
}

Paint SceneBuilder::paint_now() const {
    constexpr double hues = 256;
    if (paint_.colour || !runs_along_) return paint_;
    const std::string& scheme = schemes_[paint_.index % schemes_.size()];
    if (scheme.empty()) return paint_;
    return {paint_.index, scheme_colour(scheme, std::floor(fraction_ * hues) / hues)};
}

void SceneBuilder::check_memory() const {
    budget_.check();
    budget_.check_memory(
        scene_.rods.capacity() * sizeof(Rod) + scene_.corners.capacity() * sizeof(Vector) +
            scene_.faces.capacity() * sizeof(Face) + scene_.solids.capacity() * sizeof(Solid) +
            2 * depths_.capacity() * sizeof(std::uint32_t),
        "the scene");
}

void SceneBuilder::stroke(const Vector& from, const TurtleState& state) {
    if (scene_.rods.size() % 65536 == 0) check_memory();
    if (scene_.rods.size() == Rod::none)
        throw BoundReached(Bound::method, scene_.name + " has more than 2^32 - 1 segments");
    Rod rod;
    rod.from = from;
    rod.to = state.position;
    if (state.width.is_length)
        rod.radius = state.width.amount / 2;
    else
        rod.line_width = state.width.amount;
    rod.paint = paint_now();
    rod.before = last_;
    last_ = static_cast<std::uint32_t>(scene_.rods.size());
    scene_.rods.push_back(rod);
    depths_.push_back(static_cast<std::uint32_t>(saved_.size()));
}

void SceneBuilder::returned(const TurtleState&) {
    last_ = saved_.back();
    saved_.pop_back();
}

void SceneBuilder::polygon(std::span<const Vector> corners) {
    if (scene_.faces.size() % 65536 == 0) check_memory();
    scene_.add_face(corners, paint_now());
}

void SceneBuilder::solid(SolidShape shape, const Vector& size, const TurtleState& state) {
    if (scene_.solids.size() % 65536 == 0) check_memory();
    scene_.solids.push_back({shape, state.position, state.attitude, size, paint_now()});
}

void SceneBuilder::name_branches() {
    std::vector<std::uint32_t> next(scene_.rods.size(), Rod::none);  // the one that goes on
    for (std::uint32_t i = 0; i < scene_.rods.size(); ++i) {
        const std::uint32_t before = scene_.rods[i].before;
        if (before == Rod::none) continue;
        if (next[before] == Rod::none || depths_[i] < depths_[next[before]]) next[before] = i;
    }
    for (std::uint32_t i = 0; i < scene_.rods.size(); ++i) {
        Rod& rod = scene_.rods[i];
        rod.branch = rod.before != Rod::none && next[rod.before] != i;
    }
}

Scene SceneBuilder::finished() {
    check_memory();
    name_branches();
    return std::move(scene_);
}

ViewChoices view_choices(const Drawing& drawing) {
    ViewChoices choices;
    if (const auto& camera = drawing.camera) {
        choices.camera = {camera->from.azimuth.value, camera->from.elevation.value,
                          camera->perspective};
        if (camera->opening) choices.camera.opening = camera->opening->value;
    }
    if (const auto& light = drawing.light)
        choices.light = Light{light->azimuth.value, light->elevation.value};
    if (drawing.fog) choices.fog = drawing.fog->value;
    return choices;
}

FigureStyle style_of(const Drawing& drawing) {
    return {drawing.colours, drawing.width, drawing.narrow};
}

namespace {

/// Whether the turtle leaves the plane for a symbol that interpretations leave alone.
bool leaves_plane(const Model& system, Symbol symbol) {
    const Drawing& drawing = system.drawing;
    for (const SolidSetting& solid : drawing.solids)
        if (solid.symbol == symbol) return true;
    for (const SurfaceSetting& surface : drawing.surfaces)
        if (surface.symbol == symbol) return !is_flat(surface);
    return turns_out_of_plane(system.alphabet.name(symbol));
}

/// Whether a symbol of `plot` is written with three coordinates.
bool plots_in_space(const Model& system) {
    const auto& plotters = system.drawing.plotters;
    const auto plots = [&](const ModuleWord& word) {
        return std::any_of(word.arguments.begin(), word.arguments.end(), [&](const auto& module) {
            const Symbol symbol = word.letters[module.first];
            return module.second.size() == 3 &&
                   std::count(plotters.begin(), plotters.end(), symbol) > 0;
        });
    };
    if (plotters.empty()) return false;
    if (plots(system.axiom)) return true;
    for (const auto* all : {&system.rules, &system.interpretation})
        for (const Production& rule : *all)
            if (plots(rule.successor)) return true;
    return false;
}

/// The letters that words and what the turtle makes of them may have.
std::vector<Symbol> walked_letters(const LSystem& system) {
    std::map<Symbol, std::vector<const Production*>> rules;
    for (const auto* all : {&system.rules, &system.interpretation})
        for (const Production& rule : *all) rules[rule.predecessor.symbol].push_back(&rule);
    // A word that is a parameter or comes from a system within may have any letter.
    if (holds_words(system)) {
        std::vector<Symbol> every(system.alphabet.size());
        for (Symbol a = 0; a < every.size(); ++a) every[a] = a;
        return every;
    }
    return accessible(system.axiom.letters, system.alphabet.size(), [&](Symbol a, auto see) {
        const auto found = rules.find(a);
        if (found == rules.end()) return;
        for (const Production* rule : found->second) see(rule->successor.letters);
    });
}

/// Whether something else stands for a symbol wherever the turtle meets it, so that it never does what is usual.
bool is_always_interpreted(const LSystem& system, Symbol symbol) {
    const auto stands_for_all = [&](const Production& rule) {
        return rule.predecessor.symbol == symbol && rule.predecessor.parameters.empty() &&
               rule.left.empty() && rule.right.empty() && rule.elsewhere.empty() &&
               !rule.condition && !rule.probability;
    };
    const auto has_numbers = [&](const ModuleWord& word) {
        return std::ranges::any_of(word.arguments, [&](const auto& module) {
            return word.letters[module.first] == symbol;
        });
    };
    if (std::ranges::none_of(system.interpretation, stands_for_all) || has_numbers(system.axiom))
        return false;
    for (const auto* all : {&system.rules, &system.interpretation})
        for (const Production& rule : *all)
            if (has_numbers(rule.successor)) return false;
    return true;
}

}  // namespace

bool leaves_plane(const Model& system) {
    if (system.drawing.tropism && system.drawing.tropism->z.value != 0) return true;
    if (plots_in_space(system) || class_of(system).shape) return true;
    const std::vector<Symbol> letters = walked_letters(system);
    return std::any_of(letters.begin(), letters.end(), [&](Symbol symbol) {
        return leaves_plane(system, symbol) && !is_always_interpreted(system, symbol);
    });
}

SpaceDerivation scene(const Model& system, std::uint64_t n, const Budget& budget,
                      const FigureChoices& choices, std::shared_ptr<Environment> external) {
    if (class_of(system).shape) {
        const View<ShapeSystem> shapes = as_shape(system);
        SpaceDerivation out;
        out.scene = box_scene(system, boxes_after(*shapes, shapes->axiom, n, budget));
        out.scene.name = figure_name(system, n);
        out.facts.box = box_of(out.scene);
        return out;
    }
    const DerivedModules derived = open_modules(system, n, choices, std::move(external), budget);
    SpaceDerivation out = scene(system, derived.kinds, derived.word, n, derived.seed, budget);
    out.facts.rounded = derived.rounded;
    return out;
}

SpaceDerivation scene(const Model& system, const ModuleKinds& kinds, const ModuleString& word,
                      std::uint64_t n, std::uint64_t seed, const Budget& budget) {
    const ModuleTurtle turtle(system, kinds, n, seed);
    SceneBuilder builder(system.drawing, turtle.name(), word.kinds.size(), budget);
    SpaceDerivation out;
    out.end = turtle.walk(word, builder, budget);
    out.scene = builder.finished();
    out.facts.segments = out.scene.rods.size();
    out.facts.length = total_length(out.scene);
    out.facts.box = box_of(out.scene);
    out.facts.step = std::fabs(turtle.start().step);
    for (const Rod& rod : out.scene.rods)
        if (const double size = length(rod.to - rod.from); size > 0)
            out.facts.step = std::min(out.facts.step, size);
    // Rounding over a long walk is far less than a millionth of this.
    out.facts.step = std::max(out.facts.step, out.facts.box.diagonal() * 1e-5);
    return out;
}

}  // namespace algae
