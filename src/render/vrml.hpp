#pragma once

#include "base/budget.hpp"
#include "render/output.hpp"
#include "render/scene_graph.hpp"

namespace algae {

/// Writes a scene graph as VRML97 (ISO/IEC 14772-1:1997). Throws Error if the bytes cannot be written.
void write_vrml97(const SceneGraph& graph, Output& output, const Budget& budget);

/// The same as VRML 1.0 (Bell, Parisi and Pesce, The Virtual Reality Modeling Language, version 1.0,
/// 1995). Each shape stands in a Separator of its own with its absolute place: a Separator around each
/// module's movements alone would undo them at its end.
void write_vrml1(const SceneGraph& graph, Output& output, const Budget& budget);

}  // namespace algae
