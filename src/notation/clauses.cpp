#include "notation/clauses.hpp"

#include <algorithm>
#include <cctype>

#include "notation/characters.hpp"
#include "notation/system_block.hpp"

namespace algae {

namespace {

bool is_ascii_blank(char byte) { return is_blank(static_cast<unsigned char>(byte)); }

std::string_view keyword_of(std::string_view text) {
    std::size_t length = 0;
    while (length < text.size() && is_letter(static_cast<unsigned char>(text[length])) &&
           static_cast<unsigned char>(text[length]) < 0x80)
        ++length;
    return text.substr(0, length);
}

/// Whether `text` begins with `#rrggbb` and nothing sticks to it.
bool starts_with_colour(std::string_view text) {
    constexpr std::size_t length = 7;
    if (text.size() < length) return false;
    for (std::size_t i = 1; i < length; ++i)
        if (!std::isxdigit(static_cast<unsigned char>(text[i]))) return false;
    return text.size() == length || is_ascii_blank(text[length]) || text[length] == ';';
}

const char* first_arrow(std::string_view text) {
    const std::size_t ascii = text.find("->");
    const std::size_t unicode = text.substr(0, ascii).find("→");
    const std::size_t arrow = unicode != std::string_view::npos ? unicode : ascii;
    return arrow == std::string_view::npos ? nullptr : text.data() + arrow;
}

}  // namespace

bool Clause::has_word(std::string_view word) const {
    return keyword == word && (text.size() == word.size() || is_ascii_blank(text[word.size()]));
}

bool is_rule(const Clause& clause) {
    return clause.arrow && !clause.has_word("title") && !clause.has_word("source") &&
           !clause.has_word("interpret");
}

std::string_view Clause::value() const { return trimmed(text.substr(keyword.size())); }

std::vector<Clause> clauses(std::string_view text) {
    std::vector<Clause> found;
    const char* after_last = text.data();
    std::size_t begin = 0;
    const auto add = [&](std::size_t end) {
        Clause clause;
        clause.text = trimmed(text.substr(begin, end - begin));
        if (clause.text.empty()) return;
        clause.keyword = keyword_of(clause.text);
        clause.arrow = first_arrow(clause.text);
        clause.comments = after_last;
        after_last = clause.text.data() + clause.text.size();
        found.push_back(clause);
    };
    std::size_t here = 0;
    const auto add_block = [&] {  // a system within the system is one clause
        std::size_t bytes = 0;
        if (!text.substr(here).starts_with("system") ||
            !trimmed(text.substr(begin, here - begin)).empty() || !system_block(text.substr(here), bytes))
            return false;
        add(here + bytes);
        found.back().arrow = nullptr;
        begin = here += bytes;
        return true;
    };
    while (here < text.size()) {
        const char byte = text[here];
        if (byte == 's' && (here == begin || is_ascii_blank(text[here - 1])) && add_block()) continue;
        if (byte == '\n' || byte == ';') {
            add(here++);
            begin = here;
        } else if (byte == '#' && (here == begin || is_ascii_blank(text[here - 1]))) {
            if (starts_with_colour(text.substr(here)) &&
                keyword_of(trimmed(text.substr(begin, here - begin))) == "colour") {
                ++here;
                continue;
            }
            add(here);
            here = std::min(text.find('\n', here), text.size());
            begin = here;
        } else {
            ++here;
        }
    }
    add(text.size());
    return found;
}

std::vector<std::string_view> pieces(std::string_view text) {
    std::vector<std::string_view> found;
    const char* begin = nullptr;
    std::size_t depth = 0;
    const char* const end = text.data() + text.size();
    for (const char* here = text.data(); here != end;) {
        const Character next = first_character({here, static_cast<std::size_t>(end - here)});
        if (next.code == '(') ++depth;
        if (next.code == ')' && depth > 0) --depth;
        if (!is_blank(next.code)) {
            if (!begin) begin = here;
        } else if (begin && depth == 0) {
            found.emplace_back(begin, static_cast<std::size_t>(here - begin));
            begin = nullptr;
        }
        here += next.bytes;
    }
    if (begin) found.emplace_back(begin, static_cast<std::size_t>(end - begin));
    return found;
}

std::vector<std::string_view> comments(std::string_view text) {
    std::vector<std::string_view> found;
    for (std::size_t here = text.find('#'); here != std::string_view::npos;
         here = text.find('#', here)) {
        const std::size_t end = std::min(text.find('\n', here), text.size());
        found.push_back(trimmed(text.substr(here, end - here)));
        here = end;
    }
    return found;
}

}  // namespace algae
