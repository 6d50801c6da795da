#include "notation/print.hpp"

#include <utility>

#include "notation/canonical.hpp"
#include "notation/spelling.hpp"

namespace algae {

namespace {

void add_arguments(const std::vector<Expression>& arguments, std::string& out) {
    out += '(';
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        if (i > 0) out += ',';
        out += to_text(arguments[i]);
    }
    out += ')';
}

std::string print_pattern(const Alphabet& alphabet, const Pattern& pattern, const char* separator) {
    std::string out;
    Spelling spelling(alphabet);
    for (const ModulePattern& module : pattern) {
        if (!out.empty() && *separator) {
            out += separator;
            spelling.forget();
        }
        spelling.add(module.symbol, out);
        if (module.parameters.empty()) continue;
        out += '(';
        for (std::size_t i = 0; i < module.parameters.size(); ++i)
            out += (i > 0 ? "," : "") + module.parameters[i];
        out += ')';
        spelling.forget();
    }
    return out;
}

std::string print_shape(const Alphabet& alphabet, const ShapeSuccessor& shape) {
    if (shape.operation == "I") return "I(" + spell_apart(alphabet, shape.parts) + ')';
    std::string out = shape.operation + '(' + shape.axis;
    for (const ShapeSuccessor::Size& size : shape.sizes) {
        std::string text = to_text(size.value);
        const bool ends_plainly = text.back() == ')' || (text.back() >= '0' && text.back() <= '9');
        if (size.relative && (size.value.kind != Expression::Kind::number || !ends_plainly))
            text = '(' + text + ')';
        out += ", " + text + (size.relative ? "r" : "");
    }
    return out + "){ " + spell_apart(alphabet, shape.parts) + " }";
}

/// The text of a word that is not taken for something else because of how it begins.
std::string guarded(std::string text, std::initializer_list<const char*> beginnings) {
    for (const char* beginning : beginnings)
        if (text.starts_with(beginning)) return "ε " + text;
    return text;
}

}  // namespace

std::string print_word(const Alphabet& alphabet, const ModuleWord& word) {
    if (word.letters.empty()) return "ε";
    std::string out;
    Spelling spelling(alphabet);
    auto arguments = word.arguments.begin();
    for (std::size_t i = 0; i < word.letters.size(); ++i) {
        spelling.add(word.letters[i], out);
        if (arguments == word.arguments.end() || arguments->first != i) continue;
        add_arguments(arguments->second, out);
        spelling.forget();
        ++arguments;
    }
    return out;
}

std::string print_word(const Alphabet& alphabet, const Word& word) {
    if (word.empty()) return "ε";
    std::string out;
    Spelling spelling(alphabet);
    for (const Symbol symbol : word) spelling.add(symbol, out);
    return out;
}

std::string print_rule(const Alphabet& alphabet, const Production& rule) {
    std::string out;
    if (!rule.left.empty()) out += print_pattern(alphabet, rule.left, "") + " < ";
    out += print_pattern(alphabet, {rule.predecessor}, "");
    if (!rule.right.empty()) out += " > " + print_pattern(alphabet, rule.right, "");
    if (!rule.elsewhere.empty()) out += " ? " + print_pattern(alphabet, rule.elsewhere, ", ");
    if (rule.condition) out += " : " + to_text(*rule.condition);
    out += rule.probability ? " -(" + to_text(quantity(*rule.probability).expression) + ")-> " : " -> ";
    if (rule.shape)
        out += print_shape(alphabet, *rule.shape);
    else
        out += guarded(print_word(alphabet, rule.successor), {"div(", "repeat("});
    // A left context may spell a setting whose value may contain arrows.
    return guarded(std::move(out), {"title ", "source ", "interpret "});
}

std::string print_lsystem(const LSystem& system) {
    std::string out;
    for (const CanonicalLine& line : canonical_lines(system)) out += line.text + '\n';
    return out;
}

}  // namespace algae
