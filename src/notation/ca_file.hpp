#pragma once

#include "notation/relative_reader.hpp"

namespace algae {

/// Files `*.ca` of cellular automata.
RelativeKind ca_kind();

}  // namespace algae
