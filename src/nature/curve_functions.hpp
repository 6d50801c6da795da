#pragma once

#include "nature/iterated_functions.hpp"
#include "system/lsystem.hpp"

namespace algae {

/// The graph-directed iterated function system whose attractor the curves of a D0L system approach when
/// each generation is drawn as large as the one before: a state for each piece of its recurrent set
/// (a letter, in a phase), maps of the ratio 1/|mu| for its parts (Dekking, Recurrent sets, 1982). If
/// the axiom is more than one letter, the first state is the whole, and its maps only place the parts.
/// The attractor lies as the curve does when the turtle starts at the origin with heading 0 and no
/// generation is turned against the one before: `start` and `spin` are left out.
///
/// Throws what RecurrentSet throws where the system has none, and Error if it is no D0L system.
IteratedFunctions functions_of_curve(const LSystem& system, const Budget& budget = {});

}  // namespace algae
