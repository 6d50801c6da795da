// Figures for Python: points and segments as arrays, pictures as bytes, trees, meshes, dimensions.
//
// A turtle sends its strokes to a canvas that writes their coordinates one after the other into a vector, which then becomes the memory
// of a numpy array: nothing is copied, and nothing of Python is touched while the turtle walks. Pictures are drawn into a string
// in the formats of the command.

#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>

#include "dimension/dimension.hpp"
#include "language/language.hpp"
#include "notation/notation.hpp"
#include "python/detail/running.hpp"
#include "python/detail/values.hpp"
#include "render/render.hpp"
#include "report/report.hpp"
#include "turtle/turtle.hpp"

namespace algae::python {

namespace {

/// Which word of a system is drawn, and as what.
struct Shown {
    std::uint64_t first = 0, last = 0;
    std::optional<std::uint64_t> seed;
    std::string tables;
};

FigureChoices choices_of(const SystemObject& system, const Shown& shown) {
    FigureChoices found;
    found.seed = shown.seed;
    if (!found.seed && system->drawing.seeds) found.seed = system->drawing.seeds->first;
    if (!shown.tables.empty()) found.tables = table_sequence(system->tables, shown.tables);
    found.random_tables = shown.seed.has_value();
    if (!found.seed && found.tables.empty()) {
        if (const View<D0L> rules = as_d0l(*system); !rules && as_ol(*system))
            throw Error(rules.reason() + "; say seed=S to draw one word picked at random");
        if (leaves_tables_open(*system))
            throw Error("it has " + std::to_string(system->tables.size()) +
                        " tables and no schedule; say tables='...', or seed=S for random ones");
    }
    return found;
}

/// The figure of a generation in the plane, or what a camera sees of it.
std::unique_ptr<Figure> figure_of(const Model& model, std::uint64_t n, const FigureChoices& choices,
                                  const ViewChoices& view, const Budget& budget) {
    if (!leaves_plane(model)) return open_figure(model, n, budget, choices);
    SpaceDerivation found = scene(model, n, budget, choices);
    return std::make_unique<SpaceView>(
        std::move(found.scene), style_of(model.drawing),
        SceneFacts{found.end.position, found.facts.step, found.facts.rounded}, view, budget);
}

// Points and segments

/// The strokes of a figure: points, and where each run of points begins.
class Points : public Canvas {
public:
    explicit Points(const Budget& budget) : budget_(budget) {}

    void move_to(Point point) override {
        begins.push_back(static_cast<std::int64_t>(coordinates.size() / 2));
        add(point);
    }
    void line_to(Point point) override { add(point); }
    void polygon(std::span<const Point>) override {}

    std::vector<double> coordinates;
    std::vector<std::int64_t> begins;

private:
    void add(Point point) {
        if (coordinates.size() == coordinates.capacity())
            budget_.check_memory(coordinates.size() * 3 * sizeof(double), "the points");
        coordinates.push_back(point.x);
        coordinates.push_back(point.y);
    }
    const Budget& budget_;
};

/// Each stroke by both of its ends.
class Segments : public Canvas {
public:
    explicit Segments(const Budget& budget) : budget_(budget) {}

    void move_to(Point point) override { here_ = point; }
    void line_to(Point point) override {
        if (coordinates.size() == coordinates.capacity())
            budget_.check_memory(coordinates.size() * 3 * sizeof(double), "the segments");
        const double stroke[] = {here_.x, here_.y, point.x, point.y};
        coordinates.insert(coordinates.end(), std::begin(stroke), std::end(stroke));
        here_ = point;
    }
    void polygon(std::span<const Point>) override {}

    std::vector<double> coordinates;

private:
    const Budget& budget_;
    Point here_;
};

/// A first guess of how many strokes come, so that memory is asked for once.
std::size_t expected_strokes(const Figure& figure, const Budget& budget) {
    const auto strokes = figure.strokes();
    return static_cast<std::size_t>(
        std::min<std::uint64_t>(strokes.value_or(0), budget.memory / 128));
}

void refuse_space(const SystemObject& system, const char* instead) {
    if (leaves_plane(*system)) throw Error(system->name + " leaves the plane; " + instead);
}

py::tuple points(const SystemObject& system, const Shown& shown, const Limits& limits) {
    refuse_space(system, "segments(n) gives its strokes in space, mesh(n) its surface");
    const FigureChoices choices = choices_of(system, shown);
    auto found = run(limits, [&](const Budget& budget) {
        const auto figure = open_figure(*system, shown.last, budget, choices);
        Points canvas(budget);
        canvas.coordinates.reserve(2 * (expected_strokes(*figure, budget) + 1));
        figure->draw(canvas, 0, budget);
        return std::pair(std::move(canvas.coordinates), std::move(canvas.begins));
    });
    const auto count = static_cast<py::ssize_t>(found.first.size() / 2);
    return py::make_tuple(as_array(std::move(found.first), {count, 2}),
                          as_array(std::move(found.second)));
}

py::array segments(const SystemObject& system, const Shown& shown, const Limits& limits) {
    const FigureChoices choices = choices_of(system, shown);
    const bool in_space = leaves_plane(*system);
    std::vector<double> found = run(limits, [&](const Budget& budget) {
        if (in_space) {
            const SpaceDerivation walked = scene(*system, shown.last, budget, choices);
            std::vector<double> all;
            all.reserve(walked.scene.rods.size() * 6);
            for (const Rod& rod : walked.scene.rods)
                for (const Vector& end : {rod.from, rod.to})
                    for (const double value : {end.x, end.y, end.z}) all.push_back(value);
            return all;
        }
        const auto figure = open_figure(*system, shown.last, budget, choices);
        Segments canvas(budget);
        canvas.coordinates.reserve(4 * expected_strokes(*figure, budget));
        figure->draw(canvas, 0, budget);
        return std::move(canvas.coordinates);
    });
    const py::ssize_t dimensions = in_space ? 3 : 2;
    const auto count = static_cast<py::ssize_t>(found.size()) / (2 * dimensions);
    return as_array(std::move(found), {count, 2, dimensions});
}

py::dict mesh_arrays(const SystemObject& system, const Shown& shown, unsigned facets,
                     const Limits& limits) {
    const FigureChoices choices = choices_of(system, shown);
    struct Found {
        std::vector<double> points, normals;
        std::vector<std::uint32_t> triangles;
    };
    Found found = run(limits, [&](const Budget& budget) {
        MeshOptions options;
        options.facets = facets;
        const Mesh mesh =
            mesh_of(scene(*system, shown.last, budget, choices).scene, options, budget);
        Found result;
        result.points.reserve(3 * mesh.corners.size());
        result.normals.reserve(3 * mesh.corners.size());
        for (std::uint32_t i = 0; i < mesh.corners.size(); ++i)
            for (const auto& [to, from] : {std::pair(&result.points, mesh.place(i)),
                                           std::pair(&result.normals, mesh.corners[i].normal)})
                for (const double value : {from.x, from.y, from.z}) to->push_back(value);
        result.triangles.reserve(3 * mesh.triangles.size());
        for (const Mesh::Triangle& triangle : mesh.triangles)
            result.triangles.insert(result.triangles.end(), triangle.begin(), triangle.end());
        return result;
    });
    const auto corners = static_cast<py::ssize_t>(found.points.size() / 3);
    const auto triangles = static_cast<py::ssize_t>(found.triangles.size() / 3);
    py::dict out;
    out["points"] = as_array(std::move(found.points), {corners, 3});
    out["normals"] = as_array(std::move(found.normals), {corners, 3});
    out["triangles"] = as_array(std::move(found.triangles), {triangles, 3});
    return out;
}

// Pictures

/// What a caller of `draw` may say of a picture; what is absent is as the file says.
struct Wishes {
    std::optional<double> width, height, margin, line_width, font_size, frame_time;
    std::vector<std::string> colours;
    std::optional<std::string> background;
    std::string caption;
    bool captions = false, scale_bar = false, common_scale = false, panels = false;
    std::optional<std::tuple<double, double, bool, double>> camera;
    unsigned facets = 8;
};

PictureOptions options_of(const Wishes& wishes, const Model& model) {
    PictureOptions options;
    options.width = wishes.width;
    options.height = wishes.height;
    if (wishes.margin) options.margin = *wishes.margin;
    options.line_width = wishes.line_width;
    options.font_size = wishes.font_size;
    options.colours = wishes.colours;
    options.background = wishes.background;
    options.scale_bar = wishes.scale_bar;
    options.common_scale = wishes.common_scale;
    options.title = model.title;
    options.source = model.source;
    for (const Drawing::Label& label : model.drawing.labels)
        options.labels.push_back(
            {label.text, {label.place.x.value, label.place.y.value, label.place.z.value}});
    return options;
}

ViewChoices view_of(const Wishes& wishes, const Model& model) {
    ViewChoices view = view_choices(model.drawing);
    if (wishes.camera) {
        const auto& [azimuth, elevation, perspective, opening] = *wishes.camera;
        view.camera = {azimuth, elevation, perspective, opening};
        check_camera(view.camera);
    }
    if (wishes.background && *wishes.background != "transparent")
        view.background = colour_named(*wishes.background);
    return view;
}

/// The letters of a word by their positions, for formats that say them.
struct Letters {
    DerivedModules derived;
    std::vector<std::string> names;  // by kind
};

std::vector<double> numbers(const std::vector<Coordinate>& coordinates) {
    std::vector<double> values;
    for (const Coordinate& coordinate : coordinates) values.push_back(coordinate.value());
    return values;
}

/// Why parameters of a figure are doubles: None where they are exact.
Json rounding_json(const std::string& reason) {
    return reason.empty() ? Json(nullptr) : Json(reason);
}

Json facts_json(const Facts& facts, std::uint64_t generation,
                const std::optional<std::uint64_t>& seed) {
    Json one{{"generation", generation}};
    if (seed) one.set("seed", *seed);
    one.set("segments", facts.segments);
    one.set("bounding_box", {{"min", numbers(facts.low)}, {"max", numbers(facts.high)}});
    one.set("end", numbers(facts.end));
    one.set("exact", facts.exact);
    one.set("rounded", rounding_json(facts.rounded));
    return one;
}

/// The figures of the generations, and what they are called.
class Plates {
public:
    Plates(const SystemObject& system, const Shown& shown, const FigureChoices& choices,
           const Wishes& wishes, const Budget& budget)
        : model_(*system) {
        if (!wishes.colours.empty()) model_.drawing.colours = wishes.colours;
        const ViewChoices view = view_of(wishes, model_);
        for (std::uint64_t n = shown.first; n <= shown.last; ++n) {
            figures_.push_back(figure_of(model_, n, choices, view, budget));
            const std::string title = model_.title.empty() ? model_.name : model_.title;
            std::string caption = wishes.caption;
            if (wishes.captions && caption.empty()) caption = title + ", n = " + std::to_string(n);
            plates.push_back({figures_.back().get(),
                              "generation " + std::to_string(n) + " of " + model_.name, caption});
            facts.push_back(facts_json(figures_.back()->facts(), n, choices.seed));
        }
    }

    std::vector<Plate> plates;
    std::vector<Json> facts;

private:
    Model model_;
    std::vector<std::unique_ptr<Figure>> figures_;
};

/// The letters of the words, where they are few enough to be kept.
std::vector<FigureSource> sources_of(const SystemObject& system, const Plates& all,
                                     std::uint64_t first, const FigureChoices& choices,
                                     std::vector<std::shared_ptr<Letters>>& kept,
                                     const Budget& budget) {
    std::vector<FigureSource> sources;
    for (const Plate& plate : all.plates) {
        FigureSource& source = sources.emplace_back();
        source.plate = plate;
        source.generation = first + sources.size() - 1;
        if (plate.figure->is_layered()) continue;
        try {
            auto letters = std::make_shared<Letters>();
            letters->derived = open_modules(*system, source.generation, choices, nullptr, budget);
            const ModuleKinds& kinds = letters->derived.kinds;
            for (std::size_t kind = 0; kind < kinds.size(); ++kind)
                letters->names.push_back(
                    system->alphabet.name(kinds.letter(static_cast<ModuleKind>(kind))));
            source.modules = letters->derived.word.kinds.size();
            source.letter = [letters = letters.get()](std::uint64_t at) -> std::string_view {
                return letters->names[letters->derived.word.kinds[static_cast<std::size_t>(at)]];
            };
            kept.push_back(std::move(letters));
        } catch (const BoundReached& bound) {
            if (bound.bound() == Bound::time) throw;
        }
    }
    return sources;
}

/// A page of HTML that turns figures in space, one for each generation.
std::pair<std::string, std::vector<Json>> drawn_to_turn(const SystemObject& system,
                                                        const Shown& shown,
                                                        const FigureChoices& choices,
                                                        const Wishes& wishes,
                                                        const Budget& budget) {
    MeshChoices how;
    how.mesh.facets = wishes.facets;
    how.colours = wishes.colours;
    how.background = wishes.background;
    how.camera = view_of(wishes, *system).camera;
    std::vector<Scene> scenes;
    std::vector<NamedScene> named;
    std::vector<Json> facts;
    for (std::uint64_t n = shown.first; n <= shown.last; ++n) {
        SpaceDerivation found = scene(*system, n, budget, choices);
        scenes.push_back(std::move(found.scene));
        facts.push_back(Json{{"generation", n},
                             {"segments", scenes.back().rods.size()},
                             {"parts", scenes.back().parts()},
                             {"rounded", rounding_json(found.facts.rounded)}});
    }
    for (const Scene& one : scenes)
        named.push_back({&one, "generation " + std::to_string(shown.first + named.size()) + " of " +
                                   system->name});
    std::ostringstream out;
    draw_scene_page(named, out, how, options_of(wishes, *system), budget);
    return {out.str(), std::move(facts)};
}

/// The bytes of a picture in a format, and what is known of its figures.
py::tuple draw(const SystemObject& system, const Shown& shown, const Wishes& wishes,
               const std::string& format, const Limits& limits) {
    const FigureChoices choices = choices_of(system, shown);
    const std::string named = "figure." + format;
    const auto mesh = mesh_format(named);
    const auto text = figure_format(named);
    const auto animation = animation_format(named);
    const PictureFormat picture =
        mesh || text || animation ? PictureFormat::svg : picture_format(named);
    const bool is_single = shown.first == shown.last;
    if (mesh && !is_single)
        throw Error(format + " holds one figure in space; expected one generation, found " +
                    std::to_string(shown.first) + " to " + std::to_string(shown.last));
    auto [bytes, facts] = run(limits, [&](const Budget& budget, Progress* progress) {
        std::ostringstream out;
        if (mesh) {
            MeshChoices how;
            how.mesh.facets = wishes.facets;
            how.colours = wishes.colours;
            how.background = wishes.background;
            how.camera = view_of(wishes, *system).camera;
            SpaceDerivation found = scene(*system, shown.last, budget, choices);
            const MeshDrawn drawn = draw_mesh(found.scene, out, *mesh, how, budget);
            Json one{{"generation", shown.last},
                     {"vertices", drawn.vertices},
                     {"triangles", drawn.triangles},
                     {"solids", drawn.solids}};
            one.set("rounded", rounding_json(found.facts.rounded));
            return std::pair(out.str(), std::vector<Json>{one});
        }
        if (text == FigureFormat::html && leaves_plane(*system))
            return drawn_to_turn(system, shown, choices, wishes, budget);
        const Plates all(system, shown, choices, wishes, budget);
        const PictureOptions options = options_of(wishes, *system);
        const bool pages =
            !wishes.panels && (picture == PictureFormat::pdf || picture == PictureFormat::ps);
        if (text) {
            std::vector<std::shared_ptr<Letters>> kept;
            draw_as_text(sources_of(system, all, shown.first, choices, kept, budget), out, *text,
                         {options, false, wishes.panels || !is_single}, budget, progress);
        } else if (animation) {
            AnimationTiming timing;
            if (wishes.frame_time) timing.frame = *wishes.frame_time;
            draw_animation(all.plates, out, *animation, options, timing, budget, progress);
        } else if (is_single) {
            draw_picture(all.plates.front(), out, picture, options, budget, progress);
        } else if (pages) {
            draw_pages(all.plates, out, picture, options, budget, progress);
        } else {
            draw_panels(all.plates, out, picture, options, budget, progress);
        }
        return std::pair(out.str(), all.facts);
    });
    std::vector<std::string> texts;
    for (const Json& one : facts) texts.push_back(one.text(-1));
    return py::make_tuple(py::bytes(bytes), texts);
}

std::vector<std::string> facts(const SystemObject& system, const Shown& shown,
                               const Limits& limits) {
    const FigureChoices choices = choices_of(system, shown);
    return run(limits, [&](const Budget& budget) {
        std::vector<std::string> all;
        for (std::uint64_t n = shown.first; n <= shown.last; ++n)
            all.push_back(
                facts_json(
                    figure_of(*system, n, choices, view_choices(system->drawing), budget)->facts(),
                    n, choices.seed)
                    .text(-1));
        return all;
    });
}

// Trees

/// A derivation tree, or a graph of a system, to be drawn or taken apart.
struct TreeObject {
    Graph graph;
    std::optional<DerivationTree> tree;
};

constexpr std::uint64_t most_nodes = 200'000;

void check_size(const Integer& nodes, std::uint64_t most) {
    if (nodes > Integer(most))
        throw BoundReached(Bound::nodes, "the tree has " + readable(nodes) +
                                             " nodes, more than the " + std::to_string(most) +
                                             " of max_nodes; depth=D cuts it, shared=True draws "
                                             "equal subtrees once");
}

TreeObject tree_of(const SystemObject& system, const Shown& shown, const TreeShape& shape,
                   std::uint64_t most, const Limits& limits) {
    const Class kind = class_of(*system);
    if (kind.shape || kind.open)
        throw Error(
            kind.shape ? "it has shape rules, which divide boxes; a tree shows derivations of words"
                       : "it has communication modules, which an environment fills; a tree shows "
                         "derivations by rules alone");
    const View<D0L> rules = as_d0l(*system);
    const std::uint64_t n = shown.last;
    if (!rules && !shown.seed && shown.tables.empty() && as_ol(*system))
        throw Error(rules.reason() +
                    "; word=W shows the derivation of one word, seed=S one that is "
                    "picked at random");
    return run(limits, [&](const Budget& budget) {
        TreeObject found;
        if (rules && !shown.seed && shown.tables.empty()) {
            check_size(tree_size(*rules, n, shape, budget), most);
            found.tree = derivation_tree(*rules, n, shape, budget);
        } else {
            RewritingChoices choices;
            choices.seed = shown.seed.value_or(1);
            choices.evenly = !kind.stochastic && shown.seed;
            choices.random_tables = shown.seed.has_value();
            choices.arithmetic = Arithmetic::exact;
            std::vector<std::size_t> tables;
            if (!shown.tables.empty()) tables = table_sequence(system->tables, shown.tables);
            const Rewriting rewriting(*system, choices, budget);
            const ModuleTrace trace =
                traced(rewriting, n, tables, std::max(most, most_nodes), budget);
            check_size(tree_size(rewriting, trace, shape, budget), most);
            found.tree = derivation_tree(rewriting, trace, shape, budget);
        }
        found.graph = tree_graph(*found.tree);
        return found;
    });
}

TreeObject tree_of_word(const SystemObject& system, const WordObject& word, const TreeShape& shape,
                        std::uint64_t most, const Limits& limits) {
    const View<ET0L> rules = as_et0l(*system);
    Alphabet alphabet = *rules->alphabet;
    const Word letters = over(word, alphabet);
    return run(limits, [&](const Budget& budget) {
        const Membership found = membership(*rules, letters, budget);
        if (!found.member)
            throw Error(spell(alphabet, letters) +
                        " is not in the language: " + reason(found, alphabet, letters));
        const Derivation steps = derivation(*rules, letters, found, budget);
        check_size(tree_size(*rules, steps, shape, budget), most);
        TreeObject result;
        result.tree = derivation_tree(*rules, steps, shape, budget);
        result.graph = tree_graph(*result.tree);
        return result;
    });
}

py::dict nodes_and_edges(const TreeObject& object) {
    py::list nodes, edges;
    if (object.tree) {
        const DerivationTree& tree = *object.tree;
        for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
            let_signals_in(i);
            const DerivationTree::Node& node = tree.nodes[i];
            using Kind = DerivationTree::Node::Kind;
            const std::string label = node.kind == Kind::erased    ? "ε"
                                      : node.kind == Kind::omitted ? "..."
                                      : node.text.empty() ? tree.alphabet->name(node.letter)
                                                          : node.text;
            nodes.append(py::make_tuple(label, node.generation));
            for (const std::size_t child : node.children)
                edges.append(py::make_tuple(i, child, ""));
        }
    } else {
        for (const Graph::Node& node : object.graph.nodes)
            nodes.append(py::make_tuple(node.label + node.subscript, 0));
        for (const Graph::Edge& edge : object.graph.edges)
            edges.append(py::make_tuple(edge.from, edge.to, edge.label));
    }
    py::dict out;
    out["nodes"] = std::move(nodes);
    out["edges"] = std::move(edges);
    return out;
}

py::bytes tree_bytes(const TreeObject& object, const std::string& format,
                     std::optional<double> width, const Limits& limits) {
    return py::bytes(run(limits, [&](const Budget& budget) {
        if (format == "dot" || format == "gv") return dot_text(object.graph);
        if (format == "tex") return latex_text(object.graph, budget);
        std::ostringstream out;
        GraphOptions options;
        options.width = width;
        draw_graph(object.graph, out, picture_format("tree." + format), options, budget);
        return out.str();
    }));
}

// Dimension

struct DimensionObject {
    ExactDimension exact;
    DimensionRow row;
};

DimensionObject dimension_of(const SystemObject& system, const Limits& limits) {
    DimensionObject found;
    found.exact =
        run(limits, [&](const Budget& budget) { return exact_dimension(*system, budget); });
    found.row = {system->name, system->title, found.exact, {}, {}};
    return found;
}

const char* status_of(const ExactDimension& exact) {
    static const char* const names[] = {"exact", "upper bound", "unfinished", "none"};
    return names[static_cast<std::size_t>(exact.status)];
}

/// A measured value, the interval in which the true one is expected, and why.
py::tuple estimated(const std::optional<Estimate>& estimate, const std::string& because) {
    py::object values = py::none();
    if (estimate) values = py::make_tuple(estimate->value, estimate->low, estimate->high);
    return py::make_tuple(values, because);
}

py::tuple measured(const SystemObject& system, const Shown& shown, const std::string& measure,
                   const Limits& limits) {
    const FigureChoices choices = choices_of(system, shown);
    constexpr std::size_t grids = 16, most_scales = 20, most_cells = 1024;
    struct Found {
        std::optional<Estimate> estimate;
        std::string because;
    };
    const Found found = run(limits, [&](const Budget& budget) -> Found {
        const auto figure = open_figure(*system, shown.last, budget, choices);
        if (measure == "boxes") {
            BoxScales scales = scales_of(figure->box(), 2, 1);
            const double detail = figure->facts().step;
            scales.count = detail > 0 ? std::clamp<std::size_t>(
                                            static_cast<std::size_t>(std::max(
                                                std::log2(scales.coarsest / detail), 0.0)) +
                                                1,
                                            1, most_scales)
                                      : most_scales;
            const BoxFit fit =
                fit_dimension(box_counts(*figure, scales, even_offsets(grids), budget));
            return {fit.estimate, fit.because};
        }
        const auto scaling = [&]() -> Scaling {
            if (measure == "divider") return divider(*figure, budget);
            if (measure == "mass") return mass(*figure, {}, budget);
            if (measure == "correlation") return correlation(*figure, {}, budget);
            if (measure == "lacunarity")
                return lacunarity(drawn_cells(*figure, most_cells, budget), budget);
            throw Error(
                "measure: expected boxes, divider, mass, correlation or lacunarity, found " +
                algae::quoted(measure));
        };
        const Scaling result = scaling();
        return {result.estimate, result.because};
    });
    return estimated(found.estimate, found.because);
}

py::tuple bounded(const SystemObject& system, const Rational& within, const Limits& limits) {
    const DimensionBounds found = run(limits, [&](const Budget& budget) {
        return dimension_bounds(*system, BoundsSearch::until_within(within), budget);
    });
    return py::make_tuple(found.low, found.high, found.low_by, found.high_by);
}

}  // namespace

void add_figures(py::module_& module) {
    py::class_<Shown>(module, "Shown")
        .def(py::init([](std::uint64_t first, std::uint64_t last, std::optional<std::uint64_t> seed,
                         std::string tables) {
                 return Shown{first, last, seed, std::move(tables)};
             }),
             py::arg("first"), py::arg("last"), py::arg("seed") = py::none(),
             py::arg("tables") = "");
    py::class_<Wishes>(module, "Wishes")
        .def(py::init<>())
        .def_readwrite("width", &Wishes::width)
        .def_readwrite("height", &Wishes::height)
        .def_readwrite("margin", &Wishes::margin)
        .def_readwrite("line_width", &Wishes::line_width)
        .def_readwrite("font_size", &Wishes::font_size)
        .def_readwrite("frame_time", &Wishes::frame_time)
        .def_readwrite("colours", &Wishes::colours)
        .def_readwrite("background", &Wishes::background)
        .def_readwrite("caption", &Wishes::caption)
        .def_readwrite("captions", &Wishes::captions)
        .def_readwrite("scale_bar", &Wishes::scale_bar)
        .def_readwrite("common_scale", &Wishes::common_scale)
        .def_readwrite("panels", &Wishes::panels)
        .def_readwrite("camera", &Wishes::camera)
        .def_readwrite("facets", &Wishes::facets);
    module.def("points", points, py::arg("system"), py::arg("shown"), py::arg("limits"));
    module.def("segments", segments, py::arg("system"), py::arg("shown"), py::arg("limits"));
    module.def("mesh", mesh_arrays, py::arg("system"), py::arg("shown"), py::arg("facets"),
               py::arg("limits"));
    module.def("draw", draw, py::arg("system"), py::arg("shown"), py::arg("wishes"),
               py::arg("format"), py::arg("limits"));
    module.def("facts", facts, py::arg("system"), py::arg("shown"), py::arg("limits"));

    py::class_<TreeObject>(module, "Tree")
        .def("parts", nodes_and_edges)
        .def("bytes", tree_bytes, py::arg("format"), py::arg("width"), py::arg("limits"));
    module.def(
        "tree_of",
        [](const SystemObject& system, const Shown& shown, std::optional<std::uint64_t> depth,
           bool shared, std::uint64_t most, const Limits& limits) {
            return tree_of(system, shown, {depth, shared}, most, limits);
        },
        py::arg("system"), py::arg("shown"), py::arg("depth"), py::arg("shared"), py::arg("most"),
        py::arg("limits"));
    module.def(
        "tree_of_word",
        [](const SystemObject& system, const WordObject& word, std::optional<std::uint64_t> depth,
           bool shared, std::uint64_t most, const Limits& limits) {
            return tree_of_word(system, word, {depth, shared}, most, limits);
        },
        py::arg("system"), py::arg("word"), py::arg("depth"), py::arg("shared"), py::arg("most"),
        py::arg("limits"));
    module.def(
        "growth_digraph",
        [](const SystemObject& system, const Limits& limits) {
            const View<D0L> rules = as_d0l(*system);
            return TreeObject{
                run(limits, [&](const Budget& budget) { return growth_graph(*rules, budget); }),
                {}};
        },
        py::arg("system"), py::arg("limits"));
    module.def("families_diagram", [] { return TreeObject{families_graph(), {}}; });

    py::class_<DimensionObject>(module, "Dimension")
        .def("status", [](const DimensionObject& found) { return status_of(found.exact); })
        .def("almost_surely",
             [](const DimensionObject& found) { return found.exact.almost_surely; })
        .def("conditions", [](const DimensionObject& found) { return found.exact.conditions; })
        .def("text",
             [](const DimensionObject& found) -> std::optional<std::string> {
                 if (!found.exact.value) return std::nullopt;
                 return found.exact.value->text();
             })
        .def("rational",
             [](const DimensionObject& found) -> std::optional<Rational> {
                 if (!found.exact.value) return std::nullopt;
                 return found.exact.value->rational();
             })
        .def(
            "decimal",
            [](const DimensionObject& found, int digits, const Limits& limits) {
                if (!found.exact.value)
                    throw Error("the rules give no formula of the dimension: " +
                                (found.exact.conditions.empty() ? std::string()
                                                                : found.exact.conditions.back()));
                if (found.exact.value->enclosure(64).midpoint() > 2)
                    return decimal(Rational(2), digits);
                return run(limits, [&](const Budget& budget) {
                    if (const auto exact = found.exact.value->rational())
                        return decimal(*exact, digits);
                    return decimal(
                        [&](long bits) {
                            budget.check();
                            return found.exact.value->enclosure(bits);
                        },
                        digits);
                });
            },
            py::arg("digits"), py::arg("limits"))
        .def("boundary",
             [](const DimensionObject& found) -> std::optional<std::string> {
                 if (!found.exact.boundary) return std::nullopt;
                 return found.exact.boundary->text();
             })
        .def("latex",
             [](const DimensionObject& found) {
                 return found.exact.value ? formula_latex(found.exact.value->text())
                                          : std::string();
             })
        .def("report",
             [](const DimensionObject& found) { return to_json(found.row, true).text(-1); });
    module.def("dimension_of", dimension_of, py::arg("system"), py::arg("limits"));
    module.def("measured", measured, py::arg("system"), py::arg("shown"), py::arg("measure"),
               py::arg("limits"));
    module.def("dimension_bounds", bounded, py::arg("system"), py::arg("within"),
               py::arg("limits"));
}

}  // namespace algae::python
