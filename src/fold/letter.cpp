#include "fold/letter.hpp"

#include <algorithm>
#include <string>

#include "fold/walk.hpp"

namespace algae {

namespace {

/// The lengths of the words that letters become in k steps, none counted beyond a cap. Rows are
/// kept at every `stride`-th k and worked out again between, so n rows take the space of 2 sqrt(n).
class CappedLengths {
public:
    CappedLengths(const D0L& system, std::uint64_t n, const Integer& cap, const Budget& budget)
        : system_(system), cap_(cap), budget_(budget) {
        while (stride_ < std::uint64_t{1} << 32 && stride_ * stride_ < n) stride_ *= 2;
        Row row(system.alphabet->size(), Integer(0));
        for (const Symbol a : system.letters) row[a] = 1;
        for (std::uint64_t k = 0;; ++k) {
            if (k % 1024 == 0) budget.check();
            if (k % stride_ == 0) {
                kept_.push_back(row);
                check_memory();
            }
            if (k == n) break;
            Row next = after(row);
            if (next == row) {  // and so for ever
                settled_ = k;
                break;
            }
            row = std::move(next);
        }
    }

    const Integer& of(Symbol a, std::uint64_t k) {
        k = std::min(k, settled_);
        const std::uint64_t segment = k / stride_;
        if (segment != segment_ || rows_.empty()) {
            segment_ = segment;
            rows_.assign(1, kept_.at(static_cast<std::size_t>(segment)));
        }
        while (rows_.size() <= k % stride_) {
            if (rows_.size() % 1024 == 0) {
                budget_.check();
                check_memory();
            }
            rows_.push_back(after(rows_.back()));
        }
        return rows_[static_cast<std::size_t>(k % stride_)][a];
    }

private:
    using Row = std::vector<Integer>;

    Row after(const Row& row) const {
        Row next(row.size(), Integer(0));
        for (const Symbol a : system_.letters) {
            for (const Symbol b : system_.successor(a)) {
                next[a] += row[b];
                if (next[a] >= cap_) {
                    next[a] = cap_;
                    break;
                }
            }
        }
        return next;
    }

    void check_memory() const {
        const std::uint64_t number = sizeof(Integer) + (bit_length(cap_) > 62 ? 16 + bit_length(cap_) / 8 : 0);
        budget_.check_memory((kept_.size() + rows_.size()) * system_.alphabet->size() * number,
                             "the table of lengths");
    }

    const D0L& system_;
    Integer cap_;
    const Budget& budget_;
    std::uint64_t stride_ = 1;
    std::uint64_t settled_ = UINT64_MAX;
    std::vector<Row> kept_;
    std::uint64_t segment_ = UINT64_MAX;
    std::vector<Row> rows_;
};

struct Step {
    const Symbol* next;
    const Symbol* end;
    std::uint64_t steps;
};

}  // namespace

Word letters_at(const D0L& system, std::uint64_t n, const Integer& at, std::uint64_t count,
                const Budget& budget) {
    count = std::min(count, budget.letters == UINT64_MAX ? UINT64_MAX - 1 : budget.letters + 1);
    if (at < 0)
        throw Error("position " + to_string(at) + " is before the beginning: positions count from 0");
    const Fates fates(system);
    CappedLengths lengths(system, n, at + 1, budget);
    // The way down to the letter: at every generation the rest of a successor still to be read.
    std::vector<Step> path{{system.axiom.data(), system.axiom.data() + system.axiom.size(), n}};
    Integer left = at;
    std::uint64_t visits = 0;
    for (;;) {
        Step& here = path.back();
        while (here.next != here.end && lengths.of(*here.next, here.steps) <= left) {
            left -= lengths.of(*here.next, here.steps);
            ++here.next;
        }
        if (here.next == here.end) {
            // Only the axiom's row can end here: below, the letter is known to reach far enough.
            throw Error("position " + to_string(at) + " is past the end: generation " + std::to_string(n) +
                        " has " + to_string(at - left) + " letters");
        }
        if (here.steps == 0 || fates.is_constant(*here.next)) break;
        if (++visits % 4096 == 0) {
            budget.check();
            budget.check_memory(path.capacity() * sizeof(Step), "the way down to the letter");
        }
        const std::uint64_t steps = here.steps - 1;
        const Word& successor = system.successor(*here.next++);
        while (here.next != here.end && fates.is_gone(*here.next, here.steps)) ++here.next;
        if (here.next == here.end) path.pop_back();
        path.push_back({successor.data(), successor.data() + successor.size(), steps});
        // Every row above still gives a letter, so of more rows than letters asked for the uppermost
        // are never read.
        if (path.size() / 2 > count + 512) path.erase(path.begin(), path.end() - static_cast<std::ptrdiff_t>(count + 1));
    }
    // From here on letters follow each other without counting.
    Word found;
    while (found.size() < count && !path.empty()) {
        if (++visits % 65536 == 0) budget.check();
        Step& here = path.back();
        if (here.next == here.end) {
            path.pop_back();
            continue;
        }
        const Symbol a = *here.next++;
        const std::uint64_t steps = here.steps;
        if (steps == 0 || fates.is_constant(a)) {
            if (found.size() == budget.letters)
                throw BoundReached(Bound::letters, "more than " + std::to_string(budget.letters) +
                                                       " letters asked for, the bound set" +
                                                       budget.by(Bound::letters));
            found.push_back(a);
        } else if (!fates.is_gone(a, steps)) {
            const Word& successor = system.successor(a);
            while (here.next != here.end && fates.is_gone(*here.next, steps)) ++here.next;
            if (here.next == here.end) path.pop_back();
            path.push_back({successor.data(), successor.data() + successor.size(), steps - 1});
        }
    }
    return found;
}

}  // namespace algae
