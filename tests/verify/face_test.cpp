// What certificates alone do not show: how definitions and proofs by cases are written, values that compare, and bounds on what
// terms and figures take.

#include <doctest/doctest.h>

#include <chrono>
#include <memory>
#include <string>
#include <vector>

#include "exact/exact.hpp"
#include "verify/samples.hpp"
#include "verify/verify.hpp"

using namespace algae;
using samples::Json;
using Outcome = verify::Finding::Outcome;

namespace {

std::vector<std::string> definitions_of(const Json& certificate) {
    std::vector<std::string> lines;
    const std::string text = certificate.dump();
    verify::check_certificate(
        verify::source_of(text), "x.json", {},
        {.on_start = [&](const auto& read) { lines = verify::definitions(read); }});
    return lines;
}

Json without_statements(const Json& alphabet, const Json& systems) {
    return {{"format", "algae certificate 1"},
            {"claim", "nothing"},
            {"alphabet", alphabet},
            {"systems", systems},
            {"statements", Json::array()}};
}

/// What is found of a comparison of numbers.
verify::Finding compared(const std::string& left, const std::string& right,
                         const Budget& budget = {}) {
    const Json numbers{{"numbers", {left, "=", right}}};
    return samples::check(samples::certificate(numbers, "proved", {{"by", "values"}}), budget)
        .at(0);
}

/// A text so many times, with another one between.
std::string repeated(const std::string& text, std::size_t times, const std::string& between) {
    std::string all = text;
    for (std::size_t i = 1; i < times; ++i) all += between + text;
    return all;
}

}  // namespace

TEST_CASE("the definitions of a certificate without turtles are its letters and systems") {
    const Json systems = Json::parse(R"({
      "C": {"axiom": "a b", "rules": [
        {"left": "", "letter": "a", "right": "", "successor": "b"},
        {"left": "b", "letter": "a", "right": "", "successor": ""},
        {"left": "", "letter": "b", "right": "a long", "successor": "a"},
        {"left": "a b", "letter": "b", "right": "b", "successor": "b"}]},
      "G": {"axiom": "a", "tables": [{"a": ["a b", "b"], "long": [""]}]},
      "M": {"axiom": [["a"]], "modules": [{"module": ["a"], "successor": [], "elsewhere": [["b"], ["c", "x"]]}]},
      "T": {"axiom": "", "tables": [{"b": ["a", "b", "b b"]}, {}]},
      "k-1.2": {"axiom": "a", "tables": [{"a": ["b"]}]},
      "k 1": {"axiom": "a", "tables": [{"a": ["b"]}]}
    })");
    CHECK(definitions_of(without_statements({"a", "b", "long"}, systems)) ==
          std::vector<std::string>{
              "letters a b 'long'",
              "C: axiom ab; a -> b; b < a -> ε; b > a'long' -> a; ab < b > b -> b",
              "G: axiom a; a -> ab | b; 'long' -> ε", "T: axiom ε; table; b -> a | b | bb; table",
              "'k 1': axiom a; a -> b", "k-1.2: axiom a; a -> b",
              "M: axiom a; a elsewhere bc(x) -> ε"});
    CHECK(definitions_of(without_statements(Json::array(), Json::object())) ==
          std::vector<std::string>{"no letters"});
    CHECK(definitions_of(without_statements({"b"}, Json::object())) ==
          std::vector<std::string>{"letters b"});
}

TEST_CASE("the definitions tell the parts of a turn that a turtle makes, below a full one") {
    Json certificate = without_statements(
        {"a"}, {{"X", {{"axiom", "a"}, {"tables", Json::array({Json::object()})}}}});
    certificate.erase("statements");
    certificate["turtles"] = Json::parse(R"({"X": {"turn": "5/4", "heading": "-1/3", "spin": "7/3",
                                                   "letters": {"a": "F"}}})");
    certificate["statements"] = Json::array();
    CHECK(definitions_of(certificate).back() ==
          "the turtle of X: turns by 1/4 of a full turn, starts at 2/3 of it, for each generation "
          "1/3 more; a does F");
}

TEST_CASE("a proof by cases is written with the fields that its ends have, and read as it was") {
    FamilyObstruction proof;
    proof.language = finite_language({"a", "ab"});
    ObstructionCase none;
    none.letter = 1;
    ObstructionCase needed;
    needed.end = ObstructionCase::End::needed;
    needed.excluded = {{{0, {1}}, {0, 1}, {{1}, {}}}, {{1, {}}, {0}, {}}};
    ObstructionCase choice;
    choice.end = ObstructionCase::End::choice;
    choice.letter = 1;
    choice.rules = {{1, {0, 1}}};
    choice.cases = {none};
    proof.root.end = ObstructionCase::End::conflict;
    proof.root.word = {0, 1};
    proof.root.images = {{1}, {}};
    proof.root.rules = {{0, {1}}, {1, {}}};
    proof.root.cases = {needed, choice};
    const Json root =
        Json::parse(R"({"excluded": [], "end": "conflict", "word": "a b", "images": ["b", ""],
      "rules": [{"letter": "a", "image": "b"}, {"letter": "b", "image": ""}],
      "cases": [{"excluded": [{"letter": "a", "image": "b", "word": "a b", "images": ["b", ""]},
                              {"letter": "b", "image": "", "word": "a"}],
                 "end": "needed"},
                {"excluded": [], "end": "choice", "letter": "b",
                 "rules": [{"letter": "b", "image": "a b"}],
                 "cases": [{"excluded": [], "end": "no image", "letter": "b"}]}]})");
    CHECK(to_json(proof) == Json{{"root", root}});
    ObstructionCase sources;
    sources.end = ObstructionCase::End::sources;
    sources.sources = {{{0}}, {{0, 1}, {}}};
    proof.root = sources;
    proof.impossible = {{{{0, {}}}, needed}};
    const Json written = to_json(proof);
    CHECK(written["root"] == Json::parse(R"({"excluded": [], "end": "sources",
                                             "sources": [["a"], ["a b", ""]]})"));
    CHECK(written["impossible"] ==
          Json::array({{{"rules", Json::parse(R"([{"letter": "a", "image": ""}])")},
                        {"why", root["cases"][0]}}}));
}

TEST_CASE("words of a finite language are written with commas between") {
    CHECK(to_string(finite_language({"a", "b"})) == "{a, b}");
    CHECK(to_string(finite_language({"a", "b", "ab"})) == "{a, b, ab}");
}

TEST_CASE("finite languages are the same if their letters and words are") {
    const FiniteLanguage one = finite_language({"a", "ab"});
    CHECK(one == finite_language({"ab", "a"}));
    CHECK(!(one == finite_language({"a", "b", "ab"})));  // the same letters
    CHECK(!(one == finite_language({"c", "cd"})));       // the same numbers of symbols
}

TEST_CASE("families, terms and values of JSON begin as the plainest ones") {
    CHECK(to_string(Family{}) == "0L");
    CHECK(to_string(Family{.propagating = true}) == "P0L");
    CHECK(to_string(Family{.deterministic = true}) == "D0L");
    CHECK(to_string(Family{.tables = true}) == "T0L");
    const verify::Powers::Term term;
    CHECK(term.coefficient == 1);
    CHECK(term.number == 0);
    CHECK(term.power == 0);
    CHECK(term.base == 1);
    CHECK(verify::JsonValue{}.line == 0);
}

TEST_CASE("modules are in the order of their letters, then of their numbers") {
    const auto number = [](long value) { return QuadraticNumber{Rational(Integer(value)), 0, 1}; };
    const verify::Module a{"a", {number(2)}}, b{"b", {number(1)}};
    CHECK(a < b);
    CHECK(!(b < a));
    CHECK(!(a < a));
    CHECK(verify::Module{"a", {}} < a);
    CHECK(verify::Module{"a", {number(1), number(9)}} < a);
    CHECK(!(a < verify::Module{"a", {number(1), number(9)}}));
}

TEST_CASE("terms have 10000 operations and no more, and the product that is last counts") {
    const std::string ones = repeated("1", 137, "*");  // 136 operations
    const std::string product = repeated("(" + ones + ")", 73, "*"), sum = repeated(ones, 73, "+");
    CHECK(compared(product, "1").outcome == Outcome::checked);  // 136 * 73 + 72 are 10000
    CHECK(compared(sum, "73").outcome == Outcome::checked);
    for (const std::string& longer : {product + "*1", sum + "*1", sum + "+1", sum + "/1"}) {
        const verify::Finding found = compared(longer, "1");
        CHECK(found.outcome == Outcome::not_checked);
        CHECK_MESSAGE(found.reason.ends_with(": a term of more than 10000 parts"), found.reason);
    }
}

TEST_CASE("a figure of more segments than the memory holds is not checked") {
    Json certificate = samples::certificate(
        Json::parse(R"J({"numbers": ["distinct segments(L, 3)", "=", "8000"]})J"), "proved",
        Json::parse(R"({"by": "values"})"));
    certificate.erase("statements");
    const std::string twenty = repeated("a", 20, " ");
    certificate["systems"] = {
        {"L", {{"axiom", "a"}, {"tables", Json::array({{{"a", {twenty}}}})}}}};
    certificate["turtles"] = Json::parse(R"({"L": {"turn": "1/2", "letters": {"a": "F"}}})");
    certificate["statements"] = samples::certificate(
        Json::parse(R"J({"numbers": ["distinct segments(L, 3)", "=", "8000"]})J"), "proved",
        Json::parse(R"({"by": "values"})"))["statements"];
    CHECK(samples::check(certificate, Budget{}).at(0).outcome == Outcome::checked);
    Budget small;
    small.memory = 1 << 20;
    const verify::Finding found = samples::check(certificate, small).at(0);
    CHECK(found.outcome == Outcome::not_checked);
    CHECK_MESSAGE(found.reason.starts_with("the segments of a figure would take more than"),
                  found.reason);
}

TEST_CASE("if the time is over while a system is seen to be finite, nothing is judged") {
    const Json statement = Json::parse(
        R"({"is": "E0L", "language": {"intersection": [{"generated": "W"}, {"generated": "C"}]}})");
    const Json certificate =
        samples::certificate(statement, "proved", Json::parse(R"({"by": "closed"})"));
    CHECK(samples::check(certificate).at(0).outcome == Outcome::checked);
    Budget budget;
    budget.deadline = std::chrono::steady_clock::now();
    const verify::Finding found = samples::check(certificate, budget).at(0);
    CHECK(found.outcome == Outcome::not_checked);
    CHECK(found.reason == "the time allowed is over");
}
