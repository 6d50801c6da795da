#include <doctest/doctest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "command/run.hpp"
#include "places.hpp"

namespace {

const std::string growth = source_folder() + "/figures/001-formal-languages/open-growth.lsys";

/// A system that leaves its module to a program, on standard input.
const std::string external =
    "printf 'axiom A?E(0); A > ?E(x) : x < 4 -> FA; environment ?E external' |";

/// A shell script that answers the n-th question with n.
const std::string counts =
    "n=0\nwhile read -r line; do n=$((n+1)); echo \"{\\\"answers\\\":[[$n]]}\"; done\n";

}  // namespace

TEST_CASE("derive fills communication modules") {
    CHECK(run("derive '" + growth + "' -n 3 --all").out ==
          "F(0,0)A?E(0)\nF(0,0)F(0,1)A?E(1)\nF(0,0)F(0,1)F(0,2)A?E(2)\nF(0,0)F(0,1)F(0,2)?E(2)\n");
    CHECK(nlohmann::json::parse(run("derive '" + growth + "' -n 3 --json").out)["words"][0] ==
          "F(0,0)F(0,1)F(0,2)?E(2)");
}

TEST_CASE("derive asks a program") {
    const Scratch scratch;
    const std::string script = scratch.file("counts.sh", counts);
    CHECK(run("derive - -n 0..4 --environment 'sh " + script + "'", external).out ==
          "A?E(1)\nFA?E(2)\nFFA?E(3)\nFFFA?E(4)\nFFFA?E(5)\n");
    // A program for each seed.
    CHECK(run("derive - -n 1 --seeds 1..3 --environment 'sh " + script + "'", external).out ==
          "FA?E(2)\nFA?E(2)\nFA?E(2)\n");
}

TEST_CASE("programs that fail") {
    const auto failed = [](const std::string& arguments) {
        const Run found = run("derive - -n 2 " + arguments, external);
        CHECK(found.out.empty());
        return std::to_string(found.status) + ' ' + found.err;
    };
    CHECK(failed("") ==
          "2 algae: the communication module ?E is filled by a program; say by which, with "
          "--environment "
          "'COMMAND'\n");
    CHECK(failed("--environment 'exit 1'") ==
          "2 algae: the environment program 'exit 1' ended with status 1 before it gave the answer "
          "to generation 0\n");
    CHECK(failed("--environment 'echo 3'") ==
          "2 algae: the environment program 'echo 3', generation 0: expected a line such as "
          "{\"answers\":[[1],[2]]}, found '3'\n");
    CHECK(failed("--timeout 0.3 --environment 'sleep 30'") ==
          "3 algae: the time allowed by --timeout is over, and the environment program 'sleep 30' "
          "has not given the answer "
          "to generation 0\n");
    CHECK(run("derive koch -n 1 --environment cat").err ==
          "algae: --environment: no module of the system asks a program; expected a setting such "
          "as `environment ?E "
          "external`\n");
    CHECK(run("derive '" + growth + "' -n 1 --distribution").err ==
          "algae: it has communication modules, and --distribution asks no environment\n");
}

TEST_CASE("draw shows the words that derive writes") {
    const Scratch scratch;
    const auto facts = [&](const std::string& arguments, const std::string& before = "") {
        const Run found =
            run("draw " + arguments + " -o '" + scratch.file("figure.svg") + "' --json", before);
        REQUIRE(found.status == 0);
        return nlohmann::json::parse(found.out);
    };
    CHECK(facts("'" + growth + "' -n 3")["end"] == nlohmann::json({0, 2}));
    const std::string script = scratch.file("counts.sh", counts);
    const nlohmann::json all =
        facts("- -n 0..5 --panels --environment 'sh " + script + "'", external)["figures"];
    REQUIRE(all.size() == 6);
    for (std::size_t n = 0; n < 6; ++n) CHECK(all[n]["segments"] == std::min<std::size_t>(n, 3));
    const Run refused = run("draw - -n 2 -o '" + scratch.file("none.svg") + "'", external);
    CHECK(refused.status == 2);
    CHECK(refused.err ==
          "algae: the communication module ?E is filled by a program; say by which, with "
          "--environment "
          "'COMMAND'\n");
}
