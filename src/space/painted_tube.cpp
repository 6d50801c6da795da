#include <algorithm>
#include <cmath>
#include <numbers>

#include "space/scene_painter.hpp"

// Rods with thickness: strips of a tube, mitred where they join.

namespace algae {

namespace {

constexpr double fine = 1.6;      // pixels: tubes thinner than this are strokes
constexpr double thinnest = 0.5;  // pixels: thinner rods would fade away
constexpr double sharp =
    -0.5;  // cosine between the two sides of a joint above which it gets a ball

Vector unit(const Vector& way) {
    const double size = length(way);
    return size > 0 ? (1 / size) * way : way;
}

/// How far from the joint, along the rod that leaves it as `own`, the rod's surface in the direction
/// `aside` meets that of one of the same radius that leaves it as `other`.
double mitre(const Vector& own, const Vector& other, const Vector& aside, double radius) {
    const double cosine = dot(own, other);
    return cosine > 0.98 ? 0 : radius * dot(aside, other) / (1 - cosine);
}

}  // namespace

void ScenePainter::paint_tube(const SeenStick& stick) {
    const Rod& rod = lit_.scene.rods[stick.rod];
    const Vector whole = rod.to - rod.from, along = unit(whole);
    const double last = lit_.end_radius(stick.rod);
    const double a = rod.radius + stick.begins * (last - rod.radius),
                 b = rod.radius + stick.ends * (last - rod.radius);
    Vector from = rod.from + stick.begins * whole, to = rod.from + stick.ends * whole;
    const double pixel = lit_.resolution;
    const Colour colour = lit_.colour(rod.paint, false);
    const Vector sight = lit_.projection.to_camera(0.5 * (from + to));
    const double depth = (stick.from.depth + stick.to.depth) / 2;
    Vector side = cross(sight, along);
    const double slant = length(side);  // 0: seen from its end
    if (slant < 1e-6) {
        const bool ahead = stick.to.depth >= stick.from.depth;
        paint_cap(ahead ? to : from, sight,
                  unit(cross(sight, std::fabs(sight.z) < 0.9 ? Vector{0, 0, 1} : Vector{1, 0, 0})),
                  ahead ? b : a, 32, colour);
        return;
    }
    side = (1 / slant) * side;
    const Vector front = cross(along, side);
    const double thickness = 2 * std::max(stick.from_radius, stick.to_radius);
    const auto shade = [&](double aside) {
        const Vector normal = aside * side + std::sqrt(std::max(0.0, 1 - aside * aside)) * front;
        return lit_.lighting(colour, normal, depth);
    };
    if (pixel > 0 && thickness < fine * pixel) {
        Colour mean;
        for (const double aside : {-0.7, 0.0, 0.7}) {
            const Colour part = shade(aside);
            mean = {mean.red + part.red / 3, mean.green + part.green / 3,
                    mean.blue + part.blue / 3};
        }
        canvas_.paint(mean);
        length_width(std::max(stick.from_radius + stick.to_radius, thinnest * pixel));
        canvas_.move_to(flat(stick.from));
        canvas_.line_to(flat(stick.to));
        return;
    }

    // The two ends: cut by the plane between this rod and the one it joins, or straight.
    const bool starts = stick.begins == 0, stops = stick.ends == 1;
    const std::uint32_t before = starts && !rod.branch ? rod.before : Rod::none;
    const std::uint32_t after = stops ? lit_.next[stick.rod] : Rod::none;
    const auto direction = [&](std::uint32_t index) {
        return unit(lit_.scene.rods[index].to - lit_.scene.rods[index].from);
    };
    const Vector back = before == Rod::none ? Vector{} : -1.0 * direction(before);
    const Vector ahead = after == Rod::none ? Vector{} : direction(after);
    const bool ball_at_start = before != Rod::none && dot(along, back) > sharp;
    const bool ball_at_end = after != Rod::none && dot(-1.0 * along, ahead) > sharp;
    Vector below, beside;  // where the rods lead that a branch grows between
    if (starts && rod.branch && rod.before != Rod::none) {
        // A branch begins just under the surface of the rod it grows from.
        below = -1.0 * direction(rod.before);
        if (lit_.next[rod.before] != Rod::none) beside = direction(lit_.next[rod.before]);
        const double thick = lit_.end_radius(rod.before),
                     cosine = std::fabs(dot(along, direction(rod.before)));
        const double sine = std::sqrt(std::max(0.0, 1 - cosine * cosine));
        if (thick > a && sine > 0.2) {
            const double inside = (std::sqrt(thick * thick - a * a) - a * cosine) / sine;
            from = from + std::clamp(inside, 0.0, 0.8 * length(to - from)) * along;
        }
    }
    if (ball_at_start) joint_ball(stick.rod, from, a, colour);
    if (ball_at_end) joint_ball(after, to, b, colour);

    const double half = length(to - from) / 2;
    const double more = pixel > 0 && slant > 0.1 ? overlap * pixel / slant : 0;
    const auto corner = [&](double aside, bool end) {
        const Vector outward = aside * side + std::sqrt(std::max(0.0, 1 - aside * aside)) * front;
        const double radius = end ? b : a;
        const Vector own = end ? -1.0 * along : along;
        const bool joined = (end ? after : before) != Rod::none,
                   ball = end ? ball_at_end : ball_at_start;
        double cut = joined ? mitre(own, end ? ahead : back, outward, radius) : 0;
        if (ball) cut = std::max(0.0, cut);
        if (!end && starts && rod.branch)
            cut = std::max(
                {cut, mitre(along, below, outward, radius), mitre(along, beside, outward, radius)});
        if ((joined && !ball) || (end ? !stops : !starts)) cut -= more;
        return flat(
            lit_.projection((end ? to : from) + std::min(cut, half) * own + radius * outward));
    };
    const double pixels = pixel > 0 ? thickness / pixel : 40;
    const int strips =
        pixels < 2.5 ? 3
                     : static_cast<int>(std::clamp(2 + pixels / 1.5, 4.0,
                                                   lit_.scene.rods.size() > 2000 ? 20.0 : 40.0));
    const double reach = pixel > 0 ? 2 * under / pixels : 0;
    for (int i = 0; i < strips; ++i) {
        const double left = -std::cos(std::numbers::pi * i / strips);
        const double right = -std::cos(std::numbers::pi * (i + 1) / strips);
        const double wide = std::min(1.0, right + (i + 1 < strips ? reach : 0));
        const double middle = -std::cos(std::numbers::pi * (i + 0.5) / strips);
        polygon(shade(middle), std::array{corner(left, false), corner(wide, false),
                                          corner(wide, true), corner(left, true)});
    }
    if (pixels < 3) return;
    const bool free_start = starts && rod.before == Rod::none,
               free_end = stops && after == Rod::none;
    if (free_end && dot(along, sight) > 0) paint_cap(to, along, side, b, 2 * strips, colour);
    if (free_start && dot(along, sight) < 0)
        paint_cap(from, -1.0 * along, side, a, 2 * strips, colour);
}

void ScenePainter::joint_ball(std::uint32_t rod, const Vector& middle, double radius,
                              const Colour& colour) {
    if (painted_[rod]) return;
    painted_[rod] = 1;
    const Seen seen = lit_.projection(middle);
    paint_ball(seen, radius * seen.scale, colour);
}

void ScenePainter::paint_cap(const Vector& middle, const Vector& outward, const Vector& side,
                             double radius, int count, const Colour& colour) {
    const Vector other = cross(outward, side);
    corners_.clear();
    for (int i = 0; i < count; ++i) {
        const Turn turn = turn_by(360.0 * i / count);
        corners_.push_back(flat(
            lit_.projection(middle + radius * turn.cosine * side + radius * turn.sine * other)));
    }
    polygon(lit_.lighting(colour, outward, lit_.projection(middle).depth), corners_);
}

}  // namespace algae
