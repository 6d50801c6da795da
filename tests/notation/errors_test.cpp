#include <doctest/doctest.h>

#include <string>

#include "base/error.hpp"
#include "notation/read.hpp"

using namespace algae;

namespace {

/// What is said about a text, or "" if nothing is wrong with it.
std::string findings(const std::string& text) {
    try {
        read_lsystem(text, "x.lsys");
        return {};
    } catch (const Diagnostics& error) {
        return error.what();
    }
}

std::string finding_about_word(const std::string& text) {
    Alphabet alphabet;
    try {
        read_word(text, alphabet);
        return {};
    } catch (const Diagnostics& error) {
        return error.what();
    }
}

}  // namespace

TEST_CASE("brackets without their other half") {
    CHECK(findings("axiom F-F]--F[\nF -> F+F]--F+F\nF -> [[F]") ==
          "x.lsys:1:10: error: unmatched ']'\n"
          "  axiom F-F]--F[\n"
          "           ^\n"
          "x.lsys:1:14: error: '[' is never closed\n"
          "  axiom F-F]--F[\n"
          "               ^\n"
          "x.lsys:2:9: error: unmatched ']'\n"
          "  F -> F+F]--F+F\n"
          "          ^\n"
          "x.lsys:3:6: error: '[' is never closed\n"
          "  F -> [[F]\n"
          "       ^");
    CHECK(findings("axiom a\ninterpret a -> F]") ==
          "x.lsys:2:17: error: unmatched ']'\n"
          "  interpret a -> F]\n"
          "                  ^");
}

TEST_CASE("statements that are none") {
    CHECK(findings("angel 60\naxiom F") ==
          "x.lsys:1:1: error: expected a setting or a rule with '->', found 'angel'; did you mean "
          "'angle'?\n"
          "  angel 60\n"
          "  ^");
    CHECK(findings("axiom F\nF = FF") ==
          "x.lsys:2:1: error: expected a setting or a rule with '->', found 'F'\n"
          "  F = FF\n"
          "  ^");
    CHECK(findings("axiom F F -> F") ==
          "x.lsys:1:1: error: expected a line break or ';' between the setting 'axiom' and the rule\n"
          "  axiom F F -> F\n"
          "  ^");
}

TEST_CASE("settings given twice, not at all or without a value") {
    CHECK(findings("axiom F\naxiom G\nangle 3\nangle 4") ==
          "x.lsys:2:1: error: 'axiom' is given twice, first in line 1\n"
          "  axiom G\n"
          "  ^\n"
          "x.lsys:4:1: error: 'angle' is given twice, first in line 3\n"
          "  angle 4\n"
          "  ^");
    CHECK(findings("F -> F\n") ==
          "x.lsys:2:1: error: expected an axiom before the end of the file, found none");
    CHECK(findings("axiom") ==
          "x.lsys:1:6: error: expected a word after 'axiom' (the empty word is ε), found the end of "
          "the line\n"
          "  axiom\n"
          "       ^");
    CHECK(findings("axiom F;angle ; step") ==
          "x.lsys:1:15: error: expected a value after 'angle', found ';'\n"
          "  axiom F;angle ; step\n"
          "                ^\n"
          "x.lsys:1:21: error: expected a value after 'step', found the end of the line\n"
          "  axiom F;angle ; step\n"
          "                      ^");
    CHECK(findings("").starts_with("x.lsys:1:1: error: expected an axiom before the end"));
}

TEST_CASE("names that stand for nothing, with a suggestion") {
    CHECK(findings("axiom F(y)\nlet radius = 2\nA(x) : z > 3 -> B(radios, x)") ==
          "x.lsys:1:9: error: expected a number or a constant, found 'y'\n"
          "  axiom F(y)\n"
          "          ^\n"
          "x.lsys:3:8: error: expected a parameter or a constant, found 'z'\n"
          "  A(x) : z > 3 -> B(radios, x)\n"
          "         ^\n"
          "x.lsys:3:19: error: expected a parameter or a constant, found 'radios'; did you mean "
          "'radius'?\n"
          "  A(x) : z > 3 -> B(radios, x)\n"
          "                    ^");
    // A faulty constant is reported once, not at each of its uses.
    CHECK(findings("axiom F(r)\nlet r = \nangle 2*r\nF -(r)-> F") ==
          "x.lsys:2:8: error: expected a number or a name, found the end of the line\n"
          "  let r =\n"
          "         ^");
}

TEST_CASE("parameters") {
    CHECK(findings("axiom F\nA(x,x) -> B\nA(x) < B(x) -> C\nA() -> B") ==
          "x.lsys:2:5: error: the parameter 'x' stands twice before the arrow\n"
          "  A(x,x) -> B\n"
          "      ^\n"
          "x.lsys:3:10: error: the parameter 'x' stands twice before the arrow\n"
          "  A(x) < B(x) -> C\n"
          "           ^\n"
          "x.lsys:4:3: error: expected a parameter's name, found ')'\n"
          "  A() -> B\n"
          "    ^");
}

TEST_CASE("probabilities") {
    CHECK(findings("axiom b\nb -(1/3)-> a\nb -(1/3)-> c") ==
          "x.lsys:2:1: error: the probabilities of b add up to 2/3, expected 1\n"
          "  b -(1/3)-> a\n"
          "  ^");
    CHECK(findings("axiom b\nb -(1/3)-> a\nb -> c") ==
          "x.lsys:3:1: error: expected a probability, as other rules of b have one\n"
          "  b -> c\n"
          "  ^");
    CHECK(findings("axiom b\nb -(0)-> a\nb -(1.5)-> a\nb -(q)-> c\nb -(sqrt(2)/2)-> c\nb -()-> c") ==
          "x.lsys:2:5: error: expected a probability above 0 and at most 1, found 0\n"
          "  b -(0)-> a\n"
          "      ^\n"
          "x.lsys:3:5: error: expected a probability above 0 and at most 1, found 1.5\n"
          "  b -(1.5)-> a\n"
          "      ^\n"
          "x.lsys:4:5: error: expected a number or a constant, found 'q'\n"
          "  b -(q)-> c\n"
          "      ^\n"
          "x.lsys:5:5: error: expected a rational probability, found 'sqrt(2)/2'\n"
          "  b -(sqrt(2)/2)-> c\n"
          "      ^\n"
          "x.lsys:6:5: error: expected a number or a name, found ')'\n"
          "  b -()-> c\n"
          "      ^");
    // Equal left sides are those with the same tables, arities, contexts and conditions.
    CHECK(findings("axiom b\nb -(1)-> a\nb(x) -> a\nc < b -(1)-> a\nb > c -> a") == "");
    CHECK(findings("axiom b\nb(x) : x > 1 -(1/2)-> a\nb(y) : y > 1 -(1/2)-> c\nb(x) -> d") == "");
    CHECK(findings("axiom b\ntable s\nb -(1)-> a\ntable t\nb -> c") == "");
    CHECK(findings("axiom b\ninterpret b -(1/4)-> a") ==
          "x.lsys:2:11: error: the probabilities of b add up to 1/4, expected 1\n"
          "  interpret b -(1/4)-> a\n"
          "            ^");
}

TEST_CASE("tables") {
    CHECK(findings("axiom a\na -> b\ntable light\na -> c\ntable light\ntable\ntable a b") ==
          "x.lsys:2:1: error: expected a table before the first rule, as there are tables further "
          "down\n"
          "  a -> b\n"
          "  ^\n"
          "x.lsys:5:7: error: the table 'light' is opened twice\n"
          "  table light\n"
          "        ^\n"
          "x.lsys:6:6: error: expected a value after 'table', found the end of the line\n"
          "  table\n"
          "       ^\n"
          "x.lsys:7:9: error: expected the end of the line, found 'b'\n"
          "  table a b\n"
          "          ^");
}

TEST_CASE("left sides") {
    CHECK(findings("axiom a\nAB -> C\n-> D\nA < -> B\nA < B > -> C\na ? -> b\na : -> c\nε -> a") ==
          "x.lsys:2:2: error: expected '->' or a context after one symbol, found 'B'\n"
          "  AB -> C\n"
          "   ^\n"
          "x.lsys:3:1: error: expected a symbol before the arrow, found '->'\n"
          "  -> D\n"
          "  ^\n"
          "x.lsys:4:5: error: expected a symbol before the arrow, found '->'\n"
          "  A < -> B\n"
          "      ^\n"
          "x.lsys:5:9: error: expected a right context, found '->'\n"
          "  A < B > -> C\n"
          "          ^\n"
          "x.lsys:6:5: error: expected a module, found '->'\n"
          "  a ? -> b\n"
          "      ^\n"
          "x.lsys:7:5: error: expected a number or a name, found '->'\n"
          "  a : -> c\n"
          "      ^\n"
          "x.lsys:8:1: error: expected a symbol before the arrow, found 'ε'\n"
          "  ε -> a\n"
          "  ^");
}

TEST_CASE("words") {
    CHECK(findings("axiom a<b\na -> (x)\na -> b(1)(2)\na -> b#c\na->b(,)\na -> b(1\na -> b -> c") ==
          "x.lsys:1:8: error: expected a symbol, found '<'\n"
          "  axiom a<b\n"
          "         ^\n"
          "x.lsys:2:6: error: expected a symbol, found '('\n"
          "  a -> (x)\n"
          "       ^\n"
          "x.lsys:3:10: error: expected a symbol, found '('\n"
          "  a -> b(1)(2)\n"
          "           ^\n"
          "x.lsys:4:7: error: expected a symbol, found '#'; a comment needs a blank before\n"
          "  a -> b#c\n"
          "        ^\n"
          "x.lsys:5:6: error: expected a number or a name, found ','\n"
          "  a->b(,)\n"
          "       ^\n"
          "x.lsys:6:9: error: expected an operator, ',' or ')', found the end of the line\n"
          "  a -> b(1\n"
          "          ^\n"
          "x.lsys:7:9: error: expected a symbol, found '>'\n"
          "  a -> b -> c\n"
          "          ^");
    CHECK(findings("axiom F−F\na(x) : x−1 > 2 -> b") ==
          "x.lsys:1:8: error: expected a symbol, found '−' (U+2212); did you mean '-'?\n"
          "  axiom F−F\n"
          "         ^\n"
          "x.lsys:2:9: error: expected an operator or '->', found '−' (U+2212); did you mean '-'?\n"
          "  a(x) : x−1 > 2 -> b\n"
          "          ^");
    CHECK(finding_about_word("F(x") ==
          "word:1:4: error: expected an operator, ',' or ')', found the end of the line\n"
          "  F(x\n"
          "     ^");
    CHECK(finding_about_word("a\nb") == "");
}

TEST_CASE("expressions") {
    CHECK(findings("axiom a\na(x) : 1 < x < 3 -> b\na(x) : sine(x) -> c\na(x) : min(x) > 2 -> c\n"
                   "a(x) : x x -> c\na(x) : (x -> c\na(x) : x) -> c\na(x) : sin(x,2) -> c") ==
          "x.lsys:2:10: error: relations do not chain: write 'a < b & b < c'\n"
          "  a(x) : 1 < x < 3 -> b\n"
          "           ^\n"
          "x.lsys:3:8: error: expected a function, found 'sine'; did you mean 'sin'?\n"
          "  a(x) : sine(x) -> c\n"
          "         ^\n"
          "x.lsys:4:13: error: expected 2 or more arguments of min, found 1\n"
          "  a(x) : min(x) > 2 -> c\n"
          "              ^\n"
          "x.lsys:5:10: error: expected an operator or '->', found 'x'\n"
          "  a(x) : x x -> c\n"
          "           ^\n"
          "x.lsys:6:11: error: expected an operator or ')', found '->'\n"
          "  a(x) : (x -> c\n"
          "            ^\n"
          "x.lsys:7:9: error: expected an operator or '->', found ')'\n"
          "  a(x) : x) -> c\n"
          "          ^\n"
          "x.lsys:8:15: error: expected 1 argument of sin, found 2\n"
          "  a(x) : sin(x,2) -> c\n"
          "                ^");
}

TEST_CASE("numbers out of range and expressions without a value") {
    CHECK(findings("axiom a\nangle 1/0\nwidth -1\nstep 10^400\nshrink sqrt(-1)\nspin 2*\nscale 1 2\n"
                   "narrow log(0)") ==
          "x.lsys:2:9: error: division by 0 in '1/0'\n"
          "  angle 1/0\n"
          "          ^\n"
          "x.lsys:3:7: error: expected a width above 0, found '-1'\n"
          "  width -1\n"
          "        ^\n"
          "x.lsys:4:6: error: the value of '10^400' is too large\n"
          "  step 10^400\n"
          "       ^\n"
          "x.lsys:5:8: error: the square root of a negative number in 'sqrt(-1)'\n"
          "  shrink sqrt(-1)\n"
          "         ^\n"
          "x.lsys:6:8: error: expected a number or a name, found the end of the line\n"
          "  spin 2*\n"
          "         ^\n"
          "x.lsys:7:9: error: expected an operator, found '2'\n"
          "  scale 1 2\n"
          "          ^\n"
          "x.lsys:8:8: error: the logarithm of a number that is not positive in 'log(0)'\n"
          "  narrow log(0)\n"
          "         ^");
    CHECK(findings("axiom a\ngeneration 3..2") ==
          "x.lsys:2:15: error: expected a generation from 3 on, found 2\n"
          "  generation 3..2\n"
          "                ^");
    CHECK(findings("axiom a\ngeneration 9223372036854775808") ==
          "x.lsys:2:12: error: expected a generation below 2^63, found '9223372036854775808'\n"
          "  generation 9223372036854775808\n"
          "             ^");
    CHECK(findings("axiom a\ngeneration 9223372036854775807") == "");
    CHECK(findings("axiom a\ngeneration -1").starts_with("x.lsys:2:12: error: expected a generation, found '-'"));
    CHECK(findings("axiom a\nlet x = 2^2^2^2^2^2\n")
              .starts_with("x.lsys:2:11: error: the value of '2^2^2^2^2' is too large"));
}

TEST_CASE("other settings") {
    CHECK(findings("axiom a\nstart 1 2\nturn left\ncolour red? blue\n"
                   "expect size 3: 4\nexpect lenght 3: 4\nexpect length: 4\nexpect length 3 4\n"
                   "expect length 3:") ==
          "x.lsys:2:10: error: expected a heading, found the end of the line\n"
          "  start 1 2\n"
          "           ^\n"
          "x.lsys:3:6: error: expected 'clockwise' or 'counter-clockwise', found 'left'\n"
          "  turn left\n"
          "       ^\n"
          "x.lsys:4:8: error: expected a colour's name or #rrggbb, found 'red?'\n"
          "  colour red? blue\n"
          "         ^\n"
          "x.lsys:5:8: error: expected one of length, lengths, word, segments, distinct, vertices, "
          "end, box, found 'size'\n"
          "  expect size 3: 4\n"
          "         ^\n"
          "x.lsys:6:8: error: expected one of length, lengths, word, segments, distinct, vertices, "
          "end, box, found 'lenght'; did you mean 'length'?\n"
          "  expect lenght 3: 4\n"
          "         ^\n"
          "x.lsys:7:14: error: expected a generation, found ':'\n"
          "  expect length: 4\n"
          "               ^\n"
          "x.lsys:8:17: error: expected ':', found '4'\n"
          "  expect length 3 4\n"
          "                  ^\n"
          "x.lsys:9:17: error: expected a value, found the end of the line\n"
          "  expect length 3:\n"
          "                  ^");
    CHECK(findings("axiom a\nstart 1 2 3 4") ==
          "x.lsys:2:13: error: expected the end of the line after x, y and heading, found '4'\n"
          "  start 1 2 3 4\n"
          "              ^");
    CHECK(findings("axiom a\nalphabet title a=b\nlet = 3\nlet x 3\nlet y = 2\nlet y = 3\n"
                   "interpret F\nignore F(2)") ==
          "x.lsys:2:10: error: expected another name, 'title' has a meaning in the notation\n"
          "  alphabet title a=b\n"
          "           ^\n"
          "x.lsys:3:5: error: expected a constant's name, found '='\n"
          "  let = 3\n"
          "      ^\n"
          "x.lsys:4:7: error: expected '=', found '3'\n"
          "  let x 3\n"
          "        ^\n"
          "x.lsys:6:5: error: the constant 'y' is given twice\n"
          "  let y = 3\n"
          "      ^\n"
          "x.lsys:7:12: error: expected a rule with '->', found the end of the line\n"
          "  interpret F\n"
          "             ^\n"
          "x.lsys:8:9: error: expected symbols without parameters, found '('\n"
          "  ignore F(2)\n"
          "          ^");
}

TEST_CASE("shape rules") {
    CHECK(findings("axiom a\na -> div(Q, 3){ B }\na -> div(X, 3) B\na -> repeat(X, 1, 2){ B }\n"
                   "a -> div(X, 3){ }\na -> div(X){ B }\na -> div(X, 3){ B } C") ==
          "x.lsys:2:10: error: expected an axis, X, Y or Z, found 'Q'\n"
          "  a -> div(Q, 3){ B }\n"
          "           ^\n"
          "x.lsys:3:16: error: expected '{' and the parts, found 'B'\n"
          "  a -> div(X, 3) B\n"
          "                 ^\n"
          "x.lsys:4:6: error: expected one size of repeat, found 2\n"
          "  a -> repeat(X, 1, 2){ B }\n"
          "       ^\n"
          "x.lsys:5:17: error: expected a symbol, found '}'\n"
          "  a -> div(X, 3){ }\n"
          "                  ^\n"
          "x.lsys:6:11: error: expected ',' and a size, found ')'\n"
          "  a -> div(X){ B }\n"
          "            ^\n"
          "x.lsys:7:21: error: expected the end of the rule, found 'C'\n"
          "  a -> div(X, 3){ B } C\n"
          "                      ^");
}

TEST_CASE("bytes that are no text") {
    using namespace std::string_literals;
    CHECK(findings("axiom F\0F\0\ntitle \xff\x01\naxiom \xc0\xaf\ntitle \x1b[1m"s) ==
          "x.lsys:1:8: error: expected a text, found a NUL byte\n"
          "  axiom F\uFFFDF\uFFFD\n"
          "         ^\n"
          "x.lsys:2:7: error: expected UTF-8, found the byte 0xFF\n"
          "  title \uFFFD\uFFFD\n"
          "        ^\n"
          "x.lsys:3:7: error: expected UTF-8, found the byte 0xC0\n"
          "  axiom \uFFFD\uFFFD\n"
          "        ^\n"
          "x.lsys:4:7: error: found the control character U+001B\n"
          "  title \uFFFD[1m\n"
          "        ^");
    CHECK(findings("axiom \xed\xa0\x80").starts_with("x.lsys:1:7: error: expected UTF-8, found the byte 0xED"));
    CHECK(findings("axiom \xf4\x90\x80\x80").starts_with("x.lsys:1:7: error: expected UTF-8"));
    CHECK(findings("axiom a\xe2\x82").starts_with("x.lsys:1:8: error: expected UTF-8"));
    CHECK(findings("\xEF\xBB\xBF" "axiom a\r\na -> b\r\n") == "");
}

TEST_CASE("columns count characters, long lines are cut around the caret, tabs are one column") {
    CHECK(findings("axiom αβγ)") ==
          "x.lsys:1:10: error: expected a symbol, found ')'\n"
          "  axiom αβγ)\n"
          "           ^");
    CHECK(findings("axiom\ta)\r\n") ==
          "x.lsys:1:8: error: expected a symbol, found ')'\n"
          "  axiom a)\n"
          "         ^");
    const std::string finding = findings("axiom " + std::string(1000, 'a') + ")" + std::string(1000, 'b'));
    CHECK(finding == "x.lsys:1:1007: error: expected a symbol, found ')'\n  ..." + std::string(70, 'a') +
                         ")" + std::string(39, 'b') + "...\n  " + std::string(73, ' ') + "^");
}

TEST_CASE("of very many findings the first twenty are shown, in order of place") {
    std::string text = "axiom a\n";
    for (int i = 0; i < 50; ++i) text += i % 2 == 0 ? "foo\n" : "a -> ]\n";
    try {
        read_lsystem(text, "x.lsys");
        FAIL("expected findings");
    } catch (const Diagnostics& error) {
        REQUIRE(error.findings().size() == 21);
        for (std::size_t i = 0; i < 20; ++i) CHECK(error.findings()[i].place.line == i + 2);
        CHECK(error.findings().back().text() == "x.lsys: error: 30 more errors");
    }
}
