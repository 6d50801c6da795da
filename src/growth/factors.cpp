#include <algorithm>
#include <memory>
#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>

#include "exact/exact.hpp"
#include "growth/growth.hpp"
#include "watch/watch.hpp"

// The factors of D0L languages, and formulas that build each generation from earlier ones.
//
// The set of factors of k letters closes under "factors of images of factors"; with erasing rules this is done for words from
// which the letters that vanish within j steps are deleted, for all j from large to 0 (the argument stands at
// `factors` in the face). Before anything else a morphism is brought into form: mortal letters are left out, and the
// defect theorem makes it injective. A locally catenative formula needs one instance only: the morphism maps the equation for n
// to that for n + 1.

namespace algae {

std::vector<char> accessible_letters(const Morphism& rules, const Word& word) {
    std::vector<char> found(rules.size(), 0);
    for (const Symbol letter :
         accessible(word, rules.size(), [&](Symbol a, auto see) { see(rules[a]); }))
        found[letter] = 1;
    return found;
}

namespace {

Word lasting_part(const Word& word, const std::vector<std::uint64_t>& lifetime) {
    Word part;
    for (const Symbol a : word)
        if (lifetime[a] == lasts) part.push_back(a);
    return part;
}

}  // namespace

Iterated skeleton(const D0L& system) {
    const auto lifetime = lifetimes(system.rules);
    std::vector<Word> images(system.rules.size());
    for (const Symbol a : system.letters)
        if (lifetime[a] == lasts) images[a] = lasting_part(system.successor(a), lifetime);
    return {lasting_part(system.axiom, lifetime), Morphism(std::move(images))};
}

std::vector<char> growing_letters(const Morphism& rules) {
    const auto lifetime = lifetimes(rules);
    std::vector<std::vector<std::size_t>> lasting(rules.size());  // letters of the image, by letter
    for (Symbol a = 0; a < rules.size(); ++a)
        if (lifetime[a] == lasts) {
            const Word part = lasting_part(rules[a], lifetime);
            lasting[a].assign(part.begin(), part.end());
        }
    const std::vector<std::size_t> component = strong_components(lasting);
    std::vector<std::vector<std::size_t>> members(rules.size());  // by component
    for (std::size_t a = 0; a < lasting.size(); ++a) members[component[a]].push_back(a);
    std::vector<char> grows(members.size(), 0);
    for (std::size_t c = 0; c < grows.size(); ++c)  // those it leads to come first
        for (const std::size_t a : members[c])
            for (const std::size_t b : lasting[a])
                if (grows[component[b]] || (component[b] == c && lasting[a].size() > 1))
                    grows[c] = 1;
    std::vector<char> growing(rules.size());
    for (std::size_t a = 0; a < growing.size(); ++a) growing[a] = grows[component[a]];
    return growing;
}

namespace {

bool begins_with(const Word& word, const Word& begin) {
    return word.size() >= begin.size() && std::equal(begin.begin(), begin.end(), word.begin());
}

/// The prefix code whose submonoid is the least that contains the words.
std::vector<Word> prefix_hull(std::vector<Word> words) {
    for (bool changed = true; changed;) {
        std::sort(words.begin(), words.end());
        words.erase(std::unique(words.begin(), words.end()), words.end());
        changed = false;
        // A word that begins another one stands before it, and so do all between them.
        for (std::size_t i = 0; i + 1 < words.size(); ++i)
            if (begins_with(words[i + 1], words[i])) {
                words[i + 1].erase(
                    words[i + 1].begin(),
                    words[i + 1].begin() + static_cast<std::ptrdiff_t>(words[i].size()));
                changed = true;
                break;
            }
    }
    return words;
}

/// The word as a product of words of a prefix code.
Word factorised(const Word& word, const std::vector<Word>& code) {
    Word factors;
    for (std::size_t at = 0; at < word.size();) {
        const Word rest(word.begin() + static_cast<std::ptrdiff_t>(at), word.end());
        std::size_t next = 0;
        while (next < code.size() && !begins_with(rest, code[next])) ++next;
        if (next == code.size()) throw Error("a word is no product of the words that generate it");
        factors.push_back(static_cast<Symbol>(next));
        at += code[next].size();
    }
    return factors;
}

}  // namespace

Injective made_injective(const Iterated& system, const Budget& budget) {
    const auto accessible = accessible_letters(system.rules, system.axiom);
    std::vector<Symbol> number(system.rules.size(), 0);
    std::vector<Word> letters, images;
    for (Symbol a = 0; a < number.size(); ++a)
        if (accessible[a]) {
            number[a] = static_cast<Symbol>(letters.size());
            letters.push_back({a});
        }
    for (const Word& letter : letters)
        images.push_back(replaced(system.rules[letter.front()], number));
    Injective result{{replaced(system.axiom, number), Morphism(std::move(images))},
                     Morphism(std::move(letters))};
    for (;;) {
        budget.check();
        const Morphism& rules = result.system.rules;
        const std::vector<Word> code = prefix_hull(rules.images());
        if (code.size() == rules.size()) return result;
        std::vector<Word> parts;  // of the images, as products of words of the code
        for (const Word& word : rules.images()) parts.push_back(factorised(word, code));
        const Morphism factors(std::move(parts));
        std::vector<Word> next, back;
        for (const Word& word : code) {
            next.push_back(factors(word));
            back.push_back(result.back(word));
        }
        result = {{factors(result.system.axiom), Morphism(std::move(next))},
                  Morphism(std::move(back)),
                  result.steps + 1};
    }
}

bool is_factor_of_powers(const Word& word, const Word& z) {
    if (word.empty()) return true;
    if (z.empty()) return false;
    for (std::size_t start = 0; start < z.size(); ++start) {
        std::size_t i = 0;
        while (i < word.size() && word[i] == z[(start + i) % z.size()]) ++i;
        if (i == word.size()) return true;
    }
    return false;
}

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
    Word word(std::size_t i) const {
        return Word(order_[i]->first.begin(), order_[i]->first.end());
    }
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
void add_image(Windows& windows, const Morphism& rules, const Word& word, bool ends) {
    if (word.empty()) {
        windows.add({}, 1, ends);
        return;
    }
    const Word next = rules(word);
    windows.add(next, ends ? std::max<std::size_t>(next.size(), 1) : rules[word.front()].size(),
                ends);
}

/// The closure for a morphism without empty images.
Windows closed(const Iterated& system, std::size_t length, const Budget& budget) {
    Windows windows(length, budget);
    windows.add(system.axiom, system.axiom.size() + 1, true);
    WorkCount done("window");
    for (std::size_t which = 0; windows.next(which); ++done)
        add_image(windows, system.rules, windows.word(which), windows.ends(which));
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
    const auto lifetime = lifetimes(system.rules);
    std::uint64_t steps = 0;  // after so many nothing is left of a mortal letter
    for (const Symbol a : system.letters)
        if (lifetime[a] != lasts) steps = std::max(steps, lifetime[a]);
    FactorSet set;
    const auto left = [&](const Word& word,
                          std::uint64_t j) {  // without what vanishes within j steps
        Word rest;
        for (const Symbol a : word)
            if (lifetime[a] == lasts || lifetime[a] > j) rest.push_back(a);
        return rest;
    };
    Windows windows = closed(skeleton(system), length, budget);
    for (std::uint64_t j = steps; j-- > 0;) {
        Morphism rules;
        for (const Symbol a : system.letters) rules.add(a, left(system.successor(a), j));
        Windows next(length, budget);
        const Word axiom = left(system.axiom, j);
        next.add(axiom, axiom.size() + 1, true);
        for (std::size_t i = 0; i < windows.size(); ++i)
            add_image(next, rules, windows.word(i), windows.ends(i));
        windows = std::move(next);
    }
    return set_of(windows, length);
}

std::vector<std::uint64_t> factor_complexity(const D0L& system, std::size_t length,
                                             const Budget& budget) {
    return counts(factors(system, length, budget), budget);
}

std::vector<std::uint64_t> factor_complexity(const Iterated& system, std::size_t length,
                                             const Budget& budget) {
    return counts(set_of(closed(system, length, budget), length), budget);
}

bool generates_infinite_word(const D0L& system) {
    const Word next = system.rules(system.axiom);
    if (next.size() <= system.axiom.size() ||
        !std::equal(system.axiom.begin(), system.axiom.end(), next.begin()))
        return false;
    const auto growing = growing_letters(system.rules);
    return std::any_of(system.axiom.begin(), system.axiom.end(),
                       [&](Symbol a) { return growing[a] != 0; });
}

namespace {

/// The fewest of the words, one after the other, that make `whole`: how far back each is, or nothing.
/// `earlier[i - 1]` is the word i generations back; empty words take no part.
std::optional<std::vector<std::size_t>> tiling(const Word& whole,
                                               const std::vector<const Word*>& earlier) {
    constexpr std::size_t never = static_cast<std::size_t>(-1);
    std::vector<std::size_t> fewest(whole.size() + 1, never), choice(whole.size() + 1, 0);
    fewest[0] = 0;
    for (std::size_t at = 0; at < whole.size(); ++at) {
        if (fewest[at] == never) continue;
        for (std::size_t i = 0; i < earlier.size(); ++i) {
            const Word& word = *earlier[i];
            const std::size_t end = at + word.size();
            if (word.empty() || end > whole.size() || fewest[end] <= fewest[at] + 1) continue;
            if (!std::equal(word.begin(), word.end(),
                            whole.begin() + static_cast<std::ptrdiff_t>(at)))
                continue;
            fewest[end] = fewest[at] + 1;
            choice[end] = i + 1;
        }
    }
    if (fewest.back() == never || whole.empty()) return std::nullopt;
    std::vector<std::size_t> back;
    for (std::size_t end = whole.size(); end > 0; end -= earlier[back.back() - 1]->size())
        back.push_back(choice[end]);
    std::reverse(back.begin(), back.end());
    return back;
}

/// Why no formula can hold, if the lengths tell.
std::optional<std::string> why_none(const D0L& system, const Budget& budget) {
    const GrowthOrder order =
        growth_order(system, letter_orders(components(growth_matrix(system), budget)));
    if (order.kind == GrowthKind::zero) return "the words are empty from some n on";
    if (order.kind == GrowthKind::bounded)
        return "the lengths are bounded, and two words or more would make them double without end";
    if (order.kind == GrowthKind::exponential) return std::nullopt;
    return "the lengths grow like a polynomial, and two words or more would make them grow "
           "exponentially";
}

}  // namespace

std::string CatenativeFormula::text() const {
    std::string text = "w(n) =";
    for (const std::size_t i : back) text += " w(n-" + std::to_string(i) + ")";
    return text + " for n >= " + std::to_string(from);
}

CatenativeAnswer locally_catenative(const D0L& system, std::size_t depth, std::size_t further,
                                    const Budget& budget) {
    if (const auto reason = why_none(system, budget))
        return {CatenativeAnswer::Kind::none, std::nullopt, *reason};
    const std::uint64_t most = std::min<std::uint64_t>(budget.letters, 1'000'000);
    std::vector<Word> words{system.axiom};
    std::uint64_t letters = system.axiom.size();
    while (words.size() <= depth + further) {
        budget.check();
        Word next = system.rules(words.back());
        letters += next.size();
        if (letters > most) break;
        words.push_back(std::move(next));
    }
    for (std::size_t deep = 1; deep <= depth; ++deep)
        for (std::size_t n = deep; n < words.size(); ++n) {
            budget.check();
            std::vector<const Word*> earlier;
            for (std::size_t i = 1; i <= deep; ++i) earlier.push_back(&words[n - i]);
            const auto back = tiling(words[n], earlier);
            if (back && back->size() > 1)
                return {CatenativeAnswer::Kind::found, CatenativeFormula{*back, n},
                        "it holds for n = " + std::to_string(n) +
                            ", and the morphism maps each case to the next"};
        }
    return {CatenativeAnswer::Kind::not_found, std::nullopt,
            "no formula of depth up to " + std::to_string(depth) + " holds for any n up to " +
                std::to_string(words.size() - 1)};
}

}  // namespace algae
