#include "word/alphabet.hpp"

#include <algorithm>
#include <cctype>
#include <numeric>

#include "word/spelling.hpp"

namespace algae {

Symbol Alphabet::symbol(std::string_view name) {
    if (const auto found = symbols_.find(name); found != symbols_.end()) return found->second;
    const auto fresh = static_cast<Symbol>(names_.size());
    names_.emplace_back(name);
    symbols_.emplace(names_.back(), fresh);
    if (!is_short_name(name)) long_names_.push_back(fresh);
    may_need_blanks_ = may_need_blanks_ || name == "_" || name == "?" || needs_blank(name, "0");
    return fresh;
}

std::optional<Symbol> Alphabet::find(std::string_view name) const {
    if (const auto found = symbols_.find(name); found != symbols_.end()) return found->second;
    return std::nullopt;
}

std::vector<std::uint32_t> Alphabet::ranks() const {
    std::vector<Symbol> order(size());
    std::iota(order.begin(), order.end(), Symbol{0});
    std::sort(order.begin(), order.end(), [&](Symbol a, Symbol b) { return names_[a] < names_[b]; });
    std::vector<std::uint32_t> rank(size());
    for (std::uint32_t i = 0; i < order.size(); ++i) rank[order[i]] = i;
    return rank;
}

namespace {

bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

/// The bytes of the first character of a UTF-8 text.
std::size_t first_character(std::string_view text) {
    if (text.empty()) return 0;
    const auto lead = static_cast<unsigned char>(text[0]);
    const std::size_t bytes = lead < 0x80 ? 1 : lead < 0xE0 ? 2 : lead < 0xF0 ? 3 : 4;
    return std::min(bytes, text.size());
}

}  // namespace

bool is_short_name(std::string_view name) {
    // A communication module `?E` is the name of its symbol behind a question mark.
    if (name.size() > 1 && name[0] == '?') name.remove_prefix(1);
    const std::size_t letter = first_character(name);
    if (name.size() == letter) return letter > 0;
    if (name[letter] != '_') return false;
    const std::string_view subscript = name.substr(letter + 1);
    if (subscript.empty()) return false;
    return std::all_of(subscript.begin(), subscript.end(), is_digit) ||
           first_character(subscript) == subscript.size();
}

bool needs_blank(std::string_view left, std::string_view right) {
    if (!is_short_name(left) || !is_short_name(right)) return true;
    const bool subscripted = left.find('_', 1) != std::string_view::npos;
    if (subscripted && is_digit(left.back()) && is_digit(right.front())) return true;
    // "a" "_" would be read as the start of a subscript, "?" "E" as a communication module,
    // "-" ">" never occurs: '>' is no symbol.
    return (right == "_" && !subscripted) || left == "?";
}

std::string spell(const Alphabet& alphabet, const Word& word) {
    if (word.empty()) return "ε";
    const Spellings spellings(alphabet);
    std::string out;
    for (std::size_t i = 0; i < word.size(); ++i) {
        if (i > 0 && spellings.blank_between(word[i - 1], word[i])) out += ' ';
        out += alphabet.name(word[i]);
    }
    return out;
}

}  // namespace algae
