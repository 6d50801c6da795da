#pragma once

#include <array>
#include <optional>
#include <vector>

namespace algae::oracle {

using Triple = std::array<double, 3>;

/// A solid for the ray caster: a box along the axes, a ball, or a round rod with flat ends.
struct Body {
    enum class Kind { box, ball, rod } kind = Kind::box;
    Triple low{}, high{};  // of a box; of a rod the ends; of a ball the middle, as `low`
    double radius = 0;
};

/// A place to look from and a middle to look at: angles in degrees, `opening` 0 for an orthographic
/// view. `radius`: of the ball around everything.
struct Eye {
    double azimuth = 0, elevation = 0, opening = 0;
    Triple middle{};
    double radius = 1;
};

/// The body that is met first by the line of sight through a point of the picture; nothing if none is.
/// One body after the other, each solved for by itself.
std::optional<std::size_t> first_met(const std::vector<Body>& bodies, const Eye& eye, double x,
                                     double y);

/// Where a point is seen, by plain rotation matrices: first about z, then about x, then divided by
/// the distance.
std::array<double, 2> seen_by_matrices(const Eye& eye, const Triple& point);

}  // namespace algae::oracle
