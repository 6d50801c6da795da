#pragma once
// Used by the .cpp files of FreeStep alone.

#include <cstdint>
#include <vector>

#include "rewrite/free_step.hpp"

namespace algae {

/// What a thread works with, kept from part to part.
struct FreeStep::Room {
    std::vector<std::vector<Row>> rows;         // by kind, or by outcome
    std::vector<std::vector<double>> gathered;  // columns of parameters
    std::vector<const double*> columns;         // the same, for programs
    std::vector<char> is_gathered;              // by parameter
    std::vector<double> values;                 // what a program gives
    std::vector<std::uint32_t> found;           // by row: the rules that match, counted from 1
    Program::Columns programs;
};

}  // namespace algae
