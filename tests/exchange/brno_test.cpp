#include <doctest/doctest.h>
#include <rapidcheck.h>

#include "exchange/any_brno.hpp"
#include "exchange/compared.hpp"
#include "exchange/detail/formats.hpp"
#include "exchange/exchange.hpp"
#include "exchange/inputs.hpp"
#include "model/model.hpp"
#include "notation/notation.hpp"
#include "turtle/slow_walk.hpp"

using namespace algae;
using namespace algae::exchange_tests;

namespace {

std::string lsys(const std::string& text) { return print_lsystem(read_brno(text, "x.brno")); }
std::string said(const std::string& text) {
    return refusal([&] { read_brno(text, "x.brno"); });
}
std::string unsaid(const std::string& text) {
    return refusal([&] { print_brno(read_lsystem(text, "x.lsys")); });
}

/// A small file with this of modules, axiom, angles and rules.
std::string file(const std::string& modules, const std::string& axiom, const std::string& angles,
                 const std::string& rules) {
    return "modules: " + modules + ";\naxiom: " + axiom + ";\nangles: " + angles +
           ";\nrules: " + rules + ";\nEND\n";
}

}  // namespace

TEST_CASE("the bush is that of the gallery, letter by letter and stroke by stroke") {
    const Model bush = read_brno(example("bush.brno"), "bush.brno");
    Model known = of_gallery("bush-3d");
    CHECK(read_brno(print_brno(known), "bush-3d").drawing.start == std::nullopt);
    known.drawing.start.reset();  // the format does not say that it stands
    const std::size_t lengths[] = {1, 36, 216, 777, 2556, 8010};
    for (std::uint64_t n = 0; n <= 5; ++n) {
        const std::string word = word_of(bush, n);
        CHECK(word.size() == 2 * lengths[n]);
        CHECK(word == word_of(known, n));
    }
    const SpaceDerivation own = scene_of(bush, 5), theirs = scene_of(known, 5);
    CHECK(trace(own, {}).distinct_segments == 420);
    REQUIRE(own.scene.rods.size() == theirs.scene.rods.size());
    for (std::size_t i = 0; i < own.scene.rods.size(); ++i) {
        CHECK(near(own.scene.rods[i].from, theirs.scene.rods[i].from));
        CHECK(near(own.scene.rods[i].to, theirs.scene.rods[i].to));
        CHECK(own.scene.rods[i].radius == 2.5);  // of c(5,5)
    }
    REQUIRE(own.scene.solids.size() == theirs.scene.solids.size());
    CHECK(own.scene.solids.size() > 100);
    for (std::size_t i = 0; i < own.scene.solids.size(); ++i) {
        CHECK(near(own.scene.solids[i].middle, theirs.scene.solids[i].middle));
        CHECK(own.scene.solids[i].size.x == 3);
    }
    CHECK(own.scene.faces.size() == theirs.scene.faces.size());
    CHECK(own.scene.corners == theirs.scene.corners);
    // And the other way: the gallery's bush has cylinders of its own, one wide.
    const Model written = read_brno(print_brno(known), "bush-3d");
    CHECK(same_scene(scene_of(written, 4).scene, scene_of(known, 4).scene));
}

TEST_CASE(
    "the example as it is printed, with a roll before each pitch and one more between branches") {
    std::string text = example("bush.brno");
    const auto replace = [&](const std::string& old, const std::string& by) {
        for (std::size_t at = text.find(old); at != std::string::npos;
             at = text.find(old, at + by.size()))
            text.replace(at, old.size(), by);
    };
    replace("[&FLK", "[\\&FLK");
    replace("]///////[", "]////////[");
    replace("f}", "f\\}");
    const Model printed = read_brno(text, "printed.brno");
    const std::size_t lengths[] = {1, 40, 235, 841, 2758, 8629};
    for (std::uint64_t n = 0; n <= 5; ++n) CHECK(word_of(printed, n).size() == 2 * lengths[n]);
}

TEST_CASE("what a file says in the notation") {
    CHECK(lsys(example("bush.brno")) ==
          "axiom A\nA -> [&FLK!A]/////[&FLK!A]///////[&FLK!A]\nF -> S/////F\nS -> FL\nK -> Q\n"
          "L -> [^^{-f+f+f-|-f+f+f}]\ninterpret F -> !(5)F(5)\ninterpret K -> K(3)\n"
          "interpret f -> f(8)\ninterpret / -> /(23)\nangle 22\nsolid K sphere radius\n");
    // Lines of one length are steps; a line between braces only is a side of a polygon.
    CHECK(lsys(file("F = P(1)", "F", "U = 60", "F -> F+F--F+F")) ==
          "axiom F\nF -> F+F--F+F\nangle 60\n");
    CHECK(lsys(file("L = p(7), R=P(7), X", "L", "U=90", "L -> L+R+, R -> -L-R, X ->X")) ==
          "axiom L\nL -> L+R+\nR -> -L-R\nX -> X\ninterpret L -> F\ninterpret R -> F\nangle 90\n"
          "step 7\n");
    CHECK(lsys(file("f = P(2)", "{f+f+f}", "U = 120", "f -> f")) ==
          "axiom {f+f+f}\nf -> f\nangle 120\nstep 2\n");
    CHECK(lsys(file("f = P(2), X", "fX", "U = 120", "X -> {f}")) ==
          "axiom fX\nX -> {f}\ninterpret f -> F\nstep 2\n");
    // A primitive overrides what the turtle knows, and so does none.
    CHECK(lsys(file("F, f, G, a = P(1)", "FfGa", "U = 9", "a -> a")) ==
          "axiom FfGa\na -> a\ninterpret F -> ε\ninterpret f -> ε\ninterpret G -> ε\n"
          "interpret a -> F(1)\n");
    CHECK(lsys(file("F = S(3), f = C(1,2), b = P(4), X", "FfbX", "L=1", "F->")) ==
          "axiom FfbX\nF -> ε\ninterpret F -> B_1(1.5)\ninterpret f -> !(1)F(2)\n"
          "interpret b -> !(1)F(4)\nsolid B_1 sphere radius\n");
    // Each turn has an angle of its own.
    CHECK(lsys(file("A", "+&\\A^/-|[]{}!", "H = 0, U=1,L = 360", "A -> A")) ==
          "axiom +&\\A^/-|[]{}!\nA -> A\ninterpret & -> &(360)\ninterpret ^ -> ^(360)\n"
          "interpret \\ -> \\(0)\ninterpret / -> /(0)\nangle 1\n");
}

TEST_CASE("comments stand between words, and two rolls are two rolls in a word") {
    CHECK(lsys("// a\nmodules: // b\n A, // c\n B; \\\\ d\naxiom: // AB\\\\A\n;angles:H=5;\n"
               "\\\\ e\nrules: A -> //B, // f\nB \\\\ g\n -> A; // h\nEND of it") ==
          "axiom //AB\\\\A\nA -> //B\nB -> A\nangle 5\n");
    CHECK(word_of(read_brno(file("A", "A", "H = 90", "A -> //A\\\\A"), ""), 1) == "/ / A \\ \\ A ");
    CHECK(said(file("A", "A // the start\n", "H = 90", "A -> A")) ==
          "x.brno:2:13: error: expected a declared module, found 't'; in words two rolls begin no "
          "comment\n  axiom: A // the start\n              ^");
}

TEST_CASE("faults are found together, with their places") {
    CHECK(said("") ==
          "x.brno:1:1: error: expected 'modules:' at the beginning, found the end of the file");
    CHECK(said(file("A, wall, F = Q(1), A, K = S(1.5), M = C(0,1), N = P 3", "A", "L = 1",
                    "A -> A")) ==
          "x.brno:1:13: error: expected a module, one letter, found 'wall'\n"
          "  modules: A, wall, F = Q(1), A, K = S(1.5), M = C(0,1), N = P 3;\n"
          "              ^\n"
          "x.brno:1:23: error: expected C(diameter, height), P(length) or S(diameter), found 'Q'\n"
          "  modules: A, wall, F = Q(1), A, K = S(1.5), M = C(0,1), N = P 3;\n"
          "                        ^\n"
          "x.brno:1:29: error: the module A is declared twice\n"
          "  modules: A, wall, F = Q(1), A, K = S(1.5), M = C(0,1), N = P 3;\n"
          "                              ^\n"
          "x.brno:1:38: error: expected a diameter, a whole number of pixels, found '1.5'\n"
          "  modules: A, wall, F = Q(1), A, K = S(1.5), M = C(0,1), N = P 3;\n"
          "                                       ^\n"
          "x.brno:1:50: error: expected a diameter, a whole number of pixels from 1 to 1000000, "
          "found '0'\n"
          "  modules: A, wall, F = Q(1), A, K = S(1.5), M = C(0,1), N = P 3;\n"
          "                                                   ^\n"
          "x.brno:1:62: error: expected '(' behind P, found '3'\n"
          "  modules: A, wall, F = Q(1), A, K = S(1.5), M = C(0,1), N = P 3;\n"
          "                                                               ^");
    CHECK(said(file("A, B = C(1,1), K = S(2)", "A[", "L = 400, X = 1, U = 2, U = 3",
                    "A -> A]+, A -> B, C -> A(2), B -> {K+B}&")) ==
          "x.brno:3:13: error: expected a whole number of degrees from 0 to 360, found '400'\n"
          "  angles: L = 400, X = 1, U = 2, U = 3;\n"
          "              ^\n"
          "x.brno:3:18: error: expected an angle, L, U or H, found 'X'\n"
          "  angles: L = 400, X = 1, U = 2, U = 3;\n"
          "                   ^\n"
          "x.brno:3:32: error: the angle U is given twice\n"
          "  angles: L = 400, X = 1, U = 2, U = 3;\n"
          "                                 ^\n"
          "x.brno:4:18: error: the second rule for A, expected one\n"
          "  rules: A -> A]+, A -> B, C -> A(2), B -> {K+B}&;\n"
          "                   ^\n"
          "x.brno:4:26: error: expected a declared module, found 'C'\n"
          "  rules: A -> A]+, A -> B, C -> A(2), B -> {K+B}&;\n"
          "                           ^\n"
          "x.brno:4:32: error: expected a module, a symbol of the turtle, ',' or ';' in the rule "
          "for C, found '('\n"
          "  rules: A -> A]+, A -> B, C -> A(2), B -> {K+B}&;\n"
          "                                 ^");
    CHECK(said(file("A, B = C(1,1), K = S(2)", "A[[]", "U = 3",
                    "A -> A]+, A -> B, C -> AX, B -> {K+B}&/\\x")) ==
          "x.brno:4:18: error: the second rule for A, expected one\n"
          "  rules: A -> A]+, A -> B, C -> AX, B -> {K+B}&/\\x;\n"
          "                   ^\n"
          "x.brno:4:26: error: expected a declared module, found 'C'\n"
          "  rules: A -> A]+, A -> B, C -> AX, B -> {K+B}&/\\x;\n"
          "                           ^\n"
          "x.brno:4:32: error: expected a declared module, found 'X'\n"
          "  rules: A -> A]+, A -> B, C -> AX, B -> {K+B}&/\\x;\n"
          "                                 ^\n"
          "x.brno:4:48: error: expected a declared module, found 'x'\n"
          "  rules: A -> A]+, A -> B, C -> AX, B -> {K+B}&/\\x;\n"
          "                                                 ^");
    CHECK(
        said(file("A, B = C(1,1), K = S(2)", "A[[]", "U = 3", "A -> A]+, B -> {K+B}&/\\")) ==
        "x.brno:2:9: error: '[' is never closed\n"
        "  axiom: A[[];\n"
        "          ^\n"
        "x.brno:4:14: error: unmatched ']'\n"
        "  rules: A -> A]+, B -> {K+B}&/\\;\n"
        "               ^\n"
        "x.brno:4:24: error: expected turns and lines between '{' and '}', found 'K', a ball\n"
        "  rules: A -> A]+, B -> {K+B}&/\\;\n"
        "                         ^\n"
        "x.brno:4:26: error: expected turns and lines between '{' and '}', found 'B', a cylinder\n"
        "  rules: A -> A]+, B -> {K+B}&/\\;\n"
        "                           ^\n"
        "x.brno:4:28: error: expected the angle L among the angles, as '&' turns by it\n"
        "  rules: A -> A]+, B -> {K+B}&/\\;\n"
        "                             ^\n"
        "x.brno:4:29: error: expected the angle H among the angles, as '/' turns by it\n"
        "  rules: A -> A]+, B -> {K+B}&/\\;\n"
        "                              ^");
    CHECK(said("modules: A;\naxiom: A;\nangles: U = 1;\nrules: A -> A\nEND") ==
          "x.brno:5:1: error: expected ',' or ';', found 'END'\n"
          "  END\n"
          "  ^");
    CHECK(said(file("A", "A+/", "L = 1", "A -> -A-/")) ==
          "x.brno:2:9: error: expected the angle U among the angles, as '+' turns by it\n"
          "  axiom: A+/;\n"
          "          ^\n"
          "x.brno:2:10: error: expected the angle H among the angles, as '/' turns by it\n"
          "  axiom: A+/;\n"
          "           ^");
    CHECK(said("modules: A;\naxiom: A;\nangles: U = 1;\nrules: A -> A;\n") ==
          "x.brno:5:1: error: expected 'END' behind the rules, found the end of the file");
    CHECK(said("modules: A;\naxiom: A\nangles: U = 1;\nrules: A -> A;\n") ==
          "x.brno:3:1: error: expected ';' behind the axiom, found 'angles'\n"
          "  angles: U = 1;\n"
          "  ^");
    CHECK(said("modules: A;\nangles: U = 1;\nrules: A -> A;\n") ==
          "x.brno:2:1: error: expected 'axiom:' behind the modules, found 'angles'\n"
          "  angles: U = 1;\n"
          "  ^");
    CHECK(said("modules A;") ==
          "x.brno:1:9: error: expected ':' behind 'modules', found 'A'\n"
          "  modules A;\n"
          "          ^");
    CHECK(said("modules: A\xff;") ==
          "x.brno:1:11: error: expected UTF-8, found the byte 0xFF\n"
          "  modules: A�;\n"
          "            ^");
    CHECK(said("modules: \xce\xb1;") ==
          "x.brno:1:10: error: expected a module, one letter, found 'α'\n"
          "  modules: α;\n"
          "           ^\n"
          "x.brno:1:12: error: expected 'axiom:' behind the modules, found the end of the file\n"
          "  modules: α;\n"
          "             ^");
}

TEST_CASE("a faulty module is declared all the same") {
    for (const std::string primitive : {"P(8.5)", "P(0)", "C(8)", "Q(1)", "S 3"}) {
        const std::string all = said(file("F = " + primitive + ", A", "FA", "U = 90", "F -> F+F"));
        CAPTURE(all);
        CHECK(all.starts_with("x.brno:1:"));
        CHECK(all.find("x.brno:", 1) == std::string::npos);
    }
}

TEST_CASE("no angle need be there where no word turns") {
    const std::string text = file("F = P(1)", "F", "", "F -> F|F");
    CHECK(lsys(text) == "axiom F\nF -> F|F\n");
    CHECK(print_brno(read_brno(text, "")).find("angles:\n    ;\n") != std::string::npos);
    CHECK(lsys(print_brno(read_brno(text, ""))) == lsys(text));
    CHECK(said(file("F = P(1)", "F", "", "F -> F+F")) ==
          "x.brno:4:14: error: expected the angle U among the angles, as '+' turns by it\n"
          "  rules: F -> F+F;\n"
          "               ^");
}

TEST_CASE("what no file can say is named") {
    CHECK(unsaid("axiom F; b < F -> F") ==
          "x.lsys:1:10: brno cannot say the rule b < F -> F: it has a context");
    CHECK(unsaid("axiom F; F -> F; F -> FF") ==
          "x.lsys:1:18: brno cannot say the rule F -> FF: it is the second for its letter");
    CHECK(unsaid("axiom F; F -(1)-> F") ==
          "x.lsys:1:10: brno cannot say the rule F -(1)-> F: it has a probability");
    CHECK(unsaid("axiom F(1)") == "x.lsys: brno cannot say the axiom's parameters");
    CHECK(unsaid("axiom F; F -> F(2)") ==
          "x.lsys:1:10: brno cannot say the rule F -> F(2): it has parameters");
    CHECK(
        unsaid("axiom F_l") ==
        "x.lsys: brno cannot say the symbol F_l in the axiom, expected letters and +-&^\\/|[]{}!");
    CHECK(unsaid("axiom F; F -> F*F") ==
          "x.lsys: brno cannot say the symbol * in the rule F -> F*F, expected letters and "
          "+-&^\\/|[]{}!");
    CHECK(unsaid("axiom F; + -> F") ==
          "x.lsys: brno cannot say the rule + -> F: its left side is no letter");
    CHECK(unsaid("axiom F+; angle 22.5") ==
          "x.lsys: brno cannot say the angle of +, expected a whole number from 0 to 360");
    CHECK(unsaid("axiom F+; turn clockwise") == "x.lsys: brno cannot say that + turns clockwise");
    CHECK(unsaid("axiom F; start 0 0 90") ==
          "x.lsys: brno cannot say where the turtle starts, expected 'start 0 0 0'");
    CHECK(unsaid("axiom F; shrink 1/3") ==
          "x.lsys: brno cannot say that steps shrink from one generation to the next");
    CHECK(unsaid("axiom F; spin 3") ==
          "x.lsys: brno cannot say that the start turns from one generation to the next");
    CHECK(unsaid("axiom F; step 0.5") ==
          "x.lsys: brno cannot say the length of the module F, expected a whole number from 1 to "
          "1000000");
    CHECK(unsaid("axiom fF") == "x.lsys: brno cannot say f, a step that draws nothing");
    CHECK(unsaid("axiom {F}") ==
          "x.lsys: brno cannot say F between braces, where a line is a side of the polygon and "
          "nothing else");
    CHECK(unsaid("axiom A; interpret A -> FF") ==
          "x.lsys: brno cannot say the module A: expected a line, a cylinder, a ball or nothing to "
          "be seen");
    CHECK(
        unsaid("axiom A; interpret A -> A") ==
        "x.lsys:1:20: brno cannot say the rule A -> A: it goes round in circles or gives too much");
    CHECK(unsaid("axiom A; interpret A(x) -> F; interpret A -> A(2)") ==
          "x.lsys:1:20: brno cannot say the rule A(x) -> F: it has parameters");
    CHECK(unsaid("axiom A; interpret A -(1)-> F") ==
          "x.lsys:1:20: brno cannot say the rule A -(1)-> F: it is one of several interpretations");
    CHECK(unsaid("axiom AF; interpret A -> !(2)F(2)") ==
          "x.lsys: brno cannot say the width of F, a line among cylinders");
    CHECK(unsaid("axiom {A}; interpret A -> !(2)F(2)") ==
          "x.lsys: brno cannot say the cylinder A between braces, where turns and lines stand");
    CHECK(unsaid("axiom B; solid B box") ==
          "x.lsys: brno cannot say the module B: expected a line, a cylinder, a ball or nothing to "
          "be seen");
    CHECK(unsaid("axiom B; stamp B square") ==
          "x.lsys: brno cannot say the module B: expected a line, a cylinder, a ball or nothing to "
          "be seen");
    CHECK(unsaid("axiom B; surface B leaf") == "x.lsys: brno cannot say surfaces");
    CHECK(unsaid("axiom B!; narrow 0.7") == "x.lsys: brno cannot say another meaning of !");
    CHECK(unsaid("axiom B+-; interpret + -> +(30)") ==
          "x.lsys: brno cannot say that + and - turn by different angles");
    CHECK(unsaid("axiom B|; interpret | -> +(30)") ==
          "x.lsys: brno cannot say another meaning of |");
    CHECK(unsaid("axiom B; tropism 0 0 1") == "x.lsys: brno cannot say a tropism");
    CHECK(unsaid("axiom B; table a; table b") == "x.lsys: brno cannot say tables");
    CHECK(unsaid("axiom B; terminals B") == "x.lsys: brno cannot say terminals");
}

TEST_CASE("files in the form that the writer gives them") {
    CHECK(converted("title Koch curve; axiom F; F -> F+F--F+F; angle 60; colour red; generation 4",
                    "koch.lsys", "lsys", "brno", {}) ==
          "// Koch curve\n\nmodules:\n    F = P(1);\n\naxiom:\n    F;\n\nangles:\n    U = 60;\n\n"
          "rules:\n    F -> F+F--F+F;\n\nEND\n");
    CHECK(print_brno(read_lsystem("axiom ε", "")) ==
          "modules:\n    A;\n\naxiom:\n    ;\n\nangles:\n    ;\n\nrules:\n    A -> "
          "A;\n\nEND\n");
    CHECK(system_format("examples/bush.brno")->name == "brno");
}

TEST_CASE("what is read, written and read again is the same") {
    CHECK(rc::check([] {
        const std::string text = any_brno_text();
        const Model once = read_brno(text, "x.brno");
        const Model twice = read_brno(print_brno(once), "y.brno");
        RC_ASSERT(print_lsystem(once) == print_lsystem(twice));
        RC_ASSERT(once == twice);
    }));
}

TEST_CASE("a file's figure is that of its primitives, walked slowly") {
    // Modules by themselves, so that the words can be rewritten and drawn by hand.
    CHECK(rc::check([] {
        oracle::WrittenSystem system;
        system.axiom = oracle::balanced("F" + *oracle::any_word("FKbXX+-&^\\/[]", 4));
        system.successors['X'] = {oracle::balanced(*oracle::any_word("FKbX+-&^\\/[]", 5))};
        system.successors['F'] = {oracle::balanced(*oracle::any_word("FKbX+/[]", 3))};
        const std::string height = std::to_string(1 + below(5)),
                          length = std::to_string(1 + below(5)),
                          diameter = std::to_string(1 + below(5)),
                          ball = std::to_string(1 + below(5));
        const double angles[] = {static_cast<double>(below(361)), static_cast<double>(below(361)),
                                 static_cast<double>(below(361))};
        const auto whole = [](double angle) { return std::to_string(static_cast<int>(angle)); };
        const Model read = read_brno(
            file("F=c(" + diameter + "," + height + "),b=p(" + length + "),X,K=s(" + ball + ")",
                 system.axiom,
                 "L=" + whole(angles[0]) + ",U=" + whole(angles[1]) + ",H=" + whole(angles[2]),
                 "X->" + system.successors['X'][0] + ",F->" + system.successors['F'][0]),
            "x.brno");
        for (unsigned n = 0; n <= 2; ++n) {
            const std::string word = oracle::rewritten(system, n);
            std::vector<slow_walk::Module> modules;
            for (const char letter : word) {
                const std::string turns = "&^+-\\/";
                if (const std::size_t at = turns.find(letter); at != std::string::npos)
                    modules.push_back({letter, {angles[at / 2]}});
                else if (letter == '[' || letter == ']')
                    modules.push_back({letter, {}});
                else if (letter == 'K')
                    modules.push_back({letter, {std::stod(ball)}});
                if (letter == 'F' || letter == 'b') {
                    modules.push_back({'!', {letter == 'F' ? std::stod(diameter) : 1}});
                    modules.push_back({'F', {std::stod(letter == 'F' ? height : length)}});
                }
            }
            slow_walk::Walk walk;
            walk.all(modules);
            const Scene drawn = scene_of(read, n).scene;
            RC_ASSERT(drawn.rods.size() == walk.strokes.size());
            bool cylinders = word.find('F') != std::string::npos || n > 0;
            for (std::size_t i = 0; i < drawn.rods.size(); ++i) {
                const auto place = [](const slow_walk::Place& p) {
                    return Vector{static_cast<double>(p[0]), static_cast<double>(p[1]),
                                  static_cast<double>(p[2])};
                };
                RC_ASSERT(near(drawn.rods[i].from, place(walk.strokes[i].from)));
                RC_ASSERT(near(drawn.rods[i].to, place(walk.strokes[i].to)));
                if (cylinders)
                    RC_ASSERT(near(2 * drawn.rods[i].radius,
                                   static_cast<double>(walk.strokes[i].diameter)));
            }
            RC_ASSERT(drawn.solids.size() == walk.solids.size());
            for (std::size_t i = 0; i < drawn.solids.size(); ++i)
                RC_ASSERT(near(drawn.solids[i].size.x, walk.solids[i].values[0] / 2));
        }
    }));
}

TEST_CASE("systems that a file can say keep their words and their figures") {
    CHECK(rc::check([] {
        const oracle::WrittenSystem written = *oracle::any_bracketed("&/");
        Model system{oracle::lsystem_of(written), {}, {}, {}};
        std::string text = print_lsystem(system) + "interpret f -> " +
                           one_of({"ε", "F", "!(2)F(3)", "F(2)"}) + "\nangle " +
                           std::to_string(below(361)) + "\nstep " + std::to_string(1 + below(3)) +
                           "\n" +
                           one_of({"", "interpret / -> /(30)\n",
                                   "interpret X -> S_2(1.5)\nsolid S_2 sphere radius\n"});
        system = read_lsystem(text, "x.lsys");
        std::string file;
        try {
            file = print_brno(system);
        } catch (const Error& error) {
            RC_DISCARD(error.what());
        }
        const Model back = read_brno(file, "x.brno");
        for (std::uint64_t n = 0; n <= 2; ++n) {
            RC_ASSERT(word_of(back, n) == word_of(system, n));
            RC_ASSERT(same_scene(scene_of(back, n).scene, scene_of(system, n).scene));
        }
    }));
}

TEST_CASE("no file, however broken, ends in anything but a system or an error") {
    const auto survives = [](const std::string& text) {
        survive(text, "x.brno", read_brno, print_brno);
    };
    CHECK(rc::check([&] { survives(*rc::gen::arbitrary<std::string>()); }));
    CHECK(rc::check([&] {
        std::string text = any_brno_text();
        for (int i = 1 + below(3); i > 0; --i) {
            const auto at = static_cast<std::size_t>(below(static_cast<int>(text.size())));
            const std::string piece = one_of({"", ";", ",", ":", "=", "(", "[", "}", "A", "END",
                                              "rules:", "->", "9", "-1", "//", "\xc3", "é", "\n"});
            text.replace(at, static_cast<std::size_t>(below(3)), piece);
        }
        survives(text);
    }));
    const auto end = [&](const std::string& text) { CHECK(said(text).size() < 1'000'000); };
    end("modules: A" + many(", A") + ";");
    end("modules: " + many("("));
    end(file("A", many("["), "U = 1", "A -> A"));
    end(file("A", many("x{"), "U = 1", "A -> A" + many(", A -> A")));
    end(file("A", many("A\n"), "U = 1", "A -> " + many("//")));
}
