#include "language/detail/judge.hpp"
#include "language/language.hpp"

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <nlohmann/json.hpp>

#include "certified.hpp"
#include "notation/notation.hpp"
#include "oracle/random_systems.hpp"

using namespace algae;
using algae::random::certified;
using algae::random::sound;

namespace {

Claim claim_of(const std::string& system, const std::string& statement) {
    return read_claim("claim T\nlet G = " + system + "\nshow " + statement, "x.claim", {});
}

const std::string waiting =
    "S0L { axiom b; a -(1)-> ab; b -(1/6)-> a; b -(1/6)-> aba; b -(1/3)-> bba; b -(1/3)-> b }";
const std::string two =
    "parametric { axiom B(2)A(4,4); A(x,y) : y <= 3 -> A(2*x,x+y); A(x,y) : y > 3 -> B(x)A(x/y,0); "
    "B(x) : x < 1 -> C; B(x) : x >= 1 -> B(x-1) }";

std::string explained(const std::string& system, const std::string& statement) {
    const CheckedClaim checked = check(claim_of(system, statement));
    return sentences(checked.statements[0].answer, *checked.claim.alphabet).at(0);
}

Truth truth(const std::string& system, const std::string& statement) {
    return check(claim_of(system, statement)).statements[0].answer.truth;
}

/// A word of a and b, with letters of its own where it is long.
std::string any_word() { return *oracle::any_word("abc", 3); }

}  // namespace

TEST_CASE("probabilities are exact, and sentences say them") {
    CHECK(truth(waiting, "P(G ==> b in 2 steps) = 1/9") == Truth::proved);
    CHECK(truth(waiting, "P(G ==> b in 2 steps) = 1/8") == Truth::refuted);
    CHECK(truth(waiting, "P(G ==> b in 2 steps) != 1/8") == Truth::proved);
    CHECK(truth(waiting, "P(G : a ==> ab in 1 step) = 1") == Truth::proved);
    CHECK(truth(waiting, "P(G ==> c in 2 steps) = 0") == Truth::proved);
    CHECK(truth(waiting, "G ==> aba in 1 step") == Truth::proved);
    CHECK(truth(waiting, "G ==> ab in 1 step") == Truth::refuted);
    CHECK(explained(waiting, "P(G ==> aba in 1 step) = 1/6") ==
          "G: b derives 4 words in 1 step; the probability of aba is 1/6, the sum over its "
          "derivations of "
          "the products of the rules' probabilities.");
    CHECK(explained(waiting, "P(G ==> ab in 1 step) = 0") ==
          "G: b derives 4 words in 1 step, and ab is none of them: its probability is 0.");
}

TEST_CASE("words with parameters are the same where all digits are") {
    CHECK(truth(two, "G ==> CB(0)B(8)A(8/7,0) in 5 steps") == Truth::proved);
    CHECK(truth(two, "G ==> CB(0)B(8)A(1.142857,0) in 5 steps") == Truth::refuted);
    CHECK(truth(two, "G ==> CB(0)B(8)A(8/7) in 5 steps") == Truth::refuted);
    CHECK(truth(two, "P(G ==> B(1)B(4)A(1,0) in 1 step) = 1") == Truth::proved);
    CHECK(explained(two, "G ==> B(0)B(3)A(2,1) in 2 steps") ==
          "G: B(2)A(4,4) ==> B(0)B(3)A(2,1) in 2 steps: B(2)A(4,4) => B(1)B(4)A(1,0) => "
          "B(0)B(3)A(2,1).");
    CHECK(explained(two, "G ==> A(1,1) in 1 step") ==
          "G: B(2)A(4,4) ==> B(1)B(4)A(1,0) in 1 step, and nothing else.");
}

TEST_CASE("systems are explained with their rules") {
    const CheckedClaim checked =
        check(claim_of("parametric { let k = 2; axiom A(k)X_12; c < A(x) > [d] ? B(y) : x < y & y "
                       "> k -> A(x+1)X_12 ; A(x) : x = 9 -> ε; "
                       "d -(1/2)-> dd; d -(1/2)-> ε; ignore + - }",
                       "G ==> A(k)X_12 in 1 step"));
    CHECK(rewriting_text(*checked.claim.rewritings[0]) ==
          "the parametric S(1,1)L system with context conditions and axiom A(k)X_12; c "
          "< A(x) > [d] ? B(y) : "
          "x < y & y > k -> A(x+1)X_12; A(x) : x = 9 -> ε; d -(1/2)-> dd; d -(1/2)-> ε; ignored "
          "are + -, where k = 2");
    CHECK(explanation(checked).find("Let G be the ") != std::string::npos);
}

TEST_CASE("a deadline and a bound leave it undecided") {
    Budget small;
    small.memory = 10'000;
    const Claim claim = claim_of("S0L { axiom aaaaaaaaaaaaaaaaaaaa; a -(1/2)-> a; a -(1/2)-> b }",
                                 "P(G ==> a in 1 step) = 0");
    CHECK(check(claim, small).statements[0].answer.truth == Truth::undecided);
}

TEST_CASE("rules that match together without probabilities are an error at their place") {
    const CheckedClaim checked = check(claim_of(
        "parametric { axiom A(1); A(x) : x > 0 -> B; A(x) : x < 2 -> C }", "G ==> B in 1 step"));
    const Answer& answer = checked.statements.at(0).answer;
    CHECK(answer.truth == Truth::undecided);
    CHECK(answer.tried.at(0).starts_with("x.claim:2:"));
}

TEST_CASE("probabilities found by deriving all words are those found by recursion over prefixes") {
    CHECK(rc::check([] {
        std::string system = "S0L { axiom " + *oracle::any_nonempty_word("abc", 2);
        for (const char letter : std::string("ab")) {
            const int k = *rc::gen::inRange(1, 5);
            const std::string share = std::to_string(k) + "/5", rest = std::to_string(5 - k) + "/5";
            system += std::string("; ") + letter + " -(" + share + ")-> " + any_word();
            system += std::string("; ") + letter + " -(" + rest + ")-> " + any_word();
        }
        system += "; c -(1/4)-> " + any_word() + "; c -(3/4)-> c }";
        const int steps = *rc::gen::inRange(0, 3);
        const std::string in = " in " + std::to_string(steps) + " steps";
        const std::string word = *oracle::any_word("abc", 4);
        const std::string goal = word.empty() ? "ε" : word;
        RC_LOG() << system << " " << goal << in << "\n";
        const Claim claim = claim_of(system, "P(G ==> " + goal + in + ") = 2/5");
        const auto found = sound(claim);
        RC_ASSERT(found.is_checked() || found.judgement.truth == Truth::undecided);
        const auto derives = sound(claim_of(system, "G ==> " + goal + in));
        const auto never = sound(claim_of(system, "P(G ==> " + goal + in + ") = 0"));
        if (derives.judgement.truth == Truth::undecided ||
            never.judgement.truth == Truth::undecided)
            return;
        RC_ASSERT((derives.judgement.truth == Truth::proved) ==
                  (never.judgement.truth == Truth::refuted));
    }));
}

TEST_CASE("derivations with parameters are certified") {
    for (int steps = 0; steps <= 6; ++steps) {
        const auto found =
            certified(claim_of(two, "G ==> CB(1)A(8,7) in " + std::to_string(steps) + " steps"));
        CHECK(found.is_checked());
        CHECK((found.judgement.truth == Truth::proved) == (steps == 4));
    }
    const auto around =
        certified(claim_of("IL { axiom A[B]C; A > [B]C -> D }", "G ==> D[B]C in 1 step"));
    CHECK(around.judgement.truth == Truth::proved);
    CHECK(around.is_checked());
}

TEST_CASE(
    "contexts in trees, ignored letters and modules elsewhere are certified as they are derived") {
    CHECK(rc::check([] {
        const auto one = [](const std::vector<std::string>& texts) {
            return *rc::gen::elementOf(texts);
        };
        const auto word = [&](int depth, const auto& self) -> std::string {
            std::string text;
            for (int i = *rc::gen::inRange(1, 5); i > 0; --i)
                text += depth > 0 && *rc::gen::inRange(0, 3) == 0
                            ? "[" + self(depth - 1, self) + "]"
                            : one({"a", "b", "c", "A(1)", "A(2)"});
            return text;
        };
        std::string system = "parametric { axiom " + word(2, word) + "A(1)";
        for (int i = *rc::gen::inRange(1, 5); i > 0; --i)
            system += "; " + one({"", "", "a < ", "b < ", "ab < ", "A(y) < "}) +
                      one({"a", "b", "c"}) +
                      one({"", "", " > a", " > [a]b", " > [b]", " > a[b][c]", " > []c"}) + " -> " +
                      one({"ab", "c", "ε", "a[b]", "A(3)"});
        system += "; A(x) ? b, A(z) : x < z -> A(x+z)";
        if (*rc::gen::inRange(0, 2) == 0) system += "; ignore c";
        system += " }";
        RC_LOG() << system << "\n";
        std::string reached;
        try {
            const CheckedClaim checked = check(claim_of(system, "G ==> Z in 1 step"));
            // Rules that match together without probabilities.
            if (checked.statements[0].answer.truth == Truth::undecided) return;
            const std::string said =
                sentences(checked.statements[0].answer, *checked.claim.alphabet).at(0);
            const std::size_t from = said.find(" ==> ") + 5;
            reached = said.substr(from, said.find(" in 1 step") - from);
        } catch (const Error&) {
            return;  // two rules with the same contexts
        }
        const auto found = sound(claim_of(system, "G ==> " + reached + " in 1 step"));
        RC_ASSERT(found.judgement.truth == Truth::proved);
        RC_ASSERT(found.is_checked());
        RC_ASSERT(sound(claim_of(system, "G ==> " + reached + "a in 1 step")).is_checked());
    }));
}
