#include "language/construct_propagating.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "language/construct_draft.hpp"
#include "language/construct_synchronised.hpp"

namespace algae {

namespace {

using Letters = std::set<Symbol>;

bool all_marked(const auto& letters, const std::vector<char>& marks) {
    return std::all_of(letters.begin(), letters.end(), [&](Symbol a) { return marks[a] != 0; });
}

/// The letters that derive, each with tables of its own, words of letters that may go.
std::vector<char> vanishing(const ET0L& system, std::vector<char> found) {
    for (bool grown = true; grown;) {
        grown = false;
        for (const Table& rules : system.tables)
            for (Symbol a = 0; a < rules.size(); ++a)
                if (!found[a] &&
                    std::any_of(rules[a].begin(), rules[a].end(),
                                [&](const Word& word) { return all_marked(word, found); }))
                    found[a] = grown = true;
    }
    return found;
}

/// The least sets of letters that vanish which words over these letters become in one step.
std::set<Letters> next_sets(const Letters& letters, const Table& rules,
                            const std::vector<char>& vanish) {
    std::set<Letters> found{{}};
    for (const Symbol a : letters) {
        std::set<Letters> longer;
        for (const Letters& begun : found)
            for (const Word& successor : rules[a])
                if (all_marked(successor, vanish)) {
                    Letters more = begun;
                    more.insert(successor.begin(), successor.end());
                    longer.insert(std::move(more));
                }
        found.clear();
        for (const Letters& candidate : longer)
            if (std::none_of(longer.begin(), longer.end(), [&](const Letters& other) {
                    return other.size() < candidate.size() &&
                           std::includes(candidate.begin(), candidate.end(), other.begin(),
                                         other.end());
                }))
                found.insert(candidate);
    }
    return found;
}

/// The letters of the result and its rules, from the axiom on.
class Guesses {
public:
    Guesses(const ET0L& system, const Alphabet& base, const std::vector<char>& vanish,
            const Budget& budget)
        : system_(&system), draft_(base, 0), vanish_(&vanish), budget_(&budget) {
        draft_.add_tables(system);
    }

    ET0L result(std::string name) {
        const Word axiom{*letter(system_->axiom.front(), {})};
        while (!open_.empty()) {
            const auto [a, set] = open_.back();
            open_.pop_back();
            for (std::size_t t = 0; t < system_->tables.size(); ++t)
                for (const Letters& next : next_sets(set, system_->tables[t], *vanish_))
                    for (const Word& successor : system_->tables[t][a])
                        add_rules(t, letters_.at({a, set}), successor, next);
        }
        return draft_.system(axiom, std::move(name));
    }

private:
    /// The letter for a letter that remains and a set that vanishes; none if not all of them become
    /// terminals in the same step.
    std::optional<Symbol> letter(Symbol a, const Letters& set) {
        const bool done = system_->terminal[a];
        for (const Symbol b : set)
            if ((system_->terminal[b] != 0) != done) return std::nullopt;
        if (done) return draft_.terminal(system_->alphabet->name(a));
        const auto [place, fresh] = letters_.try_emplace({a, set}, 0);
        if (fresh) {
            place->second = draft_.fresh(system_->alphabet->name(a));
            open_.emplace_back(a, set);
        }
        return place->second;
    }

    /// One rule for each way to choose what remains of the successor.
    void add_rules(std::size_t table, Symbol from, const Word& successor, const Letters& set) {
        std::vector<char> gone(successor.size());
        for (;;) {
            add_rule(table, from, successor, set, gone);
            std::size_t i = 0;  // counts in binary over the letters that may vanish
            while (i < gone.size() && (gone[i] || !(*vanish_)[successor[i]])) gone[i++] = false;
            if (i == gone.size()) return;
            gone[i] = true;
            draft_.check(*budget_);
        }
    }

    void add_rule(std::size_t table, Symbol from, const Word& successor, Letters set,
                  const std::vector<char>& gone) {
        for (std::size_t i = 0; i < successor.size(); ++i)
            if (gone[i]) set.insert(successor[i]);
        Word word;
        for (std::size_t i = 0; i < successor.size(); ++i) {
            if (gone[i]) continue;
            const auto next = letter(successor[i], set);
            if (!next) return;
            word.push_back(*next);
            set.clear();
        }
        if (!word.empty()) draft_.add_rule(table, from, word);
    }

    const ET0L* system_;
    Draft draft_;
    const std::vector<char>* vanish_;
    const Budget* budget_;
    std::map<std::pair<Symbol, Letters>, Symbol> letters_;
    std::vector<std::pair<Symbol, Letters>> open_;
};

}  // namespace

ET0L propagating(const ET0L& system, const Budget& budget) { return thinned(system, {}, budget); }

ET0L thinned(const ET0L& system, const std::vector<char>& may_go, const Budget& budget) {
    const ET0L separate = synchronised(system);
    std::vector<char> vanish(separate.alphabet->size());
    for (Symbol a = 0; a < may_go.size(); ++a) vanish[a] = may_go[a] && separate.terminal[a];
    vanish = vanishing(separate, std::move(vanish));
    return Guesses(separate, *system.alphabet, vanish, budget).result(system.name);
}

bool can_vanish(const ET0L& system, const std::vector<char>& may_go, const Budget& budget) {
    std::vector<char> gone(system.alphabet->size());
    for (Symbol a = 0; a < may_go.size(); ++a) gone[a] = may_go[a] && system.terminal[a];
    const std::vector<char> vanish = vanishing(system, gone);
    const Letters axiom(system.axiom.begin(), system.axiom.end());
    std::set<Letters> seen{axiom};
    std::vector<Letters> open{axiom};
    std::uint64_t bytes = 0;
    while (!open.empty()) {
        const Letters letters = std::move(open.back());
        open.pop_back();
        if (all_marked(letters, gone)) return true;
        for (const Table& rules : system.tables)
            for (const Letters& next : next_sets(letters, rules, vanish))
                if (seen.insert(next).second) {
                    open.push_back(next);
                    budget.check();
                    budget.check_memory(bytes += 64 * (next.size() + 1),
                                        "the sets of letters that vanish");
                }
    }
    return false;
}

}  // namespace algae
