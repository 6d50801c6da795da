#include <algorithm>
#include <utility>

#include "language/finite_rules.hpp"

namespace algae {

using Image = FiniteWords::Image;
using Node = FiniteWords::Node;

bool RuleSearch::narrow(PossibleRules& rules, ObstructionCase& why) {
    open_departure_.reset();
    for (;;) {
        if (!narrow_by_words(rules, why)) return false;
        if (family_.deterministic) return true;
        open_departure_ = departure(rules);
        if (!open_departure_ || open_departure_->open.size() > 1) return true;
        const Departure step = *std::exchange(open_departure_, std::nullopt);
        if (step.open.empty()) {
            why.end = ObstructionCase::End::conflict;
            why.word = language_.words[step.word];
            why.images = spelled_images(step.images);
            return false;
        }
        const Pair pair = step.open.front();
        if (!exclude(rules, why, pair,
                     {rule(pair.letter, pair.image), language_.words[step.word],
                      spelled_images(step.images)}))
            return false;
    }
}

bool RuleSearch::exclude(PossibleRules& rules, ObstructionCase& why, Pair pair,
                         ExcludedRule reason) {
    why.excluded.push_back(std::move(reason));
    rules.possible[pair.letter][pair.image] = 0;
    if (rules.there[pair.letter][pair.image]) {
        why.end = ObstructionCase::End::needed;
        return false;
    }
    const auto& images = rules.possible[pair.letter];
    if (std::find(images.begin(), images.end(), 1) != images.end()) return true;
    why.end = ObstructionCase::End::no_image;
    why.letter = words_.letters[pair.letter];
    return false;
}

/// Every closed table has, for each of its rules and each word, a choice of one rule for each letter
/// that sends the word into the language.
bool RuleSearch::narrow_by_words(PossibleRules& rules, ObstructionCase& why) {
    std::vector<std::vector<char>> seen(words_.letters.size());
    for (bool changed = true; changed;) {
        changed = false;
        for (std::uint32_t w = 0; w < words_.count(); ++w) {
            std::vector<std::uint32_t> occurring = words_.words[w];
            std::sort(occurring.begin(), occurring.end());
            occurring.erase(std::unique(occurring.begin(), occurring.end()), occurring.end());
            for (const std::uint32_t x : occurring) seen[x].assign(words_.images.size(), 0);
            for (const std::uint32_t x : occurring)
                for (Image u = 0; u < words_.images.size(); ++u) {
                    if (!rules.possible[x][u] || seen[x][u]) continue;
                    chosen_[x] = u;
                    const bool found = lands(w, 0, 0, rules);
                    for (const std::uint32_t y : occurring)
                        if (found) seen[y][chosen_[y]] = 1;
                    for (const std::uint32_t y : occurring) chosen_[y] = FiniteWords::none;
                    if (found) continue;
                    changed = true;
                    if (!exclude(rules, why, {x, u}, {rule(x, u), language_.words[w], {}}))
                        return false;
                }
        }
    }
    return true;
}

bool RuleSearch::lands(std::uint32_t word, std::size_t position, Node node,
                       const PossibleRules& rules) {
    tick();
    const auto& letters = words_.words[word];
    while (position < letters.size() && chosen_[letters[position]] != FiniteWords::none) {
        node = after(node, chosen_[letters[position++]]);
        if (node == FiniteWords::none) return false;
    }
    if (position == letters.size()) return words_.word_at[node] != FiniteWords::none;
    const std::uint32_t letter = letters[position];
    for (const auto& [image, end] : words_.below[node]) {
        if (!rules.possible[letter][image]) continue;
        chosen_[letter] = image;
        if (lands(word, position + 1, end, rules)) return true;
    }
    chosen_[letter] = FiniteWords::none;
    return false;
}

}  // namespace algae
