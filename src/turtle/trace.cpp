#include "turtle/trace.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace algae {

namespace {

/// Gives points numbers, equal ones to points that lie together.
class Points {
public:
    explicit Points(double grid) : grid_(grid), slots_(1024, none) {}

    std::uint32_t number(Point point) {
        const Place x = place(point.x), y = place(point.y);
        for (int dx = x.before; dx <= x.behind; ++dx)
            for (int dy = y.before; dy <= y.behind; ++dy) {
                const std::uint32_t seen = slots_[slot({x.cell + dx, y.cell + dy})];
                if (seen != none) return seen;
            }
        const auto fresh = static_cast<std::uint32_t>(cells_.size());
        cells_.push_back({x.cell, y.cell});
        slots_[slot(cells_.back())] = fresh;
        if (2 * cells_.size() > slots_.size()) grow();
        return fresh;
    }
    std::size_t size() const { return cells_.size(); }
    std::size_t bytes() const {
        return slots_.size() * sizeof(std::uint32_t) + cells_.capacity() * sizeof(Cell);
    }

private:
    using Cell = std::array<long long, 2>;
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
        std::uint64_t hash = static_cast<std::uint64_t>(cell[0]) * 0x9E3779B97F4A7C15u;
        hash ^= hash >> 31;
        hash = (hash + static_cast<std::uint64_t>(cell[1])) * 0xBF58476D1CE4E5B9u;
        hash ^= hash >> 29;
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

class Tracer : public Canvas {
public:
    Tracer(double grid, const Budget& budget) : points_(grid), budget_(budget) {}

    void move_to(Point point) override { from_ = points_.number(point); }
    void line_to(Point point) override {
        const std::uint32_t to = points_.number(point);
        const auto [low, high] = std::minmax(from_, to);
        segments_.push_back(std::uint64_t{high} << 32 | low);
        from_ = to;
        if (segments_.size() % 65536 == 0)
            budget_.check_memory(segments_.capacity() * sizeof(std::uint64_t) + points_.bytes(), "the segments");
    }
    void polygon(std::span<const Point>) override {}
    void width(double) override {}
    void width_as_length(double) override {}
    void colour(std::uint32_t) override {}
    void position(double) override {}

    Trace result() {
        // Those of a curve that never crosses itself come in order.
        if (!std::is_sorted(segments_.begin(), segments_.end()))
            std::sort(segments_.begin(), segments_.end());
        const auto last = std::unique(segments_.begin(), segments_.end());
        std::vector<char> is_end(points_.size());
        for (auto it = segments_.begin(); it != last; ++it)
            is_end[*it & 0xFFFFFFFF] = is_end[*it >> 32] = 1;
        const auto vertices = std::count(is_end.begin(), is_end.end(), 1);
        return {static_cast<std::uint64_t>(last - segments_.begin()), static_cast<std::uint64_t>(vertices)};
    }

private:
    Points points_;
    const Budget& budget_;
    std::vector<std::uint64_t> segments_;
    std::uint32_t from_ = 0;
};

}  // namespace

Trace trace(const Figure& figure, const Budget& budget) {
    Tracer tracer(figure.facts().step * 1e-6, budget);
    figure.draw(tracer, 0, budget);
    return tracer.result();
}

}  // namespace algae
