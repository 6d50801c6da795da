#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <iosfwd>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "exact/integer.hpp"

namespace algae {

/// A matrix of integers, a value.
class IntegerMatrix {
public:
    IntegerMatrix() = default;
    /// The zero matrix.
    IntegerMatrix(std::size_t rows, std::size_t columns);
    /// Throws `Error` if the rows differ in length.
    ///
    /// Example: IntegerMatrix({{1, 1}, {1, 0}})(0, 1) == 1
    IntegerMatrix(std::initializer_list<std::initializer_list<Integer>> rows);
    explicit IntegerMatrix(const std::vector<std::vector<Integer>>& rows);

    static IntegerMatrix identity(std::size_t size);

    std::size_t rows() const { return rows_; }
    std::size_t columns() const { return columns_; }
    bool is_square() const { return rows_ == columns_; }
    bool is_zero() const;

    /// The entry in a row and a column, both counted from 0. Not checked.
    Integer& operator()(std::size_t row, std::size_t column) {
        return entries_[row * columns_ + column];
    }
    const Integer& operator()(std::size_t row, std::size_t column) const {
        return entries_[row * columns_ + column];
    }

    /// All three throw `Error` if the sizes do not fit.
    IntegerMatrix& operator+=(const IntegerMatrix& right);
    IntegerMatrix& operator-=(const IntegerMatrix& right);
    friend IntegerMatrix operator*(const IntegerMatrix& left, const IntegerMatrix& right);
    friend IntegerMatrix operator+(IntegerMatrix left, const IntegerMatrix& right) {
        return std::move(left += right);
    }
    friend IntegerMatrix operator-(IntegerMatrix left, const IntegerMatrix& right) {
        return std::move(left -= right);
    }
    friend bool operator==(const IntegerMatrix&, const IntegerMatrix&) = default;

private:
    friend struct FlintHandle;

    std::size_t rows_ = 0;
    std::size_t columns_ = 0;
    std::vector<Integer> entries_;  // row after row
};

/// The matrix times a column vector. Throws `Error` if the sizes do not fit.
///
/// Example: IntegerMatrix({{1, 1}, {1, 0}}) * std::vector<Integer>{3, 2} == std::vector<Integer>{5, 3}
std::vector<Integer> operator*(const IntegerMatrix& matrix, const std::vector<Integer>& vector);

/// A row vector times the matrix. Throws `Error` if the sizes do not fit.
std::vector<Integer> operator*(const std::vector<Integer>& vector, const IntegerMatrix& matrix);

/// The sum of the products of entries. Throws `Error` if the lengths differ.
Integer dot(const std::vector<Integer>& left, const std::vector<Integer>& right);

/// Example: transpose(IntegerMatrix({{1, 2}})) == IntegerMatrix({{1}, {2}})
IntegerMatrix transpose(const IntegerMatrix& matrix);

/// In log2(exponent) squarings. Throws `Error` if the matrix is not square or the exponent is
/// negative, `BoundReached` as soon as an entry is longer than `largest_bits` bits.
///
/// Example: power(IntegerMatrix({{1, 1}, {1, 0}}), 10)(0, 1) == 55
IntegerMatrix power(const IntegerMatrix& matrix, const Integer& exponent,
                    std::uint64_t largest_bits = std::uint64_t{1} << 30);

/// Throws `Error` if the matrix is not square.
Integer determinant(const IntegerMatrix& matrix);

/// The dimension of the space that the rows span over the rationals.
std::size_t rank(const IntegerMatrix& matrix);

/// The inverse of a square matrix over the rationals: `numerator` over `denominator`, the latter
/// positive, in lowest terms. Nothing where there is none. Throws `Error` if the matrix is not square.
struct RationalInverse {
    IntegerMatrix numerator;
    Integer denominator = 1;
};
///
/// Example: inverse(IntegerMatrix({{2, 0}, {0, 2}}))->denominator == 2
std::optional<RationalInverse> inverse(const IntegerMatrix& matrix);

/// A basis of the lattice that the rows span, in Hermite's normal form: as many rows as the rank,
/// pivots positive, entries above a pivot smaller than it and not negative (Cohen 1993, 2.4.2).
///
/// Example: lattice_basis(IntegerMatrix({{2, 4}, {3, 6}})) == IntegerMatrix({{1, 2}})
IntegerMatrix lattice_basis(const IntegerMatrix& rows);

/// A unimodular matrix that makes a basis (the rows, independent) one of short vectors: the product
/// of it and the rows is reduced in the sense of Lenstra, Lenstra and Lovasz (1982).
///
/// Example: reducing_matrix(IntegerMatrix({{1, 0}, {5, 1}})) * IntegerMatrix({{1, 0}, {5, 1}}) == IntegerMatrix({{1, 0}, {0, 1}})
IntegerMatrix reducing_matrix(const IntegerMatrix& rows);

/// "[1 1]\n[1 0]", for messages and tests.
std::string to_string(const IntegerMatrix& matrix);
std::ostream& operator<<(std::ostream& out, const IntegerMatrix& matrix);

}  // namespace algae
