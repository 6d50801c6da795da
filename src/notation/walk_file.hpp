#pragma once

#include "notation/relative_reader.hpp"

namespace algae {

/// Files `*.walk` of random walks.
RelativeKind walk_kind();

}  // namespace algae
