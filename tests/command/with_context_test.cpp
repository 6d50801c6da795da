#include <doctest/doctest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "command/run.hpp"

namespace {

const std::string choices = "printf 'axiom ab; a > b -> aa | b' |";
const std::string erasing = "printf 'axiom ab; a > b -> aa | b; b -> ε | b' |";

}  // namespace

TEST_CASE("all words of a system with context and choices") {
    CHECK(run("derive - --all-words --longest 3", choices).out == "ab\nbb\naab\nabb\nbbb\n");
    CHECK(run("derive - --all-words -n 1", choices).out == "bb\naab\n");
    const Run refused = run("derive - -n 2", choices);
    CHECK(refused.status == 2);
    CHECK(refused.err.find("say --all-words for all words, or --seed S for one picked at random") !=
          std::string::npos);
    CHECK(run("derive - --all-words --longest 3 --max-memory 16M", erasing).status == 3);
}

TEST_CASE("member and finite take systems with context") {
    const Run in = run("member - bbb", choices);
    CHECK(in.status == 0);
    CHECK(in.out.starts_with("yes: bbb is in the language, first in generation 3\n"));
    CHECK(in.out.ends_with("     3  bbb\n"));
    CHECK(run("member - bbb --brief", choices).out ==
          "yes: bbb is in the language, first in generation 3\n");
    const auto found = nlohmann::json::parse(run("member - bbb --json", choices).out);
    CHECK(found["step"] == 3);
    REQUIRE(found["derivation"].size() == 4);
    CHECK(found["derivation"][3]["word"] == "bbb");
    CHECK_FALSE(nlohmann::json::parse(run("member - bbb --json --brief", choices).out)
                    .contains("derivation"));
    const Run out = run("member - ba", choices);
    CHECK(out.status == 1);
    CHECK(out.out ==
          "no: ba is not in L(A): no rule erases, so words do not get shorter, and none of the 2 "
          "words with at most 2 letters is it.\n");
    const auto json = nlohmann::json::parse(run("member - ba --json", choices).out);
    CHECK(json["member"] == false);
    CHECK(run("finite -", choices).status == 1);
    const Run finite = run("finite -", "printf 'axiom aab; a > b -> a | b' |");
    CHECK(finite.status == 0);
    CHECK(finite.out.find("L(A) has 3 words") != std::string::npos);
}

TEST_CASE("equal takes systems with context") {
    const Run same = run("equal signal signal");
    CHECK(same.status == 0);
    const Run other = run("equal - signal", choices);
    CHECK(other.status == 1);
    const auto json = nlohmann::json::parse(run("equal - signal --json", choices).out);
    CHECK(json["verdict"] == "different");
}

TEST_CASE("letters of a system with context") {
    CHECK(run("letter signal -n 3 --at 2 --count 5").out == "ab\n");
    const Run beyond = run("letter signal -n 3 --at 4");
    CHECK(beyond.status == 2);
    CHECK(beyond.err.find("generation 3 has no letter at 4: it has 4 letters") !=
          std::string::npos);
    const Run choosing = run("letter - -n 3 --at 0", choices);
    CHECK(choosing.status == 2);
    CHECK(choosing.err.find("not a deterministic IL system: a has two rules") != std::string::npos);
}

TEST_CASE("derivations of words with context are counted and listed") {
    const Run counted = run("member - bbb --count", choices);
    CHECK(counted.status == 0);
    CHECK(counted.out ==
          "yes: bbb is in the language, first in generation 3\n"
          "of 3 steps: 1 derivation\nof 4 steps: 1 derivation\nof 5 steps: 1 derivation\n"
          "of 6 steps: 1 derivation\nof 7 steps: 1 derivation\nof 8 steps: 1 derivation\n"
          "of 9 steps: 1 derivation\nof 10 steps: 1 derivation\nof 11 steps: 1 derivation\n"
          "of 12 steps: 1 derivation\n"
          "infinitely many derivations: there are some of infinitely many numbers of steps\n");
    const Run listed = run("member - aab --all", choices);
    CHECK(listed.out ==
          "yes: aab is in the language, first in generation 1\n"
          "of 1 step: 1 derivation\n"
          "derivation 1 of 1 step\n"
          "     0  ab\n"
          "        a -> aa\n"
          "     1  aab\n");
    const std::string branching = "printf 'axiom aa; a > a -> b | a; a -> a | b' |";
    const auto json = nlohmann::json::parse(run("member - bb --all -n 1..2 --json", branching).out);
    CHECK(json["member"] == true);
    CHECK(json["total"] == 5);
    CHECK(json["counts"] ==
          nlohmann::json::parse(R"([{"steps":1,"count":1},{"steps":2,"count":4}])"));
    CHECK(json["derivations"].size() == 5);
    CHECK(json["complete"] == true);
    const Run no = run("member - ba --count --json", choices);
    CHECK(no.status == 1);
    CHECK(nlohmann::json::parse(no.out)["total"] == 0);
}

TEST_CASE("a derivation of a word with context is drawn as a tree, its contexts as thin arcs") {
    const auto facts = nlohmann::json::parse(
        run("tree - --word abb --json -o /dev/null --format svg", choices).out);
    CHECK(facts["generation"] == 2);
    CHECK(facts["nodes"] == 8);
    CHECK(facts["contexts"] == 2);
    const Run no = run("tree - --word ba -o /dev/null --format svg", choices);
    CHECK(no.status == 2);
    CHECK(no.err.find("--word: ba is not in the language, `algae member` says why") !=
          std::string::npos);
}

TEST_CASE(
    "growth of a system with context and choices: lengths of all words, and whether they have a "
    "bound") {
    const Run rising = run("growth - -n 0..3", choices);
    CHECK(rising.status == 0);
    CHECK(rising.out.find("n = 0: 2..2, 1 word\nn = 1: 2..3, 2 words\nn = 2: 2..4, 3 words\n"
                          "n = 3: 2..5, 4 words\n") != std::string::npos);
    CHECK(rising.out.find("Lengths have no bound: L(A) is infinite") != std::string::npos);
    const auto bounded =
        nlohmann::json::parse(run("growth - --json", "printf 'axiom aab; a > b -> a | b' |").out);
    CHECK(bounded["class"] == "bounded");
    CHECK(bounded["generations"].size() == 11);
    CHECK(bounded["generations"][3]["words"] == 3);
    const std::string wide = "printf 'axiom aa; a > a -> ab | ba | aa; a -> a | aab' |";
    const auto cut = nlohmann::json::parse(run("growth - --json", wide).out);
    CHECK(cut["complete"] == false);
    const Run asked = run("growth - -n 0..30", wide);
    CHECK(asked.status == 3);
    CHECK(asked.err.find("has those before") != std::string::npos);
}
