#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "combinatorics/combinatorics.hpp"

namespace algae {

/// The suffixes of a word in lexicographic order, a prefix before what it begins. 12 bytes for each letter, and as many
/// as the word has while it is built.
class SuffixArray {
public:
    /// Throws Error beyond 2^31 - 2 bytes, where a letter takes one, or two if there are more than 256.
    SuffixArray(const Word& word, const Budget& budget);

    std::size_t size() const { return order_.size(); }
    /// Where the suffix of this rank begins.
    std::size_t operator[](std::size_t rank) const {
        return static_cast<std::size_t>(order_[rank]);
    }
    std::size_t rank(std::size_t begin) const { return static_cast<std::size_t>(ranks_[begin]); }
    /// The longest common prefix of the suffixes of this rank and of the one before, which rank 0 has not.
    std::size_t common(std::size_t rank) const { return static_cast<std::size_t>(common_[rank]); }

private:
    std::vector<std::int32_t> order_, ranks_, common_;
};

/// Where the least conjugate begins; the first place if there are several. O(n).
std::size_t least_rotation(const Word& word);

/// How long two suffixes are alike, in constant time: minima over ranks, of whole blocks by a table.
class CommonPrefixes {
public:
    explicit CommonPrefixes(const SuffixArray& suffixes);
    /// The length of the longest common prefix of the suffixes that begin there; the end of the word has the empty one.
    std::size_t operator()(std::size_t left, std::size_t right) const;

private:
    static constexpr std::size_t block = 32;

    std::size_t least_in(std::size_t first, std::size_t last) const;  // ranks, first <= last

    const SuffixArray& suffixes_;
    std::vector<std::vector<std::int32_t>> least_;  // least_[k][b]: of 2^k blocks from b on
};

}  // namespace algae
