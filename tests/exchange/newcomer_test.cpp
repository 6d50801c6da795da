#include <doctest/doctest.h>

#include "exchange/compared.hpp"
#include "exchange/exchange.hpp"
#include "model/model.hpp"

// What somebody types who has not used a format before: another program's arrow, a colon that is missing, degrees where parts of a turn are
// meant. Each message says what is right.

using namespace algae;
using namespace algae::exchange_tests;

TEST_CASE("wrong inputs of newcomers are refused with their place and with what is right") {
    struct Case {
        const char *format, *text, *message;
    };
    const Case all[] = {
        {"l", "K {\nAngle 6\nAxiom F\nF -> F+F\n}\n",
         "x.l:4:3: error: expected a rule such as F=F+F, found '->'"},
        {"l", "K {\nAngle 60\nAxiom F\nF=F+F\n}\n",
         "x.l:2:7: error: expected an angle from 3 to 50, the parts of a full turn, found '60'; 60 "
         "degrees are 'Angle 6'"},
        {"l", "K {\nAngle 6\nAxiom: F\nF=F+F\n}\n",
         "x.l:3:1: error: expected 'Axiom', 'Angle', '}' or a rule for one symbol, found 'axiom:'; "
         "did you mean 'axiom'?"},
        {"l", "K {\nAngle 6\nF=F+F\n}\n", "x.l:1:1: error: expected an axiom in 'K', found none"},
        {"cpfg", "Lsystem: 1\nderivation length 3\nAxiom: F\nF --> FF\nendlsystem\n",
         "x.cpfg:2:1: error: expected 'Axiom:' or a line of the header, such as 'derivation "
         "length: "
         "3' or 'ignore: +-', found 'derivation length 3'; did you mean 'derivation length'?"},
        {"cpfg", "Lsystem: 1\nangle: 30\nAxiom: F\nF --> FF\nendlsystem\n",
         "found 'angle: 30'; angles stand in a view file, `angle increment: 30`, or behind "
         "symbols, "
         "+(30)"},
        {"cpfg", "Lsystem: 1\nAxiom: F\nF -> FF\nendlsystem\n",
         "x.cpfg:3:1: error: expected a rule with '-->', found 'F -> FF'"},
        {"cpfg", "Lsystem: 1\nderivation length: 1\n\nF --> FF\nendlsystem\n",
         "x.cpfg:4:1: error: expected 'Axiom:' or a line of the header"},
        {"lpy", "axiom = \"F\"\nproduction:\nF --> F+F\nendlsystem\n",
         "x.lpy:1:1: error: expected a line `Axiom: F`, found none"},
        {"lpy", "Axiom: F\nproduction:\nF -> F+F\n",
         "x.lpy:3:1: error: a line of Python is not read: expected `NAME = number` or a rule with "
         "-->; found 'F -> F+F'"},
        {"jff", "F -> F+F\n",
         "x.jff:1:1: error: expected an element of XML, such as <structure>, found 'F -> F+F'"},
        {"jff", "<structure><type>pda</type></structure>",
         "x.jff:1:12: error: expected an L-system of JFLAP, found the type 'pda'"},
        {"inkscape", "axiom = F\nrule = F=F+F\n", "x.inkscape:2:1: error: expected a line such as"},
        {"tikz", "\\pgfdeclarelindenmayersystem{k}{\\rule{F=F+F}}\n",
         "error: expected a rule with '->', found 'F=F+F'"},
        {"sage", "WordMorphism('a -> ab, b -> a')\n",
         "x.sage:1:15: error: expected '->' behind the first character, as in a->ab without "
         "blanks"},
        {"walnut", "0 -> 01\n1 > 10\n",
         "x.walnut:2:3: error: expected '->' behind the letter 1, found '>'"},
        {"walnut", "a -> ab\nb -> a\n",
         "x.walnut:1:1: error: expected a number as a letter, found 'a'"},
        {"netlogo", "add-rule \"F\" \"F+F\" \"F\"\n",
         "expected 'set' for chain, d, delta, k-shorten, found the end of the file"},
        {"maple", "lsystem(\"F\",[\"F\",\"F+F\"],60,3);\n",
         "expected an assignment, restart, with(...) or a call Lsystem(...), found 'lsystem'"},
        {"brno", "modules: F=P(1);\naxiom: F;\nangles: U=22.5;\nrules: F -> F+F;\nEND\n",
         "x.brno:3:11: error: expected a whole number of degrees, found '22.5'"},
    };
    for (const Case& one : all) {
        CAPTURE(one.text);
        const std::string file = std::string("x.") + one.format;
        const std::string said = refusal([&] { system_format(file)->read(one.text, file); });
        CAPTURE(said);
        CHECK(said.find(one.message) != std::string::npos);
    }
    // A program of L+C says its axiom with a semicolon.
    CHECK(refusal([] {
              system_format("x.l")->read("module A(float);\n", "x.l");
          }).find("expected a line `Axiom: F(1);`, found none") != std::string::npos);
}
