#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include "command/run.hpp"

namespace {

const std::string tree =
    "axiom !(0.4)F(2)A; A -> [&(40)!(0.2)F(1)][/(120)&(40)!(0.2)F(1)]F(1)^(10)F(1)\ngeneration 1\n";

}  // namespace

TEST_CASE("draw writes figures in space for other programs") {
    const Scratch scratch;
    const std::string file = scratch.file("tree.lsys", tree);
    for (const std::string end : {"glb", "obj", "ply", "stl", "x3d", "wrl", "pov", "vrml"}) {
        const std::string format = end == "vrml" ? " --format vrml1" : "";
        const Run drawn =
            run("draw '" + file + "' --json -o '" + scratch.file("tree." + end) + "'" + format);
        INFO(drawn.err);
        REQUIRE(drawn.status == 0);
        const auto json = nlohmann::json::parse(drawn.out);
        CHECK(json["generation"] == 1);
        CHECK(json["segments"] == 5);
        CHECK(json["triangles"] > 0);
        CHECK(json["vertices"] > 0);
        CHECK(json["bounding_box"]["max"].size() == 3);
        CHECK(json["format"] == (end == "vrml" ? "vrml1" : end));
        CHECK(!text_of(scratch.file("tree." + end)).empty());
    }
    CHECK(scratch.size() == 10);  // the system, eight files and the materials
}

TEST_CASE("figures of the plane become tubes or lines") {
    const Scratch scratch;
    const Run tubes = run("draw koch -n 2 --facets 5 --json -o '" + scratch.file("koch.glb") + "'");
    REQUIRE(tubes.status == 0);
    CHECK(nlohmann::json::parse(tubes.out)["triangles"] == 16 * 10 + 6);
    const Run lines = run("draw koch -n 2 --json -o - --format x3d");
    REQUIRE(lines.status == 0);
    CHECK(lines.out.rfind("<?xml", 0) == 0);
    CHECK(lines.out.find("\"lines\": 16") != std::string::npos);
}

TEST_CASE("what is wrong with a mesh is said before a file appears") {
    const Scratch scratch;
    const std::string file = scratch.file("tree.lsys", tree);
    const auto refused = [&](const std::string& options, int status, const std::string& message) {
        const Run drawn = run("draw '" + file + "' " + options);
        CHECK(drawn.status == status);
        CHECK(drawn.err.find(message) != std::string::npos);
        INFO(drawn.err);
        CHECK(scratch.size() == 1);
    };
    const std::string to_glb = "-o '" + scratch.file("a.glb") + "' ";
    refused("-o '" + scratch.file("a.dae") + "'", 2,
            "expected a picture file ending in .svg, .pdf, .png, .ps or .eps");
    refused("-o '" + scratch.file("a.dae") + "'", 2,
            "a figure in space in .glb, .obj, .ply, .stl, .x3d, .wrl or .pov");
    refused("-o -", 2, "glb, obj, ply, stl, x3d, wrl, vrml1 or pov");
    refused(to_glb + "--facets 2", 2, "--facets 2: expected 3 to 256 sides of a tube");
    refused(to_glb + "--panels", 2, "--panels: glb is not a picture");
    refused(to_glb + "-n 0..2", 2, "-n 0..2: glb holds one generation");
    refused(to_glb + "--max-memory 1K", 3, "--max-memory");
    refused("--facets 9 -o '" + scratch.file("a.svg") + "'", 2, "--facets is for");
}

TEST_CASE("POV-Ray renders a pov, with the figure in it") {
    if (std::system("povray --version >/dev/null 2>&1") != 0) {
        MESSAGE("NOT TESTED: scenes by POV-Ray, as it is not installed (apt-get install povray)");
        return;
    }
    const Scratch scratch;
    // Rods, a solid, a polygon and lines without thickness.
    const std::string file = scratch.file(
        "all.lsys",
        "axiom !(0.4)F(2)[+(40)!(0.2)F(1)]K(1)L{F+F+F}; solid K sphere radius; surface L leaf; "
        "colour green red; generation 0");
    const std::string pov = scratch.file("all.pov");
    REQUIRE(run("draw '" + file + "' -o '" + pov + "'").status == 0);
    REQUIRE(run("draw hilbert-3d -n 1 -o '" + scratch.file("lines.pov") + "'").status == 0);
    constexpr std::size_t bytes = 80 * 60 * 3;
    const auto render = [&](const std::string& name, const std::string& options) {
        const std::string ppm = scratch.file(name + ".ppm");
        const int status = std::system(("povray +W80 +H60 -D +FP +WT1 Declare=Soft=0 " + options +
                                        " +I'" + scratch.file(name + ".pov") + "' +O'" + ppm +
                                        "' >'" + scratch.file("said") + "' 2>&1")
                                           .c_str());
        INFO(text_of(scratch.file("said")));
        CHECK(status == 0);
        const std::string image = text_of(ppm);  // its head says the time
        REQUIRE(image.size() > bytes);
        return image.substr(image.size() - bytes);
    };
    for (const std::string name : {"all", "lines"}) {
        const std::string image = render(name, "Declare=Ground=0");

        std::size_t painted = 0;
        for (std::size_t i = 0; i < bytes; i += 3) painted += image.substr(i, 3) != "\xff\xff\xff";
        CHECK(painted > 150);        // the figure
        CHECK(painted < bytes / 6);  // and what is behind it
        CHECK(render(name, "Declare=Ground=0") == image);
        CHECK(render(name, "") != image);  // the ground
    }
}
