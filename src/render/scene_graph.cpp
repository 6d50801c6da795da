#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "render/detail/scene_graph.hpp"
#include "turtle/turtle.hpp"
#include "watch/watch.hpp"

// A scene as VRML and X3D describe one: solids that stay solids, surfaces, lines, viewpoints and a light.
//
// Solids are nodes of their own kind, and so are rods that stand alone and end flat: cylinders. Above 20,000 such bodies all rods
// are surfaces. The other rods are tubes, and together with the polygons they are one surface for each colour, closed parts apart
// from sheets, which are seen from both sides; a point where the paint changes is in two of them. Strokes without thickness are
// polylines, one set for each colour.
//
// Each node has its absolute place; no transformation is inherited. A rotation is an axis and an angle, taken from the quaternion
// of the three axes by the largest of its parts (Shepperd 1978).
//
// A figure that leaves the plane z = 0 stands upright in these formats, whose y is up: (x, y, z) becomes (x, z, -y). The first
// viewpoint is then the camera, and front, side and above follow; a figure of the plane is looked at from straight in front, from
// the left and from the right. A viewpoint is so far away that the whole box is seen, and the light comes over the left shoulder
// of the first.

namespace algae {

namespace {

constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
constexpr std::size_t most_bodies = 20'000;

class SceneBuilder {
public:
    SceneBuilder(const Scene& scene, const MeshOptions& options, const Budget& budget)
        : scene_(scene), options_(options), budget_(budget), upright_(is_in_space(box_of(scene))) {}

    SceneGraph built(const Camera& camera, const std::optional<Light>& light) {
        graph_.title = scene_.name;
        graph_.upright = upright_;
        graph_.crease = options_.crease * std::numbers::pi / 180;
        const Scene thick = without_lines();
        if (!thick.rods.empty() || !thick.faces.empty() || !thick.solids.empty()) add_shapes(thick);
        add_lines();
        look(camera);
        if (light) {
            const Turn around = turn_by(light->azimuth), above = turn_by(light->elevation);
            graph_.light =
                placed({-above.cosine * around.cosine, -above.cosine * around.sine, -above.sine});
        }
        return std::move(graph_);
    }

private:
    /// In the axes of the file.
    Vector placed(const Vector& v) const { return upright_ ? Vector{v.x, v.z, -v.y} : v; }

    std::uint32_t colour(const Paint& paint) {
        const Colour wanted = paint.colour.value_or(Colour{});
        const auto found = std::find(graph_.colours.rbegin(), graph_.colours.rend(), wanted);
        if (found != graph_.colours.rend())
            return static_cast<std::uint32_t>(graph_.colours.rend() - found - 1);
        graph_.colours.push_back(wanted);
        return static_cast<std::uint32_t>(graph_.colours.size() - 1);
    }
    Scene without_lines() const {
        Scene thick;
        thick.name = scene_.name;
        thick.corners = scene_.corners;
        thick.faces = scene_.faces;
        thick.solids = scene_.solids;
        std::vector<std::uint32_t> places(scene_.rods.size(), none);
        for (std::uint32_t i = 0; i < scene_.rods.size(); ++i) {
            if (!(scene_.rods[i].radius > 0)) continue;
            places[i] = static_cast<std::uint32_t>(thick.rods.size());
            Rod rod = scene_.rods[i];
            rod.before = rod.before < i ? places[rod.before] : Rod::none;
            thick.rods.push_back(rod);
        }
        return thick;
    }
    void add_shapes(const Scene& thick) {
        const Thickness thickness = algae::thickness(thick);
        const Limbs limbs = limbs_of(thick, thickness, budget_);
        std::size_t bodies = thick.solids.size();
        for (const Limb& limb : limbs.limbs) bodies += is_cylinder(limbs, limb);
        MeshOptions options = options_;
        options.cylinders = bodies > most_bodies;
        options.solids = false;
        const Mesh mesh = mesh_of(thick, options, budget_);
        graph_.box.add(algae::box_of(mesh));
        if (!options.cylinders)
            for (const Limb& limb : limbs.limbs)
                if (is_cylinder(limbs, limb)) add_rod(limbs.nodes_of(limb), thick);
        for (const Solid& solid : thick.solids) add_solid(solid, thickness);
        Scene solids;
        solids.solids = thick.solids;
        graph_.box.add(algae::box_of(solids));
        add_surfaces(mesh);
    }
    void add_rod(std::span<const Limbs::Node> nodes, const Scene& thick) {
        const Vector way = nodes[1].point - nodes[0].point, y = unit(way);
        const Vector level = cross({0, 0, 1}, y);
        const Vector x = length(level) > 1e-3 ? unit(level) : unit(cross({0, 1, 0}, y));
        SceneGraph::Body& body = graph_.bodies.emplace_back();
        body.shape = SolidShape::cylinder;
        body.middle = placed(0.5 * (nodes[0].point + nodes[1].point));
        body.turn = turn_to(placed(x), placed(y), placed(cross(x, y)));
        body.size = {nodes[0].radius, length(way), 0};
        body.colour = colour(thick.rods[nodes[0].rod].paint);
        const Vector reach{nodes[0].radius * std::sqrt(std::max(0.0, 1 - y.x * y.x)),
                           nodes[0].radius * std::sqrt(std::max(0.0, 1 - y.y * y.y)),
                           nodes[0].radius * std::sqrt(std::max(0.0, 1 - y.z * y.z))};
        for (const Limbs::Node& node : nodes) {
            graph_.box.add(node.point - reach);
            graph_.box.add(node.point + reach);
        }
    }
    void add_solid(const Solid& solid, const Thickness& thickness) {
        const auto measure = [&](double size) {
            return std::max(size == 0 ? thickness.line : std::fabs(size), thickness.least);
        };
        const Vector h = placed(solid.attitude.heading()), l = placed(solid.attitude.left()),
                     u = placed(solid.attitude.up());
        SceneGraph::Body& body = graph_.bodies.emplace_back();
        body.shape = solid.shape;
        body.middle = placed(solid.middle);
        body.colour = colour(solid.paint);
        if (solid.shape == SolidShape::box) {
            body.turn = turn_to(h, l, u);
            body.size = {measure(solid.size.x), measure(solid.size.y), measure(solid.size.z)};
            return;
        }
        body.turn = turn_to(u, h, l);
        if (solid.shape == SolidShape::sphere)
            body.size = {measure(solid.size.x), 0, 0};
        else
            body.size = {measure(solid.size.y), measure(solid.size.x), 0};
    }
    void add_surfaces(const Mesh& mesh) {
        const std::size_t paints = mesh.paints.size();
        std::vector<SceneGraph::Surface> surfaces(2 * paints);
        for (std::size_t i = 0; i < surfaces.size(); ++i) {
            surfaces[i].sheet = i >= paints;
            surfaces[i].colour = colour(mesh.paints[i % paints]);
        }
        // A point of two colours, at a joint where the paint changes, is in two surfaces.
        std::vector<std::uint32_t> known(mesh.points.size(), none), owner(mesh.points.size(), none);
        WorkCount triangles("triangle", mesh.triangles.size());
        for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
            if (i % 4096 == 0) budget_.check();
            triangles.at(i);
            const auto which = static_cast<std::uint32_t>(mesh.corners[mesh.triangles[i][0]].paint +
                                                          (i < mesh.closed ? 0 : paints));
            SceneGraph::Surface& surface = surfaces[which];
            Mesh::Triangle triangle;
            for (std::size_t k = 0; k < 3; ++k) {
                const std::uint32_t point = mesh.corners[mesh.triangles[i][k]].point;
                if (owner[point] != which) {
                    owner[point] = which;
                    known[point] = static_cast<std::uint32_t>(surface.points.size());
                    surface.points.push_back(placed(mesh.points[point]));
                }
                triangle[k] = known[point];
            }
            surface.triangles.push_back(triangle);
        }
        for (SceneGraph::Surface& surface : surfaces) {
            if (surface.triangles.empty()) continue;
            graph_.vertices += surface.points.size();
            graph_.triangles += surface.triangles.size();
            graph_.surfaces.push_back(std::move(surface));
        }
    }
    void add_lines() {
        std::vector<std::uint32_t> groups;  // of each colour
        std::vector<std::uint32_t> last;    // rod of each group
        for (std::uint32_t i = 0; i < scene_.rods.size(); ++i) {
            const Rod& rod = scene_.rods[i];
            if (rod.radius > 0) continue;
            const std::uint32_t shade = colour(rod.paint);
            groups.resize(graph_.colours.size(), none);
            if (groups[shade] == none) {
                groups[shade] = static_cast<std::uint32_t>(graph_.lines.size());
                graph_.lines.emplace_back().colour = shade;
                last.push_back(none);
            }
            SceneGraph::Lines& lines = graph_.lines[groups[shade]];
            std::uint32_t& end = last[groups[shade]];
            if (rod.before == none || rod.before != end) {
                lines.points.push_back(placed(rod.from));
                lines.strokes.push_back(1);
            }
            lines.points.push_back(placed(rod.to));
            ++lines.strokes.back();
            end = i;
            graph_.box.add(rod.from);
            graph_.box.add(rod.to);
            ++graph_.strokes;
        }
    }
    void look(const Camera& camera) {
        const auto from = [&](const char* name, const Camera& stand) {
            const Projection projection(stand, graph_.box);
            const Vector &right = projection.right(), &up = projection.up();
            const Vector& toward = projection.toward();
            SceneGraph::Viewpoint view;
            view.name = name;
            view.opening = (stand.perspective ? stand.opening : 40) * std::numbers::pi / 180;
            const double reach = std::max(graph_.box.diagonal() / 2, 1e-6);
            view.distance = reach / std::sin(view.opening / 2);
            const Vector middle = 0.5 * (graph_.box.low + graph_.box.high);
            view.place = placed(middle + view.distance * toward);
            view.turn = turn_to(placed(right), placed(up), placed(toward));
            if (graph_.viewpoints.empty())  // the light comes over its left shoulder
                graph_.light = -1.0 * unit(placed(toward + 0.6 * up - 0.6 * right));
            graph_.viewpoints.push_back(std::move(view));
        };
        if (upright_) {
            from("Figure", camera);
            from("Front", {-90, 0, false, 40});
            from("Side", {0, 0, false, 40});
            from("From above", {-90, 90, false, 40});
        } else {
            from("Figure", {-90, 90, false, 40});
            from("From the left", {-135, 45, false, 40});
            from("From the right", {-45, 45, false, 40});
        }
    }

    const Scene& scene_;
    const MeshOptions& options_;
    const Budget& budget_;
    bool upright_;
    SceneGraph graph_;
};

}  // namespace

bool is_in_space(const SpaceBox& box) { return box.low.z != 0 || box.high.z != 0; }

AxisTurn turn_to(const Vector& x, const Vector& y, const Vector& z) {
    // The matrix has these columns. By the largest part of its quaternion (w, a, b, c): Shepperd,
    // Quaternion from rotation matrix, 1978.
    const double trace = x.x + y.y + z.z;
    const std::array<double, 4> squares{1 + trace, 1 + 2 * x.x - trace, 1 + 2 * y.y - trace,
                                        1 + 2 * z.z - trace};
    const auto largest = std::max_element(squares.begin(), squares.end()) - squares.begin();
    std::array<double, 4> q;
    switch (largest) {
        case 0:
            q = {squares[0], y.z - z.y, z.x - x.z, x.y - y.x};
            break;
        case 1:
            q = {y.z - z.y, squares[1], x.y + y.x, z.x + x.z};
            break;
        case 2:
            q = {z.x - x.z, x.y + y.x, squares[2], y.z + z.y};
            break;
        default:
            q = {x.y - y.x, z.x + x.z, y.z + z.y, squares[3]};
            break;
    }
    Vector axis{q[1], q[2], q[3]};
    const double sine = length(axis);
    if (!(sine > 0)) return {};
    const double sign = q[0] < 0 ? -1 : 1;
    return {(sign / sine) * axis, 2 * std::atan2(sine, sign * q[0])};
}

SceneGraph scene_graph(const Scene& scene, const MeshOptions& options, const Camera& camera,
                       const std::optional<Light>& light, const Budget& budget) {
    return SceneBuilder(scene, options, budget).built(camera, light);
}

}  // namespace algae
