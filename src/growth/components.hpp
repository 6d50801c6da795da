#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "base/budget.hpp"
#include "exact/polynomial.hpp"
#include "growth/growth_matrix.hpp"
#include "growth/rate.hpp"

namespace algae {

/// Letters that all occur in what each of them becomes, or one letter alone. All numbers are places
/// in `D0L::letters`.
struct Component {
    std::vector<std::size_t> letters;
    std::vector<std::size_t> below;  // components that occur in successors, without itself
    Factorisation characteristic;    // of its part of the matrix
    std::optional<Rate> rate;        // its spectral radius; none for a letter that never returns
    std::uint64_t cyclicity = 0;     // the greatest common divisor of its cycles' lengths; 0 without a cycle
};

/// The strongly connected components of the letters.
struct Components {
    std::vector<Component> list;          // what occurs in a component's successors stands before it
    std::vector<std::size_t> of_letter;   // the component of each letter
};

/// Components by Tarjan's algorithm (Boost.Graph), rates exactly.
///
/// Example: components(growth_matrix(d0l("a", {{'a', "ab"}, {'b', "a"}}))).list[0].rate->exact() == "(1+sqrt(5))/2"
Components components(const GrowthMatrix& matrix, const Budget& budget = {});

}  // namespace algae
