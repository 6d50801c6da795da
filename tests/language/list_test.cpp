// Words of languages, listed, counted and drawn: against the words that an evaluator by definition finds, and against each other.

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "growth/growth.hpp"
#include "language/language.hpp"
#include "model/model.hpp"
#include "notation/notation.hpp"
#include "oracle/language_words.hpp"
#include "random_languages.hpp"

using namespace algae;

namespace {

constexpr std::uint64_t any_number = std::uint64_t{1} << 62;

WrittenLanguage read(const std::string& text) {
    return read_language(text, [](const std::string& name) {
        for (const GalleryEntry& entry : gallery())
            if (entry.name == name) return read_lsystem(entry.text, name + ".lsys");
        return read_lsystem(name, "system");
    });
}

WordList list(const std::string& text, const ListLimits& limits, const Budget& budget = {}) {
    const WrittenLanguage written = read(text);
    return list_words(written.language, *written.alphabet, limits, budget);
}

/// The words up to a length, with blanks between; how much is known of others behind.
std::string listed(const std::string& text, std::uint64_t length,
                   std::uint64_t words = any_number) {
    const WrittenLanguage written = read(text);
    const WordList found = list_words(written.language, *written.alphabet, {length, words});
    std::string all =
        joined(found.words, " ", [&](const Word& word) { return spell(*written.alphabet, word); });
    if (found.whole) return all + " and no other";
    if (found.full) return all + " ...";
    return found.decided == length + 1 ? all
                                       : all + " at least, up to " + std::to_string(found.decided);
}

bool is_before(const Word& left, const Word& right) {
    return left.size() != right.size() ? left.size() < right.size() : left < right;
}

/// The first coefficients of the power series.
std::vector<Integer> series(const GeneratingFunction& function, std::size_t count) {
    std::vector<Integer> all;
    for (std::size_t n = 0; n < count; ++n) {
        Integer value = function.numerator.coefficient(n);
        for (std::size_t k = 1; k <= n; ++k)
            value -= function.denominator.coefficient(k) * all[n - k];
        all.push_back(value);
    }
    return all;
}

WordCounts counts(const std::string& text, std::uint64_t longest) {
    const WrittenLanguage written = read(text);
    return count_words(written.language, *written.alphabet, longest);
}

std::vector<std::string> drawn(const std::string& text, std::uint64_t length, std::uint64_t count,
                               std::uint64_t seed) {
    const WrittenLanguage written = read(text);
    std::vector<std::string> all;
    for (const Word& word : draw_words(written.language, *written.alphabet, length, count, seed))
        all.push_back(spell(*written.alphabet, word));
    return all;
}

}  // namespace

TEST_CASE("the words of a random expression are those of its definition") {
    int compared = 0, asked = 0, decided = 0, found_words = 0;
    const auto letters = random::letters();
    CHECK(rc::check("list", [&] {
        const random::Languages languages = *random::any_language({3});
        constexpr std::size_t longest = 5;
        ++asked;
        const auto expected = oracle::language_words(languages.all[0], longest);
        if (!expected) return;
        ++compared;
        const WordList found = list_words(languages.all[0], *letters, {longest, any_number});
        RC_ASSERT(std::is_sorted(found.words.begin(), found.words.end(), is_before));
        for (const Word& word : found.words) RC_ASSERT(expected->contains(word));
        std::size_t due = 0;
        for (const Word& word : *expected) due += word.size() < found.decided ? 1 : 0;
        const auto known =
            std::count_if(found.words.begin(), found.words.end(),
                          [&](const Word& word) { return word.size() < found.decided; });
        RC_ASSERT(static_cast<std::size_t>(known) == due);
        RC_ASSERT((found.decided == longest + 1) == found.stopped.empty() || found.whole);
        if (found.stopped.empty()) ++decided;
        found_words += static_cast<int>(found.words.size());

        // A shorter list is the beginning of it.
        const std::uint64_t some = *rc::gen::inRange<std::uint64_t>(1, 8);
        const WordList first = list_words(languages.all[0], *letters, {longest, some});
        RC_ASSERT(first.full == (found.words.size() >= some));
        for (std::size_t i = 0; found.stopped.empty() && i < first.words.size(); ++i)
            RC_ASSERT(first.words[i] == found.words[i]);

        const WordCounts by_length = count_words(languages.all[0], *letters, longest);
        std::vector<Integer> numbers(longest + 1, Integer(0));
        for (const Word& word : *expected) numbers[word.size()] += 1;
        if (found.stopped.empty()) RC_ASSERT(by_length.counts == numbers);
    }));
    MESSAGE(compared << " of " << asked << " compared, " << decided << " of these decided, "
                     << found_words << " words");
    CHECK(compared * 10 >= asked * 6);
    CHECK(decided * 10 >= compared * 9);
}

TEST_CASE("the generating function has the numbers of words as coefficients, in lowest terms") {
    int regular = 0;
    const auto letters = random::letters();
    CHECK(rc::check("function", [&] {
        const random::Languages languages = *random::any_language({3});
        constexpr std::size_t longest = 40;
        const Language& language = languages.all[0];
        const WordCounts found = count_words(language, *letters, 4);
        if (!found.function) return;
        ++regular;
        const WordCounts more = count_words(language, *letters, longest);
        RC_ASSERT(*more.function == *found.function);
        RC_ASSERT(series(*found.function, longest + 1) == more.counts);
        RC_ASSERT(found.function->denominator.coefficient(0) == Integer(1));
        const WordList words = list_words(language, *letters, {4, any_number});
        Integer all = 0;
        for (const Integer& count : found.counts) all += count;
        RC_ASSERT(all == Integer(words.words.size()));
        RC_ASSERT(found.whole == words.whole);
        if (!found.function->numerator.is_zero())
            RC_ASSERT(gcd(found.function->numerator, found.function->denominator).degree() == 0);
        else
            RC_ASSERT(found.function->denominator.degree() == 0);
    }));
    MESSAGE(regular << " regular languages");
    CHECK(regular >= 5);
}

TEST_CASE(
    "words of every kind of language are listed shortest first, then by the names of their "
    "letters") {
    CHECK(listed("{b, a, ε, ab}", 5) == "ε a b ab and no other");
    CHECK(listed("/b|a/ /(b|a)*/", 2) == "a b aa ab ba bb");
    CHECK(listed("/b|a/ /(b|a)*/", 100, 4) == "a b aa ab ...");
    CHECK(listed("{}", 3) == " and no other");
    CHECK(listed("~{a}", 3) == "ε aa aaa");
    CHECK(listed("~(L(axiom a; a -> aa)) & /a+/", 6) == "aaa aaaaa aaaaaa");
    CHECK(listed("L(axiom a; a -> aa)", 16) == "a aa aaaa aaaaaaaa aaaaaaaaaaaaaaaa");
    CHECK(listed("L(axiom a; a -> b | ε; b -> aa)", 3) == "ε a b aa bb bbb");
    CHECK(listed("{a^n b^(2n) : n >= 0}", 6) == "ε abb aabbbb");
    CHECK(listed("{a^n b^m : n >= 1, m >= 2} & {a^(n^2) b^(2n) : n >= 0}", 9) == "abb aaaabbbb");
    CHECK(listed("CF { S -> aSa | bSb | ε }", 4) == "ε aa bb aaaa abba baab bbbb");
    CHECK(listed("CF { S -> SS | aSb | ε }", 4) == "ε ab aabb abab");
    CHECK(listed("{ a -> ab; b -> a }(L(axiom a; a -> aa))", 9) == "ab abab abababab");
    CHECK(listed("{ a -> ε; b -> b }({a^n b^n : n >= 0})", 3) == "ε b bb bbb");
    CHECK(listed("{ x -> a; y -> aa }^-1(L(axiom a; a -> aa))", 3) == "x y xx yy xxy xyx yxx");
    CHECK(listed("{a^(2^n) : n >= 0} {b} | {c}+", 4) == "c ab cc aab ccc cccc");
    CHECK(listed("{a^n b^n : n >= 1}*", 6) == "ε ab aabb abab aaabbb aabbab abaabb ababab");
    CHECK(listed("{a^n b^n : n >= 1}+ \\ {a^n b^n : n >= 1}", 6) == "abab aabbab abaabb ababab");
    CHECK(listed("({a^n b : n >= 0} {a^(2^n) : n >= 0})^R", 4) == "ab aab aba aaba abaa");
    CHECK(listed("L(axiom S; S -> aS | b; terminals a b)", 3) == "b ab aab");
    CHECK(listed("L(axiom ab; a < b -> ba; a -> a)", 6).starts_with("ab aba"));
    CHECK(listed("L(axiom a; table x; a -> aa; table y; a -> aaa)", 12) ==
          "a aa aaa aaaa aaaaaa aaaaaaaa aaaaaaaaa aaaaaaaaaaaa");
}

TEST_CASE("what is not decided is open, and what is listed is in the language") {
    // An erasing system with context may come back to short words at any time.
    const WordList open = list("L(axiom ab; a -> aa; a < b -> ε; b -> ab)", {5, any_number});
    CHECK(open.decided == 0);
    CHECK(!open.whole);
    CHECK(open.stopped.find("may be shorter") != std::string::npos);
    Budget budget;
    budget.memory = 200'000;
    const WordList bounded = list("/(a|b)*/", {40, any_number}, budget);
    CHECK(bounded.stopped.find("would take more than") != std::string::npos);
    CHECK(bounded.decided >= 5);
    CHECK(bounded.words.at(6) == Word{1, 1});
    const WordList dense = list("/(a|b)*/ {a^n c^n : n >= 1}", {40, any_number}, budget);
    CHECK(dense.stopped.find("would take more than") != std::string::npos);
    CHECK(dense.decided >= 4);
    // The number that was asked for is there before the memory ends.
    CHECK(list("/(a|b)*/ {a^n c^n : n >= 1}", {1000, 20}, budget).stopped.empty());
    const WrittenLanguage written = read("L(axiom ab; a -> aa; a < b -> ε; b -> ab)");
    CHECK_THROWS_AS(static_cast<void>(draw_words(written.language, *written.alphabet, 3, 1, 1)),
                    BoundReached);
}

TEST_CASE("numbers of words and their generating functions") {
    const auto function = [](const std::string& text) {
        return to_string(*counts(text, 3).function);
    };
    CHECK(counts("/(a|b)*/", 100).counts[100] == power(Integer(2), 100));
    CHECK(function("/(a|b)*/") == "1/(1 - 2x)");
    CHECK(function("~/(a|b)*bb(a|b)*/") == "(1 + x)/(1 - x - x^2)");
    CHECK(function("{ε, a, ab}") == "1 + x + x^2");
    CHECK(function("{}") == "0");
    CHECK(counts("{ε, a, ab}", 2).whole);
    CHECK(!counts("{ε, a, ab}", 1).whole);
    CHECK(counts("CF { S -> aSb | ε }", 5).counts == std::vector<Integer>{1, 0, 1, 0, 1, 0});
    CHECK(!counts("CF { S -> aSb | ε }", 5).function);
    CHECK(counts("CF { S -> SS | aSb | ε }", 10).counts ==
          std::vector<Integer>{1, 0, 1, 0, 2, 0, 5, 0, 14, 0, 42});
}

TEST_CASE("words of a length are drawn with equal chance") {
    // By chi-square with fixed seeds: with k - 1 degrees of freedom the sum is below k + 4 sqrt(2k) but for one in thousands.
    const auto spread = [](const std::string& text, std::uint64_t length) {
        const WordList all = list(text, {length, any_number});
        std::size_t words = 0;
        for (const Word& word : all.words) words += word.size() == length ? 1 : 0;
        REQUIRE(words > 1);
        const std::uint64_t draws = 200 * words;
        std::map<std::string, double> times;
        for (const std::string& word : drawn(text, length, draws, 7)) times[word] += 1;
        CHECK(times.size() == words);
        double sum = 0;
        for (const auto& [word, count] : times) sum += (count - 200) * (count - 200) / 200;
        const auto k = static_cast<double>(words);
        CHECK(sum < k + 4 * std::sqrt(2 * k));
        CHECK(sum > 0);
    };
    spread("/(a|bb)*/", 6);
    spread("/(a|b|c)*/ \\ /(a|b)*/", 4);
    spread("CF { S -> SS | aSb | ε }", 8);
    spread("{a, aab}* | {c}* {b}", 7);
    CHECK(drawn("/(a|bb)*/", 6, 5, 3) == drawn("/(a|bb)*/", 6, 5, 3));
    CHECK(drawn("/(a|bb)*/", 6, 20, 3) != drawn("/(a|bb)*/", 6, 20, 4));
    CHECK(drawn("/(aa)*/", 5, 3, 1).empty());
    CHECK(drawn("{a^(2^n) : n >= 0}", 3, 3, 1).empty());
    const std::vector<std::string> one = drawn("/a*/", 300, 2, 1);
    CHECK(one == std::vector<std::string>(2, std::string(300, 'a')));
    // Numbers beyond 64 bits.
    std::string together;
    for (const std::string& word : drawn("/(a|b)*/", 500, 4, 9)) together += word;
    const auto as = std::count(together.begin(), together.end(), 'a');
    CHECK(std::abs(as - 1000) < 100);
}
