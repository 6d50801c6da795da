#pragma once

#include <optional>
#include <vector>

#include "base/budget.hpp"
#include "exact/integer.hpp"
#include "verify/system.hpp"

namespace algae::verify {

/// The lengths of the words of a D0L system, one generation after the other, by counting letters.
class Lengths {
public:
    /// `system` must outlive this.
    explicit Lengths(const System& system);

    /// The number of letters that are accessible.
    std::size_t letters() const { return counts_.size(); }
    /// The length of the present generation, at first the axiom's.
    Integer length() const;
    void next();

private:
    const System& system_;
    std::vector<Symbol> symbols_;
    std::vector<Integer> counts_;  // by place in symbols_
};

/// The length of one generation. Throws BoundReached for generations beyond 100,000.
Integer length_of_generation(const System& system, const Integer& generation, const Budget& budget);

/// The letter at a position, counted from 0, of a generation of a D0L system, found without writing
/// the word; nothing if the word is not so long. Throws BoundReached where the lengths of what letters
/// become take more than the budget.
std::optional<Symbol> letter_of_generation(const System& system, std::uint64_t generation,
                                           Integer position, const Budget& budget);

}  // namespace algae::verify
