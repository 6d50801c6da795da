#pragma once

#include "nature/iterated_functions.hpp"
#include "system/lsystem.hpp"

namespace algae {

/// The graph-directed iterated function system whose attractor the curves of a D0L system approach when
/// each generation is drawn as large as the one before: a state for each piece of its recurrent set
/// (a letter, in a phase), maps of the ratio 1/|mu| for its parts (Dekking, Recurrent sets, 1982). If
/// the axiom is more than one letter, the first state is the whole, and its maps only place the parts.
///
/// Throws what RecurrentSet throws where the system has none, and Error if it is no D0L system.
IteratedFunctions functions_of_curve(const LSystem& system, const Budget& budget = {});

}  // namespace algae
