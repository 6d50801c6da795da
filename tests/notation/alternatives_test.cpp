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
    CHECK(canonical("axiom F; F -> F|F; G -> |; H ->|F| ; I -> F|| F; J -> F | # turn") == "");
}

TEST_CASE("what is wrong with alternatives") {
    CHECK(messages("axiom a\na -> a |  | b\na -> | b\na -> a | b |\na -> [a | b]\n"
                   "a -(1/2)-> a | b\na -> [ | b( | c#") == "");
    CHECK(claim_messages("let h = { a -> a | b }\nlet A = {a, a | b}\nlet B = {|, a|b}") == "");
}

TEST_CASE("a claim about a system with alternatives is judged by its rules") {
    const CheckedClaim checked =
        check(claim("let G = 0L { axiom a; a -> a | aa }\nlet A = L(G)\n"
                    "show aaa in A\nshow ε not in A\nshow A == /a+/"));
    CHECK(checked.worst() == CheckedStatement::Outcome::holds);
}

TEST_CASE("textbook notation that is no word") {
    CHECK(messages("axiom aεb\na -> εb\nb -> ε\nc -> ε ε\nd -> λ\ne -> Λ\nf -> a^n b^12\n"
                   "g -> a...b\nh -> a…b") == "");
    CHECK(messages("axiom λ\na -> λ") == "");
    CHECK(messages("alphabet λ\naxiom a\na -> λ") == "");
    CHECK(messages("axiom a\na -> λ\nλ -> a") == "");
    CHECK(messages("axiom a\na -> F^F\nb -> F^n[^F]\nc -> {...}.F\nd -> a^2(1)") == "");
    CHECK(messages("alphabet ^\naxiom a\na -> a^n") == "");
    CHECK(claim_messages("let A = {aε, a^3, a...}\nlet h = { a -> λ }\nshow a^n in A") == "");
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
            return out.empty() ? std::string("ε") : out;
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
        RC_ASSERT(options.longer || printed.find(" | ") == std::string::npos);
        ++compared;
        if (options.longer) ++longer;
    }));
    MESSAGE(compared, " systems compared, ", longer, " with longer names, ", with_bars, " bars");
    CHECK(compared >= 100);
    CHECK(longer > 10);
    CHECK(with_bars > 50);
}
