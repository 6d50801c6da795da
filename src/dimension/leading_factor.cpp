#include "dimension/leading_factor.hpp"

#include <cmath>
#include <map>
#include <numbers>
#include <optional>

#include "dimension/displacement.hpp"
#include "growth/annihilator.hpp"
#include "growth/growth_matrix.hpp"

namespace algae {

namespace {

constexpr long root_bits = 192;

struct Candidate {
    std::size_t power;  // of the factorisation
    ComplexBall root, eigenvalue;
    unsigned multiplicity;

    double size() const {
        return std::hypot(eigenvalue.real.midpoint(), eigenvalue.imaginary.midpoint());
    }
    Ball square() const {
        return eigenvalue.real * eigenvalue.real + eigenvalue.imaginary * eigenvalue.imaginary;
    }
};

bool is_one(const ComplexBall& number) {
    return number.real.contains(Rational(1)) && number.imaginary.contains(Rational(0));
}

}  // namespace

LeadingFactor::LeadingFactor(const Unfolding& unfolding, const std::vector<bool>& moving,
                             const CyclotomicRing& ring, const Budget& budget)
    : ring_(ring), places_(unfolding.size(), 0) {
    for (std::size_t p = 0; p < unfolding.size(); ++p)
        if (moving[p]) {
            places_[p] = pieces_.size();
            pieces_.push_back(p);
        }
    if (pieces_.empty()) throw Error("the turtle always comes back to where it began");
    if (pieces_.size() * ring.degree() > Displacement::largest_matrix)
        throw BoundReached(Bound::method, "the ways of its pieces need " +
                                              std::to_string(pieces_.size() * ring.degree()) +
                                              " coordinates, more than " +
                                              std::to_string(Displacement::largest_matrix));
    for (const std::size_t piece : pieces_) {
        std::vector<Entry>& row = rows_.emplace_back();
        for (const Unfolding::Item& item : unfolding.paths[piece])
            if (moving[item.piece]) row.push_back({places_[item.piece], item.heading});
        widest_ = std::max(widest_, row.size());
    }
    if (ring.degree() > 1)
        times_ = static_cast<long>(
            std::ceil((2.0 * static_cast<double>(widest_) + 1) /
                      (2 * std::sin(std::numbers::pi / static_cast<double>(ring.order())))));

    std::vector<CyclotomicInteger> ways;
    for (const std::size_t piece : pieces_) ways.push_back(unfolding.moves[piece]);
    const Polynomial annihilator = annihilator_of(ways, budget);
    choose(annihilator, unfolding.phases);

    // u: what the other factors leave of the ways, by Horner's rule.
    const Polynomial others = *exact_divide(annihilator, factor_);
    std::vector<CyclotomicInteger> part(ways.size(), ring_.zero());
    for (std::size_t k = others.coefficients().size(); k-- > 0;) {
        budget.check();
        part = next(part);
        for (std::size_t i = 0; i < part.size(); ++i) {
            CyclotomicInteger term = ways[i];
            ring_.scale(term, others.coefficients()[k]);
            ring_.add(part[i], term);
        }
    }
    for (long i = 0; i < factor_.degree(); ++i) {
        powers_.push_back(part);
        part = next(part);
        budget.check();
    }
}

/// A times the ways.
std::vector<CyclotomicInteger> LeadingFactor::next(
    const std::vector<CyclotomicInteger>& ways) const {
    std::vector<CyclotomicInteger> out;
    for (std::size_t i = 0; i < ways.size(); ++i) {
        CyclotomicInteger sum = ring_.rotate(ways[i], 1);
        ring_.scale(sum, Integer(times_));
        for (const Entry& entry : rows_[i])
            ring_.add_rotated(sum, ways[entry.place], entry.heading);
        out.push_back(std::move(sum));
    }
    return out;
}

Polynomial LeadingFactor::annihilator_of(const std::vector<CyclotomicInteger>& ways,
                                         const Budget& budget) const {
    // The transpose of A over the integers, as `annihilator` wants a row times a matrix.
    const std::size_t degree = ring_.degree();
    GrowthMatrix matrix;
    std::vector<std::map<std::size_t, Integer>> rows(ways.size() * degree);
    const auto add = [&](std::size_t from, std::size_t to, std::int64_t heading,
                         const Integer& times) {
        for (std::size_t j = 0; j < degree; ++j) {
            const auto power = ring_.power(static_cast<long>(heading) + static_cast<long>(j));
            for (std::size_t i = 0; i < degree; ++i)
                if (power[i] != 0)
                    rows[from * degree + j][to * degree + i] += times * Integer(power[i]);
        }
    };
    for (std::size_t i = 0; i < ways.size(); ++i) {
        if (times_ != 0) add(i, i, 1, Integer(times_));
        for (const Entry& entry : rows_[i]) add(entry.place, i, entry.heading, 1);
    }
    for (const auto& row : rows) {
        auto& entries = matrix.rows.emplace_back();
        for (const auto& [column, times] : row)
            if (!times.is_zero()) entries.push_back({column, times});
    }
    std::vector<Integer> start;
    for (const CyclotomicInteger& way : ways)
        start.insert(start.end(), way.coefficients.begin(), way.coefficients.end());
    return annihilator(start, matrix, budget);
}

void LeadingFactor::choose(const Polynomial& annihilator, std::size_t phases) {
    if (annihilator.degree() < 1) throw Error("the turtle always comes back to where it began");
    const Factorisation factors = factorise(annihilator);
    const ComplexBall centre = shift(root_bits);
    std::vector<Candidate> candidates;
    for (std::size_t k = 0; k < factors.powers.size(); ++k)
        for (const Root& root : roots(factors.powers[k].factor, root_bits)) {
            const ComplexBall number{root.real, root.imaginary};
            const ComplexBall rest{number.real - centre.real, number.imaginary - centre.imaginary};
            const Candidate candidate{k, number, rest, factors.powers[k].exponent};
            if (candidate.size() <= static_cast<double>(widest_) + 0.25)
                candidates.push_back(candidate);
        }
    const Candidate* largest = nullptr;
    for (const Candidate& candidate : candidates)
        if (!largest || candidate.size() > largest->size()) largest = &candidate;
    if (!largest || compare(largest->square(), Ball(1, root_bits)) != Order::greater)
        throw Error(
            "the way from the beginning of the curve to its end does not grow exponentially");
    const Candidate* chosen = nullptr;
    for (const Candidate& candidate : candidates) {
        if (compare(candidate.square(), largest->square()) == Order::less) continue;
        if (candidate.multiplicity > 1)
            throw Error(
                "lengths grow like a power of the number of the generation times that of a "
                "factor, so parts do not become similar");
        const ComplexBall quotient = candidate.eigenvalue / largest->eigenvalue;
        if (!is_one(power(quotient, phases)))
            throw EqualFactors(
                "several scaling factors are equally large, so parts do not become similar");
        const auto degree_of = [&](const Candidate& c) {
            return factors.powers[c.power].factor.degree();
        };
        if (!chosen || degree_of(candidate) < degree_of(*chosen) ||
            (degree_of(candidate) == degree_of(*chosen) &&
             candidate.eigenvalue.real.midpoint() > chosen->eigenvalue.real.midpoint() + 1e-9))
            chosen = &candidate;
    }
    factor_ = factors.powers[chosen->power].factor;
    near_ = chosen->root;
}

ComplexBall LeadingFactor::shift(long bits) const {
    const Rational part(2, Integer(ring_.order()));
    return {cos_pi(part, bits) * Ball(times_, bits), sin_pi(part, bits) * Ball(times_, bits)};
}

ComplexBall LeadingFactor::root(long bits) const {
    for (const Root& root : roots(factor_, bits))
        if (root.real.overlaps(near_.real) && root.imaginary.overlaps(near_.imaginary))
            return {root.real, root.imaginary};
    throw Error("a root of a polynomial was lost");
}

ComplexBall LeadingFactor::eigenvalue(long bits) const {
    const ComplexBall whole = root(bits), part = shift(bits);
    return {whole.real - part.real, whole.imaginary - part.imaginary};
}

}  // namespace algae
