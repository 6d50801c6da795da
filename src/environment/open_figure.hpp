#pragma once

#include <memory>

#include "environment/environment.hpp"
#include "turtle/figure.hpp"

namespace algae {

/// The figure of generation n of any system: of one with communication modules that of the word of
/// OpenDevelopment, of others what `figure` gives. Throws what these throw, and Error if the system
/// has tables and nobody says which.
std::unique_ptr<Figure> open_figure(const LSystem& system, std::uint64_t n, const Budget& budget,
                                    const FigureChoices& choices = {},
                                    std::shared_ptr<Environment> external = nullptr);

}  // namespace algae
