#include "claim/rewriting_text.hpp"

#include <utility>

#include "system/classes.hpp"
#include "word/spelling.hpp"

namespace algae {

namespace {

std::string word_text(const Alphabet& alphabet, const ModuleWord& word) {
    if (word.letters.empty()) return "ε";
    std::string text;
    for (std::size_t i = 0; i < word.letters.size(); ++i) {
        const auto arguments = word.arguments.find(i);
        const bool long_names = alphabet.name(word.letters[i]).size() > 1;
        if (i > 0 && long_names && text.back() != ')') text += ' ';
        text += alphabet.name(word.letters[i]);
        if (arguments == word.arguments.end()) continue;
        std::string list;
        for (const Expression& argument : arguments->second)
            list += (list.empty() ? "" : ",") + to_text(argument);
        text += "(" + list + ")";
    }
    return text;
}

std::string pattern_text(const Alphabet& alphabet, const Pattern& pattern, const char* between) {
    std::string text;
    for (const ModulePattern& module : pattern) {
        text += (text.empty() ? "" : between) + alphabet.name(module.symbol);
        std::string list;
        for (const std::string& parameter : module.parameters)
            list += (list.empty() ? "" : ",") + parameter;
        if (!list.empty()) text += "(" + list + ")";
    }
    return text;
}

std::string rule_text(const Alphabet& alphabet, const Production& rule) {
    std::string text = pattern_text(alphabet, {rule.predecessor}, "");
    if (!rule.left.empty()) text = pattern_text(alphabet, rule.left, "") + " < " + text;
    if (!rule.right.empty()) text += " > " + pattern_text(alphabet, rule.right, "");
    if (!rule.elsewhere.empty()) text += " ? " + pattern_text(alphabet, rule.elsewhere, ", ");
    if (rule.condition) text += " : " + to_text(*rule.condition);
    text += rule.probability ? " -(" + to_string(*rule.probability) + ")-> " : " -> ";
    return text + word_text(alphabet, rule.successor);
}

}  // namespace

std::string rewriting_text(const LSystem& system) {
    Class kind = class_of(system);
    const bool conditional = std::exchange(kind.conditional, false);
    std::string text = "the " + kind.name() + " system with " +
                       (conditional ? "context conditions and " : "") + "axiom " +
                       word_text(system.alphabet, system.axiom);
    for (const Production& rule : system.rules) text += "; " + rule_text(system.alphabet, rule);
    std::string ignored;
    for (const Symbol letter : system.ignored) ignored += " " + system.alphabet.name(letter);
    if (!ignored.empty()) text += "; ignored are" + ignored;
    std::string constants;
    for (const auto& [name, value] : system.constants)
        constants +=
            (constants.empty() ? ", where " : ", ") + name + " = " + to_text(value.expression);
    return text + constants;
}

}  // namespace algae
