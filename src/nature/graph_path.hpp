#pragma once

#include <vector>

#include "space/scene.hpp"
#include "turtle/canvas.hpp"
#include "turtle/pose.hpp"

namespace algae {

/// The graph of evenly spaced values, as a line in a box of `breadth` by 1: its lowest value is at the
/// bottom and its highest at the top. Values that are all the same lie at the bottom.
///
/// Example: graph_path({2, 4, 3}, 2) == std::vector<Point>{{0, 0}, {1, 1}, {2, 0.5}}
std::vector<Point> graph_path(const std::vector<double>& values, double breadth);

/// A rod without thickness from each point to the next, in the colours of these settings.
Scene path_scene(const std::vector<Vector>& places, const Settings& settings);

/// Points of space as the usual camera sees them from far away.
std::vector<Point> seen_path(const std::vector<Vector>& places);

}  // namespace algae
