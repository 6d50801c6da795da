#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "base/budget.hpp"
#include "exact/ball.hpp"
#include "exact/polynomial.hpp"
#include "growth/number_field.hpp"
#include "growth/recurrence.hpp"

namespace algae {

/// What the roots r of one irreducible polynomial add to a sequence: the sum over all of them of
/// (c_0(r) + c_1(r) n + c_2(r) n^2 + ...) r^n.
struct ClosedFormTerm {
    Polynomial polynomial;                      // monic, irreducible, not x
    std::vector<AlgebraicNumber> coefficients;  // of the powers of n, in the field of r; the last one is not 0
};

/// a(n) as a sum of powers of algebraic numbers, from some n on; exactly.
class ClosedForm {
public:
    /// Coefficients in fields of at most this degree are polynomials in the root, of larger ones quotients.
    static constexpr long largest_written_degree = 8;

    /// By partial fractions of the generating function: the coefficients are its residues.
    explicit ClosedForm(const Recurrence& recurrence, const Budget& budget = {});

    /// By rising degree of the polynomials.
    const std::vector<ClosedFormTerm>& terms() const { return terms_; }
    /// The values that stand outside, those of n = 0, 1, ...: the form holds from there on.
    const std::vector<Integer>& exceptions() const { return exceptions_; }

    /// An enclosure of the value of the form for some n >= exceptions().size(), from enclosures of the
    /// roots with about this many bits.
    Ball value(std::uint64_t n, long bits) const;

    /// "(7*4^n - 4)/3", "((5+3*sqrt(5))/10)*((1+sqrt(5))/2)^n + ...", "sum over the roots r of
    /// x^3 - x - 1 of ((...)/23)*r^n", followed by ", for n >= 2" if there are exceptions.
    std::string text() const;

private:
    std::vector<ClosedFormTerm> terms_;
    std::vector<Integer> exceptions_;
};

/// Example: closed_form(d0l("F", {{'F', "F+F--F+F"}})).text() == "(7*4^n - 4)/3"
ClosedForm closed_form(const D0L& system, const Budget& budget = {});

/// A form as text; what `ClosedForm::text` calls.
std::string closed_form_text(const std::vector<ClosedFormTerm>& terms);

/// The roots of the polynomials of degree 3 and more that a form needs, each to 15 digits, one a
/// line: "r^3 = r + 1: r = 1.32471795724475, ...". Only polynomials of at most this degree.
std::vector<std::string> root_lines(const ClosedForm& form, long largest_degree = 12);

}  // namespace algae
