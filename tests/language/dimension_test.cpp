#include "language/language.hpp"

#include <doctest/doctest.h>

#include <chrono>
#include <nlohmann/json.hpp>

#include "certified.hpp"
#include "dimension/dimension.hpp"
#include "language/detail/judge.hpp"
#include "notation/notation.hpp"

using namespace algae;
using algae::random::certified;

namespace {

const std::string koch = "D0L { axiom F; F -> F+F--F+F; angle 60 }";
const std::string folded = "D0L { axiom F; F -> FF-F-F-F-F-F+F }";
const std::string dragon = "D0L { axiom FX; X -> X+YF+; Y -> -FX-Y }";
const std::string terdragon = "D0L { axiom F; F -> F+F-F; angle 120 }";

Claim claim_of(const std::string& system, const std::string& statement) {
    return read_claim("claim T\nlet G = " + system + "\nshow " + statement, "x.claim", {});
}

Truth truth(const std::string& system, const std::string& statement) {
    return check(claim_of(system, statement)).statements[0].answer.truth;
}

std::string last_sentence(const std::string& system, const std::string& statement) {
    const CheckedClaim checked = check(claim_of(system, statement));
    return sentences(checked.statements[0].answer, *checked.claim.alphabet).back();
}

}  // namespace

TEST_CASE("dimensions are compared exactly, whatever form they are written in") {
    for (const char* value : {"log 4 / log 3", "log 2 / log sqrt 3", "log 16/log 9",
                              "log 4 / log 3 = 1.261859507142914874199054228686"})
        CHECK(truth(koch, std::string("dimension(G) = ") + value) == Truth::proved);
    for (const char* value :
         {"log 3 / log 4", "1.26", "1.2618595071429148741990542286855217085", "2", "log 5 / log 3"})
        CHECK(truth(koch, std::string("dimension(G) = ") + value) == Truth::refuted);
    CHECK(truth(koch, "dimension(G) != 4/3") == Truth::proved);
    CHECK(truth(koch, "dimension(G) <= 4/3") == Truth::proved);
    CHECK(truth(koch, "dimension(G) <= log 4 / log 3") == Truth::proved);
    CHECK(truth(koch, "dimension(G) <= 5/4") == Truth::refuted);
    CHECK(truth(koch, "not dimension(G) <= 5/4") == Truth::proved);
    CHECK(truth(koch, "dimension(G) >= 5/4") == Truth::proved);
    CHECK(truth(koch, "dimension(G) >= log 16 / log 9") == Truth::proved);
    CHECK(truth(koch, "dimension(G) >= 1.2618595072") == Truth::refuted);
    CHECK(last_sentence(koch, "dimension(G) >= 5/4") ==
          "The dimension of the limit set of G is log 4 / log 3 = 1.261859507143 > 5/4.");
}

TEST_CASE("parts that coincide count once") {
    CHECK(truth(folded, "dimension(G) = log 6 / log sqrt 10") == Truth::proved);
    CHECK(truth(folded, "dimension(G) = log 36 / log 10") == Truth::proved);
    CHECK(truth(folded, "dimension(G) = log 8 / log sqrt 10") == Truth::refuted);
    CHECK(last_sentence(folded, "dimension(G) = log 8 / log sqrt 10") ==
          "The dimension of the limit set of G is log 6 / log sqrt 10 = 1.556302500767 < log 8 / "
          "log sqrt 10.");
}

TEST_CASE("the boundary of a limit set that fills an area") {
    CHECK(truth(dragon, "dimension(G) = 2") == Truth::proved);
    CHECK(truth(dragon, "boundary(G) = log the largest real root of x^3 - x^2 - 2 / log sqrt 2") ==
          Truth::proved);
    CHECK(truth(dragon, "boundary(G) = 1.5") == Truth::refuted);
    CHECK(truth(terdragon, "boundary(G) = log 2 / log sqrt 3") == Truth::proved);
    CHECK(truth(terdragon, "boundary(G) = log 4 / log 3") == Truth::proved);
    CHECK(truth(koch, "boundary(G) = 1") == Truth::undecided);
    CHECK(last_sentence(koch, "boundary(G) = 1") ==
          "The limit set of G has the dimension log 4 / log 3 = 1.261859507143 and no interior "
          "points: it is all boundary.");
}

TEST_CASE("an upper bound proves what is at most, and refutes what is above it") {
    // Irrational turns: whether parts coincide is not known.
    const std::string tree = "D0L { axiom X; X -> F[+X][-X]; F -> FF; angle 20 }";
    const auto bounded = exact_dimension(
        *std::get<HasDimension>(claim_of(tree, "dimension(G) = 1").statements[0].statement.says)
             .system);
    if (bounded.status == ExactDimension::Status::upper_bound) {
        const std::string bound = bounded.value->text();
        CHECK(truth(tree, "dimension(G) = " + bound) == Truth::undecided);
        CHECK(truth(tree, "dimension(G) <= " + bound) == Truth::proved);
    }
    CHECK(truth(tree, "dimension(G) <= 3") == Truth::proved);
    CHECK(truth(tree, "dimension(G) = 3") == Truth::refuted);
}

TEST_CASE("without a formula nothing is decided") {
    CHECK(truth("D0L { axiom F; F -> F+F; angle 90 }", "dimension(G) = 1") == Truth::undecided);
    CHECK(last_sentence("D0L { axiom F; F -> F+F; angle 90 }", "dimension(G) <= 2") ==
          "The rules of G give no formula for the dimension.");
    CHECK(truth("S0L { axiom F; F -(1/2)-> FF; F -(1/2)-> F }", "dimension(G) = 1") ==
          Truth::undecided);
}

TEST_CASE("what is so with probability 1 decides nothing") {
    const std::string koch_or_line =
        "S0L { axiom F; F -(1/2)-> F+F--F+F; F -(1/2)-> FFF; angle 60 }";
    for (const char* statement :
         {"dimension(G) = log 4 / log 3", "dimension(G) = 1", "dimension(G) <= 1.5",
          "dimension(G) >= 1", "boundary(G) = log 4 / log 3", "boundary(G) = 1"}) {
        CAPTURE(statement);
        CHECK(truth(koch_or_line, statement) == Truth::undecided);
    }
    CHECK(last_sentence(koch_or_line, "dimension(G) = 1") ==
          "The rules of G give no formula for the dimension.");
}

TEST_CASE("a dimension that is not found in time is undecided, which says nothing of the rules") {
    Budget over;
    over.deadline = std::chrono::steady_clock::now();
    for (const char* statement : {"dimension(G) = 2", "boundary(G) = 1.5", "dimension(G) <= 1"}) {
        CAPTURE(statement);
        const CheckedClaim found = check(claim_of(terdragon, statement), over);
        CHECK(found.statements[0].answer.truth == Truth::undecided);
        CHECK(sentences(found.statements[0].answer, *found.claim.alphabet) ==
              std::vector<std::string>{"the time allowed is over"});
    }
}

TEST_CASE("certificates of dimensions are checked, or say that they are not") {
    const auto found = certified(claim_of(koch, "dimension(G) = log 4 / log 3"));
    CHECK(found.finding.outcome == verify::Finding::Outcome::checked);
    CHECK(found.finding.statement == "the dimension of G is log 4 / log 3");
    CHECK(found.rule() == "limit set");
    const auto least = certified(claim_of(koch, "not dimension(G) >= 4/3"));
    CHECK(least.finding.outcome == verify::Finding::Outcome::checked);
    CHECK(least.finding.statement == "the dimension of G is not at least 4/3");
    const auto coincide = certified(claim_of(folded, "dimension(G) = log 6 / log sqrt 10"));
    CHECK(coincide.finding.outcome == verify::Finding::Outcome::checked);
    CHECK(coincide.rule() == "limit set");
    const auto most = certified(claim_of(terdragon, "not boundary(G) <= 1"));
    CHECK(most.finding.outcome == verify::Finding::Outcome::checked);
    CHECK(most.finding.statement == "the boundary's dimension of G is not at most 1");
}

TEST_CASE("claims are decided by certified bounds where no search ends") {
    const char* const plant = "D0L { axiom X; X -> F-[[X]+X]+F[+FX]-X; F -> FF; angle 90 }";
    CHECK(truth(plant, "dimension(G) <= 1.95") == Truth::proved);
    CHECK(last_sentence(plant, "dimension(G) <= 1.95").find("is at most") != std::string::npos);
    CHECK(truth(plant, "not dimension(G) <= 1.2") == Truth::proved);
    CHECK(truth(plant, "dimension(G) >= 1.5") == Truth::proved);
    CHECK(truth(plant, "dimension(G) >= 1.95") == Truth::refuted);
    CHECK(last_sentence(plant, "dimension(G) >= 1.2").find("is at least") != std::string::npos);
    CHECK(last_sentence(plant, "dimension(G) >= 1.95").find("is at most") != std::string::npos);
    CHECK(last_sentence(plant, "dimension(G) = 1.2").find("is at least") != std::string::npos);
}

TEST_CASE("a dimension that is the claimed one is said once, and polygons are no segments") {
    CHECK(last_sentence(koch, "dimension(G) = log 4 / log 3") ==
          "The dimension of the limit set of G is log 4 / log 3 = 1.261859507143.");
    const auto has_segments = [](const std::string& system) {
        const Claim claim = claim_of(system, "dimension(G) = 1");
        return has_lattice_turtle(
            *std::get<HasDimension>(claim.statements[0].statement.says).system);
    };
    CHECK(has_segments(koch));
    CHECK_FALSE(has_segments("D0L { axiom F; F -> {F+F--F+F}; angle 60 }"));
}
