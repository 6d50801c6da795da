#pragma once

#include <string_view>

#include "claim/claim.hpp"
#include "notation/claim_clauses.hpp"
#include "notation/claim_reading.hpp"

namespace algae {

/// A definition `let NAME = VALUE`, taken apart but not read.
struct ClaimDefinition {
    std::string_view name, value;
    ClaimName* meaning = nullptr;  // set by reading the value

    /// Whether the value begins with the name of a family: a system.
    bool is_system() const;
};

/// Takes `let NAME = VALUE` apart and makes the name known. Throws `SyntaxError`.
ClaimDefinition begin_definition(const ClaimClause& clause, ClaimReading& reading);

/// Reads the value, makes it what the name means and adds systems and languages to the claim. Throws
/// `SyntaxError` or `DependsOnError`.
void read_definition(const ClaimDefinition& definition, ClaimReading& reading, Claim& claim);

}  // namespace algae
