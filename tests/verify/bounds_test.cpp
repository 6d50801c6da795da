// Texts that are too long for the files of tests/verify/certificates: at the bounds of the checker, and next to them.

#include <doctest/doctest.h>

#include <cstdio>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "exact/exact.hpp"
#include "verify/changed.hpp"
#include "verify/detail/limit_set.hpp"

namespace {

changed::Json statement_of_numbers(const std::string& left, const std::string& right) {
    return {{"numbers", {left, "=", right}}};
}

/// What is said of a statement with its proof, about a system G.
std::string outcome_of(const changed::Json& statement, const changed::Json& proof,
                       const changed::Json& system,
                       const std::vector<std::string>& alphabet = {"a"},
                       const char* verdict = "proved",
                       const algae::Budget& budget = changed::budget()) {
    return changed::found(changed::certificate_of({{"alphabet", alphabet},
                                                   {"systems", {{"G", system}}},
                                                   {"statement", statement},
                                                   {"verdict", verdict},
                                                   {"proof", proof}}),
                          budget)
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

namespace {

const changed::Json& one() {
    static const changed::Json system =
        changed::Json::parse(R"({"axiom": "a", "tables": [{"a": ["a a"]}]})");
    return system;
}

}  // namespace

TEST_CASE("multiples of more than 300 bits are not worked out again") {
    const auto found = [](const algae::Integer& times) {
        changed::Json multiple = changed::Json::parse(
            R"({"first order": {"exists": ["i"], "holds": {"equation": {"of": {"i": "1"}, "plus": "0"}}}, "system": "G"})");
        multiple["first order"]["holds"]["equation"]["of"]["i"] = to_string(times);
        return outcome_of(
            multiple,
            changed::Json::parse(
                R"({"by": "automata", "addition": {"edges": [[0,0,0,0,0],[0,0,1,1,0],[0,1,0,1,0],[0,1,1,0,1],[1,0,0,1,0],[1,0,0,0,1]], "accepting": [true, false]}})"),
            one());
    };
    const algae::Integer most = algae::power(algae::Integer(2), 300);
    const std::string beyond = "not checked: multiples of more than 90 digits";
    CHECK_FALSE(found(most - algae::Integer(1)).starts_with(beyond));
    CHECK(found(most).starts_with(beyond));
    CHECK(found(algae::Integer(std::string(9'000, '7'))).starts_with(beyond));
}

TEST_CASE("instances of up to 100 names are enumerated again") {
    const auto found = [](int count) {
        changed::Json names{{"for all", changed::Json::array()},
                            {"holds", {{"numbers", {"1", "=", "1"}}}}};
        for (int i = 0; i < count; ++i)
            names["for all"].push_back(
                {{"name", "n" + std::to_string(i)}, {"of", "numbers"}, {"up to", 0}});
        return outcome_of(names, changed::Json::parse(R"({"by": "cases", "cases": []})"), one());
    };
    const std::string refused =
        "not checked: the instances are not enumerated again: there are more than 100 names";
    CHECK(found(100).starts_with("wrong: proof.cases: there is no case for n0 = 0, "));
    CHECK(found(101) == refused);
    CHECK(found(20'000) == refused);
}

TEST_CASE("complements are not enumerated beside one of several names that is a morphism") {
    CHECK(
        outcome_of(
            changed::Json::parse(
                R"({"for all": [{"name": "h", "of": "codings"}, {"name": "n", "of": "numbers", "up to": 1}], "holds": {"equal": [{"complement": {"words": ["a"]}}, {"complement": {"words": ["a"]}}]}})"),
            changed::Json::parse(R"({"by": "cases", "cases": []})"), one()) ==
        "not checked: the instances are not enumerated again: a complement may be over the "
        "letters of a morphism");
}

TEST_CASE("up to 1000 languages stand within each other") {
    const auto found = [](int count) {
        changed::Json powers{{"powers", changed::Json::array()},
                             {"numbers", {{{"name", "n"}, {"least", 0}}}}};
        for (int i = 0; i < count; ++i)
            powers["powers"].push_back(
                {{"word", "a"},
                 {"exponent",
                  {i == 0 ? changed::Json::parse(R"({"coefficient": 1, "number": "n", "power": 1})")
                          : changed::Json{{"coefficient", 1}}}}});
        algae::Budget budget;
        budget.memory = 100 << 20;
        return outcome_of(
            {{"equal", {powers, changed::Json::parse(R"({"star": {"words": ["a"]}})")}}},
            {{"by", "derivatives"}}, one(), {"a"}, "proved", budget);
    };
    const std::string beyond = "not checked: more than 1000 languages stand within each other";
    CHECK(found(20'000) == beyond);
    CHECK(found(998) == "not checked: the derivatives would take more than the 100 MiB allowed");
    CHECK(found(999) == beyond);
}

TEST_CASE("up to 1000 modules stand around one in a rule") {
    const auto found = [](const char* side, int count) {
        changed::Json modules = changed::Json::parse(
            R"({"axiom": [["a"]], "modules": [{"module": ["a"], "successor": []}]})");
        for (int i = 0; i < count; ++i) modules["modules"][0][side].push_back({"a"});
        return outcome_of(
            changed::Json::parse(R"({"derives": [["a"]], "system": "G", "steps": 0})"),
            {{"by", "rewriting"}}, modules);
    };
    for (const char* side : {"left", "right", "elsewhere"}) {
        CHECK(found(side, 1'000) == "checked");
        CHECK(found(side, 1'001) ==
              "error: systems.G.modules[0]: more than 1000 modules around one");
    }
}

TEST_CASE("an image has up to 100000 words") {
    const auto found = [](int first, int second) {
        changed::Json images{{"a", changed::Json::array()}, {"b", changed::Json::array()}};
        const auto add = [&](const char* letter, int count) {
            for (int i = 0; i < count; ++i) {
                std::string word = "a";
                for (int k = 0; k < 14; ++k) word += i >> k & 1 ? " b" : " a";
                images[letter].push_back(word);
            }
        };
        add("a", first);
        add("b", second);
        return outcome_of(
            changed::Json::parse(
                R"({"for some": [{"name": "h", "of": "finite substitutions"}], "holds": {"is": "finite", "language": {"image": {"words": ["a b"]}, "morphism": "h"}}})"),
            {{"by", "instance"}, {"values", {{"h", images}}}, {"proof", {{"by", "values"}}}}, one(),
            {"a", "b"});
    };
    CHECK(found(250, 400) == "checked");
    CHECK(found(11, 9'091) == "not checked: an image of more than 100000 words is not checked");
}

TEST_CASE("words of sequences have up to 50000000 letters together") {
    changed::Json slow = changed::Json::parse(R"({"axiom": "", "tables": [{}]})");
    std::vector<std::string> alphabet;
    std::string word;
    const auto circle = [&](int size) {
        for (int i = 0; i < size; ++i) {
            alphabet.push_back("c" + std::to_string(size) + std::to_string(i));
            slow["tables"][0][alphabet.back()] = {"c" + std::to_string(size) +
                                                  std::to_string((i + 1) % size)};
        }
        word += "c" + std::to_string(size) + "0 ";
    };
    for (const int size : {2, 3, 5, 7, 11}) circle(size);
    alphabet.push_back("x");
    for (int i = 0; i < 60'000; ++i) word += i == 0 ? "x" : " x";
    slow["axiom"] = word;
    changed::Json certificate =
        changed::certificate_of({{"alphabet", alphabet},
                                 {"systems", {{"G", slow}, {"H", slow}}},
                                 {"statement", {{"equal sequences", {"G", "H"}}}},
                                 {"verdict", "proved"},
                                 {"proof", {{"by", "lengths"}}}});
    algae::Budget budget;
    CHECK(changed::found(certificate, budget).outcome ==
          "not checked: the words of the sequences are too long");
    budget.memory = 52 << 20;
    CHECK(changed::found(certificate, budget).outcome ==
          "not checked: the words of the sequences would take more than the 52 MiB allowed");
}

TEST_CASE("up to 1000000 segments of a figure are counted") {
    changed::Json system = changed::Json::parse(R"({"axiom": "F", "tables": [{"F": ["F F"]}]})");
    changed::Json certificate = changed::certificate_of(
        {{"header",
          changed::Json::parse(R"({"turtles": {"G": {"turn": "1/4", "letters": {"F": "F"}}}})")},
         {"alphabet", {"F"}},
         {"systems", {{"G", system}}},
         {"statement", statement_of_numbers("distinct segments(G, 20)", "1048576")},
         {"verdict", "proved"},
         {"proof", {{"by", "values"}}}});
    CHECK(changed::found(certificate).outcome ==
          "not checked: more than 1000000 segments are not counted");
}

TEST_CASE("names of four kinds are bound once") {
    for (const char* of :
         {"languages", "D0L systems", "morphisms", "numbers", "words", "letters"}) {
        changed::Json statement = changed::Json::parse(
            R"({"for all": [{"name": "x", "of": ""}], "holds": {"for all": [{"name": "x", "of": "numbers"}], "holds": {"numbers": ["1", "=", "1"]}}})");
        statement["for all"][0]["of"] = of;
        CHECK(outcome_of(statement, {{"by", "values"}}, one(), {"a", "x"}) ==
              "error: statements[0].statement.holds.for all[0].name: expected another name, as "
              "this one is bound already");
    }
}

TEST_CASE("characters that steer are written by their numbers") {
    const auto utf8 = [](unsigned code) {
        std::string text;
        if (code < 0x80) {
            text += static_cast<char>(code);
        } else if (code < 0x800) {
            text += static_cast<char>(0xC0 | code >> 6);
            text += static_cast<char>(0x80 | (code & 63));
        } else {
            text += static_cast<char>(0xE0 | code >> 12);
            text += static_cast<char>(0x80 | (code >> 6 & 63));
            text += static_cast<char>(0x80 | (code & 63));
        }
        return text;
    };
    const auto steers = [](unsigned code) {
        return code < 0x20 || (0x7F <= code && code < 0xA0) || (0x200B <= code && code <= 0x200F) ||
               (0x2028 <= code && code <= 0x202E) || (0x2060 <= code && code <= 0x206F);
    };
    std::size_t count = 0;
    for (unsigned begin = 1; begin < 0x3100; begin += 50) {
        std::string name, expected;
        for (unsigned code = begin; code < begin + 50; ++code) {
            name += utf8(code) + "x" + utf8(code);
            std::string number(code < 0x80 ? 10 : 16, ' ');
            std::snprintf(number.data(), number.size(), code < 0x80 ? "\\x%02x" : "\\u%04x", code);
            const std::string shown = steers(code) ? number.c_str() : utf8(code);
            expected += shown + "x" + shown;
            count += steers(code);
        }
        try {
            algae::verify::check_certificate(
                changed::Json{{"format", "algae certificate 1"}, {name, 1}}.dump(), "x.json",
                changed::budget());
            FAIL("such a field is not known");
        } catch (const algae::Error& error) {
            CAPTURE(begin);
            CHECK((error.what() == "x.json:1: unexpected field '" + expected + "'"));
        }
    }
    CHECK(count == 31 + 33 + 5 + 7 + 16);
}

namespace {

/// What is said of the dimension of a line F -> FF that has more letters, with changes of the certificate.
std::string outcome_of_line(const std::vector<std::string>& more,
                            const std::function<void(changed::Json&)>& change) {
    changed::Json one = changed::Json::parse(
        R"({"header": {"turtles": {"G": {"turn": "1/2", "letters": {"F": "F"}}}}, "alphabet": ["F"], "systems": {"G": {"axiom": "F", "tables": [{"F": ["F F"]}]}}, "statement": {"dimension": "G", "equals": "1"}, "verdict": "proved", "proof": {"by": "limit set", "order": 2, "phases": 1, "scale": [[2]], "turn": [["-1"]], "ways": [["F", 0, [1]]], "factor": ["2", "0"]}})");
    std::string axiom = "F";
    for (const std::string& letter : more) {
        one["alphabet"].push_back(letter);
        one["systems"]["G"]["tables"][0][letter] = {letter};
        one["proof"]["ways"].push_back({letter, 0, {0}});
        axiom += " " + letter;
    }
    one["systems"]["G"]["axiom"] = axiom;
    change(one);
    return changed::found(changed::certificate_of(one)).outcome;
}

std::vector<std::string> letters(std::size_t count) {
    std::vector<std::string> all;
    for (std::size_t i = 0; i < count; ++i) all.push_back("c" + std::to_string(i));
    return all;
}

}  // namespace

TEST_CASE("limit sets have up to 24 dimensions, 400 pieces, 3600 directions and 64 phases") {
    const auto nothing = [](changed::Json&) {};
    const std::string only_above = "wrong: proof: an upper bound does not show this",
                      too_many = "not checked: there are too many ",
                      too_large = "not checked: positions lie in too large a field";
    CHECK(outcome_of_line({}, nothing) == only_above);
    CHECK(outcome_of_line(letters(149), nothing) == only_above);
    CHECK(outcome_of_line(letters(150), nothing) == too_many + "letters and directions");
    CHECK(outcome_of_line(letters(399), nothing) == too_many + "letters and directions");
    CHECK(outcome_of_line(letters(400), nothing) == too_many + "pieces");
    const auto changed_to = [](const char* field, changed::Json value) {
        return outcome_of_line({}, [&](changed::Json& one) { one["proof"][field] = value; });
    };
    CHECK(changed_to("order", 3600) ==
          "wrong: proof.turn: no numbers are seen on which it acts as a turn");
    CHECK(changed_to("order", 3601) ==
          "error: statements[0].proof.order: expected a number from 1 to 3600");
    CHECK(changed_to("phases", 64) ==
          "wrong: proof.ways: the way of 'F' does not follow from its successor's");
    CHECK(changed_to("phases", 65) ==
          "error: statements[0].proof.phases: expected a number from 1 to 64");
    CHECK(changed_to("scale", changed::Json::array()) == too_large);
    CHECK(changed_to("scale", std::vector<changed::Json>(24, {1})) ==
          "error: statements[0].proof.scale[0]: expected 24 integers in a row");
    CHECK(changed_to("scale", std::vector<changed::Json>(25, {1})) == too_large);
}

TEST_CASE("turns of letters come back within 10000 generations") {
    const auto found = [](int circle) {
        std::vector<std::string> more = letters(static_cast<std::size_t>(circle));
        more.insert(more.end(), {"+", "A"});
        return outcome_of_line(more, [&](changed::Json& one) {
            changed::Json& table = one["systems"]["G"]["tables"][0];
            for (int i = 0; i < circle; ++i)
                table["c" + std::to_string(i)] = {"c" + std::to_string((i + 1) % circle)};
            table["A"] = {"A +"};
            one["header"]["turtles"]["G"]["turn"] = "1/73";
            one["header"]["turtles"]["G"]["letters"]["+"] = "+";
            one["header"]["turtles"]["G"]["letters"]["c0"] = "+";
            one["proof"]["order"] = 73;
        });
    };
    CHECK(found(136) == "wrong: proof.phases: turns do not come back after so many generations");
    CHECK(found(137) == "not checked: turns do not come back");
}

TEST_CASE("parts meet in up to 20000 ways") {
    const auto found = [](int count) {
        return outcome_of_line({}, [&](changed::Json& one) {
            one["proof"]["component"] = changed::Json::parse(R"(["F", 0])");
            one["proof"]["discs"] = changed::Json::parse(R"([["F", 0, "0.5", "0", "0.51"]])");
            one["proof"]["neighbours"] = changed::Json::array();
            for (int i = 1; i <= count; ++i)
                one["proof"]["neighbours"].push_back({"F", "F", 0, 0, {i}});
        });
    };
    CHECK(found(3) == "checked");
    CHECK(found(20'000) == "checked");
    CHECK(found(20'001) == "not checked: parts meet in too many ways");
}

TEST_CASE("the size and letters of a system with context are not known") {
    const auto found = [](const char* bound) {
        changed::Json statement = changed::Json::parse(
            R"({"for some": [{"name": "x", "of": "IL systems"}], "holds": {"numbers": ["1", "=", "1"]}})");
        if (*bound != 0) statement["for some"][0][bound] = 90;
        return outcome_of(
            statement,
            changed::Json::parse(
                R"({"by": "instance", "values": {"x": {"axiom": "a", "rules": [{"left": "a", "letter": "a", "right": "", "successor": "a a"}]}}, "proof": {"by": "values"}})"),
            one());
    };
    CHECK(found("") == "checked");
    for (const char* bound : {"size", "length"})
        CHECK(found(bound) ==
              "wrong: proof.values.x: the size and letters of a system with context are not known");
}

TEST_CASE("a letter that never occurs in a value has no rule, and were it the first") {
    const auto found = [](const char* rules) {
        changed::Json statement = changed::Json::parse(
            R"({"for some": [{"name": "x", "of": "0L systems"}], "holds": {"numbers": ["1", "=", "1"]}})");
        changed::Json proof = changed::Json::parse(
            R"({"by": "instance", "values": {"x": {"axiom": "b", "tables": []}}, "proof": {"by": "values"}})");
        proof["values"]["x"]["tables"].push_back(changed::Json::parse(rules));
        return outcome_of(statement, proof, one(), {"a", "b", "c"});
    };
    CHECK(found(R"({"b": ["b b"]})") == "checked");
    CHECK(found(R"({"b": ["b b"], "a": ["b"]})") ==
          "wrong: proof.values.x: a letter that never occurs has a rule");
    CHECK(found(R"({"b": ["b b"], "c": ["b"]})") ==
          "wrong: proof.values.x: a letter that never occurs has a rule");
}

TEST_CASE("rates are below a number where weights show it, rounded up") {
    using algae::Integer;
    using algae::Rational;
    using Weights = std::vector<std::uint64_t>;
    constexpr std::uint64_t none = std::uint64_t{1} << 46;  // more than any image may be
    const auto below = [](std::uint64_t units,
                          const std::function<std::uint64_t(std::uint64_t)>& image) {
        return algae::verify::limits::grows_below(
            1, Rational(Integer(units), Integer(std::uint64_t{1} << 18)),
            [&](std::size_t, const Weights& weights) { return image(weights[0]); }, {});
    };
    CHECK(below((2 << 18) + 300, [](std::uint64_t w) { return 2 * w; }));
    CHECK_FALSE(below(2 << 18, [](std::uint64_t w) { return 2 * w; }));
    // The weight becomes 4096 and 2^18 / units, rounded up.
    CHECK_FALSE(below(3, [&](std::uint64_t w) { return w >= 4096 + 87'382 ? none : 1; }));
    CHECK(below(3, [&](std::uint64_t w) { return w > 4096 + 87'382 ? none : 1; }));
    CHECK(below(4, [&](std::uint64_t w) { return w > 4096 + 65'536 ? none : 1; }));
}

TEST_CASE("words of up to 10000000 letters are compared") {
    const auto found = [](const char* axiom) {
        changed::Json statement = changed::Json::parse(
            R"({"words": [[{"system": "G", "generation": "7"}], "==", [{"system": "G", "generation": "7"}]]})");
        changed::Json system = changed::Json::parse(
            R"({"axiom": "", "tables": [{"a": ["a a a a a a a a a a"], "b": ["b"]}]})");
        system["axiom"] = axiom;
        return outcome_of(statement, {{"by", "words"}}, system, {"a", "b"});
    };
    CHECK(found("a") == "checked");
    CHECK(found("b a") == "not checked: a word has more than 10000000 letters");
}

TEST_CASE("recurrences have up to 5000 terms, and 50000 values are compared") {
    const auto found = [](const char* left) {
        changed::Json statement = changed::Json::parse(
            R"({"for all": [{"name": "n", "of": "numbers"}, {"name": "m", "of": "numbers"}], "holds": {"numbers": ["", "=", "2"]}})");
        statement["holds"]["numbers"][0] = left;
        return outcome_of(statement, {{"by", "recurrences"}}, one());
    };
    CHECK(found("n^999+n^999+n^999+n^999+n^999") ==
          "wrong: proof: both sides differ for m = 0, n = 0");
    CHECK(found("n^999+n^999+n^999+n^999+n^999+1") ==
          "not checked: a term has a recurrence of more than 5000 terms");
    CHECK(found("n^198*m^248") == "wrong: proof: both sides differ for m = 0, n = 0");
    CHECK(found("n^19*m^19*m^118") ==
          "not checked: it would take more than 50000 values of the numbers");
}

TEST_CASE("words that are derived with contexts have up to 50000000 letters together") {
    // c becomes all words over a and b, with 20000 letters before it.
    changed::Json system = changed::Json::parse(
        R"({"axiom": "", "rules": [{"left": "", "letter": "c", "right": "", "successor": "a c"}, {"left": "", "letter": "c", "right": "", "successor": "b c"}, {"left": "c", "letter": "c", "right": "", "successor": ""}]})");
    std::string axiom;
    for (int i = 0; i < 20'000; ++i) axiom += "a ";
    system["axiom"] = axiom + "c";
    const auto found = [&](const char* statement) {
        return outcome_of(changed::Json::parse(statement), {{"by", "exhausted"}}, system,
                          {"a", "b", "c"}, "refuted", {});
    };
    const std::string refused = "not checked: the words derived are too long or too many";
    CHECK(found(R"({"derives": "b", "system": "G"})") == refused);
    CHECK(found(R"({"derives": "b", "system": "G", "steps": 100})") == refused);
}

TEST_CASE("a word is kept out by an automaton, or all letters are terminals") {
    const auto found = [](const char* system, const char* proof) {
        return outcome_of(changed::Json::parse(R"({"derives": "b", "system": "G"})"),
                          changed::Json::parse(proof), changed::Json::parse(system), {"a", "b"},
                          "refuted");
    };
    const char* const all = R"({"axiom": "a", "tables": [{"a": ["a a"]}]})";
    const char* const terminals = R"({"axiom": "a", "tables": [{"a": ["a a"]}], "terminals": "a"})";
    const char* const without = R"({"by": "invariant", "automata": {}})";
    const char* const with =
        R"({"by": "invariant", "automata": {"G": {"accepting": [1], "moves": [{"from": 0, "letter": "a", "to": 1}, {"from": 1, "letter": "a", "to": 1}]}}})";
    const char* const context =
        R"({"axiom": "a", "rules": [{"left": "", "letter": "a", "right": "", "successor": "a a"}]})";
    CHECK(found(all, with) == "wrong: proof.automata.G: the system has no context");
    CHECK(found(all, without) == "checked");
    CHECK(found(terminals, without) ==
          "wrong: proof: the system has letters that are no terminals, and no automaton");
    CHECK(found(context, with) == "checked");
    CHECK(found(context, without) ==
          "not checked: the words take more than a sixteenth of the 256 MiB allowed");
    CHECK(outcome_of(changed::Json::parse(R"({"derives": "a a a", "system": "G"})"),
                     changed::Json::parse(with), changed::Json::parse(context), {"a", "b"},
                     "refuted") == "wrong: proof: the automata do not keep the word out");
}
