#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <unordered_map>
#include <vector>

#include "base/budget.hpp"
#include "exact/integer.hpp"
#include "growth/growth_matrix.hpp"
#include "language/sequence_overflow.hpp"

namespace algae {

/// Compares the sequences of two D0L systems with the same axiom, generation by generation, without
/// writing the words out: where the letters of g^k(a) lead from an overflow is worked out once for each
/// letter a, overflow and k that occur. The systems and the budget must outlive it.
class OverflowWalk {
public:
    OverflowWalk(const SequencePair& systems, const Budget& budget);

    /// Generations 0 to this number are known to be the same.
    std::uint64_t generations() const { return generations_; }
    /// All overflows that prefixes of the words before that generation have; the empty one first.
    const std::vector<Overflow>& overflows() const { return overflows_; }
    /// Compares the next generation: nothing if it is the same, otherwise the position, from 0, of the
    /// first letter that differs or that only one of the words has. After that it must not be called again.
    /// Throws BoundReached if what is kept takes more than budget.memory.
    std::optional<Integer> next_difference();

private:
    using Number = std::uint32_t;  // of an overflow
    /// A word of which `read` letters have been read, each standing for what it becomes in `level` steps.
    struct Reading {
        const Word* word;
        std::size_t level;
        std::size_t read;
        Number at;
    };

    std::optional<Number> first_step(Symbol letter, Number from);
    Number number_of(Overflow overflow);
    Integer position(const std::vector<Reading>& open, std::size_t agreed) const;
    void check_memory() const;

    const SequencePair& systems_;
    const Budget& budget_;
    GrowthMatrix matrix_;
    std::vector<std::size_t> row_;               // of a letter in the matrix
    std::vector<std::vector<Integer>> lengths_;  // of g^k(letter), by k and row
    std::vector<Overflow> overflows_;
    std::map<Overflow, Number> numbers_;
    std::vector<std::unordered_map<std::uint64_t, Number>>
        led_;  // by level: where a letter leads from an overflow
    std::size_t generations_ = 0;
    std::uint64_t kept_ = 0;  // bytes
    std::size_t agreed_ = 0;  // by the step that found the difference
};

}  // namespace algae
