#include "dimension/cell_set.hpp"

#include <algorithm>
#include <bit>
#include <numeric>
#include <tuple>
#include <utility>

namespace algae {

namespace {

constexpr int first_table_bits = 10;

std::uint64_t number_of_bits(const std::vector<std::uint64_t>& words, std::size_t count) {
    return std::accumulate(words.begin(), words.begin() + static_cast<std::ptrdiff_t>(count),
                           std::uint64_t{0}, [](std::uint64_t sum, std::uint64_t word) {
                               return sum + static_cast<unsigned>(std::popcount(word));
                           });
}

}  // namespace

CellSet::CellSet(int bits, Storage storage, const Budget& budget)
    : storage_(storage), budget_(budget) {
    if (storage == Storage::dense) {
        const std::uint64_t tiles = std::uint64_t{1} << 2 * std::max(bits - 3, 0);
        budget.check_memory(tiles * sizeof(std::uint64_t), "the bits for the cells of a grid");
        words_.assign(tiles, 0);
    } else {
        shift_ = 64 - first_table_bits;
        words_.assign(std::size_t{1} << first_table_bits, 0);
        keys_.assign(words_.size(), nobody);
    }
}

std::size_t CellSet::slot(std::uint64_t tile) {
    const std::size_t mask = keys_.size() - 1;
    std::size_t at = home(tile);
    while (keys_[at] != tile) {
        if (keys_[at] == nobody) {
            if (4 * (tiles_ + 1) > 3 * keys_.size()) {
                grow();
                return slot(tile);
            }
            ++tiles_;
            keys_[at] = tile;
            break;
        }
        at = (at + 1) & mask;
    }
    return at;
}

void CellSet::grow() {
    // While tiles move, the old table and the new one take memory.
    budget_.check_memory(memory() * 3, "the tiles for the cells of a grid");
    budget_.check();
    const std::vector<std::uint64_t> keys =
        std::exchange(keys_, std::vector(keys_.size() * 2, nobody));
    const std::vector<std::uint64_t> words =
        std::exchange(words_, std::vector(keys_.size(), std::uint64_t{0}));
    --shift_;
    const std::size_t mask = keys_.size() - 1;
    for (std::size_t i = 0; i < keys.size(); ++i) {
        if (keys[i] == nobody) continue;
        std::size_t at = home(keys[i]);
        while (keys_[at] != nobody) at = (at + 1) & mask;
        keys_[at] = keys[i];
        words_[at] = words[i];
    }
    last_tile_ = nobody;
}

void CellSet::sort_tiles() {
    std::vector<std::pair<std::uint64_t, std::uint64_t>> tiles;
    budget_.check_memory(memory() + tiles_ * sizeof(tiles[0]), "the tiles for the cells of a grid");
    tiles.reserve(tiles_);
    for (std::size_t i = 0; i < keys_.size(); ++i)
        if (keys_[i] != nobody) tiles.emplace_back(keys_[i], words_[i]);
    std::sort(tiles.begin(), tiles.end());
    for (std::size_t i = 0; i < tiles.size(); ++i) std::tie(keys_[i], words_[i]) = tiles[i];
}

std::vector<std::uint64_t> CellSet::take_counts(int halvings) {
    if (storage_ == Storage::sparse) sort_tiles();
    std::size_t count = storage_ == Storage::dense ? words_.size() : tiles_;
    std::vector<std::uint64_t> counts{number_of_bits(words_, count)};
    for (int i = 0; i < halvings; ++i) {
        // Four tiles that follow each other become one, at or before the place of the first.
        std::size_t kept = 0;
        for (std::size_t from = 0; from < count;) {
            std::uint64_t tile = 0;
            if (storage_ == Storage::dense) {
                for (int k = 0; k < 4 && from < count; ++k, ++from)
                    tile |= quarters(words_[from]) << 16 * k;
            } else {
                const std::uint64_t key = keys_[from] >> 2;
                for (; from < count && keys_[from] >> 2 == key; ++from)
                    tile |= quarters(words_[from]) << 16 * (keys_[from] & 3);
                keys_[kept] = key;
            }
            words_[kept++] = tile;
        }
        count = kept;
        counts.push_back(number_of_bits(words_, count));
    }
    std::fill(words_.begin(), words_.end(), 0);
    std::fill(keys_.begin(), keys_.end(), nobody);
    tiles_ = 0;
    last_tile_ = nobody;
    return counts;
}

}  // namespace algae
