#include "verify/contains.hpp"

#include <algorithm>
#include <set>

#include "base/error.hpp"
#include "verify/derivatives.hpp"
#include "verify/relations.hpp"

namespace algae::verify {

namespace {

constexpr std::size_t longest = 4000;  // letters of a word that is taken apart in all ways
constexpr std::uint64_t longest_sequence =
    50'000'000;  // letters of the words of a sequence together

void must_be_short(const Word& word) {
    if (word.size() > longest)
        throw BoundReached(Bound::method,
                           "a word of " + std::to_string(word.size()) +
                               " letters is not taken apart in all ways, only up to " +
                               std::to_string(longest));
}

using Images = std::map<Symbol, Word>;

/// For each letter, between which positions of the word its image stands.
Relations places(const std::vector<Symbol>& letters, const Images& images, const Word& word) {
    must_be_short(word);
    Relations start;
    for (const Symbol a : letters) {
        BooleanMatrix relation(word.size() + 1);
        if (const auto image = images.find(a); image != images.end())
            for (std::size_t i = 0; image->second.size() <= word.size() - i; ++i) {
                if (std::equal(image->second.begin(), image->second.end(),
                               word.begin() + static_cast<std::ptrdiff_t>(i)))
                    relation.set(i, i + image->second.size());
                if (i == word.size()) break;
            }
        start.emplace(a, std::move(relation));
    }
    return start;
}

/// Whether the sequence of a system with context has a word that `wanted` is true of. Where no rule
/// has the empty successor, words longer than `most` letters end the search.
template <class Wanted>
bool some_word(const System& system, const Word& from, std::size_t most, const Budget& budget,
               Wanted wanted) {
    const bool grows = never_shrinks(system);
    std::set<Word> known;
    std::uint64_t letters = 0;
    for (Word word = from; !grows || word.size() <= most; word = next_word(system, word)) {
        budget.check();
        if (wanted(word)) return true;
        letters += word.size() + 16;
        if (letters > longest_sequence)
            throw BoundReached(Bound::method, "the words of the sequence are too long");
        if (!known.insert(word).second) return false;
    }
    return false;
}

Word word_after(const System& system, Word word, const Integer& steps, const Budget& budget) {
    std::map<Word, std::size_t> known;
    std::vector<Word> all;
    std::uint64_t letters = 0;
    while (steps != all.size()) {
        budget.check();
        letters += word.size() + 16;
        if (letters > longest_sequence)
            throw BoundReached(Bound::method, "the words of the sequence are too long");
        const auto [place, is_new] = known.emplace(word, all.size());
        if (!is_new) {  // it comes round again
            const std::size_t first = place->second;
            return all[first +
                       static_cast<std::size_t>(
                           remainder(steps - first, Integer(all.size() - first)).to_uint64())];
        }
        all.push_back(word);
        word = next_word(system, word);
    }
    return word;
}

class Membership {
public:
    Membership(const Alphabet& alphabet, const Budget& budget)
        : alphabet_(alphabet), budget_(budget) {}

    bool in(const Language& language, const Word& word) {
        const auto key = std::make_pair(language.get(), word);
        if (const auto known = known_.find(key); known != known_.end()) return known->second;
        budget_.check();
        bytes_ += 150 + word.size() * sizeof(Symbol);
        budget_.check_memory(bytes_, "what is known of factors of the word");
        kept_.push_back(language);
        const bool found = find(*language, word);
        known_[key] = found;
        return found;
    }

private:
    bool find(const Tree& tree, const Word& word) {
        switch (tree.kind) {
            case Tree::Kind::words:
                return std::find(tree.words.begin(), tree.words.end(), word) != tree.words.end();
            case Tree::Kind::generated:
                return generated(*tree.system, word);
            case Tree::Kind::united:
                return in(tree.parts[0], word) || in(tree.parts[1], word);
            case Tree::Kind::intersection:
                return in(tree.parts[0], word) && in(tree.parts[1], word);
            case Tree::Kind::difference:
                return in(tree.parts[0], word) && !in(tree.parts[1], word);
            case Tree::Kind::concatenation:
                return concatenated(tree, word);
            case Tree::Kind::star:
                return word.empty() || repeated(tree.parts[0], word);
            case Tree::Kind::plus:
                return word.empty() ? in(tree.parts[0], word) : repeated(tree.parts[0], word);
            case Tree::Kind::reversal:
                return in(tree.parts[0], Word(word.rbegin(), word.rend()));
            case Tree::Kind::complement:
                return std::all_of(word.begin(), word.end(),
                                   [&](Symbol a) {
                                       return std::binary_search(tree.letters.begin(),
                                                                 tree.letters.end(), a);
                                   }) &&
                       !in(tree.parts[0], word);
            case Tree::Kind::inverse_image: {
                const auto image = image_of(word, tree.morphism, budget_);
                return image && in(tree.parts[0], *image);
            }
            case Tree::Kind::image:
                break;
        }
        return image(tree, word);
    }

    bool generated(const System& system, const Word& word) const {
        for (const Symbol a : word)
            if (!system.terminal[a]) return false;
        return derives(system, system.axiom, word, std::nullopt, budget_);
    }

    bool concatenated(const Tree& tree, const Word& word) {
        must_be_short(word);
        for (auto middle = word.begin();; ++middle) {
            if (in(tree.parts[0], Word(word.begin(), middle)) &&
                in(tree.parts[1], Word(middle, word.end())))
                return true;
            if (middle == word.end()) return false;
        }
    }

    /// Whether a word that is not empty is made of words of the language, none of them empty.
    bool repeated(const Language& part, const Word& word) {
        must_be_short(word);
        std::vector<char> reached(word.size() + 1);
        reached[0] = 1;
        for (std::size_t end = 1; end <= word.size(); ++end)
            for (std::size_t start = 0; start < end && !reached[end]; ++start)
                if (reached[start] &&
                    in(part, Word(word.begin() + static_cast<std::ptrdiff_t>(start),
                                  word.begin() + static_cast<std::ptrdiff_t>(end))))
                    reached[end] = 1;
        return reached[word.size()];
    }

    static Language image_under(Images morphism, const Language& part) {
        Tree tree;
        tree.kind = Tree::Kind::image;
        tree.morphism = std::move(morphism);
        tree.parts = {part};
        return std::make_shared<const Tree>(std::move(tree));
    }

    /// The image of an operation is the operation on images where that is so; otherwise all words with
    /// this image are tried.
    bool image(const Tree& tree, const Word& word) {
        const Tree& part = *tree.parts[0];
        switch (part.kind) {
            case Tree::Kind::words:
                return std::any_of(part.words.begin(), part.words.end(), [&](const Word& each) {
                    return image_of(each, tree.morphism, budget_) == word;
                });
            case Tree::Kind::generated:
                return image_of_generated(*part.system, tree.morphism, word);
            case Tree::Kind::united:
            case Tree::Kind::concatenation:
            case Tree::Kind::star:
            case Tree::Kind::plus: {
                auto images = images_of_.find(&tree);
                if (images == images_of_.end()) {
                    std::vector<Language> parts;
                    for (const Language& each : part.parts)
                        parts.push_back(image_under(tree.morphism, each));
                    images =
                        images_of_.emplace(&tree, combination(part.kind, std::move(parts))).first;
                }
                return in(images->second, word);
            }
            case Tree::Kind::image: {
                Images both;
                for (const auto& [a, image] : part.morphism)
                    if (const auto further = image_of(image, tree.morphism, budget_))
                        both[a] = *further;
                auto through = images_of_.find(&tree);
                if (through == images_of_.end())
                    through = images_of_.emplace(&tree, image_under(std::move(both), part.parts[0]))
                                  .first;
                return in(through->second, word);
            }
            default:
                break;
        }
        if (is_regular(tree.parts[0])) {
            Derivatives derivatives(alphabet_, budget_);
            const auto term = derivatives.term(std::make_shared<const Tree>(tree));
            return derivatives.nullable(derivatives.derivative(term, word));
        }
        for (const auto& [a, image] : tree.morphism)
            if (image.empty())
                throw BoundReached(
                    Bound::method,
                    "whether a word is the image of a word of this language cannot be checked: a "
                    "letter is erased");
        Word before;
        std::uint64_t tries = 0;
        return some_preimage(tree, word, 0, before, tries);
    }

    bool some_preimage(const Tree& tree, const Word& word, std::size_t done, Word& before,
                       std::uint64_t& tries) {
        must_be_short(word);
        if (++tries > 1'000'000)
            throw BoundReached(Bound::method, "too many words have this image");
        if (done == word.size()) return in(tree.parts[0], before);
        for (const auto& [a, image] : tree.morphism) {
            if (image.size() > word.size() - done ||
                !std::equal(image.begin(), image.end(),
                            word.begin() + static_cast<std::ptrdiff_t>(done)))
                continue;
            before.push_back(a);
            const bool found = some_preimage(tree, word, done + image.size(), before, tries);
            before.pop_back();
            if (found) return true;
        }
        return false;
    }

    bool image_of_generated(const System& system, const Images& morphism, const Word& word) const {
        if (system.context) return with_context(system, morphism, word);
        Images images;
        for (const auto& [a, image] : morphism)
            if (system.terminal[a]) images[a] = image;
        const auto start = places(accessible_letters(system, system.axiom), images, word);
        return some_relations(
            system, start, word.size() + 1,
            [&](const Relations& relations) {
                return relation_of(system.axiom, relations, word.size() + 1).at(0, word.size());
            },
            budget_);
    }

    bool with_context(const System& system, const Images& morphism, const Word& word) const {
        const bool erases = std::any_of(morphism.begin(), morphism.end(),
                                        [](const auto& each) { return each.second.empty(); });
        return some_word(
            system, system.axiom, erases ? SIZE_MAX : word.size(), budget_,
            [&](const Word& each) { return image_of(each, morphism, budget_) == word; });
    }

    const Alphabet& alphabet_;
    const Budget& budget_;
    std::map<std::pair<const Tree*, Word>, bool> known_;
    std::map<const Tree*, Language> images_of_;
    std::vector<Language>
        kept_;  // so that no expression made on the way has the address of another
    std::uint64_t bytes_ = 0;
};

}  // namespace

bool contains(const Language& language, const Word& word, const Alphabet& alphabet,
              const Budget& budget) {
    return Membership(alphabet, budget).in(language, word);
}

std::optional<Word> image_of(const Word& word, const std::map<Symbol, Word>& morphism,
                             const Budget& budget) {
    Word whole;
    for (const Symbol a : word) {
        const auto image = morphism.find(a);
        if (image == morphism.end()) return std::nullopt;
        budget.check_memory((whole.size() + image->second.size()) * 4 * sizeof(Symbol),
                            "the image of a word");
        whole.insert(whole.end(), image->second.begin(), image->second.end());
    }
    return whole;
}

bool derives(const System& system, const Word& from, const Word& to,
             const std::optional<Integer>& steps, const Budget& budget) {
    if (system.context)
        return steps ? word_after(system, from, *steps, budget) == to
                     : some_word(system, from, to.size(), budget,
                                 [&](const Word& word) { return word == to; });
    if (!steps && from == to) return true;
    Images itself;
    for (const Symbol a : to) itself[a] = {a};
    const auto start = places(accessible_letters(system, from), itself, to);
    const auto stop = [&](const Relations& relations) {
        return relation_of(from, relations, to.size() + 1).at(0, to.size());
    };
    if (steps) return some_relations_after(system, start, to.size() + 1, *steps, stop, budget);
    return some_relations(system, start, to.size() + 1, stop, budget);
}

}  // namespace algae::verify
