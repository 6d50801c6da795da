#pragma once

#include <cstdint>
#include <span>

#include "base/budget.hpp"
#include "render/film.hpp"
#include "render/output.hpp"

namespace algae {

/// Writes an opaque film as an animated GIF (version 89a): what changes of each frame, with one table of
/// colours for all. `hundredths`: how long each frame is shown, in hundredths of a second, below
/// 65,536. `plays`: how often it is shown, below 65,536; 0 for ever.
///
/// Throws Error if the film has a side above 65,535 pixels, BoundReached for want
/// of memory, and what writing throws.
void write_gif(const Film& film, std::span<const std::uint32_t> hundredths, std::uint32_t plays,
               Output& output, const Budget& budget = {});

}  // namespace algae
