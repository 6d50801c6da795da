#include <algorithm>

#include "growth/letters.hpp"

namespace algae {

std::vector<std::optional<std::uint64_t>> lifetimes(const GrowthMatrix& matrix) {
    const std::size_t size = matrix.size();
    std::vector<std::optional<std::uint64_t>> found(size);
    std::vector<std::size_t> alive(size), dead;  // letters of the successor that are not known to die
    std::vector<std::vector<std::size_t>> occurs_in(size);
    for (std::size_t i = 0; i < size; ++i) {
        alive[i] = matrix.rows[i].size();
        for (const auto& entry : matrix.rows[i]) occurs_in[entry.column].push_back(i);
        if (alive[i] == 0) {
            found[i] = 1;
            dead.push_back(i);
        }
    }
    // In order of lifetime, so the last letter of a successor to die says when all have.
    for (std::size_t k = 0; k < dead.size(); ++k)
        for (const std::size_t i : occurs_in[dead[k]])
            if (--alive[i] == 0) {
                found[i] = *found[dead[k]] + 1;
                dead.push_back(i);
            }
    return found;
}

}  // namespace algae
