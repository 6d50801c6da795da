#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/budget.hpp"
#include "render/cells.hpp"
#include "render/picture.hpp"
#include "render/plan.hpp"

namespace algae {

/// A frame of a film: what differs from the frame before it, and all of the first.
struct FilmFrame {
    PixelRectangle area;                // at least one pixel
    std::vector<std::uint32_t> pixels;  // row by row, 0xAARRGGBB, colours times opacity
};

/// The frames of an animation, without gaps in time.
struct Film {
    int width = 0, height = 0;  // pixels
    bool opaque = true;
    std::vector<FilmFrame> frames;

    /// Changes `picture`, all pixels of a frame, into the next one.
    void show(std::size_t frame, std::vector<std::uint32_t>& picture) const;
};

/// Draws plates as frames, one each, by a plan of frames. Throws BoundReached if they need more
/// memory than the budget has, and what drawing throws. `drawn` learns what was drawn.
Film film(std::span<const Plate> plates, const Plan& plan, const Budget& budget, Progress* progress,
          Drawn& drawn);

}  // namespace algae
