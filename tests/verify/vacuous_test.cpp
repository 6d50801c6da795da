// Certificates whose proof says nothing: a case that is not one, a step that is left out, an induction without a step. What
// they say is false, and each would pass if one operator of the checker were another one.

#include <doctest/doctest.h>

#include <string>

#include "verify/samples.hpp"

using namespace samples;
using Outcome = algae::verify::Finding::Outcome;

namespace {

/// The reason for which a certificate is refused.
std::string refused(const Json& certificate) {
    const auto found = check(certificate)[0];
    CHECK(found.outcome == Outcome::wrong);
    return found.reason;
}

/// Says that a finite language is not of a family, by one case at the root.
std::string refused_cases(const char* family, const Json& words, const char* root) {
    const Json statement{{"is", family}, {"language", {{"words", words}}}};
    const Json proof{{"by", "cases"}, {"obstruction", {{"root", Json::parse(root)}}}};
    return refused(certificate(statement, "refuted", proof));
}

/// Says that two systems, with the tables given, have the same sequence.
std::string refused_balance(const char* left, const char* right, const char* proof,
                            const char* axiom = "a", const char* other_axiom = "a") {
    Json all = certificate({{"equal sequences", {"L", "R"}}}, "proved", Json::parse(proof));
    all["systems"] = {{"L", {{"axiom", axiom}, {"tables", {Json::parse(left)}}}},
                      {"R", {{"axiom", other_axiom}, {"tables", {Json::parse(right)}}}}};
    return refused(all);
}

}  // namespace

TEST_CASE("a letter that is said to have no image is one that has none left") {
    const char* const one_left = R"({"excluded": [], "end": "no image", "letter": "a"})";
    const char* const no_letter = R"({"excluded": [], "end": "no image", "letter": "b"})";
    CHECK(refused_cases("0L", {"a"}, one_left) == "a has an image left");
    CHECK(refused_cases("D0L", {"a", "a a"}, one_left) == "a has an image left");
    CHECK(refused_cases("0L", {"a"}, no_letter) == "b has an image left");
}

TEST_CASE(
    "words that are said not to be reached are not, in a deterministic step by several letters") {
    // The system a -> b, b -> a generates the language.
    const char* const apart =
        R"({"excluded": [], "end": "sources", "sources": [["a b"], ["b a"]]})";
    for (const char* const family : {"D0L", "PD0L", "0L", "P0L"}) {
        INFO(family);
        CHECK(refused_cases(family, {"a b", "b a"}, apart) == "ba may give ab");
    }
    // Two letters whose images differ, and one that comes twice.
    CHECK(
        refused_cases("PD0L", {"a b a", "b a b"},
                      R"({"excluded": [], "end": "sources", "sources": [["a b a"], ["b a b"]]})") ==
        "bab may give aba");
}

TEST_CASE("an induction about sequences has a step, from a beginning on that holds") {
    const char* const empty_only =
        R"({"by": "balance", "bound": 0, "states": [{"ahead": "left", "word": ""}]})";
    // The first step alone: a leads back, and b, which comes later, does not.
    const std::string leaves =
        "a word of the sequence does not lead through these overflows back to the empty one";
    CHECK(refused_balance(R"({"a": ["a b"], "b": ["a b"]})", R"({"a": ["a b"], "b": ["b a"]})",
                          empty_only) == leaves);
    // Neither leads back, already at the beginning.
    CHECK(refused_balance(R"({"a": ["a b"]})", R"({"a": ["b a"]})", empty_only) == leaves);
    // It leads to an overflow that is listed, and ends there.
    CHECK(refused_balance(R"({"a": ["a a"]})", R"({"a": ["a"]})",
                          R"({"by": "balance", "bound": 1, "states": [{"ahead": "left", "word": ""},
                              {"ahead": "left", "word": "a"}]})") == leaves);
    CHECK(refused_balance(R"({"a": ["a"]})", R"({"a": ["a"]})", empty_only, "a", "a a") ==
          "the axioms differ");
    // No state, one that is not the empty overflow, and steps that repeat nothing.
    const char *const longer = R"({"a": ["a a"]})", *const other = R"({"a": ["a"]})";
    CHECK(refused_balance(longer, other, R"({"by": "balance", "bound": 0, "states": []})") ==
          "the empty overflow is missing");
    CHECK(refused_balance(longer, other, R"({"by": "balance", "bound": 1,
                                             "states": [{"ahead": "left", "word": "a"}]})") ==
          "the first overflow is not empty");
    for (const char* const repeats :
         {R"({"steps": 0, "earlier": 0})", R"({"steps": 1, "earlier": 1})",
          R"({"steps": 1, "earlier": 2})"}) {
        const Json proof{{"by", "balance"},
                         {"bound", 0},
                         {"states", Json::array({{{"ahead", "left"}, {"word", ""}}})},
                         {"accepts", Json::parse(repeats)}};
        CHECK(refused_balance(other, other, proof.dump().c_str()) ==
              "nothing repeats before it begins");
    }
}
