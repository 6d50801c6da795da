#include "lesson/own_statement.hpp"

#include <charconv>
#include <vector>

#include "notation/characters.hpp"
#include "notation/claim_families.hpp"
#include "notation/claim_rewriting.hpp"
#include "notation/claim_scanner.hpp"
#include "notation/findings.hpp"
#include "notation/suggestion.hpp"

namespace algae {

namespace {

std::uint64_t read_number(ClaimScanner& scanner) {
    const std::string_view rest = scanner.rest();
    std::uint64_t number = 0;
    const auto [stop, error] = std::from_chars(rest.data(), rest.data() + rest.size(), number);
    if (error != std::errc()) throw unexpected("a number", rest.data());
    scanner.here = stop;
    return number;
}

std::string read_form(ClaimScanner& scanner) {
    const std::string_view name = scanner.take_piece();
    if (system_form(name) || is_rewriting_family(name)) return std::string(name);
    const std::string expected = "the name of a form of systems";
    if (name.empty()) throw unexpected(expected, name.data());
    std::vector<std::string> forms{"S0L", "parametric"};
    for (const std::string& family : common_families())
        if (system_form(family)) forms.push_back(family);
    throw SyntaxError{name.data(), "expected " + expected + ", found " + quoted(name) +
                                       did_you_mean(name, forms)};
}

OwnStatement::Counted read_counted(ClaimScanner& scanner) {
    const std::string_view noun = scanner.take_name();
    if (noun == "rule" || noun == "rules") return OwnStatement::Counted::rules;
    if (noun == "letter" || noun == "letters") return OwnStatement::Counted::letters;
    if (noun != "axiom") throw unexpected("rules, letters or axiom symbols", noun.data());
    if (!scanner.take_word("symbols") && !scanner.take_word("symbol"))
        throw unexpected("'symbols'", scanner.here);
    return OwnStatement::Counted::axiom_symbols;
}

OwnStatement::Figure read_figure(ClaimScanner& scanner, std::string_view text) {
    if (!scanner.take_word("figure") || !scanner.take("("))
        throw unexpected("figure(SYSTEM, GENERATION)", scanner.here);
    const std::string_view rest = scanner.rest();
    const std::string_view name = rest.substr(0, rest.find_first_of(", )"));
    if (name.empty()) throw unexpected("the name of a system", rest.data());
    OwnStatement::Figure figure;
    figure.system = name;
    figure.offset = static_cast<std::size_t>(name.data() - text.data());
    scanner.here += name.size();
    if (!scanner.take(",")) throw unexpected("',' and a generation", scanner.here);
    figure.generation = read_number(scanner);
    if (!scanner.take(")")) throw unexpected("')'", scanner.here);
    return figure;
}

OwnStatement::Relation read_relation(ClaimScanner& scanner) {
    if (scanner.take("==")) return OwnStatement::Relation::same;
    if (scanner.take_word("is")) {
        const bool congruent = scanner.take_word("congruent");
        if ((congruent || scanner.take_word("similar")) && scanner.take_word("to"))
            return congruent ? OwnStatement::Relation::congruent : OwnStatement::Relation::similar;
    }
    throw unexpected("'is similar to', 'is congruent to' or '=='", scanner.here);
}

}  // namespace

OwnStatement read_own_statement(std::string_view text) {
    ClaimScanner scanner(text);
    OwnStatement statement;
    if (scanner.name() == "figure") {
        statement.kind = OwnStatement::Kind::figures;
        statement.left = read_figure(scanner, text);
        statement.relation = read_relation(scanner);
        statement.right = read_figure(scanner, text);
    } else if (!scanner.take_word("answer")) {
        throw unexpected("'answer' or 'figure'", scanner.here);
    } else if (scanner.take_word("has")) {
        statement.kind = OwnStatement::Kind::count;
        statement.at_most = scanner.take_word("at");
        if (statement.at_most && !scanner.take_word("most"))
            throw unexpected("'most'", scanner.here);
        statement.count = read_number(scanner);
        statement.counted = read_counted(scanner);
    } else if (scanner.take_word("is")) {
        statement.form = read_form(scanner);
    } else {
        throw unexpected("'is' or 'has'", scanner.here);
    }
    if (!scanner.at_end()) throw unexpected("the end of the statement", scanner.here);
    return statement;
}

}  // namespace algae
