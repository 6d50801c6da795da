#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <tuple>
#include <vector>

#include "environment/environment.hpp"

namespace algae {

/// How far a point is from the straight line between two others.
///
/// Example: distance({0, 2, 0}, Vector{-1, 0, 0}, Vector{1, 0, 0}) == 2
/// Example: distance({4, 4, 0}, Vector{-1, 0, 0}, Vector{1, 0, 0}) == 5
double distance(const Vector& point, const Vector& from, const Vector& to);

/// Segments by the cells of a grid that they go through, so that those near a point are found without
/// looking at all. A cell is as wide as the radius that is asked for, or as the mean length of the
/// segments where that is more, so that n segments lie in O(n) cells. O(n log n) time.
class SegmentGrid {
public:
    /// `radius` must be above 0 and finite. Throws BoundReached if the grid takes more than
    /// budget.memory.
    SegmentGrid(std::span<const Segment> segments, double radius, const Budget& budget);

    /// Whether `is_wanted(index)` for some segment that may come within the radius of the point: for
    /// all that do, and for some that do not. One segment may be looked at several times.
    template <class IsWanted>
    bool any_near(const Vector& point, IsWanted is_wanted) const {
        const double reach = radius_ + 1e-6 * width_;  // more than what rounding can change
        const Vector out{reach, reach, reach};
        const Cell low = cell(point - out), high = cell(point + out);
        for (std::int64_t x = low.x; x <= high.x; ++x)
            for (std::int64_t y = low.y; y <= high.y; ++y) {
                // Cells that differ in z only lie together.
                auto entry =
                    std::lower_bound(entries_.begin(), entries_.end(), Entry{{x, y, low.z}, 0});
                for (; entry != entries_.end() && entry->cell <= Cell{x, y, high.z}; ++entry)
                    if (is_wanted(entry->segment)) return true;
            }
        return false;
    }

private:
    struct Cell {
        std::int64_t x, y, z;
        auto operator<=>(const Cell&) const = default;
    };
    struct Entry {
        Cell cell;
        std::size_t segment;
        auto operator<=>(const Entry&) const = default;
    };

    Cell cell(const Vector& point) const;
    void add(const Vector& from, const Vector& to, std::size_t segment);

    double radius_, width_;
    std::vector<Entry> entries_;  // sorted
};

}  // namespace algae
