#pragma once

#include <cstdint>
#include <vector>

#include "system/d0l.hpp"
#include "word/lifetimes.hpp"

namespace algae {

/// What a walk needs to know of a letter's future.
class Fates {
public:
    explicit Fates(const D0L& system);

    /// Whether the letter is its own successor.
    bool is_constant(Symbol a) const { return constant_[a] != 0; }
    /// Whether nothing is left of the letter after `steps` steps.
    bool is_gone(Symbol a, std::uint64_t steps) const {
        return steps >= gone_[a] && gone_[a] != never;
    }
    /// The least number of steps after which nothing is left of the letter: it is mortal
    /// (Rozenberg and Salomaa 1980, I.3); `never` if something always is.
    std::uint64_t lifetime(Symbol a) const { return gone_[a]; }
    static constexpr std::uint64_t never = lasts;

private:
    std::vector<char> constant_;
    std::vector<std::uint64_t> gone_;
};

/// Goes through the derivation of generation n from left to right. visit(a, steps) is called for
/// letters a that have `steps` steps still to go, each before what it becomes; it returns whether
/// to go into that. A constant is visited once, with 0 steps; letters of which nothing is left are
/// not visited. Letters with 0 steps are the word's own; for them the return value is ignored.
///
/// Memory: one position for each generation. Time: one call for each letter visited.
template <class Visit>
void walk(const D0L& system, const Fates& fates, std::uint64_t n, Visit&& visit) {
    struct Frame {
        const Symbol* next;
        const Symbol* end;
        std::uint64_t steps;  // that its letters have still to go
    };
    std::vector<Frame> path;
    path.push_back({system.axiom.data(), system.axiom.data() + system.axiom.size(), n});
    while (!path.empty()) {
        Frame& here = path.back();
        if (here.next == here.end) {
            path.pop_back();
            continue;
        }
        const Symbol a = *here.next++;
        const std::uint64_t steps = here.steps;
        if (steps == 0 || fates.is_constant(a)) {
            visit(a, std::uint64_t{0});
            continue;
        }
        if (fates.is_gone(a, steps) || !visit(a, steps)) continue;
        const Word& successor = system.successor(a);
        while (here.next != here.end && fates.is_gone(*here.next, steps)) ++here.next;
        if (here.next == here.end) path.pop_back();  // a last letter leaves nothing to come back to
        path.push_back({successor.data(), successor.data() + successor.size(), steps - 1});
    }
}

}  // namespace algae
