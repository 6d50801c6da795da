#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "rewrite/rewrite.hpp"
#include "system/system.hpp"

namespace algae::command {

/// How `derive` and `tree` choose where a system leaves a choice. A seed on the command line says that rules without
/// probabilities, and tables, are picked too.
RewritingChoices derivation_choices(const LSystem& system, std::optional<std::uint64_t> seed,
                                    bool seeded);

/// The tables of --tables; none where the schedule or the seed picks them. Throws Error if nothing does.
std::vector<std::size_t> derivation_tables(const LSystem& system, const std::string& tables,
                                           bool seeded);

/// Throws Error if a sequence has fewer tables than n steps need.
void check_long_enough(const std::vector<std::size_t>& sequence, std::uint64_t n);

}  // namespace algae::command
