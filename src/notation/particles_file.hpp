#pragma once

#include "notation/relative_reader.hpp"

namespace algae {

/// Files `*.particles` of particle systems.
RelativeKind particles_kind();

}  // namespace algae
