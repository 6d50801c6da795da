#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "exact/exact.hpp"
#include "model/model.hpp"
#include "notation/notation.hpp"

using namespace algae;

namespace {

Model read(const std::string& text) { return read_lsystem(text, "x.lsys"); }

/// A rule laid open: every part with its symbols apart, so that the reader's cuts can be seen.
std::string laid_open(const std::string& rule) {
    const Model system = read("axiom a\nlet c = 1/4\nlet rest = 1-c\n" + rule);
    REQUIRE(system.rules.size() >= 1);
    const Production& first = system.rules.front();
    std::string out;
    const auto module = [&](Symbol symbol, std::vector<std::string> parts) {
        out += '<' + system.alphabet.name(symbol);
        for (std::size_t i = 0; i < parts.size(); ++i) out += (i == 0 ? "(" : ",") + parts[i];
        out += parts.empty() ? ">" : ")>";
    };
    const auto pattern = [&](const char* name, const Pattern& modules) {
        if (modules.empty()) return;
        out += std::string(name) + ' ';
        for (const ModulePattern& one : modules) module(one.symbol, one.parameters);
        out += "; ";
    };
    pattern("left", first.left);
    pattern("of", {first.predecessor});
    pattern("right", first.right);
    pattern("elsewhere", first.elsewhere);
    if (first.condition) out += "if " + to_text(*first.condition) + "; ";
    if (first.probability) out += "with " + to_string(*first.probability) + "; ";
    if (first.shape) {
        out += first.shape->operation + ' ' + first.shape->axis;
        for (const auto& size : first.shape->sizes)
            out += ' ' + to_text(size.value) + (size.relative ? " relative" : "");
        out += " of ";
        for (const Symbol symbol : first.shape->parts) module(symbol, {});
        return out;
    }
    out += "is ";
    for (std::size_t i = 0; i < first.successor.letters.size(); ++i) {
        std::vector<std::string> arguments;
        if (const auto at = first.successor.arguments.find(i);
            at != first.successor.arguments.end())
            for (const Expression& argument : at->second) arguments.push_back(to_text(argument));
        module(first.successor.letters[i], arguments);
    }
    return out;
}

std::vector<std::string> names(const Model& system, const Word& word) {
    std::vector<std::string> out;
    for (const Symbol symbol : word) out.push_back(system.alphabet.name(symbol));
    return out;
}

using Strings = std::vector<std::string>;

}  // namespace

TEST_CASE("rules") {
    CHECK(laid_open("F -> F+F--F+F") == "of <F>; is <F><+><F><-><-><F><+><F>");
    CHECK(laid_open("X -> ") == "of <X>; is ");
    CHECK(laid_open("X ->") == "of <X>; is ");
    CHECK(laid_open("X -> ε") == "of <X>; is ");
    CHECK(laid_open("- -> ε") == "of <->; is ");
    CHECK(laid_open("--> ε") == "of <->; is ");
    CHECK(laid_open("F → FF") == "of <F>; is <F><F>");
    CHECK(laid_open("F→FF") == "of <F>; is <F><F>");
    CHECK(laid_open("F -> F # double") == "of <F>; is <F>");
    CHECK(laid_open("F -> F; G -> G") == "of <F>; is <F>");
    CHECK(laid_open("@ -> \"'*!%~$.{&}\\|/") ==
          "of <@>; is <\"><'><*><!><%><~><$><.><{><&><}><\\><|></>");
}

TEST_CASE("symbols") {
    CHECK(laid_open("X -> F_lF_r+F_l") == "of <X>; is <F_l><F_r><+><F_l>");
    CHECK(laid_open("X_12 -> X_1 2X_a12_x+_x a_bc_") ==
          "of <X_12>; is <X_1><2><X_a><1><2><_><x><+><_><x><a_b><c><_>");
    CHECK(laid_open("α_β -> α∧β") == "of <α_β>; is <α><∧><β>");
    CHECK(laid_open("a -> ?Eb?E_1(2)") == "of <a>; is <?E><b><?E_1(2)>");
    const Model declared = read("axiom wallwindow wall\nw->wal window\nalphabet wall window");
    CHECK(names(declared, declared.axiom.letters) == Strings{"wall", "window", "wall"});
    CHECK(names(declared, declared.rules[0].successor.letters) == Strings{"w", "a", "l", "window"});
    CHECK(names(declared, declared.declared) == Strings{"wall", "window"});
}

TEST_CASE("probabilities") {
    CHECK(laid_open("F -(1/3)-> F; F -(2/3)-> G") == "of <F>; with 1/3; is <F>");
    CHECK(laid_open("F-(.25)->F;F-(0.75)→F") == "of <F>; with 1/4; is <F>");
    CHECK(laid_open("F -(c)-> F; F -(rest)-> G") == "of <F>; with 1/4; is <F>");
    CHECK(laid_open("F -(1-c)-> F; F -(c)-> G") == "of <F>; with 3/4; is <F>");
    CHECK(laid_open("- -(1)-> a") == "of <->; with 1; is <a>");
    CHECK(laid_open("A(x) : x > 3 -(0.5)-> B; A(y) : y > 3 -(1/2)-> C") ==
          "of <A(x)>; if x > 3; with 1/2; is <B>");
    CHECK(laid_open("A(x) : (x > 3)-(1)-> B") == "of <A(x)>; if x > 3; with 1; is <B>");
    CHECK(laid_open("A(x)-(1)-> B") == "of <A(x)>; with 1; is <B>");
}

TEST_CASE("a minus before a bracket is a module where a symbol must come") {
    CHECK(laid_open("-(a) -> +(a)") == "of <-(a)>; is <+(a)>");
    CHECK(laid_open("-(a)-> +(a)") == "of <-(a)>; is <+(a)>");
    CHECK(laid_open("b < -(a)-> +(a)") == "left <b>; of <-(a)>; is <+(a)>");
    CHECK(laid_open("b > -(a)-> +(a)") == "of <b>; right <-(a)>; is <+(a)>");
    CHECK(laid_open("b > -(a) -(1)-> +(a)") == "of <b>; right <-(a)>; with 1; is <+(a)>");
    CHECK(laid_open("A(x) : x -(3) -> B") == "of <A(x)>; if x-3; is <B>");
    CHECK(laid_open("A(x) : x > -(3)-> B") == "of <A(x)>; if x > -3; is <B>");
}

TEST_CASE("contexts") {
    CHECK(laid_open("b < a > c -> x") == "left <b>; of <a>; right <c>; is <x>");
    CHECK(laid_open("b < - > c -> x") == "left <b>; of <->; right <c>; is <x>");
    CHECK(laid_open("0 < 1 > 0 -> 1") == "left <0>; of <1>; right <0>; is <1>");
    CHECK(laid_open("BC < S > G[H]M -> X") == "left <B><C>; of <S>; right <G><[><H><]><M>; is <X>");
    CHECK(laid_open("+ - < + > - - -> +") == "left <+><->; of <+>; right <-><->; is <+>");
    CHECK(laid_open("ε < a > ε -> b") == "of <a>; is <b>");
    CHECK(laid_open("a(x)b < c(y) > d(z) : x+y > z -> e(x)") ==
          "left <a(x)><b>; of <c(y)>; right <d(z)>; if x+y > z; is <e(x)>");
}

TEST_CASE("parameters and conditions") {
    CHECK(laid_open("A(x,y) : y <= 3 -> A(x*2, x+y)") == "of <A(x,y)>; if y <= 3; is <A(x*2,x+y)>");
    CHECK(laid_open("A ( x , y ) : * -> A ( x )") == "of <A(x,y)>; is <A(x)>");
    CHECK(laid_open("A(x) : x ≤ 3 & x ≥ 1 | x ≠ 2 && x == 2 -> F(2^0.5*x)") ==
          "of <A(x)>; if x <= 3 & x >= 1 | x != 2 & x = 2; is <F(2^0.5*x)>");
    CHECK(laid_open("A(x) -> /(137.5)^(90)A(x,0.04)") ==
          "of <A(x)>; is </(137.5)><^(90)><A(x,0.04)>");
    CHECK(laid_open("A(x) ? B(y), C(r,z) : x < y + r -> D(x)E(y+r)") ==
          "of <A(x)>; elsewhere <B(y)><C(r,z)>; if x < y+r; is <D(x)><E(y+r)>");
    CHECK(laid_open("A > ?E(x) : x > 1 -> ?E(2)") == "of <A>; right <?E(x)>; if x > 1; is <?E(2)>");
    CHECK(laid_open("?E(x) -> ?E(x)") == "of <?E(x)>; is <?E(x)>");
}

TEST_CASE("shape rules") {
    CHECK(laid_open("A -> div(Y, 3, 1r, (c+1)r){ B C C }") ==
          "of <A>; div Y 3 1 relative c+1 relative of <B><C><C>");
    CHECK(laid_open("A -> repeat(Y, 0.3){C}") == "of <A>; repeat Y 0.3 of <C>");
    CHECK(laid_open("A -> div(XZ, 1r, 2 : c){ B C }") ==
          "of <A>; div XXZ 1 relative 2 c of <B><C>");
    CHECK(laid_open("A -> Split(X, 2){ B }") == "of <A>; div X 2 of <B>");
    CHECK(laid_open("A -> I(B)") == "of <A>; I  of <B>");
    CHECK(laid_open("A(x,y,z) : x > y -> I(B)") == "of <A(x,y,z)>; if x > y; I  of <B>");
    CHECK(laid_open("A(x,y,z) -> I(x)") == "of <A(x,y,z)>; is <I(x)>");
    CHECK(laid_open("A -> I(c)") == "of <A>; is <I(c)>");
    CHECK(laid_open("A -> I(1)") == "of <A>; is <I(1)>");
    CHECK(laid_open("A(B) -> I(B)") == "of <A(B)>; is <I(B)>");
    CHECK(laid_open("A(x) -> d iv(x)") == "of <A(x)>; is <d><i><v(x)>");
}

TEST_CASE("settings") {
    const Model system = read(
        "title  A -> B, see #3  # not this\n"
        "source 000 fig. 2.8; id S-005  F-007\n"
        "let r = 1/2\n"
        "axiom F\n"
        "ignore + - F F\nterminals a b\n"
        "interpret L_1 -> F\n"
        "angle 25.7; step 2*r; shrink 1/sqrt(2)\n"
        "start 0 -1 (90 + r)\nspin -45; scale 2; narrow .5; width 1.5\n"
        "colour red #ff8000 along\n");
    CHECK(system.title == "A -> B, see");
    CHECK(system.source == "000 fig. 2.8");
    CHECK(system.identifiers == Strings{"S-005", "F-007"});
    CHECK(names(system, system.ignored) == Strings{"+", "-", "F"});
    CHECK(names(system, system.terminals) == Strings{"a", "b"});
    CHECK(system.interpretation.size() == 1);
    CHECK(system.drawing.angle->exact == Rational(257, 10));
    CHECK(system.drawing.step->exact == Rational(1));
    CHECK_FALSE(system.drawing.shrink->exact.has_value());
    CHECK(system.drawing.shrink->value == doctest::Approx(0.70710678));
    CHECK(system.drawing.start->y.exact == Rational(-1));
    CHECK(system.drawing.start->heading.exact == Rational(181, 2));
    CHECK(system.drawing.spin->exact == Rational(-45));
    CHECK(system.drawing.clockwise == false);
}

TEST_CASE("colours, turns, generations, tables, expectations") {
    const Model system = read(
        "axiom a; turn clockwise\ncolour red #ff8000 along # a comment; not a statement\n"
        "generation 2..7\n"
        "table light\na -> b\na -> c\ntable dark ; a -> d\n"
        "expect length 3 : 148 # counted\nexpect word 0: F -  F");
    CHECK(system.drawing.colours == Strings{"red", "#ff8000", "along"});
    CHECK(system.drawing.clockwise);
    CHECK(system.drawing.generations == std::pair<std::uint64_t, std::uint64_t>{2, 7});
    CHECK(system.tables == Strings{"light", "dark"});
    CHECK(system.rules[1].table == 0);
    CHECK(system.rules[2].table == 1);
    CHECK(system.expectations[0].value == "148");
    CHECK(system.expectations[1].value == "F -  F");
    CHECK(read("axiom a; generation 4").drawing.generations ==
          std::pair<std::uint64_t, std::uint64_t>{4, 4});
    CHECK_FALSE(read("axiom a; turn counter-clockwise").drawing.clockwise);
}

TEST_CASE("places") {
    const Model system = read("# Koch\n  axiom  ε\n  F -> F;  G -> F(1)\n");
    CHECK(to_string(system.axiom_place) == "x.lsys:2:10");
    CHECK(to_string(system.rules[0].place) == "x.lsys:3:3");
    CHECK(to_string(system.rules[1].place) == "x.lsys:3:12");
    CHECK(to_string(system.rules[1].successor.arguments.at(0)[0].place) == "x.lsys:3:19");
    CHECK(system.axiom.letters.empty());
    CHECK(system.name == "x.lsys");
}

TEST_CASE("words of the command line") {
    Alphabet alphabet;
    alphabet.symbol("F");
    alphabet.symbol("wall");
    const ModuleWord word = read_word(" wallF_l[F(0.5,-2)] x ", alphabet);
    CHECK(print_word(alphabet, word) == "wall F_l[F(0.5,-2)]x");
    CHECK(read_word("ε", alphabet).letters.empty());
    CHECK(read_word("", alphabet).letters.empty());
}
