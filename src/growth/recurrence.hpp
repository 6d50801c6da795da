#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/budget.hpp"
#include "exact/polynomial.hpp"
#include "growth/growth_matrix.hpp"
#include "system/d0l.hpp"

namespace algae {

/// A sequence of integers that obeys a linear recurrence with constant integer coefficients from
/// some index on, given by the shortest one.
struct Recurrence {
    /// q, monic, q(0) not 0: a(n+k) + q_(k-1) a(n+k-1) + ... + q_0 a(n) == 0 for n >= exceptions;
    /// 1 where the sequence is 0 from `exceptions` on.
    Polynomial polynomial = 1;
    /// How many first values stand outside: the multiplicity of the root 0.
    std::size_t exceptions = 0;
    /// a(0), ..., a(exceptions + order - 1): what the recurrence starts from.
    std::vector<Integer> initial;

    std::size_t order() const { return static_cast<std::size_t>(polynomial.degree()); }
    /// The first n for which a(n) follows from the values before it.
    std::size_t holds_from() const { return exceptions + order(); }
    /// The first values. O(count * order) products.
    std::vector<Integer> values(std::size_t count) const;
    /// "a(n) = 5a(n-1) - 4a(n-2)"; "a(n) = 0" of order 0.
    std::string text() const;

    bool operator==(const Recurrence&) const = default;
};

/// The shortest recurrence of the lengths of the words. Its order is at most the number of
/// accessible letters, so twice as many terms decide it (Salomaa and Soittola 1978, II.3).
///
/// Example: shortest_recurrence(d0l("F", {{'F', "F+F--F+F"}})).text() == "a(n) = 5a(n-1) - 4a(n-2)"
Recurrence shortest_recurrence(const D0L& system, const Budget& budget = {});
/// The same of the numbers row * matrix^n * column.
Recurrence shortest_recurrence(const std::vector<Integer>& row, const GrowthMatrix& matrix,
                               const std::vector<Integer>& column, const Budget& budget = {});

/// The power series with these coefficients as a quotient in lowest terms; the constant term of the
/// denominator is 1.
struct GeneratingFunction {
    Polynomial numerator;
    Polynomial denominator;
    bool operator==(const GeneratingFunction&) const = default;
};

/// Example: generating_function(shortest_recurrence(d0l("b", {{'a', "ab"}, {'b', "a"}}))).denominator == Polynomial({1, -1, -1})
GeneratingFunction generating_function(const Recurrence& recurrence);

/// "(1 + 3x)/(1 - 5x + 4x^2)", in order of rising powers, as power series are written.
std::string to_string(const GeneratingFunction& function);

}  // namespace algae
