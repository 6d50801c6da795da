#include "notation/claim_definitions.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "notation/characters.hpp"
#include "notation/claim_families.hpp"
#include "notation/claim_language.hpp"
#include "notation/claim_rewriting.hpp"
#include "notation/claim_words.hpp"
#include "notation/read_system.hpp"
#include "notation/suggestion.hpp"

namespace algae {

namespace {

/// What stands up to the first blank or brace.
std::string_view first_word(std::string_view text) {
    std::size_t length = 0;
    while (length < text.size() && text[length] != '{' &&
           !is_blank(static_cast<unsigned char>(text[length])))
        ++length;
    return text.substr(0, length);
}

/// The system of a definition and the place of what it was read from.
LSystem system_of(const ClaimDefinition& definition, std::string_view rest, ClaimReading& reading) {
    const std::string name(definition.name);
    if (!rest.starts_with('{')) return reading.opened(std::string(rest), rest.data());
    const char* const close = closing_brace(rest.data(), rest.data() + rest.size());
    if (close + 1 != rest.data() + rest.size())
        throw unexpected("the end of the definition", close + 1);
    const std::size_t faults = reading.findings.count();
    LSystem system = read_system(rest.substr(1, rest.size() - 2), reading.source, reading.findings,
                                 name, reading.long_names);
    if (reading.findings.count() > faults) throw DependsOnError();
    return system;
}

void add_rewriting(const ClaimDefinition& definition, LSystem system, Claim& claim) {
    definition.meaning->rewriting = std::make_shared<const LSystem>(std::move(system));
    definition.meaning->kind = ClaimName::Kind::rewriting;
    claim.rewritings.push_back(definition.meaning->rewriting);
}

void read_system_definition(const ClaimDefinition& definition, ClaimReading& reading,
                            Claim& claim) {
    const std::string_view family = first_word(definition.value);
    const std::string_view rest = trimmed(definition.value.substr(family.size()));
    if (rest.empty())
        throw unexpected("a system between braces or the name of one",
                         family.data() + family.size());
    LSystem system = system_of(definition, rest, reading);
    system.name = definition.name;
    definition.meaning->written = std::make_shared<const LSystem>(system);
    const bool is_rewriting = is_rewriting_family(family);
    const auto refuse = [&](const std::string& reason) {
        throw SyntaxError{family.data(), std::string(definition.name) + " is called a " +
                                             std::string(family) + " system, but " + reason};
    };
    if (is_rewriting) {
        if (const std::string reason = misfit(system, family); !reason.empty()) refuse(reason);
        return add_rewriting(definition, std::move(system), claim);
    }
    if (const std::string reason = misfit(system, *system_form(family)); !reason.empty())
        refuse(reason);
    if (const View<IL> interactive = as_il(system);
        interactive && interactive->brackets && !as_et0l(system))
        return add_rewriting(definition, std::move(system), claim);
    definition.meaning->system =
        reading.add_system(std::string(definition.name), system, family.data());
    definition.meaning->kind = ClaimName::Kind::system;
    claim.systems.push_back(definition.meaning->system);
}

/// A word and braces with rules in them: a system of a family that there is not.
void refuse_unknown_family(std::string_view value) {
    const std::string_view word = first_word(value);
    ClaimScanner rest(value.substr(word.size()));
    if (word.empty() || !is_morphism(rest)) return;
    std::vector<std::string> families = common_families();
    families.insert(families.end(), rewriting_families().begin(), rewriting_families().end());
    throw SyntaxError{word.data(),
                      "expected a family of systems (0L, PD0L, ET0L, IL, ...), found " +
                          quoted(word) + did_you_mean(word, families)};
}

void expect_end(ClaimScanner& scanner, const char* expected) {
    if (!scanner.at_end()) throw unexpected(expected, scanner.here);
}

}  // namespace

bool ClaimDefinition::is_system() const {
    const std::string_view family = first_word(value);
    return system_form(family).has_value() || is_rewriting_family(family);
}

ClaimDefinition begin_definition(const ClaimClause& clause, ClaimReading& reading) {
    ClaimScanner scanner(clause.text.substr(clause.keyword.size()));
    ClaimDefinition definition;
    definition.name = scanner.take_name();
    if (definition.name.empty()) throw unexpected("a name after 'let'", scanner.here);
    definition.meaning = &reading.define(definition.name);
    definition.meaning->end = scanner.end;
    if (!scanner.take("=")) throw unexpected("'='", scanner.here);
    definition.value = scanner.rest();
    if (definition.value.empty())
        throw unexpected("a language, a system or a morphism after '='", scanner.here);
    if (clause.unclosed) throw SyntaxError{clause.unclosed, "'{' is never closed"};
    if (!definition.is_system()) refuse_unknown_family(definition.value);
    return definition;
}

void read_definition(const ClaimDefinition& definition, ClaimReading& reading, Claim& claim) {
    if (definition.is_system()) return read_system_definition(definition, reading, claim);
    ClaimName& meaning = *definition.meaning;
    ClaimScanner scanner(definition.value);
    if (is_morphism(scanner)) {
        ClaimScanner ahead = scanner;
        meaning.morphism = parse_morphism(ahead, reading);
        if (ahead.at_end()) {
            meaning.kind = ClaimName::Kind::morphism;
            return;
        }
        if (!ahead.rest().starts_with('(') && !ahead.rest().starts_with('^'))
            throw unexpected("the end of the definition, or '(' and a language", ahead.here);
    }
    meaning.language = parse_language(scanner, reading);
    expect_end(scanner, "an operator or the end of the definition");
    meaning.language.language = named(meaning.language.language, std::string(definition.name));
    meaning.kind = ClaimName::Kind::language;
    claim.languages.push_back(meaning.language.language);
}

}  // namespace algae
