#include <doctest/doctest.h>

#include "model/model.hpp"

#include "rewrite/words.hpp"

// The derivations that are worked out in the literature.

using namespace algae;
using List = std::vector<std::string>;

TEST_CASE("a parametric system with two modules") {
    const std::string system =
        "axiom B(2)A(4,4)\nA(x,y) : y <= 3 -> A(x*2,x+y)\nA(x,y) : y > 3 -> B(x)A(x/y,0)\n"
        "B(x) : x < 1 -> C\nB(x) : x >= 1 -> B(x-1)";
    CHECK(words(system, 5) == List{"B(2)A(4,4)", "B(1)B(4)A(1,0)", "B(0)B(3)A(2,1)", "CB(2)A(4,3)",
                                   "CB(1)A(8,7)", "CB(0)B(8)A(" + number_text(8.0 / 7) + ",0)"});
}

TEST_CASE("a rule matches by letter, number of parameters and condition") {
    const std::string rule = "\nA(t) : t > 5 -> B(t+1)CD(t^0.5,t-2)";
    CHECK(word_of("axiom A(16)" + rule, 1) == "B(17)CD(4,14)");
    CHECK(word_of("axiom A(3)" + rule, 1) == "A(3)");
    CHECK(word_of("axiom A(16,1)" + rule, 1) == "A(16,1)");
    CHECK(word_of("axiom A" + rule, 1) == "A");
}

TEST_CASE("modules that nothing matches keep their parameters") {
    CHECK(words("axiom X(1); X(x) -> F(x)+(90)F(x)+(135)F(2^0.5*x)", 2).back() ==
          "F(1)+(90)F(1)+(135)F(1.4142135623730951)");
}

TEST_CASE("Honda's tree grows by 2^n - 1 segments of the lengths that the ratios say") {
    const std::string honda =
        "let r1 = 0.9; let r2 = 0.8; let a0 = 45; let a2 = 45; let d = 137.5; let wr = 0.707\n"
        "axiom ^(90)A(1,0.04)\n"
        "A(l,w) -> !(w)F(l)[&(a0)B(r2*l,wr*w)]/(d)A(r1*l,wr*w)\n"
        "B(l,w) -> !(w)F(l)[-(a2)@C(r2*l,wr*w)]C(r1*l,wr*w)\n"
        "C(l,w) -> !(w)F(l)[+(a2)@B(r2*l,wr*w)]B(r1*l,wr*w)";
    CHECK(words(honda, 1)[1] == "^(90)!(0.04)F(1)[&(45)B(0.8,0.02828)]/(137.5)A(0.9,0.02828)");
    const Rewriting rewriting(read_lsystem(honda, "honda.lsys"));
    const std::vector<std::size_t> counts{2, 9, 23, 51, 107, 219, 443};
    for (std::uint64_t n = 0; n < counts.size(); ++n)
        CHECK(derive(rewriting, n).kinds.size() == counts[n]);
    const ModuleString tree = derive(rewriting, 8);
    CHECK(tree.kinds.size() == 1787);
    double total = 0, thinnest = 1;
    std::size_t segments = 0;
    const double* value = tree.values.data();
    const auto& kinds = rewriting.rules().kinds;
    for (const ModuleKind kind : tree.kinds) {
        const std::string& name = rewriting.rules().system->alphabet.name(kinds.letter(kind));
        if (name == "F") total += *value, ++segments;
        if (name == "!") thinnest = std::min(thinnest, *value);
        value += kinds.arity(kind);
    }
    CHECK(segments == 255);
    CHECK(total == doctest::Approx(98.2251).epsilon(1e-6));
    CHECK(thinnest == doctest::Approx(0.003532).epsilon(1e-3));
}

TEST_CASE("numbers of modules in rows of trees and in a branching pattern") {
    const auto counts = [](const std::string& system, std::uint64_t n) {
        const Rewriting rewriting(read_lsystem(system, "counts.lsys"));
        std::vector<std::size_t> sizes;
        for (std::uint64_t k = 0; k <= n; ++k) sizes.push_back(derive(rewriting, k).kinds.size());
        return sizes;
    };
    using Sizes = std::vector<std::size_t>;
    CHECK(counts("axiom F(1); F(x) -> F(x*0.3)+(86)F(x*0.21^0.5)-(172)F(x*0.21^0.5)+(86)F(x*0.7)",
                 6) == Sizes{1, 7, 31, 127, 511, 2047, 8191});
    CHECK(counts("axiom F(1,0)\nF(x,t) : t = 0 -> "
                 "F(x*0.3,2)+(86)F(x*0.21^0.5,1)-(172)F(x*0.21^0.5,1)+(86)F(x*0.7,0)\n"
                 "F(x,t) : t > 0 -> F(x,t-1)",
                 9) == Sizes{1, 7, 13, 31, 67, 145, 313, 673, 1447, 3109});
    CHECK(counts("axiom X\nX -> F(1)[+(86)X][-(86)X]\nF(x) -> F(x*1.456)", 6) ==
          Sizes{1, 9, 25, 57, 121, 249, 505});
    CHECK(counts("axiom F(1)-(120)F(1)-(120)F(1); F(x) -> F(x/3)+(60)F(x/3)-(120)F(x/3)+(60)F(x/3)",
                 6) == Sizes{5, 23, 95, 383, 1535, 6143, 24575});
    CHECK(counts("axiom F(1); let p = 0.7; let q = 0.3; let h = sqrt(p*q); F(x) -> "
                 "F(p*x)+F(h*x)--F(h*x)+F(q*x)",
                 6) == Sizes{1, 8, 36, 148, 596, 2388, 9556});
}

TEST_CASE("a signal, with context") {
    CHECK(words("axiom baaa; b < a -> b; b -> a", 4) ==
          List{"baaa", "abaa", "aaba", "aaab", "aaaa"});
}

TEST_CASE("context in a word of brackets") {
    const std::string rule = "; BC < S > G[H]M -> X";
    CHECK(word_of("axiom ABC[DE][SG[HI[JK]L]MNO]" + rule, 1) == "ABC[DE][XG[HI[JK]L]MNO]");
    CHECK(word_of("axiom ABC[DE][SG[HI][JK]L]MNO" + rule, 1) == "ABC[DE][SG[HI][JK]L]MNO");
}

TEST_CASE("parametric context") {
    const std::string rule = "; A(x) < B(y) > C(z) : x+y+z > 10 -> E((x+y)/2)F((y+z)/2)";
    CHECK(word_of("axiom A(4)B(5)C(6)" + rule, 1) == "A(4)E(4.5)F(5.5)C(6)");
    CHECK(word_of("axiom A(4)B(0)C(6)" + rule, 1) == "A(4)B(0)C(6)");
    CHECK(word_of("axiom A(4)B(5)C" + rule, 1) == "A(4)B(5)C");
}

TEST_CASE("a condition on modules elsewhere") {
    const std::string rule = "; A(x) ? B(y), C(r,z) : x < y + r -> D(x)E(y+r)";
    CHECK(word_of("axiom C(3,8)D(-1)B(5)H(0,0)A(1)F(3)" + rule, 1) ==
          "C(3,8)D(-1)B(5)H(0,0)D(1)E(8)F(3)");
    CHECK(word_of("axiom C(3,8)B(5)A(8)" + rule, 1) == "C(3,8)B(5)A(8)");
    CHECK(word_of("axiom B(5)A(1)" + rule, 1) == "B(5)A(1)");
    // Of several the first: the last item moves on first.
    CHECK(word_of("axiom B(1)C(2,0)A(5)C(9,0)B(7)" + rule, 1) == "B(1)C(2,0)D(5)E(10)C(9,0)B(7)");
    CHECK(word_of("axiom B(1)C(2,0)A(9)C(5,0)B(7)" + rule, 1) == "B(1)C(2,0)D(9)E(12)C(5,0)B(7)");
}

TEST_CASE("a module elsewhere is not the rewritten one, and one may stand for two") {
    CHECK(word_of("axiom A(1)A(2); A(x) ? A(y) : y > x -> B(y)", 1) == "B(2)A(2)");
    CHECK(word_of("axiom A(1)B(2); A(x) ? B(y), B(z) : x < y & y = z -> C(y+z)", 1) == "C(4)B(2)");
    CHECK(word_of("axiom A; A ? A -> B", 1) == "A");
}

TEST_CASE("more context comes first, then the file") {
    CHECK(word_of("axiom bac; a -> x; b < a -> y; b < a > c -> z", 1) == "bzc");
    CHECK(word_of("axiom bac; a -> x; a > c -> y; b < a -> z", 1) == "byc");
    CHECK(word_of("axiom A(1)B; A(x) -> C; A(x) ? B -> D", 1) == "DB");
}

TEST_CASE("contexts do not see what is ignored, nor beyond the word") {
    CHECK(words("axiom b+a+a; ignore +; b < a -> b; b -> a", 2) == List{"b+a+a", "a+b+a", "a+a+b"});
    CHECK(word_of("axiom a; b < a -> b; a > b -> b", 1) == "a");
    CHECK(word_of("axiom F[a]b; a > b -> x; F < b -> y", 1) == "F[a]y");
    CHECK(word_of("axiom F[+a][-a]b; ignore + -; F > [a][a]b -> x", 1) == "x[+a][-a]b");
    CHECK(word_of("axiom F[+a][-c]b; ignore + -; F > [a][a]b -> x", 1) == "F[+a][-c]b");
    CHECK(word_of("axiom F[a(1)][a(2)]b; F > [a(x)]b : x > 1 -> G(x)", 1) == "G(2)[a(1)][a(2)]b");
    CHECK(word_of("axiom ab[]a[]; a > [] -> x", 1) == "ab[]x[]");  // any branch
}
