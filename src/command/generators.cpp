// The verbs of the other generators of natural geometry, one a kind: ifs, walk, brownian, terrain, dla,
// particles, ca.
//
// All are one verb with a table of options. An option replaces a statement of the generator's file, so the
// notation reads and checks its text, and a command line without FILE is a file of such statements. Without
// -o a verb prints the facts about the generator; with -o it draws: several figures
// side by side, frames of an animation, or the scene of a generator in space.

#include "command/detail/files.hpp"
#include "command/detail/output.hpp"
#include "command/detail/pictures.hpp"
#include "command/detail/verb.hpp"
#include "exact/exact.hpp"
#include "nature/nature.hpp"
#include "render/render.hpp"

namespace algae::command {

namespace {

struct Options {
    std::string kind;  // the verb's name, and the end of its files
    std::string file, output, format, caption;
    std::optional<double> width, height, rate;
    bool captions = false, json = false, text = false;
    std::deque<StatementOption> said;  // whose places stay
    std::deque<bool> flags;            // those of them that say yes
    Bounds bounds;
};

/// The generator that FILE and the options describe.
std::unique_ptr<Generator> chosen(const Options& options, const Budget& budget) {
    return open_kind(options.kind, options.file, budget,
                     {options.said.begin(), options.said.end()});
}

/// All frames one after the other, each showing the same part of the plane.
Drawn animate(const Generator& generator, const Options& options, AnimationFormat format,
              PictureOptions picture, const Budget& budget) {
    AnimationTiming timing;
    timing.frame = 1 / options.rate.value_or(20);
    timing.last = timing.frame;
    picture.common_scale = true;
    const std::vector<GeneratorFigure> frames = generator.frames(budget);
    const std::vector<Plate> plates = generator_plates(frames, options.captions, options.caption);
    ProgressBar bar("Drawing");
    return draw_animation(plates, target_of(options.output), format, picture, timing, budget, &bar);
}

int run_generator(const Options& options) {
    const Budget budget = options.bounds.budget();
    std::optional<PictureFormat> format;
    std::optional<AnimationFormat> animation;
    std::optional<MeshFormat> mesh;
    if (!options.output.empty()) {
        const std::string named = named_format(options.output, options.format);
        mesh = mesh_format(named);
        animation = animation_format(named);
        if (!mesh) format = animation ? PictureFormat::png : picture_of(named);
    } else if (!options.format.empty()) {
        throw Error("--format: expected -o, where the figure goes");
    }
    if (mesh)
        refuse_on_mesh({{"--width", options.width.has_value()},
                        {"--height", options.height.has_value()},
                        {"--captions", options.captions},
                        {"--caption", !options.caption.empty()}},
                       *mesh);
    if (!animation && options.rate)
        throw Error("--rate is for animations: expected -o with .gif, .webp, .mp4 or .webm");
    PictureOptions picture;
    picture.width = options.width;
    picture.height = options.height;
    const std::unique_ptr<Generator> generator = chosen(options, budget);
    std::optional<Drawn> drawn;
    Json written;
    if (mesh)
        written =
            write_mesh(scene_of(*generator, *mesh, budget), options.output, *mesh, {}, budget);
    else if (animation)
        drawn = animate(*generator, options, *animation, picture, budget);
    else if (format)
        drawn = draw_generator(*generator, options.output, *format, picture, options.captions,
                               options.caption, budget);
    if (options.output == "-") return success;
    if (options.json) {
        Json all = generator_json(*generator, drawn, options.output, budget);
        if (mesh) all.update(written);
        print(all.text());
        return success;
    }
    std::string page;
    if (!generator->title.empty()) page += generator->title + "\n";
    for (const GeneratorFact& fact : generator->facts(budget)) {
        std::string key = fact.key;
        for (char& letter : key) letter = letter == '_' ? ' ' : letter;
        page += key + ": " + fact.text + "\n";
    }
    print(page);
    return success;
}

int run_automaton(const Options& options) {
    if (!options.text) return run_generator(options);
    if (!options.output.empty() || options.json)
        throw Error("--text: expected no picture and no --json beside it");
    const Budget budget = options.bounds.budget();
    const auto generator = chosen(options, budget);
    const auto& automaton = dynamic_cast<const CellularAutomaton&>(*generator);
    if (automaton.rule.dimensions == 1) {
        print(grid_text(automaton.space_time(automaton.generations.front(),
                                             automaton.generations.back(), budget)));
        return success;
    }
    print(joined(automaton.generations, "\n",
                 [&](std::uint64_t n) { return grid_text(automaton.generation(n, budget)); }));
    return success;
}

/// An option that replaces a statement of the file.
struct Statement {
    const char *option, *key,
        *type;  // "--points", "points", "N"; no type for a flag, which says yes
    const char* help;
};

struct GeneratorVerb {
    const char *kind, *help;
    std::vector<std::string> examples;
    std::vector<Statement> statements;
};

/// Whether generators of this kind may lie in space.
bool in_space(const std::string& kind) {
    return kind == "terrain" || kind == "brownian" || kind == "walk";
}

const GeneratorVerb generators[] = {
    {"ifs",
     "The attractor of an iterated function system",
     {"algae ifs fern -o fern.png", "algae ifs copy-machine --iterations 0..5 -o copies.pdf"},
     {{"--points", "points", "N", "so many points of the chaos game"},
      {"--iterations", "generation", "N[..M]",
       "the images of the start set instead, after so many rounds"},
      {"--seed", "seed", "S", "of the chaos game (default 1)"}}},
    {"walk",
     "A random walk with Gaussian steps",
     {"algae walk --steps 10000 --seed 3 -o walk.svg", "algae walk random-walk -o walk.pdf"},
     {{"--steps", "steps", "N",
       "how many steps (default 10000); several as \"100 10000\" are side by side"},
      {"--dimensions", "dimensions", "1|2|3",
       "of the place (default 2); in one dimension the graph against time"},
      {"--deviation", "deviation", "NUMBER", "of each coordinate of a step (default 1)"},
      {"--seed", "seed", "S", "of the steps (default 1)"}}},
    {"brownian",
     "Fractional Brownian motion, exactly or by displacing midpoints",
     {"algae brownian --hurst 0.7 --levels 12 -o path.svg",
      "algae brownian --method midpoint --levels 1..6 -o displacements.pdf"},
     {{"--hurst", "hurst", "H",
       "how smooth it is, between 0 and 1 (default 0.5); several as \"0.2 0.8\""},
      {"--sigma", "sigma", "NUMBER", "the root of the variance of X(1) (default 1)"},
      {"--levels", "levels", "N[..M]", "2^N steps (default 10); a figure for each of a range"},
      {"--dimensions", "dimensions", "1|2|3",
       "independent coordinates (default 1, the graph against time)"},
      {"--method", "method", "exact|midpoint",
       "by circulant embedding (default) or midpoint displacement"},
      {"--seed", "seed", "S", "of the random numbers (default 1)"}}},
    {"terrain",
     "A landscape: a random surface with water, as a map, contour lines, solid or its coast",
     {"algae terrain --levels 8 --roughness 0.8 --seed 4 --view solid -o land.png",
      "algae terrain mountains -o mountains.glb"},
     {{"--levels", "levels", "N[..M]", "2^N squares along an edge (default 8)"},
      {"--roughness", "roughness", "H", "between 0, rough, and 1, smooth (default 0.8)"},
      {"--relief", "height", "NUMBER",
       "the deviation of heights, in edges of the land (default 0.3)"},
      {"--water", "water", "SHARE", "of the land that lies below it (default 0.4)"},
      {"--view", "view", "map|contours|solid|coast|grid",
       "what is shown (default map); several as \"map solid\""},
      {"--lines", "lines", "N", "contour lines (default 12)"},
      {"--method", "method", "midpoint|exact",
       "displacing midpoints of squares (default), or exactly fractional Brownian"},
      {"--camera", "camera", "\"AZIMUTH ELEVATION\"",
       "where the solid view is seen from (default -60 35)"},
      {"--seed", "seed", "S", "of the random numbers (default 1)"}}},
    {"dla",
     "Diffusion-limited aggregation: particles that walk until they touch the cluster",
     {"algae dla --particles 20000 --seed 5 --off-lattice -o cluster.png",
      "algae dla dla -o dla.pdf"},
     {{"--particles", "particles", "N",
       "how many join the seed (default 10000); several as \"100 1000\""},
      {"--seed", "seed", "S", "of the walks (default 1)"},
      {"--off-lattice", "off-lattice", "", "discs in the plane instead of cells of a square grid"},
      {"--region", "region", "CELLS",
       "particles begin within so many cells of the seed, and are lost beyond (default: they "
       "come from far away)"},
      {"--move", "move", "jumps|steps",
       "in a region: by jumps, or cell by cell as the algorithm is written; the chances are the "
       "same"},
      {"--stop-at-border", "stop-at-border", "yes|no",
       "when the cluster reaches the border of the region (default yes)"}}},
    {"particles",
     "A system of particles: frames, or an animation",
     {"algae particles fireworks -o fireworks.png",
      "algae particles fireworks --seed 2 -o fireworks.gif"},
     {{"--show", "show", "FRAME", "the frame of the picture; several as \"10 20 30\""},
      {"--frames", "frames", "LAST", "the last frame of the animation"},
      {"--seed", "seed", "S", "of the random numbers (default: what the file says, or 1)"}}},
    {"ca",
     "Cellular automata: space-time pictures, or generations in the plane",
     {"algae ca --rule 30 --cells 101 -n 50 --text", "algae ca rule-126 -o rule-126.svg"},
     {{"--rule", "rule", "N", "the rule by its number, 0 to 255 for two states and radius 1"},
      {"--life", "life", "B3/S23", "a rule in the plane by numbers of neighbours"},
      {"--states", "states", "K", "of a cell (default 2)"},
      {"--radius", "radius", "R", "of the neighbourhood (default 1)"},
      {"--cells", "cells", "N", "on the line, or \"COLUMNS ROWS\" (default 101)"},
      {"--start", "start", "START",
       "single (a 1 in the middle, the default), random, or the states of the cells"},
      {"--boundary", "boundary", "B", "periodic (a ring, the default), or \"fixed STATE\""},
      {"--seed", "seed", "S", "of a random start (default 1)"},
      {"-n", "generation", "N[..M]",
       "the last generation, or the first and the last (default 50)"}}},
};

void add_generator(Verbs& verbs, const GeneratorVerb& generator) {
    const std::string kind = generator.kind;
    const bool automaton = kind == "ca";
    auto [verb, options] = verbs.add(kind, generator.help, generator.examples,
                                     automaton ? run_automaton : run_generator);
    options.kind = kind;
    verb.option("FILE", options.file, file_type,
                "a file ending in ." + kind +
                    ", - for standard input, or a name from the gallery; options say what the file "
                    "would");
    verb.output(
        "-o,--output", options.output, "FILE",
        "the picture: .svg, .pdf, .png, .ps or .eps, the animation: .gif, .webp, .mp4 or .webm" +
            std::string(in_space(kind) ? ", the figure in space: .glb, .obj, .ply, .stl, "
                                         ".x3d, .wrl or .pov"
                                       : "") +
            "; - for standard output");
    verb.option(
        "--format", options.format,
        std::string(picture_formats) + (in_space(kind) ? '|' + std::string(mesh_formats) : ""),
        "the format, where the name does not say it");
    verb.option("--width", options.width, positive, "W", "of the picture, in points (png: pixels)");
    verb.option("--height", options.height, positive, "H",
                "of the picture, in points (png: pixels)");
    verb.flag("--captions", options.captions, "what each figure shows underneath");
    verb.option("--caption", options.caption, "TEXT", "a text underneath");
    verb.option("--rate", options.rate, positive, "R",
                "frames a second of an animation (default 20)");
    verb.json_flag(options.json);
    if (automaton)
        verb.flag("--text", options.text, "print the states, a line for each generation");
    for (const Statement& statement : generator.statements) {
        std::string& text =
            options.said.emplace_back(StatementOption{statement.option, statement.key, ""}).text;
        if (*statement.type)
            verb.option(statement.option, text, statement.type, statement.help);
        else
            verb.flag(statement.option, options.flags.emplace_back(), statement.help).take =
                [&text](const std::string&) { text = "yes"; };
    }
    verb.bounded_by(options.bounds);
}

}  // namespace

void add_generators(Verbs& verbs) {
    for (const GeneratorVerb& generator : generators) add_generator(verbs, generator);
}

}  // namespace algae::command
