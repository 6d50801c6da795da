#include "notation/lexicon.hpp"

#include <algorithm>

#include "notation/characters.hpp"

namespace algae {

std::size_t undeclared_length(std::string_view text) {
    if (text.empty()) return 0;
    const Character first = first_character(text);
    if (first.code == '?') {
        const std::string_view name = text.substr(1);
        if (name.empty() || !is_letter(first_character(name).code)) return 0;
        return 1 + undeclared_length(name);
    }
    if (!first.is_valid() || is_reserved(first.code) || is_blank(first.code) ||
        is_false_minus(first.code))
        return 0;
    std::size_t length = first.bytes;
    if (!is_letter(first.code) || length + 1 >= text.size() || text[length] != '_') return length;
    const std::string_view subscript = text.substr(length + 1);
    const Character letter = first_character(subscript);
    if (is_letter(letter.code)) return length + 1 + letter.bytes;
    std::size_t digits = 0;
    while (digits < subscript.size() && is_digit(static_cast<unsigned char>(subscript[digits])))
        ++digits;
    return digits > 0 ? length + 1 + digits : length;
}

Lexicon::Lexicon(Alphabet& alphabet) : alphabet_(alphabet) {
    symbols_.fill(unknown);
    for (unsigned byte = 0; byte < 128; ++byte)
        plain_[byte] = byte >= 0x20 && byte != 0x7F && !is_blank(byte) && !is_reserved(byte);
    for (Symbol symbol = 0; symbol < alphabet_.size(); ++symbol) {
        const std::string& name = alphabet_.name(symbol);
        if (undeclared_length(name) != name.size()) declare(name);
    }
}

Symbol Lexicon::declare(std::string_view name) {
    std::uint32_t node = 0;
    for (const char byte : name) {
        const auto fresh = static_cast<std::uint32_t>(trie_.size());
        const auto [edge, is_new] = trie_[node].next.try_emplace(byte, fresh);
        node = edge->second;
        if (is_new) trie_.emplace_back();
    }
    trie_[node].ends = true;
    plain_[static_cast<unsigned char>(name[0])] = false;
    return alphabet_.symbol(name);
}

std::size_t Lexicon::length(std::string_view text) const {
    std::size_t longest = undeclared_length(text);
    std::uint32_t node = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const auto edge = trie_[node].next.find(text[i]);
        if (edge == trie_[node].next.end()) break;
        node = edge->second;
        if (trie_[node].ends) longest = std::max(longest, i + 1);
    }
    return longest;
}

std::optional<Symbol> Lexicon::next(std::string_view& text) {
    const std::size_t bytes = length(text);
    if (bytes == 0) return std::nullopt;
    const Symbol symbol = alphabet_.symbol(text.substr(0, bytes));
    text.remove_prefix(bytes);
    return symbol;
}

std::optional<Symbol> Lexicon::plain(unsigned char byte) {
    if (!plain_[byte]) return std::nullopt;
    if (symbols_[byte] == unknown) {
        const char name = static_cast<char>(byte);
        symbols_[byte] = alphabet_.symbol({&name, 1});
    }
    return symbols_[byte];
}

}  // namespace algae
