#pragma once

#include "algebra/monoid.hpp"

namespace algae {

/// A monoid with a commutative addition over which `append` distributes: what a letter with several
/// successors is folded into.
template <class S>
concept Semiring = Monoid<S> &&
    requires(const S& s, typename S::value_type& left, const typename S::value_type& right) {
        { s.zero() } -> std::same_as<typename S::value_type>;
        { s.add(left, right) } -> std::same_as<void>;
    };

}  // namespace algae
