#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "notation/findings.hpp"

namespace algae {

/// A word of another program's file, and for each of its bytes the byte where it stands there.
struct PlacedWord {
    std::string text;
    std::vector<std::size_t> offsets;

    /// Appends a letter that stands at this byte.
    void add(std::string_view letter, std::size_t offset);
};

/// Adds a finding for each bracket that has no other.
void check_brackets(const PlacedWord& word, Findings& findings);

}  // namespace algae
