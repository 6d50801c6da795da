#pragma once

#include <string_view>
#include <vector>

namespace algae {

/// One setting or rule, cut out of its line: without comment, without blanks at its ends.
struct Clause {
    std::string_view text;
    std::string_view keyword;        // the letters it begins with
    const char* arrow = nullptr;     // its first `->` or `→`; nullptr if it has none
    const char* comments = nullptr;  // where the blank lines and comments before it begin

    /// Whether the keyword is all up to the first blank.
    bool has_word(std::string_view word) const;
    /// What stands behind the keyword, without blanks.
    std::string_view value() const;
};

/// The clauses of a text: `;` and line breaks separate them, `#` at the start of a line or
/// behind white space opens a comment (but in `colour #ff8000` it opens a colour). A system within the
/// system, `system leaf { ... }`, is one clause. Linear.
std::vector<Clause> clauses(std::string_view text);

/// Whether a clause is a rule: it has an arrow that is not part of a title, a source or an
/// interpretation.
bool is_rule(const Clause& clause);

/// The pieces of a text between blanks outside brackets.
std::vector<std::string_view> pieces(std::string_view text);

/// The comments in a stretch of text without clauses, each with its `#`, without the line break.
std::vector<std::string_view> comments(std::string_view text);

}  // namespace algae
