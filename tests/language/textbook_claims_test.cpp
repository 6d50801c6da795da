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

TEST_CASE("the theorem of a claim may stand behind its examples") {
    for (const char* text : {"claim T\ntheorem {a} is finite\nshow a in {a}",
                             "claim T\nshow a in {a}\ntheorem {a} is finite",
                             "claim T\nshow a in {a}\nshow b in {b}\ntheorem {a} is finite"}) {
        const CheckedClaim checked = check(read_claim(text, "x.claim", {}));
        const auto theorem = checked.theorem();
        REQUIRE(theorem);
        CHECK(checked.claim.statements.at(*theorem).statement.text == "{a} is finite");
        CHECK(checked.verdict() == ClaimVerdict::proved);
    }
    CHECK_FALSE(check(read_claim("claim T\nshow a in {a}", "x.claim", {})).theorem());
}

TEST_CASE("a page has the definitions, then the statements") {
    const CheckedClaim checked = check(
        read_claim("claim A page\nlet G = IL { axiom ab; a -> b; a -> ab; b -> b; a < b -> a; "
                   "a < b > b -> b; a < b > a -> a }\nlet S = CF { S -> aSb | ε }\n"
                   "show ab in L(G)\nshow a in {a}",
                   "x.claim", {}));
    CHECK(explanation(checked) ==
          "A page\n"
          "\n"
          "Let G be the system with axiom ab; a -> b | ab; a < b > b -> b; a < b > a -> a; a < b "
          "-> a; b -> b.\n"
          "Let S = CF { S -> aSb | ε }.\n"
          "\n"
          "1. ab in L(G): proved.\n"
          "   ab is in L(G): it is the axiom.\n"
          "\n"
          "2. a in {a}: proved.\n"
          "   a is in {a}.\n");
}

TEST_CASE("that a family is closed under an operation is a statement about its languages") {
    const std::vector<std::pair<const char*, const char*>> known{
        {"union", "for all E0L languages A, B: A | B is E0L"},
        {"concatenation", "for all E0L languages A, B: A B is E0L"},
        {"star", "for all E0L languages A: A* is E0L"},
        {"plus", "for all E0L languages A: A+ is E0L"},
        {"reversal", "for all E0L languages A: A^R is E0L"},
        {"intersection", "for all E0L languages A, B: A & B is E0L"},
        {"intersection with regular",
         "for all E0L languages A and regular languages B: A & B is E0L"},
        {"homomorphism", "for all E0L languages A and morphisms h: h(A) is E0L"},
        {"non-erasing homomorphism",
         "for all E0L languages A and non-erasing morphisms h: h(A) is E0L"},
        {"inverse homomorphism", "for all E0L languages A and morphisms h: h^-1(A) is E0L"},
        {"finite substitution", "for all E0L languages A and finite substitutions h: h(A) is E0L"}};
    for (const auto& [operation, text] : known) {
        CAPTURE(operation);
        const auto statement = closure_statement("E0L", operation, true, 0);
        REQUIRE(statement);
        CHECK(statement->text == text);
        // As many names are bound as the text has.
        const std::string names = statement->text.substr(0, statement->text.find(':'));
        std::size_t count = 0;
        for (const char* name : {"languages A", "B", " h"})
            count += names.find(name) != std::string::npos;
        CHECK(std::get<Quantified>(statement->says).bindings.size() == count);
    }
}

namespace {

/// A statement, perhaps with definitions before it, and what is known of it.
struct Said {
    const char* text;
    Truth truth;
    const char* why = "";  // stands in the argument, or in what was tried
};

void compare(const std::vector<Said>& all) {
    for (const auto& [text, truth, why] : all) {
        CAPTURE(text);
        const CheckedClaim checked = check(read_claim("claim T\n" + std::string(text), "x", {}));
        const Answer& answer = checked.statements.at(0).answer;
        CHECK(answer.truth == truth);
        std::string argument;
        for (const std::string& line : in_sentences(answer, *checked.claim.alphabet).argument)
            argument += line + '\n';
        CHECK_MESSAGE(argument.find(why) != std::string::npos, argument);
        for (const auto& finding : verify::check_certificate(certificate(checked).dump(), "x"))
            CHECK(finding.outcome != verify::Finding::Outcome::wrong);
    }
}

const Truth yes = Truth::proved, no = Truth::refuted, open = Truth::undecided;

}  // namespace

TEST_CASE("comparisons of languages, each with its reason") {
    const std::string powers = "let G = D0L { axiom ac; a -> ab; c -> dc }\nshow ";
    const std::string within = powers + "L(G) <= {a b^n d^n c : n >= 0}",
                      around = powers + "{a b^n d^n c : n >= 0} <= L(G)";
    compare({
        // No theorem says that no method decides it, as one side is regular.
        {"let G = 0L { axiom a; a -> aa | b }\nshow /b(bb)*/ <= L(G)", open,
         "and no theorem applies"},
        // All words of a finite side are said.
        {"let G = 0L { axiom a; a -> aa | b }\nshow {a, aa, bb} <= L(G)", yes,
         "a is in L(G): it is the axiom.\naa is in L(G): a => aa.\nbb is in L(G): a => aa => bb."},
        // A system is constructed where no system is given, and only there.
        {"let G = 0L { axiom a; a -> aa | b }\nshow L(G) <= /(a|b)*/", yes,
         "Every word of L(G) is in {a, b}*"},
        {"let G = D0L { axiom a; a -> aa }\nshow L(G)* <= /a*/", yes,
         "A system for L(G)* is constructed (star)"},
        // The second number of the powers makes the difference.
        {"let G = 0L { axiom abcdefghx; x -> abcdefghx | abcdefghxx }\n"
         "show {(abcdefgh)^n x (hgfedcba)^m : n >= 1, m >= 0} <= L(G)",
         no, "abcdefghxhgfedcba is not in L(G)"},
        // A letter that is the first of its successor, and one that is the last.
        {within.c_str(), yes, "Word number n of G is a b^n d^n c"},
        {around.c_str(), yes, "Word number n of G is a b^n d^n c"},
    });
    const CheckedClaim checked = check(
        read_claim("claim T\nlet G = 0L { axiom a; a -> aa | b }\nshow L(G) <= /(a|b)*/", "x", {}));
    CHECK(in_sentences(checked.statements[0].answer, *checked.claim.alphabet).argument.size() == 1);
}

TEST_CASE("families of a meeting and of a union") {
    compare({
        // {a^(2^n)} is not context-free, so its meeting with a regular language need not be.
        {"let G = D0L { axiom a; a -> aa }\nshow L(G) & /a*/ is context-free", open},
        {"let S = CF { S -> aSb | ε }\nshow S & /a*b*/ is context-free", yes},
        {"let S = CF { S -> aSb | ε }\nshow /a*b*/ & S is context-free", yes},
        // It is {a^(2^n)}, which is D0L.
        {"let G = D0L { axiom a; a -> aaaa }\nlet H = D0L { axiom aa; a -> aaaa }\n"
         "show L(G) | L(H) is DT0L",
         open},
        // A word that no rule of lengths makes.
        {"let G = D0L { axiom a; a -> aaaa }\nlet H = D0L { axiom aaa; a -> aaaa }\n"
         "show L(G) | L(H) is DT0L",
         no},
    });
}

TEST_CASE("a word is not in a product whose factors are open") {
    compare(
        {{"let G = IL { axiom b; b -> aaaaab; b -> x; a > aaaax ->; a > aaax ->; a > aax ->; "
          "a > ax ->; a > x -> }\nshow aax in /a/ L(G)",
          open, "some factors of aax could not be decided"}});
}

TEST_CASE("numbers, their powers and their bounds") {
    compare({
        {"show 2^(-3) = 1/8", yes},
        {"show (3/2)^(-2) = 4/9", yes},
        {"show (1 + sqrt(2))^(-2) = 3 - 2*sqrt(2)", yes},
        {"show 2^(1/2) = 1", open, "as exponent, found 1/2"},
        {"show for all numbers n: n^(1/2) >= 0", open,
         "expected an exponent from 0 to 1000, found 1/2"},
        {"show for all numbers n: n^sqrt(2) >= 0", open,
         "expected an exponent from 0 to 1000, found sqrt(2)"},
        {"show for all numbers n with n >= 1 and n >= 3: n^2 >= 9", yes},
        {"show for all numbers n with n >= 3 and n >= 1: 2^n >= 8", yes},
        // The left side minus the right one is n + 0, 1, ...: a recurrence of order 2, and its differences are all 1.
        {"show for all numbers n with n >= 1 and n >= 3: n >= 3", yes,
         "Let v(n) = u(n+1) - u(n). If it is not negative, u(n) is not negative, as u(0) is.\n"
         "v(n+1) = v(n) has no negative coefficient"},
    });
    Budget small;
    small.memory = 50'000;
    const auto truth = [&](const char* text) {
        return check(read_claim("claim T\nshow " + std::string(text), "x", {}), small)
            .statements.at(0)
            .answer.truth;
    };
    CHECK(truth("10^300 > 1") == yes);
    CHECK(truth("(10^300)^100 > 1") == open);
}

TEST_CASE("statements about all values, decided by one or by none") {
    compare({
        {"show for all letters x: { a -> x }(/a*/) == /x*/", yes},
        {"show for all letters x, y: { a -> xy; b -> x }({ab}) == {xyx}", yes},
        {"show for all finite languages A up to size 4: A & {z^n : n >= 1} is empty", no,
         "The least counterexample is A = {z}"},
        {"show for all finite languages A up to size 4: A & {b^n c^n : n >= 1} is empty", no,
         "The least counterexample is A = {bc}"},
        // Systems with an empty axiom are not among the instances.
        {"allow empty axiom\nshow for all D0L systems over {a} G up to size 3: L(G) is finite or "
         "L(G) is infinite",
         open},
        {"show for all D0L systems over {a} G up to size 3: L(G) is finite or L(G) is infinite",
         yes},
        {"allow empty axiom\nshow for all finite languages A over {a} with words up to length 2: "
         "A is finite",
         yes},
        {"show for all context-free languages A: A is 0L", no},
        {"show for all context-free languages A: A is EP0L", no},
        {"show for all context-free languages A: A is E0L", yes},
        {"show for all D0L systems G with L(G) is infinite and growth(G) ~ exponential: L(G) is "
         "not context-free",
         yes},
        {"show for all D0L systems G with not growth(G) ~ exponential: L(G) is not regular", no},
        {"show for all D0L systems G with growth(G) ~ polynomial 1: L(G) is not regular", no},
        {"show for all D0L systems G with growth(G) ~ polynomial 2: L(G) is not regular", yes},
        {"show for all PD0L systems G up to size 4 with word(G, 1) begins with word(G, 0) and "
         "word(G, 0) != word(G, 1): L(G) is infinite",
         yes, "The second word of G is w x"},
        {"show for all numbers n: not (n >= 0 and n + 1 >= 1)", no},
        {"show for some number n: n = 1 and n = 2", open},
        {"show for all 0L systems G and words x, y with G : x ==> y in 1000000 steps: "
         "G : x ==> y in 1000000 steps",
         yes, "So the statement follows from its conditions."},
        {"show for all 0L systems G and words u, v, w with G : u ==> w in 1 step and "
         "G : v ==> ε in 1 step: G : u v ==> w in 1 step",
         yes},
    });
}

TEST_CASE("a search says which share of the instances it has looked at") {
    struct Kept : Progress {
        std::vector<double> shares;
        void report(double done) override { shares.push_back(done); }
    };
    Kept kept;
    SearchLimits limits;
    limits.progress = &kept;
    const Claim claim = read_claim(
        "claim T\nshow for all finite languages A up to size 5: "
        "A is finite and A is D0L or A is not D0L",
        "x", {});
    decide(claim.statements.at(0).statement, claim, {}, limits);
    REQUIRE(!kept.shares.empty());
    CHECK(std::is_sorted(kept.shares.begin(), kept.shares.end()));
    CHECK(kept.shares.front() > 0);
    CHECK(kept.shares.front() < 1);
    CHECK(kept.shares.back() <= 1);
}
