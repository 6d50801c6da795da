#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "algebra/semiring.hpp"
#include "base/budget.hpp"
#include "fold/fold.hpp"
#include "system/ol.hpp"

namespace algae {

/// The fold of an 0L system: a letter goes to the sum over its successors, so n generations cost n
/// products for each letter written in the rules, in a semiring.
template <Semiring S, class Letter>
typename S::value_type fold(const OL& system, std::uint64_t n, const Lift<S, Letter>& lift,
                            const Budget& budget = {}) {
    const S& semiring = lift.monoid;
    Hom<S> phi{semiring, std::vector<typename S::value_type>(system.alphabet->size(), semiring.one())};
    for (const Symbol a : system.letters) phi.images[a] = lift.letter(a);
    while (n-- > 0) {
        budget.check();
        Hom<S> composed = phi;
        for (const Symbol a : system.letters) {
            composed.images[a] = semiring.zero();
            for (const Word& successor : system.successors[a])
                semiring.add(composed.images[a], phi(successor));
        }
        phi = std::move(composed);
    }
    return phi(system.axiom);
}

/// All words of generation n, each once, in shortlex order of their names; with `longest`, only
/// those of at most so many letters (and then shorter words that come from longer ones are found
/// too, because words are built from what each letter becomes, not forward).
///
/// Throws BoundReached if the sets take more than budget.memory.
///
/// Example: words_of_generation(ol("aa", {{'a', ""}, {'a', "a"}}), 1).size() == 3
std::vector<Word> words_of_generation(const OL& system, std::uint64_t n,
                                      std::optional<std::size_t> longest = std::nullopt,
                                      const Budget& budget = {});

/// All words of the language with at most `longest` letters, in shortlex order. Complete, erasing
/// rules or not: what each letter becomes in k steps, cut at `longest`, is one of finitely many
/// families of finite sets, so the families repeat from some k on.
///
/// Example: words_up_to(ol("a", {{'a', "a"}, {'a', "aa"}}), 5).size() == 5
std::vector<Word> words_up_to(const OL& system, std::size_t longest, const Budget& budget = {});

}  // namespace algae
