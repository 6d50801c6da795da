#pragma once

#include <string>

#include "base/budget.hpp"
#include "claim/claim.hpp"
#include "notation/read_claim.hpp"

namespace algae::cli {

/// The claim in a file, or "-" for standard input; systems that it names are those of the gallery or of files
/// beside it. Throws Error, Diagnostics or BoundReached.
Claim open_claim(const std::string& file, const Budget& budget);

/// What a name of a system means in a text that stands in this folder.
SystemSource systems_from(const std::string& folder, const Budget& budget);

}  // namespace algae::cli
