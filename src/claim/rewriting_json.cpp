#include "claim/rewriting_json.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "rewrite/module_text.hpp"
#include "rewrite/program.hpp"

namespace algae {

namespace {

using Json = nlohmann::ordered_json;

/// What the names in the expressions of a rule stand for.
struct Scope {
    const LSystem& system;
    std::vector<std::string> parameters;

    std::optional<std::size_t> parameter(const std::string& name) const {
        const auto found = std::find(parameters.begin(), parameters.end(), name);
        if (found == parameters.end()) return std::nullopt;
        return static_cast<std::size_t>(found - parameters.begin());
    }
    const Quantity* constant(const std::string& name) const {
        for (const auto& [known, value] : system.constants)
            if (known == name) return &value;
        return nullptr;
    }
};

Json expression_json(const Expression& expression, const Scope& scope) {
    const auto parameter = [&](const std::string& name) { return scope.parameter(name); };
    if (!has_parameters(expression, parameter))
        return number_text(evaluate(expression, [&](const std::string& name) {
                               return scope.constant(name);
                           }).value);
    if (expression.kind == Expression::Kind::name) return {{"parameter", expression.name}};
    Json parts = Json::array();
    for (const Expression& operand : expression.operands)
        parts.push_back(expression_json(operand, scope));
    return {{"apply", expression.name}, {"to", std::move(parts)}};
}

Json word_json(const ModuleWord& word, const Scope& scope) {
    Json modules = Json::array();
    for (std::size_t i = 0; i < word.letters.size(); ++i) {
        Json module = Json::array({scope.system.alphabet.name(word.letters[i])});
        if (const auto found = word.arguments.find(i); found != word.arguments.end())
            for (const Expression& argument : found->second)
                module.push_back(expression_json(argument, scope));
        modules.push_back(std::move(module));
    }
    return modules;
}

Json pattern_json(const Pattern& pattern, Scope& scope) {
    Json modules = Json::array();
    for (const ModulePattern& module : pattern) {
        Json written = Json::array({scope.system.alphabet.name(module.symbol)});
        for (const std::string& name : module.parameters) {
            scope.parameters.push_back(name);
            written.push_back(name);
        }
        modules.push_back(std::move(written));
    }
    return modules;
}

Json rule_json(const Production& rule, const LSystem& system) {
    Scope scope{system, {}};
    Json result{{"module", pattern_json({rule.predecessor}, scope)[0]}};
    const auto add = [&](const char* name, const Pattern& pattern) {
        if (!pattern.empty()) result[name] = pattern_json(pattern, scope);
    };
    add("left", rule.left);
    add("right", rule.right);
    add("elsewhere", rule.elsewhere);
    if (rule.condition) result["condition"] = expression_json(*rule.condition, scope);
    if (rule.probability) result["probability"] = to_string(*rule.probability);
    result["successor"] = word_json(rule.successor, scope);
    return result;
}

}  // namespace

Json to_json(const LSystem& system) {
    Json rules = Json::array();
    for (const Production& rule : system.rules) rules.push_back(rule_json(rule, system));
    Json result{{"axiom", to_json(system.axiom, system)}, {"modules", std::move(rules)}};
    for (const Symbol letter : system.ignored)
        result["ignored"].push_back(system.alphabet.name(letter));
    return result;
}

Json to_json(const ModuleWord& word, const LSystem& system) {
    return word_json(word, Scope{system, {}});
}

}  // namespace algae
