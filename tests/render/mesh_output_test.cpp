#include "render/render.hpp"

#include <assimp/scene.h>
#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <assimp/Importer.hpp>
#include <cstring>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>

#include "command/run.hpp"
#include "exact/exact.hpp"
#include "render/detail/scene_graph.hpp"
#include "turtle/any_scene.hpp"

using namespace algae;

namespace {

std::string written(const Scene& scene, MeshFormat format, const MeshChoices& choices = {}) {
    std::ostringstream stream;
    draw_mesh(scene, stream, format, choices, Budget());
    return stream.str();
}

std::size_t count(const std::string& text, const std::string& part) {
    std::size_t found = 0;
    for (std::size_t at = text.find(part); at != text.npos; at = text.find(part, at + 1)) ++found;
    return found;
}

/// A bent trunk with a branch, a straight rod apart, a line, one solid of each kind and a leaf.
Scene garden() {
    Scene scene = chain({{0, 0, 0}, {0, 0, 2}, {0.5, 0, 4}}, 0.3);
    scene.name = "a \"garden\" <&>";
    scene.colours = {"brown", "#00ff00"};
    Rod branch;
    branch.from = {0, 0, 2};
    branch.to = {-1, 0.5, 3};
    branch.radius = 0.1;
    branch.before = 0;
    branch.branch = true;
    branch.paint.index = 1;
    scene.rods.push_back(branch);
    Rod line;
    line.from = {0.5, 0, 4};
    line.to = {0.5, 0, 5};
    line.before = 1;
    scene.rods.push_back(line);
    line.from = line.to;
    line.to = {1, 0, 5};
    line.before = 3;
    scene.rods.push_back(line);
    double x = 3;
    for (const SolidShape shape :
         {SolidShape::box, SolidShape::cylinder, SolidShape::cone, SolidShape::sphere}) {
        Attitude attitude;
        attitude.pitch(turn_by(-20 * x));
        scene.solids.push_back({shape, {x, 0, 0}, attitude, {1, 0.5, 0.25}, {1, {}}});
        x += 2;
    }
    scene.add_face(std::vector<Vector>{{0, 3, 0}, {1, 3, 1}, {2, 3, 0}, {1, 3, 3}},
                   {0, Colour{0, 0.5, 1}});
    return scene;
}

/// What assimp reads back: triangles, vertices and the box around them.
struct ReadBack {
    std::size_t triangles = 0, vertices = 0;
    SpaceBox box;
    double colours = 0;

    ReadBack(const std::string& bytes, const char* format) {
        Assimp::Importer importer;
        const aiScene* scene = importer.ReadFileFromMemory(bytes.data(), bytes.size(), 0, format);
        REQUIRE(scene != nullptr);
        for (unsigned m = 0; m < scene->mNumMeshes; ++m) {
            const aiMesh& mesh = *scene->mMeshes[m];
            triangles += mesh.mNumFaces;
            vertices += mesh.mNumVertices;
            for (unsigned i = 0; i < mesh.mNumVertices; ++i)
                box.add(Vector{mesh.mVertices[i].x, mesh.mVertices[i].y, mesh.mVertices[i].z});
            for (unsigned f = 0; f < mesh.mNumFaces; ++f) CHECK(mesh.mFaces[f].mNumIndices == 3);
            if (mesh.HasVertexColors(0))
                for (unsigned i = 0; i < mesh.mNumVertices; ++i) colours += mesh.mColors[0][i].g;
        }
    }
};

bool near(const Vector& a, const Vector& b) { return length(a - b) < 1e-5; }

nlohmann::json json_of_glb(const std::string& bytes) {
    std::uint32_t size = 0;
    std::memcpy(&size, bytes.data() + 12, 4);
    return nlohmann::json::parse(bytes.substr(20, size));
}

}  // namespace

TEST_CASE("a glb read back has the triangles and the box, y up") {
    const Scene scene = garden();
    std::ostringstream stream;
    const MeshDrawn drawn = draw_mesh(scene, stream, MeshFormat::glb, {}, Budget());
    const ReadBack back(stream.str(), "glb");
    CHECK(back.triangles == drawn.triangles);
    CHECK(back.vertices <= drawn.vertices);  // equal corners become one
    CHECK(back.vertices + 10 > drawn.vertices);
    CHECK(near(back.box.low, {drawn.box.low.x, drawn.box.low.z, -drawn.box.high.y}));
    CHECK(near(back.box.high, {drawn.box.high.x, drawn.box.high.z, -drawn.box.low.y}));
    const auto json = json_of_glb(stream.str());
    CHECK(json["asset"]["generator"] == "algae");
    CHECK(!json.contains("extensionsUsed"));
    REQUIRE(json["materials"].size() == 3);
    CHECK(json["materials"][1]["name"] == "colour-00ff00");
    CHECK(json["materials"][2]["doubleSided"] == true);
    CHECK(double(json["materials"][2]["pbrMetallicRoughness"]["baseColorFactor"][1]) ==
          doctest::Approx(0.214).epsilon(0.001));  // 0.5 as an amount of light
}

TEST_CASE("many colours are colours of the vertices of a glb") {
    Scene scene;
    scene.name = "a rainbow";
    for (int i = 0; i < 300; ++i) {
        Rod rod;
        rod.from = {double(i), 0, 0};
        rod.to = {double(i), 0, 1};
        rod.radius = 0.2;
        rod.paint.colour = Colour{i / 300.0, 1, 0};
        scene.rods.push_back(rod);
    }
    const std::string bytes = written(scene, MeshFormat::glb);
    CHECK(json_of_glb(bytes)["materials"].size() == 1);
    const ReadBack back(bytes, "glb");
    CHECK(back.colours == doctest::Approx(static_cast<double>(back.vertices)));
}

TEST_CASE("ply and stl read back agree, z up") {
    const Scene scene = garden();
    for (const MeshFormat format : {MeshFormat::ply, MeshFormat::stl}) {
        std::ostringstream stream;
        const MeshDrawn drawn = draw_mesh(scene, stream, format, {}, Budget());
        const ReadBack back(stream.str(), mesh_format_name(format));
        CHECK(back.triangles == drawn.triangles);
        CHECK(near(back.box.low, drawn.box.low));
        CHECK(near(back.box.high, drawn.box.high));
        CHECK(stream.str().find("ssimp") == std::string::npos);
    }
    CHECK(written(scene, MeshFormat::stl).size() ==
          84 + 50 * ReadBack(written(scene, MeshFormat::ply), "ply").triangles);
}

TEST_CASE("an obj names the file of materials beside it") {
    const Scratch scratch;
    const MeshDrawn drawn =
        draw_mesh(garden(), scratch.file("my tree.obj"), MeshFormat::obj, {}, Budget());
    CHECK(scratch.size() == 2);
    const std::string obj = text_of(scratch.file("my tree.obj")),
                      mtl = text_of(scratch.file("my tree.mtl"));
    CHECK(obj.find("mtllib my tree.mtl\n") != std::string::npos);
    CHECK(count(obj, "\nf ") == drawn.triangles);
    CHECK(count(mtl, "newmtl ") == 3);
    CHECK(mtl.find("Kd 0 1 0") != std::string::npos);
    CHECK((obj + mtl).find("ssimp") == std::string::npos);
    CHECK_THROWS_AS(draw_mesh(garden(), scratch.file("x.mtl"), MeshFormat::obj, {}, Budget()),
                    Error);
    CHECK(written(garden(), MeshFormat::obj).find("mtllib") == std::string::npos);
}

TEST_CASE("files appear whole or not at all, and the same each time") {
    const Scratch scratch;
    Budget small;
    small.memory = 1 << 16;
    for (const MeshFormat format :
         {MeshFormat::glb, MeshFormat::obj, MeshFormat::ply, MeshFormat::stl, MeshFormat::x3d,
          MeshFormat::wrl, MeshFormat::vrml1, MeshFormat::pov}) {
        std::vector<Vector> way;
        for (int i = 0; i < 9999; ++i) way.push_back({double(i), double(i % 2), 0});
        CHECK_THROWS_AS(draw_mesh(chain(way, 0.1), scratch.file("figure"), format, {}, small),
                        BoundReached);
        MeshChoices choices;
        choices.colours = {"no such colour"};
        CHECK_THROWS_AS(draw_mesh(garden(), scratch.file("figure"), format, choices, Budget()),
                        Error);
        CHECK_THROWS_AS(draw_mesh(Scene{}, scratch.file("figure"), format, {}, Budget()), Error);
        CHECK(scratch.size() == 0);
        CHECK(written(garden(), format) == written(garden(), format));
    }
}

TEST_CASE("scene graphs hold solids, straight rods and lines as such") {
    const Scene scene = garden();
    std::ostringstream stream;
    const MeshDrawn drawn = draw_mesh(scene, stream, MeshFormat::x3d, {}, Budget());
    CHECK(drawn.solids == 5);  // four, and the branch
    CHECK(drawn.lines == 2);
    const std::string x3d = stream.str(), wrl = written(scene, MeshFormat::wrl),
                      vrml1 = written(scene, MeshFormat::vrml1);
    CHECK(wrl.rfind("#VRML V2.0 utf8\n", 0) == 0);
    CHECK(vrml1.rfind("#VRML V1.0 ascii\n", 0) == 0);
    CHECK(x3d.find("title=\"a &quot;garden&quot; &lt;&amp;&gt;\"") != std::string::npos);
    CHECK(wrl.find("title \"a \\\"garden\\\" <&>\"") != std::string::npos);
    for (const std::string& text : {x3d, wrl, vrml1}) {
        CHECK(count(text, text == vrml1 ? "Cube {" : text == wrl ? "Box {" : "<Box ") == 1);
        CHECK(count(text, text == x3d ? "<Cylinder " : "Cylinder {") == 2);
        CHECK(count(text, text == x3d ? "<Cone " : "Cone {") == 1);
        CHECK(count(text, text == x3d ? "<Sphere " : "Sphere {") == 1);
        CHECK(count(text, text == x3d ? "<IndexedFaceSet " : "IndexedFaceSet {") ==
              2);  // trunk and leaf
        CHECK(count(text, text == x3d ? "<IndexedLineSet " : "IndexedLineSet {") == 1);
        CHECK(count(text, text == x3d ? "<DirectionalLight " : "DirectionalLight {") == 1);
        CHECK(text.find("nan") == std::string::npos);
        CHECK(text.find("inf") == std::string::npos);
    }
    CHECK(wrl.find("coordIndex [ 0,1,2,-1, ] }") !=
          std::string::npos);  // one stroke along two lines
}

TEST_CASE("figures of the plane keep x and y, others stand with y up") {
    const auto box_corner = [](const Vector& to) {
        const ReadBack back(written(chain({{0, 0, 0}, to}, 0.001), MeshFormat::glb), "glb");
        return back.box.high;
    };
    CHECK(length(box_corner({0, 4, 0}) - Vector{0, 4, 0}) < 0.01);
    CHECK(length(box_corner({0, 0, 4}) - Vector{0, 4, 0}) < 0.01);
    CHECK(length(box_corner({0, -4, 3}) - Vector{0, 3, 4}) < 0.01);
}

TEST_CASE("a turn about an axis takes the axes where they shall be") {
    CHECK(rc::check("random frames", [] {
        const Vector x = any_direction();
        Vector other = any_direction();
        if (!(length(cross(x, other)) > 1e-3)) return;
        const Vector z = (1 / length(cross(x, other))) * cross(x, other), y = cross(z, x);
        const AxisTurn turn = turn_to(x, y, z);
        RC_ASSERT(std::fabs(length(turn.axis) - 1) < 1e-9);
        const auto turned = [&](const Vector& v) {  // Rodrigues
            return std::cos(turn.radians) * v + std::sin(turn.radians) * cross(turn.axis, v) +
                   ((1 - std::cos(turn.radians)) * dot(turn.axis, v)) * turn.axis;
        };
        RC_ASSERT(length(turned({1, 0, 0}) - x) < 1e-9);
        RC_ASSERT(length(turned({0, 1, 0}) - y) < 1e-9);
        RC_ASSERT(length(turned({0, 0, 1}) - z) < 1e-9);
    }));
    CHECK(turn_to({1, 0, 0}, {0, 1, 0}, {0, 0, 1}).radians == 0);
}
