#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "exact/rational.hpp"

namespace algae {

/// A sequence f(0), f(1), ... given by its first values and f(n) = c1 f(n-1) + ... + ck f(n-k) for
/// n >= initial.size(), which is k or more.
struct SequenceSpecification {
    std::vector<Rational> coefficients;  // c1, ..., ck
    std::vector<Rational> initial;
    std::size_t terms = 0;  // how many terms the recurrence was found from; 0 where it was given

    /// f(0), ..., f(count - 1).
    std::vector<Rational> values(std::size_t count) const;
    /// "a(n) = a(n-1) + a(n-2) for n >= 2; 1, 1".
    std::string text() const;
};

/// The shortest recurrence of a list of terms, with the fewest terms before it holds (Berlekamp 1968,
/// Massey 1969, over the rationals). It is the only one of its order exactly if there are at
/// least twice as many terms as `initial` has.
///
/// Example: recurrence_of_terms({1, 1, 2, 3, 5, 8}).coefficients == std::vector<Rational>{1, 1}
SequenceSpecification recurrence_of_terms(const std::vector<Rational>& terms);

/// The same sequence, with its shortest recurrence.
SequenceSpecification reduced(const SequenceSpecification& sequence);

/// f(n + shift).
SequenceSpecification shifted(const SequenceSpecification& sequence, std::size_t shift);

/// What a person wrote: terms "1,1,2,3,5,8", at the end "..." if they like; a recurrence with first values,
/// "a(n) = a(n-1) + a(n-2); 1, 1"; or a polynomial in n, "(n^3+5n+6)/6". Throws Error that names the place.
///
/// Example: read_specification("n^2+1").values(4) == std::vector<Rational>{1, 2, 5, 10}
SequenceSpecification read_specification(const std::string& text);

}  // namespace algae
