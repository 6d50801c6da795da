#pragma once

#include <string>
#include <vector>

#include "base/budget.hpp"
#include "claim/claim.hpp"
#include "notation/read_claim.hpp"

namespace algae::cli {

/// The files of claims that a path means: itself, or in a folder all claims, sorted by name. What is
/// no path here may be one of the theory that comes with algae: `theory`, `theory/closure`. Throws
/// Error if there are none.
std::vector<std::string> claim_files(const std::string& path);

/// The claim in a file, in one of the theory that comes with algae, or "-" for standard input; systems that it names are those of the gallery or of files
/// beside it. Throws Error, Diagnostics or BoundReached.
Claim open_claim(const std::string& file, const Budget& budget);

/// What a name of a system means in a text that stands in this folder.
SystemSource systems_from(const std::string& folder, const Budget& budget);

}  // namespace algae::cli
