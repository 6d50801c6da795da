#include "verify/statement_text.hpp"

#include <array>
#include <charconv>
#include <iomanip>
#include <limits>
#include <locale>
#include <sstream>

namespace algae::verify {

namespace {

constexpr std::size_t longest = 160;  // bytes of one expression

/// The text with a gap in its middle if it is long, cut between characters.
std::string shortened(const std::string& text) {
    if (text.size() <= longest) return text;
    const auto inside = [&](std::size_t i) {
        return (static_cast<unsigned char>(text[i]) & 0xC0) == 0x80;
    };
    std::size_t head = longest / 2, tail = text.size() - longest / 2;
    while (head > 0 && inside(head)) --head;
    while (tail < text.size() && inside(tail)) ++tail;
    return text.substr(0, head) + " ... " + text.substr(tail);
}

std::string morphism_text(const std::map<Symbol, Word>& morphism, const Alphabet& alphabet) {
    std::string text;
    for (const auto& [a, image] : morphism)
        text += (text.empty() ? "" : ", ") + alphabet.name(a) + " -> " + spell(alphabet, image);
    return "[" + text + "]";
}

std::string language_text(const Language& language, const Alphabet& alphabet) {
    const auto part = [&](std::size_t i) { return language_text(language->parts[i], alphabet); };
    const auto of_two = [&](const char* sign) { return "(" + part(0) + sign + part(1) + ")"; };
    std::string text;
    switch (language->kind) {
        case Tree::Kind::words:
            for (const Word& word : language->words)
                text += (text.empty() ? "" : ", ") + spell(alphabet, word);
            text = "{" + text + "}";
            break;
        case Tree::Kind::generated:
            return "L(" + language->name + ")";
        case Tree::Kind::united:
            text = of_two(" | ");
            break;
        case Tree::Kind::intersection:
            text = of_two(" & ");
            break;
        case Tree::Kind::difference:
            text = of_two(" - ");
            break;
        case Tree::Kind::concatenation:
            text = of_two(" ");
            break;
        case Tree::Kind::star:
            text = part(0) + "*";
            break;
        case Tree::Kind::plus:
            text = part(0) + "+";
            break;
        case Tree::Kind::reversal:
            text = "reversal of " + part(0);
            break;
        case Tree::Kind::complement:
            text = "complement of " + part(0) + " over " + spell(alphabet, language->letters);
            break;
        case Tree::Kind::image:
            text = "image of " + part(0) + " under " + morphism_text(language->morphism, alphabet);
            break;
        case Tree::Kind::inverse_image:
            text = "inverse image of " + part(0) + " under " +
                   morphism_text(language->morphism, alphabet);
            break;
    }
    return shortened(text);
}

/// The shortest decimal that is read back as the same number.
std::string shortest_decimal(double value) {
#ifdef __cpp_lib_to_chars
    std::array<char, 400> digits;
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
    return {digits.data(), end};
#else  // a library that converts integers only
    for (int precision = 1;; ++precision) {
        std::ostringstream out;
        out.imbue(std::locale::classic());
        out << std::setprecision(precision) << value;
        if (precision == std::numeric_limits<double>::max_digits10) return out.str();
        std::istringstream in(out.str());
        in.imbue(std::locale::classic());
        double again = 0;
        if (in >> again && again == value) return out.str();
    }
#endif
}

std::string modules_text(const Modules& word) {
    std::string text;
    for (const Module& module : word) {
        text += module.letter;
        std::string list;
        for (const double value : module.values) {
            list += (list.empty() ? "" : ",") + shortest_decimal(value);
        }
        if (!list.empty()) text += "(" + list + ")";
    }
    return text.empty() ? "ε" : shortened(text);
}

std::string plain_text(const Statement& statement, const Alphabet& alphabet, bool opposite) {
    using Kind = Statement::Kind;
    const std::string no = opposite ? "not " : "";
    const auto language = [&](std::size_t i) {
        return language_text(statement.languages[i], alphabet);
    };
    const auto system = [&](std::size_t i) { return statement.systems[i].name; };
    const std::string word = shortened(spell(alphabet, statement.word));
    switch (statement.kind) {
        case Kind::family:
            return language(0) + " is " + no + statement.family;
        case Kind::finite:
            return language(0) + " is " + no + "finite";
        case Kind::empty:
            return language(0) + " is " + no + "empty";
        case Kind::equal:
            return language(0) + (opposite ? " != " : " = ") + language(1);
        case Kind::included:
            return language(0) + (opposite ? " is not within " : " <= ") + language(1);
        case Kind::member:
            return word + " is " + no + "in " + language(0);
        case Kind::size:
            return language(0) + (opposite ? " has not " : " has ") +
                   shortened(to_string(*statement.size)) + " words";
        case Kind::derives:
            return system(0) + (opposite ? " does not derive " : " derives ") + word +
                   (statement.from ? " from " + shortened(spell(alphabet, *statement.from)) : "") +
                   (statement.steps ? " in " + shortened(to_string(*statement.steps)) + " steps"
                                    : "");
        case Kind::rewrites:
        case Kind::chance: {
            const bool is_chance = statement.kind == Kind::chance;
            return statement.family + (opposite && !is_chance ? " does not derive " : " derives ") +
                   modules_text(statement.modules) +
                   (statement.modules_from ? " from " + modules_text(*statement.modules_from)
                                           : "") +
                   " in " + shortened(to_string(*statement.steps)) + " steps" +
                   (is_chance ? std::string(opposite ? ", not" : "") + " with the probability " +
                                    to_string(*statement.probability)
                              : "");
        }
        case Kind::equal_sequences:
            return system(0) + " and " + system(1) + " have " + (opposite ? "different" : "equal") +
                   " sequences";
        case Kind::equal_growth:
            return system(0) + " and " + system(1) + " have " + (opposite ? "different" : "equal") +
                   " lengths";
        case Kind::growth_formula:
            return "the lengths of " + system(0) + " are " + no + "given by the formula";
        case Kind::dimension:
        case Kind::boundary:
            return std::string("the ") +
                   (statement.kind == Kind::dimension ? "dimension" : "boundary's dimension") +
                   " of " + statement.family + " is " + no +
                   (statement.at_most ? "at most " : "") + statement.formula->text();
        case Kind::growth_class:
            break;
    }
    return "the growth of " + system(0) + " is " + no + statement.family +
           (statement.size ? " of degree " + shortened(to_string(*statement.size)) : "");
}

}  // namespace

std::string statement_text(const Statement& statement, bool refuted, const Alphabet& alphabet) {
    return plain_text(statement, alphabet, statement.negated != refuted);
}

}  // namespace algae::verify
