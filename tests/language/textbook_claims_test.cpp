#include <doctest/doctest.h>

#include <nlohmann/json.hpp>
#include <set>

#include "exact/exact.hpp"
#include "language/language.hpp"
#include "model/model.hpp"
#include "notation/notation.hpp"
#include "verify/verify.hpp"

// Claims on all languages and systems that textbooks and forums make or ask, true and false and open, beside what is known of
// them. A true one may stay undecided; it is never refuted. An open one is undecided. A false one is refuted by
// a counterexample that is no larger than the known one, but where that is infinite.

using namespace algae;

namespace {

struct Known {
    const char* claim;
    enum { no, yes, open } holds;
    std::uint64_t size = 0;         // of the least counterexample
    const char* verdict = nullptr;  // where it is certain
};

const std::vector<Known> claims{
    {"for all 0L languages A, B: A | B is 0L", Known::no, 5},
    {"for all 0L languages A, B: A B is 0L", Known::no, 5},
    {"for all 0L languages A, B with A & B is not empty: A & B is 0L", Known::no, 6},
    {"for all D0L languages A and non-erasing morphisms h: h(A) is D0L", Known::no, 9},
    {"for all 0L languages A and letter-to-letter morphisms h: h(A) is 0L", Known::no, 9},
    {"for all finite languages A: A* is 0L", Known::no, 0},
    {"for all 0L languages A: A^R is 0L", Known::yes, 0, "proved"},
    {"for all finite languages A: A is 0L", Known::no, 0},
    {"for all finite languages A: A is E0L", Known::yes, 0, "proved"},
    {"for all context-free languages A: A is E0L", Known::yes, 0, "proved"},
    {"for all 0L languages A: A is D0L", Known::no, 6},
    {"for all DT0L languages A: A is D0L or A is 0L", Known::no, 9},
    {"for all 0L languages A: A | {ε} is 0L", Known::no, 8},
    {"for all 0L languages A, B over different letters: A | B is 0L", Known::no, 7},
    {"for all D0L systems G, H with L(G) == L(H): sequence(G) == sequence(H)", Known::no, 8},
    {"for all PD0L systems G with L(G) is infinite: growth(G) is strictly increasing", Known::no,
     6},
    {"for all D0L systems G with word(G, 1) begins with word(G, 0) and word(G, 1) != word(G, 0): "
     "L(G) is "
     "infinite",
     Known::no, 5},
    {"for all PD0L systems G with word(G, 1) begins with word(G, 0) and word(G, 1) != word(G, 0): "
     "L(G) is "
     "infinite",
     Known::yes, 0, "proved"},
    {"for all D0L systems G with growth(G) ~ exponential: L(G) is not context-free", Known::yes, 0,
     "proved"},
    {"for all T0L languages A, B: A & B is T0L or A & B is empty", Known::no, 6},
    // Its counterexamples are infinite, so none is found.
    {"for all 0L languages A: A* is 0L", Known::open},
    // The conjecture on 2n words, for two letters a theorem of Karhumäki.
    {"for all D0L systems G, H with word(G, 0) == word(H, 0) and word(G, 1) == word(H, 1) and "
     "word(G, 2) == "
     "word(H, 2) and word(G, 3) == word(H, 3): sequence(G) == sequence(H)",
     Known::open},
};

}  // namespace

TEST_CASE("claims of textbooks come out as is known, with counterexamples no larger") {
    std::size_t decided = 0;
    for (const Known& known : claims) {
        CAPTURE(known.claim);
        SearchLimits limits;
        limits.instances = 20'000;
        limits.size = known.holds == Known::no ? known.size : 6;
        const CheckedClaim checked = check(
            read_claim(std::string("claim T\ntheorem ") + known.claim, "x.claim", {}), {}, limits);
        const CheckedStatement& statement = checked.statements.at(0);
        const std::string verdict = verdict_text(statement);
        const auto finding =
            verify::check_certificate(certificate(checked).dump(1), "x.json", {}).at(0);
        using Outcome = verify::Finding::Outcome;
        if (known.verdict) CHECK(verdict == known.verdict);
        if (known.holds == Known::no) {
            CHECK(verdict == "refuted");
            REQUIRE(statement.answer.searched);
            CHECK(statement.answer.searched->size <= known.size);
            CHECK(statement.answer.searched->undecided == 0);
        } else {
            CHECK(verdict != "refuted");
        }
        if (known.holds == Known::open) CHECK(verdict == "undecided");
        CHECK(finding.outcome == (verdict == "undecided" ? Outcome::undecided : Outcome::checked));
        decided += verdict != "undecided";
    }
    MESSAGE(decided << " of " << claims.size() << " claims decided");
    CHECK(decided >= 20);
}

TEST_CASE("theorems on all D0L systems are refused where one of their conditions fails") {
    using Outcome = verify::Finding::Outcome;
    const auto outcome = [](const std::string& claim, const auto& change) {
        auto json = certificate(check(read_claim("claim T\ntheorem " + claim, "x.claim", {})));
        change(json.at("statements")[0].at("statement"));
        return verify::check_certificate(json.dump(), "x.json", {}).at(0).outcome;
    };
    const auto same = [](auto&) {};
    const std::string sparse =
        "for all D0L systems G with growth(G) ~ polynomial 2: L(G) is not regular";
    CHECK(outcome(sparse, same) == Outcome::checked);
    CHECK(outcome(sparse, [](auto& json) { json.at("with")[0]["degree"] = 1; }) == Outcome::wrong);
    CHECK(outcome(sparse, [](auto& json) {
              json.at("with")[0].erase("degree");
              json.at("with")[0]["class"] = "bounded";
          }) == Outcome::wrong);
    CHECK(outcome(sparse, [](auto& json) { json.at("for all")[0]["of"] = "0L systems"; }) ==
          Outcome::wrong);
    CHECK(outcome(sparse, [](auto& json) { json.at("holds").at("not")["is"] = "0L"; }) ==
          Outcome::wrong);
    const std::string longer =
        "for all PD0L systems G with word(G, 1) begins with word(G, 0) and word(G, 1) != word(G, "
        "0): L(G) is infinite";
    CHECK(outcome(longer, same) == Outcome::checked);
    CHECK(outcome(longer, [](auto& json) { json.at("for all")[0]["of"] = "D0L systems"; }) ==
          Outcome::wrong);
    CHECK(outcome(longer, [](auto& json) { json.at("with").erase(1); }) == Outcome::wrong);
    CHECK(outcome(longer, [](auto& json) {
              json.at("with")[0].at("words")[0][0]["generation"] = "2";
          }) == Outcome::wrong);
    CHECK(outcome(longer, [](auto& json) {
              json.at("holds") = {{"is", "finite"}, {"language", {{"generated", "G"}}}};
          }) == Outcome::wrong);
}

TEST_CASE("titles that are false are never printed as proved") {
    for (const char* text : {"claim P = NP\nshow a in {a}",
                             "claim Every word is a palindrome\nlet A = {a}\nshow a in A",
                             "claim 0L languages are closed under union\nlet A = {a}\nlet B = "
                             "{b}\nshow A | B is 0L\nclosed "
                             "under union: 0L"}) {
        CAPTURE(text);
        const CheckedClaim checked = check(read_claim(text, "x.claim", {}));
        CHECK(checked.verdict() != ClaimVerdict::proved);
        CHECK(explanation(checked).find(checked.claim.title + ": proved") == std::string::npos);
    }
}
