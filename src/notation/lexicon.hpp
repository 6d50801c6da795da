#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "word/alphabet.hpp"

namespace algae {

/// How a text is cut into symbols: the longest name that a declaration or the notation knows.
class Lexicon {
public:
    /// New symbols are added to `alphabet`, which must outlive the lexicon. Names in it that are
    /// read only if declared count as declared.
    explicit Lexicon(Alphabet& alphabet);

    /// From now on `name` is read as one symbol where nothing longer fits.
    Symbol declare(std::string_view name);

    /// From now on a call of `name` is the word of a system.
    void name_system(std::string_view name) { systems_.emplace_back(name); }
    const std::vector<std::string>& systems() const { return systems_; }

    /// The symbols so far.
    const Alphabet& alphabet() const { return alphabet_; }

    /// The symbol of this name, if it has occurred.
    std::optional<Symbol> known(std::string_view name) const { return alphabet_.find(name); }

    /// The bytes of the symbol that `text` begins with; 0 if it begins with none. At most as many
    /// steps as the longest declared name has bytes.
    std::size_t length(std::string_view text) const;

    /// The symbol that `text` begins with; the text moves on behind it.
    std::optional<Symbol> next(std::string_view& text);

    /// The symbol of an ASCII character that is a whole symbol unless `_` follows; otherwise none.
    std::optional<Symbol> plain(unsigned char byte);

private:
    struct Node {
        std::map<char, std::uint32_t> next;
        bool ends = false;
    };
    static constexpr Symbol unknown = ~Symbol{0};

    Alphabet& alphabet_;
    std::vector<std::string> systems_;
    std::vector<Node> trie_{1};
    std::array<bool, 256> plain_{};    // ASCII characters that are symbols by themselves
    std::array<Symbol, 256> symbols_;  // of those, once they have occurred
};

/// The bytes of the symbol that `text` begins with where nothing is declared; 0 if it begins with
/// none: one character, a letter with a subscript, or either behind a question mark.
///
/// Example: undeclared_length("F_lF") == 3
/// Example: undeclared_length("?E(x)") == 2
std::size_t undeclared_length(std::string_view text);

}  // namespace algae
