#pragma once

#include "verify/proofs.hpp"

namespace algae::verify {

/// Checks that L(G) is infinite by five courses of steps, each of one letter by a table: `before` leads from a
/// letter of the axiom to the letter `again`; `round` from there to itself, and `beside`, which is the same step
/// as `round` at some point but for the place, by the same tables to `other`; `kept` by the same tables from
/// `other` to itself; `after` from `other` to a terminal. All letters beside them can finish: derive words
/// of terminals by the tables that follow. So n rounds give a word of L(G) with n letters and more.
void check_endless_tables(const Checking& with, const Language& language, const Field& proof);

}  // namespace algae::verify
