#include <doctest/doctest.h>

#include "notation/claim_said.hpp"

using namespace algae;

namespace {

Quantified quantified(const std::string& text) {
    return said_in<Quantified>(claim("theorem " + text).statements.at(0).statement);
}

}  // namespace

TEST_CASE("for all and for some bind names that range over something") {
    const Quantified said = quantified("for all 0L languages A, B: A | B is 0L");
    CHECK(said.universal);
    REQUIRE(said.bindings.size() == 2);
    CHECK(said.bindings[0].name == "A");
    CHECK(said.bindings[1].name == "B");
    CHECK(said.bindings[1].family == "0L");
    CHECK(said.bindings[1].text == "0L languages");
    CHECK(said.bindings[1].domain == Domain{});
    CHECK(is_said<InFamily>(said.body.at(0)));
    CHECK(!quantified("for some finite language A: A is not 0L").universal);
    CHECK(!quantified("there is a finite language A: A is not 0L").universal);
    for (const char* all : {"for every", "for each", "for all"})
        CHECK(quantified(std::string(all) + " D0L system G: L(G) is infinite").universal);
    CHECK(claim("theorem not for all 0L languages A: A is D0L").statements.at(0).statement.negated);
}

TEST_CASE("what names range over") {
    using Kind = Domain::Kind;
    const auto domain = [](const std::string& noun) {
        return quantified("for all finite languages A and " + noun + " X: A is finite")
            .bindings.at(1)
            .domain;
    };
    CHECK(domain("languages") == Domain{});
    CHECK(domain("finite languages") == Domain{});
    CHECK(domain("regular languages") == Domain{});
    CHECK(domain("PDT0L systems") ==
          Domain{.kind = Kind::system, .deterministic = true, .propagating = true, .tables = true});
    CHECK(domain("0L systems") == Domain{.kind = Kind::system});
    CHECK(domain("morphisms") == Domain{.kind = Kind::morphism});
    CHECK(domain("non-erasing morphisms") == Domain{.kind = Kind::morphism, .nonerasing = true});
    const Domain coding{.kind = Kind::morphism, .nonerasing = true, .letter_to_letter = true};
    CHECK(domain("letter-to-letter morphisms") == coding);
    CHECK(domain("codings") == coding);
    CHECK(domain("finite substitutions") == Domain{.kind = Kind::substitution});
    CHECK(domain("words") == Domain{.kind = Kind::word});
    CHECK(domain("letters") == Domain{.kind = Kind::letter});
}

TEST_CASE("a morphism of which the inverse is used has letters of its own") {
    const Quantified said = quantified("for all D0L languages A and morphisms h: h^-1(A) is D0L");
    CHECK(said.bindings.at(1).domain.kind == Domain::Kind::inverse_morphism);
    CHECK(claim_messages("theorem for all finite languages A and morphisms h: h(h^-1(A)) == A") ==
          "2:53: expected 'h' or its inverse, found both in one statement; bind a second name for "
          "the inverse");
}

TEST_CASE("bounds stand behind the noun or the names") {
    const Quantified both =
        quantified("for all finite languages A with words up to length 2 over {a, b}: A is T0L");
    CHECK(both.bindings.at(0).domain.max_word_length == 2);
    REQUIRE(both.over);
    CHECK(both.over->size() == 2);
    CHECK(quantified("for all D0L systems up to size 8 G: L(G) is finite")
              .bindings.at(0)
              .domain.max_size == 8);
    CHECK(quantified("for all words w up to length 3: w in /a*/")
              .bindings.at(0)
              .domain.max_word_length == 3);
    CHECK(quantified("for all 0L languages A, B over different letters: A | B is 0L").disjoint);
    CHECK(quantified("for all 0L languages A, B over disjoint alphabets: A | B is 0L").disjoint);
}

TEST_CASE("conditions stand behind with") {
    const Quantified said =
        quantified("for all 0L languages A, B with A & B is not empty and A != B: A & B is 0L");
    REQUIRE(said.conditions.size() == 2);
    CHECK(said.conditions[0].negated);
    CHECK(is_said<EqualLanguages>(said.conditions[1]));
}

TEST_CASE("statements are joined by not, and, or, implies and iff, the tightest first") {
    const auto joint = [](const std::string& text) {
        return said_in<Joint>(claim("let A = {a}\nshow " + text).statements.at(0).statement);
    };
    const Joint either = joint("A is 0L and A is D0L or A is finite");
    CHECK(either.kind == Joint::Kind::any);
    CHECK(said_in<Joint>(either.parts.at(0)).kind == Joint::Kind::all);
    const Joint implies = joint("A is 0L implies A is D0L implies A is finite");
    CHECK(implies.kind == Joint::Kind::implies);
    CHECK(said_in<Joint>(implies.parts.at(1)).kind == Joint::Kind::implies);
    CHECK(joint("(A is 0L or A is D0L) and A is finite").kind == Joint::Kind::all);
    CHECK(joint("not A is 0L iff not (A is D0L and A is finite)").parts.at(1).negated);
    CHECK(is_said<EqualLanguages>(
        claim("let A = {a}\nshow (A | A) == A").statements.at(0).statement));
}

TEST_CASE("a bound name hides a definition to the end of its statement") {
    const Claim read =
        claim("let A = {a}\ntheorem for all finite languages A: A is 0L\nshow A is 0L\n");
    const auto body =
        said_in<InFamily>(said_in<Quantified>(read.statements.at(0).statement).body.at(0));
    CHECK(body.language->kind == LanguageTree::Kind::variable);
    CHECK(said_in<InFamily>(read.statements.at(1).statement).language->kind ==
          LanguageTree::Kind::words);
    CHECK(claim_messages("theorem for all finite languages A: A is 0LX\nshow A is 0L")
              .ends_with("3:6: expected a name that is defined above, found 'A'"));
}

TEST_CASE("a claim has at most one theorem") {
    CHECK(claim_messages("theorem {a} is 0L\ntheorem {b} is 0L") ==
          "3:1: 'theorem' is given twice, first in line 2");
}

TEST_CASE("what is wrong with a quantified statement is told with its place") {
    CHECK(claim_messages("theorem for all 0L languages A, B") ==
          "2:34: expected ':' and a statement behind what the names range over, found the end of "
          "the line");
    CHECK(claim_messages("theorem for all OL languages A: A is 0L") ==
          "2:17: expected one of finite, 0L, P0L, D0L, PD0L, T0L, PT0L, DT0L, PDT0L, E0L, EP0L, "
          "ED0L, ET0L, EPT0L, EDT0L, EPDT0L, IL, DIL, PDIL, regular, context-free before "
          "'languages', found 'OL'; did you mean '0L', with a zero?");
    CHECK(claim_messages("theorem for all systems G: L(G) is finite") ==
          "2:17: expected a family of systems (0L, D0L, PD0L, ...) before 'systems', found "
          "'systems'");
    CHECK(claim_messages("theorem for all E0L systems G: L(G) is finite") ==
          "2:17: expected a family of 0L systems with or without tables (0L, P0L, D0L, PD0L, T0L, "
          "PT0L, DT0L, PDT0L), found 'E0L'");
    CHECK(claim_messages("theorem for all finite langages A: A is 0L") ==
          "2:24: expected what the name ranges over (0L languages, finite languages, D0L systems, "
          "words, letters, morphisms, ...), found 'langages'; did you mean 'languages'?");
    CHECK(claim_messages("theorem for all finite languages A, A: A is 0L") ==
          "2:37: the name 'A' is bound twice");
    CHECK(claim_messages("theorem for all finite languages: {a} is 0L") ==
          "2:33: expected a name behind 'languages', found ':'");
    CHECK(claim_messages("let A = {w}\ntheorem for all words w: w in A") ==
          "3:23: expected a name that is not a letter of the claim, found 'w'");
    CHECK(claim_messages("theorem for all numbers n: n is 0L") ==
          "2:28: expected a language, found 'n', a number");
    CHECK(claim_messages("theorem for all words w: w is 0L") ==
          "2:26: expected a language, found 'w', a word; its language is {w}");
    CHECK(claim_messages("theorem for all finite languages A up to size x: A is 0L") ==
          "2:47: expected a number, found 'x'");
    CHECK(claim_messages("theorem for all morphisms h and 0L languages A: h(A) is 0L") ==
          "2:17: expected the languages before the morphism that is applied to them, found 'A' "
          "behind 'h'");
    CHECK(claim_messages("theorem for all finite languages A and finite substitutions s: "
                         "s^-1(A) is 0L") ==
          "2:17: expected a morphism where an inverse is used, found the finite substitution 's'");
    CHECK(claim_messages("show {a} is 0L iff {b} is 0L iff {c} is 0L") ==
          "2:34: expected one 'iff', found a second; use brackets");
}

TEST_CASE("closed under an operation is a statement about all languages of a family") {
    const Claim read = claim("theorem not closed under union: 0L P0L\n");
    const Joint both = said_in<Joint>(read.statements.at(0).statement);
    REQUIRE(both.parts.size() == 2);
    CHECK(both.parts[0].text == "not for all 0L languages A, B: A | B is 0L");
    CHECK(both.parts[1].negated);
    CHECK(said_in<Quantified>(both.parts[1]).bindings.at(1).family == "P0L");
    REQUIRE(read.closure.size() == 1);
    CHECK(!read.closure[0].closed);
    const Claim one = claim("theorem closed under reversal: IL by a book\n");
    CHECK(
        said_in<InFamily>(said_in<Quantified>(one.statements.at(0).statement).body.at(0)).family ==
        "IL");
    CHECK(one.statements.at(0).citation == "a book");
    CHECK(one.closure.at(0).closed);
    CHECK(claim_messages("theorem closed under complement: REG") ==
          "2:9: expected another operation than complement, of which no statement about all "
          "languages can be made");
}
