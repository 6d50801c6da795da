// What is said of a morphism by its images, and of derived words, columns and families of its infinite word.

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <cmath>
#include <complex>
#include <numeric>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "combinatorics/combinatorics.hpp"
#include "oracle/finite_words.hpp"
#include "oracle/morphisms.hpp"

using namespace algae;

namespace {

using oracle::LetterImages;

Morphism morphism(const LetterImages& images) {
    std::vector<Word> all;
    for (const std::string& image : images) {
        all.emplace_back();
        for (const char letter : image) all.back().push_back(static_cast<Symbol>(letter - 'a'));
    }
    return Morphism(all);
}

std::string text_of(const Word& word) {
    std::string text;
    for (const Symbol letter : word) text += static_cast<char>('a' + letter);
    return text;
}

MorphismProperties properties(const LetterImages& images) {
    return morphism_properties(morphism(images));
}

/// Of few letters; conjugates of powers, compositions of automorphisms and palindromes among them, which are rare at random.
LetterImages any_images(std::mt19937& generator) {
    const auto below = [&](std::size_t bound) { return generator() % bound; };
    const std::size_t letters = 2 + below(2);
    const auto word = [&](std::size_t least, std::size_t most) {
        std::string found(least + below(most - least + 1), 'a');
        for (char& letter : found) letter = static_cast<char>('a' + below(letters));
        return found;
    };
    LetterImages images;
    for (std::size_t a = 0; a < letters; ++a) images.push_back(word(below(8) == 0 ? 0 : 1, 4));
    switch (below(5)) {
        case 0: {  // an automorphism: letters are put before or behind others, or change places
            images.clear();
            for (std::size_t a = 0; a < letters; ++a)
                images.emplace_back(1, static_cast<char>('a' + a));
            for (std::size_t i = below(5); i-- > 0;) {
                const std::size_t x = below(letters), y = (x + 1 + below(letters - 1)) % letters;
                if (below(3) == 0)
                    std::swap(images[x], images[y]);
                else
                    images[x] = below(2) == 0 ? images[x] + images[y] : images[y] + images[x];
            }
            break;
        }
        case 1: {
            const std::string root = word(1, 2);
            for (std::string& image : images) {
                image = root;
                for (std::size_t i = below(3); i-- > 0;) image += root;
            }
            break;
        }
        case 2: {
            const auto palindrome = [&] {
                const std::string half = word(0, 1);
                return half + word(0, 1) + std::string(half.rbegin(), half.rend());
            };
            const std::string p = palindrome();
            for (std::string& image : images) image = p + palindrome();
            break;
        }
        default:
            break;
    }
    return images;
}

}  // namespace

TEST_CASE("what is said of random morphisms is what the definitions say") {
    std::mt19937 generator(19);
    std::size_t compared = 0, codes = 0, automorphisms = 0, not_automorphisms = 0, open = 0,
                cyclic = 0, class_p = 0, square_free = 0, overlap_free = 0;
    for (; compared < 3000; ++compared) {
        const LetterImages images = any_images(generator);
        const std::size_t d = images.size();
        std::string text;
        for (const std::string& image : images) text += image + ", ";
        INFO(text);
        const MorphismProperties found = properties(images);
        // Codes.
        const auto known = oracle::same_image_of(images, d == 2 ? 8 : 5);
        if (found.same_image) {
            const std::string x = text_of(found.same_image->first),
                              y = text_of(found.same_image->second);
            REQUIRE(x != y);
            REQUIRE(oracle::mapped(images, x) == oracle::mapped(images, y));
            if (known) REQUIRE(x.size() + y.size() <= known->first.size() + known->second.size());
            if (known && std::max(x.size(), y.size()) <= (d == 2 ? 8 : 5))
                REQUIRE(x.size() + y.size() == known->first.size() + known->second.size());
        } else {
            ++codes;
            REQUIRE(!known);
        }
        if (found.prefix_code || found.suffix_code) REQUIRE(!found.same_image);
        // Conjugates.
        const auto conjugates = oracle::conjugates_of_morphism(images);
        REQUIRE(found.conjugates == conjugates.size());
        cyclic += found.cyclic;
        std::set<std::string> roots;
        for (const std::string& image : images)
            if (!image.empty()) roots.insert(oracle::root_of(image));
        REQUIRE(found.cyclic == (roots.size() == 1));
        REQUIRE(found.class_p == oracle::is_class_p(images));
        bool has_class_p = false;
        for (const LetterImages& one : conjugates)
            has_class_p = has_class_p || oracle::is_class_p(one);
        REQUIRE(found.conjugate_of_class_p == has_class_p);
        class_p += has_class_p;
        // Automorphisms.
        const bool may_be =
            oracle::permutes_choices(images, 3) && (d == 3 || oracle::permutes_choices(images, 4));
        if (found.automorphism) {
            ++automorphisms;
            REQUIRE(may_be);
            REQUIRE((found.determinant == Integer(1) || found.determinant == Integer(-1)));
        } else if (!may_be ||
                   (found.determinant != Integer(1) && found.determinant != Integer(-1))) {
            ++not_automorphisms;
        } else {
            ++open;
        }
        if (d == 2 && !images[0].empty() && !images[1].empty()) {
            // Berstel and Seebold 1994: balanced on this word, and not cyclic.
            const bool is_sturmian =
                !found.cyclic && oracle::is_balanced(oracle::mapped(images, "baabaababaabab"));
            REQUIRE(found.sturmian == is_sturmian);
        }
        // Squares and overlaps.
        std::size_t least = 0;  // letters of a word without squares whose image has one
        bool makes_overlap = false;
        for (const std::string& word : oracle::words_to(d, d == 2 ? 9 : 6)) {
            const std::string image = oracle::mapped(images, word);
            if (least == 0 && !oracle::has_square(word) && oracle::has_square(image))
                least = word.size();
            makes_overlap =
                makes_overlap || (!oracle::has_overlap(word) && oracle::has_overlap(image));
        }
        REQUIRE(found.square_free.has_value());
        REQUIRE(*found.square_free == !found.makes_square.has_value());
        if (*found.square_free) {
            ++square_free;
            REQUIRE(least == 0);
        } else {
            const std::string word = text_of(*found.makes_square);
            REQUIRE(!oracle::has_square(word));
            REQUIRE(oracle::has_square(oracle::mapped(images, word)));
            if (least > 0) REQUIRE(word.size() == least);
        }
        if (found.overlap_free) {
            REQUIRE(*found.overlap_free == !makes_overlap);
            overlap_free += *found.overlap_free;
        }
    }
    MESSAGE(compared, " morphisms: ", codes, " codes, ", automorphisms, " automorphisms, ",
            not_automorphisms, " others (", open, " not told apart), ", cyclic, " cyclic, ",
            class_p, " of class P, ", square_free, " square-free, ", overlap_free, " overlap-free");
    CHECK(codes >= 500);
    CHECK(automorphisms >= 300);
    CHECK(not_automorphisms >= 1000);
    CHECK(open * 20 <= compared);
    CHECK(cyclic >= 200);
    CHECK(class_p >= 300);
    CHECK(square_free >= 50);
    CHECK(overlap_free >= 20);
}

TEST_CASE("known morphisms") {
    const MorphismProperties fibonacci = properties({"ab", "a"});
    CHECK(fibonacci.sturmian);
    CHECK(fibonacci.pisot);
    CHECK(fibonacci.irreducible);
    CHECK(fibonacci.class_p);
    CHECK(fibonacci.conjugates == 2);
    CHECK(fibonacci.determinant == Integer(-1));
    const MorphismProperties thue_morse = properties({"ab", "ba"});
    CHECK(thue_morse.overlap_free == true);
    CHECK(thue_morse.square_free == false);
    CHECK(text_of(*thue_morse.makes_square) == "ab");
    CHECK(thue_morse.left_marked);
    CHECK(thue_morse.right_marked);
    CHECK(thue_morse.pisot);  // 2
    CHECK_FALSE(thue_morse.class_p);
    CHECK_FALSE(thue_morse.automorphism);
    CHECK(properties({"abba", "baab"}).class_p);
    // Thue 1912, Leech 1957: without squares.
    CHECK(properties({"abc", "ac", "b"}).square_free == false);
    CHECK(text_of(*properties({"abc", "ac", "b"}).makes_square) == "aba");
    CHECK(properties({"abcbacbcabcba", "bcacbacabcacb", "cabacbabcabac"}).square_free == true);
    // Lehmer's polynomial has degree 10; the smallest Salem number of degree 4 belongs to x^4 - x^3 - x^2 - x + 1.
    const MorphismProperties salem = properties({"d", "ad", "ac", "bc"});
    CHECK(salem.characteristic == Polynomial({1, -1, -1, -1, 1}));
    CHECK(salem.salem);
    CHECK_FALSE(salem.pisot);
    const MorphismProperties chacon = properties({"aaba", "b"});
    CHECK(chacon.pisot);  // 3; the other eigenvalue, 1, is no conjugate of it
    CHECK_FALSE(chacon.irreducible);
    CHECK_FALSE(properties({"abbb", "a"}).pisot);  // (1 + sqrt 13)/2 and its conjugate -1.30
    CHECK_THROWS_WITH_AS(morphism_properties(Morphism({{0, {0, 1}}})),
                         "expected a morphism into the words over its own letters", Error);
}

namespace {

/// The roots of a polynomial by the iteration of Durand and Kerner.
std::vector<std::complex<double>> roots_of(const Polynomial& polynomial) {
    std::vector<std::complex<double>> found;
    const auto degree = static_cast<std::size_t>(polynomial.degree());
    for (std::size_t i = 0; i < degree; ++i)
        found.push_back(std::pow(std::complex<double>(0.4, 0.9), static_cast<double>(i)));
    for (int round = 0; round < 2000; ++round)
        for (std::size_t i = 0; i < degree; ++i) {
            std::complex<double> value = 0, others = 1;
            for (std::size_t k = degree + 1; k-- > 0;)
                value = value * found[i] + polynomial.coefficient(k).to_double();
            for (std::size_t j = 0; j < degree; ++j)
                if (j != i) others *= found[i] - found[j];
            if (std::abs(others) > 1e-30) found[i] -= value / others;
        }
    return found;
}

}  // namespace

TEST_CASE("Pisot numbers are those whose conjugates are small") {
    std::mt19937 generator(7);
    std::size_t compared = 0, pisot = 0;
    for (std::size_t i = 0; i < 1500; ++i) {
        const LetterImages images = any_images(generator);
        const MorphismProperties found = properties(images);
        if (!found.irreducible || found.characteristic.degree() < 2) continue;
        std::vector<double> sizes;
        for (const auto& root : roots_of(found.characteristic)) sizes.push_back(std::abs(root));
        std::sort(sizes.begin(), sizes.end());
        if (std::abs(sizes[sizes.size() - 2] - 1) < 1e-6) continue;
        CHECK(found.pisot == (sizes[sizes.size() - 2] < 1 && sizes.back() > 1));
        pisot += found.pisot;
        ++compared;
    }
    MESSAGE(compared, " morphisms, ", pisot, " with a Pisot number");
    CHECK(compared >= 200);
    CHECK(pisot >= 50);
    CHECK(compared - pisot >= 20);
}

namespace {

/// The beginning of the infinite word.
std::string beginning(const Morphism& h, std::size_t length) {
    Word word{0};
    while (word.size() < length) word = h(word);
    return text_of(word).substr(0, length);
}

/// Morphisms that prolong a, and whose letters all lead to each other.
LetterImages primitive_images(std::mt19937& generator, std::size_t letters, std::size_t uniform) {
    for (;;) {
        LetterImages images;
        for (std::size_t a = 0; a < letters; ++a) {
            std::string image(uniform > 0 ? uniform : 1 + generator() % 4, 'a');
            for (char& letter : image) letter = static_cast<char>('a' + generator() % letters);
            images.push_back(image);
        }
        images[0][0] = 'a';
        if (images[0].size() < 2) images[0] += static_cast<char>('a' + generator() % letters);
        bool is_primitive = true;
        for (std::size_t a = 0; a < letters; ++a) {
            std::set<char> reached{static_cast<char>('a' + a)};
            for (std::size_t i = 0; i < letters * letters; ++i) {
                std::set<char> next;
                for (const char letter : reached)
                    for (const char one : images[static_cast<std::size_t>(letter - 'a')])
                        next.insert(one);
                reached = next;
            }
            is_primitive = is_primitive && reached.size() == letters;
        }
        if (is_primitive) return images;
    }
}

}  // namespace

TEST_CASE("derived words are those of the returns") {
    std::mt19937 generator(3);
    std::size_t words = 0, levels = 0;
    for (; words < 150; ++words) {
        const LetterImages images = primitive_images(generator, 2 + generator() % 2, 0);
        DerivedWords found;
        try {
            found = derived_words(morphism(images), 0);
        } catch (const BoundReached&) {
            continue;
        }
        REQUIRE(found.before < found.words.size());
        for (std::size_t i = 0; i < found.words.size(); ++i) {
            const std::size_t next = i + 1 < found.words.size() ? i + 1 : found.before;
            const std::string word = beginning(found.words[i].h, 400),
                              derived = beginning(found.words[next].h, 400);
            // Cut before each first letter: the n-th new piece is the n-th return.
            std::vector<std::string> pieces;
            std::string sequence;
            for (std::size_t begin = 0;;) {
                const std::size_t end = word.find(word.front(), begin + 1);
                if (end == std::string::npos) break;
                const std::string piece = word.substr(begin, end - begin);
                const auto at = std::find(pieces.begin(), pieces.end(), piece);
                sequence += static_cast<char>('a' + (at - pieces.begin()));
                if (at == pieces.end()) pieces.push_back(piece);
                begin = end;
            }
            REQUIRE(sequence == derived.substr(0, sequence.size()));
            for (std::size_t k = 0; k < pieces.size(); ++k)
                REQUIRE(text_of(found.words[i].returns[k]) == pieces[k]);
            ++levels;
        }
    }
    MESSAGE(levels, " derived words of ", words, " words");
    CHECK(levels >= 300);
    const DerivedWords fibonacci = derived_words(morphism({"ab", "a"}), 0);
    CHECK(fibonacci.before == 0);
    CHECK(fibonacci.words.size() == 1);
}

namespace {

/// Whether letters of even and of odd numbers take turns in the images, which begin like their letters.
bool take_turns(const LetterImages& images) {
    for (std::size_t a = 0; a < images.size(); ++a)
        for (std::size_t i = 0; i < images[a].size(); ++i)
            if ((static_cast<std::size_t>(images[a][i] - 'a') + a + i) % 2 != 0) return false;
    return true;
}

}  // namespace

TEST_CASE("columns of morphisms of constant length") {
    std::mt19937 generator(5);
    std::size_t compared = 0, high = 0, coincident = 0, toeplitz = 0;
    for (int i = 0; i < 400; ++i) {
        // A fifth of them with two kinds of letters that take turns, so that the height is even.
        const bool is_even = generator() % 5 == 0;
        const std::size_t q = is_even ? 3 : 2 + generator() % 3,
                          letters = 2 + generator() % (is_even ? 3 : 2);
        LetterImages images;
        do images = primitive_images(generator, letters, q);
        while (is_even && !take_turns(images));
        const auto found = constant_length(morphism(images), 0);
        if (!found) continue;
        ++compared;
        INFO(images[0], " ", images[1]);
        CHECK(found->length == q);
        const std::string word = beginning(morphism(images), 60000);
        // The height: of all places of the first letter.
        std::size_t distances = 0;
        for (std::size_t n = 1; n < word.size(); ++n)
            if (word[n] == word[0]) distances = std::gcd(distances, n);
        std::size_t height = 1;
        for (std::size_t n = 1; n <= distances; ++n)
            if (distances % n == 0 && std::gcd(n, q) == 1) height = n;
        REQUIRE(found->height == height);
        high += height > 1;
        // Blocks of that many letters at the places that q^k divides, for each rest.
        std::size_t least = ~std::size_t{0}, power = 1;
        for (; power * q * height * 40 < word.size(); power *= q)
            for (std::size_t rest = 0; rest < power; ++rest) {
                std::set<std::string> blocks;
                for (std::size_t n = rest; (n + 1) * height <= word.size(); n += power)
                    blocks.insert(word.substr(n * height, height));
                least = std::min(least, blocks.size());
            }
        CHECK(found->column_number == least);
        coincident += found->column_number == 1;
        // In a Toeplitz word the first letters stand in whole progressions.
        const auto repeats = [&](std::size_t n) {
            for (std::size_t period = height; period * 40 < word.size(); period *= q) {
                bool is_same = true;
                for (std::size_t at = n; at < word.size(); at += period)
                    is_same = is_same && word[at] == word[n];
                if (is_same) return true;
            }
            return false;
        };
        for (std::size_t n = 0; n < 3; ++n)
            if (found->toeplitz) CHECK(repeats(n));
        if (!found->toeplitz) CHECK_FALSE(repeats(0));
        toeplitz += found->toeplitz;
    }
    MESSAGE(compared, " words: ", high, " of height above 1, ", coincident, " with a coincidence, ",
            toeplitz, " of Toeplitz");
    CHECK(compared >= 200);
    CHECK(coincident >= 50);
    CHECK(compared - coincident >= 20);
    CHECK(toeplitz >= 30);
    CHECK(high >= 20);
    // Dekking's word of height 2 (1978): no column of letters is constant, one of pairs of letters is.
    const auto dekking = constant_length(morphism({"aba", "bac", "cab"}), 0);
    REQUIRE(dekking);
    CHECK(dekking->height == 2);
    CHECK(dekking->column_number == 1);
    CHECK(constant_length(morphism({"ab", "ba"}), 0)->column_number == 2);
    CHECK(constant_length(morphism({"ab", "aa"}), 0)->toeplitz);
    CHECK_FALSE(constant_length(morphism({"ab", "a"}), 0));
    CHECK_FALSE(constant_length(morphism({"aba", "bab"}), 0));  // periodic
}

TEST_CASE("families of infinite words") {
    const auto of = [](const LetterImages& images) {
        return complexity_for_all(morphism(images), 0);
    };
    const auto fibonacci = of({"ab", "a"});
    CHECK(fibonacci.arnoux_rauzy);
    CHECK(fibonacci.episturmian);
    CHECK(fibonacci.dendric);
    CHECK(of({"ab", "ac", "a"}).arnoux_rauzy);
    const auto thue_morse = of({"ab", "ba"});
    CHECK_FALSE(thue_morse.dendric);
    CHECK_FALSE(thue_morse.episturmian);
    // A word of one letter has no special factors.
    CHECK_FALSE(of({"aa"}).arnoux_rauzy);
    // The Fibonacci word of b and c with an a before each letter: episturmian, but after the empty word two right extensions are left of three.
    const auto with_fewer = of({"aba", "cab", "c"});
    CHECK(with_fewer.episturmian);
    CHECK_FALSE(with_fewer.arnoux_rauzy);
    CHECK_FALSE(with_fewer.dendric);
    // Cassaigne, Labbe and Leroy 2017: 2 n + 1 factors, all extension graphs trees, and several left special factors.
    const auto selmer = of({"ac", "ab", "b"});
    CHECK(selmer.dendric);
    CHECK_FALSE(selmer.episturmian);
    CHECK(selmer.value(Integer(100)) == Integer(201));
}
