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
                          const std::vector<std::string>& parameters, bool of_boxes) {
    if (is_distance(expression)) {
        if (of_boxes)
            distances.push_back(expression);
        else
            findings.add(expression.place,
                         "expected no distance but in the condition of a shape rule, found " +
                             quoted(to_text(expression)));
        return;
    }
    if (expression.kind == Expression::Kind::word) {
        for (const auto& [position, arguments] : expression.word->arguments)
            for (const Expression& argument : arguments) check_fixed(argument);
        return;
    }
    for (const Expression& operand : expression.operands)
        check_names(operand, parameters, of_boxes);
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

void Reading::check_fixed(const Expression& expression) {
    if (expression.kind == Expression::Kind::word || !reads_words(expression))
        return check_names(expression, {});
    findings.add(expression.place, "expected a number or a word in quotes, found " +
                                       quoted(to_text(expression)));
}

void Reading::check_distances() {
    for (const Expression& distance : distances) {
        const Expression& symbol = distance.operands.at(1);
        if (lexicon.known(symbol.name)) continue;
        std::vector<std::string> candidates;
        constexpr std::size_t most = 1000;
        for (Symbol known = 0; known < std::min(most, system.alphabet.size()); ++known)
            candidates.push_back(system.alphabet.name(known));
        findings.add(symbol.place, "expected a symbol of the system, found " + quoted(symbol.name) +
                                       did_you_mean(symbol.name, candidates));
    }
}

}  // namespace algae
