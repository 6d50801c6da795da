#pragma once

#include <nlohmann/json_fwd.hpp>

#include "system/lsystem.hpp"

namespace algae {

// Systems whose words are derived module by module, as a certificate writes them (CERTIFICATES.md).

/// The axiom and the rules; constants are in them as numbers.
nlohmann::ordered_json to_json(const LSystem& system);

/// A word of modules whose arguments are expressions over the constants of the system.
nlohmann::ordered_json to_json(const ModuleWord& word, const LSystem& system);

}  // namespace algae
