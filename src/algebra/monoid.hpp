#pragma once
// algebra: the concepts an analysis may target, and the target monoids of general use.

#include <concepts>

namespace algae {

/// A monoid is a value: it may carry context (a modulus, an angle) that its elements do not.
/// `one` is the neutral element, `append` is left := left . right, associative.
/// tests/laws checks the laws for every model.
template <class M>
concept Monoid = std::copyable<M> && std::copyable<typename M::value_type> &&
    std::equality_comparable<typename M::value_type> &&
    requires(const M& m, typename M::value_type& left, const typename M::value_type& right) {
        { m.one() } -> std::same_as<typename M::value_type>;
        { m.append(left, right) } -> std::same_as<void>;
    };

/// Bracketed words are free on letters, juxtaposition and the unary operation [ ]; a target that
/// gives brackets a meaning says what a branch is worth to the axis it grows on.
template <class M>
concept Branching = Monoid<M> && requires(const M& m, const typename M::value_type& twig) {
    { m.branch(twig) } -> std::same_as<typename M::value_type>;
};

}  // namespace algae
