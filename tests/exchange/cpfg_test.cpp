#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <map>

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
        {file("A --> B(trunc(1.7),trunc(0-1.7))\n"), "B(2,-2)"},
        {file("A --> B(7%3,7.9%3)\n"), "B(1,1)"},
        {file("A --> B(foo+1)\n"), "B(1)"},
        {file("A > [B=]C --> Y\n", "A[BDE]C"), "Y[BDE]C"},
        {file("A --> B\ndecomposition\nB --> CB\n"), "CB"},
        {file("A --> B\ndecomposition\nmaximum depth: 3\nB --> CB\n"), "CCCB"},
        {file("A --> B\ndecomposition\nB --> C\n", "B"), "C"},
        {file("A --> B\ndecomposition\nB --> C\n", "B", "derivation length: 0\n"), "B"},
        // Others, by what the program's texts say.
        {file("A(x) : x<>3 --> B\n", "A(3)A(4)"), "A(3)B"},
        {file("A --> B(Z)\n", "A", "derivation length: 1+1\n"), "B(2)"},
        {file("A --> B(2>1 ? 5 : 6, 2<1 ? 5 : 1 ? 7 : 8)\n"), "B(5,7)"},
        {file("A --> B((0-7)%3, sign(0-2), atan2(1,0-1))\n"), "B(-1,-1,135)"},
        {file("A --> X\nB < A --> Y\n", "BA"), "BX"},
        {file("A(x) : x>1 --> X\nB < A(x) --> Y\n", "BA(1)BA(2)"), "BYBX"},
        {file("A(x) : x>1 --> X\nA(y) --> Y(y)\n", "A(1)A(2)"), "Y(1)X"},
        {file("A(x) --> B(x+1)\ndecomposition\nmaximum depth: 2\nB(y) --> C(y*2)B(y)\n", "A(1)"),
         "C(4)C(4)B(2)"},
        {file("A --> [@#(1)@Gs@!(8)F@Ge(2)]\n"), "[@contour(1)@Gs@sides(8)F@Ge(2)]"},
        {file("#ifdef LONG\nA --> BBB\n#elif defined(SHORT) && SHORT > 1\nA --> B\n#else\nA --> "
              "C\n#endif\n",
              "A", "derivation length: 1\n", "#define SHORT 2\n#if 0\n#define LONG\n#endif\n"),
         "B"},
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
        {file("A --> B\ndecomposition\nC < B --> CB\n"), "a decomposition with contexts"},
        {file("A --> B\ndecomposition\nB --> CB : 2\n"),
         "a decomposition with contexts or weights"},
        {file("A(x) --> B(x)\ndecomposition\nmaximum depth: 99\nB(x) --> B(x+x)\n"),
         "x.l:4:10: error: a decomposition that gives an expression of more than 10000 characters"},
        {file("A(x) --> B(x)B(x+1)B(x+2)B(x+3)B(x+4)B(x+5)B(x+6)\ndecomposition\n"
              "B(x) : x > 9 --> C\n"),
         "a decomposition whose conditions have more than 64 outcomes for one rule"},
        {file("A(x) : x > 1 --> B : 1\nA(x) : x > 2 --> C : 1\ndecomposition\nA(x) --> D\n", "A(1)",
              "seed: 1\n"),
         "x.l:7:1: error: a decomposition of what rules with contexts or conditions may leave"},
        {"Lsystem: 1\nAxiom: A\nendlsystem\n",
         "x.l:3:1: error: expected a rule or an empty line before 'endlsystem'"},
        {file("A --> g\n", "A{F}"), "g beside polygons leaves no corner"},
        {file("A --> B\n", "?(1,2)A$"), "the symbol ? begins a system within another"},
        {file("A --> @S\n"), "the command @S has no meaning"},
        {file("A --> F(x)_(2)\n"),
         "the symbol _ goes by the older tropism, which turns by an arc sine"},
        {file("](l) < A --> B\n"), "x.l:4:1: error: a bracket in a left context has no meaning"},
        {file("A] --> B\n"),
         "x.l:4:2: error: a bracket in a predecessor of several modules has no meaning"},
        {file("A > B](l)C --> B\n"), "x.l:4:6: error: expected a right context that is a tree"},
        {file("A > =]B --> B\n"), "x.l:4:5: error: = in a context skips what follows in a branch"},
        {file("A --> B\n#endif\n"), "x.l:5:1: error: #endif without #if"},
        {file("#if 1\nA --> B\n"), "x.l:4:1: error: expected #endif, found none"},
        {file("A > B --> Y\n", "AB[C]", "ring lsystem\nderivation length: 1\n"),
         "x.l:2:1: error: a ring with branches has no meaning"},
        {file("AB < C --> Y\n", "ABC", "ring lsystem\nderivation length: 1\n"),
         "x.l:5:1: error: a context of several modules in a ring has no meaning"},
        {file("A < B --> *\n", "ABC", "ring lsystem\nderivation length: 1\n"),
         "x.l:5:1: error: a word of a ring in which contexts see no letter has no meaning"},
        {file("A < B --> C : 2\n", "ABC", "seed: 1\nring lsystem\nderivation length: 1\n"),
         "x.l:3:1: error: a ring with choices and contexts has no meaning"},
        {file("AB --> C\n", "ABC", "ring lsystem\nderivation length: 1\n"),
         "x.l:2:1: error: a ring beside predecessors of several modules"},
        {file("A < B --> C\n", "AB%C", "ring lsystem\nderivation length: 1\n"),
         "x.l:2:1: error: a ring with % has no meaning"},
        {file("A < B --> C\n+ --> A\n", "A+B", "ring lsystem\nignore: +\nderivation length: 1\n"),
         "x.l:7:1: error: a rule of a ring by which contexts see more than before"},
        {file("A > B=C --> Y\n", "ABDC"), "= in a context skips what follows in a branch"},
        {file("A --> B(ran(2))\n"), "the function ran has no meaning"},
        {file("A --> B\n", "A", "define: { array a[3]; }\n"), "arrays have no meaning"},
        {file("A --> B\n", "A", "Start: { fopen(1); }\n"),
         "x.l:2:10: error: a statement other than NAME = number; has no meaning in the notation: "
         "found 'fopen(1)'"},
        {file("A --> B\n", "A", "Start: { srand(1; }\n"),
         "x.l:2:10: error: a statement other than NAME = number;"},
        {file("A --> B\n", "A", "End: { x = 1; }\n"), "the block End: holds statements"},
        {file("A --> B\n", "A", "StartEach: { x = 2*x; }\n"),
         "x.l:2:1: error: the block StartEach: has a meaning in the notation only where it adds "
         "numbers: {n = n+1;}"},
        {file("A --> B\n", "A", "Start: x = 1;\n"), "expected a block { ... } behind 'Start:'"},
        {file("A --> B\n", "A", "Start: {x = 1;} y\n"),
         "x.l:2:17: error: expected the end of the line behind the block, found 'y'"},
        {"#include \"a.l\"\n" + file("A --> B\n"),
         "x.l:1:1: error: expected a file of this name in the folder of the one that includes it "
         "or below, found none: #include \"a.l\""},
        {"#include <math.h>\n" + file("A --> B\n"),
         "x.l:1:1: error: the program's own files are not read: expected #include \"NAME\""},
        {file("A(x) : {y = 1; --> B\n", "A(1)"), "x.l:4:8: error: unmatched '{'"},
        {file("A(x) : y = 1;} 1 --> B\n", "A(1)"), "x.l:4:14: error: unmatched '}'"},
        {file("A(x) : {y = 1;} --> B\n", "A(1)"),
         "expected a condition beside the block, as in {x = 1;} 1, found none"},
        {file("A(x) : {if (x > 1) {y = 1;}} 1 --> B\n", "A(1)"),
         "x.l:4:20: error: a statement other than NAME = number; has no meaning"},
        {file("A(x) : {y = ;} 1 --> B\n", "A(1)"), "x.l:4:11: error: expected a number behind '='"},
        {file("A(x) : {n = n+1;} 1 --> B(n)\n", "A(1)"),
         "x.l:4:13: error: n is assigned by a block, and keeps its value from one rule to the "
         "next"},
        {file("A(x) : {y = x;} 1 --> B\nB --> C(y)\n", "A(1)"),
         "x.l:5:9: error: y is assigned by a block, and keeps its value"},
        {file("A(x) : {x = x+x; x = x+x; x = x+x; x = x+x; x = x+x; x = x+x; x = x+x; x = x+x; "
              "x = x+x; x = x+x; x = x+x; x = x+x; x = x+x;} 1 --> A(x)\n",
              "A(1)"),
         "a block that gives an expression of more than 10000 characters"},
        {file("AA --> C\n", "AABAB"),
         "x.l:4:2: error: a predecessor of several modules is one rule for all of them, which has "
         "a "
         "meaning in the notation only where two such predecessors cannot share modules"},
        {file("AB --> C\n", "A[B]"), "only in words without branches"},
        {file("A --> X\nAB --> C\n", "AB"), "only before all other rules for one of these modules"},
        {file("F --> *\n", "~F"), "x.l:4:1: error: a rule for F rewrites a part of the command ~F"},
        {file("A --> B\n") + "A --> B\n",
         "x.l:6:1: error: expected another 'Lsystem:' or the end of the file behind 'endlsystem', "
         "found 'A --> B'"},
        {file("A --> B\n") + file("A --> C\n"),
         "x.l:6:1: error: a second system: say which of 1, 1 is meant, as in x.l:1"},
    };
    for (const auto& [text, expected] : all) {
        INFO(text);
        CHECK(holds(cpfg_fault(text), expected));
    }
}

TEST_CASE("a decomposition with conditions uses the first rule that holds, at each depth") {
    const std::pair<std::string, const char*> all[] = {
        // 2 + 1 is above 2; 1 + 1 is not.
        {file("A(x) --> B(x+1)\ndecomposition\nB(y) : y > 2 --> CC\n", "A(2)A(1)"), "CCB(2)"},
        {file("A(x) --> B(x)\ndecomposition\nB(y) : y > 2 --> C\nB(y) : y > 1 --> D\nB(y) --> E\n",
              "A(1)A(2)A(3)"),
         "EDC"},
        // As long as the number is above 0, five times at most.
        {file("A --> B(3)\ndecomposition\nmaximum depth: 5\nB(y) : y > 0 --> F B(y-1)\n"),
         "FFFB(0)"},
        {file("A(x) --> B(x)\ndecomposition\nmaximum depth: 2\nB(y) : y > 0 --> F B(y-1)\n",
              "A(0)A(1)A(2)A(3)"),
         "B(0)FB(0)FFB(0)FFB(1)"},
        // What no rule rewrites is decomposed too, and a rule of its own comes first.
        {file("A --> A\ndecomposition\nB(y) : y > 1 --> C\n", "B(1)B(2)"), "B(1)C"},
        {file("B(x) : x > 5 --> D\ndecomposition\nB(y) : y > 1 --> C\n", "B(1)B(2)B(6)"), "B(1)CD"},
        // Beside contexts and conditions of the rule itself.
        {file("P < A(x) : x > 1 --> B(x)\nA(x) --> B(x+10)\ndecomposition\n"
              "B(y) : y > 11 --> C\nB(y) : y > 2 --> D\n",
              "PA(2)PA(3)PA(1)A(5)"),
         "PB(2)PDPDC"},
        // With weights of which only one rule has any.
        {file("A(x) --> B(x) : 1\ndecomposition\nB(y) : y > 1 --> C\n", "A(1)A(2)",
              "seed: 1\nderivation length: 1\n"),
         "B(1)C"},
    };
    for (const auto& [text, expected] : all) {
        INFO(text);
        CHECK(cpfg_word(text) == expected);
    }
    CHECK(printed_word(
              read_lpfg("module A(float);\nmodule B(float);\nderivation length: 1;\nAxiom: A(1) "
                        "A(2);\nproduction:\nA(x) : { produce B(x*2); }\ndecomposition:\n"
                        "B(x) : { if (x > 3) produce F(x); else produce f(x); }\n",
                        "x.l")) == "f(2)F(4)");
}

TEST_CASE("what blocks of cpfg assign stands where it is read") {
    const std::pair<std::string, const char*> all[] = {
        {file("A(t) : {s = t+1;} s > 2 --> B(s)\nA(t) --> C(t)\n", "A(1)A(2)"), "C(1)B(3)"},
        // Parameters are assigned too, before the condition and behind it, one after the other.
        {file("A(t) : {t = t-1;} t > 0 {u = 2*t; v = u+t;} --> B(t,u,v)\nA(t) --> C(t)\n",
              "A(1)A(3)"),
         "C(1)B(2,4,6)"},
        {file("A : * {u = 5;} --> B(u)\n"), "B(5)"},
        {file("A : 1 {u = 5;\n  v = u*2;}\n\t--> B(u)u(v)\n"), "B(5)u(10)"},
        // Names of modules are not those of numbers.
        {file("A(x) : {x = 2;} 1 --> x(x)Ax\n", "A(1)"), "x(2)Ax"},
        // Constants, and numbers that grow with the steps.
        {file("A --> B(b,a)\n", "A(a)A",
              "derivation length: 1\nStart: {a = 3; b = a/2;\n a = a+1;}\n"),
         "A(4)B(1.5,4)"},
        {file("A --> AB(n)\n", "A", "derivation length: 3\nStart: {n=5;}\nStartEach: {n=n+2;}\n"),
         "AB(11)B(9)B(7)"},
        {file("A --> A\ndecomposition\nB(x) : {x = x*2;} x < 9 --> C(x)\n", "B(3)B(6)"),
         "C(6)B(6)"},
        {file("A --> B\n", "A", "derivation length: 1\nEndEach: { }\n"), "B"},
        // Messages and the seed of random numbers change nothing.
        {file("A : 1 {printf(\"a; %d)\", 1); x = 2;} --> B(x)\n", "A",
              "derivation length: 1\nStart: {srand(7);}\nEndEach: {printf(\"%f\\n\", x);}\n"),
         "B(2)"},
    };
    for (const auto& [text, expected] : all) {
        INFO(text);
        const Model system = read_cpfg(text, "x.l");
        std::string word = printed_word(system);
        if (word.starts_with("X_81")) word = word.substr(word.find(')') + 1);
        CHECK(word == expected);
    }
    // A block may stand in a homomorphism, and braces of polygons are none.
    CHECK(printed_word(read_cpfg(file("A --> {F.}\nB : 1 --> {F\n", "A{B"), "x.l")) == "{F.}{{F");
    const Model leaf = read_cpfg(
        file("A(t) --> A(t+1)\nhomomorphism\nA(t) : {l = t/2;} 1 --> F(l)+(30)F(l)\n", "A(1)"),
        "x.l");
    CHECK(figure(leaf, 1, {})->segments() == Integer(2));
}

TEST_CASE("files that a file of cpfg includes are read, and errors name their places") {
    const std::map<std::string, std::string> files{
        {"d/size.l",
         "#define N 2 /* #include \"no.l\"\n#include \"no.l\" */\n#include \"more/rules.l\"\n"},
        {"d/more/rules.l", "#define RULE A --> B\n#include \"last.l\""},
        {"d/more/last.l", "#define WORD AA"},
        {"d/round.l", "#include \"back.l\"\n"},
        {"d/back.l", "\n#include \"round.l\"\n"},
        {"d/rules.l", "A --> B\nA --> B)\n"},
        {"d/many.l", "#include \"twice.l\"\n#include \"twice.l\"\n"},
        {"d/twice.l", std::string(1000, ' ')},
    };
    std::vector<std::string> asked;
    const IncludedText text_of = [&](const std::string& name) -> std::optional<std::string> {
        asked.push_back(name);
        const auto found = files.find(name);
        return found == files.end() ? std::nullopt : std::optional(found->second);
    };
    const std::string text =
        "#include \"size.l\"\n#if 0\n#include \"none.l\"\n#endif\nLsystem: 1\nderivation length: "
        "N\n"
        "Axiom: WORD\nRULE\nB --> BC\nendlsystem\n";
    const std::string joined = cpfg_with_included(text, "d/x.l", text_of);
    CHECK(printed_word(read_cpfg(joined, "d/x.l")) == "BCBC");
    CHECK(asked ==
          std::vector<std::string>{"d/size.l", "d/more/rules.l", "d/more/last.l", "d/none.l"});
    const auto fault = [&](const std::string& said) {
        return refusal([&] { read_cpfg(cpfg_with_included(said, "d/x.l", text_of), "d/x.l"); });
    };
    CHECK(holds(
        fault("#include \"round.l\"\n"),
        "d/back.l:2:1: error: files that include each other in a circle: expected 'round.l' not "
        "to be within itself"));
    CHECK(holds(fault("#include \"x.l\"\n"), "d/x.l:1:1: error: files that include each other"));
    const std::string head = "Lsystem: 1\nAxiom: A\n";
    CHECK(holds(fault(head + "#include \"rules.l\"\nendlsystem\n"),
                "d/rules.l:2:8: error: unmatched ')'"));
    CHECK(holds(fault("#include \"size.l\"\n" + head + "A --> B\nB --> C)\nendlsystem\n"),
                "d/x.l:5:8: error: unmatched ')'"));
    CHECK(holds(fault(head + "#include \"/etc/passwd\"\nendlsystem\n"),
                "d/x.l:3:1: error: expected a file of this name in the folder of the one that "
                "includes it or below, found none: #include \"/etc/passwd\""));
    CHECK(asked.back() == "/etc/passwd");
    // Files that include two others each, 40 deep, would be longer than any memory.
    const IncludedText doubled = [&](const std::string& name) -> std::optional<std::string> {
        const std::string next = name + "a";
        return next.size() > 40 ? std::string(1000, 'x')
                                : "#include \"" + next + "\"\n#include \"" + next + "\"\n";
    };
    CHECK(holds(refusal([&] { cpfg_with_included("#include \"a\"\n", "x.l", doubled); }),
                "with the files that are included the text has more than 10000000 characters"));
}

TEST_CASE("several systems of a file of cpfg are told apart by their labels") {
    const std::string two =
        "Lsystem: 1\nderivation length: 1\nAxiom: A\nA --> B\nendlsystem\n\nLsystem: 2\n"
        "derivation length: 1\nAxiom: A\nA --> C\nendlsystem\n";
    CHECK(printed_word(read_cpfg(two, "x.l:1")) == "B");
    CHECK(printed_word(read_cpfg(two, "x.l:2")) == "C");
    CHECK(holds(refusal([&] { read_cpfg(two, "x.l:3"); }), "there is no system '3'"));
}

TEST_CASE("rules with weights share the choice with those whose conditions hold") {
    const Model system =
        read_cpfg(file("A(x) : x > 1 --> B : 2\nA(x) --> C : 1\n", "A(1)A(2)", "seed: 3\n"), "x.l");
    REQUIRE(system.rules.size() == 3);
    const std::string text = print_lsystem(system);
    CHECK(holds(text, "-(1)-> C"));
    CHECK(holds(text, "-(2/3)-> B"));
    CHECK(holds(text, "-(1/3)-> C"));
}

TEST_CASE("a homomorphism is applied to its depth") {
    const auto segments = [](const std::string& drawn) {
        const Model system =
            read_cpfg(file("A --> A\nhomomorphism\n" + drawn, "A", "derivation length: 0\n"), "x");
        return figure(system, 0, {})->segments();
    };
    CHECK(segments("A --> FA\n") == Integer(1));
    CHECK(segments("maximum depth: 3\nA --> FA\n") == Integer(3));
    CHECK(segments("F --> FF\nA --> FF\n") == Integer(2));
    CHECK(segments("maximum depth: 2\nF --> FF\nA --> FF\n") == Integer(4));
    // Conditions that the values decide, as those of switches are; the first that holds is used.
    const std::string switches = "maximum depth: 2\nA --> S(2)\nS(x) : x < 2 --> F\n";
    CHECK(segments(switches + "S(x) : x == 2 --> FF\nS(x) --> FFF\n") == Integer(2));
    CHECK(segments(switches) == Integer(0));
    CHECK(holds(cpfg_fault(file("A(t) --> A(t)\nhomomorphism\nmaximum depth: 2\nA(t) --> S(t)\n"
                                "S(x) : x < 2 --> F\n",
                                "A(1)")),
                "a homomorphism with a condition on parameters of what a homomorphism gives"));
}

TEST_CASE("the declarative part of a program of lpfg is read") {
    const std::string program =
        "#include <lpfgall.h>\n// it does not produce much\nconst int N = 7;\n"
        "derivation length: 2;\nmodule A(int, float);\nmodule B();\n"
        "Axiom: A(N, 1)\n  B();\nproduction:\n"
        "A(n, x) :\n{\n  if (n % 2 == 1 && n > 3) {\n    produce F(x) SB() Left(30) B() EB() "
        "A(n/2, x/2);\n"
        "  }\n  else if (n > 0) produce A(n - 1, x);\n  produce B();\n}\n"
        "interpretation:\nB() : { produce F(0.5); }\n";
    const Model system = read_cpfg(program, "x.l");
    // 7/2 is 3 for whole numbers of C; 3 is odd and not above 3.
    CHECK(printed_word(system, 1) == "F(1)[+(30)B]A(3,0.5)B");
    CHECK(printed_word(system, 2) == "F(1)[+(30)B]A(2,0.5)B");
    CHECK(figure(system, 2, {})->segments() == Integer(3));
    CHECK(system_format("x.l")->read(program, "x.l").rules.size() == system.rules.size());
    CHECK(system_format_of(program)->name == "cpfg");
    // The word in a comment, or letters of a system, make no program of L+C.
    CHECK(cpfg_word("/* these rules produce a row\nmodule A(float);\n*/\n" + file("A --> B\n")) ==
          "B");
    const auto with = [](const std::string& rules) {
        return cpfg_fault("module A(float);\nAxiom: A(1);\n" + rules);
    };
    const std::pair<std::string, const char*> all[] = {
        {"A(x) : { y = 1; produce A(y); }\n",
         "x.l:3:10: error: an assignment to y is read only of parameters of the rule and of names "
         "that the same block declares, as in `float y = 1;`"},
        {"A(x) : { if (x > 1) { x = 2; } produce A(x); }\n",
         "x.l:3:23: error: an assignment to x is read only of parameters"},
        {"A(x) : { f(1); produce A(x); }\n",
         "x.l:3:10: error: a statement of C++ is not read: expected produce, if, else or NAME = "
         "number; found 'f(1)'"},
        {"A(x) : { float y = 1, z = 2; produce A(y); }\n", "a statement of C++ is not read"},
        {"A(x) : { nproduce A(x); }\n", "x.l:3:10: error: nproduce goes on behind what it makes"},
        {"A(x) : { produce C(x); }\n", "x.l:3:18: error: the module 'C' is not declared"},
        {"A(x) : { produce A(sin(x)); }\n", "x.l:3:20: error: the function sin takes radians in C"},
        {"A(x) : { produce A(x, 1); }\n",
         "x.l:3:18: error: the module A has 1 parameters, found 2"},
        {"A(x) : { produce A(y); }\n", "x.l:3:20: error: the name 'y' has no value"},
        {"float size = 3;\n", "x.l:3:1: error: a declaration of C++ is not read"},
        {"Start: { size = 3; }\n", "x.l:3:1: error: the block Start: holds statements of C++"},
        {"A(x) : { if x > 1 produce A(x); }\n", "x.l:3:13: error: expected '(' behind 'if'"},
        {"A(x) : { produce A(x);\n", "x.l:3:8: error: unmatched '{'"},
    };
    for (const auto& [rules, message] : all) {
        INFO(rules);
        CHECK(holds(with(rules), message));
    }
}

TEST_CASE("control panels of vlab are named, and hold no system") {
    CHECK(holds(cpfg_fault("// a panel\npanel name: Plant\ntarget: Lsystem\n"),
                "x.l:2:1: error: a control panel of vlab, which holds no system: expected the "
                "system that it is for"));
    CHECK(holds(refusal([] { system_format("x.l")->read("target: Lsystem\n", "x.l"); }),
                "a control panel of vlab"));
}

TEST_CASE("blocks of L-Py with produce, if, elif and else are rules with conditions") {
    const std::string text =
        "Axiom: A(0)\nderivation length: 4\nproduction:\nA(x) :\n    if x < 2 :\n        produce "
        "F A(x+1)\n    elif x == 2:\n        if x > 5: produce X\n        else: produce Y A(x+1)\n"
        "    else:\n        produce\nY : produce Z\nendlsystem\n";
    const Model system = read_lpy(text, "x.lpy");
    CHECK(printed_word(system, 2) == "FFA(2)");
    CHECK(printed_word(system, 3) == "FFYA(3)");
    CHECK(printed_word(system, 4) == "FFZ");
    const auto fault = [](const std::string& block) {
        return lpy_fault("Axiom: A\nproduction:\nA :\n" + block);
    };
    CHECK(holds(fault("  x = 1\n"),
                "x.lpy:4:3: error: a line of Python is not read: expected produce"));
    CHECK(holds(fault("  nproduce A\n"), "x.lpy:4:3: error: nproduce goes on"));
    CHECK(holds(fault("  else: produce A\n"), "x.lpy:4:3: error: else without if"));
    CHECK(holds(fault("  produce A\n    produce B\n"),
                "x.lpy:5:5: error: expected the indentation of the lines of this block, 2 columns, "
                "found 4"));
    CHECK(holds(fault("B --> A\n"), "x.lpy:3:3: error: expected a block with produce behind ':'"));
}

TEST_CASE("what % cuts stays in words, and figures are those that the program draws") {
    // The program itself prints A[BC]H after a step.
    const Model cut = read_cpfg(file("Z --> Z\n", "F[+FF%F[+F]F]F"), "x.l");
    const Model gone = read_cpfg(file("Z --> Z\n", "F[+FF]F"), "x.l");
    CHECK(printed_word(cut, 1) == "F[+FF%F[+F]F]F");
    CHECK(figure(cut, 1, {})->segments() == figure(gone, 1, {})->segments());
    const Model later = read_cpfg(file("C --> %\n", "F[FCF]F", "derivation length: 2\n"), "x.l");
    CHECK(figure(later, 2, {})->segments() == Integer(3));
}

TEST_CASE("numbers of cpfg have 32 bits, and here they are exact") {
    // The program itself prints N, as 0.1 is rounded in the word and not in the condition.
    CHECK(cpfg_word(file("A(x) : x==0.1 --> Y\nA(x) --> N\n", "A(0.1)")) == "Y");
    // It prints B(1), with a warning.
    CHECK(holds(refusal([&] { cpfg_word(file("A --> B(1/0)\n")); }), "0"));
}

TEST_CASE("commands of several symbols, and symbols that the notation lacks, are read") {
    const auto text = [&](const std::string& axiom) {
        return print_lsystem(read_cpfg(file("A --> A\n", axiom), "x.l"));
    };
    CHECK(holds(text("F&(30)@vF"), "interpret @v -> $\n"));
    CHECK(holds(text("F;F;(3)F,F,(2)F"), "interpret X_59(x) -> '(x)\n"));
    CHECK(holds(text("#(3)F"), "interpret X_35(x) -> !(x)\n"));
    CHECK(holds(text("F@O(2)"), "solid X_79 sphere radius\n"));
    CHECK(holds(text("Fg(2)F"), "interpret g(x) -> f(x)\n"));
    CHECK(holds(text("F~l(2)F$"), "axiom F ~l(2)FX_36\n"));
    CHECK(holds(text("F?P(0,0)"), "axiom F?P(0,0)\n"));
    const Model seen = read_cpfg(file("A > ?P(x,y) --> B(y)\n", "F(2)A?P(0,0)"), "x.l");
    CHECK(holds(print_lsystem(seen), "A > ?P(x,y) -> B(y)\n"));
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
    CHECK(holds(lpy_fault("import math\nAxiom: A\n"),
                "x.lpy:1:1: error: a line of Python is not read"));
    CHECK(holds(lpy_fault("Axiom: A(2^3)\n"), "^ is exclusive or in Python: a power is **"));
    CHECK(holds(lpy_fault("Axiom: A\nproduction:\nB << A --> C\n"),
                "the context << looks at the string"));
    CHECK(holds(lpy_fault("Axiom: A(sin(1))\n"), "takes radians in Python"));
    CHECK(holds(lpy_fault("Axiom: A\ngroup 1:\n"), "groups have no meaning"));
    CHECK(holds(lpy_fault("Axiom: A(1 < 2 < 3)\n"), "a chain of comparisons is not read"));
    const Model words =
        read_lpy("Axiom: Left(30)RollL F Right Sphere(2)\nproduction:\nF --> FF\n", "w.lpy");
    CHECK(print_word(words.alphabet, words.axiom) == "+(30)/F- @O(2)");
    CHECK(holds(print_lsystem(words), "interpret @O(x) -> X_79(x)\n"));
    CHECK(words.drawing.generations->second == 1);
}

TEST_CASE(
    "symbols of L-Py that the notation has no letters for are modules when they are written") {
    const Model system =
        read_lpy("module SX36\nAxiom: A $ SX36\nproduction:\nA --> A$$\nendlsystem\n", "x.lpy");
    const std::string printed = print_lpy(system);
    CHECK(holds(printed, "Axiom: A SX36_ SX36\n"));
    const Model again = read_lpy(printed, "y.lpy");
    CHECK(print_lpy(again) == printed);
    CHECK(again.rules[0].successor.letters.size() == 3);
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
    // A block of L-Py.
    CHECK(holds(print_lpy(plain), "A(x,y) :\n    if ((x<4) and (not ((y==3)))) : produce F("));
    const Model block = read_lpy(print_lpy(plain), "back");
    for (std::uint64_t n = 0; n < 5; ++n) CHECK(printed_word(block, n) == printed_word(plain, n));
    const Model within = read_lsystem(
        "axiom BA(1)B\nB < A(x) > B : x > 0 -> A(x-1)\nA(x) : x = 0 -> ε\nstart 0 0 90\n", "s");
    for (std::uint64_t n = 0; n < 3; ++n)
        CHECK(printed_word(read_lpy(print_lpy(within), "b"), n) == printed_word(within, n));
    const auto refused = [](const std::string& said) {
        return refusal([&] { print_cpfg(read_lsystem(said, "s")); });
    };
    CHECK(holds(refused("axiom F_l"), "symbols are single characters of ASCII"));
    CHECK(holds(refused("axiom F\ntable a\nF -> FF\ntable b\nF -> F"), "tables"));
    CHECK(holds(refused("axiom F+(2)F; turn clockwise"), "turn clockwise"));
    CHECK(holds(refused("axiom F; coding { F -> 0 }"), "a coding"));
    CHECK(holds(refused("axiom F'; F -> F"), "it means something else there"));
    // Of the rules that match, the longest context is used.
    const Model ordered = read_lsystem("axiom BA; A -> X; B < A -> Y", "s");
    CHECK(printed_word(read_cpfg(print_cpfg(ordered), "b"), 1) == "BY");
}

TEST_CASE("conditions that order rules do not grow when a file is read and written again") {
    // A rule behind another gets the negation of its condition once.
    const std::string text = file(
        "A(x) : x > 3 --> B(x)\nA(x) : x > 1 && sin(x) > 0 --> C\nA(x) : x > 0 --> D\nA(x) "
        "--> E\n",
        "A(1)A(2)A(4)A(0)");
    const std::string once = print_cpfg(read_cpfg(text, "x.l")),
                      twice = print_cpfg(read_cpfg(once, "x.l"));
    CHECK(once == twice);
    std::size_t compared = 0, guarded = 0;
    CHECK(rc::check([&] {
        const auto below = [](int from, int to) {
            return *rc::gen::resize(100, rc::gen::inRange(from, to));
        };
        const auto side = [&] {
            return *rc::gen::elementOf(
                std::vector<std::string>{"x", "y", "x+y", "2*x", "sin(x)", "1", "2", "Q"});
        };
        const auto relation = [&] {
            return side() +
                   *rc::gen::elementOf(std::vector<std::string>{"<", "<=", ">", ">=", "==", "!="}) +
                   side();
        };
        std::string rules;
        const int count = below(1, 5);
        for (int i = 0; i < count; ++i) {
            rules += *rc::gen::elementOf(std::vector<std::string>{"", "", "B(z) < "}) + "A(x,y)";
            const int kind = below(0, 5);
            if (kind == 1) rules += " : " + relation();
            if (kind == 2) rules += " : " + relation() + " && " + relation();
            if (kind == 3) rules += " : !(" + relation() + ") || " + relation();
            if (kind == 4) rules += " : " + relation() + " && !(" + relation() + ")";
            rules += " --> B(" + side() + ")\n";
        }
        std::string said = file(rules, "A(1,2)B(1)A(2,1)A(0,0)");
        RC_LOG() << said;
        std::string first;
        try {
            first = print_cpfg(read_cpfg(said, "x.l"));
        } catch (const Error&) {
            // The letters that count steps and order rules have no names there.
            RC_ASSERT(rules.find('Q') != std::string::npos || rules.find('<') != std::string::npos);
            return;
        }
        RC_LOG() << first;
        guarded += holds(first, "!(") ? 1 : 0;
        RC_ASSERT(print_cpfg(read_cpfg(first, "x.l")) == first);
        RC_ASSERT(cpfg_word(first) == cpfg_word(said));
        ++compared;
    }));
    MESSAGE(compared << " systems written twice, " << guarded << " of them with negations");
    CHECK(compared >= 10);
    CHECK(guarded >= 3);
}

TEST_CASE(
    "turns to the right, and names of several letters, are written where the program has them") {
    // + turns to the right there: so it is -(60) in the homomorphism, and words keep their letters.
    const Model right =
        read_lsystem("axiom F; F -> F+F--F+F; angle 60; step 2; start 0 0 90; turn clockwise", "s");
    CHECK(holds(print_cpfg(right), "F --> F(2)\n+ --> -(60)\n- --> +(60)\n"));
    for (const bool python : {false, true}) {
        const std::string text = python ? print_lpy(right) : print_cpfg(right);
        CAPTURE(text);
        const Model back = python ? read_lpy(text, "b") : read_cpfg(text, "b");
        CHECK(printed_word(back, 2) == printed_word(right, 2));
        CHECK(same_scene(scene_of(back, 2).scene, scene_of(right, 2).scene));
    }
    CHECK(holds(refusal([] {
                    print_cpfg(read_lsystem("axiom F+(30)F; turn clockwise; start 0 0 90", "s"));
                }),
                "cpfg cannot say `turn clockwise` beside turns with numbers"));
    // What interpretations give is said with the file's angle and step too.
    const Model drawn =
        read_lsystem("axiom g; g -> g+g; interpret g -> F+F; angle 30; step 3; start 0 0 90", "s");
    for (const bool python : {false, true}) {
        const std::string text = python ? print_lpy(drawn) : print_cpfg(drawn);
        CAPTURE(text);
        const Model back = python ? read_lpy(text, "b") : read_cpfg(text, "b");
        CHECK(same_scene(scene_of(back, 2).scene, scene_of(drawn, 2).scene));
    }
    const Model names = read_lsystem(
        "alphabet Apex; axiom Apex L; Apex -> F Apex L e; L -> L e f t; angle 60; start 0 0 90",
        "s");
    const std::string text = print_lpy(names);
    CAPTURE(text);
    CHECK(holds(text, "module Apex\n"));
    const Model back = read_lpy(text, "b.lpy");
    for (std::uint64_t n = 0; n < 4; ++n) CHECK(word_of(back, n) == word_of(names, n));
    // Letters that together are a name that L-Py knows stand apart.
    const Model left = read_lsystem("axiom Left; L -> LL; angle 60; start 0 0 90", "s");
    CHECK(word_of(read_lpy(print_lpy(left), "b.lpy"), 1) == "L L e f t ");
    CHECK(holds(lpy_fault("module F_a\nAxiom: F_a\nproduction:\nF_a --> F\n"),
                "x.lpy:1:8: error: the turtle of the notation draws and moves with names such as "
                "F_a: expected another name"));
}

TEST_CASE("files ending in .l are told apart by what stands in them") {
    CHECK(looks_like_cpfg("#define N 1\nLsystem: 1\n"));
    CHECK(!looks_like_cpfg("Koch { Angle 6\nAxiom F\n}\n"));
    CHECK(system_format("x.l")->read(file("A --> B\n"), "x.l").rules.size() == 1);
    CHECK(system_format_of(file("A --> B\n"))->name == "cpfg");
}

TEST_CASE("and and or of Python give one of their sides") {
    const auto word = [](const std::string& value, const char* x) {
        return printed_word(read_lpy(std::string("Axiom: A(") + x +
                                         ")\nderivation length: 1\nproduction:\nA(x) --> B(" +
                                         value + ")\nendlsystem\n",
                                     "x.lpy"));
    };
    for (const int x : {-1, 0, 1, 3}) {
        const std::string at = std::to_string(x);
        const auto is = [&](const std::string& value, int expected) {
            INFO(value << " at " << x);
            CHECK(word(value, at.c_str()) == "B(" + std::to_string(expected) + ")");
        };
        is("x and 5", x ? 5 : 0);
        is("x or 5", x ? x : 5);
        is("(x>1) and 5 or 7", x > 1 ? 5 : 7);
        is("x > 1 and x < 5", x > 1 && x < 5 ? 1 : 0);
        is("not x and 4", x ? 0 : 4);
        is("-(x or 2)", x ? -x : -2);
    }
    CHECK(holds(lpy_fault("Axiom: A\nproduction:\nA --> B(010)\n"), "a number begins with 0"));
}

TEST_CASE("either of two rules is no file of a program that takes the first") {
    const Model either = read_lsystem("axiom a; a -> ab; a -> c", "x");
    for (const auto print : {print_cpfg, print_lpfg, print_lpy})
        CHECK(
            holds(refusal([&] { print(either); }),
                  "it is one of several for its letter, of which the first is always taken there"));
    CHECK(holds(refusal([&] { print_cpfg(read_lsystem("axiom ab; a > b -> c; a > b -> d", "x")); }),
                "of which the first is always taken"));
}

TEST_CASE(
    "a letter that moves in cpfg and L-Py and not in the notation does nothing there either") {
    const Model system = read_lsystem("axiom gF; F -> FgF; start 0 0 90", "x");
    const auto end = [](const Model& of, std::uint64_t n) {
        const auto place = figure(of, n, {})->facts().end;
        return std::pair(std::lround(place[0].value() * 1e6), std::lround(place[1].value() * 1e6));
    };
    CHECK(end(read_cpfg(print_cpfg(system), "y"), 2) == end(system, 2));
    CHECK(end(read_lpy(print_lpy(system), "y"), 2) == end(system, 2));
    const Model with_number = read_lsystem("axiom g(2)F; start 0 0 90", "x");
    CHECK(end(read_cpfg(print_cpfg(with_number), "y"), 0) == end(with_number, 0));
}

TEST_CASE("what cannot say a coding refuses it") {
    const Model coded = read_lsystem("axiom F; F -> FF; coding { F -> 0 }", "x");
    for (const auto print : {print_netlogo, print_brno, print_maple, print_cpfg, print_inkscape})
        CHECK(holds(refusal([&] { print(coded); }), "a coding"));
}
