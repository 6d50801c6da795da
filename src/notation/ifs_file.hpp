#pragma once

#include "nature/iterated_functions.hpp"
#include "notation/relative_reader.hpp"

namespace algae {

/// Files `*.ifs` of iterated function systems.
RelativeKind ifs_kind();

/// The file that says this system.
RelativeFile ifs_file(const IteratedFunctions& system);

}  // namespace algae
