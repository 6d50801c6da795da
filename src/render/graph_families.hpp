#pragma once

#include <utility>
#include <vector>

#include "render/graph.hpp"

namespace algae {

/// Families of languages and how they lie: the first is a proper part of the second. Inclusions
/// that follow from others are left out. Languages are compared up to the empty word where the
/// families of Chomsky take part (Rozenberg and Salomaa 1980; ET0L in CS: van Leeuwen 1975; that
/// regular languages are IL: theory/document-001/families-regular-with-context.claim).
const std::vector<std::pair<const char*, const char*>>& family_inclusions();

/// The diagram of these families: a line leads up to the larger family; dashed lines join 0L with
/// REG and CF, with neither of which it has an inclusion.
///
/// Example: families_graph().nodes.size() == 14
Graph families_graph();

}  // namespace algae
