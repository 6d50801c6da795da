#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace algae {

/// The colours of pictures in at most 256: exactly if they have no more. Otherwise the colour there
/// is most of stays as it is, and the others are cut into 255 groups of similar ones, each time the
/// group with the largest squared error where its values are widest spread, at their mean (Wan, Wong
/// and Prusinkiewicz 1988). Colours that are rare count more than by their number, so that thin lines
/// keep theirs. The table depends on how many pixels have which colour, not on their order.
class ColourTable {
public:
    static constexpr std::uint64_t memory = std::uint64_t{4} << 24;  // bytes that a table takes

    ColourTable() : table_(std::size_t{1} << 24) {}

    /// Counts pixels 0xRRGGBB; what is above that is ignored.
    void count(std::span<const std::uint32_t> pixels);
    /// Chooses the colours; afterwards nothing is counted any more. O(colours * log) time.
    void choose();

    /// 0xRRGGBB, at least one.
    const std::vector<std::uint32_t>& colours() const { return colours_; }
    /// Whether every pixel has its own colour in the table.
    bool is_exact() const { return exact_; }
    /// The place in the table for a pixel that was counted.
    std::uint8_t index(std::uint32_t pixel) const {
        return static_cast<std::uint8_t>(table_[pixel & 0xffffffu]);
    }

private:
    std::vector<std::uint32_t> table_;  // by colour: how many, later its place
    std::vector<std::uint32_t> colours_;
    bool exact_ = true;
};

}  // namespace algae
