#pragma once
// The cells of a grid that segments touch, by asking every cell about every segment in exact numbers.

#include <cstdint>
#include <set>
#include <utility>
#include <vector>

#include "exact/exact.hpp"
#include "turtle/turtle.hpp"

namespace algae::oracle {

using ExactPoint = std::pair<Rational, Rational>;
using ExactSegment = std::pair<ExactPoint, ExactPoint>;
using Cell = std::pair<long, long>;

/// Whether some point of the segment has x in [left, left + width) and y in [low, low + width).
bool touches(const ExactSegment& segment, const Rational& left, const Rational& low,
             const Rational& width);

/// All cells of this width, counted from the origin, that some segment touches.
std::set<Cell> touched_cells(const std::vector<ExactSegment>& segments, const Rational& width);

/// A coordinate in cells, rounded half upward to a fraction 2^-20 of one.
Rational rounded(double coordinate, double origin, double cell);

/// The segments as a grid with this origin and cell sees them: in cells.
std::vector<ExactSegment> seen_segments(const std::vector<std::pair<Point, Point>>& segments,
                                        Point origin, double cell);

}  // namespace algae::oracle
