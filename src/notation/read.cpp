#include "notation/read.hpp"

#include <algorithm>
#include <utility>

#include "notation/characters.hpp"
#include "notation/expression_grammar.hpp"
#include "notation/read_system.hpp"
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
    plot,
    stamp,
    other,
    unknown
};
constexpr Stage all_stages[] = {Stage::alphabet,       Stage::constant, Stage::axiom,
                                Stage::rule,           Stage::ignore,   Stage::terminals,
                                Stage::interpretation, Stage::plot,     Stage::stamp,
                                Stage::other,          Stage::unknown};

Stage stage(const Clause& clause) {
    if (is_rule(clause)) return Stage::rule;
    const std::string_view name = clause.keyword;
    if (name == "alphabet") return Stage::alphabet;
    if (name == "let") return Stage::constant;
    if (name == "axiom") return Stage::axiom;
    if (name == "table") return Stage::rule;
    if (name == "ignore") return Stage::ignore;
    if (name == "terminals") return Stage::terminals;
    if (name == "interpret") return Stage::interpretation;
    if (name == "plot") return Stage::plot;
    if (name == "stamp") return Stage::stamp;
    const auto& names = setting_names();
    return std::find(names.begin(), names.end(), name) != names.end() ? Stage::other
                                                                      : Stage::unknown;
}

bool may_repeat(std::string_view name) {
    for (const char* repeated :
         {"id", "alphabet", "let", "table", "interpret", "environment", "stamp", "expect"})
        if (name == repeated) return true;
    return false;
}

[[noreturn]] void refuse(const Clause& clause, const Reading& reading) {
    constexpr std::size_t most = 1000;  // after so many findings nobody needs suggestions
    const std::string_view text = clause.text;
    const std::string_view word =
        text.substr(0, std::min(text.find_first_of(" \t=:"), text.size()));
    throw SyntaxError{text.data(), "expected a setting or a rule with '->', found " + quoted(word) +
                                       (reading.findings.count() < most
                                            ? did_you_mean(clause.keyword, setting_names())
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

void read_axiom(const Clause& clause, Reading& reading) {
    const std::string_view value = clause.value();
    LSystem& system = reading.system;
    system.axiom_place = reading.source.place(value.data());
    system.axiom = parse_word(value, reading.lexicon, reading.source);
    check_brackets(system.axiom, value, reading.lexicon, reading.source, reading.findings);
    for (const auto& [position, arguments] : system.axiom.arguments)
        for (const Expression& argument : arguments) reading.check_names(argument, {});
}

void read_clause(const Clause& clause, Stage at, Reading& reading) {
    const std::string_view name = clause.keyword, value = clause.value();
    if (at == Stage::unknown) refuse(clause, reading);
    if (at == Stage::rule && clause.arrow) return read_rule(clause, reading);
    if (!may_repeat(name)) {
        const auto [first, is_new] = reading.given.emplace(name, clause.text.data());
        if (!is_new)
            throw SyntaxError{clause.text.data(),
                              quoted(name) + " is given twice, first in line " +
                                  std::to_string(reading.source.place(first->second).line)};
    }
    if (value.empty()) {
        const char* const end = clause.text.data() + clause.text.size();
        const bool is_axiom = at == Stage::axiom;
        throw unexpected(is_axiom ? "a word after 'axiom' (the empty word is ε)"
                                  : "a value after '" + std::string(name) + "'",
                         end);
    }
    switch (at) {
        case Stage::alphabet:
            return read_alphabet(clause, reading);
        case Stage::constant:
            return read_constant(clause, reading);
        case Stage::axiom:
            return read_axiom(clause, reading);
        case Stage::ignore:
            reading.system.ignored = without_repetitions(parse_symbols(value, reading.lexicon));
            return;
        case Stage::terminals:
            reading.system.terminals = without_repetitions(parse_symbols(value, reading.lexicon));
            return;
        case Stage::plot:
            reading.system.settings.plotters =
                without_repetitions(parse_symbols(value, reading.lexicon));
            return;
        case Stage::interpretation:
            return read_interpretation(clause, reading);
        default:
            return read_setting(clause, reading);
    }
}

/// A rule that follows a setting in the same statement is a frequent slip.
bool follows_setting(const Clause& clause) {
    const std::string_view name = clause.keyword;
    const auto& names = setting_names();
    return std::find(names.begin(), names.end(), name) != names.end() && clause.has_word(name);
}

void read_clauses(const std::vector<Clause>& all, Reading& reading) {
    std::vector<Stage> stages;
    for (const Clause& clause : all) stages.push_back(stage(clause));
    // Rules before the first table belong to none.
    const auto first_table = std::find_if(all.begin(), all.end(), [](const Clause& clause) {
        return clause.keyword == "table" && !clause.arrow;
    });
    for (const Stage at : all_stages) {
        for (auto clause = all.begin(); clause != all.end(); ++clause) {
            if (stages[static_cast<std::size_t>(clause - all.begin())] != at) continue;
            try {
                if (at == Stage::rule && first_table != all.end() && clause < first_table)
                    throw SyntaxError{clause->text.data(),
                                      "expected a table before the first rule, as there are tables "
                                      "further down"};
                read_clause(*clause, at, reading);
            } catch (const SyntaxError& error) {
                if (clause->arrow && at == Stage::rule && follows_setting(*clause)) {
                    reading.findings.add(clause->text.data(),
                                         "expected a line break or ';' between the setting " +
                                             quoted(clause->keyword) + " and the rule");
                    reading.given.emplace(clause->keyword, clause->text.data());
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

LSystem read_system(std::string_view text, const Source& source, Findings& findings, const std::string& name,
                    const std::vector<std::string>& declared) {
    LSystem system;
    system.name = name;
    Lexicon lexicon(system.alphabet);
    for (const std::string& symbol : declared) lexicon.declare(symbol);
    Reading reading{source, findings, lexicon, system, {}, {}, {}, {}, false};
    read_clauses(clauses(text), reading);
    if (!reading.given.count("axiom"))
        findings.add(text.data() + text.size(),
                     text.size() == source.text().size() ? "expected an axiom before the end of the file, found none"
                                                         : "expected an axiom in the system, found none");
    check_probabilities(system.rules, reading);
    check_probabilities(system.interpretation, reading);
    return system;
}

LSystem read_lsystem(std::string_view text, const std::string& file_name) {
    const Source source(text, file_name);
    Findings findings(source);
    findings.throw_if_no_text();
    LSystem system = read_system(text, source, findings, file_name, {});
    findings.throw_if_any();
    return system;
}

}  // namespace algae
