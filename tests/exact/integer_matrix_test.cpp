#include "exact/exact.hpp"

#include <doctest/doctest.h>

#include "exact/any_numbers.hpp"

using namespace algae;

namespace {

IntegerMatrix schoolbook(const IntegerMatrix& left, const IntegerMatrix& right) {
    IntegerMatrix result(left.rows(), right.columns());
    for (std::size_t i = 0; i < left.rows(); ++i)
        for (std::size_t j = 0; j < right.columns(); ++j)
            for (std::size_t k = 0; k < left.columns(); ++k)
                result(i, j) += left(i, k) * right(k, j);
    return result;
}

/// Laplace's expansion along the first row.
Integer expansion(const IntegerMatrix& matrix) {
    if (matrix.rows() == 0) return 1;
    Integer sum;
    for (std::size_t k = 0; k < matrix.columns(); ++k) {
        IntegerMatrix minor(matrix.rows() - 1, matrix.rows() - 1);
        for (std::size_t i = 1; i < matrix.rows(); ++i)
            for (std::size_t j = 0; j < matrix.columns(); ++j)
                if (j != k) minor(i - 1, j < k ? j : j - 1) = matrix(i, j);
        sum += matrix(0, k) * expansion(minor) * (k % 2 == 0 ? 1 : -1);
    }
    return sum;
}

}  // namespace

TEST_CASE("products agree with the schoolbook") {
    CHECK(rc::check([] {
        const auto a = *rc::gen::inRange<std::size_t>(0, 6),
                   b = *rc::gen::inRange<std::size_t>(0, 6),
                   c = *rc::gen::inRange<std::size_t>(0, 6);
        const IntegerMatrix left = any_matrix(a, b), right = any_matrix(b, c);
        RC_ASSERT(left * right == schoolbook(left, right));
        RC_ASSERT(transpose(left * right) == transpose(right) * transpose(left));
        RC_ASSERT(left + left - left == left);
        std::vector<Integer> column(b), row(a);
        IntegerMatrix as_column(b, 1), as_row(1, a);
        for (std::size_t i = 0; i < b; ++i)
            as_column(i, 0) = column[i] = *rc::gen::arbitrary<Integer>();
        for (std::size_t i = 0; i < a; ++i) as_row(0, i) = row[i] = *rc::gen::arbitrary<Integer>();
        const auto product = left * column;
        for (std::size_t i = 0; i < a; ++i) RC_ASSERT(product[i] == (left * as_column)(i, 0));
        const auto other = row * left;
        for (std::size_t i = 0; i < b; ++i) RC_ASSERT(other[i] == (as_row * left)(0, i));
        RC_ASSERT(dot(row, left * column) == dot(row * left, column));
    }));
}

TEST_CASE("powers") {
    CHECK(rc::check("one factor at a time", [] {
        const auto size = *rc::gen::inRange<std::size_t>(0, 5);
        const IntegerMatrix matrix = any_matrix(size, size);
        IntegerMatrix expected = IntegerMatrix::identity(size);
        for (int n = 0; n < 8; ++n) {
            RC_ASSERT(power(matrix, n) == expected);
            expected = schoolbook(expected, matrix);
        }
    }));
    const IntegerMatrix fibonacci{{1, 1}, {1, 0}};
    CHECK(to_string(power(fibonacci, 300)(0, 1)) ==
          "222232244629420445529739893461909967206666939096499764990979600");
    const Integer f = power(fibonacci, 1000)(0, 1), g = power(fibonacci, 999)(0, 1);
    CHECK(abs(f * f - f * g - g * g) == 1);  // Cassini
    const IntegerMatrix cycle{{0, 1, 0}, {0, 0, 1}, {1, 0, 0}};
    CHECK(power(cycle, power(Integer(10), 100)) == cycle);
    CHECK_THROWS_AS(power(fibonacci, power(Integer(10), 100), 100000), BoundReached);
    CHECK_THROWS_AS(power(fibonacci, -1), Error);
    CHECK_THROWS_AS(power(IntegerMatrix(2, 3), 2), Error);
}

TEST_CASE("determinant and rank") {
    CHECK(rc::check("expansion along a row", [] {
        const auto size = *rc::gen::inRange<std::size_t>(0, 5);
        const IntegerMatrix matrix = any_matrix(size, size);
        const Integer value = determinant(matrix);
        RC_ASSERT(value == expansion(matrix));
        RC_ASSERT((rank(matrix) == size) == (value != 0));
        RC_ASSERT(rank(transpose(matrix)) == rank(matrix));
    }));
    CHECK(rank(IntegerMatrix({{1, 2, 3}, {2, 4, 6}})) == 1);
    CHECK(rank(IntegerMatrix(3, 2)) == 0);
}

TEST_CASE("sizes that do not fit are refused") {
    CHECK_THROWS_WITH_AS(IntegerMatrix(2, 3) * IntegerMatrix(2, 3),
                         "expected a matrix of 3 rows, found one of size 2 x 3", Error);
    CHECK_THROWS_AS(IntegerMatrix(2, 3) + IntegerMatrix(3, 2), Error);
    CHECK_THROWS_AS(determinant(IntegerMatrix(2, 3)), Error);
    CHECK_THROWS_AS(IntegerMatrix(2, 3) * std::vector<Integer>(2), Error);
    CHECK_THROWS_AS((IntegerMatrix{{1, 2}, {3}}), Error);
    CHECK(to_string(IntegerMatrix{{1, -2}, {3, 4}}) == "[1 -2]\n[3 4]");
}

TEST_CASE("an inverse over the rationals") {
    const IntegerMatrix matrix({{2, 1}, {1, 3}});
    const auto found = inverse(matrix);
    REQUIRE(found);
    CHECK(found->denominator == 5);
    CHECK(found->numerator * matrix == IntegerMatrix({{5, 0}, {0, 5}}));
    CHECK_FALSE(inverse(IntegerMatrix({{1, 2}, {2, 4}})));
    CHECK(inverse(IntegerMatrix({{-1}}))->numerator == IntegerMatrix({{-1}}));
    CHECK_THROWS_AS(inverse(IntegerMatrix({{1, 2}})), Error);
}

TEST_CASE("bases of lattices, and short ones") {
    CHECK(lattice_basis(IntegerMatrix({{4, 0}, {6, 0}, {0, 5}})) ==
          IntegerMatrix({{2, 0}, {0, 5}}));
    CHECK(lattice_basis(IntegerMatrix({{0, 0}})).rows() == 0);
    const IntegerMatrix rows({{1, 100}, {0, 1}});
    const IntegerMatrix steps = reducing_matrix(rows);
    CHECK(abs(determinant(steps)) == 1);
    const IntegerMatrix reduced = steps * rows;
    for (std::size_t i = 0; i < 2; ++i)
        for (std::size_t j = 0; j < 2; ++j) CHECK(abs(reduced(i, j)) <= 1);
}
