#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "base/budget.hpp"
#include "dimension/grid.hpp"
#include "turtle/figure.hpp"

namespace algae {

/// A cell, by its code (bits of its coordinates in turns, as Morton's), and how much of the measure
/// lies in it.
struct CellMass {
    std::uint64_t code = 0;
    double mass = 0;
    bool operator==(const CellMass&) const = default;
};

/// Collects masses of cells in any order. Memory for the different cells, three times over at most.
class CellMasses {
public:
    explicit CellMasses(const Budget& budget) : budget_(budget) {}

    void add(std::uint64_t code, double mass) {
        if (!masses_.empty() && masses_.back().code == code) {
            masses_.back().mass += mass;
            return;
        }
        if (masses_.size() >= limit_) merge();
        masses_.push_back({code, mass});
    }
    /// Every cell once, in the order of codes; empties the collection. Throws BoundReached.
    std::vector<CellMass> take() {
        merge();
        return std::exchange(masses_, {});
    }

private:
    void merge();

    Budget budget_;
    std::vector<CellMass> masses_;
    std::size_t limit_ = 1 << 16;
};

/// The length that a figure draws in each cell that it touches, in the half-open cells of a grid and
/// with Morton's codes; outlines of polygons count. A cell may be touched in a point, with mass 0.
/// O(segments * log(cells) + cells crossed).
///
/// Throws Error if the figure reaches beyond the grid's cells 0 to 2^31, BoundReached, Interrupted.
std::vector<CellMass> drawn_masses(const Figure& figure, const Grid& grid, const Budget& budget);

/// The same measure in cells twice as wide, where codes have the bits of so many coordinates in
/// turns. The list must be in the order of codes. O(cells).
std::vector<CellMass> in_cells_twice_as_wide(const std::vector<CellMass>& cells, int columns);

/// For each cell the mass of it and of all cells around it: of a box three times as wide. O(cells).
std::vector<double> masses_around(const std::vector<CellMass>& cells, int columns);

}  // namespace algae
