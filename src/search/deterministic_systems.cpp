#include <algorithm>

#include "search/search.hpp"

// How many D0L systems of a size are there up to renaming, and which is the one of a given number?
//
// The least text of a deterministic system is axiom#h(x1)#h(x2)#... with letters numbered where they first occur: a restricted growth
// text. As every letter is accessible, each rule can be read when its letter has occurred, so nothing but the system itself is in
// the way of numbering; no renaming leaves it as it is, and systems up to renaming are such texts. They are the paths of an automaton
// whose state is small: letters that have occurred (u), rules given or begun (r), letters still to come of the word (m), size
// left behind this word (s). With exactly k letters:
//
//     W(u, r, m, s) = u W(u, r, m-1, s) + W(u+1, r, m-1, s)          an old letter, or the next new one if u < k
//     W(u, r, 0, s) = [u = k and s = 0]                              if all rules are given, u = r
//                   = sum over l of W(u, r+1, l, s-1-l)              otherwise: the length of the next rule's word is chosen first
//
// The order of words, shorter first and then by letters, is the order in which these choices are tried, so the number of a system is
// the sum of the W of choices passed by, and a system is found by its number by going down (Nijenhuis and Wilf 1978, on ranking
// by paths). What is subtle: r counts the word in progress, so the axiom is W(0, 0, l, size-l); u = r with letters left of the word
// is no end.

namespace algae {

/// The table W for one number of letters.
struct DeterministicSystems::Ways {
    Ways(std::uint64_t size_, std::size_t k_, bool propagating, const Budget& budget)
        : size(static_cast<std::size_t>(size_)), k(k_), shortest(propagating ? 1 : 0) {
        const std::uint64_t entries = (k + 1) * (k + 2) * (size + 1) * (size + 1);
        budget.check_memory(entries * sizeof(Integer), "the table that counts systems");
        table.resize(static_cast<std::size_t>(entries));
        // What an entry needs has a greater r, or the same r and a smaller m.
        for (std::size_t r = k + 1; r-- > 0;) {
            budget.check();
            for (std::size_t s = 0; s <= size; ++s)
                for (std::size_t u = k + 1; u-- > r;) at(u, r, 0, s) = begun(u, r, s);
            for (std::size_t m = 1; m <= size; ++m)
                for (std::size_t s = 0; s + m <= size; ++s)
                    for (std::size_t u = k + 1; u-- > 0;) {
                        Integer ways = u == 0 ? Integer() : Integer(u) * at(u, r, m - 1, s);
                        if (u < k) ways += at(u + 1, r, m - 1, s);
                        at(u, r, m, s) = std::move(ways);
                    }
        }
    }

    Integer& at(std::size_t u, std::size_t r, std::size_t m, std::size_t s) {
        return table[((u * (k + 2) + r) * (size + 1) + m) * (size + 1) + s];
    }
    const Integer& at(std::size_t u, std::size_t r, std::size_t m, std::size_t s) const {
        return table[((u * (k + 2) + r) * (size + 1) + m) * (size + 1) + s];
    }
    /// W(u, r, 0, s).
    Integer begun(std::size_t u, std::size_t r, std::size_t s) const {
        if (u == r) return u == k && s == 0 ? 1 : 0;
        Integer ways;
        for (std::size_t l = shortest; l + 1 <= s; ++l) ways += at(u, r + 1, l, s - 1 - l);
        return ways;
    }
    /// All systems with k letters.
    Integer all() const {
        Integer ways;
        for (std::size_t l = 1; l <= size; ++l) ways += at(0, 0, l, size - l);
        return ways;
    }

    std::size_t size, k, shortest;
    std::vector<Integer> table;
};

/// A walk through the texts with k letters from one number on.
struct DeterministicSystems::Path {
    const Ways& ways;
    const Budget& budget;
    const InstanceVisitor& visitor;
    Integer skipped;  // how many systems are still to be passed by
    std::optional<Integer> left;
    bool is_stopped = false;
    Instance instance = {};
    std::uint32_t steps = 0;

    /// Whether the systems behind a choice are passed by, all of them.
    bool passes(const Integer& behind) {
        if (behind.is_zero()) return true;
        if (skipped.is_zero() || skipped < behind) return false;
        skipped -= behind;
        return true;
    }

    /// Goes on behind m letters of the present word that are still to come; false ends the walk.
    bool letter(std::size_t u, std::size_t r, std::size_t m, std::size_t s) {
        if (m == 0) return u == r ? whole() : rule(u, r + 1, s);
        for (std::size_t a = 0; a <= u && a < ways.k; ++a) {
            const std::size_t seen = a == u ? u + 1 : u;
            if (passes(ways.at(seen, r, m - 1, s))) continue;
            instance.letters_.push_back(static_cast<Symbol>(a));
            const bool goes_on = letter(seen, r, m - 1, s);
            instance.letters_.pop_back();
            if (!goes_on) return false;
        }
        return true;
    }

    bool word(std::size_t u, std::size_t r, std::size_t length, std::size_t s) {
        if (passes(ways.at(u, r, length, s))) return true;
        instance.pieces_.push_back(instance.words_.size());
        instance.words_.push_back(instance.letters_.size());
        const bool goes_on = letter(u, r, length, s);
        instance.words_.pop_back();
        instance.pieces_.pop_back();
        return goes_on;
    }

    bool rule(std::size_t u, std::size_t r, std::size_t s) {
        for (std::size_t l = ways.shortest; l + 1 <= s; ++l)
            if (!word(u, r, l, s - 1 - l)) return false;
        return true;
    }

    bool whole() {
        if (++steps % 4096 == 0) budget.check();
        if (left) {
            if (left->is_zero()) return false;
            *left -= 1;
        }
        is_stopped = !visitor(instance);
        return !is_stopped;
    }

    bool all() {
        instance.size_ = ways.size;
        instance.letter_count_ = ways.k;
        instance.values_.resize(1);
        instance.values_[0].kind = Domain::Kind::system;
        for (std::size_t a = 0; a < ways.k; ++a)
            instance.values_[0].owners.push_back(static_cast<Symbol>(a));
        for (std::size_t l = 1; l <= ways.size; ++l)
            if (!word(0, 0, l, ways.size - l)) return false;
        return true;
    }
};

DeterministicSystems::DeterministicSystems(std::uint64_t size, bool propagating,
                                           std::optional<std::uint64_t> letters,
                                           const Budget& budget)
    : size_(size), propagating_(propagating), budget_(budget), counts_(1) {
    // A letter occurs once and has a rule: at least two, or three, and only in the axiom of the last rule's word.
    const std::uint64_t most = std::min(size / 2, letters.value_or(size));
    for (std::size_t k = 1; k <= most; ++k)
        counts_.push_back(Ways(size, k, propagating, budget).all());
}

Integer DeterministicSystems::count() const {
    Integer all;
    for (const Integer& some : counts_) all += some;
    return all;
}

Integer DeterministicSystems::count(std::size_t letters) const {
    return letters < counts_.size() ? counts_[letters] : Integer();
}

Instance DeterministicSystems::at(const Integer& index) const {
    if (index < 0 || index >= count())
        throw Error("expected the number of one of " + to_string(count()) + " systems of size " +
                    std::to_string(size_) + ", found " + to_string(index));
    Instance found;
    visit(
        [&](const Instance& instance) {
            found = instance;
            return true;
        },
        index, index + 1);
    return found;
}

bool DeterministicSystems::visit(const InstanceVisitor& visitor, Integer first,
                                 const std::optional<Integer>& last) const {
    if (last && *last <= first) return true;
    std::optional<Integer> left;
    if (last) left = *last - first;
    for (std::size_t k = 1; k < counts_.size(); ++k) {
        if (counts_[k].is_zero()) continue;
        if (first >= counts_[k]) {
            first -= counts_[k];
            continue;
        }
        if (left && left->is_zero()) return true;
        const Ways ways(size_, k, propagating_, budget_);
        Path path{ways, budget_, visitor, first, left};
        if (!path.all()) return !path.is_stopped;
        left = path.left;
        first = 0;
    }
    return true;
}

}  // namespace algae
