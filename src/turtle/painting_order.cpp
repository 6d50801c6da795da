#include "turtle/detail/view.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <queue>
#include <utility>

// The order in which things are painted: everything after what it hides.
//
// Only things whose boxes meet can hide each other. A board of squares over the picture, about as many as
// there are things, tells which these are: a pair is compared in the first square that both reach into.
// The relation is sorted topologically (Kahn), and of all that is ready the farthest goes first. Where
// nothing is ready, some things hide each other in a ring: the farthest is painted all the same, and the
// strong components of what was left then are the knots that the caller may cut.

namespace algae {

namespace {

constexpr std::uint64_t most_comparisons = 40'000'000;

/// A board of squares over the picture that tells which things reach into each.
class Board {
public:
    explicit Board(std::span<const Extent> things) {
        double right = 0, top = 0;
        std::size_t count = 0;
        bool first = true;
        for (const Extent& thing : things) {
            left_ = first ? thing.left : std::min(left_, thing.left);
            bottom_ = first ? thing.bottom : std::min(bottom_, thing.bottom);
            right = first ? thing.right : std::max(right, thing.right);
            top = first ? thing.top : std::max(top, thing.top);
            first = false;
            if (!thing.slight) ++count;
        }
        size_ = static_cast<std::uint32_t>(
            std::clamp(1.5 * std::sqrt(static_cast<double>(count)), 1.0, 1000.0));
        across_ = right > left_ ? size_ / (right - left_) : 0;
        up_ = top > bottom_ ? size_ / (top - bottom_) : 0;
        starts_.assign(std::size_t{size_} * size_ + 1, 0);
        for (std::uint32_t i = 0; i < things.size(); ++i)
            if (!things[i].slight)
                each_square(things[i], [&](std::size_t square) { ++starts_[square + 1]; });
        std::partial_sum(starts_.begin(), starts_.end(), starts_.begin());
        members_.resize(starts_.back());
        std::vector<std::uint64_t> next(starts_.begin(), starts_.end() - 1);
        for (std::uint32_t i = 0; i < things.size(); ++i)
            if (!things[i].slight)
                each_square(things[i], [&](std::size_t square) { members_[next[square]++] = i; });
    }

    std::size_t square(double x, double y) const { return std::size_t{row(y)} * size_ + column(x); }
    std::span<const std::uint32_t> members(std::size_t square) const {
        return std::span(members_).subspan(starts_[square], starts_[square + 1] - starts_[square]);
    }
    template <class Visit>
    void each_square(const Extent& thing, Visit visit) const {
        const std::uint32_t last_row = row(thing.top), last_column = column(thing.right);
        for (std::uint32_t y = row(thing.bottom); y <= last_row; ++y)
            for (std::uint32_t x = column(thing.left); x <= last_column; ++x)
                visit(std::size_t{y} * size_ + x);
    }

private:
    std::uint32_t column(double x) const { return index((x - left_) * across_); }
    std::uint32_t row(double y) const { return index((y - bottom_) * up_); }
    std::uint32_t index(double at) const {
        return std::min(static_cast<std::uint32_t>(std::max(at, 0.0)), size_ - 1);
    }

    double left_ = 0, bottom_ = 0, across_ = 0, up_ = 0;
    std::uint32_t size_ = 1;
    std::vector<std::uint64_t> starts_;  // by square, into members_
    std::vector<std::uint32_t> members_;
};

using Pair = std::pair<std::uint32_t, std::uint32_t>;

/// Every pair (hidden, hiding) that a comparison finds.
std::vector<Pair> hidden_pairs(std::span<const Extent> things, const Hiding& hiding,
                               const Budget& budget) {
    const Board board(things);
    std::vector<Pair> pairs;
    std::uint64_t comparisons = 0;
    for (std::uint32_t i = 0; i < things.size() && comparisons < most_comparisons; ++i) {
        if ((i & 0x3ff) == 0) budget.check();
        const Extent& one = things[i];
        board.each_square(one, [&](std::size_t square) {
            for (const std::uint32_t j : board.members(square)) {
                if (j == i || (!one.slight && j < i)) continue;
                const Extent& other = things[j];
                const double left = std::max(one.left, other.left),
                             bottom = std::max(one.bottom, other.bottom);
                if (left >= std::min(one.right, other.right) ||
                    bottom >= std::min(one.top, other.top))
                    continue;
                if (board.square(left, bottom) != square)
                    continue;  // met once, in the first square they share
                ++comparisons;
                const int found = hiding(i, j);
                if (found > 0) pairs.emplace_back(j, i);
                if (found < 0) pairs.emplace_back(i, j);
            }
        });
        budget.check_memory(pairs.size() * sizeof(Pair), "what hides what in a figure in space");
    }
    return pairs;
}

}  // namespace

PaintingOrder painting_order(std::span<const Extent> things, const Hiding& hiding,
                             const Budget& budget) {
    const auto count = static_cast<std::uint32_t>(things.size());
    std::vector<std::uint32_t> by_depth(count), rank(count);
    std::iota(by_depth.begin(), by_depth.end(), 0);
    std::stable_sort(by_depth.begin(), by_depth.end(), [&](std::uint32_t a, std::uint32_t b) {
        return things[a].depth < things[b].depth;
    });
    for (std::uint32_t i = 0; i < count; ++i) rank[by_depth[i]] = i;

    const std::vector<Pair> pairs = hidden_pairs(things, hiding, budget);
    std::vector<std::uint64_t> starts(std::size_t{count} + 1, 0);
    std::vector<std::uint32_t> over(pairs.size()), waiting(count, 0);
    for (const Pair& pair : pairs) {
        ++starts[pair.first + 1];
        ++waiting[pair.second];
    }
    std::partial_sum(starts.begin(), starts.end(), starts.begin());
    std::vector<std::uint64_t> next(starts.begin(), starts.end() - 1);
    for (const Pair& pair : pairs) over[next[pair.first]++] = pair.second;

    PaintingOrder result;
    result.order.reserve(count);
    std::vector<char> painted(count, 0);
    std::priority_queue<std::uint32_t, std::vector<std::uint32_t>, std::greater<>> ready;  // ranks
    for (std::uint32_t i = 0; i < count; ++i)
        if (waiting[i] == 0) ready.push(rank[i]);
    std::vector<std::uint32_t> left_over;  // what was not painted when nothing was ready first
    std::uint32_t farthest = 0;
    while (result.order.size() < count) {
        if ((result.order.size() & 0xfff) == 0) budget.check();
        if (ready.empty()) {
            if (left_over.empty())
                for (std::uint32_t i = 0; i < count; ++i)
                    if (!painted[i]) left_over.push_back(i);
            while (painted[by_depth[farthest]]) ++farthest;
            ready.push(farthest);
        }
        const std::uint32_t thing = by_depth[ready.top()];
        ready.pop();
        if (painted[thing]) continue;
        painted[thing] = 1;
        result.order.push_back(thing);
        for (std::uint64_t i = starts[thing]; i < starts[thing + 1]; ++i)
            if (--waiting[over[i]] == 0 && !painted[over[i]]) ready.push(rank[over[i]]);
    }
    if (left_over.empty()) return result;

    std::vector<std::uint32_t> local(count, 0);
    for (std::uint32_t i = 0; i < left_over.size(); ++i) local[left_over[i]] = i + 1;
    std::vector<std::vector<std::size_t>> under(left_over.size());
    for (const Pair& pair : pairs)
        if (local[pair.first] && local[pair.second])
            under[local[pair.first] - 1].push_back(local[pair.second] - 1);
    const std::vector<std::size_t> component = strong_components(under);
    std::vector<std::uint32_t> sizes(left_over.size(), 0);  // by component
    for (const std::size_t number : component) ++sizes[number];
    for (std::size_t i = 0; i < left_over.size(); ++i)
        if (sizes[component[i]] > 1) result.knotted.push_back(left_over[i]);
    return result;
}

}  // namespace algae
