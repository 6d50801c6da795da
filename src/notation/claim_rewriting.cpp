#include "notation/claim_rewriting.hpp"

#include <algorithm>
#include <utility>

#include "base/error.hpp"
#include "environment/environments.hpp"
#include "notation/characters.hpp"
#include "notation/claim_scanner.hpp"
#include "notation/claim_statement.hpp"
#include "notation/expression_grammar.hpp"
#include "notation/word_grammar.hpp"
#include "system/classes.hpp"
#include "system/s0l.hpp"

namespace algae {

namespace {

const char* place_of(const Expression& expression, const ClaimReading& reading) {
    return reading.source.text().data() + reading.source.offset(expression.place);
}

/// Throws where the expression has no value or a value that is no number from the constants.
void check_value(const Expression& expression, const LSystem& system, const ClaimReading& reading) {
    try {
        evaluate(expression, [&](const std::string& name) -> const Quantity* {
            for (const auto& [constant, value] : system.constants)
                if (constant == name) return &value;
            return nullptr;
        });
    } catch (const Diagnostics& error) {
        throw SyntaxError{place_of(expression, reading), error.findings().front().message};
    }
}

/// A word of modules over the alphabet of the system, to which new letters are added.
ModuleWord parse_modules(std::string_view text, LSystem& system, ClaimReading& reading) {
    const std::string_view word = trimmed(text);
    if (word.empty()) throw unexpected("a word (the empty word is ε)", text.data());
    Lexicon lexicon(system.alphabet);
    for (const std::string& name : reading.long_names) lexicon.declare(name);
    const ModuleWord read = parse_word(word, lexicon, reading.source);
    for (const auto& [position, arguments] : read.arguments)
        for (const Expression& argument : arguments) check_value(argument, system, reading);
    return read;
}

/// The bracket that closes the first one of the text.
std::size_t closing_bracket(std::string_view text) {
    std::size_t depth = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] == '(') ++depth;
        if (text[i] == ')' && --depth == 0) return i;
    }
    throw SyntaxError{text.data() + text.find('('), "'(' is never closed"};
}

}  // namespace

const std::vector<std::string>& rewriting_families() {
    static const std::vector<std::string> all{"S0L", "PS0L", "parametric"};
    return all;
}

bool is_rewriting_family(std::string_view name) {
    const auto& all = rewriting_families();
    return std::find(all.begin(), all.end(), name) != all.end();
}

std::string misfit(const LSystem& system, std::string_view family) {
    const Class found = class_of(system);
    if (family != "parametric") {
        if (const View<S0L> view = as_s0l(system); !view) return "it is " + view.reason();
        if (!found.stochastic) return "no rule has a probability";
        for (const Production& rule : system.rules)
            if (family == "PS0L" && rule.successor.letters.empty())
                return "the rule at " + to_string(rule.place) + " is erasing";
        return {};
    }
    if (found.shape) return "it has shape rules";
    if (found.nested) return "it has systems within it or words as parameters";
    if (found.open && found.stochastic) return "it has communication modules and probabilities";
    if (found.open && asks_program(system))
        return "its communication modules are filled by a program";
    if (found.tables > 1) return "it has several tables";
    if (found.extended) return "it has terminals";
    if (!found.parametric && !found.conditional)
        return "none of its modules has parameters and no rule has a condition";
    return {};
}

bool is_chance(std::string_view text) {
    ClaimScanner scanner(text);
    return scanner.take_word("P") && scanner.rest().starts_with('(') &&
           text.find("==>") != std::string_view::npos;
}

void parse_chance(std::string_view text, Statement& statement, ClaimReading& reading) {
    const std::size_t open = text.find('('), close = closing_bracket(text);
    const std::string_view inside = text.substr(open + 1, close - open - 1);
    parse_derivation(inside, statement, reading);
    if (!statement.rewriting)
        throw SyntaxError{inside.data() + inside.find_first_not_of(' '),
                          "expected a system with probabilities (S0L, PS0L, parametric), found '" +
                              statement.systems.front()->name + "', which has none"};
    if (class_of(*statement.rewriting).open)
        throw SyntaxError{inside.data() + inside.find_first_not_of(' '),
                          "expected a system without communication modules, found '" +
                              statement.rewriting->name +
                              "', whose environments leave nothing to chance"};
    statement.kind = Statement::Kind::chance;
    ClaimScanner scanner(text.substr(close + 1));
    statement.negated = scanner.take("!=");
    if (!statement.negated && !scanner.take("="))
        throw unexpected("'=' or '!=' and a probability", scanner.rest().data());
    const std::string_view number = scanner.rest();
    if (number.empty()) throw unexpected("a probability, such as 1/9", scanner.here);
    const Expression expression = parse_expression(number, reading.source);
    check_value(expression, LSystem{}, reading);
    const Quantity value = evaluate(expression, {});
    if (!value.exact || *value.exact < 0 || *value.exact > 1)
        throw SyntaxError{
            number.data(),
            "expected a probability, an exact number from 0 to 1, found " + quoted(number)};
    statement.probability = value.exact;
}

void parse_rewriting(const std::shared_ptr<const LSystem>& system,
                     const std::optional<std::string_view>& from, std::string_view word,
                     std::optional<std::uint64_t> steps, Statement& statement,
                     ClaimReading& reading) {
    statement.kind = Statement::Kind::rewrites;
    LSystem with_all_letters = *system;
    if (from) statement.modules_from = parse_modules(*from, with_all_letters, reading);
    statement.modules = parse_modules(word, with_all_letters, reading);
    if (!steps)
        throw unexpected("'in' and a number of steps, as " + system->name +
                             " has probabilities, parameters or contexts of trees",
                         word.data() + word.size());
    statement.steps = steps;
    statement.rewriting = std::make_shared<const LSystem>(std::move(with_all_letters));
}

}  // namespace algae
