#pragma once

#include <string>

#include "turtle/outline.hpp"

namespace algae {

/// Whether two outlines are the same but for a motion of the plane, its mirror images, and size.
struct Similarity {
    bool similar = false;
    bool same_size = false;   // then they are congruent
    bool same_place = false;  // then they are the same, to a ten millionth of their size
    bool exact =
        false;  // decided by numbers that are not rounded; otherwise to a ten millionth of the figure
    std::string difference;  // a sentence, where they are not similar
};

/// Compares strokes with strokes and polygons with polygons: a stroke is not the same as two that make
/// it up. Names are for the sentence. A motion is looked for in doubles, from the farthest point from the middle to each
/// point as far from the middle of the other; what is found is proved in the ring where both
/// are exact, by (p - p0)(q1 - q0) = (q - q0)(p1 - p0) for all points p and their images q.
/// Linear in the strokes for each such pair of points.
Similarity similarity(const Outline& left, const std::string& left_name, const Outline& right,
                      const std::string& right_name);

}  // namespace algae
