#pragma once

#include <set>
#include <utility>
#include <vector>

#include "language/finite_rules.hpp"

namespace algae {

/// The search for tables: all closed tables at once. A step from one word to another is possible in
/// some closed table or in none; steps are looked for only where they would lead into a set of words
/// that no table found so far reaches from outside.
class TableSearch {
public:
    explicit TableSearch(RuleSearch& rules) : rules_(rules) {}

    /// Closed tables that generate the language together, or nothing; then `obstruction` has the
    /// reason in `root` and `impossible`.
    std::vector<PossibleRules> tables(FamilyObstruction& obstruction);

private:
    using Pair = std::pair<std::uint32_t, FiniteWords::Image>;
    using Set = std::set<Pair>;

    void add(PossibleRules table);
    /// Adds a table with a step from outside into the set, if there is one.
    bool enter(const std::vector<std::uint32_t>& set, FamilyObstruction& obstruction);
    bool follow(std::uint32_t from, std::uint32_t to, std::size_t position, std::size_t done,
                Set& used, FamilyObstruction& obstruction);
    bool closes(const Set& used, PossibleRules& table, ObstructionCase& why);
    void rule_out(Set used, ObstructionCase why, FamilyObstruction& obstruction);
    bool is_impossible(const Set& used) const;

    RuleSearch& rules_;
    PossibleRules all_;
    StepRelation steps_;
    std::vector<PossibleRules> found_;
    std::vector<Set> impossible_;
};

}  // namespace algae
