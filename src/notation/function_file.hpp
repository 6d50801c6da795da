#pragma once

#include "notation/relative_reader.hpp"

namespace algae {

/// Files `*.function` of Weierstrass's function.
RelativeKind function_kind();

}  // namespace algae
