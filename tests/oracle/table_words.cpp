#include "oracle/table_words.hpp"

#include <bitset>
#include <stdexcept>
#include <string>
#include <unordered_map>

namespace algae::oracle {

namespace {

std::set<Word> products(const std::set<Word>& left, const std::set<Word>& right,
                        std::size_t longest) {
    std::set<Word> found;
    for (const Word& u : left)
        for (const Word& v : right)
            if (u.size() + v.size() <= longest) {
                Word word = u;
                word.insert(word.end(), v.begin(), v.end());
                found.insert(std::move(word));
            }
    return found;
}

/// Finite sets of short words over some letters, as bits, and their products.
class ShortWords {
public:
    using Set = std::bitset<512>;

    ShortWords(const std::set<Symbol>& letters, std::size_t longest) : words_{{}} {
        for (std::size_t i = 0; i < words_.size(); ++i)
            if (words_[i].size() < longest)
                for (const Symbol a : letters) {
                    words_.push_back(words_[i]);
                    words_.back().push_back(a);
                }
        if (words_.size() > Set().size())
            throw std::logic_error("too many short words: " + std::to_string(words_.size()));
        for (std::size_t i = 0; i < words_.size(); ++i) places_.emplace(words_[i], i);
        product_.assign(words_.size(), std::vector<std::size_t>(words_.size(), words_.size()));
        for (std::size_t i = 0; i < words_.size(); ++i)
            for (std::size_t j = 0; j < words_.size(); ++j) {
                Word word = words_[i];
                word.insert(word.end(), words_[j].begin(), words_[j].end());
                if (const auto place = places_.find(word); place != places_.end())
                    product_[i][j] = place->second;
            }
    }

    Set set(const std::set<Word>& words) const {
        Set found;
        for (const Word& word : words)
            if (const auto place = places_.find(word); place != places_.end())
                found.set(place->second);
        return found;
    }
    std::set<Word> words(const Set& set) const {
        std::set<Word> found;
        for (std::size_t i = 0; i < words_.size(); ++i)
            if (set[i]) found.insert(words_[i]);
        return found;
    }
    Set product(const Set& left, const Set& right) const {
        std::vector<std::size_t> behind;
        for (std::size_t j = 0; j < words_.size(); ++j)
            if (right[j]) behind.push_back(j);
        Set found;
        for (std::size_t i = 0; i < words_.size(); ++i)
            if (left[i])
                for (const std::size_t j : behind)
                    if (product_[i][j] < words_.size()) found.set(product_[i][j]);
        return found;
    }

private:
    std::vector<Word> words_;
    std::map<Word, std::size_t> places_;
    std::vector<std::vector<std::size_t>> product_;
};

}  // namespace

std::optional<std::set<Word>> table_words(const ET0L& system, std::size_t longest,
                                          std::size_t on_the_way, std::size_t most) {
    std::set<Word> seen;
    if (system.axiom.size() <= on_the_way) seen.insert(system.axiom);
    std::vector<Word> open(seen.begin(), seen.end());
    while (!open.empty()) {
        const Word word = open.back();
        open.pop_back();
        for (const Table& table : system.tables) {
            std::set<Word> next{{}};
            for (const Symbol a : word)
                next = products(next, std::set<Word>(table[a].begin(), table[a].end()), on_the_way);
            for (const Word& other : next)
                if (seen.insert(other).second) open.push_back(other);
            if (seen.size() > most) return std::nullopt;
        }
    }
    std::erase_if(seen, [&](const Word& word) {
        for (const Symbol a : word)
            if (!system.terminal[a]) return true;
        return word.size() > longest;
    });
    return seen;
}

Meaning plain(const ET0L& system) {
    Meaning found;
    for (Symbol a = 0; a < system.terminal.size(); ++a)
        if (system.terminal[a]) found[a] = {{a}};
    return found;
}

std::optional<std::set<Word>> meant_words(const ET0L& system, const Meaning& meaning,
                                          std::size_t longest, std::size_t most) {
    std::set<Symbol> letters;
    for (const auto& [a, words] : meaning)
        for (const Word& word : words) letters.insert(word.begin(), word.end());
    const ShortWords sets(letters, longest);
    using Family = std::vector<ShortWords::Set>;
    struct Hash {
        std::size_t operator()(const Family& family) const {
            std::size_t value = 0;
            for (const auto& set : family)
                value = value * 1000003 + std::hash<ShortWords::Set>()(set);
            return value;
        }
    };
    const auto means = [&](const Family& family, const Word& word) {
        ShortWords::Set found = sets.set({{}});
        for (const Symbol a : word) found = sets.product(found, family[a]);
        return found;
    };
    Family last(system.alphabet->size());
    for (const auto& [a, words] : meaning) last[a] = sets.set(words);
    std::unordered_map<Family, bool, Hash> seen{{last, true}};
    std::vector<Family> open{last};
    ShortWords::Set found;
    while (!open.empty()) {
        const Family family = std::move(open.back());
        open.pop_back();
        found |= means(family, system.axiom);
        for (const Table& table : system.tables) {
            Family before(family.size());
            for (Symbol a = 0; a < table.size(); ++a)
                for (const Word& successor : table[a]) before[a] |= means(family, successor);
            if (seen.emplace(before, true).second) open.push_back(before);
            if (seen.size() > most) return std::nullopt;
        }
    }
    return sets.words(found);
}

}  // namespace algae::oracle
