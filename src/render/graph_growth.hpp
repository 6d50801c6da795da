#pragma once

#include "base/budget.hpp"
#include "render/graph.hpp"
#include "system/d0l.hpp"

namespace algae {

/// The growth digraph of a D0L system: an edge from a letter to each letter of its successor, with
/// how often it occurs there if more than once; an arrow without a start leads to the letters of
/// the axiom. Colours tell the four fates of a letter by its strongly connected component
/// (Rozenberg and Salomaa 1980, I.3): mortal letters vanish; a letter on no cycle passes; the
/// letters of a cycle come back once a round; in an expanding component they multiply, by its rate
/// a step. Components of the last kind, and cycles of several letters, have a frame.
///
/// Takes what `components` takes. Throws what budget.check throws.
///
/// Example: growth_graph(d0l("b", {{'a', "ab"}, {'b', "a"}})).groups[0].label == "rate (1+√5)/2 = 1.6180..."
Graph growth_graph(const D0L& system, const Budget& budget = {});

}  // namespace algae
