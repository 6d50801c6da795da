#include "oracle/infinite_words.hpp"

#include <algorithm>
#include <cmath>

namespace algae::oracle {

namespace {

constexpr char begin_of_word = '^', end_of_word = '$';

bool is_end(char letter) { return letter == begin_of_word || letter == end_of_word; }

/// The letters whose images vanish in the end.
std::set<char> vanishing(const Rules& rules) {
    std::set<char> found;
    for (std::size_t before = 1; before != found.size();) {
        before = found.size();
        for (const auto& [letter, image] : rules)
            if (std::ranges::all_of(image, [&](char one) { return found.contains(one); }))
                found.insert(letter);
        if (found.empty()) break;
    }
    return found;
}

bool is_palindrome(const std::string& word) {
    return std::equal(word.begin(), word.end(), word.rbegin());
}

}  // namespace

std::string image_of(const Rules& rules, const std::string& word) {
    std::string image;
    for (const char letter : word)
        image += is_end(letter) ? std::string(1, letter) : rules.at(letter);
    return image;
}

std::set<char> reached(const Rules& rules, const std::string& axiom) {
    std::set<char> found(axiom.begin(), axiom.end());
    for (std::size_t before = 0; before != found.size();) {
        before = found.size();
        for (const char letter : std::set<char>(found))
            found.insert(rules.at(letter).begin(), rules.at(letter).end());
    }
    return found;
}

std::vector<std::set<std::string>> factors_of(const Rules& rules, const std::string& axiom,
                                              std::size_t longest) {
    const std::set<char> mortal = vanishing(rules);
    const std::size_t steady =
        longest + 2;  // letters that never vanish in a window, its ends among them
    std::set<std::string> windows;
    std::vector<std::string> open;
    const auto see = [&](const std::string& word) {
        std::vector<std::size_t> places;
        for (std::size_t i = 0; i < word.size(); ++i)
            if (!mortal.contains(word[i])) places.push_back(i);
        for (std::size_t i = 0; i < places.size(); ++i) {
            const std::size_t last = std::min(i + steady, places.size()) - 1;
            std::string window = word.substr(places[i], places[last] + 1 - places[i]);
            if (windows.insert(window).second) open.push_back(std::move(window));
            if (last + 1 == places.size()) break;
        }
    };
    see(begin_of_word + axiom + end_of_word);
    while (!open.empty()) {
        const std::string word = std::move(open.back());
        open.pop_back();
        see(image_of(rules, word));
    }
    std::vector<std::set<std::string>> found(longest + 1);
    for (const std::string& window : windows)
        for (std::size_t i = 0; i < window.size(); ++i)
            for (std::size_t n = 0; n <= longest && i + n <= window.size(); ++n) {
                if (n > 0 && is_end(window[i + n - 1])) break;
                found[n].insert(window.substr(i, n));
            }
    return found;
}

std::map<char, std::size_t> counts_of(const std::string& word) {
    std::map<char, std::size_t> found;
    for (const char letter : word) ++found[letter];
    return found;
}

std::size_t abelian_of(const std::set<std::string>& words) {
    std::set<std::map<char, std::size_t>> found;
    for (const std::string& word : words) found.insert(counts_of(word));
    return found.size();
}

std::map<char, std::size_t> apart_of(const std::set<std::string>& words) {
    std::set<char> letters;
    for (const std::string& word : words) letters.insert(word.begin(), word.end());
    std::map<char, std::size_t> found;
    for (const char letter : letters) {
        std::size_t least = ~std::size_t{0}, most = 0;
        for (const std::string& word : words) {
            const auto times = static_cast<std::size_t>(std::ranges::count(word, letter));
            least = std::min(least, times);
            most = std::max(most, times);
        }
        found[letter] = most - least;
    }
    return found;
}

std::size_t palindromes_in(const std::set<std::string>& words) {
    return static_cast<std::size_t>(std::ranges::count_if(words, is_palindrome));
}

bool are_reversed(const std::set<std::string>& words) {
    return std::ranges::all_of(words, [&](const std::string& word) {
        return words.contains(std::string(word.rbegin(), word.rend()));
    });
}

std::map<std::string, std::int64_t> bispecial_of(const std::vector<std::set<std::string>>& factors,
                                                 std::size_t longest) {
    std::map<std::string, std::int64_t> found;
    for (std::size_t n = 0; n <= longest; ++n) {
        std::map<std::string, std::int64_t> left, right, both;
        for (const std::string& word : factors[n + 1]) {
            ++left[word.substr(1)];
            ++right[word.substr(0, n)];
        }
        for (const std::string& word : factors[n + 2]) ++both[word.substr(1, n)];
        for (const std::string& word : factors[n])
            if (left[word] > 1 && right[word] > 1)
                found[word] = both[word] - left[word] - right[word] + 1;
    }
    return found;
}

std::optional<std::size_t> recurrence_of(const std::vector<std::set<std::string>>& factors,
                                         std::size_t n) {
    for (std::size_t length = n; length < factors.size(); ++length)
        if (std::ranges::all_of(factors[length], [&](const std::string& word) {
                std::set<std::string> parts;
                for (std::size_t i = 0; i + n <= length; ++i) parts.insert(word.substr(i, n));
                return parts.size() == factors[n].size();
            }))
            return length;
    return std::nullopt;
}

std::set<std::string> returns_of(const std::vector<std::set<std::string>>& factors, char letter) {
    std::set<std::string> found;
    for (const std::string& word : factors.back())
        for (std::size_t i = word.find(letter); i != std::string::npos;) {
            const std::size_t next = word.find(letter, i + 1);
            if (next != std::string::npos) found.insert(word.substr(i, next - i));
            i = next;
        }
    return found;
}

std::optional<std::size_t> primitive_power(const Rules& rules, const std::string& axiom) {
    const std::set<char> letters = reached(rules, axiom);
    std::map<char, std::set<char>> now;
    for (const char letter : letters) now[letter] = {letter};
    const std::size_t d = letters.size();
    for (std::size_t power = 1; power <= (d - 1) * (d - 1) + 1; ++power) {
        bool is_full = true;
        for (auto& [letter, there] : now) {
            std::set<char> next;
            for (const char one : there) next.insert(rules.at(one).begin(), rules.at(one).end());
            there = std::move(next);
            is_full = is_full && there.size() == d;
        }
        if (is_full) return power;
    }
    return std::nullopt;
}

std::optional<std::map<char, double>> shares_of(const Rules& rules, const std::string& axiom) {
    const std::set<char> reach = reached(rules, axiom);
    const std::vector<char> letters(reach.begin(), reach.end());
    const std::size_t d = letters.size();
    using Matrix = std::vector<std::vector<double>>;
    Matrix step(d, std::vector<double>(d));
    for (std::size_t i = 0; i < d; ++i)
        for (std::size_t j = 0; j < d; ++j)
            step[i][j] = static_cast<double>(std::ranges::count(rules.at(letters[i]), letters[j]));
    const auto times = [&](const Matrix& left, const Matrix& right) {
        Matrix product(left.size(), std::vector<double>(d));
        double sum = 0;
        for (std::size_t i = 0; i < left.size(); ++i)
            for (std::size_t k = 0; k < d; ++k)
                for (std::size_t j = 0; j < d; ++j) {
                    product[i][j] += left[i][k] * right[k][j];
                    sum += left[i][k] * right[k][j];
                }
        if (sum > 0)
            for (auto& row : product)
                for (double& one : row) one /= sum;
        return product;
    };
    Matrix power = step, row(1, std::vector<double>(d));
    // More squares would lose more to rounding, of words whose parts grow alike, than they win.
    for (int i = 0; i < 26; ++i) power = times(power, power);
    for (const char letter : axiom)
        row[0][static_cast<std::size_t>(std::ranges::find(letters, letter) - letters.begin())] += 1;
    row = times(row, power);
    const Matrix first = row;
    for (int i = 0; i < 60; ++i) {
        row = times(row, step);
        for (std::size_t j = 0; j < d; ++j)
            if (std::abs(row[0][j] - first[0][j]) > 1e-7) return std::nullopt;
    }
    std::map<char, double> found;
    double all = 0;
    for (std::size_t j = 0; j < d; ++j) all += found[letters[j]] = row[0][j];
    if (all < 0.5) return std::nullopt;  // the words vanish
    return found;
}

std::pair<std::size_t, std::size_t> greatest_exponent(
    const std::vector<std::set<std::string>>& factors) {
    std::pair<std::size_t, std::size_t> best{1, 1};
    for (const std::string& word : factors.back())
        for (std::size_t p = 1; p < word.size(); ++p) {
            std::size_t same = 0;
            for (std::size_t i = 0; i + p < word.size(); ++i) {
                same = word[i] == word[i + p] ? same + 1 : 0;
                if ((same + p) * best.second > best.first * p) best = {same + p, p};
            }
        }
    return best;
}

bool is_cut_in_one_way(const Rules& rules, const std::vector<std::set<std::string>>& factors,
                       std::size_t length) {
    std::map<std::string, bool> is_cut;  // by factor: whether there is one in the middle
    for (const std::string& word : factors[length]) {
        const std::string image = image_of(rules, word);
        std::set<std::size_t> cuts{0};
        for (std::size_t i = 1, at = 0; i <= word.size(); ++i)
            cuts.insert(at += rules.at(word[i - 1]).size());
        for (std::size_t i = 0; i + length <= image.size(); ++i) {
            const bool here = cuts.contains(i + length / 2);
            const auto [known, is_new] = is_cut.emplace(image.substr(i, length), here);
            if (known->second != here) return false;
        }
    }
    return true;
}

Families families_of(const std::vector<std::set<std::string>>& factors, std::size_t longest) {
    Families found;
    const auto is_factor = [&](const std::string& word) {
        return factors[word.size()].contains(word);
    };
    const std::set<std::string>& letters = factors[1];
    for (std::size_t n = 0; n <= longest; ++n) {
        std::size_t left_special = 0, full = 0;
        for (const std::string& word : factors[n]) {
            std::set<std::string> left, right;
            for (const std::string& letter : letters) {
                if (is_factor(letter + word)) left.insert(letter);
                if (is_factor(word + letter)) right.insert(letter);
            }
            left_special += left.size() > 1;
            full += left.size() == letters.size();
            found.episturmian =
                found.episturmian && is_factor(std::string(word.rbegin(), word.rend()));
            if (left.size() < 2 || right.size() < 2) continue;
            // A tree has one edge less than nodes, and no other letter once leaves are gone.
            std::vector<std::pair<std::string, std::string>> edges;
            for (const std::string& x : left)
                for (const std::string& y : right)
                    if (is_factor(x + word + y)) edges.emplace_back("<" + x, ">" + y);
            const bool has_count = edges.size() + 1 == left.size() + right.size();
            for (bool is_changed = true; is_changed;) {
                std::map<std::string, int> degree;
                for (const auto& [x, y] : edges) ++degree[x], ++degree[y];
                is_changed = std::erase_if(edges, [&](const auto& edge) {
                                 return degree[edge.first] == 1 || degree[edge.second] == 1;
                             }) > 0;
            }
            found.dendric = found.dendric && has_count && edges.empty();
        }
        found.episturmian = found.episturmian && left_special <= 1;
        found.arnoux_rauzy = found.arnoux_rauzy && left_special == 1 && full == 1;
    }
    found.arnoux_rauzy = found.arnoux_rauzy && found.episturmian;
    return found;
}

}  // namespace algae::oracle
