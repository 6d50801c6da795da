// Inference: what is found has the words, and brute force finds nothing smaller.

#include <doctest/doctest.h>

#include <functional>
#include <map>
#include <random>
#include <set>

#include "exact/exact.hpp"
#include "search/search.hpp"

using namespace algae;

namespace {

using Texts = std::vector<std::string>;
using Family = InferenceWish::Family;

Word word_of(const std::string& text) {
    Word word;
    for (const char letter : text) word.push_back(static_cast<Symbol>(letter - 'a'));
    return word;
}

std::vector<Word> words_of(const Texts& texts) {
    std::vector<Word> words;
    for (const std::string& text : texts) words.push_back(word_of(text));
    return words;
}

std::string text_of(const Word& word) {
    std::string text;
    for (const Symbol letter : word) text += static_cast<char>('a' + letter);
    return text;
}

/// Rules of a letter as pairs of contexts and successor, first that fits first; no fold, no matcher of the library.
bool fits(const InferredRule& rule, const std::string& word, std::size_t at) {
    const std::string left = text_of(rule.left), right = text_of(rule.right);
    return static_cast<char>('a' + rule.letter) == word[at] && left.size() <= at &&
           word.compare(at - left.size(), left.size(), left) == 0 &&
           word.compare(at + 1, right.size(), right) == 0 && at + 1 + right.size() <= word.size();
}

/// All that a word may become by the rules of a table; with contexts only the first rule that fits counts.
bool derives(const InferredSystem& system, std::size_t table, const std::string& from,
             const std::string& to, std::size_t at = 0, std::size_t cut = 0) {
    if (at == from.size()) return cut == to.size();
    for (const InferredRule& rule : system.rules) {
        if (rule.table != table || !fits(rule, from, at)) continue;
        const std::string successor = text_of(rule.successor);
        if (to.compare(cut, successor.size(), successor) == 0 &&
            cut + successor.size() <= to.size() &&
            derives(system, table, from, to, at + 1, cut + successor.size()))
            return true;
        if (!rule.left.empty() || !rule.right.empty()) return false;
    }
    return false;
}

std::uint64_t size_of(const InferredSystem& system) {
    std::uint64_t size = system.axiom.size();
    for (const InferredRule& rule : system.rules)
        size += 1 + rule.left.size() + rule.right.size() + rule.successor.size();
    return size;
}

void check_explains(const InferredSystem& system, const Texts& texts) {
    CHECK(text_of(system.axiom) == texts.front());
    CHECK(size_of(system) == system.size);
    for (std::size_t i = 0; i + 1 < texts.size(); ++i)
        CHECK(derives(system, system.schedule[i], texts[i], texts[i + 1]));
}

/// All words over a and b up to a length, shorter first.
Texts all_words(std::size_t longest) {
    Texts all{""};
    for (std::size_t at = 0; at < all.size(); ++at)
        if (all[at].size() < longest)
            for (const char letter : {'a', 'b'}) all.push_back(all[at] + letter);
    return all;
}

std::string image(const std::map<char, std::string>& rules, const std::string& word) {
    std::string out;
    for (const char letter : word) out += rules.at(letter);
    return out;
}

/// The least |h(a)| + |h(b)| below a bound of morphisms that have the words as generations, by trying all of them.
std::optional<std::size_t> least_by_force(const Texts& texts, const std::set<char>& letters,
                                          std::size_t longest) {
    std::optional<std::size_t> least;
    const Texts images = all_words(longest), only{""};
    for (const std::string& a : letters.count('a') ? images : only)
        for (const std::string& b : letters.count('b') ? images : only) {
            if (least && a.size() + b.size() >= *least) continue;
            const std::map<char, std::string> rules{{'a', a}, {'b', b}};
            bool explains = true;
            for (std::size_t i = 0; i + 1 < texts.size() && explains; ++i)
                explains = image(rules, texts[i]) == texts[i + 1];
            if (explains) least = a.size() + b.size();
        }
    return least;
}

std::set<char> letters_in(const Texts& texts) {
    std::set<char> letters;
    for (const std::string& text : texts) letters.insert(text.begin(), text.end());
    return letters;
}

}  // namespace

TEST_CASE("four words of a fern's filament determine its rules") {
    const auto found = infer_generations(words_of({"c", "b", "ac", "cb"}), {});
    REQUIRE(found.system);
    check_explains(*found.system, {"c", "b", "ac", "cb"});
    std::map<std::string, std::string> rules;
    for (const InferredRule& rule : found.system->rules)
        rules[text_of({rule.letter})] = text_of(rule.successor);
    CHECK(rules == std::map<std::string, std::string>{{"a", "c"}, {"b", "ac"}, {"c", "b"}});
}

TEST_CASE("10,000 random D0L systems are inferred from their words, and not by larger ones") {
    std::mt19937_64 random(20261123);
    const auto below = [&](std::size_t count) {
        return static_cast<std::size_t>(random() % count);
    };
    int inferred = 0, forced = 0, smaller = 0;
    while (inferred < 10'000) {
        const std::size_t letters = 1 + below(3);
        const auto any = [&](std::size_t least, std::size_t most) {
            std::string word(least + below(most - least + 1), 'a');
            for (char& letter : word) letter = static_cast<char>('a' + below(letters));
            return word;
        };
        std::map<char, std::string> rules;
        for (const char letter : {'a', 'b', 'c'}) rules[letter] = any(0, 3);
        Texts texts{any(1, 3)};
        const std::size_t steps = 1 + below(4);
        for (std::size_t i = 0; i < steps; ++i) texts.push_back(image(rules, texts.back()));
        if (texts.back().size() > 60) continue;
        ++inferred;
        const Inference found = infer_generations(words_of(texts), {});
        REQUIRE(found.system);
        check_explains(*found.system, texts);
        std::uint64_t own = texts.front().size();
        for (const char letter : letters_in(texts)) own += 1 + rules[letter].size();
        CHECK(found.system->size <= own);
        smaller += found.system->size < own;
        std::size_t longest = 0;
        for (std::size_t i = 1; i < texts.size(); ++i) longest = std::max(longest, texts[i].size());
        if (letters > 2 || longest > 5) continue;
        const auto occur = letters_in({texts.begin(), texts.end() - 1});
        const auto least = least_by_force(texts, occur, longest);
        REQUIRE(least);
        CHECK(found.system->size == texts.front().size() + letters_in(texts).size() + *least);
        ++forced;
    }
    CHECK(forced > 1000);
    CHECK(smaller > 500);
    MESSAGE(inferred << " systems inferred, " << smaller
                     << " of them smaller than what made the words, " << forced
                     << " compared with all morphisms");
}

TEST_CASE("any words: a system is found where brute force finds one, and nowhere else") {
    std::mt19937 random(3);
    int none = 0, some = 0;
    const Texts all = all_words(4);
    for (int round = 0; round < 8000; ++round) {
        Texts texts{all[1 + random() % 14]};
        for (int i = 0; i < 2; ++i) texts.push_back(all[random() % all.size()]);
        const auto least = least_by_force(texts, letters_in({texts.begin(), texts.end() - 1}), 4);
        const Inference found = infer_generations(words_of(texts), {});
        REQUIRE(found.system.has_value() == least.has_value());
        (least ? some : none) += 1;
        if (!least) continue;
        check_explains(*found.system, texts);
        CHECK(found.system->size == texts[0].size() + letters_in(texts).size() + *least);
    }
    CHECK(none > 1000);
    CHECK(some > 200);
}

TEST_CASE("0L systems: nothing smaller among all sets of rules") {
    std::mt19937 random(5);
    const Texts all = all_words(3);
    int compared = 0;
    for (int round = 0; round < 250; ++round) {
        Texts texts{all[1 + random() % 6]};
        for (int i = 0; i < 2; ++i) texts.push_back(all[random() % all.size()]);
        const Inference found = infer_generations(words_of(texts), {Family::ol, false});
        // The empty word gives nothing but itself.
        const bool possible = !texts[1].empty() || texts[2].empty();
        REQUIRE(found.system.has_value() == possible);
        if (!possible) continue;
        check_explains(*found.system, texts);
        // Rules are letters with successors; all sets that cost less.
        std::vector<InferredRule> rules;
        for (const char letter : letters_in(texts))
            for (const std::string& word : all)
                rules.push_back({0, {}, static_cast<Symbol>(letter - 'a'), {}, word_of(word)});
        InferredSystem smaller;
        smaller.axiom = word_of(texts[0]);
        bool exists = false;
        const std::function<void(std::size_t, std::uint64_t)> choose = [&](std::size_t from,
                                                                           std::uint64_t left) {
            if (exists) return;
            std::set<Symbol> ruled;
            for (const InferredRule& rule : smaller.rules) ruled.insert(rule.letter);
            if (ruled.size() == letters_in(texts).size() &&
                derives(smaller, 0, texts[0], texts[1]) && derives(smaller, 0, texts[1], texts[2]))
                exists = true;
            for (std::size_t i = from; i < rules.size() && !exists; ++i) {
                const std::uint64_t cost = 1 + rules[i].successor.size();
                if (cost > left) continue;
                smaller.rules.push_back(rules[i]);
                choose(i + 1, left - cost);
                smaller.rules.pop_back();
            }
        };
        choose(0, found.system->size - texts[0].size() - 1);
        CHECK(!exists);
        ++compared;
    }
    CHECK(compared > 200);
}

TEST_CASE("tables and contexts explain what one rule a letter cannot") {
    const Texts texts{"a", "aa", "aaa"};
    CHECK(!infer_generations(words_of(texts), {}).system);
    // With tables a step has one successor a letter: aa cannot become aaa.
    CHECK(!infer_generations(words_of(texts), {Family::dt0l, false}).system);
    const auto context = infer_generations(words_of(texts), {Family::dil, false});
    REQUIRE(context.system);
    check_explains(*context.system, texts);

    const Texts squares{"a", "aa", "aaaaaa"};
    const auto tables = infer_generations(words_of(squares), {Family::dt0l, false});
    REQUIRE(tables.system);
    CHECK(tables.system->tables == 2);
    check_explains(*tables.system, squares);
    CHECK(tables.system->size == 1 + 3 + 4);
}

TEST_CASE("a DIL system exists unless one word has two successors") {
    std::mt19937 random(11);
    const Texts all = all_words(4);
    int some = 0, none = 0;
    for (int round = 0; round < 1500; ++round) {
        Texts texts{all[1 + random() % 14]};
        for (int i = 0; i < 3; ++i) texts.push_back(all[random() % 15]);
        bool possible = true;
        for (std::size_t i = 0; i + 1 < texts.size(); ++i) {
            possible = possible && (!texts[i].empty() || texts[i + 1].empty());
            for (std::size_t j = 0; j < i; ++j)
                possible = possible && (texts[i] != texts[j] || texts[i + 1] == texts[j + 1]);
        }
        const auto found = infer_generations(words_of(texts), {Family::dil, false});
        REQUIRE(found.system.has_value() == possible);
        (possible ? some : none) += 1;
        if (possible) check_explains(*found.system, texts);
    }
    CHECK(some > 500);
    CHECK(none > 100);
}

TEST_CASE("propagating systems have no empty successor") {
    const auto found = infer_generations(words_of({"ab", "b", "b"}), {Family::d0l, true});
    CHECK(!found.system);
    const auto other = infer_generations(words_of({"ab", "bc"}), {Family::d0l, true});
    REQUIRE(other.system);
    CHECK(other.system->size == 2 + 2 + 2 + 2);
    for (const InferredRule& rule : other.system->rules) CHECK(!rule.successor.empty());
}

TEST_CASE("what cannot be asked is refused") {
    CHECK_THROWS_AS(infer_generations({}, {}), Error);
    CHECK_THROWS_AS(infer_generations({{}, {0}}, {}), Error);
    const auto never = [](const ET0L&, const Word&) { return false; };
    CHECK_THROWS_AS(infer_sample({{0}}, {Family::dil, false}, 3, never), Error);
    CHECK(!infer_sample({{0}}, {}, 4, never).system);
}
