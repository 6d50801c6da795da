// Critical exponents, and how far apart equal factors are, against words written out and results of the literature.

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "automatic/known_words.hpp"
#include "exact/exact.hpp"

using namespace algae;

namespace {

const KnownWord& named(const std::string& name) {
    for (const KnownWord& one : words())
        if (one.name == name) return one;
    throw Error("no word " + name);
}

/// The greatest exponent with a period up to some length, by comparing letters.
Rational greatest_exponent(const std::string& word, std::size_t longest_period) {
    Rational best = 1;
    for (std::size_t p = 1; p <= longest_period; ++p)
        for (std::size_t i = 0, same = 0; i + p < word.size(); ++i) {
            same = word[i] == word[i + p] ? same + 1 : 0;
            best = std::max(best, Rational(Integer(same + p), Integer(p)));
        }
    return best;
}

/// Least r such that all factors of r letters have all factors of n letters, on a prefix; nothing if none up to `most` has.
std::optional<std::uint64_t> recurrence_on(const std::string& word, std::size_t n,
                                           std::size_t most) {
    const auto factors = [&](std::string_view text) {
        std::set<std::string_view> all;
        for (std::size_t i = 0; i + n <= text.size(); ++i) all.insert(text.substr(i, n));
        return all.size();
    };
    const std::size_t all = factors(word);
    for (std::size_t r = n; r <= most; ++r) {
        bool every = true;
        for (std::size_t i = 0; i + r <= word.size() && every; ++i)
            every = factors(std::string_view(word).substr(i, r)) == all;
        if (every) return r;
    }
    return std::nullopt;
}

Rules random_rules(std::size_t letters) {
    Rules rules;
    for (std::size_t a = 0; a < letters; ++a) {
        const auto length = *rc::gen::inRange<std::size_t>(1, 4);
        std::string image;
        for (std::size_t i = 0; i < length; ++i)
            image += static_cast<char>('a' + *rc::gen::inRange<int>(0, static_cast<int>(letters)));
        rules.emplace_back(static_cast<char>('a' + a), image);
    }
    rules[0].second.insert(0, 1, 'a');
    return rules;
}

}  // namespace

TEST_CASE("critical exponents of words of the literature") {
    const auto exponent = [](const char* name) {
        return critical_exponent(named(name).word(), Budget());
    };
    const auto fibonacci = exponent("Fibonacci");  // Mignosi and Pirillo 1992
    CHECK(fibonacci.value->exact() == "(5+sqrt(5))/2");
    CHECK(!fibonacci.attained);
    CHECK(fibonacci.asymptotic->exact() == "(5+sqrt(5))/2");
    CHECK(exponent("Pell").value->exact() == "3+sqrt(2)");  // Carpi and de Luca 2000
    CHECK(!exponent("Pell").attained);
    const auto thue = exponent("Thue-Morse");  // Thue 1912
    CHECK(thue.value->exact() == "2");
    CHECK(thue.attained);
    CHECK(thue.factor == std::pair(Integer(2), Integer(1)));
    const auto stewart = exponent("Stewart");  // Noche 2008
    CHECK(stewart.value->exact() == "3");
    CHECK(!stewart.attained);
    const auto doubling = exponent("period doubling");  // Damanik 2000
    CHECK(doubling.value->exact() == "4");
    CHECK(!doubling.attained);
    const auto rudin = exponent("Rudin-Shapiro");  // Allouche and Bousquet-Melou 1994
    CHECK(rudin.value->exact() == "4");
    CHECK(rudin.attained);
    // Tan and Wen 2007: 2 + 1 / (r - 1) for r^3 = r^2 + r + 1.
    CHECK(exponent("Tribonacci").value->decimal(10) == "3.1914878840");
    CHECK(!exponent("Tribonacci").attained);
    CHECK(exponent("not primitive").infinite);  // all powers of b
    CHECK(critical_exponent(KnownWord{"", {{'a', "ab"}, {'b', "ab"}}}.word(), Budget()).infinite);
}

TEST_CASE("no factor of a long prefix passes the critical exponent, and some come near") {
    std::size_t decided = 0, attained = 0, undecided = 0;
    const auto try_one = [&] {
        const Rules rules = random_rules(*rc::gen::element<std::size_t>(2, 2, 3));
        std::optional<CriticalExponent> found;
        const KnownWord one{"random", rules};
        try {
            Budget budget;
            budget.memory = std::uint64_t{64} << 20;
            found = critical_exponent(one.word(), budget);
        } catch (const BoundReached&) {
            ++undecided;
            return;
        } catch (const Error&) {
            return;  // no numeration, or no sums
        }
        const std::string prefix = one.prefix(3'000);
        if (found->infinite) {
            RC_ASSERT(greatest_exponent(prefix, 100) > Rational(20));
            return;
        }
        const Rational seen = greatest_exponent(prefix, 300);
        const Ball value = found->value->enclosure(128);
        RC_ASSERT(value.upper() >= seen);
        RC_ASSERT(seen.to_double() > value.midpoint() * 0.95);
        if (found->factor) {
            const auto& [n, p] = *found->factor;
            RC_ASSERT(value.contains(Rational(n, p)));
            if (n < Integer(1'000)) {
                RC_ASSERT(seen == Rational(n, p));
                ++attained;
            }
        } else {
            RC_ASSERT(value.lower() > seen);
        }
        ++decided;
    };
    CHECK(rc::check([&] {
        for (int i = 0; i < 3; ++i) try_one();
    }));
    MESSAGE(decided << " decided, " << attained << " of them attained, " << undecided
                    << " undecided");
    CHECK(decided >= 8);
}

TEST_CASE(
    "critical exponents by return words: those of automata, and where addition is not regular") {
    std::size_t compared = 0;
    for (const KnownWord& one : words()) {
        // Automata of the other words are large.
        if (!one.coding.empty() || one.name == std::string("flipped Tribonacci") ||
            one.name == std::string("eigenvalue 0"))
            continue;
        CAPTURE(one.name);
        std::optional<CriticalExponent> found;
        try {
            found = critical_exponent(system_of(one.rules), Budget());
        } catch (const BoundReached&) {
            continue;
        }
        const CriticalExponent known = critical_exponent(one.word(), Budget());
        CHECK(found->infinite == known.infinite);
        if (known.infinite) continue;
        CHECK(found->value->exact() == known.value->exact());
        CHECK(found->attained == known.attained);
        CHECK(found->factor == known.factor);
        REQUIRE(found->asymptotic);
        CHECK(found->asymptotic->exact() == known.asymptotic->exact());
        ++compared;
    }
    CHECK(compared >= 5);
    const auto exponent = [](const Rules& rules) {
        return critical_exponent(system_of(rules), Budget());
    };
    const auto flipped = exponent({{'a', "ab"}, {'b', "ca"}, {'c', "a"}});
    CHECK(flipped.value->exact() == "(r + 5)/2");
    CHECK(!flipped.attained);
    // Lengths by x^2 - 6x + 6 and by x^2 - x - 6: one root above 1, the other one too, or -2.
    CHECK(exponent({{'a', "aabaa"}, {'b', "baab"}}).value->exact() == "3+sqrt(3)");
    CHECK(exponent({{'a', "abb"}, {'b', "aaa"}}).value->exact() == "15/2");
    // Glen and Justin 2009: 2 + 1/(r - 1) with r^4 = r^3 + r^2 + r + 1.
    CHECK(exponent({{'a', "ab"}, {'b', "ac"}, {'c', "ad"}, {'d', "a"}}).value->decimal(8) ==
          "3.07809508");
    CHECK(exponent({{'a', "abab"}, {'b', "c"}, {'c', ""}}).infinite);
}

TEST_CASE("critical exponents by return words are those of long prefixes") {
    std::size_t decided = 0, attained = 0, refused = 0;
    const auto try_one = [&] {
        const Rules rules = random_rules(*rc::gen::element<std::size_t>(2, 2, 3));
        std::optional<CriticalExponent> found;
        try {
            found = critical_exponent(system_of(rules), Budget());
        } catch (const BoundReached&) {
            ++refused;
            return;
        } catch (const Error&) {
            return;  // no infinite word, or its first letter does not come back
        }
        const std::string prefix = KnownWord{"random", rules}.prefix(4'000);
        if (found->infinite) {
            // Letters that do not grow make powers that are longer by one in each generation, as b of a -> aab, b -> b.
            const Rational longest = greatest_exponent(prefix, 100);
            RC_ASSERT(longest > Rational(20) ||
                      (longest > Rational(5) &&
                       longest > greatest_exponent(prefix.substr(0, 1'000), 100)));
            return;
        }
        const Rational seen = greatest_exponent(prefix, 400);
        const Ball value = found->value->enclosure(128);
        RC_ASSERT(value.upper() >= seen);
        RC_ASSERT(seen.to_double() > value.midpoint() * 0.95);
        if (found->factor && found->factor->first < Integer(1'000)) {
            RC_ASSERT(seen == Rational(found->factor->first, found->factor->second));
            ++attained;
        }
        if (!found->attained) RC_ASSERT(value.lower() > seen);
        ++decided;
    };
    CHECK(rc::check([&] {
        for (int i = 0; i < 3; ++i) try_one();
    }));
    MESSAGE(decided << " decided, " << attained << " of them attained, " << refused << " refused");
    CHECK(decided >= 40);
}

TEST_CASE("recurrence functions and return words are those of long prefixes") {
    std::size_t values = 0;
    for (const KnownWord& one : words()) {
        CAPTURE(one.name);
        const FactorRecurrence found = factor_recurrence(one.word(), 5, Budget());
        const std::string prefix = one.prefix(3'000);
        if (std::string(one.name) == "not primitive") {  // runs of b grow
            CHECK(found.values == std::vector<std::uint64_t>{0});
            CHECK(found.return_words.empty());
            continue;
        }
        REQUIRE(found.values.size() == 6);
        for (std::size_t n = 1; n <= 5; ++n) {
            if (found.values[n] > 120) continue;
            CHECK(recurrence_on(prefix, n, 120) == found.values[n]);
            ++values;
        }
        for (const auto& [letter, returns] : found.return_words) {
            std::set<std::string> expected, all;
            for (std::size_t from = prefix.find(letter), to;; from = to) {
                to = prefix.find(letter, from + 1);
                if (to == std::string::npos) break;
                expected.insert(prefix.substr(from, to - from));
            }
            for (const auto& word : returns) {
                std::string text;
                for (const std::string& part : word) text += part;
                all.insert(text);
            }
            CHECK(all == expected);
        }
    }
    CHECK(values >= 40);
    CHECK(factor_recurrence(named("Fibonacci").word(), 7, Budget()).values ==
          std::vector<std::uint64_t>{0, 3, 6, 10, 11, 17, 18, 19});  // Morse and Hedlund 1940
}

TEST_CASE("random words: recurrence functions are those of long prefixes") {
    std::size_t compared = 0;
    CHECK(rc::check([&] {
        const Rules rules = random_rules(*rc::gen::element<std::size_t>(2, 3));
        const KnownWord one{"random", rules};
        std::optional<FactorRecurrence> found;
        try {
            found = factor_recurrence(one.word(), 3, Budget());
        } catch (const Error&) {
            return;  // no infinite word
        }
        const std::string prefix = one.prefix(4'000);
        for (std::size_t n = 1; n < found->values.size(); ++n) {
            if (found->values[n] > 80) continue;
            RC_ASSERT(recurrence_on(prefix, n, 80) == found->values[n]);
            ++compared;
        }
    }));
    CHECK(compared >= 40);
}

TEST_CASE("closure under reversal is that of long prefixes") {
    std::size_t decided = 0;
    for (const KnownWord& one : words()) {
        if (std::string(one.name) == "not primitive") continue;
        CAPTURE(one.name);
        const std::string prefix = one.prefix(20'000);
        bool closed = true;
        for (std::size_t n = 1; n <= 14; ++n) {
            std::set<std::string> factors;
            for (std::size_t i = 0; i + n <= prefix.size(); ++i)
                factors.insert(prefix.substr(i, n));
            for (const std::string& factor : factors)
                closed = closed && factors.contains(std::string(factor.rbegin(), factor.rend()));
        }
        Budget budget;
        budget.memory = std::uint64_t{128} << 20;
        std::optional<bool> found;
        try {
            found = has_property(one.word(), "closed under reversal", budget);
        } catch (const BoundReached&) {
            continue;
        }
        CHECK(found == closed);
        ++decided;
    }
    CHECK(decided >= 6);
}
