#pragma once

#include <optional>
#include <vector>

#include "base/budget.hpp"
#include "growth/morphic.hpp"
#include "system/d0l.hpp"

namespace algae {

/// Why a D0L system is pushy: `letter` grows, and h^steps(letter) = ... letter run, or run letter ...
/// if `left`, where `run` is not empty and has only letters that do not grow. So the letter pushes ever
/// longer words of such letters before it: run, run h^steps(run), run h^steps(run) h^(2 steps)(run), ...
/// to the right, and the same towards the left.
struct Pusher {
    Symbol letter = 0;
    std::size_t steps = 0;
    Word run;
    bool left = false;
};

/// Whether the words h^n(w) have unboundedly long factors over letters that do not grow (Ehrenfeucht
/// and Rozenberg 1983: the system is pushy), and if so, why. Decided: next to a growing letter a
/// stands the last (or first) growing letter of h(a) with what follows (or precedes) it; the system is
/// pushy exactly if in one of these two maps some cycle of accessible letters adds letters, for
/// otherwise every run between growing letters gets longer only a bounded number of times (Klouda and
/// Starosta 2015). Linear time but for writing the run.
///
/// Example: pusher_of(d0l("a", {{'a', "ab"}, {'b', "b"}})).has_value()
std::optional<Pusher> pusher_of(const D0L& system, const Budget& budget = {});

/// The same for the letters that `word` leads to, for a morphism without empty images of these.
std::optional<Pusher> pusher_of(const std::vector<Word>& images, const Word& word, const Budget& budget = {});

}  // namespace algae
