#include "growth/growth_class.hpp"

#include <algorithm>
#include <numeric>
#include <ostream>

#include "growth/complex_ball.hpp"

namespace algae {

namespace {

/// The order of a component with what it reaches, given those of the components below it.
GrowthOrder order_of(const Component& component, const std::vector<GrowthOrder>& found) {
    GrowthOrder most;
    for (const std::size_t below : component.below)
        if (grows_slower(most, found[below])) most = found[below];
    if (!component.rate) return most;
    const bool exponential = *component.rate != Rate(1);
    const GrowthOrder alone{exponential ? GrowthKind::exponential : GrowthKind::bounded, 0, *component.rate};
    if (most.kind == GrowthKind::zero || most.rate < alone.rate) return alone;
    if (most.rate == alone.rate) {
        ++most.degree;
        if (most.kind == GrowthKind::bounded) most.kind = GrowthKind::polynomial;
    }
    return most;
}

/// exp(2 pi i turn) * rho
ComplexBall turned(const Ball& rho, const Rational& turn, long bits) {
    return {rho * cos_pi(2 * turn, bits), rho * sin_pi(2 * turn, bits)};
}

/// The one of the polynomials, irreducible and different, that has this root.
std::size_t with_root(const std::vector<Polynomial>& polynomials, const Rate& rho, const Rational& turn) {
    std::vector<std::size_t> left(polynomials.size());
    std::iota(left.begin(), left.end(), 0);
    for (long bits = 64; left.size() > 1; bits *= 2) {
        const Ball size = rho.enclosure(bits);
        const ComplexBall root = turned(size, turn, size.bits());
        std::erase_if(left, [&](std::size_t i) { return !value_at(polynomials[i], root).contains_zero(); });
    }
    return left.front();
}

/// How often a factor divides.
unsigned multiplicity(Polynomial value, const Polynomial& factor) {
    unsigned times = 0;
    while (const auto quotient = exact_divide(value, factor)) {
        value = *quotient;
        ++times;
    }
    return times;
}

}  // namespace

std::string to_string(GrowthKind kind) {
    switch (kind) {
        case GrowthKind::zero: return "zero";
        case GrowthKind::bounded: return "bounded";
        case GrowthKind::polynomial: return "polynomial";
        case GrowthKind::exponential: return "exponential";
    }
    return {};
}

std::string GrowthOrder::text() const {
    if (kind == GrowthKind::zero) return "0 from some n on";
    if (kind == GrowthKind::bounded) return "bounded";
    const std::string power = degree == 0 ? "" : degree == 1 ? "n" : "n^" + std::to_string(degree);
    if (kind == GrowthKind::polynomial) return power;
    const std::string base = rate.integer() ? to_string(*rate.integer()) : rate.exact();
    const bool atom = rate.integer() || (base.starts_with("sqrt(") && base.find(')') == base.size() - 1);
    return (degree == 0 ? "" : power + "*") + (atom ? base : "(" + base + ")") + "^n";
}

bool grows_slower(const GrowthOrder& a, const GrowthOrder& b) {
    if (a.kind != b.kind) return a.kind < b.kind;
    if (a.rate != b.rate) return a.rate < b.rate;
    return a.degree < b.degree;
}

std::vector<GrowthOrder> letter_orders(const Components& components) {
    std::vector<GrowthOrder> found;
    for (const Component& component : components.list) found.push_back(order_of(component, found));
    std::vector<GrowthOrder> letters;
    for (const std::size_t component : components.of_letter) letters.push_back(found[component]);
    return letters;
}

GrowthOrder growth_order(const D0L& system, const std::vector<GrowthOrder>& letters) {
    GrowthOrder most;
    const std::vector<Integer> counts = axiom_counts(system);
    for (std::size_t i = 0; i < counts.size(); ++i)
        if (!counts[i].is_zero() && grows_slower(most, letters[i])) most = letters[i];
    return most;
}

Integer limit_period(const Polynomial& annihilator, const GrowthOrder& order, const Components& components) {
    if (order.kind == GrowthKind::zero) return 1;
    Integer period = 1;
    if (order.kind != GrowthKind::exponential) {
        for (const auto& [factor, times] : factorise(annihilator).powers)
            if (times == order.degree + 1)
                if (const auto root = cyclotomic_order(factor)) period = lcm(period, Integer(*root));
        return period;
    }
    // The other roots of the size of rho are rho times roots of unity (Perron and Frobenius): the
    // h-th ones for a component of rate rho and cyclicity h. Each is a root of one of its factors.
    for (const Component& component : components.list) {
        if (!component.rate || *component.rate != order.rate) continue;
        std::vector<Polynomial> factors;
        for (const auto& power : component.characteristic.powers) factors.push_back(power.factor);
        const std::uint64_t h = component.cyclicity;
        for (std::uint64_t j = 1; 2 * j <= h; ++j) {
            const std::uint64_t primitive = h / std::gcd(h, j);
            if (remainder(period, Integer(primitive)).is_zero()) continue;
            const std::size_t found = with_root(factors, order.rate, Rational(j, h));
            if (multiplicity(annihilator, factors[found]) == order.degree + 1) period = lcm(period, Integer(primitive));
        }
    }
    return period;
}

GrowthClass growth_class(const D0L& system, const Components& components, const Recurrence& recurrence) {
    GrowthClass found;
    found.order = growth_order(system, letter_orders(components));
    if (found.order.kind == GrowthKind::zero || found.order.kind == GrowthKind::bounded)
        found.preperiod = recurrence.exceptions;
    found.period = limit_period(recurrence.polynomial, found.order, components);
    return found;
}

GrowthClass growth_class(const D0L& system, const Budget& budget) {
    return growth_class(system, components(growth_matrix(system), budget), shortest_recurrence(system, budget));
}

}  // namespace algae
