#include "notation/claim_statement.hpp"

#include <charconv>
#include <string>

#include "notation/characters.hpp"
#include "notation/claim_dimension.hpp"
#include "notation/claim_families.hpp"
#include "notation/claim_growth.hpp"
#include "notation/claim_language.hpp"
#include "notation/claim_rewriting.hpp"
#include "notation/claim_words.hpp"
#include "notation/suggestion.hpp"

namespace algae {

namespace {

using Kind = Statement::Kind;

std::string_view before(std::string_view text, std::size_t offset) {
    return text.substr(0, offset);
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
void parse_property(ClaimScanner& scanner, Statement& statement) {
    statement.negated = scanner.take_word("not");
    const char* const where = scanner.rest().data();
    const std::string_view property = scanner.take_piece();
    if (property == "finite" || property == "infinite") {
        statement.kind = Kind::finite;
        if (property == "infinite") statement.negated = !statement.negated;
    } else if (property == "empty") {
        statement.kind = Kind::empty;
    } else if (const auto family = language_family(property)) {
        statement.kind = Kind::family;
        statement.family = *family;
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
    statement.languages.push_back(parse_language(scanner, reading).language);
    if (scanner.take_word("is")) return parse_property(scanner, statement);
    if (scanner.take("==")) {
        statement.kind = Kind::equal;
    } else if (scanner.take("!=")) {
        statement.kind = Kind::equal;
        statement.negated = true;
    } else if (scanner.take("<=")) {
        statement.kind = Kind::included;
    } else {
        throw unexpected("an operator, 'is', '==', '!=' or '<='", scanner.here);
    }
    statement.languages.push_back(parse_language(scanner, reading).language);
}

void parse_size(ClaimScanner& scanner, Statement& statement, ClaimReading& reading) {
    statement.kind = Kind::size;
    scanner.take("|");
    statement.languages.push_back(parse_language(scanner, reading, true).language);
    if (!scanner.take("|")) throw unexpected("an operator or '|' and '='", scanner.here);
    statement.negated = scanner.take("!=");
    if (!statement.negated && !scanner.take("="))
        throw unexpected("'=' and a number of words", scanner.here);
    statement.size = parse_number(scanner, "a number of words");
}

void parse_body(std::string_view text, Statement& statement, ClaimReading& reading) {
    ClaimScanner scanner(text);
    if (is_chance(text)) return parse_chance(text, statement, reading);
    if (text.find("==>") != std::string_view::npos)
        return parse_derivation(text, statement, reading);
    if (const auto in = find_in(text)) {
        statement.kind = Kind::member;
        statement.negated = in->negated;
        statement.word = parse_claimed_word(before(text, in->word_end), reading);
        scanner.here = text.data() + in->behind;
        statement.languages.push_back(parse_language(scanner, reading).language);
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

void parse_derivation(std::string_view text, Statement& statement, ClaimReading& reading) {
    const std::size_t arrow = text.find("==>");
    const std::string_view left = before(text, arrow);
    const std::size_t colon = left.find(':');
    const std::string_view name = trimmed(before(left, colon));
    if (name.empty()) throw unexpected("the name of a system", text.data());
    std::optional<std::string_view> from;
    if (colon != std::string_view::npos) from = left.substr(colon + 1);
    std::string_view word = text.substr(arrow + 3);
    if (const std::size_t in = find_word(word, "in"); in != std::string_view::npos) {
        ClaimScanner steps(word.substr(in + 2));
        const char* const where = steps.rest().data();
        const Integer number = parse_number(steps, "a number of steps");
        if (!number.fits_uint64())
            throw SyntaxError{where, "expected a number of steps below 2^64"};
        statement.steps = number.to_uint64();
        if (!steps.take_word("steps") && !steps.take_word("step"))
            throw unexpected("'steps'", steps.here);
        if (!steps.at_end()) throw unexpected("the end of the statement", steps.here);
        word = before(word, in);
    }
    if (const auto rewriting = reading.rewriting(name))
        return parse_rewriting(rewriting, from, word, statement.steps, statement, reading);
    statement.kind = Kind::derives;
    statement.systems.push_back(reading.system(name));
    if (from) statement.from = parse_claimed_word(*from, reading);
    statement.word = parse_claimed_word(word, reading);
}

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

}  // namespace algae
