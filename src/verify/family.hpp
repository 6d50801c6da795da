#pragma once

#include <array>
#include <string>
#include <string_view>

namespace algae {

/// A family of languages of L-systems without context: 0L, with T (tables), D (deterministic: one
/// successor a letter, in each table) and P (propagating: no empty successor), as in Rozenberg and
/// Salomaa 1980.
struct Family {
    bool propagating = false;
    bool deterministic = false;
    bool tables = false;

    bool operator==(const Family&) const = default;
};

/// The name as the textbooks write it.
///
/// Example: to_string(Family{.propagating = true, .tables = true}) == "PT0L"
std::string to_string(Family family);

/// The family of this name. Throws Error if there is none.
///
/// Example: family_named("PD0L") == Family{true, true, false}
Family family_named(std::string_view name);

/// 0L, P0L, D0L, PD0L, T0L, PT0L, DT0L, PDT0L.
const std::array<Family, 8>& all_families();

}  // namespace algae
