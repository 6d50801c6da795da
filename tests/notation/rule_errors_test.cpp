#include <doctest/doctest.h>

#include <string>

#include "notation/said.hpp"

using namespace algae;

namespace {

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
    CHECK(
        findings("axiom b\nb -(0)-> a\nb -(1.5)-> a\nb -(q)-> c\nb -(sqrt(2)/2)-> c\nb -()-> c") ==
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
          "x.lsys:1:8: error: '<' is never closed\n"
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

TEST_CASE("shape rules along several axes") {
    CHECK(
        findings(
            "axiom a\na -> div(XX, 3 : 2){ B }\na -> div(XZ, 3, 2){ B }\na -> repeat(XZ, 1){ B }\n"
            "a -> div(X, 3 : 2){ B }\na -> div(, 3){ B }\na -> div(X, 3 : ){ B }") ==
        "x.lsys:2:10: error: expected different axes, found 'XX'\n"
        "  a -> div(XX, 3 : 2){ B }\n"
        "           ^\n"
        "x.lsys:3:6: error: expected sizes for each of 2 axes, with ':' between, found 1\n"
        "  a -> div(XZ, 3, 2){ B }\n"
        "       ^\n"
        "x.lsys:4:13: error: expected one axis of repeat, found 'XZ'\n"
        "  a -> repeat(XZ, 1){ B }\n"
        "              ^\n"
        "x.lsys:5:6: error: expected sizes for one axis, found 2 lists with ':' between\n"
        "  a -> div(X, 3 : 2){ B }\n"
        "       ^\n"
        "x.lsys:6:10: error: expected an axis, X, Y or Z, found ','\n"
        "  a -> div(, 3){ B }\n"
        "           ^\n"
        "x.lsys:7:17: error: expected a number or a name, found ')'\n"
        "  a -> div(X, 3 : ){ B }\n"
        "                  ^");
}
