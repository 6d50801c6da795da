// Errors in parts, for editors and programs.
//
// Messages are made for people, by one pattern throughout: what is wrong or what was expected, ", found" and what was there, "; did you
// mean 'X'?". The parts are cut out of the message, so that each message is written once. A part that the message does not
// have is null.

#include <algorithm>
#include <charconv>

#include "report/report.hpp"

namespace algae {

namespace {

/// Without the quotation marks around it.
std::string unquoted(std::string_view text) {
    if (text.size() > 1 && text.front() == text.back() && (text[0] == '\'' || text[0] == '"'))
        text = text.substr(1, text.size() - 2);
    return std::string(text);
}

std::size_t characters(std::string_view text) {
    return static_cast<std::size_t>(
        std::ranges::count_if(text, [](char c) { return (c & 0xc0) != 0x80; }));
}

Json or_null(const std::string& text) { return text.empty() ? Json() : Json(text); }

}  // namespace

MessageParts parts_of(std::string_view message) {
    constexpr std::string_view expected = "expected ", found = ", found ", meant = "did you mean '";
    MessageParts parts;
    const auto npos = std::string_view::npos;
    const std::size_t begin = message.find(expected);
    const std::size_t there = message.find(found);
    const auto end_of = [&](std::size_t from) {
        // A semicolon within quotation marks is what was found.
        const char quote = from < message.size() ? message[from] : ' ';
        std::size_t search = from;
        if (quote == '\'' || quote == '"')
            if (const std::size_t close = message.find(quote, from + 1); close != npos)
                search = close + 1;
        return std::min(message.find(';', search), message.size());
    };
    if (begin != npos) {
        const std::size_t from = begin + expected.size();
        const std::size_t end = there != npos && there > from ? there : end_of(from);
        parts.expected = message.substr(from, end - from);
    }
    if (there != npos) {
        const std::size_t from = there + found.size();
        parts.found = unquoted(message.substr(from, end_of(from) - from));
    }
    if (const std::size_t hint = message.find(meant); hint != npos) {
        const std::size_t from = hint + meant.size(), end = message.find('\'', from);
        if (end != npos) parts.suggestion = message.substr(from, end - from);
    }
    return parts;
}

std::size_t end_column(const Diagnostic& finding) {
    const std::string found = parts_of(finding.message).found;
    const bool there = finding.caret <= finding.line.size() && !found.empty() &&
                       std::string_view(finding.line).find(found) != std::string_view::npos;
    return finding.place.column + (there ? characters(found) : 1);
}

Json to_json(const Diagnostic& finding) {
    Json out = error_json(finding.message);
    const Place& place = finding.place;
    out.set("file", or_null(place.file));
    if (place.line > 0)
        out.set("line", place.line).set("column", place.column).set("end", end_column(finding));
    return out;
}

namespace {

/// The place that a message begins with, `koch.lsys:3:11: `; without a file where there is none.
Place place_of(std::string_view message) {
    const std::string_view said = message.substr(0, message.find(": "));
    const std::size_t second = said.rfind(':');
    if (second == std::string_view::npos || second == 0 || said.size() == message.size()) return {};
    const std::size_t first = said.rfind(':', second - 1);
    if (first == std::string_view::npos || first == 0) return {};
    const auto number = [](std::string_view digits) {  // 0 if it is none
        std::size_t value = 0;
        const char* const end = digits.data() + digits.size();
        return std::from_chars(digits.data(), end, value).ptr == end ? value : 0;
    };
    const std::size_t line = number(said.substr(first + 1, second - first - 1)),
                      column = number(said.substr(second + 1));
    if (line == 0 || column == 0) return {};
    return {std::string(said.substr(0, first)), line, column};
}

Json number_or_null(std::size_t number) { return number > 0 ? Json(number) : Json(nullptr); }

}  // namespace

Json error_json(std::string_view message) {
    const MessageParts parts = parts_of(message);
    const Place place = place_of(message);
    return {{"file", or_null(place.file)},
            {"line", number_or_null(place.line)},
            {"column", number_or_null(place.column)},
            {"end", nullptr},
            {"message", std::string(message)},
            {"expected", or_null(parts.expected)},
            {"suggestion", or_null(parts.suggestion)}};
}

}  // namespace algae
