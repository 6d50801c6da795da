#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <string>
#include <vector>

#include "exchange/compared.hpp"
#include "exchange/detail/formats.hpp"
#include "exchange/exchange.hpp"
#include "model/model.hpp"
#include "notation/notation.hpp"
#include "turtle/turtle.hpp"

// Programs of lpfg that are written, and read again.

using namespace algae;
using namespace algae::exchange_tests;

namespace {

bool holds(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

/// The values of all parameters of a generation but those that turns and steps have only in L+C: as a text of letters that are in both.
std::string numbers(const Model& system, std::uint64_t n, const std::string& letter) {
    const DerivedModules derived = derived_modules(system, n, {});
    const std::string word = ModuleText(system.alphabet, derived.kinds).text(derived.word);
    std::string found;
    for (std::size_t at = word.find(letter + "("); at != std::string::npos;
         at = word.find(letter + "(", at + 1))
        found += word.substr(at, word.find(')', at) + 1 - at);
    return found;
}

std::size_t length(const Model& system, std::uint64_t n) {
    return derived_modules(system, n, {}).word.kinds.size();
}

}  // namespace

TEST_CASE("systems are written as people write programs of lpfg") {
    const Model koch = read_lsystem(
        "title Koch\naxiom F++F++F\nF -> F-F++F-F\nangle 60\nstart 0 0 90\ngeneration 3\n", "k");
    CHECK(print_lpfg(koch) ==
          "#include <lpfgall.h>\n// Koch\nderivation length: 3;\n"
          "Axiom: F(1) Left(60) Left(60) F(1) Left(60) Left(60) F(1);\nproduction:\n"
          "F(x1) :\n{\n  produce F(1) Right(60) F(1) Left(60) Left(60) F(1) Right(60) F(1);\n}\n");
    const Model tree = read_lsystem(
        "let r = 1/2\naxiom A(1)\nA(s) : s > 1/8 & !(s = 3) -> F(s)[+(30)A(s*r)][-(30)A(s^2/3)]\n"
        "A(s) : s <= 1/8 -> ε\nstart 0 0 90\n",
        "t");
    const std::string program = print_lpfg(tree);
    CAPTURE(program);
    CHECK(holds(program, "const float r = (float(1)/2);\n"));
    CHECK(holds(program, "module A(float);\n"));
    CHECK(holds(program,
                "A(s) :\n{\n  if (((s>(float(1)/8))&&(!((s==3))))) produce F(s) SB() "
                "Left(30) A((s*r)) EB() SB() Right(30) A((pow(s, 2)/3)) EB();\n}\n"));
    CHECK(holds(program, "A(s) :\n{\n  if ((s<=(float(1)/8))) produce;\n}\n"));
    const Model back = read_lpfg(program, "t.lpfg");
    for (std::uint64_t n = 0; n < 6; ++n) {
        CHECK(word_of(back, n) == word_of(tree, n));
        CHECK(numbers(back, n, "A") == numbers(tree, n, "A"));
        CHECK(same_scene(scene_of(back, n).scene, scene_of(tree, n).scene));
    }
    CHECK(converted(program, "t.lpfg", "lpfg", "lsys", {}) == print_lsystem(back));
    CHECK(system_format("t.lpfg")->name == "lpfg");
}

TEST_CASE("letters that are no names in L+C, or those of others, get names") {
    // F with and without a number, a reserved word, parameters called as letters, contexts that skip.
    const Model system = read_lsystem(
        "alphabet if Left F_l F_r\naxiom F(2)F if Left F_l\nF -> F F_r(2)\nF(if) : if < 9 -> "
        "F(if+1)\n"
        "if < Left > F_l -> if g g(2)\ng(Left) -> g(Left/2)\nignore F F_r +\ninterpret Left -> "
        "F+F\n"
        "angle 25\nstep 3\nstart 0 0 90\n",
        "s");
    const std::string program = print_lpfg(system);
    CAPTURE(program);
    CHECK(holds(program, "interpretation:\n"));
    const Model back = read_lpfg(program, "s.lpfg");
    for (std::uint64_t n = 0; n < 5; ++n) {
        CHECK(length(back, n) == length(system, n));
        CHECK(same_scene(scene_of(back, n).scene, scene_of(system, n).scene));
    }
    CHECK(numbers(back, 3, "g") == "");
    CHECK(length(back, 3) > length(back, 1));
    // Letters that stand for symbols of cpfg are told from them.
    const Model coloured =
        read_lpfg(print_lpfg(read_lsystem("axiom FX_59F\nF > X_59 -> F F\ninterpret X_59 -> '\n"
                                          "start 0 0 90\ncolour red blue\n",
                                          "c")),
                  "c.lpfg");
    CHECK(length(coloured, 1) == 4);
    // Turns to the right, colours and widths.
    const Model right = read_lsystem(
        "axiom F+F+(30)F'F'(2)F!(0.1)F|F{F.F}\nF -> F-F\nangle 50\nturn clockwise\nstart 0 0 90\n"
        "colour red blue green\n",
        "r");
    const Model read = read_lpfg(print_lpfg(right), "r.lpfg");
    CHECK(same_scene(scene_of(read, 2).scene, scene_of(right, 2).scene));
    CHECK(holds(print_lpfg(right), "Right(50)"));
}

TEST_CASE("what a block of L+C assigns stands where it is read, with its type") {
    const std::string head =
        "#include <lpfgall.h>\nmodule A(int, float);\nmodule B(float);\nderivation length: 1;\n"
        "Axiom: A(7, 1) A(1, 3);\nproduction:\n";
    const auto word = [&](const std::string& rule) {
        const Model system = read_lpfg(head + rule, "x.lpfg");
        const DerivedModules derived = derived_modules(system, 1, {});
        return ModuleText(system.alphabet, derived.kinds).text(derived.word);
    };
    // 7/2 is 3 for whole numbers, also where an int gets it; 1/2 is 0 for a float too, which is then divided as one.
    CHECK(word("A(n, x) : { float y = n/2; int k = x*2.7; produce B(y) B(k) B(y/2); }\n") ==
          "B(3)B(2)B(1.5)B(0)B(8)B(0)");
    CHECK(word("A(n, x) : { n = n/2; x = n/2; if (n > 1) { float z = x + 1; produce B(z); } "
               "produce B(n); }\n") == "B(2)B(0)");
    CHECK(
        word(
            "A(n, x) : { x = x + 0.5; if (x > 2) produce B(x); else { const float y = x*2; produce "
            "B(y); } }\n") == "B(3)B(3.5)");
    CHECK(scene_of(read_lpfg("#include <lpfgall.h>\nAxiom: F(1) Sphere(2);\n", "x"), 0)
              .scene.solids.size() == 1);
}

TEST_CASE("what lpfg cannot say is refused with the reason") {
    const auto refused = [](const std::string& said) {
        return refusal([&] { print_lpfg(read_lsystem(said, "s")); });
    };
    CHECK(holds(refused("axiom A\nA -(1/2)-> B\nA -(1/2)-> C\n"),
                "s:2:1: lpfg cannot say the rule A -(0.5)-> B: a choice is a program there"));
    CHECK(holds(refused("axiom A\nA > [B] -> C\n"), "its context has branches"));
    CHECK(holds(refused("axiom A(1)\nA(x) -> A(sin(x))\n"),
                "lpfg cannot say the function sin: it takes radians there"));
    CHECK(holds(refused("axiom F$F\n"), "the letter $: it means something else there"));
    CHECK(holds(refused("axiom F%F\n"), "the letter %: it means something else there"));
    CHECK(holds(refused("axiom F*(2)F\n"), "the letter * with a number"));
    CHECK(holds(refused("axiom F'(1,0,0)F\n"), "the letter ' with three numbers"));
    CHECK(holds(refused("let int = 2\naxiom F(int)\n"), "the constant int: it is no name there"));
    CHECK(holds(refused("axiom F; coding { F -> 0 }\n"), "a coding"));
    CHECK(holds(refused("axiom F; F -> F; interpret F -> G; interpret G -> F\n"),
                "it is an interpretation of what another one gives"));
    CHECK(holds(refused("table a\nF -> FF\ntable b\nF -> F\naxiom F\n"), "tables"));
    // Texts that are no programs say where.
    const auto fault = [](const std::string& text) {
        return refusal([&] { read_lpfg(text, "x.lpfg"); });
    };
    const std::string math = "#include \"lpfgall.h\"\n#include <math.h>\nmodule A(float);\n";
    CHECK(fault(math + "Axiom: A(1);\nproduction:\nA(x) : { produce A(sqrt(x)); }\n").empty());
    CHECK(holds(fault(math + "Axiom: A(1);\nproduction:\nA(x) : { produce A(M_PI); }\n"),
                "x.lpfg:6:20: error: the name 'M_PI' has no value"));
    CHECK(holds(fault("module X_59();\nAxiom: X_59();\n"),
                "x.lpfg:1:8: error: names such as X_59 stand for letters that the notation has no "
                "symbols for: expected another name"));
    CHECK(holds(fault(""), "x.lpfg:1:1: error: expected a line `Axiom: F(1);`, found none"));
    CHECK(holds(fault("Axiom: A(1);\n"), "x.lpfg:1:8: error: the module 'A' is not declared"));
    CHECK(holds(fault("Axiom: F(1)\n"), "x.lpfg:1:7: error: expected ';' behind"));
}

TEST_CASE("random systems written for lpfg read back with the same lengths, numbers and figures") {
    std::size_t compared = 0, drawn = 0;
    CHECK(rc::check([&] {
        const auto below = [](int from, int to) {
            return *rc::gen::resize(100, rc::gen::inRange(from, to));
        };
        const auto expression = [&](const std::vector<std::string>& names) {
            std::vector<std::string> parts{"1", "2", "1/2", "0.25", "r"};
            parts.insert(parts.end(), names.begin(), names.end());
            parts.insert(parts.end(), names.begin(), names.end());
            std::string said = *rc::gen::elementOf(parts);
            for (int i = below(0, 3); i > 0; --i)
                said = "(" + said + *rc::gen::elementOf(std::vector<std::string>{"+", "-", "*"}) +
                       *rc::gen::elementOf(parts) + ")";
            if (below(0, 4) == 0) said = "floor(" + said + "/2)";
            return said;
        };
        const auto word = [&](const std::vector<std::string>& names, int most) {
            std::string text;
            int open = 0;
            for (int i = below(1, most); i > 0; --i) {
                const std::string letter = *rc::gen::elementOf(std::vector<std::string>{
                    "A", "A", "B", "F", "F", "f", "+", "-", "&", "/", "[", "]", "if", "F_l", "'"});
                if (letter == "]" && open == 0) continue;
                open += letter == "[" ? 1 : letter == "]" ? -1 : 0;
                text += letter;
                const bool may = letter != "[" && letter != "]" && letter != "'" && letter != "if";
                if (letter == "A" || (may && below(0, 3) == 0))
                    text += "(" + expression(names) + ")";
                text += " ";
            }
            for (; open > 0; --open) text += "]";
            return text;
        };
        std::string text = "alphabet if F_l\nlet r = 2/3\naxiom A(2) " + word({}, 6) + "\n";
        const int rules = below(1, 4);
        for (int i = 0; i < rules; ++i) {
            std::vector<std::string> names{"x"};
            std::string context;
            if (below(0, 3) == 0) {
                context = *rc::gen::elementOf(std::vector<std::string>{"A(y) < ", "F < ", "B < "});
                if (context[0] == 'A') names.push_back("y");
            }
            const std::string condition = *rc::gen::elementOf(
                std::vector<std::string>{"x > 0 & ", "!(x = 1) & ", "x/2 < 1 & "});
            text += context + "A(x) : " + condition + "x " + (i % 2 == 0 ? "<" : ">=") + " " +
                    std::to_string(i) + "/2 -> " + word(names, 6) + "\n";
        }
        if (*rc::gen::arbitrary<bool>()) text += "F -> " + word({}, 4) + "\n";
        if (*rc::gen::arbitrary<bool>()) text += "interpret B -> F+F(2)\n";
        if (*rc::gen::arbitrary<bool>()) text += "ignore + - F_l\n";
        text += "angle " + std::to_string(*rc::gen::element(20, 45, 60)) + "\nstart 0 0 90\nstep " +
                std::to_string(*rc::gen::element(1, 2)) + "\n";
        if (below(0, 3) == 0) text += "turn clockwise\n";
        RC_LOG() << text;
        const Model system = read_lsystem(text, "any");
        const std::string program = print_lpfg(system);
        RC_LOG() << program;
        const Model back = read_lpfg(program, "back");
        for (std::uint64_t n = 0; n < 3; ++n) {
            std::size_t expected = 0;
            try {
                expected = length(system, n);
            } catch (const Error&) {
                return;  // two rules that match
            }
            if (expected > 3000) return;
            RC_ASSERT(length(back, n) == expected);
            RC_ASSERT(numbers(back, n, "A") == numbers(system, n, "A"));
            ++compared;
            const Scene a = scene_of(system, n).scene, b = scene_of(back, n).scene;
            RC_ASSERT(same_scene(a, b));
            drawn += a.rods.empty() ? 0 : 1;
        }
    }));
    MESSAGE(compared << " words compared, " << drawn << " of them with strokes");
    CHECK(compared >= 50);
    CHECK(drawn >= 20);
}

TEST_CASE(
    "steps with numbers and branches in contexts are written for cpfg as the notation means them") {
    const Model steps = read_lsystem("axiom F(2)F f G(3); F -> F F(2); step 3; start 0 0 90", "s");
    const Model back = read_cpfg(print_cpfg(steps), "s.l");
    for (std::uint64_t n = 0; n < 3; ++n)
        CHECK(same_scene(scene_of(back, n).scene, scene_of(steps, n).scene));
    const Model branch = read_lsystem("axiom A[BC]D; A > [B]D -> F; start 0 0 90", "s");
    CHECK(holds(print_cpfg(branch), "A > [B=]D --> F\n"));
    CHECK(word_of(read_cpfg(print_cpfg(branch), "s.l"), 1) == "F [ B C ] D ");
    const Model any =
        read_lsystem("axiom A[B]D; A > []D -> F; A > [B[C]]E -> G; start 0 0 90", "s");
    CHECK(holds(print_cpfg(any), "A > [=]D --> F\n"));
    CHECK(holds(print_cpfg(any), "A > [B[C=]=]E --> G\n"));
    CHECK(holds(
        refusal([] { print_cpfg(read_lsystem("axiom A[B][C]; A > [C] -> F; start 0 0 90", "s")); }),
        "cpfg cannot say the rule A > [C] -> F: a branch in a context is the first"));
}

TEST_CASE("a number that begins with 0 is octal in C, and refused") {
    CHECK(holds(refusal([] {
                    read_lpfg("#include <lpfgall.h>\nmodule A(float);\nAxiom: A(010);\n", "x.lpfg");
                }),
                "a number that begins with 0 is octal in C: say it without the 0"));
}
