#include <doctest/doctest.h>

#include <string>

#include "command/run.hpp"
#include "places.hpp"

namespace {

const std::string examples = source_folder() + "/examples/";

bool holds(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("a Maple worksheet is derived, drawn and converted both ways") {
    const Scratch scratch;
    const Run word = run("derive '" + examples + "plant.maple' -n 1");
    CHECK(word.out == run("derive plant-f -n 1").out);
    const std::string picture = scratch.file("honda.svg");
    CHECK(run("draw '" + examples + "honda.maple' -o '" + picture + "'").status == 0);
    CHECK(text_of(picture).size() > 10'000);
    const Run written = run("convert honda-a --to maple");
    REQUIRE(written.status == 0);
    CHECK(holds(written.out, "F := L -> [[\"F\",L]]:\n"));
    const std::string file = scratch.file("tree.maple", written.out);
    const Run back = run("convert '" + file + "' --to lsys");
    CHECK(back.out == run("convert '" + examples + "honda.maple' --to lsys").out);
    CHECK(run("convert - --from maple --to lsys", "cat '" + file + "' |").out == back.out);
    const Run refused = run("convert row-of-trees --to maple");
    CHECK(refused.status == 2);
    CHECK(holds(refused.err, "maple cannot say the rule F(x,t) : t = 0 -> "));
    const Run wrong =
        run("show '" + scratch.file("w.maple", "> a := 1:\n> Lsystem(a, 2);\n") + "'");
    CHECK(wrong.status == 2);
    CHECK(holds(wrong.err,
                "w.maple:2:11: error: expected the axiom, a list of modules, found a number\n"
                "  > Lsystem(a, 2);\n            ^"));
}

TEST_CASE("tables of maps and of cells are what their verbs take") {
    const Scratch scratch;
    const std::string fern = "'" + examples + "fern.ifs-table'";
    const Run known = run("ifs " + fern);
    CHECK(holds(known.out, "bounding box: [-2.18229, 2.65578] x [0, 9.99845]"));
    CHECK(holds(known.out, "map 1 (line 3): norm 0.16"));
    CHECK(run("draw " + fern + " -o '" + scratch.file("fern.png") + "' --width 100").status == 0);
    CHECK(run("convert " + fern + " --to ifs").out ==
          "map 0 0 0 0.16 0 0 0.01\nmap 0.85 0.04 -0.04 0.85 0 1.6 0.85\n"
          "map 0.2 -0.26 0.23 0.22 0 1.6 0.07\nmap -0.15 0.28 0.26 0.24 0 0.44 0.07\n");
    const std::string rule = "'" + examples + "rule-110.ca-table'";
    CHECK(run("ca " + rule + " --cells 9 -n 4 --text").out ==
          run("ca --rule 110 --cells 9 -n 4 --text").out);
    CHECK(run("convert " + rule + " --to ca").out == "rule 110\n");
    CHECK(holds(run("convert rule-110 --to ca-table").out, "110 -> 1\n111 -> 0\n"));
    CHECK(holds(run("ca " + fern).err, "fern.ifs-table is an iterated function system, expected"));
    CHECK(holds(run("derive " + rule + " -n 1").err, "expected an L-system"));
    CHECK(holds(run("convert " + rule + " --to lsys").err,
                "cannot convert ca-table to lsys; ca-table converts to ca\n"));
    CHECK(holds(run("fmt " + rule).err,
                "rule-110.ca-table is the table of a rule of cells on a line; expected a "
                "file of the notation, as `algae convert --to ca` makes of it"));
    CHECK(holds(run("fmt '" + examples + "plant.maple'").err, "`algae convert --to lsys` makes"));
}
