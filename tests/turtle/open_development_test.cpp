#include "turtle/turtle.hpp"

#include <doctest/doctest.h>

#include "exact/exact.hpp"
#include "model/model.hpp"
#include "notation/notation.hpp"
#include "rewrite/rewrite.hpp"

using namespace algae;

namespace {

using Texts = std::vector<std::string>;

/// The words of generations 0 to n, with these settings behind the system.
Texts words(const std::string& system, std::uint64_t n,
            std::shared_ptr<Environment> external = nullptr, const RewritingChoices& choices = {}) {
    OpenDevelopment development(read_lsystem(system, "test.lsys"), choices, std::move(external));
    const CompiledRules& rules = development.rules();
    const ModuleText text(rules.system->alphabet, rules.kinds);
    Texts out;
    for (std::uint64_t generation = 0; generation <= n; ++generation) {
        development.go_to(generation);
        out.push_back(text.text(development.word()));
    }
    return out;
}

std::string refusal(const std::string& system, std::uint64_t n,
                    std::shared_ptr<Environment> external = nullptr) {
    try {
        return words(system, n, std::move(external)).back();
    } catch (const Error& error) {
        return error.what();
    }
}

const std::string growth =
    "axiom F(0,0)A?E(0)\nlet x = 0\nplot F\n"
    "A > ?E(y) : y < 2 -> F(x, y+1)A\nA > ?E(y) : y >= 2 -> ε\n";
const Texts grown{"F(0,0)A?E(0)", "F(0,0)F(0,1)A?E(1)", "F(0,0)F(0,1)F(0,2)A?E(2)",
                  "F(0,0)F(0,1)F(0,2)?E(2)", "F(0,0)F(0,1)F(0,2)?E(2)"};

/// A program that answers one question with the height of the turtle.
const std::string height =
    "while read -r line; do printf '%s\\n' \"$line\" | sed "
    "'s/.*\"position\":\\[[^,]*,\\([^,]*\\),.*/{\"answers\":[[\\1]]}/'; "
    "done";

}  // namespace

TEST_CASE("the documents' growing line") {
    CHECK(words(growth + "environment ?E y", 4) == grown);
    CHECK(words(growth + "environment ?E external", 4,
                std::make_shared<ExternalEnvironment>(height)) == grown);
}

TEST_CASE(
    "the word of generation 0 is filled too, and a file's parameters are only there for the first "
    "question") {
    CHECK(words("axiom FF?P(7,7)+?H(9)?P(1); angle 45", 1) ==
          Texts{"FF?P(2,0)+?H(45)?P(2)", "FF?P(2,0)+?H(45)?P(2)"});
}

TEST_CASE("the turtle sees interpretations, brackets, start, shrink and spin") {
    const std::string all =
        "axiom L?P(0,0)[+L?P(0,0)]L?P(0,0); L -> LL; interpret L -> F; angle 90; start 1 2 0; "
        "shrink 1/2; spin 90; ";
    CHECK(words(all, 1) == Texts{"L?P(2,2)[+L?P(2,3)]L?P(3,2)", "LL?P(1,3)[+LL?P(0,3)]LL?P(1,4)"});
}

TEST_CASE("every kind of environment in a word") {
    const std::string word =
        "axiom ^F?X(0)?Y(0)?Z(0)?P(0,0,0)?H(0,0,0)?C(0)?D(0)?L(0)[&FF?L(0)][&&F?C(0)?L(0)]; angle "
        "90\n"
        "environment ?X x; environment ?Y y; environment ?Z z\n"
        "environment ?C clip 0 0 0 1 1 1; environment ?D collision 0.5; environment ?L light 1";
    CHECK(words(word, 0) ==
          Texts{"^F?X(0)?Y(0)?Z(1)?P(0,0,1)?H(0,0,1)?C(1)?D(0)?L(1)[&FF?L(1)][&&F?C(1)?L(0)]"});
}

TEST_CASE("collisions count the whole word, not what grows on") {
    const auto filled = [](const std::string& axiom) {
        return words("axiom " + axiom + "; angle 90; environment ?E collision 0.5", 0).front();
    };
    CHECK(filled("F?E(0)F[+F?E(0)]F?E(0)") == "F?E(0)F[+F?E(0)]F?E(0)");
    CHECK(filled("F+F+F+F?E(0)") == "F+F+F+F?E(1)");
    CHECK(filled("[FF+F?E(0)]+FF-FF?E(0)") == "[FF+F?E(0)]+FF-FF?E(0)");
    CHECK(filled("[FF+FF?E(0)]+FF-FF?E(0)") == "[FF+FF?E(1)]+FF-FF?E(1)");
    CHECK(filled("FF(0)?E(0)") == "FF(0)?E(0)");
    CHECK(filled("f?E(0)") == "f?E(0)");
}

TEST_CASE("chance, tables and conditions are those of rewriting") {
    const std::string random =
        "axiom A?P(0); A > ?P(x) : x < 20 -(1/2)-> FA; A > ?P(x) : x < 20 -(1/2)-> FFA; A > ?P(x) "
        ": x >= 20 -> B";
    RewritingChoices seed;
    seed.seed = 5;
    const Texts once = words(random, 20, nullptr, seed);
    CHECK(once == words(random, 20, nullptr, seed));
    CHECK(once != words(random, 20));
    CHECK(once.back().find('B') != std::string::npos);
    const std::size_t drawn = once.back().find('B');
    CHECK(once.back() == std::string(drawn, 'F') + "B?P(" + std::to_string(drawn) + ')');
    CHECK((drawn == 20 || drawn == 21));
}

TEST_CASE("systems without communication modules are only rewritten") {
    CHECK(words("axiom A(1)}; A(x) -> A(x*2)A(x)", 2) ==
          Texts{"A(1)}", "A(2)A(1)}", "A(4)A(2)A(2)A(1)}"});
}

TEST_CASE("what has no environment, or another number of parameters") {
    CHECK(refusal("axiom A?E(0)", 0) ==
          "nothing fills the communication module ?E; expected a setting such as `environment ?E "
          "position`");
    CHECK(refusal("axiom A; A -> B?E(0)", 0).find("nothing fills") != std::string::npos);
    CHECK(refusal("axiom A?E(0); environment ?E external", 0) ==
          "the communication module ?E is filled by a program; say by which");
    CHECK(refusal("axiom FF?E(1,2); environment ?E light 3", 0) ==
          "?E(1,2) at position 2 of generation 0: expected 1 parameter, which `light` fills, found "
          "2");
    CHECK(refusal("axiom A; A -> B?P", 1) ==
          "?P at position 1 of generation 1: expected 1 or 2 or 3 parameters, which `position` "
          "fills, found 0");
    CHECK(refusal("axiom ?H(1,2)", 0) ==
          "?H(1,2) at position 0 of generation 0: expected 1 or 3 parameters, which `heading` "
          "fills, found 2");
}

TEST_CASE("errors of turtle and program come through") {
    CHECK(refusal("axiom F]?P(0)", 0).find("unmatched ']'") != std::string::npos);
    const std::string once = "read -r line; echo '{\"answers\":[[1]]}'; read -r line; exit 4";
    CHECK(refusal("axiom A?E(0); environment ?E external", 2,
                  std::make_shared<ExternalEnvironment>(once)) ==
          "the environment program '" + once +
              "' ended with status 4 before it gave the answer to generation 1");
}

TEST_CASE("a program is asked once a generation, also where nothing asks") {
    const std::string count =
        "n=0; while read -r line; do n=$((n+1)); case \"$line\" in *module*) echo "
        "\"{\\\"answers\\\":[[$n]]}\";; *) echo '{\"answers\":[]}';; esac; done";
    CHECK(words("axiom A; A -> B; B -> ?E(0); environment ?E external", 3,
                std::make_shared<ExternalEnvironment>(count)) == Texts{"A", "B", "?E(3)", "?E(4)"});
}
