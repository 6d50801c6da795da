#pragma once

#include <span>
#include <vector>

#include "base/budget.hpp"
#include "dimension/scaling.hpp"
#include "turtle/figure.hpp"

namespace algae {

/// A polyline: the points that it joins, in order.
using Stroke = std::vector<Point>;

/// The connected strokes of a figure; outlines of polygons are closed. 16 bytes a segment: throws
/// BoundReached if that is more than budget.memory, Error if nothing is drawn.
std::vector<Stroke> strokes_of(const Figure& figure, const Budget& budget);

/// How many steps dividers of this opening take along a stroke from its first point to its last.
/// Each step goes to the first point of the stroke, on its segments too, that is one opening away:
/// where the circle meets the segment. What remains at the end counts as a share of a step. 0 for
/// fewer than two points. O(points + steps).
///
/// Throws Error unless the opening is above 0, Interrupted.
///
/// Example: divider_steps(Stroke{{0, 0}, {3, 0}, {3, 1}}, 2, Budget()) == 1 + std::sqrt(2) / 2
double divider_steps(std::span<const Point> stroke, double opening, const Budget& budget);

/// The lengths that dividers of several openings find (Richardson 1961; Mandelbrot, How long is the
/// coast of Britain?, Science 156, 1967): opening times steps, so that dimension = 1 - slope. Each
/// stroke is walked from eight of its points to both of its ends, and the mean taken. Openings are
/// an eighth of the widest stroke and its halves down to `detail`, the length of a segment; used
/// are those of at least four. Strokes less wide than the widest opening are left out, which
/// `because` says. O(points * openings).
///
/// Throws Error if there is no stroke wider than a point, BoundReached, Interrupted.
Scaling divider(const std::vector<Stroke>& strokes, double detail, const Budget& budget);

/// The same of the strokes of a figure.
Scaling divider(const Figure& figure, const Budget& budget);

}  // namespace algae
