#pragma once
// expect: whether what a file says must come out does.

#include <string>
#include <vector>

#include "base/budget.hpp"
#include "base/error.hpp"
#include "system/lsystem.hpp"

namespace algae {

/// An expectation of a file that does not hold: where it stands, what it expected, what was found.
struct Disappointment {
    Place place;
    std::string message;  // "expected length 3: 148, found 149"
};

/// The expectations of a system that do not hold, in file order.
///
/// Kinds: length N; lengths N (the set of lengths, for 0L systems); mean N (the expected length of a
/// stochastic 0L system, an exact fraction); word N; segments N, distinct N,
/// vertices N (drawn segments, different ones, different ends of them); end N (x y); box N (x y of
/// the lower left and the upper right corner); of figures in space x y z. A decimal stands for the value rounded to its
/// digits, in the parameters of a word too; a fraction there for the double nearest to it. Systems
/// with choices derive the word of the first seed of their setting `seed`, or of seed 1. The word of a
/// system of shape rules is that of its boxes' symbols. An unknown kind, and a
/// value that cannot be read, is a disappointment too.
std::vector<Disappointment> unmet_expectations(const LSystem& system, const Budget& budget = {});

}  // namespace algae
