#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <sstream>

#include "exchange/any_brno.hpp"
#include "exchange/compared.hpp"
#include "exchange/detail/formats.hpp"
#include "exchange/exchange.hpp"
#include "exchange/inputs.hpp"
#include "exchange/netlogo_model.hpp"
#include "model/model.hpp"
#include "notation/notation.hpp"
#include "places.hpp"
#include "turtle/turtle.hpp"

using namespace algae;
using namespace algae::exchange_tests;

namespace {

/// The system without what a procedure does not say.
std::string bare(Model system) {
    system.title = system.source = "";
    system.identifiers.clear();
    system.expectations.clear();
    system.drawing.generations.reset();
    return print_lsystem(system);
}

Model read(const std::string& text) { return read_netlogo(text, "x.netlogo"); }
std::string said(const std::string& text) {
    return refusal([&] { read(text); });
}
std::string unsaid(const std::string& text) {
    return refusal([&] { print_netlogo(read_lsystem(text, "x.lsys")); });
}
const std::string numbers = "set d 1 set delta 90 set k-shorten 1\n";
/// The text without the lines that `numbers` makes.
std::string lsys(const std::string& text) {
    std::string out = print_lsystem(read(text + '\n' + numbers));
    for (const char* line :
         {"angle 90\n", "step 1\n", "shrink 1\n", "start 0 0 90\n", "colour along\n"}) {
        const std::size_t at = out.find(line);
        REQUIRE(at != std::string::npos);
        out.erase(at, std::string(line).size());
    }
    return out;
}

const std::string koch_island =
    "1 to setup-koch-island\n2 add-rule \"F\" \"F-F+F+FF-F-F+F\" \"F\"\n3 set chain \"F-F-F-F\"\n"
    "4 set d 16\n5 set delta 90\n6 set x0 -8\n7 set y0 8\n8 set delta-0 90\n9 set k-shorten 0.25\n"
    "10 end\n";
const std::string simple_tree =
    "add-rule \"F\" \"F[+F]F[-F]\" \"F\"\nset chain \"F\"\nset d 16\nset delta 25\nset x0 0\n"
    "set y0 -14\nset delta-0 0\nset k-shorten 0.5\n";
const std::string hilbert =
    "to setup-hilbert-curve\n  add-rule \"A\" \"+BX-AXA-XB+\" \"A\"\n"
    "  add-rule \"B\" \"-AX+BXB+XA-\" \"B\"\n  add-rule \"X\" \"X\" \"F\" ; the edge\n"
    "  set chain \"A\" set d 24 set delta 90\n  set x0 -12 set y0 -12 set delta-0 90\n"
    "  set k-shorten 0.5\nend\n";

}  // namespace

TEST_CASE("the model's three systems are those of the gallery") {
    const std::pair<std::string, std::string> all[] = {
        {koch_island, "koch-island-002"}, {simple_tree, "simple-tree"}, {hilbert, "hilbert-coded"}};
    for (const auto& [text, name] : all) {
        CAPTURE(name);
        const Model own = read(text), known = of_gallery(name);
        CHECK(bare(own) == bare(known));
        for (std::uint64_t n = 0; n <= 4; ++n) {
            CHECK(word_of(own, n) == word_of(known, n));
            CHECK(same_scene(scene_of(own, n).scene, scene_of(known, n).scene));
        }
    }
    std::ifstream file(source_folder() + "/examples/koch-island.netlogo");
    std::ostringstream text;
    text << file.rdbuf();
    CHECK(bare(read(text.str())) == bare(of_gallery("koch-island-002")));
}

TEST_CASE("the exercises that have a form there are those of the gallery") {
    const auto figure_of = [](const std::string& text, const std::string& name, std::uint64_t n) {
        return same_scene(scene_of(read(text), n).scene, scene_of(of_gallery(name), n).scene);
    };
    CHECK(
        figure_of("add-rule \"L\" \"L+R+\" \"F\" add-rule \"R\" \"-L-R\" \"F\" set chain \"L\"\n"
                  "set d 1 set delta 90 set delta-0 90 set k-shorten 1 / sqrt 2 set d-delta 45",
                  "dragon-002", 7));
    CHECK(
        figure_of("add-rule \"x\" \"-*Fx\" \"\" set chain \"Fx\" set d 1 set delta 92\n"
                  "set k-shorten 1 set k 0.98",
                  "spiral", 30));
    CHECK(figure_of(
        "add-rule \"x\" \"S[ff++f-*x][ff--f+*x]\" \"\" set chain \"x\" set d 1 set delta 45\n"
        "set k-shorten 1 set k 1 / sqrt 2",
        "pythagoras-tree", 4));
    CHECK(figure_of(
        "add-rule \"x\" \"*[--Fx]+FFx\" \"\" add-rule \"x\" \"*[++Fx]-FFx\" \"\" set chain \"Fx\"\n"
        "set d 1 set delta 18 set k-shorten 1 set k 0.8",
        "stochastic-trees", 5));
    for (const char* name :
         {"dragon-002", "spiral", "pythagoras-tree", "stochastic-trees", "penrose", "koch"}) {
        CAPTURE(name);
        const Model known = of_gallery(name);
        CHECK(figure_of(print_netlogo(known), name, 4));
        CHECK(word_of(read(print_netlogo(known)), 4) == word_of(known, 4));
    }
}

TEST_CASE("letters do what their commands say, and nothing else") {
    CHECK(lsys("set chain \"F\"") == "axiom F\n");
    CHECK(lsys("set chain \"\"") == "axiom ε\n");
    CHECK(lsys("add-rule \"F\" \"\" \"F\" set chain \"FG|{}.'%&\"") ==
          "axiom FG|{}.'%&\nF -> ε\ninterpret G -> ε\ninterpret | -> ε\ninterpret { -> ε\n"
          "interpret } -> ε\ninterpret . -> ε\ninterpret ' -> ε\ninterpret % -> ε\ninterpret & -> "
          "ε\n");
    CHECK(lsys("add-rule \"F\" \"F_l\" \"\" set chain \"F_l\"") ==
          "axiom F _l\nF -> F _l\ninterpret F -> ε\n");
    CHECK(lsys("add-rule \"a\" \"\\\\\\\"\" \"F\" set chain \"a*!\"") ==
          "axiom a*!\na -> \\\"\ninterpret a -> F\ninterpret \\ -> ε\n");
    // Letters that change places.
    CHECK(lsys("add-rule \"F\" \"f\" \"f\" add-rule \"f\" \"F\" \"F\" set chain \"F\"") ==
          "axiom F\nF -> f\nf -> F\ninterpret F -> f_1\ninterpret f -> F_1\n");
    CHECK(lsys("add-rule \"+\" \"+\" \"-\" add-rule \"-\" \"-\" \"+\" set chain \"+-\"") ==
          "axiom +-\n+ -> +\n- -> -\ninterpret + -> -(90)\ninterpret - -> +(90)\n");
    // Stamps.
    CHECK(lsys("add-rule \"T\" \"TS\" \"S\" set chain \"T\"") ==
          "axiom T\nT -> TS\ninterpret T -> S_1\nstamp S_1 square\nstamp S square\n");
    CHECK(lsys("add-rule \"S\" \"S\" \"\" set chain \"S\"") == "axiom S\nS -> S\n");
    // Several rules: as often as they stand there; their commands are chosen alike.
    CHECK(lsys("add-rule \"F\" \"FF\" \"F\" add-rule \"F\" \"G\" \"F\" add-rule \"F\" \"FF\" \"F\" "
               "set chain \"F\"") == "axiom F\nF -(2/3)-> FF\nF -(1/3)-> G\ninterpret G -> ε\n");
    CHECK(lsys("add-rule \"F\" \"F\" \"F\" add-rule \"F\" \"F\" \"f\" set chain \"F\"") ==
          "axiom F\nF -> F\ninterpret F -(0.5)-> F_1\ninterpret F -(0.5)-> f\n");
    CHECK(lsys("add-rule \"-\" \"-\" \"-\" add-rule \"-\" \"F\" \"-\" set chain \"-\"") ==
          "axiom -\n- -(0.5)-> -\n- -(0.5)-> F\n");
    CHECK(lsys("SET CHAIN \"F\"") == "axiom F\n");
}

TEST_CASE("commands that say nothing of the system are passed over, others named whole") {
    CHECK(read("to setup-koch-island\n  clear-all\n  CT cd\n" +
               koch_island.substr(23, koch_island.size() - 30) + "  reset-ticks\nend\n") ==
          read(koch_island));
    CHECK(said("to setup\n  clear-al\n  create-turtles 1 [ hide-turtle ]\n  set chain F-F\nend\n")
              .starts_with(
                  "x.netlogo:2:3: error: expected 'add-rule' or 'set', found 'clear-al'\n    "
                  "clear-al\n    ^\n"
                  "x.netlogo:3:3: error: expected 'add-rule' or 'set', found 'create-turtles'\n"
                  "    create-turtles 1 [ hide-turtle ]\n    ^\n"
                  "x.netlogo:4:13: error: expected a word in quotation marks behind 'set chain', "
                  "found 'F-F'\n"));
}

TEST_CASE("numbers are those of NetLogo") {
    const auto step = [](const std::string& number) {
        const std::string text =
            print_lsystem(read("set chain \"F\" set delta 1 set k-shorten 1\nset d " + number));
        const std::size_t at = text.find("step ");
        return text.substr(at + 5, text.find('\n', at) - at - 5);
    };
    CHECK(step("-8") == "-8");
    CHECK(step(".5") == "0.5");
    CHECK(step("2.") == "2");
    CHECK(step("1e-3") == "0.001");
    CHECK(step("1 / sqrt 2") == "1/sqrt(2)");
    CHECK(step("sqrt 2 * 3") == "sqrt(2)*3");
    CHECK(step("sqrt (2 * 3)") == "sqrt(2*3)");
    CHECK(step("2 ^ 3 ^ 2") == "(2^3)^2");
    CHECK(step("(- 3) - -3 * (1 + 1)") == "-3--3*(1+1)");
    CHECK(step("7 - 2 - 1") == "7-2-1");
    CHECK(step("exp ln (abs -2)") == "exp(log(abs(-2)))");
    for (const char* text :
         {"-8", "0.5", "1/sqrt(2)", "1/3", "(2^3)^2", "2^3^2", "-(1+2)", "sqrt(sqrt(2))", "360/7",
          "max(1,2)", "(1 < 2)", "2*-3", "cos(60)", "1e-7"}) {
        CAPTURE(text);
        const Model system = read_lsystem("axiom F; step " + std::string(text), "");
        CHECK(read(print_netlogo(system)).drawing.step->value == system.drawing.step->value);
    }
}

TEST_CASE("faults of a procedure are found together, with their places") {
    CHECK(said("") ==
          "x.netlogo:1:1: error: expected 'set' for chain, d, delta, k-shorten, found the end of "
          "the file");
    CHECK(said("set d 16 set y0") ==
          "x.netlogo:1:16: error: expected a number, found the end of the file\n"
          "  set d 16 set y0\n"
          "                 ^");
    CHECK(said("to setup-a\nset d 1\nend\nto setup-b\nset d 2\nend\nto setup-c end") ==
          "x.netlogo:4:1: error: expected one procedure, found setup-a, setup-b and setup-c; put "
          "the one you want into a file of its own\n"
          "  to setup-b\n"
          "  ^");
    CHECK(
        said("to setup-a\nset d 1\n" + numbers) ==
        "x.netlogo:4:1: error: expected 'end' of the procedure setup-a, found the end of the file");
    CHECK(said("set d 1\nend") ==
          "x.netlogo:2:1: error: 'end' without 'to' before it\n"
          "  end\n"
          "  ^");
    CHECK(said("to a\nend\nset d 1") ==
          "x.netlogo:3:1: error: expected 'to' or the end of the file behind 'end', found 'set'\n"
          "  set d 1\n"
          "  ^");
    CHECK(said("to a\nto b\nend") ==
          "x.netlogo:2:1: error: expected 'end' of the procedure a before 'to'\n"
          "  to b\n"
          "  ^");
    CHECK(
        said("ask patches [ set pcolor white ]\nadd-rule F \"F\" \"F\"\nadd-rule \"FF\" \"F\" "
             "\"F\"\n"
             "add-rule \"F\" \"F(x)\" \"F\"\nadd-rule \"F\" \"F]\" \"F\"\nadd-rule \"F\" \"F\nset "
             "k-shrten 2\n"
             "set chain F\nset d 0\nset delta 1 / 0\nset x0 sqrt -1\nset y0 1e10\nset k 3 * 4)") ==
        "x.netlogo:1:1: error: expected 'add-rule' or 'set', found 'ask'\n"
        "  ask patches [ set pcolor white ]\n"
        "  ^\n"
        "x.netlogo:2:10: error: expected a letter in quotation marks behind 'add-rule', found 'F'\n"
        "  add-rule F \"F\" \"F\"\n"
        "           ^\n"
        "x.netlogo:3:10: error: expected one letter, found \"FF\"\n"
        "  add-rule \"FF\" \"F\" \"F\"\n"
        "           ^\n"
        "x.netlogo:4:16: error: expected a symbol of the notation, found '('\n"
        "  add-rule \"F\" \"F(x)\" \"F\"\n"
        "                 ^\n"
        "x.netlogo:5:16: error: unmatched ']'\n"
        "  add-rule \"F\" \"F]\" \"F\"\n"
        "                 ^\n"
        "x.netlogo:6:14: error: expected '\"' at the end of the string, found the end of the line\n"
        "  add-rule \"F\" \"F\n"
        "               ^\n"
        "x.netlogo:7:5: error: expected one of chain, d, delta, x0, y0, delta-0, k-shorten, "
        "d-delta, k, found 'k-shrten'; did you mean 'k-shorten'?\n"
        "  set k-shrten 2\n"
        "      ^\n"
        "x.netlogo:8:11: error: expected a word in quotation marks behind 'set chain', found 'F'\n"
        "  set chain F\n"
        "            ^\n"
        "x.netlogo:9:7: error: expected a number other than 0 for d\n"
        "  set d 0\n"
        "        ^\n"
        "x.netlogo:10:11: error: division by 0 in '1/0'\n"
        "  set delta 1 / 0\n"
        "            ^\n"
        "x.netlogo:11:8: error: the square root of a negative number in 'sqrt(-1)'\n"
        "  set x0 sqrt -1\n"
        "         ^\n"
        "x.netlogo:12:8: error: expected a number from -10^9 to 10^9\n"
        "  set y0 1e10\n"
        "         ^\n"
        "x.netlogo:13:12: error: expected 'add-rule' or 'set', found ')'\n"
        "  set k 3 * 4)\n"
        "             ^");
    CHECK(
        said("add-rule \"[\" \"[]\" \"\" add-rule \"A\" \"A\" \"]\" set chain \"A\"\n" + numbers) ==
        "x.netlogo:1:19: error: expected '[' and ']' to stand for themselves, found the command "
        "\"\" of '['\n"
        "  add-rule \"[\" \"[]\" \"\" add-rule \"A\" \"A\" \"]\" set chain \"A\"\n"
        "                    ^\n"
        "x.netlogo:1:39: error: expected '[' and ']' to stand for themselves, found the command "
        "\"]\" of 'A'\n"
        "  add-rule \"[\" \"[]\" \"\" add-rule \"A\" \"A\" \"]\" set chain \"A\"\n"
        "                                        ^");
    CHECK(said("set chain \"A\\n\"\nset chain \"A B\"\nset chain \"\xf0\x9f\x98\x80\"") ==
          "x.netlogo:1:13: error: expected '\\\\' or '\\\"' in a string, found '\\n'\n"
          "  set chain \"A\\n\"\n"
          "              ^\n"
          "x.netlogo:2:13: error: expected a symbol of the notation, found ' '\n"
          "  set chain \"A B\"\n"
          "              ^\n"
          "x.netlogo:3:12: error: expected a character of NetLogo, found '😀', which is two there\n"
          "  set chain \"😀\"\n"
          "             ^");
    CHECK(said("set d (1 + 2") ==
          "x.netlogo:1:13: error: expected ')' or an operator between blanks, found the end of the "
          "file\n"
          "  set d (1 + 2\n"
          "              ^");
    CHECK(said("set d 1 + ") ==
          "x.netlogo:1:11: error: expected a number, found the end of the file\n"
          "  set d 1 + \n"
          "            ^");
    CHECK(said("set d 2*3") ==
          "x.netlogo:1:8: error: expected 'add-rule' or 'set', found '*'\n"
          "  set d 2*3\n"
          "         ^");
    CHECK(said("set d 1e99999") ==
          "x.netlogo:1:7: error: expected an exponent of at most 10000, found 99999\n"
          "  set d 1e99999\n"
          "        ^");
}

TEST_CASE("what no procedure can say is named") {
    CHECK(unsaid("axiom F; b < F -> F") ==
          "x.lsys:1:10: netlogo cannot say the rule b < F -> F: it has a context");
    CHECK(unsaid("axiom F(2)") == "x.lsys: netlogo cannot say the axiom's parameters");
    CHECK(unsaid("axiom F_l") ==
          "x.lsys: netlogo cannot say the symbol F_l in the axiom, expected one character");
    CHECK(unsaid("axiom \xf0\x9f\x98\x80") ==
          "x.lsys: netlogo cannot say the symbol 😀 in the axiom, expected one character");
    CHECK(unsaid("axiom F; F -(0.001)-> F; F -(0.999)-> FF") ==
          "x.lsys: netlogo cannot say the probabilities of F: their common denominator is 1000, "
          "expected at most 100");
    CHECK(unsaid("axiom F; interpret F -(0.5)-> F; interpret F -(0.5)-> f") ==
          "x.lsys:1:20: netlogo cannot say the rule F -(0.5)-> F: it is one of several "
          "interpretations");
    CHECK(unsaid("axiom A; interpret A -> FF") ==
          "x.lsys: netlogo cannot say the letter A, which stands for several commands");
    CHECK(unsaid("axiom A; interpret A -> F(2)") ==
          "x.lsys: netlogo cannot say the symbol F with a parameter, for which A stands: its "
          "commands are F f + - [ ] *, and S for a square");
    CHECK(unsaid("axiom A; interpret A -> +(30)") ==
          "x.lsys: netlogo cannot say the symbol + with a parameter, for which A stands: its "
          "commands are F f + - [ ] *, and S for a square");
    CHECK(unsaid("axiom A; interpret A -> *(2)") ==
          "x.lsys: netlogo cannot say the symbol * with a parameter, for which A stands: its "
          "commands are F f + - [ ] *, and S for a square");
    CHECK(unsaid("axiom A; interpret A -> [F]") ==
          "x.lsys: netlogo cannot say the symbol [, for which A stands: its commands are F f + - [ "
          "] *, and S for a square");
    CHECK(unsaid("axiom A|") ==
          "x.lsys: netlogo cannot say the symbol |: its commands are F f + - [ ] *, and S for a "
          "square");
    CHECK(unsaid("axiom {F}") ==
          "x.lsys: netlogo cannot say the symbol {: its commands are F f + - [ ] *, and S for a "
          "square");
    CHECK(unsaid("axiom F&F") ==
          "x.lsys: netlogo cannot say the symbol &: its commands are F f + - [ ] *, and S for a "
          "square");
    CHECK(unsaid("axiom F!F; narrow 0.5") ==
          "x.lsys: netlogo cannot say the symbol !: its commands are F f + - [ ] *, and S for a "
          "square");
    CHECK(unsaid("axiom A; stamp A circle") ==
          "x.lsys: netlogo cannot say the symbol A: its commands are F f + - [ ] *, and S for a "
          "square");
    CHECK(unsaid("axiom A; solid A box") ==
          "x.lsys: netlogo cannot say the symbol A: its commands are F f + - [ ] *, and S for a "
          "square");
    CHECK(unsaid("axiom A; system leaf { axiom F }") ==
          "x.lsys: netlogo cannot say systems within a system");
}

TEST_CASE("a procedure in the form that the writer gives it") {
    CHECK(converted("title Trees \"of\" chance; axiom X; X -(1/3)-> F[+X]; X -(2/3)-> \\X; angle "
                    "22.5; start 0 -1 90\n"
                    "interpret \\ -> ε; interpret G -> F; shrink 1/2; turn clockwise; colour red; "
                    "width 2; seed 4",
                    "x.lsys", "lsys", "netlogo", {}) ==
          "; Trees \"of\" chance\n"
          "add-rule \"X\" \"F[+X]\" \"X\"\n"
          "add-rule \"X\" \"\\\\X\" \"X\"\n"
          "add-rule \"X\" \"\\\\X\" \"X\"\n"
          "set chain \"X\"\n"
          "set d 1\n"
          "set delta -22.5\n"
          "set x0 0\n"
          "set y0 -1\n"
          "set delta-0 0\n"
          "set k-shorten 1 / 2\n"
          "");
    CHECK(print_netlogo(
              read_lsystem("axiom XY; interpret Y -> f; spin 10; scale 2; stamp X square", "")) ==
          "add-rule \"X\" \"X\" \"S\"\n"
          "add-rule \"Y\" \"Y\" \"f\"\n"
          "set chain \"XY\"\n"
          "set d 1\n"
          "set delta 90\n"
          "set x0 0\n"
          "set y0 0\n"
          "set delta-0 90\n"
          "set k-shorten 1\n"
          "set d-delta -10\n"
          "set k 2\n"
          "");
    CHECK(print_netlogo(
              read_lsystem("axiom F; F -> F; F -> FF; step -2; start 1/3 sqrt(2) 30", "")) ==
          "; several rules for a letter: the model picks one at random\n"
          "add-rule \"F\" \"F\" \"F\"\n"
          "add-rule \"F\" \"FF\" \"F\"\n"
          "set chain \"F\"\n"
          "set d -2\n"
          "set delta 90\n"
          "set x0 1 / 3\n"
          "set y0 sqrt 2\n"
          "set delta-0 60\n"
          "set k-shorten 1\n"
          "");
}

TEST_CASE("what is read, written and read again is the same") {
    const auto any_text = [] {
        std::string out = one_of({"", "1 ", "; F\n"});
        const bool procedure = below(2) == 0;
        if (procedure) out += "to setup-x\n";
        const std::string letters = "FFfXYSG+-*|a'";
        for (int i = below(3); i > 0; --i) out += one_of({"\n", "\n3 "});
        for (int i = below(6); i > 0; --i)
            out += "add-rule \"" + one_of({"F", "X", "Y", "S", "+", "-", "f", "G", "*", "\\\\"}) +
                   "\" \"" + oracle::balanced(*oracle::any_word(letters + "[]", 5)) + "\" \"" +
                   one_of({"F", "F", "f", "", "X", "S", "+", "-", "*"}) + "\"" +
                   one_of({"\n", " ", " ; note\n"});
        out += "set chain \"" + oracle::balanced(*oracle::any_word(letters + "[]", 5)) + "\"\n";
        out += "set d " + one_of({"16", "-0.5", "1 / sqrt 2", "2 ^ 0.5"}) + "\nset delta " +
               one_of({"90", "-30", "360 / 7"}) + "\n";
        out += "set k-shorten " + one_of({"0.25", "1", "1 / 3"}) + "\n";
        if (below(2)) out += "set x0 -8\nset y0 8.5\n";
        if (below(2))
            out += "set delta-0 " + one_of({"90", "0", "-10", "sqrt 2", "90 - sqrt 2"}) + "\n";
        if (below(2)) out += "set d-delta " + one_of({"45", "-1", "sqrt 3", "(- sqrt 3)"}) + "\n";
        if (below(2)) out += "set k " + one_of({"0.98", "1 / sqrt 2"}) + "\n";
        return out + (procedure ? "end\n" : "");
    };
    CHECK(rc::check([&] {
        const std::string text = any_text();
        const Model once = read(text);
        std::string written;
        try {
            written = print_netlogo(once);
        } catch (const Error& error) {
            // Two commands for one letter have probabilities.
            RC_ASSERT(std::string(error.what()).find("one of several interpretations") !=
                      std::string::npos);
            return;
        }
        const Model twice = read(written);
        RC_LOG() << written;
        for (std::uint64_t n = 0; n <= 2; ++n) {
            RC_ASSERT(word_of(twice, n) == word_of(once, n));
            RC_ASSERT(same_scene(scene_of(twice, n).scene, scene_of(once, n).scene));
        }
        const Model thrice = read(print_netlogo(twice));
        RC_ASSERT(print_lsystem(thrice) == print_lsystem(twice));
    }));
}

TEST_CASE("a procedure's figure is that of the model, run slowly") {
    CHECK(rc::check([] {
        const std::string letters = "FFfXYS+-*G|[]";
        NetlogoModel model;
        std::string text;
        for (const char letter : std::string("FXY"))
            if (below(4) > 0) {
                const std::string successor = oracle::balanced(*oracle::any_word(letters, 5));
                const std::string command =
                    one_of({"F", "f", "", "+", "-", "X", "S", "*", std::string(1, letter)});
                model.rules.push_back({letter, successor, command});
                text += "add-rule \"" + std::string(1, letter) + "\" \"" + successor + "\" \"" +
                        command + "\"\n";
            }
        model.chain = oracle::balanced(*oracle::any_word(letters, 5));
        text += "set chain \"" + model.chain + "\"\n";
        const auto set = [&](const char* name, long double& number, int least, int bound,
                             int parts) {
            const int value = least + below(bound);
            number = static_cast<long double>(value) / parts;
            text += "set " + std::string(name) + ' ' + std::to_string(value) + " / " +
                    std::to_string(parts) + "\n";
        };
        set("d", model.d, 1, 5, 2);
        set("delta", model.delta, -90, 360, 1);
        set("k-shorten", model.k_shorten, 1, 4, 4);
        if (below(2)) set("x0", model.x0, -8, 16, 1);
        if (below(2)) set("y0", model.y0, -8, 16, 1);
        if (below(2)) set("delta-0", model.delta_0, -90, 360, 1);
        if (below(2)) set("d-delta", model.d_delta, -90, 180, 1);
        if ((model.has_k = below(2))) set("k", model.k, 1, 9, 8);
        const Model system = read(text);
        for (std::uint64_t n = 0; n <= 2; ++n) {
            if (n > 0) model.restart();
            model.draw();
            const Scene drawn = scene_of(system, n).scene;
            RC_ASSERT(drawn.rods.size() == model.lines.size());
            for (std::size_t i = 0; i < drawn.rods.size(); ++i) {
                const NetlogoModel::Line& line = model.lines[i];
                RC_ASSERT(near(drawn.rods[i].from,
                               {static_cast<double>(line.x0), static_cast<double>(line.y0), 0}));
                RC_ASSERT(near(drawn.rods[i].to,
                               {static_cast<double>(line.x1), static_cast<double>(line.y1), 0}));
            }
            RC_ASSERT(drawn.faces.size() == model.stamps.size());
            for (std::size_t i = 0; i < drawn.faces.size(); ++i) {
                const auto corners = drawn.corners_of(drawn.faces[i]);
                Vector middle;
                for (const Vector& corner : corners) middle = middle + 0.25 * corner;
                RC_ASSERT(near(middle, {static_cast<double>(model.stamps[i].x),
                                        static_cast<double>(model.stamps[i].y), 0}));
            }
        }
    }));
}

TEST_CASE("systems that a procedure can say keep their words and their figures") {
    CHECK(rc::check([] {
        const oracle::WrittenSystem written = *oracle::any_bracketed("*");
        std::string text = print_lsystem({oracle::lsystem_of(written), {}, {}, {}}) +
                           "interpret | -> " + one_of({"ε", "F", "f", "+"}) + "\n" +
                           one_of({"", "interpret X -> G\n", "stamp X square\n",
                                   "interpret X -> Y\nstamp Y square\n"}) +
                           one_of({"", "turn clockwise\n"}) + one_of({"", "scale 0.5\n"}) +
                           one_of({"", "shrink 1/3\n", "spin 7\n"}) +
                           one_of({"", "start 1 -2 30\n"}) + "angle " + std::to_string(below(181)) +
                           "\nstep " + one_of({"2", "sqrt(2)", "1/7"}) + "\n";
        const Model system = read_lsystem(text, "x.lsys");
        const Model back = read(print_netlogo(system));
        for (std::uint64_t n = 0; n <= 2; ++n) {
            RC_ASSERT(word_of(back, n) == word_of(system, n));
            RC_ASSERT(same_scene(scene_of(back, n).scene, scene_of(system, n).scene));
        }
    }));
}

TEST_CASE("no text, however broken, ends in anything but a system or an error") {
    const auto survives = [](const std::string& text) {
        try {
            read(text);
        } catch (const Diagnostics& error) {
            for (const Diagnostic& finding : error.findings()) {
                RC_ASSERT(finding.place.file == "x.netlogo");
                // Nothing is left for the notation to find.
                RC_ASSERT(finding.line.find("->") == std::string::npos ||
                          text.find("->") != std::string::npos ||
                          finding.line.find("add-rule") != std::string::npos ||
                          finding.line.find("chain") != std::string::npos);
            }
        }
    };
    CHECK(rc::check([&] { survives(*rc::gen::arbitrary<std::string>()); }));
    CHECK(rc::check([&] {
        std::string text = one_of({koch_island, simple_tree, hilbert});
        for (int i = 1 + below(4); i > 0; --i) {
            const auto at = static_cast<std::size_t>(below(static_cast<int>(text.size())));
            text.replace(at, static_cast<std::size_t>(below(3)),
                         one_of({"",      "\"",
                                 "\\",    "[",
                                 "]",     "(",
                                 "- ",    "to a\n",
                                 "end ",  "set k 0.5\n",
                                 "sqrt ", " / ",
                                 "9",     "\n7 ",
                                 "é",     "ε",
                                 "\xff",  "add-rule \"F\" \"f_1\" \"*\"\n",
                                 "_",     "'",
                                 "?",     ";"}));
        }
        survives(text);
    }));
    CHECK(rc::check([&] {
        // Any characters as symbols.
        std::string word;
        for (int i = below(6); i > 0; --i)
            word += one_of({"_", "F", "1", "-", ">", "'", "`", "\\\\", "\\\"", "é", "~", "@", "$",
                            "t", "∧", "−", "ε", "?", "E"});
        survives("add-rule \"" + one_of({"_", "F", "'", "-", "t", "é", "1", "\\\""}) + "\" \"" +
                 word + "\" \"" + word + "\" set chain \"" + word + "\"\n" + numbers);
    }));
    const auto end = [&](const std::string& text) {
        CHECK(refusal([&] { read(text); }).size() < 10'000);
    };
    end("set d " + many("("));
    end("set d " + many("1 + "));
    end("set d " + many("sqrt "));
    end("set d " + many("9"));
    end(many("set d 1\n"));
    end(many("add-rule \"F\" \"F\" \"F\"\n"));
    end(many("to a\n"));
    end("set chain \"" + many("[") + "\"");
    end("set chain \"" + many("F"));
    end(many("x\n"));
}
