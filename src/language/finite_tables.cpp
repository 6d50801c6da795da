#include "language/finite_tables.hpp"

#include <algorithm>

namespace algae {

std::vector<PossibleRules> TableSearch::tables(FamilyObstruction& obstruction) {
    all_ = rules_.all_rules();
    steps_.assign(rules_.words().count(), std::vector<char>(rules_.words().count(), 0));
    if (!rules_.narrow(all_, obstruction.root)) return {};  // never: the identity is closed
    PossibleRules first = all_;
    ObstructionCase none;
    if (rules_.narrow_to_solution(first, false, none)) add(std::move(first));
    std::vector<std::vector<std::uint32_t>> entered_by_none;
    for (;;) {
        if (const auto sets = rules_.ruling_out(entered_by_none)) {
            obstruction.root.end = ObstructionCase::End::sources;
            obstruction.root.sources = rules_.spelled(*sets);
            return {};
        }
        const auto sets = RuleSearch::sources(steps_);
        if (!rules_.ruling_out(sets)) return std::move(found_);
        for (const auto& set : sets) {
            if (std::find(entered_by_none.begin(), entered_by_none.end(), set) !=
                entered_by_none.end())
                continue;
            if (!enter(set, obstruction)) entered_by_none.push_back(set);
            break;
        }
    }
}

void TableSearch::add(PossibleRules table) {
    const StepRelation more = rules_.steps(table);
    for (std::size_t from = 0; from < more.size(); ++from)
        for (std::size_t to = 0; to < more.size(); ++to) steps_[from][to] |= more[from][to];
    found_.push_back(std::move(table));
}

bool TableSearch::enter(const std::vector<std::uint32_t>& set, FamilyObstruction& obstruction) {
    for (std::uint32_t from = 0; from < rules_.words().count(); ++from) {
        if (std::binary_search(set.begin(), set.end(), from)) continue;
        for (const std::uint32_t to : set) {
            Set used;
            if (follow(from, to, 0, 0, used, obstruction)) return true;
        }
    }
    return false;
}

bool TableSearch::follow(std::uint32_t from, std::uint32_t to, std::size_t position,
                         std::size_t done, Set& used, FamilyObstruction& obstruction) {
    const FiniteWords& words = rules_.words();
    const auto& path = words.node_path[to];
    if (position == words.words[from].size()) {
        if (done + 1 != path.size() || is_impossible(used)) return false;
        PossibleRules table;
        ObstructionCase why;
        if (closes(used, table, why)) {
            add(std::move(table));
            return true;
        }
        rule_out(used, std::move(why), obstruction);
        return false;
    }
    const std::uint32_t letter = words.words[from][position];
    for (const auto& [image, end] : words.below[path[done]]) {
        const std::size_t next = done + words.images[image].size();
        if (next >= path.size() || path[next] != end || !all_.possible[letter][image]) continue;
        if (rules_.is_deterministic()) {
            const auto other = used.lower_bound({letter, 0});
            if (other != used.end() && other->first == letter && other->second != image) continue;
        }
        const bool is_new = used.insert({letter, image}).second;
        const bool entered =
            !is_impossible(used) && follow(from, to, position + 1, next, used, obstruction);
        if (is_new) used.erase({letter, image});
        if (entered) return true;
    }
    return false;
}

bool TableSearch::closes(const Set& used, PossibleRules& table, ObstructionCase& why) {
    table = all_;
    for (const auto& [letter, image] : used) {
        if (rules_.is_deterministic())
            std::fill(table.possible[letter].begin(), table.possible[letter].end(), 0);
        table.possible[letter][image] = 1;
        table.there[letter][image] = 1;
    }
    return rules_.narrow_to_solution(table, false, why);
}

/// Fewer rules that are impossible together say more, and say it to more steps.
void TableSearch::rule_out(Set used, ObstructionCase why, FamilyObstruction& obstruction) {
    const Set all = used;
    for (const Pair& pair : all) {
        Set fewer = used;
        fewer.erase(pair);
        PossibleRules table;
        ObstructionCase reason;
        if (fewer.empty() || closes(fewer, table, reason)) continue;
        used = std::move(fewer);
        why = std::move(reason);
    }
    ImpossibleTable& table = obstruction.impossible.emplace_back();
    for (const auto& [letter, image] : used) table.rules.push_back(rules_.rule(letter, image));
    table.why = std::move(why);
    impossible_.push_back(std::move(used));
}

bool TableSearch::is_impossible(const Set& used) const {
    return std::any_of(impossible_.begin(), impossible_.end(), [&](const Set& set) {
        return std::includes(used.begin(), used.end(), set.begin(), set.end());
    });
}

}  // namespace algae
