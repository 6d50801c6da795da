#include "oracle/ray_caster.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace algae::oracle {

namespace {

using Matrix = std::array<Triple, 3>;

constexpr double degree = 3.14159265358979323846 / 180;

Triple times(const Matrix& m, const Triple& v) {
    Triple result{};
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j) result[i] += m[i][j] * v[j];
    return result;
}

/// World to picture: x to the right, y upward, z towards the eye.
Triple turned(const Eye& eye, const Triple& v) {
    const double a = (eye.azimuth + 90) * degree, e = eye.elevation * degree;
    const Matrix about_z{
        {{std::cos(a), std::sin(a), 0}, {-std::sin(a), std::cos(a), 0}, {0, 0, 1}}};
    const Matrix about_x{
        {{1, 0, 0}, {0, std::sin(e), std::cos(e)}, {0, -std::cos(e), std::sin(e)}}};
    return times(about_x, times(about_z, v));
}

/// Picture to world: the transpose.
Triple turned_back(const Eye& eye, const Triple& v) {
    Triple result{};
    for (std::size_t i = 0; i < 3; ++i) {
        Triple unit{};
        unit[i] = 1;
        const Triple column = turned(eye, unit);
        for (std::size_t j = 0; j < 3; ++j) result[i] += column[j] * v[j];
    }
    return result;
}

double product(const Triple& a, const Triple& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Triple minus(const Triple& a, const Triple& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

double distance_to(const Eye& eye) { return eye.radius / std::sin(eye.opening / 2 * degree); }

constexpr double never = std::numeric_limits<double>::infinity();

double meets_box(const Body& box, const Triple& from, const Triple& way) {
    double enters = -never, leaves = never;
    for (std::size_t i = 0; i < 3; ++i) {
        if (way[i] == 0) {
            if (from[i] < box.low[i] || from[i] > box.high[i]) return never;
            continue;
        }
        double a = (box.low[i] - from[i]) / way[i], b = (box.high[i] - from[i]) / way[i];
        if (a > b) std::swap(a, b);
        enters = std::max(enters, a);
        leaves = std::min(leaves, b);
    }
    return enters < leaves ? enters : never;
}

double meets_ball(const Body& ball, const Triple& from, const Triple& way) {
    const Triple off = minus(from, ball.low);
    const double a = product(way, way), b = product(way, off),
                 c = product(off, off) - ball.radius * ball.radius;
    const double inside = b * b - a * c;
    return inside < 0 ? never : (-b - std::sqrt(inside)) / a;
}

double meets_rod(const Body& rod, const Triple& from, const Triple& way) {
    const Triple axis = minus(rod.high, rod.low), off = minus(from, rod.low);
    const double square = product(axis, axis);
    double best = never;
    const auto try_at = [&](double t) {
        const Triple at{off[0] + t * way[0], off[1] + t * way[1], off[2] + t * way[2]};
        const double along = product(at, axis) / square;
        const double aside = product(at, at) - along * along * square;
        if (along >= -1e-9 && along <= 1 + 1e-9 && aside <= rod.radius * rod.radius * (1 + 1e-6))
            best = std::min(best, t);
    };
    const double wa = product(way, axis), oa = product(off, axis);
    const double a = product(way, way) - wa * wa / square, b = product(way, off) - wa * oa / square;
    const double c = product(off, off) - oa * oa / square - rod.radius * rod.radius;
    const double inside = b * b - a * c;
    if (a > 0 && inside >= 0) try_at((-b - std::sqrt(inside)) / a);
    if (wa != 0) {
        try_at(-oa / wa);
        try_at((square - oa) / wa);
    }
    return best;
}

}  // namespace

std::optional<std::size_t> first_met(const std::vector<Body>& bodies, const Eye& eye, double x,
                                     double y) {
    const Triple middle = turned(eye, eye.middle);
    Triple from = turned_back(eye, {x, y, middle[2] + 1000}), way = turned_back(eye, {0, 0, -1});
    if (eye.opening > 0) {
        from = turned_back(eye, {middle[0], middle[1], middle[2] + distance_to(eye)});
        way = minus(turned_back(eye, {x, y, middle[2]}), from);
    }
    double best = never;
    std::optional<std::size_t> met;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        const double t = bodies[i].kind == Body::Kind::box    ? meets_box(bodies[i], from, way)
                         : bodies[i].kind == Body::Kind::ball ? meets_ball(bodies[i], from, way)
                                                              : meets_rod(bodies[i], from, way);
        if (t < best) {
            best = t;
            met = i;
        }
    }
    return met;
}

std::array<double, 2> seen_by_matrices(const Eye& eye, const Triple& point) {
    const Triple seen = turned(eye, point);
    if (eye.opening == 0) return {seen[0], seen[1]};
    const Triple middle = turned(eye, eye.middle);
    const double away = distance_to(eye) - (seen[2] - middle[2]), nearer = distance_to(eye) / away;
    return {middle[0] + nearer * (seen[0] - middle[0]), middle[1] + nearer * (seen[1] - middle[1])};
}

}  // namespace algae::oracle
