#include "space/scene_painter.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace algae {

namespace {

constexpr Colour grey{0.62, 0.62, 0.6}, black{0, 0, 0};
constexpr double fine = 1.6;  // pixels: tubes thinner than this are strokes
// Pixels are squares: what covers one that an edge touches reaches sqrt 2 pixels from the edge.
constexpr double under = 1.3;     // pixels that a facet reaches under one that is painted later
constexpr double overlap = 0.5;   // pixels that two that adjoin both reach over their edge
constexpr double thinnest = 0.5;  // pixels: thinner rods would fade away
constexpr double sharp =
    -0.5;  // cosine between the two sides of a joint above which it gets a ball

Vector unit(const Vector& way) {
    const double size = length(way);
    return size > 0 ? (1 / size) * way : way;
}

Point flat(const Seen& seen) { return {seen.x, seen.y}; }

/// A facet whose edges are moved outward where others adjoin, or may. Of a solid, a facet reaches
/// under those that are painted later; of polygons nobody knows which is.
void widen(const SeenFacet& facet, double pixel, bool of_solid, std::vector<Point>& corners) {
    const std::size_t count = facet.corners.size();
    corners.clear();
    double area = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const Vector &a = facet.corners[i], &b = facet.corners[(i + 1) % count];
        area += a.x * b.y - a.y * b.x;
    }
    const double out = area < 0 ? -pixel : pixel;
    const auto normal = [&](std::size_t i) {
        const Vector &a = facet.corners[i], &b = facet.corners[(i + 1) % count];
        const double x = b.y - a.y, y = a.x - b.x, size = std::hypot(x, y);
        return size > 0 ? Point{x / size, y / size} : Point{0, 0};
    };
    for (std::size_t i = 0; i < count; ++i) {
        const Vector& corner = facet.corners[i];
        const std::size_t before = (i + count - 1) % count;
        const auto moved = [&](std::size_t edge) {
            switch (facet.adjoins[edge]) {
                case Adjoining::nothing:  // another solid may stand beside this
                    return of_solid ? overlap * out : 0;
                case Adjoining::later:
                case Adjoining::cut:
                    return (of_solid ? under : overlap) * out;
                case Adjoining::earlier:
                    break;
            }
            return 0.0;
        };
        const double p = moved(before), q = moved(i);
        Point at{corner.x, corner.y};
        if (p != 0 || q != 0) {
            // Where the two moved edges meet; at a sharp tip, the end of each.
            const Point m = normal(before), n = normal(i);
            const double sine = m.x * n.y - m.y * n.x;
            if (std::fabs(sine) > 0.7) {
                at.x += (p * n.y - q * m.y) / sine;
                at.y += (q * m.x - p * n.x) / sine;
            } else {
                corners.push_back({corner.x + p * m.x, corner.y + p * m.y});
                at.x += q * n.x;
                at.y += q * n.y;
            }
        }
        corners.push_back(at);
    }
}

/// How far from the joint, along the rod that leaves it as `own`, the rod's surface in the direction
/// `aside` meets that of one of the same radius that leaves it as `other`.
double mitre(const Vector& own, const Vector& other, const Vector& aside, double radius) {
    const double cosine = dot(own, other);
    return cosine > 0.98 ? 0 : radius * dot(aside, other) / (1 - cosine);
}

}  // namespace

Colour LitScene::colour(const Paint& paint, bool line) const {
    if (paint.colour) return *paint.colour;
    if (default_colours) return line ? black : grey;
    return colours[paint.index % colours.size()];
}

double LitScene::end_radius(std::uint32_t rod) const {
    const std::uint32_t after = next[rod];
    const double own = scene.rods[rod].radius;
    return after == Rod::none || scene.rods[after].radius == 0
               ? own
               : std::min(own, scene.rods[after].radius);
}

ScenePainter::ScenePainter(Canvas& canvas, const LitScene& lit)
    : canvas_(canvas), lit_(lit), painted_(lit.scene.rods.size(), 0) {}

void ScenePainter::paint(const SeenThing& thing) {
    std::visit([this](const auto& kind) { paint_thing(kind); }, thing);
}

void ScenePainter::multiple_width(double factor) {
    if (!width_is_length_ && width_ == factor) return;
    canvas_.width(factor);
    width_ = factor;
    width_is_length_ = false;
}

void ScenePainter::length_width(double length) {
    if (width_is_length_ && width_ == length) return;
    canvas_.width_as_length(length);
    width_ = length;
    width_is_length_ = true;
}

void ScenePainter::polygon(const Colour& colour, std::span<const Point> corners) {
    canvas_.paint(colour);
    canvas_.polygon(corners);
}

void ScenePainter::paint_thing(const SeenStick& stick) {
    if (lit_.scene.rods[stick.rod].radius > 0)
        paint_tube(stick);
    else
        paint_line(stick);
}

void ScenePainter::paint_line(const SeenStick& stick) {
    const Rod& rod = lit_.scene.rods[stick.rod];
    const double half = (std::fabs(rod.line_width) / 2 + lit_.gap) * lit_.line_width;
    const double dx = stick.to.x - stick.from.x, dy = stick.to.y - stick.from.y,
                 way = std::hypot(dx, dy);
    const std::uint32_t before = rod.before, after = lit_.next[stick.rod];
    const bool has_gap = lit_.gap > 0 && half > 0;
    if (has_gap && way > 0) {
        const double x = dx / way, y = dy / way;
        const double a = stick.begins == 0 && before != Rod::none ? half : 0;
        const double b = stick.ends == 1 && after != Rod::none ? half : 0;
        if (way > a + b) {
            const Point from{stick.from.x + a * x, stick.from.y + a * y},
                to{stick.to.x - b * x, stick.to.y - b * y};
            polygon(lit_.background, std::array{Point{from.x - half * y, from.y + half * x},
                                                Point{from.x + half * y, from.y - half * x},
                                                Point{to.x + half * y, to.y - half * x},
                                                Point{to.x - half * y, to.y + half * x}});
        }
    }
    canvas_.paint(lit_.lighting.at_depth(lit_.colour(rod.paint, true),
                                         (stick.from.depth + stick.to.depth) / 2));
    multiple_width(rod.line_width);
    canvas_.move_to(flat(stick.from));
    canvas_.line_to(flat(stick.to));
    if (!has_gap) return;
    painted_[stick.rod] = 1;
    // What the gap may have taken from the ends of the lines that this one joins.
    if (stick.begins == 0 && before != Rod::none && painted_[before])
        paint_stub(before, false, 2 * half);
    if (stick.ends == 1 && after != Rod::none && painted_[after]) paint_stub(after, true, 2 * half);
}

void ScenePainter::paint_stub(std::uint32_t index, bool at_start, double reach) {
    const Rod& rod = lit_.scene.rods[index];
    if (rod.radius > 0) return;
    const Seen from = lit_.projection(at_start ? rod.from : rod.to),
               to = lit_.projection(at_start ? rod.to : rod.from);
    const double way = std::hypot(to.x - from.x, to.y - from.y);
    const double share = way > reach ? reach / way : 1;
    canvas_.paint(
        lit_.lighting.at_depth(lit_.colour(rod.paint, true), (from.depth + to.depth) / 2));
    multiple_width(rod.line_width);
    canvas_.move_to(flat(from));
    canvas_.line_to({from.x + share * (to.x - from.x), from.y + share * (to.y - from.y)});
}

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
                  ahead ? b : a, colour);
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
    if (free_end && dot(along, sight) > 0) paint_cap(to, along, side, b, colour);
    if (free_start && dot(along, sight) < 0) paint_cap(from, -1.0 * along, side, a, colour);
}

void ScenePainter::joint_ball(std::uint32_t rod, const Vector& middle, double radius,
                              const Colour& colour) {
    if (painted_[rod]) return;
    painted_[rod] = 1;
    const Seen seen = lit_.projection(middle);
    paint_ball(seen, radius * seen.scale, colour);
}

void ScenePainter::paint_cap(const Vector& middle, const Vector& outward, const Vector& side,
                             double radius, const Colour& colour) {
    constexpr int count = 32;
    const Vector other = cross(outward, side);
    corners_.clear();
    for (int i = 0; i < count; ++i) {
        const Turn turn = turn_by(360.0 * i / count);
        corners_.push_back(flat(
            lit_.projection(middle + radius * turn.cosine * side + radius * turn.sine * other)));
    }
    polygon(lit_.lighting(colour, outward, lit_.projection(middle).depth), corners_);
}

void ScenePainter::paint_thing(const SeenBall& ball) {
    paint_ball(ball.middle, ball.radius, ball.colour);
}

void ScenePainter::paint_ball(const Seen& middle, double radius, const Colour& colour) {
    const double pixels = lit_.resolution > 0 ? radius / lit_.resolution : 20;
    const Projection& camera = lit_.projection;
    const Vector light = lit_.lighting.toward();
    double x = dot(light, camera.right()), y = dot(light, camera.up()),
           z = std::max(0.05, dot(light, camera.toward()));
    const double size = std::sqrt(x * x + y * y + z * z);
    x /= size, y /= size, z /= size;
    const double aside = std::hypot(x, y), ux = aside > 0 ? x / aside : 1,
                 uy = aside > 0 ? y / aside : 0;
    const int levels = static_cast<int>(std::clamp(pixels * 1.2, 1.0, 40.0));
    const int count = 4 * static_cast<int>(std::clamp(pixels / 2, 3.0, 16.0));
    // What the light meets more directly than a bound is a cap of the ball: one over the other, from
    // the darkest, which is all that is seen of it.
    for (int level = 0; level < levels; ++level) {
        const double darkest = -aside;
        const double bound = darkest + (1 - darkest) * level / levels;
        const double across = level == 0 ? 1 : std::sqrt(std::max(0.0, 1 - bound * bound));
        corners_.clear();
        for (int i = 0; i < count; ++i) {
            const Turn turn = turn_by(360.0 * i / count);
            double px = turn.cosine, py = turn.sine;
            if (level > 0) {
                // A circle about the light, seen from the camera; what lies behind is seen at the rim.
                const double along = bound * aside + across * turn.cosine * z,
                             beside = across * turn.sine;
                const double deep = bound * z - across * turn.cosine * aside;
                px = along * ux - beside * uy;
                py = along * uy + beside * ux;
                const double rim = std::hypot(px, py);
                if (deep < 0 && rim > 0) px /= rim, py /= rim;
            }
            corners_.push_back({middle.x + radius * px, middle.y + radius * py});
        }
        const double cosine = bound + (1 - darkest) * 0.5 / levels;
        polygon(lit_.lighting.at_depth(Lighting::lit(colour, cosine), middle.depth), corners_);
    }
}

void ScenePainter::paint_thing(const SeenBlock& block) {
    for (const SeenFacet& facet : block.facets) {
        if (facet.corners.size() < 3) continue;
        widen(facet, lit_.resolution, !block.flat, corners_);
        polygon(facet.colour, corners_);
        if (block.has_edges) paint_edges(facet);
    }
}

void ScenePainter::paint_edges(const SeenFacet& facet) {
    constexpr double shade = 0.75, breadth = 0.8, least = 8;  // in pixels: of an edge, its length
    const std::size_t count = facet.corners.size();
    const double pixel = lit_.resolution;
    const Colour dark{shade * facet.colour.red, shade * facet.colour.green,
                      shade * facet.colour.blue};
    double area = 0, shortest = INFINITY;
    for (std::size_t i = 0; i < count; ++i) {
        const Vector &a = facet.corners[i], &b = facet.corners[(i + 1) % count];
        area += a.x * b.y - a.y * b.x;
        shortest = std::min(shortest, std::hypot(b.x - a.x, b.y - a.y));
    }
    if (!(pixel > 0) || shortest < least * pixel) return;
    const double inward = (area < 0 ? -breadth : breadth) * pixel;
    for (std::size_t i = 0; i < count; ++i) {
        if (facet.adjoins[i] == Adjoining::cut) continue;
        const Vector &a = facet.corners[i], &b = facet.corners[(i + 1) % count];
        const double size = std::hypot(b.x - a.x, b.y - a.y);
        const double x = -inward * (b.y - a.y) / size, y = inward * (b.x - a.x) / size;
        polygon(dark, std::array{Point{a.x, a.y}, Point{b.x, b.y}, Point{b.x + x, b.y + y},
                                 Point{a.x + x, a.y + y}});
    }
}

}  // namespace algae
