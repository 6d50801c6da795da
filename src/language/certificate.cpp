#include "language/detail/judge.hpp"

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

#include "model/model.hpp"
#include "rewrite/rewrite.hpp"
#include "verify/verify.hpp"

// Systems, languages, statements and proofs of equality as a certificate writes them: CERTIFICATES.md describes
// each form.

namespace algae {

using Json = nlohmann::ordered_json;

namespace {

/// What the names in the expressions of a rule stand for.
struct Scope {
    const LSystem& system;
    std::vector<std::string> parameters;

    std::optional<std::size_t> parameter(const std::string& name) const {
        const auto found = std::find(parameters.begin(), parameters.end(), name);
        if (found == parameters.end()) return std::nullopt;
        return static_cast<std::size_t>(found - parameters.begin());
    }
    const Quantity* constant(const std::string& name) const {
        for (const auto& [known, value] : system.constants)
            if (known == name) return &value;
        return nullptr;
    }
};

Json expression_json(const Expression& expression, const Scope& scope) {
    const auto parameter = [&](const std::string& name) { return scope.parameter(name); };
    if (!has_parameters(expression, parameter))
        return number_text(evaluate(expression, [&](const std::string& name) {
                               return scope.constant(name);
                           }).value);
    if (expression.kind == Expression::Kind::name) return {{"parameter", expression.name}};
    Json parts = Json::array();
    for (const Expression& operand : expression.operands)
        parts.push_back(expression_json(operand, scope));
    return {{"apply", expression.name}, {"to", std::move(parts)}};
}

Json word_json(const ModuleWord& word, const Scope& scope) {
    Json modules = Json::array();
    for (std::size_t i = 0; i < word.letters.size(); ++i) {
        Json module = Json::array({scope.system.alphabet.name(word.letters[i])});
        if (const auto found = word.arguments.find(i); found != word.arguments.end())
            for (const Expression& argument : found->second)
                module.push_back(expression_json(argument, scope));
        modules.push_back(std::move(module));
    }
    return modules;
}

Json pattern_json(const Pattern& pattern, Scope& scope) {
    Json modules = Json::array();
    for (const ModulePattern& module : pattern) {
        Json written = Json::array({scope.system.alphabet.name(module.symbol)});
        for (const std::string& name : module.parameters) {
            scope.parameters.push_back(name);
            written.push_back(name);
        }
        modules.push_back(std::move(written));
    }
    return modules;
}

Json rule_json(const Production& rule, const LSystem& system) {
    Scope scope{system, {}};
    Json result{{"module", pattern_json({rule.predecessor}, scope)[0]}};
    const auto add = [&](const char* name, const Pattern& pattern) {
        if (!pattern.empty()) result[name] = pattern_json(pattern, scope);
    };
    add("left", rule.left);
    add("right", rule.right);
    add("elsewhere", rule.elsewhere);
    if (rule.condition) result["condition"] = expression_json(*rule.condition, scope);
    if (rule.probability) result["probability"] = to_string(*rule.probability);
    result["successor"] = word_json(rule.successor, scope);
    return result;
}

}  // namespace

Json to_json(const LSystem& system) {
    Json rules = Json::array();
    for (const Production& rule : system.rules) rules.push_back(rule_json(rule, system));
    Json result{{"axiom", word_json(system.axiom, {system, {}})}, {"modules", std::move(rules)}};
    for (const Symbol letter : system.ignored)
        result["ignored"].push_back(system.alphabet.name(letter));
    return result;
}

namespace {

using Kind = LanguageTree::Kind;

Json words_json(const std::vector<Word>& words, const Alphabet& alphabet) {
    Json result = Json::array();
    for (const Word& word : words) result.push_back(certificate_text(alphabet, word));
    return result;
}

Json morphism_json(const std::map<Symbol, Word>& morphism, const Alphabet& alphabet) {
    Json result = Json::object();
    for (const auto& [a, image] : morphism)
        result[alphabet.name(a)] = certificate_text(alphabet, image);
    return result;
}

Json pair_json(const LanguageTree& tree, const Alphabet& alphabet) {
    return Json::array({to_json(tree.parts[0], alphabet), to_json(tree.parts[1], alphabet)});
}

Json number_json(const Integer& number) { return to_string(number); }

Json body(const Statement& statement, const Alphabet& alphabet) {
    const auto language = [&](std::size_t i) {
        return to_json(statement.languages.at(i), alphabet);
    };
    const auto system = [&](std::size_t i) { return Json(statement.systems.at(i)->name); };
    switch (statement.kind) {
        case Statement::Kind::family:
            return {{"is", statement.family}, {"language", language(0)}};
        case Statement::Kind::finite:
            return {{"is", "finite"}, {"language", language(0)}};
        case Statement::Kind::empty:
            return {{"is", "empty"}, {"language", language(0)}};
        case Statement::Kind::equal:
            return {{"equal", Json::array({language(0), language(1)})}};
        case Statement::Kind::included:
            return {{"included", Json::array({language(0), language(1)})}};
        case Statement::Kind::member:
            return {{"member", certificate_text(alphabet, statement.word)},
                    {"language", language(0)}};
        case Statement::Kind::size:
            return {{"size", number_json(*statement.size)}, {"language", language(0)}};
        case Statement::Kind::derives: {
            Json result{{"derives", certificate_text(alphabet, statement.word)},
                        {"system", system(0)}};
            if (statement.from) result["from"] = certificate_text(alphabet, *statement.from);
            if (statement.steps) result["steps"] = *statement.steps;
            return result;
        }
        case Statement::Kind::rewrites:
        case Statement::Kind::chance: {
            Json result{{"derives", word_json(statement.modules, {*statement.rewriting, {}})},
                        {"system", statement.rewriting->name}};
            if (statement.modules_from)
                result["from"] = word_json(*statement.modules_from, {*statement.rewriting, {}});
            result["steps"] = *statement.steps;
            if (statement.probability) result["probability"] = to_string(*statement.probability);
            return result;
        }
        case Statement::Kind::equal_sequences:
            return {{"equal sequences", Json::array({system(0), system(1)})}};
        case Statement::Kind::equal_growth:
            return {{"equal growth", Json::array({system(0), system(1)})}};
        case Statement::Kind::growth_formula:
            return {{"growth", system(0)}, {"equals", to_text(*statement.formula)}};
        case Statement::Kind::growth_class: {
            Json result{{"growth", system(0)}, {"class", statement.family}};
            if (statement.size) result["degree"] = number_json(*statement.size);
            return result;
        }
        case Statement::Kind::dimension:
        case Statement::Kind::boundary: {
            const bool of_all = statement.kind == Statement::Kind::dimension;
            return {
                {of_all ? "dimension" : "boundary", statement.drawn->name},
                {statement.dimension->at_most ? "at most" : "equals", statement.dimension->text}};
        }
    }
    return {};
}

}  // namespace

Json to_json(const ET0L& system, const Alphabet& alphabet, const Word& other) {
    Json tables = Json::array();
    ET0L begun = system;
    begun.axiom.insert(begun.axiom.end(), other.begin(), other.end());
    const std::vector<Symbol> letters = accessible_letters(begun);
    bool all = true;
    Word terminals;
    for (const Table& table : system.tables) {
        Json rules = Json::object();
        for (const Symbol a : letters)
            if (table[a] != std::vector<Word>{Word{a}})
                rules[alphabet.name(a)] = words_json(table[a], alphabet);
        tables.push_back(std::move(rules));
    }
    for (const Symbol a : letters) {
        if (system.terminal[a])
            terminals.push_back(a);
        else
            all = false;
    }
    Json result{{"axiom", certificate_text(alphabet, system.axiom)}, {"tables", std::move(tables)}};
    if (!all) result["terminals"] = certificate_text(alphabet, terminals);
    return result;
}

Json to_json(const SourceSystem& system, const Alphabet& alphabet, const Word& other) {
    if (system.tables) return to_json(*system.tables, alphabet, other);
    const IL& source = *system.interactive;
    Json rules = Json::array();
    Word ignored;
    for (Symbol a = 0; a < source.rules.size(); ++a)
        for (const IL::Rule& rule : source.rules[a])
            rules.push_back({{"left", certificate_text(alphabet, rule.left)},
                             {"letter", alphabet.name(a)},
                             {"right", certificate_text(alphabet, rule.right)},
                             {"successor", certificate_text(alphabet, rule.successor)}});
    for (Symbol a = 0; a < source.ignored.size(); ++a)
        if (source.ignored[a]) ignored.push_back(a);
    Json result{{"axiom", certificate_text(alphabet, source.axiom)}, {"rules", std::move(rules)}};
    if (!ignored.empty()) result["ignored"] = certificate_text(alphabet, ignored);
    return result;
}

Json to_json(const Language& language, const Alphabet& alphabet) {
    const LanguageTree& tree = *language;
    switch (tree.kind) {
        case Kind::words:
            return {{"words", words_json(tree.words, alphabet)}};
        case Kind::generated:
            return {{"generated", tree.system->name}};
        case Kind::united:
            return {{"union", pair_json(tree, alphabet)}};
        case Kind::intersected:
            return {{"intersection", pair_json(tree, alphabet)}};
        case Kind::difference:
            return {{"difference", pair_json(tree, alphabet)}};
        case Kind::concatenated:
            return {{"concatenation", pair_json(tree, alphabet)}};
        case Kind::star:
            return {{"star", to_json(tree.parts[0], alphabet)}};
        case Kind::plus:
            return {{"plus", to_json(tree.parts[0], alphabet)}};
        case Kind::reversed:
            return {{"reversal", to_json(tree.parts[0], alphabet)}};
        case Kind::complement:
            return {{"complement", to_json(tree.parts[0], alphabet)},
                    {"letters", certificate_text(alphabet, tree.letters)}};
        case Kind::image:
            return {{"image", to_json(tree.parts[0], alphabet)},
                    {"morphism", morphism_json(tree.morphism, alphabet)}};
        case Kind::inverse_image:
            return {{"inverse image", to_json(tree.parts[0], alphabet)},
                    {"morphism", morphism_json(tree.morphism, alphabet)}};
    }
    return {};
}

Json to_json(const Statement& statement, const Alphabet& alphabet) {
    Json result = body(statement, alphabet);
    return statement.negated ? Json{{"not", result}} : result;
}

namespace {

/// Small numbers as numbers, others as digits.
Json number(const Integer& value) {
    if (bit_length(value) <= 53) return value.to_int64();
    return to_string(value);
}

}  // namespace

Json word_proof(const Word& word, const Alphabet& alphabet) {
    return {{"by", "word"}, {"word", certificate_text(alphabet, word)}};
}

Json construction_proof(const TableValue& tables) {
    return {{"by", "construction"}, {"system", to_json(tables.system, *tables.system.alphabet)}};
}

Json balance_certificate(const Balance& balance, const Alphabet& alphabet) {
    Json states = Json::array();
    for (const Overflow& overflow : balance.states)
        states.push_back({{"ahead", overflow.ahead == Overflow::Ahead::left ? "left" : "right"},
                          {"word", certificate_text(alphabet, overflow.word)}});
    return {{"by", "balance"},
            {"bound", balance.bound},
            {"states", std::move(states)},
            {"accepts", {{"steps", balance.steps}, {"earlier", balance.earlier}}}};
}

Json difference_certificate(const SequenceDifference& difference) {
    return {{"by", "generation"},
            {"generation", difference.generation},
            {"position", number(difference.position)}};
}

Json language_certificate(const LanguageEquality& equality, const Alphabet& alphabet) {
    if (equality.finite) return {{"by", "values"}};
    Json words = Json::array(), sections = Json::array();
    for (const auto& [left, right] : equality.words) words.push_back({left, right});
    for (const SectionMatch& match : equality.sections)
        sections.push_back({{"left", match.section.left},
                            {"step", match.section.step},
                            {"right", match.section.right},
                            {"stride", match.section.stride},
                            {"proof", balance_certificate(match.balance, alphabet)}});
    return {{"by", "sections"}, {"words", std::move(words)}, {"sections", std::move(sections)}};
}

}  // namespace algae
