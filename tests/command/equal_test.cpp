#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include "command/run.hpp"

using nlohmann::json;

TEST_CASE("equal --as sequence shows the automaton of overflows") {
    const Scratch files;
    const std::string one = files.file("one.lsys", "axiom ab; a -> ; b -> aabb");
    const std::string two = files.file("two.lsys", "axiom ab; a -> aabb; b -> ");
    const Run same = run("equal " + one + " " + two + " --as sequence");
    CHECK(same.status == 0);
    CHECK(same.out ==
          "equal: A and B have the same word in every generation\n"
          "  bound: read any of these words from the left; what it becomes by the rules of A is "
          "never more than 8 letters\n"
          "         ahead of or behind what it becomes by the rules of B\n"
          "  automaton: 3 states, what is ahead: ε, B aabb, B aabbaabb\n"
          "  steps: each of the words of generations 0 to 1 leads from ε back to ε;\n"
          "         what the letters become in 2 steps does the same to the states as in 1, so all "
          "later words do too\n");
    const Run proof = run("equal " + one + " " + two + " --as sequence --json");
    const json found = json::parse(proof.out);
    CHECK(proof.status == 0);
    CHECK(found["verdict"] == "equal");
    CHECK(found["witness"] == json::parse(R"({"by": "balance", "bound": 8,
        "states": [{"ahead": "left", "word": ""}, {"ahead": "right", "word": "a a b b"}, {"ahead": "right", "word": "a a b b a a b b"}],
        "accepts": {"steps": 2, "earlier": 1}})"));
}

TEST_CASE("equal --as sequence shows the first difference") {
    const Scratch files;
    const std::string one = files.file("one.lsys", "axiom ab; a -> abb; b -> aabba");
    const std::string two = files.file("two.lsys", "axiom ab; a -> abbaabb; b -> a");
    const Run other = run("equal " + one + " " + two + " --as sequence");
    CHECK(other.status == 1);
    CHECK(other.out.starts_with("different: the words of generation 3 differ at position "));
    CHECK(other.out.find(", those before are the same\n  A, from position ") != std::string::npos);
    const json found = json::parse(run("equal " + one + " " + two + " --as sequence --json").out);
    CHECK(found["verdict"] == "different");
    CHECK(found["witness"]["by"] == "generation");
    CHECK(found["witness"]["generation"] == 3);
    CHECK(found["witness"]["letters"][0] != found["witness"]["letters"][1]);
    const Run ends = run("equal " + files.file("a.lsys", "axiom a; a -> ab") + " " +
                         files.file("b.lsys", "axiom a; a -> a") + " --as sequence");
    CHECK(ends.out ==
          "different: the words of generation 1 differ at position 1, those before are the same\n"
          "  A, from position 0 of 2: ab\n"
          "  B, from position 0 of 1: a\n");
}

TEST_CASE("equal compares languages") {
    const Scratch files;
    const std::string one = files.file("one.lsys", "axiom S; S -> T; T -> SX");
    const std::string two = files.file("two.lsys", "axiom T; T -> S; S -> TX");
    const Run same = run("equal " + one + " " + two);
    CHECK(same.status == 0);
    CHECK(
        same.out.starts_with("equal: A and B have the same words, infinitely many\n"
                             "generations 0, 2, 4, ... of A are generations 1, 3, 5, ... of B\n"
                             "  rules: here a step is 2 steps of A and 2 of B\n"
                             "  bound: "));
    const json proof = json::parse(run("equal " + one + " " + two + " --json").out);
    CHECK(proof["witness"]["by"] == "sections");
    CHECK(proof["witness"]["words"] == json::array());
    CHECK(proof["witness"]["sections"].size() == 2);
    CHECK(proof["witness"]["sections"][1]["proof"]["by"] == "balance");

    const Run other =
        run("equal " + one + " " + files.file("three.lsys", "axiom S; S -> T; T -> XS"));
    CHECK(other.status == 1);
    CHECK(other.out ==
          "different: generation 2 of A is not a word of B: SX\n"
          "  generation 2 of B alone has as many of each letter, in another order\n");
    CHECK(run("equal " + one + " koch").out ==
          "different: generation 0 of A is not a word of B: S\n");
    const json refuted = json::parse(run("equal " + one + " koch --json").out);
    CHECK(refuted == json::parse(R"({"verdict": "different",
        "witness": {"by": "word", "of": "A", "generation": 0, "length": 1, "word": "S"}})"));
    CHECK(run("equal " + files.file("p.lsys", "axiom ab; a -> b; b -> a") + " " +
              files.file("q.lsys", "axiom ba; a -> b; b -> a"))
              .out == "equal: A and B have the same 2 words\n");
    CHECK(run("equal koch koch").status == 0);
}

TEST_CASE("equal with a bound that is reached is undecided and says what was tried") {
    const Scratch files;
    const std::string one = files.file("one.lsys", "axiom ab; a -> ; b -> aabb");
    const std::string two = files.file("two.lsys", "axiom ab; a -> aabb; b -> ");
    const Run text = run("equal " + one + " " + two + " --as sequence --max-memory 500");
    CHECK(text.status == 3);
    CHECK(text.err.find("undecided: generations 0 to ") != std::string::npos);
    const Run undecided =
        run("equal " + one + " " + two + " --as sequence --max-memory 500 --json");
    CHECK(undecided.status == 3);
    CHECK(json::parse(undecided.out)["verdict"] == "undecided");
    CHECK(run("equal " + one + " " + files.file("three.lsys", "axiom a; a -> a; a -> aa")).status ==
          2);
    CHECK(run("equal " + one + " " + two + " --as words").status == 2);
}
