#pragma once

#include <span>
#include <string>

#include "cli/verb_table.hpp"

namespace algae::cli {

/// The page algae(1), in the language of man(7).
std::string manual_page(std::span<const VerbEntry> verbs);

/// Completions of verbs, options, their values, names of the gallery and files, for bash: a function
/// `_algae` that needs nothing but bash.
std::string bash_completion(std::span<const VerbEntry> verbs);

/// The same for zsh, as a file `_algae` of its functions.
std::string zsh_completion(std::span<const VerbEntry> verbs);

/// The same for fish.
std::string fish_completion(std::span<const VerbEntry> verbs);

}  // namespace algae::cli
