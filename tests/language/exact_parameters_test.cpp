// Derivations with parameters: what is proved is worked out again by verify, with rationals by definition, and nothing that
// rounding would make true is proved.

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <nlohmann/json.hpp>
#include <string>

#include "exact/exact.hpp"
#include "language/language.hpp"
#include "model/model.hpp"
#include "notation/notation.hpp"
#include "rewrite/rewrite.hpp"
#include "verify/verify.hpp"

using namespace algae;
using Outcome = verify::Finding::Outcome;

namespace {

struct Result {
    Truth truth;
    verify::Finding finding;
};

Result result(const std::string& system, const std::string& statement) {
    const CheckedClaim checked = check(
        read_claim("claim T\nlet G = parametric {\n" + system + "}\nshow " + statement, "x", {}));
    return {checked.statements.at(0).answer.truth,
            verify::check_certificate(certificate(checked).dump()).at(0)};
}

std::string random_number() {
    return std::to_string(*rc::gen::inRange(0, 30)) + "." +
           std::to_string(*rc::gen::inRange(0, 10));
}

/// Sums, products and quotients of x, y and decimals.
std::string random_term(int depth) {
    if (depth == 0)
        return *rc::gen::oneOf(rc::gen::element<std::string>("x", "y"),
                               rc::gen::exec(random_number));
    const std::string of = *rc::gen::element<std::string>("+", "-", "*", "/");
    return "(" + random_term(depth - 1) + of + random_term(*rc::gen::inRange(0, depth)) + ")";
}

std::string random_system() {
    std::string text = "axiom A(" + random_number() + "," + random_number() + ")\n";
    const std::string bound = random_term(1);
    text += "A(x,y) : x < " + bound + " -> A(" + random_term(2) + "," + random_term(1) + ")B(" +
            random_term(1) + ")\n";
    text += "A(x,y) : x >= " + bound + " -> B(" + random_term(1) + ")A(y," + random_term(1) + ")\n";
    text += "B(x) : x != 1 -> B(x/3+" + random_number() + ")\n";
    return text;
}

}  // namespace

TEST_CASE(
    "false statements that rounding makes true are refuted: x/1024, floor(0.29*100), 2^53 + 1") {
    const std::string system =
        "axiom A(1)\nA(x) : x > 0 -> A(x/1024)\nA(x) : x = 0 -> B\n"
        "C(x) -> C(floor(x*100))\nD(x) -> D(x+1)\nE(x) -> E(x+0.1)\n";
    const auto holds = [&](const std::string& statement) {
        const Result found = result(system, statement);
        CHECK(found.finding.outcome == Outcome::checked);
        return found.truth;
    };
    CHECK(holds("G ==> B in 125 steps") == Truth::refuted);
    CHECK(holds("G : C(0.29) ==> C(28) in 1 step") == Truth::refuted);
    CHECK(holds("G : C(0.29) ==> C(29) in 1 step") == Truth::proved);
    CHECK(holds("G : D(9007199254740992) ==> D(9007199254740992) in 1 step") == Truth::refuted);
    CHECK(holds("G : D(9007199254740992) ==> D(9007199254740993) in 1 step") == Truth::proved);
    CHECK(holds("G : E(0.1) ==> E(0.3) in 2 steps") == Truth::proved);
    CHECK(holds("G : E(0.1) ==> E(1) in 9 steps") == Truth::proved);
}

TEST_CASE("verify works out what is proved of parameters, and refutes a digit more") {
    std::size_t compared = 0, undefined = 0;
    CHECK(rc::check([&] {
        const auto [system, steps] = *rc::gen::resize(
            100, rc::gen::exec([] { return std::pair(random_system(), *rc::gen::inRange(1, 6)); }));
        RewritingChoices choices;
        choices.arithmetic = Arithmetic::exact;
        std::string word;
        try {
            const Rewriting rewriting(read_lsystem(system, "x"), choices);
            word = ModuleText(rewriting.rules().system->alphabet, rewriting.rules().kinds)
                       .text(derive(rewriting, static_cast<std::uint64_t>(steps)));
        } catch (const Error& error) {
            RC_ASSERT(std::string(error.what()).find("division by 0") != std::string::npos);
            ++undefined;
            return;
        }
        const auto derives = [&](const std::string& to) {
            return result(system, "G ==> " + to + " in " + std::to_string(steps) +
                                      (steps == 1 ? " step" : " steps"));
        };
        const Result so = derives(word);
        RC_ASSERT(so.truth == Truth::proved);
        RC_ASSERT(so.finding.outcome == Outcome::checked);
        const Result other = derives(word.substr(0, word.size() - 1) + "+10^(-30))");
        RC_ASSERT(other.truth == Truth::refuted);
        RC_ASSERT(other.finding.outcome == Outcome::checked);
        ++compared;
    }));
    MESSAGE(compared << " compared, " << undefined << " divide by 0");
    CHECK(compared >= 60);
}

TEST_CASE(
    "what no number tells is undecided where enclosures do not, and verify says what it leaves") {
    const std::string system =
        "axiom A(2)\nA(x) -> A(exp(x))\nS(x) : exp(log(x)) = x -> T\nE(x) -> E(x*x)\n"
        "R(x) -> R(sqrt(x))\n";
    CHECK(result(system, "G ==> A(7.38905609893065) in 1 step").truth == Truth::refuted);
    const Result same = result(system, "G ==> A(exp(2)) in 1 step");
    CHECK(same.truth == Truth::undecided);
    CHECK(same.finding.statement == "G derives A(exp(2)) in 1 steps");
    CHECK(result(system, "G : S(2) ==> T in 1 step").truth == Truth::undecided);
    CHECK(result(system, "G : E(3) ==> E(5) in 30 steps").truth == Truth::undecided);
    CHECK(result(system, "G ==> A(3) in 1 step").finding.reason == "'exp' is not worked out again");
    for (const char* statement :
         {"G : R(16) ==> R(2) in 2 steps", "G : R(2) ==> R(2^0.5) in 1 step",
          "G : R(9/8) ==> R(3/4*sqrt(2)) in 1 step"}) {
        const Result root = result(system, statement);
        CHECK(root.truth == Truth::proved);
        CHECK(root.finding.outcome == Outcome::checked);
    }
}
