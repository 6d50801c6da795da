#include <doctest/doctest.h>
#include <rapidcheck.h>

#include "model/model.hpp"
#include "notation/notation.hpp"

using namespace algae;

namespace {

std::string typed(const std::string& text, const ConstantValues& replaced = {}) {
    return print_lsystem(read_typed_system(text, "typed", replaced));
}

/// The first line of what is said about a typed text, or "".
std::string fault(const std::string& text) {
    try {
        read_typed_system(text, "typed");
        return {};
    } catch (const Error& error) {
        const std::string all = error.what();
        return all.substr(0, all.find('\n'));
    }
}

std::string file_fault(const std::string& text) {
    try {
        read_lsystem(text, "x");
        return {};
    } catch (const Error& error) {
        const std::string all = error.what();
        return all.substr(0, all.find('\n'));
    }
}

Quantity number(const std::string& text) {
    return evaluate(read_expression(text), [](const std::string&) { return nullptr; });
}

}  // namespace

TEST_CASE("a system is typed on one line") {
    const std::string fibonacci = "axiom a\na -> ab\nb -> a\n";
    for (const char* text : {"a -> ab, b -> a", "a->ab,b->a", "a -> ab; b -> a", "a -> ab\nb -> a",
                             "axiom a, a -> ab, b -> a", "a -> ab , b -> a,axiom a", "a->ab b->a",
                             "a -> ab b -> a", "a → ab, b → a"}) {
        CAPTURE(text);
        CHECK(typed(text) == fibonacci);
    }
    CHECK(typed("0->01,1->10") == "axiom 0\n0 -> 01\n1 -> 10\n");
    CHECK(typed("axiom b; a -> ab, b -> a") == "axiom b\na -> ab\nb -> a\n");
    CHECK(typed("F -> F+F--F+F, angle 60, step 1/3") ==
          "axiom F\nF -> F+F--F+F\nangle 60\nstep 1/3\n");
    CHECK(typed("a -> ab, coding { a -> 0, b -> 1 }") ==
          "axiom a\na -> ab\ncoding { a -> 0; b -> 1 }\n");
    CHECK(typed("a -> aa | b, b -> c") == "axiom a\na -> aa\na -> b\nb -> c\n");
}

TEST_CASE("a comma separates only outside brackets and before a rule or a setting") {
    CHECK(typed("axiom A(1,2), A(x,y) : x < y -> A(x+1,y), B -> C") ==
          "axiom A(1,2)\nA(x,y) : x < y -> A(x+1,y)\nB -> C\n");
    // The modules of a context condition have commas between them.
    CHECK(typed("axiom AB(1)C(1,1), B(x) -> D, A ? B(y), C(r,z) : y < z -> E")
              .find("A ? B(y), C(r,z) : y < z -> E") != std::string::npos);
    CHECK(fault("a -> a,b") == "typed:1:7: error: expected a symbol, found ','");
    // In a file a comma separates nothing.
    CHECK(file_fault("axiom a; a -> ab, b -> a").find("x:1:17: error") == 0);
    CHECK(file_fault("axiom a; a -> ab b -> a") != "");
}

TEST_CASE("a typed system tells what is wrong at its place, and how it is said") {
    CHECK(fault("a -> ab]") == "typed:1:8: error: unmatched ']'");
    CHECK(fault("F -> F[+F, b -> a") == "typed:1:7: error: '[' is never closed");
    CHECK(fault("A(x) -> A(x+1)") ==
          "typed:1:1: error: expected an axiom, as the first rule has parameters, such as 'axiom "
          "A(1); ...'");
    CHECK(fault("b < a -> b") ==
          "typed:1:1: error: expected an axiom, as the first rule has a context, such as 'axiom "
          "aa; ...'");
    CHECK(fault("A -> I(B)") ==
          "typed:1:1: error: expected an axiom, as the first rule is one of shapes, such as 'axiom "
          "A(1,1,1); ...'");
    CHECK(fault("] -> 01, 1 -> 10") ==
          "typed:1:1: error: expected an axiom, as the first rule is of a bracket, such as 'axiom "
          "a; ...'");
    CHECK(fault("angle 60") ==
          "typed:1:9: error: expected an axiom, such as 'axiom a; a -> ab', found none");
    CHECK(fault("a -> ab, b = a") != "");
    CHECK(is_typed_system("a->b"));
    CHECK(is_typed_system("axiom a"));
    CHECK(is_typed_system("a → b"));
    for (const char* name : {"koch", "koch.lsys", "axiomatic", "a-", "a=b", "-"})
        CHECK(!is_typed_system(name));
}

TEST_CASE("constants get other values") {
    const std::string text = "let r = 1/2; let s = r*4; axiom A(s); A(x) -> A(x*r)";
    CHECK(typed(text, {{"r", number("3")}}) ==
          "let r = 3\nlet s = r*4\naxiom A(s)\nA(x) -> A(x*r)\n");
    CHECK(read_lsystem(text, "x", {{"r", number("3")}}).constants.at(1).second.exact ==
          Rational(12));
    const auto said = [&](const std::string& system, const char* name) {
        try {
            read_lsystem(system, "x", {{name, number("3")}});
            return std::string();
        } catch (const Error& error) {
            return std::string(error.what());
        }
    };
    CHECK(said(text, "q") == "x: has no constant 'q'; it has r and s");
    CHECK(said("axiom a; a -> b", "q") ==
          "x: has no constant 'q'; it has none: `let q = ...` in its text makes one");
}

TEST_CASE("a coding names a letter for each letter") {
    const Model word = read_lsystem("axiom a; a -> ab; b -> c; coding { a -> 0; b -> -1 }", "x");
    const LetterCoding coding(word.alphabet, word.coding);
    CHECK(spell(coding.alphabet, coding.morphism({0, 1, 0, 2})) == "0 -1 0c");
    CHECK(format_lsystem("coding {a->0\nb->1}\naxiom a # the first\na -> ab", "x") ==
          "axiom a # the first\na -> ab\ncoding { a -> 0; b -> 1 }\n");
    const std::pair<const char*, const char*> all[] = {
        {"coding { a -> 00 }",
         "x:1:37: error: expected one letter as the image of 'a', found '00'"},
        {"coding { a -> }", "expected one letter as the image of 'a', found none"},
        {"coding { c -> 0 }", "x:1:32: error: expected a letter of the system, found 'c'"},
        {"coding { a -> 0; a -> 1 }", "the letter 'a' has an image already"},
        {"coding { a 0 }", "expected a letter and its image, such as a -> 0, found 'a 0'"},
        {"coding { a -> 0", "'{' is never closed"},
        {"coding a -> 0", "expected '{' after 'coding'"},
        {"coding { a -> 0 }; coding { b -> 0 }", "'coding' is given twice"},
        {"A(x) -> b; coding { a -> 0 }",
         "expected a system without parameters and shape rules in a file with a coding"},
    };
    for (const auto& [text, message] : all) {
        CAPTURE(text);
        CHECK(file_fault("axiom a; a -> ab    ; " + std::string(text)).find(message) !=
              std::string::npos);
    }
}

TEST_CASE("rules that are typed in any way are the same system, and no text does harm") {
    std::size_t compared = 0;
    CHECK(rc::check("separators", [&] {
        const int count = *rc::gen::inRange(1, 5);
        std::string line, file;
        for (int i = 0; i < count; ++i) {
            std::string word;
            for (int length = *rc::gen::inRange(0, 5); length > 0; --length)
                word += *rc::gen::element<std::string>("a", "b", "F", "+", "[F]", "-");
            const std::string letter(1, static_cast<char>('a' + i)),
                rule = letter + *rc::gen::element<std::string>("->", " -> ", " ->", " → ") +
                       (word.empty() ? "ε" : word);
            line += (i ? *rc::gen::element<std::string>(",", ", ", ";", " ; ", "\n", " , ") : "") +
                    rule;
            file += rule + "\n";
        }
        const Model typed_system = read_typed_system(line, "x");
        RC_ASSERT(typed_system == read_lsystem("axiom a\n" + file, "x"));
        RC_ASSERT(read_lsystem(print_lsystem(typed_system), "x") == typed_system);
        ++compared;
    }));
    CHECK(compared >= 90);
    CHECK(rc::check("any text", [] {
        std::string text;
        for (int length = *rc::gen::inRange(0, 40); length > 0; --length)
            text += *rc::gen::element<std::string>("a", "->", ",", " ", ";", "(", ")", "[", "]",
                                                   "{", "}", "?", ":", "coding", "axiom ",
                                                   "system ", "x", "\n", "<", "let k=1", "\xff");
        try {
            const Model system = read_typed_system(text, "x");
            RC_ASSERT(read_lsystem(print_lsystem(system), "x") == system);
        } catch (const Error&) {
        }
    }));
    // Long lines of commas and blanks take linear time.
    for (const char* piece : {",", " ,", "a ", "? ,", "a->b,", "->,"}) {
        std::string text = "a -> b";
        for (int i = 0; i < 20'000; ++i) text += piece;
        fault(text);
    }
}
