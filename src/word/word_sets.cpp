#include "word/word_sets.hpp"

#include <algorithm>
#include <iterator>
#include <string>

#include "base/error.hpp"

namespace algae {

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
