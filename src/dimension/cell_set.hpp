#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/budget.hpp"
#include "dimension/morton.hpp"

namespace algae {

/// A set of cells as bits, in tiles of 8 by 8 cells in Morton order. Dense where all tiles are kept,
/// sparse where only tiles that hold something are, in a hash table. Marking takes a few
/// nanoseconds; both give the same counts.
class CellSet {
public:
    enum class Storage { dense, sparse };

    /// How many columns and rows a dense set should have at most: 2^13, 8 MB of bits.
    static constexpr int most_dense_bits = 13;

    /// For columns and rows from 0 to 2^bits - 1, bits at most 31. Throws BoundReached if a dense
    /// set would take more than the budget's memory; a sparse one throws from `mark`.
    CellSet(int bits, Storage storage, const Budget& budget);

    Storage storage() const { return storage_; }

    void mark(Morton cell) {
        const std::uint64_t tile = cell.code >> 6;
        if (storage_ == Storage::dense)
            words_[tile] |= std::uint64_t{1} << (cell.code & 63);
        else
            mark_sparse(tile, std::uint64_t{1} << (cell.code & 63));
    }

    /// How many cells are marked; then in squares of 2 by 2 of them, of 4 by 4, and so on:
    /// `halvings` + 1 numbers. Empties the set. O(tiles).
    std::vector<std::uint64_t> take_counts(int halvings);

    /// The bytes that the set takes.
    std::uint64_t memory() const {
        return (words_.capacity() + keys_.capacity()) * sizeof(std::uint64_t);
    }

private:
    static constexpr std::uint64_t nobody = ~std::uint64_t{0};

    void mark_sparse(std::uint64_t tile, std::uint64_t bit) {
        if (tile != last_tile_) {
            last_slot_ = slot(tile);
            last_tile_ = tile;
        }
        words_[last_slot_] |= bit;
    }
    /// Where the tile is in the table, put in if it was not.
    std::size_t slot(std::uint64_t tile);
    std::size_t home(std::uint64_t tile) const {
        return static_cast<std::size_t>((tile * 0x9E3779B97F4A7C15u) >> shift_);
    }
    void grow();
    /// Leaves the tiles that hold something in Morton order, at the front of both lists.
    void sort_tiles();

    Storage storage_;
    Budget budget_;
    std::vector<std::uint64_t> words_;
    std::vector<std::uint64_t> keys_;  // of tiles, where sparse
    std::size_t tiles_ = 0;
    int shift_ = 0;  // the top bits of a hash are the place
    std::uint64_t last_tile_ = nobody;
    std::size_t last_slot_ = 0;
};

}  // namespace algae
