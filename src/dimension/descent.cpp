#include "dimension/descent.hpp"

#include <algorithm>
#include <numbers>

namespace algae {

Descent::Descent(const RecurrentSet& set)
    : shrink(1.0 / set.displacement().factor()), smaller(1 / set.displacement().ratio()) {
    const auto headings = static_cast<std::size_t>(set.order());
    for (std::size_t h = 0; h < headings; ++h)
        turns.push_back(polar(
            1, 2 * std::numbers::pi * static_cast<double>(h) / static_cast<double>(headings)));
    const auto part_of = [&](const RecurrentSet::Part& part, Number unit) {
        const auto heading = static_cast<std::size_t>(normal_heading(part.heading, set.order()));
        return Part{part.piece, heading, Number(set.displacement().value(part.offset)) * unit};
    };
    for (std::size_t p = 0; p < set.size(); ++p) {
        auto& own = parts.emplace_back();
        for (const RecurrentSet::Part& part : set.parts(p)) own.push_back(part_of(part, shrink));
        discs.push_back({set.disc(p).centre, set.disc(p).radius});
    }
    for (const RecurrentSet::Part& part : set.axiom()) axiom.push_back(part_of(part, {1, 0}));
    // The limit of the first parts.
    points.resize(parts.size());
    const int deep = static_cast<int>(std::ceil(40 / std::log(set.displacement().ratio()))) + 1;
    for (std::size_t p = 0; p < parts.size(); ++p) {
        Number start, unit{1, 0};
        std::size_t piece = p;
        for (int level = 0; level < deep && !parts[piece].empty(); ++level) {
            const Part& first = parts[piece].front();
            start = start + unit * first.offset;
            unit = unit * shrink * turns[first.heading];
            piece = first.piece;
        }
        points[p] = start;
    }
}

Extent extent_of(const Descent& descent, double turn, int levels) {
    Extent extent;
    const auto visit = [&](const auto& self, const Placed& at, int left) -> void {
        const auto& disc = descent.discs[at.piece];
        const Number centre = at.start + at.unit * disc.centre;
        const double radius = at.size * disc.radius;
        if (left == 0 ||
            (centre.real() - radius > extent.left && centre.real() + radius < extent.right &&
             centre.imag() - radius > extent.low && centre.imag() + radius < extent.high)) {
            if (left > 0) return;
            extent.left = std::min(extent.left, centre.real() - radius);
            extent.right = std::max(extent.right, centre.real() + radius);
            extent.low = std::min(extent.low, centre.imag() - radius);
            extent.high = std::max(extent.high, centre.imag() + radius);
            return;
        }
        for (const auto& part : descent.parts[at.piece])
            self(
                self,
                {part.piece, at.start + at.unit * part.offset,
                 at.unit * descent.shrink * descent.turns[part.heading], at.size * descent.smaller},
                left - 1);
    };
    const Number rotation = polar(1, turn);
    for (const auto& part : descent.axiom)
        visit(visit,
              {part.piece, rotation * part.offset, rotation * descent.turns[part.heading], 1},
              levels);
    return extent;
}

}  // namespace algae
