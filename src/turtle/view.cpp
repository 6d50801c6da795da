#include "turtle/detail/view.hpp"
#include "watch/watch.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <numbers>
#include <utility>

// The picture of a scene: what is in front hides what is behind.
//
// Every rod, polygon and solid becomes a thing as the camera sees it, convex, with a box around it. The
// things are painted from far to near in the order that painting_order finds. Things that hide each other
// in a ring have no order: they are halved, which in the end leaves rings of parts too small to be seen, and
// a new order is looked for, a few times at most.
//
// What is subtle: edges at which another polygon goes on are found beforehand by hashing their end points,
// for there the picture must show no seam; thin things among very many are not compared with each other;
// a frame of a film brings the box it is seen in (`sight`), so that camera and fog stay the same.
//
// Painting. A canvas smooths the edges of what it fills, so that two polygons that meet at an edge would
// let the background shine through. So a facet reaches a little under the one beside it that is painted later, and
// where nobody knows which is later both reach over their edge (widen).
//
// A tube is a few strips along the rod, cut by the plane between this rod and the one it joins (mitre);
// at sharp joints a ball closes the gap, and a branch begins under the surface of the rod it grows from.
// A ball is caps of equal light, one over the other. Lines without thickness may keep free a gap beside
// them where they pass in front of others; the gap of one takes from the ends of the lines it joins, which
// are drawn again there (paint_stub).

namespace algae {

namespace {

constexpr Colour grey{0.62, 0.62, 0.6}, black{0, 0, 0};

constexpr double fine = 1.6;      // pixels: tubes thinner than this are strokes
constexpr double thinnest = 0.5;  // pixels: thinner rods would fade away
constexpr double sharp =
    -0.5;  // cosine between the two sides of a joint above which it gets a ball

/// How far from the joint, along the rod that leaves it as `own`, the rod's surface in the direction
/// `aside` meets that of one of the same radius that leaves it as `other`.
double mitre(const Vector& own, const Vector& other, const Vector& aside, double radius) {
    const double cosine = dot(own, other);
    return cosine > 0.98 ? 0 : radius * dot(aside, other) / (1 - cosine);
}

/// 1 if the corners go round counter-clockwise in the picture, else -1.
double orientation(const SeenFacet& facet) {
    double area = 0;
    for (std::size_t i = 0; i < facet.corners.size(); ++i) {
        const Vector &a = facet.corners[i], &b = facet.corners[(i + 1) % facet.corners.size()];
        area += a.x * b.y - a.y * b.x;
    }
    return area < 0 ? -1 : 1;
}

/// A scene in the light and the measures of its rods: what painting needs to know.
struct LitScene {
    const Scene& scene;
    const Projection& projection;
    const Lighting& lighting;
    std::vector<std::uint32_t> next;  // by rod: the one that goes on where it ends, or Rod::none
    double resolution = 0;            // the size of a pixel in the picture; 0: unknown
    double line_width = 0;            // of lines without thickness, in the picture; 0: unknown
    double gap = 0;                   // kept free beside such lines, as a multiple of their width
    Colour background;
    std::vector<Colour> colours;   // the scene's list
    bool default_colours = false;  // the scene has no list: lines are black, the rest is grey

    Colour colour(const Paint& paint, bool line) const {
        if (paint.colour) return *paint.colour;
        if (default_colours) return line ? black : grey;
        return colours[paint.index % colours.size()];
    }

    /// The radius at a rod's end: that of the next where it is thinner.
    double end_radius(std::uint32_t rod) const {
        const std::uint32_t after = next[rod];
        const double own = scene.rods[rod].radius;
        return after == Rod::none || scene.rods[after].radius == 0
                   ? own
                   : std::min(own, scene.rods[after].radius);
    }
};

/// Sends things as a camera sees them to a canvas as shaded polygons and strokes.
class ScenePainter {
public:
    ScenePainter(Canvas& canvas, const LitScene& lit)
        : canvas_(canvas), lit_(lit), painted_(lit.scene.rods.size(), 0) {}

    void paint(const SeenThing& thing) {
        std::visit([this](const auto& kind) { paint_thing(kind); }, thing);
    }

private:
    void paint_thing(const SeenStick& stick) {
        if (lit_.scene.rods[stick.rod].radius > 0)
            paint_tube(stick);
        else
            paint_line(stick);
    }

    void paint_thing(const SeenBall& ball) { paint_ball(ball.middle, ball.radius, ball.colour); }

    void paint_thing(const SeenBlock& block) {
        for (const SeenFacet& facet : block.facets) {
            if (facet.corners.size() < 3) continue;
            widen(facet, lit_.resolution, !block.flat, corners_);
            polygon(facet.colour, corners_);
            if (block.has_edges) paint_edges(facet);
        }
    }

    /// Its edges, darker, where they are long enough to be seen.
    void paint_edges(const SeenFacet& facet) {
        constexpr double shade = 0.75, breadth = 0.8,
                         least = 8;  // in pixels: of an edge, its length
        const std::size_t count = facet.corners.size();
        const double pixel = lit_.resolution;
        const Colour dark{shade * facet.colour.red, shade * facet.colour.green,
                          shade * facet.colour.blue};
        double shortest = INFINITY;
        for (std::size_t i = 0; i < count; ++i) {
            const Vector &a = facet.corners[i], &b = facet.corners[(i + 1) % count];
            shortest = std::min(shortest, std::hypot(b.x - a.x, b.y - a.y));
        }
        if (!(pixel > 0) || shortest < least * pixel) return;
        const double inward = orientation(facet) * breadth * pixel;
        for (std::size_t i = 0; i < count; ++i) {
            if (facet.adjoins[i] == Adjoining::cut) continue;
            const Vector &a = facet.corners[i], &b = facet.corners[(i + 1) % count];
            const double size = std::hypot(b.x - a.x, b.y - a.y);
            const double x = -inward * (b.y - a.y) / size, y = inward * (b.x - a.x) / size;
            polygon(dark, std::array{Point{a.x, a.y}, Point{b.x, b.y}, Point{b.x + x, b.y + y},
                                     Point{a.x + x, a.y + y}});
        }
    }

    void paint_line(const SeenStick& stick) {
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
        if (stick.ends == 1 && after != Rod::none && painted_[after])
            paint_stub(after, true, 2 * half);
    }

    void paint_tube(const SeenStick& stick) {
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
            paint_cap(
                ahead ? to : from, sight,
                unit(cross(sight, std::fabs(sight.z) < 0.9 ? Vector{0, 0, 1} : Vector{1, 0, 0})),
                ahead ? b : a, 32, colour);
            return;
        }
        side = (1 / slant) * side;
        const Vector front = cross(along, side);
        const double thickness = 2 * std::max(stick.from_radius, stick.to_radius);
        const auto shade = [&](double aside) {
            const Vector normal =
                aside * side + std::sqrt(std::max(0.0, 1 - aside * aside)) * front;
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
            const Vector outward =
                aside * side + std::sqrt(std::max(0.0, 1 - aside * aside)) * front;
            const double radius = end ? b : a;
            const Vector own = end ? -1.0 * along : along;
            const bool joined = (end ? after : before) != Rod::none,
                       ball = end ? ball_at_end : ball_at_start;
            double cut = joined ? mitre(own, end ? ahead : back, outward, radius) : 0;
            if (ball) cut = std::max(0.0, cut);
            if (!end && starts && rod.branch)
                cut = std::max({cut, mitre(along, below, outward, radius),
                                mitre(along, beside, outward, radius)});
            if ((joined && !ball) || (end ? !stops : !starts)) cut -= more;
            return flat(
                lit_.projection((end ? to : from) + std::min(cut, half) * own + radius * outward));
        };
        const double pixels = pixel > 0 ? thickness / pixel : 40;
        const int strips =
            pixels < 2.5 ? 3
                         : static_cast<int>(std::clamp(
                               2 + pixels / 1.5, 4.0, lit_.scene.rods.size() > 2000 ? 20.0 : 40.0));
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

    /// A disc at the end of a tube that looks at the camera, with so many corners: those of the tube's
    /// strips, so that nothing shows between them.
    void paint_cap(const Vector& middle, const Vector& outward, const Vector& side, double radius,
                   int count, const Colour& colour) {
        const Vector other = cross(outward, side);
        corners_.clear();
        for (int i = 0; i < count; ++i) {
            const Turn turn = turn_by(360.0 * i / count);
            corners_.push_back(flat(lit_.projection(middle + radius * turn.cosine * side +
                                                    radius * turn.sine * other)));
        }
        polygon(lit_.lighting(colour, outward, lit_.projection(middle).depth), corners_);
    }

    void paint_ball(const Seen& middle, double radius, const Colour& colour) {
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

    void paint_stub(std::uint32_t index, bool at_start, double reach) {
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

    void joint_ball(std::uint32_t rod, const Vector& middle, double radius, const Colour& colour) {
        if (painted_[rod]) return;
        painted_[rod] = 1;
        const Seen seen = lit_.projection(middle);
        paint_ball(seen, radius * seen.scale, colour);
    }

    void multiple_width(double factor) {
        if (!width_is_length_ && width_ == factor) return;
        canvas_.width(factor);
        width_ = factor;
        width_is_length_ = false;
    }

    void length_width(double length) {
        if (width_is_length_ && width_ == length) return;
        canvas_.width_as_length(length);
        width_ = length;
        width_is_length_ = true;
    }

    void polygon(const Colour& colour, std::span<const Point> corners) {
        canvas_.paint(colour);
        canvas_.polygon(corners);
    }

    // Pixels are squares: what covers one that an edge touches reaches sqrt 2 pixels from the edge.
    static constexpr double under =
        1.3;  // pixels that a facet reaches under one that is painted later
    static constexpr double overlap =
        0.5;  // pixels that two that adjoin both reach over their edge

    static Point flat(const Seen& seen) { return {seen.x, seen.y}; }
    /// A facet whose edges are moved outward where others adjoin, or may. Of a solid, a facet reaches
    /// under those that are painted later; of polygons nobody knows which is.
    static void widen(const SeenFacet& facet, double pixel, bool of_solid,
                      std::vector<Point>& corners) {
        const std::size_t count = facet.corners.size();
        corners.clear();
        const double out = orientation(facet) * pixel;
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

    Canvas& canvas_;
    const LitScene& lit_;
    std::vector<char>
        painted_;  // by rod: drawn already (lines), or the ball at its start is (tubes)
    std::vector<Point> corners_;
    double width_ = 1;  // of the canvas' pen
    bool width_is_length_ = false;
};

constexpr std::size_t bytes_of_rod = 320, bytes_of_face = 900, bytes_of_solid = 3000;
constexpr std::size_t few = 30'000;  // things: what is slight is compared, too
constexpr double slight_pixels = 1.3;
constexpr int most_halvings = 6;

/// The box of a scene, with the thickness of its rods: what a camera must hold.
SpaceBox thick_box(const Scene& scene) {
    SpaceBox box = box_of(scene);
    double radius = 0;
    for (const Rod& rod : scene.rods) radius = std::max(radius, rod.radius);
    if (box.empty || radius == 0) return box;
    const Vector around{radius, radius, radius};
    const Vector low = box.low - around, high = box.high + around;
    box.add(low);
    box.add(high);
    return box;
}

void check_size(const Scene& scene, const Budget& budget) {
    const std::uint64_t bytes = scene.rods.size() * bytes_of_rod +
                                scene.faces.size() * bytes_of_face +
                                scene.solids.size() * bytes_of_solid;
    budget.check_memory(bytes, ("the picture of the " + std::to_string(scene.parts()) +
                                " parts of " + (scene.name.empty() ? "a scene" : scene.name))
                                   .c_str());
}

/// By corner: whether the edge of a face that begins there is also one of another face.
std::vector<char> adjoining_edges(const Scene& scene) {
    std::vector<char> adjoins(scene.corners.size(), 0);
    if (scene.faces.size() < 2) return adjoins;
    const auto mix = [](const Vector& v) {
        std::uint64_t hash = 0;
        for (const double part : {v.x, v.y, v.z})
            hash = (hash ^ std::bit_cast<std::uint64_t>(part + 0.0)) * 0x9E3779B97F4A7C15u,
            hash ^= hash >> 29;
        return hash;
    };
    std::vector<std::pair<std::uint64_t, std::uint32_t>> edges;
    edges.reserve(scene.corners.size());
    for (const Face& face : scene.faces)
        for (std::uint32_t i = 0; i < face.corners; ++i) {
            const Vector &a = scene.corners[face.first + i],
                         &b = scene.corners[face.first + (i + 1) % face.corners];
            edges.emplace_back(mix(a) + mix(b), face.first + i);
        }
    std::sort(edges.begin(), edges.end());
    for (std::size_t i = 1; i < edges.size(); ++i)
        if (edges[i].first == edges[i - 1].first)
            adjoins[edges[i].second] = adjoins[edges[i - 1].second] = 1;
    return adjoins;
}

}  // namespace

SpaceView::SpaceView(Scene scene, const FigureStyle& style, const SceneFacts& facts,
                     const ViewChoices& choices, const Budget& budget)
    : scene_(std::move(scene)),
      style_(style),
      choices_(choices),
      projection_(choices.camera, choices.sight ? *choices.sight : thick_box(scene_)) {
    check_size(scene_, budget);
    if (!choices_.light) choices_.light = usual_light(choices_.camera);
    const Lighting checked(*choices_.light, choices_.fog, choices_.background, 0, 0);
    facts_.rounded = facts.rounded;
    style_.narrow.reset();  // widths are those of the rods
    next_.assign(scene_.rods.size(), Rod::none);
    for (std::uint32_t i = 0; i < scene_.rods.size(); ++i) {
        const Rod& rod = scene_.rods[i];
        if (rod.branch)
            branches_ = true;
        else if (rod.before != Rod::none)
            next_[rod.before] = i;
    }
    adjoins_ = adjoining_edges(scene_);

    bool first = true;
    const auto add = [&](const Vector& point, double radius) {
        const Seen seen = projection_(point);
        const auto [low, high] = projection_.outline(point, radius);
        box_.add(low);
        box_.add(high);
        farthest_ = first ? seen.depth : std::min(farthest_, seen.depth);
        nearest_ = first ? seen.depth : std::max(nearest_, seen.depth);
        first = false;
    };
    for (std::uint32_t i = 0; i < scene_.rods.size(); ++i) {
        if ((i & 0xffff) == 0) budget.check();
        add(scene_.rods[i].from, scene_.rods[i].radius);
        add(scene_.rods[i].to, scene_.rods[i].radius);
    }
    for (const Vector& corner : scene_.corners) add(corner, 0);
    for (const Solid& solid : scene_.solids)
        for (const Vector& corner : corners_of(solid))
            add(corner, solid.shape == SolidShape::sphere ? solid.size.x : 0);

    if (choices_.sight)
        for (int corner = 0; corner < 8; ++corner) {
            const Vector &low = choices_.sight->low, &high = choices_.sight->high;
            const double depth =
                projection_({(corner & 1) != 0 ? low.x : high.x, (corner & 2) != 0 ? low.y : high.y,
                             (corner & 4) != 0 ? low.z : high.z})
                    .depth;
            farthest_ = corner == 0 ? depth : std::min(farthest_, depth);
            nearest_ = corner == 0 ? depth : std::max(nearest_, depth);
        }

    facts_.segments = Integer(static_cast<std::uint64_t>(scene_.rods.size()));
    facts_.end = {Coordinate(facts.end.x), Coordinate(facts.end.y), Coordinate(facts.end.z)};
    facts_.step = facts.step;
    const SpaceBox around = box_of(scene_);
    if (around.empty) return;
    facts_.low = {Coordinate(around.low.x), Coordinate(around.low.y), Coordinate(around.low.z)};
    facts_.high = {Coordinate(around.high.x), Coordinate(around.high.y), Coordinate(around.high.z)};
}

std::optional<Point> SpaceView::place(const Vector& point) const {
    const Seen seen = projection_(point);
    return std::isfinite(seen.x + seen.y) && seen.scale > 0 ? std::optional(Point{seen.x, seen.y})
                                                            : std::nullopt;
}

void SpaceView::draw(Canvas& canvas, double resolution, const Budget& budget) const {
    const Lighting lighting(*choices_.light, choices_.fog, choices_.background, farthest_,
                            nearest_);
    LitScene lit{scene_,
                 projection_,
                 lighting,
                 next_,
                 resolution,
                 canvas.line_width(),
                 choices_.gap.value_or(branches_ ? 0 : 1),
                 choices_.background,
                 {},
                 scene_.colours.empty()};
    for (const std::string& name : scene_.colours)
        lit.colours.push_back(is_scheme(name) ? scheme_colour(name, 0) : colour_named(name));

    std::vector<SeenThing> things;
    things.reserve(scene_.parts());
    for (std::uint32_t i = 0; i < scene_.rods.size(); ++i) {
        if ((i & 0xffff) == 0) budget.check();
        const Rod& rod = scene_.rods[i];
        SeenStick stick{i, 0, 1, projection_(rod.from), projection_(rod.to), 0, 0};
        const double line = std::fabs(rod.line_width) * lit.line_width / 2;
        stick.from_radius = rod.radius > 0 ? rod.radius * stick.from.scale : line;
        stick.to_radius = rod.radius > 0 ? lit.end_radius(i) * stick.to.scale : line;
        things.emplace_back(stick);
    }
    for (const Face& face : scene_.faces)
        things.push_back(seen(scene_.corners_of(face),
                              std::span(adjoins_).subspan(face.first, face.corners),
                              lit.colour(face.paint, false), projection_, lighting));
    for (const Solid& solid : scene_.solids) {
        budget.check();
        const double scale = projection_(solid.middle).scale;
        things.push_back(seen(solid, lit.colour(solid.paint, false),
                              sides_of(solid.size.y * scale, resolution), projection_, lighting));
    }

    std::vector<Extent> extents;
    PaintingOrder painting;
    for (int halving = 0;; ++halving) {
        extents.clear();
        for (const SeenThing& thing : things) {
            Extent extent = extent_of(thing);
            if (const auto* stick = std::get_if<SeenStick>(&thing))
                extent.slight = things.size() > few &&
                                stick->from_radius + stick->to_radius < slight_pixels * resolution;
            extents.push_back(extent);
        }
        painting = painting_order(
            extents, [&](std::uint32_t a, std::uint32_t b) { return hides(things[a], things[b]); },
            budget);
        if (painting.knotted.empty() || halving == most_halvings || things.size() > 2 * few) break;
        bool halved = false;
        for (const std::uint32_t i : painting.knotted) {
            const Extent& extent = extents[i];
            if (std::max(extent.right - extent.left, extent.top - extent.bottom) <= 3 * resolution)
                continue;
            if (auto* stick = std::get_if<SeenStick>(&things[i])) {
                SeenStick rest = *stick;
                const Rod& rod = scene_.rods[stick->rod];
                const double middle = (stick->begins + stick->ends) / 2;
                const Seen cut = projection_(rod.from + middle * (rod.to - rod.from));
                const double radius = (stick->from_radius + stick->to_radius) / 2;
                stick->ends = rest.begins = middle;
                stick->to = rest.from = cut;
                stick->to_radius = rest.from_radius = radius;
                things.emplace_back(rest);
                halved = true;
            } else if (const auto* block = std::get_if<SeenBlock>(&things[i])) {
                auto [left, right] = halves(*block);
                things[i] = std::move(left);
                things.emplace_back(std::move(right));
                halved = true;
            }
        }
        if (!halved) break;
    }

    ScenePainter painter(canvas, lit);
    std::size_t done = 0;
    WorkCount painted("part of the view", painting.order.size());
    for (const std::uint32_t i : painting.order) {
        if ((done++ & 0xff) == 0) {
            budget.check();
            painted.at(done);
            if (canvas.wants_position())
                canvas.position(static_cast<double>(done) / static_cast<double>(things.size()));
        }
        painter.paint(things[i]);
    }
}

}  // namespace algae
