#include "growth/equal_growth.hpp"

#include "growth/growth_matrix.hpp"

namespace algae {

GrowthComparison equal_growth(const D0L& left, const D0L& right, const Budget& budget) {
    const GrowthMatrix matrices[] = {growth_matrix(left), growth_matrix(right)};
    std::vector<Integer> counts[] = {axiom_counts(left), axiom_counts(right)};
    GrowthComparison found;
    found.bound = matrices[0].size() + matrices[1].size();
    for (std::uint64_t n = 0; n < found.bound; ++n) {
        budget.check();
        Integer lengths[2];
        for (int side = 0; side < 2; ++side) {
            for (const Integer& count : counts[side]) lengths[side] += count;
            counts[side] = counts[side] * matrices[side];
        }
        if (lengths[0] != lengths[1]) {
            found.difference = {n, lengths[0], lengths[1]};
            return found;
        }
    }
    found.equal = true;
    return found;
}

}  // namespace algae
