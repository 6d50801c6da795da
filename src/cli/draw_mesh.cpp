#include "cli/draw_mesh.hpp"

#include <iostream>
#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "cli/command.hpp"
#include "cli/input.hpp"
#include "cli/numbers.hpp"
#include "cli/output.hpp"
#include "cli/plates.hpp"
#include "cli/relatives.hpp"
#include "rewrite/terminal_words.hpp"
#include "space/space_figure.hpp"

namespace algae::cli {

namespace {

/// The scene of one word of a system.
Scene scene_of(const MeshRequest& request, const LSystem& system, std::uint64_t generation,
               const Budget& budget) {
    const auto seeds = system.settings.seeds;
    FigureChoices choices;
    if (!request.seed.empty())
        choices.seed = natural("--seed", request.seed);
    else if (seeds) {
        if (seeds->first != seeds->second)
            throw Error(system.name +
                        " shows the words of several seeds; say --seed S for the one of the mesh");
        choices.seed = seeds->first;
    }
    if (!request.tables.empty()) choices.tables = table_sequence(system.tables, request.tables);
    Scene found = scene(system, generation, budget, choices).scene;
    if (found.name.empty())
        found.name = "generation " + std::to_string(generation) + " of " + system.name;
    return found;
}

nlohmann::ordered_json corner(const Vector& v) { return {v.x, v.y, v.z}; }

}  // namespace

PictureFormat picture_of(const std::string& named) {
    try {
        return picture_format(named);
    } catch (const Error& error) {
        throw Error(std::string(error.what()) +
                    "; an animation ends in .gif or .webp, a figure in space in .glb, .obj, .ply, "
                    ".stl, .x3d or .wrl, or say --format vrml1");
    }
}

nlohmann::ordered_json write_mesh(const Scene& scene, const std::string& output, MeshFormat format,
                                  const MeshChoices& choices, const Budget& budget) {
    const MeshDrawn drawn = output == "-" ? draw_mesh(scene, std::cout, format, choices, budget)
                                          : draw_mesh(scene, output, format, choices, budget);
    nlohmann::ordered_json json;
    json["segments"] = scene.rods.size();
    json["bounding_box"] = {{"min", corner(drawn.box.low)}, {"max", corner(drawn.box.high)}};
    json["vertices"] = drawn.vertices;
    json["triangles"] = drawn.triangles;
    if (drawn.solids) json["solids"] = drawn.solids;
    if (drawn.lines) json["lines"] = drawn.lines;
    json["output"] = output;
    json["format"] = mesh_format_name(format);
    return json;
}

Scene scene_of(const Relative& relative, MeshFormat format, const Budget& budget) {
    auto found = relative.scene(budget);
    if (!found)
        throw Error(relative.name + " lies in the plane, and " + mesh_format_name(format) +
                    " is for figures in space; expected svg, pdf, png, ps or eps");
    if (found->name.empty()) found->name = relative.name;
    return std::move(*found);
}

void add_mesh_options(CLI::App& verb, std::string& facets) {
    verb.add_option("--facets", facets,
                    "of files of figures in space: sides of a tube, 3 to 256 (default 8)")
        ->type_name("K");
}

int draw_mesh_file(const MeshRequest& request, MeshFormat format, const Budget& budget) {
    MeshChoices choices;
    if (const auto camera = request.space.chosen_camera()) choices.camera = *camera;
    if (!request.facets.empty()) {
        const std::uint64_t facets = natural("--facets", request.facets);
        if (facets < 3 || facets > 256)
            throw Error("--facets " + request.facets + ": expected 3 to 256 sides of a tube");
        choices.mesh.facets = static_cast<unsigned>(facets);
    }
    if (!request.colours.empty()) choices.colours = list("--colour", request.colours);
    if (!request.background.empty()) choices.background = request.background;

    nlohmann::ordered_json json;
    Scene scene;
    if (is_relative(request.file)) {
        const auto relative = open_relative(request.file, budget,
                                            {{{"-n", "generation", {}, {}}, request.generation},
                                             {{"--seed", "seed", {}, {}}, request.seed}});
        scene = scene_of(*relative, format, budget);
    } else {
        const LSystem system = open_system(request.file, budget);
        const auto generations = request.generation.empty() ? shown_generations(system)
                                                            : range("-n", request.generation);
        if (!request.generation.empty() && generations.first != generations.second)
            throw Error("-n " + request.generation + ": " + mesh_format_name(format) +
                        " holds one generation");
        choices.camera = view_choices(request.space, system, choices.background).camera;
        scene = scene_of(request, system, generations.second, budget);
        json["generation"] = generations.second;
    }
    json.update(write_mesh(scene, request.output, format, choices, budget));
    if (request.json) print(json.dump(2) + "\n");
    return success;
}

}  // namespace algae::cli
