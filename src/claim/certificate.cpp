#include "claim/certificate.hpp"

#include <nlohmann/json.hpp>

#include "claim/rewriting_json.hpp"
#include "verify/obstruction_json.hpp"

namespace algae {

using Json = nlohmann::ordered_json;

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
            Json result{{"derives", to_json(statement.modules, *statement.rewriting)},
                        {"system", statement.rewriting->name}};
            if (statement.modules_from)
                result["from"] = to_json(*statement.modules_from, *statement.rewriting);
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
            return {{of_all ? "dimension" : "boundary", statement.drawn->name},
                    {statement.dimension->at_most ? "at most" : "equals",
                     statement.dimension->text}};
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

}  // namespace algae
