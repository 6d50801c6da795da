#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <chrono>

#include "exact/exact.hpp"
#include "growth/growth.hpp"

using namespace algae;

namespace {

using Numbers = std::vector<Rational>;
using Kind = Realisation::Kind;

Realisation realised(const std::string& text) { return realise(read_specification(text)); }

/// Whether the first lengths of what was found are the sequence, from the shift on.
bool has_lengths(const Realisation& result, const SequenceSpecification& sequence) {
    const auto values = sequence.values(30 + result.shift);
    for (std::size_t n = 0; n < 30; ++n)
        if (Rational(length(*result.system, n)) != values[n + result.shift]) return false;
    return true;
}

std::string refusal(const std::string& text) {
    try {
        read_specification(text);
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

}  // namespace

TEST_CASE("a sequence is read as terms, as a recurrence or as a polynomial") {
    CHECK(read_specification("1,1,2,3,5,8").text() == "a(n) = a(n-1) + a(n-2) for n >= 2; 1, 1");
    CHECK(read_specification("a(n) = a(n-1) + a(n-2); 1, 1").text() ==
          "a(n) = a(n-1) + a(n-2) for n >= 2; 1, 1");
    CHECK(read_specification("1, 2, 4, 8, ...").text() == "a(n) = 2 a(n-1) for n >= 1; 1");
    CHECK(read_specification("n^2").values(5) == Numbers{0, 1, 4, 9, 16});
    CHECK(read_specification("(n^3+5n+6)/6").values(6) == Numbers{1, 2, 4, 8, 15, 26});
    CHECK(read_specification("2(n+1)(n-1) + 3").values(3) == Numbers{1, 3, 9});
    CHECK(read_specification("f(n) = 2f(n-1) + 1; 1").values(5) == Numbers{1, 3, 7, 15, 31});
    CHECK(read_specification("f(n) = -1/2 f(n-2); 4, 2").values(4) == Numbers{4, 2, -2, -1});
}

TEST_CASE("what is no sequence is refused with the place") {
    CHECK(refusal("") ==
          "the sequence \"\", place 1: expected terms such as 1,1,2,3, a recurrence or a "
          "polynomial in n, found its end");
    CHECK(refusal("2^n") ==
          "the sequence \"2^n\", place 3: expected an exponent written as a number, found \"n\"");
    CHECK(refusal("1,2,") == "the sequence \"1,2,\", place 5: expected a number, found its end");
    CHECK(
        refusal("a(n) = a(n+1); 1") ==
        "the sequence \"a(n) = a(n+1); 1\", place 11: expected '-' as in a(n-1), found \"+1); 1\"");
    CHECK(refusal("a(n) = a(n-1) + a(n-2); 1") ==
          "the sequence \"a(n) = a(n-1) + a(n-2); 1\", place 26: expected 2 first values, as many "
          "as the recurrence goes back, found its end");
    CHECK(refusal("n^201") ==
          "the sequence \"n^201\", place 3: expected an exponent of at most 200, found \"201\"");
    CHECK(refusal("n/0") ==
          "the sequence \"n/0\", place 4: expected a number other than 0 as the divisor, found its "
          "end");
    CHECK(!refusal(std::string(5000, '(')).empty());
}

TEST_CASE("classical sequences have systems") {
    for (const char* text :
         {"1,1,2,3,5,8", "n^2+1", "n^2+n+1", "(n^3+5n+6)/6", "5", "2n+1", "1,3,8,20,48,112",
          "4,2,4,8,16,32", "1,2,2,3,3,4,4,5", "1,1,1,0,0,0", "n^2-n+1", "n^2-5n+7",
          "a(n) = 5a(n-1) - 6a(n-2); 4, 13", "a(n) = 3a(n-1) - a(n-2); 1, 2",
          "a(n) = 4a(n-1) - a(n-2); 1, 2", "1,2,5,14,42,132", "n^7+1",
          "a(n) = 3a(n-1) - 3a(n-2) + 2a(n-3); 3, 3, 3"}) {
        INFO(text);
        const Realisation result = realised(text);
        CHECK(result.kind == Kind::found);
        REQUIRE(result.system);
        CHECK(has_lengths(result, read_specification(text)));
    }
}

TEST_CASE("lengths that never fall come without empty successors") {
    for (const char* text : {"1,1,2,3,5,8", "n^2+1", "n^2-n+1", "7", "1,3,8,20,48,112"}) {
        INFO(text);
        CHECK(is_propagating(*realised(text).system));
    }
    CHECK(!is_propagating(*realised("4,2,4,8,16,32").system));
}

TEST_CASE("no system has the length 0 before another, and the rest is offered") {
    const Realisation result = realised("n^2");
    CHECK(result.kind == Kind::impossible);
    CHECK(result.because ==
          "a(0) = 0 but a(1) = 1: the empty word stays empty, so lengths that are once 0 stay 0");
    CHECK(result.shift == 1);
    REQUIRE(result.system);
    CHECK(has_lengths(result, read_specification("n^2")));
}

TEST_CASE("what is no length is named") {
    CHECK(realised("a(n) = a(n-1) - a(n-2); 1, 1").because ==
          "a(3) = -1 is negative, so it is no length");
    CHECK(realised("n^2/2").because == "a(1) = 1/2 is not a natural number, so it is no length");
    CHECK(realised("0,0,0,0").because == "a(0) = 0: an axiom has at least one letter");
}

TEST_CASE("too few terms determine nothing") {
    const Realisation result = realised("1,2,4,9,3");
    CHECK(result.kind == Kind::not_known);
    CHECK(result.because ==
          "the 5 terms determine no recurrence: their shortest one has order 3 and rests on 6 "
          "terms; give more");
}

TEST_CASE("what is not found is said not to be known") {
    const Realisation result = realised("n^12+1");
    CHECK(result.kind == Kind::not_known);
    CHECK(result.because.find("rules of more than 20000 letters") != std::string::npos);
}

TEST_CASE("the shortest recurrence of terms gives them back") {
    CHECK(rc::check([] {
        const auto order = *rc::gen::inRange<std::size_t>(1, 6);
        const auto number =
            rc::gen::map(rc::gen::inRange(-3, 4), [](int n) { return Rational(n); });
        SequenceSpecification sequence;
        sequence.coefficients = *rc::gen::container<Numbers>(order, number);
        sequence.initial =
            *rc::gen::container<Numbers>(order + *rc::gen::inRange<std::size_t>(0, 3), number);
        const auto terms = sequence.values(2 * sequence.initial.size());
        const auto found = recurrence_of_terms(terms);
        RC_ASSERT(found.initial.size() <= sequence.initial.size());
        RC_ASSERT(found.values(30) == sequence.values(30));
        RC_ASSERT(reduced(sequence).values(30) == sequence.values(30));
    }));
}

TEST_CASE("the lengths of random systems can be realised, or it is said that it is not known") {
    CHECK(rc::check([] {
        const auto word = rc::gen::nonEmpty(rc::gen::resize(
            3, rc::gen::container<std::string>(rc::gen::elementOf(std::string("abc")))));
        const D0L system = d0l(*word, {{'a', *word}, {'b', *word}, {'c', *word}});
        Numbers terms;
        for (std::size_t n = 0; n < 8; ++n) terms.emplace_back(length(system, n));
        const auto sequence = recurrence_of_terms(terms);
        const Realisation result = realise(sequence);
        RC_ASSERT(result.kind != Kind::impossible);
        RC_TAG(result.kind == Kind::found ? "found" : "not known");
        if (result.system) RC_ASSERT(has_lengths(result, sequence));
    }));
}

TEST_CASE("every polynomial with natural values above 0 has a system") {
    CHECK(rc::check([] {
        // sums of binomial coefficients with a few first values changed in sign are natural or refused
        const auto coefficients = *rc::gen::container<std::vector<int>>(4, rc::gen::inRange(-3, 5));
        SequenceSpecification sequence{{4, -6, 4, -1}, {}, 0};
        for (int n = 0; n < 4; ++n) {
            const int value = coefficients[0] + coefficients[1] * n +
                              coefficients[2] * n * (n - 1) / 2 +
                              coefficients[3] * n * (n - 1) * (n - 2) / 6;
            sequence.initial.emplace_back(value);
        }
        const auto values = sequence.values(200);
        const bool natural = std::all_of(values.begin(), values.end(),
                                         [](const Rational& v) { return sign(v) > 0; });
        const Realisation result = realise(sequence);
        RC_ASSERT((result.kind == Kind::found) == natural);
        if (natural) RC_ASSERT(has_lengths(result, sequence));
    }));
}

TEST_CASE("fractions that grow longer with each term are refused by the first of them") {
    const auto begin = std::chrono::steady_clock::now();
    const Realisation found =
        realise(read_specification("1,1,2,184467440737095516152,184463,8,5,8"));
    CHECK(found.kind == Realisation::Kind::impossible);
    CHECK(found.because.find("a(8) = ") == 0);
    CHECK(std::chrono::steady_clock::now() - begin < std::chrono::milliseconds(500));
}
