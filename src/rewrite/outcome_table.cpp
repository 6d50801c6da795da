#include "rewrite/outcome_table.hpp"

#include <algorithm>

#include "base/error.hpp"

namespace algae {

void OutcomeTable::add(std::uint32_t successor, const ModuleKind* kinds, std::size_t size,
                       std::size_t values, std::uint32_t arity) {
    outcomes.push_back({successor, static_cast<std::uint32_t>(size),
                        static_cast<std::uint32_t>(values), arity,
                        padded_.data() + padded_.size()});
    padded_.insert(padded_.end(), kinds, kinds + size);
    padded_.insert(padded_.end(), near, 0);
}

OutcomeTable::OutcomeTable(const CompiledRules& rules, const RuleSet& set) {
    const std::size_t kinds = rules.kinds.size();
    const std::size_t count = kinds + rules.successors.size();
    if (count > 65'535)
        throw BoundReached(Bound::method, "the system has more than 65535 rules and letters");
    std::size_t letters = 0;
    for (const Successor& successor : rules.successors) letters += successor.kinds.size();
    padded_.reserve(letters + kinds + count * near);  // so that outcomes may point into it
    for (std::size_t k = 0; k < kinds; ++k) {
        const auto kind = static_cast<ModuleKind>(k);
        add(0, &kind, 1, rules.kinds.arity(kind), rules.kinds.arity(kind));
    }
    ways.resize(kinds);
    closer.assign(kinds, 0);
    number_of.assign(rules.successors.size(), 0);
    for (std::size_t k = 0; k < kinds; ++k) {
        const auto kind = static_cast<ModuleKind>(k);
        ways[k].thresholds.fill(~std::uint64_t{0});
        ways[k].outcomes.fill(kind);
        for (const Alternatives& alternatives : set.of[k])
            for (const std::uint32_t successor : alternatives.successors) {
                number_of[successor] = static_cast<Number>(outcomes.size());
                const Successor& to = rules.successors[successor];
                add(successor, to.kinds.data(), to.kinds.size(), to.values.size(),
                    rules.kinds.arity(kind));
            }
        if (set.of[k].empty()) continue;
        const Alternatives& first = set.of[k].front();
        const std::size_t choices = first.successors.size();
        closer[k] = set.of[k].size() > 1 || first.condition || choices > 4 ||
                    (choices > 1 && first.thresholds.empty());
        any_closer = any_closer || closer[k];
        if (closer[k]) continue;
        random = random || choices > 1;
        for (std::size_t i = 0; i < 4; ++i) {
            ways[k].outcomes[i] = number_of[first.successors[std::min(i, choices - 1)]];
            if (i + 1 < choices) ways[k].thresholds[i] = first.thresholds[i];
        }
    }
}

}  // namespace algae
