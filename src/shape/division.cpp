#include "shape/division.hpp"

#include <algorithm>

#include "base/error.hpp"
#include "system/expression.hpp"

namespace algae {

std::vector<Rational> lengths_of(const Rational& extent, const std::vector<Share>& sizes) {
    Rational lengths = 0, shares = 0;
    for (const Share& size : sizes) {
        if (sign(size.value) <= 0)
            throw Error("expected sizes above 0, found " + shortest_text(size.value) +
                        (size.relative ? "r" : ""));
        (size.relative ? shares : lengths) += size.value;
    }
    const Rational rest = extent - lengths;
    if (sign(rest) < 0)
        throw Error("expected sizes that add up to at most " + shortest_text(extent) + ", found " +
                    shortest_text(lengths));
    if (!shares.is_zero() && rest.is_zero())
        throw Error("expected sizes that leave something of " + shortest_text(extent) +
                    " for the relative ones, found " + shortest_text(lengths));
    std::vector<Rational> parts;
    for (const Share& size : sizes)
        parts.push_back(size.relative ? size.value * rest / shares : size.value);
    return parts;
}

Integer parts_that_fit(const Rational& extent, const Rational& size) {
    if (sign(size) <= 0) throw Error("expected a size above 0, found " + shortest_text(size));
    if (size > extent)
        throw Error("expected a size of at most " + shortest_text(extent) + ", found " +
                    shortest_text(size));
    return floor(extent / size);
}

}  // namespace algae
