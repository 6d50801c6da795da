// Exact arithmetic of parameters: against rationals worked out by definition, and where it must say that it does not know.

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "exact/exact.hpp"
#include "model/model.hpp"
#include "notation/notation.hpp"
#include "rewrite/rewrite.hpp"

using namespace algae;

namespace {

RewritingChoices exact_choices() {
    RewritingChoices choices;
    choices.arithmetic = Arithmetic::exact;
    return choices;
}

std::string derived(const std::string& text, std::uint64_t n) {
    const Rewriting rewriting(read_lsystem(text, "x"), exact_choices());
    const ModuleString word = derive(rewriting, n);
    return ModuleText(rewriting.rules().system->alphabet, rewriting.rules().kinds).text(word);
}

std::string refusal(const std::string& text, std::uint64_t n) {
    try {
        return derived(text, n);
    } catch (const Error& error) {
        return error.what();
    } catch (const BoundReached& bound) {
        return bound.what();
    }
}

/// An expression in x and y as text, and its value by definition; nothing where there is none.
struct Written {
    std::string text;
    std::optional<Rational> value;
};

Written random_expression(const Rational& x, const Rational& y, int depth) {
    if (depth == 0 || *rc::gen::inRange(0, 5) == 0) {
        switch (*rc::gen::inRange(0, 4)) {
            case 0:
                return {"x", x};
            case 1:
                return {"y", y};
            case 2: {
                const int tenths = *rc::gen::inRange(0, 40);
                return {std::to_string(tenths / 10) + "." + std::to_string(tenths % 10),
                        Rational(tenths, 10)};
            }
            default: {
                const int whole = *rc::gen::inRange(0, 2000);
                return {std::to_string(whole), Rational(whole)};
            }
        }
    }
    const Written left = random_expression(x, y, depth - 1);
    const int kind = *rc::gen::inRange(0, 17);
    const auto one = [&](const std::string& name, const Rational& value) {
        return Written{name + "(" + left.text + ")",
                       left.value ? std::optional(value) : std::nullopt};
    };
    const Rational l = left.value.value_or(0);
    if (kind == 0) return one("-", -l);
    if (kind == 1) return one("abs", l < 0 ? -l : l);
    if (kind == 2) return one("floor", Rational(floor_divide(l.numerator(), l.denominator())));
    if (kind == 3) return one("ceil", -Rational(floor_divide(-l.numerator(), l.denominator())));
    const Written right = random_expression(x, y, depth - 1);
    const Rational r = right.value.value_or(0);
    const bool both = left.value && right.value;
    const auto two = [&](const std::string& name, const Rational& value) {
        return Written{"(" + left.text + ")" + name + "(" + right.text + ")",
                       both ? std::optional(value) : std::nullopt};
    };
    switch (kind) {
        case 4:
        case 5:
            return two("+", l + r);
        case 6:
        case 7:
            return two("-", l - r);
        case 8:
        case 9:
            return two("*", l * r);
        case 10:
        case 11:
            return r == 0 ? Written{two("/", 0).text, std::nullopt} : two("/", l / r);
        case 12:
            return two(" < ", l < r ? 1 : 0);
        case 13:
            return two(" >= ", l >= r ? 1 : 0);
        case 14:
            return two(" = ", l == r ? 1 : 0);
        case 15:
            return {"min(" + left.text + "," + right.text + ")",
                    both ? std::optional(std::min(l, r)) : std::nullopt};
        default:
            return {"max(" + left.text + "," + right.text + ")",
                    both ? std::optional(std::max(l, r)) : std::nullopt};
    }
}

}  // namespace

TEST_CASE("expressions have the values of rational arithmetic") {
    std::size_t compared = 0, fractions = 0, without = 0;
    CHECK(rc::check([&] {
        const auto number = [] {
            return Rational(*rc::gen::inRange(-300, 300), *rc::gen::inRange(1, 60));
        };
        const auto [x, y, written] = *rc::gen::resize(
            100, rc::gen::exec([&] {
                const Rational first = number(), second = number();
                return std::tuple(first, second, random_expression(first, second, 4));
            }));
        const std::string text = "axiom A(" + shortest_text(x) + "," + shortest_text(y) +
                                 ")\nA(x,y) -> B(" + written.text + ")";
        CAPTURE(text);
        const std::string found = refusal(text, 1);
        if (written.value) {
            RC_ASSERT(found == "B(" + shortest_text(*written.value) + ")");
            fractions += !exact_decimal(*written.value);
        } else {
            RC_ASSERT(found.find("division by 0") != std::string::npos);
            ++without;
        }
        ++compared;
    }));
    MESSAGE(compared << " compared, " << fractions << " fractions, " << without
                     << " without value");
    CHECK(compared >= 100);
    CHECK(fractions >= 5);
}

TEST_CASE(
    "decimals are not rounded: three times 0.1 is 0.3, ten times is 1, and 2^53 + 1 is not 2^53") {
    const std::string tenths = "axiom A(0.1)\nA(x) -> A(x+0.1)";
    CHECK(derived(tenths, 2) == "A(0.3)");
    CHECK(derived(tenths, 9) == "A(1)");
    CHECK(derived("axiom A(9007199254740992)\nA(x) -> A(x+1)", 1) == "A(9007199254740993)");
    CHECK(derived("axiom A(0.29)\nA(x) -> A(floor(x*100))", 1) == "A(29)");
    const std::string shrinking = "axiom A(1)\nA(x) : x > 0 -> A(x/1024)\nA(x) : x = 0 -> B";
    CHECK(derived(shrinking, 125).starts_with("A("));
    CHECK(derived("axiom A(1)\nA(x) -> A(x/3)", 2) == "A(1/9)");
    CHECK(derived("axiom A(0.1)\nA(x) : x*3 = 0.3 -> T", 1) == "T");
    CHECK(derived("axiom A(1e300)\nA(x) -> A(x*x)", 1) == "A(1e600)");
    CHECK(derived("axiom A(1e-300)\nA(x) -> A(x*x)A(x*x*0)", 1) == "A(1e-600)A(0)");
}

TEST_CASE("what is not rational is enclosed, and a comparison that is not decided says so") {
    const auto after = [](const std::string& argument, const std::string& rule) {
        return refusal("axiom A(" + argument + ")\nA(x)" + rule, 1);
    };
    CHECK(after("2", " -> A(sqrt(x))") == "A(1.414213562373095…)");
    CHECK(after("2", " -> A(-sqrt(x))") == "A(-1.414213562373095…)");
    CHECK(after("2", " -> A(floor(1000*sqrt(x)))") == "A(1414)");
    CHECK(after("2", " : sqrt(x) < 1.5 -> B") == "B");
    CHECK(
        after("2", " : exp(log(x)) = x -> B") ==
        "x:2:1: the rule for A(2) at position 0 of generation 0: the enclosures of 512 bits do not "
        "say which value 'exp(log(x)) = x' has");
    CHECK(after("2", " -> A(1/(exp(x)-exp(1)*exp(1)))")
              .ends_with("do not say which value '1/(exp(x)-exp(1)*exp(1))' has"));
    // Constants too: doubles would say that these are equal.
    CHECK(after("2", " : exp(log(2)) = 2 -> B")
              .ends_with("do not say which value 'exp(log(2)) = 2' has"));
    CHECK(refusal("let r = sqrt(2) = 1.4142135623730951\naxiom A(r)\nA(x) : x = 0 -> B", 1) == "B");
    CHECK(after("9/4", " -> A(sqrt(x))A(x^(1/2))A(x^-2)") == "A(1.5)A(1.5)A(16/81)");
    CHECK(after("390", " -> A(sin(x))A(cos(x-90))A(tan(x+15))") == "A(0.5)A(0.5)A(1)");
    CHECK(after("1", " -> A(asin(x/2))A(acos(x))A(atan(-x))A(log(x))A(exp(x-1))") ==
          "A(30)A(0)A(-45)A(0)A(1)");
    CHECK(after("1", " -> A(exp(x))A(log(x+1))A(cos(x))") ==
          "A(2.718281828459045…)A(0.6931471805599453…)A(0.9998476951563912…)");
    CHECK(after("-1", " -> A(sqrt(x))") ==
          "x:2:1: the rule for A(-1) at position 0 of generation 0: the square root of a negative "
          "number in 'sqrt(x)'");
    CHECK(after("90", " -> A(tan(x))").ends_with("'tan(x)' has no value"));
    CHECK(after("3", " -> A(asin(x))").ends_with("'asin(x)' needs a number from -1 to 1"));
    CHECK(refusal("let r = sqrt(2)\naxiom A(r)\nA(x) : x = r -> B", 0) == "A(1.414213562373095…)");
    // Square roots of one number are exact.
    CHECK(after("2", " : sqrt(x)*sqrt(x) = x -> B") == "B");
    CHECK(after("2", " : 3*sqrt(2)-x^0.5 = sqrt(8) & (1+sqrt(2))^3 = 7+5*sqrt(2) -> B") == "B");
    CHECK(
        after("2", " : 1/(1+sqrt(2)) = sqrt(2)-1 & sin(45)*2 = sqrt(2) & tan(60) = sqrt(3) -> B") ==
        "B");
    CHECK(after("2", " : sqrt(2)+sqrt(3) > 3.146 & sqrt(2) < sqrt(3) & sqrt(2) != sqrt(3) -> B") ==
          "B");
    CHECK(after("2", " -> A(1/(sqrt(x)-2^(1/2)))").find("division by 0") != std::string::npos);
    CHECK(after("2", " -> A(floor(-sqrt(x)))A(ceil(sqrt(x)))A(abs(1-sqrt(x)))") ==
          "A(-2)A(2)A(0.4142135623730950…)");
    // The same number goes from module to module.
    CHECK(refusal("axiom A(2)\nA(x) -> B(sqrt(x))\nB(x) -> C(x,x)\nC(x,y) : x = y -> D", 3) == "D");
}

TEST_CASE("enclosures hold what doubles say, but for rounding") {
    std::size_t compared = 0;
    CHECK(rc::check([&] {
        const Rational x(*rc::gen::inRange(1, 4000), *rc::gen::inRange(1, 40));
        const double near = x.to_double(), degrees = std::acos(-1.0) / 180;
        const std::vector<std::pair<std::string, double>> all = {
            {"sqrt(x)", std::sqrt(near)},
            {"log(x)", std::log(near)},
            {"exp(x/100)", std::exp(near / 100)},
            {"atan(x)", std::atan(near) / degrees},
            {"sin(x)", std::sin(near * degrees)},
            {"cos(x)", std::cos(near * degrees)},
            {"x^0.3", std::pow(near, 0.3)},
            {"asin(x/4000)", std::asin(near / 4000) / degrees},
            {"acos(x/4000)", std::acos(near / 4000) / degrees}};
        for (const auto& [expression, value] : all) {
            const Rewriting rewriting(
                read_lsystem("axiom A(" + shortest_text(x) + ")\nA(x) -> B(" + expression + ")",
                             "x"),
                exact_choices());
            const ModuleString word = derive(rewriting, 1);
            const auto known = rewriting.rules().kinds.words()->known(word.values.at(0));
            const double found =
                known.exact ? enclosure(*known.exact, 64).midpoint() : known.within->midpoint();
            RC_ASSERT(std::abs(found - value) <= 1e-9 * std::max(1.0, std::abs(value)));
            if (known.within) RC_ASSERT(known.within->has_radius_below(-400));
            ++compared;
        }
    }));
    CHECK(compared >= 900);
}

TEST_CASE("a number of more than 10,000 digits reaches a bound, at its place") {
    const std::string squares = "axiom A(10)\nA(x) -> A(x*x)";
    CHECK(derived(squares, 13).size() < 20);  // 10^8192, as 1e8192
    CHECK(refusal(squares, 14) == "x:2:11: the value of 'x*x' has more than 10,000 digits");
    CHECK(refusal("axiom A(3)\nA(x) -> A(x^100000)", 1) ==
          "x:2:11: the value of 'x^100000' has more than 10,000 digits");
    CHECK(refusal("axiom A(3)\nA(x) -> A(x^(-10^30))", 1).ends_with("more than 10,000 digits"));
    Budget budget;
    budget.memory = 1 << 20;
    const Rewriting rewriting(read_lsystem("axiom A(1/3)\nA(x) -> A(x/3)A(x/7)", "x"),
                              exact_choices(), budget);
    CHECK_THROWS_AS(derive(rewriting, 100, {}, budget), BoundReached);
}

TEST_CASE(
    "equal numbers of words are equal values, and enclosures that may be equal are not called "
    "different") {
    const Rewriting rewriting(
        read_lsystem("axiom A(1/3)A(2/6)B(exp(1))B(exp(1))B(exp(2))B(sqrt(2))B(2^(1/2))", "x"),
        exact_choices());
    const auto& values = rewriting.axiom().values;
    const WordValues& held = *rewriting.rules().kinds.words();
    CHECK(held.equal(values[0], values[1]) == true);
    CHECK(same_value(values[0], values[1]));
    CHECK(held.equal(values[0], values[2]) == false);
    CHECK(held.equal(values[2], values[3]) == std::nullopt);
    CHECK(held.equal(values[2], values[2]) == true);
    CHECK(held.equal(values[2], values[4]) == false);
    CHECK(same_value(values[5], values[6]));
    CHECK(held.equal(values[4], values[5]) == false);
}

TEST_CASE("probabilities of words add up where their numbers are equal") {
    const Rewriting rewriting(
        read_lsystem("axiom A(0.1)\nA(x) -(1/2)-> A(x+0.2)\nA(x) -(1/2)-> A(x*3)", "x"),
        exact_choices());
    const auto words = distribution(rewriting, 1);
    REQUIRE(words.size() == 1);
    CHECK(words[0].probability == 1);
}

TEST_CASE("words as parameters and exact numbers stand beside each other") {
    CHECK(derived("system leaf { axiom F(0.1); F(x) -> F(x+0.1) }\naxiom A(0.1,leaf(2))\n"
                  "A(x,w) -> A(x/3,w)[<w>]",
                  1) == "A(1/30,\"F(0.3)\")[F(0.3)]");
}
