#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include "command/run.hpp"

TEST_CASE("derive prints the boxes of a system of shape rules, a box a line") {
    CHECK(run("derive relative-sizes -n 1").out ==
          "D 0 0 0 2 3 1\nE 2 0 0 3 3 1\nE 5 0 0 3 3 1\nD 8 0 0 2 3 1\n");
    CHECK(run("derive wall -n 0..1").out ==
          "# generation 0\nwall 0 0 0 1 1 1\n# generation 1\nwindow 0 0 0 1/3 1 1\nwindow 1/3 0 0 "
          "1/3 1 1\n"
          "window 2/3 0 0 1/3 1 1\n");
    const auto json = nlohmann::json::parse(run("derive wall -n 1 --json").out)["generations"];
    REQUIRE(json.size() == 1);
    CHECK(json[0]["generation"] == 1);
    CHECK(json[0]["boxes"][1] == nlohmann::json{{"symbol", "window"},
                                                {"origin", {"1/3", "0", "0"}},
                                                {"size", {"1/3", "1", "1"}}});
}

TEST_CASE("the panel building through all its steps") {
    CHECK(run("derive building -n 3").out ==
          "sklep 0 0 0 5 3 10\ndvere 5 0 0 2 3 10\nsklep 7 0 0 5 3 10\npatro 0 3 0 12 3 10\npatro "
          "0 6 0 12 3 10\n");
    CHECK(run("derive building -n 6").out ==
          "okno 0 0 0 5 3 10\nvstup 5 0 0 2 3 10\nokno 7 0 0 5 3 10\n"
          "okno 0 3 0 5 3 10\nzabradli 5 3 0 1 3 10\nokno 6 3 0 5 3 10\nzabradli 11 3 0 1 3 10\n"
          "okno 0 6 0 5 3 10\nzabradli 5 6 0 1 3 10\nokno 6 6 0 5 3 10\nzabradli 11 6 0 1 3 10\n");
}

TEST_CASE("derive refuses what makes no sense of boxes") {
    const Run seeded = run("derive wall -n 1 --seed 3");
    CHECK(seeded.status == 2);
    CHECK(
        seeded.err ==
        "algae: a system of shape rules derives boxes; derive takes -n, --all and --json for it\n");
    CHECK(run("derive wall").err == "algae: -n is missing: which generation?\n");
    const Run large = run("derive - -n 1", "printf 'axiom A\\nA -> div(X, 2){ B }' |");
    CHECK(large.status == 2);
    CHECK(large.err.find("2:13: expected sizes that add up to at most 1, found 2, along X, for the "
                         "box A 0 0 0 1 1 1") != std::string::npos);
}

TEST_CASE("show --axes counts the axes of a generation by order") {
    CHECK(run("show axial-tree --axes -n 0").out ==
          "order 0: 1 axis, 2 edges\norder 1: 4 axes, 5 edges\norder 2: 1 axis, 1 edge\n");
    CHECK(nlohmann::json::parse(run("show plant-a --axes -n 1 --json").out)["orders"] ==
          nlohmann::json{{{"order", 0}, {"axes", 1}, {"edges", 3}},
                         {{"order", 1}, {"axes", 2}, {"edges", 2}}});
    CHECK(run("show koch --axes").err == "algae: --axes and -n go together\n");
}
