#pragma once

// Sets of lengths: of the words of regular languages over one letter, and what tables make of them.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "exact/exact.hpp"
#include "language/detail/regular.hpp"
#include "word/word.hpp"

namespace algae {

/// The lengths of the words of a regular language over one letter: from `tail` on, a length is in it if the length `period` below is.
struct LengthSet {
    Symbol letter = 0;
    std::size_t tail = 0, period = 1;  // as small as they can be
    std::vector<char> has;             // by length, below tail + period

    /// The number below tail + period that is in all multiples and sums of lengths as good as this one.
    std::size_t class_of(std::size_t length) const {
        return length < has.size() ? length : tail + (length - tail) % period;
    }
    bool contains(std::size_t length) const { return has[class_of(length)] != 0; }
    /// Whether long lengths that leave this rest are in it when they are divided by the period.
    bool contains_long(std::size_t rest) const { return contains(rest % period + tail * period); }
};

/// Nothing if two letters stand in words, or none does. Linear time.
///
/// Example: lengths_of(plus(finite_set({{0, 0}})))->period == 2
std::optional<LengthSet> lengths_of(const RegularLanguage& language);

/// Numbers from 0 to some greatest one, by bits.
class Numbers {
public:
    explicit Numbers(std::size_t greatest) : size_(greatest + 1), bits_(greatest / 64 + 1) {}

    std::size_t size() const { return size_; }
    bool at(std::size_t number) const { return (bits_[number / 64] >> (number % 64) & 1) != 0; }
    void set(std::size_t number) { bits_[number / 64] |= std::uint64_t{1} << (number % 64); }
    bool empty() const {
        return std::all_of(bits_.begin(), bits_.end(),
                           [](std::uint64_t each) { return each == 0; });
    }
    /// Adds the numbers of another one, all greater by `by`; those beyond the greatest are left out.
    void add(const Numbers& other, std::size_t by = 0) {
        const std::size_t words = by / 64, rest = by % 64;
        for (std::size_t i = bits_.size(); i-- > words;) {
            std::uint64_t moved = other.bits_[i - words] << rest;
            if (rest > 0 && i > words) moved |= other.bits_[i - words - 1] >> (64 - rest);
            bits_[i] |= moved;
        }
        if (size_ % 64 != 0) bits_.back() &= (std::uint64_t{1} << (size_ % 64)) - 1;
    }
    /// Takes out all numbers up to this one.
    void clear_up_to(std::size_t number) {
        std::fill(bits_.begin(), bits_.begin() + static_cast<std::ptrdiff_t>(number / 64), 0);
        bits_[number / 64] &= number % 64 == 63 ? 0 : ~std::uint64_t{0} << (number % 64 + 1);
    }
    bool operator==(const Numbers&) const = default;

private:
    std::size_t size_;
    std::vector<std::uint64_t> bits_;
};

/// The lengths of the successors of the letter by a table: some numbers and, if `step` is not 0, all that are greater than one of
/// `endless` by a multiple of it.
struct LengthTable {
    std::vector<std::size_t> lengths;  // increasing
    std::vector<std::size_t> endless = {};
    std::size_t step = 0;
};

/// The lengths up to `limit` that the table makes of a shorter one in the set, which is `least` or more.
/// O(limit^2 * lengths of the table / 64), and less where no rule erases.
Numbers from_shorter(const LengthSet& set, const LengthTable& table, std::size_t limit,
                     std::size_t least, const Budget& budget = {});

/// That tables make all lengths of the set but those of `base` from shorter ones in the set. Up to `from` they are worked out one by one. If a
/// table makes s of x, it makes s + p k of x + p, for each length k > 0 that it has and the period p if x is in the tail's cycle; so up to
/// `from` some of the tables make one length of each rest that such longer ones have.
struct LengthInduction {
    std::vector<std::size_t> base;  // increasing
    std::size_t from = 0;
    std::vector<std::size_t> tables;
};

/// Nothing if more than `most` lengths are not made from shorter ones, or if the number `from` is not found below `limit`.
std::optional<LengthInduction> length_induction(const LengthSet& set,
                                                const std::vector<LengthTable>& tables,
                                                std::size_t most, std::size_t limit = 20'000,
                                                const Budget& budget = {});

}  // namespace algae
