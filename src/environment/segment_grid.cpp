#include "environment/segment_grid.hpp"

#include <cmath>

namespace algae {

namespace {

/// The whole part, as far as numbers of cells go.
std::int64_t whole(double value) {
    constexpr double most = 1e15;
    if (!(value > -most)) return -static_cast<std::int64_t>(most);
    return value < most ? static_cast<std::int64_t>(std::floor(value))
                        : static_cast<std::int64_t>(most);
}

}  // namespace

double distance(const Vector& point, const Vector& from, const Vector& to) {
    const Vector way = to - from, there = point - from;
    const double square = dot(way, way);
    const double part = square > 0 ? std::clamp(dot(there, way) / square, 0.0, 1.0) : 0;
    return length(there - part * way);
}

SegmentGrid::SegmentGrid(std::span<const Segment> segments, double radius, const Budget& budget)
    : radius_(radius), width_(radius) {
    double all = 0;
    for (const Segment& segment : segments) all += length(segment.to - segment.from);
    if (!segments.empty()) width_ = std::max(radius, all / static_cast<double>(segments.size()));
    entries_.reserve(2 * segments.size());
    for (std::size_t i = 0; i < segments.size(); ++i) {
        if (i % 4096 == 0) budget.check();
        // In pieces as long as a cell is wide, which lie in 8 cells at most.
        const auto& [from, to, module] = segments[i];
        const auto pieces = static_cast<double>(1 + whole(length(to - from) / width_));
        Vector begin = from;
        for (double k = 1; k <= pieces; ++k) {
            const Vector end = k == pieces ? to : from + (k / pieces) * (to - from);
            add(begin, end, i);
            begin = end;
        }
        budget.check_memory(entries_.capacity() * sizeof(Entry), "the grid of an environment");
    }
    std::sort(entries_.begin(), entries_.end());
    entries_.erase(std::unique(entries_.begin(), entries_.end()), entries_.end());
}

SegmentGrid::Cell SegmentGrid::cell(const Vector& point) const {
    return {whole(point.x / width_), whole(point.y / width_), whole(point.z / width_)};
}

void SegmentGrid::add(const Vector& from, const Vector& to, std::size_t segment) {
    const Cell a = cell(from), b = cell(to);
    for (std::int64_t x = std::min(a.x, b.x); x <= std::max(a.x, b.x); ++x)
        for (std::int64_t y = std::min(a.y, b.y); y <= std::max(a.y, b.y); ++y)
            for (std::int64_t z = std::min(a.z, b.z); z <= std::max(a.z, b.z); ++z)
                entries_.push_back({{x, y, z}, segment});
}

}  // namespace algae
