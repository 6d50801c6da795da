// Parameters of figures: exact up to a bound of work, then doubles that say so.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>

#include "model/model.hpp"
#include "notation/notation.hpp"
#include "rewrite/rewrite.hpp"
#include "turtle/turtle.hpp"

using namespace algae;

namespace {

std::string text(const Model& system, const DerivedModules& derived) {
    return ModuleText(system.alphabet, derived.kinds).text(derived.word);
}

bool has(const Model& system, const DerivedModules& derived, const std::string& letter) {
    const Symbol wanted = system.alphabet.find(letter).value();
    return std::any_of(derived.word.kinds.begin(), derived.word.kinds.end(),
                       [&](ModuleKind kind) { return derived.kinds.letter(kind) == wanted; });
}

}  // namespace

TEST_CASE("a figure does not show what doubles alone derive") {
    // Doubles have no number between 0 and 2^-1074: with them A becomes B in step 109.
    const Model system =
        read_lsystem("axiom A(1); A(x) : x > 0 -> A(x/1024)F; A(x) : x = 0 -> B", "x");
    for (const std::uint64_t n : {108U, 109U, 110U, 125U, 190U}) {
        const DerivedModules derived = derived_modules(system, n, {});
        CHECK(derived.rounded.empty());
        CHECK(!has(system, derived, "B"));
        CHECK(derived.word.kinds.size() == n + 1);
        REQUIRE(derived.word.values.size() == 1);
        CHECK(derived.word.values.front() > 0);  // the nearest double, but not 0
        CHECK(figure(system, n, {})->segments() == Integer(n));
    }
}

TEST_CASE("parameters of figures are exact on the way and the nearest doubles at the end") {
    const auto derived = [](const std::string& file, std::uint64_t n) {
        const Model system = read_lsystem(file, "x");
        const DerivedModules found = derived_modules(system, n, {});
        CHECK(found.rounded.empty());
        CHECK(!found.kinds.words());
        return text(system, found);
    };
    CHECK(derived("axiom A(0); A(x) -> A(x+0.1)", 3) == "A(0.3)");
    CHECK(derived("axiom A(0); A(x) : x < 1 -> A(x+0.1); A(x) : x = 1 -> B", 11) == "B");
    CHECK(derived("axiom A(0.29); A(x) -> B(floor(x*100))", 1) == "B(29)");
    CHECK(derived("axiom A(2^53); A(x) -> B(x+1-x)", 1) == "B(1)");
    CHECK(derived("axiom A(2); A(x) -> A(sqrt(x)); A(x) : x > 3 -> B", 1) ==
          "A(1.4142135623730951)");
    CHECK(derived("axiom A(1); A(x) -> A(exp(x))", 1) == "A(2.718281828459045)");
}

TEST_CASE("numbers of more than 10,000 digits make a figure fall back to doubles, which say so") {
    const Model system = read_lsystem("axiom A(1.0001); A(x) -> F(x)A(x*x)", "x");
    CHECK(derived_modules(system, 8, {}).rounded.empty());
    const DerivedModules derived = derived_modules(system, 14, {});
    CHECK(derived.rounded == "x:1:32: the value of 'x*x' has more than 10,000 digits");
    CHECK(derived.word.kinds.size() == 15);
    CHECK(figure(system, 14, {})->facts().rounded == derived.rounded);
    // What doubles do not hold is refused as always.
    CHECK_THROWS_WITH_AS(derived_modules(read_lsystem("axiom A(2); A(x) -> A(x*x)", "x"), 12, {}),
                         "x:1:13: the rule for A(1.3407807929942597e154) at position 0 of "
                         "generation 9: the value of 'x*x' is too large",
                         Error);
}

TEST_CASE("a comparison that enclosures do not decide makes a figure fall back to doubles") {
    const std::string file =
        "axiom A(1); A(x) : exp(x)*exp(0-x) = 1 -> B; A(x) : exp(x)*exp(0-x) != 1 -> C";
    const Model system = read_lsystem(file, "x");
    RewritingChoices exact;
    exact.arithmetic = Arithmetic::exact;
    CHECK_THROWS_AS(derive(Rewriting(system, exact), 1), UndecidedValue);
    const DerivedModules derived = derived_modules(system, 1, {});
    CHECK(derived.rounded.find("the enclosures of 512 bits do not say which value") !=
          std::string::npos);
    CHECK(derived.word.kinds.size() == 1);
    // What has no value is no matter of rounding.
    CHECK_THROWS_AS(
        derived_modules(read_lsystem("axiom A(0.1); A(x) -> A(1/(3*x-0.3))", "x"), 1, {}), Error);
}

TEST_CASE("figures of many modules keep doubles, and say so") {
    const Model system = read_lsystem("axiom A(1); A(x) -> A(x/3)A(x/2)", "x");
    std::size_t exact = 0, rounded = 0;
    for (std::uint64_t n = 0; n <= 17; ++n) {
        const DerivedModules derived = derived_modules(system, n, {});
        CHECK(derived.word.kinds.size() == std::size_t{1} << n);
        if (derived.rounded.empty()) {
            ++exact;
            CHECK(rounded == 0);  // from some generation on
            CHECK(derived.word.values.front() == 1 / std::pow(3.0, n));
        } else {
            ++rounded;
            CHECK(derived.rounded == "the words up to it have more than 20000 modules together");
        }
    }
    CHECK(exact == 14);  // 2^14 - 1 modules and one a generation
    CHECK(rounded == 4);
    // The work on numbers is bounded too.
    const DerivedModules slow =
        derived_modules(read_lsystem("axiom A(1); A(x) -> A(exp(x)/exp(1)/2+1/3)", "x"), 300, {});
    CHECK(slow.rounded == "exact parameters take more than 2000 operations");
    // The caller's own bound of letters stays one.
    Budget few;
    few.letters = 100;
    CHECK_THROWS_AS(derived_modules(system, 10, {}, few), BoundReached);
}

TEST_CASE("a scene says that its parameters are doubles") {
    const Model system = read_lsystem("axiom A(1); A(x) -> &F(x)A(x/3)A(x/2)", "x");
    CHECK(scene(system, 5, {}).facts.rounded.empty());
    CHECK(!scene(system, 15, {}).facts.rounded.empty());
}

TEST_CASE("words as parameters are rounded inside") {
    const Model system = read_lsystem("axiom A(\"F(1)\",0.1); A(w,x) -> A(w,x+0.1)<w>", "x");
    const DerivedModules derived = derived_modules(system, 2, {});
    CHECK(derived.rounded.empty());
    CHECK(text(system, derived) == "A(\"F(1)\",0.3)F(1)F(1)");
}
