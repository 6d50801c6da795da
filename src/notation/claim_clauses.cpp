#include "notation/claim_clauses.hpp"

#include <algorithm>

#include "notation/characters.hpp"

namespace algae {

namespace {

bool is_ascii_blank(char byte) { return is_blank(static_cast<unsigned char>(byte)); }

/// Whether a clause that begins here is a text for people.
bool is_prose(std::string_view rest) {
    const std::size_t begin = rest.find_first_not_of(" \t\r");
    if (begin == std::string_view::npos) return false;
    rest.remove_prefix(begin);
    for (const std::string_view word : {"claim", "source", "note", "title"})
        if (rest.starts_with(word) &&
            (rest.size() == word.size() || is_ascii_blank(rest[word.size()])))
            return true;
    return false;
}

/// Tells `on(offset)` of every brace, line break and `;` outside comments, and of every `#` that opens one,
/// until it says false.
template <class On>
void walk(std::string_view text, On on) {
    std::size_t begin = 0;
    bool prose = is_prose(text);
    for (std::size_t here = 0; here < text.size(); ++here) {
        const char byte = text[here];
        if (byte == '\n' || byte == ';') {
            if (!on(here)) return;
            begin = here + 1;
            prose = is_prose(text.substr(begin));
        } else if (byte == '#' && (here == begin || is_ascii_blank(text[here - 1]))) {
            if (!on(here)) return;
            here = std::min(text.find('\n', here), text.size()) - 1;
        } else if ((byte == '{' || byte == '}') && !prose) {
            if (!on(here)) return;
        }
    }
}

/// The places of braces `{` without `}`, in increasing order.
std::vector<std::size_t> unclosed_braces(std::string_view text) {
    std::vector<std::size_t> open;
    walk(text, [&](std::size_t here) {
        if (text[here] == '{') open.push_back(here);
        if (text[here] == '}' && !open.empty()) open.pop_back();
        return true;
    });
    return open;
}

}  // namespace

std::string_view ClaimClause::value() const { return trimmed(text.substr(keyword.size())); }

std::vector<ClaimClause> claim_clauses(std::string_view text) {
    std::vector<ClaimClause> found;
    const std::vector<std::size_t> unclosed = unclosed_braces(text);
    auto next_unclosed = unclosed.begin();
    const char* first_unclosed = nullptr;  // of this clause
    std::size_t begin = 0, depth = 0;
    const auto add = [&](std::size_t end) {
        ClaimClause clause;
        clause.text = trimmed(text.substr(begin, end - begin));
        clause.unclosed = first_unclosed;
        first_unclosed = nullptr;
        if (clause.text.empty()) return;
        const auto blank = std::find_if(clause.text.begin(), clause.text.end(), is_ascii_blank);
        clause.keyword =
            clause.text.substr(0, static_cast<std::size_t>(blank - clause.text.begin()));
        found.push_back(clause);
    };
    walk(text, [&](std::size_t here) {
        const char byte = text[here];
        if (byte == '{') {
            if (next_unclosed != unclosed.end() && *next_unclosed == here) {
                ++next_unclosed;
                if (!first_unclosed) first_unclosed = text.data() + here;
            } else {
                ++depth;
            }
        } else if (byte == '}') {
            if (depth > 0) --depth;
        } else if (depth == 0) {
            add(here);
            begin = byte == '#' ? std::min(text.find('\n', here), text.size()) : here + 1;
        }
        return true;
    });
    add(text.size());
    return found;
}

const char* closing_brace(const char* open, const char* end) {
    const std::string_view text{open, static_cast<std::size_t>(end - open)};
    std::size_t depth = 0, close = 0;
    walk(text, [&](std::size_t here) {
        if (text[here] == '{') ++depth;
        if (text[here] == '}' && --depth == 0) close = here;
        return close == 0;
    });
    return close > 0 ? open + close : nullptr;
}

}  // namespace algae
