#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "base/budget.hpp"
#include "growth/realise_specification.hpp"
#include "system/d0l.hpp"

namespace algae {

/// A D0L system with given lengths, or why there is none, or that none was found.
struct Realisation {
    enum class Kind { found, impossible, not_known };
    Kind kind = Kind::not_known;
    std::optional<D0L> system;  // of f; where that is impossible perhaps of f(n + shift)
    std::size_t shift = 0;
    std::size_t compared = 0;  // terms that were found equal, enough to prove it
    std::string because;
};

/// A D0L system with |h^n(w)| = f(n), without empty successors where that comes out at once.
///
/// Impossible if some term is not a natural number, or is 0 before one that is not: the empty word
/// stays empty. (A sequence of integers has a shortest recurrence with integer coefficients: Fatou 1906.)
///
/// Otherwise f is built in stages. Let E be the shift, c, c1, ..., ck natural numbers and f_i = (E-c)^i f.
/// If f_k = c1 f_(k-1) + ... + ck f_0 + g and g has a system with axiom u, then f has one: words w_i of
/// f_i(0) letters, each of a letter of its own and of letters that fill it up; the first becomes
/// w_i^c w_(i+1), the last of them w_(k-1)^c w_(k-1)^c1 ... w_0^ck u. (For c = 0 these are the locally
/// catenative systems of Rozenberg and Lindenmayer 1973 with an addend; for c = 1, c1 = ... = ck = 0
/// Newton's formula for polynomials.) A stage takes a divisor of the characteristic polynomial, times
/// a small polynomial, that has the form (x-c)^k - c1 (x-c)^(k-1) - ... - ck, and g has what is left. That
/// does it for every polynomial f with natural values above 0, after so many first words that the differences
/// are positive, unless a rule gets too long (20000 letters); for other sequences it is tried.
///
/// Whatever is found is compared with f on as many terms as the order of its recurrence and the number
/// of letters together: both sequences obey recurrences of these orders, so their difference obeys
/// one of the sum and is 0 if so many first terms are.
///
/// Example: realise(read_specification("1,1,2,3,5,8")).system->letters.size() == 2
Realisation realise(const SequenceSpecification& sequence, const Budget& budget = {});

}  // namespace algae
