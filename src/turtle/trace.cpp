#include "turtle/trace.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_map>
#include <vector>

namespace algae {

namespace {

/// Gives points numbers, equal ones to points that lie together.
class Points {
public:
    explicit Points(double grid) : grid_(grid) {}

    std::uint32_t number(Point point) {
        // A point close to the edge of a cell may have been seen on the other side of it.
        const long long x = std::llround(point.x / grid_), y = std::llround(point.y / grid_);
        for (long long dx = -1; dx <= 1; ++dx)
            for (long long dy = -1; dy <= 1; ++dy)
                if (const auto seen = numbers_.find(key(x + dx, y + dy)); seen != numbers_.end())
                    return seen->second;
        const auto fresh = static_cast<std::uint32_t>(numbers_.size());
        numbers_.emplace(key(x, y), fresh);
        return fresh;
    }
    std::size_t size() const { return numbers_.size(); }

private:
    using Key = std::array<long long, 2>;
    struct Hash {
        std::size_t operator()(const Key& key) const {
            std::uint64_t hash = static_cast<std::uint64_t>(key[0]) * 0x9E3779B97F4A7C15u;
            hash ^= hash >> 31;
            return (hash + static_cast<std::uint64_t>(key[1])) * 0xBF58476D1CE4E5B9u;
        }
    };
    static Key key(long long x, long long y) { return {x, y}; }
    double grid_;
    std::unordered_map<Key, std::uint32_t, Hash> numbers_;
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
            budget_.check_memory(segments_.size() * sizeof(std::uint64_t) + points_.size() * 64, "the segments");
    }
    void polygon(std::span<const Point>) override {}
    void width(double) override {}
    void width_as_length(double) override {}
    void colour(std::uint32_t) override {}
    void position(double) override {}

    Trace result() {
        std::sort(segments_.begin(), segments_.end());
        const auto last = std::unique(segments_.begin(), segments_.end());
        std::vector<std::uint32_t> ends;
        for (auto it = segments_.begin(); it != last; ++it) {
            ends.push_back(static_cast<std::uint32_t>(*it));
            ends.push_back(static_cast<std::uint32_t>(*it >> 32));
        }
        std::sort(ends.begin(), ends.end());
        const auto vertices = std::unique(ends.begin(), ends.end()) - ends.begin();
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
