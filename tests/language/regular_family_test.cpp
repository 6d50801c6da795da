// Infinite languages and families of L-systems: against all small systems, by the table of theory/census/infinite-languages.md, and
// proofs that are changed.

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <functional>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "language/language.hpp"
#include "notation/notation.hpp"
#include "oracle/written_out.hpp"
#include "places.hpp"
#include "verify/verify.hpp"

using namespace algae;
using Outcome = verify::Finding::Outcome;

namespace {

const std::array<std::string, 8> families = {"0L",  "P0L",  "D0L",  "PD0L",
                                             "T0L", "PT0L", "DT0L", "PDT0L"};

CheckedClaim checked(const std::string& statements) {
    return check(read_claim("claim T\n" + statements, "x", {}));
}

/// "yes", "no" or "open".
std::string answer_of(const CheckedStatement& found) {
    return found.answer.truth == Truth::proved    ? "yes"
           : found.answer.truth == Truth::refuted ? "no"
                                                  : "open";
}

/// A system over a and b: of each letter its successors, in each table.
struct Plain {
    std::string axiom;
    std::vector<std::array<std::vector<std::string>, 2>> tables;
};

bool erases(const Plain& system) {
    for (const auto& table : system.tables)
        for (const auto& successors : table)
            if (std::find(successors.begin(), successors.end(), "") != successors.end())
                return true;
    return false;
}

/// The words of at most so many letters that a system derives, by writing out all words of at most `kept` letters. With erasing rules
/// words may be missing, none is too many.
std::set<std::string> derived(const Plain& system, std::size_t longest, std::size_t kept) {
    std::set<std::string> all{system.axiom};
    std::vector<std::string> open{system.axiom};
    while (!open.empty()) {
        const std::string word = open.back();
        open.pop_back();
        for (const auto& table : system.tables) {
            bool cut = false;
            const std::set<std::string> made = oracle::next_words(
                word, kept,
                [&](std::size_t i) { return table[static_cast<std::size_t>(word[i] - 'a')]; }, cut);
            for (const std::string& each : made)
                if (all.insert(each).second) open.push_back(each);
        }
    }
    std::erase_if(all, [&](const std::string& word) { return word.size() > longest; });
    return all;
}

/// A regular expression as claims write it and as a recogniser of words.
struct Recognised {
    std::string text;
    std::function<bool(const std::string&)> has;
};

Recognised random_expression(int depth) {
    if (depth == 0 || *rc::gen::inRange(0, 4) == 0) {
        const std::string word =
            *rc::gen::element<std::string>("a", "b", "aa", "ab", "ba", "bb", "aab");
        return {word, [word](const std::string& other) { return other == word; }};
    }
    const Recognised left = random_expression(depth - 1);
    const int kind = *rc::gen::inRange(0, 4);
    if (kind < 2)  // star, plus
        return {"(" + left.text + ")" + (kind == 0 ? "*" : "+"),
                [left, kind](const std::string& word) {
                    std::vector<char> reached(word.size() + 1, 0);
                    reached[0] = 1;
                    for (std::size_t i = 0; i < word.size(); ++i)
                        for (std::size_t j = i + 1; j <= word.size() && reached[i]; ++j)
                            if (left.has(word.substr(i, j - i))) reached[j] = 1;
                    return word.empty() ? kind == 0 || left.has("") : reached.back() != 0;
                }};
    const Recognised right = random_expression(depth - 1);
    if (kind == 2)
        return {"(" + left.text + "|" + right.text + ")", [left, right](const std::string& word) {
                    return left.has(word) || right.has(word);
                }};
    return {left.text + right.text, [left, right](const std::string& word) {
                for (std::size_t i = 0; i <= word.size(); ++i)
                    if (left.has(word.substr(0, i)) && right.has(word.substr(i))) return true;
                return false;
            }};
}

std::set<std::string> words_up_to(const Recognised& expression, std::size_t longest) {
    std::set<std::string> found;
    std::vector<std::string> words{""};
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (expression.has(words[i])) found.insert(words[i]);
        if (words[i].size() < longest)
            for (const char letter : {'a', 'b'}) words.push_back(words[i] + letter);
    }
    return found;
}

/// The system of a proof by a found system.
Plain system_of(const nlohmann::ordered_json& proof) {
    const auto word = [](std::string text) {
        std::erase(text, ' ');
        return text;
    };
    Plain system{word(proof.at("system").at("axiom").get<std::string>()), {}};
    for (const auto& table : proof.at("system").at("tables")) {
        auto& rules = system.tables.emplace_back();
        for (const char letter : {'a', 'b'}) {
            const std::string name(1, letter);
            auto& successors = rules[static_cast<std::size_t>(letter - 'a')];
            if (table.contains(name))
                for (const auto& each : table.at(name))
                    successors.push_back(word(each.get<std::string>()));
            else
                successors.push_back(name);
        }
    }
    return system;
}

}  // namespace

TEST_CASE("sixty infinite languages are of the families that their table says, with proofs") {
    std::ifstream file(source_folder() + "/theory/census/infinite-languages.md");
    std::string let, line;
    std::size_t languages = 0, decided_0l = 0, decided = 0;
    while (std::getline(file, line)) {
        if (line.starts_with("    let ")) let = line.substr(4) + "\n";
        if (!line.starts_with("| `")) continue;
        ++languages;
        std::vector<std::string> cells;
        std::string cell;
        for (std::size_t i = 1; i < line.size(); ++i) {
            if (line[i] == '|' && line[i - 1] != '\\') {
                cells.push_back(cell);
                cell.clear();
            } else if (line[i] != '\\' || line[i + 1] != '|') {
                cell += line[i];
            }
        }
        REQUIRE(cells.size() == 11);
        const std::string language = cells[0].substr(2, cells[0].size() - 4);
        CAPTURE(language);
        std::string statements = let;
        for (const std::string& family : families)
            statements += "show " + language + " is " + family + "\n";
        const CheckedClaim found = checked(statements);
        const auto findings = verify::check_certificate(certificate(found).dump());
        for (std::size_t i = 0; i < families.size(); ++i) {
            CAPTURE(families[i]);
            const std::string answer = answer_of(found.statements[i]);
            CHECK(" " + answer + " " == cells[i + 1]);
            CHECK(findings[i].outcome ==
                  (answer == "open" ? Outcome::undecided : Outcome::checked));
            decided += answer != "open";
            decided_0l += i == 0 && answer != "open";
        }
        // What is of a family is of those that include it.
        const auto yes = [&](std::size_t i) { return cells[i + 1] == " yes "; };
        for (const auto& [inner, outer] : {std::pair(1, 0),
                                           {2, 0},
                                           {3, 1},
                                           {3, 2},
                                           {0, 4},
                                           {1, 5},
                                           {2, 6},
                                           {3, 7},
                                           {5, 4},
                                           {6, 4},
                                           {7, 5},
                                           {7, 6}})
            if (yes(static_cast<std::size_t>(inner))) CHECK(yes(static_cast<std::size_t>(outer)));
    }
    CHECK(languages == 60);
    CHECK(decided_0l >= 50);
    CHECK(decided >= 430);
}

TEST_CASE("a system that is found for a regular language derives its words and no others") {
    std::size_t compared = 0, refuted = 0, asked = 0;
    CHECK(rc::check([&] {
        const Recognised expression =
            *rc::gen::resize(100, rc::gen::exec([] { return random_expression(3); }));
        const std::string family = *rc::gen::elementOf(families);
        const CheckedClaim found = checked("show /" + expression.text + "/ is " + family);
        const Answer& answer = found.statements[0].answer;
        ++asked;
        const auto findings = verify::check_certificate(certificate(found).dump());
        RC_ASSERT(answer.truth == Truth::undecided || findings[0].outcome == Outcome::checked);
        refuted += answer.truth == Truth::refuted;
        if (answer.truth != Truth::proved) return;
        const auto proof = certificate(found).at("statements")[0].at("proof");
        if (proof.at("by") != "equal") return;  // a finite language
        const Plain system = system_of(proof);
        const std::set<std::string> expected = words_up_to(expression, 5),
                                    some = derived(system, 5, 9);
        for (const std::string& word : some) RC_ASSERT(expected.contains(word));
        // Words that erasing systems derive by way of long ones only are missing.
        if (erases(system) && some != expected) return;
        ++compared;
        RC_ASSERT(some == expected);
    }));
    MESSAGE(compared << " systems compared, " << refuted << " refuted, of " << asked);
    CHECK(compared >= 2);
    CHECK(refuted >= 3);
}

TEST_CASE("no small system generates a regular language that is refuted") {
    // All propagating systems with up to two of these successors for each letter, which derive all their words of at most six letters
    // through such words; and systems that erase, of whose words some may be missing: these must not all be in the language.
    const std::vector<std::string> successors{"",   "a",  "b",   "aa",  "ab",
                                              "ba", "bb", "aaa", "aab", "abb"};
    std::vector<std::vector<std::string>> sets;
    for (std::size_t i = 0; i < successors.size(); ++i)
        for (std::size_t j = i; j < successors.size(); ++j)
            sets.push_back(i == j ? std::vector{successors[i]}
                                  : std::vector{successors[i], successors[j]});
    std::size_t languages = 0, systems = 0;
    CHECK(rc::check([&] {
        const Recognised expression =
            *rc::gen::resize(100, rc::gen::exec([] { return random_expression(3); }));
        const bool propagating = *rc::gen::arbitrary<bool>();
        const CheckedClaim found =
            checked("show /" + expression.text + "/ is " + (propagating ? "P0L" : "0L"));
        if (found.statements[0].answer.truth != Truth::refuted) return;
        ++languages;
        const std::set<std::string> expected = words_up_to(expression, 5);
        for (int tried = 0; tried < 300; ++tried) {
            const auto any = [&] { return sets[*rc::gen::inRange<std::size_t>(0, sets.size())]; };
            Plain system{
                *rc::gen::elementOf(std::vector<std::string>(expected.begin(), expected.end())),
                {{any(), any()}}};
            if (system.axiom.empty()) continue;
            const bool erases = std::any_of(
                system.tables[0].begin(), system.tables[0].end(),
                [](const auto& of) { return std::find(of.begin(), of.end(), "") != of.end(); });
            if (propagating && erases) continue;
            ++systems;
            if (derived(system, 5, 7) != expected) continue;
            // They may differ in longer words.
            std::string text = "let G = 0L { axiom " + system.axiom;
            for (const char letter : {'a', 'b'})
                for (const std::string& successor :
                     system.tables[0][static_cast<std::size_t>(letter - 'a')])
                    text +=
                        std::string("; ") + letter + " -> " + (successor.empty() ? "ε" : successor);
            const CheckedClaim equal = checked(text + " }\nshow L(G) == /" + expression.text + "/");
            RC_ASSERT(equal.statements[0].answer.truth != Truth::proved);
        }
    }));
    MESSAGE(languages << " languages, " << systems << " systems");
    CHECK(languages >= 3);
}

TEST_CASE("proofs that a language is not of a family are refused when they are changed") {
    const auto outcome = [](const std::string& statement,
                            const std::function<void(nlohmann::ordered_json&)>& change) {
        auto json = certificate(checked("show " + statement));
        change(json.at("statements")[0]);
        return verify::check_certificate(json.dump())[0].outcome;
    };
    const auto same = [](nlohmann::ordered_json&) {};
    const auto with = [](const std::string& key, const nlohmann::ordered_json& value) {
        return [key, value](nlohmann::ordered_json& entry) { entry.at("proof")[key] = value; };
    };
    const auto family = [](const std::string& name) {
        return [name](nlohmann::ordered_json& entry) { entry.at("statement").at("is") = name; };
    };
    const std::string mirrored = "/a*b|b*a/ is ";
    CHECK(outcome(mirrored + "0L", same) == Outcome::checked);
    // Words that one word derives, and a case that is left out.
    CHECK(outcome(mirrored + "0L", [](nlohmann::ordered_json& entry) {
              entry.at("proof").at("case").at("cases")[0] = {{"apart", {"a", "a"}}};
          }) == Outcome::wrong);
    CHECK(outcome(mirrored + "0L", [](nlohmann::ordered_json& entry) {
              entry.at("proof").at("case").at("cases") = nlohmann::ordered_json::array();
          }) == Outcome::wrong);
    CHECK(outcome(mirrored + "0L", with("case", {{"letter", "a"}})) == Outcome::wrong);
    CHECK(outcome(mirrored + "0L", with("case", nlohmann::ordered_json::object())) ==
          Outcome::wrong);
    CHECK(outcome(mirrored + "0L", [](nlohmann::ordered_json& entry) {
              // A step that stays in the language: each letter becomes itself.
              auto& step = entry.at("proof").at("case");
              step.at("images") = nlohmann::ordered_json::array();
              for (const char letter : step.at("word").get<std::string>())
                  if (letter != ' ') step.at("images").push_back(std::string(1, letter));
          }) == Outcome::wrong);
    CHECK(outcome(mirrored + "T0L", same) == Outcome::checked);
    CHECK(outcome(mirrored + "T0L", with("apart", {"a", "a"})) == Outcome::wrong);
    CHECK(outcome("/a*b*/ is D0L", same) == Outcome::checked);
    CHECK(outcome("/a*b*/ is D0L", family("0L")) == Outcome::wrong);
    CHECK(outcome("/a*|b*/ is D0L", with("word", "a b")) == Outcome::wrong);
    CHECK(outcome("/a+|b+/ is D0L", with("word", "a")) == Outcome::checked);
    CHECK(outcome("/a+|b+/ is D0L", family("DT0L")) == Outcome::wrong);
    CHECK(outcome("/(ab)+/ is DT0L", same) == Outcome::checked);
    CHECK(outcome("/(ab)+/ is DT0L", family("T0L")) == Outcome::wrong);
    CHECK(outcome("/a*b/ is PT0L", [](nlohmann::ordered_json& entry) {
              entry.at("verdict") = "refuted";
              entry.at("proof") = {{"by", "proportional"}};
          }) == Outcome::wrong);
    CHECK(outcome("{a^n b^n : n >= 0} is 0L", same) == Outcome::checked);
    CHECK(outcome("{a^n b a^n : n >= 0} is 0L", [](nlohmann::ordered_json& entry) {
              entry.at("verdict") = "refuted";
              entry.at("proof") = {{"by", "blocks"}};
          }) == Outcome::wrong);
    const std::string sparse = "{a^(2^n) : n >= 0} | {a^(3^n) : n >= 0} is ";
    CHECK(outcome(sparse + "0L", same) == Outcome::checked);
    CHECK(outcome(sparse + "0L", with("length", 2)) == Outcome::wrong);
    CHECK(outcome(sparse + "0L", with("length", 5)) == Outcome::wrong);
    CHECK(outcome(sparse + "T0L", with("length", 1)) == Outcome::wrong);
    CHECK(outcome("/a*/ is 0L", [](nlohmann::ordered_json& entry) {
              entry.at("proof").at("system").at("tables")[0].at("a") = {"", "a"};
          }) == Outcome::wrong);
}

TEST_CASE("what is not decided of an infinite language says what was tried") {
    const auto said = [](const std::string& statement) {
        const CheckedClaim found = checked("show " + statement);
        REQUIRE(found.statements[0].answer.truth == Truth::undecided);
        return found.statements[0].answer.tried.at(0);
    };
    CHECK(said("/a*b*/ is DT0L") ==
          "no DT0L system for {a}* . {b}* was found among those with successors of at most 7 "
          "letters, and the classes of its words do not show that there is none");
}
