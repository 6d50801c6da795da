#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <functional>
#include <map>

#include "exact/exact.hpp"
#include "model/model.hpp"
#include "notation/notation.hpp"
#include "system/system.hpp"

using namespace algae;

namespace {

using Values = std::vector<Rational>;  // of x and y

/// A part of a condition as text, and its value worked out here.
struct Part {
    std::string text;
    std::function<Rational(const Values&)> value;
};

int below(int bound) { return *rc::gen::inRange(0, bound); }

Part any_linear() {
    const int which = below(6);
    if (which == 0) return {"x", [](const Values& v) { return v[0]; }};
    if (which == 1) return {"y", [](const Values& v) { return v[1]; }};
    if (which == 2) {
        const int number = below(7);
        return {"(" + std::to_string(number) + "-3)",
                [=](const Values&) { return Rational(number - 3); }};
    }
    const Part left = any_linear();
    if (which == 3) {
        const int factor = 1 + below(3);
        return {"(" + left.text + "*" + std::to_string(factor) + "/2)",
                [=](const Values& v) { return left.value(v) * Rational(factor, 2); }};
    }
    const Part right = any_linear();
    if (which == 4)
        return {"(" + left.text + "+" + right.text + ")",
                [=](const Values& v) { return left.value(v) + right.value(v); }};
    return {"(" + left.text + "-" + right.text + ")",
            [=](const Values& v) { return left.value(v) - right.value(v); }};
}

Part any_term(bool linear) {
    if (linear || below(2)) return any_linear();
    const Part left = any_linear(), right = any_linear();
    const auto floor = [](const Rational& value) {
        return Rational(floor_divide(value.numerator(), value.denominator()));
    };
    switch (below(6)) {
        case 0:
            return {"(" + left.text + "*" + right.text + ")",
                    [=](const Values& v) { return left.value(v) * right.value(v); }};
        case 1:
            return {"floor(" + left.text + ")",
                    [=](const Values& v) { return floor(left.value(v)); }};
        case 2:
            return {"ceil(" + left.text + ")",
                    [=](const Values& v) { return -floor(-left.value(v)); }};
        case 3:
            return {"abs(" + left.text + ")", [=](const Values& v) {
                        const Rational value = left.value(v);
                        return value < 0 ? -value : value;
                    }};
        case 4:
            return {"min(" + left.text + "," + right.text + ")",
                    [=](const Values& v) { return std::min(left.value(v), right.value(v)); }};
        default:
            return {"max(" + left.text + "," + right.text + ")",
                    [=](const Values& v) { return std::max(left.value(v), right.value(v)); }};
    }
}

Part any_condition(bool linear, int depth) {
    const auto truth = [](bool is) { return Rational(is ? 1 : 0); };
    const int which = depth > 0 ? below(5) : 4;
    if (which == 0) {
        const Part inner = any_condition(linear, depth - 1);
        return {"!(" + inner.text + ")",
                [=](const Values& v) { return truth(inner.value(v).is_zero()); }};
    }
    if (which == 1 || which == 2) {
        const Part left = any_condition(linear, depth - 1),
                   right = any_condition(linear, depth - 1);
        const bool both = which == 1;
        return {"(" + left.text + (both ? " & " : " | ") + right.text + ")", [=](const Values& v) {
                    const bool first = !left.value(v).is_zero(), second = !right.value(v).is_zero();
                    return truth(both ? first && second : first || second);
                }};
    }
    const Part left = any_term(linear), right = any_term(linear);
    static const std::vector<std::string> relations{"<", "<=", ">", ">=", "=", "!="};
    const std::size_t relation = static_cast<std::size_t>(below(6));
    return {"(" + left.text + " " + relations[relation] + " " + right.text + ")",
            [=](const Values& v) {
                const Rational a = left.value(v), b = right.value(v);
                const bool is[] = {a<b, a <= b, a> b, a >= b, a == b, a != b};
                return truth(is[relation]);
            }};
}

LSystem read(const std::string& text) { return read_lsystem(text, "rules.lsys"); }

/// "no", "1 2: x=2" for each pair.
std::string overlapping_rules(const std::string& text) {
    std::string all;
    for (const RuleOverlap& overlap : overlaps(read(text))) {
        all += (all.empty() ? "" : "; ") + std::to_string(overlap.first) + " " +
               std::to_string(overlap.second) + ":";
        if (!overlap.both) all += " undecided";
        if (overlap.both)
            for (const auto& [name, value] : *overlap.both)
                all += " " + name + "=" + shortest_text(value);
    }
    return all.empty() ? "none" : all;
}

}  // namespace

TEST_CASE("rules that are said to exclude each other do, and those that overlap match together") {
    std::size_t excluded = 0, overlapping = 0, undecided = 0;
    for (const bool linear : {true, false})
        CHECK(rc::check("conditions", [&] {
            const auto [one, other] = *rc::gen::resize(
                100, rc::gen::exec([&] {
                    return std::pair(any_condition(linear, 2), any_condition(linear, 2));
                }));
            RC_LOG() << one.text << "   " << other.text << '\n';
            // The parameters of the second rule have other names there.
            const std::string second = [&text_of_other = other.text] {
                std::string text = text_of_other;
                for (char& letter : text)
                    letter = letter == 'x' ? 'p' : letter == 'y' ? 'q' : letter;
                for (std::size_t at; (at = text.find("map(")) != std::string::npos;)
                    text.replace(at, 3, "max");
                return text;
            }();
            const auto pairs = overlaps(
                read("axiom A(1,2); A(x,y) : " + one.text + " -> B; A(p,q) : " + second + " -> C"));
            bool is_seen = false;
            for (int a = -10; a <= 10 && !is_seen; ++a)
                for (int b = -10; b <= 10 && !is_seen; ++b) {
                    const Values v{Rational(a, 2), Rational(b, 2)};
                    is_seen = !one.value(v).is_zero() && !other.value(v).is_zero();
                }
            if (pairs.empty()) {
                RC_ASSERT(!is_seen);
                ++excluded;
                return;
            }
            RC_ASSERT(pairs.size() == 1u);
            if (!pairs.front().both) {
                RC_ASSERT(!linear);
                ++undecided;
                return;
            }
            Values v(2);
            for (const auto& [name, value] : *pairs.front().both) v[name == "y"] = value;
            RC_ASSERT(!one.value(v).is_zero());
            RC_ASSERT(!other.value(v).is_zero());
            ++overlapping;
        }));
    CHECK(excluded > 3);
    CHECK(overlapping > 5);
    CHECK(undecided < 60);
}

TEST_CASE("conditions that exclude each other, and what they need to know for it") {
    const std::string a = "axiom A(1); ";
    CHECK(overlapping_rules(a + "A(x) : x < 2 -> B; A(x) : x >= 2 -> C") == "none");
    CHECK(overlapping_rules(a + "A(x) : x < 2 -> B; A(y) : y >= 2 -> C") == "none");
    CHECK(overlapping_rules(a + "A(x) : x < 2 -> B; A(x) : x > 1 -> C") == "0 1: x=1.5");
    CHECK(overlapping_rules(a + "A(x) : x <= 2 -> B; A(x) : x >= 2 -> C") == "0 1: x=2");
    CHECK(overlapping_rules(a + "A(x) -> B; A(x) : x > 1 -> C") == "0 1: x=2");
    CHECK(overlapping_rules(a + "A(x) : x > 1 & x < 1 -> B; A(x) -> C") == "none");
    CHECK(overlapping_rules("let k = 3; " + a + "A(x) : x < k -> B; A(x) : x > k+1 -> C") ==
          "none");
    CHECK(overlapping_rules("let k = sqrt(2); " + a + "A(x) : x < k -> B; A(x) : x >= k -> C") ==
          "none");
    CHECK(overlapping_rules(a + "A(x) : floor(x) = 1 -> B; A(x) : x > 3 -> C") == "none");
    CHECK(overlapping_rules(a + "A(x) : x*x < 1 -> B; A(x) : x*x >= 1 -> C") == "none");
    CHECK(overlapping_rules(a + "A(x) : x*x < 1 -> B; A(x) : x > 0 -> C") == "0 1: x=0.5");
    // That a square is not below 0 is not known here, and no number shows the opposite.
    CHECK(overlapping_rules(a + "A(x) : x*x < 0 -> B; A(x) -> C") == "0 1: undecided");
    CHECK(overlapping_rules(a + "A(x) : sin(x) > 0 & x > 7 -> B; A(x) : x > 7 & x < 7.5 -> C") ==
          "0 1: undecided");
}

TEST_CASE("left sides tell rules apart before their conditions do") {
    CHECK(overlapping_rules("axiom A(1)B; A(x) > B -> B; A(x) -> C") == "none");
    CHECK(overlapping_rules("axiom A(1)A; A(x) -> B; A -> C") == "none");
    CHECK(overlapping_rules("axiom A(1); table s; A(x) -> B; table t; A(x) -> C") == "none");
    CHECK(overlapping_rules("axiom A(1); A(x) -(1/2)-> B; A(x) -(1/2)-> C") == "none");
    CHECK(overlapping_rules("axiom A(1); A(x) -> B(x); A(x) -> B(x)") == "none");
    CHECK(overlapping_rules("axiom a; a -> b; a -> b") == "none");
    CHECK(overlapping_rules("axiom a; a -> b; a -> c") == "0 1:");
    CHECK(overlapping_rules(
              "axiom A(1)B(2); B(y) < A(x) : y < x -> C; B(y) < A(x) : y >= x -> D") == "none");
    CHECK(
        overlapping_rules("axiom A(1)B(2); B(y) < A(x) : y < x -> C; B(y) < A(x) : y > x-1 -> D") ==
        "0 1: y=-0.5 x=0");
    // Each rule looks for a module of its own elsewhere: these may both find one.
    CHECK(overlapping_rules("axiom A(1)B(2); A(x) ? B(y) : y < x -> C; A(x) ? B(y) : y > x -> D") !=
          "none");
}

TEST_CASE("the class is deterministic only where that is seen") {
    const auto name = [](const std::string& rules) {
        return class_of(read("axiom A(1); " + rules)).name();
    };
    CHECK(name("A(x) : x < 2 -> A(x+1)B; A(x) : x >= 2 -> B") == "parametric PD0L");
    CHECK(name("A(x) : x < 3 -> A(x+1)B; A(x) : x >= 2 -> B") == "parametric P0L");
    CHECK(name("A(x) : x*x < 0 -> B; A(x) -> B") == "parametric P0L");
}

TEST_CASE("modules that no rule matches because of the number of their parameters") {
    const auto unmatched = [](const std::string& text) {
        const LSystem system = read(text);
        std::string all;
        for (const UnmatchedModule& module : unmatched_modules(system)) {
            all += system.alphabet.name(module.letter) + std::to_string(module.parameters) + ":";
            for (const std::size_t count : module.expected) all += std::to_string(count);
            all += ' ';
        }
        return all;
    };
    CHECK(unmatched("axiom A(1); A(x) -> A(x,1)B(2)") == "A2:1 ");
    CHECK(unmatched("axiom A; A(x) -> B; A(x,y) -> A(1)C") == "A0:12 ");
    CHECK(unmatched("axiom A(1); A(x) -> A(x)F(1)[+(45)A(x)]") == "");
    CHECK(unmatched("axiom a; a -> ab") == "");
}
