#include "language/construct_power.hpp"

#include <string>

#include "base/error.hpp"

namespace algae {

namespace {

/// The word after one step. Throws BoundReached if it is longer than `letters`.
Word step(const D0L& system, const Word& word, std::uint64_t letters) {
    Word next;
    for (const Symbol a : word) {
        const Word& successor = system.successor(a);
        if (next.size() + successor.size() > letters)
            throw BoundReached("the rules of a power have words of more than " +
                               std::to_string(letters) +
                               " letters: use a smaller power or more --max-letters");
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
            images[a] = step(system, images[a], budget.letters);
        }
    std::vector<D0L> found;
    Word axiom = system.axiom;
    for (unsigned i = 0; i < power; ++i) {
        found.push_back(make_d0l(system.alphabet, axiom, images, system.name));
        if (i + 1 < power) axiom = step(system, axiom, budget.letters);
    }
    return found;
}

}  // namespace algae
