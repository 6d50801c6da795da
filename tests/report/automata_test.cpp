// Automata of statements for Walnut, Graphviz and Sage, sets as regular expressions, numbers of numbers as matrices.

#include <doctest/doctest.h>

#include <regex>
#include <string>
#include <vector>

#include "automatic/known_words.hpp"
#include "report/report.hpp"

using namespace algae;

namespace {

AutomaticWord word_of(const char* name) {
    for (const KnownWord& one : words())
        if (std::string(one.name) == name) return one.word();
    throw Error(name);
}

FirstOrderReport said(const char* name, const std::string& text) {
    const AutomaticWord word = word_of(name);
    const FirstOrderStatement statement = read_first_order(text, "statement", "T", word.letters);
    return {text, name, word, statement.free(), decide_first_order(statement, word, Budget())};
}

}  // namespace

TEST_CASE("automata of statements are written for other programs") {
    // No two ones follow each other.
    const FirstOrderReport all = said("Fibonacci", "n = n");
    CHECK(automaton_text(all, AutomatonFormat::walnut) ==
          "msd_fib\n\n0 1\n0 -> 0\n1 -> 1\n\n1 1\n0 -> 0\n");
    CHECK(automaton_text(all, AutomatonFormat::sage) ==
          "Automaton([(0, 0, 0), (0, 1, 1), (1, 0, 0)], initial_states=[0], final_states=[0, "
          "1])\n");
    CHECK(automaton_text(all, AutomatonFormat::graphviz) ==
          "digraph {\n  rankdir = LR;\n  node [shape = circle];\n  begin [shape = point];\n"
          "  0 [shape = doublecircle];\n  1 [shape = doublecircle];\n"
          "  begin -> 0 [label = \"n\"];\n  0 -> 0 [label = \"0\"];\n  0 -> 1 [label = \"1\"];\n"
          "  1 -> 0 [label = \"0\"];\n}\n");
    const FirstOrderReport less = said("Thue-Morse", "i < n");
    CHECK(automaton_text(less, AutomatonFormat::walnut) ==
          "msd_2 msd_2\n\n0 0\n0 0 -> 0\n0 1 -> 1\n1 1 -> 0\n\n"
          "1 1\n0 0 -> 1\n1 0 -> 1\n0 1 -> 1\n1 1 -> 1\n");
    CHECK(automaton_text(less, AutomatonFormat::sage).find("(0, 1, [(0, 1)])") !=
          std::string::npos);
    CHECK(automaton_text(less, AutomatonFormat::graphviz)
              .find("1 -> 1 [label = \"0,0\\n1,0\\n0,1\\n1,1\"]") != std::string::npos);
    const FirstOrderReport none = said("Thue-Morse", "n < n");
    CHECK(automaton_text(none, AutomatonFormat::walnut) == "msd_2\n\n0 0\n");
    CHECK(automaton_text(none, AutomatonFormat::sage) ==
          "Automaton([], initial_states=[0], final_states=[])\n");
    CHECK(automaton_text(said("Narayana", "n > 3"), AutomatonFormat::walnut)
              .starts_with("msd_dtnarayana\n"));
    CHECK_THROWS_WITH_AS(
        automaton_text(said("Fibonacci", "for some n: n = n"), AutomatonFormat::walnut),
        "a statement whose numbers are all bound has no automaton; leave the quantifier of one "
        "away: 'for some i: ...' with n free is the set of such n",
        Error);
}

TEST_CASE("sets of numbers are regular expressions over their digits") {
    const auto expression = [](const FirstOrderReport& report) {
        return regular_expression(report.answer.relation, report.word.numeration);
    };
    CHECK(*expression(said("Thue-Morse", "n < n")) == "∅");
    CHECK(*expression(said("Thue-Morse", "n = 5")) == "0*101");
    CHECK(!expression(said("Thue-Morse", "i < n")));
    // Each number is in the set exactly if its digits match.
    std::size_t compared = 0, matching = 0;
    for (const auto& one : {std::pair{"Fibonacci", "n >= 1 and for some i: equal(i, i + n, 2n)"},
                            {"Fibonacci", "n = n"},
                            {"Thue-Morse", "n >= 1 and for some i: equal(i, i + n, n)"},
                            {"Thue-Morse", "T[n] = a and n > 6"},
                            {"Pell", "T[n] = b"},
                            {"Tribonacci", "T[n] = T[n + 1]"}}) {
        CAPTURE(one.second);
        const FirstOrderReport report = said(one.first, one.second);
        const auto found = expression(report);
        REQUIRE(found);
        std::string plain = *found;  // ε is nothing
        for (std::size_t at; (at = plain.find("ε")) != std::string::npos;)
            plain.replace(at, std::string("ε").size(), "()");
        const std::regex pattern(plain);
        for (int n = 0; n < 200; ++n) {
            std::string digits;
            for (const std::uint32_t digit : report.word.numeration.digits(n))
                digits += std::to_string(digit);
            const bool is_in = contains(report.answer.relation, report.word.numeration, {n});
            REQUIRE(std::regex_match(digits, pattern) == is_in);
            ++compared;
            matching += is_in;
        }
    }
    CHECK(compared == 1200);
    CHECK(matching > 300);
}

TEST_CASE("a word goes to Walnut with its number system") {
    const auto morse = walnut_files(word_of("Thue-Morse"), "Thue-Morse", Budget());
    REQUIRE(morse.size() == 1);
    CHECK(morse[0].first == "Word Automata Library/Thuemorse.txt");
    CHECK(morse[0].second == "msd_2\n\n0 0\n0 -> 0\n1 -> 1\n\n1 1\n0 -> 1\n1 -> 0\n");
    const auto pell = walnut_files(word_of("Pell"), "pell", Budget());
    REQUIRE(pell.size() == 3);
    CHECK(pell[0].first == "Custom Bases/msd_dtpell.txt");
    CHECK(pell[0].second == "{0, 1, 2}\n\n0 1\n0 -> 0\n1 -> 0\n2 -> 1\n\n1 1\n0 -> 0\n");
    CHECK(pell[1].first == "Custom Bases/msd_dtpell_addition.txt");
    CHECK(pell[1].second.starts_with("{0, 1, 2} {0, 1, 2} {0, 1, 2}\n\n0 1\n0 0 0 -> 0\n"));
    CHECK(pell[2].first == "Word Automata Library/Pell.txt");
    CHECK(pell[2].second == "msd_dtpell\n\n0 0\n0 -> 0\n1 -> 0\n2 -> 1\n\n1 1\n0 -> 0\n");
    // Letters that are numbers stay; one letter, and what begins as a quantifier, have names of Walnut's before them.
    CHECK(walnut_files(word_of("Rudin-Shapiro"), "a", Budget())[0].first ==
          "Word Automata Library/WA.txt");
    CHECK(walnut_files(word_of("Rudin-Shapiro"), "even", Budget())[0].first ==
          "Word Automata Library/WEven.txt");
    CHECK(walnut_files(word_of("Rudin-Shapiro"), "7", Budget())[0].second.starts_with(
        "msd_2\n\n0 0\n0 -> 0\n1 -> 1\n\n1 0\n0 -> 0\n1 -> 2\n\n2 1\n"));
}

TEST_CASE("how many numbers there are for each is written as matrices") {
    const AutomaticWord word = word_of("Thue-Morse");
    const FirstOrderReport less = said("Thue-Morse", "i < n");
    const LinearRepresentation count = counts(less.answer.relation, "n", word.numeration);
    for (int n = 0; n < 40; ++n) CHECK(count.value(word.numeration, n) == n);
    const std::string text = matrices_text(count);
    CHECK(text.starts_with("begin = vector(ZZ, ["));
    CHECK(text.find("digits = [\n    matrix(ZZ, " + std::to_string(count.size()) + ", [[") !=
          std::string::npos);
    FirstOrderReport report = less;
    report.count = count;
    report.counted = "n";
    CHECK(
        to_text(report).find("number for each n       0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, ...") !=
        std::string::npos);
    CHECK(to_json(report).text().find("\"of\": \"n\"") != std::string::npos);
}
