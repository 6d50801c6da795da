#pragma once

#include <cstddef>
#include <string>
#include <utility>

#include "system/lsystem.hpp"

namespace algae {

/// What kind of L-system a file describes, as read off its rules. Nothing is derived.
struct Class {
    bool deterministic = true;  // at most one rule for a letter, arity and context in each table;
                                // rules with conditions are taken to exclude each other
    bool propagating = true;    // no rule has the empty successor
    bool stochastic = false;    // some rule has a probability
    bool parametric = false;    // some module has parameters, or some rule a condition
    bool bracketed = false;     // there are [ and ]
    bool extended = false;      // there are terminals
    bool open = false;          // there are communication modules
    bool shape = false;         // there are shape rules
    bool conditional = false;   // some rule has a context condition
    bool nested = false;        // there are systems within it, or words as parameters
    std::size_t tables = 0;
    std::pair<std::size_t, std::size_t> context = {0, 0};  // the longest left and right contexts

    /// The name of the class with the letters of Rozenberg and Salomaa: E extended, P propagating,
    /// D deterministic, T with tables, S stochastic; then 0L or (k,l)L; "parametric", "open",
    /// "shape", "with context conditions" and "with systems within" where they apply. "PD0L", "(1,0)L", "parametric D0L".
    std::string name() const;
};

/// O(size of the system).
Class class_of(const LSystem& system);

}  // namespace algae
