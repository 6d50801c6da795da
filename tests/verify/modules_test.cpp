// Certificates about systems whose words are derived module by module.
#include <doctest/doctest.h>

#include "exact/exact.hpp"
#include "verify/samples.hpp"

using namespace samples;
using Outcome = algae::verify::Finding::Outcome;

namespace {

/// b waits with 1/3, or becomes ab; A counts up to 3 and halves from there on; C looks around.
Json module_systems() {
    return Json::parse(R"({
      "S": {"axiom": [["b"]], "modules": [
        {"module": ["b"], "probability": "1/3", "successor": [["b"]]},
        {"module": ["b"], "probability": "2/3", "successor": [["a"], ["b"]]}]},
      "A": {"axiom": [["A", "1"]], "modules": [
        {"module": ["A", "x"], "condition": {"apply": "<", "to": [{"parameter": "x"}, "3"]},
         "successor": [["A", {"apply": "+", "to": [{"parameter": "x"}, "1"]}], ["B"]]},
        {"module": ["A", "x"], "condition": {"apply": ">=", "to": [{"parameter": "x"}, "3"]},
         "successor": [["A", {"apply": "/", "to": [{"parameter": "x"}, "7"]}]]}]},
      "C": {"axiom": [["b"]], "modules": [{"module": ["b"], "left": [["a"]], "successor": []}]},
      "D": {"axiom": [["b"]], "modules": [
        {"module": ["b"], "successor": [["a"]]}, {"module": ["b"], "successor": []}]},
      "F": {"axiom": [["A", "1"]], "modules": [
        {"module": ["A", "x"], "successor": [["A", {"apply": "sin", "to": [{"parameter": "x"}]}]]}]},
      "Z": {"axiom": [["A", "0"]], "modules": [
        {"module": ["A", "x"], "successor": [["A", {"apply": "/", "to": ["1", {"parameter": "x"}]}]]}]}
    })");
}

Json certificate_of(const std::string& statement, const char* verdict = "proved") {
    Json made = certificate(Json::parse(statement), verdict, Json{{"by", "rewriting"}});
    made["systems"] = module_systems();
    return made;
}

algae::verify::Finding found(const std::string& statement, const char* verdict = "proved") {
    return check(certificate_of(statement, verdict)).front();
}

std::string refused(const Json& certificate) {
    try {
        check(certificate);
    } catch (const algae::Error& error) {
        return error.what();
    }
    return {};
}

}  // namespace

TEST_CASE("probabilities are worked out again") {
    const std::string ab =
        R"({"derives": [["a"], ["b"]], "system": "S", "steps": 2, "probability": )";
    CHECK(found(ab + R"("4/9"})").outcome == Outcome::checked);
    CHECK(found(ab + R"("1/9"})", "refuted").outcome == Outcome::checked);
    const auto wrong = found(ab + R"("1/9"})");
    CHECK(wrong.outcome == Outcome::wrong);
    CHECK(wrong.reason == "the word has the probability 4/9");
    CHECK(wrong.path == "statements[0].proof");
    CHECK(found(ab + R"("4/9"})", "refuted").outcome == Outcome::wrong);
    CHECK(found(ab + R"("4/9"})").statement == "S derives ab in 2 steps with the probability 4/9");
    CHECK(
        found(
            R"({"derives": [["b"]], "system": "S", "from": [["b"], ["b"]], "steps": 3, "probability": "0"})")
            .outcome == Outcome::checked);
    CHECK(
        found(
            R"({"derives": [["b"], ["b"]], "system": "S", "from": [["b"], ["b"]], "steps": 3, "probability": "1/729"})")
            .outcome == Outcome::checked);
}

TEST_CASE("derivations with parameters are worked out again") {
    CHECK(found(R"({"derives": [["A", "3"], ["B"], ["B"]], "system": "A", "steps": 2})").outcome ==
          Outcome::checked);
    CHECK(
        found(R"({"derives": [["A", "3/7"], ["B"], ["B"]], "system": "A", "steps": 3})").outcome ==
        Outcome::checked);
    const auto wrong =
        found(R"({"derives": [["A", "0.42857"], ["B"], ["B"]], "system": "A", "steps": 3})");
    CHECK(wrong.outcome == Outcome::wrong);
    CHECK(wrong.reason == "the word has the probability 0");
    CHECK(found(R"({"derives": [["A", "3"]], "system": "A", "steps": 2})", "refuted").outcome ==
          Outcome::checked);
    CHECK(found(R"({"not": {"derives": [["A", "3"]], "system": "A", "steps": 2}})").outcome ==
          Outcome::checked);
}

TEST_CASE("contexts are matched again") {
    CHECK(found(R"({"derives": [["b"]], "system": "C", "steps": 1})").outcome == Outcome::checked);
    CHECK(found(R"({"derives": [["a"]], "system": "C", "from": [["a"], ["b"]], "steps": 1})")
              .outcome == Outcome::checked);
    CHECK(found(R"({"derives": [["a"], ["b"]], "system": "C", "from": [["a"], ["b"]], "steps": 1})")
              .outcome == Outcome::wrong);
}

TEST_CASE("what is not worked out again is said to be not checked") {
    const auto sine = found(R"({"derives": [["A", "0"]], "system": "F", "steps": 1})");
    CHECK(sine.outcome == Outcome::not_checked);
    CHECK(sine.reason == "'sin' is not worked out again");
    CHECK(found(R"({"derives": [["b"]], "system": "S", "steps": 5000})").outcome ==
          Outcome::not_checked);
}

TEST_CASE("rules that leave a choice, and values that do not exist, are no proof") {
    CHECK(found(R"({"derives": [["a"]], "system": "D", "steps": 1})").reason ==
          "the rules for a module b have the sum 2 of probabilities");
    CHECK(found(R"({"derives": [["A", "0"]], "system": "Z", "steps": 1})").reason ==
          "a division by 0 has no value");
}

TEST_CASE("what is no certificate is refused") {
    const std::string b = R"({"derives": [["b"]], "system": "S", "steps": 1)";
    CHECK(refused(certificate_of(b + R"(, "probability": "x"})"))
              .find("expected a probability, found 'x'") != std::string::npos);
    CHECK(
        refused(certificate_of(b + R"(, "probability": "1/0"})")).find("expected a probability") !=
        std::string::npos);
    CHECK(refused(certificate_of(b + R"(, "more": 1})")).find("more") != std::string::npos);
    CHECK(refused(certificate_of(R"({"derives": [["b", "x"]], "system": "S", "steps": 1})"))
              .find("expected a number, found 'x'") != std::string::npos);
    CHECK(refused(certificate_of(R"({"derives": [[]], "system": "S", "steps": 1})"))
              .find("a module must have a letter") != std::string::npos);
    CHECK(!refused(certificate_of(R"({"derives": [["b"]], "system": "S"})")).empty());
    Json other = certificate_of(b + "}");
    other["statements"][0]["proof"]["by"] = "derivation";
    CHECK(check(other)[0].outcome == Outcome::wrong);
}
