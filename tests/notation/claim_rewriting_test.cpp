// Claims about systems with probabilities, parameters and contexts of trees.
#include <doctest/doctest.h>

#include "notation/claim_said.hpp"

using namespace algae;

namespace {

const std::string definitions =
    "let G = S0L { axiom b; a -(1)-> ab; b -(1/3)-> a; b -(2/3)-> b }\n"
    "let Q = parametric { let k = 2; axiom A(k); A(x) : x < 9 -> A(k*x)B }\n"
    "let C = IL { axiom A[B]C; A > [B]C -> D }\n"
    "let D = D0L { axiom a; a -> aa }\n";

Statement statement(const std::string& text) {
    return claim(definitions + "show " + text).statements.at(0).statement;
}
std::string said(const std::string& line) { return claim_messages(definitions + line); }

}  // namespace

TEST_CASE("systems whose words are derived module by module are definitions of their own") {
    const Claim read = claim(definitions);
    REQUIRE(read.rewritings.size() == 3);
    CHECK(read.rewritings[0]->name == "G");
    CHECK(read.rewritings[1]->rules.size() == 1);
    CHECK(read.systems.size() == 1);
}

TEST_CASE("the probability of a derivation") {
    const Statement chance = statement("P(G ==> ab in 2 steps) = 1/9");
    const auto said = said_in<HasChance>(chance);
    CHECK(!chance.negated);
    CHECK(said.probability == Rational(1, 9));
    CHECK(said.derivation.steps == 2);
    CHECK(said.derivation.word.letters.size() == 2);
    CHECK(chance.text == "P(G ==> ab in 2 steps) = 1/9");
    CHECK(statement("P(G ==> b in 1 step) != 0.25").negated);
    CHECK(said_in<HasChance>(statement("P(G ==> b in 1 step) = (1/3)^2")).probability ==
          Rational(1, 9));
    CHECK(statement("not P (G : a ==> ab in 1 step) = 1").negated);
    CHECK(said_in<HasChance>(statement("P(Q : A(1)A(2) ==> A(2)BA(4)B in 1 step) = 1"))
              .derivation.from->letters.size() == 2);
    CHECK(
        said_in<HasChance>(statement("P(G ==> ε in 1 step) = 0")).derivation.word.letters.empty());
}

TEST_CASE("derivations of words with parameters") {
    const auto derives = said_in<Rewrites>(statement("Q ==> A(k^2)B in 1 step"));
    CHECK(derives.system->name == "Q");
    CHECK(derives.word.arguments.at(0).size() == 1);
    CHECK(said_in<Rewrites>(statement("Q ==> A(8/7)Z(1,2) in 1 step")).word.letters.size() == 2);
    CHECK(is_said<Rewrites>(statement("C : A ==> A in 1 step")));
    CHECK(is_said<Derives>(statement("D ==> aa in 1 step")));
}

TEST_CASE("what does not fit a family is said with its reason") {
    CHECK(claim_messages("let G = S0L { axiom b; b -(1/6)-> a; b -(1/2)-> bb }") ==
          "2:24: the probabilities of b add up to 2/3, expected 1");
    CHECK(claim_messages("let G = S0L { axiom b; b -> a; b -> bb }") ==
          "2:9: G is called a S0L system, but it is not a stochastic 0L system: b has several "
          "rules without probabilities");
    CHECK(claim_messages("let G = S0L { axiom b; b -> a }") ==
          "2:9: G is called a S0L system, but no rule has a probability");
    CHECK(claim_messages("let G = PS0L { axiom b; b -(1/2)-> ε; b -(1/2)-> b }") ==
          "2:9: G is called a PS0L system, but the rule at x.claim:2:25 is erasing");
    CHECK(claim_messages("let G = S0L { axiom A(1); A(x) -(1)-> A(x) }") ==
          "2:9: G is called a S0L system, but it is not a stochastic 0L system: the axiom has "
          "parameters");
    CHECK(claim_messages("let G = parametric { axiom a; a -> aa }") ==
          "2:9: G is called a parametric system, but none of its modules has parameters and no "
          "rule has a condition");
    CHECK(claim_messages("let G = parametric { axiom A; A -> div(X, 1r, 1r){ B } }") ==
          "2:9: G is called a parametric system, but it has shape rules");
    CHECK(claim_messages("let G = parametric { system s { axiom a; a -> aa }; axiom A(1); A(x) -> "
                         "[<s(x)>]A(x+1) }") ==
          "2:9: G is called a parametric system, but it has systems within it or words as "
          "parameters");
    CHECK(claim_messages("let G = parametric") ==
          "2:19: expected a system between braces or the name of one, found the end of the line");
    CHECK(claim_messages("let G = SOL { axiom a; a -> aa }") ==
          "2:9: expected a family of systems (0L, PD0L, ET0L, IL, ...), found 'SOL'; did you mean "
          "'S0L'?");
    CHECK(claim_messages("let S0L = {a}") ==
          "2:5: expected another name, 'S0L' has a meaning in claims");
}

TEST_CASE("what does not fit a statement stands at its place") {
    CHECK(said("show P(D ==> a in 1 step) = 1") ==
          "6:8: expected a system with probabilities (S0L, PS0L, parametric), found 'D', which has "
          "none");
    CHECK(said("show P(G ==> a in 1 step) = 4/3") ==
          "6:29: expected a probability, an exact number from 0 to 1, found '4/3'");
    CHECK(said("show P(G ==> a in 1 step) = sqrt(1/2)") ==
          "6:29: expected a probability, an exact number from 0 to 1, found 'sqrt(1/2)'");
    CHECK(said("show P(G ==> a in 1 step) = p") ==
          "6:29: expected a number or a constant, found 'p'");
    CHECK(said("show P(G ==> a in 1 step)") ==
          "6:26: expected '=' or '!=' and a probability, found the end of the line");
    CHECK(said("show P(G ==> a in 1 step) =") ==
          "6:28: expected a probability, such as 1/9, found the end of the line");
    CHECK(said("show P(G ==> a in 1 step = 1/3") == "6:7: '(' is never closed");
    CHECK(said("show P(G ==> a) = 1/3")
              .find("expected 'in' and a number of steps, as G has "
                    "probabilities, parameters or contexts of trees") != std::string::npos);
    CHECK(said("show Q ==> A(4)B").find("expected 'in' and a number of steps, as Q has") !=
          std::string::npos);
    CHECK(said("show Q ==> A(y) in 1 step") == "6:14: expected a number or a constant, found 'y'");
    CHECK(said("show Q ==> A(1/0) in 1 step").find("6:1") == 0);
    CHECK(said("show Q ==> in 1 step") ==
          "6:12: expected a word (the empty word is ε), found 'in'");
    CHECK(said("show a in L(G)") ==
          "6:13: expected a system, found 'G', a system with probabilities, parameters or contexts "
          "of trees, of which claims say what it derives and how likely that is");
    CHECK(said("show growth(Q) == growth(Q)").find("6:13: expected a system, found 'Q'") == 0);
}
