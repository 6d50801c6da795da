#include <algorithm>
#include <numeric>
#include <set>

#include "combinatorics/detail/levels.hpp"

// Derived words, which returns to the first letter make of an infinite word, and what is seen of it in them.
//
// Let 1 be the first letter of u, and let it come back. u is cut before each 1 into return words 1x, x without 1; number them in order, and u is
// the image of a derived word u' under the morphism T that gives each its return word. h(u) = u makes the cuts of u cuts of its
// image, so u' is the infinite word of a morphism h' with T h' = h T, found letter by letter from the first return word on. The derived words
// u, u', u'', ... are finitely many for a primitive h (Durand, A characterization of substitutive sequences using return words,
// 1998, where this is about returns to prefixes of u; deriving again and again by first letters gives such). Two of them are equal
// as soon as their morphisms are, numbered by first occurrence; from there on everything repeats.

namespace algae {

namespace {

/// The word cut before each 0, numbered by first occurrence: the return words are added to the list.
class Cutting {
public:
    Symbol number(const Word& piece) {
        const auto [at, is_new] = numbers_.emplace(piece, static_cast<Symbol>(pieces_.size()));
        if (is_new) {
            pieces_.push_back(piece);
            size_ += piece.size();
            if (size_ > most_letters) too_large("get too large");
        }
        return at->second;
    }
    const Images& pieces() const { return pieces_; }

private:
    std::map<Word, Symbol> numbers_;
    Images pieces_;
    std::size_t size_ = 0;
};

/// The images with letters numbered by first occurrence in the word that the first one begins.
Images in_order(const Morphism& h, Symbol first) {
    std::map<Symbol, Symbol> numbers{{first, 0}};
    std::vector<Symbol> letters{first};
    Images images;
    for (std::size_t i = 0; i < letters.size(); ++i) {
        Word image;
        for (const Symbol letter : h[letters[i]]) {
            const auto [at, is_new] = numbers.emplace(letter, static_cast<Symbol>(letters.size()));
            if (is_new) letters.push_back(letter);
            image.push_back(at->second);
        }
        images.push_back(std::move(image));
    }
    return images;
}

/// The first return word: the beginning of the infinite word before 0 comes back.
Word first_return(const Images& h, const Budget& budget) {
    Word word = h[0];
    for (std::size_t i = 1;; ++i) {
        if (i % 4096 == 0) budget.check();
        if (i >= word.size())
            throw Error("the first letter of the infinite word does not come back in it");
        if (word[i] == 0) {
            word.resize(i);
            return word;
        }
        if (word.size() < most_letters)
            word.insert(word.end(), h[word[i]].begin(), h[word[i]].end());
        if (i >= most_letters) too_large("have return words that are too long");
    }
}

/// The return words of the infinite word of h to its first letter, and the morphism of the derived word.
struct Derived {
    Images returns, h;
};

Derived derived(const Images& h, const Budget& budget) {
    Cutting cutting;
    cutting.number(first_return(h, budget));
    Derived found;
    std::size_t size = 0;
    for (std::size_t i = 0; i < cutting.pieces().size(); ++i) {
        budget.check();
        Word image, piece;
        for (const Symbol letter : Word(cutting.pieces()[i]))
            for (const Symbol next : h[letter]) {
                if (next == 0 && !piece.empty()) {
                    image.push_back(cutting.number(piece));
                    piece.clear();
                }
                piece.push_back(next);
            }
        image.push_back(cutting.number(piece));
        size += image.size();
        if (size > most_letters) too_large("get too large");
        found.h.push_back(std::move(image));
    }
    found.returns = cutting.pieces();
    return found;
}

void put_in_order(Pairs& pairs) {
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
}

/// A word that several texts begin with, and the letter that comes next in each of them.
struct Beginning {
    Word word;
    std::map<Symbol, Symbol> next;  // by the letter whose text it is
};

/// The words that texts begin with and go on after in several ways, none past a second 0.
void branchings(const std::map<Symbol, Word>& texts, const std::vector<Symbol>& these,
                std::size_t length, std::vector<Beginning>& found) {
    std::map<Symbol, std::vector<Symbol>> by_next;
    for (const Symbol one : these) by_next[texts.at(one)[length]].push_back(one);
    if (by_next.size() > 1) {
        Beginning here;
        const Word& text = texts.at(these.front());
        here.word.assign(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(length));
        for (const auto& [letter, those] : by_next)
            for (const Symbol one : those) here.next.emplace(one, letter);
        found.push_back(std::move(here));
    }
    for (const auto& [letter, those] : by_next)
        if (letter != 0 && those.size() > 1) branchings(texts, those, length + 1, found);
}

}  // namespace

void too_large(const std::string& what) {
    throw BoundReached(Bound::method, "the words derived by returns " + what);
}

Integer size(const Counts& counts) {
    return std::accumulate(counts.begin(), counts.end(), Integer(0));
}

Counts sum(Counts left, const Counts& right) {
    for (std::size_t i = 0; i < left.size(); ++i) left[i] += right[i];
    return left;
}

/// The bilateral multiplicity of a word with these pairs of letters around it; nothing if it is not bispecial.
std::optional<std::int64_t> multiplicity(const Pairs& pairs) {
    std::set<Symbol> left, right;
    for (const auto& [x, y] : pairs) {
        left.insert(x);
        right.insert(y);
    }
    if (left.size() < 2 || right.size() < 2) return std::nullopt;
    return static_cast<std::int64_t>(pairs.size()) - static_cast<std::int64_t>(left.size()) -
           static_cast<std::int64_t>(right.size()) + 1;
}

DerivedLevel::DerivedLevel(Images returns) : returns_(std::move(returns)) {
    Symbol greatest = 0;
    for (const Word& word : returns_)
        for (const Symbol letter : word) greatest = std::max(greatest, letter);
    letters_ = greatest + std::size_t{1};
}

Counts DerivedLevel::image(const Counts& counts) const {
    Counts found(letters_);
    for (std::size_t b = 0; b < counts.size(); ++b)
        if (!counts[b].is_zero())
            for (const auto& [letter, times] : parikh(b))
                found[letter] += counts[b] * Integer(times);
    return found;
}

std::vector<BispecialImage> DerivedLevel::images(const Pairs& pairs) const {
    std::map<Symbol, Word> before, after;
    std::vector<Symbol> left, right;
    for (const auto& [x, y] : pairs) {
        const Word &ends = returns_[x], &begins = returns_[y];
        if (before.emplace(x, Word(ends.rbegin(), ends.rend())).second) left.push_back(x);
        if (const auto at = after.emplace(y, begins); at.second) {
            at.first->second.push_back(0);
            right.push_back(y);
        }
    }
    std::vector<Beginning> ends, begins;
    branchings(before, left, 0, ends);
    branchings(after, right, 1, begins);
    std::vector<BispecialImage> found;
    for (const Beginning& s : ends)
        for (const Beginning& p : begins) {
            BispecialImage one;
            for (const auto& [x, y] : pairs) {
                const auto a = s.next.find(x), b = p.next.find(y);
                if (a != s.next.end() && b != p.next.end())
                    one.pairs.emplace_back(a->second, b->second);
            }
            put_in_order(one.pairs);
            if (!multiplicity(one.pairs)) continue;
            one.added = Counts(letters_);
            for (const Word* word : {&s.word, &p.word})
                for (const Symbol letter : *word) one.added[letter] += 1;
            found.push_back(std::move(one));
        }
    return found;
}

std::vector<BispecialRoot> DerivedLevel::roots() const {
    std::vector<Word> texts = returns_;
    std::vector<Place> places;
    for (std::size_t b = 0; b < texts.size(); ++b) {
        texts[b].push_back(0);
        for (std::size_t i = 1; i < texts[b].size(); ++i) places.push_back({b, i});
    }
    std::vector<BispecialRoot> found;
    look(texts, places, 0, found);
    return found;
}

void DerivedLevel::look(const std::vector<Word>& texts, const std::vector<Place>& places,
                        std::size_t length, std::vector<BispecialRoot>& found) const {
    Pairs pairs;
    std::map<Symbol, std::vector<Place>> by_next;
    for (const Place& place : places) {
        const Word& text = texts[place.text];
        const Symbol next = text[place.begin + length];
        pairs.emplace_back(text[place.begin - 1], next);
        by_next[next].push_back(place);
    }
    put_in_order(pairs);
    if (multiplicity(pairs)) {
        BispecialRoot one{std::move(pairs), Counts(letters_)};
        for (std::size_t i = 0; i < length; ++i)
            one.counts[texts[places.front().text][places.front().begin + i]] += 1;
        found.push_back(std::move(one));
    }
    for (const auto& [letter, those] : by_next) {
        if (letter == 0) continue;
        std::set<Symbol> left;
        for (const Place& place : those) left.insert(texts[place.text][place.begin - 1]);
        if (left.size() > 1) look(texts, those, length + 1, found);
    }
}

const std::map<Symbol, std::size_t>& DerivedLevel::parikh(std::size_t b) const {
    if (parikh_.empty())
        for (const Word& word : returns_) {
            parikh_.emplace_back();
            for (const Symbol letter : word) ++parikh_.back()[letter];
        }
    return parikh_[b];
}

DerivedWords derived_words(const Morphism& h, Symbol a, const Budget& budget) {
    if (!h.maps(a) || h[a].size() < 2 || h[a].front() != a)
        throw Error("expected a letter whose image begins with it and is longer");
    Images now = in_order(h, a);
    std::map<Images, std::size_t> seen;
    DerivedWords found;
    found.letters =
        accessible({a}, h.size(), [&](Symbol letter, const auto& see) { see(h[letter]); });
    for (;;) {
        const auto [at, is_new] = seen.emplace(now, found.words.size());
        if (!is_new) {
            found.before = at->second;
            return found;
        }
        if (found.words.size() == most_levels) too_large("do not repeat");
        Derived next = derived(now, budget);
        found.words.push_back({Morphism(std::move(now)), std::move(next.returns)});
        now = std::move(next.h);
    }
}

std::vector<DerivedLevel> levels_of(DerivedWords all) {
    std::vector<DerivedLevel> levels;
    for (DerivedWord& one : all.words) levels.emplace_back(std::move(one.returns));
    return levels;
}

namespace {

using Blocks = std::set<std::size_t>;  // numbers of blocks

/// Blocks of a number of letters of an infinite word, from places that it divides, and their images.
class BlockMorphism {
public:
    BlockMorphism(const Morphism& h, std::size_t size, std::size_t length, const Budget& budget)
        : length_(length) {
        Word first{0};
        while (first.size() < size) first = h(first);
        first.resize(size);
        number(first);
        for (std::size_t i = 0; i < blocks_.size(); ++i) {
            budget.check();
            const Word image = h(Word(blocks_[i]));
            std::vector<std::size_t> parts;
            for (std::size_t begin = 0; begin < image.size(); begin += size) {
                const auto at = image.begin() + static_cast<std::ptrdiff_t>(begin);
                parts.push_back(number(Word(at, at + static_cast<std::ptrdiff_t>(size))));
            }
            images_.push_back(std::move(parts));
        }
    }

    std::size_t count() const { return blocks_.size(); }
    Blocks column(const Blocks& of, std::size_t place) const {
        Blocks found;
        for (const std::size_t block : of) found.insert(images_[block][place]);
        return found;
    }
    std::size_t columns() const { return length_; }

private:
    std::size_t number(const Word& block) {
        const auto [at, is_new] = numbers_.emplace(block, blocks_.size());
        if (is_new) blocks_.push_back(block);
        return at->second;
    }

    std::size_t length_;
    std::map<Word, std::size_t> numbers_;
    std::vector<Word> blocks_;
    std::vector<std::vector<std::size_t>> images_;
};

/// Whether some power of the matrix has no zero: for a letter whose image begins with it, exactly if all letters lead to each other.
bool is_primitive(const Images& images) {
    std::vector<std::vector<std::size_t>> next;
    for (const Word& image : images) next.emplace_back(image.begin(), image.end());
    const std::vector<std::size_t> parts = strong_components(next);
    return std::all_of(parts.begin(), parts.end(), [&](std::size_t p) { return p == parts[0]; });
}

}  // namespace

std::optional<ConstantLength> constant_length(const Morphism& h, Symbol a, const Budget& budget) {
    if (!h.maps(a) || h[a].size() < 2 || h[a].front() != a)
        throw Error("expected a letter whose image begins with it and is longer");
    const Images images = in_order(h, a);
    ConstantLength found;
    found.length = images[0].size();
    for (const Word& image : images)
        if (image.size() != found.length) return std::nullopt;
    if (!is_primitive(images)) return std::nullopt;
    const DerivedWords all = derived_words(h, a, budget);
    std::size_t distances = 0;
    for (const Word& word : all.words.front().returns) distances = std::gcd(distances, word.size());
    for (const DerivedWord& one : all.words)
        if (one.returns.size() == 1) return std::nullopt;  // from here on it repeats one word
    found.height = distances;
    for (std::size_t common = std::gcd(found.height, found.length); common > 1;
         common = std::gcd(found.height, found.length))
        found.height /= common;
    const BlockMorphism blocks(Morphism(images), found.height, found.length, budget);
    Blocks every;
    for (std::size_t i = 0; i < blocks.count(); ++i) every.insert(i);
    constexpr std::size_t most_sets = 100'000;
    std::set<Blocks> seen{every};
    std::vector<Blocks> wanted{every};
    found.column_number = every.size();
    for (std::size_t i = 0; i < wanted.size(); ++i) {
        budget.check();
        if (wanted.size() > most_sets)
            throw BoundReached(Bound::method,
                               "the images have too many sets of letters at one place");
        for (std::size_t place = 0; place < blocks.columns(); ++place) {
            Blocks next = blocks.column(wanted[i], place);
            found.column_number = std::min(found.column_number, next.size());
            if (seen.insert(next).second) wanted.push_back(std::move(next));
        }
    }
    // The places of the word are read digit by digit after as many zeros as one likes.
    Blocks first = every;
    for (Blocks next = blocks.column(first, 0); next != first; next = blocks.column(first, 0))
        first = std::move(next);
    found.toeplitz = first.size() == 1;
    return found;
}

}  // namespace algae
