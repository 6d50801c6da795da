#include "language/finite_rules.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "base/error.hpp"

namespace algae {

using Image = FiniteWords::Image;
using Node = FiniteWords::Node;

RuleSearch::RuleSearch(const FiniteLanguage& language, const FiniteWords& words, Family family,
                       bool empty_axiom, std::uint64_t cases, const Budget& budget)
    : language_(language),
      words_(words),
      family_(family),
      empty_axiom_(empty_axiom),
      cases_(cases),
      budget_(budget),
      chosen_(words.letters.size(), FiniteWords::none) {}

PossibleRules RuleSearch::all_rules() const {
    const std::vector<std::vector<char>> all(words_.letters.size(),
                                             std::vector<char>(words_.images.size(), 1));
    PossibleRules rules{all, {}};
    rules.there.assign(all.size(), std::vector<char>(words_.images.size(), 0));
    if (family_.propagating)
        for (auto& images : rules.possible) images[0] = 0;
    return rules;
}

LetterRule RuleSearch::rule(std::uint32_t letter, Image image) const {
    return {words_.letters[letter], words_.images[image]};
}

std::vector<Word> RuleSearch::spelled_images(const std::vector<Image>& images) const {
    std::vector<Word> all;
    for (const Image image : images) all.push_back(words_.images[image]);
    return all;
}

std::vector<std::vector<Word>> RuleSearch::spelled(
    const std::vector<std::vector<std::uint32_t>>& sets) const {
    std::vector<std::vector<Word>> all;
    for (const auto& set : sets) {
        auto& spelled_set = all.emplace_back();
        for (const std::uint32_t word : set) spelled_set.push_back(language_.words[word]);
    }
    return all;
}

std::vector<std::vector<Image>> RuleSearch::listed(const PossibleRules& rules) const {
    std::vector<std::vector<Image>> images(rules.possible.size());
    for (std::size_t x = 0; x < images.size(); ++x)
        for (Image u = 0; u < words_.images.size(); ++u)
            if (rules.possible[x][u]) images[x].push_back(u);
    return images;
}

Node RuleSearch::after(Node node, Image image) const {
    const auto& below = words_.below[node];
    const auto place =
        std::lower_bound(below.begin(), below.end(), image,
                         [](const FiniteWords::Step& step, Image u) { return step.image < u; });
    return place != below.end() && place->image == image ? place->end : FiniteWords::none;
}

void RuleSearch::tick() {
    if (++ticks_ % 4096 == 0) budget_.check();
}

bool RuleSearch::narrow_to_solution(PossibleRules& rules, bool generating, ObstructionCase& why) {
    if (cases_ == 0)
        throw BoundReached(
            Bound::method,
            "the bound on the number of cases was reached before the answer was known");
    --cases_;
    budget_.check();
    if (!narrow(rules, why)) return false;
    if (generating) {
        if (const auto sets = unreached(steps(rules))) {
            why.end = ObstructionCase::End::sources;
            why.sources = spelled(*sets);
            return false;
        }
    }
    return family_.deterministic ? split_by_choice(rules, generating, why)
                                 : split_by_departure(rules, generating, why);
}

bool RuleSearch::split_by_departure(PossibleRules& rules, bool generating, ObstructionCase& why) {
    if (!open_departure_) return true;
    const Departure step = *std::exchange(open_departure_, std::nullopt);
    why.end = ObstructionCase::End::conflict;
    why.word = language_.words[step.word];
    why.images = spelled_images(step.images);
    PossibleRules rest = rules;
    for (const Pair& pair : step.open) {
        why.rules.push_back(rule(pair.letter, pair.image));
        PossibleRules without = rest;
        without.possible[pair.letter][pair.image] = 0;
        ObstructionCase part;
        if (narrow_to_solution(without, generating, part)) {
            rules = std::move(without);
            return true;
        }
        why.cases.push_back(std::move(part));
        rest.there[pair.letter][pair.image] = 1;
    }
    return false;
}

bool RuleSearch::split_by_choice(PossibleRules& rules, bool generating, ObstructionCase& why) {
    const auto images = listed(rules);
    std::optional<std::uint32_t> letter;
    for (std::uint32_t x = 0; x < images.size(); ++x)
        if (images[x].size() > 1 && (!letter || images[x].size() < images[*letter].size()))
            letter = x;
    if (!letter) return true;
    why.end = ObstructionCase::End::choice;
    why.letter = words_.letters[*letter];
    for (const Image u : images[*letter]) {
        why.rules.push_back(rule(*letter, u));
        PossibleRules only = rules;
        only.possible[*letter].assign(words_.images.size(), 0);
        only.possible[*letter][u] = 1;
        ObstructionCase part;
        if (narrow_to_solution(only, generating, part)) {
            rules = std::move(only);
            return true;
        }
        why.cases.push_back(std::move(part));
    }
    return false;
}

}  // namespace algae
