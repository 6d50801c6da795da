#pragma once

#include <optional>
#include <string_view>

namespace algae {

/// A system within another as its text has it: `system leaf { axiom F; F -> F[+F] }`.
struct SystemBlock {
    std::string_view name;
    std::string_view body;  // between the braces; up to the end of the text if they do not match
    bool closed = true;
};

/// The block at the start of a text, if there is one, and how many bytes it takes: up to the brace that
/// matches its first, those in comments not counted. Linear in the bytes of the block.
std::optional<SystemBlock> system_block(std::string_view text, std::size_t& bytes);

}  // namespace algae
