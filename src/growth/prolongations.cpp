#include <algorithm>

#include "growth/letters.hpp"

namespace algae {

namespace {

/// What a letter's lifetime is by symbol; none for letters that never die.
struct Lifetimes {
    std::vector<std::optional<std::uint64_t>> of;

    bool is_mortal(Symbol a) const { return of[a].has_value(); }
    /// Whether all letters have died after so many steps.
    bool die_within(Word::const_iterator from, Word::const_iterator to, std::uint64_t steps) const {
        return std::all_of(from, to, [&](Symbol a) { return of[a] && *of[a] <= steps; });
    }
};

}  // namespace

std::vector<Prolongation> prolongations(const D0L& system) {
    Lifetimes lifetime{std::vector<std::optional<std::uint64_t>>(system.alphabet->size())};
    const auto by_place = lifetimes(growth_matrix(system));
    for (std::size_t i = 0; i < by_place.size(); ++i) lifetime.of[system.letters[i]] = by_place[i];
    const auto leftmost = [&](Symbol a) {
        const Word& word = system.successor(a);
        return std::find_if(word.begin(), word.end(), [&](Symbol b) { return !lifetime.is_mortal(b); });
    };
    std::vector<Prolongation> found;
    for (const Symbol a : system.letters) {
        if (lifetime.is_mortal(a)) continue;
        std::uint64_t power = 1;
        Symbol b = *leftmost(a);
        for (; b != a && power <= system.letters.size(); ++power) b = *leftmost(b);
        if (b != a) continue;
        bool begins = true, fixed = true, infinite = false;
        for (std::uint64_t step = 1; step <= power && begins; ++step) {
            const Word& word = system.successor(b);
            const auto next = leftmost(b);
            begins = lifetime.die_within(word.begin(), next, power - step);
            fixed = fixed && lifetime.die_within(next + 1, word.end(), power - step);
            infinite = infinite || std::any_of(next + 1, word.end(), [&](Symbol c) { return !lifetime.is_mortal(c); });
            b = *next;
        }
        if (begins) found.push_back({a, power, fixed, infinite});
    }
    return found;
}

}  // namespace algae
