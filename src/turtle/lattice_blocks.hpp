#pragma once

#include "base/budget.hpp"
#include "fold/walk.hpp"
#include "system/d0l.hpp"
#include "turtle/canvas.hpp"
#include "turtle/commands.hpp"
#include "turtle/compass.hpp"
#include "turtle/pen.hpp"

namespace algae {

/// Draws `steps` steps of `rules` letter by letter as Pen<LatticePosition> does, stroke for stroke
/// and number for number, only faster: what a letter draws in its last few steps is worked out once
/// for each heading and then moved to where the turtle is, in whole numbers.
///
/// Returns false, and draws nothing, where that does not apply: an inexact compass, coordinates of
/// more than four numbers, commands beyond drawing, moving, turning and brackets, a canvas that wants
/// positions. Every letter but the brackets must leave the stack as it found it.
bool draw_lattice_blocks(const D0L& rules, const Fates& fates, std::uint64_t steps,
                         const Commands& commands, const Compass& compass,
                         const PenSettings& settings, Canvas& canvas, const Budget& budget);

}  // namespace algae
