#include <algorithm>
#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/strong_components.hpp>
#include <cctype>
#include <iterator>
#include <numeric>
#include <optional>
#include <string>

#include "exact/exact.hpp"
#include "word/word.hpp"

// Symbols are numbers, and only an alphabet gives them names. A word is written by its symbols' names one after the other,
// and a blank stands exactly where two names would otherwise be read as one: after a subscript in digits (`X_1 2`), beside
// names longer than a letter and its subscript, and where short names together begin such a longer name.
// `Spellings` does this as a monoid, so that a fold can write a word that nobody derives.

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
    std::sort(order.begin(), order.end(),
              [&](Symbol a, Symbol b) { return names_[a] < names_[b]; });
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

Spellings::Spellings(const Alphabet& alphabet) : alphabet_(&alphabet) {
    if (alphabet.long_names().empty()) return;
    auto rests = std::make_shared<Rests>();
    for (const Symbol symbol : alphabet.long_names()) {
        const std::string_view name = alphabet.name(symbol);
        for (std::size_t bytes = 1; bytes < name.size(); ++bytes)
            if (const auto begun = alphabet.find(name.substr(0, bytes)))
                (*rests)[*begun].emplace_back(name.substr(bytes));
    }
    rests_ = std::move(rests);
}

bool Spellings::begins_long_name(Symbol left, std::string_view right) const {
    const auto found = rests_->find(left);
    return found != rests_->end() &&
           std::any_of(found->second.begin(), found->second.end(), [&](const std::string& rest) {
               return rest.starts_with(right) || right.starts_with(rest);
           });
}

Morphism::Morphism(std::vector<Word> images)
    : images_(std::move(images)), mapped_(images_.size(), 1) {}

Morphism::Morphism(std::initializer_list<std::pair<Symbol, Word>> images) {
    for (const auto& [letter, image] : images) add(letter, image);
}

bool Morphism::add(Symbol letter, Word image) {
    if (maps(letter)) return false;
    if (letter >= size()) {
        images_.resize(letter + std::size_t{1});
        mapped_.resize(images_.size());
    }
    images_[letter] = std::move(image);
    mapped_[letter] = 1;
    return true;
}

std::vector<Symbol> Morphism::domain() const {
    std::vector<Symbol> letters;
    for (Symbol a = 0; a < size(); ++a)
        if (maps(a)) letters.push_back(a);
    return letters;
}

std::optional<Word> Morphism::image_of(const Word& word) const {
    Word image;
    for (const Symbol a : word) {
        if (!maps(a)) return std::nullopt;
        image.insert(image.end(), images_[a].begin(), images_[a].end());
    }
    return image;
}

Word Morphism::operator()(const Word& word) const {
    std::optional<Word> image = image_of(word);
    if (!image) throw Error("the morphism has no image for a letter of the word");
    return *std::move(image);
}

std::vector<Symbol> Morphism::erased() const {
    std::vector<Symbol> letters = domain();
    std::erase_if(letters, [&](Symbol a) { return !images_[a].empty(); });
    return letters;
}

Morphism Morphism::mirrored() const {
    Morphism other = *this;
    for (Word& image : other.images_) std::reverse(image.begin(), image.end());
    return other;
}

std::string to_string(const Morphism& morphism, const Alphabet& alphabet) {
    return "{ " +
           joined(
               morphism.domain(), "; ",
               [&](Symbol a) { return alphabet.name(a) + " -> " + spell(alphabet, morphism[a]); }) +
           " }";
}

std::vector<std::size_t> strong_components(
    const std::vector<std::vector<std::size_t>>& successors) {
    using Graph = boost::adjacency_list<boost::vecS, boost::vecS, boost::directedS>;
    Graph graph(successors.size());
    for (std::size_t from = 0; from < successors.size(); ++from)
        for (const std::size_t to : successors[from]) boost::add_edge(from, to, graph);
    std::vector<std::size_t> component(successors.size());
    boost::strong_components(graph, boost::make_iterator_property_map(
                                        component.begin(), boost::get(boost::vertex_index, graph)));
    return component;
}

std::optional<Brackets> brackets_of(const Alphabet& alphabet) {
    const auto open = alphabet.find("["), close = alphabet.find("]");
    if (!open || !close) return std::nullopt;
    return Brackets{*open, *close};
}

bool brackets_match(const Word& word, const Brackets& brackets) {
    std::size_t depth = 0;
    for (const Symbol a : word) {
        if (a == brackets.open) ++depth;
        if (a == brackets.close && depth-- == 0) return false;
    }
    return depth == 0;
}

std::vector<Symbol> renaming(const Alphabet& from, const Alphabet& to) {
    std::vector<Symbol> letters;
    for (Symbol a = 0; a < from.size(); ++a) {
        const std::optional<Symbol> letter = to.find(from.name(a));
        if (!letter) throw Error("the symbol " + from.name(a) + " is not in the alphabet");
        letters.push_back(*letter);
    }
    return letters;
}

Word replaced(Word word, const std::vector<Symbol>& letters) {
    for (Symbol& a : word) a = letters[a];
    return word;
}

std::vector<std::uint64_t> lifetimes(const Morphism& morphism) {
    const std::vector<Word>& images = morphism.images();
    std::vector<std::uint64_t> lifetime(images.size(), lasts);
    std::vector<std::size_t> alive(
        images.size());  // letters of the image that are not known to die
    std::vector<std::vector<Symbol>> occurs_in(images.size());
    std::vector<Symbol> dying;
    for (Symbol a = 0; a < images.size(); ++a) {
        alive[a] = images[a].size();
        for (const Symbol b : images[a]) occurs_in[b].push_back(a);
        if (alive[a] == 0) {
            lifetime[a] = 1;
            dying.push_back(a);
        }
    }
    for (std::size_t i = 0; i < dying.size(); ++i)  // in the order of their lifetimes
        for (const Symbol a : occurs_in[dying[i]])
            if (--alive[a] == 0) {
                lifetime[a] = lifetime[dying[i]] + 1;
                dying.push_back(a);
            }
    return lifetime;
}

bool shortlex_less(const Word& left, const Word& right) {
    return left.size() != right.size() ? left.size() < right.size() : left < right;
}

void WordSets::add(value_type& left, const value_type& right) const {
    if (right.empty()) return;
    value_type both;
    both.reserve(left.size() + right.size());
    std::set_union(left.begin(), left.end(), right.begin(), right.end(), std::back_inserter(both),
                   shortlex_less);
    left = std::move(both);
}

void WordSets::append(value_type& left, const value_type& right) const {
    if (right.size() == 1 && right.front().empty()) return;
    value_type product;
    // There is one such set for each letter, and one on the way; none may take more than a share.
    const std::uint64_t share = budget_->memory / 8;
    std::uint64_t bytes = 0;
    const auto settle = [&] {
        std::sort(product.begin(), product.end(), shortlex_less);
        product.erase(std::unique(product.begin(), product.end()), product.end());
        bytes = 0;
        std::uint64_t letters = 0;
        for (const Word& word : product) {
            bytes += sizeof(Word) + 16 + word.capacity() * sizeof(Symbol);
            letters += word.size();
        }
        if (letters > budget_->letters)
            throw BoundReached(Bound::letters, "the set of words has more than " +
                                                   std::to_string(budget_->letters) +
                                                   " letters, the bound set" +
                                                   budget_->by(Bound::letters));
        if (bytes > share)
            throw BoundReached(Bound::memory,
                               "the set of words, one of those for each letter, would take more "
                               "than an eighth of the " +
                                   std::to_string(budget_->memory >> 20) + " MiB allowed" +
                                   budget_->by(Bound::memory));
    };
    std::uint64_t next_settling = std::min(std::uint64_t{1} << 20, share);
    for (const Word& u : left)
        for (const Word& v : right) {
            if (v.size() > longest_ || u.size() > longest_ - v.size()) continue;
            Word& word = product.emplace_back();
            word.reserve(u.size() + v.size());
            word.insert(word.end(), u.begin(), u.end());
            word.insert(word.end(), v.begin(), v.end());
            bytes += sizeof(Word) + 16 + word.capacity() * sizeof(Symbol);
            if (bytes > next_settling) {  // many products are the same word: count them once
                budget_->check();
                settle();
                next_settling = std::min(std::max(next_settling, 2 * bytes), share + bytes / 2);
            }
        }
    settle();
    left = std::move(product);
}

}  // namespace algae
