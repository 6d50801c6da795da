#include "system/classes.hpp"

#include <algorithm>
#include <set>
#include <tuple>

namespace algae {

namespace {

bool has_parameters(const Pattern& pattern) {
    return std::any_of(pattern.begin(), pattern.end(), [](const ModulePattern& m) { return !m.parameters.empty(); });
}

/// The modules of a context; brackets only say where they stand.
std::size_t context_length(const Pattern& context, const Alphabet& alphabet) {
    return static_cast<std::size_t>(std::count_if(context.begin(), context.end(), [&](const ModulePattern& module) {
        const std::string& name = alphabet.name(module.symbol);
        return name != "[" && name != "]";
    }));
}

std::vector<Symbol> symbols(const Pattern& pattern) {
    std::vector<Symbol> found;
    for (const ModulePattern& module : pattern) found.push_back(module.symbol);
    return found;
}

/// Whether two rules could both apply to a letter. Equal rules written twice are one rule.
bool has_choice(const LSystem& system) {
    using Key = std::tuple<std::size_t, Symbol, std::size_t, std::vector<Symbol>, std::vector<Symbol>>;
    std::set<Key> seen;
    std::vector<const Production*> unconditional;
    for (const Production& rule : system.rules)
        if (!rule.condition && rule.elsewhere.empty()) unconditional.push_back(&rule);
    // Twice the same rule: sorted by what they rewrite, then compared.
    std::set<std::pair<Key, Word>> successors;
    for (const Production* rule : unconditional) {
        const Key key{rule->table, rule->predecessor.symbol, rule->predecessor.parameters.size(),
                      symbols(rule->left), symbols(rule->right)};
        const bool fresh_key = seen.insert(key).second;
        const bool fresh_rule = successors.insert({key, rule->successor.letters}).second;
        if (!fresh_key && (fresh_rule || rule->shape || !rule->successor.arguments.empty())) return true;
    }
    return false;
}

}  // namespace

Class class_of(const LSystem& system) {
    Class kind;
    kind.tables = system.tables.size();
    kind.extended = !system.terminals.empty();
    kind.bracketed = system.alphabet.find("[") && system.alphabet.find("]");
    kind.parametric = !system.axiom.arguments.empty();
    kind.deterministic = !has_choice(system);
    for (Symbol a = 0; a < system.alphabet.size(); ++a) {
        kind.open = kind.open || is_communication(system.alphabet.name(a));
    }
    for (const Production& rule : system.rules) {
        kind.propagating = kind.propagating && (rule.shape || !rule.successor.letters.empty());
        kind.stochastic = kind.stochastic || rule.probability;
        kind.parametric = kind.parametric || rule.condition || !rule.predecessor.parameters.empty() ||
                          !rule.successor.arguments.empty() || has_parameters(rule.left) || has_parameters(rule.right);
        kind.shape = kind.shape || rule.shape;
        kind.conditional = kind.conditional || !rule.elsewhere.empty();
        kind.context.first = std::max(kind.context.first, context_length(rule.left, system.alphabet));
        kind.context.second = std::max(kind.context.second, context_length(rule.right, system.alphabet));
    }
    kind.nested = holds_words(system);
    kind.parametric = kind.parametric || kind.nested;
    if (kind.stochastic) kind.deterministic = false;
    return kind;
}

std::string Class::name() const {
    std::string name;
    if (open) name += "open ";
    if (parametric) name += "parametric ";
    if (shape) name += "shape ";
    if (extended) name += 'E';
    if (propagating) name += 'P';
    if (deterministic) name += 'D';
    if (stochastic) name += 'S';
    if (tables > 0) name += 'T';
    name += context == std::pair<std::size_t, std::size_t>{0, 0}
                ? "0L"
                : '(' + std::to_string(context.first) + ',' + std::to_string(context.second) + ")L";
    if (conditional) name += " with context conditions";
    if (nested) name += conditional ? " and systems within" : " with systems within";
    return name;
}

}  // namespace algae
