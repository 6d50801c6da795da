#include "growth/repetitions.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <set>

#include "growth/pushy.hpp"

namespace algae {

namespace {

void check_length(const Word& word, const Budget& budget) {
    budget.check();
    budget.check_memory(word.size() * sizeof(Symbol), "a word that is repeated without end");
}

/// The cycles of first letters of images, of growing letters.
std::vector<std::vector<Symbol>> first_letter_cycles(const Iterated& system, const std::vector<char>& growing) {
    std::vector<std::size_t> seen(system.images.size(), 0);
    std::vector<std::vector<Symbol>> cycles;
    std::size_t round = 0;
    for (Symbol start = 0; start < system.images.size(); ++start) {
        if (system.images[start].empty() || seen[start] != 0) continue;
        ++round;
        Symbol a = start;
        for (; seen[a] == 0; a = system.images[a].front()) seen[a] = round;
        if (seen[a] != round || !growing[a]) continue;
        std::vector<Symbol> cycle;
        Symbol b = a;
        do {
            cycle.push_back(b);
            b = system.images[b].front();
        } while (b != a);
        cycles.push_back(std::move(cycle));
    }
    return cycles;
}

/// The beginning of a word before a growing letter occurs in it a second time, if that letter is the
/// first one; `repeated` says whether any letter did.
std::optional<Word> before_return(const Word& word, const std::vector<char>& growing, bool& repeated) {
    std::set<Symbol> seen;
    for (std::size_t i = 0; i < word.size(); ++i)
        if (growing[word[i]] && !seen.insert(word[i]).second) {
            repeated = true;
            if (word[i] != word.front()) return std::nullopt;
            return Word(word.begin(), word.begin() + static_cast<std::ptrdiff_t>(i));
        }
    repeated = false;
    return std::nullopt;
}

/// How often `part` is written one after the other in the word; 0 if it is no power.
std::size_t exponent(const Word& word, const Word& part) {
    if (part.empty() || word.size() % part.size() != 0) return 0;
    for (std::size_t i = 0; i < word.size(); ++i)
        if (word[i] != part[i % part.size()]) return 0;
    return word.size() / part.size();
}

/// The words v_i for which g(v_i) is a power of v_(i+1) around the cycle, and some power above 1.
std::optional<std::vector<Word>> periods(const Iterated& system, const std::vector<Symbol>& cycle,
                                         const std::vector<char>& growing, const Budget& budget) {
    const std::size_t q = cycle.size();
    std::vector<Word> begins;  // of the infinite words that the letters begin
    for (const Symbol a : cycle) begins.push_back({a});
    std::vector<std::optional<Word>> found(q);
    std::vector<char> settled(q, 0);
    // A second growing letter comes within as many rounds as there are letters, or never.
    for (std::size_t round = 0; round < q * (system.images.size() + 1); ++round) {
        bool all = true;
        std::vector<Word> next(q);
        for (std::size_t i = 0; i < q; ++i) {
            const std::size_t j = (i + 1) % q;
            bool repeated = false;
            if (!settled[i]) {
                found[i] = before_return(begins[i], growing, repeated);
                if (repeated && !found[i]) return std::nullopt;
                settled[i] = repeated;
            }
            all = all && settled[i];
            next[j] = settled[j] ? begins[j] : image(system.images, begins[i]);
            check_length(next[j], budget);
        }
        begins = std::move(next);
        if (all) break;
    }
    bool longer = false;
    std::vector<Word> words;
    for (std::size_t i = 0; i < q; ++i) {
        if (!found[i] || !found[(i + 1) % q]) return std::nullopt;
        const std::size_t times = exponent(image(system.images, *found[i]), *found[(i + 1) % q]);
        if (times == 0) return std::nullopt;
        longer = longer || times > 1;
        words.push_back(*found[i]);
    }
    if (!longer) return std::nullopt;
    return words;
}

/// What a growing letter leaves behind it for ever: the images of `run` come back after some steps.
Word pushed(const std::vector<Word>& images, const Word& run, std::size_t steps, const Budget& budget) {
    std::map<Word, std::size_t> seen;
    std::vector<Word> parts;
    for (Word part = run;;) {
        const auto [place, is_new] = seen.emplace(part, parts.size());
        if (!is_new) {
            Word all;  // the letter is followed by run, h^q(run), h^(2q)(run), ...
            for (std::size_t i = place->second; i < parts.size(); ++i)
                all.insert(all.end(), parts[i].begin(), parts[i].end());
            check_length(all, budget);
            return all;
        }
        parts.push_back(part);
        for (std::size_t i = 0; i < steps; ++i) part = image(images, part);
        check_length(part, budget);
    }
}

}  // namespace

std::vector<InfiniteRepetition> growing_repetitions(const Iterated& system, const Budget& budget) {
    const Injective simple = made_injective(system, budget);
    const auto growing = growing_letters(simple.system.images);
    std::map<Word, Symbol> found;
    for (const auto& cycle : first_letter_cycles(simple.system, growing))
        if (const auto words = periods(simple.system, cycle, growing, budget))
            for (const Word& word : *words)
                found.emplace(least_conjugate(primitive_root(image(simple.back, word))),
                              simple.back[word.front()].front());
    std::vector<InfiniteRepetition> repetitions;
    for (const auto& [word, letter] : found) repetitions.push_back({word, true, letter});
    return repetitions;
}

std::vector<InfiniteRepetition> infinite_repetitions(const D0L& system, const Budget& budget) {
    const Iterated rest = skeleton(system);
    const auto growing = growing_letters(rest.images);
    const auto accessible = accessible_letters(rest.images, rest.axiom);
    std::vector<InfiniteRepetition> found = growing_repetitions(rest, budget);
    for (const bool left : {false, true}) {
        const std::vector<Word> images = left ? mirrored({{}, rest.images}).images : rest.images;
        for (Symbol a = 0; a < images.size(); ++a) {
            if (!accessible[a] || !growing[a]) continue;
            // Only letters on a cycle of last growing letters push without end.
            std::vector<Word> after;
            std::vector<Symbol> path{a};
            do {
                const Word& next = images[path.back()];
                const auto last = std::find_if(next.rbegin(), next.rend(), [&](Symbol b) { return growing[b] != 0; });
                after.emplace_back(last.base(), next.end());
                path.push_back(*last);
            } while (path.back() != a && path.size() <= images.size());
            if (path.back() != a) continue;
            Word run;
            for (const Word& part : after) {
                const Word more = image(images, run);
                run = part;
                run.insert(run.end(), more.begin(), more.end());
                check_length(run, budget);
            }
            if (run.empty()) continue;
            Word word = pushed(images, run, after.size(), budget);
            if (left) std::reverse(word.begin(), word.end());
            found.push_back({word, false, a});
        }
    }
    // As the system itself writes them, with the letters that vanish.
    const auto lifetime = lifetimes(system.rules.images);
    std::uint64_t steps = 0;
    for (const Symbol a : system.letters)
        if (lifetime[a] != lasts) steps = std::max(steps, lifetime[a]);
    std::map<Word, InfiniteRepetition> all;
    for (InfiniteRepetition& repetition : found) {
        for (std::uint64_t i = 0; i < steps; ++i) {
            repetition.word = primitive_root(image(system.rules.images, repetition.word));
            check_length(repetition.word, budget);
        }
        repetition.word = least_conjugate(primitive_root(repetition.word));
        all.emplace(repetition.word, repetition);
    }
    std::vector<InfiniteRepetition> repetitions;
    for (auto& [word, repetition] : all) repetitions.push_back(repetition);
    std::stable_sort(repetitions.begin(), repetitions.end(),
                     [](const auto& x, const auto& y) { return x.word.size() < y.word.size(); });
    return repetitions;
}

}  // namespace algae
