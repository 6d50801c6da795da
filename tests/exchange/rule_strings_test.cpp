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

bool holds(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}
std::string inkscape_fault(const std::string& text) {
    return refusal([&] { read_inkscape(text, "x.inkscape"); });
}
std::string tikz_fault(const std::string& text) {
    return refusal([&] { read_tikz(text, "x.tikz"); });
}

}  // namespace

TEST_CASE("Inkscape's fields: capitals, letters that draw and move, turns that go to the right") {
    const Model plant = read_inkscape(
        "# a plant\naxiom = ++f\nrules = f=ff-[-f+f+f]+[+f-f-f]\norder = 2\nlangle = 16\nrangle = "
        "16\n",
        "x");
    CHECK(print_lsystem(plant) ==
          "axiom ++F\nF -> FF-[-F+F+F]+[+F-F-F]\nangle 16\nstart 0 0 90\nturn "
          "clockwise\ngeneration 2\n");
    const Model kinds =
        read_inkscape("axiom = AGX\nrules = X=BHX;X=C;\nlangle = 30\nrangle = 40\n", "x");
    CHECK(figure(kinds, 0, {})->segments() == Integer(1));
    CHECK(figure(kinds, 1, {})->segments() == Integer(2));  // the last rule for X wins
    // + is a turn to the right by langle, - one to the left by rangle.
    const Model turned = read_inkscape("axiom = +F\nlangle = 90\nrangle = 45\n", "x");
    CHECK(figure(turned, 0, {})->facts().end[0].value() == doctest::Approx(1));
    const Model left = read_inkscape("axiom = -F\nlangle = 90\nrangle = 45\n", "x");
    CHECK(figure(left, 0, {})->facts().end[0].value() == doctest::Approx(-std::sqrt(0.5)));
    CHECK(read_inkscape("axiom = F\nrules = F=\n", "x").rules[0].successor.letters.empty());
}

TEST_CASE("what Inkscape drops or never uses is refused with its place") {
    CHECK(holds(inkscape_fault("axiom = F\nrules = F=F+F;FF\n"),
                "x.inkscape:2:15: error: expected a rule with one '='"));
    CHECK(holds(inkscape_fault("axiom = F\nrules = FF=F\n"), "one for 'FF' is never used"));
    CHECK(holds(inkscape_fault("axiom = F]\n"), "unmatched ']'"));
    CHECK(holds(inkscape_fault("axiom = F\nrandomizestep = 10\n"), "changes each step at random"));
    CHECK(holds(inkscape_fault("axiom = F\nlangel = 3\n"), "did you mean 'langle'?"));
    CHECK(holds(inkscape_fault("axiom = F\norder = x\n"), "expected a number as order, found 'x'"));
    CHECK(holds(inkscape_fault("axiom = F\naxiom = G\n"), "a second line for 'axiom'"));
    CHECK(holds(inkscape_fault("rules = F=F\n"), "expected a line `axiom = F`"));
}

TEST_CASE("systems of TikZ are read as its library draws them") {
    const Model koch = read_tikz(
        "\\pgfdeclarelindenmayersystem{koch}{\n  \\rule{F -> F-F++F-F}\n}\n\\draw l-system "
        "[l-system={koch, axiom=F++F++F, order=3, angle=60, step=2pt}];\n",
        "x");
    CHECK(print_lsystem(koch) == "axiom F++F++F\nF -> F-F++F-F\nangle 60\ngeneration 3\n");
    const Model set = read_tikz(
        "\\tikz[l-system={rule set={F -> FF-[-F+F]+[+F-F], X -> F}, axiom={F[X]}, order=2, left "
        "angle=30, right angle=20}]",
        "x");
    CHECK(print_lsystem(set) ==
          "axiom F[X]\nF -> FF-[-F+F]+[+F-F]\nX -> F\ninterpret - -> -(20)\nangle 30\ngeneration "
          "2\n");
    const Model hilbert = read_tikz(
        "\\pgfdeclarelindenmayersystem{h}{\\symbol{G}{\\pgflsystemdrawforward}\\rule{G -> G+G}}\n",
        "x");
    CHECK(print_lsystem(hilbert) == "axiom G\nG -> G+G\ninterpret G -> F\nangle 90\n");
    CHECK(figure(read_tikz("\\rule{G -> GF}", "x"), 1, {})->segments() ==
          Integer(1));  // G does nothing
    // Of two declarations the options name one.
    const std::string two =
        "\\pgfdeclarelindenmayersystem{a}{\\rule{F -> "
        "FF}}\n\\pgfdeclarelindenmayersystem{b}{\\rule{F "
        "-> F+F}\\rule{X -> F}}\n";
    CHECK(print_lsystem(read_tikz(two + "\\draw l-system [l-system={a, axiom=F, order=1}];",
                                  "x")) == "axiom F\nF -> FF\nangle 90\ngeneration 1\n");
    CHECK(read_tikz(two + "[l-system={b, axiom=F}]", "x").rules.size() == 2);
    CHECK(holds(tikz_fault(two), "x.tikz:2:1: error: a second system: say which of a, b is drawn"));
    CHECK(holds(tikz_fault(two + "[l-system={c, axiom=F}]"),
                "x.tikz:3:12: error: no system 'c' is declared"));
    CHECK(holds(tikz_fault(two + "[l-system={a, axiom=F}] [l-system={b}]"), "a second system"));
    CHECK(holds(tikz_fault("l-system={rule set={F -> FF}, axiom=F} l-system={axiom=X}"),
                "a second value of 'axiom', which was 'F'"));
    CHECK(holds(tikz_fault("nothing"), "expected \\pgfdeclarelindenmayersystem"));
    CHECK(holds(tikz_fault("\\rule{F - F}"), "x.tikz:1:7: error: expected a rule with '->'"));
    CHECK(holds(tikz_fault("\\rule{FF -> F}"), "expected one character before '->', found 'FF'"));
    CHECK(holds(tikz_fault("\\rule{F -> F"), "unmatched '{'"));
    CHECK(holds(tikz_fault("\\symbol{X}{\\fill circle;}\\rule{F -> F}"), "TeX that is none of"));
    CHECK(holds(tikz_fault("\\rule{F -> F} l-system={axiom=F, ordre=3}"), "did you mean 'order'?"));
    CHECK(holds(tikz_fault("\\rule{F -> F} l-system={randomize step percent=5}"), "at random"));
}

TEST_CASE("rule strings read back with the same figures") {
    std::size_t compared = 0;
    CHECK(rc::check([&] {
        const bool tikz = *rc::gen::arbitrary<bool>();
        const auto word = [&](int most) {
            std::string text;
            const int count = *rc::gen::inRange(1, most);
            int open = 0;
            for (int i = 0; i < count; ++i) {
                const char letter = *rc::gen::elementOf(std::string("FXY+-[]"));
                if (letter == ']' && open == 0) continue;
                open += letter == '[' ? 1 : letter == ']' ? -1 : 0;
                text += letter;
            }
            return text + std::string(static_cast<std::size_t>(open), ']');
        };
        std::string text = "axiom X" + word(5) + "\nX -> F" + word(6) + "\n";
        if (*rc::gen::arbitrary<bool>()) text += "F -> " + word(4) + "F\n";
        if (*rc::gen::arbitrary<bool>()) text += "interpret Y -> F\n";
        text += "angle " + std::to_string(*rc::gen::element(30, 45, 60, 90)) +
                (tikz ? "\n" : "\nstart 0 0 90\n");
        if (*rc::gen::arbitrary<bool>()) text += "turn clockwise\n";
        const Model system = read_lsystem(text, "any");
        std::string file;
        try {
            file = tikz ? print_tikz(system) : print_inkscape(system);
        } catch (const Error&) {
            return;
        }
        const Model back = tikz ? read_tikz(file, "back") : read_inkscape(file, "back");
        for (std::uint64_t n = 0; n < 4; ++n) {
            const auto a = figure(system, n, {}), b = figure(back, n, {});
            RC_ASSERT(a->segments() == b->segments());
            if (a->box().empty) continue;
            RC_ASSERT(similarity(outline(system, n), "a", outline(back, n), "b").same_place);
            ++compared;
        }
    }));
    CHECK(compared >= 60);
}

TEST_CASE("what the strings cannot say is refused") {
    const auto refused = [](const std::string& text, bool tikz) {
        const Model system = read_lsystem(text, "s");
        return refusal([&] { tikz ? print_tikz(system) : print_inkscape(system); });
    };
    CHECK(holds(refused("axiom F(2)", true), "tikz cannot say the axiom's parameters"));
    CHECK(holds(refused("axiom F_l", true), "single characters that TeX leaves alone"));
    CHECK(holds(refused("axiom F&F", false), "which does &"));
    CHECK(holds(refused("axiom F; F -> F; F -> FF", false), "it is the second for its letter"));
    CHECK(holds(refused("axiom X; interpret X -> F+F", false), "which does several things"));
    CHECK(holds(refused("axiom F|F", true), "which turns back"));
}

TEST_CASE("comments of TeX and of Inkscape's fields are no part of a system") {
    const char* const text =
        "\\pgfdeclarelindenmayersystem{k}{% a curve\n\\rule{F -> F-F}\n% \\rule{F -> FFF}\n}\n"
        "% \\draw l-system [l-system={other, axiom=FF, order=7}];\n"
        "\\draw l-system [l-system={k, axiom=F, order=1, % angle=90,\n angle=60}];\n";
    CHECK(print_lsystem(read_tikz(text, "x")) == "axiom F\nF -> F-F\nangle 60\ngeneration 1\n");
    CHECK(print_lsystem(read_inkscape("axiom = F # one\nrules = F=F+F # c\nlangle = 60\nrangle = "
                                      "60\n",
                                      "x"))
              .starts_with("axiom F\nF -> F+F\n"));
}

TEST_CASE("symbols that do nothing in the plane leave a figure there") {
    const Model plane = read_inkscape("axiom = F&F^F\n", "x");
    CHECK_FALSE(leaves_plane(plane));
    CHECK_FALSE(leaves_plane(read_lsystem("axiom XF+F; X -> &; interpret & -> ε", "")));
    // With a number it is another module, which nothing interprets.
    CHECK(leaves_plane(read_lsystem("axiom F&(30)F; interpret & -> ε", "")));
    CHECK(leaves_plane(read_lsystem("axiom F&F; interpret & -> &(30)", "")));
    CHECK(leaves_plane(
        read_lsystem("axiom F&F; interpret & -(1/2)-> ε; interpret & -(1/2)-> F", "")));
}
