#include "exchange/polygon_letters.hpp"

#include <algorithm>
#include <utility>

namespace algae {

namespace {

bool braces_match(const std::string& word) {
    std::size_t depth = 0;
    for (const char letter : word) {
        if (letter == '{') ++depth;
        if (letter == '}' && depth-- == 0) return false;
    }
    return depth == 0;
}

}  // namespace

PolygonLetters polygon_letters(const std::string& axiom, const std::map<char, std::string>& rules) {
    const bool match = braces_match(axiom) &&
                       std::all_of(rules.begin(), rules.end(),
                                   [](const auto& rule) { return braces_match(rule.second); });
    PolygonLetters letters;
    // Words still to be looked at, and whether they stand inside a polygon as a whole.
    std::vector<std::pair<const std::string*, bool>> words{{&axiom, false}};
    while (!words.empty()) {
        const auto [word, fenced] = words.back();
        words.pop_back();
        std::size_t depth = fenced ? 1 : 0;
        for (const char letter : *word) {
            if (letter == '{' && match) ++depth;
            if (letter == '}' && match) --depth;
            if (letter == '{' || letter == '}') continue;
            const bool is_new =
                (depth > 0 ? letters.inside : letters.outside).insert(letter).second;
            const auto rule = rules.find(letter);
            if (is_new && rule != rules.end()) words.emplace_back(&rule->second, depth > 0);
        }
    }
    return letters;
}

std::vector<std::size_t> brace_depths(const std::string& word) {
    std::vector<std::size_t> depths;
    std::size_t depth = 0;
    for (const char letter : word) {
        if (letter == '{') ++depth;
        if (letter == '}' && depth > 0) --depth;
        depths.push_back(depth);
    }
    return depths;
}

}  // namespace algae
