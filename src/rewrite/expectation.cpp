#include "rewrite/expectation.hpp"

#include <algorithm>
#include <map>

#include "base/error.hpp"

namespace algae {

std::vector<Rational> expected_counts(const S0L& system, std::uint64_t n, const Budget& budget) {
    std::vector<Rational> counts(system.alternatives.size());
    for (const Symbol a : system.axiom) counts[a] += Rational(1);
    for (std::uint64_t k = 0; k < n; ++k) {
        budget.check();
        std::vector<Rational> next(counts.size());
        for (Symbol a = 0; a < counts.size(); ++a) {
            if (counts[a].is_zero()) continue;
            for (const auto& [word, probability] : system.alternatives[a]) {
                const Rational share = counts[a] * probability;
                for (const Symbol b : word) next[b] += share;
            }
        }
        counts = std::move(next);
    }
    return counts;
}

namespace {

/// Words with their probabilities, and about how many bytes they take.
class Likely {
public:
    explicit Likely(const Budget& budget) : budget_(&budget) {}

    void add(ModuleString word, const Rational& probability) {
        const std::size_t bytes =
            word.kinds.size() * sizeof(ModuleKind) + word.values.size() * sizeof(double) + 200;
        const auto [found, fresh] = words_.try_emplace(std::move(word));
        found->second += probability;
        if (!fresh) return;
        bytes_ += bytes;
        budget_->check_memory(bytes_, "the words with their probabilities");
    }

    const std::map<ModuleString, Rational>& words() const { return words_; }

private:
    const Budget* budget_;
    std::map<ModuleString, Rational> words_;
    std::uint64_t bytes_ = 0;
};

/// What one word becomes in a step.
Likely successors(const Rewriting& rewriting, const ModuleString& word, std::uint64_t generation,
                  std::size_t table, const Budget& budget) {
    const auto outcomes = rewriting.outcomes(word, generation, table, budget);
    Likely all(budget);
    all.add({}, Rational(1));
    std::size_t offset = 0;
    for (std::size_t i = 0; i < word.kinds.size(); ++i) {
        budget.check();
        Likely longer(budget);
        for (const auto& [beginning, probability] : all.words())
            for (const Rewriting::Outcome& outcome : outcomes[i]) {
                ModuleString next = beginning;
                rewriting.append(outcome, word, i, offset, generation, next);
                longer.add(std::move(next), probability * outcome.probability);
            }
        all = std::move(longer);
        offset += rewriting.rules().kinds.arity(word.kinds[i]);
    }
    return all;
}

}  // namespace

std::vector<LikelyWord> distribution(const Rewriting& rewriting, std::uint64_t n,
                                     const std::vector<std::size_t>& tables, const Budget& budget) {
    return distribution(rewriting, rewriting.axiom(), n, tables, budget);
}

std::vector<LikelyWord> distribution(const Rewriting& rewriting, const ModuleString& from,
                                     std::uint64_t n, const std::vector<std::size_t>& tables,
                                     const Budget& budget) {
    Likely words(budget);
    words.add(from, Rational(1));
    for (std::uint64_t generation = 0; generation < n; ++generation) {
        Likely next(budget);
        const std::size_t table = tables.empty()
                                      ? scheduled_table(*rewriting.rules().system, generation)
                                      : tables.at(generation);
        for (const auto& [word, probability] : words.words()) {
            const Likely after = successors(rewriting, word, generation, table, budget);
            for (const auto& [longer, share] : after.words()) next.add(longer, probability * share);
        }
        words = std::move(next);
    }
    std::vector<LikelyWord> out;
    for (const auto& [word, probability] : words.words()) out.push_back({word, probability});
    const auto ranks = rewriting.rules().system->alphabet.ranks();
    const auto& kinds = rewriting.rules().kinds;
    std::stable_sort(out.begin(), out.end(), [&](const LikelyWord& left, const LikelyWord& right) {
        const auto &a = left.word.kinds, &b = right.word.kinds;
        if (a.size() != b.size()) return a.size() < b.size();
        return std::lexicographical_compare(
            a.begin(), a.end(), b.begin(), b.end(), [&](ModuleKind x, ModuleKind y) {
                return std::pair(ranks[kinds.letter(x)], kinds.arity(x)) <
                       std::pair(ranks[kinds.letter(y)], kinds.arity(y));
            });
    });
    return out;
}

}  // namespace algae
