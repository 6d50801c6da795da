#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <limits>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "exact/exact.hpp"

// word: symbols, alphabets, words as they are written, and homomorphisms of the free monoid: into words (a morphism, the
// rules of a deterministic system) and into any other monoid, where an analysis happens. Also what a morphism alone decides
// of letters (how long each lasts) and the semiring of finite sets of words, into which a system with choices is folded.

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
        std::size_t operator()(std::string_view text) const {
            return std::hash<std::string_view>{}(text);
        }
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

/// Words as text, under concatenation with a blank wherever two names written together would be
/// read otherwise. The empty word is the empty text here; printing makes it `ε`. The alphabet must
/// outlive the monoid and must not grow.
class Spellings {
public:
    struct value_type {
        std::string text;
        Symbol first = 0, last = 0;  // meaningless for the empty word
        bool operator==(const value_type& other) const { return text == other.text; }
    };

    explicit Spellings(const Alphabet& alphabet);

    value_type one() const { return {}; }
    value_type letter(Symbol symbol) const { return {alphabet_->name(symbol), symbol, symbol}; }
    void append(value_type& left, const value_type& right) const {
        if (right.text.empty()) return;
        if (left.text.empty()) {
            left = right;
            return;
        }
        if (blank_between(left.last, right.first)) left.text += ' ';
        left.text += right.text;
        left.last = right.last;
    }

    /// Whether a blank stands between these two letters. Constant time where no name is long.
    bool blank_between(Symbol left, Symbol right) const {
        if (!alphabet_->may_need_blanks()) return false;
        const std::string& name = alphabet_->name(right);
        return needs_blank(alphabet_->name(left), name) || (rests_ && begins_long_name(left, name));
    }

private:
    /// By symbol: what is missing to every long name that its name begins.
    using Rests = std::unordered_map<Symbol, std::vector<std::string>>;

    bool begins_long_name(Symbol left, std::string_view right) const;

    const Alphabet* alphabet_;
    std::shared_ptr<const Rests> rests_;  // absent where no name is long
};

/// A morphism of free monoids: a letter of its domain goes to a word, a word over the domain to the images of its letters,
/// one after the other. Of a D0L system the domain are all letters; of a morphism in a claim those that have an image.
class Morphism {
public:
    Morphism() = default;
    /// The domain are the letters 0, 1, ..., each with its image.
    explicit Morphism(std::vector<Word> images);
    /// Letters and their images.
    ///
    /// Example: Morphism({{0, {0, 1}}, {1, {0}}}) == Morphism(std::vector<Word>{{0, 1}, {0}})
    Morphism(std::initializer_list<std::pair<Symbol, Word>> images);

    /// Gives the letter an image; if it has one already that stays, and the answer is false.
    bool add(Symbol letter, Word image);

    /// Whether the letter has an image.
    bool maps(Symbol letter) const { return letter < mapped_.size() && mapped_[letter] != 0; }
    /// The letters that have an image, in increasing order.
    std::vector<Symbol> domain() const;
    /// One more than the greatest letter that has an image.
    std::size_t size() const { return images_.size(); }
    /// By symbol; the empty word for a letter below `size()` that has no image.
    const std::vector<Word>& images() const { return images_; }
    /// The image of a letter below `size()`.
    const Word& operator[](Symbol letter) const { return images_[letter]; }

    /// The image of a word. Throws Error if one of its letters has none.
    ///
    /// Example: Morphism({{0, {0, 1}}, {1, {0}}})({0, 1}) == Word{0, 1, 0}
    Word operator()(const Word& word) const;
    /// The image of a word; nothing if one of its letters has none.
    std::optional<Word> image_of(const Word& word) const;

    /// The letters whose image is the empty word.
    std::vector<Symbol> erased() const;
    /// The morphism with every image reversed.
    Morphism mirrored() const;

    bool operator==(const Morphism&) const = default;

private:
    std::vector<Word> images_;
    std::vector<char> mapped_;  // by symbol, as long as images_
};

/// "{ a -> ab; b -> ε }".
std::string to_string(const Morphism& morphism, const Alphabet& alphabet);

/// The letters that occur in some word derived from the axiom, in order of first access. `successors(a, see)`
/// calls `see` with every word that the letter may become; `letters` is how many symbols there are.
template <class Successors>
std::vector<Symbol> accessible(const Word& axiom, std::size_t letters, Successors successors) {
    std::vector<char> seen(letters, 0);
    std::vector<Symbol> found;
    const auto see = [&](const Word& word) {
        for (const Symbol a : word)
            if (!seen[a]) {
                seen[a] = 1;
                found.push_back(a);
            }
    };
    see(axiom);
    for (std::size_t i = 0; i < found.size(); ++i) successors(found[i], see);
    return found;
}

/// The strongly connected components of a directed graph, given by the successors of each node: the number of the
/// component of each node. What a component leads to has smaller numbers. Linear time (Tarjan 1972).
///
/// Example: strong_components({{1}, {0, 2}, {}}) == std::vector<std::size_t>{1, 1, 0}
std::vector<std::size_t> strong_components(const std::vector<std::vector<std::size_t>>& successors);

/// The free monoid itself: words under concatenation.
struct Words {
    using value_type = Word;
    Word one() const { return {}; }
    void append(Word& left, const Word& right) const {
        left.insert(left.end(), right.begin(), right.end());
    }
};

/// The two symbols that fence a branch, where an alphabet has them.
struct Brackets {
    Symbol open = 0;
    Symbol close = 0;
    bool operator==(const Brackets&) const = default;
};

/// The symbols named "[" and "]", if the alphabet has both.
std::optional<Brackets> brackets_of(const Alphabet& alphabet);

/// Whether each open bracket has its closing one behind it, and each closing one its open one.
///
/// Example: !brackets_match({1, 0}, Brackets{0, 1})
bool brackets_match(const Word& word, const Brackets& brackets);

/// The homomorphism from words to M with these images of the letters, indexed by symbol: what a fold works out. It is no
/// Morphism: M is a value with context of its own (a modulus, an angle), its elements need not be words, and brackets may
/// have a meaning there.
///
/// Where M is Branching and the alphabet has brackets, `[` u `]` is sent to branch(image of u), and
/// the image of a word whose brackets do not match throws Error.
template <Monoid M>
struct Hom {
    M monoid;
    std::vector<typename M::value_type> images;
    std::optional<Brackets> brackets = std::nullopt;
    //> hom
    typename M::value_type operator()(const Word& word) const {
        if constexpr (Branching<M>)
            if (brackets) return branched(word);
        auto product = monoid.one();
        for (const Symbol a : word) monoid.append(product, images.at(a));
        return product;
    }

    /// This homomorphism after h: a letter goes where its successor goes. Only the letters given
    /// are worked out, the others keep the neutral element.
    Hom after(const Morphism& h, const std::vector<Symbol>& letters) const {
        Hom composed{monoid, std::vector<typename M::value_type>(images.size(), monoid.one()),
                     brackets};
        for (const Symbol a : letters) {
            if constexpr (Branching<M>)
                if (brackets && (a == brackets->open || a == brackets->close)) continue;
            composed.images[a] = (*this)(h[a]);
        }
        return composed;
    }
    //< hom
private:
    typename M::value_type branched(const Word& word) const requires Branching<M> {
        std::vector<typename M::value_type> open{monoid.one()};  // one for each branch still open
        for (const Symbol a : word) {
            if (a == brackets->open) {
                open.push_back(monoid.one());
            } else if (a == brackets->close) {
                if (open.size() == 1) throw Error("unmatched ']'");
                const auto twig = monoid.branch(open.back());
                open.pop_back();
                monoid.append(open.back(), twig);
            } else {
                monoid.append(open.back(), images.at(a));
            }
        }
        if (open.size() > 1) throw Error("'[' is never closed");
        return std::move(open.back());
    }
};

/// The symbols of the second alphabet that have the names of those of the first, by symbol. Throws Error if
/// one is missing there.
std::vector<Symbol> renaming(const Alphabet& from, const Alphabet& to);

/// The word with each letter replaced.
///
/// Example: replaced({1, 0}, {5, 6}) == Word{6, 5}
Word replaced(Word word, const std::vector<Symbol>& letters);

/// The lifetime of a letter that never dies.
inline constexpr std::uint64_t lasts = UINT64_MAX;

/// By symbol, how many steps each letter lasts when a step is the morphism: nothing is left of it from
/// that many steps on; `lasts` if something always is (Rozenberg and Salomaa 1980, I.3: the other
/// letters are mortal). O(size of the images).
///
/// Example: lifetimes(Morphism({{0, {1}}, {1, {}}})) == std::vector<std::uint64_t>{2, 1}
std::vector<std::uint64_t> lifetimes(const Morphism& morphism);

/// Finite sets of words under union and concatenation, all words longer than `longest` left out:
/// a semiring, because lengths add up. Sets are sorted in shortlex order over symbol numbers.
class WordSets {
public:
    using value_type = std::vector<Word>;

    /// `budget` bounds the memory of one set; it must outlive the semiring.
    explicit WordSets(const Budget& budget,
                      std::size_t longest = std::numeric_limits<std::size_t>::max())
        : budget_(&budget), longest_(longest) {}

    value_type zero() const { return {}; }
    value_type one() const { return {Word{}}; }
    /// left := left united with right.
    void add(value_type& left, const value_type& right) const;
    /// left := all words u v, u from left, v from right. Throws BoundReached if they take more
    /// than the budget's memory.
    void append(value_type& left, const value_type& right) const;

private:
    const Budget* budget_;
    std::size_t longest_;
};

/// Shorter words first, then by symbol numbers.
bool shortlex_less(const Word& left, const Word& right);

}  // namespace algae
