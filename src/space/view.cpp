#include "space/view.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

#include "base/error.hpp"
#include "space/scene_painter.hpp"
#include "space/seen_solid.hpp"
#include "system/colour.hpp"

namespace algae {

namespace {

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

ViewChoices view_choices(const Settings& settings) {
    ViewChoices choices;
    if (const auto& camera = settings.camera) {
        choices.camera = {camera->from.azimuth.value, camera->from.elevation.value,
                          camera->perspective};
        if (camera->opening) choices.camera.opening = camera->opening->value;
    }
    if (const auto& light = settings.light)
        choices.light = Light{light->azimuth.value, light->elevation.value};
    if (settings.fog) choices.fog = settings.fog->value;
    return choices;
}

SpaceView::SpaceView(Scene scene, const Settings& settings, const SceneFacts& facts,
                     const ViewChoices& choices, const Budget& budget)
    : scene_(std::move(scene)),
      settings_(settings),
      choices_(choices),
      projection_(choices.camera, choices.sight ? *choices.sight : thick_box(scene_)) {
    check_size(scene_, budget);
    if (!choices_.light) choices_.light = usual_light(choices_.camera);
    const Lighting checked(*choices_.light, choices_.fog, choices_.background, 0, 0);
    settings_.narrow.reset();  // widths are those of the rods
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
        lit.colours.push_back(name == "along" ? hue(0) : colour_named(name));

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
    for (const std::uint32_t i : painting.order) {
        if ((done++ & 0xff) == 0) {
            budget.check();
            if (canvas.wants_position())
                canvas.position(static_cast<double>(done) / static_cast<double>(things.size()));
        }
        painter.paint(things[i]);
    }
}

}  // namespace algae
