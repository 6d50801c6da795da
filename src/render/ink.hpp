#pragma once

#include <string>
#include <string_view>

#include "base/budget.hpp"
#include "dimension/points.hpp"

namespace algae {

/// Which pixels of an image are ink, and which are paper.
struct InkOptions {
    /// A pixel is ink if it is darker than this, from 0 (black) to 1 (white); transparent pixels are
    /// as light as the white sheet below them.
    double threshold = 0.5;
    /// Ink is what is lighter instead.
    bool invert = false;
};

/// Whether the bytes begin as those of a PNG image do.
bool is_png(std::string_view bytes);

/// The pixels of a PNG image that are ink, as points a pixel apart, x to the right and y upward.
///
/// Throws Error if the bytes are no image that Cairo can read, if the threshold is not between 0 and
/// 1, or if all pixels are ink or all are paper; BoundReached.
PointSet ink_of(std::string_view png, const std::string& name, const InkOptions& options,
                const Budget& budget);

}  // namespace algae
