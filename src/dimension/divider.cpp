#include <fmt/format.h>

#include <algorithm>

#include "dimension/detail/cells.hpp"
#include "dimension/detail/measures.hpp"

// Richardson's dividers: how the length of a coast depends on the opening with which it is walked
// (Richardson 1961; Mandelbrot, How long is the coast of Britain?, 1967).
//
// A step goes to the first point of the stroke, on its segments too, that is one opening away: the
// first segment whose end lies outside of the circle is met by it in exactly one point, since its
// beginning lies inside. Of the two forms of the root of the quadratic equation the one is taken
// that does not subtract like numbers. Where openings are so fine that a step does not leave its
// place in doubles, an error says so. What remains at the end counts as a share of a step.
//
// The result depends on where the walk begins, so each stroke is walked from eight of its points in
// both directions.

namespace algae {

namespace {

constexpr std::size_t starts = 8;
constexpr std::size_t check_every = 1 << 16;

/// How far from `from` to `to`, as a share, the circle is left whose inside holds `from`.
double exit_share(Point centre, double radius, Point from, Point to) {
    const double dx = to.x - from.x, dy = to.y - from.y;
    const double fx = from.x - centre.x, fy = from.y - centre.y;
    const double a = dx * dx + dy * dy, b = fx * dx + fy * dy;
    const double c = std::min(fx * fx + fy * fy - radius * radius, 0.0);  // inside
    const double root = std::sqrt(b * b - a * c);
    // Of the two forms of the same root, the one that subtracts no like numbers.
    return b > 0 ? -c / (b + root) : (root - b) / a;
}

double side_of(const Stroke& stroke) {
    Box box;
    for (const Point point : stroke) box.add(point);
    return std::max(box.breadth(), box.height());
}

/// From a point of the stroke to both ends.
double steps_from(const Stroke& stroke, const Stroke& reversed, std::size_t start, double opening,
                  const Budget& budget) {
    return divider_steps(std::span(stroke).subspan(start), opening, budget) +
           divider_steps(std::span(reversed).subspan(stroke.size() - 1 - start), opening, budget);
}

}  // namespace

std::vector<Stroke> strokes_of(const Figure& figure, const Budget& budget) {
    std::vector<Stroke> strokes;
    std::uint64_t points = 0;
    const auto grow = [&] {
        if (points++ % check_every == 0)
            budget.check_memory((points + check_every) * sizeof(Point) * 2,
                                "the points of the strokes");
    };
    DrawnSegments canvas([&](Point from, Point to, bool joined) {
        if (!joined) strokes.push_back({from});
        grow();
        strokes.back().push_back(to);
    });
    figure.draw(canvas, 0, budget);
    if (strokes.empty()) throw Error("nothing is drawn: expected something to measure");
    return strokes;
}

double divider_steps(std::span<const Point> stroke, double opening, const Budget& budget) {
    if (!(opening > 0))
        throw Error(fmt::format("expected dividers opened wider than 0, found {}", opening));
    if (stroke.size() < 2) return 0;
    std::uint64_t steps = 0, work = 0;
    Point leg = stroke.front();
    for (std::size_t i = 0; i + 1 < stroke.size(); ++i) {
        if (++work % check_every == 0) budget.check();
        Point from = stroke[i];
        const Point to = stroke[i + 1];
        while (distance(leg, to) >= opening) {
            if (++work % check_every == 0) budget.check();
            const double share = exit_share(leg, opening, from, to);
            const Point next{from.x + share * (to.x - from.x), from.y + share * (to.y - from.y)};
            if (next == leg)
                throw Error(fmt::format(
                    "dividers opened by {} are too fine for coordinates of this size", opening));
            leg = from = next;
            ++steps;
        }
    }
    return static_cast<double>(steps) + distance(leg, stroke.back()) / opening;
}

Scaling divider(const std::vector<Stroke>& strokes, double detail, const Budget& budget) {
    double whole = 0;
    for (const Stroke& stroke : strokes) whole = std::max(whole, side_of(stroke));
    if (!std::isfinite(whole) || !(whole > 0))
        throw Error(fmt::format(
            "expected a stroke that is wider or higher than a point, found a size of {}", whole));
    Scaling result;
    const double coarsest = whole / ScaleRange::parts_of_whole;
    result.sizes = halved_sizes(coarsest, detail);
    if (result.sizes.empty()) result.sizes = {coarsest};
    std::vector<double> steps(result.sizes.size());
    std::size_t left_out = 0;
    for (const Stroke& stroke : strokes) {
        if (side_of(stroke) < coarsest) {
            ++left_out;
            continue;
        }
        const Stroke reversed(stroke.rbegin(), stroke.rend());
        for (std::size_t k = 0; k < starts; ++k) {
            const std::size_t start = (2 * k + 1) * (stroke.size() - 1) / (2 * starts);
            for (std::size_t i = 0; i < steps.size(); ++i)
                steps[i] += steps_from(stroke, reversed, start, result.sizes[i], budget) / starts;
        }
    }
    std::vector<double> powers;
    for (std::size_t i = 0; i < steps.size(); ++i) {
        result.values.push_back(steps[i] * result.sizes[i]);
        powers.push_back(-std::log(steps[i]));
    }
    ScaleRange range{ScaleRange::details * detail, coarsest};
    range.scales = "openings";
    fit_scaling(result, powers, range, {1, 1, 0}, HUGE_VAL);
    if (left_out > 0)
        result.because +=
            "; " + counted(left_out, "stroke") + " less wide than an eighth of the widest left out";
    return result;
}

Scaling divider(const Figure& figure, const Budget& budget) {
    return divider(strokes_of(figure, budget), figure.facts().step, budget);
}

}  // namespace algae
