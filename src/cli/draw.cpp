#include <fmt/format.h>

#include <iostream>
#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "cli/command.hpp"
#include "cli/draw_explain.hpp"
#include "cli/draw_mesh.hpp"
#include "cli/draw_motion.hpp"
#include "cli/draw_progress.hpp"
#include "cli/environment_option.hpp"
#include "cli/input.hpp"
#include "cli/numbers.hpp"
#include "cli/output.hpp"
#include "cli/plates.hpp"
#include "cli/relatives.hpp"
#include "render/picture.hpp"
#include "rewrite/terminal_words.hpp"

namespace algae::cli {

namespace {

struct Options {
    std::string file, generation, output, format, seed, seeds, tables, environment;
    std::string width, height, margin, line_width, background, font_size, columns, caption;
    std::string colours, facets;
    std::vector<std::string> labels;
    bool scale_bar = false;
    SpaceOptions space;
    bool panels = false, common_scale = false, captions = false, json = false;
    MotionOptions motion;
    Bounds bounds;
};

std::optional<double> optional_number(const std::string& option, const std::string& text) {
    if (text.empty()) return std::nullopt;
    return positive(option, text);
}

PictureOptions picture_options(const Options& options) {
    PictureOptions picture;
    picture.width = optional_number("--width", options.width);
    picture.height = optional_number("--height", options.height);
    if (!options.margin.empty()) picture.margin = options.margin == "0" ? 0 : positive("--margin", options.margin);
    picture.line_width = optional_number("--line-width", options.line_width);
    picture.font_size = optional_number("--font-size", options.font_size);
    if (!options.columns.empty()) picture.columns = natural("--columns", options.columns);
    if (!options.background.empty()) picture.background = options.background;
    if (!options.colours.empty()) picture.colours = list("--colour", options.colours);
    picture.common_scale = options.common_scale;
    picture.scale_bar = options.scale_bar;
    for (const std::string& label : options.labels) picture.labels.push_back(point_label(label));
    return picture;
}

/// The name whose end says the format.
std::string named_format(const Options& options) {
    if (options.output.empty()) throw Error("--output is required");
    if (!options.format.empty()) return "figure." + options.format;
    if (options.output == "-") throw Error("-o -: say which format with --format: svg, pdf, png, ps, eps, gif, webp, " + mesh_format_names());
    return options.output;
}

/// The generations of a picture; an animation begins with generation 0.
std::pair<std::uint64_t, std::uint64_t> generations_of(const Options& options, const LSystem& system, bool moves) {
    if (!options.generation.empty()) return range("-n", options.generation);
    const auto shown = shown_generations(system);
    return moves && shown.first == shown.second ? std::pair(std::uint64_t{0}, shown.second) : shown;
}

nlohmann::json numbers(const std::vector<Coordinate>& coordinates) {
    nlohmann::json out = nlohmann::json::array();
    for (const Coordinate& c : coordinates) out.push_back(c.value());
    return out;
}

nlohmann::ordered_json as_json(const FigurePlates& plates, const Drawn& drawn, const std::string& path) {
    nlohmann::ordered_json all = nlohmann::ordered_json::array();
    for (const FigurePlate& plate : plates.figures) {
        const Facts& facts = plate.figure->facts();
        nlohmann::ordered_json one;
        one["generation"] = plate.generation;
        if (plate.seed) one["seed"] = *plate.seed;
        one["segments"] = json_number(facts.segments);
        one["bounding_box"] = {{"min", numbers(facts.low)}, {"max", numbers(facts.high)}};
        one["end"] = numbers(facts.end);
        one["exact"] = facts.exact;
        all.push_back(std::move(one));
    }
    nlohmann::ordered_json out;
    if (all.size() == 1) out = all.front();
    else out["figures"] = all;
    out["output"] = path;
    out["width"] = drawn.width;
    out["height"] = drawn.height;
    out["lines"] = drawn.lines;
    out["as_image"] = drawn.as_image;
    return out;
}

PlateChoices choices(const Options& options, const LSystem& system) {
    PlateChoices found;
    if (!options.seed.empty() && !options.seeds.empty()) throw Error("--seed and --seeds: expected one of them");
    if (!options.seed.empty()) {
        const std::uint64_t seed = natural("--seed", options.seed);
        found.seeds = {seed, seed};
    }
    if (!options.seeds.empty()) found.seeds = range("--seeds", options.seeds);
    if (!options.tables.empty()) found.tables = table_sequence(system.tables, options.tables);
    found.environment = options.environment;
    found.space = options.space;
    if (!options.background.empty()) found.background = options.background;
    if (!options.colours.empty()) found.colours = list("--colour", options.colours);
    return found;
}

/// A file of a figure in space, which has nothing of a page.
int draw_to_mesh(const Options& options, MeshFormat format) {
    const std::pair<const char*, bool> of_pages[] = {
        {"--seeds", !options.seeds.empty()}, {"--environment", !options.environment.empty()},
        {"--width", !options.width.empty()}, {"--height", !options.height.empty()},
        {"--margin", !options.margin.empty()}, {"--line-width", !options.line_width.empty()},
        {"--font-size", !options.font_size.empty()}, {"--columns", !options.columns.empty()},
        {"--caption", !options.caption.empty()}, {"--captions", options.captions},
        {"--panels", options.panels}, {"--common-scale", options.common_scale},
        {"--scale-bar", options.scale_bar}, {"--label", !options.labels.empty()},
        {"--light", !options.space.light.empty()}, {"--fog", !options.space.fog.empty()}};
    for (const auto& [option, given] : of_pages)
        if (given) throw Error(std::string(option) + ": " + mesh_format_name(format) + " is no picture; it holds one figure in space");
    options.motion.check_unused();
    return draw_mesh_file({options.file, options.output, options.generation, options.seed, options.tables,
                           options.colours, options.background, options.facets, options.space, options.json},
                          format, options.bounds.budget());
}

/// Files of relatives: what -n and --seed say stands in their statements.
int draw_relative_file(const Options& options, PictureFormat format, const PictureOptions& picture,
                       const Budget& budget) {
    for (const auto& [option, given] : {std::pair("--seeds", !options.seeds.empty()), {"--tables", !options.tables.empty()},
                                        {"--environment", !options.environment.empty()},
                                        {"--camera", !options.space.camera.empty()}, {"--light", !options.space.light.empty()},
                                        {"--fog", !options.space.fog.empty()}})
        if (given) throw Error(std::string(option) + " is for systems, and " + options.file + " is none");
    const auto relative = open_relative(options.file, budget,
                                        {{{"-n", "generation", {}, {}}, options.generation}, {{"--seed", "seed", {}, {}}, options.seed}});
    const Drawn drawn = draw_relative(*relative, options.output, format, picture, options.captions, options.caption, budget);
    if (options.json) print(relative_json(*relative, drawn, options.output, budget).dump(2) + "\n");
    return success;
}

[[noreturn]] void refuse_panels() {
    throw Error("--panels: animations and explanations show one figure at a time");
}

int draw_explained(const Options& options) {
    if (!options.output.empty()) named_format(options);
    options.motion.check_unused();
    const Budget budget = options.bounds.budget();
    const LSystem system = open_system(options.file, budget);
    return explain(system,
                   {options.generation, choices(options, system), options.output, options.format,
                    picture_options(options), options.json},
                   budget);
}

int draw_progressive(const Options& options) {
    named_format(options);
    const Budget budget = options.bounds.budget();
    const LSystem system = open_system(options.file, budget);
    return draw_progress(system,
                         {options.generation, choices(options, system), options.output,
                          options.format, picture_options(options), options.motion,
                          options.captions, options.caption, options.json},
                         budget);
}

int draw(const Options& options) {
    if (options.panels && (options.motion.explain || options.motion.progressive)) refuse_panels();
    if (options.motion.explain) return draw_explained(options);
    if (options.motion.progressive) return draw_progressive(options);
    const std::string named = named_format(options);
    if (const auto mesh = mesh_format(named)) return draw_to_mesh(options, *mesh);
    if (!options.facets.empty()) throw Error("--facets is for " + mesh_format_names());
    const std::optional<AnimationFormat> animation = animation_format(named);
    const PictureFormat format = animation ? PictureFormat::png : picture_of(named);
    const AnimationTiming timing = options.motion.timing(0.8);
    options.motion.check(animation.has_value());
    if (animation && options.panels) refuse_panels();
    const PictureOptions picture = picture_options(options);
    const Budget budget = options.bounds.budget();
    if (is_relative(options.file)) return draw_relative_file(options, format, picture, budget);
    const LSystem system = open_system(options.file, budget);
    const auto generations = generations_of(options, system, animation.has_value());
    FigurePlates plates(system, generations, choices(options, system), budget);
    if (!options.caption.empty()) plates.caption(options.caption);
    else if (options.captions) plates.caption_with_facts();

    ProgressBar bar("Drawing");
    const bool single = plates.figures.size() == 1;
    const bool pages = !single && !options.panels && (format == PictureFormat::pdf || format == PictureFormat::ps);
    // What a file says of its own figure is drawn as well as the format can.
    const bool of_seeds = generations.first == generations.second;  // the words of several seeds
    const bool panels =
        options.panels || ((options.generation.empty() || of_seeds) && !single && !pages);
    const auto draw_to = [&](auto& target) {
        if (animation)
            return draw_animation(plates.plates(), target, *animation, picture, timing, budget, &bar);
        if (single && !panels)
            return draw_picture(plates.plates().front(), target, format, picture, budget, &bar);
        if (pages) return draw_pages(plates.plates(), target, format, picture, budget, &bar);
        return draw_panels(plates.plates(), target, format, picture, budget, &bar);
    };
    if (!single && !pages && !panels && !animation)
        throw Error("-n " + options.generation + ": several generations need --panels, pdf or ps for pages, or gif or webp for an animation");
    const Drawn drawn = options.output == "-" ? draw_to(std::cout) : draw_to(options.output);
    if (drawn.as_image)
        std::cerr << "algae: note: too many strokes for a vector format, drawn as an image within it\n";
    for (const std::size_t blank : drawn.blank)
        std::cerr << "algae: note: nothing is drawn in generation " << plates.figures[blank].generation << '\n';
    if (options.json) print(as_json(plates, drawn, options.output).dump(2) + "\n");
    return success;
}

}  // namespace

void add_draw(Verbs& verbs) {
    auto options = std::make_shared<Options>();
    CLI::App& verb = add_verb(verbs, "draw", "The turtle figure of a generation",
                              "  algae draw koch -n 4 -o koch.svg\n"
                              "  algae draw plant-f -n 0..5 --panels --captions -o plants.pdf\n"
                              "  algae draw dragon -n 0..10 --frame-time 0.5 -o dragon.gif\n"
                              "  algae draw hilbert-3d --camera 30,20,perspective -o hilbert.png",
                              options, draw);
    verb.add_option("FILE", options->file, file_help)->type_name(file_type)->required();
    verb.add_option("-n", options->generation, "the generation, or a range such as 0..6: pages of a pdf, frames of a gif or webp, or --panels (default: what the file says)")->type_name("N[..M]");
    verb.add_option("-o,--output", options->output, "the picture: .svg, .pdf, .png, .ps or .eps, the animation: .gif or .webp, the figure in space: .glb, .obj, .ply, .stl, .x3d or .wrl; - for standard output")->type_name("FILE");
    verb.add_option("--format", options->format, "the format, where the name does not say it; vrml1 for VRML 1.0")->type_name(std::string(picture_formats) + '|' + mesh_formats);
    verb.add_flag("--panels", options->panels, "several generations side by side");
    verb.add_option("--columns", options->columns, "panels in a row")->type_name("N");
    verb.add_flag("--common-scale", options->common_scale, "the same scale for all generations; in an animation, the same part of the plane");
    verb.add_option("--width", options->width, "of the picture, in points (png, gif, webp: pixels)")->type_name("W");
    verb.add_option("--height", options->height, "of the picture, in points (png, gif, webp: pixels)")->type_name("H");
    verb.add_option("--margin", options->margin, "blank border (default 10)")->type_name("M");
    verb.add_option("--line-width", options->line_width, "of strokes, in points or pixels (default 1)")->type_name("W");
    verb.add_option("--colour", options->colours, "names or #rrggbb, the next for each '; or: along, a hue that runs with the word")->type_name("COLOUR,...");
    verb.add_option("--background", options->background, "a colour, or transparent (default: white in png, gif and webp, none elsewhere)")->type_name("COLOUR");
    verb.add_flag("--captions", options->captions, "system, generation and angle underneath");
    verb.add_option("--caption", options->caption, "a text underneath")->type_name("TEXT");
    verb.add_option("--font-size", options->font_size, "of captions")->type_name("S");
    verb.add_option("--seed", options->seed, "the word of a system with choices that this seed picks (what the file says; 1 for systems with probabilities)")->type_name("S");
    verb.add_option("--seeds", options->seeds, "a figure for each of these seeds, such as 1..9, side by side")->type_name("A..B");
    verb.add_option("--tables", options->tables, "the table of each step: light,dark or, of one character each, abab or 1212")->type_name("SEQUENCE");
    options->space.add_to(verb);
    verb.add_flag("--scale-bar", options->scale_bar, "a bar below the figure with its length, in the units of the file");
    verb.add_option("--label", options->labels, "a text at a point of the figure; may be given several times")->type_name("TEXT@x,y[,z]")->expected(1)->take_all();
    options->motion.add_to(verb);
    add_mesh_options(verb, options->facets);
    add_environment_option(verb, options->environment);
    verb.add_flag("--json", options->json, "print segments, bounding box and end as one JSON object; integers from 2^53 on are strings");
    options->bounds.add_to(verb);
}

}  // namespace algae::cli
