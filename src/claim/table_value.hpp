#pragma once

#include <optional>
#include <string>

#include "base/budget.hpp"
#include "language/language.hpp"

namespace algae {

/// An ET0L system for the language of an expression, and by which constructions it was made, in a sentence.
struct TableValue {
    ET0L system;
    std::string argument;
};

/// Of a language of a system without context, that system; of operations under which E0L or ET0L languages are
/// closed, the system that the construction makes: with one table as long as the parts have one
/// and the operation keeps it, or with deterministic tables if that is asked for. Nothing where some part is
/// not known to be one. Throws what the constructions throw.
std::optional<TableValue> table_value(const Language& language, const Alphabet& alphabet,
                                      const Budget& budget = {}, bool deterministic = false);

}  // namespace algae
