#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "language/language.hpp"

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

/// Whether the rules of the system have the form. Rules of letters that never occur do not matter.
bool has_form(const SourceSystem& system, const SystemForm& form);

}  // namespace algae
