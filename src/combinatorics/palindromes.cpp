// The palindromic tree of a word: a node for each palindrome, with an edge for each letter written on both sides.

#include <algorithm>
#include <limits>

#include "combinatorics/combinatorics.hpp"
#include "watch/watch.hpp"

namespace algae {

namespace {

using Node = std::int32_t;

class PalindromicTree {
public:
    PalindromicTree(const Word& word, const Budget& budget) : word_(word) {
        constexpr std::size_t bytes = 64;  // for a letter
        if (word.size() > static_cast<std::size_t>(std::numeric_limits<Node>::max() - 2))
            throw Error("palindromes are looked for in words of at most 2147483645 letters");
        budget.check_memory(bytes * word.size(), "the palindromes of the word");
        nodes_.reserve(word.size() + 2);
        nodes_.push_back({-1, 0});  // a letter is this with the letter on both sides
        nodes_.push_back({0, 0});
        fewest_.assign(word.size() + 1, 0);
        last_.assign(word.size() + 1, 0);
        series_.assign(word.size() + 2, 0);
        WorkCount letters("letter for palindromes", word.size());
        for (std::size_t i = 0; i < word.size(); ++i) {
            if (i % 65536 == 0) budget.check();
            letters.at(i);
            append(i);
            shorten(i + 1);
        }
    }

    PalindromicFactors result() const {
        PalindromicFactors found;
        found.count = nodes_.size() - 2;
        found.defect = word_.size() - found.count;
        std::int32_t longest = 1;
        for (const Palindrome& node : nodes_) longest = std::max(longest, node.length);
        for (const Palindrome& node : nodes_)
            if (node.length == longest)
                found.longest.push_back({static_cast<std::size_t>(node.end - node.length),
                                         static_cast<std::size_t>(node.length)});
        for (std::size_t end = word_.size(); end > 0;) {
            const auto begin = static_cast<std::size_t>(last_[end]);
            found.fewest.push_back({begin, end - begin});
            end = begin;
        }
        std::ranges::reverse(found.fewest);
        return found;
    }

private:
    static constexpr Node imaginary = 0, empty = 1;

    struct Palindrome {
        std::int32_t length = 0;
        Node suffix = imaginary;      // the longest palindrome that ends it and is shorter
        std::int32_t end = 0;         // of its first occurrence, beyond the last letter
        std::int32_t difference = 0;  // of its length and that of `suffix`
        Node series = imaginary;      // the longest suffix whose difference is another
        Node child = imaginary,
             next = imaginary;  // edges: the first one from here, and that of its parent after it
        Symbol letter = 0;      // of the edge to it
    };

    /// The longest palindrome among `node` and its suffixes that has the letter at `i` before it.
    Node before(Node node, std::size_t i) const {
        for (;; node = nodes_[static_cast<std::size_t>(node)].suffix) {
            const std::int64_t at =
                static_cast<std::int64_t>(i) - 1 - nodes_[static_cast<std::size_t>(node)].length;
            if (at >= 0 && word_[static_cast<std::size_t>(at)] == word_[i]) return node;
        }
    }

    Node child(Node node, Symbol letter) const {
        Node found = nodes_[static_cast<std::size_t>(node)].child;
        while (found != imaginary && nodes_[static_cast<std::size_t>(found)].letter != letter)
            found = nodes_[static_cast<std::size_t>(found)].next;
        return found;
    }

    void append(std::size_t i) {
        const Node inner = before(longest_, i);
        Node found = child(inner, word_[i]);
        if (found == imaginary) {
            found = static_cast<Node>(nodes_.size());
            Palindrome made;
            made.length = nodes_[static_cast<std::size_t>(inner)].length + 2;
            made.end = static_cast<std::int32_t>(i + 1);
            made.letter = word_[i];
            made.suffix =
                made.length == 1
                    ? empty
                    : child(before(nodes_[static_cast<std::size_t>(inner)].suffix, i), word_[i]);
            const Palindrome& suffix = nodes_[static_cast<std::size_t>(made.suffix)];
            made.difference = made.length - suffix.length;
            made.series = made.difference == suffix.difference ? suffix.series : made.suffix;
            made.next = nodes_[static_cast<std::size_t>(inner)].child;
            nodes_.push_back(made);
            nodes_[static_cast<std::size_t>(inner)].child = found;
        }
        longest_ = found;
    }

    /// The fewest palindromes of the prefix that ends there: the last one is among the suffixes of the longest, which
    /// form few series with equal differences.
    void shorten(std::size_t end) {
        fewest_[end] = std::numeric_limits<std::int32_t>::max();
        for (Node node = longest_; nodes_[static_cast<std::size_t>(node)].length > 0;) {
            const Palindrome& one = nodes_[static_cast<std::size_t>(node)];
            const Palindrome& series = nodes_[static_cast<std::size_t>(one.series)];
            std::int32_t& best = series_[static_cast<std::size_t>(node)];
            best = static_cast<std::int32_t>(end) - (series.length + one.difference);
            if (one.difference == nodes_[static_cast<std::size_t>(one.suffix)].difference) {
                const std::int32_t other = series_[static_cast<std::size_t>(one.suffix)];
                if (fewest_[static_cast<std::size_t>(other)] <
                    fewest_[static_cast<std::size_t>(best)])
                    best = other;
            }
            const std::int32_t with = fewest_[static_cast<std::size_t>(best)] + 1;
            if (with < fewest_[end]) {
                fewest_[end] = with;
                last_[end] = best;
            }
            node = one.series;
        }
    }

    const Word& word_;
    std::vector<Palindrome> nodes_;
    Node longest_ = empty;              // palindrome that ends what is read
    std::vector<std::int32_t> fewest_;  // by length of a prefix
    std::vector<std::int32_t> last_;    // where the last of the fewest begins
    std::vector<std::int32_t>
        series_;  // by node: the best beginning of its series, at the last visit
};

}  // namespace

PalindromicFactors palindromic_factors(const Word& word, const Budget& budget) {
    if (word.empty()) return {};
    return PalindromicTree(word, budget).result();
}

}  // namespace algae
