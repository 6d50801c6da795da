#include "dimension/neighbours.hpp"

#include <cmath>
#include <numbers>

#include "base/error.hpp"

namespace algae {

namespace {

bool is_zero(const Displacement::Vector& vector) {
    for (const std::int64_t x : vector)
        if (x != 0) return false;
    return true;
}

/// Whether the discs of a piece and one placed so come together.
bool may_meet(const RecurrentSet& set, std::size_t piece, const Placement& other) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(other.heading) /
                         static_cast<double>(set.order());
    const auto& first = set.disc(piece);
    const auto& second = set.disc(other.piece);
    const std::complex<double> centre =
        set.displacement().value(other.offset) + std::polar(1.0, angle) * second.centre;
    return std::abs(centre - first.centre) <= first.radius + second.radius + 1e-6;
}

}  // namespace

Placement placed(const RecurrentSet& set, const Placement& whole, const RecurrentSet::Part& part) {
    Placement found{part.piece, normal_heading(whole.heading + part.heading, set.order()),
                    set.displacement().scaled(whole.offset)};
    set.displacement().add(found.offset, set.displacement().turned(part.offset, whole.heading));
    return found;
}

Placement seen_from(const RecurrentSet& set, const Placement& first, const Placement& other) {
    Displacement::Vector offset = other.offset;
    set.displacement().subtract(offset, first.offset);
    return {other.piece, normal_heading(other.heading - first.heading, set.order()),
            set.displacement().turned(offset, -first.heading)};
}

std::vector<RecurrentSet::Part> parts_within(const RecurrentSet& set, std::size_t piece) {
    const auto& component_of = set.components().of_letter;
    std::vector<RecurrentSet::Part> found;
    for (const RecurrentSet::Part& part : set.parts(piece))
        if (component_of[part.piece] == component_of[piece]) found.push_back(part);
    return found;
}

std::size_t Neighbours::Hash::operator()(const std::pair<std::size_t, Placement>& key) const {
    std::uint64_t hash = key.first * 0x9E3779B97F4A7C15u + key.second.piece;
    const auto mix = [&](std::uint64_t value) {
        hash = (hash ^ value) * 0xBF58476D1CE4E5B9u;
        hash ^= hash >> 29;
    };
    mix(static_cast<std::uint64_t>(key.second.heading));
    for (const std::int64_t x : key.second.offset) mix(static_cast<std::uint64_t>(x));
    return hash;
}

Neighbours::Neighbours(const RecurrentSet& set, std::size_t component, const Budget& budget,
                       std::size_t most) {
    const auto number = [&](std::size_t piece, Placement other) {
        const auto [place, is_new] = numbers_.try_emplace({piece, std::move(other)}, pairs_.size());
        if (is_new) {
            if (pairs_.size() == most)
                throw BoundReached(Bound::method, "more than " + std::to_string(most) +
                                                      " ways in which two parts may meet");
            pairs_.push_back({piece, place->first.second, {}});
            if (pairs_.size() % 1024 == 0)
                budget.check_memory(pairs_.size() * (200 + 16 * set.displacement().rank()),
                                    "the pairs of parts that meet");
        }
        return place->second;
    };
    const auto pair_of = [&](const Placement& first, const Placement& second,
                             std::vector<std::size_t>& into) {
        const Placement other = seen_from(set, first, second);
        if (may_meet(set, first.piece, other)) into.push_back(number(first.piece, other));
    };
    std::vector<std::vector<RecurrentSet::Part>> parts(set.size());
    for (const std::size_t piece : set.components().list[component].letters)
        parts[piece] = parts_within(set, piece);

    const Placement here{0, 0, set.displacement().zero()};
    const auto placed_parts = [&](Placement whole) {
        std::vector<Placement> found;
        for (const RecurrentSet::Part& part : parts[whole.piece])
            found.push_back(placed(set, whole, part));
        return found;
    };
    for (const std::size_t piece : set.components().list[component].letters) {
        const auto own = placed_parts({piece, 0, here.offset});
        for (std::size_t i = 0; i < own.size(); ++i)
            for (std::size_t j = i + 1; j < own.size(); ++j) pair_of(own[i], own[j], starts_);
    }
    for (std::size_t k = 0; k < pairs_.size(); ++k) {
        if (k % 256 == 0) budget.check();
        const std::size_t piece = pairs_[k].piece;
        const Placement other = pairs_[k].other;
        // A pair of one piece with itself says all there is to say.
        if (piece == other.piece && other.heading == 0 && is_zero(other.offset)) {
            coincide_ = true;
            pairs_[k].next = {k};
            continue;
        }
        std::vector<std::size_t> next;
        const auto first = placed_parts({piece, 0, here.offset});
        const auto second = placed_parts(other);
        for (const Placement& x : first)
            for (const Placement& y : second) pair_of(x, y, next);
        pairs_[k].next = std::move(next);
    }
    leave_out_dead_ends();
    find_critical();
}

void Neighbours::leave_out_dead_ends() {
    std::vector<std::vector<std::size_t>> before(pairs_.size());
    std::vector<std::size_t> left(pairs_.size(), 0), dead;
    for (std::size_t k = 0; k < pairs_.size(); ++k) {
        left[k] = pairs_[k].next.size();
        for (const std::size_t next : pairs_[k].next) before[next].push_back(k);
        if (left[k] == 0) dead.push_back(k);
    }
    for (std::size_t i = 0; i < dead.size(); ++i)
        for (const std::size_t k : before[dead[i]])
            if (--left[k] == 0) dead.push_back(k);
    std::vector<std::size_t> renumbered(pairs_.size());
    std::vector<Pair> alive;
    for (std::size_t k = 0; k < pairs_.size(); ++k) {
        renumbered[k] = alive.size();
        if (left[k] > 0) alive.push_back(std::move(pairs_[k]));
    }
    const auto renumber = [&](std::vector<std::size_t>& numbers) {
        std::vector<std::size_t> kept;
        for (const std::size_t k : numbers)
            if (left[k] > 0) kept.push_back(renumbered[k]);
        numbers = std::move(kept);
    };
    for (Pair& pair : alive) renumber(pair.next);
    renumber(starts_);
    std::erase_if(numbers_, [&](const auto& entry) { return left[entry.second] == 0; });
    for (auto& [key, value] : numbers_) value = renumbered[value];
    pairs_ = std::move(alive);
}

void Neighbours::find_critical() {
    critical_.assign(pairs_.size(), false);
    if (!coincide_) return;
    std::vector<std::vector<std::size_t>> before(pairs_.size());
    std::vector<std::size_t> open;
    for (std::size_t k = 0; k < pairs_.size(); ++k) {
        for (const std::size_t next : pairs_[k].next) before[next].push_back(k);
        const Placement& other = pairs_[k].other;
        if (pairs_[k].piece == other.piece && other.heading == 0 && is_zero(other.offset)) {
            critical_[k] = true;
            open.push_back(k);
        }
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

std::optional<std::size_t> Neighbours::find(std::size_t piece, const Placement& other) const {
    const auto place = numbers_.find({piece, other});
    if (place == numbers_.end()) return std::nullopt;
    return place->second;
}

GrowthMatrix Neighbours::matrix() const {
    GrowthMatrix out;
    for (const Pair& pair : pairs_) {
        std::map<std::size_t, Integer> counts;
        for (const std::size_t next : pair.next) counts[next] += 1;
        auto& row = out.rows.emplace_back();
        for (const auto& [column, times] : counts) row.push_back({column, times});
    }
    return out;
}

std::vector<Integer> Neighbours::starts() const {
    std::vector<Integer> out(pairs_.size());
    for (const std::size_t k : starts_) out[k] += 1;
    return out;
}

}  // namespace algae
