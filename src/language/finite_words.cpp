#include "language/finite_words.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "word/word_sets.hpp"

namespace algae {

FiniteWords::FiniteWords(const FiniteLanguage& language, const Budget& budget)
    : letters(letters_of(language)) {
    std::uint64_t bytes = 0;
    for (const Word& word : language.words)
        bytes += (std::uint64_t{word.size()} + 1) * (word.size() + 2) *
                 (word.size() * sizeof(Symbol) + 100) / 2;
    budget.check_memory(bytes, "the factors of the words of the language");

    std::vector<std::uint32_t> number(language.alphabet->size(), none);
    for (std::uint32_t i = 0; i < letters.size(); ++i) number[letters[i]] = i;

    std::vector<std::map<Symbol, Node>> next(1);
    word_at.push_back(none);
    for (const Word& word : language.words) {
        auto& spelled = words.emplace_back();
        auto& path = node_path.emplace_back(1, 0);
        for (const Symbol a : word) {
            spelled.push_back(number[a]);
            const auto [place, is_new] =
                next[path.back()].try_emplace(a, static_cast<Node>(next.size()));
            const Node node = place->second;
            if (is_new) {
                next.emplace_back();
                word_at.push_back(none);
            }
            path.push_back(node);
        }
        word_at[path.back()] = static_cast<std::uint32_t>(words.size() - 1);
    }

    const auto shorter = [](const Word& left, const Word& right) {
        return shortlex_less(left, right);
    };
    std::map<Word, Image, decltype(shorter)> numbered(shorter);
    numbered[{}] = 0;
    for (const Word& word : language.words)
        for (auto from = word.begin(); from != word.end(); ++from)
            for (auto to = from + 1; to <= word.end(); ++to)
                numbered.try_emplace(Word(from, to), 0);
    for (auto& [image, place] : numbered) {
        place = static_cast<Image>(images.size());
        images.push_back(image);
    }

    below.resize(next.size());
    for (Node start = 0; start < next.size(); ++start) {
        budget.check();
        std::vector<std::pair<Word, Node>> open{{Word{}, start}};
        while (!open.empty()) {
            const auto [image, node] = std::move(open.back());
            open.pop_back();
            below[start].push_back({numbered.at(image), node});
            for (const auto& [symbol, child] : next[node]) {
                Word longer = image;
                longer.push_back(symbol);
                open.emplace_back(std::move(longer), child);
            }
        }
        std::sort(below[start].begin(), below[start].end(),
                  [](const Step& left, const Step& right) { return left.image < right.image; });
    }
}

}  // namespace algae
