#pragma once
// word: symbols, alphabets, words, the free monoid, homomorphisms and finite substitutions.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace algae {

/// A symbol is a dense number given out by an Alphabet. It has a name only together with it.
using Symbol = std::uint32_t;

/// A word over some alphabet.
using Word = std::vector<Symbol>;

/// The symbols of a system, in the order in which they were first written.
class Alphabet {
public:
    /// The symbol of this name; a new one if the name is new. Amortised constant time.
    ///
    /// Example: Alphabet().symbol("a") == 0
    Symbol symbol(std::string_view name);

    std::optional<Symbol> find(std::string_view name) const;
    const std::string& name(Symbol symbol) const { return names_.at(symbol); }
    std::size_t size() const { return names_.size(); }
    /// The symbols whose names are read as one only because they are declared.
    const std::vector<Symbol>& long_names() const { return long_names_; }
    /// Whether there are names that need a blank next to some other name.
    bool may_need_blanks() const { return may_need_blanks_; }

    /// ranks()[a] < ranks()[b] when the name of a stands before that of b in code point order.
    /// Shortlex order compares words by length, then by these ranks.
    std::vector<std::uint32_t> ranks() const;

    bool operator==(const Alphabet& other) const { return names_ == other.names_; }

private:
    struct Hash {
        using is_transparent = void;
        std::size_t operator()(std::string_view text) const { return std::hash<std::string_view>{}(text); }
    };
    std::vector<std::string> names_;
    std::vector<Symbol> long_names_;
    bool may_need_blanks_ = false;
    std::unordered_map<std::string, Symbol, Hash, std::equal_to<>> symbols_;
};

/// The names of the symbols, one after the other, with a blank only where two names written
/// together would be read otherwise (`X_1 2`, longer declared names, or short names that together
/// look like the beginning of one); `ε` for the empty word.
///
/// Example: spell(Alphabet(), {}) == "ε"
std::string spell(const Alphabet& alphabet, const Word& word);

/// Whether a blank must stand between two names so that they are read back as written, where nothing
/// else is declared.
bool needs_blank(std::string_view left, std::string_view right);

/// Whether the name is one Unicode character, or a letter with a subscript (`F_l`, `X_12`).
/// Longer names must be declared by `alphabet`.
bool is_short_name(std::string_view name);

}  // namespace algae
