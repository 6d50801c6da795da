#pragma once

// Cellular automata, generation by generation.

#include "nature/nature.hpp"

namespace algae {

/// The generations of a cellular automaton, one after the other. Elementary rules work on 64 cells
/// at a time, as a sum of products of the three bits over the field of two elements; others look
/// every cell up in the table.
class CellDevelopment {
public:
    CellDevelopment(const CellRule& rule, const CellGrid& start, const CellBoundary& boundary);
    ~CellDevelopment();
    CellDevelopment(CellDevelopment&&) noexcept;

    /// Goes n generations on. Elementary rules: O(n * cells / 64), others O(n * cells *
    /// neighbours).
    void step(std::uint64_t n, const Budget& budget);
    CellGrid grid() const;

private:
    class Engine;
    class Bits;
    class Bytes;
    std::unique_ptr<Engine> engine_;
};

}  // namespace algae
