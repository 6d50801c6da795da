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

/// The claim in a file, in one of the theory that comes with algae, or "-" for standard input; systems
/// that it names are those of the gallery or of files beside it. Throws Error, Diagnostics or
/// BoundReached.
Claim open_claim(const std::string& file, const Budget& budget);

/// The folder of a file, "." for standard input.
std::string folder_of(const std::string& file);

/// What a name of a system means in a text: a file in the first of these folders that has it, or what
/// it means on the command line.
SystemSource systems_from(const std::vector<std::string>& folders, const Budget& budget);

}  // namespace algae::cli
