// Suffix arrays by libdivsufsort (Mori), common prefixes by Kasai, Lee, Arimura, Arikawa and Park (2001).

#include "combinatorics/detail/suffix_array.hpp"
#include "watch/watch.hpp"

#include <divsufsort.h>

#include <algorithm>
#include <limits>

namespace algae {

namespace {

/// The letters as bytes, each the same number of them, the greater ones first: their order is that of the letters.
struct Bytes {
    std::vector<unsigned char> text;
    std::size_t of_letter = 1;
};

Bytes bytes_of(const Word& word) {
    std::vector<Symbol> letters(word);
    std::ranges::sort(letters);
    letters.erase(std::unique(letters.begin(), letters.end()), letters.end());
    Bytes made;
    for (std::size_t some = letters.size(); some > 256; some = (some + 255) / 256) ++made.of_letter;
    made.text.reserve(word.size() * made.of_letter);
    for (const Symbol letter : word) {
        const auto rank =
            static_cast<std::size_t>(std::ranges::lower_bound(letters, letter) - letters.begin());
        for (std::size_t k = made.of_letter; k-- > 0;)
            made.text.push_back(static_cast<unsigned char>(rank >> (8 * k)));
    }
    return made;
}

}  // namespace

SuffixArray::SuffixArray(const Word& word, const Budget& budget) {
    const std::size_t n = word.size();
    if (n == 0) return;
    budget.check_memory(std::uint64_t{17} * n, "the suffixes of the word");
    {
        const Bytes bytes = bytes_of(word);
        if (bytes.text.size() >
            static_cast<std::size_t>(std::numeric_limits<std::int32_t>::max() - 1))
            throw Error("factors are counted in words of at most 2147483646 letters, found " +
                        std::to_string(n));
        order_.resize(bytes.text.size());
        if (divsufsort(bytes.text.data(), order_.data(),
                       static_cast<std::int32_t>(bytes.text.size())) != 0)
            throw std::bad_alloc();
        if (bytes.of_letter > 1) {
            const auto size = static_cast<std::int32_t>(bytes.of_letter);
            std::erase_if(order_, [size](std::int32_t begin) { return begin % size != 0; });
            for (std::int32_t& begin : order_) begin /= size;
        }
    }
    budget.check();
    ranks_.resize(n);
    for (std::size_t rank = 0; rank < n; ++rank)
        ranks_[static_cast<std::size_t>(order_[rank])] = static_cast<std::int32_t>(rank);
    common_.assign(n, 0);
    WorkCount suffixes("suffix", n);
    for (std::size_t i = 0, alike = 0; i < n; ++i) {
        if (i % 65536 == 0) budget.check();
        suffixes.at(i);
        const auto at = static_cast<std::size_t>(ranks_[i]);
        if (at == 0) {
            alike = 0;
            continue;
        }
        const auto other = static_cast<std::size_t>(order_[at - 1]);
        while (i + alike < n && other + alike < n && word[i + alike] == word[other + alike])
            ++alike;
        common_[at] = static_cast<std::int32_t>(alike);
        if (alike > 0) --alike;
    }
}

CommonPrefixes::CommonPrefixes(const SuffixArray& suffixes) : suffixes_(suffixes) {
    const std::size_t blocks = (suffixes.size() + block - 1) / block;
    least_.emplace_back(blocks, std::numeric_limits<std::int32_t>::max());
    for (std::size_t rank = 0; rank < suffixes.size(); ++rank) {
        std::int32_t& least = least_[0][rank / block];
        least = std::min(least, static_cast<std::int32_t>(suffixes.common(rank)));
    }
    for (std::size_t width = 1; 2 * width <= blocks; width *= 2) {
        const std::vector<std::int32_t>& below = least_.back();
        std::vector<std::int32_t> level(blocks - 2 * width + 1);
        for (std::size_t b = 0; b < level.size(); ++b)
            level[b] = std::min(below[b], below[b + width]);
        least_.push_back(std::move(level));
    }
}

std::size_t CommonPrefixes::least_in(std::size_t first, std::size_t last) const {
    std::size_t least = std::numeric_limits<std::size_t>::max();
    const auto look = [&](std::size_t from, std::size_t to) {
        for (std::size_t rank = from; rank <= to; ++rank)
            least = std::min(least, suffixes_.common(rank));
    };
    const std::size_t first_block = first / block + 1, last_block = last / block;
    if (first_block > last_block) {
        look(first, last);
        return least;
    }
    look(first, first_block * block - 1);
    look(last_block * block, last);
    if (first_block == last_block) return least;
    std::size_t level = 0;
    while (std::size_t{2} << level <= last_block - first_block) ++level;
    const std::vector<std::int32_t>& table = least_[level];
    const std::int32_t inner =
        std::min(table[first_block], table[last_block - (std::size_t{1} << level)]);
    return std::min(least, static_cast<std::size_t>(inner));
}

std::size_t CommonPrefixes::operator()(std::size_t left, std::size_t right) const {
    const std::size_t n = suffixes_.size();
    if (left >= n || right >= n) return 0;
    if (left == right) return n - left;
    const std::size_t first = suffixes_.rank(left), last = suffixes_.rank(right);
    return least_in(std::min(first, last) + 1, std::max(first, last));
}

std::vector<std::uint64_t> factor_counts(const Word& word, const Budget& budget) {
    const std::size_t n = word.size();
    const SuffixArray suffixes(word, budget);
    // A suffix has one factor of each length that the suffix before it has not, from their common prefix on.
    std::vector<std::uint64_t> counts(n + 2, 0);
    counts[0] = 1;
    for (std::size_t rank = 0; rank < n; ++rank) {
        ++counts[suffixes.common(rank) + 1];
        --counts[n - suffixes[rank] + 1];  // wraps around, and back below
    }
    for (std::size_t length = 2; length <= n; ++length) counts[length] += counts[length - 1];
    counts.resize(n + 1);
    return counts;
}

std::vector<std::size_t> lempel_ziv_factorisation(const Word& word, const Budget& budget) {
    const std::size_t n = word.size();
    const SuffixArray suffixes(word, budget);
    budget.check_memory(n * (sizeof(std::uint32_t) + sizeof(std::pair<std::size_t, std::size_t>)),
                        "the factorisation of a word");
    // By place: the longest factor from there on that begins earlier, too. Of the suffixes that begin earlier the nearest ones in order, on either side,
    // have the most in common with this one (Crochemore and Ilie 2008).
    std::vector<std::uint32_t> longest(n, 0);
    std::vector<std::pair<std::size_t, std::size_t>>
        open;  // place, and what it has in common with that below
    for (std::size_t rank = 0; rank <= n; ++rank) {
        if (rank % 65536 == 0) budget.check();
        std::size_t common = rank < n ? suffixes.common(rank) : 0;
        while (!open.empty() && (rank == n || suffixes[rank] < open.back().first)) {
            const auto [place, before] = open.back();
            longest[place] = static_cast<std::uint32_t>(std::max(before, common));
            common = std::min(before, common);
            open.pop_back();
        }
        if (rank < n) open.emplace_back(suffixes[rank], common);
    }
    std::vector<std::size_t> found;
    for (std::size_t begin = 0; begin < n; begin += std::max<std::size_t>(1, longest[begin]))
        found.push_back(begin);
    return found;
}

}  // namespace algae
