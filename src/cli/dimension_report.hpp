#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "dimension/exact_dimension.hpp"
#include "dimension/fit.hpp"

namespace algae::cli {

/// What was measured, and what it is called.
struct Measured {
    std::string what;
    std::optional<ExactDimension> exact;
    std::optional<std::uint64_t> generation;
    BoxCounts counts;
    BoxFit fit;
};

/// What `algae dimension` prints.
std::string dimension_page(const Measured& found);
/// What the rules give: status, formula, value and decimal, conditions, similarity, boundary.
nlohmann::ordered_json exact_json(const ExactDimension& exact);
nlohmann::ordered_json dimension_json(const Measured& found);

}  // namespace algae::cli
