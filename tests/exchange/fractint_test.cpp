#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <array>

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

Model entry(const std::string& text, const std::string& name = "x.l") {
    return read_fractint(text, name);
}
std::string said(const std::string& body) {
    return refusal([&] { entry("A {\n" + body + "\n}\n"); });
}
std::string unsaid(const std::string& text) {
    return refusal([&] { print_fractint(read_lsystem(text, "x.lsys")); });
}
std::string lsys(const std::string& body) { return print_lsystem(entry("A {\n" + body + "\n}\n")); }

/// What Iterated Dynamics draws of generations 0, 1 and 2: how many lines, and the box of all places where its turtle is, y up.
struct Measured {
    const char* text;
    std::array<std::size_t, 3> segments;
    std::array<std::array<double, 4>, 3> boxes;
};

const Measured measured[] = {
    {"Tri { ; comment\n  Angle 6\n  Axiom F--F--F\n  F=F+F--F+F\n}\n",
     {3, 12, 48},
     {{{0.0, -0.8660254038, 1.0, 0.0},
       {0.0, -2.598076211, 3.0, 0.8660254038},
       {0.0, -7.794228634, 9.0, 2.598076211}}}},
    {"Twig {\n  Angle 8\n  Axiom fx\n  x=-fx++\n  x=fy-\n  f=\n  y=+fx--fy+\n}\n",
     {1, 2, 4},
     {{{0.0, 0.0, 1.0, 0.0}, {0.0, -0.7071067812, 1.414213562, 0.0}, {0.0, -1.0, 2.0, 0.0}}}},
    {"OneLine { Angle 4\n  Axiom d\\90@iq2d\n  d=d\\60m/30@.5d\n}\n",
     {2, 4, 8},
     {{{0.0, 0.0, 1.0, 0.7071067812},
       {0.0, 0.0, 1.933012702, 1.510599969},
       {0.0, 0.0, 2.058012702, 2.174038106}}}},
    {"PipeOdd { \n  Angle 5\n  Axiom f|f\n}\n",
     {2, 2, 2},
     {{{0.0, -0.5877852523, 1.0, 0.0},
       {0.0, -0.5877852523, 1.0, 0.0},
       {0.0, -0.5877852523, 1.0, 0.0}}}},
    {"BareAt { \n  Angle 4\n  Axiom f@f+f\n}\n",
     {3, 3, 3},
     {{{0.0, 0.0, 1.0, 0.0}, {0.0, 0.0, 1.0, 0.0}, {0.0, 0.0, 1.0, 0.0}}}},
    {"SpacesRule { \n  Angle 4\n  Axiom F\n  F = F+F\n}\n",
     {1, 2, 4},
     {{{0.0, 0.0, 1.0, 0.0}, {0.0, 0.0, 1.0, 1.0}, {0.0, 0.0, 1.0, 1.0}}}},
    {"UnkSym { \n  Angle 4\n  Axiom F?F(2)%F\n}\n",
     {3, 3, 3},
     {{{0.0, 0.0, 3.0, 0.0}, {0.0, 0.0, 3.0, 0.0}, {0.0, 0.0, 3.0, 0.0}}}},
    {"Order0rule { \n  Angle 4\n  Axiom F\n  F=\n}\n",
     {1, 0, 0},
     {{{0.0, 0.0, 1.0, 0.0}, {0.0, 0.0, 0.0, 0.0}, {0.0, 0.0, 0.0, 0.0}}}},
    {"CaseA {\n  ANGLE 4\n  AXIOM f+F\n  f=Ff\n}\n",
     {2, 4, 8},
     {{{0.0, 0.0, 1.0, 1.0}, {0.0, 0.0, 2.0, 2.0}, {0.0, 0.0, 4.0, 4.0}}}},
    {"Exp {\n  Angle 4\n  Axiom F@1e2F\n}\n",
     {2, 2, 2},
     {{{0.0, 0.0, 2.0, 0.0}, {0.0, 0.0, 2.0, 0.0}, {0.0, 0.0, 2.0, 0.0}}}},
};

}  // namespace

TEST_CASE("figures of Fractint are those that the program draws, with their boxes") {
    std::size_t boxes = 0;
    for (const Measured& one : measured) {
        CAPTURE(one.text);
        const Model system = entry(one.text);
        for (std::uint64_t n = 0; n <= 2; ++n) {
            CAPTURE(n);
            const auto figure = open_figure(system, n, {}, {}, nullptr);
            const Facts& facts = figure->facts();
            CHECK(facts.segments == one.segments[n]);
            if (facts.segments == 0) continue;
            const auto& box = one.boxes[n];
            // The box of the program counts moves too; where a figure is all lines they are equal.
            const bool moves =
                std::string(one.text).find_first_of("GgMmPp@") != std::string::npos &&
                std::string(one.text).find("m/30") != std::string::npos;
            if (moves) continue;
            ++boxes;
            CHECK(near(facts.low.at(0).value(), box[0]));
            CHECK(near(facts.low.at(1).value(), box[1]));
            CHECK(near(facts.high.at(0).value(), box[2]));
            CHECK(near(facts.high.at(1).value(), box[3]));
        }
    }
    CHECK(boxes >= 20);
}

TEST_CASE("an entry of Fractint in the notation") {
    CHECK(lsys("Angle 6\nAxiom F--F--F\nF=F+F--F+F") ==
          "title A\naxiom F--F--F\nF -> F+F--F+F\nangle 60\n");
    CHECK(lsys("angle 8\naxiom fx\nx=-fx++\nx=fy-\nf=\ny=+fx")
              .find("X -> -FX++FY-\nF -> ε\nY -> +FX\n") != std::string::npos);
    // Half a turn of an odd number of parts is less than half a turn, clockwise.
    CHECK(lsys("Angle 5\nAxiom F|F").find("interpret | -> -(144)\n") != std::string::npos);
    CHECK(lsys("Angle 6\nAxiom F|F").find("interpret |") == std::string::npos);
    // The heading of D does not see + and -, and that of F does not see \ and /.
    CHECK(lsys("Angle 4\nAxiom D+\\60D")
              .find("interpret D -> F\ninterpret + -> ε\ninterpret \\60 -> +(60)\n") !=
          std::string::npos);
    CHECK(lsys("Angle 4\nAxiom F+\\60F").find("interpret \\60 -> ε\n") != std::string::npos);
    CHECK(
        lsys("Angle 4\nAxiom F@IQ2F@.5G")
            .find("interpret @iq2 -> *(1/sqrt(2))\ninterpret @.5 -> *(0.5)\ninterpret G -> f\n") !=
        std::string::npos);
    CHECK(lsys("Angle 4\nAxiom Fc12F").find("interpret C12 -> '(12)\n") != std::string::npos);
    // What does nothing there does nothing here.
    CHECK(lsys("Angle 4\nAxiom F&F?F(2)").find("interpret & -> ε\n") != std::string::npos);
}

TEST_CASE("letters of Fractint are told apart by the state in which they stand") {
    const auto box = [](const std::string& body, std::uint64_t n) {
        const auto drawn = open_figure(entry("A {\n" + body + "\n}\n"), n, {}, {}, nullptr);
        const Facts& facts = drawn->facts();
        return std::array{facts.low.at(0).value(), facts.low.at(1).value(),
                          facts.high.at(0).value(), facts.high.at(1).value()};
    };
    const auto same = [&](const std::string& a, const std::string& b) {
        std::size_t compared = 0;
        for (std::uint64_t n = 1; n <= 4; ++n) {
            const auto left = box(a, n), right = box(b, n);
            for (std::size_t i = 0; i < 4; ++i) compared += near(left[i], right[i]) ? 1 : 0;
        }
        return compared == 16;
    };
    // What stands between two ! has its turns the other way.
    CHECK(same("Angle 4\nAxiom F!X!F\nX=F+FX-F", "Angle 4\nAxiom FYF\nY=F-FY+F"));
    CHECK(same("Angle 4\nAxiom X\nX=F+!X", "Angle 4\nAxiom X\nX=F+Y\nY=F-X"));
    // D looks up, whatever + does: one step to the right, three up.
    CHECK(box("Angle 4\nAxiom \\90X\nX=F+X-D", 2) == std::array<double, 4>{0, 0, 1, 3});
    CHECK(lsys("Angle 4\nAxiom c3F<2F>1F").find("interpret X_60·2 -> '(5)\n") != std::string::npos);
    CHECK(lsys("Angle 4\nAxiom c3F<2F>1F").find("interpret X_62·1 -> '(4)\n") != std::string::npos);
}

TEST_CASE("one of several systems of a file is named behind a colon") {
    const std::string text =
        "; two\ncomment { not { one }\nKoch { ; a curve\n Angle 6\n Axiom F\n}\n{ prose }\nDragon "
        "{\n Angle 8\n Axiom FX\n}\n";
    CHECK(refusal([&] { entry(text); }) ==
          "x.l has several systems: Koch, Dragon; say which: x.l:Koch");
    CHECK(entry(text, "x.l:dragon").title == "Dragon");
    CHECK(refusal([&] { entry(text, "x.l:Dargon"); }) ==
          "x.l has no system 'Dargon'; did you mean 'Dragon'?; it has Koch, Dragon");
    CHECK(refusal([&] { entry("no system\n"); }).find("expected an entry NAME { ... }") !=
          std::string::npos);
    CHECK(file_and_entry("a/b.l:C") == std::pair<std::string, std::string>("a/b.l", "C"));
    CHECK(file_and_entry("a/b.lsys") == std::pair<std::string, std::string>("a/b.lsys", ""));
    CHECK(system_format("x.l:Dragon")->name == "l");
    CHECK(system_format_of(text)->name == "l");
    CHECK(system_format_of("axiom a; a -> ab") == nullptr);
    // Systems within a system of the notation look much like it.
    CHECK(system_format_of("system s { axiom <s(0)> }\naxiom <s(0)>") == nullptr);
    CHECK(system_format_of("system leaf {\n    axiom x\n}\naxiom <leaf(0)>\n") == nullptr);
}

TEST_CASE("what Fractint rejects, and what has no meaning here, is refused with its place") {
    const std::pair<const char*, const char*> all[] = {
        {"Angle 4\nAxiom = F",
         "x.l:3:9: error: expected the end of the line after the value of 'axiom'"},
        {"Angle 4\nAxiom F\nF=F + F",
         "x.l:4:5: error: expected the end of the line after the rule for 'f', which has no "
         "blanks, found '+'"},
        {"Angle 4\nAxiom F\nc=FF", "x.l:4:1: error: the command 'c' cannot be rewritten"},
        {"Angle 4\nAxiom F\nF=FF }", "x.l:4:6: error: expected '}' on a line of its own"},
        {"Angle 51\nAxiom F", "x.l:2:7: error: expected an angle from 3 to 50"},
        {"Angle 2\nAxiom F", "x.l:2:7: error: expected an angle from 3 to 50"},
        {"Axiom F", "x.l:1:1: error: expected 'Angle'"},
        {"Angle 4", "x.l:1:1: error: expected an axiom in 'A'"},
        {"Angle 4\nAxiom F\nFF=F",
         "x.l:4:1: error: expected 'Axiom', 'Angle', '}' or a rule for one symbol, found 'ff'"},
        {"Angle 4\nAxiom F\nF=F[F", "x.l:4:4: error: '[' is never closed"},
        {"Angle 4\nAxiom", "x.l:3:1: error: expected a value after 'axiom'"},
        {"Angle 4\nAxiom XF+F\nX=!X",
         "x.l:3:9: error: '+' depends on what ! swaps, which 'x' "
         "before it changes from one order to the next"},
        {"Angle 4\nAxiom XFD\nX=+X",
         "x.l:3:9: error: 'd' depends on the difference of the two "
         "headings, which 'x' before it changes"},
    };
    for (const auto& [body, message] : all) {
        CAPTURE(body);
        CHECK(said(body).find(message) == 0);
    }
    // Every fault is told at once.
    CHECK(said("Angle 99\nAxiom F\nFF=F").find("x.l:4:1: error") != std::string::npos);
}

TEST_CASE("what no entry of Fractint says is refused by name") {
    const std::pair<const char*, const char*> all[] = {
        {"axiom a; a -> b; a -> c", "it is the second for its letter"},
        {"axiom A(1)", "cannot say the axiom's parameters"},
        {"axiom F+F; angle 25.7", "the angle 25.7: expected a multiple of 360/N degrees"},
        {"axiom F&F", "the letter &, which is the command & of the notation"},
        {"axiom F; interpret F -> F(2)", "takes steps of other lengths"},
        {"axiom FL; interpret L -> F", "which does what another letter does"},
        {"axiom F; start 0 0 90", "a start heading other than 0"},
        {"axiom F; a < F -> b", "it has a context"},
        {"axiom a; a -> ab; coding { a -> 0 }", "a coding"},
        {"axiom F|F; angle 72", "half a turn is no multiple of 360/5"},
    };
    for (const auto& [text, message] : all) {
        CAPTURE(text);
        CHECK(unsaid(text).find(message) != std::string::npos);
    }
    CHECK(print_fractint(read_lsystem("title Koch; axiom F--F--F; F -> F+F--F+F; angle 60", "")) ==
          "Koch { ; Koch\n  Angle 6\n  Axiom F--F--F\n  F=F+F--F+F\n}\n");
    CHECK(print_fractint(read_lsystem("axiom F; F -> F+F; angle 120; turn clockwise", "")) ==
          "System {\n  Angle 3\n  Axiom F\n  F=F-F\n}\n");
}

TEST_CASE("what is printed for Fractint draws the same figure") {
    std::size_t compared = 0;
    for (const GalleryEntry& known : gallery()) {
        const Model system = read_lsystem(known.text, std::string(known.name));
        std::string text;
        try {
            text = print_fractint(system);
        } catch (const Error&) {
            continue;
        }
        CAPTURE(text);
        if (!as_d0l(system) || leaves_plane(system)) continue;
        const Model again = read_fractint(text, "x.l");
        for (std::uint64_t n = 0; n <= 3; ++n) {
            const auto left = open_figure(system, n, {}, {}, nullptr),
                       right = open_figure(again, n, {}, {}, nullptr);
            CHECK(left->facts().segments == right->facts().segments);
            if (left->facts().segments == 0) continue;
            // The same shape: width and height in the same ratio.
            const auto span = [](const Facts& facts, std::size_t i) {
                return facts.high.at(i).value() - facts.low.at(i).value();
            };
            CHECK(near(span(left->facts(), 0) * span(right->facts(), 1),
                       span(left->facts(), 1) * span(right->facts(), 0)));
        }
        ++compared;
    }
    CHECK(compared >= 30);
}

TEST_CASE("entries of Fractint come back from the notation, and no text does harm") {
    std::size_t whole = 0;
    CHECK(rc::check("entries", [&] {
        const auto word = [](int most) {
            std::string out;
            const int length = *rc::gen::inRange(1, most);
            for (int i = 0; i < length; ++i)
                out += *rc::gen::element<std::string>("F", "G", "X", "y", "+", "-", "|", "@2",
                                                      "@.5", "@iq2", "f", "z");
            return out;
        };
        std::string text = "Any {\n Angle " + std::to_string(*rc::gen::inRange(3, 51)) +
                           "\n Axiom " + word(6) + "\n";
        for (const char left : {'F', 'X', 'y'})
            if (*rc::gen::inRange(0, 2)) text += std::string(" ") + left + "=" + word(8) + "\n";
        const Model system = read_fractint(text + "}\n", "x.l");
        std::string printed;
        try {
            printed = print_fractint(system);
        } catch (const Error&) {
            RC_SUCCEED("an odd angle with half a turn");
        }
        const Model again = read_fractint(printed, "x.l");
        for (std::uint64_t n = 0; n <= 3; ++n) {
            const auto left = open_figure(system, n, {}, {}, nullptr),
                       right = open_figure(again, n, {}, {}, nullptr);
            RC_ASSERT(left->facts().segments == right->facts().segments);
        }
        ++whole;
    }));
    CHECK(whole >= 30);
    CHECK(rc::check("any text", [] {
        std::string text;
        const int length = *rc::gen::inRange(0, 60);
        for (int i = 0; i < length; ++i)
            text += *rc::gen::element<std::string>("A {", "}", "\n", "Angle 4\n", "Axiom F\n",
                                                   "F=F+F\n", " ", ";", "{", "[", "]", "=", "@",
                                                   "\\", "c1", "\xff", "<", "q", "axiom");
        try {
            read_fractint(text, "x.l");
        } catch (const Error&) {
        }
    }));
}

TEST_CASE("symbols beyond ASCII are refused with their place, and stand in comments") {
    CHECK(said("Angle 4\nAxiom \xe9\n")
              .find("x.l:3:7: error: expected symbols of ASCII, found the "
                    "byte 233") != std::string::npos);
    CHECK(said("Angle 4\nAxiom f\n\xe8=f\n").find("x.l:4:1: error: expected symbols of ASCII") !=
          std::string::npos);
    CHECK(lsys("; \xe9\nAngle 4\nAxiom f").find("axiom F\n") != std::string::npos);
}

TEST_CASE("numbers of Fractint end where the program stops to read") {
    CHECK(lsys("Angle 4\nAxiom @1.5.2f").find("*(1.5)") != std::string::npos);
    CHECK(lsys("Angle 4\nAxiom c1.5f").find("'(1)") != std::string::npos);
    CHECK(lsys("Angle 4\nAxiom c300f").find("'(44)") != std::string::npos);
}

TEST_CASE(
    "errors of figures from other programs' files name the file, and no line of another text") {
    const Model system = read_cpfg(
        "// one\n\n\nLsystem: 1\nderivation length: 1\nAxiom: A(0)\nA(x) --> B(1/x)\n"
        "endlsystem\n",
        "big.l");
    CHECK(
        refusal([&] { derived_modules(system, 1, {}); }).starts_with("big.l: the rule for A(0) "));
}
