#pragma once

#include "notation/relative_reader.hpp"

namespace algae {

/// Files `*.brownian` of fractional Brownian motion.
RelativeKind brownian_kind();

}  // namespace algae
