#pragma once

#include <vector>

#include "nature/height_field.hpp"
#include "nature/path_figure.hpp"
#include "space/scene.hpp"

namespace algae {

/// The heights of a landscape that its colours depend on.
struct Relief {
    double low = 0, water = 0, high = 1;  // the lowest, the water's, the highest
};

/// The colour of a height: blue below the water, darker where it is deep; sand, green, brown, grey and
/// snow above it.
Colour relief_colour(const Relief& relief, double height);

/// A map of the squares of a surface, in the colours of their mean heights, lit from the upper left as
/// usual on maps (Horn, Hill shading and the reflectance map, 1981); water is flat. Neighbours of one
/// colour are one rectangle.
std::vector<Path> relief_map(const HeightField& field, const Relief& relief, const Budget& budget);

/// The squares of a surface as faces in space, two triangles each, in the colours of their heights;
/// what lies below the water is the water's surface. `shown` are drawn along an edge at most: of finer
/// surfaces every second, fourth, ... point.
Scene relief_scene(const HeightField& field, const Relief& relief, std::size_t shown,
                   const Budget& budget);

}  // namespace algae
