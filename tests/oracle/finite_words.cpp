#include "oracle/finite_words.hpp"

#include <algorithm>
#include <map>
#include <numeric>

namespace algae::oracle {

namespace {

std::string reversed(std::string word) {
    std::reverse(word.begin(), word.end());
    return word;
}

bool has_period(const std::string& word, std::size_t period) {
    for (std::size_t i = 0; i + period < word.size(); ++i)
        if (word[i] != word[i + period]) return false;
    return true;
}

bool is_lyndon(const std::string& word) {
    for (std::size_t i = 1; i < word.size(); ++i)
        if (word.substr(i) <= word) return false;
    return !word.empty();
}

std::map<char, int> letters_of(const std::string& word) {
    std::map<char, int> counts;
    for (const char letter : word) ++counts[letter];
    return counts;
}

bool lies_in(const std::map<char, int>& small, const std::map<char, int>& large) {
    return std::all_of(small.begin(), small.end(), [&](const auto& one) {
        const auto found = large.find(one.first);
        return found != large.end() && one.second <= found->second;
    });
}

}  // namespace

std::vector<std::size_t> borders_of(const std::string& word) {
    std::vector<std::size_t> found;
    for (std::size_t k = 1; k < word.size(); ++k)
        if (word.substr(0, k) == word.substr(word.size() - k)) found.push_back(k);
    return found;
}

std::vector<std::size_t> periods_of(const std::string& word) {
    std::vector<std::size_t> found;
    for (std::size_t p = 1; p <= word.size(); ++p)
        if (has_period(word, p)) found.push_back(p);
    return found;
}

std::string root_of(const std::string& word) {
    for (std::size_t k = 1; k < word.size(); ++k) {
        std::string power;
        while (power.size() < word.size()) power += word.substr(0, k);
        if (power == word) return word.substr(0, k);
    }
    return word;
}

std::set<std::string> conjugates_of(const std::string& word) {
    std::set<std::string> found;
    for (std::size_t i = 0; i < word.size(); ++i) found.insert(word.substr(i) + word.substr(0, i));
    return found;
}

std::vector<std::string> lyndon_words_of(const std::string& word) {
    for (std::size_t cuts = 0; cuts < std::size_t{1} << (word.empty() ? 0 : word.size() - 1);
         ++cuts) {
        std::vector<std::string> parts{""};
        for (std::size_t i = 0; i < word.size(); ++i) {
            parts.back() += word[i];
            if (i + 1 < word.size() && (cuts >> i & 1) != 0) parts.emplace_back();
        }
        if (std::all_of(parts.begin(), parts.end(), is_lyndon) &&
            std::is_sorted(parts.rbegin(), parts.rend()))
            return parts;
    }
    return {};
}

std::set<std::string> palindromes_of(const std::string& word) {
    std::set<std::string> found;
    for (std::size_t i = 0; i < word.size(); ++i)
        for (std::size_t k = 1; i + k <= word.size(); ++k)
            if (word.substr(i, k) == reversed(word.substr(i, k))) found.insert(word.substr(i, k));
    return found;
}

std::size_t palindromic_length_of(const std::string& word) {
    std::vector<std::size_t> fewest(word.size() + 1, word.size());
    fewest[0] = 0;
    for (std::size_t end = 1; end <= word.size(); ++end)
        for (std::size_t begin = 0; begin < end; ++begin) {
            const std::string part = word.substr(begin, end - begin);
            if (part == reversed(part)) fewest[end] = std::min(fewest[end], fewest[begin] + 1);
        }
    return fewest[word.size()];
}

std::set<Maximal> runs_of(const std::string& word) {
    std::set<Maximal> found;
    for (std::size_t begin = 0; begin < word.size(); ++begin)
        for (std::size_t end = begin + 2; end <= word.size(); ++end) {
            const std::size_t period = periods_of(word.substr(begin, end - begin)).front();
            if (2 * period > end - begin) continue;
            if (begin > 0 && word[begin - 1] == word[begin - 1 + period]) continue;
            if (end < word.size() && word[end] == word[end - period]) continue;
            found.insert({begin, end, period});
        }
    return found;
}

std::set<std::string> squares_of(const std::string& word) {
    std::set<std::string> found;
    for (std::size_t i = 0; i < word.size(); ++i)
        for (std::size_t k = 1; i + 2 * k <= word.size(); ++k)
            if (word.substr(i, k) == word.substr(i + k, k)) found.insert(word.substr(i, 2 * k));
    return found;
}

std::vector<std::size_t> factor_counts_of(const std::string& word) {
    std::vector<std::size_t> counts;
    for (std::size_t k = 0; k <= word.size(); ++k) {
        std::set<std::string> found;
        for (std::size_t i = 0; i + k <= word.size(); ++i) found.insert(word.substr(i, k));
        counts.push_back(found.size());
    }
    return counts;
}

std::vector<std::pair<std::size_t, std::size_t>> abelian_periods_of(const std::string& word) {
    std::vector<std::pair<std::size_t, std::size_t>> found;
    for (std::size_t period = 1; period <= word.size(); ++period)
        for (std::size_t head = 0; head < period; ++head) {
            if (head + period > word.size()) break;
            const auto block = letters_of(word.substr(head, period));
            bool fits = lies_in(letters_of(word.substr(0, head)), block);
            std::size_t i = head;
            for (; i + period <= word.size(); i += period)
                fits = fits && letters_of(word.substr(i, period)) == block;
            if (fits && lies_in(letters_of(word.substr(i)), block)) {
                found.emplace_back(head, period);
                break;
            }
        }
    return found;
}

std::vector<std::size_t> lempel_ziv_of(const std::string& word) {
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < word.size();) {
        std::size_t longest = 0;
        for (std::size_t j = 0; j < i; ++j) {
            std::size_t same = 0;
            while (i + same < word.size() && word[j + same] == word[i + same]) ++same;
            longest = std::max(longest, same);
        }
        found.push_back(i);
        i += longest == 0 ? 1 : longest;
    }
    return found;
}

bool is_balanced(const std::string& word) {
    for (const char letter : std::set<char>(word.begin(), word.end()))
        for (std::size_t length = 1; length < word.size(); ++length) {
            std::set<std::ptrdiff_t> counts;
            for (std::size_t i = 0; i + length <= word.size(); ++i) {
                const std::string part = word.substr(i, length);
                counts.insert(std::count(part.begin(), part.end(), letter));
            }
            if (*counts.rbegin() - *counts.begin() > 1) return false;
        }
    return true;
}

bool is_central(const std::string& word) {
    for (const char before : {'a', 'b'})
        for (const char behind : {'a', 'b'})
            if (!is_balanced(before + word + behind)) return false;
    return true;
}

std::set<std::string> standard_words(std::size_t longest) {
    std::vector<std::pair<std::string, std::string>> pairs{{"a", "b"}};
    std::set<std::string> found{"a", "b"};
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        const auto [x, y] = pairs[i];
        for (const auto& next : {std::pair(x, x + y), std::pair(y + x, y)}) {
            if (next.first.size() > longest || next.second.size() > longest) continue;
            found.insert(next.first);
            found.insert(next.second);
            pairs.push_back(next);
        }
    }
    return found;
}

std::set<std::string> christoffel_words(std::size_t longest) {
    std::set<std::string> found{"a", "b"};
    for (std::size_t n = 2; n <= longest; ++n)
        for (std::size_t up = 1; up < n; ++up) {
            if (std::gcd(up, n) != 1) continue;
            std::string word;
            std::size_t x = 0, y = 0;
            while (word.size() < n) {
                // Up if the point above is not over the line from (0, 0) to (n - up, up).
                const bool is_below = (y + 1) * (n - up) <= x * up;
                word += is_below ? 'b' : 'a';
                ++(is_below ? y : x);
            }
            found.insert(word);
        }
    return found;
}

}  // namespace algae::oracle
