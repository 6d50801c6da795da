#pragma once

#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "automatic/automatic.hpp"
#include "system/system.hpp"

// Infinite words that the tests of this room are about.

namespace algae {

using Rules = std::vector<std::pair<char, std::string>>;

inline D0L system_of(const Rules& rules) {
    std::string letters;
    for (const auto& [letter, image] : rules) letters += letter;
    const auto alphabet = std::make_shared<Alphabet>();
    for (const char letter : letters) alphabet->symbol(std::string(1, letter));
    std::vector<Word> images;
    for (const auto& [letter, image] : rules) {
        images.emplace_back();
        for (const char c : image) images.back().push_back(alphabet->symbol(std::string(1, c)));
    }
    return make_d0l(alphabet, {0}, std::move(images), "written");
}

struct KnownWord {
    const char* name;
    Rules rules;
    std::map<char, char> coding = {};

    AutomaticWord word() const {
        const D0L system = system_of(rules);
        return automatic_word(system, [&](Symbol letter) {
            const char written = system.alphabet->name(letter)[0];
            return std::string(1, coding.empty() ? written : coding.at(written));
        });
    }
    /// The first letters, by writing images of letters one after the other.
    std::string prefix(std::size_t length) const {
        const auto image = [&](char letter) {
            for (const auto& [left, right] : rules)
                if (left == letter) return right;
            return std::string();
        };
        std::string all(1, rules.front().first);
        for (std::size_t i = 0; all.size() < length; ++i)
            all += i == 0 ? image(all[0]).substr(1) : image(all[i]);
        for (char& letter : all)
            if (!coding.empty()) letter = coding.at(letter);
        return all;
    }
};

inline const std::vector<KnownWord>& words() {
    static const std::vector<KnownWord> all{
        {"Thue-Morse", {{'a', "ab"}, {'b', "ba"}}},
        {"Fibonacci", {{'a', "ab"}, {'b', "a"}}},
        {"Tribonacci", {{'a', "ab"}, {'b', "ac"}, {'c', "a"}}},
        {"Rudin-Shapiro",
         {{'a', "ab"}, {'b', "ac"}, {'c', "db"}, {'d', "dc"}},
         {{'a', '0'}, {'b', '0'}, {'c', '1'}, {'d', '1'}}},
        {"Stewart", {{'a', "aab"}, {'b', "abb"}}},
        {"Pell", {{'a', "aab"}, {'b', "a"}}},
        {"Narayana", {{'a', "ab"}, {'b', "c"}, {'c', "a"}}},
        {"flipped Tribonacci", {{'a', "ab"}, {'b', "ca"}, {'c', "a"}}},
        {"not primitive", {{'a', "aba"}, {'b', "bbb"}}},
        {"eigenvalue 0", {{'a', "abc"}, {'b', "ac"}, {'c', "b"}}},
        {"Sturmian", {{'a', "aabab"}, {'b', "aab"}}},
        {"period doubling", {{'a', "ab"}, {'b', "aa"}}},
    };
    return all;
}

}  // namespace algae
