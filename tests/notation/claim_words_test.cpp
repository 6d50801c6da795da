#include <doctest/doctest.h>

#include "model/model.hpp"

#include "notation/claim_said.hpp"

using namespace algae;
using Kind = LanguageTree::Kind;

TEST_CASE("sets with powers") {
    CHECK(read_back("{a^n b^n : n >= 0}") == "{a^n b^n : n >= 0}");
    CHECK(read_back("{a^nb^n | n >= 1}") == "{a^n b^n : n >= 1}");
    CHECK(read_back("{ a^(n+2*n) (ab)^(2^(n+1)) c c^2 : n > 0 }") ==
          "{a^(3n) (ab)^(2*2^n) ccc : n >= 1}");
    CHECK(read_back("{a^2^n : n ≥ 0}") == "{a^(2^n) : n >= 0}");
    CHECK(read_back("{a^((n+1)^2 + 3*2^n n) b : n >= 0}") == "{a^(n^2+3n*2^n+2n+1) b : n >= 0}");
    CHECK(read_back("{a^n b^m : n, m >= 1}") == "{a^n b^m : n, m >= 1}");
    CHECK(read_back("{a^n b^(2n+3m) : n >= 0, m >= 1}") == "{a^n b^(3m+2n) : n >= 0, m >= 1}");
    CHECK(read_back("{a^n : n >= 0}* \\ {a^n b^n : n >= 1}") ==
          "{a^n : n >= 0}* \\ {a^n b^n : n >= 1}");
    CHECK(read_back("{0^n 1^n : n >= 0}") == "{0^n 1^n : n >= 0}");
}

TEST_CASE("sets with powers that are written in another way") {
    const auto said = [](const std::string& set) { return claim_messages("show a in " + set); };
    CHECK(
        said("{a^n b^n}") ==
        "2:12: expected letters, found the power 'a^n': write a a a out; if ^ is a letter, declare "
        "it by 'alphabet'");
    CHECK(said("{w : |w| = 3}") ==
          "2:14: expected powers such as a^n before ':', as in {a^n b^(2n+1) : n >= 0}; other sets "
          "of words are written by operations on languages, as /(a|b)*/ & ~L(G)");
    CHECK(said("{a^3 : n >= 0}").starts_with("2:16: expected powers such as a^n before ':'"));
    CHECK(said("{a^n : n}") == "2:19: expected '>=' and a number, found '}'");
    CHECK(said("{a^n : n = 3}") == "2:20: expected '>=' and a number, found '='");
    CHECK(said("{a^n : n >= 0, n >= 1}") == "2:26: the number 'n' stands there twice");
    CHECK(said("{a^n : n, m >= 0}") == "2:17: the number m stands in no exponent");
    CHECK(said("{a^n b^m c^k : n, m, k >= 0}") ==
          "2:32: expected one or two numbers, found a third one, 'k'");
    CHECK(said("{a^n b^k : n >= 0}") ==
          "2:18: expected a number of the condition behind ':', found 'k'");
    CHECK(said("{a^2n : n >= 0}") ==
          "2:15: expected brackets around an exponent of several signs, as in a^(2n)");
    CHECK(
        said("{a^(n-1) : n >= 1}") ==
        "2:16: expected '+', '*', '^' or ')' in an exponent, found '-': exponents have no negative "
        "terms");
    CHECK(said("{a^(n^n) : n >= 1}") ==
          "2:15: expected an exponent such as n, 2n+1, n^2 or 3*2^(n+1), found a power of another "
          "kind");
    CHECK(said("{a^(n m) : n, m >= 0}") ==
          "2:17: with two numbers exponents are sums such as 2n+m+1, without products of both");
    CHECK(said("{a^(n^2) b^m : n, m >= 0}") ==
          "2:12: with two numbers exponents are sums such as 2n+m+1, without powers of them");
    CHECK(said("{a^n n : n >= 0}").starts_with("2:16: expected letters, found 'n', a number"));
    CHECK(said("{ε^n a^n : n >= 0}") == "2:12: expected a letter or word before '^', found ε");
    CHECK(said("{(ab^n : n >= 0}") == "2:12: '(' is never closed");
    CHECK(said("{a^n, b : n >= 0}") ==
          "2:15: expected a letter, or a word between brackets, found ','");
}

TEST_CASE("context-free grammars") {
    const Claim read = claim(
        "let A = CF { S -> aSb | ε }\n"
        "let B = CF { E -> E+T | T; T -> x\n start T }\n"
        "show ab in A | CF { S -> SS|ab }\n"
        "show aabb in L(A)\n");
    REQUIRE(read.languages.size() == 2);
    CHECK(to_string(named(read.languages[0], ""), *read.alphabet) == "CF { S -> aSb | ε }");
    CHECK(to_string(named(read.languages[1], ""), *read.alphabet) == "CF { T -> x; E -> E+T | T }");
    REQUIRE(read.systems.size() == 3);
    CHECK(read.systems[0]->name == "A");
    CHECK(read.systems[2]->name == "CF { S -> SS | ab }");
    const ET0L& system = *read.systems[0]->tables;
    const Symbol start = *read.alphabet->find("S");
    CHECK(system.axiom == Word{start});
    CHECK(system.terminal[start] == 0);
    CHECK(system.tables[0][start].size() == 3);
    CHECK(said_in<HasWord>(read.statements[1].statement).language->system == read.systems[0]);
    CHECK(read_back("CF{S->aSb|ε}.{c}") == "CF { S -> aSb | ε } . {c}");
    CHECK(read_back("{c} CF { S -> a }*") == "{c} . CF { S -> a }*");
}

TEST_CASE("right-linear grammars are regular expressions") {
    CHECK(read_back("regular { S -> aS | b }") == "{a}* . {b}");
    CHECK(read_back("regular { S -> aS | bA | ε; A -> bA | b }") ==
          "{a}* . ({ε} | {b} . ({b}* . {b}))");
    CHECK(read_back("regular { S -> aS }") == "{}");
    CHECK(read_back("regular { S -> ab | c | A; A -> d }") == "{c, d, ab}");
}

TEST_CASE("grammars that are written in another way") {
    const auto said = [](const std::string& grammar) {
        return claim_messages("let A = " + grammar);
    };
    CHECK(said("CF { S -> aSb | }") == "2:25: expected a word (the empty word is ε), found '}'");
    CHECK(said("CF { S -> aSb | λ }") ==
          "2:25: the empty word is written ε; if λ is a letter, declare it by 'alphabet'");
    CHECK(
        said("CF { S -> aB }") ==
        "2:19: expected a rule for 'B', found none; if it is a terminal, declare it by 'alphabet'");
    CHECK(said("CF { AB -> a }") == "2:14: expected one letter before the arrow, found 'AB'");
    CHECK(said("CF { S -> a; axiom S }") ==
          "2:22: expected a rule such as 'S -> aSb | ε', or 'start' and a letter, found 'axiom'");
    CHECK(said("CF { S -> a; start T }") == "2:28: expected a letter that has a rule, found 'T'");
    CHECK(
        said("regular { S -> aSb | ε }") ==
        "2:24: expected at most one letter that is rewritten, at the end of the word, found 'aSb'; "
        "other grammars are written CF { ... }");
    CHECK(said("{a}\nlet CF = {a}") == "3:5: expected another name, 'CF' has a meaning in claims");
}

TEST_CASE("codes and palindromes are said") {
    const Claim read = claim(
        "let A = {a, ab}\n"
        "show A is a code\n"
        "show A is not a prefix code\n"
        "show abba is a palindrome\n"
        "show aab is not a palindrome\n");
    CHECK(!said_in<IsCode>(read.statements[0].statement).prefix);
    CHECK(said_in<IsCode>(read.statements[1].statement).prefix);
    CHECK(read.statements[1].statement.negated);
    CHECK(said_in<IsPalindrome>(read.statements[2].statement).word.size() == 4);
    CHECK(!read.statements[2].statement.negated);
    CHECK(claim_messages("let A = {a}\nshow A is a cod") ==
          "3:13: expected 'code' or 'prefix code' after 'a', found 'cod'");
    CHECK(claim_messages("let A = {a}\nshow A is a palindrome") ==
          "3:6: expected a word, found the name 'A'");
}
