#include "notation/claim_growth.hpp"

#include <algorithm>
#include <array>
#include <string>

#include "notation/characters.hpp"
#include "notation/expression_grammar.hpp"
#include "notation/suggestion.hpp"

namespace algae {

namespace {

using Kind = Statement::Kind;

/// `growth(G)` or `sequence(G)`; the system is added to the statement.
void parse_subject(ClaimScanner& scanner, std::string_view word, Statement& statement,
                   ClaimReading& reading) {
    if (!scanner.take_word(word))
        throw unexpected(quoted(word) + " and a system between brackets", scanner.here);
    if (!scanner.take("(")) throw unexpected("'(' after " + quoted(word), scanner.here);
    const std::string_view name = scanner.take_name();
    if (name.empty()) throw unexpected("the name of a system", scanner.here);
    statement.systems.push_back(reading.system(name));
    if (!scanner.take(")")) throw unexpected("')'", scanner.here);
}

/// Throws if the formula has names other than n.
void check_names(const Expression& formula, const ClaimReading& reading) {
    if (formula.kind == Expression::Kind::name && formula.name != "n")
        throw SyntaxError{
            reading.source.text().data() + reading.source.offset(formula.place),
            "expected n, the number of the generation, found " + quoted(formula.name)};
    for (const Expression& operand : formula.operands) check_names(operand, reading);
}

void parse_class(ClaimScanner& scanner, Statement& statement) {
    const char* const where = scanner.rest().data();
    const std::string_view found = scanner.take_name();
    static const std::vector<std::string> all{"zero", "bounded", "polynomial", "exponential"};
    const std::string expected = "zero, bounded, polynomial or exponential";
    if (found.empty()) throw unexpected(expected, where);
    if (std::find(all.begin(), all.end(), found) == all.end())
        throw SyntaxError{
            where, "expected " + expected + ", found " + quoted(found) + did_you_mean(found, all)};
    statement.kind = Kind::growth_class;
    statement.family = found;
    if (found == "polynomial" && !scanner.at_end())
        statement.size = parse_number(scanner, "a degree");
}

}  // namespace

Integer parse_number(ClaimScanner& scanner, const char* what) {
    constexpr std::size_t longest = 1000;
    const std::string_view rest = scanner.rest();
    std::size_t digits = 0;
    while (digits < rest.size() && is_digit(static_cast<unsigned char>(rest[digits]))) ++digits;
    if (digits == 0) throw unexpected(what, scanner.here);
    if (digits > longest)
        throw SyntaxError{scanner.here,
                          "a number of more than " + std::to_string(longest) + " digits"};
    scanner.here += digits;
    return Integer(rest.substr(0, digits));
}

void parse_growth(ClaimScanner& scanner, Statement& statement, ClaimReading& reading) {
    const std::string_view word = scanner.name();
    const bool growth = word == "growth";
    parse_subject(scanner, word, statement, reading);
    statement.negated = scanner.take("!=");
    if (statement.negated || scanner.take("==")) {
        statement.kind = growth ? Kind::equal_growth : Kind::equal_sequences;
        return parse_subject(scanner, word, statement, reading);
    }
    if (!growth) throw unexpected("'==' or '!='", scanner.here);
    if (scanner.take("~")) return parse_class(scanner, statement);
    if (!scanner.take("=")) throw unexpected("'=', '==', '!=' or '~'", scanner.here);
    if (scanner.name() == "growth")
        throw SyntaxError{scanner.here, "expected '==' before another growth, found '='"};
    statement.kind = Kind::growth_formula;
    const std::string_view formula = scanner.rest();
    if (formula.empty()) throw unexpected("an expression in n", scanner.here);
    statement.formula = parse_expression(formula, reading.source);
    check_names(*statement.formula, reading);
    scanner.here = scanner.end;
}

}  // namespace algae
