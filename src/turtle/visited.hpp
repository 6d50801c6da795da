#pragma once

#include <cmath>
#include <cstdint>
#include <unordered_set>

#include "base/budget.hpp"
#include "turtle/canvas.hpp"
#include "turtle/compass.hpp"
#include "word/alphabet.hpp"

namespace algae {

/// Which parts of a derivation were drawn where: letter, steps to go, heading, and the place on a
/// grid. Forgets nothing, but stops remembering when the budget's memory is used up; then parts
/// are drawn again, which costs time and changes nothing.
class VisitedParts {
public:
    VisitedParts(double grid, const Budget& budget) : grid_(grid), most_(budget.memory / 128) {}

    /// Notes the part; false if it was noted before.
    bool insert(Symbol letter, std::uint64_t steps, Compass::Heading heading, Point place) {
        const Key key{letter, steps, heading, std::llround(place.x / grid_), std::llround(place.y / grid_)};
        if (parts_.size() >= most_) return !parts_.contains(key);
        return parts_.insert(key).second;
    }

private:
    struct Key {
        Symbol letter;
        std::uint64_t steps;
        Compass::Heading heading;
        long long x, y;
        bool operator==(const Key&) const = default;
    };
    struct Hash {
        std::size_t operator()(const Key& key) const {
            std::uint64_t hash = key.letter;
            for (const std::uint64_t part : {key.steps, static_cast<std::uint64_t>(key.heading),
                                             static_cast<std::uint64_t>(key.x), static_cast<std::uint64_t>(key.y)}) {
                hash = (hash ^ part) * 0x9E3779B97F4A7C15u;
                hash ^= hash >> 29;
            }
            return hash;
        }
    };
    double grid_;
    std::size_t most_;
    std::unordered_set<Key, Hash> parts_;
};

}  // namespace algae
