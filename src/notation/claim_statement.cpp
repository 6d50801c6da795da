#include <algorithm>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "dimension/dimension.hpp"
#include "notation/detail/claim_reading.hpp"
#include "turtle/turtle.hpp"

// Statements of claims, and the facts of the table of closure properties.
//
// What kind of statement a text is shows in a few signs: `==>` is a derivation, and behind `P(` the
// probability of one; a word `in` outside braces separates a word from the language it is in; `growth`,
// `sequence`, `dimension`, `boundary` and `|` begin statements of their own; all else is about one or two
// languages. `not` may stand in front of any statement and in the middle of most, once in all.
//
// Derivations are of two kinds. In systems without parameters and probabilities words are strings of letters,
// over the common alphabet of the claim (`derives`). Those of stochastic and parametric systems, and of
// systems with contexts in words that are trees, are derived module by module (`rewrites`, `chance`): their
// words have values in them and are read over the system's own alphabet, to which letters that it does not
// know are added, since a claim may say that they never occur.

namespace algae {

namespace {

std::string_view before(std::string_view text, std::size_t offset) {
    return text.substr(0, offset);
}

/// The system of `growth(G)` or `sequence(G)`.
std::shared_ptr<const SourceSystem> parse_subject(ClaimScanner& scanner, std::string_view word,
                                                  ClaimReading& reading) {
    if (!scanner.take_word(word))
        throw unexpected(quoted(word) + " and a system between brackets", scanner.here);
    if (!scanner.take("(")) throw unexpected("'(' after " + quoted(word), scanner.here);
    const std::string_view name = scanner.take_name();
    if (name.empty()) throw unexpected("the name of a system", scanner.here);
    auto system = reading.system(name);
    if (!scanner.take(")")) throw unexpected("')'", scanner.here);
    return system;
}

/// Throws if the formula has names other than n.
void check_names(const Expression& formula, const ClaimReading& reading) {
    if (formula.kind == Expression::Kind::name && formula.name != "n")
        throw SyntaxError{
            reading.source.text().data() + reading.source.offset(formula.place),
            "expected n, the number of the generation, found " + algae::quoted(formula.name)};
    for (const Expression& operand : formula.operands) check_names(operand, reading);
}

HasGrowthClass parse_class(ClaimScanner& scanner, std::shared_ptr<const SourceSystem> system) {
    const char* const where = scanner.rest().data();
    const std::string_view found = scanner.take_name();
    static const std::vector<std::string> all{"zero", "bounded", "polynomial", "exponential"};
    const std::string expected = "zero, bounded, polynomial or exponential";
    if (found.empty()) throw unexpected(expected, where);
    if (std::find(all.begin(), all.end(), found) == all.end())
        throw SyntaxError{
            where, "expected " + expected + ", found " + quoted(found) + did_you_mean(found, all)};
    HasGrowthClass said{std::move(system), std::string(found)};
    if (found == "polynomial" && !scanner.at_end()) said.degree = parse_number(scanner, "a degree");
    return said;
}

/// Reads what is said of the sequence or the growth of systems, `growth(G) = 2^n`, into the statement.
/// Throws `SyntaxError` or `DependsOnError`.
void parse_growth(ClaimScanner& scanner, Statement& statement, ClaimReading& reading) {
    const std::string_view word = scanner.name();
    const bool growth = word == "growth";
    const auto system = parse_subject(scanner, word, reading);
    statement.negated = scanner.take("!=");
    if (statement.negated || scanner.take("==")) {
        const auto other = parse_subject(scanner, word, reading);
        if (growth)
            statement.says = EqualGrowth{system, other};
        else
            statement.says = EqualSequences{system, other};
        return;
    }
    if (!growth) throw unexpected("'==' or '!='", scanner.here);
    if (scanner.take("~")) {
        statement.says = parse_class(scanner, system);
        return;
    }
    if (!scanner.take("=")) throw unexpected("'=', '==', '!=' or '~'", scanner.here);
    if (scanner.name() == "growth")
        throw SyntaxError{scanner.here, "expected '==' before another growth, found '='"};
    const std::string_view text = scanner.rest();
    if (text.empty()) throw unexpected("an expression in n", scanner.here);
    const Expression formula = parse_expression(text, reading.source);
    check_names(formula, reading);
    statement.says = HasGrowthFormula{system, formula};
    scanner.here = scanner.end;
}

/// Reads what is said of the dimension of the limit set that a system draws, or of its boundary,
/// `dimension(G) = log 4 / log 3`, into the statement. Throws `SyntaxError` or `DependsOnError`.
void parse_dimension(ClaimScanner& scanner, Statement& statement, ClaimReading& reading) {
    const std::string_view word = scanner.take_name();
    if (!scanner.take("(")) throw unexpected("'(' after " + quoted(word), scanner.here);
    const std::string_view name = scanner.take_name();
    if (name.empty()) throw unexpected("the name of a system", scanner.here);
    const auto system = reading.written(name);
    if (!scanner.take(")")) throw unexpected("')'", scanner.here);
    const bool at_most = scanner.take("<=");
    statement.negated = !at_most && scanner.take("!=");
    if (!at_most && !statement.negated && !scanner.take("="))
        throw unexpected("'=', '!=' or '<=' and a number", scanner.here);
    const std::string_view text = scanner.rest();
    ClaimedDimension claimed{std::make_shared<const DimensionValue>(parse_dimension_value(scanner)),
                             "", at_most};
    claimed.text = trimmed(text.substr(0, static_cast<std::size_t>(scanner.here - text.data())));
    if (word == "dimension")
        statement.says = HasDimension{system, std::move(claimed)};
    else
        statement.says = BoundaryHasDimension{system, std::move(claimed)};
}

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

/// Whether a statement begins with `P(` and holds an arrow: the probability of a derivation.
bool is_chance(std::string_view text) {
    ClaimScanner scanner(text);
    return scanner.take_word("P") && scanner.rest().starts_with('(') &&
           text.find("==>") != std::string_view::npos;
}

/// Reads what is derived, `WORD in n steps`, by a system of these, and the word it begins with if it is no
/// axiom. Throws `SyntaxError`.
Rewrites parse_rewriting(const std::shared_ptr<const LSystem>& system,
                         const std::optional<std::string_view>& from, std::string_view word,
                         std::optional<std::uint64_t> steps, ClaimReading& reading) {
    Rewrites said;
    LSystem with_all_letters = *system;
    if (from) said.from = parse_modules(*from, with_all_letters, reading);
    said.word = parse_modules(word, with_all_letters, reading);
    if (!steps)
        throw unexpected("'in' and a number of steps, as " + system->name +
                             " has probabilities, parameters or contexts of trees",
                         word.data() + word.size());
    said.steps = *steps;
    said.system = std::make_shared<const LSystem>(std::move(with_all_letters));
    return said;
}

/// Reads `G ==> W in 3 steps` or `G : U ==> W`. Throws `SyntaxError`.
std::variant<Derives, Rewrites> parse_derivation(std::string_view text, ClaimReading& reading) {
    const std::size_t arrow = text.find("==>");
    const std::string_view left = before(text, arrow);
    const std::size_t colon = left.find(':');
    const std::string_view name = trimmed(before(left, colon));
    if (name.empty()) throw unexpected("the name of a system", text.data());
    std::optional<std::string_view> from;
    if (colon != std::string_view::npos) from = left.substr(colon + 1);
    std::string_view word = text.substr(arrow + 3);
    std::optional<std::uint64_t> number_of_steps;
    if (const std::size_t in = find_word(word, "in"); in != std::string_view::npos) {
        ClaimScanner steps(word.substr(in + 2));
        const char* const where = steps.rest().data();
        const Integer number = parse_number(steps, "a number of steps");
        if (!number.fits_uint64())
            throw SyntaxError{where, "expected a number of steps below 2^64"};
        number_of_steps = number.to_uint64();
        if (!steps.take_word("steps") && !steps.take_word("step"))
            throw unexpected("'steps'", steps.here);
        if (!steps.at_end()) throw unexpected("the end of the statement", steps.here);
        word = before(word, in);
    }
    if (const auto rewriting = reading.rewriting(name))
        return parse_rewriting(rewriting, from, word, number_of_steps, reading);
    Derives said{reading.system(name), {}, {}, number_of_steps};
    if (from) said.from = parse_claimed_word(*from, reading);
    said.word = parse_claimed_word(word, reading);
    return said;
}

/// Reads `P(G ==> W in n steps) = NUMBER`, or `!=`. Throws `SyntaxError`.
void parse_chance(std::string_view text, Statement& statement, ClaimReading& reading) {
    const std::size_t open = text.find('('), close = closing_bracket(text);
    const std::string_view inside = text.substr(open + 1, close - open - 1);
    const auto derivation = parse_derivation(inside, reading);
    if (const auto* said = std::get_if<Derives>(&derivation))
        throw SyntaxError{inside.data() + inside.find_first_not_of(' '),
                          "expected a system with probabilities (S0L, PS0L, parametric), found '" +
                              said->system->name + "', which has none"};
    const Rewrites& said = std::get<Rewrites>(derivation);
    if (class_of(*said.system).open)
        throw SyntaxError{inside.data() + inside.find_first_not_of(' '),
                          "expected a system without communication modules, found '" +
                              said.system->name + "', whose environments leave nothing to chance"};
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
    statement.says = HasChance{said, *value.exact};
}

/// Where a word that is written before `in` ends: in front of that, and of `not`.
struct InPlace {
    std::size_t word_end = 0;
    std::size_t behind = 0;
    bool negated = false;
};

std::optional<InPlace> find_in(std::string_view text) {
    const std::size_t in = find_word(text, "in");
    if (in == std::string_view::npos) return std::nullopt;
    InPlace place{in, in + 2, false};
    const std::string_view left = trimmed(before(text, in));
    if (left == "not" ||
        (left.ends_with("not") && is_blank(static_cast<unsigned char>(left[left.size() - 4])))) {
        place.negated = true;
        place.word_end = static_cast<std::size_t>(left.data() - text.data()) + left.size() - 3;
    }
    return place;
}

/// `E is ...`, from behind `is`.
void parse_property(ClaimScanner& scanner, const Language& language, Statement& statement) {
    statement.negated = scanner.take_word("not");
    const char* const where = scanner.rest().data();
    const std::string_view property = scanner.take_piece();
    if (property == "finite" || property == "infinite") {
        statement.says = IsFinite{language};
        if (property == "infinite") statement.negated = !statement.negated;
    } else if (property == "empty") {
        statement.says = IsEmpty{language};
    } else if (const auto family = language_family(property)) {
        statement.says = InFamily{language, *family};
    } else {
        const std::string expected =
            "a family (0L, PD0L, ET0L, regular, ...), finite, infinite or empty";
        if (property.empty()) throw unexpected(expected, where);
        std::vector<std::string> candidates = common_families();
        for (const char* word : {"finite", "infinite", "empty"}) candidates.emplace_back(word);
        throw SyntaxError{where, "expected " + expected + ", found " + quoted(property) +
                                     did_you_mean(property, candidates)};
    }
}

/// What is said of one language, or of two.
void parse_about_languages(ClaimScanner& scanner, Statement& statement, ClaimReading& reading) {
    const Language left = parse_language(scanner, reading).language;
    if (scanner.take_word("is")) return parse_property(scanner, left, statement);
    const bool included = scanner.take("<=");
    statement.negated = scanner.take("!=");
    if (!included && !statement.negated && !scanner.take("=="))
        throw unexpected("an operator, 'is', '==', '!=' or '<='", scanner.here);
    const Language right = parse_language(scanner, reading).language;
    if (included)
        statement.says = IncludedIn{left, right};
    else
        statement.says = EqualLanguages{left, right};
}

void parse_size(ClaimScanner& scanner, Statement& statement, ClaimReading& reading) {
    scanner.take("|");
    const Language language = parse_language(scanner, reading, true).language;
    if (!scanner.take("|")) throw unexpected("an operator or '|' and '='", scanner.here);
    statement.negated = scanner.take("!=");
    if (!statement.negated && !scanner.take("="))
        throw unexpected("'=' and a number of words", scanner.here);
    statement.says = HasSize{language, parse_number(scanner, "a number of words")};
}

void parse_body(std::string_view text, Statement& statement, ClaimReading& reading) {
    ClaimScanner scanner(text);
    if (is_chance(text)) return parse_chance(text, statement, reading);
    if (text.find("==>") != std::string_view::npos) {
        std::visit([&](const auto& said) { statement.says = said; },
                   parse_derivation(text, reading));
        return;
    }
    if (const auto in = find_in(text)) {
        statement.negated = in->negated;
        Word word = parse_claimed_word(before(text, in->word_end), reading);
        scanner.here = text.data() + in->behind;
        statement.says = HasWord{parse_language(scanner, reading).language, std::move(word)};
    } else if (scanner.name() == "growth" || scanner.name() == "sequence") {
        parse_growth(scanner, statement, reading);
    } else if (scanner.name() == "dimension" || scanner.name() == "boundary") {
        parse_dimension(scanner, statement, reading);
    } else if (scanner.rest().starts_with('|')) {
        parse_size(scanner, statement, reading);
    } else {
        parse_about_languages(scanner, statement, reading);
    }
    if (!scanner.at_end()) throw unexpected("the end of the statement", scanner.here);
}

}  // namespace

/// The statement that is the whole of the text: `A is not 0L`, `A == B`, `a in A`, `|A| = 3`,
/// `G ==> aab in 3 steps`, `growth(G) ~ exponential`, ... Throws `SyntaxError` or `DependsOnError`.
Statement parse_statement(std::string_view text, ClaimReading& reading) {
    Statement statement;
    statement.text = trimmed(text);
    statement.place = reading.source.place(text.data());
    ClaimScanner scanner(text);
    const bool denied = scanner.take_word("not");
    const char* const where = scanner.rest().data();
    if (scanner.at_end()) throw unexpected("a statement", where);
    parse_body(scanner.rest(), statement, reading);
    if (denied && statement.negated)
        throw SyntaxError{where, "expected at most one negation, found a second behind 'not'"};
    statement.negated = denied != statement.negated;
    return statement;
}

namespace {

bool is_one_of(const std::vector<std::string>& all, std::string_view word) {
    return std::find(all.begin(), all.end(), word) != all.end();
}

/// The words up to a colon, with one blank between any two.
std::string take_operation(ClaimScanner& scanner) {
    const std::string_view rest = scanner.rest();
    ClaimScanner words(rest.substr(0, rest.find(':')));
    std::string operation;
    while (!words.at_end())
        operation += (operation.empty() ? "" : " ") + std::string(words.take_piece());
    scanner.here = words.end;
    return operation;
}

}  // namespace

bool is_closure_fact(std::string_view text) {
    ClaimScanner scanner(text);
    scanner.take_word("not");
    return scanner.take_word("closed");
}

ClosureFact parse_closure_fact(std::string_view text, const ClaimReading& reading) {
    ClosureFact fact;
    fact.place = reading.source.place(text.data());
    ClaimScanner scanner(text);
    fact.closed = !scanner.take_word("not");
    scanner.take_word("closed");
    if (!scanner.take_word("under")) throw unexpected("'under' after 'closed'", scanner.here);
    const char* const where = scanner.rest().data();
    fact.operation = take_operation(scanner);
    if (fact.operation.empty()) throw unexpected("an operation", where);
    if (!is_one_of(closure_operations(), fact.operation))
        throw SyntaxError{where, "expected an operation (" + listed(closure_operations()) +
                                     "), found " + algae::quoted(fact.operation) +
                                     did_you_mean(fact.operation, closure_operations())};
    if (!scanner.take(":")) throw unexpected("':' and families", scanner.here);
    do {
        const char* const family_place = scanner.rest().data();
        const std::string_view family = scanner.take_piece();
        if (family.empty()) throw unexpected("a family", family_place);
        if (!is_one_of(closure_families(), family))
            throw SyntaxError{family_place, "expected a family of the table (" +
                                                listed(closure_families()) + "), found " +
                                                quoted(family) +
                                                did_you_mean(family, closure_families())};
        if (is_one_of(fact.families, family))
            throw SyntaxError{family_place,
                              "the family " + std::string(family) + " stands there twice"};
        fact.families.emplace_back(family);
    } while (!scanner.at_end());
    return fact;
}

}  // namespace algae
