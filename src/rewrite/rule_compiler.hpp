#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "rewrite/rule_set.hpp"

namespace algae {

/// Compiles one rule: its left side with what it asks for, and successors whose arguments are programs
/// over the parameters of that side.
class RuleCompiler {
public:
    /// Both must outlive the compiler.
    RuleCompiler(CompiledRules& rules, const Production& rule);

    /// The contexts, the condition and how many parameters there are; without alternatives.
    Alternatives left_side();
    /// A word over these parameters.
    Successor successor(const ModuleWord& word);

private:
    void add_names(const ModulePattern& module);
    bool is_bracket(ModuleKind kind) const;
    std::vector<ModuleKind> kinds(const Pattern& pattern);
    double literal(const ModuleWord& word);
    Program program(const Expression& expression, bool number);
    void add_value(const Expression& argument, Successor& out);
    std::size_t items_needed(const Program& holds) const;

    CompiledRules& rules_;
    const Production& rule_;
    std::vector<std::string> names_;
    std::vector<std::size_t> known_;  // after each module elsewhere, how many names there are
};

}  // namespace algae
