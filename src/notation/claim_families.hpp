#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "language/system_form.hpp"
#include "system/lsystem.hpp"

namespace algae {

/// The name by which statements keep a family of languages: "REG" and "regular" are REG, "CF" and
/// "context-free" are CF, names of families of L-systems stay; nothing if there is no such family.
///
/// Example: language_family("regular") == "REG"
std::optional<std::string> language_family(std::string_view name);

/// Names of families for messages that choose one nearby.
const std::vector<std::string>& common_families();

/// Why the system is not of the form: "the rule at x.claim:3:20 is erasing"; empty if it is. Rules
/// of letters that never occur are not looked at.
std::string misfit(const LSystem& system, const SystemForm& form);

}  // namespace algae
