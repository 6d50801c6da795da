#include "growth/length_bounds.hpp"

namespace algae {

namespace {

/// One of the two recurrences.
struct Extreme {
    bool most;
    std::vector<Integer> lengths;      // by symbol: of what it becomes in some number of steps
    std::vector<std::size_t> choices;  // by place in OL::letters: the choice of the first of them

    Integer length(const Word& word) const {
        Integer sum;
        for (const Symbol a : word) sum += lengths[a];
        return sum;
    }

    void step(const OL& system) {
        std::vector<Integer> next(lengths.size());
        for (std::size_t i = 0; i < system.letters.size(); ++i) {
            const auto& successors = system.successors[system.letters[i]];
            Integer& best = next[system.letters[i]];
            for (std::size_t k = 0; k < successors.size(); ++k) {
                Integer candidate = length(successors[k]);
                if (k != 0 && !(most ? candidate > best : candidate < best)) continue;
                best = std::move(candidate);
                choices[i] = k;
            }
        }
        lengths = std::move(next);
    }
};

}  // namespace

LengthBounds length_bounds(const OL& system, std::uint64_t n, const Budget& budget) {
    const std::vector<Integer> ones(system.alphabet->size(), 1);
    const std::vector<std::size_t> first(system.letters.size(), 0);
    Extreme least{false, ones, first}, most{true, ones, first};
    LengthBounds found;
    std::uint64_t bits = 0;
    for (std::uint64_t k = 0;; ++k) {
        budget.check();
        found.least.push_back(least.length(system.axiom));
        found.most.push_back(most.length(system.axiom));
        budget.check_memory((bits += 2 * bit_length(found.most.back()) + 128) / 8, "the lengths");
        if (k == n) break;
        least.step(system);
        most.step(system);
    }
    found.least_choice = least.choices;
    found.most_choice = most.choices;
    return found;
}

D0L chosen_system(const OL& system, const std::vector<std::size_t>& choices) {
    std::vector<Word> images;
    for (const auto& successors : system.successors) images.push_back(successors.front());
    for (std::size_t i = 0; i < system.letters.size(); ++i)
        images[system.letters[i]] = system.successors[system.letters[i]][choices.at(i)];
    return make_d0l(system.alphabet, system.axiom, std::move(images), system.name);
}

}  // namespace algae
