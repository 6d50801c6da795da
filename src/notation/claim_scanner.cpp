#include "notation/claim_scanner.hpp"

#include "notation/characters.hpp"

namespace algae {

namespace {

bool is_name_character(char byte, bool first) {
    const auto code = static_cast<unsigned char>(byte);
    return (code < 0x80 && is_letter(code)) ||
           (!first && (is_digit(code) || byte == '_' || byte == '\''));
}

}  // namespace

std::string_view ClaimScanner::rest() {
    while (here != end) {
        const Character next = first_character({here, static_cast<std::size_t>(end - here)});
        if (!is_blank(next.code)) break;
        here += next.bytes;
    }
    return {here, static_cast<std::size_t>(end - here)};
}

bool ClaimScanner::take(std::string_view token) {
    if (!rest().starts_with(token)) return false;
    here += token.size();
    return true;
}

bool ClaimScanner::take_word(std::string_view word) {
    if (name() != word) return false;
    here += word.size();
    return true;
}

std::string_view ClaimScanner::name() {
    const std::string_view text = rest();
    std::size_t length = 0;
    while (length < text.size() && is_name_character(text[length], length == 0)) ++length;
    return text.substr(0, length);
}

std::string_view ClaimScanner::take_name() {
    const std::string_view found = name();
    here += found.size();
    return found;
}

std::string_view ClaimScanner::take_piece() {
    const std::string_view text = rest();
    while (here != end) {
        const Character next = first_character({here, static_cast<std::size_t>(end - here)});
        if (is_blank(next.code)) break;
        here += next.bytes;
    }
    return text.substr(0, text.size() - static_cast<std::size_t>(end - here));
}

std::size_t find_word(std::string_view text, std::string_view word) {
    const auto is_bound = [&](std::size_t i) {
        return i >= text.size() || is_blank(static_cast<unsigned char>(text[i]));
    };
    std::size_t depth = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] == '{') ++depth;
        if (text[i] == '}' && depth > 0) --depth;
        if (depth == 0 && text.substr(i).starts_with(word) && (i == 0 || is_bound(i - 1)) &&
            is_bound(i + word.size()))
            return i;
    }
    return std::string_view::npos;
}

}  // namespace algae
