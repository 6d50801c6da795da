#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "exact/exact.hpp"
#include "verify/detail/limit_set.hpp"

// Where the parts of a limit set meet, which of them lie in one place, and how fast the different ones multiply.
//
// Two parts of one level are seen from each other as a `Seen`: piece, heading and offset. A proof lists the ways in which
// parts of a component may meet. That the list is whole is checked: whatever pair follows from two parts of one piece, or
// from a pair of the list, is on the list, is one part twice, or lies apart, as discs show. There are finitely many ways, so the
// parts near any place are boundedly many, and the different parts of late levels give the dimension (Strichartz and Wang
// 1999; Ngai and Wang 2001).
//
// The different parts are counted by their codes. Of the codes of a part, which are words of the same length, the first
// in the order of a dictionary is kept. A beginning of a kept code is kept. A part, by its kept code, is of a kind: the other
// parts that may coincide with parts of it, and whether those have smaller codes. The kinds of its parts follow: such a part is
// left out if some part around with a smaller code has it, or an earlier part of the same whole is it. So kept codes are
// the paths of a graph. Where not everything that coincides is known to do so, some parts keep several codes: an upper bound.
//
// The rate of paths is the largest of the spectral radii of the strongly connected components; nodes that lead equally often to
// the same ones are joined, which keeps it. A bound of it, or of the rate of a map that grows with its argument, is a solution of
// image(W) < number * W in integers above 0 (Collatz and Wielandt): W = 1 + image(W) / number, found by repeating it.

namespace algae::verify::limits {

namespace {

constexpr std::size_t most_pairs = 20'000, most_kinds = 60'000;
constexpr std::size_t largest_joined =
    200;  // of the matrices whose characteristic polynomials are worked out

}  // namespace

// Graphs.

std::vector<std::vector<std::size_t>> strong_components(const Graph& graph) {
    // Tarjan's algorithm without recursion.
    constexpr std::size_t unseen = ~std::size_t{0};
    std::vector<std::size_t> number(graph.size(), unseen), low(graph.size()), stack;
    std::vector<bool> is_open(graph.size(), false);
    std::vector<std::pair<std::size_t, std::size_t>> path;  // node, and which edge comes next
    std::vector<std::vector<std::size_t>> found;
    std::size_t count = 0;
    const auto enter = [&](std::size_t node) {
        number[node] = low[node] = count++;
        stack.push_back(node);
        is_open[node] = true;
        path.emplace_back(node, 0);
    };
    for (std::size_t start = 0; start < graph.size(); ++start) {
        if (number[start] != unseen) continue;
        enter(start);
        while (!path.empty()) {
            const std::size_t node = path.back().first;
            if (path.back().second < graph[node].size()) {
                const std::size_t next = graph[node][path.back().second++];
                if (number[next] == unseen)
                    enter(next);
                else if (is_open[next])
                    low[node] = std::min(low[node], number[next]);
                continue;
            }
            path.pop_back();
            if (!path.empty()) low[path.back().first] = std::min(low[path.back().first], low[node]);
            if (low[node] != number[node]) continue;
            auto& component = found.emplace_back();
            std::size_t last;
            do {
                last = stack.back();
                stack.pop_back();
                is_open[last] = false;
                component.push_back(last);
            } while (last != node);
        }
    }
    return found;
}

namespace {

/// The matrix of the nodes of a component, those that lead equally often to the same ones joined.
IntegerMatrix joined_matrix(const Graph& graph, const std::vector<std::size_t>& nodes,
                            const Budget& budget) {
    std::map<std::size_t, std::size_t> classes;
    for (const std::size_t node : nodes) classes[node] = 0;
    for (std::size_t count = 1;;) {
        budget.check();
        std::map<std::pair<std::size_t, std::vector<std::size_t>>, std::size_t> seen;
        std::map<std::size_t, std::size_t> finer;
        for (const std::size_t node : nodes) {
            std::vector<std::size_t> next;
            for (const std::size_t to : graph[node])
                if (const auto at = classes.find(to); at != classes.end())
                    next.push_back(at->second);
            std::sort(next.begin(), next.end());
            finer[node] =
                seen.try_emplace({classes[node], std::move(next)}, seen.size()).first->second;
        }
        classes = std::move(finer);
        if (seen.size() == count) break;
        count = seen.size();
        if (count > largest_joined) too_hard("the graph of a rate stays too large");
    }
    std::size_t size = 0;
    for (const auto& [node, number] : classes) size = std::max(size, number + 1);
    IntegerMatrix matrix(size, size);
    std::vector<bool> is_done(size, false);
    for (const auto& [node, number] : classes) {
        if (is_done[number]) continue;
        is_done[number] = true;
        for (const std::size_t to : graph[node])
            if (const auto at = classes.find(to); at != classes.end())
                matrix(number, at->second) += 1;
    }
    return matrix;
}

}  // namespace

Operand rate_of_paths(const Graph& graph, const Budget& budget) {
    std::optional<Operand> best;
    for (const auto& nodes : strong_components(graph)) {
        const IntegerMatrix matrix = joined_matrix(graph, nodes, budget);
        if (matrix.is_zero()) continue;  // no cycle
        const auto rate = root_of(characteristic_polynomial(matrix));
        if (!rate) too_hard("a rate is not found");
        const Order order = best ? compared(*rate, *best) : Order::greater;
        if (order == Order::unknown) too_hard("two rates are too near to each other");
        if (order == Order::greater) best = rate;
    }
    return best ? *best
                : Operand{Integer(1), 1, {}, [](long precision) { return Ball(1, precision); }};
}

bool grows_below(
    std::size_t size, const Rational& number,
    const std::function<std::uint64_t(std::size_t, const std::vector<std::uint64_t>&)>& image,
    const Budget& budget) {
    // Of numbers that are at most so large, no product here leaves 64 bits.
    constexpr std::uint64_t one = 1 << 12, largest_weight = std::uint64_t{1} << 31;
    constexpr std::uint64_t unit = 1 << 18, largest_image = std::uint64_t{1} << 45;
    constexpr int most_rounds = 4000;
    const Integer scaled = floor(number * Rational(Integer(unit)));
    if (!(Integer(0) < scaled) || scaled > Integer(std::uint64_t{1} << 31)) return false;
    const auto below = static_cast<std::uint64_t>(scaled.to_int64());
    std::vector<std::uint64_t> weights(size, one), next(size);
    for (int round = 0; round < most_rounds; ++round) {
        bool is_shown = true;
        for (std::size_t k = 0; k < size; ++k) {
            if (k % 4096 == 0) budget.check();
            const std::uint64_t value = image(k, weights);
            if (value > largest_image) return false;
            is_shown = is_shown && value * unit < below * weights[k];
            next[k] = std::max(weights[k], one + (value * unit + below - 1) / below);
            if (next[k] > largest_weight) return false;
        }
        if (is_shown) return true;
        weights.swap(next);
    }
    return false;
}

// Parts of a component.

Parts::Parts(const Places& places, const Component& component)
    : places_(places),
      component_(component),
      inside_(component.pieces.begin(), component.pieces.end()) {}

std::vector<Seen> Parts::of(const Seen& whole) const {
    const LimitSet& set = places_.set;
    std::vector<Seen> found;
    for (const Seen& part : set.parts.at(whole.piece)) {
        if (!inside_.contains(part.piece)) continue;
        Row offset = whole.offset * set.scale;
        add(offset, set.turned(part.offset, whole.heading));
        found.push_back({part.piece, set.normal(whole.heading + part.heading), std::move(offset)});
    }
    return found;
}

bool Parts::discs_are_apart(std::size_t first, const Seen& other) {
    if (++looks_ > most_looks) too_hard("too many pairs of parts are looked at");
    if (looks_ % 1024 == 0) places_.task.budget.check();
    const LimitSet& set = places_.set;
    if (set.discs.empty()) places_.task.proof.refuse("the pieces have no discs");
    const Disc &one = set.discs.at(first), &two = set.discs.at(other.piece);
    return is_above(
        size(set.value(other.offset) + set.zeta(other.heading) * two.centre - one.centre),
        one.radius + two.radius);
}

bool Parts::are_apart(std::size_t first, const Seen& other) {
    return are_apart(first, other, deepest);
}

bool Parts::are_apart(std::size_t first, const Seen& other, int depth) {
    if (discs_are_apart(first, other)) return true;
    if (depth == 0 || set().is_same(first, other)) return false;
    const auto own = of(here(first)), others = of(other);
    for (const Seen& part : own)
        for (const Seen& another : others)
            if (!are_apart(part.piece, set().seen_from(part, another), depth - 1)) return false;
    return true;
}

bool Parts::coincide_within(std::size_t first, const Seen& other, std::uint64_t levels) {
    if (set().is_same(first, other)) return true;
    if (levels == 0) return false;
    const auto [place, is_new] = known_.try_emplace({first, other}, false, 0);
    if (place->second.first || place->second.second >= levels) return place->second.first;
    if (!is_new || !discs_are_apart(first, other)) {
        if (known_.size() > most_pairs * 50) too_hard("too many pairs of parts are looked at");
        const auto own = of(here(first)), others = of(other);
        for (const Seen& part : own)
            for (const Seen& another : others)
                if (coincide_within(part.piece, set().seen_from(part, another), levels - 1)) {
                    place->second.first = true;
                    return true;
                }
        place->second.second = levels;
    } else {
        place->second.second = ~std::uint64_t{0};
    }
    return false;
}

// Neighbours.

Neighbours::Neighbours(Parts& parts, const Places& places, const Field& list) : parts_(parts) {
    const LimitSet& set = parts.set();
    std::vector<Pair> pairs;
    for (const Field& neighbour : list.list()) {
        const auto said = neighbour.list();
        if (said.size() != 5) neighbour.fail("expected two letters, a phase, a heading and a row");
        const std::size_t first = places.piece_of(said[0], said[2]);
        Seen other{places.piece_of(said[1], said[2]), places.heading(said[3]), places.row(said[4])};
        if (!parts.contains(first) || !parts.contains(other.piece))
            neighbour.refuse("it is not of the component");
        if (set.is_same(first, other)) neighbour.refuse("the two are the same part");
        if (pairs.size() == most_pairs) too_hard("parts meet in too many ways");
        if (numbers_.emplace(Pair{first, other}, pairs.size()).second)
            pairs.emplace_back(first, std::move(other));
    }
    next_.resize(pairs.size() + 1);
    same_.assign(pairs.size() + 1, false);
    const auto visit = [&](const Seen& first, const Seen& other, std::size_t from) {
        const Seen seen = set.seen_from(first, other);
        if (set.is_same(first.piece, seen)) {
            same_[from] = coincide_ = true;
        } else if (const auto at = numbers_.find({first.piece, seen}); at != numbers_.end()) {
            next_[from].push_back(at->second);
        } else if (!parts.are_apart(first.piece, seen)) {
            list.refuse("two parts may meet that are not among them");
        }
    };
    for (const std::size_t whole : parts.component().pieces) {
        const auto own = parts.of(parts.here(whole));
        for (std::size_t i = 0; i < own.size(); ++i)
            for (std::size_t k = i + 1; k < own.size(); ++k) visit(own[i], own[k], pairs.size());
    }
    for (std::size_t k = 0; k < pairs.size(); ++k) {
        places.task.budget.check();
        const auto own = parts.of(parts.here(pairs[k].first)), others = parts.of(pairs[k].second);
        for (const Seen& one : own)
            for (const Seen& each : others) visit(one, each, k);
    }
    // Those that lead to two parts in one place.
    critical_ = same_;
    Graph before(next_.size());
    std::vector<std::size_t> open;
    for (std::size_t k = 0; k < next_.size(); ++k) {
        for (const std::size_t next : next_[k]) before[next].push_back(k);
        if (critical_[k]) open.push_back(k);
    }
    while (!open.empty()) {
        const std::size_t k = open.back();
        open.pop_back();
        for (const std::size_t b : before[k])
            if (!critical_[b]) {
                critical_[b] = true;
                open.push_back(b);
            }
    }
}

bool Neighbours::may_coincide(std::size_t first, const Seen& other) const {
    const auto is_critical = [&](const Pair& pair) {
        const auto at = numbers_.find(pair);
        return at != numbers_.end() && critical_[at->second];
    };
    if (is_critical({first, other})) return true;
    return is_critical({other.piece, parts_.set().seen_from(other, parts_.here(first))});
}

Operand Neighbours::meeting_rate(const Budget& budget) const {
    std::vector<std::size_t> number(next_.size(), next_.size()), open{next_.size() - 1};
    Graph reached(1);
    number.back() = 0;
    while (!open.empty()) {
        const std::size_t pair = open.back();
        open.pop_back();
        for (const std::size_t next : next_[pair]) {
            if (number[next] == next_.size()) {
                number[next] = reached.size();
                reached.emplace_back();
                open.push_back(next);
            }
            reached[number[pair]].push_back(number[next]);
        }
    }
    return rate_of_paths(reached, budget);
}

// Kinds of parts.

namespace {

class KindsOfParts {
public:
    KindsOfParts(const Parts& parts, const MayCoincide& may_coincide)
        : parts_(parts), may_coincide_(may_coincide) {}

    Graph graph(const Budget& budget) {
        number({parts_.component().pieces.front(), {}});
        Graph found;
        for (std::size_t k = 0; k < kinds_.size(); ++k) {
            budget.check();
            if (k % 256 == 0)
                budget.check_memory(held_ * (sizeof(Seen) + 16 * parts_.set().rank),
                                    "the kinds of parts");
            found.push_back(parts_of(*kinds_[k]));
        }
        return found;
    }

private:
    /// Another part seen from one, and whether its code is smaller.
    using Around = std::pair<Seen, bool>;
    struct Kind {
        std::size_t piece;
        std::vector<Around> others;
        bool operator<(const Kind& other) const {
            return piece != other.piece ? piece < other.piece : others < other.others;
        }
    };
    struct Owner {
        std::size_t place = 0;                    // among the parts of the part itself
        bool is_own = false, is_smaller = false;  // has some code smaller than that of the part
    };

    std::size_t number(Kind kind) {
        const std::size_t size = kind.others.size();
        const auto [place, is_new] = numbers_.try_emplace(std::move(kind), kinds_.size());
        if (is_new) {
            if (kinds_.size() == most_kinds) too_hard("there are too many kinds of parts");
            held_ += size + 4;
            kinds_.push_back(&place->first);
        }
        return place->second;
    }

    std::vector<std::size_t> parts_of(const Kind& kind) {
        std::map<Seen, Owner> all;
        const auto own = parts_.of(parts_.here(kind.piece));
        for (std::size_t k = own.size(); k-- > 0;) {
            Owner& owner = all[own[k]];
            owner.place = k;  // at last the first one
            owner.is_own = true;
        }
        for (const auto& [other, is_smaller] : kind.others)
            for (const Seen& part : parts_.of(other)) {
                Owner& owner = all[part];
                owner.is_smaller = owner.is_smaller || is_smaller;
            }
        std::vector<std::size_t> found;
        for (const auto& [part, owner] : all) {
            if (!owner.is_own || owner.is_smaller) continue;
            Kind next{part.piece, {}};
            for (const auto& [other, of_other] : all) {
                if (other == part) continue;
                Seen seen = parts_.set().seen_from(part, other);
                if (!may_coincide_(part.piece, seen)) continue;
                const bool is_smaller =
                    of_other.is_smaller || (of_other.is_own && of_other.place < owner.place);
                next.others.emplace_back(std::move(seen), is_smaller);
            }
            std::sort(next.others.begin(), next.others.end());
            found.push_back(number(std::move(next)));
        }
        return found;
    }

    const Parts& parts_;
    const MayCoincide& may_coincide_;
    std::map<Kind, std::size_t> numbers_;
    std::vector<const Kind*> kinds_;
    std::size_t held_ = 0;
};

}  // namespace

Graph kinds_of_parts(const Parts& parts, const MayCoincide& may_coincide, const Budget& budget) {
    return KindsOfParts(parts, may_coincide).graph(budget);
}

}  // namespace algae::verify::limits
