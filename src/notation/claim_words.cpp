#include "notation/claim_words.hpp"

#include <algorithm>
#include <utility>

#include "notation/characters.hpp"
#include "notation/claim_clauses.hpp"
#include "notation/clauses.hpp"
#include "notation/word_grammar.hpp"

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

}  // namespace

Word parse_claimed_word(std::string_view text, ClaimReading& reading) {
    const std::string_view word = trimmed(text);
    if (word.empty()) throw unexpected("a word (the empty word is ε)", text.data());
    return parse_symbols(word, reading.lexicon);
}

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

bool is_morphism(ClaimScanner& scanner) {
    const std::vector<Clause> inside = clauses(inside_braces(scanner));
    return std::any_of(inside.begin(), inside.end(),
                       [](const Clause& clause) { return clause.arrow != nullptr; });
}

std::map<Symbol, Word> parse_morphism(ClaimScanner& scanner, ClaimReading& reading) {
    const std::string_view text = inside_braces(scanner);
    std::map<Symbol, Word> morphism;
    for (const Clause& clause : clauses(text)) {
        if (!clause.arrow) throw unexpected("a letter, '->' and a word", clause.text.data());
        const auto left_size = static_cast<std::size_t>(clause.arrow - clause.text.data());
        const std::string_view left = trimmed(clause.text.substr(0, left_size));
        const std::size_t arrow_size = *clause.arrow == '-' ? 2 : std::string_view("→").size();
        const Word letter = parse_symbols(left, reading.lexicon);
        if (letter.size() != 1) throw unexpected("one letter before the arrow", clause.text.data());
        Word image = parse_symbols(clause.text.substr(left_size + arrow_size), reading.lexicon);
        if (!morphism.emplace(letter[0], std::move(image)).second)
            throw SyntaxError{clause.text.data(), "the letter " + quoted(left) + " has two images"};
    }
    scanner.here = text.data() + text.size() + 1;
    return morphism;
}

}  // namespace algae
