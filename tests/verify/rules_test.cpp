#include <doctest/doctest.h>

#include "exact/exact.hpp"
#include "verify/changed.hpp"
#include "verify/samples.hpp"

using namespace samples;
using Outcome = algae::verify::Finding::Outcome;

TEST_CASE("sound proofs of every kind are checked") {
    for (const Sample& sample : sound()) {
        INFO(sample.statement << " " << sample.verdict << " " << sample.proof);
        const auto found = check(certificate(sample));
        REQUIRE(found.size() == 1);
        CHECK_MESSAGE(found[0].outcome == Outcome::checked,
                      found[0].path << ": " << found[0].reason);
    }
}

TEST_CASE("the other verdict never passes") {
    for (const Sample& sample : sound()) {
        INFO(sample.statement << " " << sample.verdict << " " << sample.proof);
        Json changed = certificate(sample);
        Json& verdict = changed["statements"][0]["verdict"];
        verdict = verdict == "proved" ? "refuted" : "proved";
        CHECK(check(changed)[0].outcome != Outcome::checked);
        Json negated = certificate(sample);
        Json& statement = negated["statements"][0]["statement"];
        statement = Json{{"not", statement}};
        CHECK(check(negated)[0].outcome != Outcome::checked);
    }
}

TEST_CASE("a wrong proof is named with its path, line and reason") {
    Json bad = certificate(Json::parse(R"({"derives": "a b a", "system": "F"})"), "proved",
                           Json::parse(R"({"by": "derivation", "words": ["a", "a b", "a b b"]})"));
    const auto found = check(bad)[0];
    CHECK(found.outcome == Outcome::wrong);
    CHECK(found.path == "statements[0].proof.words[2]");
    CHECK(found.reason == "the word before does not give it");
    const std::string text = bad.dump(1);
    std::size_t line = 1, place = text.rfind("\"a b b\"");
    while ((place = text.rfind('\n', place - 1)) != std::string::npos && place > 0) ++line;
    CHECK(found.line == line);
    CHECK(found.statement == "F derives aba");
}

TEST_CASE("cited and undecided statements are told apart, constructions are not checked") {
    Json all = certificate(
        Json::parse(R"({"is": "CF", "language": {"generated": "G"}})"), "proved",
        Json::parse(R"({"by": "construction", "system": {"axiom": "a", "tables": [{}]}})"));
    Json cited = all["statements"][0];
    cited.erase("proof");
    cited["verdict"] = "cited";
    cited["citation"] = "RS80 III.2.1";
    Json undecided = cited;
    undecided.erase("citation");
    undecided["verdict"] = "undecided";
    all["statements"].push_back(cited);
    all["statements"].push_back(undecided);
    const auto found = check(all);
    CHECK(found[0].outcome == Outcome::not_checked);
    CHECK(found[1].outcome == Outcome::cited);
    CHECK(found[1].citation == "RS80 III.2.1");
    CHECK(found[2].outcome == Outcome::undecided);
}

TEST_CASE("a family is shown by its operations only where it is closed under them") {
    algae::Budget budget = small_budget();
    budget.deadline.reset();  // a slow machine says the same
    const auto outcome = [&](const char* family, const char* language) {
        const Json said{{"is", family}, {"language", Json::parse(language)}};
        return check(certificate(said, "proved", Json{{"by", "closed"}}), budget)[0].outcome;
    };
    const char *star = R"({"star": {"generated": "G"}})",
               *before = R"({"inverse image": {"generated": "E"}, "morphism": {"a": "a a"}})",
               *meeting = R"({"intersection": [{"generated": "G"}, {"generated": "W"}]})";
    for (const char* family : {"E0L", "ET0L"}) CHECK(outcome(family, star) == Outcome::checked);
    CHECK(outcome("EDT0L", star) == Outcome::wrong);  // G has a letter with two successors
    for (const char* family : {"0L", "T0L", "D0L", "IL", "REG", "CF"})
        CHECK(outcome(family, star) == Outcome::wrong);
    CHECK(outcome("ET0L", before) == Outcome::checked);
    for (const char* family : {"E0L", "EDT0L"}) CHECK(outcome(family, before) == Outcome::wrong);
    CHECK(outcome("ET0L", meeting) == Outcome::wrong);
    CHECK(outcome("E0L", R"({"plus": {"generated": "T"}})") == Outcome::wrong);  // two tables
    CHECK(outcome("ET0L", R"({"plus": {"generated": "T"}})") == Outcome::checked);
    // C has contexts, but few words.
    CHECK(outcome("ET0L", R"({"plus": {"generated": "C"}})") == Outcome::checked);
    CHECK(outcome("E0L", R"({"difference": [{"generated": "G"}, {"star": {"words": ["a a"]}}]})") ==
          Outcome::checked);
    CHECK(outcome("E0L", R"({"difference": [{"star": {"words": ["a"]}}, {"generated": "G"}]})") ==
          Outcome::wrong);
    // Few words are a regular language, whatever gives them.
    CHECK(outcome("E0L", R"({"difference": [{"generated": "G"}, {"generated": "C"}]})") ==
          Outcome::checked);
    CHECK(outcome("E0L", R"({"intersection": [{"generated": "G"}, {"generated": "C"}]})") ==
          Outcome::checked);
    CHECK(outcome("E0L", R"({"intersection": [{"generated": "C"}, {"generated": "G"}]})") ==
          Outcome::checked);
}

TEST_CASE("a rule for all values passes only where its side condition holds") {
    const auto outcome = [](const char* statement, const char* proof) {
        return check(certificate(Json::parse(statement), "proved", Json::parse(proof)))[0].outcome;
    };
    const auto family = [&](const std::string& domain, const std::string& said, bool reversed) {
        Json language{{"name", "A"}};
        if (reversed) language = Json{{"reversal", language}};
        const Json statement{
            {"for all", Json::array({{{"name", "A"}, {"of", domain + " languages"}}})},
            {"holds", {{"is", said}, {"language", language}}}};
        return outcome(statement.dump().c_str(), R"({"by": "families"})");
    };
    CHECK(family("context-free", "E0L", false) == Outcome::checked);
    CHECK(family("regular", "ET0L", true) == Outcome::checked);
    CHECK(family("finite", "E0L", false) == Outcome::checked);
    CHECK(family("PD0L", "T0L", true) == Outcome::checked);
    CHECK(family("context-free", "EDT0L", false) == Outcome::wrong);
    CHECK(family("context-free", "REG", false) == Outcome::wrong);
    CHECK(family("regular", "0L", false) == Outcome::wrong);
    CHECK(family("finite", "0L", false) == Outcome::wrong);
    CHECK(family("0L", "P0L", false) == Outcome::wrong);
    CHECK(family("E0L", "CF", false) == Outcome::wrong);
    CHECK(family("IL", "IL", true) == Outcome::wrong);

    const auto letters = [&](const char* holds, const char* by) {
        return outcome(
            (R"({"for all": [{"name": "A", "of": "languages"}, {"name": "B", "of": "languages"}], "holds": )" +
             std::string(holds) + "}")
                .c_str(),
            (R"({"by": "letters", "letters": )" + std::string(by) +
             R"(, "proof": {"by": "derivatives"}})")
                .c_str());
    };
    const char* swapped =
        R"({"equal": [{"union": [{"name": "A"}, {"name": "B"}]}, {"union": [{"name": "B"}, {"name": "A"}]}]})";
    CHECK(letters(swapped, R"({"A": "a", "B": "b"})") == Outcome::checked);
    CHECK(letters(swapped, R"({"A": "a", "B": "a"})") == Outcome::wrong);  // the same letter twice
    CHECK_THROWS_WITH(letters(swapped, R"({"A": "a"})"),
                      "x.json:232: statements[0].proof.letters: the field 'B' is missing");
    // A letter that the statement has itself is no other one.
    CHECK(
        letters(
            R"({"equal": [{"union": [{"name": "A"}, {"words": ["a"]}]}, {"union": [{"name": "A"}, {"name": "A"}]}]})",
            R"({"A": "a", "B": "b"})") == Outcome::wrong);
    // Letters do not stand for languages under an intersection.
    CHECK(letters(R"({"equal": [{"intersection": [{"name": "A"}, {"name": "B"}]}, {"words": []}]})",
                  R"({"A": "a", "B": "b"})") == Outcome::wrong);

    // Each part needs its own proof, and all of them are wanted.
    const char* both = R"({"for all": [{"name": "A", "of": "D0L languages"}], "holds": {"all of": [
        {"is": "0L", "language": {"name": "A"}}, {"is": "T0L", "language": {"name": "A"}}]}})";
    CHECK(outcome(both, R"({"by": "each", "proofs": [{"by": "families"}, {"by": "families"}]})") ==
          Outcome::checked);
    CHECK(outcome(both, R"({"by": "each", "proofs": [{"by": "families"}]})") == Outcome::wrong);
    std::string one = both;
    one.replace(one.find("T0L"), 3, "P0L");
    CHECK(outcome(one.c_str(),
                  R"({"by": "each", "proofs": [{"by": "families"}, {"by": "families"}]})") ==
          Outcome::wrong);
    std::string any = both;
    any.replace(any.find("all of"), 6, "any of");
    CHECK(outcome(any.c_str(),
                  R"({"by": "each", "proofs": [{"by": "families"}, {"by": "families"}]})") !=
          Outcome::checked);
}

TEST_CASE("a name ranges over what is known, and over nothing else") {
    const auto said = [](const char* of) -> std::string {
        Json statement = Json::parse(
            R"({"for all": [{"name": "G", "of": "", "size": 2}], "holds": {"palindrome": "a"}})");
        statement["for all"][0]["of"] = of;
        try {
            check(certificate(statement, "proved", Json::parse(R"({"by": "values"})")));
        } catch (const algae::Error& error) {
            return error.what();
        }
        return "";
    };
    for (const char* of : {"0L systems", "PDT0L systems", "IL systems", "PD(1,2)L systems",
                           "E0L languages", "regular languages", "CF languages", "languages",
                           "finite languages", "codings", "non-erasing morphisms", "numbers"})
        CHECK_MESSAGE(said(of).empty(), of);
    for (const char* of :
         {"F0L systems", "green D0L systems", "systems", " systems", "regular systems",
          "OL languages", "any languages", "green morphisms", "substitutions", "animals"})
        CHECK_MESSAGE(said(of).ends_with("].of: expected what a name ranges over, found '" +
                                         std::string(of) + "'"),
                      of);
}

TEST_CASE("the length 1 stands for longer ones, too, where all lengths from 1 on are periodic") {
    // a -> a | aa generates a+, and a -> a | aaa the words of odd length, so neither is shown to be beyond the family.
    const auto found = [](const char* language, const char* proof) {
        const Json is{{"is", "PT0L"}, {"language", Json::parse(language)}};
        return check(certificate(is, "refuted", Json::parse(proof)))[0];
    };
    const auto all = found(
        R"({"concatenation": [{"words": ["a"]}, {"star": {"words": ["a"]}}]})",
        R"({"by": "lengths", "targets": [{"rest": [0, 1], "frames": [{"modulus": 1, "rest": 0, "case": {"rest": [0, 1]}}]}]})");
    CHECK(all.outcome == Outcome::wrong);
    CHECK(all.reason == "a table with these lengths may make them of long ones");
    const auto odd = found(
        R"({"concatenation": [{"words": ["a"]}, {"star": {"words": ["a a"]}}]})",
        R"({"by": "lengths", "targets": [{"rest": [1, 2], "frames": [{"modulus": 1, "rest": 0, "case": {"rest": [1, 2]}}]}]})");
    CHECK(odd.outcome == Outcome::wrong);
    CHECK(odd.reason == "a table with these lengths may make them of long ones");
}

namespace {

/// What is found of a statement over an alphabet with its proof; T is the system of Thue and Morse.
std::string outcome_over(const char* alphabet, const char* statement, const char* verdict,
                         const char* proof) {
    return changed::found(
               changed::certificate_of(
                   {{"alphabet", Json::parse(alphabet)},
                    {"systems",
                     {{"T", Json::parse(
                                R"({"axiom": "a", "tables": [{"a": ["a b"], "b": ["b a"]}]})")}}},
                    {"statement", Json::parse(statement)},
                    {"verdict", verdict},
                    {"proof", Json::parse(proof)}}))
        .outcome;
}

}  // namespace

TEST_CASE("a name is no sum and no number") {
    // "for all i, j + k, i + j, k: i + (j + k) = (i + j) + k" is false where all four are names.
    const char* addition =
        R"({"by": "automata", "addition": {"edges": [[0,0,0,0,0],[0,0,0,1,1],[0,0,1,1,0],[0,1,0,1,0],[1,0,1,0,1],[1,1,0,0,1],[1,1,1,0,0],[1,1,1,1,1]], "accepting": [true, false]}})";
    CHECK(
        outcome_over(
            R"(["a", "b"])",
            R"({"first order": {"for all": ["i", "j + k", "i + j", "k"], "holds": {"equation": {"of": {"i": "1", "j + k": "1", "i + j": "-1", "k": "-1"}, "plus": "0"}}}, "system": "T"})",
            "proved", addition) ==
        "error: statements[0].statement.first order.for all[1]: expected a name: a letter or _, "
        "then letters, digits, _ and '");
    for (const std::string name : {"2", "", ".1", "2i", "i i", "\u00e4"})
        CHECK(
            outcome_over(R"(["a", "b"])",
                         (R"({"first order": {"exists": [")" + name +
                          R"("], "holds": {"equation": {"of": {}, "plus": "0"}}}, "system": "T"})")
                             .c_str(),
                         "proved", addition) ==
            "error: statements[0].statement.first order.exists[0]: expected a name: a letter or _, "
            "then letters, digits, _ and '");
    for (const std::string of : {"numbers", "languages", "0L systems", "codings"})
        CHECK(outcome_over(R"(["a", "b"])",
                           (R"({"for all": [{"name": "1 + 1", "of": ")" + of +
                            R"("}], "holds": {"numbers": ["1", "=", "1"]}})")
                               .c_str(),
                           "proved", R"({"by": "values"})") ==
              "error: statements[0].statement.for all[0].name: expected a name: a letter or _, "
              "then letters, digits, _ and '");
}

TEST_CASE("a bound word is no letter where it is reversed") {
    const auto found = [](const char* of, const char* word) {
        const std::string said = std::string(R"({"for all": [{"name": "x", "of": ")") + of +
                                 R"("}], "holds": {"equal": [{"reversal": {"words": [")" + word +
                                 R"("]}}, {"words": [")" + word + R"("]}]}})";
        return outcome_over(R"(["a", "b", "x"])", said.c_str(), "proved",
                            R"({"by": "letters", "letters": {}, "proof": {"by": "values"}})");
    };
    CHECK(found("letters", "x") == "checked");
    CHECK(found("words", "a") == "checked");
    CHECK(found("words", "a a") == "checked");
    for (const char* word : {"x", "x x", "a x a"})
        CHECK(found("words", word) ==
              "wrong: proof.letters: a letter that stands for any word cannot be reversed");
}

TEST_CASE("a complement of powers is over the letters of the powers") {
    const auto found = [](const char* word, const char* verdict) {
        return outcome_over(
            R"(["a", "b", "c"])",
            (std::string(R"({"member": ")") + word +
             R"(", "language": {"complement": {"powers": [{"word": "a b", "exponent": [{"coefficient": 1, "number": "n", "power": 1}]}], "numbers": [{"name": "n", "least": 0}]}}})")
                .c_str(),
            verdict, R"({"by": "membership"})");
    };
    for (const char* word : {"a", "b", "b a", "a a"}) {
        CHECK(found(word, "proved") == "checked");
        CHECK(found(word, "refuted").starts_with("wrong: "));
    }
    for (const char* word : {"", "a b", "c"}) {
        CHECK(found(word, "refuted") == "checked");
        CHECK(found(word, "proved").starts_with("wrong: "));
    }
}

TEST_CASE("languages of bound names are the same only where the names are") {
    using namespace algae::verify;
    System doubling;
    doubling.axiom = {0};
    doubling.tables = {{{{0, 0}}}};
    doubling.terminal = {1};
    const auto system = std::make_shared<const System>(doubling);
    const Language bound = generated_by(nullptr, "X");
    CHECK(same(bound, generated_by(nullptr, "X")));
    CHECK(!same(bound, generated_by(nullptr, "Y")));
    CHECK(!same(bound, generated_by(system, "X")));
    CHECK(!same(generated_by(system, "X"), bound));
    CHECK(same(generated_by(system, "X"), generated_by(system, "Y")));
}

TEST_CASE("what is no certificate is refused with the place") {
    const Json good = certificate(sound()[0]);
    const auto error = [](const Json& bad) -> std::string {
        try {
            check(bad);
        } catch (const algae::Error& refused) {
            return refused.what();
        }
        return "accepted";
    };
    Json bad = good;
    bad["statements"][0]["statement"]["member"] = "a c";
    CHECK(error(bad).ends_with(
        ": statements[0].statement.member: 'c' is not a letter of the alphabet"));
    bad = good;
    bad["statements"][0]["statement"]["member"] = "a  a";
    CHECK(error(bad).ends_with("'' is not a letter of the alphabet"));
    bad = good;
    bad["statements"][0]["proof"]["more"] = 1;
    CHECK(error(bad).ends_with(": statements[0].proof: unexpected field 'more'"));
    bad = good;
    bad["format"] = "algae certificate 2";
    CHECK(error(bad) == "x.json:2: format: expected \"algae certificate 1\"");
    bad = good;
    bad.erase("alphabet");
    CHECK(error(bad) == "x.json:1: the field 'alphabet' is missing");
    bad = good;
    bad["alphabet"] = {"a", 7};
    CHECK(error(bad).ends_with(": alphabet[1]: expected a string, found a number"));
    CHECK_THROWS_WITH_AS(algae::verify::check_certificate("{\"a\": 1,\n\"a\": 2}", "y"),
                         "y:2: the field 'a' stands here twice", algae::Error);
    CHECK_THROWS_AS(algae::verify::check_certificate("", "y"), algae::Error);
    CHECK_THROWS_AS(algae::verify::check_certificate("{} {}", "y"), algae::Error);
    CHECK_THROWS_AS(algae::verify::check_certificate("[1e999]", "y"), algae::Error);
    CHECK_THROWS_AS(algae::verify::check_certificate("\"\xff\"", "y"), algae::Error);
}

TEST_CASE("nothing deep, large or long crashes or hangs") {
    CHECK_THROWS_AS(algae::verify::check_certificate(std::string(1'000'000, '['), "y"),
                    algae::BoundReached);
    Json language = Json::parse(R"({"words": ["a"]})");
    for (int i = 0; i < 400; ++i) language = Json{{"star", language}};
    const auto with = [&](const char* statement, const char* verdict, const char* proof) {
        Json made = certificate(Json::parse(statement), verdict, Json::parse(proof));
        return check(made)[0].outcome;
    };
    Json deep = certificate(Json{{"member", "a"}, {"language", language}}, "proved",
                            Json{{"by", "membership"}});
    CHECK(check(deep)[0].outcome == Outcome::checked);
    CHECK(with(R"({"derives": "a", "system": "W", "steps": "99999999999999999999999999"})",
               "refuted", R"({"by": "exhausted"})") == Outcome::checked);
    CHECK(with(R"({"is": "finite", "language": {"generated": "W"}})", "proved",
               R"({"by": "values"})") == Outcome::not_checked);
    CHECK(with(R"({"equal sequences": ["F", "W"]})", "refuted",
               R"({"by": "generation", "generation": "99999999999999999999"})") ==
          Outcome::not_checked);
    CHECK(with(R"({"equal sequences": ["F", "W"]})", "refuted",
               R"({"by": "generation", "generation": 30, "position": "1073741823"})") ==
          Outcome::checked);
    CHECK(with(R"j({"numbers": ["length(W,3)", "=", "9^9^9^9^9"]
})j",
               "refuted", R"({"by": "values"})") == Outcome::not_checked);
    CHECK(with(R"({"equal": [{"generated": "W"}, {"generated": "W"}]})", "proved",
               R"({"by": "sections", "words": [[40, 40]], "sections": []})") ==
          Outcome::not_checked);
}
