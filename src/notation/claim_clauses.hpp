#pragma once

#include <string_view>
#include <vector>

namespace algae {

/// One definition, statement or text of a claim, cut out of its line or lines: without blanks at its ends.
struct ClaimClause {
    std::string_view text;
    std::string_view keyword;        // what it begins with, up to the first blank
    const char* unclosed = nullptr;  // its first '{' without '}'

    /// What stands behind the keyword, without blanks.
    std::string_view value() const;
};

/// The clauses of a claim: `;` and line breaks outside braces separate them, `#` at the start of a line or
/// behind white space opens a comment. Braces in the texts of `claim`, `source`, `note` and `title` are
/// not counted, and one that is never closed does not hide the lines below it. Linear.
std::vector<ClaimClause> claim_clauses(std::string_view text);

/// The brace that closes the one at `open`; nullptr if there is none before `end`.
const char* closing_brace(const char* open, const char* end);

}  // namespace algae
