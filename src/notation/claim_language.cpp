#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "notation/detail/claim_reading.hpp"

// Languages in claims: words, finite sets, morphisms, regular expressions and what operations make of
// languages.
//
// Recursive descent, one function a level of the notation, from the loosest to the tightest: union and
// difference (`|`, `\`), intersection, concatenation (`.` or nothing), complement `~`, postfix `*`, `+`,
// `^R`, then names, sets, `L(G)`, `/regular/`, images under morphisms and their inverses. What descends is
// bounded: brackets nest at most 200 deep, and chains of prefixes and postfixes are loops. The trees that
// come out are bounded too, because those who work on them do recurse: 1,000 operations inside each other, a
// million parts with names written out (`LanguageOperand`).
//
// Braces open a set or a morphism; an arrow between them tells which. Between slashes, letters next to each
// other are one word and choices of words one finite set, so that long words become one leaf and not a chain
// of concatenations (`Gathered`).

namespace algae {

namespace {

/// What stands between the braces, the first of which stands next; nothing if there is no other.
std::string_view inside_braces(ClaimScanner& scanner) {
    const std::string_view rest = scanner.rest();
    if (!rest.starts_with('{')) return {};
    const char* const close = closing_brace(rest.data(), scanner.end);
    if (!close) return {};
    return rest.substr(1, static_cast<std::size_t>(close - rest.data()) - 1);
}

/// Moves over the line breaks and comments of a set.
void skip_comments(ClaimScanner& scanner) {
    while (scanner.rest().starts_with('#') &&
           is_blank(static_cast<unsigned char>(scanner.here[-1]))) {
        const std::string_view rest = scanner.rest();
        scanner.here += std::min(rest.find('\n'), rest.size());
    }
}

/// Reads a word in a set: comments may stand in it.
Word parse_element(ClaimScanner& scanner, ClaimReading& reading) {
    Word word;
    const char* const begin = scanner.here;
    bool is_there = false;
    while (true) {
        skip_comments(scanner);
        const std::string_view rest = scanner.rest();
        std::size_t length = std::min(rest.find_first_of(",{}#\n"), rest.size());
        if (length == 0 && rest.starts_with('#')) length = 1;  // no comment: parse_symbols says so
        if (length == 0) break;
        const Word piece = parse_symbols(rest.substr(0, length), reading.lexicon);
        word.insert(word.end(), piece.begin(), piece.end());
        is_there = true;
        scanner.here += length;
    }
    if (!is_there) throw unexpected("a word (the empty word is ε)", begin);
    return word;
}

/// Reads the finite set `{a, ab, ε}` that stands next.
Language parse_set(ClaimScanner& scanner, ClaimReading& reading) {
    std::vector<Word> words;
    scanner.take("{");
    skip_comments(scanner);
    if (scanner.take("}")) return words_language({});
    while (true) {
        words.push_back(parse_element(scanner, reading));
        if (scanner.take("}")) return words_language(std::move(words));
        if (!scanner.take(",")) throw unexpected("',' or '}'", scanner.here);
    }
}

}  // namespace

/// The word that is the whole of the text; ε is the empty word, a text without anything is none.
Word parse_claimed_word(std::string_view text, ClaimReading& reading) {
    const std::string_view word = trimmed(text);
    if (word.empty()) throw unexpected("a word (the empty word is ε)", text.data());
    return parse_symbols(word, reading.lexicon);
}

/// Whether a morphism between braces stands next, not a set of words: there is an arrow between them.
bool is_morphism(ClaimScanner& scanner) {
    const std::vector<Clause> inside = clauses(inside_braces(scanner));
    return std::any_of(inside.begin(), inside.end(),
                       [](const Clause& clause) { return clause.arrow != nullptr; });
}

/// Reads the morphism `{ a -> ab; b -> ε }` that stands next.
Morphism parse_morphism(ClaimScanner& scanner, ClaimReading& reading) {
    const std::string_view text = inside_braces(scanner);
    Morphism morphism;
    for (const Clause& clause : clauses(text)) {
        if (!clause.arrow) throw unexpected("a letter, '->' and a word", clause.text.data());
        const auto left_size = static_cast<std::size_t>(clause.arrow - clause.text.data());
        const std::string_view left = trimmed(clause.text.substr(0, left_size));
        const std::size_t arrow_size = *clause.arrow == '-' ? 2 : std::string_view("→").size();
        const Word letter = parse_symbols(left, reading.lexicon);
        if (letter.size() != 1) throw unexpected("one letter before the arrow", clause.text.data());
        Word image = parse_symbols(clause.text.substr(left_size + arrow_size), reading.lexicon);
        if (!morphism.add(letter[0], std::move(image)))
            throw SyntaxError{clause.text.data(), "the letter " + quoted(left) + " has two images"};
    }
    scanner.here = text.data() + text.size() + 1;
    return morphism;
}

namespace {

using Kind = LanguageTree::Kind;

/// How many operations a language may have inside each other, and how many parts.
constexpr std::size_t most_levels = 1000;
constexpr std::size_t most_parts = 1'000'000;

SyntaxError too_deep(const char* where) {
    return {where, "a language with more than " + std::to_string(most_levels) +
                       " operations inside each other"};
}

/// What the bounds say of an operation on these parts; the language is still missing.
LanguageOperand measured(const std::vector<LanguageOperand>& parts, const char* where) {
    LanguageOperand out;
    for (const LanguageOperand& part : parts) {
        out.levels = std::max(out.levels, part.levels + 1);
        out.parts += part.parts;
    }
    if (out.levels > most_levels) throw too_deep(where);
    if (out.parts > most_parts)
        throw SyntaxError{where, "a language with more than " + std::to_string(most_parts) +
                                     " parts where its names are written out"};
    return out;
}

/// The language that an operation makes of others; `where` it is written. Throws `SyntaxError` if the
/// expression becomes too deep or too large.
LanguageOperand combined_operand(Kind kind, std::vector<LanguageOperand> parts, const char* where) {
    LanguageOperand out = measured(parts, where);
    std::vector<Language> languages;
    for (LanguageOperand& part : parts) languages.push_back(std::move(part.language));
    out.language = combined(kind, std::move(languages));
    return out;
}

/// The words that are not in the language, over the letters that the claim declares or else those of the
/// language. Throws `SyntaxError` if there are none, or it has others.
LanguageOperand complement_operand(LanguageOperand part, const ClaimReading& reading,
                                   const char* where) {
    LanguageOperand out = measured({part}, where);
    std::vector<Symbol> letters = letters_of(part.language);
    if (!reading.declared.empty()) {
        for (const Symbol letter : letters)
            if (!std::binary_search(reading.declared.begin(), reading.declared.end(), letter))
                throw SyntaxError{
                    where, "expected a language over the letters of 'alphabet', found the letter " +
                               reading.alphabet->name(letter)};
        letters = reading.declared;
    }
    if (letters.empty())
        throw SyntaxError{where,
                          "expected a language with letters after '~', found one without; "
                          "'alphabet a b' says what letters there are"};
    out.language = complement_language(std::move(part.language), std::move(letters));
    return out;
}

/// The image of the language under a morphism; `name` is what the text calls that. Throws `SyntaxError` if
/// a letter of the language has no image.
LanguageOperand image_operand(LanguageOperand part, const Morphism& morphism, std::string_view name,
                              const ClaimReading& reading) {
    LanguageOperand out = measured({part}, name.data());
    for (const Symbol letter : letters_of(part.language))
        if (!morphism.maps(letter))
            throw SyntaxError{name.data(),
                              "expected a morphism with an image for each letter of the language, "
                              "found none for " +
                                  reading.alphabet->name(letter)};
    out.language = image_language(std::move(part.language), morphism);
    return out;
}

LanguageOperand inverse_image_operand(LanguageOperand part, const Morphism& morphism,
                                      const char* where) {
    LanguageOperand out = measured({part}, where);
    out.language = inverse_image_language(std::move(part.language), morphism);
    return out;
}

/// Factors or choices put together as they come: neighbours that are words become one finite set.
class Gathered {
public:
    Gathered(Kind kind, const char* where) : kind_(kind), where_(where) {}

    void add_word(Word word) {
        if (kind_ == Kind::concatenated && !words_.empty())
            words_[0].insert(words_[0].end(), word.begin(), word.end());
        else
            words_.push_back(std::move(word));
    }

    void add(LanguageOperand operand) {
        const LanguageTree& tree = *operand.language;
        const bool joins =
            tree.kind == Kind::words && (kind_ == Kind::united || tree.words.size() == 1);
        if (!joins) {
            flush();
            return join(std::move(operand));
        }
        for (const Word& word : tree.words) add_word(word);
    }

    LanguageOperand finish() {
        flush();
        return std::move(*whole_);
    }

private:
    void flush() {
        if (words_.empty()) return;
        join({words_language(std::exchange(words_, {})), 0, 1});
    }
    void join(LanguageOperand operand) {
        whole_ = whole_ ? combined_operand(kind_, {std::move(*whole_), std::move(operand)}, where_)
                        : std::move(operand);
    }

    Kind kind_;
    const char* where_;
    std::vector<Word> words_;  // of a concatenation at most one
    std::optional<LanguageOperand> whole_;
};

class RegularParser {
public:
    RegularParser(ClaimScanner& scanner, ClaimReading& reading)
        : scanner_(scanner), reading_(reading) {}

    LanguageOperand whole() {
        const char* const open = scanner_.rest().data();
        scanner_.take("/");
        const std::string_view rest = scanner_.rest();
        if (rest.find('/') == std::string_view::npos)
            throw SyntaxError{open, "'/' is never closed"};
        LanguageOperand operand = choice();
        if (scanner_.take("/")) return operand;
        throw unexpected("a letter, an operator or '/'", scanner_.here);
    }

private:
    static constexpr std::size_t most_brackets = 200;

    LanguageOperand choice() {
        Gathered choices(Kind::united, scanner_.rest().data());
        do {
            choices.add(product());
        } while (scanner_.take("|"));
        return choices.finish();
    }

    LanguageOperand product() {
        Gathered factors(Kind::concatenated, scanner_.rest().data());
        do {
            // A letter that stays as it is needs no language of its own: long words are read fast.
            const ClaimScanner before_letter = scanner_;
            std::optional<Word> letter = take_letter();
            if (letter && !is_repeated()) {
                factors.add_word(*letter);
            } else {
                scanner_ = before_letter;
                factors.add(factor());
            }
        } while (!ends());
        return factors.finish();
    }

    LanguageOperand factor() {
        const char* const where = scanner_.rest().data();
        if (std::optional<Word> letter = take_letter())
            return repeated({words_language({std::move(*letter)}), 0, 1});
        if (!scanner_.take("(")) throw unexpected("a letter or '(' (the empty word is ε)", where);
        if (++brackets_ > most_brackets)
            throw SyntaxError{where, "more than " + std::to_string(most_brackets) +
                                         " brackets inside each other"};
        LanguageOperand inner = choice();
        --brackets_;
        if (!scanner_.take(")")) throw unexpected("a letter, an operator or ')'", scanner_.here);
        return repeated(std::move(inner));
    }

    LanguageOperand repeated(LanguageOperand operand) {
        while (true) {
            const char* const where = scanner_.rest().data();
            if (scanner_.take("?")) {
                Gathered choices(Kind::united, where);
                choices.add(std::move(operand));
                choices.add_word({});
                operand = choices.finish();
            } else if (scanner_.take("*")) {
                operand = combined_operand(Kind::star, {std::move(operand)}, where);
            } else if (scanner_.take("+")) {
                operand = combined_operand(Kind::plus, {std::move(operand)}, where);
            } else {
                return operand;
            }
        }
    }

    /// Moves over a letter or ε and says what word it is.
    std::optional<Word> take_letter() {
        const std::string_view rest = scanner_.rest();
        if (scanner_.take("ε")) return Word();
        if (rest.empty() || std::string_view("|*+?()/").find(rest[0]) != std::string_view::npos)
            return std::nullopt;
        if (std::string_view(".^$\\[]{}").find(rest[0]) != std::string_view::npos)
            throw SyntaxError{rest.data(), "expected a letter, found " + quoted(rest.substr(0, 1)) +
                                               ", which has no meaning between slashes"};
        std::string_view after = rest;
        const std::optional<Symbol> letter = reading_.lexicon.next(after);
        if (!letter) return std::nullopt;
        scanner_.here = after.data();
        return Word{*letter};
    }

    bool ends() {
        const std::string_view rest = scanner_.rest();
        return rest.empty() || rest[0] == '|' || rest[0] == ')' || rest[0] == '/';
    }

    bool is_repeated() {
        const std::string_view rest = scanner_.rest();
        return !rest.empty() && (rest[0] == '*' || rest[0] == '+' || rest[0] == '?');
    }

    ClaimScanner& scanner_;
    ClaimReading& reading_;
    std::size_t brackets_ = 0;
};

/// Reads the regular expression between slashes that stands next, `/a(aa)*|b?/`, as a language: letters next
/// to each other are one word, choices of words one finite set. Throws `SyntaxError`. Brackets nest at
/// most 200 deep, operations 1000. Linear.
LanguageOperand parse_regular(ClaimScanner& scanner, ClaimReading& reading) {
    return RegularParser(scanner, reading).whole();
}

/// Recursive descent, one function a level of the notation.
class LanguageParser {
public:
    LanguageParser(ClaimScanner& scanner, ClaimReading& reading)
        : scanner_(scanner), reading_(reading) {}

    LanguageOperand sum(bool between_bars) {
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

private:
    static constexpr std::size_t most_brackets = 200;

    LanguageOperand intersection() {
        LanguageOperand left = product();
        while (true) {
            const char* const where = scanner_.rest().data();
            if (!scanner_.take("&")) return left;
            left = combined_operand(Kind::intersected, {std::move(left), product()}, where);
        }
    }

    LanguageOperand product() {
        LanguageOperand left = prefix();
        while (true) {
            const char* const where = scanner_.rest().data();
            if (!scanner_.take(".") && !starts_factor()) return left;
            left = combined_operand(Kind::concatenated, {std::move(left), prefix()}, where);
        }
    }

    LanguageOperand prefix() {
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

    LanguageOperand postfix() {
        LanguageOperand operand = primary();
        while (true) {
            const char* const where = scanner_.rest().data();
            Kind kind = Kind::star;
            if (scanner_.take("+")) {
                kind = Kind::plus;
            } else if (scanner_.take("^")) {
                if (!scanner_.take_word("R"))
                    throw unexpected("R after '^' (reversal)", scanner_.here);
                kind = Kind::reversed;
            } else if (!scanner_.take("*")) {
                return operand;
            }
            operand = combined_operand(kind, {std::move(operand)}, where);
        }
    }

    LanguageOperand primary() {
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

    LanguageOperand named() {
        const std::string_view name = scanner_.take_name();
        if (name == "L" && scanner_.rest().starts_with('(')) return generated();
        const ClaimName& known = reading_.expect(name);
        switch (known.kind) {
            case ClaimName::Kind::system:
                throw SyntaxError{name.data(), "expected a language, found the system " +
                                                   quoted(name) + "; its language is L(" +
                                                   std::string(name) + ")"};
            case ClaimName::Kind::morphism:
                return applied(known.morphism, name);
            default:
                return known.language;
        }
    }

    LanguageOperand generated() {
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

    LanguageOperand applied(const Morphism& morphism, std::string_view name) {
        bool inverse = false;
        if (scanner_.take("^")) {
            inverse = scanner_.take("-1");
            if (!inverse)
                throw unexpected("-1 after '^' (the inverse of a morphism)", scanner_.here);
        }
        if (!scanner_.rest().starts_with('('))
            throw unexpected(inverse ? "'(' and a language after the inverse of a morphism"
                                     : "'(' and a language after a morphism",
                             scanner_.here);
        LanguageOperand operand = bracketed();
        return inverse ? inverse_image_operand(std::move(operand), morphism, name.data())
                       : image_operand(std::move(operand), morphism, name, reading_);
    }

    LanguageOperand bracketed() {
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

    bool starts_factor() {
        const std::string_view rest = scanner_.rest();
        if (rest.empty()) return false;
        if (rest[0] == '{' || rest[0] == '/' || rest[0] == '(' || rest[0] == '~') return true;
        const std::string_view name = scanner_.name();
        return !name.empty() && name != "is" && name != "in" && name != "not" && name != "by";
    }

    ClaimScanner& scanner_;
    ClaimReading& reading_;
    std::size_t brackets_ = 0;
};

}  // namespace

LanguageOperand parse_language(ClaimScanner& scanner, ClaimReading& reading, bool between_bars) {
    return LanguageParser(scanner, reading).sum(between_bars);
}

}  // namespace algae
