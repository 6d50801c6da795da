#include "exact/exact.hpp"

#include <algorithm>
#include <ostream>

#include "exact/detail/flint.hpp"

namespace algae {

namespace {

std::string size_of(std::size_t rows, std::size_t columns) {
    return std::to_string(rows) + " x " + std::to_string(columns);
}

std::string size_of(const IntegerMatrix& matrix) {
    return size_of(matrix.rows(), matrix.columns());
}

void require_same_size(const IntegerMatrix& left, const IntegerMatrix& right) {
    if (left.rows() != right.rows() || left.columns() != right.columns())
        throw Error("expected a " + size_of(left) + " matrix, found one of size " + size_of(right));
}

void require_square(const IntegerMatrix& matrix) {
    if (!matrix.is_square())
        throw Error("expected a square matrix, found one of size " + size_of(matrix));
}

void require_length(std::size_t expected, std::size_t found) {
    if (expected != found)
        throw Error("expected a vector of length " + std::to_string(expected) +
                    ", found one of length " + std::to_string(found));
}

std::uint64_t longest_entry(const IntegerMatrix& matrix) {
    std::uint64_t longest = 0;
    for (const Integer& entry : FlintHandle::entries(matrix))
        longest = std::max(longest, bit_length(entry));
    return longest;
}

/// No entry of the product has more bits than the sum of the longest entries and log2 of the length
/// of a row; where there is a zero matrix, the product is zero.
void require_product_below(std::uint64_t largest_bits, const IntegerMatrix& left,
                           const IntegerMatrix& right) {
    const std::uint64_t a = longest_entry(left);
    const std::uint64_t b = longest_entry(right);
    if (a != 0 && b != 0 && a + b > largest_bits)
        throw BoundReached(Bound::digits, "a product of matrices would have entries of about " +
                                              std::to_string(a + b) +
                                              " binary digits, more than the bound of " +
                                              std::to_string(largest_bits));
}

IntegerMatrix product(const IntegerMatrix& left, const IntegerMatrix& right) {
    FlintMatrix result(left.rows(), right.columns());
    fmpz_mat_mul(result.value, MatrixView(left).value, MatrixView(right).value);
    return result.take();
}

}  // namespace

IntegerMatrix::IntegerMatrix(std::size_t rows, std::size_t columns)
    : rows_(rows), columns_(columns), entries_(rows * columns) {}

IntegerMatrix::IntegerMatrix(std::initializer_list<std::initializer_list<Integer>> rows)
    : IntegerMatrix(std::vector<std::vector<Integer>>(rows.begin(), rows.end())) {}

IntegerMatrix::IntegerMatrix(const std::vector<std::vector<Integer>>& rows)
    : rows_(rows.size()), columns_(rows.empty() ? 0 : rows.front().size()) {
    entries_.reserve(rows_ * columns_);
    for (const auto& row : rows) {
        if (row.size() != columns_)
            throw Error("expected rows of " + std::to_string(columns_) + " entries, found one of " +
                        std::to_string(row.size()));
        entries_.insert(entries_.end(), row.begin(), row.end());
    }
}

IntegerMatrix IntegerMatrix::identity(std::size_t size) {
    IntegerMatrix matrix(size, size);
    for (std::size_t i = 0; i < size; ++i) matrix(i, i) = 1;
    return matrix;
}

bool IntegerMatrix::is_zero() const {
    return std::all_of(entries_.begin(), entries_.end(),
                       [](const Integer& x) { return x.is_zero(); });
}

IntegerMatrix& IntegerMatrix::operator+=(const IntegerMatrix& right) {
    require_same_size(*this, right);
    for (std::size_t i = 0; i < entries_.size(); ++i) entries_[i] += right.entries_[i];
    return *this;
}

IntegerMatrix& IntegerMatrix::operator-=(const IntegerMatrix& right) {
    require_same_size(*this, right);
    for (std::size_t i = 0; i < entries_.size(); ++i) entries_[i] -= right.entries_[i];
    return *this;
}

IntegerMatrix operator*(const IntegerMatrix& left, const IntegerMatrix& right) {
    if (left.columns() != right.rows())
        throw Error("expected a matrix of " + std::to_string(left.columns()) +
                    " rows, found one of size " + size_of(right));
    require_product_below(Integer::largest_bit_length, left, right);
    return product(left, right);
}

std::vector<Integer> operator*(const IntegerMatrix& matrix, const std::vector<Integer>& vector) {
    require_length(matrix.columns(), vector.size());
    std::vector<Integer> result(matrix.rows());
    for (std::size_t row = 0; row < matrix.rows(); ++row)
        for (std::size_t column = 0; column < matrix.columns(); ++column)
            if (!matrix(row, column).is_zero() && !vector[column].is_zero())
                result[row] += matrix(row, column) * vector[column];
    return result;
}

std::vector<Integer> operator*(const std::vector<Integer>& vector, const IntegerMatrix& matrix) {
    require_length(matrix.rows(), vector.size());
    std::vector<Integer> result(matrix.columns());
    for (std::size_t row = 0; row < matrix.rows(); ++row)
        for (std::size_t column = 0; column < matrix.columns(); ++column)
            if (!matrix(row, column).is_zero() && !vector[row].is_zero())
                result[column] += vector[row] * matrix(row, column);
    return result;
}

Integer dot(const std::vector<Integer>& left, const std::vector<Integer>& right) {
    require_length(left.size(), right.size());
    Integer sum;
    for (std::size_t i = 0; i < left.size(); ++i) sum += left[i] * right[i];
    return sum;
}

IntegerMatrix transpose(const IntegerMatrix& matrix) {
    IntegerMatrix result(matrix.columns(), matrix.rows());
    for (std::size_t row = 0; row < matrix.rows(); ++row)
        for (std::size_t column = 0; column < matrix.columns(); ++column)
            result(column, row) = matrix(row, column);
    return result;
}

IntegerMatrix power(const IntegerMatrix& matrix, const Integer& exponent,
                    std::uint64_t largest_bits) {
    require_square(matrix);
    if (sign(exponent) < 0)
        throw Error("expected an exponent from 0 upwards, found " + to_string(exponent));
    IntegerMatrix result = IntegerMatrix::identity(matrix.rows());
    for (std::uint64_t bit = bit_length(exponent); bit-- > 0;) {
        require_product_below(largest_bits, result, result);
        result = product(result, result);
        if (fmpz_tstbit(flint(exponent), static_cast<ulong>(bit)) != 0) {
            require_product_below(largest_bits, result, matrix);
            result = product(result, matrix);
        }
    }
    return result;
}

Integer determinant(const IntegerMatrix& matrix) {
    require_square(matrix);
    Integer result;
    fmpz_mat_det(flint(result), MatrixView(matrix).value);
    return result;
}

std::size_t rank(const IntegerMatrix& matrix) {
    return static_cast<std::size_t>(fmpz_mat_rank(MatrixView(matrix).value));
}

std::optional<RationalInverse> inverse(const IntegerMatrix& matrix) {
    require_square(matrix);
    FlintMatrix numerator(matrix.rows(), matrix.rows());
    Integer denominator;
    if (!fmpz_mat_inv(numerator.value, flint(denominator), MatrixView(matrix).value))
        return std::nullopt;
    RationalInverse found{numerator.take(), denominator};
    Integer common = found.denominator;
    for (const Integer& entry : FlintHandle::entries(found.numerator)) common = gcd(common, entry);
    if (sign(found.denominator) < 0) common.negate();
    found.denominator = exact_divide(found.denominator, common);
    for (Integer& entry : FlintHandle::entries(found.numerator))
        entry = exact_divide(entry, common);
    return found;
}

IntegerMatrix lattice_basis(const IntegerMatrix& rows) {
    FlintMatrix form(rows.rows(), rows.columns());
    fmpz_mat_hnf(form.value, MatrixView(rows).value);
    const IntegerMatrix all = form.take();
    const std::size_t size = rank(rows);
    IntegerMatrix basis(size, rows.columns());
    for (std::size_t row = 0; row < size; ++row)
        for (std::size_t column = 0; column < rows.columns(); ++column)
            basis(row, column) = all(row, column);
    return basis;
}

IntegerMatrix reducing_matrix(const IntegerMatrix& rows) {
    FlintMatrix reduced(rows.rows(), rows.columns());
    fmpz_mat_set(reduced.value, MatrixView(rows).value);
    FlintMatrix steps(rows.rows(), rows.rows());
    fmpz_mat_one(steps.value);
    fmpz_lll_t context;
    fmpz_lll_context_init_default(context);
    fmpz_lll(reduced.value, steps.value, context);
    return steps.take();
}

std::string to_string(const IntegerMatrix& matrix) {
    std::string text;
    for (std::size_t row = 0; row < matrix.rows(); ++row) {
        text += row == 0 ? "[" : "\n[";
        for (std::size_t column = 0; column < matrix.columns(); ++column)
            text += (column == 0 ? "" : " ") + to_string(matrix(row, column));
        text += ']';
    }
    return text;
}

std::ostream& operator<<(std::ostream& out, const IntegerMatrix& matrix) {
    return out << to_string(matrix);
}

}  // namespace algae
