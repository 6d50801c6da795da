#include <doctest/doctest.h>

#include "notation/claim_said.hpp"

using namespace algae;

TEST_CASE("findings about claims stand at their places") {
    CHECK(claim_findings("let G = PD0L { axiom a  # start\n  a -> ε\n}\nshow {a is 0L") ==
          "x.claim:2:9: error: G is called a PD0L system, but the rule at x.claim:3:3 is erasing\n"
          "  let G = PD0L { axiom a  # start\n"
          "          ^\n"
          "x.claim:5:6: error: '{' is never closed\n"
          "  show {a is 0L\n"
          "       ^");
    CHECK(claim_messages("let J = D0L {\n  axim a; a -> aa\n}") ==
          "3:3: expected a setting or a rule with '->', found 'axim'; did you mean 'axiom'?\n"
          "4:1: expected an axiom in the system, found none");
}

TEST_CASE("titles and texts") {
    const auto said = [](const std::string& text) {
        try {
            read_claim(text, "x.claim", {});
        } catch (const Diagnostics& error) {
            return error.findings()[0].message;
        }
        return std::string();
    };
    CHECK(said("show {a} is 0L") ==
          "expected a title, 'claim TEXT', before the end of the file, found none");
    CHECK(said("claim") == "expected a text after 'claim', found the end of the line");
    CHECK(said("claim A\nclaim B") == "'claim' is given twice, first in line 1");
    CHECK(said("claim A\nsource B;source C") == "'source' is given twice, first in line 2");
    CHECK(said("claim A\nshwo A") ==
          "expected claim, source, note, alphabet, allow, let, theorem, show, lemma, refute or "
          "closed, found "
          "'shwo'; did you "
          "mean 'show'?");
    CHECK(said("claim A\nallow empty axioms") ==
          "expected 'allow empty axiom', found 'allow empty axioms'");
    CHECK(said("claim A\nallow") == "expected 'allow empty axiom', found 'allow'");
    CHECK(said("claim \xFF") == "expected UTF-8, found the byte 0xFF");
}

TEST_CASE("names") {
    CHECK(claim_messages("let A = {a}\nlet A = {b}") ==
          "3:5: 'A' is defined twice, first in line 2");
    CHECK(claim_messages("let in = {a}") ==
          "2:5: expected another name, 'in' has a meaning in claims");
    CHECK(claim_messages("let D0L = {a}") ==
          "2:5: expected another name, 'D0L' has a meaning in claims");
    CHECK(claim_messages("let = {a}") == "2:5: expected a name after 'let', found '='");
    CHECK(claim_messages("let A {a}") == "2:7: expected '=', found '{'");
    CHECK(claim_messages("let A =") ==
          "2:8: expected a language, a system or a morphism after '=', found the end of the line");
    CHECK(claim_messages("let A = A | {b}") == "2:9: 'A' stands in its own definition");
    CHECK(claim_messages("show A is 0L\nlet A = {a}") ==
          "2:6: expected a name that is defined above, found 'A', which is defined in line 3");
    CHECK(
        claim_messages("let Fibonacci = {a}\nshow Fibonaci is 0L") ==
        "3:6: expected a name that is defined above, found 'Fibonaci'; did you mean 'Fibonacci'?");
    CHECK(claim_messages("show aab is 0L") ==
          "2:6: expected a name that is defined above, found 'aab'; the language of one word is "
          "written {aab}");
    CHECK(claim_messages("show h({a}) is 0L") ==
          "2:6: expected a name that is defined above, found 'h'");
    // What depends on a faulty definition is not a finding of its own.
    CHECK(claim_messages("let A = {a,,}\nlet B = A {b}\nshow B is 0L") ==
          "2:12: expected a word (the empty word is ε), found ','");
}

TEST_CASE("languages, systems and morphisms are told apart") {
    const std::string names = "let A = {a}\nlet G = 0L { axiom b; b -> a }\nlet h = { a -> a }\n";
    CHECK(claim_messages(names + "show G is 0L") ==
          "5:6: expected a language, found the system 'G'; its language is L(G)");
    CHECK(claim_messages(names + "show L(A) is 0L") ==
          "5:8: expected a system, found 'A', a language");
    CHECK(claim_messages(names + "show L(h) is 0L") ==
          "5:8: expected a system, found 'h', a morphism");
    CHECK(claim_messages(names + "show growth(A) == growth(G)") ==
          "5:13: expected a system, found 'A', a language");
    CHECK(claim_messages(names + "show h is 0L") ==
          "5:8: expected '(' and a language after a morphism, found 'is'");
    CHECK(claim_messages(names + "show h^2(A) is 0L") ==
          "5:8: expected -1 after '^' (the inverse of a morphism), found '2'");
    CHECK(
        claim_messages(names + "show h(L(G)) is 0L") ==
        "5:6: expected a morphism with an image for each letter of the language, found none for b");
}

TEST_CASE("expressions") {
    CHECK(claim_messages("show ({a} is 0L") == "2:11: expected an operator or ')', found 'is'");
    CHECK(claim_messages("show {a} | is 0L") == "2:12: expected a language, found 'is'");
    CHECK(claim_messages("show {a}^S is 0L") == "2:10: expected R after '^' (reversal), found 'S'");
    CHECK(claim_messages("show {a;b} is 0L") == "2:8: expected a symbol, found ';'");
    CHECK(claim_messages("show {a#b} is 0L") ==
          "2:8: expected a symbol, found '#'; a comment needs a blank before");
    CHECK(
        claim_messages("show ~{} is 0L") ==
        "2:6: expected letters for the words of a complement, found none; 'alphabet a b' says what "
        "letters there are");
    CHECK(claim_messages("alphabet a\nshow ~{b} is 0L") == "");
    CHECK(
        claim_messages("let h = { a -> a }\nlet A = h(~{a})\nshow b in {b}") ==
        "3:9: expected a morphism with an image for each letter of the language, found none for b");
    CHECK(claim_messages("let h = { a -> b; a -> c }") == "2:19: the letter 'a' has two images");
    CHECK(claim_messages("let h = { ab -> b }") ==
          "2:11: expected one letter before the arrow, found 'ab'");
    CHECK(claim_messages("alphabet a{") == "2:11: expected names without '{'");
    CHECK(claim_messages("alphabet") ==
          "2:9: expected letters after 'alphabet', found the end of the line");
}

TEST_CASE("regular expressions") {
    CHECK(claim_messages("show /a is 0L") == "2:6: '/' is never closed");
    CHECK(claim_messages("show /a(b/ is 0L") ==
          "2:10: expected a letter, an operator or ')', found '/'");
    CHECK(claim_messages("show /a)/ is 0L") ==
          "2:8: expected a letter, an operator or '/', found ')'");
    CHECK(claim_messages("show // is 0L") ==
          "2:7: expected a letter or '(' (the empty word is ε), found '/'");
    CHECK(claim_messages("show /[ab]/ is 0L") ==
          "2:7: expected a letter, found '[', which has no meaning between slashes");
}

TEST_CASE("families") {
    CHECK(claim_messages("let G = DOL { axiom a; a -> aa }") ==
          "2:9: expected a family of systems (0L, PD0L, ET0L, IL, ...), found 'DOL'; did you mean "
          "'D0L'?");
    CHECK(claim_messages("let G = D0L { axiom a; a -> b; a -> c }") ==
          "2:9: G is called a D0L system, but the rule at x.claim:2:32 is a second one for a");
    CHECK(claim_messages("let G = 0L { axiom S; S -> a; terminals a }") ==
          "2:9: G is called a 0L system, but its letter S is no terminal");
    CHECK(claim_messages("let G = 0L { axiom a; table x; a -> a; table y; a -> b }") ==
          "2:9: G is called a 0L system, but it has several tables");
    CHECK(claim_messages("let G = 1L { axiom a; a < a > a -> b }") ==
          "2:9: G is called a 1L system, but its contexts are up to 1 on the left and 1 on the "
          "right");
    CHECK(claim_messages("let G = D0L fibonaci") ==
          "2:13: no file \"fibonaci\", and nothing of that name in the gallery");
    CHECK(claim_messages("show {a} is P00L") ==
          "2:13: expected a family (0L, PD0L, ET0L, regular, ...), finite, infinite, empty, a code "
          "or "
          "a prefix code, "
          "found 'P00L'; did "
          "you mean 'P0L'?");
}

TEST_CASE("statements") {
    const std::string names = "let A = {a}\nlet N = 0L { axiom a; a -> b }\n";
    CHECK(claim_messages("show") == "2:5: expected a statement, found the end of the line");
    CHECK(claim_messages(names + "show A") ==
          "4:7: expected an operator, 'is', '==', '!=' or '<=', found the end of the line");
    CHECK(claim_messages(names + "show A = A") ==
          "4:8: expected an operator, 'is', '==', '!=' or '<=', found '='");
    CHECK(claim_messages(names + "show A is 0L now") ==
          "4:14: expected the end of the statement, found 'now'");
    CHECK(claim_messages(names + "show A is 0L by") ==
          "4:16: expected a citation after 'by', found the end of the line");
    CHECK(claim_messages(names + "show in A") ==
          "4:6: expected a word (the empty word is ε), found 'in'");
    CHECK(claim_messages(names + "show |A| = x") == "4:12: expected a number of words, found 'x'");
    CHECK(claim_messages(names + "show N ==> a in b steps") ==
          "4:17: expected numbers that 'for all numbers ...' binds, found 'b'");
    CHECK(claim_messages(names + "show N ==> a in -3 steps") ==
          "4:17: expected a whole number of steps from 0 to 2^64 - 1, found '-3'");
    CHECK(claim_messages(names + "show N ==> a in 1/0 steps") == "4:17: division by 0 in '1/0'");
    CHECK(claim_messages(names + "show N ==> a in 2") ==
          "4:18: expected 'steps', found the end of the line");
    CHECK(claim_messages(names + "show growth(N) = m") ==
          "4:18: expected n, the number of the generation, found 'm'");
    CHECK(claim_messages(names + "show growth(N) = growth(N)") ==
          "4:18: expected '==' before another growth, found '='");
    CHECK(claim_messages(names + "show growth(N) ~ linear") ==
          "4:18: expected zero, bounded, polynomial or exponential, found 'linear'");
    CHECK(claim_messages(names + "show not A is not 0L") ==
          "4:10: expected at most one negation, found a second behind 'not'");
    CHECK(claim_messages("closed under union D0L")
              .starts_with("2:14: expected an operation (union, "));
    CHECK(claim_messages("closed under union: D0L D0L") ==
          "2:25: the family D0L stands there twice");
    CHECK(claim_messages("closed under union: XL")
              .starts_with("2:21: expected a family of the table (REG, "));
}

TEST_CASE("statements about infinite words and their factors") {
    const std::string names =
        "let f = D0L { axiom a; a -> ab; b -> a }\nlet A = {a}\n"
        "let N = 0L { axiom a; a -> b; a -> a }\nlet g = D0L { axiom c; c -> cd; d -> dc; e -> e "
        "}\n";
    const auto told = [&](const std::string& text) {
        return claim_messages(names + "show " + text);
    };
    const std::string properties =
        "balanced, circular, 7/3-power-free, 7/3+-power-free, square-free, overlap-free, "
        "cube-free, "
        "aperiodic, recurrent, uniformly recurrent, closed under reversal or rich";
    CHECK(told("f is overlap-fee") ==
          "6:11: expected a property of the infinite word of f (" + properties +
              "), found 'overlap-fee'; did you mean 'overlap-free'?; of its language, write L(f)");
    CHECK(told("N is rich") ==
          "6:6: expected a D0L system, whose words may begin one infinite word, found 'N'");
    CHECK(told("f is 1-power-free") == "6:11: expected an exponent above 1, which all words have");
    CHECK(told("f is 7/0+-power-free") == "6:11: expected a property of the infinite word of f (" +
                                              properties +
                                              "), found '7/0+-power-free'; did you mean "
                                              "'7/3+-power-free'?; of its language, write L(f)");
    CHECK(told("f is 7/x-power-free") == "6:11: expected a property of the infinite word of f (" +
                                             properties +
                                             "), found '7/x-power-free'; did you mean "
                                             "'7/3-power-free'?; of its language, write L(f)");
    CHECK(told("g is balanced") ==
          "6:11: 'balanced' is said of words over two letters, and g has 3");
    CHECK(told("N is circular") ==
          "6:6: expected a D0L system, whose words may begin one infinite word, found 'N'");
    CHECK(told("critical_exponent(A) = 2") == "6:24: expected a system, found 'A', a language");
    CHECK(told("critical_exponent f = 2") ==
          "6:24: expected '(' after 'critical_exponent', found 'f'");
    CHECK(told("critical_exponent() = 2") == "6:24: expected the name of a system, found ')'");
    CHECK(told("critical_exponent(f = 2") == "6:26: expected ')', found '='");
    CHECK(told("critical_exponent(f) ~ 2") ==
          "6:27: expected '=', '!=', '<', '<=', '>' or '>=', found '~'");
    CHECK(told("critical_exponent(f) =") ==
          "6:28: expected a number, 'sqrt' or '(', found the end of the line");
    CHECK(told("critical_exponent(f) < 2 sqrt 3") ==
          "6:31: expected an operator or the end of the statement, found 'sqrt'");
    CHECK(told("critical_exponent(f) < sqrt 2 + sqrt 3") ==
          "6:36: expected roots of one number, found roots of 2 and 3");
    CHECK(told("critical_exponent(f) < the largest real root of x^2 + 1") ==
          "6:29: expected a polynomial with a real root, found x^2 + 1");
    CHECK(told("critical_exponent(f) < the largest real root of 3") ==
          "6:54: expected a polynomial in x, found 3");
    CHECK(told("ab in factors(A)") == "6:20: expected a system, found 'A', a language");
    CHECK(told("ab in factors(f") == "6:21: expected ')', found the end of the line");
    CHECK(told("complexity(f, n) > n") == "6:23: expected '+', '-', '=' or '!=', found '>'");
    CHECK(told("complexity(f, n) = complexity(g, n)") ==
          "6:36: expected one system in a statement on complexities, 'f', found 'g'");
    CHECK(told("complexity(f, m) = n + 1") ==
          "6:25: expected one number, 'm', found 'n' beside it");
    CHECK(told("complexity(f, n - 1) = n") == "6:22: expected '+' or ')', found '-'");
    CHECK(told("complexity(f) = n") == "6:18: expected ',' and a length, found ')'");
    CHECK(told("complexity(A, n) = n") == "6:17: expected a system, found 'A', a language");
    CHECK(told("complexity(f, n) = 2 *") ==
          "6:28: expected a number, a name of one, or complexity(...), found the end of the line");
    CHECK(told("abelian_complexity(f, n) = 2") ==
          "6:6: expected complexity or palindromic_complexity, found 'abelian_complexity'");
    CHECK(told("for all n with m >= 1: complexity(f, n) = 2") ==
          "6:23: expected 'n >= ' and a number, found '>'");
    CHECK(told("for all n with n >= 1 complexity(f, n) = 2") ==
          "6:28: expected '>=' and a number, or ':', found 'complexity'");
    CHECK(told("for some n: complexity(f, n) = 2").find("a number of this statement alone") !=
          std::string::npos);
    CHECK(told("for all n: complexity(f, n) = 2 and f is rich") ==
          "6:31: expected a number of this statement alone, found 'n', which stands for something "
          "else; 'for all n with n >= 1:' goes before a single statement on complexities");
}

TEST_CASE("a claim allows the empty axiom or does not") {
    CHECK(!claim("show {ε} is 0L").empty_axiom);
    CHECK(claim("allow empty axiom\nshow {ε} is 0L").empty_axiom);
    CHECK(claim("show {ε} is 0L; allow  empty\taxiom  # as some books do").empty_axiom);
}
