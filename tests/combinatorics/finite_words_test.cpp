#include "combinatorics/combinatorics.hpp"

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <atomic>
#include <numeric>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "oracle/finite_words.hpp"

using namespace algae;

namespace {

Word word_of(const std::string& text) {
    Word word;
    for (const char letter : text) word.push_back(static_cast<Symbol>(letter - 'a'));
    return word;
}

std::string text_of(const Word& word) {
    std::string text;
    for (const Symbol letter : word) text += static_cast<char>('a' + letter);
    return text;
}

std::string part(const std::string& text, const Occurrence& place) {
    return text.substr(place.begin, place.length);
}

bool is_palindrome(const std::string& text) {
    return text == std::string(text.rbegin(), text.rend());
}

/// Powers, palindromes and images by morphisms among them: words at random have few long repetitions.
std::string any_word(std::size_t longest) {
    const std::string letters = *rc::gen::element<std::string>("a", "ab", "abc", "abcd");
    const auto at_random = [&](std::size_t most) {
        const auto size = *rc::gen::inRange<std::size_t>(0, most + 1);
        return *rc::gen::container<std::string>(size, rc::gen::elementOf(letters));
    };
    std::string word = at_random(longest);
    switch (*rc::gen::inRange(0, 4)) {
        case 1: {
            const std::string root = at_random(4);
            word = at_random(2);
            while (!root.empty() && word.size() + root.size() < longest) word += root;
            break;
        }
        case 2:
            word = word.substr(0, longest / 2) + std::string(word.rbegin(), word.rend());
            break;
        case 3: {
            const std::string a = "a" + at_random(2), b = at_random(3);
            for (std::string next = "a"; next.size() <= longest && next != word;) {
                word = next;
                next.clear();
                for (const char letter : word) next += letter == 'a' ? a : b;
            }
            break;
        }
        default:
            break;
    }
    return word.substr(0, longest);
}

void expect(const std::string& text, bool holds) {
    if (!holds) throw std::runtime_error("of " + text);
}

void compare(const std::string& text) {
    const Word word = word_of(text);
    expect(text, borders(word) == oracle::borders_of(text));
    expect(text, periods(word) == oracle::periods_of(text));
    expect(text, text_of(primitive_root(word)) == oracle::root_of(text));
    const PalindromicFactors palindromes = palindromic_factors(word);
    const std::set<std::string> all = oracle::palindromes_of(text);
    expect(text, palindromes.count == all.size());
    expect(text, palindromes.defect == text.size() - all.size());
    std::size_t longest = 0;
    for (const std::string& one : all) longest = std::max(longest, one.size());
    std::set<std::string> longest_ones, found;
    for (const std::string& one : all)
        if (one.size() == longest) longest_ones.insert(one);
    for (const Occurrence& place : palindromes.longest) {
        expect(text, text.find(part(text, place)) == place.begin);
        expect(text, found.insert(part(text, place)).second);
    }
    expect(text, found == longest_ones);
    expect(text, palindromes.fewest.size() == oracle::palindromic_length_of(text));
    std::size_t end = 0;
    for (const Occurrence& place : palindromes.fewest) {
        expect(text, place.begin == end);
        expect(text, is_palindrome(part(text, place)));
        end += place.length;
    }
    expect(text, end == text.size());
    const WordRepetitions repetitions = repetitions_in(word);
    std::set<oracle::Maximal> runs;
    for (const Run& run : repetitions.runs)
        expect(text, runs.insert({run.begin, run.end, run.period}).second);
    expect(text, runs == oracle::runs_of(text));
    expect(text, text.empty() || runs.size() < text.size());
    expect(text, repetitions.distinct_squares == oracle::squares_of(text).size());
    const auto counts = factor_counts(word);
    expect(text, std::vector<std::size_t>(counts.begin(), counts.end()) ==
                     oracle::factor_counts_of(text));
    std::vector<std::pair<std::size_t, std::size_t>> abelian;
    for (const AbelianPeriod& one : abelian_periods(word))
        abelian.emplace_back(one.head, one.period);
    expect(text, abelian == oracle::abelian_periods_of(text));
    expect(text, lempel_ziv_factorisation(word) == oracle::lempel_ziv_of(text));
    const auto sturmian = sturmian_properties(word);
    expect(text, sturmian.has_value() == (std::set<char>(text.begin(), text.end()).size() <= 2));
    if (sturmian) expect(text, sturmian->balanced == oracle::is_balanced(text));
    if (text.empty()) return;
    const std::set<std::string> conjugates = oracle::conjugates_of(text);
    expect(text, text_of(least_conjugate(word)) == *conjugates.begin());
    expect(text, primitive_root(word).size() == conjugates.size());
}

}  // namespace

TEST_CASE("all words of few letters are what the definitions say") {
    std::size_t compared = 0;
    for (const std::string letters : {"ab", "abc"}) {
        std::vector<std::string> words{""};
        const std::size_t longest = letters.size() == 2 ? 9 : 6;
        for (std::size_t length = 0; length <= longest; ++length) {
            std::vector<std::string> longer;
            for (const std::string& text : words) {
                compare(text);
                const auto begins = lyndon_factorisation(word_of(text));
                const auto parts = oracle::lyndon_words_of(text);
                REQUIRE((text.empty() ? begins.empty() : begins.size() == parts.size()));
                for (std::size_t i = 0, at = 0; i < begins.size(); at += parts[i++].size())
                    REQUIRE(begins[i] == at);
                ++compared;
                for (const char letter : letters) longer.push_back(text + letter);
            }
            words = std::move(longer);
        }
    }
    MESSAGE(compared, " words");
    CHECK(compared == 1023 + 1093);
}

TEST_CASE("central, standard and Christoffel words are those of their definitions") {
    constexpr std::size_t longest = 14;
    const std::set<std::string> standard = oracle::standard_words(longest),
                                christoffel = oracle::christoffel_words(longest);
    std::size_t compared = 0, central = 0, balanced = 0;
    std::vector<std::string> words{""};
    for (std::size_t length = 0; length <= longest; ++length) {
        std::vector<std::string> longer;
        for (const std::string& text : words) {
            // The letters have their numbers in the word alone, so a word of the letter b is one of a.
            const SturmianProperties found = *sturmian_properties(word_of(text));
            INFO(text);
            REQUIRE(found.balanced == oracle::is_balanced(text));
            REQUIRE(found.central == oracle::is_central(text));
            REQUIRE(found.standard == standard.contains(text));
            REQUIRE(found.christoffel == christoffel.contains(text));
            central += found.central;
            balanced += found.balanced;
            ++compared;
            for (const char letter : {'a', 'b'}) longer.push_back(text + letter);
        }
        words = std::move(longer);
    }
    CHECK(compared == 32767);
    // The sums over n of Euler's function at n + 2, and of 1 + (n - k + 1) times that at k for k = 1, ..., n (de Luca and Mignosi 1994).
    std::size_t known_central = 0, known_balanced = 0;
    const auto coprime = [](std::size_t n) {
        std::size_t found = 0;
        for (std::size_t k = 1; k <= n; ++k) found += std::gcd(k, n) == 1;
        return found;
    };
    for (std::size_t n = 0; n <= longest; ++n) {
        known_central += coprime(n + 2);
        ++known_balanced;
        for (std::size_t k = 1; k <= n; ++k) known_balanced += (n - k + 1) * coprime(k);
    }
    CHECK(central == known_central);
    CHECK(balanced == known_balanced);
}

TEST_CASE("words with repetitions are what the definitions say") {
    int repetitive = 0, poor = 0, compared = 0;
    CHECK(rc::check([&] {
        const std::string text = any_word(60);
        compare(text);
        ++compared;
        repetitive += oracle::runs_of(text).size() >= 5;
        poor += palindromic_factors(word_of(text)).defect > 0;
    }));
    MESSAGE(compared, " words, ", repetitive, " with five runs or more, ", poor, " not rich");
    CHECK(repetitive >= 4);
    CHECK(poor >= 3);
}

TEST_CASE("many letters, and more than a byte has values") {
    int compared = 0;
    CHECK(rc::check([&] {
        const auto kinds = *rc::gen::element<Symbol>(2, 200, 300, 70000);
        const auto size = *rc::gen::inRange<std::size_t>(300, 1200);
        Word word, small;
        for (std::size_t i = 0; i < size; ++i) word.push_back(*rc::gen::inRange<Symbol>(0, kinds));
        for (std::size_t i = 0; i < 300; ++i) word.push_back(word[i]);  // something to repeat
        for (Symbol i = 0; i < 280; ++i)
            word.push_back(kinds + i);  // so that there are surely many
        std::vector<std::set<Word>> factors(5);
        for (std::size_t k = 0; k < factors.size(); ++k)
            for (std::size_t i = 0; i + k <= word.size(); ++i)
                factors[k].insert(Word(word.begin() + static_cast<std::ptrdiff_t>(i),
                                       word.begin() + static_cast<std::ptrdiff_t>(i + k)));
        const auto counts = factor_counts(word);
        for (std::size_t k = 0; k < factors.size(); ++k) RC_ASSERT(counts[k] == factors[k].size());
        ++compared;
    }));
    CHECK(compared == 100);
}

TEST_CASE("known words") {
    // The Fibonacci word of 4181 letters: rich, n + 1 factors of each small length; of 4180 runs at most.
    Word fibonacci{0}, before{1};
    while (fibonacci.size() < 4181) {
        Word next = fibonacci;
        next.insert(next.end(), before.begin(), before.end());
        before = std::move(fibonacci);
        fibonacci = std::move(next);
    }
    CHECK(palindromic_factors(fibonacci).defect == 0);
    const auto counts = factor_counts(fibonacci);
    for (std::size_t n = 0; n <= 1000; ++n) CHECK(counts[n] == n + 1);
    // The number of runs in Fibonacci words is 2F(n-2) - 3 (Kolpakov and Kucherov 1999): 2 * 1597 - 3.
    CHECK(repetitions_in(fibonacci).runs.size() == 3191);
    // Fraenkel and Simpson 1999: 2(F(n-2) - 1) distinct squares.
    CHECK(repetitions_in(fibonacci).distinct_squares == 3192);
}

TEST_CASE("long words of one letter, of one letter but for one, and at random") {
    for (const int kind : {0, 1, 2}) {
        Word word;
        for (std::uint32_t i = 0, x = 1; i < 300'000; ++i) {
            x = x * 1664525 + 1013904223;
            word.push_back(kind == 0 ? 0 : kind == 1 ? (i == 150'000 ? 1 : 0) : x >> 31);
        }
        const WordRepetitions found = repetitions_in(word);
        if (kind == 0) CHECK(found.distinct_squares == 150'000);
        if (kind == 1) CHECK(found.runs.size() == 2);
        CHECK(palindromic_factors(word).count <= word.size());
        CHECK(factor_counts(word)[1] == (kind == 0 ? 1 : 2));
    }
}

TEST_CASE("work on long words stops when it is told to") {
    const std::atomic<bool> stop = true;
    Budget budget;
    budget.stop = &stop;
    const Word word(100'000, 0);
    CHECK_THROWS_AS(palindromic_factors(word, budget), Interrupted);
    CHECK_THROWS_AS(repetitions_in(word, budget), Interrupted);
    CHECK_THROWS_AS(factor_counts(word, budget), Interrupted);
    CHECK_THROWS_AS(abelian_periods(word, budget), Interrupted);
    Budget small;
    small.memory = 100'000;
    CHECK_THROWS_AS(palindromic_factors(word, small), BoundReached);
    CHECK_THROWS_AS(repetitions_in(word, small), BoundReached);
    CHECK_THROWS_AS(factor_counts(word, small), BoundReached);
}
