#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "base/budget.hpp"
#include "nature/cell_rule.hpp"

namespace algae {

/// What stands beyond the edges of a grid: the other side of it, or always the same state.
struct CellBoundary {
    bool periodic = true;
    std::uint8_t outside = 0;
    bool operator==(const CellBoundary&) const = default;
};

/// The states of all cells, row by row.
struct CellGrid {
    std::size_t columns = 0, rows = 1;
    std::vector<std::uint8_t> cells;

    CellGrid() = default;
    /// All 0. Throws Error if there would be more cells than the memory of the budget has bytes, or
    /// none.
    CellGrid(std::size_t columns, std::size_t rows, const Budget& budget);

    std::uint8_t& at(std::size_t column, std::size_t row) { return cells[row * columns + column]; }
    std::uint8_t at(std::size_t column, std::size_t row) const {
        return cells[row * columns + column];
    }
    bool operator==(const CellGrid&) const = default;
};

/// The generations of a cellular automaton, one after the other. Elementary rules work on 64 cells at
/// a time, as a sum of products of the three bits over the field of two elements; others look every
/// cell up in the table.
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
