#include "notation/rules.hpp"

#include <utility>

#include "notation/characters.hpp"
#include "notation/expression_grammar.hpp"
#include "notation/rule_grammar.hpp"
#include "notation/shape_grammar.hpp"
#include "notation/word_grammar.hpp"

namespace algae {

namespace {

Rational parse_probability(std::string_view text, Reading& reading) {
    const Quantity value = reading.quantity(parse_expression(text, reading.source));
    if (!value.exact)
        throw SyntaxError{text.data(), "expected a rational probability, found " + quoted(text)};
    if (sign(*value.exact) <= 0 || *value.exact > 1)
        throw SyntaxError{text.data(), "expected a probability above 0 and at most 1, found " +
                                           shortest_text(*value.exact)};
    return *value.exact;
}

void parse_successor(std::string_view text, Production& production, Reading& reading) {
    if (text.empty()) return;
    if ((production.shape = parse_shape(text, production, reading))) return;
    production.successor = parse_word(text, reading.lexicon, reading.source, true);
    check_brackets(production.successor, text, reading.lexicon, reading.source, reading.findings);
}

void check_all_names(const Production& production, Reading& reading) {
    const std::vector<std::string> names = parameters(production);
    if (production.condition) 
        reading.check_names(*production.condition, names, production.shape.has_value());
    for (const auto& [position, arguments] : production.successor.arguments)
        for (const Expression& argument : arguments) reading.check_names(argument, names);
    for (const auto& [position, words] : production.successor.splices)
        for (const Expression& word : words) reading.check_names(word, names);
    if (production.shape)
        for (const ShapeSuccessor::Size& size : production.shape->sizes)
            reading.check_names(size.value, names);
}

Production parse_production(std::string_view text, const char* arrow, Reading& reading) {
    Production production;
    production.place = reading.source.place(text.data());
    const Arrow split = split_at_arrow(text, arrow);
    if (split.left_side.empty()) throw unexpected("a symbol before the arrow", text.data());
    parse_left_side(split.left_side, reading.lexicon, reading.source, production);
    if (split.probability.data())
        production.probability = parse_probability(split.probability, reading);
    parse_successor(split.right_side, production, reading);
    check_all_names(production, reading);
    return production;
}

}  // namespace

void read_rule(const Clause& clause, Reading& reading) {
    Production production = parse_production(clause.text, clause.arrow, reading);
    if (!reading.system.tables.empty()) production.table = reading.system.tables.size() - 1;
    reading.system.rules.push_back(std::move(production));
}

void read_interpretation(const Clause& clause, Reading& reading) {
    const std::string_view rule = clause.value();
    if (!clause.arrow) throw unexpected("a rule with '->'", rule.data() + rule.size());
    reading.system.interpretation.push_back(parse_production(rule, clause.arrow, reading));
}

}  // namespace algae
