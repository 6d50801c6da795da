#include <algorithm>
#include <initializer_list>
#include <limits>

#include "search/search.hpp"

// Instances as values: an instance is kept as its text, flat arrays of letters, of words and of pieces, because it changes
// with every step of the search; what a visitor asks for (a language, a D0L system) is built when it asks. And how large instances can get: a
// domain is finite if its letters and the lengths of its words are bounded, or its size.
//
// What is subtle: letters of later values count. A morphism has images of the letters of all values before it, so the bounds are
// worked out from left to right, with a bound of how many letters have occurred. Sums saturate: a finite bound above 2^64 - 1 is
// that number, which no search reaches.

namespace algae {

namespace {

constexpr std::uint64_t saturated = std::numeric_limits<std::uint64_t>::max();

std::uint64_t sum(std::uint64_t left, std::uint64_t right) {
    return left > saturated - right ? saturated : left + right;
}

std::uint64_t product(std::uint64_t left, std::uint64_t right) {
    return right != 0 && left > saturated / right ? saturated : left * right;
}

std::uint64_t raised(std::uint64_t base, std::uint64_t exponent) {
    if (base <= 1) return exponent == 0 ? 1 : base;
    std::uint64_t result = 1;
    for (; exponent > 0 && result != saturated; --exponent) result = product(result, base);
    return result;
}

/// A number, or no bound.
using Bounded = std::optional<std::uint64_t>;

Bounded least(const Bounded& left, const Bounded& right) {
    if (!left || !right) return left ? left : right;
    return std::min(*left, *right);
}

Bounded sum(const Bounded& left, const Bounded& right) {
    if (!left || !right) return std::nullopt;
    return sum(*left, *right);
}

Bounded product(const Bounded& left, const Bounded& right) {
    if ((left && *left == 0) || (right && *right == 0)) return 0;
    if (!left || !right) return std::nullopt;
    return product(*left, *right);
}

/// The size of the language of all words of at most so many letters of so many.
Bounded all_words(const Bounded& letters, const Bounded& length) {
    if (!length || !letters) return letters && *letters == 0 ? Bounded(1) : std::nullopt;
    if (*letters == 0) return 1;
    std::uint64_t size = 0;
    for (std::uint64_t l = 0; l <= *length && size != saturated; ++l)
        size = sum(size, product(sum(l, 1), raised(*letters, l)));
    return size;
}

/// How large a value of the domain may be where so many letters occur before it and so many occur in it.
Bounded greatest(const Domain& domain, const Bounded& before, const Bounded& letters) {
    const Bounded length = domain.letter_to_letter ? Bounded(1) : domain.max_word_length;
    const Bounded image = sum(length, Bounded(1));
    switch (domain.kind) {
        case Domain::Kind::language:
            return all_words(letters, length);
        case Domain::Kind::system: {
            const Bounded rules =
                product(letters, domain.deterministic ? image : all_words(letters, length));
            if (!domain.tables || !rules || !letters) return sum(length, rules);
            // Tables differ, and each has for each letter a word, or some of the words.
            const Bounded words = all_words(letters, length);
            if (!words) return std::nullopt;
            const std::uint64_t choices =
                domain.deterministic ? *words : raised(2, std::min<std::uint64_t>(*words, 64));
            return sum(length, product(rules, Bounded(raised(choices, *letters))));
        }
        case Domain::Kind::word:
            return image;
        case Domain::Kind::letter:
            return 1;
        case Domain::Kind::morphism:
            return product(before, image);
        case Domain::Kind::inverse_morphism:
            return product(domain.letters, image);
        case Domain::Kind::substitution:
            return product(before, all_words(letters, length));
        case Domain::Kind::number:
            return domain.max_number;
    }
    return std::nullopt;
}

}  // namespace

std::optional<std::uint64_t> greatest_size(const Tuple& tuple) {
    const Bounded everywhere = tuple.over ? tuple.over : tuple.letters;
    Bounded whole = 0, before = 0;  // the size and how many letters have occurred
    for (const Domain& domain : tuple.values) {
        const Bounded length = domain.letter_to_letter ? Bounded(1) : domain.max_word_length;
        Bounded letters = everywhere;
        if (domain.kind != Domain::Kind::inverse_morphism) letters = least(letters, domain.letters);
        letters = least(letters, domain.max_size);
        switch (domain.kind) {
            case Domain::Kind::word:
                letters = least(letters, length);
                break;
            case Domain::Kind::letter:
                letters = least(letters, Bounded(1));
                break;
            case Domain::Kind::morphism:
                letters = least(letters, product(before, length));
                break;
            case Domain::Kind::number:
                letters = 0;
                break;
            case Domain::Kind::substitution:
                if (before && *before == 0) letters = 0;
                break;
            case Domain::Kind::inverse_morphism:
                letters = least(letters, before);
                break;
            case Domain::Kind::language:
            case Domain::Kind::system:
                break;
        }
        const Bounded size = least(domain.max_size, greatest(domain, before, letters));
        whole = sum(whole, size);
        letters = least(letters, size);
        before =
            least(everywhere,
                  domain.kind == Domain::Kind::inverse_morphism ? before : sum(before, letters));
    }
    return whole;
}

bool is_finite(const Tuple& tuple) { return greatest_size(tuple).has_value(); }

Alphabet search_alphabet(std::size_t letters) {
    Alphabet alphabet;
    for (std::size_t i = 0; i < letters; ++i) {
        std::string name(1, static_cast<char>('a' + i % 26));
        if (i >= 26) name += '_' + std::to_string(i / 26);
        alphabet.symbol(name);
    }
    return alphabet;
}

Word Instance::word_at(std::size_t word) const {
    return {letters_.begin() + static_cast<std::ptrdiff_t>(words_[word]),
            letters_.begin() + static_cast<std::ptrdiff_t>(word_end(word))};
}

std::vector<Word> Instance::words_of(std::size_t piece) const {
    std::vector<Word> words;
    for (std::size_t i = pieces_[piece]; i < piece_end(piece); ++i) words.push_back(word_at(i));
    return words;
}

std::size_t Instance::piece_of(std::size_t value, std::size_t owner, std::size_t table) const {
    const Value& of = values_[value];
    const std::size_t axiom = of.kind == Domain::Kind::system ? 1 : 0;
    return of.first_piece + axiom + owner * of.tables + table;
}

const Instance::Value& Instance::expect(std::size_t value,
                                        std::initializer_list<Domain::Kind> kinds,
                                        const char* what) const {
    if (value >= values_.size())
        throw Error("expected one of " + counted(values_.size(), "value") +
                    " of an instance, found number " + std::to_string(value));
    const Value& found = values_[value];
    if (std::find(kinds.begin(), kinds.end(), found.kind) == kinds.end())
        throw Error("expected " + std::string(what) + " as value " + std::to_string(value) +
                    " of an instance, found another kind of value");
    return found;
}

std::vector<Word> Instance::language(std::size_t value) const {
    return words_of(expect(value, {Domain::Kind::language}, "a language").first_piece);
}

Word Instance::word(std::size_t value) const {
    return words_of(expect(value, {Domain::Kind::word}, "a word").first_piece).front();
}

Symbol Instance::letter(std::size_t value) const {
    return words_of(expect(value, {Domain::Kind::letter}, "a letter").first_piece).front().front();
}

std::uint64_t Instance::number(std::size_t value) const {
    return expect(value, {Domain::Kind::number}, "a number").number;
}

ET0L Instance::et0l(std::size_t value) const {
    const Value& of = expect(value, {Domain::Kind::system}, "a system");
    ET0L system{.alphabet = std::make_shared<Alphabet>(search_alphabet(letter_count_)),
                .axiom = words_of(of.first_piece).front(),
                .tables = std::vector<Table>(of.tables, Table(letter_count_)),
                .terminal = std::vector<char>(letter_count_, 1),
                .table_names = std::vector<std::string>(of.tables),
                .name = {}};
    for (std::size_t t = 0; t < of.tables; ++t) {
        for (std::size_t i = 0; i < of.owners.size(); ++i)
            system.tables[t][of.owners[i]] = words_of(piece_of(value, i, t));
        for (Symbol a = 0; a < letter_count_; ++a)
            if (system.tables[t][a].empty()) system.tables[t][a] = {Word{a}};
    }
    return system;
}

OL Instance::ol(std::size_t value) const {
    if (expect(value, {Domain::Kind::system}, "a system").tables != 1)
        throw Error("expected a system with one table as value " + std::to_string(value) +
                    " of an instance, found " + std::to_string(values_[value].tables));
    ET0L system = et0l(value);
    return {.alphabet = std::move(system.alphabet),
            .axiom = std::move(system.axiom),
            .successors = std::move(system.tables.front()),
            .letters = values_[value].owners,
            .name = {}};
}

D0L Instance::d0l(std::size_t value) const {
    OL system = ol(value);
    std::vector<Word> images;
    for (std::vector<Word>& successors : system.successors) {
        if (successors.size() != 1)
            throw Error("expected a deterministic system as value " + std::to_string(value) +
                        " of an instance, found a letter with " +
                        std::to_string(successors.size()) + " successors");
        images.push_back(std::move(successors.front()));
    }
    return {.alphabet = std::move(system.alphabet),
            .axiom = std::move(system.axiom),
            .rules = Morphism(std::move(images)),
            .letters = std::move(system.letters),
            .name = {}};
}

Morphism Instance::morphism(std::size_t value) const {
    const Value& of =
        expect(value, {Domain::Kind::morphism, Domain::Kind::inverse_morphism}, "a morphism");
    if (of.kind == Domain::Kind::inverse_morphism) return Morphism(words_of(of.first_piece));
    Morphism morphism;
    for (std::size_t i = 0; i < of.owners.size(); ++i)
        morphism.add(of.owners[i], words_of(piece_of(value, i, 0)).front());
    return morphism;
}

std::vector<std::pair<Symbol, std::vector<Word>>> Instance::substitution(std::size_t value) const {
    const Value& of = expect(value, {Domain::Kind::substitution}, "a substitution");
    std::vector<std::pair<Symbol, std::vector<Word>>> images;
    for (std::size_t i = 0; i < of.owners.size(); ++i)
        images.emplace_back(of.owners[i], words_of(piece_of(value, i, 0)));
    return images;
}

std::string Instance::text(std::size_t value) const {
    if (value >= values_.size())
        throw Error("expected one of " + counted(values_.size(), "value") +
                    " of an instance, found number " + std::to_string(value));
    const Value& of = values_[value];
    if (of.kind == Domain::Kind::number) return std::to_string(of.number);
    const Alphabet alphabet = search_alphabet(letter_count_);
    std::string text;
    if (of.tables > 1) text = std::to_string(of.tables) + ':';
    for (std::size_t p = of.first_piece; p < value_end(value); ++p) {
        if (p > of.first_piece) text += '#';
        const std::vector<Word> words = words_of(p);
        text += words.empty()
                    ? "{}"
                    : joined(words, ",", [&](const Word& word) { return spell(alphabet, word); });
    }
    return text;
}

std::string Instance::text() const {
    std::vector<std::string> texts;
    for (std::size_t i = 0; i < values_.size(); ++i) texts.push_back(text(i));
    return joined(texts, "; ");
}

}  // namespace algae
