#pragma once
// What can be seen in the words themselves, written out letter by letter.

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "oracle/random_systems.hpp"
#include "oracle/written_system.hpp"

namespace algae {

/// A system that mostly grows: a, which leads to itself, b and d, and letters that stay or vanish.
inline rc::Gen<oracle::WrittenSystem> any_growing_d0l() {
    return rc::gen::apply(
        [](std::string before, std::string after, std::string b, std::string d, bool first) {
            oracle::WrittenSystem system{
                first ? "a" : "da",
                {{'a', {before + "a" + after}}, {'b', {b}}, {'d', {d}}, {'m', {""}}}};
            return system;
        },
        oracle::any_word("abd", 2), oracle::any_word("abbcdm", 3), oracle::any_word("abdbdcm", 4),
        oracle::any_nonempty_word("bdbdca", 3), rc::gen::arbitrary<bool>());
}

/// The words of the generations that have at most so many letters, no more than `generations`.
inline std::vector<std::string> expanded(const oracle::WrittenSystem& system, std::size_t letters,
                                         unsigned generations) {
    std::vector<std::string> words;
    const unsigned last = oracle::last_generation_within(system, letters, generations);
    for (unsigned n = 0; n <= last; ++n) {
        oracle::WrittenSystem next = system;
        if (n > 0) next.axiom = words.back();
        words.push_back(oracle::rewritten(next, n > 0 ? 1 : 0));
    }
    return words;
}

/// The factors of so many letters of all words.
inline std::set<std::string> factors_of(const std::vector<std::string>& words, std::size_t length) {
    std::set<std::string> found;
    for (const std::string& word : words)
        for (std::size_t i = 0; i + length <= word.size(); ++i)
            found.insert(word.substr(i, length));
    return found;
}

/// The word, so many times.
inline std::string repeated(const std::string& word, std::size_t times) {
    std::string result;
    while (times-- > 0) result += word;
    return result;
}

inline bool occurs(const std::string& factor, const std::vector<std::string>& words) {
    return std::any_of(words.begin(), words.end(), [&](const std::string& word) {
        return word.find(factor) != std::string::npos;
    });
}

}  // namespace algae
