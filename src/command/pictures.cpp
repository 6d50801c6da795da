// What the verbs that draw share: the figures of a system or of another generator, and their output.
//
// A system is drawn as plates, one for each generation and seed. A figure in the plane is traversed and
// never stored; a system that leaves the plane becomes a scene, seen by a camera. Options of the
// camera are refused if there is none. Files of figures in space (glb, obj, ...) contain the scene itself and
// have no pages.

#include "command/detail/pictures.hpp"

#include <charconv>
#include <cmath>
#include <cstdio>
#include <limits>

#include "command/detail/choices.hpp"
#include "command/detail/files.hpp"
#include "exact/exact.hpp"
#include "model/model.hpp"
#include "notation/notation.hpp"
#include "system/system.hpp"
#include "turtle/turtle.hpp"

namespace algae::command {

namespace {

/// A reader of the text of --camera.
MovingCamera camera(const std::string& option, const std::string& text) {
    const std::string expected = "AZIMUTH,ELEVATION or AZIMUTH,ELEVATION,perspective[:DEGREES]";
    const std::vector<std::string> parts = between_commas(text);
    const std::size_t dots = parts[0].find("..");
    const auto azimuth = number(parts[0].substr(0, dots));
    const auto last = dots == std::string::npos ? std::nullopt : number(parts[0].substr(dots + 2));
    // A turntable may leave the elevation as it is.
    const auto elevation = parts.size() > 1            ? number(parts[1])
                           : dots != std::string::npos ? std::optional(Camera{}.elevation)
                                                       : std::nullopt;
    if (!azimuth || !elevation || parts.size() > 3 || (dots != std::string::npos && !last))
        refuse(option, expected, text);
    if (last && (*last == *azimuth || std::fabs(*last - *azimuth) > 3600))
        refuse(option, "a turn of at most 3600 degrees, such as 0..360", parts[0]);
    Camera found{*azimuth, *elevation};
    if (parts.size() == 3) {
        const std::string word = "perspective";
        const std::string& said = parts[2];
        const bool opens = said.starts_with(word + ':');
        const auto opening = opens ? number(said.substr(word.size() + 1)) : std::nullopt;
        if ((said != word && !opens) || (opens && !opening)) refuse(option, expected, text);
        found.perspective = true;
        if (opening) found.opening = *opening;
    }
    try {
        check_camera(found);
    } catch (const Error& error) {
        throw Error(option + ": " + error.what());
    }
    return {found, last};
}

/// A reader of the text of --light.
Light light(const std::string& option, const std::string& text) {
    const std::vector<std::string> parts = between_commas(text);
    const auto azimuth = number(parts[0]);
    const auto elevation = parts.size() == 2 ? number(parts[1]) : std::nullopt;
    if (!azimuth || !elevation) refuse(option, "AZIMUTH,ELEVATION", text);
    if (std::fabs(*elevation) > 90) refuse(option, "an elevation from -90 to 90 degrees", parts[1]);
    return Light{*azimuth, *elevation};
}

/// A reader of the text of --fog.
double fog_share(const std::string& option, const std::string& text) {
    const auto share = number(text);
    if (!share || *share < 0 || *share > 1) refuse(option, "a number from 0 to 1", text);
    return *share;
}

}  // namespace

std::vector<Camera> MovingCamera::stations() const {
    if (!last) return {camera};
    constexpr double stride = 5;  // degrees
    const double turn = *last - camera.azimuth;
    const auto steps = static_cast<std::size_t>(std::max(1.0, std::ceil(std::fabs(turn) / stride)));
    const bool comes_round = std::fmod(turn, 360) == 0;
    std::vector<Camera> found(comes_round ? steps : steps + 1, camera);
    for (std::size_t i = 0; i < found.size(); ++i)
        found[i].azimuth += turn * static_cast<double>(i) / static_cast<double>(steps);
    return found;
}

void SpaceOptions::add_to(Verb& verb) {
    verb.option("--camera", camera, command::camera,
                "AZIMUTH[..LAST],ELEVATION[,perspective[:DEGREES]]",
                "of figures in space: where the camera stands in degrees, from +x towards +y and "
                "above the horizon (default -60,15), and whether it sees in perspective; 0..360,15 "
                "goes around the figure, in an animation");
    verb.option("--light", light, command::light, "AZIMUTH,ELEVATION",
                "of figures in space: where the light comes from (default: over the camera's left "
                "shoulder)");
    verb.option("--fog", fog, fog_share, "F",
                "of figures in space: the share of the background in the colour of what is "
                "farthest, 0 to 1 (default 0)");
}

void SpaceOptions::check_unused(const std::string& name) const {
    refuse_given({{"--camera", camera.has_value()},
                  {"--light", light.has_value()},
                  {"--fog", fog.has_value()}},
                 " is for figures in space, and those of " + name + " stay in the plane");
}

void SettingOptions::add_to(Verb& verb) {
    verb.option("--angle", angle, "DEGREES",
                "that + and - turn by, instead of what the file says: 22.5 or 180/7");
    verb.option(
        "--start", start, "upward|X Y HEADING",
        "where the turtle starts, instead of what the file says: upward lets a plant stand, in "
        "the plane and in space");
}

Model SettingOptions::applied_to(Model system) const {
    const auto read = [](const char* option, const char* keyword, std::string value) {
        for (char& letter : value)
            if (letter == ',') letter = ' ';
        if (value.find_first_of(";\n\r#{}<>") != std::string::npos)
            refuse(option, std::string("what follows `") + keyword + "` in a file", value);
        try {
            return read_lsystem(std::string("axiom F\n") + keyword + ' ' + value, "").drawing;
        } catch (const Diagnostics& error) {
            throw Error(std::string(option) + ": " + error.findings().front().message);
        }
    };
    if (!angle.empty()) system.drawing.angle = read("--angle", "angle", angle).angle;
    if (!start.empty()) system.drawing.start = read("--start", "start", start).start;
    return system;
}

Theme theme(const std::string& option, const std::string& text) {
    if (text == "light") return Theme::light;
    if (text == "dark") return Theme::dark;
    if (text == "print") return Theme::print;
    refuse(option, "light, dark or print", text);
}

namespace {

std::string code_of(const Colour& colour) {
    const auto part = [](double value) { return static_cast<int>(std::lround(255 * value)); };
    char text[8];
    std::snprintf(text, sizeof text, "#%02x%02x%02x", part(colour.red), part(colour.green),
                  part(colour.blue));
    return text;
}

}  // namespace

ThemeColours theme_colours(Theme theme, const std::vector<std::string>& own,
                           const std::optional<std::string>& background) {
    constexpr const char* dark_page = "#15171a";
    constexpr const char* light_ink = "#e8e8e4";
    ThemeColours found{background, own};
    if (theme == Theme::light) return found;
    if (theme == Theme::dark && !background) found.background = dark_page;
    const bool is_shown = found.background && *found.background != "transparent";
    const Colour page = is_shown ? colour_named(*found.background)
                                 : colour_named(theme == Theme::dark ? dark_page : "white");
    if (found.colours.empty()) found.colours = {"black"};
    for (std::string& name : found.colours) {
        if (is_scheme(name)) {
            if (theme == Theme::print) name = "black";
            continue;
        }
        const Colour colour = colour_named(name);
        if (theme == Theme::dark) {
            const bool is_black = colour == Colour{};
            name = is_black ? light_ink : code_of(readable_on(colour, page));
            continue;
        }
        const double grey =
            0.2126 * colour.red + 0.7152 * colour.green + 0.0722 * colour.blue;  // ITU-R BT.709
        name = code_of(readable_on({grey, grey, grey}, page));
    }
    return found;
}

bool has_common_scale(const Drawing& drawing, std::span<const Plate> plates) {
    constexpr double most = 8;
    if (drawing.common_scale) return *drawing.common_scale;
    double least = std::numeric_limits<double>::infinity(), largest = 0;
    for (const Plate& plate : plates) {
        const Box& box = plate.figure->box();
        const double longer = std::max(box.breadth(), box.height());
        if (!(longer > 0)) continue;
        least = std::min(least, longer);
        largest = std::max(largest, longer);
    }
    return plates.size() > 1 && largest > least && largest < most * least;
}

bool is_other_picture(const Drawing& drawing) {
    return !drawing.picture.empty() && drawing.picture != picture_kinds().front();
}

namespace {

/// The derivation tree of a generation, by the rules or as it was derived.
Graph derivation_graph(const Model& system, std::uint64_t n, const Budget& budget) {
    constexpr std::uint64_t most_modules = 2000;
    if (const View<D0L> rules = as_d0l(system)) {
        if (tree_size(*rules, n, {}, budget) > Integer(most_modules))
            throw BoundReached(Bound::nodes, "the derivation tree of generation " +
                                                 std::to_string(n) + " has more than " +
                                                 std::to_string(most_modules) + " nodes");
        return tree_graph(derivation_tree(*rules, n, {}, budget));
    }
    const auto seed =
        system.drawing.seeds ? std::optional(system.drawing.seeds->first) : std::nullopt;
    const Rewriting rewriting(system, derivation_choices(system, seed, seed.has_value()), budget);
    const std::vector<std::size_t> tables = derivation_tables(system, "", seed.has_value());
    check_long_enough(tables, n);
    const ModuleTrace trace = traced(rewriting, n, tables, most_modules, budget);
    return tree_graph(derivation_tree(rewriting, trace, {}, budget));
}

}  // namespace

void draw_other(const Model& system, std::pair<std::uint64_t, std::uint64_t> generations,
                const std::string& path, PictureFormat format, const PictureOptions& picture,
                const Budget& budget) {
    const auto& [first, last] = generations;
    const std::string& kind = system.drawing.picture;
    if (kind == "plot") {
        const View<D0L> rules = as_d0l(system);
        if (!rules) throw Error("a plot of lengths: " + rules.reason());
        draw_plot(growth_plot(*rules, first, last, budget), path, budget);
        return;
    }
    if (first != last)
        throw Error("a " + kind + " shows one generation, expected a line such as `generation " +
                    std::to_string(last) + "`");
    if (kind == "tree") {
        GraphOptions options;
        options.width = picture.width;
        options.height = picture.height;
        options.background = picture.background;
        draw_graph(derivation_graph(system, last, budget), target_of(path), format, options,
                   budget);
        return;
    }
    FigureChoices choices;
    if (system.drawing.seeds) choices.seed = system.drawing.seeds->first;
    const DerivedModules derived = open_modules(system, last, choices, nullptr, budget);
    note_rounding(system, last, derived.rounded);
    const Explanation explained =
        explanation(system, derived.kinds, derived.word, last, derived.seed, budget);
    PictureOptions options = picture;
    if (options.colours.empty()) options.colours = system.drawing.colours;
    draw_explanation(explained, system.title.empty() ? system.name : system.title, target_of(path),
                     format, options, budget);
}

ViewChoices view_choices(const SpaceOptions& options, const Model& system,
                         const std::optional<std::string>& background) {
    ViewChoices choices = view_choices(system.drawing);
    if (options.camera) choices.camera = options.camera->camera;
    if (options.light) choices.light = *options.light;
    if (options.fog) choices.fog = *options.fog;
    if (background && *background != "transparent") choices.background = colour_named(*background);
    return choices;
}

PointLabel point_label(const std::string& option, const std::string& text) {
    const std::string expected = "TEXT@x,y or TEXT@x,y,z";
    const auto at = text.rfind('@');
    if (at == std::string::npos || at == 0) refuse(option, expected, text);
    const std::vector<std::string> parts = between_commas(text.substr(at + 1));
    if (parts.size() != 2 && parts.size() != 3) refuse(option, expected, text);
    PointLabel label{text.substr(0, at), {}};
    double* const into[] = {&label.place.x, &label.place.y, &label.place.z};
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const auto value = number(parts[i]);
        if (!value) refuse(option, expected, text);
        *into[i] = *value;
    }
    return label;
}

std::vector<PointLabel> labels_of(const Drawing& drawing) {
    std::vector<PointLabel> found;
    for (const Drawing::Label& label : drawing.labels)
        found.push_back(
            {label.text, {label.place.x.value, label.place.y.value, label.place.z.value}});
    return found;
}

std::string named_format(const std::string& output, const std::string& format) {
    if (!format.empty()) return "figure." + format;
    if (output == "-")
        throw Error(
            "-o -: say which format with --format: svg, pdf, png, ps, eps, gif, webp, mp4, webm, "
            "tex, typ, csv, geojson, dxf, html, abc, mid, " +
            mesh_format_names());
    return output;
}

Target target_of(const std::string& output) {
    if (output == "-") return std::cout;
    return output;
}

void refuse_given(const std::vector<std::pair<const char*, bool>>& given, const std::string& why) {
    for (const auto& [option, is_given] : given)
        if (is_given) throw Error(option + why);
}

void refuse_on_mesh(const std::vector<std::pair<const char*, bool>>& given, MeshFormat format) {
    refuse_given(given, std::string(": ") + mesh_format_name(format) +
                            " is not a picture; it contains one figure in space");
}

FigurePlates::FigurePlates(const Model& system, std::pair<std::uint64_t, std::uint64_t> generations,
                           const PlateChoices& choices, const Budget& budget)
    : title_(system.title.empty() ? system.name : system.title) {
    if (const auto& angle = system.drawing.angle) {
        const auto decimal = angle->exact ? exact_decimal(*angle->exact) : std::nullopt;
        angle_ = (decimal ? *decimal : to_text(angle->expression)) + "°";
    }
    const auto seeds = choices.seeds ? choices.seeds : system.drawing.seeds;
    if (!seeds && choices.tables.empty()) {
        if (const View<D0L> rules = as_d0l(system); !rules && as_ol(system))
            throw Error(rules.reason() + "; say --seed S to draw one word picked at random");
        if (leaves_tables_open(system))
            throw Error(
                "it has " + std::to_string(system.tables.size()) +
                " tables and no schedule; say --tables SEQUENCE, or --seed S for random ones");
    }
    many_seeds_ = seeds && seeds->first != seeds->second;
    const bool in_space = leaves_plane(system);
    if (!in_space) choices.space.check_unused(system.name);
    Model painted = system;
    if (!choices.colours.empty()) painted.drawing.colours = choices.colours;
    const ViewChoices view_of = view_choices(choices.space, system, choices.background);
    if (choices.space.turns()) {
        if (generations.first != generations.second || many_seeds_)
            throw Error("--camera " + rounded_decimal(choices.space.camera->camera.azimuth, 6) +
                        ".." + rounded_decimal(*choices.space.camera->last, 6) +
                        ": goes around one figure, found several; expected one generation, -n N, "
                        "and one seed");
        const auto seed = seeds ? std::optional(seeds->first) : std::nullopt;
        const SpaceDerivation found = scene(painted, generations.first, budget,
                                            {seed, choices.tables, choices.seeds.has_value()},
                                            external_environment(choices.environment, system));
        auto views = turned_views(found, style_of(painted.drawing), view_of,
                                  choices.space.camera->stations(), budget);
        for (std::unique_ptr<Figure>& view : views) {
            FigurePlate& plate = figures.emplace_back();
            plate.generation = generations.first;
            plate.seed = seed;
            plate.name = "generation " + std::to_string(generations.first) + " of " + system.name;
            plate.figure = std::move(view);
        }
        return;
    }
    const auto seen = [&](SpaceDerivation found) {
        return std::make_unique<SpaceView>(
            std::move(found.scene), style_of(painted.drawing),
            SceneFacts{found.end.position, found.facts.step, found.facts.rounded}, view_of, budget);
    };
    const auto add = [&](std::uint64_t n, std::optional<std::uint64_t> seed) {
        FigurePlate& plate = figures.emplace_back();
        plate.generation = n;
        plate.seed = seed;
        plate.name = "generation " + std::to_string(n) + " of " + system.name;
        if (many_seeds_) plate.name += ", seed " + std::to_string(*seed);
        if (in_space) {
            plate.figure =
                seen(scene(painted, n, budget, {seed, choices.tables, choices.seeds.has_value()},
                           external_environment(choices.environment, system)));
            return;
        }
        const FigureChoices chosen{seed, choices.tables, choices.seeds.has_value()};
        auto external = external_environment(choices.environment, system);
        if (!class_of(system).parametric) {
            plate.figure = open_figure(system, n, budget, chosen, std::move(external));
            return;
        }
        constexpr std::size_t most_kept = 1'000'000;  // modules
        DerivedModules derived = open_modules(system, n, chosen, std::move(external), budget);
        if (derived.word.kinds.size() <= most_kept)
            plate.derived = std::make_shared<const DerivedModules>(derived);
        plate.figure = figure(system, std::move(derived), n, budget);
    };
    /// The figures on the way from generation n to the next.
    const auto grow = [&](std::uint64_t n, std::optional<std::uint64_t> seed) {
        const FigureChoices chosen{seed, choices.tables, choices.seeds.has_value()};
        const auto development =
            std::make_shared<const ContinuousDevelopment>(painted, n, chosen, budget);
        for (std::uint64_t k = 1; k < choices.between; ++k) {
            budget.check();
            const double share = static_cast<double>(k) / static_cast<double>(choices.between);
            DerivedModules derived = development->at(share, budget);
            const Model& walked = development->system();
            FigurePlate& plate = figures.emplace_back();
            plate.generation = n;
            plate.seed = seed;
            plate.development = development;
            plate.name = "what is between generations " + std::to_string(n) + " and " +
                         std::to_string(n + 1) + " of " + system.name;
            if (in_space)
                plate.figure =
                    seen(scene(walked, derived.kinds, derived.word, n + 1, derived.seed, budget));
            else
                plate.figure = figure(walked, std::move(derived), n + 1, budget);
        }
    };
    if (choices.between > 1 && (many_seeds_ || generations.first == generations.second))
        throw Error("--between: expected several generations of one word, such as -n 0..6, found " +
                    (many_seeds_ ? "several seeds"
                                 : "generation " + std::to_string(generations.first) + " alone"));
    for (std::uint64_t n = generations.first; n <= generations.second; ++n) {
        if (choices.between > 1 && n > generations.first)
            grow(n - 1, seeds ? std::optional(seeds->first) : std::nullopt);
        if (!seeds)
            add(n, std::nullopt);
        else
            for (std::uint64_t seed = seeds->first; seed <= seeds->second; ++seed) add(n, seed);
    }
}

void FigurePlates::caption(const std::string& text) {
    for (FigurePlate& plate : figures) plate.caption = text;
}

void FigurePlates::caption_with_facts() {
    for (FigurePlate& plate : figures) {
        plate.caption = title_ + ", n = " + std::to_string(plate.generation);
        if (!angle_.empty()) plate.caption += ", " + angle_;
        if (many_seeds_) plate.caption += ", seed " + std::to_string(*plate.seed);
    }
}

std::vector<Plate> FigurePlates::plates() const {
    std::vector<Plate> found;
    for (const FigurePlate& plate : figures)
        found.push_back({plate.figure.get(), plate.name, plate.caption});
    return found;
}

std::vector<Rounded> rounded_figures(const std::vector<FigurePlate>& figures) {
    std::vector<Rounded> found;
    for (const FigurePlate& plate : figures)
        if (const std::string& reason = plate.figure->facts().rounded; !reason.empty())
            found.emplace_back(plate.name, reason);
    return found;
}

std::string rounding_text(const std::vector<Rounded>& figures) {
    if (figures.empty()) return "";
    const auto& [name, reason] = figures.front();
    return "the parameters of " + name +
           (figures.size() == 1 ? "" : " and of " + counted(figures.size() - 1, "other figure")) +
           " are doubles, rounded in each step: " + reason;
}

void note_rounding(const std::vector<Rounded>& figures) {
    if (!figures.empty()) note(rounding_text(figures));
}

void note_rounding(const Model& system, std::uint64_t n, const std::string& reason) {
    if (reason.empty()) return;
    note_rounding(
        {{"generation " + std::to_string(n) + (system.name.empty() ? "" : " of " + system.name),
          reason}});
}

/// The letters of a word by their positions.
struct FigureSources::Letters {
    std::shared_ptr<const DerivedModules> derived;
    std::vector<std::string> names;  // by kind
    std::string_view at(std::uint64_t position) const {
        return names[derived->word.kinds[static_cast<std::size_t>(position)]];
    }
};

FigureSources::FigureSources(const std::vector<FigurePlate>& plates, const PlateChoices& choices,
                             FigureFormat format, bool plotter, const Budget& budget) {
    const bool exact = format == FigureFormat::csv || format == FigureFormat::geojson;
    for (const FigurePlate& plate : plates) {
        FigureSource& source = all.emplace_back();
        source.plate = {plate.figure.get(), plate.name, plate.caption};
        source.generation = plate.generation;
        // An external program is not asked twice, and what is seen in space is in the order of its depth.
        if (!plate.system || !choices.environment.empty() || plate.figure->is_layered()) continue;
        if (!names_letters(*plate.figure, format, plotter)) continue;
        const Model& system = *plate.system;
        const FigureChoices chosen{plate.seed, choices.tables, choices.seeds.has_value()};
        try {
            auto letters = std::make_shared<Letters>();
            letters->derived = plate.derived;
            if (!letters->derived)
                letters->derived = std::make_shared<const DerivedModules>(
                    open_modules(system, plate.generation, chosen, nullptr, budget));
            const ModuleKinds& kinds = letters->derived->kinds;
            for (std::size_t kind = 0; kind < kinds.size(); ++kind)
                letters->names.push_back(
                    system.alphabet.name(kinds.letter(static_cast<ModuleKind>(kind))));
            source.modules = letters->derived->word.kinds.size();
            source.letter = [letters = letters.get()](std::uint64_t at) { return letters->at(at); };
            letters_.push_back(std::move(letters));
        } catch (const BoundReached& bound) {
            if (bound.bound() == Bound::time) throw;
        }
        if (!exact || !plate.figure->facts().exact) continue;
        try {
            source.outline =
                std::make_shared<const Outline>(outline(system, plate.generation, budget, chosen));
            const auto& start = system.drawing.start;
            if (!start)
                source.start = {0, 0};
            else if (start->x.exact && start->y.exact)
                source.start = {*start->x.exact, *start->y.exact};
        } catch (const BoundReached& bound) {
            if (bound.bound() == Bound::time) throw;
        }
    }
}

namespace {

Json text_json(const FigureTextDrawn& drawn, FigureFormat format, bool plotter) {
    Json out{{"format", figure_format_name(format)},
             {"strokes", drawn.strokes},
             {"paths", drawn.paths},
             {"polygons", drawn.polygons}};
    if (drawn.width > 0) out.set("width", drawn.width).set("height", drawn.height);
    if (format == FigureFormat::csv || format == FigureFormat::geojson)
        out.set("exact", drawn.exact);
    if (drawn.notes > 0) out.set("notes", drawn.notes);
    if (plotter)
        out.set("repeated", drawn.repeated)
            .set("travel", drawn.travel)
            .set("travel_in_order_of_word", drawn.travelled);
    return out;
}

}  // namespace

int write_as_text(const std::vector<FigureSource>& all, FigureFormat format,
                  const TextChoices& options, Json facts, const Budget& budget) {
    FigureTextOptions text;
    text.picture = options.picture;
    text.plotter = options.plotter;
    text.panels = options.panels;
    ProgressBar bar("Drawing");
    const FigureTextDrawn drawn =
        draw_as_text(all, target_of(options.output), format, text, budget, &bar);
    for (const std::size_t blank : drawn.blank)
        note("nothing is drawn in " + all[blank].plate.name);
    constexpr std::uint64_t many_for_tex = 20'000;
    if (format == FigureFormat::tex && drawn.strokes > many_for_tex)
        note(std::to_string(drawn.strokes) +
             " strokes: TeX may take minutes; a pdf of the same figure is set at once");
    if (options.plotter) {
        std::string said = std::to_string(drawn.strokes) + " segments in " +
                           std::to_string(drawn.paths) + (drawn.paths == 1 ? " path" : " paths");
        if (drawn.paths == 1) said += ", one stroke: an Euler path";
        if (drawn.repeated > 0) said += "; " + std::to_string(drawn.repeated) + " were repeated";
        if (drawn.paths > 1)
            said += "; the pen is up for " + rounded_decimal(drawn.travel, 4) + " units, in the " +
                    "order of the word for " + rounded_decimal(drawn.travelled, 4);
        note(said);
    }
    if (!options.json) return success;
    facts.set("output", options.output);
    facts.update(text_json(drawn, format, options.plotter));
    print(facts.text());
    return success;
}

std::pair<std::uint64_t, std::uint64_t> shown_generations(const Model& system) {
    if (!system.drawing.generations)
        throw Error(system.name +
                    " does not say which generation its figure shows; expected a line such as "
                    "`generation 4` in it, or "
                    "-n of `algae draw`");
    return *system.drawing.generations;
}

namespace {

Json corner(const Vector& v) { return Json::array({v.x, v.y, v.z}); }

}  // namespace

PictureFormat picture_of(const std::string& named) {
    try {
        return picture_format(named);
    } catch (const Error& error) {
        throw Error(std::string(error.what()) +
                    "; an animation ends in .gif, .webp, .mp4 or .webm, a figure as text in .tex, "
                    ".typ, .csv, .geojson, .dxf or .html, music in .abc or .mid, a figure in space "
                    "in .glb, .obj, .ply, "
                    ".stl, .x3d, .wrl or .pov, or say --format vrml1");
    }
}

Json write_mesh(const Scene& scene, const std::string& output, MeshFormat format,
                const MeshChoices& choices, const Budget& budget) {
    const MeshDrawn drawn = draw_mesh(scene, target_of(output), format, choices, budget);
    Json json;
    json.set("segments", scene.rods.size());
    json.set("bounding_box", {{"min", corner(drawn.box.low)}, {"max", corner(drawn.box.high)}});
    json.set("vertices", drawn.vertices);
    json.set("triangles", drawn.triangles);
    if (drawn.solids) json.set("solids", drawn.solids);
    if (drawn.lines) json.set("lines", drawn.lines);
    json.set("output", output);
    json.set("format", mesh_format_name(format));
    return json;
}

Scene scene_of(const Generator& generator, MeshFormat format, const Budget& budget) {
    auto found = generator.scene(budget);
    if (!found)
        throw Error(generator.name + " lies in the plane, and " + mesh_format_name(format) +
                    " is for figures in space; expected svg, pdf, png, ps or eps");
    if (found->name.empty()) found->name = generator.name;
    return std::move(*found);
}

Drawn draw_plates(std::span<const Plate> plates, const std::string& output, PictureFormat format,
                  const PictureOptions& picture, const Budget& budget, Progress* progress) {
    const Target target = target_of(output);
    // As text an svg is smaller, and leaves out what is hidden.
    std::uint64_t strokes = 0;
    for (const Plate& plate : plates)
        strokes += std::min(plate.figure->strokes().value_or(picture.most_strokes + 1),
                            picture.most_strokes + 1);
    if (format == PictureFormat::svg && picture.route == PictureOptions::Route::automatic &&
        strokes <= picture.most_strokes) {
        std::vector<FigureSource> sources;
        for (const Plate& plate : plates) sources.push_back({plate});
        FigureTextDrawn drawn = draw_as_text(sources, target, FigureFormat::svg,
                                             {picture, false, plates.size() > 1}, budget, progress);
        return {drawn.width, drawn.height, drawn.strokes + drawn.polygons, drawn.polygons,
                false,       false,        std::move(drawn.blank)};
    }
    return plates.size() == 1
               ? draw_picture(plates.front(), target, format, picture, budget, progress)
               : draw_panels(plates, target, format, picture, budget, progress);
}

std::vector<Plate> generator_plates(const std::vector<GeneratorFigure>& figures, bool captions,
                                    const std::string& caption) {
    std::vector<Plate> plates;
    for (const GeneratorFigure& figure : figures)
        plates.push_back({figure.figure.get(), figure.name,
                          !caption.empty() ? caption
                          : captions       ? figure.caption
                                           : ""});
    return plates;
}

Drawn draw_generator(const Generator& generator, const std::string& output, PictureFormat format,
                     const PictureOptions& picture, bool captions, const std::string& caption,
                     const Budget& budget) {
    const std::vector<GeneratorFigure> figures = generator.figures(budget);
    const std::vector<Plate> plates = generator_plates(figures, captions, caption);
    ProgressBar bar("Drawing");
    return draw_plates(plates, output, format, picture, budget, &bar);
}

Json generator_json(const Generator& generator, const std::optional<Drawn>& drawn,
                    const std::string& output, const Budget& budget) {
    Json out;
    if (!generator.title.empty()) out.set("title", generator.title);
    for (const GeneratorFact& fact : generator.facts(budget)) out.set(fact.key, *fact.value);
    if (!drawn) return out;
    out.set("output", output);
    out.set("width", drawn->width);
    out.set("height", drawn->height);
    out.set("as_image", drawn->as_image);
    return out;
}

}  // namespace algae::command
