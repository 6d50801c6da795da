#include "base/error.hpp"

#include <utility>

namespace algae {

std::string Diagnostic::text() const {
    std::string out = to_string(place) + ": error: " + message;
    if (!line.empty()) out += "\n  " + line + "\n  " + std::string(caret, ' ') + '^';
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
