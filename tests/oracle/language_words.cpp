#include "oracle/language_words.hpp"

#include <algorithm>
#include <map>

#include "oracle/table_words.hpp"

namespace algae::oracle {

namespace {

using Words = std::set<Word>;
using Found = std::optional<Words>;
using Morphism = std::map<Symbol, Word>;
using Kind = LanguageTree::Kind;

constexpr std::size_t most_letters = 6;   // of words of a system, for images back
constexpr std::size_t most_tables = 600;  // sequences of tables that differ

Morphism map_of(const algae::Morphism& morphism) {
    Morphism found;
    for (const Symbol a : morphism.domain()) found[a] = morphism[a];
    return found;
}

std::optional<Word> mapped(const Word& word, const Morphism& morphism) {
    Word result;
    for (const Symbol a : word) {
        if (!morphism.contains(a)) return std::nullopt;
        result.insert(result.end(), morphism.at(a).begin(), morphism.at(a).end());
    }
    return result;
}

Word backwards(const Word& word) { return {word.rbegin(), word.rend()}; }

Words products(const Words& left, const Words& right, std::size_t longest) {
    Words found;
    for (const Word& u : left)
        for (const Word& v : right)
            if (u.size() + v.size() <= longest) {
                Word word = u;
                word.insert(word.end(), v.begin(), v.end());
                found.insert(std::move(word));
            }
    return found;
}

/// One word or more of the set, one after the other.
Words repeated(const Words& words, std::size_t longest) {
    Words all = words;
    for (std::size_t before = all.size() + 1; before != all.size();) {
        before = all.size();
        all.merge(products(all, words, longest));
    }
    return all;
}

Words over(const std::vector<Symbol>& letters, std::size_t longest) {
    Words all{{}}, last = all;
    for (std::size_t n = 0; n < longest; ++n) {
        Words longer;
        for (Word word : last)
            for (const Symbol a : letters) {
                word.push_back(a);
                longer.insert(word);
                word.pop_back();
            }
        all.insert(longer.begin(), longer.end());
        last = std::move(longer);
    }
    return all;
}

/// Of a language the images under `morphism` of at most `longest` letters; letters without an image have none.
class Images {
public:
    explicit Images(std::size_t longest) : longest_(longest) {}

    Found of(const LanguageTree& tree, const Morphism& morphism) const {
        const auto part = [&](std::size_t i) { return of(*tree.parts[i], morphism); };
        switch (tree.kind) {
            case Kind::words:
                return of_words({tree.words.begin(), tree.words.end()}, morphism);
            case Kind::generated:
                return generated(*tree.system, morphism);
            case Kind::united: {
                Found left = part(0), right = part(1);
                if (!left || !right) return std::nullopt;
                left->merge(*right);
                return left;
            }
            case Kind::concatenated: {
                const Found left = part(0), right = part(1);
                if (!left || !right) return std::nullopt;
                return products(*left, *right, longest_);
            }
            case Kind::star:
            case Kind::plus: {
                Found base = part(0);
                if (!base) return std::nullopt;
                Words all = repeated(*base, longest_);
                if (tree.kind == Kind::star) all.insert(Word{});
                return all;
            }
            case Kind::reversed: {
                Morphism turned;
                for (const auto& [a, image] : morphism) turned[a] = backwards(image);
                const Found base = of(*tree.parts[0], turned);
                if (!base) return std::nullopt;
                Words all;
                for (const Word& word : *base) all.insert(backwards(word));
                return all;
            }
            case Kind::image: {
                Morphism both;
                for (const auto& [a, image] : map_of(tree.morphism))
                    if (auto further = mapped(image, morphism)) both[a] = *further;
                return of(*tree.parts[0], both);
            }
            default:
                return of_sets(tree, morphism);
        }
    }

private:
    Found of_words(const Words& words, const Morphism& morphism) const {
        Words found;
        for (const Word& word : words)
            if (const auto image = mapped(word, morphism); image && image->size() <= longest_)
                found.insert(*image);
        return found;
    }

    Found generated(const SourceSystem& system, const Morphism& morphism) const {
        if (!system.tables) return std::nullopt;
        Meaning meaning;
        for (Symbol a = 0; a < system.tables->terminal.size(); ++a)
            if (system.tables->terminal[a] && morphism.contains(a)) meaning[a] = {morphism.at(a)};
        return meant_words(*system.tables, meaning, longest_, most_tables);
    }

    static bool erases(const Morphism& morphism) {
        return std::any_of(morphism.begin(), morphism.end(),
                           [](const auto& entry) { return entry.second.empty(); });
    }

    /// Every number stands in an exponent, which is at least as large.
    Words of_powers(const Powers& powers) const {
        Words found;
        const std::uint64_t most = longest_;
        const auto with = [&](std::uint64_t n, std::uint64_t m) {
            Word word;
            for (const Powers::Block& block : powers.blocks) {
                Integer exponent = 0;
                for (const Powers::Term& term : block.exponent) {
                    Integer value = term.coefficient;
                    const std::uint64_t number = term.number.value_or(0) == 0 ? n : m;
                    for (std::uint64_t i = 0; term.number && i < term.power; ++i)
                        value = value * Integer(number);
                    for (std::uint64_t i = 0; term.number && i < number; ++i)
                        value = value * term.base;
                    exponent = exponent + value;
                }
                for (Integer i = 0; i < exponent; i = i + Integer(1)) {
                    word.insert(word.end(), block.word.begin(), block.word.end());
                    if (word.size() > most) return;
                }
            }
            found.insert(std::move(word));
        };
        for (std::uint64_t n = powers.numbers.at(0).least; n <= most; ++n) {
            if (powers.numbers.size() < 2) with(n, 0);
            for (std::uint64_t m = powers.numbers.back().least;
                 powers.numbers.size() == 2 && m <= most; ++m)
                with(n, m);
        }
        return found;
    }

    /// What is no sum of images of the parts: from sets of words as they are.
    Found of_sets(const LanguageTree& tree, const Morphism& morphism) const {
        if (erases(morphism)) return std::nullopt;
        if (tree.kind == Kind::powers) return of_words(of_powers(*tree.powers), morphism);
        const auto plain = [&](std::size_t i) { return language_words(tree.parts[i], longest_); };
        Words found;
        if (tree.kind == Kind::inverse_image) {
            std::vector<Symbol> domain;
            std::size_t most = 0;
            for (const auto& [a, image] : map_of(tree.morphism)) {
                domain.push_back(a);
                most = std::max(most, image.size());
            }
            if (most * longest_ > most_letters) return std::nullopt;
            const Found base = language_words(tree.parts[0], most * longest_);
            if (!base) return std::nullopt;
            for (const Word& word : over(domain, longest_))
                if (base->contains(*mapped(word, map_of(tree.morphism)))) found.insert(word);
            return of_words(found, morphism);
        }
        const Found left = plain(0);
        if (!left) return std::nullopt;
        if (tree.kind == Kind::complement) {
            for (const Word& word : over(tree.letters, longest_))
                if (!left->contains(word)) found.insert(word);
            return of_words(found, morphism);
        }
        const Found right = plain(1);
        if (!right) return std::nullopt;
        for (const Word& word : *left)
            if (right->contains(word) == (tree.kind == Kind::intersected)) found.insert(word);
        return of_words(found, morphism);
    }

    std::size_t longest_;
};

/// The terminals that occur in derived words.
void add_derived(const ET0L& system, std::set<Symbol>& letters) {
    std::set<Symbol> seen(system.axiom.begin(), system.axiom.end());
    for (std::size_t before = seen.size() + 1; before != seen.size();) {
        before = seen.size();
        for (const Symbol a : std::set<Symbol>(seen))
            for (const Table& table : system.tables)
                for (const Word& successor : table[a])
                    seen.insert(successor.begin(), successor.end());
    }
    for (const Symbol a : seen)
        if (system.terminal[a]) letters.insert(a);
}

void add_letters(const LanguageTree& tree, std::set<Symbol>& letters) {
    for (const Word& word : tree.words) letters.insert(word.begin(), word.end());
    letters.insert(tree.letters.begin(), tree.letters.end());
    for (const auto& [a, image] : map_of(tree.morphism)) {
        letters.insert(a);
        letters.insert(image.begin(), image.end());
    }
    if (tree.kind == Kind::powers)
        for (const Powers::Block& block : tree.powers->blocks)
            letters.insert(block.word.begin(), block.word.end());
    if (tree.kind == Kind::generated && tree.system->tables)
        add_derived(*tree.system->tables, letters);
    for (const Language& part : tree.parts) add_letters(*part, letters);
}

}  // namespace

std::optional<std::set<Word>> language_words(const Language& language, std::size_t longest) {
    std::set<Symbol> letters;
    add_letters(*language, letters);
    Morphism itself;
    for (const Symbol a : letters) itself[a] = {a};
    return Images(longest).of(*language, itself);
}

}  // namespace algae::oracle
