#include "notation/claim_regular.hpp"

#include <optional>
#include <string>
#include <utility>

#include "notation/characters.hpp"
#include "notation/claim_operations.hpp"

namespace algae {

namespace {

using Kind = LanguageTree::Kind;

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

    LanguageOperand whole();

private:
    static constexpr std::size_t most_brackets = 200;

    LanguageOperand choice();
    LanguageOperand product();
    LanguageOperand factor();
    LanguageOperand repeated(LanguageOperand operand);
    /// Moves over a letter or ε and says what word it is.
    std::optional<Word> take_letter();
    bool ends();
    bool is_repeated();

    ClaimScanner& scanner_;
    ClaimReading& reading_;
    std::size_t brackets_ = 0;
};

LanguageOperand RegularParser::whole() {
    const char* const open = scanner_.rest().data();
    scanner_.take("/");
    const std::string_view rest = scanner_.rest();
    if (rest.find('/') == std::string_view::npos) throw SyntaxError{open, "'/' is never closed"};
    LanguageOperand operand = choice();
    if (scanner_.take("/")) return operand;
    throw unexpected("a letter, an operator or '/'", scanner_.here);
}

LanguageOperand RegularParser::choice() {
    Gathered choices(Kind::united, scanner_.rest().data());
    do {
        choices.add(product());
    } while (scanner_.take("|"));
    return choices.finish();
}

bool RegularParser::ends() {
    const std::string_view rest = scanner_.rest();
    return rest.empty() || rest[0] == '|' || rest[0] == ')' || rest[0] == '/';
}

bool RegularParser::is_repeated() {
    const std::string_view rest = scanner_.rest();
    return !rest.empty() && (rest[0] == '*' || rest[0] == '+' || rest[0] == '?');
}

LanguageOperand RegularParser::product() {
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

std::optional<Word> RegularParser::take_letter() {
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

LanguageOperand RegularParser::factor() {
    const char* const where = scanner_.rest().data();
    if (std::optional<Word> letter = take_letter())
        return repeated({words_language({std::move(*letter)}), 0, 1});
    if (!scanner_.take("(")) throw unexpected("a letter or '(' (the empty word is ε)", where);
    if (++brackets_ > most_brackets)
        throw SyntaxError{
            where, "more than " + std::to_string(most_brackets) + " brackets inside each other"};
    LanguageOperand inner = choice();
    --brackets_;
    if (!scanner_.take(")")) throw unexpected("a letter, an operator or ')'", scanner_.here);
    return repeated(std::move(inner));
}

LanguageOperand RegularParser::repeated(LanguageOperand operand) {
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

}  // namespace

LanguageOperand parse_regular(ClaimScanner& scanner, ClaimReading& reading) {
    return RegularParser(scanner, reading).whole();
}

}  // namespace algae
