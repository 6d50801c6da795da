#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include "command/run.hpp"

TEST_CASE("derive and show know systems within a system") {
    CHECK(run("derive leaves-of-a-system -n 1").out == "F[+x][-x]A(1)\n");
    CHECK(run("derive words-as-parameters -n 0").out == "B(\"FF[+FF][-FF]\",3)\n");
    CHECK(run("show leaves-of-a-system")
              .out.find("systems within leaf {\n"
                        "                   axiom x\n"
                        "                   x -> F[+x][-x]x\n"
                        "               }\n") != std::string::npos);
    const auto json = nlohmann::json::parse(run("show leaves-of-a-system --json").out);
    CHECK(json["systems"] ==
          nlohmann::json::parse(
              R"([{"name": "leaf", "axiom": "x", "rules": ["x -> F[+x][-x]x"], "ignore": []}])"));
    CHECK(json["class"] == "parametric PD0L with systems within");
    CHECK(run("fmt fronds").out.find("system frond {\n    axiom A(0)\n") != std::string::npos);
}

TEST_CASE("other verbs say why they take no systems within") {
    const Run letter = run("letter fronds -n 2 --at 3");
    CHECK(letter.status == 2);
    CHECK(letter.err == "algae: not a D0L system: there are systems within it\n");
}

TEST_CASE("words of systems within are bounded and their circles named") {
    const Run large = run("derive - -n 0 --max-letters 1000",
                          "printf 'system s { axiom F; F -> FF }\\naxiom C(s(40))' |");
    CHECK(large.status == 3);
    const Run circle = run("derive - -n 0", "printf 'system s { axiom <s(0)> }\\naxiom <s(0)>' |");
    CHECK(circle.status == 2);
    CHECK(circle.err.find("words need each other in a circle: s(0) needs s(0)") !=
          std::string::npos);
}
