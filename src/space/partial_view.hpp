#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "space/view.hpp"
#include "turtle/derived_modules.hpp"

namespace algae {

/// The view of a word in space after each of these numbers of symbols, which rise, with the turtle
/// where it is; all in one box and seen by one camera. Each is made anew when it is drawn, so there is
/// memory for two scenes at a time.
///
/// Throws what `scene`, SpaceView and ModuleTurtle throw. Drawing is linear in the length of the word
/// and whatever SpaceView takes.
std::vector<std::unique_ptr<Figure>> partial_views(const LSystem& system,
                                                   const DerivedModules& derived, std::uint64_t n,
                                                   const std::vector<std::size_t>& symbols,
                                                   const ViewChoices& choices,
                                                   const Budget& budget);

}  // namespace algae
