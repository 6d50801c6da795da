#include "turtle/detail/mesh.hpp"

#include <algorithm>
#include <cmath>

// Triangulation of one polygon, concave or not, plane or not.
//
// The polygon is projected along the axis that its Newell normal is nearest to, which keeps its winding.
// Then ears are cut off one by one (Meisters, Polygons have ears, 1975): a convex corner whose triangle
// holds no other corner. Only reflex corners can lie in an ear, and a corner that has become convex stays
// so, so that a grid over the reflex corners, which forgets on the way, finds them: about O(corners) for
// curves that fill their box evenly. Where sides cross or rounding leaves no ear, a convex corner is cut
// all the same, and where there is none, any: the triangles cover what they can, and none is degenerate.

namespace algae {

namespace {

/// Twice the area of a triangle, positive counter-clockwise.
double turn(Point a, Point b, Point c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Corners that may lie in an ear, found by where they are.
class Grid {
public:
    Grid(const std::vector<Point>& points, const std::vector<std::uint32_t>& members) {
        for (const Point& p : points) box_.add(p);
        members_ = members.size();
        side_ = std::max(1u, static_cast<unsigned>(std::sqrt(static_cast<double>(members.size()))));
        cells_.resize(std::size_t{side_} * side_);
        for (const std::uint32_t i : members)
            cells_[column(points[i].x) + std::size_t{side_} * row(points[i].y)].push_back(i);
    }
    /// Whether `found` is true for some member in the box around three points. Members for which
    /// `gone` is true are forgotten on the way.
    template <class Gone, class Found>
    bool any(Point a, Point b, Point c, const Gone& gone, const Found& found) {
        if (members_ == 0) return false;
        const auto [left, right] = std::minmax({a.x, b.x, c.x});
        const auto [bottom, top] = std::minmax({a.y, b.y, c.y});
        for (unsigned y = row(bottom); y <= row(top); ++y)
            for (unsigned x = column(left); x <= column(right); ++x) {
                std::vector<std::uint32_t>& cell = cells_[x + std::size_t{side_} * y];
                members_ -= std::erase_if(cell, gone);
                if (std::any_of(cell.begin(), cell.end(), found)) return true;
            }
        return false;
    }

private:
    unsigned cell(double offset, double extent) const {
        if (!(extent > 0)) return 0;
        return std::min(side_ - 1, static_cast<unsigned>(std::max(0.0, offset / extent * side_)));
    }
    unsigned column(double x) const { return cell(x - box_.low.x, box_.breadth()); }
    unsigned row(double y) const { return cell(y - box_.low.y, box_.height()); }

    Box box_;
    unsigned side_ = 1;
    std::size_t members_ = 0;
    std::vector<std::vector<std::uint32_t>> cells_;
};

/// What is left of a polygon while ears are cut off.
class Ears {
public:
    Ears(const std::vector<Point>& points, double farthest)
        : points_(points),
          farthest_(farthest),
          before_(points.size()),
          after_(points.size()),
          grid_(points, reflex(points)) {
        for (std::uint32_t i = 0; i < points.size(); ++i) {
            before_[i] = i ? i - 1 : static_cast<std::uint32_t>(points.size() - 1);
            after_[i] = i + 1 < points.size() ? i + 1 : 0;
        }
    }
    std::vector<std::array<std::uint32_t, 3>> cut(const Budget& budget) {
        std::vector<std::array<std::uint32_t, 3>> triangles;
        std::uint32_t at = 0;
        std::size_t left = points_.size(), tried = 0;
        for (std::size_t steps = 0; left > 2; ++steps) {
            if (steps % 4096 == 0) budget.check();
            const bool convex = is_convex(at);
            const bool forced = tried > left;  // sides cross, or rounding: there is no ear
            if (convex && (forced || is_empty(at))) {
                triangles.push_back({before_[at], at, after_[at]});
            } else if (!(tried > 2 * left)) {
                ++tried;
                at = after_[at];
                continue;
            }
            const std::uint32_t next = after_[at];
            after_[before_[at]] = next;
            before_[next] = before_[at];
            after_[at] = at;  // gone
            at = after_[next];
            --left;
            tried = 0;
        }
        return triangles;
    }

private:
    static std::vector<std::uint32_t> reflex(const std::vector<Point>& points) {
        // Only these can lie in an ear of a polygon whose sides do not cross.
        std::vector<std::uint32_t> found;
        for (std::uint32_t i = 0, n = static_cast<std::uint32_t>(points.size()); i < n; ++i)
            if (turn(points[(i + n - 1) % n], points[i], points[(i + 1) % n]) <= 0)
                found.push_back(i);
        return found;
    }
    /// Whether it is by more than rounding: what lies on a straight side is not.
    bool is_convex(std::uint32_t i) const {
        const Point a = points_[before_[i]], b = points_[i], c = points_[after_[i]];
        const double sides = std::fabs(b.x - a.x) + std::fabs(b.y - a.y) + std::fabs(c.x - a.x) +
                             std::fabs(c.y - a.y);
        return turn(a, b, c) > 1e-15 * farthest_ * sides;
    }
    double area(std::uint32_t i) const {
        return turn(points_[before_[i]], points_[i], points_[after_[i]]);
    }
    bool is_empty(std::uint32_t i) {
        const Point a = points_[before_[i]], b = points_[i], c = points_[after_[i]];
        // A corner that has become convex stays so while others are cut off.
        const auto harmless = [&](std::uint32_t other) {
            return after_[other] == other || area(other) > 0;
        };
        return !grid_.any(a, b, c, harmless, [&](std::uint32_t other) {
            const Point p = points_[other];
            if (p == a || p == b || p == c) return false;
            return turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0;
        });
    }

    const std::vector<Point>& points_;
    double farthest_;
    std::vector<std::uint32_t> before_, after_;
    Grid grid_;
};

/// The corners seen against a normal, along the axis that it is nearest to.
std::vector<Point> projected(std::span<const Vector> corners, const Vector& normal) {
    const double x = std::fabs(normal.x), y = std::fabs(normal.y), z = std::fabs(normal.z);
    std::vector<Point> points;
    points.reserve(corners.size());
    for (const Vector& c : corners) {
        if (z >= x && z >= y)
            points.push_back(normal.z > 0 ? Point{c.x, c.y} : Point{c.y, c.x});
        else if (x >= y)
            points.push_back(normal.x > 0 ? Point{c.y, c.z} : Point{c.z, c.y});
        else
            points.push_back(normal.y > 0 ? Point{c.z, c.x} : Point{c.x, c.z});
    }
    return points;
}

}  // namespace

Vector twice_area(std::span<const Vector> corners) {
    Vector sum;
    for (std::size_t i = 2; i < corners.size(); ++i)
        sum = sum + cross(corners[i - 1] - corners[0], corners[i] - corners[0]);
    return sum;
}

std::vector<std::array<std::uint32_t, 3>> polygon_triangles(std::span<const Vector> corners,
                                                            const Budget& budget) {
    if (corners.size() < 3) return {};
    Vector normal = twice_area(corners);
    double reach = 0, farthest = 0, largest = 0;
    for (const Vector& c : corners) {
        reach = std::max(reach, length(c - corners[0]));
        farthest = std::max(farthest, length(c));
    }
    const double least = 1e-12 * reach * reach;
    if (!(length(normal) > least))  // what winds both ways, such as an 8: as its largest part
        for (std::size_t i = 2; i < corners.size(); ++i) {
            const Vector part = cross(corners[i - 1] - corners[0], corners[i] - corners[0]);
            if (length(part) > largest) largest = length(normal = part);
        }
    if (!(length(normal) > least)) return {};
    if (corners.size() == 3) return {{{0, 1, 2}}};
    return Ears(projected(corners, normal), farthest).cut(budget);
}

}  // namespace algae
