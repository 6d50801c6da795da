#pragma once

#include "notation/relative_reader.hpp"

namespace algae {

/// Files `*.dla` of diffusion-limited aggregation.
RelativeKind dla_kind();

}  // namespace algae
