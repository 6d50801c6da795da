// `algae draw`: the turtle figure of a generation, as a picture, pages, panels, an animation or a file of a
// figure in space; with --explain or --progressive the turtle at work.
//
// The name of the output says the format, and the format says how several generations are shown: as pages of
// pdf and ps, frames of animations, or panels if --panels or the file ask for them. Options that exclude each
// other are refused before anything is drawn. --explain numbers the steps of a short word and shows them in
// a table or a picture; --progressive draws a word symbol by symbol, several symbols to a frame if there would be
// too many frames. FILE may be another generator: then -n and --seed replace statements of
// its file, so these two stay texts until the file is known.

#include <algorithm>
#include <array>
#include <chrono>
#include <deque>
#include <filesystem>
#include <optional>
#include <thread>

#include "command/detail/files.hpp"
#include "command/detail/output.hpp"
#include "command/detail/pictures.hpp"
#include "command/detail/verb.hpp"
#include "exact/exact.hpp"
#include "exchange/exchange.hpp"
#include "model/model.hpp"
#include "notation/notation.hpp"
#include "render/render.hpp"
#include "rewrite/rewrite.hpp"
#include "turtle/turtle.hpp"

namespace algae::command {

namespace {

constexpr std::uint64_t usual_frames = 240, most_frames = 10'000;
constexpr double usual_time = 0.8, usual_progress_time = 0.05,
                 usual_turn_time = 0.08;           // seconds a frame
constexpr std::uint64_t most_strokes = 5'000'000;  // of all pages together

struct Options {
    std::string file, output, format, tables, environment, background, caption, author;
    std::vector<std::string> let;
    std::string generation,
        seed;  // of a generator the text of a statement, else a range and a number
    std::optional<Range> seeds;
    std::optional<double> width, height, margin, line_width, font_size, frame_time;
    std::optional<std::uint64_t> columns, loop, max_frames, facets, between;
    std::optional<std::vector<std::string>> colours;
    std::vector<PointLabel> labels;
    SpaceOptions space;
    SettingOptions settings;
    std::optional<Theme> theme;
    bool scale_bar = false, panels = false, common_scale = false, own_scale = false;
    bool captions = false;
    bool progressive = false, explain = false, plotter = false, raster = false, json = false;
    bool watch = false;
    Bounds bounds;

    std::vector<StatementOption> statements() const {
        return {{"-n", "generation", generation}, {"--seed", "seed", seed}};
    }
};

std::uint64_t frames(const std::string& option, const std::string& text, std::uint64_t least,
                     std::uint64_t most) {
    const std::uint64_t count = natural(option, text);
    if (count < least || count > most)
        throw Error(option + " must be from " + std::to_string(least) + " to " +
                    std::to_string(most) + ", not " + text);
    return count;
}

/// A reader: how many frames --progressive may make.
std::uint64_t frame_bound(const std::string& option, const std::string& text) {
    return frames(option, text, 2, most_frames);
}

/// A reader: how many frames lead from a generation to the next.
std::uint64_t between_count(const std::string& option, const std::string& text) {
    return frames(option, text, 1, 1000);
}

/// A reader: the sides of a tube.
std::uint64_t facet_count(const std::string& option, const std::string& text) {
    const std::uint64_t facets = natural(option, text);
    if (facets < 3 || facets > 256)
        throw Error(option + " " + text + ": expected 3 to 256 sides of a tube");
    return facets;
}

/// The system of FILE, with the settings of the command line.
Model open_drawn(const Options& options, const Budget& budget,
                 const std::vector<std::string>& let) {
    return options.settings.applied_to(open_model(options.file, budget, let));
}

/// Says what a newcomer wonders about: why a plant lies on its side.
void suggest_start(const Options& options, const Model& system) {
    if (lies_down(system) && !system_format(options.file))
        note("the turtle starts along +x, so that a plant lies; --start upward lets it stand");
}

/// The options with the colours of their theme for this system instead of the file's.
Options themed(Options options, const std::vector<std::string>& own) {
    if (!options.theme) return options;
    ThemeColours found = theme_colours(
        *options.theme, options.colours.value_or(own),
        options.background.empty() ? std::nullopt : std::optional(options.background));
    if (found.background) options.background = *found.background;
    if (!found.colours.empty()) options.colours = std::move(found.colours);
    return options;
}

PictureOptions picture_options(const Options& options) {
    PictureOptions picture;
    picture.width = options.width;
    picture.height = options.height;
    if (options.margin) picture.margin = *options.margin;
    picture.line_width = options.line_width;
    picture.font_size = options.font_size;
    picture.columns = options.columns;
    if (!options.background.empty()) picture.background = options.background;
    if (options.colours) picture.colours = *options.colours;
    picture.common_scale = options.common_scale;
    picture.scale_bar = options.scale_bar;
    picture.labels = options.labels;
    picture.author = options.author;
    if (options.raster) picture.route = PictureOptions::Route::cells;
    return picture;
}

PlateChoices choices_of(const Options& options, const Model& system) {
    PlateChoices found;
    if (!options.seed.empty() && options.seeds)
        throw Error("--seed and --seeds: expected one of them");
    if (!options.seed.empty()) {
        const std::uint64_t seed = natural("--seed", options.seed);
        found.seeds = {seed, seed};
    }
    if (options.seeds) found.seeds = {options.seeds->first, options.seeds->last};
    if (!options.tables.empty()) found.tables = table_sequence(system.tables, options.tables);
    found.environment = options.environment;
    found.between = options.between.value_or(1);
    found.space = options.space;
    if (!options.background.empty()) found.background = options.background;
    if (options.colours) found.colours = *options.colours;
    return found;
}

/// `usual`: seconds a frame where the command line does not say.
AnimationTiming timing_of(const Options& options, double usual) {
    AnimationTiming timing;
    timing.frame = options.frame_time.value_or(usual);
    if (options.loop)
        timing.plays =
            static_cast<std::uint32_t>(std::min<std::uint64_t>(*options.loop, UINT32_MAX));
    return timing;
}

/// Throws Error for a camera that goes around a figure where nothing moves with it.
[[noreturn]] void refuse_turning() {
    throw Error(
        "--camera: goes around a figure in an animation of one generation; expected a file ending "
        "in .gif, .webp, .mp4 or .webm, or one azimuth");
}

/// Throws Error if an option is set that makes no sense: `moves` in a file that holds an animation.
void check_motion(const Options& options, bool moves) {
    if (options.explain && options.progressive)
        throw Error("--explain and --progressive: expected one of them");
    if (options.max_frames && !options.progressive)
        throw Error("--max-frames: only --progressive has it");
    if (!moves)
        refuse_given({{"--frame-time", options.frame_time.has_value()},
                      {"--loop", options.loop.has_value()},
                      {"--between", options.between.has_value()}},
                     ": only animations have it: expected a file ending in .gif, .webp, .mp4 or "
                     ".webm");
    if (!moves && options.space.turns()) refuse_turning();
}

/// The name whose end says the format of an output that must be given.
std::string needed_format(const Options& options) {
    if (options.output.empty()) throw Error("--output is required");
    return named_format(options.output, options.format);
}

/// The word of a generation with the choices of the command line, or of the file. Throws what
/// open_modules throws.
DerivedModules word_to_walk(const Model& system, std::uint64_t n, const PlateChoices& choices,
                            const Budget& budget) {
    const auto seeds = choices.seeds ? choices.seeds : system.drawing.seeds;
    FigureChoices found;
    if (seeds) found.seed = seeds->first;
    found.tables = choices.tables;
    found.random_tables = choices.seeds.has_value();
    return open_modules(system, n, found, external_environment(choices.environment, system),
                        budget);
}

/// The one generation that -n says; `who` shows no more.
std::uint64_t one_generation(const Options& options, const std::string& who) {
    const Range wished = range("-n", options.generation);
    if (!wished.is_single())
        throw Error("-n " + options.generation + ": " + who + " one generation");
    return wished.first;
}

/// Why parameters of a figure are doubles: null where they are exact.
Json rounding_json(const std::string& reason) {
    return reason.empty() ? Json(nullptr) : Json(reason);
}

// --explain

/// The word of a generation, if it is short enough to be explained.
std::optional<DerivedModules> short_word(const Model& system, std::uint64_t n,
                                         const PlateChoices& choices, Budget budget,
                                         std::string& length) {
    constexpr std::uint64_t countable = 1'000'000;
    budget.letters = std::min(budget.letters, countable);
    try {
        DerivedModules found = word_to_walk(system, n, choices, budget);
        length = std::to_string(found.word.kinds.size());
        if (found.word.kinds.size() <= longest_explanation) return found;
    } catch (const BoundReached& bound) {
        if (bound.bound() != Bound::letters) throw;
        length = "more than " + std::to_string(budget.letters);
    }
    return std::nullopt;
}

/// The last generation up to this one of those that begin with short words.
std::optional<std::uint64_t> last_short(const Model& system, std::uint64_t most,
                                        const PlateChoices& choices, const Budget& budget) {
    constexpr std::uint64_t enough = 200;
    std::optional<std::uint64_t> found;
    std::string length;
    for (std::uint64_t n = 0; n <= std::min(most, enough); ++n) {
        if (!choices.tables.empty() && choices.tables.size() < n) break;
        if (!short_word(system, n, choices, budget, length)) break;
        found = n;
    }
    return found;
}

Json place(const Vector& at) { return Json::array({at.x, at.y, at.z}); }

Json as_json(const TurtleState& state) {
    Json out;
    out.set("position", place(state.position));
    out.set("heading", place(state.attitude.heading()));
    out.set("angle", heading_angle(state));
    return out;
}

Json as_json(const Explanation& explanation, std::uint64_t n) {
    Json out;
    out.set("generation", n);
    out.set("word", explanation.word);
    out.set("start", as_json(explanation.start));
    Json steps = Json::array();
    for (std::size_t i = 0; i < explanation.steps.size(); ++i) {
        const ExplainedStep& step = explanation.steps[i];
        Json one{{"step", i + 1}, {"symbol", step.symbol}, {"meaning", step.meaning}};
        one.update(as_json(step.after));
        one.set("open", step.open);
        Json strokes = Json::array();
        for (const ExplainedLine& line : step.lines)
            if (line.drawn) strokes.add(Json::array({place(line.from), place(line.to)}));
        steps.add(one.set("strokes", std::move(strokes)));
    }
    return out.set("steps", std::move(steps));
}

std::size_t characters(const std::string& text) {
    return static_cast<std::size_t>(
        std::ranges::count_if(text, [](char c) { return (c & 0xc0) != 0x80; }));
}

/// The rows in columns, two blanks between them.
std::string as_text(const Explanation& explanation) {
    const auto rows = explanation_rows(explanation);
    std::vector<std::size_t> widths(rows.front().size());
    for (const auto& row : rows)
        for (std::size_t i = 0; i < row.size(); ++i)
            widths[i] = std::max(widths[i], characters(row[i]));
    std::string out;
    for (const auto& row : rows) {
        std::string line;
        for (std::size_t i = 0; i < row.size(); ++i) {
            const std::string blanks(widths[i] - characters(row[i]), ' ');
            line += (i == 0 ? blanks + row[i] : row[i] + blanks) + "  ";
        }
        line.erase(line.find_last_not_of(' ') + 1);
        out += line + '\n';
    }
    return out;
}

int draw_explained(const Options& options) {
    if (!options.output.empty()) named_format(options.output, options.format);
    check_motion(options, false);
    const Budget budget = options.bounds.budget();
    const Model system = open_drawn(options, budget, options.let);
    const PlateChoices choices = choices_of(options, system);
    if (!leaves_plane(system)) choices.space.check_unused(system.name);
    std::uint64_t n = 0;
    if (options.generation.empty()) {
        const std::uint64_t shown =
            system.drawing.generations ? system.drawing.generations->second : 0;
        n = last_short(system, shown, choices, budget).value_or(0);
    } else {
        n = one_generation(options, "--explain shows");
    }
    std::string length;
    const std::optional<DerivedModules> derived = short_word(system, n, choices, budget, length);
    if (!derived) {
        const auto shorter = n > 0 ? last_short(system, n - 1, choices, budget) : std::nullopt;
        throw Error("generation " + std::to_string(n) +
                    (system.name.empty() ? "" : " of " + system.name) + " has " + length +
                    " symbols: --explain shows words of at most " +
                    std::to_string(longest_explanation) +
                    (shorter ? ", such as -n " + std::to_string(*shorter) : "") +
                    "; --progressive draws longer ones step by step");
    }
    note_rounding(system, n, derived->rounded);
    const Explanation explained =
        explanation(system, derived->kinds, derived->word, n, derived->seed, budget);
    if (!options.output.empty()) {
        const PictureFormat format = picture_format(named_format(options.output, options.format));
        PictureOptions picture = picture_options(options);
        if (picture.colours.empty()) picture.colours = system.drawing.colours;
        const std::string title =
            (system.title.empty() ? system.name : system.title) + ", n = " + std::to_string(n);
        draw_explanation(explained, title, target_of(options.output), format, picture, budget);
    }
    if (options.json)
        print(as_json(explained, n).set("rounded", rounding_json(derived->rounded)).text());
    else if (options.output.empty())
        print(explained.word + "\n" + as_text(explained));
    return success;
}

// --progressive

/// The symbols of a word one by one, as text.
std::vector<std::string> symbol_texts(const Model& system, const DerivedModules& derived) {
    const ModuleText text(system.alphabet, derived.kinds);
    std::vector<std::string> found;
    const double* values = derived.word.values.data();
    for (const ModuleKind kind : derived.word.kinds) {
        found.push_back(text.text(kind, values));
        values += derived.kinds.arity(kind);
    }
    return found;
}

/// A number with as many places as the largest, so that captions do not jump.
std::string padded(std::size_t number, std::size_t largest) {
    std::string digits = std::to_string(number);
    std::string blanks;
    for (std::size_t i = digits.size(); i < std::to_string(largest).size(); ++i) blanks += "\u2007";
    return blanks + digits;
}

/// A system in the colours of the picture: scenes have their own.
Model painted(Model system, const PictureOptions& picture) {
    if (!picture.colours.empty()) system.drawing.colours = picture.colours;
    return system;
}

int draw_progressive(const Options& options) {
    const std::string named = needed_format(options);
    const Budget budget = options.bounds.budget();
    const Model system = open_drawn(options, budget, options.let);
    const PlateChoices choices = choices_of(options, system);
    const PictureOptions picture = picture_options(options);
    const auto animation = animation_format(named);
    const PictureFormat format = animation ? PictureFormat::png : picture_format(named);
    if (!animation && format != PictureFormat::pdf && format != PictureFormat::ps)
        throw Error(
            std::string(
                "--progressive: expected gif, webp, mp4 or webm for an animation, or pdf or "
                "ps for pages, found ") +
            format_name(format));
    check_motion(options, animation.has_value());
    if (options.space.turns()) refuse_turning();
    const AnimationTiming timing = timing_of(options, usual_progress_time);
    const std::uint64_t n = options.generation.empty()
                                ? shown_generations(system).second
                                : one_generation(options, "--progressive shows");
    const DerivedModules derived = word_to_walk(system, n, choices, budget);
    note_rounding(system, n, derived.rounded);
    const std::size_t length = derived.word.kinds.size();
    if (length == 0)
        throw Error("generation " + std::to_string(n) + " of " + system.name +
                    " is the empty word: a turtle has nothing to do");
    const std::vector<std::size_t> symbols =
        frames_of_progress(length, options.max_frames.value_or(usual_frames));
    const std::size_t stride = symbols[1];
    const bool in_space = leaves_plane(system);
    if (!in_space) choices.space.check_unused(system.name);
    const auto figures =
        in_space ? partial_views(painted(system, picture), derived, n, symbols,
                                 view_choices(choices.space, system, choices.background), budget)
                 : partial_figures(system, derived, n, symbols, budget);

    const std::vector<std::string> texts =
        options.captions ? symbol_texts(system, derived) : std::vector<std::string>();
    const std::string title = system.title.empty() ? system.name : system.title;
    std::vector<Plate> plates;
    for (std::size_t i = 0; i < figures.size(); ++i) {
        Plate& plate = plates.emplace_back();
        plate.figure = figures[i].get();
        plate.name = "generation " + std::to_string(n) + " of " + system.name;
        plate.caption = options.caption;
        if (!options.captions || !plate.caption.empty()) continue;
        plate.caption = title + ", n = " + std::to_string(n) + ": " + padded(symbols[i], length) +
                        " of " + std::to_string(length);
        if (stride == 1 && symbols[i] > 0) plate.caption += "  " + texts[symbols[i] - 1];
    }
    const std::uint64_t each = figures.front()->strokes().value_or(most_strokes);
    if (!animation && each > 2 * most_strokes / figures.size())
        throw Error("--progressive: the " + std::to_string(figures.size()) +
                    " pages would hold more than " + std::to_string(most_strokes) +
                    " strokes; use an animation, a smaller -n or a smaller --max-frames");
    if (stride > 1)
        note(std::to_string(length) + " symbols in " + std::to_string(figures.size()) +
             " frames, " + std::to_string(stride) +
             " symbols a frame; --max-frames allows more frames");

    ProgressBar bar("Drawing");
    const Target target = target_of(options.output);
    const Drawn drawn =
        animation ? draw_animation(plates, target, *animation, picture, timing, budget, &bar)
                  : draw_pages(plates, target, format, picture, budget, &bar);
    if (options.json)
        print(Json{{"generation", n},
                   {"symbols", length},
                   {"frames", figures.size()},
                   {"symbols_a_frame", stride},
                   {"rounded", rounding_json(derived.rounded)},
                   {"output", options.output},
                   {"width", drawn.width},
                   {"height", drawn.height}}
                  .text());
    return success;
}

// A file of a figure in space.

/// The scene of one word of a system. `rounded` becomes the reason why its parameters are doubles.
Scene scene_of_word(const Options& options, const Model& system, std::uint64_t generation,
                    const Budget& budget, std::string& rounded) {
    const auto seeds = system.drawing.seeds;
    FigureChoices choices;
    if (!options.seed.empty())
        choices.seed = natural("--seed", options.seed);
    else if (seeds) {
        if (seeds->first != seeds->second)
            throw Error(system.name +
                        " shows the words of several seeds; say --seed S for the one of the mesh");
        choices.seed = seeds->first;
    }
    if (!options.tables.empty()) choices.tables = table_sequence(system.tables, options.tables);
    SpaceDerivation derived = scene(system, generation, budget, choices);
    Scene& found = derived.scene;
    if (found.name.empty())
        found.name = "generation " + std::to_string(generation) + " of " + system.name;
    rounded = derived.facts.rounded;
    note_rounding(system, generation, rounded);
    return std::move(found);
}

/// A file of a figure in space, which has nothing of a page.
int draw_to_mesh(const Options& options, MeshFormat format) {
    refuse_on_mesh({{"--seeds", options.seeds.has_value()},
                    {"--environment", !options.environment.empty()},
                    {"--width", options.width.has_value()},
                    {"--height", options.height.has_value()},
                    {"--margin", options.margin.has_value()},
                    {"--line-width", options.line_width.has_value()},
                    {"--font-size", options.font_size.has_value()},
                    {"--columns", options.columns.has_value()},
                    {"--caption", !options.caption.empty()},
                    {"--captions", options.captions},
                    {"--panels", options.panels},
                    {"--common-scale", options.common_scale},
                    {"--scale-bar", options.scale_bar},
                    {"--label", !options.labels.empty()},
                    {"--fog", options.space.fog.has_value()}},
                   format);
    if (format != MeshFormat::pov)
        refuse_on_mesh({{"--light", options.space.light.has_value()}}, format);
    check_motion(options, false);
    const Budget budget = options.bounds.budget();
    MeshChoices choices;
    if (options.space.camera) choices.camera = options.space.camera->camera;
    if (options.facets) choices.mesh.facets = static_cast<unsigned>(*options.facets);
    if (options.colours) choices.colours = *options.colours;
    if (!options.background.empty()) choices.background = options.background;
    choices.light = options.space.light;

    Json json;
    Scene scene;
    if (is_generator(options.file)) {
        scene =
            scene_of(*open_generator(options.file, budget, options.statements()), format, budget);
    } else {
        const Model system = open_drawn(options, budget, options.let);
        const std::uint64_t generation =
            options.generation.empty()
                ? shown_generations(system).second
                : one_generation(options, mesh_format_name(format) + std::string(" holds"));
        const ViewChoices view = view_choices(options.space, system, choices.background);
        choices.camera = view.camera;
        choices.light = view.light;
        std::string rounded;
        scene = scene_of_word(options, system, generation, budget, rounded);
        json.set("generation", generation);
        json.set("rounded", rounding_json(rounded));
    }
    json.update(write_mesh(scene, options.output, format, choices, budget));
    if (options.json) print(json.text());
    return success;
}

// Ranges of --let.

/// The generations of a picture; an animation begins with generation 0.
std::pair<std::uint64_t, std::uint64_t> generations_of(const Options& options, const Model& system,
                                                       bool moves) {
    if (!options.generation.empty()) {
        const Range wished = range("-n", options.generation);
        return {wished.first, wished.last};
    }
    const auto shown = shown_generations(system);
    if (options.space.turns()) return {shown.second, shown.second};
    return moves && shown.first == shown.second ? std::pair(std::uint64_t{0}, shown.second) : shown;
}

/// The values of --let NAME=FIRST..LAST:STEP, each as the --let that says it; one where it is no range.
std::vector<std::string> values_of_let(const std::string& let) {
    constexpr std::size_t most = 100;
    const std::size_t equals = let.find('='), dots = let.find("..");
    if (equals == std::string::npos || dots == std::string::npos) return {let};
    const std::size_t colon = std::min(let.find(':', dots), let.size());
    const auto value = [&](std::size_t begin, std::size_t end, const char* what) {
        const std::string text = let.substr(begin, end - begin);
        const auto none = [](const std::string&) -> const Quantity* { return nullptr; };
        try {
            if (const Quantity found = evaluate(read_expression(text), none); found.exact)
                return *found.exact;
        } catch (const Diagnostics&) {
        }
        refuse("--let " + let, std::string(what) + ", such as in a1=20..60:10", text);
    };
    const Rational first = value(equals + 1, dots, "a rational number before '..'"),
                   last = value(dots + 2, colon, "a rational number behind '..'"),
                   step = colon == let.size()
                              ? Rational(1)
                              : value(colon + 1, let.size(), "a rational step behind ':'");
    if (sign(step) == 0 || (step > 0) != (last >= first))
        throw Error("--let " + let + ": the step does not lead from " + shortest_text(first) +
                    " to " + shortest_text(last));
    std::vector<std::string> all;
    for (Rational at = first; step > 0 ? at <= last : at >= last; at += step) {
        if (all.size() == most)
            throw Error("--let " + let + ": has more than " + std::to_string(most) + " values");
        all.push_back(let.substr(0, equals + 1) + shortest_text(at));
    }
    return all;
}

/// What --let says of each panel: one of its options may be a range.
std::vector<std::vector<std::string>> panels_of_let(const std::vector<std::string>& let) {
    std::vector<std::vector<std::string>> all{{}};
    for (const std::string& one : let) {
        const std::vector<std::string> values = values_of_let(one);
        if (values.size() > 1 && all.size() > 1)
            throw Error("--let: expected one range of values, found two");
        std::vector<std::vector<std::string>> longer;
        for (const auto& before : all)
            for (const std::string& value : values) {
                longer.push_back(before);
                longer.back().push_back(value);
            }
        all = std::move(longer);
    }
    return all;
}

/// A figure for each value of a constant and each generation, with the systems that they show.
class VariedPlates {
public:
    VariedPlates(const Options& options, bool moves, const Budget& budget) {
        const auto variants = panels_of_let(options.let);
        for (const auto& let : variants) {
            const Model& system = systems_.emplace_back(open_drawn(options, budget, let));
            generations = generations_of(options, system, moves);
            if (is_other_picture(system.drawing)) return;  // has no figures
            FigurePlates plates(system, generations, choices_of(options, system), budget);
            if (!options.caption.empty())
                plates.caption(options.caption);
            else if (options.captions)
                plates.caption_with_facts();
            for (FigurePlate& plate : plates.figures) {
                plate.system = &system;
                for (std::size_t i = 0; i < let.size() && variants.size() > 1; ++i) {
                    if (let[i] == options.let[i]) continue;  // the same in all panels
                    const std::string said = ", " + let[i].substr(0, let[i].find('=')) + " = " +
                                             let[i].substr(let[i].find('=') + 1);
                    plate.name += said;
                    if (options.captions && options.caption.empty()) plate.caption += said;
                }
                figures.push_back(std::move(plate));
            }
        }
        varied = variants.size() > 1;
    }

    const Model& system() const { return systems_.front(); }

    std::vector<Plate> plates() const {
        std::vector<Plate> found;
        for (const FigurePlate& plate : figures)
            found.push_back({plate.figure.get(), plate.name, plate.caption});
        return found;
    }

    std::vector<FigurePlate> figures;
    std::pair<std::uint64_t, std::uint64_t> generations;
    bool varied = false;  // by a range of --let

private:
    std::deque<Model> systems_;  // which figures refer to
};

// Pictures and animations.

std::vector<double> numbers(const std::vector<Coordinate>& coordinates) {
    std::vector<double> values;
    for (const Coordinate& c : coordinates) values.push_back(c.value());
    return values;
}

Json figures_json(const VariedPlates& plates) {
    std::vector<Json> all;
    for (const FigurePlate& plate : plates.figures) {
        const Facts& facts = plate.figure->facts();
        Json one{{"generation", plate.generation}};
        if (plate.seed) one.set("seed", *plate.seed);
        if (plates.varied) one.set("figure", plate.name);
        one.set("segments", facts.segments);
        one.set("bounding_box", {{"min", numbers(facts.low)}, {"max", numbers(facts.high)}});
        one.set("end", numbers(facts.end));
        one.set("exact", facts.exact);
        one.set("rounded", rounding_json(facts.rounded));
        all.push_back(std::move(one));
    }
    return all.size() == 1 ? all.front() : Json{{"figures", all}};
}

Json as_json(const VariedPlates& plates, const Drawn& drawn, const std::string& path) {
    Json out = figures_json(plates);
    out.set("output", path);
    out.set("width", drawn.width);
    out.set("height", drawn.height);
    out.set("lines", drawn.lines);
    out.set("as_image", drawn.as_image);
    return out;
}

/// A number of bytes for people, its first digits: "5 MB", "6 EB".
std::string size_text(const Integer& bytes) {
    constexpr std::array units{"bytes", "kB", "MB", "GB", "TB", "PB", "EB"};
    const std::string digits = to_string(bytes);
    const std::size_t unit = (digits.size() - 1) / 3;
    if (unit >= units.size()) return "more than 10^" + std::to_string(digits.size() - 1) + " bytes";
    return digits.substr(0, digits.size() - 3 * unit) + " " + units[unit];
}

/// Throws Error if an svg would hold more strokes than any program opens: none of them is left out, and no image is put in
/// their place unless --raster asks for it.
void refuse_many_strokes(const std::vector<Plate>& plates) {
    constexpr long most = 20'000'000, bytes_of_a_stroke = 5;
    Integer strokes = 0;
    for (const Plate& plate : plates) strokes += plate.figure->segments();
    if (strokes <= most) return;
    const std::string digits = to_string(strokes);
    throw Error(
        (plates.size() == 1 ? plates.front().name + " has "
                            : "the " + std::to_string(plates.size()) + " figures have ") +
        (digits.size() > 30 ? "more than 10^" + std::to_string(digits.size() - 1) : digits) +
        " strokes, about " + size_text(strokes * bytes_of_a_stroke) + ": expected at most " +
        std::to_string(most) +
        " in svg; --raster puts an image in their place, a smaller -n has fewer");
}

/// A page of figures in space, which the reader turns: one for each generation.
int draw_to_scene_page(const Options& options, const PictureOptions& picture,
                       const Budget& budget) {
    refuse_given({{"--seeds", options.seeds.has_value()},
                  {"--environment", !options.environment.empty()},
                  {"--width", options.width.has_value()},
                  {"--height", options.height.has_value()},
                  {"--line-width", options.line_width.has_value()},
                  {"--plotter", options.plotter},
                  {"--panels", options.panels},
                  {"--scale-bar", options.scale_bar},
                  {"--label", !options.labels.empty()},
                  {"--light", options.space.light.has_value()},
                  {"--fog", options.space.fog.has_value()}},
                 ": a page shows one figure in space at a time, as large as the window");
    MeshChoices choices;
    if (options.space.camera) choices.camera = options.space.camera->camera;
    if (options.facets) choices.mesh.facets = static_cast<unsigned>(*options.facets);
    if (options.colours) choices.colours = *options.colours;
    if (!options.background.empty()) choices.background = options.background;
    PictureOptions said = picture;
    std::deque<Scene> scenes;
    std::string rounded;  // of the last one
    if (is_generator(options.file)) {
        const auto generator = open_generator(options.file, budget, options.statements());
        said.title = generator->title;
        scenes.push_back(scene_of(*generator, MeshFormat::x3d, budget));
    } else {
        for (const std::vector<std::string>& let : panels_of_let(options.let)) {
            const Model system = open_drawn(options, budget, let);
            said.title = system.title;
            said.source = system.source;
            choices.camera = view_choices(options.space, system, choices.background).camera;
            const auto [first, last] = generations_of(options, system, false);
            for (std::uint64_t n = first; n <= last; ++n)
                scenes.push_back(scene_of_word(options, system, n, budget, rounded));
        }
    }
    std::vector<NamedScene> all;
    for (const Scene& scene : scenes) all.push_back({&scene, scene.name});
    const MeshDrawn drawn = draw_scene_page(all, target_of(options.output), choices, said, budget);
    if (options.json) {
        Json json{{"scenes", all.size()}, {"segments", scenes.back().rods.size()}};
        json.set("parts", scenes.back().parts());
        json.set("bounding_box",
                 {{"min", Json::array({drawn.box.low.x, drawn.box.low.y, drawn.box.low.z})},
                  {"max", Json::array({drawn.box.high.x, drawn.box.high.y, drawn.box.high.z})}});
        json.set("output", options.output);
        json.set("format", "html");
        json.set("rounded", rounding_json(rounded));
        print(json.text());
    }
    return success;
}

/// Whether FILE is a figure in space.
bool is_in_space(const Options& options, const Budget& budget) {
    if (is_generator(options.file))
        return open_generator(options.file, budget, options.statements())
            ->scene(budget)
            .has_value();
    return leaves_plane(open_model(options.file, budget, panels_of_let(options.let).front()));
}

/// Files of generators: what -n and --seed say stands in their statements.
int draw_generator_file(const Options& options, PictureFormat format,
                        std::optional<FigureFormat> text, const PictureOptions& picture,
                        const Budget& budget) {
    refuse_given({{"--let", !options.let.empty()},
                  {"--seeds", options.seeds.has_value()},
                  {"--tables", !options.tables.empty()},
                  {"--angle", !options.settings.angle.empty()},
                  {"--start", !options.settings.start.empty()},
                  {"--environment", !options.environment.empty()},
                  {"--camera", options.space.camera.has_value()},
                  {"--light", options.space.light.has_value()},
                  {"--fog", options.space.fog.has_value()}},
                 " is for systems, and " + options.file + " is not one of them");
    const auto generator = open_generator(options.file, budget, options.statements());
    if (text) {
        const std::vector<GeneratorFigure> figures = generator->figures(budget);
        std::vector<FigureSource> all;
        for (const Plate& plate : generator_plates(figures, options.captions, options.caption))
            all.push_back({plate});
        PictureOptions said = picture;
        said.title = generator->title;
        return write_as_text(all, *text,
                             {options.output, said, options.plotter, all.size() > 1, options.json},
                             {}, budget);
    }
    const Drawn drawn = draw_generator(*generator, options.output, format, picture,
                                       options.captions, options.caption, budget);
    if (options.json) print(generator_json(*generator, drawn, options.output, budget).text());
    return success;
}

[[noreturn]] void refuse_panels() {
    throw Error("--panels: animations and explanations show one figure at a time");
}

/// A note behind a file of strokes that few programs open quickly.
void offer_raster(const Options& options, bool is_layered) {
    constexpr std::uintmax_t large = 2'000'000;
    std::error_code unknown;
    const std::uintmax_t bytes = std::filesystem::file_size(options.output, unknown);
    if (unknown || bytes <= large) return;
    note(options.output + " has " + std::to_string((bytes + 500'000) / 1'000'000) + " MB, every " +
         (is_layered ? "part that can be seen" : "stroke") +
         " is in it; --raster puts an image in their place");
}

int draw_as(const Options& options) {
    if (options.panels && (options.explain || options.progressive)) refuse_panels();
    if (options.common_scale && options.own_scale)
        throw Error("--common-scale and --own-scale: expected one of them");
    if (options.explain) return draw_explained(options);
    if (options.progressive) return draw_progressive(options);
    const std::string named = needed_format(options);
    if (const auto mesh = mesh_format(named)) return draw_to_mesh(options, *mesh);
    std::optional<FigureFormat> text = figure_format(named);
    if (options.facets && text != FigureFormat::html)
        throw Error("--facets is for html, " + mesh_format_names());
    const std::optional<AnimationFormat> animation = animation_format(named);
    const PictureFormat format = animation ? PictureFormat::png
                                 : text    ? PictureFormat::svg
                                           : picture_of(named);
    const bool is_music = text == FigureFormat::abc || text == FigureFormat::mid;
    if (options.plotter && (animation || is_music || format != PictureFormat::svg))
        throw Error(
            std::string("--plotter: expected svg, tex, typ, csv, geojson, dxf or html, found ") +
            (animation  ? "an animation"
             : is_music ? figure_format_name(*text)
                        : format_name(format)));
    if (options.raster && (animation || text || format == PictureFormat::png || options.plotter))
        throw Error(
            "--raster: puts an image into svg, pdf, ps or eps; expected one of these without "
            "--plotter");
    AnimationTiming timing =
        timing_of(options, options.space.turns()             ? usual_turn_time
                           : options.between.value_or(1) > 1 ? usual_progress_time
                                                             : usual_time);
    if (options.space.turns()) timing.last = timing.frame;  // it goes on where it began
    check_motion(options, animation.has_value());
    if (animation && options.panels) refuse_panels();
    PictureOptions picture = picture_options(options);
    const Budget budget = options.bounds.budget();
    if (text == FigureFormat::html && is_in_space(options, budget))
        return draw_to_scene_page(options, picture, budget);
    if (is_generator(options.file)) {
        if (!text && options.plotter) text = FigureFormat::svg;
        return draw_generator_file(options, format, text, picture, budget);
    }
    const VariedPlates plates(options, animation.has_value(), budget);
    if (is_other_picture(plates.system().drawing)) {
        if (animation || text || options.plotter || options.raster || options.panels)
            throw Error(plates.system().name + " shows a " + plates.system().drawing.picture +
                        "; expected svg, pdf, png, ps or eps");
        draw_other(plates.system(), plates.generations, options.output, format, picture, budget);
        return success;
    }
    const auto generations = plates.generations;
    picture.title = plates.system().title;
    picture.source = plates.system().source;
    for (PointLabel& label : labels_of(plates.system().drawing))
        picture.labels.push_back(std::move(label));

    const bool single = plates.figures.size() == 1;
    const bool pages = !single && !options.panels && !plates.varied &&
                       (format == PictureFormat::pdf || format == PictureFormat::ps);
    // What a file says of its own figure is drawn as well as the format can.
    const bool of_seeds = generations.first == generations.second;  // the words of several seeds
    const bool panels =
        options.panels ||
        ((options.generation.empty() || of_seeds || plates.varied) && !single && !pages);
    // Tables and pages have room for several figures.
    const bool apart = text && *text != FigureFormat::tex && *text != FigureFormat::typ;
    if (!single && !pages && !panels && !animation && !apart)
        throw Error(
            "-n " + options.generation +
            ": several generations need --panels, pdf or ps for pages, or gif, webp, mp4 or "
            "webm for an animation");
    const Target target = target_of(options.output);
    const std::vector<Plate> all = plates.plates();
    note_rounding(rounded_figures(plates.figures));
    suggest_start(options, plates.system());
    if (panels) {
        if (!picture.columns) picture.columns = plates.system().drawing.columns;
        picture.common_scale =
            options.common_scale ||
            (!options.own_scale && has_common_scale(plates.system().drawing, all));
    }
    if (!text && !animation && !options.raster && format == PictureFormat::svg) {
        if (!options.plotter) refuse_many_strokes(all);
        text = FigureFormat::svg;
    }
    if (text) {
        const FigureSources sources(plates.figures, choices_of(options, plates.system()), *text,
                                    options.plotter, budget);
        const int status = write_as_text(
            sources.all, *text, {options.output, picture, options.plotter, panels, options.json},
            figures_json(plates), budget);
        if (*text == FigureFormat::svg && !options.plotter)
            offer_raster(options, all.front().figure->is_layered());
        return status;
    }
    ProgressBar bar("Drawing");
    const Drawn drawn =
        animation           ? draw_animation(all, target, *animation, picture, timing, budget, &bar)
        : single && !panels ? draw_picture(all.front(), target, format, picture, budget, &bar)
        : pages             ? draw_pages(all, target, format, picture, budget, &bar)
                            : draw_panels(all, target, format, picture, budget, &bar);
    if (drawn.as_image && !options.raster)
        note("too many strokes for a vector format, drawn as an image within it");
    if (!drawn.as_image && !animation && format != PictureFormat::png)
        offer_raster(options, all.front().figure->is_layered());
    for (const std::size_t blank : drawn.blank)
        note("nothing is drawn in generation " + std::to_string(plates.figures[blank].generation));
    if (options.json) print(as_json(plates, drawn, options.output).text());
    return success;
}

/// The colours that FILE itself says.
std::vector<std::string> own_colours(const Options& options, const Budget& budget) {
    if (is_generator(options.file))
        return open_generator(options.file, budget, options.statements())->style.colours;
    return open_model(options.file, budget, panels_of_let(options.let).front()).drawing.colours;
}

int draw_once(const Options& options) {
    if (!options.theme) return draw_as(options);
    if (options.file == "-")
        throw Error(
            "--theme: standard input is read once, and its colours before; expected a file");
    return draw_as(themed(options, own_colours(options, options.bounds.budget())));
}

/// Draws again whenever FILE changes, until it is told to stop. A mistake in FILE is told, and waits for the next change.
int draw_watching(const Options& options) {
    constexpr std::chrono::milliseconds pause(100);
    namespace fs = std::filesystem;
    std::error_code unknown;
    if (options.file == "-" || !fs::is_regular_file(options.file, unknown))
        throw Error("--watch: expected a file that may change, found " +
                    algae::quoted(options.file));
    if (options.output.empty() || options.output == "-")
        throw Error("--watch: expected -o with the name of a file");
    Budget waiting = options.bounds.budget();
    waiting.deadline.reset();
    std::optional<fs::file_time_type> drawn;
    for (;;) {
        const fs::file_time_type changed = fs::last_write_time(options.file, unknown);
        if (!unknown && changed != drawn) {
            drawn = changed;
            try {
                draw_once(options);
                note(options.output + " is drawn, and again when " + options.file +
                     " changes; Ctrl-C ends it");
            } catch (const Interrupted&) {
                throw;
            } catch (const std::exception& error) {
                note(error.what());
            }
        }
        waiting.check();
        std::this_thread::sleep_for(pause);
    }
}

int draw(const Options& options) {
    return options.watch ? draw_watching(options) : draw_once(options);
}

}  // namespace

void add_draw(Verbs& verbs) {
    auto [verb, options] =
        verbs.add("draw", "The turtle figure of a generation",
                  {"algae draw koch -n 4 -o koch.svg",
                   "algae draw plant-f -n 0..5 --panels --captions -o plants.pdf",
                   "algae draw dragon -n 0..10 --frame-time 0.5 -o dragon.gif",
                   "algae draw plant-f -n 0..4 --between 24 --common-scale -o growing.gif",
                   "algae draw hilbert-3d --camera 30,20,perspective -o hilbert.png",
                   "algae draw hilbert-3d --camera 0..360,20 -o hilbert.gif"},
                  draw);
    verb.option("FILE", options.file, file_type, file_help).required = true;
    add_let_option(verb, options.let);
    verb.option("-n", options.generation, "N[..M]",
                "the generation, or a range such as 0..6: pages of a pdf, frames of an animation, "
                "or --panels (default: what the file says)");
    verb.output("-o,--output", options.output, "FILE",
                "the picture: .svg, .pdf, .png, .ps or .eps, the animation: .gif, .webp, .mp4 or "
                ".webm (both by ffmpeg), the figure as text: .tex (TikZ), .typ (Typst), .csv, "
                ".geojson, .dxf or .html, music: .abc or .mid, the "
                "figure in space: .glb, .obj, .ply, .stl, .x3d, .wrl or .pov (for POV-Ray); - for "
                "standard output");
    verb.option("--format", options.format,
                std::string(picture_formats) + '|' + text_formats + '|' + mesh_formats,
                "the format, where the name does not say it; vrml1 for VRML 1.0");
    verb.flag("--panels", options.panels, "several generations side by side");
    verb.option("--columns", options.columns, natural, "N", "panels in a row");
    verb.flag(
        "--common-scale", options.common_scale,
        "the same scale for all generations, which panels have anyway where none is 8 times as "
        "large as another; in an animation, the same part of the plane");
    verb.flag("--own-scale", options.own_scale, "each panel's figure as large as its panel");
    options.settings.add_to(verb);
    verb.option("--width", options.width, positive, "W",
                "of the picture, in points (png and animations: pixels)");
    verb.option("--height", options.height, positive, "H",
                "of the picture, in points (png and animations: pixels)");
    verb.option("--margin", options.margin, positive_or_zero, "M", "blank border (default 10)");
    verb.option(
        "--line-width", options.line_width, positive, "W",
        "of strokes, in points or pixels (default 1, more in large pictures, less where strokes "
        "are dense)");
    verb.option("--colour", options.colours, list, "COLOUR,...",
                "names or #rrggbb, the next for each '; or what runs with the word: along (hues), "
                "viridis, cividis; currentColor, in an svg that of the text around it");
    verb.option(
        "--theme", options.theme, theme, "light|dark|print",
        "what the picture is for: dark draws in light colours on a dark page, print in greys");
    verb.option("--background", options.background, "COLOUR",
                "a colour, or transparent (default: white in png and animations, none elsewhere)");
    verb.flag("--captions", options.captions, "system, generation and angle underneath");
    verb.option("--caption", options.caption, "TEXT", "a text underneath");
    verb.option("--font-size", options.font_size, positive, "S", "of captions");
    verb.option("--seed", options.seed, "S",
                "the word of a system with choices that this seed picks (what the file says; 1 for "
                "systems with probabilities)");
    verb.option("--seeds", options.seeds, range, "A..B",
                "a figure for each of these seeds, such as 1..9, side by side");
    verb.option("--tables", options.tables, "SEQUENCE",
                "the table of each step: light,dark or, of one character each, abab or 1212");
    options.space.add_to(verb);
    verb.flag("--plotter", options.plotter,
              "each segment once, joined to as few paths as possible with short ways between: svg, "
              "dxf and the other figures as text");
    verb.flag("--raster", options.raster,
              "an image of the strokes in svg, pdf, ps or eps, for figures that have too many");
    verb.option("--author", options.author, "TEXT", "what pdf, svg and html say of the author");
    verb.flag("--scale-bar", options.scale_bar,
              "a bar below the figure with its length, in the units of the file");
    verb.option("--label", options.labels, point_label, "TEXT@x,y[,z]",
                "a text at a point of the figure; may be given several times");
    verb.option(
        "--frame-time", options.frame_time, positive, "SECONDS",
        "of an animation: seconds a frame (default 0.8; with --progressive and --between 0.05, "
        "around a figure 0.08)");
    verb.option(
        "--between", options.between, between_count, "N",
        "of an animation: grow from each generation to the next in so many frames, 1 to 1000; "
        "what is new begins without length, and a stroke that becomes several as these in a line");
    verb.option("--loop", options.loop, natural, "N",
                "of a gif or webp: how often it is shown; 0, the default, for ever");
    verb.flag(
        "--progressive", options.progressive,
        "one generation symbol by symbol, with the turtle where it is: an animation, or pages "
        "of pdf or ps");
    verb.option("--max-frames", options.max_frames, frame_bound, "N",
                "of --progressive: several symbols a frame where there would be more (default "
                "240)");
    verb.flag("--explain", options.explain,
              "numbered steps, the turtle at every corner and a table of what each symbol does; "
              "without -o the table alone");
    verb.option("--facets", options.facets, facet_count, "K",
                "of files of figures in space: sides of a tube, 3 to 256 (default 8)");
    verb.flag("--watch", options.watch, "draw again whenever FILE changes, until Ctrl-C");
    add_environment_option(verb, options.environment);
    verb.json_flag(options.json,
                   "print segments, bounding box and end as one JSON object; integers from 2^53 on "
                   "are strings");
    verb.bounded_by(options.bounds);
}

}  // namespace algae::command
