#include <fmt/format.h>

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
        if (std::ranges::none_of(comments_, [&](const std::string& comment) {
                return text.substr(here_).starts_with(comment);
            }))
            return;
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
    if (!std::ranges::equal(next.substr(0, word.size()), word, {}, lower, lower)) return false;
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
    const std::size_t plus = next.starts_with('+') ? 1 : 0;
    const std::string_view text = next.substr(plus, size - plus);
    const Rational value(plain_number(text));
    if (value < least || value > most)
        fail_at(here_, fmt::format("expected {} from {} to {}, found {}", expectation,
                                   to_string(least), to_string(most), algae::quoted(text)));
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

Expression Scanner::expression(const ExpressionDialect& dialect,
                               const std::function<Expression()>& operand,
                               const std::function<void(std::size_t)>& met,
                               const std::function<Expression(Expression)>& made) {
    const auto next = [&](const char* place) {
        here_ = source_.offset(place);
        return rest().data();
    };
    const auto read = [&](const char*& place) {
        next(place);
        Expression found = operand();
        place = rest().data();
        return found;
    };
    const auto meet = [&](const char* place) { met(source_.offset(place)); };
    const std::string_view text = source_.text();
    const char* place = rest().data();
    try {
        Expression found = read_expression(place, text.data() + text.size(), source_, dialect,
                                           {next, read, meet, made});
        next(place);
        return found;
    } catch (const SyntaxError& error) {
        next(error.where);
        fail_at(here_, error.message + (error.names_found ? "" : found_next()));
    }
}

std::string Scanner::found_next() {
    const std::string_view next = rest();
    return next.empty() ? "the end of the file" : found(next.substr(0, next.find('\n')));
}

void Scanner::fail(const std::string& expectation) {
    const std::string found = found_next();
    fail_at(here_, "expected " + expectation + ", found " + found);
}

void Scanner::fail_at(std::size_t offset, const std::string& message) const {
    throw Diagnostics({source_.finding(offset, message)});
}

std::string spaced_word(const std::vector<std::string>& letters) {
    std::string out;
    for (const std::string& letter : letters) {
        if (!out.empty() && letter != "|" && !out.ends_with('|')) out += ' ';
        out += letter;
    }
    return out.empty() ? "ε" : out;
}

void PlacedWord::add(std::string_view letter, std::size_t offset) {
    text += letter;
    offsets.resize(text.size(), offset);
}

std::vector<std::string_view> characters(std::string_view text) {
    std::vector<std::string_view> all;
    while (!text.empty()) {
        all.push_back(text.substr(0, first_character(text).bytes));
        text.remove_prefix(all.back().size());
    }
    return all;
}

bool is_character(std::string_view text) {
    return !text.empty() && first_character(text).bytes == text.size();
}

std::string commented(const char* mark, const std::vector<std::string>& texts) {
    std::string lines;
    for (const std::string& text : texts)
        if (!text.empty()) lines += mark + text + "\n";
    return lines;
}

void add(Findings& findings, const Diagnostics& error) {
    for (const Diagnostic& finding : error.findings()) findings.add(finding.place, finding.message);
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

std::size_t number_size(std::string_view text) {
    const auto digits = [&](std::size_t from) {
        return std::min(text.find_first_not_of("0123456789", from), text.size());
    };
    std::size_t size = digits(0), known = size;
    if (text.substr(size).starts_with('.')) {
        size = digits(size + 1);
        known = size - 1;
    }
    if (known == 0) return 0;
    if (size == text.size() || (text[size] != 'e' && text[size] != 'E')) return size;
    const bool sign = size + 1 < text.size() && (text[size + 1] == '-' || text[size + 1] == '+');
    const std::size_t first = size + (sign ? 2 : 1),
                      end = first < text.size() ? digits(first) : first;
    return end > first ? end : size;
}

std::string plain_number(std::string_view number) {
    std::string text(number);
    const std::size_t point = text.find('.');
    if (point != std::string::npos &&
        (point + 1 == text.size() || !is_digit(static_cast<unsigned char>(text[point + 1]))))
        text.erase(point, 1);
    return text;
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
