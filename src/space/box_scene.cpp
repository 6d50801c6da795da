#include "space/box_scene.hpp"

namespace algae {

Scene box_scene(const LSystem& system, const std::vector<ShapeBox>& boxes) {
    Scene out;
    out.colours = system.settings.colours;
    out.solids.reserve(boxes.size());
    for (const ShapeBox& box : boxes) {
        const auto middle = [&](std::size_t axis) {
            return (box.origin[axis] + box.size[axis] / Rational(2)).to_double();
        };
        Solid solid;
        solid.middle = {middle(0), -middle(2), middle(1)};
        solid.size = {box.size[0].to_double(), box.size[2].to_double(), box.size[1].to_double()};
        solid.paint.index = box.symbol;
        out.solids.push_back(solid);
    }
    return out;
}

}  // namespace algae
