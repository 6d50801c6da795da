#pragma once

#include "base/budget.hpp"
#include "render/output.hpp"
#include "render/scene_graph.hpp"

namespace algae {

/// Writes a scene graph as X3D 3.3 in XML (ISO/IEC 19776-1), profile Interchange. Throws Error if the
/// bytes cannot be written.
void write_x3d(const SceneGraph& graph, Output& output, const Budget& budget);

}  // namespace algae
