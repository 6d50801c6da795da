#include <doctest/doctest.h>
#include <rapidcheck.h>

#include "exchange/compared.hpp"
#include "exchange/detail/formats.hpp"
#include "exchange/exchange.hpp"
#include "exchange/inputs.hpp"
#include "model/model.hpp"
#include "notation/notation.hpp"

using namespace algae;
using namespace algae::exchange_tests;

namespace {

std::string walnut(const std::string& text) { return print_lsystem(read_walnut(text, "x.walnut")); }
std::string sage(const std::string& text) { return print_lsystem(read_sage(text, "x.sage")); }
std::string walnut_fault(const std::string& text) {
    return refusal([&] { read_walnut(text, "x.walnut"); });
}
std::string sage_fault(const std::string& text) {
    return refusal([&] { read_sage(text, "x.sage"); });
}

/// The letters of generation n as the coding has them, by names with blanks.
std::string coded_word(const Model& system, std::uint64_t n) {
    const LetterCoding coding(system.alphabet, system.coding);
    std::string out;
    for (const Symbol a : coding.morphism(derive(*as_d0l(system), n)))
        out += coding.alphabet.name(a) + " ";
    return out;
}

}  // namespace

TEST_CASE("a word automaton of Walnut is its morphism of states and a coding") {
    // The parity of the number of 11 in the binary digits, counted here.
    const Model word = read_walnut(
        "# Rudin-Shapiro.\nmsd_2\n0 0\n0 -> 0\n1 -> 1\n1 0\n0 -> 0\n1 -> 2\n2 1\n0 -> 3\n1 -> 1\n3 "
        "1\n0 -> 3\n1 -> 2\n",
        "rs.txt");
    CHECK(word.title == "Rudin-Shapiro");
    std::string expected;
    for (unsigned n = 0; n < 256; ++n) {
        unsigned pairs = 0;
        for (unsigned rest = n; rest > 0; rest >>= 1) pairs += (rest & 3) == 3 ? 1 : 0;
        expected += std::to_string(pairs % 2) + " ";
    }
    CHECK(coded_word(word, 8) == expected);
    CHECK(walnut("msd_2\n0 0\n0 -> 0\n1 -> 1\n1 1\n0 -> 1\n1 -> 0\n") ==
          "axiom 0\n0 -> 01\n1 -> 10\n");
    CHECK(walnut("3\n0 -1\n* -> 0\n") == "axiom 0\n0 -> 000\ncoding { 0 -> -1 }\n");
    // Numbers without two ones in a row: a state has one image letter where no one may follow.
    CHECK(walnut("msd_fib\n0 0\n0 -> 0\n1 -> 1\n1 1\n0 -> 0\n") == "axiom 0\n0 -> 01\n1 -> 0\n");
    CHECK(walnut("msd_trib\n0 0\n0 -> 0\n1 -> 1\n1 1\n0 -> 0\n1 -> 2\n2 2\n0 -> 0\n") ==
          "axiom 0\n0 -> 01\n1 -> 02\n2 -> 0\n");
    // The sum of digits in the numeration of Fibonacci, modulo 2: a state comes with and without a one before.
    const Model sum = read_walnut("msd_fib\n0 0\n0 -> 0\n1 -> 1\n1 1\n0 -> 1\n1 -> 0\n", "x");
    std::string digits;
    for (unsigned n = 0; n < 34; ++n) {
        unsigned parity = 0, rest = n;
        for (const unsigned f : {21U, 13U, 8U, 5U, 3U, 2U, 1U})
            if (rest >= f) {
                rest -= f;
                parity ^= 1;
            }
        digits += std::to_string(parity) + " ";
    }
    CHECK(coded_word(sum, 7) == digits);
}

TEST_CASE("a morphism of Walnut, with letters of several digits in brackets") {
    CHECK(walnut("0 -> 01\n1 -> 10\n") == "axiom 0\n0 -> 01\n1 -> 10\n");
    CHECK(walnut("morphism h \"0->01, 1->2 2->0\";\n") == "axiom 0\n0 -> 01\n1 -> 2\n2 -> 0\n");
    const Model big = read_walnut("0 -> 0[10]\n[10] -> [-1]1\n", "x");
    CHECK(coded_word(big, 2) == "0 10 -1 1 ");
}

TEST_CASE("a Walnut morphism with an open quotation mark or none is refused") {
    CHECK(walnut_fault("morphism h \"0->01 1->10").find("the quotation mark is never closed") !=
          std::string::npos);
    CHECK(walnut_fault("morphism h 0->01 1->10").find("expected the images between quotation") !=
          std::string::npos);
}

TEST_CASE("what of Walnut says no morphism is refused with its place") {
    const std::pair<const char*, const char*> all[] = {
        {"lsd_2\n0 0\n", "x.walnut:1:1: error: the number system 'lsd_2' has the last digit first"},
        {"msd_pell\n0 0\n", "x.walnut:1:1: error: the number system 'msd_pell' is not known here"},
        {"msd_2 msd_2\n0 0\n", "x.walnut:1:1: error: expected one number system"},
        {"msd_1\n0 0\n", "has no base from 2 to 1000"},
        {"msd_2\n0 0\n0 -> 0\n",
         "x.walnut:2:1: error: the state 0 has no transition for the digit 1"},
        {"msd_2\n0 0\n0 -> 0\n1 -> 1\n",
         "x.walnut:2:1: error: the state 0 goes to the state 1, which is not given"},
        {"msd_2\n0 0\n0 -> 1\n1 -> 1\n1 0\n* -> 1\n",
         "x.walnut:2:1: error: the first state 0 must go to itself by the digit 0"},
        {"msd_2\n0 0\n0 -> 0\n0 -> 0\n",
         "x.walnut:4:1: error: the state 0 has a transition for 0 already"},
        {"msd_2\n0 0\n2 -> 0\n", "x.walnut:3:1: error: expected a digit from 0 to 1, found 2"},
        {"msd_2\n0 0\n* 0 -> 0\n", "x.walnut:3:1: error: expected one digit before the arrow"},
        {"msd_2\n0 0\n0 -> 0 1\n", "x.walnut:3:1: error: expected one state behind the arrow"},
        {"msd_2\n0 0\n0 0\n", "x.walnut:3:1: error: the state 0 is given twice"},
        {"msd_2\nnone\n", "x.walnut:2:1: error: expected a state and its output"},
        {"msd_2\n", "expected a state and its output"},
        {"0 -> 01\n0 -> 1\n", "x.walnut:2:1: error: the letter 0 has an image already"},
        {"0 -> 0[1\n", "x.walnut:1:9: error: expected ']' behind the number"},
        {"a -> 01\n", "x.walnut:1:1: error: expected a number as a letter, found 'a'"},
        {"", "expected a morphism or a word automaton"},
    };
    for (const auto& [text, message] : all) {
        CAPTURE(text);
        CHECK(walnut_fault(text).find(message) != std::string::npos);
    }
    CHECK(system_format_of("# T\nmsd_2\n0 0\n* -> 0\n")->name == "walnut");
}

TEST_CASE("a WordMorphism of Sage") {
    CHECK(sage("WordMorphism('a->ab,b->a')") == "axiom a\na -> ab\nb -> a\n");
    CHECK(sage("a->ab,b->") == "axiom a\na -> ab\nb -> ε\n");
    CHECK(sage("m = WordMorphism(\"F->F+F--F+F,+->+,-->-\")\nm('F--F--F', 4)\n") ==
          "axiom F--F--F\nF -> F+F--F+F\n+ -> +\n- -> -\n");
    CHECK(sage("m = WordMorphism('a->ab,b->a'); m.fixed_point('a')") ==
          "axiom a\na -> ab\nb -> a\n");
    const std::pair<const char*, const char*> all[] = {
        {"WordMorphism('a->ab, b->a')",
         "x.sage:1:21: error: expected '->' behind the first character"},
        {"WordMorphism('a -> ab')", "x.sage:1:15: error: expected '->' behind the first character"},
        {"WordMorphism('a->b,a->c')", "x.sage:1:20: error: the letter 'a' is defined twice"},
        {"WordMorphism('F->F+F--F+F')",
         "the letter '+' has no image, so the morphism cannot be iterated; '+->+' keeps it"},
        {"WordMorphism('a->a b')", "x.sage:1:19: error: a blank is a letter in an image"},
        {"WordMorphism('a->a(')", "'(' is no letter of the notation"},
        {"WordMorphism('a->ab,b->a", "the quotation mark is never closed"},
        {"WordMorphism(3)", "expected a morphism between quotation marks"},
        {"m('a')", "expected WordMorphism('a->ab,b->a')"},
        {"WordMorphism('a->ab,b->a')\nm('c', 3)", "x.sage:2:4: error: the letter 'c' has no image"},
        {"WordMorphism('')", "expected a letter and its image, such as a->ab"},
    };
    for (const auto& [text, message] : all) {
        CAPTURE(text);
        CHECK(sage_fault(text).find(message) != std::string::npos);
    }
}

TEST_CASE("brackets that a morphism of Sage keeps are those of the notation") {
    const std::string text = "m = WordMorphism('F->F[+F]F,[->[,+->+,]->]')\nm('F', 2)\n";
    const Model plant = read_sage(text, "x.sage");
    CHECK(word_of(plant, 1) == "F [ + F ] F ");
    CHECK(read_sage(print_sage(plant), "x.sage") == plant);
    const auto fault = [](const std::string& morphism) {
        return refusal([&] { read_sage("m = WordMorphism('" + morphism + "')\n", "x.sage"); });
    };
    const std::string said = fault("a->[b,b->b,[->[");
    INFO(said);
    CHECK(said.starts_with("x.sage: the notation cannot say this system: "));
}

TEST_CASE("systems are written as morphisms, and what those cannot say is refused") {
    CHECK(print_walnut(of_gallery("thue-morse")) ==
          "# Thue-Morse word\nmsd_2\n\n0 0\n0 -> 0\n1 -> 1\n\n1 1\n0 -> 1\n1 -> 0\n");
    CHECK(print_walnut(of_gallery("tribonacci")) ==
          "# Tribonacci word\n0 -> 01\n1 -> 02\n2 -> 0\n");
    CHECK(print_walnut(of_gallery("pell")) ==
          "# Pell word\n# 0 is a\n# 1 is b\n0 -> 001\n1 -> 0\n");
    CHECK(print_sage(of_gallery("pell")) ==
          "# Pell word\nm = WordMorphism('a->aab,b->a')\nm('a', 5)\n");
    CHECK(print_sage(of_gallery("rudin-shapiro")) ==
          "# Rudin-Shapiro word\nm = WordMorphism('a->ab,b->ac,c->db,d->dc')\nc = "
          "WordMorphism('a->0,b->0,c->1,d->1')\nc(m('a', 5))\n");
    CHECK(print_sage(read_lsystem("axiom F; F -> F+F--F+F", "")) ==
          "m = WordMorphism('F->F+F--F+F,+->+,-->-')\nm('F', 5)\n");
    const auto unsaid = [](const std::string& text, auto print) {
        return refusal([&] { print(read_lsystem(text, "x")); });
    };
    CHECK(unsaid("axiom ab; a -> ab", print_walnut).find("an axiom of 2 letters") !=
          std::string::npos);
    CHECK(unsaid("axiom a; a -> ab; coding { a -> 0; b -> 1 }", print_walnut)
              .find("a coding of a morphism that is not uniform") != std::string::npos);
    CHECK(unsaid("axiom a; a -> a | aa", print_sage).find("it is the second for its letter") !=
          std::string::npos);
    CHECK(unsaid("axiom F_l; F_l -> F_lF_l", print_sage)
              .find("the letter F_l: its letters are single characters") != std::string::npos);
    // Sage begins with the first letter then.
    CHECK(unsaid("axiom ε; a -> ab", print_sage).find("an empty axiom") != std::string::npos);
}

TEST_CASE("morphisms come back from Walnut and Sage with the same words") {
    std::size_t automata = 0, morphisms = 0;
    CHECK(rc::check("random morphisms", [&] {
        const int letters = *rc::gen::inRange(1, 5);
        const int fixed = *rc::gen::inRange(0, 4);  // the length of all images; 0 and 1 are any
        std::string text = "axiom 0";
        for (int a = 0; a < letters; ++a) {
            text += "; " + std::to_string(a) + " -> ";
            const int length = fixed > 1 ? fixed : *rc::gen::inRange(1, 4);
            for (int i = 0; i < length; ++i)
                text += a == 0 && i == 0 ? "0" : std::to_string(*rc::gen::inRange(0, letters));
        }
        if (fixed > 1 && *rc::gen::inRange(0, 2)) {
            text += "; coding {";
            for (int a = 0; a < letters; ++a)
                text += " " + std::to_string(a) + " -> " + std::to_string(*rc::gen::inRange(0, 2)) +
                        ";";
            text += " }";
        }
        RC_LOG(text);
        // Letters that no word has are in no file.
        const Model system = read_lsystem(text, "x");
        const Model by_walnut = read_walnut(print_walnut(system), "x.walnut"),
                    by_sage = read_sage(print_sage(system), "x.sage");
        for (std::uint64_t n = 0; n <= 4; ++n) {
            RC_ASSERT(coded_word(by_walnut, n) == coded_word(system, n));
            RC_ASSERT(coded_word(by_sage, n) == coded_word(system, n));
        }
        ++(fixed > 1 ? automata : morphisms);
    }));
    CHECK(automata >= 6);
    CHECK(morphisms >= 20);
    CHECK(rc::check("any text", [] {
        std::string text;
        const int length = *rc::gen::inRange(0, 40);
        for (int i = 0; i < length; ++i)
            text += *rc::gen::element<std::string>(
                "msd_2\n", "0 0\n", "0 -> 0\n", "1 -> 1\n", "* -> 0\n", "[", "]", "-1", "->", ",",
                "WordMorphism('", "a->ab", "'", ")", "\n", " ", "99999999999", "(\"", "\xff");
        for (const auto read : {read_walnut, read_sage}) try {
                read(text, "x");
            } catch (const Error&) {
            }
    }));
}

TEST_CASE("comments of Sage say nothing, and powers and products of morphisms are refused") {
    CHECK(sage("m = WordMorphism('a->ab,b->a') # not WordMorphism('a->b,b->a')\n") ==
          "axiom a\na -> ab\nb -> a\n");
    CHECK(
        sage(
            "from sage.all import *\n# WordMorphism('x->y,y->x')\nm = WordMorphism('a->ab,b->a')\n")
            .starts_with("axiom a\na -> ab\n"));
    for (const char* other : {"WordMorphism('a->ab,b->a')^2", "WordMorphism('a->ab,b->a')**3",
                              "m = WordMorphism('a->ab,b->a')\nn = m*m\nn('a', 2)",
                              "m = WordMorphism('a->ab,b->a').reversal()"}) {
        INFO(other);
        CHECK(sage_fault(other).find("not computed here; expected WordMorphism('a->ab,b->a')") !=
              std::string::npos);
    }
}
