#pragma once
// Collision and light by looking at every line, in whole numbers where that decides.

#include <array>
#include <cstdint>
#include <vector>

namespace algae::oracle {

using Place = std::array<std::int64_t, 3>;

struct Line {
    Place from, to;
};

/// The lines that are in the way at a place, after the first `drawn` of them were drawn: all but the last of
/// these that ends there, and those after it that begin there (all that begin there if none ends there).
std::vector<Line> others(const std::vector<Line>& lines, std::size_t drawn, const Place& place);

/// Whether some line comes so near: decided in whole numbers, the radius as a fraction.
bool is_near(const std::vector<Line>& lines, const Place& place, std::int64_t numerator,
             std::int64_t denominator);

/// The least distance, seen along the axis `up`, of what the lines have above the place: by
/// halving intervals. `most` if that is less.
double free_column(const std::vector<Line>& lines, const Place& place, std::size_t up, double most);

}  // namespace algae::oracle
