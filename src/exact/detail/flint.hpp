#pragma once
// For the .cpp files of this room only: FLINT and Arb, and how they are handed numbers without copying them.

#include <flint/flint.h>
#include <flint/fmpq.h>
#include <flint/fmpz.h>
#include <flint/fmpz_lll.h>
#include <flint/fmpz_mat.h>
#include <flint/fmpz_poly.h>
#include <flint/fmpz_poly_factor.h>
#include <flint/fmpz_vec.h>

#if __FLINT_RELEASE >= 30000  // holds Arb
#include <flint/acb.h>
#include <flint/arb.h>
#include <flint/arb_fmpz_poly.h>
#else
#include <acb.h>
#include <arb.h>
#include <arb_fmpz_poly.h>
#endif

#include <type_traits>
#include <utility>
#include <vector>

#include "exact/exact.hpp"

namespace algae {

static_assert(sizeof(Integer) == sizeof(fmpz) && std::is_standard_layout_v<Integer>,
              "an Integer is one fmpz, and a vector of them is FLINT's vector");

/// The words of our numbers as FLINT knows them.
struct FlintHandle {
    static_assert(std::is_same_v<Integer::Word, fmpz>);
    static_assert(COEFF_MAX == Integer::small_limit && COEFF_MIN == -Integer::small_limit &&
                  COEFF_IS_MPZ(Integer::small_limit + 1));

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

/// A matrix that FLINT reads where it lies. FLINT finds the rows by pointers, from 3.3 by their distance.
struct MatrixView {
#if __FLINT_RELEASE < 30300
    std::vector<fmpz*> starts;
#endif
    fmpz_mat_struct value[1];

    explicit MatrixView(const IntegerMatrix& matrix) {
        auto* entries = const_cast<fmpz*>(FlintHandle::of(FlintHandle::entries(matrix)));
        value->entries = entries;
        value->r = static_cast<slong>(matrix.rows());
        value->c = static_cast<slong>(matrix.columns());
#if __FLINT_RELEASE >= 30300
        value->stride = value->c;
#else
        starts.reserve(matrix.rows());
        for (std::size_t row = 0; row < matrix.rows(); ++row)
            starts.push_back(entries + row * matrix.columns());
        value->rows = starts.data();
#endif
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
                fmpz_swap(flint(matrix(row, column)), fmpz_mat_entry(value, static_cast<slong>(row),
                                                                     static_cast<slong>(column)));
        return matrix;
    }
};

// For the .cpp files of this room only: what a Ball is made of.

struct Ball::Enclosure {
    arb_t value;

    Enclosure() { arb_init(value); }
    Enclosure(const Enclosure& other) {
        arb_init(value);
        arb_set(value, other.value);
    }
    Enclosure& operator=(const Enclosure&) = delete;
    ~Enclosure() { arb_clear(value); }
};

/// Access for this room: an enclosure to be written, and one to be read.
struct BallHandle {
    static arb_struct* of(Ball& value);
    static const arb_struct* of(const Ball& value);
};

inline arb_struct* arb(Ball& value) { return BallHandle::of(value); }
inline const arb_struct* arb(const Ball& value) { return BallHandle::of(value); }

/// A Ball for a result of this precision, 0 at first.
inline Ball ball(long bits) { return Ball(0, bits); }

}  // namespace algae
