#include "notation/characters.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace algae {

namespace {

bool is_continuation(char byte) { return (static_cast<unsigned char>(byte) & 0xC0) == 0x80; }

}  // namespace

Character first_character(std::string_view text) {
    const auto lead = static_cast<unsigned char>(text[0]);
    if (lead < 0x80) return {lead, 1};
    if (lead < 0xC2 || lead > 0xF4) return {};
    const std::size_t bytes = lead < 0xE0 ? 2 : lead < 0xF0 ? 3 : 4;
    if (text.size() < bytes) return {};
    char32_t code = lead & (0xFFU >> (bytes + 1));
    for (std::size_t i = 1; i < bytes; ++i) {
        if (!is_continuation(text[i])) return {};
        code = code << 6 | (static_cast<unsigned char>(text[i]) & 0x3FU);
    }
    // Written longer than needed, half of a UTF-16 pair, or beyond Unicode.
    constexpr std::array<char32_t, 5> least{0, 0, 0x80, 0x800, 0x10000};
    if (code < least[bytes] || (code >= 0xD800 && code < 0xE000) || code > 0x10FFFF) return {};
    return {code, bytes};
}

bool is_blank(char32_t code) {
    if (code < 0x80) return code == ' ' || (code >= '\t' && code <= '\r');
    return code == 0x85 || code == 0xA0 || code == 0x1680 || (code >= 0x2000 && code <= 0x200B) ||
           code == 0x2028 || code == 0x2029 || code == 0x202F || code == 0x205F || code == 0x3000 ||
           code == 0xFEFF;
}

bool is_letter(char32_t code) {
    if (code < 0x80) return (code | 0x20) >= 'a' && (code | 0x20) <= 'z';
    if (code < 0xC0) return code == 0xAA || code == 0xB5 || code == 0xBA;
    if (code == 0xD7 || code == 0xF7 || code == 0x3B5) return false;  // times, divided by, epsilon
    return !(code >= 0x2000 && code < 0x2C00) && code != 0xFFFFFFFF && !is_blank(code);
}

bool is_reserved(char32_t code) {
    if (code < 0x80)
        return std::string_view("()<>:,;?#=").find(static_cast<char>(code)) !=
               std::string_view::npos;
    return code == 0x3B5 || code == 0x2192;  // the empty word, the arrow
}

bool is_false_minus(char32_t code) {
    return code == 0x2212 || (code >= 0x2010 && code <= 0x2015) || code == 0xFE63 || code == 0xFF0D;
}

std::string_view trimmed(std::string_view text) {
    const char* const end = text.data() + text.size();
    const char* blanks_from = text.data();  // where the blanks at the end begin
    const char* begin = nullptr;
    if (!text.empty() && static_cast<unsigned char>(text.front()) < 0x80 &&
        static_cast<unsigned char>(text.back()) < 0x80) {
        while (!text.empty() && is_blank(static_cast<unsigned char>(text.front())))
            text.remove_prefix(1);
        while (!text.empty() && is_blank(static_cast<unsigned char>(text.back())))
            text.remove_suffix(1);
        if (text.empty() || (static_cast<unsigned char>(text.front()) < 0x80 &&
                             static_cast<unsigned char>(text.back()) < 0x80))
            return text;
    }
    for (const char* here = text.data(); here != text.data() + text.size();) {
        const Character next =
            first_character({here, static_cast<std::size_t>(text.data() + text.size() - here)});
        if (!is_blank(next.code)) {
            if (!begin) begin = here;
            blanks_from = here + next.bytes;
        }
        here += next.bytes;
    }
    if (!begin) return {end, 0};
    return {begin, static_cast<std::size_t>(blanks_from - begin)};
}

std::string code_point_name(char32_t code) {
    static constexpr std::string_view digits = "0123456789ABCDEF";
    std::string hexadecimal;
    for (; code != 0 || hexadecimal.size() < 4; code >>= 4) hexadecimal += digits[code & 15];
    std::reverse(hexadecimal.begin(), hexadecimal.end());
    return "U+" + hexadecimal;
}

std::string quoted(std::string_view text) {
    constexpr std::size_t longest = 40;
    if (text.size() <= longest) return "'" + std::string(text) + "'";
    std::size_t length = longest;
    while (length > 0 && is_continuation(text[length])) --length;
    return "'" + std::string(text.substr(0, length)) + "...'";
}

std::string found(std::string_view rest) {
    if (rest.empty()) return "the end of the line";
    const Character first = first_character(rest);
    if (!first.is_valid()) return "a byte that is no character";
    if (is_blank(first.code)) return "a blank";
    if (first.code == ';') return "';'";
    if (is_false_minus(first.code))
        return "'" + std::string(rest.substr(0, first.bytes)) + "' (" +
               code_point_name(first.code) + "); did you mean '-'?";
    if (rest.starts_with("->")) return "'->'";
    // A whole name or number, unless it is very long.
    constexpr std::size_t longest = 60;
    std::size_t length = first.bytes;
    if (is_letter(first.code) || is_digit(first.code)) {
        while (length < rest.size() && length < longest) {
            const Character next = first_character(rest.substr(length));
            if (!is_letter(next.code) && !is_digit(next.code) && next.code != '_') break;
            length += next.bytes;
        }
    }
    return quoted(rest.substr(0, length));
}

}  // namespace algae
