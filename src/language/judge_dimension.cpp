#include "dimension/dimension.hpp"
#include "language/detail/judge.hpp"
#include "language/detail/proof.hpp"

// Statements about the dimension of limit sets and of their boundaries: by `exact_dimension`, and exactly.
//
// Ratios of logarithms are compared exactly; the solution of an equation by enclosures that get narrower. Two
// numbers that agree in so many digits without a proof that they are equal leave the statement undecided.

namespace algae {

namespace {

using Status = ExactDimension::Status;

/// Exactly for ratios of logarithms; the solution of an equation is less or greater where enclosures
/// differ in that many digits.
Order compared(const DimensionFormula& formula, const DimensionValue& claimed) {
    if (const LogRatio* const ratio = formula.log_ratio()) return compare(*ratio, claimed);
    for (long bits = 64; bits <= digits_compared * 7; bits *= 2)
        if (const auto known = sign(formula.enclosure(bits) - claimed.enclosure(bits)))
            return *known < 0 ? Order::less : *known > 0 ? Order::greater : Order::equal;
    return Order::unknown;
}

/// Undecided, with how far the comparison went.
Answer open(const steps::LimitSet& said) {
    return {Truth::undecided, nullptr, sentences({Truth::undecided, proof_by(said), {}}, {})};
}

/// That a number known exactly is the claimed one, or at most that.
Answer judge_exact(const DimensionFormula& value, steps::LimitSet said) {
    said.order = compared(value, *said.claimed.value);
    if (said.order == Order::unknown) return open(said);
    return decided(
        said.order == Order::equal || (said.claimed.at_most && said.order == Order::less),
        std::move(said));
}

/// What an upper bound says.
Answer judge_bounded(steps::LimitSet said) {
    const DimensionValue& claimed = *said.claimed.value;
    said.order = exceeds_plane(*said.found) ? compare(DimensionValue(Rational(2)), claimed)
                                            : compared(*said.found->value, claimed);
    if (said.order == Order::less) return decided(said.claimed.at_most, std::move(said));
    if (said.order == Order::equal && said.claimed.at_most) return proved(std::move(said));
    return open(said);
}

template <class Said>
steps::LimitSet limit_set(const Said& said, bool boundary, const Budget& budget) {
    return {said.name,
            std::make_shared<const ExactDimension>(exact_dimension(*said.system, budget)), boundary,
            said.dimension, Order::unknown};
}

}  // namespace

bool exceeds_plane(const ExactDimension& found) {
    return compare(found.value->enclosure(64), Ball(2, 64)) == Order::greater;
}

Answer judge_dimension(const HasDimension& claimed, const Budget& budget) {
    const steps::LimitSet said = limit_set(claimed, false, budget);
    if (said.found->status == Status::exact) return judge_exact(*said.found->value, said);
    if (said.found->status == Status::upper_bound) return judge_bounded(said);
    return open(said);
}

Answer judge_boundary(const BoundaryHasDimension& claimed, const Budget& budget) {
    const steps::LimitSet said = limit_set(claimed, true, budget);
    return said.found->boundary ? judge_exact(*said.found->boundary, said) : open(said);
}

}  // namespace algae
