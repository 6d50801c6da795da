#include <doctest/doctest.h>

#include "claim_said.hpp"

// Statements about numbers and words that may depend on numbers: how they are read, and what is said of wrong ones.

using namespace algae;

namespace {

const std::string definitions =
    "let G = D0L { axiom a; a -> ab; b -> a }\nlet K = D0L koch\nlet H = D0L { axiom F; F -> F+F "
    "}\nlet A = {a}\nlet h = { a -> b; b "
    "-> a }\n";

/// The body of what is said of all numbers, or the statement itself.
Statement statement(const std::string& text) {
    const Claim read =
        read_claim("claim T\n" + definitions + "show " + text, "x.claim", gallery_system);
    const Statement& said = read.statements.at(0).statement;
    const auto* all = std::get_if<Quantified>(&said.says);
    return all ? all->body.at(0) : said;
}

std::string sides(const std::string& text) {
    const auto said = std::get<ComparesNumbers>(statement(text).says);
    return to_text(said.left) + " " + to_string(said.comparison) + " " + to_text(said.right);
}

}  // namespace

TEST_CASE("numbers of generations are compared") {
    CHECK(sides("length(G, n + 2) = length(G,n+1)+length(G,n)") ==
          "length(G,n+2) = length(G,n+1)+length(G,n)");
    CHECK(sides("count(G, b, 2*n) <= 2^n/3") == "count(G,b,2*n) <= 2^n/3");
    CHECK(sides("segments(K, n) = 4^n") == "count(K,F,n) = 4^n");
    CHECK(sides("distinct  segments (K, 3) = 64") == "distinct segments(K,3) = 64");
    CHECK(sides("boxes(H, 2, 3^-1) + 1 >= 2") == "boxes(H,2,3^-1)+1 >= 2");
    CHECK(sides("length(G, 3) ≠ 4") == "length(G,3) != 4");
    CHECK(sides("growth(G) = n+1") == "length(G,n) = n+1");
    CHECK(sides("-length(G, n) > -(n + 1)*sqrt(5)") == "-length(G,n) > -(n+1)*sqrt(5)");
    const Claim closed =
        read_claim("claim T\n" + definitions + "show length(G, 3) = 5", "x.claim", gallery_system);
    CHECK(std::holds_alternative<ComparesNumbers>(closed.statements.at(0).statement.says));
}

TEST_CASE("words of generations are products of factors with images and reversals of their own") {
    const auto said =
        std::get<ComparesWords>(statement("(ab h(word(G, n)))^R == word(G, n+1)^2 ε").says);
    REQUIRE(said.left.size() == 2);
    CHECK(said.left[0].system->name == "G");
    CHECK(said.left[0].images.size() == 1);
    CHECK(said.left[0].reversed);
    CHECK(said.left[1].word.size() == 2);
    CHECK(said.left[1].reversed);
    CHECK(said.right.size() == 2);
    CHECK(to_text(said.right[1].generation) == "n+1");
    const auto turned =
        std::get<ComparesWords>(statement("{ a -> ab; b -> b }(word(G, n)^R) == a").says);
    CHECK(turned.left[0].images[0][0] == Word{1, 0});  // backwards, before the reversal
    CHECK(std::get<ComparesWords>(statement("word(G, n) ends with b").says).kind ==
          ComparesWords::Kind::ends);
}

TEST_CASE("a name that the claim defines wins over a function") {
    const Claim read = read_claim(
        "claim T\nlet length = { a -> b }\nlet A = {a}\nshow length(A) == {b}", "x.claim", {});
    CHECK(std::holds_alternative<EqualLanguages>(read.statements.at(0).statement.says));
}

TEST_CASE("what is wrong with a comparison is told at its place") {
    const auto messages = [](const std::string& text) {
        try {
            read_claim("claim T\n" + definitions + "show " + text, "x.claim", gallery_system);
        } catch (const Diagnostics& error) {
            return to_string(error.findings().front().place) + ": " +
                   error.findings().front().message;
        }
        return std::string();
    };
    CHECK(messages("length(G, n)") ==
          "x.claim:7:18: expected one of = != < <= > >= and a number, found the end of the line");
    CHECK(messages("length(G) = 3") ==
          "x.claim:7:14: expected ',' and the number of a generation, found ')'");
    CHECK(messages("length(A, n) = 3") == "x.claim:7:13: expected a system, found 'A', a language");
    CHECK(messages("lenght(G, n) = length(G, n)")
              .starts_with("x.claim:7:6: expected one of length(G, n)"));
    CHECK(messages("lenght(G, n) = length(G, n)")
              .ends_with("found 'lenght'; did you mean 'length'?"));
    CHECK(messages("distinct(K, 3) = 64")
              .starts_with(
                  "x.claim:7:6: expected one of length(G, n), count(G, a, n), segments(G, n), "
                  "distinct segments(G, 3), boxes(G, 3, 1), sqrt(2), found 'distinct'"));
    CHECK(
        messages("length(G, 2) = distinct segments") ==
        "x.claim:7:38: expected '(' and a system behind 'distinct segments', found the end of the "
        "line");
    CHECK(messages("distinct segments(K) = 64") ==
          "x.claim:7:25: expected ',' and the number of a generation, found ')'");
    CHECK(
        messages("boxes(H, 3) = 64") ==
        "x.claim:7:16: expected an operator, or ',' and the side of the boxes in steps, found ')'");
    CHECK(messages("distinct segments(A, 3) = 64")
              .starts_with("x.claim:7:24: expected a system, found 'A'"));
    CHECK(messages("count(G, z, n) = 3") ==
          "x.claim:7:15: expected a letter of the claim, found 'z'");
    CHECK(messages("length(G, n) = 3 = 4") ==
          "x.claim:7:23: expected one comparison, found a second; join two by 'and'");
    CHECK(messages("length(G, n) = 2n") == "x.claim:7:22: expected an operator, found 'n'");
    CHECK(messages("length(G, n) = A") ==
          "x.claim:7:21: expected a number, found 'A', which is something else");
    CHECK(messages("word(G, n) = a") ==
          "x.claim:7:17: expected '==', '!=', 'begins with' or 'ends with' and a word, found '='");
    CHECK(messages("word(G, n) begins a") == "x.claim:7:24: expected 'with', found 'a'");
    CHECK(messages("word(G, n) == f(a)")
              .starts_with("x.claim:7:20: expected a name that is defined above"));
    CHECK(messages("word(G, n) == A(a)") ==
          "x.claim:7:20: expected 'word' or a morphism that is defined, found 'A'");
    CHECK(messages("growth(G) = m") ==
          "x.claim:7:18: expected n, the number of the generation, found 'm'");
    CHECK(messages("for all numbers n: n is 0L") ==
          "x.claim:7:25: expected a language, found 'n', a number");
}

TEST_CASE("a figure that is more than segments of one length is told with what to write instead") {
    const auto message = [](const std::string& system, const std::string& said) {
        const std::string begun = "expected a D0L system with a turtle in the plane, found 'G': ";
        try {
            read_claim("claim T\nlet G = D0L { axiom " + system + " }\nshow " + said + " = 1",
                       "x.claim", {});
        } catch (const Diagnostics& error) {
            const std::string told = error.findings().front().message;
            CHECK(told.starts_with(begun));
            return told.substr(std::min(begun.size(), told.size()));
        }
        return std::string();
    };
    const std::string segments = "distinct segments(G, 1)", boxes = "boxes(G, 1, 1)";
    CHECK(
        message("F; F -> F+F; angle 25.7", segments) ==
        "expected a turtle that turns by a part of a full turn with a denominator up to 360, such "
        "as 'angle 60' or 'angle 180/7', found 'angle 25.7'");
    CHECK(message("F; F -> F+F; angle 10*sqrt(2)", segments).ends_with("found 'angle 10*sqrt(2)'"));
    CHECK(message("F; F -> F*F; scale 1/2", segments) ==
          "the letter * changes the length of steps, expected steps of one length; 'interpret * -> "
          "ε' leaves that out");
    CHECK(message("F; F -> F*F; scale 1/2; interpret * -> ε", segments).empty());
    CHECK(message("F; F -> F*F", segments).empty());
    CHECK(message("F; F -> {F+F}", segments) ==
          "the letter { fences a filled polygon, expected segments only; 'interpret { -> ε' leaves "
          "that out");
    CHECK(message("F; F -> F[%F]", segments).starts_with("the letter % cuts branches"));
    CHECK(message("F; F -> F&F", segments).starts_with("the symbol & leaves the plane"));
    CHECK(message("F; F -> FS; stamp S square", segments) ==
          "the letter S leaves a filled shape, expected segments only, without 'stamp'");
    CHECK(message("F; F -> FF; tropism 0 -1 0", segments)
              .starts_with("its steps bend, expected straight ones"));
    CHECK(message("F; F -> F+F; angle 60", boxes) ==
          "boxes are counted of figures along the axes only: expected a turtle that turns by right "
          "angles, such as 'angle 90', found 'angle 60'");
    CHECK(message("F; F -> F+F; start 0 0 45", boxes).find("'start 0 0 90'") != std::string::npos);
    CHECK(message("F; F -> F+F; spin 45", boxes).find("'spin'") != std::string::npos);
    CHECK(message("F; F -> F+F; start 0 0 45; spin 45", segments).empty());
    CHECK(message("F; F -> F+F; start 3 4 -90; spin 270", boxes).empty());
}

TEST_CASE("numbers are bound with conditions") {
    const auto conditions = [](const std::string& text) {
        const Claim read =
            read_claim("claim T\n" + definitions + "show " + text, "x.claim", gallery_system);
        const auto& all = std::get<Quantified>(read.statements.at(0).statement.says);
        return joined(all.bindings, ",", [](const QuantifiedName& name) { return name.name; }) +
               ": " +
               joined(all.conditions, " and ", [](const Statement& one) { return one.text; });
    };
    const std::string rest = ": length(G, n) >= 1";
    CHECK(conditions("for all numbers n" + rest) == "n: ");
    CHECK(conditions("for all n" + rest) == "n: ");
    CHECK(conditions("for all numbers n >= 1" + rest) == "n: n >= 1");
    CHECK(conditions("for all k < n" + rest) == "k,n: k < n");
    CHECK(conditions("for all numbers k, n with k < n and n > 2" + rest) == "k,n: k < n and n > 2");
}
