#include "growth/analysis.hpp"

namespace algae {

GrowthAnalysis growth_analysis(const D0L& system, const Budget& budget) {
    constexpr std::uint64_t shown = 11;
    GrowthMatrix matrix = growth_matrix(system);
    Components parts = components(matrix, budget);
    Recurrence recurrence = shortest_recurrence(system, budget);
    return {lengths(system, shown, budget),
            matrix,
            parts,
            matrix_polynomials(matrix, parts, budget),
            recurrence,
            generating_function(recurrence),
            ClosedForm(recurrence, budget),
            growth_class(system, parts, recurrence),
            letter_orders(parts),
            lifetimes(matrix),
            letter_frequencies(axiom_counts(system), matrix, parts, budget),
            primitivity(matrix),
            prolongations(system)};
}

}  // namespace algae
