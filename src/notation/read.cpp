#include "notation/read.hpp"

#include <algorithm>
#include <utility>

#include "notation/characters.hpp"
#include "notation/expression_grammar.hpp"
#include "notation/reading.hpp"
#include "notation/rules.hpp"
#include "notation/settings_grammar.hpp"
#include "notation/suggestion.hpp"
#include "notation/word_grammar.hpp"

namespace algae {

namespace {

/// The statements are read in this order, that of the canonical text: names before the words they
/// occur in, constants before the expressions.
enum class Stage {
    alphabet,
    constant,
    axiom,
    rule,
    ignore,
    terminals,
    interpretation,
    other,
    unknown
};
constexpr Stage all_stages[] = {Stage::alphabet,       Stage::constant, Stage::axiom,
                                Stage::rule,           Stage::ignore,   Stage::terminals,
                                Stage::interpretation, Stage::other,    Stage::unknown};

Stage stage(const Statement& statement) {
    if (is_rule(statement)) return Stage::rule;
    const std::string_view name = statement.keyword;
    if (name == "alphabet") return Stage::alphabet;
    if (name == "let") return Stage::constant;
    if (name == "axiom") return Stage::axiom;
    if (name == "table") return Stage::rule;
    if (name == "ignore") return Stage::ignore;
    if (name == "terminals") return Stage::terminals;
    if (name == "interpret") return Stage::interpretation;
    const auto& names = setting_names();
    return std::find(names.begin(), names.end(), name) != names.end() ? Stage::other
                                                                      : Stage::unknown;
}

bool may_repeat(std::string_view name) {
    for (const char* repeated : {"id", "alphabet", "let", "table", "interpret", "expect"})
        if (name == repeated) return true;
    return false;
}

[[noreturn]] void refuse(const Statement& statement, const Reading& reading) {
    constexpr std::size_t most = 1000;  // after so many findings nobody needs suggestions
    const std::string_view text = statement.text;
    const std::string_view word =
        text.substr(0, std::min(text.find_first_of(" \t=:"), text.size()));
    throw SyntaxError{text.data(), "expected a setting or a rule with '->', found " + quoted(word) +
                                       (reading.findings.count() < most
                                            ? did_you_mean(statement.keyword, setting_names())
                                            : std::string())};
}

/// Each symbol once, in the order of its first occurrence.
std::vector<Symbol> without_repetitions(const Word& word) {
    std::vector<Symbol> out;
    std::vector<bool> seen;
    for (const Symbol symbol : word) {
        if (symbol >= seen.size()) seen.resize(symbol + 1);
        if (!seen[symbol]) out.push_back(symbol);
        seen[symbol] = true;
    }
    return out;
}

void read_axiom(const Statement& statement, Reading& reading) {
    const std::string_view value = statement.value();
    LSystem& system = reading.system;
    system.axiom_place = reading.source.place(value.data());
    system.axiom = parse_word(value, reading.lexicon, reading.source);
    check_brackets(system.axiom, value, reading.lexicon, reading.source, reading.findings);
    for (const auto& [position, arguments] : system.axiom.arguments)
        for (const Expression& argument : arguments) reading.check_names(argument, {});
}

void read_statement(const Statement& statement, Stage at, Reading& reading) {
    const std::string_view name = statement.keyword, value = statement.value();
    if (at == Stage::unknown) refuse(statement, reading);
    if (at == Stage::rule && statement.arrow) return read_rule(statement, reading);
    if (!may_repeat(name)) {
        const auto [first, is_new] = reading.given.emplace(name, statement.text.data());
        if (!is_new)
            throw SyntaxError{statement.text.data(),
                              quoted(name) + " is given twice, first in line " +
                                  std::to_string(reading.source.place(first->second).line)};
    }
    if (value.empty()) {
        const char* const end = statement.text.data() + statement.text.size();
        const bool is_axiom = at == Stage::axiom;
        throw unexpected(is_axiom ? "a word after 'axiom' (the empty word is ε)"
                                  : "a value after '" + std::string(name) + "'",
                         end);
    }
    switch (at) {
        case Stage::alphabet:
            return read_alphabet(statement, reading);
        case Stage::constant:
            return read_constant(statement, reading);
        case Stage::axiom:
            return read_axiom(statement, reading);
        case Stage::ignore:
            reading.system.ignored = without_repetitions(parse_symbols(value, reading.lexicon));
            return;
        case Stage::terminals:
            reading.system.terminals = without_repetitions(parse_symbols(value, reading.lexicon));
            return;
        case Stage::interpretation:
            return read_interpretation(statement, reading);
        default:
            return read_setting(statement, reading);
    }
}

/// A rule that follows a setting in the same statement is a frequent slip.
bool follows_setting(const Statement& statement) {
    const std::string_view name = statement.keyword;
    const auto& names = setting_names();
    return std::find(names.begin(), names.end(), name) != names.end() && statement.has_word(name);
}

void read_statements(const std::vector<Statement>& all, Reading& reading) {
    std::vector<Stage> stages;
    for (const Statement& statement : all) stages.push_back(stage(statement));
    // Rules before the first table belong to none.
    const auto first_table = std::find_if(all.begin(), all.end(), [](const Statement& s) {
        return s.keyword == "table" && !s.arrow;
    });
    for (const Stage at : all_stages) {
        for (auto statement = all.begin(); statement != all.end(); ++statement) {
            if (stages[static_cast<std::size_t>(statement - all.begin())] != at) continue;
            try {
                if (at == Stage::rule && first_table != all.end() && statement < first_table)
                    throw SyntaxError{statement->text.data(),
                                      "expected a table before the first rule, as there are tables "
                                      "further down"};
                read_statement(*statement, at, reading);
            } catch (const SyntaxError& error) {
                if (statement->arrow && at == Stage::rule && follows_setting(*statement)) {
                    reading.findings.add(statement->text.data(),
                                         "expected a line break or ';' between the setting " +
                                             quoted(statement->keyword) + " and the rule");
                    reading.given.emplace(statement->keyword, statement->text.data());
                } else {
                    reading.findings.add(error);
                }
                if (at == Stage::rule || at == Stage::interpretation) reading.broken_rules = true;
            } catch (const DependsOnError&) {
                reading.broken_rules = true;
            }
        }
    }
}

}  // namespace

LSystem read_lsystem(std::string_view text, const std::string& file_name) {
    const Source source(text, file_name);
    Findings findings(source);
    findings.throw_if_no_text();
    LSystem system;
    system.name = file_name;
    Lexicon lexicon(system.alphabet);
    Reading reading{source, findings, lexicon, system, {}, {}, {}, {}, false};
    read_statements(statements(text), reading);
    if (!reading.given.count("axiom"))
        findings.add(text.size(), "expected an axiom before the end of the file, found none");
    check_probabilities(system.rules, reading);
    check_probabilities(system.interpretation, reading);
    findings.throw_if_any();
    return system;
}

}  // namespace algae
