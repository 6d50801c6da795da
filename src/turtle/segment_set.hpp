#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/budget.hpp"
#include "turtle/pose.hpp"
#include "turtle/trace.hpp"

namespace algae {

/// Gives points numbers, equal ones to points that lie together.
class NumberedPoints {
public:
    explicit NumberedPoints(double grid) : grid_(grid), slots_(1024, none) {}

    std::uint32_t number(const Vector& point) {
        const Place x = place(point.x), y = place(point.y), z = place(point.z);
        for (int dx = x.before; dx <= x.behind; ++dx)
            for (int dy = y.before; dy <= y.behind; ++dy)
                for (int dz = z.before; dz <= z.behind; ++dz) {
                    const std::uint32_t seen =
                        slots_[slot({x.cell + dx, y.cell + dy, z.cell + dz})];
                    if (seen != none) return seen;
                }
        const auto fresh = static_cast<std::uint32_t>(cells_.size());
        cells_.push_back({x.cell, y.cell, z.cell});
        slots_[slot(cells_.back())] = fresh;
        if (2 * cells_.size() > slots_.size()) grow();
        return fresh;
    }
    std::size_t size() const { return cells_.size(); }
    std::size_t bytes() const {
        return slots_.size() * sizeof(std::uint32_t) + cells_.capacity() * sizeof(Cell);
    }

private:
    using Cell = std::array<long long, 3>;
    static constexpr std::uint32_t none = ~std::uint32_t{0};

    /// A coordinate's cell, and the cells beside it that are near.
    struct Place {
        long long cell;
        int before, behind;
    };
    Place place(double coordinate) const {
        // A point close to the edge of its cell may have been seen on the other side of it.
        constexpr double edge = 0.25;
        const double exactly = coordinate / grid_;
        const double cell = std::floor(exactly + 0.5);
        const double off = exactly - cell;
        return {static_cast<long long>(cell), off < -edge ? -1 : 0, off > edge ? 1 : 0};
    }
    /// Where the cell is, or would be.
    std::size_t slot(const Cell& cell) const {
        std::uint64_t hash = 0;
        for (const long long part : cell) {
            hash = (hash + static_cast<std::uint64_t>(part)) * 0x9E3779B97F4A7C15u;
            hash ^= hash >> 31;
        }
        std::size_t at = hash & (slots_.size() - 1);
        while (slots_[at] != none && cells_[slots_[at]] != cell)
            at = (at + 1) & (slots_.size() - 1);
        return at;
    }
    void grow() {
        slots_.assign(2 * slots_.size(), none);
        for (std::size_t i = 0; i < cells_.size(); ++i)
            slots_[slot(cells_[i])] = static_cast<std::uint32_t>(i);
    }

    double grid_;
    std::vector<std::uint32_t> slots_;  // numbers of points, at most half of them taken
    std::vector<Cell> cells_;           // by number
};

/// Different segments between points that lie on a fine grid.
class SegmentSet {
public:
    /// Points are the same when they round to the same point of a grid as fine as `grid`. The budget
    /// bounds the memory of all segments.
    SegmentSet(double grid, const Budget& budget) : points_(grid), budget_(budget) {}

    std::uint32_t number(const Vector& point) { return points_.number(point); }
    /// Between the points with these numbers. Throws BoundReached past budget.memory.
    void add(std::uint32_t from, std::uint32_t to);
    /// How many there are, once all are added.
    Trace result();

private:
    NumberedPoints points_;
    const Budget& budget_;
    std::vector<std::uint64_t> segments_;
};

}  // namespace algae
