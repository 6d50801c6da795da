#include "notation/claim_language.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "notation/characters.hpp"
#include "notation/claim_clauses.hpp"
#include "notation/claim_operations.hpp"
#include "notation/claim_regular.hpp"
#include "notation/claim_words.hpp"

namespace algae {

namespace {

using Kind = LanguageTree::Kind;

/// Recursive descent, one function a level of the notation.
class LanguageParser {
public:
    LanguageParser(ClaimScanner& scanner, ClaimReading& reading)
        : scanner_(scanner), reading_(reading) {}

    LanguageOperand sum(bool between_bars);

private:
    static constexpr std::size_t most_brackets = 200;

    LanguageOperand intersection();
    LanguageOperand product();
    LanguageOperand prefix();
    LanguageOperand postfix();
    LanguageOperand primary();
    LanguageOperand named();
    LanguageOperand generated();
    LanguageOperand applied(const std::map<Symbol, Word>& morphism, std::string_view name);
    LanguageOperand bracketed();

    bool starts_factor();

    ClaimScanner& scanner_;
    ClaimReading& reading_;
    std::size_t brackets_ = 0;
};

LanguageOperand LanguageParser::sum(bool between_bars) {
    LanguageOperand left = intersection();
    while (true) {
        const char* const where = scanner_.rest().data();
        if (between_bars && scanner_.rest().starts_with('|')) {
            ClaimScanner ahead = scanner_;
            ahead.take("|");
            if (ahead.take("=") || ahead.take("!=")) return left;
        }
        const bool united = scanner_.take("|");
        if (!united && !scanner_.take("\\")) return left;
        left = combined_operand(united ? Kind::united : Kind::difference,
                                {std::move(left), intersection()}, where);
    }
}

LanguageOperand LanguageParser::intersection() {
    LanguageOperand left = product();
    while (true) {
        const char* const where = scanner_.rest().data();
        if (!scanner_.take("&")) return left;
        left = combined_operand(Kind::intersected, {std::move(left), product()}, where);
    }
}

bool LanguageParser::starts_factor() {
    const std::string_view rest = scanner_.rest();
    if (rest.empty()) return false;
    if (rest[0] == '{' || rest[0] == '/' || rest[0] == '(' || rest[0] == '~') return true;
    const std::string_view name = scanner_.name();
    return !name.empty() && name != "is" && name != "in" && name != "not" && name != "by";
}

LanguageOperand LanguageParser::product() {
    LanguageOperand left = prefix();
    while (true) {
        const char* const where = scanner_.rest().data();
        if (!scanner_.take(".") && !starts_factor()) return left;
        left = combined_operand(Kind::concatenated, {std::move(left), prefix()}, where);
    }
}

LanguageOperand LanguageParser::prefix() {
    std::vector<const char*> signs;
    for (const char* where = scanner_.rest().data(); scanner_.take("~");
         where = scanner_.rest().data()) {
        if (signs.size() == most_levels) throw too_deep(where);
        signs.push_back(where);
    }
    LanguageOperand operand = postfix();
    for (; !signs.empty(); signs.pop_back())
        operand = complement_operand(std::move(operand), reading_, signs.back());
    return operand;
}

LanguageOperand LanguageParser::postfix() {
    LanguageOperand operand = primary();
    while (true) {
        const char* const where = scanner_.rest().data();
        Kind kind = Kind::star;
        if (scanner_.take("+")) {
            kind = Kind::plus;
        } else if (scanner_.take("^")) {
            if (!scanner_.take_word("R")) throw unexpected("R after '^' (reversal)", scanner_.here);
            kind = Kind::reversed;
        } else if (!scanner_.take("*")) {
            return operand;
        }
        operand = combined_operand(kind, {std::move(operand)}, where);
    }
}

LanguageOperand LanguageParser::primary() {
    const std::string_view rest = scanner_.rest();
    if (rest.starts_with('(')) return bracketed();
    if (rest.starts_with('/')) return parse_regular(scanner_, reading_);
    if (is_morphism(scanner_)) {
        const auto morphism = parse_morphism(scanner_, reading_);
        return applied(morphism, rest);
    }
    if (rest.starts_with('{')) return {parse_set(scanner_, reading_), 0, 1};
    if (starts_factor()) return named();
    throw unexpected("a language", scanner_.here);
}

LanguageOperand LanguageParser::bracketed() {
    const char* const open = scanner_.here;
    scanner_.take("(");
    if (++brackets_ > most_brackets)
        throw SyntaxError{
            open, "more than " + std::to_string(most_brackets) + " brackets inside each other"};
    LanguageOperand inner = sum(false);
    --brackets_;
    if (!scanner_.take(")")) throw unexpected("an operator or ')'", scanner_.here);
    return inner;
}

LanguageOperand LanguageParser::generated() {
    scanner_.take("(");
    const std::string_view rest = scanner_.rest();
    const std::string_view name = trimmed(rest.substr(0, rest.find(')')));
    if (name.empty()) throw unexpected("the name of a system", scanner_.here);
    if (name.size() == rest.size()) throw unexpected("')'", rest.data() + rest.size());
    LanguageOperand out{generated_language(reading_.system(name)), 0, 1};
    scanner_.here = name.data() + name.size();
    if (!scanner_.take(")")) throw unexpected("')'", scanner_.here);
    return out;
}

LanguageOperand LanguageParser::named() {
    const std::string_view name = scanner_.take_name();
    if (name == "L" && scanner_.rest().starts_with('(')) return generated();
    const ClaimName& known = reading_.expect(name);
    switch (known.kind) {
        case ClaimName::Kind::system:
            throw SyntaxError{name.data(), "expected a language, found the system " + quoted(name) +
                                               "; its language is L(" + std::string(name) + ")"};
        case ClaimName::Kind::morphism:
            return applied(known.morphism, name);
        default:
            return known.language;
    }
}

LanguageOperand LanguageParser::applied(const std::map<Symbol, Word>& morphism,
                                        std::string_view name) {
    bool inverse = false;
    if (scanner_.take("^")) {
        inverse = scanner_.take("-1");
        if (!inverse) throw unexpected("-1 after '^' (the inverse of a morphism)", scanner_.here);
    }
    if (!scanner_.rest().starts_with('('))
        throw unexpected(inverse ? "'(' and a language after the inverse of a morphism"
                                 : "'(' and a language after a morphism",
                         scanner_.here);
    LanguageOperand operand = bracketed();
    return inverse ? inverse_image_operand(std::move(operand), morphism, name.data())
                   : image_operand(std::move(operand), morphism, name, reading_);
}

}  // namespace

LanguageOperand parse_language(ClaimScanner& scanner, ClaimReading& reading, bool between_bars) {
    return LanguageParser(scanner, reading).sum(between_bars);
}

}  // namespace algae
