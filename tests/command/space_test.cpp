#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include "command/run.hpp"

namespace {

const std::string tree =
    "axiom A(1,0.1)\nA(l,w) -> !(w)F(l)[&(45)A(l*0.7,w*0.7)]/(137.5)A(l*0.9,w*0.7)\n";

}  // namespace

TEST_CASE("draw shows figures in space, with three coordinates in its facts") {
    const Scratch scratch;
    const std::string file = scratch.file("up.lsys", "axiom F^F\n");
    const Run drawn = run("draw " + file + " -n 0 --json -o " + scratch.file("up.svg"));
    REQUIRE(drawn.status == 0);
    const auto facts = nlohmann::json::parse(drawn.out);
    CHECK(facts["segments"] == 2);
    CHECK(facts["bounding_box"]["min"] == nlohmann::json({0, 0, 0}));
    CHECK(facts["bounding_box"]["max"] == nlohmann::json({1, 0, 1}));
    CHECK(facts["end"] == nlohmann::json({1, 0, 1}));
    CHECK(text_of(scratch.file("up.svg")).find("<svg") != std::string::npos);
}

TEST_CASE("cameras, light and fog on the command line") {
    const Scratch scratch;
    const std::string file = scratch.file("tree.lsys", tree), png = scratch.file("tree.png");
    const auto draw = [&](const std::string& options) {
        return run("draw " + file + " -n 4 -o " + png + " --width 200 " + options);
    };
    REQUIRE(draw("").status == 0);
    const std::string usual = text_of(png);
    for (const char* options :
         {"--camera 30,20", "--camera=-60,15,perspective", "--camera -60,15,perspective:70",
          "--light 0,0", "--fog 0.7", "--background black", "--colour green"}) {
        CAPTURE(options);
        CHECK(draw(options).status == 0);
        CHECK(text_of(png) != usual);
    }
    REQUIRE(draw("--camera -60,15").status == 0);
    CHECK(text_of(png) == usual);
    const auto refused = [&](const std::string& options, const std::string& message) {
        const Scratch other;
        const Run wrong = run("draw " + file + " -n 4 -o " + other.file("x.png") + ' ' + options);
        CHECK(wrong.status == 2);
        CHECK_MESSAGE(wrong.err.find(message) != std::string::npos, wrong.err);
        CHECK(other.size() == 0);
    };
    refused("--camera 30",
            "--camera: expected AZIMUTH,ELEVATION or AZIMUTH,ELEVATION,perspective[:DEGREES], "
            "found \"30\"");
    refused("--camera 30,20,fisheye", "found \"30,20,fisheye\"");
    refused("--camera 30,20,perspective:", "found \"30,20,perspective:\"");
    refused("--camera 30,95", "--camera: the camera's elevation is 95 degrees, expected -90 to 90");
    refused("--camera 30,20,perspective:180",
            "--camera: the camera's opening is 180 degrees, expected 1 to 170");
    refused("--light 30", "--light: expected AZIMUTH,ELEVATION, found \"30\"");
    refused("--light 30,91", "--light: expected an elevation from -90 to 90 degrees, found \"91\"");
    refused("--fog 2", "--fog: expected a number from 0 to 1, found \"2\"");
    refused("--scale-bar --camera 30,20,perspective",
            "a scale bar: lengths differ from near to far in perspective");
    const Run small =
        run("draw " + file + " -n 4 -o " + scratch.file("small.png") + " --max-memory 20000");
    CHECK(small.status == 3);
    CHECK(small.err.find("would take more than") != std::string::npos);
}

TEST_CASE("options of figures in space are refused in the plane") {
    const Scratch scratch;
    const Run wrong = run("draw koch -n 2 --fog 0.5 -o " + scratch.file("k.svg"));
    CHECK(wrong.status == 2);
    CHECK(wrong.err.find("--fog is for figures in space, and those of koch stay in the plane") !=
          std::string::npos);
    CHECK(scratch.size() == 0);
}

TEST_CASE("panels, pages and captions of figures in space") {
    const Scratch scratch;
    const std::string file = scratch.file("tree.lsys", tree);
    CHECK(run("draw " + file + " -n 2..4 --panels --common-scale --captions --scale-bar -o " +
              scratch.file("panels.png"))
              .status == 0);
    CHECK(run("draw " + file + " -n 2..4 --captions -o " + scratch.file("pages.pdf")).status == 0);
}

TEST_CASE("a scale bar and labels") {
    const Scratch scratch;
    const std::string svg = scratch.file("koch.svg");
    REQUIRE(run("draw koch -n 2 -o " + svg).status == 0);
    const std::string plain = text_of(svg);
    REQUIRE(run("draw koch -n 2 --scale-bar -o " + svg).status == 0);
    CHECK(text_of(svg) != plain);
    REQUIRE(run("draw koch -n 2 --label begin@0,0 --label end@9,0 -o " + svg).status == 0);
    CHECK(text_of(svg) != plain);
    const auto refused = [&](const std::string& label, const std::string& message) {
        const Run wrong = run("draw koch -n 2 --label " + label + " -o " + scratch.file("x.svg"));
        CHECK(wrong.status == 2);
        CHECK_MESSAGE(wrong.err.find(message) != std::string::npos, wrong.err);
    };
    refused("begin", "--label: expected TEXT@x,y or TEXT@x,y,z, found \"begin\"");
    refused("@1,2", "--label: expected TEXT@x,y");
    refused("A@1", "--label: expected TEXT@x,y");
    refused("A@1,y", "--label: expected TEXT@x,y");
    refused(
        "A@0,0,1",
        "the label \"A\" at 0,0,1 lies nowhere in generation 2 of koch, which stays in the plane");
}
