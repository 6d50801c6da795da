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
#include "notation/system_block.hpp"
#include "notation/word_grammar.hpp"

namespace algae {

namespace {

/// The statements are read in this order, that of the canonical text: names before the words they
/// occur in, constants before the expressions.
enum class Stage {
    alphabet,
    constant,
    inner,
    axiom,
    rule,
    ignore,
    terminals,
    interpretation,
    plot,
    stamp,
    solid,
    surface,
    other,
    unknown
};
constexpr Stage all_stages[] = {Stage::alphabet, Stage::constant,  Stage::inner,
                                Stage::axiom,    Stage::rule,      Stage::ignore,
                                Stage::terminals, Stage::interpretation, Stage::plot,
                                Stage::stamp,    Stage::solid,     Stage::surface,
                                Stage::other,    Stage::unknown};

Stage stage(const Clause& clause) {
    if (is_rule(clause)) return Stage::rule;
    const std::string_view name = clause.keyword;
    if (name == "alphabet") return Stage::alphabet;
    if (name == "let") return Stage::constant;
    if (clause.has_word("system")) return Stage::inner;
    if (name == "axiom") return Stage::axiom;
    if (name == "table") return Stage::rule;
    if (name == "ignore") return Stage::ignore;
    if (name == "terminals") return Stage::terminals;
    if (name == "interpret") return Stage::interpretation;
    if (name == "plot") return Stage::plot;
    if (name == "stamp") return Stage::stamp;
    if (name == "solid") return Stage::solid;
    if (name == "surface") return Stage::surface;
    const auto& names = setting_names();
    return std::find(names.begin(), names.end(), name) != names.end() ? Stage::other
                                                                      : Stage::unknown;
}

bool may_repeat(std::string_view name) {
    for (const char* repeated : {"id", "alphabet", "let", "system", "table", "interpret",
                                 "environment", "stamp", "solid", "surface", "expect"})
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
    system.axiom = parse_word(value, reading.lexicon, reading.source, true);
    check_brackets(system.axiom, value, reading.lexicon, reading.source, reading.findings);
    for (const auto& [position, arguments] : system.axiom.arguments)
        for (const Expression& argument : arguments) reading.check_names(argument, {});
    for (const auto& [position, words] : system.axiom.splices)
        for (const Expression& word : words) reading.check_names(word, {});
}

void read_inner(const Clause& clause, Reading& reading);

/// Throws unless the clause may stand in a system within another.
void check_inside(const Clause& clause, Stage at) {
    const bool table = clause.keyword == "table" && !clause.arrow;
    if (at == Stage::axiom || at == Stage::ignore || (at == Stage::rule && !table)) return;
    throw SyntaxError{clause.text.data(),
                      "expected 'axiom', 'ignore' or a rule in a system within another, found " +
                          quoted(clause.text.substr(0, clause.text.find_first_of(" \t=:")))};
}

void read_clause(const Clause& clause, Stage at, Reading& reading) {
    const std::string_view name = clause.keyword, value = clause.value();
    if (reading.is_inner) check_inside(clause, at);
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
        case Stage::inner:
            return read_inner(clause, reading);
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

/// Makes the names of the systems within known, as words before them may say them.
void name_systems(const std::vector<Clause>& all, Reading& reading) {
    for (const Clause& clause : all) {
        std::size_t bytes = 0;
        const auto block = system_block(clause.text, bytes);
        if (!block || clause.arrow) continue;
        const auto& known = reading.lexicon.systems();
        if (std::find(known.begin(), known.end(), block->name) != known.end())
            reading.findings.add(block->name.data(),
                                 "the system " + quoted(block->name) + " is given twice");
        else if (function_arity(block->name))
            reading.findings.add(block->name.data(),
                                 "expected a name for the system, found the function " +
                                     quoted(block->name));
        else
            reading.lexicon.name_system(block->name);
    }
}

/// No word with a quotation mark can stand in quotation marks.
void check_quotes(Reading& reading) {
    if (!holds_words(reading.system)) return;
    for (Symbol a = 0; a < reading.system.alphabet.size(); ++a)
        if (reading.system.alphabet.name(a).find('"') != std::string::npos)
            reading.findings.add(reading.source.text().data(),
                                 "expected no symbol with '\"' in a system with words in quotes, found " +
                                     quoted(reading.system.alphabet.name(a)));
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

void read_inner(const Clause& clause, Reading& outer) {
    std::size_t bytes = 0;
    const auto block = system_block(clause.text, bytes);
    if (!block) throw unexpected("a name and '{' after 'system'", clause.text.data() + 6);
    if (!block->closed) throw SyntaxError{block->body.data() - 1, "'{' is never closed"};
    constexpr std::size_t most = 100;
    if (outer.system.inner.size() == most)
        throw SyntaxError{clause.text.data(),
                          "more than " + std::to_string(most) + " systems within one"};
    InnerSystem inner;
    inner.name = inner.system.name = block->name;
    inner.place = outer.source.place(clause.text.data());
    inner.system.constants = outer.system.constants;
    Reading reading{outer.source, outer.findings, outer.lexicon, inner.system,
                    outer.constants, outer.broken, {}, {}, false};
    reading.is_inner = true;
    read_clauses(clauses(block->body), reading);
    if (!reading.given.count("axiom"))
        outer.findings.add(block->body.data() + block->body.size(),
                           "expected an axiom in the system, found none");
    reading.check_distances();
    for (const Production& rule : inner.system.rules) {
        if (rule.probability)
            outer.findings.add(rule.place, "expected a rule without probability, as the system " +
                                               quoted(inner.name) + " has one word in each generation");
        if (rule.shape)
            outer.findings.add(rule.place, "expected a rule that makes a word in the system " +
                                               quoted(inner.name) + ", found a shape rule");
    }
    inner.system.constants.clear();
    outer.broken_rules = outer.broken_rules || reading.broken_rules;
    outer.system.inner.push_back(std::move(inner));
}

}  // namespace

LSystem read_system(std::string_view text, const Source& source, Findings& findings, const std::string& name,
                    const std::vector<std::string>& declared) {
    LSystem system;
    system.name = name;
    Lexicon lexicon(system.alphabet);
    for (const std::string& symbol : declared) lexicon.declare(symbol);
    Reading reading{source, findings, lexicon, system, {}, {}, {}, {}, false};
    const std::vector<Clause> all = clauses(text);
    name_systems(all, reading);
    read_clauses(all, reading);
    if (!reading.given.count("axiom"))
        findings.add(text.data() + text.size(),
                     text.size() == source.text().size() ? "expected an axiom before the end of the file, found none"
                                                         : "expected an axiom in the system, found none");
    reading.check_distances();
    check_probabilities(system.rules, reading);
    check_probabilities(system.interpretation, reading);
    check_quotes(reading);
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
