#include "notation/print.hpp"

#include <utility>

#include "notation/settings_grammar.hpp"
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

/// Symbols with a blank between any two.
std::string print_list(const Alphabet& alphabet, const Word& symbols) {
    std::string out;
    for (const Symbol symbol : symbols) out += (out.empty() ? "" : " ") + alphabet.name(symbol);
    return out;
}

std::string print_shape(const Alphabet& alphabet, const ShapeSuccessor& shape) {
    if (shape.operation == "I") return "I(" + print_list(alphabet, shape.parts) + ')';
    std::string out = shape.operation + '(' + shape.axis;
    for (const ShapeSuccessor::Size& size : shape.sizes) {
        std::string text = to_text(size.value);
        const bool ends_plainly = text.back() == ')' || (text.back() >= '0' && text.back() <= '9');
        if (size.relative && (size.value.kind != Expression::Kind::number || !ends_plainly))
            text = '(' + text + ')';
        out += ", " + text + (size.relative ? "r" : "");
    }
    return out + "){ " + print_list(alphabet, shape.parts) + " }";
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
    const auto line = [&](const char* name, const std::string& value) {
        out += std::string(name) + ' ' + value + '\n';
    };
    const auto number = [&](const char* name, const std::optional<Quantity>& value) {
        if (value) line(name, to_text(value->expression));
    };
    if (!system.title.empty()) line("title", system.title);
    if (!system.source.empty()) line("source", system.source);
    std::string identifiers;
    for (const std::string& name : system.identifiers) identifiers += (identifiers.empty() ? "" : " ") + name;
    if (!identifiers.empty()) line("id", identifiers);
    if (!system.declared.empty()) line("alphabet", print_list(system.alphabet, system.declared));
    for (const auto& [name, value] : system.constants)
        line("let", name + " = " + to_text(value.expression));
    line("axiom", print_word(system.alphabet, system.axiom));
    std::size_t table = 0;
    const auto open_tables = [&](std::size_t end) {
        for (; table < end; ++table) line("table", system.tables[table]);
    };
    for (const Production& rule : system.rules) {
        if (!system.tables.empty()) open_tables(rule.table + 1);
        out += print_rule(system.alphabet, rule) + '\n';
    }
    open_tables(system.tables.size());
    if (!system.ignored.empty()) line("ignore", print_list(system.alphabet, system.ignored));
    if (!system.terminals.empty()) line("terminals", print_list(system.alphabet, system.terminals));
    for (const Production& rule : system.interpretation)
        line("interpret", print_rule(system.alphabet, rule));
    const Settings& settings = system.settings;
    number("angle", settings.angle);
    number("step", settings.step);
    number("shrink", settings.shrink);
    if (settings.start) {
        std::string start;
        for (const Quantity* part : {&settings.start->x, &settings.start->y, &settings.start->heading}) {
            std::string text = to_text(part->expression);
            if (text.find(' ') != std::string::npos) text = '(' + text + ')';
            start += (start.empty() ? "" : " ") + text;
        }
        line("start", start);
    }
    number("spin", settings.spin);
    number("scale", settings.scale);
    number("narrow", settings.narrow);
    number("width", settings.width);
    std::string colours;
    for (const std::string& colour : settings.colours) colours += (colours.empty() ? "" : " ") + colour;
    if (!colours.empty()) line("colour", colours);
    if (settings.clockwise) line("turn", "clockwise");
    if (settings.generations) {
        const auto [first, last] = *settings.generations;
        line("generation", std::to_string(first) + (last == first ? "" : ".." + std::to_string(last)));
    }
    for (const Expectation& expectation : system.expectations)
        line("expect", expectation.kind + ' ' + std::to_string(expectation.generation) + ": " +
                           expectation.value);
    return out;
}

}  // namespace algae
