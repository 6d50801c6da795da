#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "claim/claim.hpp"
#include "notation/claim_reading.hpp"

namespace algae {

// Systems in claims whose words are derived module by module: stochastic and parametric ones, and those
// with contexts in words that are trees. What is said of them is `G ==> W in n steps` and
// `P(G ==> W in n steps) = 1/9`.

/// Whether the word names systems that have probabilities or parameters: S0L, PS0L, parametric.
bool is_rewriting_family(std::string_view name);

/// Their names, for messages that choose one nearby.
const std::vector<std::string>& rewriting_families();

/// Why the system is not of the family; empty if it is.
std::string misfit(const LSystem& system, std::string_view family);

/// Whether a statement begins with `P(` and holds an arrow: the probability of a derivation.
bool is_chance(std::string_view text);

/// Reads `P(G ==> W in n steps) = NUMBER`, or `!=`. Throws `SyntaxError`.
void parse_chance(std::string_view text, Statement& statement, ClaimReading& reading);

/// Reads what is derived, `WORD in n steps`, into a statement on a system of these, and the word it begins
/// with if it is no axiom. Throws `SyntaxError`.
void parse_rewriting(const std::shared_ptr<const LSystem>& system,
                     const std::optional<std::string_view>& from, std::string_view word,
                     std::optional<std::uint64_t> steps, Statement& statement,
                     ClaimReading& reading);

}  // namespace algae
