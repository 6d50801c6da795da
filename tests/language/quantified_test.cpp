#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

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
Found judged(const std::string& theorem, const SearchLimits& limits = {}) {
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
    all.finding = verify::check_certificate(certificate(all.checked).dump(1), "x.json", {}).at(0);
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
     "G = the PD0L system with axiom a; a -> b; b -> a; H = the PD0L system with axiom a; a -> b",
     10},
    {"for all T0L languages A, B with A & B is not empty: A & B is T0L", "A = {ε, a}; B = {ε, b}",
     6},
    {"for all P0L languages A and finite substitutions s: s(A) is P0L", "A = {a}; s = { a -> {ε} }",
     3, "A = {a}; s = { a -> {ε, a} }"},
    {"for all D0L languages A and morphisms h: h^-1(A) is D0L", "A = {a}; h = { x -> ε }", 3,
     "A = {ε, a}; h = { x -> ε }"},
    {"for all finite languages A: A is 0L", "A = {}", 0, "A = {a, aa}"},
};

}  // namespace

TEST_CASE("false claims have their least counterexamples, and verify checks these") {
    for (const Known& known : false_claims) {
        CAPTURE(known.theorem);
        const SearchLimits limits{20'000, 8};
        const Found one =
            judged(known.theorem, known.size > 8 ? SearchLimits{20'000, known.size} : limits);
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
    CHECK(judged("not for all 0L languages A, B: A | B is 0L").verdict == "proved");
    const Found some = judged("for some finite language A: A is T0L and A is not 0L");
    CHECK(some.verdict == "proved");
    CHECK(some.values == "A = {ε, aaa, abb}");
    CHECK(some.finding.outcome == verify::Finding::Outcome::checked);
    CHECK(judged("not for some finite language A: A is T0L and A is not 0L").verdict == "refuted");
}

TEST_CASE("a true claim without bounds is not proved by a search, and says how far that went") {
    const Found one = judged("for all 0L languages A: A | A is 0L", {1000, 6});
    CHECK(one.verdict == "undecided");
    CHECK(one.checked.verdict() == ClaimVerdict::undecided);
    CHECK(
        one.checked.statements.at(0).answer.tried ==
        std::vector<std::string>{
            "No counterexample is among the first 137 instances with finite languages, up to size "
            "6, of which 130 meet the conditions; each of them is decided."});
    CHECK(one.finding.outcome == verify::Finding::Outcome::undecided);
    const Found few = judged("for all 0L languages A: A | A is 0L", {50, 6});
    CHECK(few.checked.statements.at(0).answer.searched->visited == 50);
}

TEST_CASE("conditions that no instance meets make a claim vacuous, never proved") {
    const Found one = judged("for all finite languages A with A is infinite: A is 0L", {1000, 6});
    CHECK(one.verdict == "vacuous");
    CHECK(one.checked.verdict() == ClaimVerdict::vacuous);
    // Infinite languages may meet this one.
    CHECK(judged("for all 0L languages A with A is infinite: A is D0L", {1000, 6}).verdict ==
          "undecided");
}

TEST_CASE("a claim whose bounds leave finitely many instances is decided by all of them") {
    const Found one = judged(
        "for all finite languages A with words up to length 1 over {a, b}: A | {ab} is T0L implies "
        "A is 0L");
    CHECK(one.verdict == "refuted");
    const Found two = judged(
        "for all finite languages A with words up to length 2 over {a}: A is D0L implies A is 0L");
    CHECK(two.verdict == "proved");
    CHECK(two.checked.statements.at(0).answer.searched->visited == 8);
    CHECK(two.finding.outcome == verify::Finding::Outcome::checked);
}

TEST_CASE("a morphism without an image for a letter of the language is no instance") {
    const Found named = judged("for all morphisms h: h({a}) is 0L", {500, 4});
    CHECK(named.verdict == "undecided");
    CHECK(named.finding.outcome == verify::Finding::Outcome::undecided);
    nlohmann::ordered_json written = certificate(
        judged("for all D0L languages A and non-erasing morphisms h: h(A) is D0L", {20'000, 9})
            .checked);
    written["statements"][0]["proof"]["values"]["h"].erase("b");
    CHECK(verify::check_certificate(written.dump(1), "x.json", {}).at(0).outcome ==
          verify::Finding::Outcome::wrong);
}

TEST_CASE("bound words stand in words") {
    const Found one = judged("for all 0L languages A and words w: {w} A is 0L");
    CHECK(one.verdict == "refuted");
    CHECK(one.values == "A = {ε, a}; w = a");
    CHECK(one.finding.outcome == verify::Finding::Outcome::checked);
    CHECK(judged("for all words v up to length 2 over {a}: v v in /(aa)*/").verdict == "proved");
}

TEST_CASE("a statement that names letters is tried with instances over these letters too") {
    // No renaming of {b} contains a, so an instance with the letter a itself is needed.
    const Found one = judged("for all finite languages A with a in A: A is 0L", {5000, 6});
    CHECK(one.verdict == "refuted");
    CHECK(one.values == "A = {a, aa}");
}

TEST_CASE("an undecided part decides nothing, and another part may decide the whole") {
    // Whether the star is 0L is not decided.
    CHECK(judged("{a} is 0L or {b a^(2^n) : n >= 0}* is 0L").verdict == "proved");
    CHECK(judged("{a, aa} is 0L and {b a^(2^n) : n >= 0}* is 0L").verdict == "refuted");
    CHECK(judged("{a} is 0L and {b a^(2^n) : n >= 0}* is 0L").verdict == "undecided");
    CHECK(judged("{a, aa} is 0L implies {b a^(2^n) : n >= 0}* is 0L").verdict == "proved");
    CHECK(judged("{b a^(2^n) : n >= 0}* is 0L implies {a} is 0L").verdict == "proved");
    CHECK(judged("{b a^(2^n) : n >= 0}* is 0L iff {a} is 0L").verdict == "undecided");
}

TEST_CASE("joined statements have the truth that their parts give, and verify agrees") {
    CHECK(rc::check([] {
        static const std::vector<std::pair<std::string, Truth>> atoms{
            {"{a} is 0L", Truth::proved},
            {"{a, aa} is 0L", Truth::refuted},
            {"{a, aa} is not 0L", Truth::proved},
            {"{a} is not finite", Truth::refuted},
            {"{b a^(2^n) : n >= 0}* is 0L", Truth::undecided}};
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
        const Found one = judged(tree.text);
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
                judged("for all finite languages A" + over + left + " implies A is " + right);
            CHECK(all.verdict == (holds ? "proved" : "refuted"));
            const Found some =
                judged("for some finite language A" + over + left + " and A is not " + right);
            CHECK(some.verdict == (holds ? "refuted" : "proved"));
            CHECK(all.finding.outcome == verify::Finding::Outcome::checked);
            CHECK(some.finding.outcome == verify::Finding::Outcome::checked);
            ++compared;
        }
    CHECK(compared == 20);
}

TEST_CASE("identities are proved with letters for names, families by their forms and reversal") {
    using Outcome = verify::Finding::Outcome;
    for (const char* statement :
         {"for all languages A, B: (A | B)* == (A* B*)*", "for all languages A: A* A* == A*",
          "for all languages A, B: (A B)^R == B^R A^R", "for all languages A, B: A <= A | B",
          "for all 0L languages A and languages B: A (B A)* == (A B)* A",
          "for all languages A: {ab} (A^R)* == {ab} (A*)^R", "for all 0L languages A: A^R is 0L",
          "for all PD0L languages A: A is 0L", "for all D0L languages A: A^R is ET0L",
          "for all finite languages A: A is E0L",
          "for all regular languages A: A^R is context-free",
          "for all context-free languages A: A is E0L",
          "for all regular languages A: A^R is ET0L"}) {
        CAPTURE(statement);
        const Found one = judged(statement, {200, 5});
        CHECK(one.verdict == "proved");
        CHECK(one.finding.outcome == Outcome::checked);
        CHECK(one.checked.verdict() == ClaimVerdict::proved);
    }
    for (const char* statement :
         {"for all languages A, B: A B == B A", "for all languages A, B: (A | B)* == A* | B*",
          "for all languages A: A == A^R", "for all languages A, B: A | B <= A",
          "for all 0L languages A: A is PD0L"})
        CHECK_MESSAGE(judged(statement, {500, 6}).verdict == "refuted", statement);
    // True, but not by these methods.
    for (const char* statement :
         {"for all languages A, B: A & B <= A", "for all 0L languages A: A is IL"})
        CHECK_MESSAGE(judged(statement, {100, 4}).verdict == "undecided", statement);
}

TEST_CASE("identities over names hold or fail as they do for words of short languages") {
    // Second route: the identity is tried on all pairs of sets of words up to length 1 over a, b, as sets of words.
    using Words = std::set<std::string>;
    const auto product = [](const Words& left, const Words& right) {
        Words all;
        for (const std::string& u : left)
            for (const std::string& v : right)
                if (u.size() + v.size() <= 6) all.insert(u + v);
        return all;
    };
    std::size_t proved = 0, refuted = 0;
    CHECK(rc::check([&] {
        struct Tree {
            std::string text;
            std::function<Words(const Words&, const Words&)> value;
        };
        const std::function<Tree(int)> make = [&](int depth) -> Tree {
            const int kind = *rc::gen::inRange(0, depth == 0 ? 2 : 6);
            if (kind == 0) return {"A", [](const Words& a, const Words&) { return a; }};
            if (kind == 1) return {"B", [](const Words&, const Words& b) { return b; }};
            const Tree left = make(depth - 1);
            if (kind == 2)
                return {"(" + left.text + ")^R", [left](const Words& a, const Words& b) {
                            Words all;
                            for (const std::string& word : left.value(a, b))
                                all.insert({word.rbegin(), word.rend()});
                            return all;
                        }};
            const Tree right = make(depth - 1);
            if (kind == 3)
                return {"(" + left.text + " | " + right.text + ")",
                        [left, right](const Words& a, const Words& b) {
                            Words all = left.value(a, b);
                            all.merge(right.value(a, b));
                            return all;
                        }};
            return {"(" + left.text + " . " + right.text + ")",
                    [left, right, product](const Words& a, const Words& b) {
                        return product(left.value(a, b), right.value(a, b));
                    }};
        };
        const Tree left = make(2), right = make(2);
        const Found one =
            judged("for all languages A, B: " + left.text + " == " + right.text, {300, 5});
        const std::vector<std::string> words{"", "a", "b", "ab"};
        bool holds = true;
        for (unsigned a = 0; a < 16 && holds; ++a)
            for (unsigned b = 0; b < 16 && holds; ++b) {
                Words some, others;
                for (std::size_t i = 0; i < words.size(); ++i) {
                    if (a >> i & 1) some.insert(words[i]);
                    if (b >> i & 1) others.insert(words[i]);
                }
                holds = left.value(some, others) == right.value(some, others);
            }
        if (one.verdict == "proved") {
            ++proved;
            RC_ASSERT(holds);
        }
        if (!holds) {
            ++refuted;
            RC_ASSERT(one.verdict != "proved");
        }
        RC_ASSERT(one.finding.outcome != verify::Finding::Outcome::wrong);
    }));
    CHECK(proved >= 5);
    CHECK(refuted >= 20);
}

TEST_CASE("a certificate of an instance that was changed is wrong") {
    using Outcome = verify::Finding::Outcome;
    using nlohmann::ordered_json;
    const auto outcome = [](const std::string& theorem,
                            const std::function<void(ordered_json&)>& change) {
        const Found one = judged(theorem, {20'000, 8});
        ordered_json written = certificate(one.checked);
        change(written["statements"][0]);
        try {
            return verify::check_certificate(written.dump(1), "x.json", {}).at(0).outcome;
        } catch (const Error&) {
            return Outcome::wrong;  // not even well formed
        }
    };
    const std::string both = "for all 0L languages A, B: A | B is 0L";
    CHECK(outcome(both, [](ordered_json&) {}) == Outcome::checked);
    CHECK(outcome(both, [](ordered_json& s) { s["proof"]["values"]["B"]["words"][0] = "b"; }) ==
          Outcome::wrong);
    CHECK(outcome(both, [](ordered_json& s) { s["proof"]["values"].erase("B"); }) ==
          Outcome::wrong);
    CHECK(outcome(both, [](ordered_json& s) { s["proof"]["members"].erase(1); }) == Outcome::wrong);
    CHECK(outcome(both, [](ordered_json& s) { s["proof"].erase("members"); }) == Outcome::wrong);
    CHECK(outcome(both, [](ordered_json& s) { s["verdict"] = "proved"; }) == Outcome::wrong);
    CHECK(outcome(both, [](ordered_json& s) { s["statement"]["different letters"] = true; }) ==
          Outcome::wrong);
    CHECK(outcome(both, [](ordered_json& s) { s["statement"]["over"] = "b"; }) == Outcome::wrong);
    CHECK(outcome(both, [](ordered_json& s) { s["statement"]["for all"][1]["length"] = 1; }) ==
          Outcome::wrong);
    CHECK(outcome(both, [](ordered_json& s) { s["statement"]["for all"][1]["size"] = 2; }) ==
          Outcome::wrong);
    CHECK(outcome(both, [](ordered_json& s) {
              s["statement"]["for all"][1]["of"] = "P0L systems";
          }) == Outcome::wrong);
    const std::string coded = "for all 0L languages A and codings h: h(A) is 0L";
    CHECK(outcome(coded, [](ordered_json&) {}) == Outcome::undecided);  // needs size 9
    const std::string mapped = "for all D0L languages A and morphisms h: h^-1(A) is D0L";
    CHECK(outcome(mapped, [](ordered_json&) {}) == Outcome::checked);
    CHECK(outcome(mapped, [](ordered_json& s) {
              s["statement"]["for all"][1]["of"] = "non-erasing morphisms";
          }) == Outcome::wrong);
    const std::string identity = "for all languages A, B: A (B A)* == (A B)* A";
    CHECK(outcome(identity, [](ordered_json&) {}) == Outcome::checked);
    CHECK(outcome(identity, [](ordered_json& s) { s["proof"]["letters"]["B"] = "a"; }) ==
          Outcome::wrong);
    CHECK(outcome(identity, [](ordered_json& s) { s["proof"]["letters"].erase("B"); }) ==
          Outcome::wrong);
    CHECK(outcome(identity, [](ordered_json& s) {
              s["statement"]["holds"]["equal"][1] =
                  s["statement"]["holds"]["equal"][0]["concatenation"][0];
          }) == Outcome::wrong);
    const std::string reversed = "for all 0L languages A: A^R is 0L";
    CHECK(outcome(reversed, [](ordered_json&) {}) == Outcome::checked);
    for (const char* family : {"D0L", "P0L", "PD0L"})
        CHECK(outcome(reversed, [&](ordered_json& s) { s["statement"]["holds"]["is"] = family; }) ==
              Outcome::wrong);
    CHECK(outcome(reversed, [&](ordered_json& s) {
              s["statement"]["for all"][0]["of"] = "T0L languages";
          }) == Outcome::wrong);
    CHECK(outcome(reversed, [&](ordered_json& s) { s["verdict"] = "refuted"; }) == Outcome::wrong);
    const std::string joint = "{a} is 0L and {a, aa} is not 0L";
    CHECK(outcome(joint, [](ordered_json& s) { s["proof"]["parts"].erase(1); }) == Outcome::wrong);
    CHECK(outcome(joint, [](ordered_json& s) { s["proof"]["parts"][1]["part"] = 0; }) ==
          Outcome::wrong);
    CHECK(outcome(joint, [](ordered_json& s) { s["proof"]["parts"][1]["part"] = 2; }) ==
          Outcome::wrong);
    CHECK(outcome(joint, [](ordered_json& s) { s["proof"]["parts"][0]["holds"] = false; }) ==
          Outcome::wrong);
}
