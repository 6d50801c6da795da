#include <doctest/doctest.h>

#include "claim_said.hpp"

// Statements about numbers and words that may depend on numbers: how they are read, and what is said of wrong ones.

using namespace algae;

namespace {

const std::string definitions =
    "let G = D0L { axiom a; a -> ab; b -> a }\nlet K = D0L koch\nlet A = {a}\nlet h = { a -> b; b "
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
          "x.claim:6:18: expected one of = != < <= > >= and a number, found the end of the line");
    CHECK(messages("length(G) = 3") ==
          "x.claim:6:14: expected ',' and the number of a generation, found ')'");
    CHECK(messages("length(A, n) = 3") == "x.claim:6:13: expected a system, found 'A', a language");
    CHECK(messages("lenght(G, n) = length(G, n)")
              .starts_with("x.claim:6:6: expected one of length(G, n)"));
    CHECK(messages("lenght(G, n) = length(G, n)")
              .ends_with("found 'lenght'; did you mean 'length'?"));
    CHECK(messages("count(G, z, n) = 3") ==
          "x.claim:6:15: expected a letter of the claim, found 'z'");
    CHECK(messages("length(G, n) = 3 = 4") ==
          "x.claim:6:23: expected one comparison, found a second; join two by 'and'");
    CHECK(messages("length(G, n) = 2n") == "x.claim:6:22: expected an operator, found 'n'");
    CHECK(messages("length(G, n) = A") ==
          "x.claim:6:21: expected a number, found 'A', which is something else");
    CHECK(messages("word(G, n) = a") ==
          "x.claim:6:17: expected '==', '!=', 'begins with' or 'ends with' and a word, found '='");
    CHECK(messages("word(G, n) begins a") == "x.claim:6:24: expected 'with', found 'a'");
    CHECK(messages("word(G, n) == f(a)")
              .starts_with("x.claim:6:20: expected a name that is defined above"));
    CHECK(messages("word(G, n) == A(a)") ==
          "x.claim:6:20: expected 'word' or a morphism that is defined, found 'A'");
    CHECK(messages("growth(G) = m") ==
          "x.claim:6:18: expected n, the number of the generation, found 'm'");
    CHECK(messages("for all numbers n: n is 0L") ==
          "x.claim:6:25: expected a language, found 'n', a number");
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
