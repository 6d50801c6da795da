#pragma once

#include <cstddef>
#include <cstdint>
#include <tuple>
#include <vector>

namespace algae::verify {

/// A relation on the numbers below `size`, row after row.
class BooleanMatrix {
public:
    explicit BooleanMatrix(std::size_t size = 0)
        : size_(size), words_((size + 63) / 64), bits_(size_of(size)) {}

    static BooleanMatrix identity(std::size_t size) {
        BooleanMatrix one(size);
        for (std::size_t i = 0; i < size; ++i) one.set(i, i);
        return one;
    }

    std::size_t size() const { return size_; }
    bool at(std::size_t row, std::size_t column) const {
        return (bits_[row * words_ + column / 64] >> (column % 64)) & 1;
    }
    void set(std::size_t row, std::size_t column) {
        bits_[row * words_ + column / 64] |= std::uint64_t{1} << (column % 64);
    }
    BooleanMatrix& operator|=(const BooleanMatrix& other) {
        for (std::size_t i = 0; i < bits_.size(); ++i) bits_[i] |= other.bits_[i];
        return *this;
    }
    /// This relation first, then the other.
    BooleanMatrix then(const BooleanMatrix& other) const {
        BooleanMatrix product(size_);
        for (std::size_t row = 0; row < size_; ++row)
            for (std::size_t middle = 0; middle < size_; ++middle)
                if (at(row, middle))
                    for (std::size_t k = 0; k < words_; ++k)
                        product.bits_[row * words_ + k] |= other.bits_[middle * words_ + k];
        return product;
    }
    std::size_t bytes() const { return sizeof(*this) + 8 * bits_.size(); }

    bool operator==(const BooleanMatrix&) const = default;
    bool operator<(const BooleanMatrix& other) const {
        return std::tie(size_, bits_) < std::tie(other.size_, other.bits_);
    }

private:
    static std::size_t size_of(std::size_t size) { return size * ((size + 63) / 64); }

    std::size_t size_;
    std::size_t words_;
    std::vector<std::uint64_t> bits_;
};

}  // namespace algae::verify
