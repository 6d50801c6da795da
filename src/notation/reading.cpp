#include "notation/reading.hpp"

#include <algorithm>

#include "notation/characters.hpp"
#include "notation/suggestion.hpp"

namespace algae {

const Quantity* Reading::constant(const std::string& name) const {
    const auto found = constants.find(name);
    return found == constants.end() ? nullptr : &system.constants[found->second].second;
}

Quantity Reading::quantity(const Expression& expression) const {
    try {
        return evaluate(expression, [&](const std::string& name) {
            if (broken.count(name)) throw DependsOnError();
            return constant(name);
        });
    } catch (const Diagnostics& error) {
        const Diagnostic& finding = error.findings().front();
        throw SyntaxError{source.text().data() + source.offset(finding.place), finding.message};
    }
}

void Reading::check_names(const Expression& expression,
                          const std::vector<std::string>& parameters) {
    for (const Expression& operand : expression.operands) check_names(operand, parameters);
    if (expression.kind != Expression::Kind::name) return;
    const std::string& name = expression.name;
    if (std::find(parameters.begin(), parameters.end(), name) != parameters.end()) return;
    if (constants.count(name) || broken.count(name)) return;
    std::vector<std::string> candidates = parameters;
    constexpr std::size_t most = 1000;  // to choose from more would take long and help little
    if (constants.size() < most)
        for (const auto& [known, index] : constants) candidates.push_back(known);
    std::sort(candidates.begin(), candidates.end());
    findings.add(expression.place,
                 (parameters.empty() ? "expected a number or a constant, found "
                                     : "expected a parameter or a constant, found ") +
                     quoted(name) + did_you_mean(name, candidates));
}

}  // namespace algae
