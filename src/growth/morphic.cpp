#include "growth/morphic.hpp"

#include <algorithm>

#include "base/error.hpp"

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
    Iterated rest{lasting_part(system.axiom, lifetime), std::vector<Word>(system.rules.images.size())};
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
                                   std::find(images[a].begin(), images[a].end(), a) != images[a].end());
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
                words[i + 1].erase(words[i + 1].begin(),
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
    for (const Word& letter : result.back) result.system.images.push_back(renumbered(system.images[letter.front()]));
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
    std::rotate(least.begin(), least.begin() + static_cast<std::ptrdiff_t>(std::min(i, j) % std::max<std::size_t>(n, 1)),
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

}  // namespace algae
