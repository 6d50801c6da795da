#include <algorithm>

#include "language/finite_rules.hpp"

namespace algae {

using Node = FiniteWords::Node;

StepRelation RuleSearch::steps(const PossibleRules& rules) {
    StepRelation relation(words_.count(), std::vector<char>(words_.count(), 0));
    for (std::uint32_t w = 0; w < words_.count(); ++w) {
        if (family_.deterministic) {
            land_everywhere(w, 0, 0, rules, relation[w]);
            continue;
        }
        std::vector<char> reached(words_.below.size(), 0);
        std::vector<Node> nodes{0};
        for (const std::uint32_t letter : words_.words[w]) {
            std::vector<Node> next;
            std::fill(reached.begin(), reached.end(), 0);
            for (const Node node : nodes)
                for (const auto& [image, end] : words_.below[node]) {
                    tick();
                    if (!rules.possible[letter][image] || reached[end]) continue;
                    reached[end] = 1;
                    next.push_back(end);
                }
            nodes = std::move(next);
        }
        for (const Node node : nodes)
            if (words_.word_at[node] != FiniteWords::none) relation[w][words_.word_at[node]] = 1;
    }
    return relation;
}

void RuleSearch::land_everywhere(std::uint32_t word, std::size_t position, Node node,
                                 const PossibleRules& rules, std::vector<char>& ends) {
    tick();
    const auto& letters = words_.words[word];
    while (position < letters.size() && chosen_[letters[position]] != FiniteWords::none) {
        node = after(node, chosen_[letters[position++]]);
        if (node == FiniteWords::none) return;
    }
    if (position == letters.size()) {
        if (words_.word_at[node] != FiniteWords::none) ends[words_.word_at[node]] = 1;
        return;
    }
    const std::uint32_t letter = letters[position];
    for (const auto& [image, end] : words_.below[node]) {
        if (!rules.possible[letter][image]) continue;
        chosen_[letter] = image;
        land_everywhere(word, position + 1, end, rules, ends);
    }
    chosen_[letter] = FiniteWords::none;
}

std::vector<std::vector<std::uint32_t>> RuleSearch::sources(const StepRelation& relation) {
    const auto size = static_cast<std::uint32_t>(relation.size());
    StepRelation ancestors(size, std::vector<char>(size, 0));
    for (std::uint32_t v = 0; v < size; ++v) {
        std::vector<std::uint32_t> open{v};
        ancestors[v][v] = 1;
        while (!open.empty()) {
            const std::uint32_t to = open.back();
            open.pop_back();
            for (std::uint32_t from = 0; from < size; ++from)
                if (relation[from][to] && !ancestors[v][from]) {
                    ancestors[v][from] = 1;
                    open.push_back(from);
                }
        }
    }
    std::vector<std::vector<std::uint32_t>> sets;
    for (std::uint32_t v = 0; v < size; ++v) {
        std::vector<std::uint32_t> set;
        bool closed = true;  // all ancestors come from v too, and v is the first of them
        for (std::uint32_t w = 0; w < size && closed; ++w) {
            if (!ancestors[v][w]) continue;
            closed = w >= v && ancestors[w][v];
            set.push_back(w);
        }
        if (closed) sets.push_back(std::move(set));
    }
    std::stable_sort(sets.begin(), sets.end(), [](const auto& left, const auto& right) {
        return left.size() < right.size();
    });
    return sets;
}

std::optional<std::vector<std::vector<std::uint32_t>>> RuleSearch::ruling_out(
    const std::vector<std::vector<std::uint32_t>>& closed_sets) const {
    using Sets = std::vector<std::vector<std::uint32_t>>;
    if (words_.count() == 0) return Sets{};
    for (const auto& set : closed_sets)
        if (!empty_axiom_ && set.size() == 1 && language_.words[set.front()].empty())
            return Sets{set};
    if (closed_sets.size() > 1) return Sets{closed_sets[0], closed_sets[1]};
    return std::nullopt;
}

std::optional<std::vector<std::vector<std::uint32_t>>> RuleSearch::unreached(
    const StepRelation& relation) const {
    return ruling_out(sources(relation));
}

}  // namespace algae
