#include "oracle/obstacles.hpp"

#include <algorithm>
#include <cmath>

namespace algae::oracle {

namespace {

std::int64_t inner(const Place& a, const Place& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Place minus(const Place& a, const Place& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

}  // namespace

std::vector<Line> others(const std::vector<Line>& lines, std::size_t drawn, const Place& place) {
    std::vector<Line> out;
    std::size_t after = 0;
    for (std::size_t i = 0; i < drawn; ++i)
        if (lines[i].to == place) after = i + 1;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const bool came = i + 1 == after, goes_on = i >= after && lines[i].from == place;
        if (!came && !goes_on) out.push_back(lines[i]);
    }
    return out;
}

bool is_near(const std::vector<Line>& lines, const Place& place, std::int64_t numerator,
             std::int64_t denominator) {
    const auto within = [&](std::int64_t square,
                            std::int64_t divisor) {  // square / divisor <= radius^2
        return square * denominator * denominator <= numerator * numerator * divisor;
    };
    return std::any_of(lines.begin(), lines.end(), [&](const Line& line) {
        const Place way = minus(line.to, line.from), there = minus(place, line.from);
        const std::int64_t along = inner(way, there), square = inner(way, way);
        if (along <= 0) return within(inner(there, there), 1);
        if (along >= square) return within(inner(minus(place, line.to), minus(place, line.to)), 1);
        return within(inner(there, there) * square - along * along, square);
    });
}

double free_column(const std::vector<Line>& lines, const Place& place, std::size_t up,
                   double most) {
    for (const Line& line : lines) {
        const auto at = [&](double part, std::size_t axis) {
            return static_cast<double>(line.from[axis]) +
                   part * static_cast<double>(line.to[axis] - line.from[axis]);
        };
        const auto away = [&](double part) {
            double square = 0;
            for (std::size_t axis = 0; axis < 3; ++axis)
                if (axis != up)
                    square += std::pow(at(part, axis) - static_cast<double>(place[axis]), 2);
            return std::sqrt(square);
        };
        // The part above is an interval that begins or ends with the line.
        const auto is_above = [&](double part) {
            return at(part, up) > static_cast<double>(place[up]);
        };
        double low = 0, high = 1;
        if (!is_above(0) && !is_above(1)) continue;
        if (!is_above(0) || !is_above(1)) {
            double below = is_above(0) ? 1 : 0, above = 1 - below;
            for (int i = 0; i < 200; ++i)
                (is_above((below + above) / 2) ? above : below) = (below + above) / 2;
            (is_above(0) ? high : low) = above;
        }
        for (int i = 0; i < 200; ++i) {  // the distance is convex
            const double first = low + (high - low) / 3, second = high - (high - low) / 3;
            (away(first) < away(second) ? high : low) = away(first) < away(second) ? second : first;
        }
        most = std::min(most, away(low));
    }
    return most;
}

}  // namespace algae::oracle
