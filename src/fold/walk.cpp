#include "fold/walk.hpp"

#include <algorithm>

namespace algae {

Fates::Fates(const D0L& system)
    : constant_(system.alphabet->size(), 0), gone_(system.alphabet->size(), never) {
    for (const Symbol a : system.letters) constant_[a] = system.successor(a) == Word{a};
    // A letter is gone one step after the last of its successor's letters. Letters settle in the
    // order of their lifetimes, so as many rounds as letters suffice.
    std::vector<std::vector<Symbol>> parents(gone_.size());
    std::vector<std::size_t> waiting(gone_.size(), 0);
    std::vector<Symbol> settled;
    for (const Symbol a : system.letters) {
        waiting[a] = system.successor(a).size();
        for (const Symbol b : system.successor(a)) parents[b].push_back(a);
        if (waiting[a] == 0) {
            gone_[a] = 1;
            settled.push_back(a);
        }
    }
    for (std::size_t i = 0; i < settled.size(); ++i)
        for (const Symbol parent : parents[settled[i]])
            if (--waiting[parent] == 0) {
                for (const Symbol b : system.successor(parent))
                    gone_[parent] = gone_[parent] == never ? gone_[b] + 1 : std::max(gone_[parent], gone_[b] + 1);
                settled.push_back(parent);
            }
}

}  // namespace algae
