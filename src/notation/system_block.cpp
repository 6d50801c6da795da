#include "notation/system_block.hpp"

#include <algorithm>

#include "notation/characters.hpp"

namespace algae {

namespace {

bool is_ascii_blank(char byte) { return is_blank(static_cast<unsigned char>(byte)); }

std::size_t blanks(std::string_view text) {
    return static_cast<std::size_t>(std::find_if_not(text.begin(), text.end(), is_ascii_blank) -
                                    text.begin());
}

std::size_t name_length(std::string_view text) {
    std::size_t length = 0;
    while (length < text.size()) {
        const Character next = first_character(text.substr(length));
        const bool fits =
            is_letter(next.code) || next.code == '_' || (length > 0 && is_digit(next.code));
        if (!fits) break;
        length += next.bytes;
    }
    return length;
}

}  // namespace

std::optional<SystemBlock> system_block(std::string_view text, std::size_t& bytes) {
    constexpr std::string_view keyword = "system";
    if (!text.starts_with(keyword)) return std::nullopt;
    std::size_t here = keyword.size();
    const std::size_t gap = blanks(text.substr(here));
    here += gap;
    const std::size_t length = name_length(text.substr(here));
    if (gap == 0 || length == 0) return std::nullopt;
    SystemBlock block{text.substr(here, length), {}, true};
    here += length;
    here += blanks(text.substr(here));
    if (here == text.size() || text[here] != '{') return std::nullopt;
    const std::size_t begin = ++here;
    for (std::size_t depth = 1; here < text.size(); ++here) {
        const char before = text[here - 1];
        if (text[here] == '#' && (before == '\n' || before == ';' || is_ascii_blank(before)))
            here = std::min(text.find('\n', here), text.size() - 1);
        if (text[here] == '{') ++depth;
        if (text[here] != '}' || --depth > 0) continue;
        block.body = text.substr(begin, here - begin);
        bytes = here + 1;
        return block;
    }
    block.body = text.substr(begin);
    block.closed = false;
    bytes = text.size();
    return block;
}

}  // namespace algae
