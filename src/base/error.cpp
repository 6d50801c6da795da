#include "base/error.hpp"

#include <utility>

namespace algae {

namespace {

/// The line with a question mark for every character that a terminal could not show: control
/// characters, and bytes that are not UTF-8.
std::string printable(const std::string& line) {
    std::string out;
    for (std::size_t i = 0; i < line.size();) {
        const auto lead = static_cast<unsigned char>(line[i]);
        const std::size_t bytes = lead < 0x80 ? 1 : lead < 0xC2 ? 0 : lead < 0xE0 ? 2 : lead < 0xF0 ? 3 : lead < 0xF5 ? 4 : 0;
        bool whole = bytes > 0 && i + bytes <= line.size() && (lead >= 0x20 || lead == '\t') && lead != 0x7F;
        for (std::size_t k = 1; whole && k < bytes; ++k)
            whole = (static_cast<unsigned char>(line[i + k]) & 0xC0) == 0x80;
        if (whole) {
            out.append(line, i, bytes);
            i += bytes;
        } else {
            out += '?';
            ++i;
        }
    }
    return out;
}

}  // namespace

std::string Diagnostic::text() const {
    std::string out = to_string(place) + ": error: " + message;
    if (!line.empty()) out += "\n  " + printable(line) + "\n  " + std::string(caret, ' ') + '^';
    return out;
}

namespace {

std::string joined(const std::vector<Diagnostic>& findings) {
    std::string out;
    for (const Diagnostic& finding : findings) {
        if (!out.empty()) out += '\n';
        out += finding.text();
    }
    return out;
}

}  // namespace

Diagnostics::Diagnostics(std::vector<Diagnostic> findings)
    : Error(joined(findings)), findings_(std::move(findings)) {}

}  // namespace algae
