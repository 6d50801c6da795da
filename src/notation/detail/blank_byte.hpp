#pragma once

#include <cstddef>
#include <string_view>

#include "notation/notation.hpp"

namespace algae {

/// Whether a byte is a blank of ASCII. One behind others of a character is none: the last byte of `à` is the number of a blank.
inline bool is_blank_byte(char byte) {
    constexpr unsigned char ascii = 0x80;
    return static_cast<unsigned char>(byte) < ascii && is_blank(static_cast<unsigned char>(byte));
}

/// Whether the character before a place is a blank, of ASCII or not; false at the start.
inline bool is_behind_blank(std::string_view text, std::size_t here) {
    constexpr std::size_t longest = 4;
    constexpr unsigned char continues = 0x80, bits = 0xC0;
    std::size_t begin = here;
    while (begin > 0 && here - begin < longest)
        if ((static_cast<unsigned char>(text[--begin]) & bits) != continues) break;
    return begin < here && is_blank(first_character(text.substr(begin, here - begin)).code);
}

/// Whether a text ends or has a blank at a place.
inline bool is_before_blank(std::string_view text, std::size_t here) {
    return here >= text.size() || is_blank(first_character(text.substr(here)).code);
}

}  // namespace algae
