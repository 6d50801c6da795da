#include <algorithm>
#include <map>

#include "language/finite_rules.hpp"

namespace algae {

using Image = FiniteWords::Image;
using Node = FiniteWords::Node;

std::optional<RuleSearch::Departure> RuleSearch::departure(const PossibleRules& rules) {
    const auto images = listed(rules);
    std::optional<Departure> best;
    for (std::uint32_t word = 0; word < words_.count(); ++word) {
        if (best && best->open.size() <= 1) break;
        depart(word, rules, images, best);
    }
    return best;
}

/// Follows all derivations of one word at once, keeping for every beginning that they give one path
/// with few rules that are not known to be there. Complete: if some derivation leaves the language,
/// one of these paths does.
void RuleSearch::depart(std::uint32_t word, const PossibleRules& rules,
                        const std::vector<std::vector<Image>>& images,
                        std::optional<Departure>& best) {
    const auto& letters = words_.words[word];
    const auto with = [&](Departure path, std::uint32_t letter, Image image) {
        path.images.push_back(image);
        if (rules.there[letter][image]) return path;
        const Pair pair{letter, image};
        const auto place = std::lower_bound(path.open.begin(), path.open.end(), pair);
        if (place == path.open.end() || *place != pair) path.open.insert(place, pair);
        return path;
    };
    const auto likely = [&](const Departure& path, std::uint32_t letter) {
        for (const Pair& pair : path.open)
            if (pair.letter == letter) return pair.image;
        for (const Image u : images[letter])
            if (rules.there[letter][u]) return u;
        return images[letter].front();
    };
    const auto propose = [&](Departure path) {
        while (path.images.size() < letters.size()) {
            const std::uint32_t letter = letters[path.images.size()];
            const Image image = likely(path, letter);
            path = with(std::move(path), letter, image);
        }
        if (!best || path.open.size() < best->open.size()) best = std::move(path);
    };

    std::map<Node, Departure> paths{{0, Departure{word, {}, {}}}};
    for (const std::uint32_t letter : letters) {
        std::map<Node, Departure> longer;
        for (const auto& [node, path] : paths)
            for (const Image image : images[letter]) {
                tick();
                Departure next = with(path, letter, image);
                const Node end = after(node, image);
                if (end == FiniteWords::none) {
                    if (!best || next.open.size() < best->open.size()) propose(std::move(next));
                    continue;
                }
                const auto place = longer.find(end);
                if (place == longer.end())
                    longer.emplace(end, std::move(next));
                else if (next.open.size() < place->second.open.size())
                    place->second = std::move(next);
            }
        paths = std::move(longer);
    }
    for (auto& [node, path] : paths)
        if (words_.word_at[node] == FiniteWords::none) propose(std::move(path));
}

}  // namespace algae
