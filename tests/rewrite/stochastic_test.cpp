#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <map>

#include "oracle/random_systems.hpp"
#include "rewrite/expectation.hpp"
#include "rewrite/words.hpp"

using namespace algae;

namespace {

const std::string plant =
    "axiom F; F -(0.33)-> F[+F]F[-F]F; F -(0.33)-> F[+F]F; F -(0.34)-> F[-F]F";

std::vector<Rational> expected_lengths(const std::string& system, std::uint64_t n) {
    std::vector<Rational> lengths;
    for (std::uint64_t k = 0; k <= n; ++k) {
        Rational sum;
        for (const Rational& count : expected_counts(*as_s0l(read_lsystem(system, "e.lsys")), k))
            sum += count;
        lengths.push_back(sum);
    }
    return lengths;
}

std::map<std::string, Rational> likely_words(const LSystem& system, std::uint64_t n,
                                             const RewritingChoices& choices = {}) {
    const Rewriting rewriting(system, choices);
    const ModuleText text(rewriting.rules().system->alphabet, rewriting.rules().kinds);
    std::map<std::string, Rational> out;
    for (const LikelyWord& likely : distribution(rewriting, n))
        out[text.text(likely.word)] += likely.probability;
    return out;
}

}  // namespace

TEST_CASE("the numbers of a derivation are the documented ones") {
    // Worked out from the description in another language.
    CHECK(Draws(1, 0).at(0) == 0x4181b152fb77616fULL);
    CHECK(Draws(1, 3).at(1000000) == 0xa40365845d6de794ULL);
    CHECK(Draws::scaled(~std::uint64_t{0}, 7) == 6);
    CHECK(Draws::scaled(0, 7) == 0);
}

TEST_CASE("a seed stands for one word") {
    const std::string word = word_of(plant, 3);
    CHECK(word_of(plant, 3, {.seed = 1}) == word);
    CHECK(word_of(plant, 3, {.seed = 2}) != word);
    CHECK(word_of(plant, 2) == "F[+F]F[-F]F[+F[+F]F]F[-F]F[-F[+F]F]F[+F]F[-F]F");
}

TEST_CASE("the word does not depend on the number of threads") {
    for (const std::string& system :
         {plant, std::string("axiom A(1,2); A(x,y) : x < 3 -(1/2)-> A(x+1,y/3)[B(y)]A(x,y); A(x,y) "
                             ": x < 3 -(1/2)-> A(x,x*y)A(y,x);"
                             "A(x,y) : x >= 3 -> A(x/2,y)C(x)")}) {
        const std::uint64_t n = system == plant ? 9 : 24;
        const auto word =
            derive(Rewriting(read_lsystem(system, "t.lsys"), {.seed = 7, .threads = 1}), n);
        CHECK(word.kinds.size() > 50'000);
        for (const unsigned threads : {2u, 3u, 8u})
            CHECK(derive(Rewriting(read_lsystem(system, "t.lsys"), {.seed = 7, .threads = threads}),
                         n) == word);
    }
}

TEST_CASE("expected lengths are exact") {
    CHECK(expected_lengths(plant, 3) == std::vector<Rational>{1, Rational(153, 20),
                                                              Rational(31989, 1000),
                                                              Rational(6053487, 50000)});
    CHECK(decimal(expected_lengths(plant, 6).back(), 6) == "6007.836465");
    CHECK(
        expected_lengths("axiom F; F -(1/3)-> F[+F]F[-F]F; F -(1/3)-> F[+F]F; F -(1/3)-> F[+F]F", 6)
            .back() == Rational(4427809, 729));
    CHECK(expected_lengths("axiom Fx; x -(0.5)-> *[--Fx]+FFx; x -(0.5)-> *[++Fx]-FFx", 6) ==
          std::vector<Rational>{2, 12, 32, 72, 152, 312, 632});
    CHECK(expected_lengths(
              "axiom b; a -(1)-> ab; b -(1/6)-> a; b -(1/6)-> aba; b -(1/3)-> bba; b -(1/3)-> b",
              6) == std::vector<Rational>{1, 2, 4, 8, 16, 32, 64});
}

TEST_CASE("words with their probabilities") {
    const auto after_two =
        likely_words(read_lsystem("axiom F; F -(1/3)-> FF; F -(2/3)-> F", "f.lsys"), 2);
    CHECK(after_two == std::map<std::string, Rational>{{"F", Rational(4, 9)},
                                                       {"FF", Rational(10, 27)},
                                                       {"FFF", Rational(4, 27)},
                                                       {"FFFF", Rational(1, 27)}});
    CHECK(
        likely_words(
            read_lsystem("axiom A(1); A(x) : x < 3 -(1/4)-> A(x+1); A(x) : x < 3 -(3/4)-> A(x)A(0)",
                         "a.lsys"),
            1) ==
        std::map<std::string, Rational>{{"A(2)", Rational(1, 4)}, {"A(1)A(0)", Rational(3, 4)}});
    CHECK(likely_words(
              read_lsystem("axiom ba; b < a -(1/3)-> c; b < a -(2/3)-> d; b -> e", "c.lsys"), 1) ==
          std::map<std::string, Rational>{{"ec", Rational(1, 3)}, {"ed", Rational(2, 3)}});
    CHECK(likely_words(read_lsystem("axiom aa; a -> b; a -> c", "n.lsys"), 1, {.evenly = true})
              .at("bc") == Rational(1, 4));
    CHECK_THROWS_AS(likely_words(read_lsystem("axiom aa; a -> b; a -> c", "n.lsys"), 1), Error);
    CHECK(distribution(Rewriting(read_lsystem(plant, "p.lsys")), 2).size() == 297);
}

TEST_CASE("a word picked at random is one of its generation's") {
    CHECK(rc::check([](std::uint64_t seed) {
        const auto written = *oracle::any_0l(2, true);
        const LSystem system = oracle::lsystem_of(written);
        const Rewriting rewriting(system, {.seed = seed, .evenly = true});
        for (unsigned n = 0; n <= 2; ++n) {
            std::string text;
            for (const Symbol a : letters(rewriting.rules().kinds, derive(rewriting, n)))
                text += system.alphabet.name(a);
            RC_ASSERT(oracle::words_of_generation(written, n).contains(text));
        }
    }));
}

TEST_CASE("probabilities of words add up to 1, and their letters to what is expected") {
    CHECK(rc::check([] {
        const auto written = *oracle::any_0l(2, true);
        LSystem system = oracle::lsystem_of(written);
        std::map<Symbol, std::size_t> rules;
        for (const Production& rule : system.rules) ++rules[rule.predecessor.symbol];
        std::map<Symbol, std::size_t> seen;
        for (Production& rule : system.rules) {  // 1/2, 1/4, 1/4
            const std::size_t k = ++seen[rule.predecessor.symbol],
                              all = rules[rule.predecessor.symbol];
            rule.probability = power(Rational(1, 2), static_cast<long>(std::min(k, all - 1)));
        }
        const Rewriting rewriting(system);
        std::vector<Rational> counts(system.alphabet.size());
        Rational sum;
        for (const LikelyWord& likely : distribution(rewriting, 2)) {
            sum += likely.probability;
            for (const ModuleKind kind : likely.word.kinds)
                counts[rewriting.rules().kinds.letter(kind)] += likely.probability;
        }
        RC_ASSERT(sum == 1);
        RC_ASSERT(counts == expected_counts(*as_s0l(system), 2));
    }));
}

TEST_CASE("rules are drawn as often as their probabilities say") {
    // 100,000 letters; within five standard deviations.
    std::string axiom = "axiom ";
    for (int i = 0; i < 100'000; ++i) axiom += 'a';
    for (const char* condition : {"", " : 1 > 0"}) {  // both ways of the engine
        const std::string rules = "; a" + std::string(condition) + " -(0.1)-> b; a" + condition +
                                  " -(0.2)-> c; a" + condition + " -(0.3)-> d; a" + condition +
                                  " -(0.4)-> e";
        const std::string word = word_of(axiom + rules, 1, {.seed = 5});
        for (const auto& [letter, probability] :
             {std::pair('b', 0.1), {'c', 0.2}, {'d', 0.3}, {'e', 0.4}}) {
            const double count = static_cast<double>(std::count(word.begin(), word.end(), letter));
            CHECK(std::abs(count - 100'000 * probability) <
                  5 * std::sqrt(100'000 * probability * (1 - probability)));
        }
    }
}

TEST_CASE("a choice does not depend on how it is found") {
    // The same rules with a condition that always holds, and with a context that always matches.
    const std::string rules = "a -(1/3)-> ab; a -(2/3)-> b";
    const std::string word = word_of("axiom aaaaaaaaaa; " + rules, 4, {.seed = 3});
    CHECK(word_of("axiom aaaaaaaaaa; a : 1 > 0 -(1/3)-> ab; a : 1 > 0 -(2/3)-> b", 4,
                  {.seed = 3}) == word);
    CHECK(word_of("axiom aaaaaaaaaa; c < a -> c;" + rules, 4, {.seed = 3}) == word);
}

TEST_CASE("systems that are not stochastic 0L systems say why") {
    CHECK(as_s0l(read_lsystem("axiom a; a -> b; a -> c", "n.lsys")).reason() ==
          "not a stochastic 0L system: a has several rules without probabilities");
    CHECK(as_s0l(read_lsystem("axiom a(1)", "n.lsys")).reason() ==
          "not a stochastic 0L system: the axiom has parameters");
}
