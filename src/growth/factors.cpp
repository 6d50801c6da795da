#include "growth/factors.hpp"

#include <algorithm>
#include <memory>
#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>

namespace algae {

namespace {

/// Words of one length or less, each once, in the order in which they were found. Each is marked if
/// it is known to end a word of the language.
class Windows {
public:
    Windows(std::size_t length, const Budget& budget) : length_(length), budget_(&budget) {}

    /// Adds the windows of `word` that begin at one of the first `starts` letters. `ends` says that
    /// the word ends a word of the language; then the last window is marked.
    void add(const Word& word, std::size_t starts, bool ends) {
        const std::u32string letters(word.begin(), word.end());
        const std::u32string_view text = letters;
        if (text.size() <= length_) {
            if (ends || text.size() == length_) insert(text, ends);
            return;
        }
        const std::size_t last = text.size() - length_;
        for (std::size_t i = 0; i <= std::min(last, starts - 1); ++i)
            insert(text.substr(i, length_), ends && i == last);
    }
    std::size_t size() const { return order_.size(); }
    Word word(std::size_t i) const { return Word(order_[i]->first.begin(), order_[i]->first.end()); }
    bool ends(std::size_t i) const { return order_[i]->second; }
    /// The next one whose windows are still to be looked at, or nothing.
    bool next(std::size_t& which) {
        if (done_ < order_.size()) {
            which = done_++;
            return true;
        }
        if (again_.empty()) return false;
        which = again_.back();
        again_.pop_back();
        return true;
    }

private:
    void insert(std::u32string_view text, bool ends) {
        const auto [place, is_new] = index_.try_emplace(std::u32string(text), order_.size());
        if (is_new) {
            taken_ += 4 * text.size() + 96;
            if (order_.size() % 256 == 0) {
                budget_->check();
                budget_->check_memory(taken_, "the set of factors");
            }
            order_.push_back(std::make_unique<Entry>(place->first, ends));
        } else if (ends && !order_[place->second]->second) {
            order_[place->second]->second = true;
            if (place->second < done_) again_.push_back(place->second);
        }
    }

    using Entry = std::pair<std::u32string_view, bool>;
    std::size_t length_;
    const Budget* budget_;
    std::unordered_map<std::u32string, std::size_t> index_;
    std::vector<std::unique_ptr<Entry>> order_;
    std::vector<std::size_t> again_;
    std::size_t done_ = 0;
    std::uint64_t taken_ = 0;
};

/// Adds the windows that begin in the image of the first letter, or all if the word ends there.
void add_image(Windows& windows, const std::vector<Word>& images, const Word& word, bool ends) {
    if (word.empty()) {
        windows.add({}, 1, ends);
        return;
    }
    const Word next = image(images, word);
    windows.add(next, ends ? std::max<std::size_t>(next.size(), 1) : images[word.front()].size(), ends);
}

/// The closure for a morphism without empty images.
Windows closed(const Iterated& system, std::size_t length, const Budget& budget) {
    Windows windows(length, budget);
    windows.add(system.axiom, system.axiom.size() + 1, true);
    for (std::size_t which = 0; windows.next(which);)
        add_image(windows, system.images, windows.word(which), windows.ends(which));
    return windows;
}

FactorSet set_of(const Windows& windows, std::size_t length) {
    FactorSet set{length, {}};
    set.words.reserve(windows.size());
    for (std::size_t i = 0; i < windows.size(); ++i) set.words.push_back(windows.word(i));
    return set;
}

/// Factors of k - 1 letters are what is left of those of k letters without the first or last one.
std::vector<std::uint64_t> counts(const FactorSet& set, const Budget& budget) {
    std::vector<std::u32string> texts;
    texts.reserve(set.words.size());
    for (const Word& word : set.words) texts.emplace_back(word.begin(), word.end());
    std::vector<std::vector<std::u32string_view>> shorter(set.length + 1);
    for (const std::u32string& text : texts) shorter[text.size()].push_back(text);
    std::vector<std::uint64_t> complexity(set.length + 1);
    std::unordered_set<std::u32string_view> here(shorter.back().begin(), shorter.back().end());
    for (std::size_t k = set.length;; --k) {
        budget.check();
        complexity[k] = here.size();
        if (k == 0) return complexity;
        std::unordered_set<std::u32string_view> next(shorter[k - 1].begin(), shorter[k - 1].end());
        next.reserve(here.size());
        for (const std::u32string_view word : here) {
            next.insert(word.substr(1));
            next.insert(word.substr(0, k - 1));
        }
        here = std::move(next);
    }
}

}  // namespace

FactorSet factors(const D0L& system, std::size_t length, const Budget& budget) {
    const auto lifetime = lifetimes(system.rules.images);
    std::uint64_t steps = 0;  // after so many nothing is left of a mortal letter
    for (const Symbol a : system.letters)
        if (lifetime[a] != lasts) steps = std::max(steps, lifetime[a]);
    FactorSet set;
    const auto left = [&](const Word& word, std::uint64_t j) {  // without what vanishes within j steps
        Word rest;
        for (const Symbol a : word)
            if (lifetime[a] == lasts || lifetime[a] > j) rest.push_back(a);
        return rest;
    };
    Windows windows = closed(skeleton(system), length, budget);
    for (std::uint64_t j = steps; j-- > 0;) {
        std::vector<Word> images(system.rules.images.size());
        for (const Symbol a : system.letters) images[a] = left(system.successor(a), j);
        Windows next(length, budget);
        const Word axiom = left(system.axiom, j);
        next.add(axiom, axiom.size() + 1, true);
        for (std::size_t i = 0; i < windows.size(); ++i)
            add_image(next, images, windows.word(i), windows.ends(i));
        windows = std::move(next);
    }
    return set_of(windows, length);
}

std::vector<std::uint64_t> factor_complexity(const D0L& system, std::size_t length, const Budget& budget) {
    return counts(factors(system, length, budget), budget);
}

std::vector<std::uint64_t> factor_complexity(const Iterated& system, std::size_t length, const Budget& budget) {
    return counts(set_of(closed(system, length, budget), length), budget);
}

bool generates_infinite_word(const D0L& system) {
    const Word next = image(system.rules.images, system.axiom);
    if (next.size() <= system.axiom.size() || !std::equal(system.axiom.begin(), system.axiom.end(), next.begin()))
        return false;
    const auto growing = growing_letters(system.rules.images);
    return std::any_of(system.axiom.begin(), system.axiom.end(), [&](Symbol a) { return growing[a] != 0; });
}

}  // namespace algae
