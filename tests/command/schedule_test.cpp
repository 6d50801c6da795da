#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include "command/run.hpp"

using nlohmann::json;

namespace {

const std::string text =
    "axiom a; table light; a -> ab; table dark; a -> b; b -> aa; schedule light dark";
const std::string piped = "printf '" + text + "' |";
const std::string unscheduled = "printf '" + text.substr(0, text.rfind(';')) + "' |";
const std::string plant = "axiom F\ntable a\nF -> FF\ntable b\nF -> F[+F]F\nschedule b a\n";

}  // namespace

TEST_CASE("derive takes the tables of the schedule, unless others are said") {
    CHECK(run("derive - -n 4 --all", piped).out == "a\nab\nbaa\nbabab\naabaabaa\n");
    CHECK(run("derive - -n 2 --tables dark,light", piped).out == "b\n");
    CHECK(run("derive - -n 3 --tables 12", piped).err ==
          "algae: --tables: expected a table for each of 3 steps, found 2\n");
    CHECK(run("derive - -n 9 --seeds 1..5", piped).out ==
          run("derive - -n 9 --seeds 1..5", unscheduled).out);
    CHECK(run("derive - -n 9 --seed 2", piped).out ==
          run("derive - -n 9 --seed 2", unscheduled).out);
    CHECK(run("derive - -n 3 --distribution", piped).out == "1  babab\n");
    CHECK(run("derive - -n 3 --distribution", unscheduled).err ==
          "algae: it has tables and no schedule; say --tables SEQUENCE\n");
}

TEST_CASE("languages know no schedule") {
    CHECK(run("derive - -n 2 --language", piped).out == "a\nb\naa\nab\nabb\nbaa\n");
    const Run bb = run("member - bb", piped);  // by dark three times
    CHECK(bb.out == run("member - bb", unscheduled).out);
}

TEST_CASE("draw and dimension take the tables of the schedule") {
    const Scratch scratch;
    const std::string file = scratch.file("plant.lsys", plant), svg = scratch.file("p.svg");
    const auto segments = [&](const std::string& options) {
        return json::parse(
            run("draw " + file + " --json -o " + svg + ' ' + options).out)["segments"];
    };
    CHECK(segments("-n 3") == 18);
    CHECK(segments("-n 3 --tables bab") == 18);
    CHECK(segments("-n 2 --tables aa") == 4);
    const Run measured = run("dimension " + file + " -n 8");
    CHECK(measured.out.find("1296 segments") != std::string::npos);
}

TEST_CASE("show tells of schedules, systems within, environments and stamps") {
    const Scratch scratch;
    const std::string scheduled = run("show light-and-dark").out;
    CHECK(scheduled.find("tables         light dark\n"
                         "schedule       light light dark, then again\n") != std::string::npos);
    const std::string file =
        scratch.file("all.lsys",
                     "system leaf {\naxiom x\nx -> F[+x]x\nignore + F\n}\nsystem bud { axiom y }\n"
                     "axiom A(leaf(2))?E(0)S[<bud(0)>]\nA(w) -> [<w>]A(w)\n"
                     "environment ?E clip 0 (1 < 2) 4 3\nstamp S square\nstamp T circle\nplot P Q\n"
                     "solid B box height\nsurface K polygon (0,0,0) (1,0,0) (1,1,0)\n");
    const std::string shown = run("show " + file).out;
    for (const char* lines :
         {"systems within leaf {\n"
          "                   axiom x\n"
          "                   x -> F[+x]x\n"
          "                   ignore + F\n"
          "               }\n"
          "               bud {\n"
          "                   axiom y\n"
          "               }\n",
          "environments   ?E clip 0 (1 < 2) 4 3\n", "plot           P Q\n",
          "stamps         S square\n               T circle\n", "solids         B box height\n",
          "surfaces       K polygon (0, 0, 0) (1, 0, 0) (1, 1, 0)\n"}) {
        CAPTURE(shown);
        CHECK(shown.find(lines) != std::string::npos);
    }
    const json found = json::parse(run("show " + file + " --json").out);
    CHECK(found["systems"][0] == json::parse(R"({"name": "leaf", "axiom": "x",
        "rules": ["x -> F[+x]x"], "ignore": ["+", "F"]})"));
    CHECK(found["systems"][1]["name"] == "bud");
    CHECK(found["environments"] ==
          json::parse(R"([{"module": "?E", "kind": "clip", "numbers": [0, 1, 4, 3]}])"));
    CHECK(found["plot"] == json{"P", "Q"});
    CHECK(found["stamps"] == json::parse(R"([{"symbol": "S", "shape": "square"},
        {"symbol": "T", "shape": "circle"}])"));
    CHECK(found["solids"] ==
          json::parse(R"([{"symbol": "B", "kind": "box", "measures": ["height"]}])"));
    CHECK(found["surfaces"] == json::parse(R"([{"symbol": "K", "kind": "polygon"}])"));
    CHECK(found["schedule"] == json::array());
    CHECK(json::parse(run("show light-and-dark --json").out)["schedule"] ==
          json{"light", "light", "dark"});
    const json plain = json::parse(run("show koch --json").out);
    for (const char* key :
         {"systems", "tables", "schedule", "environments", "plot", "stamps", "solids", "surfaces"})
        CHECK(plain[key] == json::array());
}
