#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "nature/height_field.hpp"
#include "nature/relative.hpp"
#include "space/camera.hpp"

namespace algae {

/// A landscape: a surface, and water up to some height. Its unit is the edge of the land.
class Terrain : public Relative {
public:
    enum class View { map, contours, solid, coast, grid };

    BrownianMotion surface{0.8, 0.3, 8};
    bool exact = false;  // otherwise by displacing the midpoints of squares
    double water = 0.4;  // the share of the land that lies below the water, from 0 to 1
    std::uint64_t seed = 1;
    std::uint64_t lines = 12;  // how many heights have contour lines
    std::vector<View> views{View::map};
    Camera camera{-60, 35};  // of the solid view
    std::optional<std::pair<int, int>>
        levels;  // a figure for each of these, instead of surface.levels

    /// Throws Error on parameters out of range.
    void check() const;
    /// The surface with so many levels.
    HeightField field(int level, const Budget& budget) const;

    std::vector<RelativeFigure> figures(const Budget& budget) const override;
    /// The coast.
    RelativeFigure measured_figure(const Budget& budget) const override;
    std::vector<RelativeFact> facts(const Budget& budget) const override;
    /// The land as squares in the colours of their heights, with the water flat.
    std::optional<Scene> scene(const Budget& budget) const override;
};

}  // namespace algae
