#include "oracle/touched_cells.hpp"

#include <algorithm>
#include <optional>

namespace algae::oracle {

namespace {

/// An interval of the line, each end in or out.
struct Interval {
    Rational low, high;
    bool has_low = true, has_high = true;

    void meet(const Interval& other) {
        if (other.low > low || (other.low == low && !other.has_low)) {
            low = other.low;
            has_low = other.has_low;
        }
        if (other.high < high || (other.high == high && !other.has_high)) {
            high = other.high;
            has_high = other.has_high;
        }
    }
    bool is_empty() const { return low > high || (low == high && !(has_low && has_high)); }
};

/// Where from + t * way lies in [low, low + width); nothing if nowhere, all of 0 to 1 if everywhere.
std::optional<Interval> inside(const Rational& from, const Rational& way, const Rational& low,
                               const Rational& width) {
    const Rational high = low + width;
    if (way.is_zero()) {
        if (from >= low && from < high) return Interval{Rational(0), Rational(1)};
        return std::nullopt;
    }
    const Rational at_low = (low - from) / way, at_high = (high - from) / way;
    if (way > Rational(0)) return Interval{at_low, at_high, true, false};
    return Interval{at_high, at_low, false, true};
}

long floor_of(const Rational& value) { return static_cast<long>(floor(value).to_int64()); }

}  // namespace

bool touches(const ExactSegment& segment, const Rational& left, const Rational& low,
             const Rational& width) {
    const auto& [from, to] = segment;
    const auto sideways = inside(from.first, to.first - from.first, left, width);
    const auto upright = inside(from.second, to.second - from.second, low, width);
    if (!sideways || !upright) return false;
    Interval part{Rational(0), Rational(1)};
    part.meet(*sideways);
    part.meet(*upright);
    return !part.is_empty();
}

std::set<Cell> touched_cells(const std::vector<ExactSegment>& segments, const Rational& width) {
    std::set<Cell> cells;
    for (const ExactSegment& segment : segments) {
        const auto& [from, to] = segment;
        const auto [left, right] =
            std::minmax({floor_of(from.first / width), floor_of(to.first / width)});
        const auto [low, high] =
            std::minmax({floor_of(from.second / width), floor_of(to.second / width)});
        for (long column = left - 1; column <= right + 1; ++column)
            for (long row = low - 1; row <= high + 1; ++row)
                if (touches(segment, Rational(column) * width, Rational(row) * width, width))
                    cells.emplace(column, row);
    }
    return cells;
}

Rational rounded(double coordinate, double origin, double cell) {
    const Rational parts(1L << 20);
    const double scaled = (coordinate - origin) * (0x1p20 / cell) + 0.5;
    return Rational(Integer(static_cast<long>(scaled)), Integer(1)) / parts;
}

std::vector<ExactSegment> seen_segments(const std::vector<std::pair<Point, Point>>& segments,
                                        Point origin, double cell) {
    const auto at = [&](Point point) {
        return ExactPoint{rounded(point.x, origin.x, cell), rounded(point.y, origin.y, cell)};
    };
    std::vector<ExactSegment> seen;
    for (const auto& [from, to] : segments) seen.emplace_back(at(from), at(to));
    return seen;
}

}  // namespace algae::oracle
