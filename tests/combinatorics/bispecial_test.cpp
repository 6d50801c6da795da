// The number of factors of every length, by bispecial factors of derived words.

#include <doctest/doctest.h>

#include <chrono>
#include <cstdlib>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "combinatorics/combinatorics.hpp"

using namespace algae;

namespace {

Morphism morphism(const std::vector<std::string>& images) {
    std::vector<Word> all;
    for (const std::string& image : images) {
        all.emplace_back();
        for (const char letter : image) all.back().push_back(static_cast<Symbol>(letter - 'a'));
    }
    return Morphism(all);
}

/// The numbers of different factors, counted in a least set of windows: those of all images of windows. No rule erases.
std::vector<std::size_t> counted(const Morphism& h, Symbol a, std::size_t longest) {
    std::set<Word> windows;
    std::vector<Word> queue;
    Word begin{a};
    while (begin.size() < longest) begin = h(begin);
    const auto see = [&](const Word& word) {
        for (std::size_t i = 0; i + longest <= word.size(); ++i) {
            const auto at = word.begin() + static_cast<std::ptrdiff_t>(i);
            Word window(at, at + static_cast<std::ptrdiff_t>(longest));
            if (windows.insert(window).second) queue.push_back(std::move(window));
        }
    };
    see(begin);
    while (!queue.empty()) {
        const Word next = h(queue.back());
        queue.pop_back();
        see(next);
    }
    std::vector<std::size_t> found;
    for (std::size_t n = 0; n <= longest; ++n) {
        std::set<Word> factors;
        for (const Word& window : windows)
            for (std::size_t i = 0; i + n <= longest; ++i) {
                const auto at = window.begin() + static_cast<std::ptrdiff_t>(i);
                factors.emplace(at, at + static_cast<std::ptrdiff_t>(n));
            }
        found.push_back(factors.size());
    }
    return found;
}

bool is_primitive(const std::vector<Word>& images) {
    const std::size_t d = images.size();
    std::vector<std::set<Symbol>> reached;
    for (Symbol a = 0; a < d; ++a) reached.push_back({a});
    for (std::size_t i = 0; i < d * d; ++i)
        for (auto& letters : reached) {
            std::set<Symbol> next;
            for (const Symbol a : letters) next.insert(images[a].begin(), images[a].end());
            letters = next;
        }
    for (const auto& letters : reached)
        if (letters.size() < d) return false;
    return true;
}

struct Prolonged {
    Morphism h;
    Symbol a;
};

/// A power of the morphism that prolongs a letter.
Prolonged prolonged(const std::vector<Word>& images) {
    const Morphism h(images);
    Symbol a = 0;
    for (std::size_t i = 0; i < images.size(); ++i) a = h[a].front();
    std::vector<Word> power = images;
    while (power[a].front() != a || power[a].size() < 2)
        for (Word& word : power) word = h(word);
    return {Morphism(power), a};
}

std::string name_of(const std::vector<Word>& images) {
    std::string name;
    for (const Word& image : images) {
        for (const Symbol letter : image) name += static_cast<char>('a' + letter);
        name += ' ';
    }
    return name;
}

/// A case of the variable, or so many.
std::size_t cases(const char* variable, std::size_t fewer) {
    const char* given = std::getenv(variable);
    return given ? static_cast<std::size_t>(std::strtoull(given, nullptr, 10)) : fewer;
}

}  // namespace

TEST_CASE("complexity for all n: words whose complexity is published") {
    const auto linear = [](const std::vector<std::string>& images) {
        const auto found = complexity_for_all(morphism(images), 0).linear();
        REQUIRE(found);
        return std::vector<Integer>{found->slope, found->constant, found->from};
    };
    CHECK(linear({"ab", "a"}) == std::vector<Integer>{1, 1, 0});        // Fibonacci
    CHECK(linear({"aab", "a"}) == std::vector<Integer>{1, 1, 0});       // Pell
    CHECK(linear({"ab", "ac", "a"}) == std::vector<Integer>{2, 1, 0});  // Tribonacci
    CHECK(linear({"ab", "c", "a"}) == std::vector<Integer>{2, 1, 0});   // Shallit 2025
    CHECK(linear({"aab", "abb"}) == std::vector<Integer>{2, 0, 1});     // Noche 2008
    CHECK(linear({"aaba", "b"}) == std::vector<Integer>{2, -1, 2});     // Chacon; Ferenczi 1995

    // Thue-Morse: p(n+1) - p(n) is 4 for 2 2^k < n <= 3 2^k and 2 otherwise, n > 1 (Brlek 1989; de Luca and Varricchio 1989).
    const ComplexityForAll morse = complexity_for_all(morphism({"ab", "ba"}), 0);
    CHECK_FALSE(morse.linear());
    for (std::int64_t k = 1; k < 40; ++k) {
        const std::int64_t power = std::int64_t{1} << k;
        CHECK(morse.value(power + 1) == Integer(3 * power));
        CHECK(morse.value(2 * power + 1) == Integer(6 * power));
        CHECK(morse.value(power + power / 2 + 1) == Integer(5 * power));
    }
    CHECK(morse.value(power(Integer(2), 300) + 1) == Integer(3) * power(Integer(2), 300));
}

TEST_CASE("complexity for all n: periodic words, letters that are forgotten, what has no answer") {
    const ComplexityForAll periodic = complexity_for_all(morphism({"abcabc", "a", "bc"}), 0);
    CHECK(periodic.linear()->slope == 0);
    CHECK(periodic.value(1'000) == 3);
    // c is forgotten: abcabcabc... is (abc)^omega.
    CHECK(complexity_for_all(morphism({"abcabc", "", ""}), 0).value(7) == 3);
    CHECK_THROWS_WITH_AS(complexity_for_all(morphism({"ba", "a"}), 0),
                         "expected a letter whose image begins with it and is longer", Error);
    CHECK_THROWS_WITH_AS(complexity_for_all(morphism({"ab", "b"}), 0),
                         "the first letter of the infinite word does not come back in it", Error);
    // a comes back, but ever later: b doubles.
    CHECK_THROWS_AS(complexity_for_all(morphism({"aba", "bb"}), 0), BoundReached);
}

TEST_CASE("complexity for all n is that of all windows of random primitive morphisms") {
    // ALGAE_MORPHISMS=1000 takes all of the morphisms.
    const std::size_t wanted = cases("ALGAE_MORPHISMS", 120);
    constexpr std::size_t longest = 40;
    std::mt19937 generator(22);
    const auto below = [&](std::size_t bound) { return generator() % bound; };
    std::size_t compared = 0, proved = 0, drawn = 0;
    while (drawn < wanted) {
        std::vector<Word> images(2 + below(3));
        for (Word& image : images) {
            image.resize(1 + below(4));
            for (Symbol& letter : image) letter = static_cast<Symbol>(below(images.size()));
        }
        bool grows = false;
        for (const Word& image : images) grows = grows || image.size() > 1;
        if (!grows || !is_primitive(images)) continue;
        ++drawn;
        const auto [h, a] = prolonged(images);
        ComplexityForAll found;
        try {
            found = complexity_for_all(h, a);
        } catch (const BoundReached&) {
            continue;
        }
        ++proved;
        const std::vector<std::size_t> values = counted(h, a, longest);
        for (std::size_t n = 0; n <= longest; ++n) {
            ++compared;
            REQUIRE_MESSAGE(found.value(n) == Integer(values[n]), name_of(images), "n = ", n);
        }
    }
    MESSAGE(proved, " of ", drawn, " random primitive morphisms proved, ", compared,
            " values compared");
    CHECK(proved * 100 >= drawn * 95);
    CHECK(compared == proved * (longest + 1));
}

TEST_CASE("complexity for all n: the work stops at the end of the time") {
    Budget budget;
    budget.deadline = std::chrono::steady_clock::now();
    CHECK_THROWS_AS(complexity_for_all(morphism({"ab", "a"}), 0, budget), BoundReached);
}
