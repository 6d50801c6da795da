#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <functional>
#include <map>
#include <nlohmann/json.hpp>

#include "exact/exact.hpp"
#include "language/language.hpp"
#include "model/model.hpp"
#include "notation/notation.hpp"
#include "verify/verify.hpp"

using namespace algae;

namespace {

struct Found {
    CheckedClaim checked;
    std::string verdict, values, other;
    verify::Finding finding;
};

std::string text(const std::vector<std::pair<std::string, std::string>>& values) {
    return joined(values, "; ", [](const auto& one) { return one.first + " = " + one.second; });
}

/// What is decided of a theorem, and what verify says of its certificate.
Found found(const std::string& theorem, const SearchLimits& limits = {}) {
    Found all{check(read_claim("claim T\ntheorem " + theorem, "x.claim", {}), {}, limits),
              {},
              {},
              {},
              {}};
    const CheckedStatement& statement = all.checked.statements.at(0);
    const Alphabet& alphabet = *all.checked.claim.alphabet;
    all.verdict = verdict_text(statement);
    all.values = text(witness_of(statement.answer, alphabet));
    all.other = text(witness_of(statement.answer, alphabet, true));
    all.finding = verify::check_certificate(
                      *verify::read_certificate(certificate(all.checked).dump(1), "x.json"), {})
                      .at(0);
    return all;
}

struct Known {
    const char* theorem;
    const char* values;
    std::uint64_t size;
    const char* other = "";
};

// Counterexamples and sizes are those of programs that share nothing with this one.
const std::vector<Known> false_claims{
    {"for all 0L languages A, B: A | B is 0L", "A = {a}; B = {aa}", 5},
    {"for all 0L languages A, B: A B is 0L", "A = {ε, a}; B = {a}", 5},
    {"for all P0L languages A, B: A B is P0L", "A = {a}; B = {a, bb}", 7},
    {"for all D0L languages A and non-erasing morphisms h: h(A) is D0L",
     "A = {a, b}; h = { a -> a; b -> aa }", 9},
    {"for all 0L languages A and letter-to-letter morphisms h: h(A) is 0L",
     "A = {a, ab}; h = { a -> a; b -> a }", 9},
    {"for all 0L languages A: A is D0L", "A = {ε, a, aa}", 6},
    {"for all 0L languages A with ε not in A: A is D0L", "A = {a, b, aa}", 7},
    {"for all DT0L languages A: A is D0L or A is 0L", "A = {ε, aaa, abb}", 9},
    {"for all 0L languages A: A | {ε} is 0L", "A = {aaa, abb}", 8},
    {"for all 0L languages A, B over different letters: A | B is 0L", "A = {aa}; B = {bbb}", 7},
    {"for all D0L systems G, H with L(G) == L(H): sequence(G) == sequence(H)",
     "G = the D0L system with axiom a; a -> b; b -> ε; H = the D0L system with axiom b; b -> a; a "
     "-> ε",
     8},
    {"for all PD0L systems G, H with L(G) == L(H): sequence(G) == sequence(H)",
     "G = the PD0L system with axiom a; a -> b; b -> a; H = the PD0L system with axiom b; b -> a; "
     "a -> b",
     10},
    {"for all T0L languages A, B with A & B is not empty: A & B is T0L", "A = {ε, a}; B = {ε, b}",
     6},
    {"for all P0L languages A and finite substitutions s: s(A) is P0L", "A = {a}; s = { a -> {ε} }",
     4, "A = {a}; s = { a -> {ε, a} }"},
    {"for all D0L languages A and morphisms h: h^-1(A) is D0L", "A = {a}; h = { x -> ε }", 3,
     "A = {aa}; h = { x -> a; y -> a }"},
    {"for all finite languages A: A is 0L", "A = {}", 0, "A = {a, aa}"},
};

}  // namespace

TEST_CASE("false claims have their least counterexamples, and verify checks these") {
    for (const Known& known : false_claims) {
        CAPTURE(known.theorem);
        const SearchLimits limits{20'000, 8};
        const Found one =
            found(known.theorem, known.size > 8 ? SearchLimits{20'000, known.size} : limits);
        CHECK(one.verdict == "refuted");
        CHECK(one.values == known.values);
        if (*known.other) CHECK(one.other == known.other);
        const auto& searched = one.checked.statements.at(0).answer.searched;
        REQUIRE(searched);
        CHECK(searched->undecided == 0);
        CHECK(searched->size == known.size);
        CHECK(one.finding.outcome == verify::Finding::Outcome::checked);
        CHECK(one.checked.verdict() == ClaimVerdict::refuted);
    }
}

TEST_CASE(
    "a false claim stands as a theorem behind not, and a true one about some is proved by an "
    "example") {
    CHECK(found("not for all 0L languages A, B: A | B is 0L").verdict == "proved");
    const Found some = found("for some finite language A: A is T0L and A is not 0L");
    CHECK(some.verdict == "proved");
    CHECK(some.values == "A = {ε, aaa, abb}");
    CHECK(some.finding.outcome == verify::Finding::Outcome::checked);
    CHECK(found("not for some finite language A: A is T0L and A is not 0L").verdict == "refuted");
}

TEST_CASE("a true claim without bounds is not proved by a search, and says how far that went") {
    const Found one = found("for all 0L languages A: A^R is 0L", {1000, 6});
    CHECK(one.verdict == "undecided");
    CHECK(one.checked.verdict() == ClaimVerdict::undecided);
    CHECK(
        one.checked.statements.at(0).answer.tried ==
        std::vector<std::string>{
            "No counterexample is among the first 121 instances with finite languages, up to size "
            "6, of which 108 meet the conditions; each of them is decided."});
    CHECK(one.finding.outcome == verify::Finding::Outcome::undecided);
    const Found few = found("for all 0L languages A: A^R is 0L", {50, 6});
    CHECK(few.checked.statements.at(0).answer.searched->visited == 50);
}

TEST_CASE("conditions that no instance meets make a claim vacuous, never proved") {
    const Found one = found("for all finite languages A with A is infinite: A is 0L", {1000, 6});
    CHECK(one.verdict == "vacuous");
    CHECK(one.checked.verdict() == ClaimVerdict::vacuous);
    // Infinite languages may meet this one.
    CHECK(found("for all 0L languages A with A is infinite: A is 0L", {1000, 6}).verdict ==
          "undecided");
}

TEST_CASE("a claim whose bounds leave finitely many instances is decided by all of them") {
    const Found one = found(
        "for all finite languages A with words up to length 1 over {a, b}: A | {ab} is T0L implies "
        "A is 0L");
    CHECK(one.verdict == "refuted");
    const Found two = found(
        "for all finite languages A with words up to length 2 over {a}: A is D0L implies A is 0L");
    CHECK(two.verdict == "proved");
    CHECK(two.checked.statements.at(0).answer.searched->visited == 8);
    CHECK(two.finding.outcome == verify::Finding::Outcome::not_checked);
}

TEST_CASE("bound words stand in words") {
    const Found one = found("for all 0L languages A and words w: {w} A is 0L");
    CHECK(one.verdict == "refuted");
    CHECK(one.values == "A = {ε, a}; w = a");
    CHECK(one.finding.outcome == verify::Finding::Outcome::checked);
    CHECK(found("for all words v up to length 2 over {a}: v v in /(aa)*/").verdict == "proved");
}

TEST_CASE("a statement that names letters is tried with instances over these letters too") {
    // No renaming of {b} contains a, so an instance with the letter a itself is needed.
    const Found one = found("for all finite languages A with a in A: A is 0L", {5000, 6});
    CHECK(one.verdict == "refuted");
    CHECK(one.values == "A = {a, aa}");
}

TEST_CASE("an undecided part decides nothing, and another part may decide the whole") {
    // Whether /a*/ is 0L is not decided without a witness.
    CHECK(found("{a} is 0L or /a*/ is 0L").verdict == "proved");
    CHECK(found("{a, aa} is 0L and /a*/ is 0L").verdict == "refuted");
    CHECK(found("{a} is 0L and /a*/ is 0L").verdict == "undecided");
    CHECK(found("{a, aa} is 0L implies /a*/ is 0L").verdict == "proved");
    CHECK(found("/a*/ is 0L implies {a} is 0L").verdict == "proved");
    CHECK(found("/a*/ is 0L iff {a} is 0L").verdict == "undecided");
}

TEST_CASE("joined statements have the truth that their parts give, and verify agrees") {
    CHECK(rc::check([] {
        static const std::vector<std::pair<std::string, Truth>> atoms{
            {"{a} is 0L", Truth::proved},
            {"{a, aa} is 0L", Truth::refuted},
            {"{a, aa} is not 0L", Truth::proved},
            {"{a} is not finite", Truth::refuted},
            {"/a*/ is 0L", Truth::undecided}};
        const auto and_of = [](Truth a, Truth b) {
            if (a == Truth::refuted || b == Truth::refuted) return Truth::refuted;
            return a == Truth::proved && b == Truth::proved ? Truth::proved : Truth::undecided;
        };
        struct Tree {
            std::string text;
            Truth truth;
        };
        const std::function<Tree(int)> make = [&](int depth) -> Tree {
            const int kind = depth == 0 ? 0 : *rc::gen::inRange(0, 6);
            if (kind == 0) {
                const auto& [text, truth] = *rc::gen::elementOf(atoms);
                return {text, truth};
            }
            const Tree left = make(depth - 1);
            if (kind == 5) return {"not (" + left.text + ")", opposite(left.truth)};
            const Tree right = make(depth - 1);
            const auto joint = [&](const char* word) {
                return "(" + left.text + ") " + word + " (" + right.text + ")";
            };
            if (kind == 1) return {joint("and"), and_of(left.truth, right.truth)};
            const Truth both_false = and_of(opposite(left.truth), opposite(right.truth));
            if (kind == 2) return {joint("or"), opposite(both_false)};
            const Truth forth = opposite(and_of(left.truth, opposite(right.truth)));
            if (kind == 3) return {joint("implies"), forth};
            const Truth back = opposite(and_of(right.truth, opposite(left.truth)));
            return {joint("iff"), and_of(forth, back)};
        };
        const Tree tree = make(3);
        const Found one = found(tree.text);
        RC_ASSERT(one.verdict == to_string(tree.truth));
        using Outcome = verify::Finding::Outcome;
        RC_ASSERT(one.finding.outcome ==
                  (tree.truth == Truth::undecided ? Outcome::undecided : Outcome::checked));
    }));
}

TEST_CASE("the verdict over bounded languages is that of a plain loop over all of them") {
    // Second route: the words up to length 2 over a, b are the bits of a number, and each set is asked for by itself.
    const std::vector<std::string> words{"ε", "a", "b", "aa", "ab", "ba", "bb"};
    const std::vector<std::string> families{"0L", "D0L", "P0L", "T0L", "PD0L"};
    std::map<std::string, std::vector<bool>> member;
    for (const std::string& family : families)
        for (unsigned bits = 0; bits < 128; ++bits) {
            std::vector<std::string> some;
            for (std::size_t i = 0; i < words.size(); ++i)
                if (bits >> i & 1) some.push_back(words[i]);
            const Claim claim =
                read_claim("claim T; show {" + joined(some, ", ") + "} is " + family, "x", {});
            member[family].push_back(check(claim).statements[0].answer.truth == Truth::proved);
        }
    std::size_t compared = 0;
    for (const std::string& left : families)
        for (const std::string& right : families) {
            if (left == right) continue;
            bool holds = true;
            for (unsigned bits = 0; bits < 128; ++bits)
                holds = holds && (!member[left][bits] || member[right][bits]);
            const std::string over = " with words up to length 2 over {a, b}: A is ";
            const Found all =
                found("for all finite languages A" + over + left + " implies A is " + right);
            CHECK(all.verdict == (holds ? "proved" : "refuted"));
            const Found some =
                found("for some finite language A" + over + left + " and A is not " + right);
            CHECK(some.verdict == (holds ? "refuted" : "proved"));
            ++compared;
        }
    CHECK(compared == 20);
}
