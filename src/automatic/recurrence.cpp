#include <algorithm>
#include <set>
#include <unordered_map>

#include "automatic/automatic.hpp"

// How far apart equal factors of an infinite word are, read off a beginning of it that is proved to hold all factors of some length.

namespace algae {

namespace {

using States = std::vector<std::uint32_t>;

/// Pairs of letters that follow each other in the word; a pair is first * letters + second.
std::set<std::uint32_t> neighbours(const Numeration& numeration) {
    const auto letters = static_cast<std::uint32_t>(numeration.letters().size());
    std::set<std::uint32_t> found;
    States queue;
    const auto add = [&](std::uint32_t left, std::uint32_t right) {
        if (found.insert(left * letters + right).second) queue.push_back(left * letters + right);
    };
    const auto add_within = [&](const States& word) {
        for (std::size_t i = 0; i + 1 < word.size(); ++i) add(word[i], word[i + 1]);
    };
    for (std::uint32_t s = 0; s < letters; ++s) add_within(numeration.image(s));
    for (std::size_t i = 0; i < queue.size(); ++i)
        add(numeration.image(queue[i] / letters).back(),
            numeration.image(queue[i] % letters).front());
    return found;
}

States image_of(const Numeration& numeration, const States& word) {
    States image;
    for (const std::uint32_t s : word)
        image.insert(image.end(), numeration.image(s).begin(), numeration.image(s).end());
    return image;
}

/// A beginning of the word with all its factors of `length` letters: the image of one with all neighbours by a power whose images have
/// at least length - 1 letters, so that a factor lies in the images of two neighbours. Nothing if it is longer than `most`.
std::optional<States> complete_beginning(const Numeration& numeration, std::size_t length,
                                         std::size_t most, const Budget& budget) {
    const auto letters = static_cast<std::uint32_t>(numeration.letters().size());
    std::set<std::uint32_t> missing = neighbours(numeration);
    States word{0};
    std::size_t seen = 0;  // letters whose neighbours are taken out
    while (!missing.empty()) {
        budget.check();
        if (word.size() > most) return std::nullopt;
        word = image_of(numeration, word);
        for (; seen + 1 < word.size() && !missing.empty(); ++seen)
            missing.erase(word[seen] * letters + word[seen + 1]);
    }
    word.resize(seen + 1);
    std::vector<std::size_t> sizes(letters, 1);
    std::size_t steps = 0;
    for (; *std::ranges::min_element(sizes) + 1 < length; ++steps) {
        budget.check();
        std::vector<std::size_t> next(letters, 0);
        for (std::uint32_t s = 0; s < letters; ++s)
            for (const std::uint32_t child : numeration.image(s)) next[s] += sizes[child];
        std::size_t total = 0;
        for (const std::uint32_t s : word) total += next[s];
        if (total > most || next == sizes) return std::nullopt;
        sizes = std::move(next);
    }
    for (std::size_t i = 0; i < steps; ++i) word = image_of(numeration, word);
    return word;
}

}  // namespace

FactorRecurrence factor_recurrence(const AutomaticWord& word, std::size_t to,
                                   const Budget& budget) {
    constexpr std::size_t most = 2'000'000;
    // Letters by their names.
    std::vector<std::string> names(word.letters.begin(), word.letters.end());
    std::ranges::sort(names);
    names.erase(std::unique(names.begin(), names.end()), names.end());
    std::vector<std::uint32_t> number;
    for (const std::string& name : word.letters)
        number.push_back(
            static_cast<std::uint32_t>(std::ranges::lower_bound(names, name) - names.begin()));
    FactorRecurrence found;
    found.values.push_back(0);
    States letters,
        factor;  // of the beginning; the number of the factor of n letters from each place on
    std::size_t complete = 0, n = 0;
    const auto one_longer = [&] {
        std::unordered_map<std::uint64_t, std::uint32_t> numbers;
        factor.pop_back();
        for (std::size_t i = 0; i < factor.size(); ++i) {
            if (i % 65'536 == 0) budget.check();
            const std::uint64_t key = std::uint64_t{factor[i]} << 32 | letters[i + n];
            factor[i] =
                numbers.emplace(key, static_cast<std::uint32_t>(numbers.size())).first->second;
        }
        ++n;
        return numbers.size();
    };
    while (found.values.size() <= to) {
        const std::size_t wanted = found.values.size();
        if (n >= wanted || complete == 0) {  // a longer beginning
            complete = std::max<std::size_t>(complete * 2, 16);
            const auto beginning = complete_beginning(word.numeration, complete, most, budget);
            if (!beginning) return found;
            letters.clear();
            for (const std::uint32_t s : *beginning) letters.push_back(number[s]);
            factor.assign(letters.size() + 1, 0);
            n = 0;
        }
        if (factor.size() <= 1) return found;
        const std::size_t factors = one_longer();
        if (n < wanted) continue;
        // Without a factor of n letters there are at most gap + n - 2 letters.
        std::vector<std::size_t> last(factors, 0);  // one beyond where it began
        std::size_t gap = 0;
        for (std::size_t i = 0; i < factor.size(); ++i) {
            gap = std::max(gap, i + 1 - last[factor[i]]);
            last[factor[i]] = i + 1;
        }
        for (const std::size_t one : last) gap = std::max(gap, factor.size() + 1 - one);
        const std::size_t value = gap + n - 1;
        if (value + 1 > complete) continue;  // longer factors may do without
        found.values.push_back(value);
        if (n > 1) continue;
        std::vector<std::size_t> before(names.size(), ~std::size_t{0});
        std::vector<std::set<std::vector<std::uint32_t>>> words(names.size());
        for (std::size_t i = 0; i < letters.size(); ++i) {
            std::size_t& from = before[letters[i]];
            if (from != ~std::size_t{0})
                words[letters[i]].emplace(letters.begin() + static_cast<std::ptrdiff_t>(from),
                                          letters.begin() + static_cast<std::ptrdiff_t>(i));
            from = i;
        }
        for (std::size_t a = 0; a < names.size(); ++a) {
            auto& all =
                found.return_words.emplace_back(names[a], std::vector<std::vector<std::string>>{})
                    .second;
            for (const auto& one : words[a]) {
                auto& spelled = all.emplace_back();
                for (const std::uint32_t letter : one) spelled.push_back(names[letter]);
            }
            std::ranges::stable_sort(all, {}, [](const auto& one) { return one.size(); });
        }
    }
    return found;
}

}  // namespace algae
