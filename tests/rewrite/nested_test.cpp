#include <doctest/doctest.h>
#include <rapidcheck.h>

#include "model/model.hpp"
#include "notation/notation.hpp"
#include "oracle/nested.hpp"
#include "rewrite/detail/inner_systems.hpp"
#include "rewrite/rewrite.hpp"
#include "rewrite/words.hpp"

using namespace algae;

namespace {

const std::string leaf = "system leaf { axiom x; x -> F[+x]x }\n";

int below(int bound) { return *rc::gen::inRange(0, bound); }
std::string any(std::initializer_list<std::string> choices) {
    return *(choices.begin() + below(static_cast<int>(choices.size())));
}

std::string any_word(const std::string& number, const std::string& word, int depth);

std::string any_number(const std::string& number, const std::string& word, int depth) {
    if (depth == 0) return any({"0", "1", "2", number, "max(" + number + "-1,0)"});
    const auto part = [&] { return any_number(number, word, depth - 1); };
    switch (below(6)) {
        case 0:
            return "length(" + any_word(number, word, depth - 1) + ")";
        case 1:
            return part() + "+1";
        case 2:
            return "max(" + part() + "," + part() + ")";
        case 3:
            return below(5) ? part() : any_word(number, word, depth - 1);  // which is no number
        default:
            return part();
    }
}

std::string any_word(const std::string& number, const std::string& word, int depth) {
    if (depth == 0) return any({"\"F\"", "\"\"", "\"FB(\"G\")A(1)\"", word});
    if (below(12) == 0) return any_number(number, word, 0);  // which is no word
    return any({word, "p(" + any_number(number, word, depth - 1) + ")",
                "q(" + any_number(number, word, depth - 1) + ")", "p(max(" + number + "-1,0))",
                "q(max(" + number + "-2,0))"});
}

std::string any_modules(const std::string& number, const std::string& word) {
    std::string out;
    for (int i = below(4); i > 0; --i) switch (below(6)) {
            case 0:
                out += "A(" + any_number(number, word, 2) + ")";
                break;
            case 1:
                out += "B(" + any_word(number, word, 2) + ")";
                break;
            case 2:
                out += "<" + any_word(number, word, 2) + ">";
                break;
            default:
                out += any({"F", "G", "A(" + number + "+1)", "B(" + word + ")"});
        }
    return out;
}

std::string any_successor(const std::string& number, const std::string& word) {
    const std::string out = any_modules(number, word);
    return out.empty() ? "ε" : out;
}

std::string any_rules() {
    std::string out;
    const std::string condition = any({"", " : n < 3", " : n > 0", " : n = 1 | n > 2"});
    if (below(5)) out += "A(n)" + condition + " -> " + any_successor("n", "\"G\"") + "\n";
    if (below(4) == 0) out += "A(n) : n < 2 & n > 0 -> A(n+1)G\n";
    if (below(5)) out += "B(w) -> " + any_successor("1", "w") + "\n";
    if (below(3) == 0) out += "G : length(q(0)) > 1 -> " + any_successor("2", "\"F\"") + "\n";
    return out;
}

std::string any_system() {
    std::string out;
    for (const std::string name : {"p", "q"})
        out += "system " + name + " {\naxiom A(0)" + any_modules("0", "\"F\"") + "\n" +
               any_rules() + "}\n";
    return out + "axiom A(0)" + any_modules("1", "p(1)") + "\n" + any_rules();
}

}  // namespace

TEST_CASE("a branch whose leaves are words of another system") {
    const auto found = words(leaf + "axiom A(0)\nA(n) : n < 2 -> F[<leaf(n)>]A(n+1)", 3);
    CHECK(found ==
          std::vector<std::string>{"A(0)", "F[x]A(1)", "F[x]F[F[+x]x]A(2)", "F[x]F[F[+x]x]A(2)"});
}

TEST_CASE("what is spliced in is rewritten by the outer system") {
    CHECK(words("system s { axiom ab; a -> ba }\naxiom <s(1)>c<s(0)>; b -> c; c -> d", 2) ==
          std::vector<std::string>{"babcab", "cacdac", "daddad"});
}

TEST_CASE("words as parameters are handed on, printed in quotes and measured") {
    CHECK(words(leaf + "axiom B(leaf(1))\nB(w) -> [<w>]B(w)C(length(w))", 2) ==
          std::vector<std::string>{"B(\"F[+x]x\")", "[F[+x]x]B(\"F[+x]x\")C(6)",
                                   "[F[+x]x][F[+x]x]B(\"F[+x]x\")C(6)C(6)"});
    CHECK(word_of("axiom B(\"FF[+F]\")C(\"\",1); B(w) -> w<w>D(w)", 1) ==
          "wFF[+F]D(\"FF[+F]\")C(\"\",1)");
    CHECK(word_of("axiom A(\"B(\"F(1,\"G\")\",2)\"); A(w) -> <w>", 1) == "B(\"F(1,\"G\")\",2)");
}

TEST_CASE("systems use each other and themselves") {
    CHECK(word_of("system s { axiom A(0); A(k) -> FL(s(k))A(k+1) }\naxiom <s(2)>", 0) ==
          "FL(\"A(0)\")FL(\"FL(\"A(0)\")A(1)\")A(2)");
    CHECK(word_of("system s { axiom a; a -> b<t(0)>a }\nsystem t { axiom c; c -> <s(1)> }\n"
                  "axiom <t(1)>",
                  0) == "bca");
}

TEST_CASE("a circle is named") {
    CHECK(refusal("system s { axiom A(5); A(k) -> <t(k)> }\nsystem t { axiom B; B -> <s(9)> }\n"
                  "axiom <s(1)>",
                  0) ==
          "test.lsys:2:21: the rule for B at position 0 of generation 0 of t: words need "
          "each other in a circle: s(1) needs t(1), which needs s(9), which needs s(1)");
    CHECK(refusal("system s { axiom <s(0)> }\naxiom <s(0)>", 0) ==
          "test.lsys:1:19: the axiom of s: words need each other in a circle: s(0) needs s(0)");
}

TEST_CASE("no number is made of a word, and no word of a number") {
    const auto rule = [](const std::string& text) { return refusal("axiom B(\"F\")\n" + text, 1); };
    const std::string start =
        "test.lsys:2:1: the rule for B(\"F\") at position 0 of generation 0: ";
    CHECK(rule("B(w) -> F(w+1)") == start + "expected numbers in 'w+1', found a word");
    CHECK(rule("B(w) -> F(-w)") == start + "expected numbers in '-w', found a word");
    CHECK(rule("B(w) -> F(w^0)") == start + "expected numbers in 'w^0', found a word");
    CHECK(rule("B(w) -> F(min(w,1))") == start + "expected numbers in 'min(w,1)', found a word");
    CHECK(rule("B(w) : w < 3 -> F") == start + "expected numbers in 'w < 3', found a word");
    CHECK(rule("B(w) : w = w -> F") == start + "expected numbers in 'w = w', found a word");
    CHECK(rule("B(w) : w != 1 -> F") == start + "expected numbers in 'w != 1', found a word");
    CHECK(rule("B(w) : w -> F") == start + "expected numbers in 'w', found a word");
    CHECK(rule("B(w) : !w -> F") == start + "expected numbers in '!w', found a word");
    CHECK(rule("B(w) : w | 1 -> F") == start + "expected numbers in 'w | 1', found a word");
    CHECK(rule("B(w) : 0 | w -> F") == start + "expected numbers in '0 | w', found a word");
    CHECK(rule("B(w) -> <length(w)>") == start + "expected a word for '<length(w)>', found 1");
    CHECK(rule("B(w) -> F(length(length(w)))") ==
          start + "expected a word in 'length(length(w))', found 1");
    CHECK(rule("B(w) -> B(\"G\"); F < B(w) > F : w > 1 -> B(2)").find("expected") ==
          std::string::npos);
    CHECK(refusal(leaf + "axiom B(1)\nB(x) -> <leaf(x/2)>", 1) ==
          "test.lsys:3:1: the rule for B(1) at position 0 of generation 0: expected a generation "
          "from 0 "
          "on in 'leaf(x/2)', found 0.5");
    CHECK(refusal(leaf + "axiom <leaf(0-1)>", 0) ==
          "test.lsys:2:8: the axiom: expected a generation from 0 on in 'leaf(0-1)', found -1");
}

TEST_CASE("words in contexts and of modules elsewhere are bound, never compared") {
    CHECK(word_of("axiom B(\"F\")C(1)B(2); B(w) < C(x) > B(y) -> D(w,x,y)", 1) ==
          "B(\"F\")D(\"F\",1,2)B(2)");
    CHECK(refusal("axiom A(1)B(\"F\")\nA(x) ? B(w) : w > x -> C", 1) ==
          "test.lsys:2:1: the rule for A(1) at position 0 of generation 0: expected numbers in 'w "
          "> x', "
          "found a word");
}

TEST_CASE("depth and size are bounded") {
    CHECK(refusal("axiom B(\"F\"); B(w) -> B(c(1)); system c { axiom <d(0)> }\n"
                  "system d { axiom F }",
                  1) != "");
    const std::string deep = "system s { axiom A(0); A(k) -> L(s(k))A(k+1) }\naxiom C(s(";
    CHECK_NOTHROW(Rewriting(read_lsystem(deep + "20))", "t.lsys")));
    CHECK_THROWS_AS(Rewriting(read_lsystem(deep + "200))", "t.lsys")), BoundReached);
    Budget small;
    small.letters = 1000;
    const LSystem doubling =
        read_lsystem("system s { axiom F; F -> FF }\naxiom C(s(20))", "t.lsys");
    CHECK_THROWS_AS(Rewriting(doubling, {}, small), BoundReached);
    // A word that stays is not derived again and again.
    CHECK(word_of("system s { axiom F }\naxiom <s(1000000000000)>", 0) == "F");
}

TEST_CASE("chances and words") {
    const Rewriting rewriting(
        read_lsystem(leaf + "axiom BB\nB -(1/2)-> C(leaf(0)); B -(1/2)-> C(leaf(1))", "t.lsys"));
    const auto all = distribution(rewriting, 1);
    CHECK(all.size() == 4);
    for (const LikelyWord& likely : all) CHECK(likely.probability == Rational(1, 4));
}

TEST_CASE("a value for each word") {
    WordValues words;
    ModuleString one, two;
    one.kinds.push_back(0);
    two.kinds.push_back(0);
    two.values.push_back(-0.0);
    const double a = words.value(one, {}), b = words.value(two, {});
    two.values[0] = 0.0;
    CHECK(WordValues::is_word(a));
    CHECK(same_value(a, words.value(one, {})));
    CHECK(same_value(b, words.value(two, {})));
    CHECK(!same_value(a, b));
    CHECK(value_before(a, b) != value_before(b, a));
    CHECK(value_before(1e308, a));
    CHECK(words.word(b) == two);
}

TEST_CASE("words of systems within are those of the definition") {
    int derived = 0, refused = 0;
    CHECK(rc::check([&] {
        const std::string text = any_system();
        RC_LOG() << text;
        const LSystem system = read_lsystem(text, "random.lsys");
        const auto n = static_cast<unsigned>(below(4));
        const oracle::NestedWord expected = oracle::nested_word(system, n);
        if (expected.too_much) return;
        std::string found;
        try {
            const Rewriting rewriting(system);
            found = ModuleText(system.alphabet, rewriting.rules().kinds).text(derive(rewriting, n));
        } catch (const Error& error) {
            RC_LOG() << error.what();
            RC_ASSERT(!expected.text);
            ++refused;
            return;
        } catch (const BoundReached& bound) {
            RC_LOG() << bound.what();
            RC_ASSERT(!expected.text);
            ++refused;
            return;
        }
        RC_ASSERT(expected.text.value_or("nothing") == found);
        ++derived;
        Alphabet alphabet = system.alphabet;  // the word reads back as itself
        RC_ASSERT(print_word(alphabet, read_word(found, alphabet)) == found);
    }));
    CHECK(derived > 20);
    CHECK(refused > 0);
}

TEST_CASE("systems within are printed as they are read") {
    CHECK(rc::check([] {
        const std::string text = any_system();
        RC_LOG() << text;
        const Model system = read_lsystem(text, "random.lsys");
        const std::string printed = print_lsystem(system);
        RC_LOG() << printed;
        RC_ASSERT(read_lsystem(printed, "printed.lsys") == system);
        RC_ASSERT(format_lsystem(text, "random.lsys") == printed);
        RC_ASSERT(format_lsystem(printed, "printed.lsys") == printed);
    }));
}
