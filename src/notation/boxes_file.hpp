#pragma once

#include "notation/relative_reader.hpp"

namespace algae {

/// Files `*.boxes` of sets covered with squares.
RelativeKind boxes_kind();

}  // namespace algae
