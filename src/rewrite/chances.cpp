#include <algorithm>
#include <charconv>
#include <map>
#include <set>
#include <string>

#include "exact/exact.hpp"
#include "rewrite/rewrite.hpp"
#include "watch/watch.hpp"

// What chance does, exactly: the distribution of the words of a generation with rational probabilities, and all
// words that a system with choices can give. Both enumerate words and are bounded by the budget's memory.

namespace algae {

std::vector<Rational> expected_counts(const S0L& system, std::uint64_t n, const Budget& budget) {
    std::vector<Rational> counts(system.alternatives.size());
    for (const Symbol a : system.axiom) counts[a] += Rational(1);
    WorkCount generations("generation", n);
    for (std::uint64_t k = 0; k < n; ++k) {
        budget.check();
        generations.at(k + 1);
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
                                      : tables.at(static_cast<std::size_t>(generation));
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

namespace {

/// A set of words that knows about how many bytes it takes.
struct WordSet {
    std::set<Word> words;
    std::uint64_t bytes = 0;

    bool add(Word word, const Budget& budget) {
        const std::size_t taken = word.size() * sizeof(Symbol) + 80;
        if (!words.insert(std::move(word)).second) return false;
        budget.check_memory(bytes += taken, "the words on the way");
        return true;
    }
};

/// All words that a table makes of one.
void add_successors(const Table& table, const Word& word, std::size_t longest, const Budget& budget,
                    WordSet& to) {
    WordSet beginnings;
    beginnings.add({}, budget);
    for (const Symbol a : word) {
        budget.check();
        WordSet longer;
        for (const Word& beginning : beginnings.words)
            for (const Word& successor : table[a]) {
                if (beginning.size() + successor.size() > longest) continue;
                Word next = beginning;
                next.insert(next.end(), successor.begin(), successor.end());
                longer.add(std::move(next), budget);
            }
        beginnings = std::move(longer);
    }
    for (const Word& next : beginnings.words) to.add(next, budget);
}

std::size_t table_of(const std::vector<std::string>& tables, const std::string& name) {
    const auto found = std::find(tables.begin(), tables.end(), name);
    if (found != tables.end()) return static_cast<std::size_t>(found - tables.begin());
    std::size_t number = 0;
    const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), number);
    if (error == std::errc() && end == name.data() + name.size() && number >= 1 &&
        number <= tables.size())
        return number - 1;
    throw Error("expected a table (" + joined(tables, ", ") + ", or a number from 1 to " +
                std::to_string(tables.size()) + "), found \"" + name + '"');
}

}  // namespace

std::vector<Word> terminal_words(const ET0L& system, std::uint64_t n,
                                 std::optional<std::size_t> longest, const Budget& budget) {
    const std::size_t bound = longest && is_propagating(system) ? *longest : ~std::size_t{0} / 2;
    WordSet here, found;
    if (system.axiom.size() <= bound) here.add(system.axiom, budget);
    for (std::uint64_t k = 0;; ++k) {
        for (const Word& word : here.words)
            if ((!longest || word.size() <= *longest) &&
                std::all_of(word.begin(), word.end(),
                            [&](Symbol a) { return system.terminal[a] != 0; }))
                found.add(word, budget);
        if (k == n) break;
        WordSet next;
        for (const Table& table : system.tables)
            for (const Word& word : here.words) add_successors(table, word, bound, budget, next);
        if (next.words == here.words) break;  // and so for ever
        here = std::move(next);
    }
    std::vector<Word> out(found.words.begin(), found.words.end());
    const auto ranks = system.alphabet->ranks();
    std::sort(out.begin(), out.end(), [&](const Word& a, const Word& b) {
        if (a.size() != b.size()) return a.size() < b.size();
        return std::lexicographical_compare(
            a.begin(), a.end(), b.begin(), b.end(),
            [&](Symbol x, Symbol y) { return ranks[x] < ranks[y]; });
    });
    return out;
}

std::vector<std::size_t> table_sequence(const std::vector<std::string>& tables,
                                        const std::string& text) {
    if (tables.empty()) throw Error("the system has no tables to choose from");
    std::vector<std::size_t> out;
    if (text.find(',') != std::string::npos ||
        std::find(tables.begin(), tables.end(), text) != tables.end()) {
        for (std::size_t from = 0; from <= text.size();) {
            const std::size_t comma = std::min(text.find(',', from), text.size());
            out.push_back(table_of(tables, text.substr(from, comma - from)));
            from = comma + 1;
        }
        return out;
    }
    for (std::size_t from = 0; from < text.size();) {
        std::size_t size = 1;  // bytes of the character
        while (from + size < text.size() &&
               (static_cast<unsigned char>(text[from + size]) & 0xC0) == 0x80)
            ++size;
        out.push_back(table_of(tables, text.substr(from, size)));
        from += size;
    }
    return out;
}

}  // namespace algae
