#include "notation/findings.hpp"

#include <algorithm>
#include <utility>

#include "notation/characters.hpp"

namespace algae {

SyntaxError unexpected(const std::string& expectation, const char* where) {
    return {where, "expected " + expectation + ", found ", false};
}

void Findings::add(const SyntaxError& error) {
    if (error.names_found) return add(error.where, error.message);
    const std::string_view text = source_.text();
    std::size_t here = source_.offset(error.where);
    while (here < text.size() && text[here] != '\n') {
        const Character next = first_character(text.substr(here));
        if (!is_blank(next.code)) break;
        here += next.bytes;
    }
    const bool is_comment =
        here > source_.offset(error.where) && text.substr(here).starts_with('#');
    if (here == text.size() || text[here] == '\n' || is_comment)
        return add(error.where, error.message + "the end of the line");
    add(here, error.message + found(text.substr(here, text.find('\n', here) - here)));
}

void Findings::add(std::size_t offset, std::string message) {
    ++count_;
    if (findings_.size() < most_kept) findings_.push_back({offset, std::move(message)});
}

void Findings::throw_if_no_text() {
    for (const Source::BadByte& bad : source_.bad_bytes()) add(bad.offset, bad.message);
    count_ += source_.bad_lines() - source_.bad_bytes().size();
    throw_if_any();
}

void Findings::throw_if_any() const {
    if (empty()) return;
    std::vector<Finding> sorted = findings_;
    std::stable_sort(sorted.begin(), sorted.end(),
                     [](const Finding& a, const Finding& b) { return a.offset < b.offset; });
    const std::size_t shown = std::min(sorted.size(), most_shown);
    std::vector<Diagnostic> diagnostics;
    for (std::size_t i = 0; i < shown; ++i)
        diagnostics.push_back(source_.finding(sorted[i].offset, sorted[i].message));
    if (count_ > shown) {
        const std::size_t more = count_ - shown;
        diagnostics.push_back({Place{source_.file(), 0, 0},
                               std::to_string(more) + (more == 1 ? " more error" : " more errors"),
                               {},
                               0});
    }
    throw Diagnostics(std::move(diagnostics));
}

}  // namespace algae
