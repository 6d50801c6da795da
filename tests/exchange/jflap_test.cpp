#include <doctest/doctest.h>
#include <rapidcheck.h>

#include "exchange/compared.hpp"
#include "exchange/detail/formats.hpp"
#include "exchange/exchange.hpp"
#include "exchange/inputs.hpp"
#include "language/language.hpp"
#include "model/model.hpp"
#include "notation/notation.hpp"

using namespace algae;
using namespace algae::exchange_tests;

namespace {

std::string file(const std::string& inside) {
    return "<structure><type>lsystem</type>\n" + inside + "\n</structure>\n";
}
std::string production(const std::string& left, const std::string& right) {
    return "<production><left>" + left + "</left><right>" + right + "</right></production>\n";
}
std::string lsys(const std::string& inside) {
    return print_lsystem(read_jflap(file(inside), "x.jff"));
}
std::string said(const std::string& text) {
    return refusal([&] { read_jflap(text, "x.jff"); });
}

}  // namespace

TEST_CASE("the dragon of JFLAP has the words and the turns that JFLAP has") {
    const Model dragon = read_jflap(
        "<!-- made by hand -->\n" +
            file("<axiom>g X</axiom>" + production("X", "- g X + + g Y -") +
                 production("Y", "+ g X - - g Y +") +
                 "<production><left>g</left><right/></production><parameter><name>angle</"
                 "name><value>45</value></parameter>"),
        "dragon.jff");
    // The lengths that the program's own expander gives.
    const std::size_t lengths[] = {2, 8, 20, 44, 92, 188, 380};
    for (std::uint64_t n = 0; n <= 6; ++n) CHECK(derive(*as_d0l(dragon), n).size() == lengths[n]);
    CHECK(print_lsystem(dragon) ==
          "axiom gX\nX -> -gX++gY-\nY -> +gX--gY+\ng -> ε\ninterpret g -> F\nangle 45\nstep "
          "15\nstart 0 0 90\nturn clockwise\n");
}

TEST_CASE("contexts of JFLAP rewrite the symbol of their number") {
    const Model words = read_jflap(
        file("<axiom>a a a a a a a a b b b b b b b b c c c c c c c c</axiom>" +
             production("0 B b", "b") + production("0 B c", "") + production("0 a b", "") +
             production("1 B b", "B") + production("1 B c", "") + production("1 a b", "B")),
        "x.jff");
    // The lengths that the program's own expander gives.
    const std::size_t lengths[] = {24, 23, 23, 22, 22, 21, 21};
    const auto rules = as_dil(words);
    REQUIRE(bool(rules));
    Development development(*rules, {});
    for (const std::size_t length : lengths) {
        CHECK(development.length() == length);
        development.steps(1);
    }
    // Where two productions match, one is picked: a c is b's neighbourhood on both sides.
    const std::string both =
        lsys("<axiom>a b c</axiom>" + production("1 a b", "x") + production("0 b c", "y"));
    CHECK(both.find("a < b > c -(0.5)-> x\n") != std::string::npos);
    CHECK(both.find("a < b > c -(0.5)-> y\n") != std::string::npos);
    CHECK(said(file("<axiom>a b [ a ]</axiom>" + production("1 a b", "c")))
              .find("brackets are letters beside contexts in JFLAP") != std::string::npos);
    CHECK(said(file("<axiom>a b</axiom>" + production("2 a b", "c")))
              .find("expected a number from 0 to 1, found 2") != std::string::npos);
    CHECK(said(file("<axiom>a b</axiom>" + production("a b", "c")))
              .find("expected the number of the symbol that is rewritten") != std::string::npos);
}

TEST_CASE("symbols of JFLAP in the notation") {
    CHECK(lsys("<axiom>gg F</axiom>") ==
          "alphabet gg\naxiom gg F\ninterpret F -> ε\nangle 15\nstep 15\nstart 0 0 90\nturn "
          "clockwise\n");
    CHECK(lsys("<axiom>g(30) +(60) * % &lt; ##</axiom>").find("interpret g·30 -> F(30/15)") !=
          std::string::npos);
    CHECK(lsys("<axiom>* %</axiom>").find("interpret * -> \\\ninterpret % -> |\n") !=
          std::string::npos);
    // Several right sides are equally likely, one that stands there twice twice as likely.
    CHECK(lsys("<axiom>T</axiom><production><left>T</left><right>T "
               "g</right><right>T</right><right>T</right></production>")
              .find("T -(1/3)-> Tg\nT -(2/3)-> T\n") != std::string::npos);
    CHECK(lsys("<axiom>a</axiom><axiom>b</axiom>").find("axiom b\n") != std::string::npos);
}

TEST_CASE("brackets of JFLAP without a partner do nothing where no branch stands around them") {
    const Model system =
        read_jflap(file("<axiom>g ] X</axiom>" + production("X", "g ] [ + X")), "x");
    CHECK(open_figure(system, 2, {}, {}, nullptr)->facts().segments == 3);
    CHECK(word_of(system, 0) == "g X_93_0 X ");
}

TEST_CASE("colours and widths of JFLAP are those of the notation where they are known") {
    const std::string text = lsys(
        "<axiom>g color=red ! g [ ! ! g ] ~ "
        "g</axiom><parameter><name>color</name><value>brown</value>"
        "</parameter><parameter><name>lineWidth</name><value>3</value></parameter>");
    CHECK(text.find("colour brown red\n") != std::string::npos);
    CHECK(text.find("-> '(1)\n") != std::string::npos);
    CHECK(text.find("width 3\n") != std::string::npos);
    for (const char* width : {"-> !(4)\n", "-> !(5)\n", "-> !(6)\n", "-> !(3)\n"})
        CHECK(text.find(width) != std::string::npos);
    // R goes on making lines wider: what stands behind it is as wide as at first.
    CHECK(lsys("<axiom>R ! g</axiom>" + production("R", "! R")).find("!(") == std::string::npos);
}

TEST_CASE("what is no L-system of JFLAP, or has no meaning here, is refused with its place") {
    const std::pair<std::string, const char*> all[] = {
        {"<structure><type>fa</type></structure>",
         "x.jff:1:12: error: expected an L-system of JFLAP, found the type 'fa'"},
        {"<structure type=\"lsystem\"></structure>", "expected an <axiom>, found none"},
        {"<html></html>", "x.jff:1:1: error: expected <structure>, found <html>"},
        {file(""), "expected an <axiom>, found none"},
        {file("<axiom>a"), "expected </axiom>, found </structure>"},
        {"<structure><type>lsystem</type>", "x.jff:1:1: error: <structure> is never closed"},
        {"</structure>", "expected no </structure>"},
        {"a", "expected an element of XML"},
        {"", "found no element"},
        {"<structure", "'<' is never closed"},
        {"<!-- ", "the comment is never closed"},
        {file("<axiom>a &x; b</axiom>"),
         "x.jff:2:10: error: expected &lt; &gt; &amp; &quot; or &apos; behind '&'"},
        {file("<axiom>a angle=2+</axiom>"),
         "x.jff:2:10: error: expected an expression behind '=', found '2+'"},
        {file("<axiom>g(a*)</axiom>"),
         "x.jff:2:8: error: expected an expression between the brackets"},
        {file("<axiom>[ X ]</axiom>" + production("X", "g ] g")),
         "unmatched ']' in a word of 'X', which stands in branches"},
        {file("<axiom>a</axiom><production><right>a</right></production>"),
         "expected <left> in a production, found none"},
        {file("<axiom>a</axiom><production><left>a</left></production>"),
         "expected <right> in a production, found none"},
        {file("<axiom>a</axiom><production><left> </left><right>a</right></production>"),
         "expected a symbol in <left>, found none"},
        {file("<axiom>a</axiom><parameter><name>angle</name><value>x</value></parameter>"),
         "expected a number as angle, found 'x'"},
        {file("<axiom>a</axiom><parameter><name>angle</name></parameter>"),
         "expected <name> and <value> in a parameter"},
    };
    for (const auto& [text, message] : all) {
        CAPTURE(text);
        CHECK(said(text).find(message) != std::string::npos);
    }
    std::string deep;
    for (int i = 0; i < 1000; ++i) deep += "<a>";
    CHECK(said(deep).find("more than 100 elements within each other") != std::string::npos);
}

TEST_CASE("systems are written for JFLAP and come back with the same words and figures") {
    std::size_t compared = 0;
    for (const GalleryEntry& known : gallery()) {
        const Model system = read_lsystem(known.text, std::string(known.name));
        if (!as_d0l(system) || leaves_plane(system)) continue;
        std::string text;
        try {
            text = print_jflap(system);
        } catch (const Error&) {
            continue;
        }
        CAPTURE(text);
        const Model again = read_jflap(text, "x.jff");
        for (std::uint64_t n = 0; n <= 3; ++n) {
            CHECK(derive(*as_d0l(again), n).size() == derive(*as_d0l(system), n).size());
            const auto left = open_figure(system, n, {}, {}, nullptr),
                       right = open_figure(again, n, {}, {}, nullptr);
            CHECK(left->facts().segments == right->facts().segments);
        }
        ++compared;
    }
    CHECK(compared >= 30);
    const auto unsaid = [](const std::string& text) {
        return refusal([&] { print_jflap(read_lsystem(text, "x")); });
    };
    CHECK(unsaid("axiom F; shrink 1/3").find("that steps shrink") != std::string::npos);
    CHECK(unsaid("axiom A(1)").find("the axiom's parameters") != std::string::npos);
    CHECK(unsaid("axiom F; angle 360/7").find("which is no decimal") != std::string::npos);
    CHECK(unsaid("axiom FL; interpret L -> F").find("which does what another letter does") !=
          std::string::npos);
    CHECK(unsaid("axiom F$").find("is the command $ of the notation") != std::string::npos);
    CHECK(unsaid("axiom a; b < a -> c").find("it has a context") != std::string::npos);
    // Turns to the left are - there.
    CHECK(print_jflap(read_lsystem("axiom F+F; angle 60", "")).find("<axiom>g - g</axiom>") !=
          std::string::npos);
    CHECK(print_jflap(read_lsystem("axiom a; a -(1/3)-> b; a -(2/3)-> c", ""))
              .find("<right>b</right>\n    <right>c</right>\n    <right>c</right>") !=
          std::string::npos);
    CHECK(rc::check("any text", [] {
        std::string text;
        for (int length = *rc::gen::inRange(0, 40); length > 0; --length)
            text += *rc::gen::element<std::string>(
                "<structure>", "<type>lsystem</type>", "<axiom>", "</axiom>", "<production>",
                "</production>", "<left>", "</left>", "<right/>", "</structure>", "a ", "g(2)",
                "&lt;", "1 ", "#", "<", ">", "\xff");
        try {
            read_jflap(text, "x.jff");
        } catch (const Error&) {
        }
    }));
}

TEST_CASE("files of JFLAP 8 are cut into the symbols that they list") {
    const Model dragon = read_jflap(
        "<structure type=\"lsystem\">\n<structure type=\"axiom\"><axiom>gX</axiom></structure>\n"
        "<structure type=\"parameter_map\"><parameter><name>angle</name><value>45</value>"
        "</parameter></structure>\n<structure type=\"grammar\">"
        "<production><rhs>-gX++gY-</rhs><lhs>X</lhs></production>"
        "<production><rhs>+gX--gY+</rhs><lhs>Y</lhs></production>"
        "<production><rhs/><lhs>g</lhs></production></structure></structure>",
        "dragon.jff");
    const std::size_t lengths[] = {2, 8, 20, 44, 92, 188, 380};
    for (std::uint64_t n = 0; n <= 6; ++n) CHECK(derive(*as_d0l(dragon), n).size() == lengths[n]);
    CHECK(dragon.drawing.angle->value == 45);
    const Model hues = read_jflap(
        "<structure type=\"lsystem\"><axiom>R</axiom><structure type=\"grammar\">"
        "<terminals><symbol>##</symbol><symbol>#</symbol><symbol>g(2)</symbol></terminals>"
        "<production><lhs>R</lhs><rhs>###g(2)R</rhs></production></structure></structure>",
        "h.jff");
    CHECK(derive(*as_d0l(hues), 3).size() == 10);
    CHECK(said("<structure type=\"pda\"></structure>")
              .find("expected an L-system of JFLAP, found the type 'pda'") != std::string::npos);
}

TEST_CASE("automata and grammars of JFLAP become languages of claims") {
    const std::string automaton =
        "<structure><type>fa</type><automaton>"
        "<state id=\"0\" name=\"q0\"><initial/></state><state id=\"1\" "
        "name=\"q1\"><final/></state>"
        "<transition><from>0</from><to>1</to><read>a</read></transition>"
        "<transition><from>1</from><to>0</to><read/></transition>"
        "<transition><from>1</from><to>1</to><read>b</read></transition>"
        "</automaton></structure>";
    CHECK(converted(automaton, "x/odd.jff", "jff", "claim", {}) ==
          "claim The language of odd.jff\nlet A = regular { start Q_0; Q_0 -> a Q_1; Q_1 -> ε; "
          "Q_1 -> Q_0; Q_1 -> b Q_1 }\n");
    const auto is_true = [](const std::string& text, const std::string& show) {
        Claim claim = read_claim(text + show + "\n", "c",
                                 [](const std::string&) -> Model { throw Error("no system"); });
        return algae::check(std::move(claim), {}).statements.at(0).answer.truth == Truth::proved;
    };
    const std::string language = converted(automaton, "odd.jff", "jff", "claim", {});
    CHECK(is_true(language, "show A == /(ab*)+/"));
    const std::string grammar =
        "<structure><type>grammar</type><production><left>S</left><right>aSb</right></production>"
        "<production><left>S</left><right/></production></structure>";
    CHECK(is_true(converted(grammar, "g.jff", "jff", "claim", {}), "show aabb in A"));
    CHECK(said(automaton).find("found the type 'fa', which converts to a claim") !=
          std::string::npos);
    CHECK(refusal([] {
              converted(
                  "<structure><type>grammar</type><production><left>AB</left><right>c</right>"
                  "</production></structure>",
                  "g.jff", "jff", "claim", {});
          }).find("expected one letter on the left") != std::string::npos);
}

TEST_CASE("what stands in CDATA is text") {
    const Model system = read_jflap(
        file(
            "<axiom><![CDATA[g]]></axiom><production><left>g</left><right>g <![CDATA[+ g]]></right>"
            "</production>"),
        "x.jff");
    CHECK(system.axiom.letters.size() == 1);
    CHECK(system.rules[0].successor.letters.size() == 3);
    CHECK(said("<structure><type>lsystem</type><axiom><![CDATA[g</axiom></structure>")
              .find("<![CDATA[ is never closed") != std::string::npos);
}
