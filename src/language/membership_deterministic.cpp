#include "language/membership_deterministic.hpp"

#include <algorithm>

#include "base/error.hpp"
#include "fold/derive.hpp"
#include "language/finiteness_letters.hpp"

namespace algae {

namespace {

D0L d0l_of(const OL& system) {
    std::vector<Word> images;
    for (const auto& choices : system.successors) images.push_back(choices.front());
    return make_d0l(system.alphabet, system.axiom, std::move(images), system.name);
}

/// Numbers of letters, all above a bound taken as one above it: sums and products of exact numbers
/// and of these agree.
class Saturated {
public:
    explicit Saturated(std::uint64_t bound) : over_(bound + 1) {}
    std::uint64_t sum(std::uint64_t left, std::uint64_t right) const { return std::min(left + right, over_); }
    bool is_over(std::uint64_t number) const { return number >= over_; }

private:
    std::uint64_t over_;
};

/// How often each letter occurs, by symbol.
std::vector<std::uint64_t> occurrences(const Word& word, std::size_t size, const Saturated& numbers) {
    std::vector<std::uint64_t> count(size, 0);
    for (const Symbol a : word) count[a] = numbers.sum(count[a], 1);
    return count;
}

/// A letter and how often it occurs in a successor.
using Contents = std::vector<std::vector<std::pair<Symbol, std::uint64_t>>>;

Contents contents(const D0L& system) {
    Contents all(system.alphabet->size());
    for (const Symbol a : system.letters) {
        Word sorted = system.successor(a);
        std::sort(sorted.begin(), sorted.end());
        for (const Symbol b : sorted) {
            if (all[a].empty() || all[a].back().first != b) all[a].emplace_back(b, 0);
            ++all[a].back().second;
        }
    }
    return all;
}

std::uint64_t times(std::uint64_t left, std::uint64_t right, const Saturated& numbers) {
    if (left == 0 || right == 0) return 0;
    if (left > UINT32_MAX || right > UINT32_MAX) return numbers.sum(UINT32_MAX, UINT32_MAX);
    return numbers.sum(left * right, 0);
}

Membership infinite_membership(const D0L& system, const std::vector<char>& growing, const Word& word,
                               const Budget& budget) {
    using enum Membership::Reason;
    const Saturated numbers(word.size());
    const Contents rules = contents(system);
    const auto wanted = occurrences(word, system.alphabet->size(), numbers);
    auto count = occurrences(system.axiom, system.alphabet->size(), numbers);
    std::vector<std::uint64_t> length(system.alphabet->size(), 1);  // of what each letter becomes, step by step
    auto next = count;
    for (std::uint64_t step = 0;; ++step) {
        if (step % 1024 == 0) budget.check();
        if (count == wanted && derive(system, step, budget) == word) return {true, derived, step, 0, 0};
        if (std::all_of(system.letters.begin(), system.letters.end(),
                        [&](Symbol a) { return !growing[a] || numbers.is_over(length[a]); }))
            return {false, outgrown, step, 0, 0};
        for (const Symbol a : system.letters) {
            next[a] = 0;
            for (const auto& [b, often] : rules[a]) next[a] = numbers.sum(next[a], times(often, length[b], numbers));
        }
        for (const Symbol a : system.letters) length[a] = next[a];
        std::fill(next.begin(), next.end(), 0);
        for (const Symbol a : system.letters)
            for (const auto& [b, often] : rules[a]) next[b] = numbers.sum(next[b], times(often, count[a], numbers));
        std::swap(count, next);
    }
}

/// The generation after `now`.
Word after(const D0L& system, const Word& now, const Budget& budget) {
    Word next;
    for (const Symbol a : now) {
        const Word& successor = system.successor(a);
        next.insert(next.end(), successor.begin(), successor.end());
        if (next.size() > budget.letters)
            throw BoundReached(Bound::letters,
                               "a generation has more than " + std::to_string(budget.letters) +
                                   " letters, the bound set" + budget.by(Bound::letters));
    }
    return next;
}

Membership finite_membership(const D0L& system, const Word& word, const Budget& budget) {
    using enum Membership::Reason;
    Word now = system.axiom, remembered = now;
    std::uint64_t remembered_step = 0;
    for (std::uint64_t step = 0, until = 1;; ++step) {
        if (step % 1024 == 0) budget.check();
        if (now == word) return {true, derived, step, 0, 0};
        if (step > 0 && now == remembered) return {false, periodic, step, remembered_step, 0};
        if (step == until) {
            remembered = now;
            remembered_step = step;
            until *= 2;
        }
        now = after(system, now, budget);
    }
}

}  // namespace

Membership deterministic_membership(const OL& system, const Word& word, const Budget& budget) {
    const LetterFutures futures = letter_futures(system);
    const D0L rules = d0l_of(system);
    const bool infinite = std::any_of(system.letters.begin(), system.letters.end(), [&](Symbol a) { return futures.growing[a] != 0; });
    return infinite ? infinite_membership(rules, futures.growing, word, budget) : finite_membership(rules, word, budget);
}

Derivation deterministic_derivation(const OL& system, std::uint64_t step, const Budget& budget) {
    const D0L rules = d0l_of(system);
    Derivation found{{system.axiom}, {}};
    std::uint64_t letters = system.axiom.size();
    for (std::uint64_t t = 0; t < step; ++t) {
        if (t % 1024 == 0) budget.check();
        found.choices.emplace_back(found.words.back().size(), 0);
        found.words.push_back(after(rules, found.words.back(), budget));
        letters += found.words.back().size() + 1;
        budget.check_memory(letters * 8, "the words of the derivation");
    }
    return found;
}

}  // namespace algae
