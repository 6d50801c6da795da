#include <algorithm>

#include "growth/letters.hpp"

namespace algae {

namespace {

/// A square matrix of zeros and ones, 64 to a word.
class BooleanMatrix {
public:
    explicit BooleanMatrix(const GrowthMatrix& matrix) : BooleanMatrix(matrix.size()) {
        for (std::size_t i = 0; i < size_; ++i)
            for (const auto& entry : matrix.rows[i]) set(i, entry.column);
    }

    friend BooleanMatrix operator*(const BooleanMatrix& left, const BooleanMatrix& right) {
        BooleanMatrix product(left.size_);
        for (std::size_t i = 0; i < left.size_; ++i)
            for (std::size_t k = 0; k < left.size_; ++k)
                if (left.has(i, k))
                    for (std::size_t w = 0; w < left.words_; ++w)
                        product.bits_[i * left.words_ + w] |= right.bits_[k * left.words_ + w];
        return product;
    }

    bool is_full() const {
        for (std::size_t i = 0; i < size_; ++i)
            for (std::size_t j = 0; j < size_; ++j)
                if (!has(i, j)) return false;
        return true;
    }
    void add_identity() {
        for (std::size_t i = 0; i < size_; ++i) set(i, i);
    }

private:
    explicit BooleanMatrix(std::size_t size) : size_(size), words_((size + 63) / 64), bits_(size * words_, 0) {}
    bool has(std::size_t i, std::size_t j) const { return (bits_[i * words_ + j / 64] >> (j % 64) & 1) != 0; }
    void set(std::size_t i, std::size_t j) { bits_[i * words_ + j / 64] |= std::uint64_t{1} << (j % 64); }

    std::size_t size_, words_;
    std::vector<std::uint64_t> bits_;
};

/// Whether some power not beyond size - 1 of matrix + 1 is full.
bool is_irreducible(const GrowthMatrix& matrix) {
    BooleanMatrix power(matrix);
    if (matrix.size() == 1) return power.is_full();
    power.add_identity();
    for (std::size_t steps = 1; steps < matrix.size(); steps *= 2) power = power * power;
    return power.is_full();
}

}  // namespace

Primitivity primitivity(const GrowthMatrix& matrix) {
    Primitivity found;
    const std::uint64_t size = matrix.size();
    if (size == 0) return found;
    found.irreducible = is_irreducible(matrix);
    if (!found.irreducible) return found;
    // Once a power is full all later ones are, and Wielandt's bound says when it must be.
    const std::uint64_t bound = (size - 1) * (size - 1) + 1;
    std::vector<BooleanMatrix> doubled{BooleanMatrix(matrix)};
    while ((std::uint64_t{1} << (doubled.size() - 1)) < bound && !doubled.back().is_full())
        doubled.push_back(doubled.back() * doubled.back());
    if (!doubled.back().is_full()) return found;
    if (doubled.size() == 1) {
        found.exponent = 1;
        return found;
    }
    doubled.pop_back();  // the largest power of two that is not enough, and what must be added to it
    BooleanMatrix power = doubled.back();
    std::uint64_t exponent = std::uint64_t{1} << (doubled.size() - 1);
    for (std::size_t k = doubled.size() - 1; k-- > 0;) {
        BooleanMatrix next = power * doubled[k];
        if (next.is_full()) continue;
        power = std::move(next);
        exponent += std::uint64_t{1} << k;
    }
    found.exponent = exponent + 1;
    return found;
}

}  // namespace algae
