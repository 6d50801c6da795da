#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "exact/exact.hpp"
#include "notation/notation.hpp"
#include "system/system.hpp"

namespace algae {

/// Names of letters as a word of the notation: blanks between them, but none next to `|`, which would separate successors.
/// `ε` if there are none.
///
/// Example: spaced_word({"F", "|", "X_40"}) == "F|X_40"
std::string spaced_word(const std::vector<std::string>& letters);

/// Reads the text of another program's file token by token, and fails with the place. White space
/// and comments between tokens are skipped.
class Scanner {
public:
    /// `comments` begin what is ignored up to the end of its line: {"//", "\\\\"}; `prompt` is ignored
    /// where it is the first character of a line that is not blank. Throws `Diagnostics` if the text is
    /// no UTF-8. The text must outlive the scanner.
    Scanner(std::string_view text, std::string file, std::vector<std::string> comments,
            char prompt = '\0');

    /// The text with its places.
    const Source& source() const { return source_; }

    /// From now on these begin comments: none where what begins one may stand in a word.
    void set_comments(std::vector<std::string> comments) { comments_ = std::move(comments); }

    /// Nothing but white space and comments is left.
    bool at_end();
    /// What stands at the next token, up to the end of the text; empty at the end.
    std::string_view rest();
    /// The offset of the next token in the text.
    std::size_t offset();
    /// Whether the next token begins with this text; goes past it if so.
    bool take(std::string_view token);
    /// The same for a word, behind which no letter, digit, `-` or `_` follows, letters of either case.
    bool take_word(std::string_view word);
    /// Goes past this text, or fails: expected '=' behind the module F, found ';'. `where` is
    /// "behind the module F" or empty.
    void expect(std::string_view token, const std::string& where);
    /// A letter, then letters, digits, `-` and `_`.
    std::string name(const std::string& expectation);
    /// What stands between two `"`, on one line. Backslashes stand for themselves.
    std::string quoted(const std::string& expectation);
    /// An integer or decimal number, with a sign, exactly; fails unless from `least` to `most`.
    Rational number(const std::string& expectation, const Rational& least, const Rational& most);
    /// Goes past the next character, which is not white space, and gives it. Fails at the end.
    std::string character(const std::string& expectation);

    /// Operands as `operand` reads them here, with operators of the dialect before and between them.
    /// `met` is told where each of these stands; what `made` gives stands for an operator with its
    /// operands.
    Expression expression(const ExpressionDialect& dialect,
                          const std::function<Expression()>& operand,
                          const std::function<void(std::size_t)>& met,
                          const std::function<Expression(Expression)>& made = {});

    /// How errors name what stands at the next token: "';'" or "the end of the file".
    std::string found_next();
    /// Throws `Diagnostics`: "expected `expectation`, found ..." with what stands at the next token.
    [[noreturn]] void fail(const std::string& expectation);
    /// Throws `Diagnostics` with this message at an offset of the text.
    [[noreturn]] void fail_at(std::size_t offset, const std::string& message) const;

private:
    void skip();
    bool at_prompt() const;

    Source source_;
    std::vector<std::string> comments_;
    char prompt_;
    std::size_t here_ = 0;
};

/// A word of another program's file, and for each of its bytes the byte where it stands there.
struct PlacedWord {
    std::string text;
    std::vector<std::size_t> offsets;

    /// Appends a letter that stands at this byte.
    void add(std::string_view letter, std::size_t offset);
};

/// The characters of a text, one by one.
///
/// Example: characters("aé").size() == 2
std::vector<std::string_view> characters(std::string_view text);

/// Whether it is a single one.
///
/// Example: is_character("é")
bool is_character(std::string_view text);

/// What is known of a system or another generator as comments behind a mark, those of its texts that
/// are not empty, a line each.
///
/// Example: commented("# ", {"Fern", ""}) == "# Fern\n"
std::string commented(const char* mark, const std::vector<std::string>& texts);

/// Adds what is wrong with a part of a text to what is wrong with all of it.
void add(Findings& findings, const Diagnostics& error);

/// Adds a finding for each bracket that has no other.
void check_brackets(const PlacedWord& word, Findings& findings);

/// The bytes of the number without a sign that a text begins with, `2`, `.5`, `1.` or `2.5e-3`; 0 if
/// it begins with none.
///
/// Example: number_size("1.e5+x") == 4
std::size_t number_size(std::string_view text);

/// The same number as `Rational` reads it: without a point that no digit follows.
///
/// Example: plain_number("1.e5") == "1e5"
std::string plain_number(std::string_view number);

/// Expressions as readers of other programs' files make them.
Expression number_expression(const Rational& value);
Expression made_expression(Expression::Kind kind, const std::string& name,
                           std::vector<Expression> operands);

}  // namespace algae
