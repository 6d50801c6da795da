#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>

#include "growth/analysis.hpp"
#include "growth/length_bounds.hpp"
#include "system/d0l.hpp"
#include "system/ol.hpp"

namespace algae::cli {

/// A growth analysis as one page to be read aloud.
std::string growth_page(const D0L& system, const GrowthAnalysis& analysis);

/// The same as one JSON object.
nlohmann::ordered_json growth_json(const D0L& system, const GrowthAnalysis& analysis);

/// The least and greatest lengths of the words of an 0L system, generation by generation from `first` on.
std::string bounds_page(const OL& system, const LengthBounds& bounds, std::uint64_t first);
nlohmann::ordered_json bounds_json(const OL& system, const LengthBounds& bounds, std::uint64_t first);

/// "(x - 1)^2 (x^2 - x - 1)".
std::string factored(const Factorisation& factors);

/// The decimal of a rate to 30 digits.
std::string rate_decimal(const GrowthOrder& order);

}  // namespace algae::cli
