#pragma once

#include <array>

#include "render/graph.hpp"
#include "word/alphabet.hpp"

namespace algae {

/// Pale colours that can be told apart, in print too, for as many letters as one can keep in mind.
inline constexpr std::array<Colour, 8> tints{{{0.78, 0.87, 0.96},
                                              {0.99, 0.87, 0.68},
                                              {0.80, 0.92, 0.77},
                                              {0.96, 0.80, 0.82},
                                              {0.86, 0.81, 0.93},
                                              {1.00, 0.97, 0.72},
                                              {0.76, 0.92, 0.91},
                                              {0.90, 0.85, 0.78}}};

/// A node with a letter's name, its subscript lowered.
///
/// Example: letter_node(*d0l("a", {}).alphabet, 0).label == "a"
Graph::Node letter_node(const Alphabet& alphabet, Symbol letter);

}  // namespace algae
