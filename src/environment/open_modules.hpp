#pragma once

#include <cstdint>
#include <memory>

#include "environment/environment.hpp"
#include "turtle/derived_modules.hpp"

namespace algae {

/// The word of generation n of any system: of one with communication modules that of
/// OpenDevelopment, of others what derived_modules gives. Throws what these throw, and Error if the
/// system has tables and nobody says which.
DerivedModules open_modules(const LSystem& system, std::uint64_t n, const FigureChoices& choices,
                            std::shared_ptr<Environment> external, const Budget& budget);

}  // namespace algae
