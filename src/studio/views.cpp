// Views of a system for a page: what a canvas draws, what a derivation's letters come from, what a turtle does.
//
// A figure goes to the page as numbers of single precision, seen from the middle of what is shown: a million strokes are sixteen
// megabytes and no text to be read. The middle itself is a double, so that a part of a figure that is a billionth of it is still drawn
// without steps. A stroke brings the place of the symbol that draws it, so that the page can show the symbol of a stroke and the
// strokes up to a symbol.
//
// Detail follows the view. Strokes outside of it are dropped; parts that lie within half a pixel of the straight way through them are
// left to the figure, which draws one stroke for each. If more than the page can take are left, the resolution is halved and the figure
// is drawn again; that stops as soon as the bound is passed, so it costs a bounded number of strokes each time.

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <tuple>

#include "growth/growth.hpp"
#include "model/model.hpp"
#include "rewrite/rewrite.hpp"
#include "studio/studio.hpp"
#include "turtle/turtle.hpp"

namespace algae {

namespace {

using nlohmann::json;

/// Numbers of 4 bytes behind a line of JSON.
class Bytes {
public:
    void add(float value) { put(std::bit_cast<std::uint32_t>(value)); }
    void add(std::uint32_t value) { put(value); }
    std::string behind(const json& head) const {
        return head.dump(-1, ' ', false, json::error_handler_t::replace) + '\n' + bytes_;
    }

private:
    void put(std::uint32_t value) {
        for (int i = 0; i < 4; ++i) bytes_ += static_cast<char>((value >> (8 * i)) & 0xff);
    }
    std::string bytes_;
};

std::string hexadecimal(const Colour& colour) {
    std::string text = "#";
    for (const double part : {colour.red, colour.green, colour.blue}) {
        const auto value = static_cast<unsigned>(std::lround(std::clamp(part, 0.0, 1.0) * 255));
        text += "0123456789abcdef"[value / 16];
        text += "0123456789abcdef"[value % 16];
    }
    return text;
}

/// More strokes than a page takes.
struct TooMany {};

/// What strokes look like: a colour as text, empty for the page's own ink, and a width.
struct Look {
    std::string colour;
    double width = 1;
    bool is_length = false;
    bool operator==(const Look&) const = default;
    auto key() const { return std::tie(colour, width, is_length); }
    bool operator<(const Look& other) const { return key() < other.key(); }
};

/// Gathers the strokes within a part of the plane.
class Gathered : public Canvas {
public:
    struct Stroke {
        float x1, y1, x2, y2;
        std::uint32_t symbol;
    };
    struct Run {
        Look look;
        std::size_t first = 0, count = 0;
    };
    struct Area {
        Look look;
        std::vector<Point> corners;
        std::uint32_t symbol;
    };

    Gathered(const std::vector<std::string>& colours, Point middle, const Box& seen,
             std::uint64_t symbols, std::uint64_t most, const Budget& budget)
        : colours_(colours),
          middle_(middle),
          seen_(seen),
          symbols_(symbols),
          most_(most),
          budget_(budget) {
        choose();
    }

    void move_to(Point point) override { here_ = point; }
    void line_to(Point point) override {
        const Point from = std::exchange(here_, point);
        if (++walked_ % 65536 == 0) budget_.check();
        if (std::max(from.x, point.x) < seen_.low.x || std::min(from.x, point.x) > seen_.high.x ||
            std::max(from.y, point.y) < seen_.low.y || std::min(from.y, point.y) > seen_.high.y)
            return;
        if (strokes.size() + areas.size() >= most_) throw TooMany();
        if (runs.empty() || runs.back().look != look_) runs.push_back({look_, strokes.size(), 0});
        ++runs.back().count;
        strokes.push_back({near(from.x, middle_.x), near(from.y, middle_.y),
                           near(point.x, middle_.x), near(point.y, middle_.y), symbol_});
    }
    void polygon(std::span<const Point> corners) override {
        if (++walked_ % 4096 == 0) budget_.check();
        Box box;
        for (const Point& corner : corners) box.add(corner);
        if (box.high.x < seen_.low.x || box.low.x > seen_.high.x || box.high.y < seen_.low.y ||
            box.low.y > seen_.high.y)
            return;
        if (strokes.size() + (corners_ += corners.size()) >= most_) throw TooMany();
        areas.push_back({look_, {corners.begin(), corners.end()}, symbol_});
    }
    void width(double factor) override {
        look_.width = std::fabs(factor);
        look_.is_length = false;
    }
    void width_as_length(double length) override {
        look_.width = std::fabs(length);
        look_.is_length = true;
    }
    void colour(std::uint32_t index) override {
        index_ = index;
        painted_ = false;
        choose();
    }
    void paint(const Colour& colour) override {
        painted_ = true;
        look_.colour = hexadecimal(colour);
    }
    void position(double fraction) override {
        const double place = std::round(fraction * static_cast<double>(symbols_));
        symbol_ = static_cast<std::uint32_t>(
            std::clamp(place, 0.0, static_cast<double>(std::max<std::uint64_t>(symbols_, 1) - 1)));
        if (scheme_.empty() || painted_) return;
        constexpr double shades = 180;
        const double shade = std::floor(std::clamp(fraction, 0.0, 1.0) * shades) / shades;
        look_.colour = hexadecimal(scheme_colour(scheme_, shade));
    }
    bool wants_position() const override { return true; }

    std::vector<Stroke> strokes;
    std::vector<Run> runs;
    std::vector<Area> areas;

private:
    static float near(double value, double middle) { return static_cast<float>(value - middle); }
    void choose() {
        scheme_.clear();
        look_.colour.clear();
        if (colours_.empty()) return;
        const std::string& name = colours_[index_ % colours_.size()];
        if (is_scheme(name))
            scheme_ = name;
        else
            look_.colour = hexadecimal(colour_named(name));
    }

    const std::vector<std::string>& colours_;
    Point middle_, here_;
    Box seen_;
    std::uint64_t symbols_, most_, walked_ = 0, corners_ = 0;
    const Budget& budget_;
    Look look_;
    std::uint32_t index_ = 0, symbol_ = 0;
    bool painted_ = false;
    std::string scheme_;  // that runs with the word now
};

json json_of(const Look& look) {
    json out{{"width", look.width}};
    out["colour"] = look.colour.empty() ? json() : json(look.colour);
    if (look.is_length) out["length"] = true;
    return out;
}

/// Why parameters were rounded; null if they were not.
json reason(const std::string& text) { return text.empty() ? json() : json(text); }

/// The choices of a system that leaves some: a seed where nobody gave one.
FigureChoices choices_of(const Model& system, std::optional<std::uint64_t> seed) {
    FigureChoices choices;
    choices.seed = seed;
    if (!seed && system.drawing.seeds) choices.seed = system.drawing.seeds->first;
    if (!choices.seed && !as_d0l(system) && as_ol(system)) choices.seed = 1;
    choices.random_tables = seed.has_value() || (!system.tables.empty() && system.schedule.empty());
    if (choices.random_tables && !choices.seed) choices.seed = 1;
    return choices;
}

std::string plane_view(const Model& system, const FigureQuestion& question, const Budget& budget) {
    const auto drawn =
        open_figure(system, question.generation, budget, choices_of(system, question.seed));
    const Box& box = drawn->box();
    FigureQuestion::Part part{box.low.x, box.low.y, box.breadth(), box.height()};
    if (question.part) part = *question.part;
    const Point middle{part.x + part.width / 2, part.y + part.height / 2};
    // A little more than the part: strokes along its edge are in it, however they are rounded.
    const double slack = 1e-6 * std::max(part.width, part.height);
    Box seen;
    seen.add(Point{part.x - slack, part.y - slack});
    seen.add(Point{part.x + part.width + slack, part.y + part.height + slack});
    // The word's length where it is known without deriving it, for the places of symbols.
    std::uint64_t symbols = 0;
    if (const View<D0L> rules = as_d0l(system)) {
        const Integer all = length(*rules, question.generation, budget);
        if (all.fits_int64() && all < Integer(std::numeric_limits<std::uint32_t>::max()))
            symbols = all.to_uint64();
    }
    const std::vector<std::string>& colours = drawn->style().colours;
    const double breadth = std::max(part.width, part.height);
    const double resolution = breadth / (2 * std::max(question.pixels, 1.0));
    for (double coarser = 1;; coarser *= 2) {
        Gathered found(colours, middle, seen, symbols, question.most_strokes, budget);
        try {
            drawn->draw(found, resolution * coarser, budget);
        } catch (const TooMany&) {
            if (resolution * coarser < breadth) continue;
            throw BoundReached(Bound::memory,
                               "the part that is shown has more than " +
                                   std::to_string(question.most_strokes) +
                                   " strokes; expected a smaller part or a lower generation");
        }
        json runs = json::array(), areas = json::array();
        for (const auto& run : found.runs) {
            json one = json_of(run.look);
            one["first"] = run.first;
            one["count"] = run.count;
            runs.push_back(std::move(one));
        }
        for (const auto& area : found.areas) {
            json one = json_of(area.look), corners = json::array();
            for (const Point& corner : area.corners) {
                corners.push_back(corner.x - middle.x);
                corners.push_back(corner.y - middle.y);
            }
            one["corners"] = std::move(corners);
            one["symbol"] = area.symbol;
            areas.push_back(std::move(one));
        }
        Bytes bytes;
        for (const auto& stroke : found.strokes)
            for (const float value : {stroke.x1, stroke.y1, stroke.x2, stroke.y2}) bytes.add(value);
        for (const auto& stroke : found.strokes) bytes.add(stroke.symbol);
        const std::optional<Quantity>& width = drawn->style().width;
        return bytes.behind({{"kind", "plane"},
                             {"generation", question.generation},
                             {"box", {box.low.x, box.low.y, box.breadth(), box.height()}},
                             {"empty", box.empty},
                             {"middle", {middle.x, middle.y}},
                             {"part", {part.x, part.y, part.width, part.height}},
                             {"segments", to_string(drawn->segments())},
                             {"exact", drawn->facts().exact},
                             {"rounded", reason(drawn->facts().rounded)},
                             {"strokes", found.strokes.size()},
                             {"coarser", coarser},
                             {"symbols", symbols},
                             {"line_width", width ? width->value : 1},
                             {"runs", std::move(runs)},
                             {"areas", std::move(areas)}});
    }
}

std::string space_view(const Model& system, const FigureQuestion& question, const Budget& budget) {
    const SpaceDerivation derived =
        scene(system, question.generation, budget, choices_of(system, question.seed));
    const SpaceBox box = box_of(derived.scene);
    json head{{"kind", "space"},
              {"generation", question.generation},
              {"segments", std::to_string(derived.facts.segments)},
              {"rounded", reason(derived.facts.rounded)},
              {"empty", derived.scene.empty()}};
    head["box"] = {box.low.x, box.low.y, box.low.z, box.high.x, box.high.y, box.high.z};
    const ViewChoices view = view_choices(system.drawing);
    head["camera"] = {view.camera.azimuth, view.camera.elevation};
    if (derived.scene.empty()) return Bytes().behind(head);
    MeshOptions options;
    options.facets = derived.scene.parts() > 50'000 ? 4 : derived.scene.parts() > 5'000 ? 6 : 10;
    const Mesh mesh = mesh_of(derived.scene, options, budget);
    const Vector middle = 0.5 * (box.low + box.high);
    const auto colour_of = [&](const Paint& paint) -> json {
        if (paint.colour) return hexadecimal(*paint.colour);
        const std::vector<std::string>& colours = derived.scene.colours;
        if (colours.empty()) return nullptr;
        const std::string& name = colours[paint.index % colours.size()];
        return name == "along" ? json(nullptr) : json(hexadecimal(colour_named(name)));
    };
    // Triangles by paint, so that a colour is one thing to be drawn.
    std::map<std::uint32_t, std::vector<std::uint32_t>> by_paint;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
        by_paint[mesh.corners[mesh.triangles[i][0]].paint].push_back(static_cast<std::uint32_t>(i));
    Bytes bytes;
    for (std::uint32_t corner = 0; corner < mesh.corners.size(); ++corner) {
        const Vector place = mesh.place(corner) - middle, normal = mesh.corners[corner].normal;
        for (const double value : {place.x, place.y, place.z, normal.x, normal.y, normal.z})
            bytes.add(static_cast<float>(value));
    }
    json runs = json::array();
    std::size_t first = 0;
    for (const auto& [paint, triangles] : by_paint) {
        for (const std::uint32_t triangle : triangles)
            for (const std::uint32_t corner : mesh.triangles[triangle]) bytes.add(corner);
        runs.push_back({{"colour", colour_of(mesh.paints[paint])},
                        {"first", first},
                        {"count", 3 * triangles.size()}});
        first += 3 * triangles.size();
    }
    head["middle"] = {middle.x, middle.y, middle.z};
    head["corners"] = mesh.corners.size();
    head["indices"] = first;
    head["runs"] = std::move(runs);
    return bytes.behind(head);
}

json json_of(const TurtleState& state) {
    return {{"position", {state.position.x, state.position.y, state.position.z}},
            {"heading",
             {state.attitude.heading().x, state.attitude.heading().y, state.attitude.heading().z}}};
}

}  // namespace

std::string figure_view(const Model& system, const FigureQuestion& question, const Budget& budget) {
    return leaves_plane(system) ? space_view(system, question, budget)
                                : plane_view(system, question, budget);
}

std::string derivation_view(const Model& system, std::uint64_t n, std::optional<std::uint64_t> seed,
                            std::uint64_t most, const Budget& budget) {
    RewritingChoices choices;
    const FigureChoices picked = choices_of(system, seed);
    choices.seed = picked.seed.value_or(1);
    choices.evenly = picked.seed.has_value() && !class_of(system).stochastic;
    choices.random_tables = picked.random_tables;
    choices.arithmetic = class_of(system).open ? Arithmetic::doubles : Arithmetic::exact;
    std::string rounded;  // why parameters are doubles
    std::optional<Rewriting> made;
    ModuleTrace trace;
    const auto derive_all = [&] {
        made.emplace(system, choices, budget);
        if (made->rules().kinds.held()) made->rules().kinds.held()->set_most_work(100'000);
        trace = traced(*made, n, {}, most, budget);
    };
    const auto derive_with_doubles = [&](const char* reason) {
        if (choices.arithmetic == Arithmetic::doubles) throw;
        rounded = reason;
        choices.arithmetic = Arithmetic::doubles;
    };
    try {
        derive_all();
    } catch (const UndecidedValue& undecided) {
        derive_with_doubles(undecided.what());
    } catch (const BoundReached& bound) {
        if (bound.bound() != Bound::method && bound.bound() != Bound::memory) throw;
        derive_with_doubles(bound.what());
    }
    if (!rounded.empty()) derive_all();
    const Rewriting& rewriting = *made;
    const ModuleText printer(system.alphabet, rewriting.rules().kinds);
    json words = json::array();
    for (std::size_t step = 0; step < trace.words.size(); ++step) {
        const ModuleString& word = trace.words[step];
        json symbols = json::array(), parents = json::array();
        std::size_t value = 0;
        for (const ModuleKind kind : word.kinds) {
            symbols.push_back(printer.text(kind, word.values.data() + value));
            value += rewriting.rules().kinds.arity(kind);
        }
        if (step > 0)
            for (std::size_t parent = 0; parent < trace.lengths[step - 1].size(); ++parent)
                for (std::uint32_t i = 0; i < trace.lengths[step - 1][parent]; ++i)
                    parents.push_back(parent);
        json one{{"symbols", std::move(symbols)}, {"parents", std::move(parents)}};
        if (step > 0 && !system.tables.empty() && step - 1 < trace.tables.size())
            one["table"] = system.tables[trace.tables[step - 1]];
        words.push_back(std::move(one));
    }
    const json out{{"words", std::move(words)},
                   {"asked", n},
                   {"full", trace.goes_on},
                   {"rounded", reason(rounded)}};
    return out.dump(-1, ' ', false, json::error_handler_t::replace);
}

std::string walk_view(const Model& system, std::uint64_t n, std::optional<std::uint64_t> seed,
                      std::uint64_t most, const Budget& budget) {
    Budget within = budget;
    within.letters = std::min(budget.letters, most);
    const DerivedModules derived =
        open_modules(system, n, choices_of(system, seed), nullptr, within);
    if (derived.word.kinds.size() > most)
        throw BoundReached(Bound::letters, "generation " + std::to_string(n) + " has " +
                                               std::to_string(derived.word.kinds.size()) +
                                               " symbols, and a walk is shown step by step for " +
                                               std::to_string(most));
    const Explanation found =
        explanation(system, derived.kinds, derived.word, n, derived.seed, budget);
    json steps = json::array();
    for (const ExplainedStep& step : found.steps) {
        json lines = json::array();
        for (const ExplainedLine& line : step.lines)
            lines.push_back({{"from", {line.from.x, line.from.y, line.from.z}},
                             {"to", {line.to.x, line.to.y, line.to.z}},
                             {"drawn", line.drawn}});
        json one{{"symbol", step.symbol},
                 {"meaning", step.meaning},
                 {"after", json_of(step.after)},
                 {"lines", std::move(lines)}};
        if (step.returns_to) one["returns_to"] = *step.returns_to;
        steps.push_back(std::move(one));
    }
    const json out{{"start", json_of(found.start)}, {"steps", std::move(steps)}};
    return out.dump(-1, ' ', false, json::error_handler_t::replace);
}

}  // namespace algae
