// A short run of tools/mutate-certificates.

#include <doctest/doctest.h>

#include "exact/exact.hpp"
#include "language/language.hpp"
#include "notation/notation.hpp"
#include "verify/mutants.hpp"
#include "verify/samples.hpp"

namespace {

/// A certificate of each statement.
std::vector<mutants::Json> certificates() {
    std::vector<mutants::Json> all;
    for (const samples::Sample& sample : samples::sound())
        all.push_back(samples::certificate(sample));
    const mutants::Json whole = algae::certificate(algae::check(algae::read_claim(R"(claim T
let G = 0L { axiom a; a -> a | aa }
let T = ET0L { axiom S; terminals a b; table x; S -> aS; table y; S -> b | ε }
let H = D0L { axiom ab; a -> b; b -> ab }
show {a, aa} is not 0L
show {ε, a, aa} is 0L
show L(T) is finite or aab in L(T)
show for all finite languages A up to size 3: A is finite
show for all D0L systems G up to size 4: L(G) is D0L
show not for all 0L languages A, B: A | B is 0L
show for all words w up to length 2 over {a, b}: w in {w}
show L(H) == L(H) | {ab}
show {a} L(G)+ <= /aa+/
show sequence(H) == sequence(H)
show growth(H) ~ exponential
)",
                                                                                  "x", {})));
    for (std::size_t i = 0; i < whole["statements"].size(); ++i)
        all.push_back(mutants::with_statement(whole, i));
    return all;
}

}  // namespace

TEST_CASE("no mutant of a certificate is accepted with a false statement") {
    const auto all = certificates();
    mutants::Mutator mutate(7);
    mutants::Counts counts;
    for (std::size_t i = 0; counts.mutants < 800; ++i)
        counts.add(mutants::judged(all[i % all.size()], all[mutate.below(all.size())], 4, mutate,
                                   std::chrono::milliseconds(200)));
    for (const std::string& example : counts.examples) FAIL_CHECK(example);
    CHECK(counts.wrong == 0);
    CHECK(counts.rejected > counts.mutants / 2);
    CHECK(counts.confirmed > 5);  // the second route is asked, and knows something
}

TEST_CASE("the second route knows true and false statements of certificates") {
    using mutants::Json;
    const auto truth = [](const char* statement) {
        return algae::oracle::truth_of(samples::certificate({statement, "proved", "{}"}),
                                       Json::parse(statement), {})
            .holds;
    };
    CHECK(truth(R"({"member": "a a", "language": {"generated": "G"}})") == true);
    CHECK(truth(R"({"member": "a b", "language": {"generated": "G"}})") == false);
    CHECK(truth(R"({"is": "0L", "language": {"words": ["a", "a a"]}})") == false);
    CHECK(
        truth(
            R"({"equal": [{"generated": "P"}, {"union": [{"words": ["a"]}, {"generated": "Q"}]}]})") ==
        false);
    CHECK(truth(R"({"included": [{"generated": "E"}, {"plus": {"words": ["a"]}}]})") == true);
    CHECK(truth(R"({"not": {"equal sequences": ["U", "V"]}})") == false);
    CHECK(
        truth(
            R"j({"for all": [{"name": "n", "of": "numbers"}], "holds": {"numbers": ["length(P,n)", "=", "n+1"]
}
})j") == false);
    CHECK(
        truth(
            R"({"words": [[{"system": "U", "generation": "0"}], "==", [{"system": "U", "generation": "0"}]]})") ==
        true);
    CHECK(
        truth(
            R"({"equal": [{"powers": [{"word": "a", "exponent": [{"coefficient": 2, "number": "n", "power": 1}]}], "numbers": [{"name": "n", "least": 0}]}, {"star": {"words": ["a"]}}]})") ==
        false);
    CHECK(truth(R"({"palindrome": "a b a"})") == true);
    CHECK(truth(R"({"is": "prefix code", "language": {"words": ["a", "a b"]}})") == false);
    CHECK(
        truth(
            R"({"for all": [{"name": "A", "of": "finite languages", "size": 3}], "holds": {"is": "0L", "language": {"name": "A"}}})") ==
        false);
    std::size_t known = 0;
    for (const samples::Sample& sample : samples::sound()) {
        const Json certificate = samples::certificate(sample);
        const auto found = algae::oracle::truth_of(
            certificate, certificate["statements"][0]["statement"], samples::small_budget());
        if (!found.holds) continue;
        ++known;
        CHECK_MESSAGE(*found.holds == (std::string(sample.verdict) == "proved"), sample.statement);
    }
    CHECK(known > 40);
}
