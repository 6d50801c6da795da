#pragma once

#include <cstdint>
#include <span>

#include "base/budget.hpp"
#include "render/film.hpp"
#include "render/output.hpp"

namespace algae {

/// Writes a film as an animated WebP without any loss. Equal frames that follow each other become one
/// that is shown as long. `hundredths`: how long each frame is shown, in hundredths of a second.
/// `plays`: how often it is shown, below 65,536; 0 for ever.
///
/// Throws Error if the film has a side above 16,383 pixels, and what writing throws.
void write_webp(const Film& film, std::span<const std::uint32_t> hundredths, std::uint32_t plays,
                Output& output, const Budget& budget = {});

}  // namespace algae
