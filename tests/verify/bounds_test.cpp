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
        CHECK(outcome_of(statement, changed::Json::parse(R"({"by": "derivations", "cases": []})"),
                         changed::Json::parse(R"({"axiom": "a", "tables": [{"a": ["a"]}]})")) ==
              "not checked: statement.holds.steps: it is about a system that is not known yet");
    }
}

TEST_CASE("a statement that is too much to read does not end the others") {
    const auto statement = [](const std::string& number) {
        return changed::Json{
            {"text", ""},
            {"statement", {{"derives", "a"}, {"system", "G"}, {"from", "a"}, {"steps", number}}},
            {"verdict", "proved"},
            {"proof", changed::Json::parse(R"({"by": "derivation", "words": ["a", "a"]})")}};
    };
    std::string many = "1";
    for (int i = 0; i <= 10'000; ++i) many += "+1";
    const changed::Json certificate{
        {"format", "algae certificate 1"},
        {"claim", "two"},
        {"alphabet", {"a"}},
        {"systems", {{"G", changed::Json::parse(R"({"axiom": "a", "tables": [{"a": ["a"]}]})")}}},
        {"statements", {statement(many), statement("1")}}};
    const auto found =
        algae::verify::check_certificate(certificate.dump(), "x.json", changed::budget());
    REQUIRE(found.size() == 2);
    using Outcome = algae::verify::Finding::Outcome;
    CHECK(found[0].outcome == Outcome::not_checked);
    CHECK(found[0].statement == "statements[0]");
    CHECK(found[0].reason == "statement.steps: a term of more than 10000 parts");
    CHECK(found[1].outcome == Outcome::checked);
}

TEST_CASE("a count in a statement that has no value is a wrong statement, not the end") {
    for (const char* steps : {"count(G, a, 3)", "length(G, 3)", "distinct segments(G, 3)"}) {
        changed::Json statement = changed::Json::parse(R"({"derives": "a", "system": "G"})");
        statement["steps"] = steps;
        CHECK(outcome_of(
                  statement, {{"by", "exhausted"}},
                  changed::Json::parse(R"({"axiom": "a", "tables": [{"a": ["a", "a a"]}]})")) ==
              "wrong: statement.steps: a system is not D0L");
    }
}

TEST_CASE("lengths of a system without values are no lengths of words") {
    const auto found = [](const char* left, const char* right) {
        changed::Json statement = changed::Json::parse(
            R"j({"for all": [{"name": "H", "of": "P0L systems"}, {"name": "a", "of": "words"}, {"name": "b", "of": "words"}], "with": [{"derives": "b", "system": "H", "from": "a"}], "holds": {}})j");
        statement["holds"] = statement_of_numbers("", "");
        statement["holds"]["numbers"] = {left, "<=", right};
        return outcome_of(
            statement,
            changed::Json::parse(
                R"({"by": "derivations", "cases": [[{"rule": "given", "index": 0}]]})"),
            changed::Json::parse(R"({"axiom": "a", "tables": [{"a": ["a"]}]})"), {"a", "b"});
    };
    CHECK(found("length(a)", "length(b)") == "checked");
    CHECK(found("length(b)", "length(a)") ==
          "wrong: proof.cases[0]: the trees do not show the statement");
    CHECK(found("length(H,1)", "length(b)") ==
          "not checked: statements[0].statement.holds.numbers[0]: it is about a system that is not "
          "known yet");
}

TEST_CASE("automata of long images are refused before they are made") {
    const auto found = [](std::size_t length) {
        std::string image = "a";
        for (std::size_t i = 1; i < length; ++i) image += " a";
        changed::Json system = changed::Json::parse(R"({"axiom": "a", "tables": [{"a": [""]}]})");
        system["tables"][0]["a"][0] = image;
        return outcome_of(
            changed::Json::parse(
                R"({"first order": {"for all": ["x", "y", "z"], "holds": {"or": [{"less": {"of": {"x": "1", "y": "-1"}, "plus": "0"}}, {"less": {"of": {"y": "1", "z": "-1"}, "plus": "0"}}, {"less": {"of": {"z": "1", "x": "-1"}, "plus": "0"}}]}}, "system": "G"})"),
            {{"by", "automata"}}, system);
    };
    CHECK(found(20).starts_with("wrong: "));
    CHECK(found(150).starts_with("not checked: the automata would take more than the 256 MiB"));
    CHECK(found(700).starts_with("not checked: automata that read 3 numbers at once"));
    CHECK(found(7000).starts_with("not checked: automata that read "));
}

TEST_CASE("what is large or deep ends no checker") {
    const changed::Json one = changed::Json::parse(R"({"axiom": "a", "tables": [{"a": ["a a"]}]})");
    changed::Json multiple = changed::Json::parse(
        R"({"first order": {"exists": ["i"], "holds": {"equation": {"of": {"i": "1"}, "plus": "0"}}}, "system": "G"})");
    multiple["first order"]["holds"]["equation"]["of"]["i"] = std::string(9'000, '7');
    CHECK(
        outcome_of(
            multiple,
            changed::Json::parse(
                R"({"by": "automata", "addition": {"edges": [[0,0,0,0,0],[0,0,1,1,0],[0,1,0,1,0],[0,1,1,0,1],[1,0,0,1,0],[1,0,0,0,1]], "accepting": [true, false]}})"),
            one)
            .starts_with("not checked: multiples of more than 90 digits"));
    changed::Json names{{"for all", changed::Json::array()},
                        {"holds", {{"numbers", {"1", "=", "1"}}}}};
    for (int i = 0; i < 60'000; ++i)
        names["for all"].push_back(
            {{"name", "n" + std::to_string(i)}, {"of", "numbers"}, {"up to", 0}});
    CHECK(outcome_of(names, changed::Json::parse(R"({"by": "cases", "cases": []})"), one) ==
          "not checked: the instances are not enumerated again: there are more than 100 names");
    changed::Json powers{{"powers", changed::Json::array()},
                         {"numbers", {{{"name", "n"}, {"least", 0}}}}};
    for (int i = 0; i < 40'000; ++i)
        powers["powers"].push_back(
            {{"word", "a"},
             {"exponent",
              {i == 0 ? changed::Json::parse(R"({"coefficient": 1, "number": "n", "power": 1})")
                      : changed::Json{{"coefficient", 1}}}}});
    CHECK(outcome_of({{"equal", {powers, changed::Json::parse(R"({"star": {"words": ["a"]}})")}}},
                     {{"by", "derivatives"}},
                     one) == "not checked: more than 5000 languages stand within each other");
    changed::Json modules = changed::Json::parse(
        R"({"axiom": [["a"]], "modules": [{"module": ["a"], "successor": []}]})");
    for (int i = 0; i < 1'001; ++i) modules["modules"][0]["elsewhere"].push_back({"a"});
    CHECK(outcome_of(changed::Json::parse(R"({"derives": [["a"]], "system": "G", "steps": 0})"),
                     {{"by", "rewriting"}},
                     modules) == "error: systems.G.modules[0]: more than 1000 modules around one");
    CHECK(
        outcome_of(
            changed::Json::parse(
                R"({"for all": [{"name": "h", "of": "finite substitutions"}], "holds": {"is": "finite", "language": {"image": {"words": ["a a a a a a a a a a a a a a a a a a a a a a"]}, "morphism": "h"}}})"),
            changed::Json::parse(
                R"({"by": "instance", "values": {"h": {"a": ["", "a"]}}, "proof": {"by": "values"}})"),
            one)
            .starts_with("wrong: "));
}
