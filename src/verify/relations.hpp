#pragma once

#include <functional>
#include <map>
#include <optional>

#include "base/budget.hpp"
#include "exact/integer.hpp"
#include "verify/boolean_matrix.hpp"
#include "verify/system.hpp"

namespace algae::verify {

/// What a letter, and all that it derives in some number of steps, does to the states of an automaton:
/// for each accessible letter the pairs of states that some derived word leads from one to the other.
using Relations = std::map<Symbol, BooleanMatrix>;

/// What a word does, where its letters do this.
BooleanMatrix relation_of(const Word& word, const Relations& relations, std::size_t states);

/// The relations of one more step, done first, by a table.
Relations one_step_earlier(const Relations& relations, const System::Successors& table,
                           std::size_t states);

/// Goes through the relations for all sequences of tables, beginning with `start` for none, until
/// nothing new comes; ends as soon as `stop` is true of one, and tells whether it was. Throws BoundReached
/// where they would take more than the budget's memory.
bool some_relations(const System& system, const Relations& start, std::size_t states,
                    const std::function<bool(const Relations&)>& stop, const Budget& budget);

/// The same for all sequences of exactly so many tables.
bool some_relations_after(const System& system, const Relations& start, std::size_t states,
                          const Integer& steps, const std::function<bool(const Relations&)>& stop,
                          const Budget& budget);

}  // namespace algae::verify
