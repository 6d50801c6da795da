#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "command/run.hpp"
#include "places.hpp"

namespace {

const std::string figures = source_folder() + "/figures/003-fractal-notes/";

std::string refused(const std::string& arguments, int status = 2) {
    const Run wrong = run(arguments);
    CHECK(wrong.status == status);
    CHECK(wrong.out.empty());
    return wrong.err;
}

bool holds(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("the verbs of the other generators print what is known and draw") {
    const Scratch scratch;
    const auto drawn = [&](const std::string& arguments, const std::string& name) {
        const std::string path = scratch.file(name);
        const Run done = run(arguments + " -o '" + path + "'");
        INFO(arguments, ": ", done.err);
        CHECK(done.status == 0);
        CHECK(text_of(path).size() > 100);
        return done.out;
    };
    CHECK(holds(drawn("ifs fern --points 1000 --width 100", "fern.png"), "Barnsley's fern\n"));
    drawn("ifs copy-machine --iterations 0..2", "copies.pdf");
    drawn("ca rule-126", "rule-126.svg");  // a system has this name too
    drawn("ca --rule 30 --cells 21 -n 10", "rule-30.svg");
    drawn("ca glider", "glider.svg");
    CHECK(holds(drawn("walk --steps 500 --seed 3", "walk.svg"), "after 500 steps: "));
    CHECK(holds(drawn("brownian --hurst 0.7 --levels 6", "path.svg"), "2 - H = 1.3"));
    CHECK(holds(drawn("terrain --levels 4 --roughness 0.7", "land.png"), "points: 17 by 17\n"));
    CHECK(
        holds(drawn("dla --particles 200 --off-lattice", "cluster.svg"), "grown: off the lattice"));
    drawn("particles fireworks --show 40", "fireworks.svg");
    drawn("draw weierstrass", "weierstrass.svg");
    drawn("draw boxes-on-koch", "boxes.svg");
    CHECK(run("ca --rule 90 --cells 7 -n 2 --text").out == "0001000\n0010100\n0100010\n");
    CHECK(run("walk --steps 5 --seed 3 --json").out == run("walk --steps 5 --seed 3 --json").out);
    CHECK(run("walk --steps 5 --seed 3 --json").out != run("walk --steps 5 --seed 4 --json").out);
}

TEST_CASE("a file says as much as options, and options come first") {
    const Scratch scratch;
    const std::string file = scratch.file("a.ca", "rule 110\ncells 9\nboundary fixed 0\n");
    CHECK(run("ca '" + file + "' -n 4 --text").out ==
          run("ca --rule 110 --cells 9 --boundary 'fixed 0' -n 4 --text").out);
    CHECK(run("ca - -n 4 --text <'" + file + "'").out == run("ca '" + file + "' -n 4 --text").out);
    CHECK(run("ca '" + file + "' --rule 90 -n 1 --text").out == "000010000\n000101000\n");
}

TEST_CASE("landscapes and paths in space become meshes") {
    const Scratch scratch;
    for (const std::string end : {"glb", "obj", "ply", "stl", "x3d", "wrl"}) {
        const Run land =
            run("terrain --levels 3 --seed 2 --json -o '" + scratch.file("land." + end) + "'");
        INFO(land.err);
        CHECK(land.status == 0);
        CHECK(holds(land.out, "\"triangles\": 128"));  // two for each of 8 by 8 squares
        CHECK(holds(land.out, "\"format\": \"" + end + "\""));
        CHECK(holds(land.out, "\"heights\""));
    }
    CHECK(scratch.size() == 7);  // with the materials of the obj
    const Run path = run("brownian --dimensions 3 --levels 4 -o - --format x3d");
    CHECK(path.status == 0);
    CHECK(holds(path.out, "<?xml"));
    CHECK(run("walk --dimensions 3 --steps 20 --format vrml1 -o '" + scratch.file("walk.wrl") + "'")
              .status == 0);
    CHECK(text_of(scratch.file("walk.wrl")).starts_with("#VRML V1.0"));
    CHECK(holds(refused("brownian -o '" + scratch.file("a.glb") + "'"),
                "brownian lies in the plane, and glb is for figures in space"));
    CHECK(holds(refused("dla --particles 9 -o '" + scratch.file("a.glb") + "'"), "in the plane"));
    CHECK(holds(refused("terrain --width 9 -o '" + scratch.file("a.glb") + "'"),
                "--width: glb is not a picture"));
    CHECK(scratch.size() == 8);
}

TEST_CASE("what is wrong with a parameter is said with its place") {
    CHECK(refused("brownian --hurst 1.2") ==
          "--hurst: error: expected hurst with a number between 0 and 1, found '1.2'\n");
    CHECK(holds(refused("brownian --levels 40"), "a whole number from 0 to 24, found '40'"));
    CHECK(refused("terrain --roughness 0") ==
          "--roughness: error: expected roughness with a number between 0 and 1, found '0'\n");
    CHECK(holds(refused("terrain --levels 20"), "a whole number from 0 to 13, found '20'"));
    CHECK(holds(refused("terrain --view mop"), "did you mean 'map'?"));
    CHECK(holds(refused("terrain --water 2"), "expected water with a number from 0 to 1"));
    CHECK(refused("ca --rule 300") ==
          "--rule: error: the rule 300 is out of range: expected 0 to 255\n");
    CHECK(holds(refused("ca --rule 30 --cells 99999999999"),
                "a grid of 99999999999 x 1 cells does not fit in the 4096 MiB"));
    CHECK(holds(refused("ca --rule 30 --start 02"), "expected states from 0 to 1"));
    CHECK(holds(refused("ca --life B9"), "expected a rule such as B3/S23"));
    CHECK(holds(refused("dla --particles 0"), "a whole number from 1 to 100000000, found '0'"));
    CHECK(holds(refused("walk --steps abc"), "found 'abc'"));
    CHECK(holds(refused("walk --dimensions 4"), "a whole number from 1 to 3, found '4'"));
    CHECK(holds(refused("walk --steps 900000000 --max-memory 10M", 3), "use fewer steps"));
    CHECK(holds(refused("walk -o a.xyz"), "found \"a.xyz\"; an animation ends in .gif"));
    CHECK(holds(refused("walk -o -"), "say which format with --format"));
    CHECK(holds(refused("walk --format svg"), "--format: expected -o"));
    CHECK(holds(refused("walk --rate 5 -o a.svg"), "--rate is for animations"));
    CHECK(holds(refused("particles"), "expected a line `kind NAME`"));
}

TEST_CASE("what is wrong with a file of iterated functions") {
    const Scratch scratch;
    const auto message = [&](const std::string& text) {
        return refused("ifs '" + scratch.file("a.ifs", text) + "'");
    };
    CHECK(holds(message("map 2 0 0 1/2 0 0\n"),
                "map 1 (line 1) does not contract: its norm is 2, expected less than 1"));
    CHECK(holds(message("map 1/2 0 0 1/2 0 0 0.5\nmap 1/2 0 0 1/2 1 0 0.6\n"),
                "the probabilities add up to 1.1, expected 1"));
    CHECK(holds(message("map 1/2 0 0 1/2 0 0 1/2\nmap 1/2 0 0 1/2 1 0\n"),
                "map 2 (line 2) has no probability, others do"));
    CHECK(holds(message("title x\nmapp 1/2 0 0 1/2 0 0\n"),
                "a.ifs:2:1: error: unknown statement 'mapp'; did you mean 'map'?"));
    CHECK(holds(message("# nothing\n"), "has no maps"));
}

TEST_CASE("files of other kinds are refused by what they are") {
    CHECK(refused("ifs koch") ==
          "algae: koch is an L-system, expected an iterated function system\n");
    CHECK(holds(refused("ifs dla"), "dla.dla is a cluster of diffusion-limited aggregation"));
    CHECK(holds(refused("show fern"),
                "fern.ifs is an iterated function system, expected an L-system"));
    CHECK(holds(refused("walk nosuch"), "nothing of that name in the gallery"));
    CHECK(holds(refused("draw ferm -o a.svg"), "did you mean 'fern'?"));
}

TEST_CASE("the gallery lists the other generators, by the names of their files") {
    const Run all = run("gallery");
    CHECK(all.status == 0);
    for (const std::string line : {"\nfern.ifs ", "\nrule-54 ", "\nrule-54.ca ", "\nglider.ca ",
                                   "\nrandom-walk.walk ", "\nmountains.terrain ", "\ndla.dla ",
                                   "\nfireworks.particles ", "\nweierstrass.function "})
        CHECK(holds(all.out, line));
    CHECK(holds(run("gallery --json").out, "\"path\": \"figures/003-fractal-notes/fern.ifs\""));
}

TEST_CASE("every file of the document's generators is in canonical form") {
    for (const std::string name :
         {"copy-machine-fern.ifs", "copy-machine.ifs", "fern.ifs", "sierpinski.ifs",
          "glider-gun.ca", "glider.ca", "rule-110.ca", "rule-126.ca", "rule-54.ca",
          "random-walk.walk", "brownian-plane.brownian", "landscape.terrain", "dla-growth.dla",
          "weierstrass.function", "boxes-on-koch.boxes"})
        CHECK_MESSAGE(run("fmt --check '" + figures + name + "'").status == 0, name);
}

TEST_CASE("automata and curves are converted, and others refused") {
    const Scratch scratch;
    const std::string file =
        scratch.file("r.ca", "rule 110\nboundary fixed 0\ncells 8\nstart 00000001\n");
    const Run system = run("convert '" + file + "' --to lsys");
    REQUIRE(system.status == 0);
    const std::string words = scratch.file("r.lsys", system.out);
    CHECK(run("derive '" + words + "' -n 5").out == run("ca '" + file + "' -n 5..5 --text").out);
    const Run maps = run("convert koch --to ifs");
    CHECK(holds(maps.out, "similarity 1/3 60 "));
    CHECK(holds(run("ifs '" + scratch.file("koch.ifs", maps.out) + "'").out, "1.26186"));
    CHECK(holds(refused("convert dla --to lsys"),
                "dla.dla: cannot convert dla to lsys; dla converts to nothing"));
    CHECK(holds(refused("convert rule-54.ca --to lsys"), "expected `boundary fixed 0`"));
}

TEST_CASE("Richardson's plot of a coast, and the dimension of a generator by its name") {
    const Scratch scratch;
    const std::string coast = scratch.file(
        "coast.terrain", "levels 8\nroughness 0.8\nmethod exact\nview coast\nseed 3\n");
    const std::string plot = scratch.file("richardson.svg");
    const Run lengths = run("dimension '" + coast + "' --measure divider --plot '" + plot + "'");
    INFO(lengths.err);
    CHECK(lengths.status == 0);
    CHECK(holds(lengths.out, "measured by dividers: 1."));
    CHECK(holds(text_of(plot), "<svg"));
    CHECK(holds(run("dimension sierpinski.ifs").out, "1.58496"));
    CHECK(refused("dimension '" + coast + "' --measure lacunarity --plot '" + plot + "'") ==
          "algae: --plot is for --measure boxes, divider, mass and correlation\n");
}
