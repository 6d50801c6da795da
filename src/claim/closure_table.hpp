#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "claim/claim.hpp"

namespace algae {

/// The operations and the families of the table of closure, in its order.
///
/// Example: closure_operations().front() == "union"
const std::vector<std::string>& closure_operations();
/// Example: closure_families().front() == "REG"
const std::vector<std::string>& closure_families();

/// Which families of languages are closed under which operations, and which claim settles it.
class ClosureTable {
public:
    struct Cell {
        bool closed = false;
        std::size_t claim = 0;  // index into the claims
    };

    /// Throws Error if two claims settle one cell, with the places of both.
    explicit ClosureTable(const std::vector<Claim>& claims);

    /// What is settled about a family and an operation, if anything is.
    std::optional<Cell> cell(std::string_view family, std::string_view operation) const;

private:
    std::map<std::pair<std::string, std::string>, Cell, std::less<>> cells_;
};

}  // namespace algae
