#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "growth/growth_matrix.hpp"
#include "system/d0l.hpp"

namespace algae {

/// For each letter of `D0L::letters` the least n with h^n(a) empty, if there is one: then the letter
/// is mortal. O(size of the rules).
///
/// Example: lifetimes(growth_matrix(d0l("a", {{'a', "ab"}, {'b', ""}})))[1] == 1
std::vector<std::optional<std::uint64_t>> lifetimes(const GrowthMatrix& matrix);

/// A letter a with h^power(a) = a v, for the least such power.
struct Prolongation {
    Symbol letter;
    std::uint64_t power;
    bool fixed;     // v is empty: h^power(a) = a
    bool infinite;  // v never dies: a, h^power(a), h^(2 power)(a), ... are prefixes of one infinite word,
                    // which h^power leaves as it is; a fixed point for power 1, otherwise a periodic one
    bool operator==(const Prolongation&) const = default;
};

/// All such letters, in the order of `D0L::letters`. The leftmost letter of h(a) that is not mortal
/// gives a map of letters; a must lie on one of its cycles, and what stands before it must have died
/// when the cycle closes.
///
/// Example: prolongations(d0l("a", {{'a', "ab"}, {'b', "a"}})).size() == 1
std::vector<Prolongation> prolongations(const D0L& system);

/// Whether every letter occurs in what each letter becomes at some time, and whether there is one
/// power of the morphism for which each becomes a word with all of them.
struct Primitivity {
    bool irreducible = false;
    std::optional<std::uint64_t> exponent;  // the least such power: then the morphism is primitive
};

/// By powers of the matrix of zeros and ones; the exponent by halving. O(letters^3 log(letters) / 64).
///
/// Example: primitivity(growth_matrix(d0l("a", {{'a', "ab"}, {'b', "a"}}))).exponent == 2
Primitivity primitivity(const GrowthMatrix& matrix);

}  // namespace algae
