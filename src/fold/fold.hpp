#pragma once
// fold: phi(h^n(w)) without the word, and what follows from it: towers, single letters, walks,
// and derivation itself, the fold into words.

#include <concepts>
#include <cstdint>
#include <vector>

#include "algebra/monoid.hpp"
#include "base/budget.hpp"
#include "system/d0l.hpp"
#include "word/hom.hpp"

namespace algae {

/// What a monoid sees in one letter; there is exactly one way to lift it to words.
template <Monoid M, std::invocable<Symbol> Letter>
struct Lift {
    M monoid;
    Letter letter;
};
template <class M, class Letter>
Lift(M, Letter) -> Lift<M, Letter>;

/// The homomorphism that a lift extends to, on the accessible letters of a system.
template <Monoid M, class Letter>
Hom<M> homomorphism(const D0L& system, const Lift<M, Letter>& lift) {
    Hom<M> phi{lift.monoid,
               std::vector<typename M::value_type>(system.alphabet->size(), lift.monoid.one()),
               system.rules.brackets};
    for (const Symbol a : system.letters) phi.images[a] = lift.letter(a);
    return phi;
}

//> fold
/// phi(h^n(axiom)), where phi extends `lift`: in n products for each letter written in the rules,
/// however long the word is.
///
/// phi . h^n is worked out from the left, phi . h . h ..., so a letter's image after k steps is a
/// product of images after k - 1 steps (the universal property of the free monoid; Rozenberg and
/// Salomaa 1980, I.1). Throws Error if M is Branching and a successor's brackets do not match,
/// and what budget.check throws.
///
/// Example: fold(d0l("b", {{'a', "ab"}, {'b', "a"}}), 300, length_lift()) == Integer("359579325206583560961765665172189099052367214309267232255589801")
template <Monoid M, class Letter>
typename M::value_type fold(const D0L& system, std::uint64_t n, const Lift<M, Letter>& lift,
                            const Budget& budget = {}) {
    Hom<M> phi = homomorphism(system, lift);
    while (n-- > 0) {
        budget.check();
        auto next = phi.after(system.rules, system.letters);
        if (next.images == phi.images) break;  // and so for ever
        phi = std::move(next);
    }
    return phi(system.axiom);
}
//< fold

/// Every phi . h^k for k = 0..n: row k sends a letter to the image of what it becomes in k steps.
/// Takes the space of n + 1 rows.
template <Monoid M, class Letter>
std::vector<Hom<M>> tower(const D0L& system, std::uint64_t n, const Lift<M, Letter>& lift,
                          const Budget& budget = {}) {
    std::vector<Hom<M>> rows{homomorphism(system, lift)};
    for (std::uint64_t k = 0; k < n; ++k) {
        budget.check();
        rows.push_back(rows.back().after(system.rules, system.letters));
    }
    return rows;
}

}  // namespace algae
