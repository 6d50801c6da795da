#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "base/budget.hpp"
#include "cli/space_options.hpp"
#include "render/mesh_output.hpp"

namespace algae::cli {

/// What `draw` takes for files of figures in space.
struct MeshRequest {
    std::string file, output, generation, seed, tables, colours, background, facets;
    SpaceOptions space;
    bool json = false;
};

/// Adds --facets.
void add_mesh_options(CLI::App& verb, std::string& facets);

/// Writes one figure of a system, or of a relative in space, and prints what it is if `json`.
int draw_mesh_file(const MeshRequest& request, MeshFormat format, const Budget& budget);

}  // namespace algae::cli
