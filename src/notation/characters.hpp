#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace algae {

/// One character of a UTF-8 text: its code point and how many bytes it takes. A byte that starts no
/// valid character has the code point 0xFFFFFFFF and takes one byte.
struct Character {
    char32_t code = 0xFFFFFFFF;
    std::size_t bytes = 1;
    bool is_valid() const { return code != 0xFFFFFFFF; }
};

/// The character at the start of a text that is not empty.
Character first_character(std::string_view text);

/// White space within a line: blank, tab, carriage return and Unicode's blanks.
bool is_blank(char32_t code);

/// ASCII letters, and beyond ASCII everything but blanks, punctuation, arrows and operators.
bool is_letter(char32_t code);

inline bool is_digit(char32_t code) { return code >= '0' && code <= '9'; }

/// Whether this is a character of the notation that never is a symbol by itself.
bool is_reserved(char32_t code);

/// A character that looks like a minus sign and is none.
bool is_false_minus(char32_t code);

/// The text without blanks at both ends.
std::string_view trimmed(std::string_view text);

/// "U+2212".
std::string code_point_name(char32_t code);

/// The text in quotation marks, cut after some forty bytes.
///
/// Example: quoted("x") == "'x'"
std::string quoted(std::string_view text);

/// How an error speaks of what stands at the start of `rest`: "'x'", a whole name or number, "the
/// end of the line", with a hint where the character is a common mistake.
std::string found(std::string_view rest);

}  // namespace algae
