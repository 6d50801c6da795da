#pragma once

#include <string>

#include "growth/equal_growth.hpp"
#include "language/equivalence_language.hpp"
#include "language/sequence_equality.hpp"

namespace algae::cli {

// What `equal` found, in sentences; A and B are the systems as they stand on the command line.

std::string equal_text(const GrowthComparison& found);
std::string equal_text(const SequenceEquality& found, const Alphabet& alphabet);
std::string equal_text(const LanguageEquality& found, const Alphabet& alphabet);

}  // namespace algae::cli
