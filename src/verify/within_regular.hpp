#pragma once

#include "base/budget.hpp"
#include "verify/certificate.hpp"

namespace algae::verify {

/// Whether every word of the left language is in the right one, a regular expression. The left is an L(G),
/// worked out by what all that letters derive does to the derivatives of the right, until it repeats;
/// or made of such by union, image, reversal, and intersection and difference with regular expressions.
/// Throws Error if it is something else.
bool within_regular(const Language& left, const Language& right, const Alphabet& alphabet,
                    const Budget& budget);

}  // namespace algae::verify
