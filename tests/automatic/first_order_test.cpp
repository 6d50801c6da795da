// First-order statements about infinite words: numerations against words written out, answers against evaluation of the formulas on
// prefixes, known results of the literature.

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "automatic/known_words.hpp"
#include "automatic/random_formulas.hpp"
#include "exact/exact.hpp"

using namespace algae;

namespace {

FirstOrderAnswer answer(const AutomaticWord& word, const std::string& text) {
    return decide_first_order(read_first_order(text, "statement", "T", word.letters), word,
                              Budget());
}

bool holds(const char* name, const std::string& text) {
    for (const KnownWord& one : words())
        if (std::string(one.name) == name) return answer(one.word(), text).holds;
    FAIL(name);
    return false;
}

}  // namespace

TEST_CASE("numbers of the numeration of Dumont and Thomas are those of the letters of the word") {
    std::size_t numbers = 0;
    for (const KnownWord& one : words()) {
        CAPTURE(one.name);
        const AutomaticWord word = one.word();
        const std::string prefix = one.prefix(600);
        std::vector<std::uint32_t> before;
        for (int n = 0; n < 600; ++n) {
            const auto digits = word.numeration.digits(n);
            REQUIRE(word.numeration.value(digits) == Integer(n));
            REQUIRE((digits.empty() || digits.front() != 0));
            if (n > 0) REQUIRE((digits.size() > before.size() || digits > before));  // radix order
            before = digits;
            REQUIRE(word.letters[word.numeration.state(n)] ==
                    std::string(1, prefix[static_cast<std::size_t>(n)]));
            ++numbers;
        }
    }
    CHECK(numbers == 600 * words().size());
    const Numeration fibonacci(system_of({{'a', "ab"}, {'b', "a"}}));
    CHECK(fibonacci.value({1, 1}) == std::nullopt);  // no two ones follow each other
    const Integer far = power(Integer(10), 60);
    CHECK(fibonacci.value(fibonacci.digits(far)) == far);
}

TEST_CASE("statements with bounded quantifiers say of numbers what prefixes say") {
    std::size_t formulas = 0, large = 0, tuples = 0, true_ones = 0, far = 0, true_far_ones = 0;
    const std::vector<std::string> names{"i", "n"};
    // By how deep quantifiers are: numbers for which the prefix still has all letters, and the quantifiers are gone through in time.
    constexpr int most[] = {15'000, 2'000, 60, 15};
    for (const KnownWord& one : words()) {
        CAPTURE(one.name);
        const AutomaticWord word = one.word();
        const std::string prefix = one.prefix(100'000);
        CHECK(rc::check("formulas", [&] {
            const Formula formula = random_formula(prefix, names, *rc::gen::inRange(0, 4));
            RC_LOG(formula.text);
            const FirstOrderStatement statement =
                read_first_order(formula.text, "random", "T", word.letters);
            Budget small;  // some statements have large automata
            small.memory = 16 << 20;
            FirstOrderAnswer found;
            try {
                found = decide_first_order(statement, word, small);
            } catch (const BoundReached&) {
                ++large;
                return;
            }
            const auto compared = [&](int i, int n) {
                std::vector<Integer> numbers;
                for (const std::string& name : statement.free())
                    numbers.emplace_back(name == "i" ? i : n);
                const bool said = formula.says({{"i", i}, {"n", n}});
                RC_ASSERT(contains(found.relation, word.numeration, numbers) == said);
                return said;
            };
            for (int i = 0; i < 8; ++i)
                for (int n = 0; n < 8; ++n, ++tuples) true_ones += compared(i, n);
            for (int k = 0; k < 6; ++k, ++far) {
                const int below = most[std::min(formula.deep, 3)];
                true_far_ones += compared(*rc::gen::inRange(0, below), *rc::gen::inRange(0, below));
            }
            ++formulas;
        }));
    }
    MESSAGE(formulas << " formulas, " << large << " with large automata left out, " << tuples
                     << " tuples, " << true_ones << " of them hold; " << far
                     << " tuples of greater numbers, " << true_far_ones << " of them hold");
    CHECK(formulas + large == 100 * words().size());
    CHECK(formulas >= 90 * words().size());
    CHECK(true_ones > tuples / 10);
    CHECK(true_ones < tuples - tuples / 10);
    CHECK(far == 6 * formulas);
    CHECK(true_far_ones > far / 10);
    CHECK(true_far_ones < far - far / 10);
}

TEST_CASE("known results on repetitions, reversal and recurrence") {
    const auto power = [](int times) {
        return "for some i, n with n >= 1: for all k < " + std::to_string(times - 1) +
               "*n: T[i+k] = T[i+n+k]";
    };
    const std::string
        overlap = "for some i, n with n >= 1: for all k <= n: T[i+k] = T[i+n+k]",
        reversed =
            "for all i, n: for some j: for all u, v with u >= i and u < i+n and u+v+1 = "
            "i+j+n: T[u] = T[v]",
        squares = "for all m: for some i, n with n > m: equal(i, i+n, n)",
        rich =
            "for all n with n >= 1: for some m with m >= 1 and m <= n: "
            "(for some i with i + m = n: palindrome(i, m)) and not (for some j with j + m < n: "
            "for all i with i + m = n: equal(i, j, m))";
    CHECK(!holds("Thue-Morse", overlap));  // Thue 1912
    CHECK(holds("Thue-Morse", squares));
    CHECK(holds("Thue-Morse", "for all i, n: for some j: for all k < n: T[i+k] != T[j+k]"));
    CHECK(!holds("Thue-Morse", "for some m, p with p >= 1: for all u with u >= m: T[u] = T[u+p]"));
    CHECK(holds("Thue-Morse",
                "for all i, j, n with n >= 1: for some k with j <= k <= j+9n: equal(i, k, n)"));
    CHECK(holds("Rudin-Shapiro", power(4)));
    CHECK(!holds("Rudin-Shapiro", power(5)));
    CHECK(!holds("Stewart", power(3)));
    CHECK(!holds("Stewart", reversed));  // Noche 2008
    CHECK(holds("Fibonacci", power(3)));
    CHECK(!holds("Fibonacci", power(4)));  // Karhumaki 1983
    CHECK(holds("Fibonacci", reversed));
    CHECK(holds("Fibonacci", rich));      // Droubay, Justin and Pirillo 2001
    CHECK(holds("Tribonacci", squares));  // Mousavi and Shallit 2014
    CHECK(holds("Tribonacci", power(2)));
    CHECK(!holds("Narayana", power(3)));
    CHECK(holds("Narayana", power(2)));
    CHECK(holds("Pell", power(4)));
    CHECK(!holds("Pell", power(5)));
    const AutomaticWord thue = words()[0].word();
    // The orders of squares in the Thue-Morse word are 2^k and 3 2^k (Pansiot 1981; Brlek 1989).
    const FirstOrderAnswer orders = answer(thue, "n >= 1 and for some i: equal(i, i+n, n)");
    std::vector<std::vector<Integer>> wanted;
    for (const int n : {1, 2, 3, 4, 6, 8, 12, 16, 24, 32}) wanted.push_back({n});
    CHECK(members(orders.relation, thue.numeration, 10) == wanted);
}

TEST_CASE(
    "complexities for all lengths are those of long prefixes, and formulas those of the "
    "literature") {
    std::size_t values = 0;
    for (const char* name : {"Thue-Morse", "Fibonacci", "Rudin-Shapiro", "Stewart", "Pell",
                             "Tribonacci", "not primitive", "Sturmian", "period doubling"}) {
        const auto one = std::ranges::find_if(
            words(), [&](const KnownWord& word) { return word.name == std::string(name); });
        CAPTURE(name);
        const AutomaticWord word = one->word();
        const std::string prefix = one->prefix(20'000);
        const ComplexityProofs proofs = complexity_proofs(word, Budget());
        for (const bool palindromes : {false, true}) {
            CAPTURE(palindromes);
            const ComplexityProof& proof = palindromes ? proofs.palindromes : proofs.factors;
            for (std::size_t n = 0; n <= 30; ++n) {
                std::set<std::string> factors;
                for (std::size_t i = 0; i + n <= prefix.size(); ++i) {
                    const std::string factor = prefix.substr(i, n);
                    if (!palindromes || factor == std::string(factor.rbegin(), factor.rend()))
                        factors.insert(factor);
                }
                const Integer value(factors.size());
                REQUIRE(proof.sequence.value(word.numeration, Integer(n)) == value);
                if (proof.linear && Integer(n) >= proof.linear->from)
                    REQUIRE(proof.linear->slope * Integer(n) + proof.linear->constant == value);
                if (proof.periodic && Integer(n) >= proof.periodic->from)
                    REQUIRE(proof.periodic->values[n % proof.periodic->values.size()] == value);
                ++values;
            }
        }
    }
    CHECK(values == 9 * 2 * 31);
    const auto linear = [](std::size_t at) {
        const auto found = complexity_proofs(words()[at].word(), Budget()).factors.linear;
        REQUIRE(found);
        return std::vector<Integer>{found->slope, found->constant, found->from};
    };
    CHECK(linear(1) == std::vector<Integer>{1, 1, 0});   // Morse and Hedlund 1940
    CHECK(linear(3) == std::vector<Integer>{8, -8, 8});  // Allouche and Shallit 1993
    const ComplexityProof thue = complexity_proofs(words()[0].word(), Budget()).factors;
    CHECK(!thue.linear);
    CHECK(thue.differences == std::vector<Integer>{1, 2, 4});  // Brlek 1989
    const auto palindromes = complexity_proofs(words()[1].word(), Budget()).palindromes.periodic;
    REQUIRE(palindromes);
    CHECK(palindromes->values == std::vector<Integer>{1, 2});  // Droubay 1995
    CHECK(palindromes->from == 0);
}

TEST_CASE("what cannot be counted is refused") {
    const AutomaticWord fibonacci = words()[1].word();
    const auto relation = [&](const std::string& text) { return answer(fibonacci, text).relation; };
    CHECK_THROWS_WITH_AS(counts(relation("i > n"), "n", fibonacci.numeration),
                         "infinitely many numbers belong to one n, so they cannot be counted",
                         Error);
    CHECK_THROWS_AS(counts(relation("i > 3"), "n", fibonacci.numeration), Error);
    const LinearRepresentation below = counts(relation("i < n"), "n", fibonacci.numeration);
    for (int n = 0; n < 100; ++n) CHECK(below.value(fibonacci.numeration, n) == n);
}

TEST_CASE("what makes a statement true or false is told") {
    const AutomaticWord fibonacci = words()[1].word();
    const auto cube =
        answer(fibonacci, "for some i, n with n >= 1: for all k < 2n: T[i+k] = T[i+n+k]");
    CHECK(cube.holds);
    REQUIRE(cube.witness.size() == 2);
    std::map<std::string, std::size_t> at;
    for (const auto& [name, value] : cube.witness)
        at[name] = static_cast<std::size_t>(value.to_int64());
    const std::string prefix = words()[1].prefix(10'000);
    for (std::size_t k = 0; k < 2 * at["n"]; ++k)
        CHECK(prefix[at["i"] + k] == prefix[at["i"] + at["n"] + k]);
    const auto denied = answer(fibonacci, "not (for some i: T[i] = T[i+1])");
    CHECK(!denied.holds);
    REQUIRE(denied.witness.size() == 1);
    CHECK(denied.witness[0].second == 2);  // ab aa
    CHECK(answer(fibonacci, "not for all i: T[i] = a").witness.size() == 1);
    CHECK(answer(fibonacci, "not for some i: T[i] = b and T[i+1] = b").holds);
    const auto no = answer(fibonacci, "for all i: T[i] = a or T[i+1] = b");
    CHECK(!no.holds);
    REQUIRE(no.witness.size() == 1);
    const auto i = static_cast<std::size_t>(no.witness[0].second.to_int64());
    CHECK(prefix.substr(i, 2) == "ba");
}

TEST_CASE("words without a numeration or without addition are refused by name") {
    const auto refused = [](const Rules& rules, const std::string& statement) {
        try {
            const AutomaticWord word = KnownWord{"", rules, {}}.word();
            answer(word, statement);
        } catch (const Error& error) {
            return std::string(error.what());
        }
        return std::string("nothing");
    };
    CHECK(refused({{'a', "abc"}, {'b', ""}, {'c', "a"}}, "0 = 0") ==
          "written: no infinite word with a numeration of its own: 'b' vanishes; an equivalent "
          "system without "
          "erasing rules has one");
    CHECK(refused({{'a', "b"}, {'b', "ab"}}, "0 = 0") ==
          "written: no infinite word with a numeration of its own: the first letters of the words "
          "go round, 'a' among them");
    CHECK(refused({{'a', "a"}}, "0 = 0") ==
          "written: no infinite word with a numeration of its own: its words begin with 'a', which "
          "stays as it is");
    const std::string chacon = refused({{'a', "abbb"}, {'b', "a"}}, "for all i: T[i + i] = b");
    CHECK(chacon.find(
              "addition is not known to be regular in the numeration of this word: the lengths of "
              "its images "
              "follow the recurrence of x^2 - x - 3, whose roots are not one Pisot number") == 0);
    // Without sums there is an answer even there.
    CHECK(answer(KnownWord{"", {{'a', "abbb"}, {'b', "a"}}, {}}.word(),
                 "for all i: for some j with j > i: T[j] = b")
              .holds);
}

TEST_CASE("long chains of iff are decided, and those of implies are refused") {
    const AutomaticWord word = words()[1].word();
    const auto chain = [](const std::string& link, std::size_t links) {
        std::string all;
        for (std::size_t i = 0; i < links; ++i) all += link;
        return all;
    };
    CHECK(answer(word, chain("0 = 1 iff ", 10'000) + "0 = 0").holds);
    CHECK(!answer(word, chain("0 = 1 iff ", 9'999) + "0 = 0").holds);
    const FirstOrderAnswer both = answer(word, "T[i] = a iff i > 3 iff i < 6");
    CHECK(members(both.relation, word.numeration, 4) ==
          std::vector<std::vector<Integer>>{{1}, {5}, {6}, {9}});
    CHECK(answer(word, chain("0 = 0 implies ", 150) + "0 = 0").holds);
    for (const char* deep : {"0 = 0 implies ", "0 = 0 => ", "not ", "for all i: "})
        CHECK_THROWS_WITH_AS(answer(word, chain(deep, 100'000) + "0 = 0"),
                             doctest::Contains("the statement is nested more than 200 deep"),
                             Diagnostics);
}

TEST_CASE("errors in statements name the place and what could stand there") {
    const std::vector<std::string> letters{"a", "b"};
    const auto message = [&](const std::string& text) {
        try {
            read_first_order(text, "statement", "T", letters);
        } catch (const Diagnostics& found) {
            const Diagnostic& one = found.findings().front();
            return std::to_string(one.place.column) + ": " + one.message;
        }
        return std::string("nothing");
    };
    CHECK(message("for all i: T[i]") == "16: expected a comparison: = != < <= > >=, found the end");
    CHECK(message("T[i - n] = a") ==
          "1: expected a position without differences, which may be below 0; say it by another "
          "variable: for some j "
          "with j + n = i: ... T[j]");
    CHECK(message("i * n = 3") ==
          "5: expected a number: products of variables are not linear, and truth is not decidable "
          "with them");
    CHECK(message("T[i] = c") == "8: expected a letter of the word, a or b, found 'c'");
    CHECK(message("T[i] < a") == "6: expected '=' or '!=' between letters, found '<'");
    CHECK(message("for all T: 0 = 0") == "9: expected a variable, 'T' is the word");
    CHECK(message("for all i, n >= 1: 0 = 0") ==
          "14: expected 'with' before the condition of several variables");
    CHECK(message("W[i] = a") == "1: expected the word T, found 'W'");
    CHECK(message("i = 1 and") == "10: expected a number, a variable or T[...], found the end");
    CHECK(message("(i = 1") == "7: expected ')' behind the statement, found the end");
    CHECK(message("i = 1 i = 2") ==
          "7: expected 'and', 'or', 'implies', 'iff' or the end, found 'i'");
    CHECK(message("T + 1 = 2") == "3: expected '[' and a position behind the word T, found '+'");
    CHECK(message(std::string(1000, '(') + "0 = 0").find("nested more than 200 deep") !=
          std::string::npos);
    CHECK(message("equal(i, j) = 1").find("expected ',' between the terms, found ')'") !=
          std::string::npos);
    CHECK(message("T[i] = 'a' and T[0] != b and 'b' = T[2i+1]") == "nothing");
}

TEST_CASE("bounds of memory and time end a decision") {
    const AutomaticWord tribonacci = words()[2].word();
    Budget small;
    small.memory = 1 << 20;
    const auto statement = read_first_order(
        "for all i, n: for some j: for all u, v with u >= i and u < i+n and u+v+1 = i+j+n: T[u] = "
        "T[v]",
        "statement", "T", tribonacci.letters);
    CHECK_THROWS_AS(decide_first_order(statement, tribonacci, small), BoundReached);
    Budget short_time;
    short_time.deadline = std::chrono::steady_clock::now();
    CHECK_THROWS_AS(decide_first_order(statement, tribonacci, short_time), BoundReached);
}
