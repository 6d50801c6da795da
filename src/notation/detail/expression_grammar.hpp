#pragma once
// Symbols, words and expressions: what the statements of `.lsys` files and of claims are made of.

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "notation/notation.hpp"

namespace algae {

/// Whether this is a character of the notation that never is a symbol by itself.
bool is_reserved(char32_t code);

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

/// Reads one expression from `here` on, up to where it cannot go on, and moves `here` there.
/// Throws `SyntaxError`. Brackets nest at most 200 deep, operators at most 500. With a lexicon words
/// may stand in it, `"FF[+F]"` and `leaf(3)` of the systems that the lexicon knows; `quotes` counts
/// the words that it stands in itself, at most 20.
Expression parse_expression(const char*& here, const char* end, const Source& source,
                            Lexicon* lexicon = nullptr, std::size_t quotes = 0);

/// An expression that is the whole of `text`. Throws `SyntaxError`.
Expression parse_expression(std::string_view text, const Source& source);

/// Arguments in brackets, `(x*2, x+y)`, from `here` on. Throws `SyntaxError`.
std::vector<Expression> parse_arguments(const char*& here, const char* end, const Source& source,
                                        Lexicon* lexicon = nullptr, std::size_t quotes = 0);

/// The word that is the whole of `text`: symbols, some with arguments in brackets; white space
/// separates, ε alone is the empty word. Linear; a word without arguments takes four bytes a symbol.
/// Where `splices` are allowed, `<w>` stands for the word that the expression w gives; a relation in
/// it needs brackets. Throws `SyntaxError`.
ModuleWord parse_word(std::string_view text, Lexicon& lexicon, const Source& source,
                      bool splices = false);

/// The word in quotes that `here` stands at, as an expression; moves `here` behind it. `quotes` counts
/// the words in quotes around it, at most 20. Throws `SyntaxError`.
Expression parse_quoted(const char*& here, const char* end, Lexicon& lexicon, const Source& source,
                        std::size_t quotes);

/// Symbols without arguments. Throws `SyntaxError`.
Word parse_symbols(std::string_view text, Lexicon& lexicon);

/// Adds a finding for each bracket of the word without its other half; `text` is what the word was
/// read from.
void check_brackets(const ModuleWord& word, std::string_view text, Lexicon& lexicon,
                    const Source& source, Findings& findings);

}  // namespace algae
