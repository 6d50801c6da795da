#include <algorithm>
#include <cctype>
#include <utility>

#include "exchange/detail/scanner.hpp"

// Reading other programs' files token by token, and what several of their readers need: words with the places
// of their letters, and expressions made without a text.
//
// White space and comments between tokens are skipped; what begins a comment differs from format to format
// and, within one, from section to section. The first fault ends the reading, with its place (`fail`), and a
// reader that can go on behind it catches that and gathers findings.

namespace algae {

namespace {

bool is_letter_of_name(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) || c == '-' || c == '_';
}

char lower(char c) { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); }

}  // namespace

Scanner::Scanner(std::string_view text, std::string file, std::vector<std::string> comments,
                 char prompt)
    : source_(text, std::move(file)), comments_(std::move(comments)), prompt_(prompt) {
    Findings(source_).throw_if_no_text();
}

bool Scanner::at_prompt() const {
    const std::string_view text = source_.text();
    if (!prompt_ || text[here_] != prompt_) return false;
    const std::size_t line = text.find_last_of('\n', here_) + 1;  // 0 where there is none
    return trimmed(text.substr(line, here_ - line)).empty();
}

void Scanner::skip() {
    const std::string_view text = source_.text();
    while (here_ < text.size()) {
        if (text[here_] == '\n' || at_prompt()) {
            ++here_;
            continue;
        }
        const Character next = first_character(text.substr(here_));
        if (is_blank(next.code)) {
            here_ += next.bytes;
            continue;
        }
        bool is_comment = false;
        for (const std::string& comment : comments_)
            is_comment = is_comment || text.substr(here_).starts_with(comment);
        if (!is_comment) return;
        here_ = std::min(text.find('\n', here_), text.size());
    }
}

bool Scanner::at_end() { return rest().empty(); }

std::string_view Scanner::rest() {
    skip();
    return source_.text().substr(here_);
}

std::size_t Scanner::offset() {
    skip();
    return here_;
}

bool Scanner::take(std::string_view token) {
    if (!rest().starts_with(token)) return false;
    here_ += token.size();
    return true;
}

bool Scanner::take_word(std::string_view word) {
    const std::string_view next = rest();
    if (next.size() < word.size()) return false;
    for (std::size_t i = 0; i < word.size(); ++i)
        if (lower(next[i]) != lower(word[i])) return false;
    if (next.size() > word.size() && is_letter_of_name(next[word.size()])) return false;
    here_ += word.size();
    return true;
}

void Scanner::expect(std::string_view token, const std::string& where) {
    if (!take(token)) fail(algae::quoted(token) + (where.empty() ? "" : " " + where));
}

std::string Scanner::name(const std::string& expectation) {
    const std::string_view next = rest();
    if (next.empty() || !std::isalpha(static_cast<unsigned char>(next.front()))) fail(expectation);
    std::size_t size = 1;
    while (size < next.size() && is_letter_of_name(next[size])) ++size;
    here_ += size;
    return std::string(next.substr(0, size));
}

std::string Scanner::quoted(const std::string& expectation) {
    const std::string_view next = rest();
    if (!next.starts_with('"')) fail(expectation);
    const std::size_t end = next.find_first_of("\"\n", 1);
    if (end == std::string_view::npos || next[end] == '\n')
        fail_at(here_, "expected '\"' at the end of the string, found the end of the line");
    here_ += end + 1;
    return std::string(next.substr(1, end - 1));
}

Rational Scanner::number(const std::string& expectation, const Rational& least,
                         const Rational& most) {
    const std::string_view next = rest();
    std::size_t size = next.starts_with('-') || next.starts_with('+') ? 1 : 0, digits = 0;
    for (bool point = false; size < next.size(); ++size) {
        if (next[size] == '.' && !point && !next.substr(size).starts_with(".."))
            point = true;
        else if (next[size] >= '0' && next[size] <= '9')
            ++digits;
        else
            break;
    }
    if (digits == 0) fail(expectation);
    const std::string text(
        next.substr(next.starts_with('+') ? 1 : 0, size - (next.starts_with('+') ? 1 : 0)));
    const Rational value(text.ends_with('.') ? text.substr(0, text.size() - 1) : text);
    if (value < least || value > most)
        fail_at(here_, "expected " + expectation + " from " + to_string(least) + " to " +
                           to_string(most) + ", found " + algae::quoted(text));
    here_ += size;
    return value;
}

std::string Scanner::character(const std::string& expectation) {
    const std::string_view next = rest();
    if (next.empty()) fail(expectation);
    const std::size_t size = first_character(next).bytes;
    here_ += size;
    return std::string(next.substr(0, size));
}

void Scanner::fail(const std::string& expectation) {
    const std::string_view next = rest();
    if (next.empty()) fail_at(here_, "expected " + expectation + ", found the end of the file");
    fail_at(here_, "expected " + expectation + ", found " + found(next.substr(0, next.find('\n'))));
}

void Scanner::fail_at(std::size_t offset, const std::string& message) const {
    throw Diagnostics({source_.finding(offset, message)});
}

void PlacedWord::add(std::string_view letter, std::size_t offset) {
    text += letter;
    offsets.resize(text.size(), offset);
}

void check_brackets(const PlacedWord& word, Findings& findings) {
    std::vector<std::size_t> open;
    for (std::size_t i = 0; i < word.text.size(); ++i) {
        if (word.text[i] == '[') open.push_back(word.offsets[i]);
        if (word.text[i] != ']') continue;
        if (open.empty())
            findings.add(word.offsets[i], "unmatched ']'");
        else
            open.pop_back();
    }
    for (const std::size_t at : open) findings.add(at, "'[' is never closed");
}

Expression number_expression(const Rational& value) {
    Expression out;
    out.value = value;
    return out;
}

Expression made_expression(Expression::Kind kind, const std::string& name,
                           std::vector<Expression> operands) {
    Expression out;
    out.kind = kind;
    out.name = name;
    out.operands = std::move(operands);
    return out;
}

}  // namespace algae
