#include "dimension/parameter_meanings.hpp"

#include <algorithm>
#include <set>

#include "base/error.hpp"

namespace algae {

namespace {

void collect_names(const Expression& expression, std::set<std::string>& into) {
    if (expression.kind == Expression::Kind::name) into.insert(expression.name);
    for (const Expression& operand : expression.operands) collect_names(operand, into);
}

}  // namespace

Step step_of(const Alphabet& alphabet, Symbol symbol) {
    const std::string& name = alphabet.name(symbol);
    if (name == "F" || name == "G" || name.starts_with("F_")) return Step::draw;
    if (name == "f" || name.starts_with("f_")) return Step::move;
    return Step::none;
}

ParameterMeanings::ParameterMeanings(const LSystem& system) {
    const auto visit = [&](const ModuleWord& word, const auto& see) {
        for (const auto& [at, arguments] : word.arguments) see(word.letters[at], arguments.size());
    };
    const auto visit_all = [&](const auto& see) {
        visit(system.axiom, see);
        for (const Production& rule : system.rules) {
            visit(rule.successor, see);
            if (!rule.predecessor.parameters.empty())
                see(rule.predecessor.symbol, rule.predecessor.parameters.size());
        }
    };
    visit_all([&](Symbol symbol, std::size_t arity) {
        const std::string& name = system.alphabet.name(symbol);
        if (name == "+" || name == "-") meanings_[{symbol, arity, 0}] = Meaning::number;
    });
    for (const Production& rule : system.rules) {
        if (!rule.condition) continue;
        std::set<std::string> names;
        collect_names(*rule.condition, names);
        const auto& parameters = rule.predecessor.parameters;
        for (std::size_t k = 0; k < parameters.size(); ++k)
            if (names.contains(parameters[k]))
                meanings_[{rule.predecessor.symbol, parameters.size(), k}] = Meaning::number;
    }
    spread(system, Meaning::number);
    visit_all([&](Symbol symbol, std::size_t arity) {
        if (step_of(system.alphabet, symbol) == Step::none) return;
        Meaning& meaning = meanings_[{symbol, arity, 0}];
        if (meaning == Meaning::number)
            throw Error("the length of " + system.alphabet.name(symbol) +
                        " decides what comes of it, so parts are not similar to the whole");
        meaning = Meaning::length;
    });
    spread(system, Meaning::length);
}

void ParameterMeanings::spread(const LSystem& system, Meaning meaning) {
    for (bool changed = true; changed;) {
        changed = false;
        for (const Production& rule : system.rules) {
            const auto& parameters = rule.predecessor.parameters;
            std::set<std::string> names;
            for (const auto& [at, arguments] : rule.successor.arguments)
                for (std::size_t k = 0; k < arguments.size(); ++k)
                    if (of(rule.successor.letters[at], arguments.size(), k) == meaning)
                        collect_names(arguments[k], names);
            for (std::size_t k = 0; k < parameters.size(); ++k) {
                if (!names.contains(parameters[k])) continue;
                Meaning& own = meanings_[{rule.predecessor.symbol, parameters.size(), k}];
                if (own != Meaning::none) continue;
                own = meaning;
                changed = true;
            }
        }
    }
}

ParameterMeanings::Meaning ParameterMeanings::of(Symbol symbol, std::size_t arity,
                                                 std::size_t place) const {
    const auto found = meanings_.find({symbol, arity, place});
    return found == meanings_.end() ? Meaning::none : found->second;
}

}  // namespace algae
