#include <algorithm>
#include <map>

#include "nature/nature.hpp"
#include "notation/detail/generator_values.hpp"

// The kinds of files that describe other generators than L-systems, and the short ones among them.
//
// A kind is one row of the table `generator_kinds`: the ending of its files, the keys that may stand in them,
// with what follows each (for messages), and a function that makes the generator. All kinds share one syntax,
// read in generator_file.cpp, so that a kind is only what its keys mean: the function takes the values from
// the `GeneratorFile`, which reports a faulty one at its place, and ends with the generator's own `check`,
// which knows what does not fit together. A value that the file does not give keeps the default of the
// generator's type, unless the notation says another. Iterated function systems, cellular automata and
// particles have longer readers, each in a source of its own.

namespace algae {

namespace {

std::unique_ptr<Generator> make_boxes(const GeneratorFile& file) {
    auto cover = std::make_unique<BoxCover>();
    file.describe(*cover);
    static const std::map<std::string, BoxCover::Shape> shapes{
        {"segment", BoxCover::Shape::segment},
        {"square", BoxCover::Shape::square},
        {"koch", BoxCover::Shape::koch},
        {"coast", BoxCover::Shape::coast}};
    cover->shape =
        shapes.at(file.choice("set", {"segment", "square", "koch", "coast"}).value_or("koch"));
    cover->cells = number_values(file, "cells", 1.0 / 4096, 1).value_or(cover->cells);
    cover->plot = file.choice("show", {"boxes", "plot"}).value_or("boxes") == "plot";
    cover->turned = file.choice("squares", {"grid", "turned"}).value_or("grid") == "turned";
    cover->seed = seed_value(file);
    cover->check();
    return cover;
}

std::unique_ptr<Generator> make_brownian(const GeneratorFile& file) {
    auto paths = std::make_unique<BrownianPaths>();
    file.describe(*paths);
    paths->hurst = hurst_values(file, "hurst").value_or(paths->hurst);
    paths->sigma = positive_value(file, "sigma").value_or(1);
    paths->levels =
        level_values(file, "levels", BrownianMotion::most_levels).value_or(paths->levels);
    paths->dimensions = static_cast<int>(file.natural("dimensions", 1, 3).value_or(1));
    paths->exact = file.choice("method", {"exact", "midpoint"}).value_or("exact") == "exact";
    paths->seed = seed_value(file);
    paths->check();
    return paths;
}

std::unique_ptr<Generator> make_dla(const GeneratorFile& file) {
    auto cluster = std::make_unique<Aggregates>();
    file.describe(*cluster);
    cluster->particles =
        natural_values(file, "particles", 1, Aggregates::most).value_or(cluster->particles);
    cluster->seed = seed_value(file);
    cluster->off_lattice = file.choice("off-lattice", {"yes", "no"}).value_or("no") == "yes";
    cluster->region = file.natural("region", 1, 16383);
    cluster->by_steps = file.choice("move", {"jumps", "steps"}).value_or("jumps") == "steps";
    cluster->stop_at_border = file.choice("stop-at-border", {"yes", "no"}).value_or("yes") == "yes";
    if (cluster->off_lattice && cluster->region)
        file.fail(*file.find("region"), "clusters off the lattice have no region");
    if (cluster->by_steps && !cluster->region)
        file.fail(*file.find("move"), "expected a region, which single steps need");
    cluster->check();
    return cluster;
}

std::unique_ptr<Generator> make_function(const GeneratorFile& file) {
    auto function = std::make_unique<WeierstrassFunction>();
    file.describe(*function);
    file.choice("function", {"weierstrass"});
    if (const auto a = hurst_values(file, "a")) {
        file.check_words(*file.find("a"), 1, 1, "NUMBER");
        function->a = a->front();
    }
    function->b = positive_value(file, "b").value_or(function->b);
    if (const auto counts = natural_values(file, "terms", 1, 1000)) function->terms = *counts;
    function->zooms = file.natural("zoom", 0, 12).value_or(0);
    function->points = file.natural("points", 2, 10'000'000).value_or(function->points);
    if (const GeneratorStatement* interval = file.find("interval")) {
        file.check_words(*interval, 2, 2, "FROM TO");
        function->from = file.quantity(*interval, interval->words[0]).value;
        function->to = file.quantity(*interval, interval->words[1]).value;
    }
    function->check();
    return function;
}

std::vector<Terrain::View> views_of(const GeneratorFile& file,
                                    const GeneratorStatement& statement) {
    static const std::map<std::string, Terrain::View> known{{"map", Terrain::View::map},
                                                            {"contours", Terrain::View::contours},
                                                            {"solid", Terrain::View::solid},
                                                            {"coast", Terrain::View::coast},
                                                            {"grid", Terrain::View::grid}};
    std::vector<Terrain::View> found;
    for (const GeneratorWord& word : statement.words) {
        const auto view = known.find(word.text);
        if (view == known.end()) {
            std::vector<std::string> names;
            for (const auto& [name, which] : known) names.push_back(name);
            file.refuse(statement, word, "map, contours, solid, coast or grid",
                        did_you_mean(word.text, names));
        }
        found.push_back(view->second);
    }
    return found;
}

std::unique_ptr<Generator> make_terrain(const GeneratorFile& file) {
    auto land = std::make_unique<Terrain>();
    file.describe(*land);
    if (const auto levels = level_values(file, "levels", most_surface_levels)) {
        land->surface.levels = levels->second;
        if (levels->first != levels->second) land->levels = levels;
    }
    if (const auto rough = hurst_values(file, "roughness")) {
        file.check_words(*file.find("roughness"), 1, 1, "H");
        land->surface.hurst = rough->front();
    }
    land->surface.sigma = positive_value(file, "height").value_or(land->surface.sigma);
    land->exact = file.choice("method", {"exact", "midpoint"}).value_or("midpoint") == "exact";
    land->water = file.number("water", 0, 1).value_or(land->water);
    land->lines = file.natural("lines", 0, 1000).value_or(land->lines);
    if (const GeneratorStatement* view = file.find("view")) land->views = views_of(file, *view);
    if (const GeneratorStatement* camera = file.find("camera")) {
        file.check_words(*camera, 2, 2, "AZIMUTH ELEVATION");
        land->camera.azimuth = file.number(*camera, camera->words[0], -360, 360);
        land->camera.elevation = file.number(*camera, camera->words[1], -90, 90);
    }
    land->seed = seed_value(file);
    land->check();
    return land;
}

std::unique_ptr<Generator> make_walk(const GeneratorFile& file) {
    constexpr std::uint64_t most_steps = 1'000'000'000;
    auto walks = std::make_unique<RandomWalks>();
    file.describe(*walks);
    walks->steps = natural_values(file, "steps", 1, most_steps).value_or(walks->steps);
    walks->walk.dimensions = static_cast<int>(file.natural("dimensions", 1, 3).value_or(2));
    walks->walk.deviation = positive_value(file, "deviation").value_or(1);
    walks->walk.seed = seed_value(file);
    walks->check();
    return walks;
}

const GeneratorKind& kind_of(const std::string& file_name) {
    if (const GeneratorKind* kind = generator_kind(file_name)) return *kind;
    std::string endings;
    for (const GeneratorKind& kind : generator_kinds())
        endings += (endings.empty() ? "." : ", .") + kind.ending;
    throw Error("expected a file ending in " + endings + ", found \"" + file_name + "\"");
}

}  // namespace

const std::vector<GeneratorKind>& generator_kinds() {
    static const std::vector<GeneratorKind> kinds{
        ifs_kind(),
        ca_kind(),
        {"walk",
         "a random walk",
         {{"steps", "N ..."}, {"dimensions", "1|2|3"}, {"deviation", "NUMBER"}, {"seed", "S"}},
         make_walk},
        {"brownian",
         "fractional Brownian motion",
         {{"hurst", "H ..."},
          {"sigma", "NUMBER"},
          {"levels", "N or N..M"},
          {"dimensions", "1|2|3"},
          {"method", "exact|midpoint"},
          {"seed", "S"}},
         make_brownian},
        {"terrain",
         "a landscape",
         {{"levels", "N or N..M"},
          {"roughness", "H"},
          {"height", "NUMBER"},
          {"method", "exact|midpoint"},
          {"water", "SHARE"},
          {"lines", "N"},
          {"view", "map|contours|solid|coast|grid ..."},
          {"camera", "AZIMUTH ELEVATION"},
          {"seed", "S"}},
         make_terrain},
        {"dla",
         "a cluster of diffusion-limited aggregation",
         {{"particles", "N ..."},
          {"seed", "S"},
          {"off-lattice", "yes|no"},
          {"region", "CELLS"},
          {"move", "jumps|steps"},
          {"stop-at-border", "yes|no"}},
         make_dla},
        particles_kind(),
        {"function",
         "Weierstrass's function",
         {{"function", "weierstrass"},
          {"a", "NUMBER"},
          {"b", "NUMBER"},
          {"terms", "N ..."},
          {"zoom", "N"},
          {"interval", "FROM TO"},
          {"points", "N"}},
         make_function},
        {"boxes",
         "a set covered with squares",
         {{"set", "segment|square|koch|coast"},
          {"cells", "SIDE ..."},
          {"show", "boxes|plot"},
          {"squares", "grid|turned"},
          {"seed", "S"}},
         make_boxes}};
    return kinds;
}

const GeneratorKind* generator_kind(std::string_view file_name) {
    const auto& kinds = generator_kinds();
    const auto found = std::ranges::find_if(
        kinds, [&](const GeneratorKind& kind) { return file_name.ends_with("." + kind.ending); });
    return found == kinds.end() ? nullptr : &*found;
}

std::unique_ptr<Generator> read_generator(std::string_view text, const std::string& file_name) {
    const GeneratorKind& kind = kind_of(file_name);
    return kind.make(read_generator_file(text, file_name, kind.keys));
}

std::string format_generator(std::string_view text, const std::string& file_name) {
    const GeneratorKind& kind = kind_of(file_name);
    const GeneratorFile file = read_generator_file(text, file_name, kind.keys);
    kind.make(file);
    return print_generator_file(file);
}

std::string_view file_name(const GalleryEntry& entry) {
    return entry.path.substr(entry.path.find_last_of('/') + 1);
}

const GalleryEntry* find_generator(std::string_view name) {
    const auto entries = generator_gallery();
    const auto found = std::find_if(entries.begin(), entries.end(), [&](const GalleryEntry& entry) {
        return entry.name == name || file_name(entry) == name;
    });
    return found == entries.end() ? nullptr : &*found;
}

}  // namespace algae
