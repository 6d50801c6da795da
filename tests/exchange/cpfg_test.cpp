#include <doctest/doctest.h>
#include <rapidcheck.h>

#include "exchange/compared.hpp"
#include "exchange/detail/formats.hpp"
#include "exchange/exchange.hpp"
#include "exchange/inputs.hpp"
#include "model/model.hpp"
#include "notation/notation.hpp"
#include "turtle/turtle.hpp"

using namespace algae;
using namespace algae::exchange_tests;

namespace {

/// The word of the system's own derivation length, as the program prints it.
std::string printed_word(const Model& system, std::optional<std::uint64_t> n = {}) {
    const std::uint64_t generation = n ? *n
                                     : system.drawing.generations
                                         ? system.drawing.generations->second
                                         : 0;
    const DerivedModules derived = derived_modules(system, generation, {});
    std::string text = ModuleText(system.alphabet, derived.kinds).text(derived.word);
    std::erase(text, ' ');
    return text == "ε" ? "" : text;
}

std::string file(const std::string& rules, const std::string& axiom = "A",
                 const std::string& header = "derivation length: 1\n",
                 const std::string& before = "") {
    return before + "Lsystem: 1\n" + header + "Axiom: " + axiom + "\n" + rules + "endlsystem\n";
}
std::string cpfg_word(const std::string& text) { return printed_word(read_cpfg(text, "x.l")); }
std::string cpfg_fault(const std::string& text) {
    return refusal([&] { read_cpfg(text, "x.l"); });
}
std::string lpy_fault(const std::string& text) {
    return refusal([&] { read_lpy(text, "x.lpy"); });
}
bool holds(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("files of cpfg give the words that the program prints") {
    // What the program itself printed for these.
    const std::pair<std::string, const char*> all[] = {
        {file("A --> B(-2^2)\n"), "B(4)"},
        {file("A --> B(2^3^2)\n"), "B(64)"},
        {file("A --> B(1.0e5)\n"), "B(100000)"},
        {file("A --> B(7/2)\n"), "B(3.5)"},
        {file("F(x) --> G(x)\n", "FF(1)"), "FG(1)"},
        {file("A --> B\nA --> C\n"), "B"},
        {file("A --> B\n\tC\n"), "BC"},
        {"Lsystem: 1\nAxiom: A\nA --> B\nendlsystem\n", "A"},
        {"lsystem: 1\nderivation length:1\naxiom:A\nA-->B\nEndLsystem\n", "B"},
        {file("A > B --> X\n", "[A]B"), "[A]B"},
        {file("A > B --> X\n", "A[C]B"), "X[C]B"},
        {file("A > B --> X\nA > [B] --> Y\n", "A[B]C"), "Y[B]C"},
        {file("A > [B]C --> Y\n", "A[B]C"), "Y[B]C"},
        {file("B < A --> X\n", "B[A]"), "B[X]"},
        {file("B < A --> X\n", "B[C]A"), "B[C]X"},
        {file("PQ < A --> X\nQP < A --> Y\n", "PQA"), "PQX"},
        {file("B < A --> X\n", "B+A", "ignore: +-\nderivation length: 1\n"), "B+X"},
        {file("B < A --> X\n", "B+(30)A", "ignore: +-\nderivation length: 1\n"), "B+(30)X"},
        {file("B < A --> X\n", "B+A", "consider: AB\nderivation length: 1\n"), "B+X"},
        {file("B < A --> X\n", "B[+A]", "consider: AB\nderivation length: 1\n"), "B[+X]"},
        {file("B < A --> X\n", "B+-A", "ignore: +\nignore: -\nderivation length: 1\n"), "B+-A"},
        {file("B --> *\n", "ABA"), "AA"},
        {file("A --> B : 50\nA --> C : 50\n"), "B"},
        {file("A(x) : x<2 --> B\nA(x) : x>=2 && x<9 --> C\n", "A(3)"), "C"},
        {file("A(x) : x<5 --> B\nA(x) : x<9 --> C\n", "A(3)A(6)"), "BC"},
        {file("A(x) : x<5 --> B\nA(x) --> C\n", "A(3)A(6)"), "BC"},
        {file("A(x) --> B(x+1)\n", "A (3)"), "B(4)"},
        {"Lsystem: 1\n\n\nderivation length: 1\n\nAxiom: A\n\nA --> B\n\nendlsystem\n", "B"},
        {file("A(n) : n>1 && n<3 --> B(n)\n", "A(2)"), "B(2)"},
        {file("A(t) --> B(LEN(t))A(t+1)\n", "A(1)", "derivation length: N\n",
              "#define N 2\n#define LEN(x) (x*2) // twice\n/* a\ncomment */\n"),
         "B(2)B(4)A(3)"},
    };
    for (const auto& [text, expected] : all) {
        INFO(text);
        CHECK(cpfg_word(text) == expected);
    }
}

TEST_CASE("what has no meaning here, or none in cpfg, is refused with its place") {
    const std::pair<std::string, const char*> all[] = {
        {file("A --> B(1e5)\n"), "x.l:4:9: error: the exponent of a number needs a decimal point"},
        {file("A --> B\n C\n"), "x.l:5:2: error: a line that begins with a blank"},
        {"Lsystem: 1\nAxiom: A\nA --> B\n", "expected 'endlsystem', found the end of the file"},
        {"LSYSTEM: 1\nAxiom: A\n", "x.l:1:1: error: expected 'Lsystem: 1', found 'LSYSTEM: 1'"},
        {file("B --> \n", "ABA"), "expected a successor behind '-->', or * for none"},
        {file("A(x) : x=3 --> B\n", "A(3)"), "found '='; a comparison is =="},
        {file("A(x) : x>1 & x<5 --> B\n", "A(3)"), "found '&'; 'and' is &&"},
        {file("A(1) --> X\n", "A(1)A(2)"), "expected a name as parameter, found '1'"},
        {file("A --> B)C\n"), "unmatched ')'"},
        {file("A --> B(foo+1)\n"), "the name 'foo' has no value; cpfg takes 0 for it"},
        {file("AB --> C\n", "AABAB"), "a predecessor of several modules"},
        {file("s --> X\n", "@Gs"), "the symbol @ says colours, surfaces, queries"},
        {file("A --> B\ndecomposition\nB --> CB\n"), "a decomposition rewrites within a step"},
        {file("A --> Y\n", "ABC", "ring lsystem\nderivation length: 1\n"), "a ring joins the ends"},
        {file("A > [B=]C --> Y\n", "A[BDE]C"), "= in a context skips a branch"},
        {file("A --> B(7%3)\n"), "% in an expression has no meaning"},
        {file("A --> B(trunc(1.7))\n"), "the function trunc has no meaning"},
        {file("A --> X\nB < A --> Y\n"),
         "a rule with longer contexts behind one with shorter ones"},
        {file("A --> B\n", "A", "define: { array a[3]; }\n"), "arrays have no meaning"},
        {file("A --> B\n", "A", "Start: { x = 1; }\n"), "the block Start: holds statements"},
        {"#include \"a.l\"\n" + file("A --> B\n"), "x.l:1:1: error: #include is not read"},
        {file("A(x) : {y = 1;} 1 --> B\n", "A(1)"), "a block of statements"},
        {file("A --> B\nA(x) : x > 1 --> C : 2\n", "A", "seed: 3\n"), "a condition beside weights"},
    };
    for (const auto& [text, expected] : all) {
        INFO(text);
        CHECK(holds(cpfg_fault(text), expected));
    }
    CHECK(
        holds(refusal([] { read_cpfg("#include <lpfgall.h>\n", "x.l"); }), "is a program of lpfg"));
}

TEST_CASE("a seed makes weights probabilities") {
    const Model system = read_cpfg(
        file("A --> B : 2\nA --> C : 1\n", "A", "seed: 5\nderivation length: 1\n"), "x.l");
    REQUIRE(system.rules.size() == 2);
    CHECK(*system.rules[0].probability == Rational(2, 3));
    CHECK(*system.rules[1].probability == Rational(1, 3));
}

TEST_CASE("the roll of cpfg goes the other way than that of the notation, that of L-Py does not") {
    CHECK(print_word(read_cpfg(file("A --> A\n", "/(90)&(30)F"), "x").alphabet,
                     read_cpfg(file("A --> A\n", "/(90)&(30)F"), "x").axiom) == "\\(90)&(30)F");
    const Model same = read_lpy("Axiom: /(90)&(30)F\nproduction:\nA --> B\nendlsystem\n", "x");
    CHECK(print_word(same.alphabet, same.axiom) == "/(90)&(30)F");
    CHECK(same.drawing.angle->value == 60);
    CHECK(read_cpfg(file("A --> A\n"), "x").drawing.angle->value == 45);
}

TEST_CASE("the declarative part of L-Py is read, and programs are refused") {
    const Model row = read_lpy(
        "c = 1\np = 0.3\nq = c - p\nh = (p*q) ** 0.5\nAxiom: -(90) F(1)\nderivation length: "
        "2\nproduction:\nF(x) --> F(x*p)+(86)F(x*h)-(172)F(x*h)+(86)F(x*q)\nendlsystem\n###### "
        "INITIALISATION ######\n}{",
        "row.lpy");
    CHECK(printed_word(row, 1).starts_with("-(90)F(0.3)+(86)F(0.458257569"));
    const Model dragon = read_lpy(
        "Axiom: FX # the start\nderivation length: 10\nproduction:\nX --> X+(90)YF+(90)\nY --> "
        "-(90)FX-(90)Y\nendlsystem\n",
        "d.lpy");
    CHECK(figure(dragon, 10, {})->segments() == Integer(1024));
    const Model named = read_lpy(
        "module Apex, Node(x)\nAxiom: Apex\nderivation length: 2\nproduction:\nApex --> Node Apex\n"
        "endlsystem\n",
        "n.lpy");
    CHECK(printed_word(named) == "NodeNodeApex");
    const Model erased =
        read_lpy("Axiom: AB\nderivation length: 1\nproduction:\nA -->\nendlsystem\n", "e");
    CHECK(printed_word(erased) == "B");
    CHECK(holds(lpy_fault("Axiom: A\nproduction:\nA :\n  produce B\n"),
                "a line of Python is not read"));
    CHECK(holds(lpy_fault("import math\nAxiom: A\n"),
                "x.lpy:1:1: error: a line of Python is not read"));
    CHECK(holds(lpy_fault("Axiom: A(2^3)\n"), "^ is exclusive or in Python: a power is **"));
    CHECK(holds(lpy_fault("Axiom: A\nproduction:\nB << A --> C\n"),
                "the context << looks at the string"));
    CHECK(holds(lpy_fault("Axiom: A(sin(1))\n"), "takes radians in Python"));
    CHECK(holds(lpy_fault("Axiom: A\ngroup 1:\n"), "groups have no meaning"));
}

TEST_CASE("systems written for cpfg and L-Py read back with the same words and the same figures") {
    std::size_t compared = 0, drawn = 0;
    CHECK(rc::check([&] {
        const bool python = *rc::gen::arbitrary<bool>();
        const auto word = [&](const char* letters, int most) {
            std::string text;
            const int count = *rc::gen::inRange(1, most);
            int open = 0;
            for (int i = 0; i < count; ++i) {
                const char letter = *rc::gen::elementOf(std::string(letters));
                if (letter == ']' && open == 0) continue;
                open += letter == '[' ? 1 : letter == ']' ? -1 : 0;
                text += letter;
            }
            return text + std::string(static_cast<std::size_t>(open), ']');
        };
        std::string text = "axiom " + word("FXY+-[]", 6) + "X\n";
        const std::string context =
            *rc::gen::elementOf(std::vector<std::string>{"", "F < ", "Y < "});
        if (!context.empty()) text += context + "X -> " + word("FXY+-[]", 5) + "\n";
        text += "X -> " + word("FXY+-[]", 6) + "\n";
        if (*rc::gen::arbitrary<bool>()) text += "F -> " + word("F+-", 4) + "\n";
        if (*rc::gen::arbitrary<bool>()) text += "interpret Y -> F-F\n";
        text += "ignore + -\nangle " + std::to_string(*rc::gen::element(30, 45, 60, 72, 90)) +
                "\nstart 0 0 90\n";
        const Model system = read_lsystem(text, "any");
        std::string file;
        try {
            file = python ? print_lpy(system) : print_cpfg(system);
        } catch (const Error&) {
            return;  // an interpretation beside an angle of its own
        }
        const Model back = python ? read_lpy(file, "back") : read_cpfg(file, "back");
        for (std::uint64_t n = 0; n < 4; ++n) {
            RC_ASSERT(printed_word(back, n) == printed_word(system, n));
            ++compared;
            const auto a = figure(system, n, {}), b = figure(back, n, {});
            RC_ASSERT(a->segments() == b->segments());
            if (a->box().empty) continue;
            RC_ASSERT(std::fabs(a->box().low.x - b->box().low.x) < 1e-6);
            RC_ASSERT(std::fabs(a->box().high.y - b->box().high.y) < 1e-6);
            ++drawn;
        }
    }));
    CHECK(compared >= 60);
    CHECK(drawn >= 30);
}

TEST_CASE("parameters and conditions are written for cpfg") {
    const std::string text =
        "let r = 0.5\naxiom A(1,2)\nA(x,y) : x < 4 & !(y = 3) -> "
        "F(x^2/r)[+(30)A(x+1,y*2)]A(x+2,-y)\n"
        "A(x,y) : x >= 4 -> F(min(x,2))\nangle 30\nstart 0 0 90\n";
    const Model system = read_lsystem(text, "s");
    CHECK(holds(refusal([&] { print_cpfg(system); }), "cpfg cannot say the function min"));
    const Model plain = read_lsystem(
        text.substr(0, text.find("A(x,y) : x >= 4")) + "angle 30\nstart 0 0 90\n", "s");
    const Model back = read_cpfg(print_cpfg(plain), "back");
    for (std::uint64_t n = 0; n < 5; ++n) CHECK(printed_word(back, n) == printed_word(plain, n));
    CHECK(holds(refusal([&] { print_lpy(plain); }), "its condition is a program there"));
    const auto refused = [](const std::string& said) {
        return refusal([&] { print_cpfg(read_lsystem(said, "s")); });
    };
    CHECK(holds(refused("axiom F_l"), "symbols are single characters of ASCII"));
    CHECK(holds(refused("axiom F\ntable a\nF -> FF\ntable b\nF -> F"), "tables"));
    CHECK(holds(refused("axiom F; turn clockwise"), "turn clockwise"));
    CHECK(holds(refused("axiom F; coding { F -> 0 }"), "a coding"));
    CHECK(holds(refused("axiom F'; F -> F"), "it means something else there"));
    // Of the rules that match, the longest context is used.
    const Model ordered = read_lsystem("axiom BA; A -> X; B < A -> Y", "s");
    CHECK(printed_word(read_cpfg(print_cpfg(ordered), "b"), 1) == "BY");
}

TEST_CASE("files ending in .l are told apart by what stands in them") {
    CHECK(looks_like_cpfg("#define N 1\nLsystem: 1\n"));
    CHECK(!looks_like_cpfg("Koch { Angle 6\nAxiom F\n}\n"));
    CHECK(system_format("x.l")->read(file("A --> B\n"), "x.l").rules.size() == 1);
    CHECK(system_format_of(file("A --> B\n"))->name == "cpfg");
}
