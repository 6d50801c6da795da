#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "system/lsystem.hpp"
#include "system/view.hpp"

namespace algae {

/// A stochastic 0L system: a word, and for each letter words with probabilities, which add up to 1;
/// every letter of a word takes one of them, independently of the others (Eichhorst and Savitch
/// 1980; Prusinkiewicz and Lindenmayer 1990, 1.7).
struct S0L {
    std::shared_ptr<const Alphabet> alphabet;
    Word axiom;
    std::vector<std::vector<std::pair<Word, Rational>>> alternatives;  // by symbol; rules in order
    std::string name;
};

/// The system as a stochastic 0L system, if it is one: no contexts, conditions, parameters, tables
/// or terminals, and probabilities wherever a letter has a choice. A letter without a rule stays.
View<S0L> as_s0l(const LSystem& system);

}  // namespace algae
