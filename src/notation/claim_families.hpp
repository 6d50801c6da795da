#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "system/lsystem.hpp"

namespace algae {

/// What the name of a family says of the form of its systems: E extended, P propagating, D deterministic,
/// T with tables, then 0L, or with context IL, 1L, 2L, (k,l)L.
struct SystemForm {
    bool extended = false, propagating = false, deterministic = false, tables = false;
    bool interactive = false;
    std::optional<std::pair<std::size_t, std::size_t>> context;  // longest contexts, left and right
    bool one_sided = false;                                      // 1L: (1,0) or (0,1)
};

/// The form that a family's name says; nothing if it is no such name.
///
/// Example: system_form("PD0L")->deterministic
/// Example: !system_form("DOL")
std::optional<SystemForm> system_form(std::string_view name);

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
