#include "dimension/recurrent_set.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "base/error.hpp"
#include "dimension/leading_factor.hpp"

namespace algae {

namespace {

using Kind = Unfolding::Item::Kind;

/// The unfolding with as few phases as part the scaling factors, and its displacement.
std::pair<Unfolding, Displacement> unfolded(const LSystem& system, const D0L& rules,
                                            const Budget& budget) {
    for (const std::size_t factor : {1u, 2u, 3u, 4u, 5u, 6u, 8u, 10u, 12u}) {
        Unfolding found = unfolding(system, rules, factor);
        try {
            Displacement displacement(found, budget);
            return {std::move(found), std::move(displacement)};
        } catch (const EqualFactors&) {
            if (factor == 12) throw;
        }
    }
    throw EqualFactors("several scaling factors are equally large");
}

/// The pieces that lead to drawing at every later level: those on or before a cycle of pieces each
/// of which leads to a letter that draws.
std::vector<bool> drawing_for_ever(const Unfolding& unfolding) {
    const std::size_t size = unfolding.size();
    const auto any_part = [&](std::size_t p, const auto& holds) {
        return std::any_of(
            unfolding.items[p].begin(), unfolding.items[p].end(),
            [&](const auto& item) { return item.kind == Kind::piece && holds(item.piece); });
    };
    std::vector<bool> leads = unfolding.draws;
    for (bool changed = true; changed;) {
        changed = false;
        for (std::size_t p = 0; p < size; ++p)
            if (!leads[p] && any_part(p, [&](std::size_t q) { return leads[q]; }))
                leads[p] = changed = true;
    }
    std::vector<bool> lasting = leads;
    for (bool changed = true; changed;) {
        changed = false;
        for (std::size_t p = 0; p < size; ++p)
            if (lasting[p] && !any_part(p, [&](std::size_t q) { return lasting[q]; })) {
                lasting[p] = false;
                changed = true;
            }
    }
    return lasting;
}

/// A disc around discs: the one around the middle of their box.
RecurrentSet::Disc around(const std::vector<RecurrentSet::Disc>& discs) {
    double left = INFINITY, right = -INFINITY, low = INFINITY, high = -INFINITY;
    for (const auto& [centre, radius] : discs) {
        left = std::min(left, centre.real() - radius);
        right = std::max(right, centre.real() + radius);
        low = std::min(low, centre.imag() - radius);
        high = std::max(high, centre.imag() + radius);
    }
    RecurrentSet::Disc found{{(left + right) / 2, (low + high) / 2}, 0};
    for (const auto& [centre, radius] : discs)
        found.radius = std::max(found.radius, std::abs(centre - found.centre) + radius);
    return found;
}

}  // namespace

RecurrentSet::RecurrentSet(const LSystem& system, const D0L& rules, const Budget& budget)
    : RecurrentSet(unfolded(system, rules, budget), budget) {}

RecurrentSet::RecurrentSet(std::pair<Unfolding, Displacement> parts, const Budget& budget)
    : unfolding_(std::move(parts.first)), displacement_(std::move(parts.second)) {
    const std::vector<bool> lasting = drawing_for_ever(unfolding_);
    for (std::size_t p = 0; p < unfolding_.size(); ++p)
        parts_.push_back(lasting[p] ? walked(unfolding_.items[p], lasting) : std::vector<Part>());
    axiom_ = walked(unfolding_.axiom, lasting);
    if (axiom_.empty()) throw Error("nothing is drawn in late generations");

    GrowthMatrix matrix;
    for (const auto& own : parts_) {
        std::vector<Integer> counts(parts_.size());
        for (const Part& part : own) counts[part.piece] += 1;
        auto& row = matrix.rows.emplace_back();
        for (std::size_t q = 0; q < counts.size(); ++q)
            if (!counts[q].is_zero()) row.push_back({q, counts[q]});
    }
    components_ = algae::components(matrix, budget);
    find_reached();
    find_discs();
}

/// The parts among items that last, with their offsets.
std::vector<RecurrentSet::Part> RecurrentSet::walked(const std::vector<Unfolding::Item>& items,
                                                     const std::vector<bool>& lasting) const {
    std::vector<Part> found;
    std::vector<Displacement::Vector> saved;
    Displacement::Vector here = displacement_.zero();
    for (const Unfolding::Item& item : items) {
        if (item.kind == Kind::push) {
            saved.push_back(here);
        } else if (item.kind == Kind::pop) {
            here = std::move(saved.back());
            saved.pop_back();
        } else {
            if (lasting[item.piece]) found.push_back({item.piece, item.heading, here});
            displacement_.add(here,
                              displacement_.turned(displacement_.way(item.piece), item.heading));
        }
    }
    return found;
}

void RecurrentSet::find_reached() {
    reached_.assign(size(), false);
    std::vector<std::size_t> open;
    const auto visit = [&](std::size_t p) {
        if (reached_[p]) return;
        reached_[p] = true;
        open.push_back(p);
    };
    for (const Part& part : axiom_) visit(part.piece);
    while (!open.empty()) {
        const std::size_t p = open.back();
        open.pop_back();
        for (const Part& part : parts_[p]) visit(part.piece);
    }
}

/// From discs around the beginnings that are large enough, towards smaller ones: a disc around the
/// discs of a piece's parts holds the piece if theirs hold them.
void RecurrentSet::find_discs() {
    const double ratio = displacement_.ratio();
    double farthest = 0;
    for (const auto& own : parts_)
        for (const Part& part : own)
            farthest = std::max(farthest, std::abs(displacement_.value(part.offset)));
    discs_.assign(size(), {0, farthest / (ratio - 1) * (1 + 1e-9) + 1e-12});
    constexpr int rounds = 60;
    for (int round = 0; round < rounds; ++round) {
        std::vector<Disc> next = discs_;
        for (std::size_t p = 0; p < size(); ++p) {
            std::vector<Disc> discs;
            for (const Part& part : parts_[p]) {
                const std::complex<double> turn =
                    std::polar(1.0, 2 * std::numbers::pi * static_cast<double>(part.heading) /
                                        static_cast<double>(order()));
                discs.push_back(
                    {(turn * discs_[part.piece].centre + displacement_.value(part.offset)) /
                         displacement_.factor(),
                     discs_[part.piece].radius / ratio});
            }
            if (discs.empty()) continue;
            const Disc tighter = around(discs);
            if (tighter.radius < discs_[p].radius) next[p] = tighter;
        }
        discs_ = std::move(next);
    }
    for (Disc& disc : discs_) disc.radius = disc.radius * (1 + 1e-9) + 1e-9;
}

}  // namespace algae
