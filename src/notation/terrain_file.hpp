#pragma once

#include "notation/relative_reader.hpp"

namespace algae {

/// Files `*.terrain` of landscapes.
RelativeKind terrain_kind();

}  // namespace algae
