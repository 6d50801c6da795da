#include "shape/nearest.hpp"

#include <algorithm>

namespace algae {

Rational gap(const ShapeBox& left, const ShapeBox& right, std::size_t axis) {
    const Rational behind = right.origin[axis] - (left.origin[axis] + left.size[axis]);
    const Rational before = left.origin[axis] - (right.origin[axis] + right.size[axis]);
    return std::max({Rational(0), behind, before});
}

NearestBoxes::NearestBoxes(const ShapeSystem& system, const std::vector<ShapeBox>& boxes) {
    for (const auto& asked : system.distances) {
        Ends& ends = ends_[{asked.axis, asked.symbol}];
        if (!ends.low.empty()) continue;
        for (const ShapeBox& box : boxes) {
            if (box.symbol != asked.symbol) continue;
            ends.low.push_back(box.origin[asked.axis]);
            ends.high.push_back(box.origin[asked.axis] + box.size[asked.axis]);
        }
        std::sort(ends.low.begin(), ends.low.end());
        std::sort(ends.high.begin(), ends.high.end());
    }
}

std::optional<Rational> NearestBoxes::distance(const ShapeBox& box, std::size_t axis,
                                               Symbol symbol) const {
    const Ends& ends = ends_.at({axis, symbol});
    const bool itself = box.symbol == symbol;
    if (ends.low.size() == static_cast<std::size_t>(itself)) return std::nullopt;
    const Rational low = box.origin[axis], high = low + box.size[axis];
    // Boxes have an extent, so those that begin before its end and do not end before it begins are
    // counted by two searches.
    const auto next = std::upper_bound(ends.low.begin(), ends.low.end(), high);
    const auto last = std::lower_bound(ends.high.begin(), ends.high.end(), low);
    const auto meeting = (next - ends.low.begin()) - (last - ends.high.begin());
    if (meeting > static_cast<std::ptrdiff_t>(itself)) return Rational(0);
    std::optional<Rational> nearest;
    if (next != ends.low.end()) nearest = *next - high;
    if (last != ends.high.begin())
        if (const Rational before = low - *std::prev(last); !nearest || before < *nearest)
            nearest = before;
    return nearest;
}

}  // namespace algae
