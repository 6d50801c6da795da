#include <algorithm>
#include <memory>
#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>

#include "exact/exact.hpp"
#include "growth/growth.hpp"

// The factors of D0L languages, and formulas that build each generation from earlier ones.
//
// The set of factors of k letters closes under "factors of images of factors"; with erasing rules this is done for words from
// which the letters that vanish within j steps are deleted, for all j from large to 0 (the argument stands at
// `factors` in the face). Before anything else a morphism is brought into form: mortal letters are left out, and the
// defect theorem makes it injective. A locally catenative formula needs one instance only: the morphism maps the equation for n
// to that for n + 1.

namespace algae {

Word image(const std::vector<Word>& images, const Word& word) {
    Word result;
    for (const Symbol a : word) result.insert(result.end(), images[a].begin(), images[a].end());
    return result;
}

std::vector<char> accessible_letters(const std::vector<Word>& images, const Word& word) {
    std::vector<char> seen(images.size(), 0);
    Word waiting = word;
    for (const Symbol a : word) seen[a] = 1;
    while (!waiting.empty()) {
        const Symbol a = waiting.back();
        waiting.pop_back();
        for (const Symbol b : images[a])
            if (!seen[b]) {
                seen[b] = 1;
                waiting.push_back(b);
            }
    }
    return seen;
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
    const auto lifetime = lifetimes(system.rules.images);
    Iterated rest{lasting_part(system.axiom, lifetime),
                  std::vector<Word>(system.rules.images.size())};
    for (const Symbol a : system.letters)
        if (lifetime[a] == lasts) rest.images[a] = lasting_part(system.successor(a), lifetime);
    return rest;
}

LetterComponents components_of(const std::vector<Word>& images) {
    const std::size_t count = images.size(), none = count;
    LetterComponents found{std::vector<std::size_t>(count, none), {}, {}};
    std::vector<std::size_t> number(count, 0), low(count, 0);
    std::vector<Symbol> open;
    struct Frame {
        Symbol letter;
        std::size_t next;
    };
    std::size_t numbered = 0;
    for (Symbol root = 0; root < count; ++root) {
        if (number[root] != 0) continue;
        std::vector<Frame> path{{root, 0}};
        number[root] = low[root] = ++numbered;
        open.push_back(root);
        while (!path.empty()) {
            const Symbol a = path.back().letter;
            if (path.back().next < images[a].size()) {
                const Symbol b = images[a][path.back().next++];
                if (number[b] == 0) {
                    number[b] = low[b] = ++numbered;
                    open.push_back(b);
                    path.push_back({b, 0});
                } else if (found.of[b] == none) {
                    low[a] = std::min(low[a], number[b]);
                }
                continue;
            }
            path.pop_back();
            if (!path.empty()) low[path.back().letter] = std::min(low[path.back().letter], low[a]);
            if (low[a] != number[a]) continue;
            auto& members = found.members.emplace_back();
            Symbol b;
            do {
                b = open.back();
                open.pop_back();
                found.of[b] = found.members.size() - 1;
                members.push_back(b);
            } while (b != a);
            found.cyclic.push_back(members.size() > 1 ||
                                   std::find(images[a].begin(), images[a].end(), a) !=
                                       images[a].end());
        }
    }
    return found;
}

std::vector<char> growing_letters(const std::vector<Word>& images) {
    const auto lifetime = lifetimes(images);
    std::vector<Word> lasting(images.size());
    for (Symbol a = 0; a < images.size(); ++a)
        if (lifetime[a] == lasts) lasting[a] = lasting_part(images[a], lifetime);
    const LetterComponents components = components_of(lasting);
    std::vector<char> grows(components.members.size(), 0);
    for (std::size_t c = 0; c < grows.size(); ++c)  // those it leads to come first
        for (const Symbol a : components.members[c]) {
            if (components.cyclic[c] && lasting[a].size() > 1) grows[c] = 1;
            for (const Symbol b : lasting[a])
                if (grows[components.of[b]]) grows[c] = 1;
        }
    std::vector<char> growing(images.size());
    for (Symbol a = 0; a < images.size(); ++a) growing[a] = grows[components.of[a]];
    return growing;
}

Iterated mirrored(const Iterated& system) {
    Iterated other = system;
    std::reverse(other.axiom.begin(), other.axiom.end());
    for (Word& word : other.images) std::reverse(word.begin(), word.end());
    return other;
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
    const auto accessible = accessible_letters(system.images, system.axiom);
    Injective result;
    std::vector<Symbol> number(system.images.size(), 0);
    for (Symbol a = 0; a < system.images.size(); ++a)
        if (accessible[a]) {
            number[a] = static_cast<Symbol>(result.back.size());
            result.back.push_back({a});
        }
    const auto renumbered = [&](Word word) {
        for (Symbol& a : word) a = number[a];
        return word;
    };
    result.system.axiom = renumbered(system.axiom);
    for (const Word& letter : result.back)
        result.system.images.push_back(renumbered(system.images[letter.front()]));
    for (;;) {
        budget.check();
        const std::vector<Word> code = prefix_hull(result.system.images);
        if (code.size() == result.system.images.size()) return result;
        const auto factors = [&](const Word& word) {  // of the image of the word
            Word product;
            for (const Symbol a : word) {
                const Word part = factorised(result.system.images[a], code);
                product.insert(product.end(), part.begin(), part.end());
            }
            return product;
        };
        Injective next;
        next.steps = result.steps + 1;
        next.system.axiom = factors(result.system.axiom);
        for (const Word& word : code) {
            next.system.images.push_back(factors(word));
            next.back.push_back(image(result.back, word));
        }
        result = std::move(next);
    }
}

namespace {

/// The lengths of the longest proper borders of the prefixes (Knuth, Morris and Pratt 1977).
std::vector<std::size_t> borders(const Word& word) {
    std::vector<std::size_t> border(word.size() + 1, 0);
    for (std::size_t i = 1, k = 0; i < word.size(); ++i) {
        while (k > 0 && word[i] != word[k]) k = border[k];
        if (word[i] == word[k]) ++k;
        border[i + 1] = k;
    }
    return border;
}

}  // namespace

Word primitive_root(const Word& word) {
    if (word.empty()) return word;
    const std::size_t period = word.size() - borders(word).back();
    if (word.size() % period != 0) return word;
    return Word(word.begin(), word.begin() + static_cast<std::ptrdiff_t>(period));
}

Word least_conjugate(const Word& word) {
    const std::size_t n = word.size();
    std::size_t i = 0, j = 1, k = 0;
    while (i < n && j < n && k < n) {
        const Symbol a = word[(i + k) % n], b = word[(j + k) % n];
        if (a == b) {
            ++k;
            continue;
        }
        (a > b ? i : j) += k + 1;
        if (i == j) ++j;
        k = 0;
    }
    Word least = word;
    std::rotate(
        least.begin(),
        least.begin() + static_cast<std::ptrdiff_t>(std::min(i, j) % std::max<std::size_t>(n, 1)),
        least.end());
    return least;
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
void add_image(Windows& windows, const std::vector<Word>& images, const Word& word, bool ends) {
    if (word.empty()) {
        windows.add({}, 1, ends);
        return;
    }
    const Word next = image(images, word);
    windows.add(next, ends ? std::max<std::size_t>(next.size(), 1) : images[word.front()].size(),
                ends);
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
    const auto left = [&](const Word& word,
                          std::uint64_t j) {  // without what vanishes within j steps
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

std::vector<std::uint64_t> factor_complexity(const D0L& system, std::size_t length,
                                             const Budget& budget) {
    return counts(factors(system, length, budget), budget);
}

std::vector<std::uint64_t> factor_complexity(const Iterated& system, std::size_t length,
                                             const Budget& budget) {
    return counts(set_of(closed(system, length, budget), length), budget);
}

bool generates_infinite_word(const D0L& system) {
    const Word next = image(system.rules.images, system.axiom);
    if (next.size() <= system.axiom.size() ||
        !std::equal(system.axiom.begin(), system.axiom.end(), next.begin()))
        return false;
    const auto growing = growing_letters(system.rules.images);
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
        Word next = image(system.rules.images, words.back());
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
