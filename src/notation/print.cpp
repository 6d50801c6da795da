#include "notation/print.hpp"

#include <algorithm>
#include <utility>

#include "notation/canonical.hpp"

namespace algae {

namespace {

std::string print_arguments(const std::vector<Expression>& arguments) {
    std::string out;
    for (const Expression& argument : arguments)
        out += (out.empty() ? "(" : ",") + to_text(argument);
    return out + ')';
}

std::string print_splices(const std::vector<Expression>& words) {
    std::string out;
    for (const Expression& word : words) {
        const bool is_plain = word.kind != Expression::Kind::binary;  // > would end it
        out += (is_plain ? "<" : "<(") + to_text(word) + (is_plain ? ">" : ")>");
    }
    return out;
}

std::string print_parameters(const std::vector<std::string>& names) {
    std::string out;
    for (const std::string& name : names) out += (out.empty() ? "(" : ",") + name;
    return out.empty() ? out : out + ')';
}

std::string print_size(const ShapeSuccessor::Size& size) {
    const std::string text = to_text(size.value);
    if (!size.relative) return text;
    // An r behind a name or an exponent would be read as part of it.
    const bool is_plain = text.find_first_not_of("0123456789.") == std::string::npos;
    return is_plain ? text + 'r' : '(' + text + ")r";
}

/// The text of a word that is not taken for something else because of how it begins.
std::string guarded(std::string text, std::initializer_list<const char*> beginnings) {
    for (const char* beginning : beginnings)
        if (text.starts_with(beginning)) return "ε " + text;
    return text;
}

}  // namespace

std::string Printer::word(const ModuleWord& word) const {
    if (word.letters.empty() && word.splices.empty()) return "ε";
    std::string out;
    auto arguments = word.arguments.begin();
    auto splices = word.splices.begin();
    bool is_bare = false;  // a name, not a closing bracket, stands before
    for (std::size_t i = 0;; ++i) {
        if (splices != word.splices.end() && splices->first == i) {
            out += print_splices((splices++)->second);
            is_bare = false;
        }
        if (i == word.letters.size()) break;
        if (is_bare && spellings_.blank_between(word.letters[i - 1], word.letters[i])) out += ' ';
        out += alphabet_.name(word.letters[i]);
        is_bare = arguments == word.arguments.end() || arguments->first != i;
        if (!is_bare) out += print_arguments((arguments++)->second);
    }
    return out;
}

std::string Printer::apart(const Word& symbols) const {
    std::string out;
    for (const Symbol symbol : symbols) out += (out.empty() ? "" : " ") + alphabet_.name(symbol);
    return out;
}

std::string Printer::pattern(const Pattern& pattern, const char* separator) const {
    std::string out;
    const ModulePattern* before = nullptr;
    for (const ModulePattern& module : pattern) {
        if (before) out += separator;
        if (before && !*separator && before->parameters.empty() &&
            spellings_.blank_between(before->symbol, module.symbol))
            out += ' ';
        out += alphabet_.name(module.symbol) + print_parameters(module.parameters);
        before = &module;
    }
    return out;
}

std::string Printer::shape(const ShapeSuccessor& shape) const {
    if (shape.operation == "I") return "I(" + apart(shape.parts) + ')';
    std::string out = shape.operation + '(' + shape.axis;
    if (shape.axis.size() > 1) out.erase(std::unique(out.begin() + 4, out.end()), out.end());
    for (std::size_t i = 0; i < shape.sizes.size(); ++i) {
        const bool turns = i > 0 && shape.axis.size() > 1 && shape.axis[i] != shape.axis[i - 1];
        out += (turns ? " : " : ", ") + print_size(shape.sizes[i]);
    }
    return out + "){ " + apart(shape.parts) + " }";
}

std::string Printer::rule(const Production& rule) const {
    std::string out;
    if (!rule.left.empty()) out += pattern(rule.left, "") + " < ";
    out += pattern({rule.predecessor}, "");
    if (!rule.right.empty()) out += " > " + pattern(rule.right, "");
    if (!rule.elsewhere.empty()) out += " ? " + pattern(rule.elsewhere, ", ");
    if (rule.condition) out += " : " + to_text(*rule.condition);
    if (rule.probability)
        out += " -(" + to_text(quantity(*rule.probability).expression) + ")-> ";
    else
        out += " -> ";
    out += rule.shape ? shape(*rule.shape) : guarded(word(rule.successor), {"div(", "repeat(", "Split("});
    // A left context may spell a setting whose value may contain arrows.
    return guarded(std::move(out), {"title ", "source ", "interpret ", "system "});
}

std::string print_word(const Alphabet& alphabet, const ModuleWord& word) {
    return Printer(alphabet).word(word);
}

std::string print_rule(const Alphabet& alphabet, const Production& rule) {
    return Printer(alphabet).rule(rule);
}

std::string print_lsystem(const LSystem& system) {
    std::string out;
    for (const CanonicalLine& line : canonical_lines(system)) {
        out += line.text + '\n';
        for (const CanonicalLine& inner : line.inside) out += "    " + inner.text + '\n';
        if (line.keyword == "system") out += "}\n";
    }
    return out;
}

}  // namespace algae
