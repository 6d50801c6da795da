#pragma once

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>
#include <string>

#include "base/budget.hpp"
#include "cli/space_options.hpp"
#include "nature/relative.hpp"
#include "render/mesh_output.hpp"
#include "render/picture.hpp"

namespace algae::cli {

/// What `draw` takes for files of figures in space.
struct MeshRequest {
    std::string file, output, generation, seed, tables, colours, background, facets;
    SpaceOptions space;
    bool json = false;
};

/// What --format takes, for types of options.
inline constexpr const char* picture_formats = "svg|pdf|png|ps|eps|gif|webp";
inline constexpr const char* mesh_formats = "glb|obj|ply|stl|x3d|wrl|vrml1";

/// The format of a picture by the end of this name. Throws Error, listing what else may be drawn.
PictureFormat picture_of(const std::string& named);

/// Writes a scene, `-` to standard output; the result says what, as JSON.
nlohmann::ordered_json write_mesh(const Scene& scene, const std::string& output, MeshFormat format,
                                  const MeshChoices& choices, const Budget& budget);

/// The scene of a relative. Throws Error if it lies in the plane.
Scene scene_of(const Relative& relative, MeshFormat format, const Budget& budget);

/// Adds --facets.
void add_mesh_options(CLI::App& verb, std::string& facets);

/// Writes one figure of a system, or of a relative in space, and prints what it is if `json`.
int draw_mesh_file(const MeshRequest& request, MeshFormat format, const Budget& budget);

}  // namespace algae::cli
