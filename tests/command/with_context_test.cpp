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
    CHECK(in.out == "yes: bbb is in L(A): ab => aab => abb => bbb.\n");
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
}
