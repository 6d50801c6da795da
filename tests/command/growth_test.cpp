#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include "command/run.hpp"

using nlohmann::json;

namespace {

/// Puts a system on standard input.
std::string given(const std::string& system) { return "printf '" + system + "' |"; }

}  // namespace

TEST_CASE("growth prints a page that says everything") {
    const Run koch = run("growth koch");
    CHECK(koch.status == 0);
    CHECK(koch.out ==
          "lengths, n = 0..10      1, 8, 36, 148, 596, 2388, 9556, 38228, 152916, 611668, 2446676\n"
          "letters                 3\n"
          "growth matrix              F  +  -\n"
          "                        F  4  2  2\n"
          "                        +  0  1  0\n"
          "                        -  0  0  1\n"
          "characteristic          (x - 4) (x - 1)^2\n"
          "minimal polynomial      (x - 4) (x - 1)\n"
          "shortest recurrence     a(n) = 5a(n-1) - 4a(n-2), for n >= 2\n"
          "from                    1, 8\n"
          "generating function     (1 + 3x)/(1 - 5x + 4x^2)\n"
          "closed form             a(n) = (7*4^n - 4)/3\n"
          "growth                  exponential: like 4^n\n"
          "rate                    4\n"
          "morphism                not irreducible\n"
          "fixed and periodic      h(F) begins with F: an infinite word that h leaves as it is\n"
          "                        h(+) = +\n"
          "                        h(-) = -\n"
          "fate of the letters     F   exponential: 4^n; share 3/7 = 0.4285714286\n"
          "                        +   bounded; share 2/7 = 0.2857142857\n"
          "                        -   bounded; share 2/7 = 0.2857142857\n");
    const Run dies = run("growth -", given("axiom a; a -> b; b -> "));
    CHECK(dies.out.find("growth                  zero: the word is empty from generation 2 on\n") !=
          std::string::npos);
    CHECK(dies.out.find("before that             1, 1\n") != std::string::npos);
    const Run turns = run("growth -", given("axiom a; a -> bb; b -> a"));
    CHECK(turns.out.find("has no limit, but one for each n modulo 2\n") != std::string::npos);
    const Run padovan = run("growth -", given("axiom c; a -> c; b -> ca; c -> b"));
    CHECK(
        padovan.out.find(
            "the roots of x^3 - x - 1 are 1.324717957245, -0.662358978622 +- 0.562279512062i\n") !=
        std::string::npos);
    CHECK(padovan.out.find("1.32471795724474602596090885448\n") != std::string::npos);
}

TEST_CASE("growth --json has stable keys") {
    const json found = json::parse(run("growth - --json", given("axiom b; a -> ab; b -> a")).out);
    CHECK(found["lengths"] == json({1, 1, 2, 3, 5, 8, 13, 21, 34, 55, 89}));
    CHECK(found["matrix"] == json::parse("[[0, 1], [1, 1]]"));
    CHECK(found["recurrence"]["text"] == "a(n) = a(n-1) + a(n-2)");
    CHECK(found["recurrence"]["coefficients"] == json({1, 1}));
    CHECK(found["recurrence"]["initial"] == json({1, 1}));
    CHECK(found["generating_function"] ==
          json::parse(R"({"numerator": [1], "denominator": [1, -1, -1]})"));
    CHECK(found["closed_form"] ==
          "((5+sqrt(5))/10)*((1+sqrt(5))/2)^n + ((5-sqrt(5))/10)*((1-sqrt(5))/2)^n");
    CHECK(found["class"] == "exponential");
    CHECK(found["degree"] == 0);
    CHECK(found["rate"]["exact"] == "(1+sqrt(5))/2");
    CHECK(found["rate"]["decimal"] == "1.61803398874989484820458683437");
    CHECK(found["primitivity_exponent"] == 2);
    CHECK(found["letters"][1]["frequency"]["exact"] == "(-1+sqrt(5))/2");
    const json cubic =
        json::parse(run("growth - --json", given("axiom a; a -> ab; b -> bc; c -> cd")).out);
    CHECK(cubic["class"] == "polynomial");
    CHECK(cubic["degree"] == 3);
    const json bounded = json::parse(
        run("growth - --json", given("axiom a; a -> bc; b -> cac; c -> de; d -> ; e -> ")).out);
    CHECK(bounded["class"] == "bounded");
    CHECK(bounded["preperiod"] == 2);
    CHECK(bounded["period"] == 2);
    CHECK(bounded["exceptions"] == json({1, 2}));
    CHECK(bounded["letters"][2]["class"] == "mortal");
    CHECK(json::parse(run("growth - --json", given("axiom a; a -> ")).out)["class"] == "zero");
}

TEST_CASE("growth says why there is no growth function") {
    const auto refused = [](const std::string& system) {
        const Run found = run("growth -", given(system));
        CHECK(found.status == 2);
        CHECK(found.out.empty());
        return found.err;
    };
    CHECK(refused("axiom a; a -> a; a -> aa") ==
          "algae: no growth function: not a D0L system: a has 2 rules; --bounds gives the least "
          "and the greatest length of "
          "each generation\n");
    CHECK(refused("axiom A(1)\nA(x) -> A(x+1)\n").find("has parameters") != std::string::npos);
    CHECK(refused("axiom a\na -(1/2)-> a\na -(1/2)-> aa\n").find("has a probability") !=
          std::string::npos);
}

TEST_CASE("growth --bounds gives the least and the greatest lengths of an 0L system") {
    const json found =
        json::parse(run("growth - --bounds -n 0..4 --json", given("axiom a; a -> a; a -> aa")).out);
    CHECK(found["least"] == json({1, 1, 1, 1, 1}));
    CHECK(found["greatest"] == json({1, 2, 4, 8, 16}));
    CHECK(found["greatest_choice"] == "a -> aa");
    const Run page = run("growth - --bounds -n 3", given("axiom a; a -> a; a -> aa"));
    CHECK(page.status == 0);
    CHECK(page.out.find("3           1  8\n") != std::string::npos);
    CHECK(run("growth - --bounds", given("axiom ba; b < a -> b")).status == 2);
}

TEST_CASE("growth --plot draws in every format") {
    const Scratch scratch;
    for (const char* name : {"a.svg", "a.pdf", "a.png", "a.ps", "a.eps"})
        CHECK(run("growth koch --plot " + scratch.file(name)).status == 0);
    CHECK(text_of(scratch.file("a.svg")).find("<svg") != std::string::npos);
    CHECK(run("growth - -n 0..30 --plot " + scratch.file("b.svg"), given("axiom a; a -> ab"))
              .status == 0);
    CHECK(run("growth - --plot " + scratch.file("c.svg"), given("axiom a; a -> ")).status == 0);
    CHECK(run("growth koch --plot " + scratch.file("d.jpeg")).status == 2);
    const Run context =
        run("growth - --plot " + scratch.file("d.svg"), given("axiom ba; b < a -> b"));
    CHECK(context.status == 2);
    CHECK(context.err ==
          "algae: no growth function: not a D0L system: the rule at standard input:1:11 has a "
          "context\n");
    CHECK(run("growth koch -n 0..90000 --plot " + scratch.file("d.svg")).status == 2);
    CHECK(scratch.size() == 7);
}

TEST_CASE("equal --as growth decides with a witness") {
    const Scratch scratch;
    const std::string fibonacci = scratch.file("f.lsys", "axiom a\na -> ab\nb -> a\n");
    const std::string anabaena =
        scratch.file("a.lsys", "axiom A\nA -> aB\na -> bA\nB -> A\nb -> a\n");
    const Run same = run("equal " + fibonacci + " " + anabaena + " --as growth");
    CHECK(same.status == 0);
    CHECK(same.out ==
          "equal: the lengths of generations 0 to 5 are the same, and as many as both systems have "
          "letters together decide\n");
    const Run other = run("equal " + fibonacci + " koch --as growth");
    CHECK(other.status == 1);
    CHECK(other.out == "different: in generation 1 the lengths are 2 and 8\n");
    const json found = json::parse(run("equal " + fibonacci + " koch --as growth --json").out);
    CHECK(found["verdict"] == "different");
    CHECK(found["witness"]["generation"] == 1);
    CHECK(found["witness"]["lengths"] == json({2, 8}));
    CHECK(run("equal " + fibonacci + " koch --as nothing").status == 2);
    CHECK(run("equal " + fibonacci + " - --as growth", given("axiom a; a -> a; a -> aa")).status ==
          2);
}
