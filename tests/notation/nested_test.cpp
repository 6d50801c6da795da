#include <doctest/doctest.h>

#include "model/model.hpp"
#include "notation/notation.hpp"
#include "said.hpp"
#include "system/system.hpp"

using namespace algae;

namespace {
const std::string leaf = "system leaf { axiom x; x -> F[+x]x }\n";
}

TEST_CASE("systems within are printed each in a block of its own") {
    CHECK(format_lsystem("axiom A(leaf(2),\"F F\")<leaf(1)>\nlet k=2\n" + leaf +
                             "B(w) -> w< w >B(w) < (length(w) > 1) >",
                         "x.lsys") ==
          "let k = 2\nsystem leaf {\n    axiom x\n    x -> F[+x]x\n}\naxiom "
          "A(leaf(2),\"FF\")<leaf(1)>\nB(w) -> w<w>B(w)<(length(w) > 1)>\n");
}

TEST_CASE("comments stay with the statements of systems within") {
    const std::string text =
        "# top\nsystem leaf {  # of the branch\n    # its seed\n    axiom x\n    x -> F[+x]x  # "
        "grows } {\n"
        "    # last\n} # behind\naxiom <leaf(2)>\n";
    CHECK(format_lsystem(text, "x.lsys") ==
          "# top\nsystem leaf {\n    # of the branch\n    # its seed\n    axiom x\n    x -> F[+x]x "
          "# grows } {\n"
          "    # last\n} # behind\naxiom <leaf(2)>\n");
    CHECK(format_lsystem(format_lsystem(text, "x.lsys"), "x.lsys") ==
          format_lsystem(text, "x.lsys"));
}

TEST_CASE("braces of polygons stay symbols") {
    const Model system =
        read_lsystem("system p { axiom {.F.}; F -> {F} }\naxiom {<p(1)>}\ns -> F", "x.lsys");
    CHECK(system.inner.at(0).system.rules.size() == 1);
    CHECK(print_lsystem(system).find("axiom {<p(1)>}") != std::string::npos);
}

TEST_CASE("a word in quotes reads back as itself") {
    Alphabet alphabet;
    const ModuleWord word = read_word("B(\"F[+A(1,\"G\")]\", 2) C(\"\")\"", alphabet);
    CHECK(word.letters.size() == 3);
    CHECK(print_word(alphabet, word) == "B(\"F[+A(1,\"G\")]\",2)C(\"\")\"");
    CHECK(print_word(alphabet, read_word(print_word(alphabet, word), alphabet)) ==
          print_word(alphabet, word));
}

TEST_CASE("what is wrong with a system within") {
    CHECK(findings("system leaf { axiom x\naxiom a")
              .starts_with("x.lsys:1:13: error: '{' is never closed"));
    CHECK(findings("system leaf\naxiom a")
              .starts_with(
                  "x.lsys:1:8: error: expected a name and '{' after 'system', found 'leaf'"));
    CHECK(findings(leaf + leaf + "axiom a")
              .starts_with("x.lsys:2:8: error: the system 'leaf' is given twice"));
    CHECK(findings("system sin { axiom x }\naxiom a")
              .starts_with(
                  "x.lsys:1:8: error: expected a name for the system, found the function 'sin'"));
    CHECK(findings("system leaf { x -> y }\naxiom a")
              .starts_with("x.lsys:1:22: error: expected an axiom in the system, found none"));
    CHECK(findings("system leaf { axiom x; angle 30 }\naxiom a")
              .starts_with("x.lsys:1:24: error: expected 'axiom', 'ignore' or a rule in a system "
                           "within another, found 'angle'"));
    CHECK(findings("system leaf { axiom x; x -(1/2)-> y; x -(1/2)-> z }\naxiom a")
              .starts_with("x.lsys:1:24: error: expected a rule without probability, as the system "
                           "'leaf' has one word in "
                           "each generation"));
    CHECK(findings("system leaf { axiom x; x -> I(y) }\naxiom a")
              .starts_with("x.lsys:1:24: error: expected a rule that makes a word in the system "
                           "'leaf', found a shape rule"));
    CHECK(findings(leaf + "axiom B(laef(2))")
              .starts_with("x.lsys:2:9: error: expected a function or a system, found 'laef'; did "
                           "you mean 'leaf'?"));
    CHECK(findings(leaf + "axiom B(leaf(2,3))")
              .starts_with("x.lsys:2:17: error: expected 1 argument of leaf, found 2"));
    CHECK(findings(leaf + "axiom B(leaf(y))")
              .starts_with("x.lsys:2:14: error: expected a number or a constant, found 'y'"));
    CHECK(findings("axiom B\nB -> <w>")
              .starts_with("x.lsys:2:7: error: expected a number or a constant, found 'w'"));
    CHECK(findings("axiom B\nB -> F<w").starts_with("x.lsys:2:7: error: '<' is never closed"));
    CHECK(findings("axiom B(\"F").starts_with("x.lsys:1:9: error: '\"' is never closed"));
    CHECK(findings("axiom B(\"F<G>\")")
              .starts_with("x.lsys:1:11: error: expected a symbol, found '<'"));
    CHECK(findings(leaf + "axiom B(\"A(leaf(1))\")")
              .starts_with(
                  "x.lsys:2:12: error: expected a number or a word in quotes, found 'leaf(1)'"));
    CHECK(findings(leaf + "axiom F\"")
              .starts_with("x.lsys:1:1: error: expected no symbol with '\"' in a system with words "
                           "in quotes, found '\"'"));
    CHECK(findings("axiom F\"") == "");
    CHECK(findings(leaf + "let c = leaf(2)\naxiom F").find("expected a function, found 'leaf'") !=
          std::string::npos);
    CHECK(findings("let c = 3; axiom F\nF < c > F -> <3 >").find("error") == std::string::npos);
}

TEST_CASE("views that need words of letters refuse them") {
    const Model system = read_lsystem(leaf + "axiom F; F -> <leaf(1)>", "x.lsys");
    CHECK(class_of(system).name() == "parametric D0L with systems within");
    CHECK(as_d0l(system).reason() == "not a D0L system: there are systems within it");
    CHECK(as_il(system).reason().ends_with("there are systems within it"));
    const Model spliced = read_lsystem("axiom F; F -> <\"GG\">", "x.lsys");
    CHECK(as_d0l(spliced).reason() ==
          "not a D0L system: the rule at x.lsys:1:10 splices a word in");
}
