#pragma once
// The kinds of other generators, and values that several of them have.

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "notation/notation.hpp"

namespace algae {

/// The kinds whose files are long enough for a source of their own.
GeneratorKind ca_kind();
GeneratorKind particles_kind();

/// Values that several kinds of generators have; each throws Diagnostics at the word that is wrong.

/// A parameter H, above 0 and below 1. All words of the statement of this key.
std::optional<std::vector<double>> hurst_values(const GeneratorFile& file, const char* key);
/// A number above 0.
std::optional<double> positive_value(const GeneratorFile& file, const char* key);
/// All words of the statement of this key, as numbers from `least` to `most`.
std::optional<std::vector<double>> number_values(const GeneratorFile& file, const char* key,
                                                 double least, double most);
/// The same as whole numbers.
std::optional<std::vector<std::uint64_t>> natural_values(const GeneratorFile& file, const char* key,
                                                         std::uint64_t least, std::uint64_t most);
/// `N` or `N..M`, both at most `most`.
std::optional<std::pair<int, int>> level_values(const GeneratorFile& file, const char* key,
                                                int most);
/// The number of a random choice; 1 where the file says none.
std::uint64_t seed_value(const GeneratorFile& file);

}  // namespace algae
