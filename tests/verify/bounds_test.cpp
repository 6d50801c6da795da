// Texts that are too long for the files of tests/verify/certificates: at the bounds of the checker, and next to them.

#include <doctest/doctest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "exact/exact.hpp"
#include "verify/changed.hpp"

namespace {

changed::Json statement_of_numbers(const std::string& left, const std::string& right) {
    return {{"numbers", {left, "=", right}}};
}

/// What is said of a statement with its proof, about a system G.
std::string outcome_of(const changed::Json& statement, const changed::Json& proof,
                       const changed::Json& system,
                       const std::vector<std::string>& alphabet = {"a"}) {
    return changed::found(changed::certificate_of({{"alphabet", alphabet},
                                                   {"systems", {{"G", system}}},
                                                   {"statement", statement},
                                                   {"verdict", "proved"},
                                                   {"proof", proof}}))
        .outcome;
}

std::string outcome_of_numbers(const std::string& left, const std::string& right) {
    return outcome_of(statement_of_numbers(left, right), {{"by", "values"}},
                      changed::Json::parse(R"({"axiom": "a", "tables": [{"a": ["a"]}]})"));
}

}  // namespace

TEST_CASE("a number in a term has up to 10000 digits") {
    const std::string where = "not checked: statements[0].statement.numbers[0]: ";
    const std::string number(10'000, '1');
    CHECK(outcome_of_numbers(number, number) == "checked");
    CHECK(outcome_of_numbers(number + "1", "1") == where + "a number of more than 10000 digits");
}

TEST_CASE("a number of a module has up to 20000 characters") {
    const auto read = [](const std::string& number) {
        changed::Json system = changed::Json::parse(R"({"axiom": [["a", ""]], "modules": []})");
        system["axiom"][0][1] = number;
        return outcome_of(
            changed::Json::parse(
                R"({"derives": [["a", "0"]], "system": "G", "from": [["a", "0"]], "steps": 0})"),
            {{"by", "rewriting"}}, system);
    };
    CHECK(read(std::string(20'000, '0')) == "checked");
    CHECK(read(std::string(20'001, '0')) ==
          "error: systems.G.axiom[0][1]: expected a number, found '" + std::string(60, '0') +
              "...'");
}

TEST_CASE("a word that is derived in no step may be long") {
    std::string word = "a";
    for (int i = 0; i < 4000; ++i) word += " a";
    const auto found = [&](const char* language) {
        changed::Json statement = changed::Json::parse(language),
                      system = changed::Json::parse(R"({"axiom": "", "tables": [{"a": ["a"]}]})");
        statement["member"] = system["axiom"] = word;
        return outcome_of(statement, {{"by", "membership"}}, system);
    };
    CHECK(found(R"({"language": {"concatenation": [{"words": [""]}, {"generated": "G"}]}})") ==
          "not checked: a word of 4001 letters is not taken apart in all ways, only up to 4000");
    CHECK(found(R"({"language": {"intersection": [{"generated": "G"}, {"generated": "G"}]}})") ==
          "checked");
}

TEST_CASE("numbers of steps do not speak of systems without values") {
    for (const char* steps : {"length(H,1)", "boxes(H,1,1)", "distinct segments(H,1)"}) {
        changed::Json statement = changed::Json::parse(
            R"({"for all": [{"name": "H", "of": "0L systems"}], "holds": {"derives": "a", "system": "H", "from": "a"}})");
        statement["holds"]["steps"] = steps;
        CHECK_THROWS_WITH_AS(
            outcome_of(statement, changed::Json::parse(R"({"by": "derivations", "cases": []})"),
                       changed::Json::parse(R"({"axiom": "a", "tables": [{"a": ["a"]}]})")),
            "statements[0].statement.holds.steps: it is about a system that is not known yet",
            algae::BoundReached);
    }
}
