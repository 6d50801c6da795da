#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "base/budget.hpp"
#include "rewrite/rewriting.hpp"
#include "system/s0l.hpp"

namespace algae {

/// By symbol, the expected number of its occurrences in generation n, exactly: the counts of the
/// axiom times the n-th power of the mean matrix, whose rows are the expected counts of what a
/// letter becomes (Prusinkiewicz and Lindenmayer 1990, 1.7; Harris 1963, II.2). n products of a
/// vector with the rules; numbers grow by O(1) digits a step.
///
/// Example: expected_counts(*as_s0l(read_lsystem("axiom F; F -(1/2)-> FF; F -(1/2)-> F", "")), 2)[0] == Rational(9, 4)
std::vector<Rational> expected_counts(const S0L& system, std::uint64_t n,
                                      const Budget& budget = {});

/// A word and how likely it is.
struct LikelyWord {
    ModuleString word;
    Rational probability;
};

/// All words of generation n with their exact probabilities, which add up to 1; shorter words first,
/// equally long ones by the names of their letters, then by their parameters. Rules without
/// probabilities that match together are an Error, unless the choices say that all are equally
/// likely. For systems with several tables each step takes the one in `tables`, without these that of the
/// schedule. There may be
/// exponentially many words of exponential length: throws BoundReached if they take more than
/// budget.memory, and otherwise as Rewriting::next does.
///
/// Example: distribution(Rewriting(read_lsystem("axiom F; F -(1/3)-> FF; F -(2/3)-> F", "")), 1)[1].probability == Rational(1, 3)
std::vector<LikelyWord> distribution(const Rewriting& rewriting, std::uint64_t n,
                                     const std::vector<std::size_t>& tables = {},
                                     const Budget& budget = {});
/// The same for the words that `from` derives, whose modules are numbered as those of the rewriting.
std::vector<LikelyWord> distribution(const Rewriting& rewriting, const ModuleString& from,
                                     std::uint64_t n, const std::vector<std::size_t>& tables = {},
                                     const Budget& budget = {});

}  // namespace algae
