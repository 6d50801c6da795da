#pragma once

#include <map>
#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "notation/findings.hpp"
#include "notation/lexicon.hpp"
#include "notation/source.hpp"
#include "notation/clauses.hpp"
#include "system/lsystem.hpp"

namespace algae {

/// A system on its way from a text: what the readers of the single statements share.
struct Reading {
    const Source& source;
    Findings& findings;
    Lexicon& lexicon;
    LSystem& system;

    std::unordered_map<std::string, std::size_t> constants;  // to their index in the system
    std::unordered_set<std::string> broken;  // names whose statement was wrong: no further findings
    std::map<std::string, const char*, std::less<>> given;  // settings so far
    std::unordered_set<std::string> tables;                 // opened so far
    bool broken_rules = false;                              // some rule could not be read
    bool is_inner = false;                                  // it is a system within another
    std::vector<Expression> distances = {};                 // in conditions, until all symbols are known

    const Quantity* constant(const std::string& name) const;

    /// The value of an expression over constants. Throws `SyntaxError` or `DependsOnError`.
    Quantity quantity(const Expression& expression) const;

    /// Adds a finding for each name in the expression that is neither a constant nor one of these
    /// parameters, and for each distance unless the expression is `of_boxes`, a condition of a shape rule.
    void check_names(const Expression& expression, const std::vector<std::string>& parameters,
                     bool of_boxes = false);

    /// Adds a finding unless the expression has the same value everywhere: an argument in a word in
    /// quotes.
    void check_fixed(const Expression& expression);

    /// Adds a finding for each distance to something that is no symbol of the system.
    void check_distances();
};

}  // namespace algae
