#include "language/membership.hpp"

#include <algorithm>
#include <optional>

#include "base/error.hpp"
#include "language/finiteness_letters.hpp"
#include "language/membership_deterministic.hpp"
#include "language/membership_table.hpp"

namespace algae {

bool is_derivation(const OL& system, const Derivation& derivation) {
    const auto& [words, choices, tables] = derivation;
    if (!tables.empty() || words.empty() || words.front() != system.axiom || choices.size() + 1 != words.size()) return false;
    for (std::size_t t = 0; t < choices.size(); ++t) {
        if (choices[t].size() != words[t].size()) return false;
        Word next;
        for (std::size_t i = 0; i < words[t].size(); ++i) {
            if (words[t][i] >= system.successors.size()) return false;
            const auto& successors = system.successors[words[t][i]];
            if (choices[t][i] >= successors.size()) return false;
            const Word& successor = successors[choices[t][i]];
            next.insert(next.end(), successor.begin(), successor.end());
        }
        if (next != words[t + 1]) return false;
    }
    return true;
}

namespace {

/// The first letter of the word that is in no word of the language.
std::optional<std::uint64_t> foreign_letter(const OL& system, const Word& word) {
    std::vector<char> known(system.alphabet->size(), 0);
    for (const Symbol a : system.letters) known[a] = 1;
    for (std::size_t i = 0; i < word.size(); ++i)
        if (word[i] >= known.size() || !known[word[i]]) return i;
    return std::nullopt;
}

/// The tables of steps n, n - 1, ..., 0, with every stride-th kept and those between worked out again.
class TablesBackwards {
public:
    TablesBackwards(const FactorTables& tables, std::uint64_t n, const Budget& budget)
        : tables_(&tables), budget_(&budget), stride_(1) {
        while (stride_ * stride_ < n) ++stride_;
        budget.check_memory((n / stride_ + stride_ + 2) * tables.bytes(), "the tables of a derivation");
        FactorTables::Table table = tables.first();
        for (std::uint64_t t = 0;; ++t) {
            budget.check();
            if (t % stride_ == 0) kept_.push_back(table);
            if (t == n) break;
            FactorTables::Table following;
            tables.next(table, following);
            table = std::move(following);
        }
    }

    const FactorTables::Table& of(std::uint64_t t) {
        if (block_.empty() || t / stride_ != number_) {
            budget_->check();
            number_ = t / stride_;
            block_.assign(1, kept_[static_cast<std::size_t>(number_)]);
            while (block_.size() < stride_) {
                FactorTables::Table following;
                tables_->next(block_.back(), following);
                block_.push_back(std::move(following));
            }
        }
        return block_[static_cast<std::size_t>(t % stride_)];
    }

private:
    const FactorTables* tables_;
    const Budget* budget_;
    std::uint64_t stride_;
    std::vector<FactorTables::Table> kept_, block_;
    std::uint64_t number_ = 0;
};

/// A letter and the factor of the word that it derives.
struct Share {
    Symbol letter;
    std::size_t from, to;
};

/// Appends what the letter becomes to `next`; returns the number of the rule.
std::uint32_t take_step(const OL& system, const LetterFutures& futures, const FactorTables& tables,
                        const FactorTables::Table& table, const Share& share, std::vector<Share>& next) {
    const auto& choices = system.successors[share.letter];
    if (share.from == share.to) {
        const std::uint32_t choice = erasing_choice(system, futures, share.letter);
        for (const Symbol b : choices[choice]) next.push_back({b, share.from, share.from});
        return choice;
    }
    for (std::uint32_t choice = 0; choice < choices.size(); ++choice)
        if (const auto stops = tables.split(table, choices[choice], share.from, share.to)) {
            std::size_t from = share.from;
            for (std::size_t i = 0; i < stops->size(); ++i) {
                next.push_back({choices[choice][i], from, (*stops)[i]});
                from = (*stops)[i];
            }
            return choice;
        }
    throw Error("no rule of " + system.alphabet->name(share.letter) + " continues the derivation");
}

}  // namespace

Membership membership(const OL& system, const Word& word, const Budget& budget) {
    using enum Membership::Reason;
    if (const auto position = foreign_letter(system, word)) return {false, foreign, 0, 0, *position};
    if (is_deterministic(system)) return deterministic_membership(system, word, budget);
    const FactorTables tables(system, word);
    budget.check_memory(3 * tables.bytes(), "the tables of what letters derive");
    FactorTables::Table table = tables.first(), following;
    // Brent 1980: one table is remembered, and a later one each time twice as many have passed.
    FactorTables::Table remembered = table;
    std::uint64_t remembered_step = 0;
    for (std::uint64_t step = 0, until = 1;; ++step) {
        budget.check();
        if (tables.derives(table, system.axiom)) return {true, derived, step, 0, 0};
        if (step > 0 && table == remembered) return {false, repeated, step, remembered_step, 0};
        if (step == until) {
            remembered = table;
            remembered_step = step;
            until *= 2;
        }
        tables.next(table, following);
        std::swap(table, following);
    }
}

std::optional<Derivation> find_derivation(const OL& system, const Word& word, std::uint64_t step, const Budget& budget) {
    if (foreign_letter(system, word)) return std::nullopt;
    if (is_deterministic(system)) {
        Derivation only = deterministic_derivation(system, step, budget);
        return only.words.back() == word ? std::optional(std::move(only)) : std::nullopt;
    }
    const FactorTables tables(system, word);
    const LetterFutures futures = letter_futures(system);
    TablesBackwards backwards(tables, step, budget);
    const auto stops = tables.split(backwards.of(step), system.axiom, 0, word.size());
    if (!stops) return std::nullopt;
    std::vector<Share> shares;
    for (std::size_t i = 0, from = 0; i < stops->size(); from = (*stops)[i++])
        shares.push_back({system.axiom[i], from, (*stops)[i]});
    Derivation found{{system.axiom}, {}};
    std::uint64_t letters = system.axiom.size();
    for (std::uint64_t left = step; left-- > 0;) {
        budget.check();
        std::vector<Share> next;
        std::vector<std::uint32_t> choices;
        const FactorTables::Table& table = backwards.of(left);
        for (const Share& share : shares) choices.push_back(take_step(system, futures, tables, table, share, next));
        shares = std::move(next);
        letters += shares.size();
        if (letters > budget.letters)
            throw BoundReached(Bound::letters, "the words of the derivation have more than " +
                                                   std::to_string(budget.letters) +
                                                   " letters together, the bound set" +
                                                   budget.by(Bound::letters));
        Word reached;
        for (const Share& share : shares) reached.push_back(share.letter);
        found.words.push_back(std::move(reached));
        found.choices.push_back(std::move(choices));
    }
    return found;
}

Derivation derivation(const OL& system, const Word& word, std::uint64_t step, const Budget& budget) {
    std::optional<Derivation> found = find_derivation(system, word, step, budget);
    if (!found) throw Error("the word is not in generation " + std::to_string(step));
    return *std::move(found);
}

}  // namespace algae
