#include "rewrite/surroundings.hpp"

#include <algorithm>

#include "base/error.hpp"
#include "word/hom.hpp"

namespace algae {

Surroundings::Surroundings(const CompiledRules& rules, const ModuleString& word,
                           const std::string& name, const Budget& budget)
    : rules_(rules), word_(word), name_(name), budget_(budget) {
    const std::size_t size = word.kinds.size();
    budget.check_memory(size * 4 * sizeof(std::size_t), "what contexts see of a word");
    const auto brackets = brackets_of(rules.system->alphabet);
    const auto& ignored = rules.system->ignored;
    const auto is_ignored = [&](Symbol a) {
        return std::find(ignored.begin(), ignored.end(), a) != ignored.end();
    };
    trees_ = brackets && !(is_ignored(brackets->open) && is_ignored(brackets->close));
    if (!word.values.empty()) {
        offsets_.resize(size);
        std::uint64_t offset = 0;
        for (std::size_t i = 0; i < size; ++i) {
            offsets_[i] = offset;
            offset += rules.kinds.arity(word.kinds[i]);
        }
    }
    at_.resize(rules.kinds.size());
    for (std::size_t i = 0; i < size; ++i)
        if (rules.sought[word.kinds[i]]) at_[word.kinds[i]].push_back(i);
    find_left();
    find_right();
}

void Surroundings::find_left() {
    const std::size_t size = word_.kinds.size();
    left_.resize(size);
    if (trees_) closes_.assign(size, none);
    std::vector<std::pair<std::size_t, std::size_t>> open;  // brackets, and what stands before them
    std::size_t last = none;
    for (std::size_t i = 0; i < size; ++i) {
        if (i % 65536 == 0) budget_.check();
        const ModuleKind kind = word_.kinds[i];
        left_[i] = last;
        if (trees_ && rules_.opens[kind]) {
            open.emplace_back(i, last);
        } else if (trees_ && rules_.closes[kind]) {
            if (open.empty())
                throw Error(name_ + ": the ']' at position " + std::to_string(i) +
                            " closes nothing");
            closes_[open.back().first] = i;
            last = open.back().second;
            open.pop_back();
        } else if (!rules_.ignored[kind]) {
            last = i;
        }
    }
    if (!open.empty())
        throw Error(name_ + ": the '[' at position " + std::to_string(open.back().first) +
                    " is not closed");
}

void Surroundings::find_right() {
    const std::size_t size = word_.kinds.size();
    axis_.resize(size + 1);
    axis_[size] = none;
    for (std::size_t i = size; i-- > 0;) {
        const ModuleKind kind = word_.kinds[i];
        if (trees_ && rules_.closes[kind])
            axis_[i] = none;
        else if (trees_ && rules_.opens[kind])
            axis_[i] = axis_[closes_[i] + 1];
        else
            axis_[i] = rules_.ignored[kind] ? axis_[i + 1] : i;
    }
}

void Surroundings::bind(std::size_t position, std::vector<double>& parameters,
                        std::size_t& filled) const {
    const std::uint32_t arity = rules_.kinds.arity(word_.kinds[position]);
    std::copy_n(values_at(position), arity,
                parameters.begin() + static_cast<std::ptrdiff_t>(filled));
    filled += arity;
}

/// The search for a right context, which goes back where a branch was the wrong one, be it that
/// the condition does not hold.
struct Surroundings::Search {
    const Surroundings& around;
    const Alternatives& rules;
    std::size_t position;
    std::vector<double>& parameters;
    std::vector<std::size_t> inside = {};  // the closing brackets of the branches gone into

    bool match(std::size_t item, std::size_t from, std::size_t filled) {
        const auto& context = rules.right;
        if (item == context.size())
            return around.match_elsewhere(rules, position, 0, filled, parameters);
        if (around.trees_ && around.rules_.opens[context[item]])
            return match_branch(item, from, filled);
        if (around.trees_ && around.rules_.closes[context[item]]) {
            const std::size_t close = inside.back();
            inside.pop_back();
            const bool found = match(item + 1, close + 1, filled);
            inside.push_back(close);
            return found;
        }
        const std::size_t next = around.axis_[from];
        if (next == none || around.word_.kinds[next] != context[item]) return false;
        around.bind(next, parameters, filled);
        return match(item + 1, next + 1, filled);
    }

    bool match_branch(std::size_t item, std::size_t from, std::size_t filled) {
        const auto& kinds = around.word_.kinds;
        for (std::size_t i = from; i < kinds.size(); ++i) {
            if (around.rules_.ignored[kinds[i]]) continue;
            if (!around.rules_.opens[kinds[i]]) return false;
            inside.push_back(around.closes_[i]);
            const bool found = match(item + 1, i + 1, filled);
            inside.pop_back();
            if (found) return true;
            i = around.closes_[i];
        }
        return false;
    }
};

bool Surroundings::match_left(const Alternatives& rules, std::size_t position,
                              std::vector<double>& parameters, std::size_t& filled) const {
    std::size_t total = 0;
    for (const ModuleKind kind : rules.left) total += rules_.kinds.arity(kind);
    std::size_t end = filled + total;
    filled = end;
    std::size_t at = position;
    for (auto wanted = rules.left.rbegin(); wanted != rules.left.rend(); ++wanted) {
        at = left_[at];
        if (at == none || word_.kinds[at] != *wanted) return false;
        const std::uint32_t arity = rules_.kinds.arity(*wanted);
        end -= arity;
        std::copy_n(values_at(at), arity, parameters.begin() + static_cast<std::ptrdiff_t>(end));
    }
    return true;
}

bool Surroundings::match_elsewhere(const Alternatives& rules, std::size_t position,
                                   std::size_t item, std::size_t filled,
                                   std::vector<double>& parameters) const {
    if (rules.elsewhere.empty())
        return !rules.condition || rules.condition->run(parameters.data()) != 0;
    for (const auto& conjunct : rules.conjuncts)
        if (conjunct.elsewhere == item && conjunct.holds.run(parameters.data()) == 0) return false;
    if (item == rules.elsewhere.size()) return true;
    budget_.check();
    for (const std::size_t at : at_[rules.elsewhere[item]]) {
        if (at == position) continue;
        std::size_t end = filled;
        bind(at, parameters, end);
        if (match_elsewhere(rules, position, item + 1, end, parameters)) return true;
    }
    return false;
}

bool Surroundings::match(const Alternatives& rules, std::size_t position,
                         std::vector<double>& parameters) const {
    parameters.resize(rules.parameters);
    std::size_t filled = 0;
    bind(position, parameters, filled);
    if (!match_left(rules, position, parameters, filled)) return false;
    return Search{*this, rules, position, parameters}.match(0, position + 1, filled);
}

}  // namespace algae
