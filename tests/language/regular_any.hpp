#pragma once
// Random regular expressions over a and b, with the words of at most six letters listed by hand.

#include <rapidcheck.h>

#include <set>
#include <string>

#include "language/detail/regular.hpp"

namespace algae::regular_tests {

inline constexpr std::size_t longest = 6;

/// A language and all its words of at most six letters.
struct Listed {
    RegularLanguage language;
    std::set<Word> words;
};

inline std::set<Word> all_short_words() {
    std::vector<Word> found{{}};
    for (std::size_t i = 0; i < found.size(); ++i)
        if (found[i].size() < longest)
            for (const Symbol a : {0u, 1u}) {
                found.push_back(found[i]);
                found.back().push_back(a);
            }
    return {found.begin(), found.end()};
}

inline std::set<Word> products(const std::set<Word>& left, const std::set<Word>& right) {
    std::set<Word> found;
    for (const Word& u : left)
        for (const Word& v : right)
            if (u.size() + v.size() <= longest) {
                Word word = u;
                word.insert(word.end(), v.begin(), v.end());
                found.insert(word);
            }
    return found;
}

/// One word or several of the set after each other.
inline std::set<Word> several(const std::set<Word>& words) {
    std::set<Word> found = words;
    for (std::size_t before = 0; before != found.size();) {
        before = found.size();
        found.merge(products(found, words));
    }
    return found;
}

inline Listed any_listed(int depth) {
    const int kind = depth == 0 ? 0 : *rc::gen::inRange(0, 6);
    if (kind == 0) {
        const auto word = rc::gen::mapcat(rc::gen::inRange(0, 4), [](int size) {
            return rc::gen::container<Word>(static_cast<std::size_t>(size),
                                            rc::gen::element(Symbol{0}, Symbol{1}));
        });
        const auto words = *rc::gen::container<std::vector<Word>>(
            static_cast<std::size_t>(*rc::gen::inRange(0, 4)), word);
        return {finite_set(words), {words.begin(), words.end()}};
    }
    const Listed left = any_listed(depth - 1);
    if (kind == 1) return {plus(left.language), several(left.words)};
    if (kind == 2) {
        std::set<Word> words = several(left.words);
        words.insert(Word{});
        return {star(left.language), words};
    }
    const Listed right = any_listed(depth - 1);
    std::set<Word> words = left.words;
    if (kind == 3)
        return {concatenated(left.language, right.language), products(left.words, right.words)};
    if (kind == 4) {
        words.insert(right.words.begin(), right.words.end());
        return {united(left.language, right.language), words};
    }
    std::erase_if(words, [&](const Word& word) { return right.words.contains(word); });
    return {difference(left.language, right.language), words};
}

/// The words of at most six letters that the language contains, asked one by one.
inline std::set<Word> contained(const RegularLanguage& language) {
    std::set<Word> words = all_short_words();
    std::erase_if(words, [&](const Word& word) { return !language.contains(word); });
    return words;
}

}  // namespace algae::regular_tests
