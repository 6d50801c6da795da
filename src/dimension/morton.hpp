#pragma once

#include <cstdint>

namespace algae {

/// The bits of a coordinate in the even places: 0b101 becomes 0b010001. Below 2^32.
///
/// Example: spread_bits(5) == 17
constexpr std::uint64_t spread_bits(std::uint64_t coordinate) {
    std::uint64_t bits = coordinate & 0xffffffffu;
    bits = (bits | bits << 16) & 0x0000ffff0000ffffu;
    bits = (bits | bits << 8) & 0x00ff00ff00ff00ffu;
    bits = (bits | bits << 4) & 0x0f0f0f0f0f0f0f0fu;
    bits = (bits | bits << 2) & 0x3333333333333333u;
    return (bits | bits << 1) & 0x5555555555555555u;
}

/// The place of a cell in Morton order (Morton 1966): the bits of column and row in turns. The four
/// cells of a square twice as wide follow each other, and so do the 64 of one eight times as wide.
struct Morton {
    static constexpr std::uint64_t columns = 0x5555555555555555u, rows = ~columns;

    std::uint64_t code = 0;

    constexpr Morton() = default;
    constexpr Morton(std::uint64_t column, std::uint64_t row)
        : code(spread_bits(column) | spread_bits(row) << 1) {}

    // A step to the next cell carries through the bits of one coordinate and leaves the other.
    constexpr void right() { code = (code & rows) | (((code | rows) + 1) & columns); }
    constexpr void left() { code = (code & rows) | (((code & columns) - 1) & columns); }
    constexpr void up() { code = (code & columns) | (((code | columns) + 1) & rows); }
    constexpr void down() { code = (code & columns) | (((code & rows) - 1) & rows); }
    bool operator==(const Morton&) const = default;
};

/// Which of the 16 quarters of an 8 by 8 tile hold a bit: bit k of the result stands for bits
/// 4 k to 4 k + 3, four cells that make one twice as wide.
///
/// Example: quarters(0xf0000000000000ffu) == 0x8003u
constexpr std::uint64_t quarters(std::uint64_t tile) {
    tile |= tile >> 1;
    tile |= tile >> 2;
    tile &= 0x1111111111111111u;
    tile = (tile | tile >> 3) & 0x0303030303030303u;
    tile = (tile | tile >> 6) & 0x000f000f000f000fu;
    tile = (tile | tile >> 12) & 0x000000ff000000ffu;
    return (tile | tile >> 24) & 0xffffu;
}

}  // namespace algae
