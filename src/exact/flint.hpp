#pragma once
// For the .cpp files of this room only: how they hand numbers to FLINT without copying them.

#include <flint/fmpz.h>
#include <flint/fmpz_mat.h>
#include <flint/fmpz_poly.h>
#include <flint/fmpz_vec.h>

#include <type_traits>
#include <utility>
#include <vector>

#include "exact/integer.hpp"
#include "exact/integer_matrix.hpp"
#include "exact/polynomial.hpp"
#include "exact/rational.hpp"

namespace algae {

static_assert(sizeof(Integer) == sizeof(fmpz) && std::is_standard_layout_v<Integer>,
              "an Integer is one fmpz, and a vector of them is FLINT's vector");

/// The words of our numbers as FLINT knows them.
struct FlintHandle {
    static fmpz* of(Integer& value) { return &value.word_; }
    static const fmpz* of(const Integer& value) { return &value.word_; }
    static fmpz* of(std::vector<Integer>& values) { return reinterpret_cast<fmpz*>(values.data()); }
    static const fmpz* of(const std::vector<Integer>& values) {
        return reinterpret_cast<const fmpz*>(values.data());
    }
    static Integer& numerator(Rational& value) { return value.numerator_; }
    static Integer& denominator(Rational& value) { return value.denominator_; }
    static const std::vector<Integer>& entries(const IntegerMatrix& matrix) {
        return matrix.entries_;
    }
    static std::vector<Integer>& entries(IntegerMatrix& matrix) { return matrix.entries_; }
};

inline fmpz* flint(Integer& value) { return FlintHandle::of(value); }
inline const fmpz* flint(const Integer& value) { return FlintHandle::of(value); }

/// A polynomial that FLINT reads where it lies.
struct PolynomialView {
    fmpz_poly_struct value[1];

    explicit PolynomialView(const Polynomial& polynomial) {
        const auto& coefficients = polynomial.coefficients();
        value->coeffs = const_cast<fmpz*>(FlintHandle::of(coefficients));
        value->length = static_cast<slong>(coefficients.size());
        value->alloc = value->length;
    }
};

/// A polynomial that FLINT writes.
struct FlintPolynomial {
    fmpz_poly_t value;

    FlintPolynomial() { fmpz_poly_init(value); }
    FlintPolynomial(const FlintPolynomial&) = delete;
    FlintPolynomial& operator=(const FlintPolynomial&) = delete;
    ~FlintPolynomial() { fmpz_poly_clear(value); }

    static Polynomial take(fmpz_poly_struct* from) {
        std::vector<Integer> coefficients(static_cast<std::size_t>(from->length));
        for (std::size_t i = 0; i < coefficients.size(); ++i)
            fmpz_swap(flint(coefficients[i]), from->coeffs + i);
        return Polynomial(std::move(coefficients));
    }
    /// Leaves zeros behind.
    Polynomial take() { return take(value); }
};

/// A matrix that FLINT reads where it lies.
struct MatrixView {
    std::vector<fmpz*> starts;
    fmpz_mat_struct value[1];

    explicit MatrixView(const IntegerMatrix& matrix) : starts(matrix.rows()) {
        auto* entries = const_cast<fmpz*>(FlintHandle::of(FlintHandle::entries(matrix)));
        for (std::size_t row = 0; row < starts.size(); ++row)
            starts[row] = entries + row * matrix.columns();
        value->entries = entries;
        value->r = static_cast<slong>(matrix.rows());
        value->c = static_cast<slong>(matrix.columns());
        value->rows = starts.data();
    }
};

/// A matrix that FLINT writes.
struct FlintMatrix {
    fmpz_mat_t value;

    FlintMatrix(std::size_t rows, std::size_t columns) {
        fmpz_mat_init(value, static_cast<slong>(rows), static_cast<slong>(columns));
    }
    FlintMatrix(const FlintMatrix&) = delete;
    FlintMatrix& operator=(const FlintMatrix&) = delete;
    ~FlintMatrix() { fmpz_mat_clear(value); }

    /// Leaves zeros behind.
    IntegerMatrix take() {
        IntegerMatrix matrix(static_cast<std::size_t>(value->r),
                             static_cast<std::size_t>(value->c));
        for (std::size_t row = 0; row < matrix.rows(); ++row)
            for (std::size_t column = 0; column < matrix.columns(); ++column)
                fmpz_swap(flint(matrix(row, column)), value->rows[row] + column);
        return matrix;
    }
};

}  // namespace algae
