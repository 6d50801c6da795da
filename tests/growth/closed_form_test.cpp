#include <doctest/doctest.h>
#include <rapidcheck.h>

#include "growth/counted.hpp"
#include "growth/growth.hpp"

using namespace algae;

namespace {

/// The integer that the form encloses at n; more bits until there is only one.
Integer rounded(const ClosedForm& form, std::uint64_t n, const Integer& about) {
    for (long bits = 64 + 2 * static_cast<long>(bit_length(about));; bits *= 2)
        if (const Ball value = form.value(n, bits); value.has_radius_below(-3))
            if (const auto found = value.unique_integer()) return *found;
}

std::string text(const std::string& axiom, const std::vector<std::pair<char, std::string>>& rules) {
    return closed_form(d0l(axiom, rules)).text();
}

}  // namespace

TEST_CASE("the closed form encloses the lengths counted letter by letter") {
    CHECK(rc::check([] {
        const D0L system = any_small_system();
        const ClosedForm form = closed_form(system);
        const std::vector<Integer> counted = counted_lengths(system, 201);
        for (std::size_t n = 0; n <= 200; n += n < 20 ? 1 : 20) {
            if (n < form.exceptions().size())
                RC_ASSERT(form.exceptions()[n] == counted[n]);
            else
                RC_ASSERT(rounded(form, n, counted[n]) == counted[n]);
        }
    }));
}

TEST_CASE("closed forms of the systems in the files give every length from 0 to 200") {
    for (const D0L& system : systems_in_files()) {
        CAPTURE(system.name);
        const ClosedForm form = closed_form(system);
        const std::vector<Integer> counted = counted_lengths(system, 201);
        bool all = true;
        for (std::size_t n = form.exceptions().size(); n <= 200; ++n)
            all = all && rounded(form, n, counted[n]) == counted[n];
        CHECK(all);
    }
}

TEST_CASE("roots with multiplicity, in fields of every small degree") {
    // Two copies of one system, the first feeding the second.
    const std::vector<std::pair<char, std::string>> chains[] = {
        {{'a', "abx"}, {'b', "a"}, {'x', "xy"}, {'y', "x"}},
        {{'a', "bx"}, {'b', "c"}, {'c', "ab"}, {'x', "y"}, {'y', "z"}, {'z', "xy"}},
        {{'a', "bbx"}, {'b', "a"}, {'x', "yy"}, {'y', "xp"}, {'p', "qq"}, {'q', "p"}},
    };
    for (const auto& rules : chains) {
        const D0L system = d0l("a", rules);
        const ClosedForm form = closed_form(system);
        const std::vector<Integer> counted = counted_lengths(system, 201);
        CHECK(form.terms().front().coefficients.size() > 1);
        for (std::size_t n = form.exceptions().size(); n <= 200; n += 7)
            CHECK(rounded(form, n, counted[n]) == counted[n]);
    }
}

TEST_CASE("fields too large to be written out are still evaluated") {
    const D0L system = d0l("a", {{'a', "b"},
                                 {'b', "c"},
                                 {'c', "d"},
                                 {'d', "e"},
                                 {'e', "f"},
                                 {'f', "g"},
                                 {'g', "h"},
                                 {'h', "i"},
                                 {'i', "j"},
                                 {'j', "ab"}});
    const ClosedForm form = closed_form(system);
    CHECK(form.terms().back().polynomial.degree() > ClosedForm::largest_written_degree);
    const std::vector<Integer> counted = counted_lengths(system, 201);
    for (std::size_t n = 0; n <= 200; n += 11) CHECK(rounded(form, n, counted[n]) == counted[n]);
}

TEST_CASE("closed forms as they are written") {
    CHECK(text("F", {{'F', "F+F--F+F"}}) == "(7*4^n - 4)/3");
    CHECK(text("b", {{'a', "ab"}, {'b', "a"}}) ==
          "((5+sqrt(5))/10)*((1+sqrt(5))/2)^n + ((5-sqrt(5))/10)*((1-sqrt(5))/2)^n");
    CHECK(text("a", {{'a', "aab"}, {'b', "bb"}}) == "(n + 2)*2^n/2");
    CHECK(text("a", {{'a', "ab"}, {'b', "bc"}, {'c', "cd"}}) == "(n^3 + 5n + 6)/6");
    CHECK(text("a", {{'a', "bb"}, {'b', "a"}}) ==
          "((1+sqrt(2))/2)*sqrt(2)^n + ((1-sqrt(2))/2)*(-sqrt(2))^n");
    CHECK(text("a", {{'a', "bc"}, {'b', "a"}, {'c', "c"}}) == "(2n + 5 - (-1)^n)/4");
    CHECK(text("a", {{'a', "bc"}, {'b', "cac"}, {'c', "de"}, {'d', ""}, {'e', ""}}) ==
          "(11 - (-1)^n)/2, for n >= 2");
    CHECK(text("a", {{'a', "b"}, {'b', "c"}, {'c', ""}}) == "0, for n >= 3");
    CHECK(text("a", {{'a', "b"}, {'b', "c"}, {'c', "a"}}) == "1");
    CHECK(text("c", {{'a', "c"}, {'b', "ca"}, {'c', "b"}}) ==
          "sum over the roots r of x^3 - x - 1 of ((r^2 + 10r + 7)/23)*r^n");
    CHECK(text("abc", {{'a', "aa"}, {'b', "b"}, {'c', "ccc"}}) == "3^n + 2^n + 1");
    CHECK(text("a", {{'a', ""}}) == "0, for n >= 1");
    CHECK(text("", {{'a', ""}}) == "0");
}

TEST_CASE("numbers with a square root as they are written") {
    CHECK(to_string(larger_root(Polynomial({-1, -1, 1}))) == "(1+sqrt(5))/2");
    CHECK(to_string(larger_root(Polynomial({-1, -1, 1})).conjugate()) == "(1-sqrt(5))/2");
    CHECK(to_string(larger_root(Polynomial({-8, 0, 1}))) == "2*sqrt(2)");
    CHECK(to_string(larger_root(Polynomial({1, 0, 1}))) == "i");
    CHECK(to_string(larger_root(Polynomial({4, 0, 1})).conjugate()) == "-2*i");
    CHECK(to_string(larger_root(Polynomial({1, 1, 1}))) == "(-1+i*sqrt(3))/2");
    CHECK(to_string(QuadraticNumber{Rational(1, 2), Rational(1, 3), 5}) == "(3+2*sqrt(5))/6");
    CHECK(to_string(QuadraticNumber{Rational(3, 2), 0, 5}) == "3/2");
}

TEST_CASE("a quotient in a number field has an integer below") {
    CHECK(rc::check([] {
        const Polynomial moduli[] = {Polynomial({-1, -1, 0, 1}), Polynomial({-2, 0, 1}),
                                     Polynomial({-5, 1}), Polynomial({3, 0, -1, 0, 0, 1})};
        const NumberField field(moduli[*rc::gen::inRange(0, 4)]);
        const auto any = [&] {
            std::vector<Integer> coefficients;
            for (int i = 0; i < field.modulus().degree(); ++i)
                coefficients.emplace_back(*rc::gen::inRange(-9, 10));
            return Polynomial(std::move(coefficients));
        };
        const Polynomial above = any(), below = any();
        RC_PRE(!below.is_zero());
        const AlgebraicNumber found = field.simplified({above, below});
        RC_ASSERT(found.denominator.degree() == 0);
        RC_ASSERT(field.multiply(found.numerator, below) ==
                  field.reduced(above * found.denominator));
    }));
}
