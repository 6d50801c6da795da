#include "notation/findings.hpp"

#include <algorithm>
#include <utility>

#include "notation/characters.hpp"

namespace algae {

SyntaxError unexpected(const std::string& expectation, const char* where, const char* end) {
    return {where, "expected " + expectation + ", found " +
                       found({where, static_cast<std::size_t>(end - where)})};
}

void Findings::add(std::size_t offset, std::string message) {
    ++count_;
    if (findings_.size() < most_kept) findings_.push_back({offset, std::move(message)});
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
