#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/budget.hpp"
#include "growth/morphic.hpp"
#include "system/d0l.hpp"

namespace algae {

/// The factors of all words h^n(w) of a D0L system, up to some length.
struct FactorSet {
    std::size_t length = 0;
    std::vector<Word> words;  // the factors of that length, and the words of the language that are shorter
};

/// All factors of so many letters, and the whole words that have fewer; each once.
///
/// Exact, with erasing rules too: let p_j delete the letters that vanish within j steps. A factor of
/// p_j(h^(n+1)(w)) of k letters lies in p_j(h(u)) for a factor u of p_(j+1)(h^n(w)) of at most k
/// letters, because p_j(h(a)) is not empty for any letter a that p_(j+1) leaves. For j so great that
/// only letters that last are left this is a closure, and then there are finitely many steps down to
/// j = 0. O(k * number of factors * longest image) letters are looked at for each j. Throws
/// BoundReached if the factors take more than budget.memory.
FactorSet factors(const D0L& system, std::size_t length, const Budget& budget = {});

/// How many factors of 0, 1, ..., length letters the words of the language have together: the factor
/// complexity of the language (Ehrenfeucht, Lee and Rozenberg 1975), and of the infinite word where
/// the axiom begins its image, for then every word begins the next one.
///
/// Example: factor_complexity(d0l("a", {{'a', "ab"}, {'b', "a"}}), 5) ==
///     std::vector<std::uint64_t>{1, 2, 3, 4, 5, 6}
std::vector<std::uint64_t> factor_complexity(const D0L& system, std::size_t length, const Budget& budget = {});

/// The same for a system without names whose images are not empty.
std::vector<std::uint64_t> factor_complexity(const Iterated& system, std::size_t length, const Budget& budget = {});

/// Whether h^n(w) begins h^(n+1)(w) and their lengths are unbounded, so that the words are
/// beginnings of one infinite word.
///
/// Example: generates_infinite_word(d0l("a", {{'a', "ab"}, {'b', "a"}}))
bool generates_infinite_word(const D0L& system);

}  // namespace algae
