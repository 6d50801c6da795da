#pragma once

#include <string>

#include "base/budget.hpp"

namespace algae::cli {

/// What `algae dimension --table` is asked for.
struct DimensionTable {
    std::string folder;  // of .lsys files, with those in folders within; the gallery if empty
    bool quick = false;  // without measuring
    bool json = false;   // one array
    std::size_t grids = 8;
};

/// How many cells are touched in the finest scale of a measurement for the table, about.
inline constexpr std::uint64_t table_cells = 50'000;

/// Prints a line for every system: the exact dimension or an upper bound, the boundary, the
/// measurement with its interval and what it differs by; then those without a formula, and why.
int print_dimension_table(const DimensionTable& table, const Budget& budget);

}  // namespace algae::cli
