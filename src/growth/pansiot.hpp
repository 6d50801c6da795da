#pragma once

#include <string>

#include "base/budget.hpp"
#include "system/d0l.hpp"

namespace algae {

/// The orders of growth that the factor complexity of a D0L language can have; `zero` for a finite
/// language, which has no long factors. In increasing order.
enum class ComplexityClass { zero, constant, linear, n_log_log_n, n_log_n, quadratic };

/// "0", "1", "n", "n log log n", "n log n", "n^2".
///
/// Example: to_string(ComplexityClass::linear) == "n"
std::string to_string(ComplexityClass value);

/// The class, or what is known of it: p(n) grows at least like one class and at most like another.
struct ComplexityOrder {
    ComplexityClass at_least = ComplexityClass::constant;
    ComplexityClass at_most = ComplexityClass::quadratic;
    std::string because;  // what was found, and the theorem

    bool is_decided() const { return at_least == at_most; }
};

/// The class of the factor complexity of the language {h^n(w)}.
///
/// For infinite words v h^q(v) h^(2q)(v)... it is Pansiot's theorem (1984; Cassaigne and Nicolas 2010,
/// section 4.7): if only letters that do not grow occur, bounded; if the system is pushy, n^2; else,
/// for a word that is not ultimately periodic, n, n log log n or n log n as the growing letters all grow
/// like rate^n, like n^e rate^n with different e, or with different rates. Letters that vanish do not
/// matter: they make every word at most a constant times as long and can be deleted.
///
/// A language is as complex as the infinite words on both sides where h^r(w) occurs in h^(r+q)(w), up
/// to O(n) factors that lie across the middle. Otherwise the letters that come back give a bound from
/// below, all letters one from above; the class is decided where they meet.
///
/// That p is bounded is shown by p(n) <= n for one n (Morse and Hedlund 1938 for words; Balogh and
/// Bollobas 2005 for any language closed under factors); that it is not by a place that comes
/// back next to growing letters and is no part of an infinite repetition.
///
/// Example: complexity_order(d0l("a", {{'a', "ab"}, {'b', "ba"}})).at_most == ComplexityClass::linear
ComplexityOrder complexity_order(const D0L& system, const Budget& budget = {});

}  // namespace algae
