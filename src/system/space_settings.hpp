#pragma once

#include <optional>
#include <string>
#include <vector>

#include "system/expression.hpp"
#include "word/alphabet.hpp"

namespace algae {

/// A direction seen from a figure, in degrees: `azimuth` counter-clockwise from +x, seen from above,
/// and `elevation` above the horizon, from -90 to 90.
struct Direction {
    Quantity azimuth, elevation;
    bool operator==(const Direction&) const = default;
};

/// Where a camera stands: `camera -60 15 perspective 40`.
struct CameraSetting {
    Direction from;
    bool perspective = false;
    std::optional<Quantity> opening;  // degrees that the picture spans in perspective, below 180
    bool operator==(const CameraSetting&) const = default;
};

/// Three coordinates: `tropism 0 0 -1`.
struct Triple {
    Quantity x, y, z;
    bool operator==(const Triple&) const = default;
};

/// A surface that a symbol leaves where the turtle stands: `surface K leaf`,
/// `surface K polygon (0,0,0) (1,0,0) (1,1,0)`. Points are along heading, left and up, in steps.
struct SurfaceSetting {
    Symbol symbol = 0;
    std::string kind;            // one of surface_kinds()
    std::vector<Triple> points;  // of a polygon its corners, of a patch its 16 Bezier points

    bool operator==(const SurfaceSetting&) const = default;
};

/// leaf, petal and disc, which are known by name, polygon and patch, which have points.
///
/// Example: surface_kinds().front() == "leaf"
const std::vector<std::string>& surface_kinds();

}  // namespace algae
