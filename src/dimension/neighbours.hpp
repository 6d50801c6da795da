#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

#include "base/budget.hpp"
#include "dimension/recurrent_set.hpp"
#include "growth/growth_matrix.hpp"

namespace algae {

/// How a piece lies to another one of the same level, seen from the latter: turned and moved, both
/// exactly.
struct Placement {
    std::size_t piece = 0;
    std::int64_t heading = 0;
    Displacement::Vector offset;

    bool operator==(const Placement&) const = default;
    bool operator<(const Placement& other) const {
        if (piece != other.piece) return piece < other.piece;
        if (heading != other.heading) return heading < other.heading;
        return offset < other.offset;
    }
};

/// The neighbours of pieces within one component of a recurrent set: all ways in which two pieces of
/// one level, different ones or the same one reached twice, can lie to each other so that they meet
/// (Bandt and Graf 1992; Strichartz and Wang 1999). Two pieces meet exactly if there is an infinite
/// path from their pair, as pairs that lie too far apart are left out.
///
/// If there are finitely many, the set has finite type: where no two parts coincide, at most as
/// many pieces meet in one place as there are pairs, and so the dimension of the component is
/// log rate / log |mu|, exactly.
class Neighbours {
public:
    struct Pair {
        std::size_t piece;  // looks along +x from 0
        Placement other;
        std::vector<std::size_t> next;  // pairs of their parts
    };

    /// Throws BoundReached where there are more than `most` pairs, or the budget does not suffice:
    /// then it is not known whether they are finitely many.
    Neighbours(const RecurrentSet& set, std::size_t component, const Budget& budget = {},
               std::size_t most = 50'000);

    /// Pairs that meet; that of a piece with itself stands among them only if two parts coincide.
    const std::vector<Pair>& pairs() const { return pairs_; }
    /// Whether some part is reached in two ways: the open set condition fails.
    bool parts_coincide() const { return coincide_; }
    /// By pair, whether it leads to a coincidence.
    const std::vector<bool>& leads_to_coincidence() const { return critical_; }
    /// The pair of a piece with one placed so, if they meet.
    std::optional<std::size_t> find(std::size_t piece, const Placement& other) const;
    /// How many pairs of different parts meet within so many levels of each piece: their growth is
    /// that of the boundary between parts. Rows are pairs.
    GrowthMatrix matrix() const;
    /// How often each pair lies directly within a piece of the component.
    std::vector<Integer> starts() const;

private:
    struct Hash {
        std::size_t operator()(const std::pair<std::size_t, Placement>& key) const;
    };
    void leave_out_dead_ends();
    void find_critical();

    std::vector<Pair> pairs_;
    std::vector<std::size_t> starts_;
    std::unordered_map<std::pair<std::size_t, Placement>, std::size_t, Hash> numbers_;
    std::vector<bool> critical_;
    bool coincide_ = false;
};

/// A part of a piece within a component, as it lies where the piece itself lies so: in the units of
/// the level below.
Placement placed(const RecurrentSet& set, const Placement& whole, const RecurrentSet::Part& part);

/// How `other` lies to `first`, seen from it.
Placement seen_from(const RecurrentSet& set, const Placement& first, const Placement& other);

/// The part of a piece that lie in its own component.
std::vector<RecurrentSet::Part> parts_within(const RecurrentSet& set, std::size_t piece);

}  // namespace algae
