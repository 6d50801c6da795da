#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "system/expression.hpp"
#include "word/alphabet.hpp"

namespace algae {

/// What fills the communication modules of one name, as a file says it: `environment ?E clip 0 0 4 3`.
struct EnvironmentSetting {
    Symbol module = 0;
    std::string kind;  // one of environment_kinds()
    std::vector<Quantity> numbers;

    bool operator==(const EnvironmentSetting&) const = default;
};

/// A kind of environments: its name and what stands behind it.
struct EnvironmentKind {
    std::string name;
    std::string numbers;              // in words: "a radius"; empty if there are none
    std::vector<std::size_t> counts;  // how many there may be
};

/// All kinds of environments that a file can name; src/environment says what they answer.
///
/// Example: environment_kinds().front().name == "x"
const std::vector<EnvironmentKind>& environment_kinds();

/// Whether modules of this name ask an environment: a question mark with something behind it.
///
/// Example: is_communication("?E") && !is_communication("?")
bool is_communication(std::string_view name);

}  // namespace algae
