// Periods, borders, conjugates and Lyndon words: linear scans.

#include <algorithm>
#include <numeric>

#include "combinatorics/detail/suffix_array.hpp"
#include "watch/watch.hpp"

namespace algae {

namespace {

/// By length of a prefix: its longest border.
std::vector<std::size_t> failures(const Word& word) {
    std::vector<std::size_t> found(word.size() + 1, 0);
    for (std::size_t i = 1, k = 0; i < word.size(); ++i) {
        while (k > 0 && word[i] != word[k]) k = found[k];
        if (word[i] == word[k]) ++k;
        found[i + 1] = k;
    }
    return found;
}

/// Calls `take` with the beginning of each Lyndon factor of the word, or of the word written twice.
template <class Take>
void factorise(const Word& word, std::size_t times, Take take) {
    const std::size_t n = word.size(), size = n * times;
    const auto letter = [&](std::size_t i) { return word[i < n ? i : i - n]; };
    for (std::size_t begin = 0; begin < size;) {
        std::size_t compared = begin, next = begin + 1;
        for (; next < size && letter(compared) <= letter(next); ++next)
            compared = letter(compared) < letter(next) ? begin : compared + 1;
        const std::size_t length = next - compared;
        for (; begin <= compared; begin += length) take(begin);
    }
}

}  // namespace

std::vector<std::size_t> borders(const Word& word) {
    std::vector<std::size_t> found;
    const std::vector<std::size_t> failure = failures(word);
    for (std::size_t k = failure[word.size()]; k > 0; k = failure[k]) found.push_back(k);
    std::ranges::reverse(found);
    return found;
}

std::vector<std::size_t> periods(const Word& word) {
    std::vector<std::size_t> found = borders(word);
    std::ranges::reverse(found);
    for (std::size_t& border : found) border = word.size() - border;
    if (!word.empty()) found.push_back(word.size());
    return found;
}

Word primitive_root(const Word& word) {
    const std::size_t period = word.size() - failures(word)[word.size()];
    if (word.empty() || word.size() % period != 0) return word;
    return Word(word.begin(), word.begin() + static_cast<std::ptrdiff_t>(period));
}

std::size_t least_rotation(const Word& word) {
    // The last Lyndon factor of the word written twice that begins in the first copy begins a least conjugate, or repeats it.
    std::size_t begin = 0;
    factorise(word, 2, [&](std::size_t i) {
        if (i < word.size()) begin = i;
    });
    return word.empty() ? 0 : begin % primitive_root(word).size();
}

Word least_conjugate(const Word& word) {
    Word turned = word;
    std::ranges::rotate(turned, turned.begin() + static_cast<std::ptrdiff_t>(least_rotation(word)));
    return turned;
}

std::vector<std::size_t> lyndon_factorisation(const Word& word) {
    std::vector<std::size_t> found;
    factorise(word, 1, [&](std::size_t i) { found.push_back(i); });
    return found;
}

namespace {

/// Whether a word of letters 0 and 1 is a factor of a Sturmian word. One letter stands alone, and between two of these stand k or k + 1 of the other
/// one: then those blocks, as letters, are such a word again, with the beginning and the end where these are too long to be parts of the shorter
/// block.
bool is_balanced(std::vector<char> word) {
    for (;;) {
        const auto has_two = [&](char letter) {
            for (std::size_t i = 1; i < word.size(); ++i)
                if (word[i - 1] == letter && word[i] == letter) return true;
            return false;
        };
        if (has_two(1)) {
            if (has_two(0)) return false;
            for (char& letter : word) letter = 1 - letter;
        }
        std::vector<std::size_t> blocks{0};  // of 0, before and behind each 1
        for (const char letter : word)
            if (letter == 0)
                ++blocks.back();
            else
                blocks.push_back(0);
        if (blocks.size() < 3) return true;
        const auto [least, most] = std::minmax_element(blocks.begin() + 1, blocks.end() - 1);
        const std::size_t k = *least, ends = std::max(blocks.front(), blocks.back());
        if (*most > k + 1 || ends > k + 1) return false;
        if (*most == k && ends <= k) return true;
        std::vector<char> next;
        if (blocks.front() > k) next.push_back(1);
        for (std::size_t i = 1; i + 1 < blocks.size(); ++i) next.push_back(blocks[i] > k ? 1 : 0);
        if (blocks.back() > k) next.push_back(1);
        word = std::move(next);
    }
}

}  // namespace

std::optional<SturmianProperties> sturmian_properties(const Word& word) {
    const std::size_t n = word.size();
    const Symbol least = n == 0 ? 0 : *std::ranges::min_element(word),
                 greatest = n == 0 ? 0 : *std::ranges::max_element(word);
    std::vector<char> letters;
    for (const Symbol letter : word) {
        if (letter != least && letter != greatest) return std::nullopt;
        letters.push_back(letter != least);
    }
    SturmianProperties found;
    found.balanced = is_balanced(letters);
    const auto is_central = [](const Word& part) {
        const std::size_t sum = part.size() + 2;
        std::vector<std::size_t> all = periods(part);
        all.push_back(part.size() + 1);  // longer ones than the word are periods, too
        return std::ranges::any_of(all, [&](std::size_t p) {
            const std::size_t q = sum - p;
            return std::gcd(p, q) == 1 && std::ranges::binary_search(all, q);
        });
    };
    found.central = is_central(word);
    found.standard = n == 1 || (n > 1 && word[n - 1] != word[n - 2] &&
                                is_central(Word(word.begin(), word.end() - 2)));
    found.christoffel = found.balanced && lyndon_factorisation(word).size() == 1;
    return found;
}

std::vector<AbelianPeriod> abelian_periods(const Word& word, const Budget& budget) {
    const std::size_t n = word.size();
    std::vector<Symbol> letters(word);
    std::ranges::sort(letters);
    letters.erase(std::unique(letters.begin(), letters.end()), letters.end());
    const std::size_t kinds = letters.size();
    std::vector<std::uint32_t> sums((n + 1) * kinds, 0);  // of the prefixes, by letter
    for (std::size_t i = 0; i < n; ++i) {
        const auto kind =
            static_cast<std::size_t>(std::ranges::lower_bound(letters, word[i]) - letters.begin());
        for (std::size_t k = 0; k < kinds; ++k)
            sums[(i + 1) * kinds + k] = sums[i * kinds + k] + (k == kind ? 1 : 0);
    }
    const auto count = [&](std::size_t begin, std::size_t end, std::size_t k) {
        return sums[end * kinds + k] - sums[begin * kinds + k];
    };
    const auto is_period = [&](std::size_t head, std::size_t period) {
        if (head + period > n) return false;
        const std::size_t whole = head + (n - head) / period * period;
        for (std::size_t k = 0; k < kinds; ++k) {
            const std::uint32_t wanted = count(head, head + period, k);
            if (count(0, head, k) > wanted || count(whole, n, k) > wanted) return false;
            for (std::size_t i = head + period; i < whole; i += period)
                if (count(i, i + period, k) != wanted) return false;
        }
        return true;
    };
    std::vector<AbelianPeriod> found;
    WorkCount periods("abelian period", n);
    for (std::size_t period = 1; period <= n; ++period) {
        budget.check();
        periods.at(period);
        for (std::size_t head = 0; head < period; ++head)
            if (is_period(head, period)) {
                found.push_back({head, period});
                break;
            }
    }
    return found;
}

}  // namespace algae
