#include <algorithm>

#include "automatic/automatic.hpp"
#include "model/model.hpp"
#include "notation/detail/claim_reading.hpp"
#include "notation/detail/grammar.hpp"

// First-order statements about infinite words in claims.
//
// `in T: ...` says of which system; without it a statement that begins with a quantifier over numbers is one if `T[` stands in it and T
// is a system. The rest is read by the room `automatic`, whose places are put into those of the file.

namespace algae {

namespace {

/// The words `in T:` before a statement.
struct Beginning {
    std::string_view system;
    std::size_t length = 0;
};

std::optional<Beginning> beginning(std::string_view text) {
    if (!text.starts_with("in ")) return std::nullopt;
    const std::size_t colon = text.find(':');
    if (colon == std::string_view::npos) return std::nullopt;
    const std::string_view name = trimmed(text.substr(3, colon - 3));
    if (!is_claim_name(name)) return std::nullopt;
    return Beginning{name, colon + 1};
}

/// Throws the finding of another reader, made of the text, as one at its place in the file.
[[noreturn]] void rethrow(const Diagnostic& finding, std::string_view text) {
    std::size_t at = 0;
    for (std::size_t line = 1; line < finding.place.line; ++line) at = text.find('\n', at) + 1;
    const auto is_first = [&] { return (static_cast<unsigned char>(text[at]) & 0xC0) != 0x80; };
    for (std::size_t passed = 0; at < text.size(); ++at)
        if (is_first() && passed++ == finding.caret) break;
    throw SyntaxError{text.data() + at, finding.message};
}

}  // namespace

std::optional<std::string_view> first_order_system(std::string_view text,
                                                   const ClaimReading& reading) {
    if (const auto begun = beginning(text)) return begun->system;
    std::string_view rest = text;
    while (rest.starts_with("not ") || rest.starts_with('('))
        rest = trimmed(rest.substr(rest.starts_with('(') ? 1 : 4));
    if (!rest.starts_with("for all ") && !rest.starts_with("for some ") &&
        !rest.starts_with("there is "))
        return std::nullopt;
    if (text.find("==>") != std::string_view::npos) return std::nullopt;
    for (std::size_t open = text.find('['); open != std::string_view::npos;
         open = text.find('[', open + 1)) {
        std::size_t begin = open;
        while (begin > 0 && is_claim_name("a" + std::string(1, text[begin - 1]))) --begin;
        const std::string_view name = text.substr(begin, open - begin);
        const ClaimName* known = name.empty() ? nullptr : reading.find(name);
        if (known && known->written && known->kind == ClaimName::Kind::system) return name;
    }
    return std::nullopt;
}

Statement parse_first_order(std::string_view system, std::string_view text, ClaimReading& reading) {
    const char* const where = text.data();
    const std::string_view whole = text;
    if (const auto begun = beginning(text)) text = text.substr(begun->length);
    HoldsInWord said;
    said.system = reading.system(system);
    const std::shared_ptr<const Model> model = reading.written(system);
    if (!as_d0l(*model))
        throw SyntaxError{system.data(),
                          "expected a D0L system, whose words may begin one infinite "
                          "word, found " +
                              quoted(system)};
    std::vector<std::string> letters;
    const LetterCoding coding(model->alphabet, model->coding);
    for (Symbol a = 0; a < model->alphabet.size(); ++a) {
        letters.push_back(coding.alphabet.name(coding.morphism[a].front()));
        if (letters.back() != model->alphabet.name(a))
            said.coding[model->alphabet.name(a)] = letters.back();
    }
    try {
        said.says = std::make_shared<const FirstOrderStatement>(
            read_first_order(text, "", std::string(system), letters));
    } catch (const Diagnostics& error) {
        rethrow(error.findings().front(), text);
    }
    if (!said.says->free().empty())
        throw SyntaxError{where, "expected a quantifier for each number, found " +
                                     quoted(said.says->free().front()) +
                                     " without one; begin with 'for all " +
                                     said.says->free().front() + ":'"};
    Statement made;
    made.text = trimmed(whole);
    made.place = reading.source.place(where);
    made.says = std::move(said);
    return made;
}

}  // namespace algae
