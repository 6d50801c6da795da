#include <doctest/doctest.h>
#include <rapidcheck.h>

#include "exact/exact.hpp"
#include "oracle/random_systems.hpp"

using namespace algae;

namespace {

/// a -> ab, b -> a with axiom b: plain, so that each test can spoil one thing.
LSystem plain() { return oracle::lsystem_of({"b", {{'a', {"ab"}}, {'b', {"a"}}}}); }

std::string why_not_ol(const LSystem& system) { return as_ol(system).reason(); }

}  // namespace

TEST_CASE("a plain system is a D0L system with its letters in order of access") {
    const D0L system = *as_d0l(plain());
    CHECK(system.axiom == Word{0});
    CHECK(system.letters == std::vector<Symbol>{0, 1});
    CHECK(system.successor(1) == Word{1, 0});
}

TEST_CASE("the same rule twice is one rule; two rules are a choice") {
    LSystem system = plain();
    system.rules.push_back(system.rules[0]);
    CHECK(as_d0l(system));
    system.rules.back().successor.letters = {};
    CHECK(!as_d0l(system));
    CHECK(as_d0l(system).reason() == "not a D0L system: a has 2 rules");
    CHECK_THROWS_WITH_AS(as_d0l(system).value(), "not a D0L system: a has 2 rules", Error);
    CHECK(as_ol(system)->successors[*system.alphabet.find("a")].size() == 2);
}

TEST_CASE("every construct beyond 0L is named with its place") {
    const auto spoiled = [](auto spoil) {
        LSystem system = plain();
        system.rules[1].place = {"x.lsys", 3, 1};
        spoil(system, system.rules[1]);
        return why_not_ol(system);
    };
    CHECK(spoiled([](LSystem&, Production& rule) {
              rule.left = {{0, {}}};
          }) == "not an 0L system: the rule at x.lsys:3:1 has a context");
    CHECK(spoiled([](LSystem&, Production& rule) {
              rule.right = {{0, {}}};
          }) == "not an 0L system: the rule at x.lsys:3:1 has a context");
    CHECK(spoiled([](LSystem&, Production& rule) {
              rule.elsewhere = {{0, {}}};
          }) == "not an 0L system: the rule at x.lsys:3:1 has a context condition");
    CHECK(spoiled([](LSystem&, Production& rule) { rule.condition = Expression{}; }) ==
          "not an 0L system: the rule at x.lsys:3:1 has a condition");
    CHECK(spoiled([](LSystem&, Production& rule) { rule.predecessor.parameters = {"x"}; }) ==
          "not an 0L system: the rule at x.lsys:3:1 has parameters");
    CHECK(spoiled([](LSystem&, Production& rule) {
              rule.successor.arguments[0] = {Expression{}};
          }) == "not an 0L system: the rule at x.lsys:3:1 has parameters");
    CHECK(spoiled([](LSystem&, Production& rule) { rule.shape = ShapeSuccessor{}; }) ==
          "not an 0L system: the rule at x.lsys:3:1 is a shape rule");
    CHECK(spoiled([](LSystem&, Production& rule) { rule.probability = Rational(1, 2); }) ==
          "not an 0L system: the rule at x.lsys:3:1 has a probability");
    CHECK(spoiled([](LSystem&, Production& rule) { rule.probability = Rational(1); }).empty());
    CHECK(spoiled([](LSystem& system, Production&) { system.tables = {"light"}; }) ==
          "not an 0L system: it has tables");
    CHECK(spoiled([](LSystem& system, Production&) { system.terminals = {0}; }) ==
          "not an 0L system: it has terminals");
    CHECK(spoiled([](LSystem& system, Production&) {
              system.axiom.arguments[0] = {Expression{}};
          }) == "not an 0L system: the axiom has parameters");
    CHECK(spoiled([](LSystem& system, Production&) {
              system.axiom.letters.push_back(system.alphabet.symbol("?E"));
          }) == "not an 0L system: the axiom has a communication module");
}

TEST_CASE("a refused D0L view gives the same reason") {
    LSystem system = plain();
    system.tables = {"light"};
    CHECK(as_d0l(system).reason() == "not a D0L system: it has tables");
}

TEST_CASE("only accessible letters count") {
    CHECK(is_propagating(d0l("A", {{'A', "A"}, {'B', ""}})));
    CHECK(!is_propagating(d0l("AB", {{'A', "A"}, {'B', ""}})));
    CHECK(d0l("A", {{'A', "A"}, {'B', "BB"}}).letters.size() == 1);
    CHECK(is_propagating(ol("a", {{'a', "a"}, {'a', "aa"}, {'b', ""}})));
    CHECK(!is_propagating(ol("a", {{'a', "a"}, {'a', ""}})));
}

TEST_CASE(
    "the accessible letters are those of the words of as many generations as there are letters") {
    const bool holds = rc::check("accessible letters", [] {
        const auto written = *oracle::any_d0l();
        std::set<std::string> met;
        std::set<char> now(written.axiom.begin(), written.axiom.end());
        for (int n = 0; n < 12; ++n) {
            std::set<char> next;
            for (const char letter : now) {
                met.insert(std::string(1, letter));
                const auto found = written.successors.find(letter);
                if (found != written.successors.end())
                    next.insert(found->second[0].begin(), found->second[0].end());
            }
            now = next;
        }
        const D0L system = oracle::d0l_of(written);
        std::set<std::string> names;
        for (const Symbol a : system.letters) names.insert(system.alphabet->name(a));
        RC_ASSERT(names == met);
    });
    CHECK(holds);
}

TEST_CASE("brackets are branches only if every word of the system matches its own") {
    CHECK(d0l("F[F]", {{'F', "F[+F]"}}).brackets);
    CHECK(!d0l("F[F", {{'F', "F[+F]"}}).brackets);
    CHECK(!d0l("F[F]", {{'F', "F]F["}}).brackets);
    CHECK(!d0l("F[F]", {{'F', "F"}, {'[', ""}}).brackets);
    CHECK(!d0l("F", {{'F', "FF"}}).brackets);
    // What no word of the system reaches does not matter.
    CHECK(d0l("F[F]", {{'F', "FF"}, {'X', "]"}}).brackets);
}

TEST_CASE("the reason of a view is empty where there is a view") {
    CHECK(as_d0l(plain()).reason().empty());
    CHECK(as_d0l(plain())->axiom == Word{0});
}
