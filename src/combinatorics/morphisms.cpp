// What the images of a morphism say of it: codes, conjugates, palindromes, automorphisms of the free group, squares, eigenvalues.

#include <algorithm>
#include <map>
#include <numeric>
#include <set>

#include "combinatorics/combinatorics.hpp"

namespace algae {

namespace {

/// The domain as letters 0, 1, ..., and the images over it.
class Images {
public:
    explicit Images(const Morphism& h) : letters_(h.domain()) {
        for (const Symbol letter : letters_) {
            all_.emplace_back();
            for (const Symbol one : h[letter]) {
                const auto at = std::lower_bound(letters_.begin(), letters_.end(), one);
                if (at == letters_.end() || *at != one)
                    throw Error("expected a morphism into the words over its own letters");
                all_.back().push_back(static_cast<Symbol>(at - letters_.begin()));
            }
        }
    }

    std::size_t count() const { return all_.size(); }
    const std::vector<Word>& all() const { return all_; }
    const Word& operator[](std::size_t letter) const { return all_[letter]; }
    /// A word with the letters of the domain again.
    Word named(Word word) const { return replaced(std::move(word), letters_); }
    Word image(const Word& word) const {
        Word found;
        for (const Symbol letter : word)
            found.insert(found.end(), all_[letter].begin(), all_[letter].end());
        return found;
    }

private:
    std::vector<Symbol> letters_;
    std::vector<Word> all_;
};

bool begins(const Word& part, const Word& whole) {
    return part.size() <= whole.size() && std::equal(part.begin(), part.end(), whole.begin());
}
bool ends(const Word& part, const Word& whole) {
    return part.size() <= whole.size() && std::equal(part.rbegin(), part.rend(), whole.rbegin());
}

template <class Holds>
bool holds_of_all_pairs(const Images& images, Holds holds) {
    for (std::size_t a = 0; a < images.count(); ++a)
        for (std::size_t b = 0; b < images.count(); ++b)
            if (a != b && !holds(images[a], images[b])) return false;
    return true;
}

/// Two words with the same image: of the words read so far, the image of one is that of the other with the end of an image behind it.
class SameImage {
public:
    SameImage(const Images& images, const Budget& budget) : images_(images), budget_(budget) {}

    std::optional<std::pair<Word, Word>> found() {
        for (Symbol a = 0; a < images_.count(); ++a)
            if (images_[a].empty()) return std::pair(Word{a}, Word{});
        for (Symbol a = 0; a < images_.count(); ++a)
            for (Symbol b = 0; b < images_.count(); ++b)
                if (a != b && begins(images_[a], images_[b]))
                    add({{b, images_[a].size()}, {}, a, b});
        // In order of the number of letters; a word and a beginning of another do not differ in their first letters.
        for (std::size_t i = 0; i < steps_.size(); ++i) {
            budget_.check();
            const auto [letter, begin] = steps_[i].rest;
            const Word rest(images_[letter].begin() + static_cast<std::ptrdiff_t>(begin),
                            images_[letter].end());
            if (rest.empty()) return words(i);
            for (Symbol a = 0; a < images_.count(); ++a) {
                if (begins(images_[a], rest))
                    add({{letter, begin + images_[a].size()}, i, a, {}});
                else if (begins(rest, images_[a]))
                    add({{a, rest.size()}, i, a, {}, true});
            }
        }
        return std::nullopt;
    }

private:
    struct Step {
        std::pair<std::size_t, std::size_t> rest;  // what is ahead: of an image, from a place on
        std::optional<std::size_t> before;         // the step before
        Symbol behind;                // the letter that was added to the word that was behind
        std::optional<Symbol> ahead;  // and at first the one of the other word
        bool is_turned = false;       // the word that was behind is ahead now
    };

    void add(const Step& step) {
        const auto& [letter, begin] = step.rest;
        Word rest(images_[letter].begin() + static_cast<std::ptrdiff_t>(begin),
                  images_[letter].end());
        if (seen_.insert(std::move(rest)).second) steps_.push_back(step);
    }

    std::pair<Word, Word> words(std::size_t at) const {
        std::vector<std::size_t> path;
        for (std::optional<std::size_t> i = at; i; i = steps_[*i].before) path.push_back(*i);
        Word behind, ahead;
        for (std::size_t i = path.size(); i-- > 0;) {
            const Step& step = steps_[path[i]];
            behind.push_back(step.behind);
            if (step.ahead) ahead.push_back(*step.ahead);
            if (step.is_turned) std::swap(behind, ahead);
        }
        return {images_.named(std::move(behind)), images_.named(std::move(ahead))};
    }

    const Images& images_;
    const Budget& budget_;
    std::vector<Step> steps_;
    std::set<Word> seen_;
};

/// How many letters x x x ... and y y y ... have in common at the beginning; nothing if they are the same, so that x and y are powers of one word.
std::optional<std::size_t> common(const Word& x, const Word& y) {
    for (std::size_t i = 0; i < x.size() + y.size(); ++i)
        if (x[i % x.size()] != y[i % y.size()]) return i;
    return std::nullopt;  // Fine and Wilf 1965
}

bool is_palindrome(const Word& word, std::size_t begin, std::size_t end) {
    while (begin < end)
        if (word[begin++] != word[--end]) return false;
    return true;
}

/// A morphism and its conjugates.
class Conjugates {
public:
    Conjugates(const Images& images, const Budget& budget) : images_(images), budget_(budget) {
        for (const Word& image : images_.all())
            if (!image.empty()) words_.push_back(image);
        if (words_.empty()) return;
        right_ = steps(words_);
        std::vector<Word> turned;
        for (const Word& word : words_) turned.emplace_back(word.rbegin(), word.rend());
        left_ = steps(turned);
    }

    bool is_cyclic() const { return !words_.empty() && !right_; }
    std::size_t count() const {
        if (words_.empty()) return 1;
        return right_ ? 1 + *left_ + *right_ : primitive_root(words_.front()).size();
    }

    /// Whether the images are p q, or all are q p, with palindromes.
    bool is_class_p() const {
        for (const bool is_behind : {false, true}) {
            std::size_t shortest = ~std::size_t{0};
            for (const Word& image : images_.all()) shortest = std::min(shortest, image.size());
            for (std::size_t size = 0; size <= shortest; ++size) {
                budget_.check();
                if (std::ranges::all_of(images_.all(), [&](const Word& image) {
                        return is_product(image, size, is_behind);
                    }))
                    return true;
            }
        }
        return false;
    }

    /// Then some conjugate has palindromes as its images, or one letter and palindromes behind it: half of p moves to the other side.
    bool has_class_p() const {
        std::vector<Word> words = words_;
        const bool is_erasing = words.size() < images_.count();
        if (left_)
            for (std::size_t i = 0; i < *left_; ++i)
                for (Word& word : words) std::rotate(word.begin(), word.end() - 1, word.end());
        for (std::size_t i = 0; i < count(); ++i) {
            budget_.check();
            const auto all = [&](std::size_t from) {
                return std::ranges::all_of(words, [&](const Word& word) {
                    return is_palindrome(word, from, word.size());
                });
            };
            const bool is_one_letter = std::ranges::all_of(
                words, [&](const Word& word) { return word.front() == words.front().front(); });
            if (all(0) || (!is_erasing && is_one_letter && all(1))) return true;
            for (Word& word : words) std::rotate(word.begin(), word.begin() + 1, word.end());
        }
        return false;
    }

private:
    static std::optional<std::size_t> steps(const std::vector<Word>& words) {
        std::optional<std::size_t> least;
        for (std::size_t i = 1; i < words.size(); ++i)
            if (const auto found = common(words[0], words[i]))
                least = std::min(least.value_or(*found), *found);
        return least;
    }

    /// Whether the word has the first, or last, `size` letters of the first image there, a palindrome, and a palindrome beside them.
    bool is_product(const Word& image, std::size_t size, bool is_behind) const {
        const Word& other = images_[0];
        const std::size_t cut = is_behind ? image.size() - size : size;
        const bool has_same =
            is_behind
                ? std::equal(image.rbegin(), image.rbegin() + static_cast<std::ptrdiff_t>(size),
                             other.rbegin())
                : std::equal(image.begin(), image.begin() + static_cast<std::ptrdiff_t>(size),
                             other.begin());
        return has_same && is_palindrome(image, 0, cut) && is_palindrome(image, cut, image.size());
    }

    const Images& images_;
    const Budget& budget_;
    std::vector<Word> words_;  // images that are not empty
    std::optional<std::size_t> left_, right_;
};

/// Whether the images generate the free group: circles that are labelled with them and have one node in common are folded until no two edges
/// with one label begin, or end, in one node. Then there is one node with an edge for each letter. As many words as letters that
/// generate it are a basis.
class Folding {
public:
    explicit Folding(const Images& images) : letters_(images.count()) {
        node();
        for (const Word& image : images.all())
            for (std::size_t i = 0, here = 0; i < image.size(); ++i) {
                const std::size_t next = i + 1 < image.size() ? node() : 0;
                join(here, image[i], next);
                here = next;
            }
    }

    bool is_rose() const {
        for (std::size_t i = 0; i < parents_.size(); ++i)
            if (find(i) != find(0)) return false;
        const auto& edges = after_[find(0)];
        return std::ranges::count(edges, none) == 0;
    }

private:
    static constexpr std::size_t none = ~std::size_t{0};

    std::size_t node() {
        parents_.push_back(parents_.size());
        after_.emplace_back(letters_, none);
        before_.emplace_back(letters_, none);
        return parents_.size() - 1;
    }
    std::size_t find(std::size_t one) const {
        while (parents_[one] != one) one = parents_[one] = parents_[parents_[one]];
        return one;
    }
    void join(std::size_t from, Symbol letter, std::size_t to) {
        std::vector<std::pair<std::size_t, std::size_t>> same;
        const auto set = [&](std::size_t& place, std::size_t other) {
            if (place == none)
                place = other;
            else
                same.emplace_back(place, other);
        };
        set(after_[find(from)][letter], to);
        set(before_[find(to)][letter], from);
        while (!same.empty()) {
            auto [x, y] = same.back();
            same.pop_back();
            x = find(x);
            y = find(y);
            if (x == y) continue;
            parents_[y] = x;
            for (std::size_t a = 0; a < letters_; ++a) {
                if (after_[y][a] != none) set(after_[x][a], after_[y][a]);
                if (before_[y][a] != none) set(before_[x][a], before_[y][a]);
            }
        }
    }

    std::size_t letters_;
    mutable std::vector<std::size_t> parents_;
    std::vector<std::vector<std::size_t>> after_, before_;  // by node and letter
};

bool has_square(const Word& word) { return !repetitions_in(word).runs.empty(); }

bool has_overlap(const Word& word) {
    const auto runs = repetitions_in(word).runs;
    return std::ranges::any_of(runs,
                               [](const Run& run) { return run.end - run.begin > 2 * run.period; });
}

/// Tries the images of square-free words, shorter ones first.
void look_for_squares(const Images& images, MorphismProperties& found, const Budget& budget) {
    constexpr std::size_t most = 100'000;
    // Crochemore's bound; where b is forgotten and a is not, a b a has a square as its image.
    std::size_t long_enough = 3;
    if (found.shortest > 0 && found.longest > 3)
        long_enough =
            std::max(long_enough, 1 + (found.longest - 3 + found.shortest - 1) / found.shortest);
    std::vector<Word> words{{}};
    std::size_t tried = 0;
    for (std::size_t length = 1; length <= long_enough && !words.empty(); ++length) {
        std::vector<Word> longer;
        for (const Word& word : words)
            for (Symbol a = 0; a < images.count(); ++a) {
                Word next = word;
                next.push_back(a);
                if (has_square(next)) continue;
                if (++tried > most) return;
                budget.check();
                if (has_square(images.image(next))) {
                    found.square_free = false;
                    found.makes_square = images.named(std::move(next));
                    return;
                }
                longer.push_back(std::move(next));
            }
        words = std::move(longer);
    }
    found.square_free = true;
}

void look_at_eigenvalues(const Images& images, MorphismProperties& found) {
    IntegerMatrix matrix(images.count(), images.count());
    for (std::size_t a = 0; a < images.count(); ++a)
        for (const Symbol letter : images[a]) matrix(a, letter) += Integer(1);
    found.characteristic = characteristic_polynomial(matrix);
    found.determinant = determinant(matrix);
    const Factorisation factors = factorise(found.characteristic);
    found.irreducible = factors.powers.size() == 1 && factors.powers.front().exponent == 1;
    // The greatest eigenvalue is real (Perron and Frobenius); its conjugates are the roots of its factor.
    constexpr long bits = 128;
    std::optional<Ball> greatest;
    Polynomial minimal;
    for (const auto& [factor, exponent] : factors.powers)
        for (const Root& root : roots(factor, bits))
            if (root.is_real && (!greatest || compare(root.real, *greatest) == Order::greater)) {
                greatest = root.real;
                minimal = factor;
            }
    const Ball one(1, bits);
    if (!greatest || compare(*greatest, one) != Order::greater) return;
    const auto size = [](const Root& root) {
        return root.real * root.real + root.imaginary * root.imaginary;
    };
    const std::vector<Root> all = roots(minimal, bits);
    const auto inside = std::ranges::count_if(
        all, [&](const Root& root) { return compare(size(root), one) == Order::less; });
    found.pisot = inside + 1 == std::ssize(all);
    // If the polynomial is the same backwards the mirror image of a root in the circle is a root, and the root itself if it is near no other one.
    const Polynomial turned(
        std::vector<Integer>(minimal.coefficients().rbegin(), minimal.coefficients().rend()));
    if (minimal.degree() < 4 || turned != minimal || inside != 1) return;
    const auto is_near_one = [&](const Root& root) {
        const Ball real = root.real / size(root), imaginary = root.imaginary / size(root);
        return std::ranges::count_if(all, [&](const Root& other) {
                   return other.real.overlaps(real) && other.imaginary.overlaps(imaginary);
               }) == 1;
    };
    found.salem = std::ranges::all_of(
        all, [&](const Root& root) { return root.is_real || is_near_one(root); });
}

}  // namespace

MorphismProperties morphism_properties(const Morphism& h, const Budget& budget) {
    const Images images(h);
    MorphismProperties found;
    if (images.count() == 0) throw Error("expected a morphism of at least one letter");
    found.shortest = ~std::size_t{0};
    for (const Word& image : images.all()) {
        found.shortest = std::min(found.shortest, image.size());
        found.longest = std::max(found.longest, image.size());
    }
    found.prefix_code =
        holds_of_all_pairs(images, [](const Word& x, const Word& y) { return !begins(x, y); });
    found.suffix_code =
        holds_of_all_pairs(images, [](const Word& x, const Word& y) { return !ends(x, y); });
    const bool is_erasing = found.shortest == 0;
    found.left_marked = !is_erasing && holds_of_all_pairs(images, [](const Word& x, const Word& y) {
        return x.front() != y.front();
    });
    found.right_marked =
        !is_erasing && holds_of_all_pairs(images, [](const Word& x, const Word& y) {
            return x.back() != y.back();
        });
    found.prefix_code = found.prefix_code && !is_erasing;
    found.suffix_code = found.suffix_code && !is_erasing;
    found.same_image = SameImage(images, budget).found();
    const Conjugates conjugates(images, budget);
    found.conjugates = conjugates.count();
    found.cyclic = conjugates.is_cyclic();
    found.class_p = conjugates.is_class_p();
    found.conjugate_of_class_p = found.class_p || conjugates.has_class_p();
    found.automorphism = !is_erasing && Folding(images).is_rose();
    found.sturmian = found.automorphism && images.count() == 2;
    look_for_squares(images, found, budget);
    if (images.count() == 2 && !is_erasing)
        found.overlap_free = !has_overlap(images.image({0, 1, 1, 0, 1, 0, 0, 1}));
    look_at_eigenvalues(images, found);
    return found;
}

}  // namespace algae
