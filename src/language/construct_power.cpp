#include "language/construct_power.hpp"

#include <string>

#include "base/error.hpp"

namespace algae {

namespace {

/// The word after one step. Throws BoundReached if it is longer than the budget allows.
Word step(const D0L& system, const Word& word, const Budget& budget) {
    Word next;
    for (const Symbol a : word) {
        const Word& successor = system.successor(a);
        if (next.size() + successor.size() > budget.letters)
            throw BoundReached(Bound::letters,
                               "the rules of a power have words of more than " +
                                   std::to_string(budget.letters) + " letters, the bound set" +
                                   budget.by(Bound::letters) + ": use a smaller power");
        next.insert(next.end(), successor.begin(), successor.end());
    }
    return next;
}

}  // namespace

std::vector<D0L> powers(const D0L& system, unsigned power, const Budget& budget) {
    if (power == 0) throw Error("expected a power of at least 1, found 0");
    std::vector<Word> images(system.alphabet->size());
    for (Symbol a = 0; a < images.size(); ++a) images[a] = {a};
    for (unsigned i = 0; i < power; ++i)
        for (const Symbol a : system.letters) {
            budget.check();
            images[a] = step(system, images[a], budget);
        }
    std::vector<D0L> found;
    Word axiom = system.axiom;
    for (unsigned i = 0; i < power; ++i) {
        found.push_back(make_d0l(system.alphabet, axiom, images, system.name));
        if (i + 1 < power) axiom = step(system, axiom, budget);
    }
    return found;
}

}  // namespace algae
