#pragma once

#include <optional>
#include <vector>

#include "base/budget.hpp"
#include "exact/polynomial.hpp"
#include "growth/morphic.hpp"

namespace algae {

/// How |h^n(a)| grows: between two constant multiples of n^exponent * rate^n.
struct MorphicGrowth {
    Polynomial rate;  // irreducible; the rate is its greatest real root
    std::size_t exponent = 0;

    bool operator==(const MorphicGrowth&) const = default;
};

/// The growth of each letter, nothing for letters with empty images. No other letter may have an
/// empty image: then lengths do not shrink, and the order holds for all n, not only for those in a
/// residue class.
///
/// The rate is the greatest Perron root of the components that the letter leads to, the exponent
/// one less than the number of components with that root on a chain (Salomaa and Soittola 1978,
/// II.9; Cassaigne, Mauduit and Nicolas 2008). Equal rates are roots of the same irreducible
/// factor of the characteristic polynomials, so nothing is rounded.
std::vector<std::optional<MorphicGrowth>> morphic_growth(const std::vector<Word>& images,
                                                         const Budget& budget = {});

}  // namespace algae
