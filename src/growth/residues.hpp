#pragma once

#include <cstdint>
#include <vector>

#include "exact/integer.hpp"

namespace algae {

/// A number from 0 to prime - 1.
using Residue = std::uint64_t;

/// The integers modulo a prime below 2^62.
class PrimeField {
public:
    explicit PrimeField(Residue prime) : prime_(prime) {}
    Residue prime() const { return prime_; }
    Residue residue(const Integer& value) const;
    Residue add(Residue left, Residue right) const {
        const Residue sum = left + right;
        return sum >= prime_ ? sum - prime_ : sum;
    }
    Residue subtract(Residue left, Residue right) const { return left >= right ? left - right : left + prime_ - right; }
    Residue multiply(Residue left, Residue right) const;
    Residue power(Residue base, std::uint64_t exponent) const;
    /// Of a number other than 0.
    Residue inverse(Residue value) const { return power(value, prime_ - 2); }

private:
    Residue prime_;
};

/// The largest prime below a number from 4 to 2^62.
///
/// Example: prime_below(100) == 97
Residue prime_below(Residue bound);

/// The monic polynomial, coefficients from the constant one upwards, of the shortest linear
/// recurrence of these terms (Berlekamp 1968, Massey 1969): for a sequence of order k, 2k terms
/// give it. O(terms^2).
///
/// Example: shortest_recurrence_modulo({1, 1, 2, 3, 5, 8}, PrimeField(101)) == std::vector<Residue>{100, 100, 1}
std::vector<Residue> shortest_recurrence_modulo(const std::vector<Residue>& terms, const PrimeField& field);

}  // namespace algae
