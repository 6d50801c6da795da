#include "turtle/detail/mesh.hpp"
#include "turtle/detail/scene.hpp"
#include "turtle/turtle.hpp"

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <map>
#include <numbers>
#include <numeric>

#include "exact/exact.hpp"
#include "turtle/any_scene.hpp"

using namespace algae;

namespace {

constexpr double pi_value = std::numbers::pi;  // algae::pi is a Ball

/// The closed surfaces of a mesh, found by the points their triangles share.
struct Shells {
    std::map<std::uint32_t, std::vector<std::size_t>> triangles;  // by a point of each

    explicit Shells(const Mesh& mesh) : leaders_(mesh.points.size()) {
        std::iota(leaders_.begin(), leaders_.end(), 0u);
        for (std::size_t i = 0; i < mesh.closed; ++i)
            for (const std::uint32_t corner : mesh.triangles[i])
                leaders_[leader(mesh.corners[corner].point)] =
                    leader(mesh.corners[mesh.triangles[i][0]].point);
        for (std::size_t i = 0; i < mesh.closed; ++i)
            triangles[leader(mesh.corners[mesh.triangles[i][0]].point)].push_back(i);
    }

private:
    std::uint32_t leader(std::uint32_t point) {
        while (leaders_[point] != point) point = leaders_[point] = leaders_[leaders_[point]];
        return point;
    }
    std::vector<std::uint32_t> leaders_;
};

/// What is wrong with a mesh; empty if nothing is.
std::string fault(const Mesh& mesh) {
    for (const Mesh::Corner& corner : mesh.corners) {
        if (corner.point >= mesh.points.size() || corner.paint >= mesh.paints.size())
            return "an index";
        if (!(std::fabs(length(corner.normal) - 1) < 1e-9)) return "a normal not of length 1";
    }
    for (const auto& [a, b, c] : mesh.triangles)
        if (!(length(cross(mesh.place(b) - mesh.place(a), mesh.place(c) - mesh.place(a))) > 0))
            return "a triangle without area";
    const Shells shells(mesh);
    for (const auto& [leader, triangles] : shells.triangles) {
        std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
        std::map<std::uint32_t, int> points;
        double six_volumes = 0;
        for (const std::size_t i : triangles) {
            const auto& t = mesh.triangles[i];
            for (std::size_t k = 0; k < 3; ++k) {
                const std::uint32_t from = mesh.corners[t[k]].point,
                                    to = mesh.corners[t[(k + 1) % 3]].point;
                if (++edges[{from, to}] > 1) return "a directed edge twice";
                ++points[from];
            }
            const Vector& origin = mesh.points[leader];
            six_volumes += dot(mesh.place(t[0]) - origin,
                               cross(mesh.place(t[1]) - origin, mesh.place(t[2]) - origin));
        }
        for (const auto& [edge, count] : edges)
            if (!edges.contains({edge.second, edge.first})) return "an open edge";
        if (points.size() + triangles.size() != edges.size() / 2 + 2) return "no sphere";
        if (!(six_volumes > 0)) return "a surface inside out";
    }
    return "";
}

/// How many of the triangles of closed surfaces look away from the normals of their corners.
std::size_t against_normals(const Mesh& mesh) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < mesh.closed; ++i) {
        const auto& [a, b, c] = mesh.triangles[i];
        const Vector n = cross(mesh.place(b) - mesh.place(a), mesh.place(c) - mesh.place(a));
        for (const std::uint32_t corner : {a, b, c})
            count += dot(n, mesh.corners[corner].normal) <= 0;
    }
    return count;
}

MeshOptions facets(unsigned count) { return {count, 40}; }

/// The share of a circle that a regular polygon inscribed in it has.
double share(unsigned sides) { return sides / (2 * pi_value) * std::sin(2 * pi_value / sides); }

Scene solid(SolidShape shape, const Vector& size) {
    Scene scene;
    scene.name = "a solid";
    Attitude attitude;
    attitude.yaw(turn_by(30));
    attitude.pitch(turn_by(-50));
    scene.solids.push_back({shape, {1, 2, 3}, attitude, size, {}});
    return scene;
}

}  // namespace

TEST_CASE("every tube is a closed surface without holes, wound outward") {
    CHECK(rc::check("random rods", [] {
        const Scene scene = any_rods(25);
        const unsigned sides = *rc::gen::inRange(3u, 14u);
        if (!(total_length(scene) > 0.01)) return;
        const Mesh mesh = mesh_of(scene, facets(sides), Budget());
        RC_ASSERT(fault(mesh) == "");
        RC_ASSERT(mesh.closed == mesh.triangles.size());
    }));
}

TEST_CASE("tubes of one radius look outward everywhere") {
    CHECK(rc::check("random chains", [] {
        std::vector<Vector> points{{0, 0, 0}};
        for (int i = *rc::gen::inRange(1, 20); i > 0; --i)
            points.push_back(points.back() + any_number(0.05, 3) * any_direction());
        const Mesh mesh = mesh_of(chain(points, 0.1), facets(8), Budget());
        RC_ASSERT(fault(mesh) == "");
        RC_ASSERT(against_normals(mesh) == 0u);
    }));
}

TEST_CASE("a straight chain has the volume and the area of a prism") {
    for (const unsigned sides : {3u, 8u, 12u, 64u}) {
        const Mesh mesh = mesh_of(chain({{1, 1, 1}, {1, 1, 2}, {1, 1, 4}, {1, 1, 8}}, 0.5),
                                  facets(sides), Budget());
        CHECK(volume(mesh) == doctest::Approx(share(sides) * pi_value * 0.25 * 7));
        const double around = sides * 2 * 0.5 * std::sin(pi_value / sides);
        CHECK(area(mesh) == doctest::Approx(2 * share(sides) * pi_value * 0.25 + around * 7));
        CHECK(mesh.triangles.size() == 2 * sides + 2 * (sides - 2));  // one piece
    }
}

TEST_CASE("a mitre keeps the volume: what the inner side loses the outer gains") {
    const Mesh mesh =
        mesh_of(chain({{0, 0, 0}, {3, 0, 0}, {3, 4, 0}, {3, 4, 5}}, 0.25), facets(8), Budget());
    CHECK(fault(mesh) == "");
    CHECK(volume(mesh) == doctest::Approx(share(8) * pi_value * 0.0625 * 12));
}

TEST_CASE("a rod narrows to the radius of the one that goes on") {
    Scene scene = chain({{0, 0, 0}, {0, 0, 3}, {0, 0, 5}}, 1);
    scene.rods[1].radius = 0.5;
    const Mesh mesh = mesh_of(scene, facets(256), Budget());
    CHECK(fault(mesh) == "");
    CHECK(volume(mesh) ==
          doctest::Approx(share(256) * pi_value * (3 * (1 + 0.5 + 0.25) / 3 + 2 * 0.25)));
}

TEST_CASE("turns about and very sharp ones end in balls instead of endless mitres") {
    for (const Vector& back : {Vector{0, 0, -2}, Vector{0.1, 0, -2}, Vector{2, 0, -1.3}}) {
        const Mesh mesh = mesh_of(chain({{0, 0, 0}, {0, 0, 3}, Vector{0, 0, 3} + back}, 0.5),
                                  facets(12), Budget());
        CHECK(fault(mesh) == "");
        CHECK(Shells(mesh).triangles.size() == 2);
        CHECK(box_of(mesh).high.z == doctest::Approx(3.5));
    }
}

TEST_CASE("branches: flat feet within what goes on, a round end where nothing does") {
    const auto branching = [](bool goes_on, double radius) {
        Scene scene = chain({{0, 0, 0}, {0, 0, 2}}, 0.5);
        const auto add = [&](const Vector& way, bool branch, double r) {
            Rod rod;
            rod.from = {0, 0, 2};
            rod.to = rod.from + way;
            rod.radius = r;
            rod.before = 0;
            rod.branch = branch;
            scene.rods.push_back(rod);
        };
        if (goes_on) add({0, 0, 2}, false, 0.5);
        add({2, 0, 1}, true, radius);
        add({-2, 0, 1}, true, radius);
        return mesh_of(scene, MeshOptions{}, Budget());
    };
    const std::size_t side = 16, flat = 6, round = 16 + 8;
    CHECK(branching(true, 0.4).triangles.size() == 3 * side + 6 * flat);  // the trunk is one piece
    CHECK(branching(false, 0.4).triangles.size() == 3 * side + 5 * flat + round);
    CHECK(branching(true, 0.6).triangles.size() == 3 * side + 4 * flat + 2 * round);
    CHECK(branching(false, 0.6).triangles.size() == 3 * side + 3 * flat + 3 * round);
    for (const bool goes_on : {false, true})
        for (const double radius : {0.4, 0.6}) CHECK(fault(branching(goes_on, radius)) == "");
}

TEST_CASE("lines have 1/500 of the diagonal as radius, dense ones a quarter of their length") {
    const Mesh far = mesh_of(chain({{0, 0, 0}, {3, 0, 0}, {3, 4, 0}}, 0), facets(8), Budget());
    CHECK(box_of(far).high.z == doctest::Approx(0.01));
    std::vector<Vector> steps;
    for (int i = 0; i <= 4000; ++i) steps.push_back({0.001 * i, 0.0005 * (i % 2), 0});
    const Mesh dense = mesh_of(chain(steps, 0), facets(4), Budget());
    CHECK(box_of(dense).high.z < 0.0004);
    CHECK(fault(dense) == "");
}

TEST_CASE("solids have the volumes and boxes that their formulas say") {
    const unsigned sides = 128;
    const auto built = [&](SolidShape shape, const Vector& size) {
        const Mesh mesh = mesh_of(solid(shape, size), facets(sides), Budget());
        CHECK(fault(mesh) == "");
        CHECK(against_normals(mesh) == 0);
        const SpaceBox box = box_of(mesh), told = box_of(solid(shape, size));
        CHECK(length(box.low - told.low) < 0.35);  // that of a cone is a cylinder's
        return volume(mesh);
    };
    CHECK(built(SolidShape::box, {1, 2, 3}) == doctest::Approx(6));
    CHECK(built(SolidShape::cylinder, {3, 0.5, 0}) ==
          doctest::Approx(share(256) * pi_value * 0.25 * 3));
    CHECK(built(SolidShape::cone, {3, 0.5, 0}) == doctest::Approx(share(256) * pi_value * 0.25));
    CHECK(built(SolidShape::sphere, {2, 0, 0}) ==
          doctest::Approx(4.0 / 3 * pi_value * 8).epsilon(0.001));
}

TEST_CASE("solids with measures of 0 are thin, not degenerate") {
    for (const SolidShape shape :
         {SolidShape::box, SolidShape::cylinder, SolidShape::cone, SolidShape::sphere})
        for (const Vector& size :
             {Vector{0, 0, 0}, Vector{2, 0, 0}, Vector{0, 2, 1}, Vector{2, 3, 0}})
            CHECK(fault(mesh_of(solid(shape, size), facets(3), Budget())) == "");
}

TEST_CASE("polygons with common corners share them, smooth below the crease") {
    Scene roof;
    roof.name = "a roof";
    const auto raised = [&](double height) {
        roof.corners.clear();
        roof.faces.clear();
        roof.add_face(std::vector<Vector>{{-1, 0, 0}, {0, 0, height}, {0, 3, height}, {-1, 3, 0}},
                      {});
        roof.add_face(std::vector<Vector>{{0, 0, height}, {1, 0, 0}, {1, 3, 0}, {0, 3, height}},
                      {});
        return mesh_of(roof, MeshOptions{}, Budget());
    };
    const Mesh low = raised(0.2), high = raised(1);
    CHECK(low.closed == 0);
    CHECK(low.triangles.size() == 4);
    CHECK(low.points.size() == 6);
    CHECK(low.corners.size() == 6);
    CHECK(high.corners.size() == 8);
    for (const Mesh::Corner& corner : low.corners) {
        const double x = low.points[corner.point].x;
        if (x == 0) CHECK(std::fabs(corner.normal.x) < 1e-12);
    }
    roof.faces[1].paint.index = 1;
    roof.colours = {"red", "green"};
    CHECK(mesh_of(roof, MeshOptions{}, Budget()).paints.size() == 2);
}

TEST_CASE("what cannot become a mesh is refused") {
    const auto refused = [](const Scene& scene, const MeshOptions& options = {}) {
        try {
            mesh_of(scene, options, Budget());
        } catch (const BoundReached&) {
            return std::string("bound");
        } catch (const Error& error) {
            return std::string(error.what());
        }
        return std::string("a mesh");
    };
    Scene empty;
    empty.name = "nothing";
    CHECK(refused(empty) == "nothing draws nothing");
    CHECK(refused(chain({{0, 0, 0}, {0, 0, 1}}, 1), facets(2)) ==
          "a tube has 3 to 256 facets, found 2");
    CHECK(refused(chain({{0, 0, 0}, {0, 0, 1.0 / 0.0}}, 1)) ==
          "a chain: stroke 1 does not lie at finite coordinates");
    CHECK(refused(chain({{0, 0, 0}, {0, 0, 0}}, 1)) == "a chain draws nothing that has an extent");
    Budget small;
    small.memory = 1 << 20;
    std::vector<Vector> long_way;
    for (int i = 0; i < 100000; ++i) long_way.push_back({double(i), double(i % 2), 0});
    CHECK_THROWS_AS(mesh_of(chain(long_way, 0.1), MeshOptions{}, small), BoundReached);
}
