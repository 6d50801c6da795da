#include <doctest/doctest.h>
#include <rapidcheck.h>

#include "exchange/any_brno.hpp"
#include "exchange/compared.hpp"
#include "exchange/detail/formats.hpp"
#include "exchange/inputs.hpp"
#include "model/model.hpp"

using namespace algae;
using namespace algae::exchange_tests;

namespace {

std::string said(const std::string& text) {
    return refusal([&] { read_maple(text, "x.maple"); });
}

/// The same without the line of the text and the caret.
std::string brief(const std::string& text) {
    const std::string all = said(text);
    return all.substr(0, all.find('\n'));
}

}  // namespace

TEST_CASE("a worksheet has one call") {
    CHECK(said("") ==
          "x.maple:1:1: error: expected a call Lsystem(...), found the end of the file");
    CHECK(said("Lsystem(\"F\",[],60,1);\n> Lsystem(\"F\",[],60,2);\nLsystem(\"F\",[],60,3);") ==
          "x.maple:2:3: error: another call of Lsystem; expected one, the first is in line 1\n"
          "  > Lsystem(\"F\",[],60,2);\n    ^\n"
          "x.maple:3:1: error: another call of Lsystem; expected one, the first is in line 1\n"
          "  Lsystem(\"F\",[],60,3);\n  ^");
    CHECK(brief("Lsystem(\"F\",[],60);") ==
          "x.maple:1:1: error: expected Lsystem(AXIOMA, REGRAS, INCREMENTO, N), Lsystem(AXIOMA, "
          "REGRAS, "
          "PROB, INCREMENTO, N) or Lsystem(AXIOMA, N), found 3 arguments");
}

TEST_CASE("statements and values are checked where they stand") {
    const std::pair<const char*, const char*> cases[] = {
        {"plot(x);",
         "1:1: error: expected an assignment, restart, with(...) or a call Lsystem(...), found "
         "'plot'"},
        {"restart",
         "1:8: error: expected ';' or ':' at the end of the statement, found the end of the file"},
        {"a := 1 b := 2;",
         "1:8: error: expected ';' or ':' at the end of the statement, found 'b'"},
        {"a := 1:\n a := 2:", "2:2: error: 'a' is assigned twice, first in line 1"},
        {"D := 1:", "1:1: error: Maple keeps the name D for itself: nothing can be assigned to it"},
        {"a := b:", "1:6: error: nothing is assigned to 'b' before"},
        {"a := 1/0: Lsystem(a,a);", "1:6: error: division by 0 in '1/0'"},
        {"a := [1: ", "1:8: error: expected ']' at the end of the list, found ':'"},
        {"a := \"F",
         "1:6: error: expected '\"' at the end of the string, found the end of the line"},
        {"a := 2^3^4;",
         "1:9: error: expected brackets that say which power is taken first, found '^'"},
        {"a := foo(2);",
         "1:6: error: expected one of sqrt, exp, ln, log, abs, floor, ceil, min, max, sin, cos, "
         "tan, arcsin, arccos, arctan, evalf, found the function 'foo'"},
        {"a := sqrt(2,3);", "1:12: error: expected ')' behind the arguments of sqrt, found ','"},
        {"a := 2+;", "1:8: error: expected a number, a name or '(', found ';'"},
        {"a := [1]: b := a+1: Lsystem(a,a);", "1:16: error: expected a number, and 'a' is a list"},
        {"a := 1: b := a[1]:", "1:14: error: expected a number, found an entry of 'a'"},
        {"f := proc(x) x end;", "1:6: error: 'proc' without 'end proc'"},
        {"Lsystem(AXIOMA, [], 60, 1);", "1:9: error: nothing is assigned to 'AXIOMA' before"},
        {"Lsystem(1, [], 60, 1);", "1:9: error: expected the axiom, a string, found a number"},
        {"Lsystem(\"F\", \"F\", 60, 1);",
         "1:14: error: expected the rules, a list of strings, found a string"},
        {"Lsystem(\"F\", [\"F\"], 60, 1);", "1:15: error: the predecessor 'F' has no successor"},
        {"Lsystem(\"F\", [\"FF\",\"F\"], 60, 1);",
         "1:15: error: expected a predecessor of one character, found 'FF'"},
        {"Lsystem(\"F\", [\"F\",\"\",\"F\",\"\"], 60, 1);",
         "1:22: error: a second rule for 'F', which the procedure never uses"},
        {"Lsystem(\"F+(\", [], 60, 1);", "1:12: error: expected a symbol, found '('"},
        {"Lsystem(\"F +\", [], 60, 1);", "1:11: error: expected a symbol, found ' '"},
        {"Lsystem(\"F\\\", [], 60, 1);",
         "1:11: error: expected '?', which stands for the backslash, found '\\'"},
        {"Lsystem(\"F$\", [], 60, 1);",
         "1:11: error: '$' turns the turtle in space, and is nothing to this procedure"},
        {"Lsystem(\"F]\", [], 60, 1);", "1:11: error: a bracket that closes none"},
        {"Lsystem(\"F[[]\", [], 60, 1);", "1:11: error: a bracket that is never closed"},
        {"Lsystem(\"F\", [], \"60\", 1);",
         "1:18: error: expected the increment, degrees, found a string"},
        {"Lsystem(\"F\", [], 60, -1);",
         "1:22: error: expected a whole number of steps from 0 to 2^63 - 1, found -1"},
        {"Lsystem(\"F\", [], 60, 1.5);",
         "1:22: error: expected a whole number of steps from 0 to 2^63 - 1, found 1.5"},
        {"Lsystem(\"F\", [], 60, sqrt(2));",
         "1:22: error: expected the number of steps without roots and functions"},
        {"Lsystem(\"F\", [], N, 1);", "1:18: error: nothing is assigned to 'N' before"},
        {"Lsystem(\"F\",[\"F\",\"F\",\"X\",\"F\"],[50,50],60,1);",
         "1:22: error: a rule for 'X' behind one for 'F'; the probabilities are those of all "
         "rules, for one predecessor"},
        {"Lsystem(\"F\",[\"F\",\"F\",\"F\",\"\"],[50,40],60,1);",
         "1:30: error: the probabilities add up to 90, expected 100, of percentages, or 1"},
        {"Lsystem(\"F\",[\"F\",\"F\",\"F\",\"\"],[0.33,0.66],60,1);",
         "1:30: error: the probabilities add up to 0.99, expected 100, of percentages, or 1"},
        {"Lsystem(\"F\",[\"F\",\"F\",\"F\",\"\"],[0,1],60,1);",
         "1:31: error: expected a probability above 0, found 0"},
        {"Lsystem(\"F\",[\"F\",\"F\"],[0.5,0.5],60,1);",
         "1:23: error: expected a probability for each of the 1 rules, found 2"},
        {"Lsystem(\"F\",[\"F\",\"(F)[\"],[1],60,1);",
         "1:22: error: brackets are written ( ) before, found '['"},
        {"Lsystem(\"F&\",[\"F\",\"F\"],[1],60,1);",
         "1:11: error: '&' turns the turtle in space, and is nothing to this procedure"},
        {"vH := [0,0,1]: Lsystem(\"F\",[],60,1);",
         "1:7: error: expected vH as in the procedure: figures in space begin along x, with z up"},
        {"PONTOA := [0,0,1]: Lsystem(\"F\",[],60,1);",
         "1:16: error: expected 0: figures begin in the plane of x and y"}};
    for (const auto& [text, expected] : cases) {
        INFO(text);
        CHECK(brief(text) == "x.maple:" + std::string(expected));
    }
}

TEST_CASE("modules and functions are checked where they stand") {
    const std::string f = "F := L -> [[\"F\",L]]:\n";
    const std::pair<std::string, const char*> cases[] = {
        {"Lsystem([\"F\"],1);",
         "1:10: error: expected a module, such as [\"F\",[1]], found a string"},
        {"Lsystem([[]],1);",
         "1:10: error: expected the name of a module and a list of its parameters, found 0 values"},
        {"Lsystem([[\"AB\",[1]]],1);",
         "1:11: error: expected the name of a module, one character, found 'AB'"},
        {"Lsystem([[\"F\",[1]]],1);",
         "1:10: error: no function is assigned to the capital letter F; one that stays needs F := "
         "L -> [[\"F\",L]]"},
        {f + "Lsystem([[\"F\"]],1);", "2:10: error: the module F has no parameter"},
        {"X := L -> [[\"X\",L]]: Lsystem([[\"X\"]],1);",
         "1:31: error: the module X has no list for its function, expected [\"X\",[]]"},
        {f + "Lsystem([[\"?\"]],1);", "2:10: error: the module ? has no parameter"},
        {f + "Lsystem([[\"@\",[1]]],1);", "2:10: error: the module @ takes no parameters"},
        {f + "Lsystem([[\"$\",[1]]],1);",
         "2:10: error: '$' is nothing to this procedure, expected '@'"},
        {f + "Lsystem([[\"]\"]],1);", "2:10: error: a bracket that closes none"},
        {f + "A := L -> [[\"F\",[L[2]]]]: Lsystem([[\"A\",[1]]],1);",
         "2:18: error: uses parameter 2 of a module that has 1"},
        {f + "A := L -> [[\"F\",[M[2]]]]: Lsystem([[\"A\",[1]]],1);",
         "2:18: error: expected an entry of 'L', found one of 'M'"},
        {f + "A := L -> [[\"F\",[L[0]]]]: Lsystem([[\"A\",[1]]],1);",
         "2:20: error: expected the number of a parameter from 1 to 1000, found '0'"},
        {f + "A := L -> [[\"F\",[c]]]: Lsystem([[\"A\",[1]]],1);",
         "2:18: error: nothing is assigned to 'c' before"},
        {f + "A := L -> [[\"A\",[1,2]]]: Lsystem([[\"A\",[1]]],1);",
         "2:12: error: the module A has 2 parameters here and 1 in line 2"},
        {f + "a := L -> [[\"a\",[1]]]: Lsystem([[\"a\",[1]]],1);",
         "2:6: error: the procedure rewrites capital letters alone, and never calls 'a'"},
        {f + "A := L -> 2: Lsystem([[\"a\",[1]]],1);",
         "2:11: error: expected '[' and the modules of the successor, found '2'"}};
    for (const auto& [text, expected] : cases) {
        INFO(text);
        CHECK(brief(text) == "x.maple:" + std::string(expected));
    }
}

TEST_CASE("no worksheet, however broken, ends in anything but a system or an error") {
    const auto survives = [](const std::string& text) {
        survive(text, "x.maple", read_maple, print_maple);
    };
    CHECK(rc::check([&] { survives(*rc::gen::arbitrary<std::string>()); }));
    const std::string whole[] = {
        "> restart; with(plots):\nR := [\"F\",\"F[+F]F?\",\"X\",\"\"]: N := "
        "2:\nLsystem(\"FX\",R,180/7,N);",
        "P := [33,67]: a := 1.5e1:\nLsystem(\"F\",[\"F\",\"F(+F)\",\"F\",\"F\"],P,a*2,3);",
        "r := 0.5: F := L -> [[\"F\",L]]:\nA := L -> "
        "[[\"F\",[L[1]*sin(r)]],[\"[\"],[\"A\",[L[1]^2]],[\"]\"]]:\n"
        "GRAFICO := proc(s) ANGULO := Pi/2: end proc:\nLsystem([[\"A\",[1]],[\"&\",[90]]],2);"};
    CHECK(rc::check([&] {
        std::string text = whole[static_cast<std::size_t>(below(3))];
        for (int i = 1 + below(3); i > 0; --i) {
            const auto at = static_cast<std::size_t>(below(static_cast<int>(text.size())));
            const std::string piece =
                one_of({"",         ";",    ",",  ":", ":=", "(", "[",    "]", "\"",  "L",
                        "end proc", "proc", "->", "9", "-",  "^", "\xc3", "é", "\n>", "#"});
            text.replace(at, static_cast<std::size_t>(below(3)), piece);
        }
        survives(text);
    }));
    for (const char* part : {"[", "(", "-", "1+", "2^(", "sin(", "a:=", "f:=proc() ", "\"", ">",
                             "> \n", "[\"F\",", "Lsystem(", "GRAFICO:=proc() ANGULO:="}) {
        survives("a := " + many(part));
        survives(many(part));
        survives("Lsystem(" + many(part));
    }
    survives("Lsystem(\"" + many("F[+") + many("]") + "\",[],1,1);");
    survives("Lsystem(\"F\",[" + many("\"F\",\"F\",") + "\"F\"],[" + many("1,") + "1],1,1);");
    for (const char* times : {"", "*1"}) {
        std::string chain = "a0 := 2: ";
        for (int i = 1; i < 20'000; ++i)
            chain += "a" + std::to_string(i) + " := a" + std::to_string(i - 1) + times + ":\n";
        survives(chain + "Lsystem(\"F\",[],sqrt(a19999),1);");
    }
    survives("x := 10^(10^(10^10)): Lsystem(\"F\",[],x,1);");
}
