// `a -> a | aa`, and what textbooks write that is no word here.
#include <doctest/doctest.h>
#include <rapidcheck.h>

#include "language/language.hpp"
#include "model/model.hpp"

#include "notation/claim_said.hpp"
#include "notation/random_text.hpp"
#include "notation/said.hpp"

using namespace algae;

namespace {

std::string canonical(const std::string& text) {
    return print_lsystem(read_lsystem(text, "x.lsys"));
}

/// The findings of a system without lines and carets: "2:6: MESSAGE".
std::string messages(const std::string& text) {
    std::string all;
    try {
        read_lsystem(text, "x.lsys");
    } catch (const Diagnostics& error) {
        for (const Diagnostic& finding : error.findings())
            all += (all.empty() ? "" : "\n") + std::to_string(finding.place.line) + ":" +
                   std::to_string(finding.place.column) + ": " + finding.message;
    }
    return all;
}

}  // namespace

TEST_CASE("a bar between blanks separates the successors of a rule") {
    CHECK(canonical("axiom a; a -> a | aa") == "axiom a\na -> a\na -> aa\n");
    CHECK(canonical("axiom a\nb < a(x) > c : x > 1 | x < 0 -> b\t|\u00A0ε | a(x | 1) | |a| # d") ==
          "axiom a\nb < a(x) > c : x > 1 | x < 0 -> b\nb < a(x) > c : x > 1 | x < 0 -> ε\n"
          "b < a(x) > c : x > 1 | x < 0 -> a(x | 1)\nb < a(x) > c : x > 1 | x < 0 -> |a|\n");
    CHECK(canonical("axiom a; interpret a -> F | G") ==
          "axiom a\ninterpret a -> F\ninterpret a -> G\n");
    CHECK(canonical("axiom A\nA -> div(X, 1r, 2r){ B | C } | I(B) | repeat(Y, 2){ | }") ==
          "axiom A\nA -> div(X, 1r, 2r){ B | C }\nA -> I(B)\nA -> repeat(Y, 2){ | }\n");
    CHECK(
        canonical("axiom a(\"x\")\nsystem s { axiom a; a -> b | c }\na(w) -> <w> | b(\"F | F\")") ==
        "system s {\n    axiom a\n    a -> b\n    a -> c\n}\naxiom a(\"x\")\na(w) -> <w>\n"
        "a(w) -> b(\"F|F\")\n");
    const Model system = read_lsystem("axiom a\na -> a | aa\na -> b", "x.lsys");
    REQUIRE(system.rules.size() == 3);
    CHECK(system.rules[0].place.column == 1);
    CHECK(system.rules[1].place.column == 10);
    CHECK(system.rules[2].place.line == 3);
}

TEST_CASE("a bar without blanks, and every bar among longer names, is a letter") {
    CHECK(canonical("axiom F; F -> F|F; G -> |; H ->|F| ; I -> F|| F; J -> |(30) |F # turn") ==
          "axiom F\nF -> F|F\nG -> |\nH -> |F|\nI -> F||F\nJ -> |(30)|F\n");
    CHECK(canonical("alphabet wall\naxiom F\nF -> F | F\nG -> | wall |") ==
          "alphabet wall\naxiom F\nF -> F|F\nG -> | wall |\n");
    // F_l is a symbol anyway.
    CHECK(canonical("alphabet F_l\naxiom F\nF -> F | G") ==
          "alphabet F_l\naxiom F\nF -> F\nF -> G\n");
    CHECK(claim_messages("alphabet a wall |\nlet G = D0L { axiom a; a -> a | wall }\n"
                         "let A = {a | a}\nlet h = { a -> a | a }") == "");
}

TEST_CASE("what is wrong with alternatives") {
    CHECK(messages("axiom a\na -> a |  | b\na -> | b\na -> a | b |\na -> [a | b]\n"
                   "a -(1/2)-> a | b\na -> b( | c | d# | e]") ==
          "2:11: expected a successor (the empty word is ε; the letter '|' is written without "
          "blanks), found '|'\n"
          "3:6: expected a successor (the empty word is ε; the letter '|' is written without "
          "blanks), found '|'\n"
          "4:13: expected a successor (the empty word is ε; the letter '|' is written without "
          "blanks), found the end of the line\n"
          "5:9: expected '|' between successors outside brackets; as a letter it is written "
          "without blanks\n"
          "6:14: expected one successor behind an arrow with a probability; write a rule for each "
          "alternative\n"
          "7:9: expected a number or a name, found '|'");
    CHECK(messages("axiom a\na -> b# | c] | d") ==
          "2:7: expected a symbol, found '#'; a comment needs a blank before\n"
          "2:12: unmatched ']'");
    CHECK(claim_messages("let h = { a -> a | b }\nlet G = 0L { axiom a; a -> a | | b }") ==
          "2:18: expected one word as the image of a letter, found '|'; as a letter it is written "
          "without blanks\n"
          "3:32: expected a successor (the empty word is ε; the letter '|' is written without "
          "blanks), found '|'");
    CHECK(claim_messages("let A = {|, a|b}\nlet B = {a, a | b}") ==
          "3:15: expected ',' between words, found '|'; as a letter it is written without blanks");
}

TEST_CASE("a claim about a system with alternatives is judged by its rules") {
    const CheckedClaim checked =
        check(claim("let G = 0L { axiom a; a -> a | aa }\nlet A = L(G)\n"
                    "show aaa in A\nshow ε not in A\nshow A == /a+/"));
    CHECK(checked.worst() == CheckedStatement::Outcome::holds);
}

TEST_CASE("textbook notation that is no word") {
    CHECK(messages("axiom aεb\na -> εb\nb -> ε\nc -> ε ε\nd -> a(\"ε\") | a(\"ε a\")") ==
          "1:8: ε is the empty word and stands alone\n"
          "2:6: ε is the empty word and stands alone\n"
          "4:6: ε is the empty word and stands alone\n"
          "5:18: ε is the empty word and stands alone");
    CHECK(
        messages("axiom a\na -> λ\nb -> Λ | a\nc -> a^n b ^ 12\nd -> a...b\ne -> a…b") ==
        "2:6: the empty word is written ε; if λ is a letter, declare it by 'alphabet'\n"
        "3:6: the empty word is written ε; if Λ is a letter, declare it by 'alphabet'\n"
        "4:6: expected letters, found the power 'a^n': write a a a out; if ^ is a letter, declare "
        "it by 'alphabet'\n"
        "4:10: expected letters, found the power 'b^12': write b b b out; if ^ is a letter, "
        "declare it by 'alphabet'\n"
        "5:7: expected letters, found '...': write the word out; if . is a letter, declare it by "
        "'alphabet'\n"
        "6:7: expected letters, found '…': write the word out; if … is a letter, declare it by "
        "'alphabet'");
    CHECK(
        claim_messages("let A = {aε}\nlet h = { a -> λ }\nlet B = {a^3}\nlet C = {a...}") ==
        "2:11: ε is the empty word and stands alone\n"
        "3:16: the empty word is written ε; if λ is a letter, declare it by 'alphabet'\n"
        "4:10: expected letters, found the power 'a^3': write a a a out; if ^ is a letter, "
        "declare it by 'alphabet'\n"
        "5:11: expected letters, found '...': write the word out; if . is a letter, declare it by "
        "'alphabet'");
}

TEST_CASE("what is a letter otherwise is no slip") {
    CHECK(messages("axiom λ\na -> λ") == "");
    CHECK(messages("alphabet λ\naxiom a\na -> λ") == "");
    CHECK(messages("axiom a\na -> λ\nλ -> a") == "");
    CHECK(messages("axiom a\na -> F^F\nb -> F^n[^F]\nc -> {...}.F\nd -> a^2(1)") == "");
    CHECK(messages("axiom a\na -> F^s\nsolid s box") == "");
    CHECK(messages("alphabet ^\naxiom a\na -> a^n") == "");
    CHECK(claim_messages("alphabet a λ ^\nlet G = 0L { axiom a; a -> λ | a^2 }\nlet A = {a^2}") ==
          "");
}

TEST_CASE("comments stay with the rule whose alternatives they are about") {
    CHECK(format_lsystem("axiom a\n# one\na -> b | c # two\n# three\nb -> c # four", "x.lsys") ==
          "axiom a\n# one\na -> b # two\na -> c\n# three\nb -> c # four\n");
}

TEST_CASE("alternatives are the rules written one by one, and print as such") {
    int compared = 0, with_bars = 0, longer = 0;
    CHECK(rc::check([&] {
        random_text::Options options;
        options.longer = random_text::chance(40);
        const std::string alphabet = options.longer ? "alphabet wall wallwindow |a a| || ab\n" : "";
        // Words full of bars, with blanks around them only where these separate no successors.
        const auto word = [&] {
            std::string out;
            for (int i = random_text::below(6); i > 0; --i) {
                out += options.longer
                           ? random_text::one_of({"|", "|a", "a|", "||", "wall", "a", "b"})
                           : random_text::one_of({"|", "F_1", "F", "_", "1", "[a|]", "b"});
                if (random_text::chance(40)) out += ' ';
            }
            if (!options.longer) out = random_text::without_bars(out);
            // The turn alone would be one more separator.
            return out.empty() ? std::string("ε") : out == "|" ? std::string("||") : out;
        };
        std::string barred = alphabet, apart = alphabet;
        for (int i = random_text::below(4); i >= 0; --i) {
            const std::string left = random_text::one_of({"a", "b", "F_1 < b", "a > |", "|"});
            barred += left + " -> ";
            for (int j = random_text::below(3); j >= 0; --j) {
                const std::string next = word();
                apart += left + " -> " + next + '\n';
                if (options.longer || j == 0) {
                    barred += next + '\n' + (options.longer && j > 0 ? left + " -> " : "");
                } else {
                    barred += next + " | ";
                    ++with_bars;
                }
            }
        }
        const std::string axiom = "axiom " + word() + '\n';
        const Model system = read_lsystem(barred + axiom, "x.lsys");
        RC_ASSERT(system == read_lsystem(apart + axiom, "x.lsys"));
        const std::string printed = print_lsystem(system);
        RC_ASSERT(read_lsystem(printed, "x.lsys") == system);
        RC_ASSERT(print_lsystem(read_lsystem(printed, "x.lsys")) == printed);
        ++compared;
        if (options.longer) ++longer;
    }));
    MESSAGE(compared, " systems compared, ", longer, " with longer names, ", with_bars, " bars");
    CHECK(compared >= 100);
    CHECK(longer > 10);
    CHECK(with_bars > 20);
}
