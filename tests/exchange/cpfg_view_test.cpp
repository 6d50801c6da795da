// View and animation files of cpfg.

#include <doctest/doctest.h>

#include "exchange/compared.hpp"
#include "exchange/detail/formats.hpp"
#include "exchange/exchange.hpp"
#include "model/model.hpp"
#include "notation/notation.hpp"

using namespace algae;
using namespace algae::exchange_tests;

namespace {

Model plant(const std::string& axiom) {
    return read_cpfg(
        "Lsystem: 1\nderivation length: 1\nAxiom: " + axiom + "\nA --> A\nendlsystem\n", "plant.l");
}
std::string view_fault(const std::string& axiom, const std::string& text) {
    return refusal([&] { with_cpfg_view(plant(axiom), text, "plant.v"); });
}
bool holds(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("a view file of cpfg says the angle, the width of lines and where the viewer stands") {
    const Model shown = with_cpfg_view(plant("F+F"),
                                       "/* a view */\n#define A 22.5\nangle increment: 10\nangle "
                                       "increment: A*2 // the last holds\ninitial line width: 3 "
                                       "pixels\ninitial color: 2\nsurface: l leaf.s 1\n",
                                       "plant.v");
    CHECK(shown.drawing.angle->value == 45);
    CHECK(shown.drawing.width->value == 3);
    CHECK(with_cpfg_view(plant("F"), "angle factor: 7\n", "v").drawing.angle->exact ==
          Rational(360, 7));
    // In the page nothing turns the figure; in space the page is seen from z.
    CHECK(!with_cpfg_view(plant("F"), "viewpoint: 0 0 1\n", "v").drawing.camera);
    CHECK(plant("F&F").drawing.camera->from.elevation.value == 90);
    const Model tipped =
        with_cpfg_view(plant("F&F"), "viewpoint: 0 -1 1\nprojection: perspective\n", "plant.v");
    CHECK(tipped.drawing.camera->from.azimuth.value == -90);
    CHECK(tipped.drawing.camera->from.elevation.value == 45);
    CHECK(tipped.drawing.camera->perspective);
    // A system that asks what is level stands upright along z, and any viewpoint can be said.
    const Model upright = with_cpfg_view(plant("F&(30)@vF"), "viewpoint: 1 0 1\n", "plant.v");
    CHECK(upright.drawing.camera->from.azimuth.value == -45);
    CHECK(upright.drawing.camera->from.elevation.value == 0);
    const Scene scene = scene_of(upright, 0).scene;
    REQUIRE(scene.rods.size() == 2);
    CHECK(near(scene.rods[0].to, Vector{0, 0, 1}));
}

TEST_CASE("a tropism of cpfg bends before steps and moves") {
    const auto end_of = [](const std::string& axiom, const std::string& view) {
        return scene_of(with_cpfg_view(plant(axiom), view, "plant.v"), 0).end.position;
    };
    // Where the program itself ends, as far as it prints it.
    const Vector there{-0.744339, 0.667802, 0};
    CHECK(length(end_of("+(40)F", "tropism: T: 0 -1 0 E: 0.22\n") - there) < 2e-6);
    CHECK(length(end_of("+(40)F", "tropism: T: 0 -2 0 A: 0 I: 1 E: 0.22 S: 0.1\n") - there) < 2e-6);
    const Model written =
        with_cpfg_view(plant("&(30)F[@vf]"), "tropism: T: 1 2 -3 E: 0.3\n", "plant.v");
    CHECK(read_lsystem(print_lsystem(written), "").drawing == written.drawing);
    // A turtle that stands along z sees the page's y as z, and its z as -y.
    const Vector page = end_of("&(30)F(3)+(20)f", "tropism: T: 1 2 -3 E: 0.3\n"),
                 upright = end_of("&(30)F(3)+(20)f[@vf]", "tropism: T: 1 2 -3 E: 0.3\n");
    CHECK(near(upright, Vector{page.x, -page.z, page.y}));
}

TEST_CASE("symbols of cpfg change the elasticity of a tropism to the end of a branch") {
    const auto end_of = [](const std::string& axiom, const std::string& view) {
        return scene_of(with_cpfg_view(plant(axiom), view, "plant.v"), 0).end.position;
    };
    const Vector there{-0.744339, 0.667802, 0};
    const std::string pull = "tropism: T: 0 -2 0 E: ";
    for (const char* axiom :
         {"@Ts(1,0.22)+(40)F", "@Ti(1,0.12)+(40)F", "@Ti@Td[@Ts(1,9)]@Ti(1,0.12)+(40)F",
          "@Ts(1,0.3)@Td(1,0.08)+(40)F", "@Ts(1)@Tf@Tx(3)@Ti(1,0.22)+(40)F"})
        CHECK(length(end_of(axiom, pull + "0.1\n") - there) < 2e-6);
    // Symbols know tropisms and torques by their order in the file; what never bends does not matter.
    CHECK(length(end_of("@Ti(2,0.22)+(40)F",
                        "torque: T: 1 0 0\n" + pull + "0\ntropism: T: 1 0 0 A: 90\n") -
                 there) < 2e-6);
    CHECK(near(end_of("@Ti(3,9)+(90)F", pull + "0\n"), Vector{-1, 0, 0}));
    CHECK(near(scene_of(plant("@Ts(1,3)+(90)F"), 0).end.position, Vector{-1, 0, 0}));
    // An intensity leaves a short direction as it is.
    CHECK(length(end_of("+(40)F", "tropism: T: 0 -0.5 0 I: 1 E: 0.44\n") - there) < 2e-6);
    const Model written = with_cpfg_view(plant("@Ti(1,0.12)F"), pull + "0.1\n", "plant.v");
    CHECK(read_lsystem(print_lsystem(written), "").drawing == written.drawing);
    const auto refused = [](const std::string& axiom) { return refusal([&] { plant(axiom); }); };
    CHECK(holds(refused("F@Ti(1)"), "@Ti without an amount goes by the step S: of the view file"));
    CHECK(holds(refused("F@Ti(1+1,0.1)"), "@Ti of a tropism that a number tells, 1+1"));
    CHECK(holds(refused("F@Tp"), "the command @Tp has no meaning"));
    CHECK(holds(view_fault("@Ts(2,1)F", pull + "1\n" + pull + "0\n"), "a second tropism"));
    CHECK(holds(view_fault("@Ts(1,1)F", "torque: T: 1 0 0\n"), "a torque has no meaning"));
}

TEST_CASE("what a view file of cpfg says otherwise than the notation is refused with its place") {
    const std::tuple<const char*, const char*, const char*> all[] = {
        {"F", "angle increment 22\n", "plant.v:1:1: error: expected `keyword: values`"},
        {"F", "angle increment: x y\n", ""},
        {"F", "angle factor: 0\n", "plant.v:1:15: error: expected a number other than 0"},
        {"F", "scale factor: 2\nangle incremnt: 30\n",
         "plant.v:2:1: error: expected a keyword of the program, found 'angle incremnt'; did you "
         "mean 'angle increment'?"},
        {"F!F", "line width increment: 0.5\n", "plant.v:1:23: error: widths that grow"},
        {"F", "line width increment: 0.5\n", ""},
        {"F%F", "interpretation past %: on\n", "plant.v:1:24: error: what stands past %"},
        {"F", "tropism: T: 0 -1 0 E: 0.22\ntropism: T: 0 1 0 E: 1\n",
         "plant.v:2:10: error: a second tropism"},
        {"F", "tropism: T: 0 -1 0\ntropism: T: 0 -1 0 I: 1 E: 0.22 S: 0.1\n", ""},
        {"F", "tropism: T: 0 -1 0 A: 20 E: 1\n", "plant.v:1:23: error: a tropism towards an angle"},
        {"F", "tropism: T: 0 -1 0 I: 2 E: 1\n", "plant.v:1:23: error: an intensity"},
        {"F", "tropism: T: 0 -1 E: 1\n",
         "plant.v:1:10: error: expected three numbers behind T:, found 2"},
        {"F", "tropism: T: 0 0 0 E: 1\n",
         "plant.v:1:13: error: expected a direction other than 0 0 0"},
        {"F", "tropism: E: 1\n", "plant.v:1:10: error: expected T: x y z, the direction"},
        {"F", "tropism: 0 -1 0\n", "plant.v:1:10: error: expected T:, A:, I:, E: or S:, found '0'"},
        {"F", "torque: T: 0 -1 0 E: 0\n", ""},
        {"F", "torque: T: 0 -1 0 E: 0.1\n", "plant.v:1:22: error: a torque has no meaning"},
        {"F", "initial elasticity: 1.0\n", "plant.v:1:21: error: the older tropism"},
        {"F&F", "viewpoint: 1 2\n", "plant.v:1:12: error: expected a viewpoint of three numbers"},
        {"F", "initial line width: 0\n", "plant.v:1:21: error: expected a width above 0"},
    };
    for (const auto& [axiom, text, expected] : all) {
        INFO(text);
        const std::string said = view_fault(axiom, text);
        if (*expected == '\0')
            CHECK(said == "");
        else
            CHECK_MESSAGE(holds(said, expected), said.c_str());
    }
}

TEST_CASE("an animation file of cpfg says generations") {
    const auto frames = [](const std::string& text) { return cpfg_frames(text, "plant.a"); };
    CHECK(frames("first frame: 2\nlast frame: 12\nstep: 1\n") ==
          std::pair<std::uint64_t, std::uint64_t>(2, 12));
    CHECK(frames("last frame: 5\nclear between frames: on\n").first == 0);
    CHECK(frames("frame intervals: 1, 3-5, 2\n") == std::pair<std::uint64_t, std::uint64_t>(1, 5));
    const auto fault = [&](const std::string& text) { return refusal([&] { frames(text); }); };
    CHECK(holds(fault("frame intervals: 1, 3-5, 10-16 step 2\n"),
                "plant.a:1:18: error: frames that are no range"));
    CHECK(holds(fault("last frame: 8\nstep: 2\n"), "plant.a:2:7: error: frames that are no range"));
    CHECK(
        holds(fault("first frame: 8\nlast frame: 2\n"), "expected a last frame behind the first"));
    CHECK(holds(fault("first frame: 8\n"), "expected a line 'last frame: N'"));
    CHECK(holds(fault("last frame: -1\n"), "expected a frame, a whole number from 0 on"));
}

TEST_CASE("the command line in specifications says which files belong together") {
    const CpfgFiles files =
        cpfg_files("name plant\ncpfg -m plant.map plant.l other.v plant.a\n", "specifications");
    CHECK(files.system == "plant.l");
    CHECK(files.view == "other.v");
    CHECK(files.animation == "plant.a");
    CHECK(holds(refusal([] { cpfg_files("nothing\n", "specifications"); }),
                "specifications: expected a command line"));
}
