#include <array>
#include <cmath>
#include <deque>
#include <set>

#include "nature/detail/iterated_functions.hpp"

// Whether the parts of an attractor of similarities lie apart but for their edges: by neighbour maps.
//
// A part f_v(K) seen from the part f_u(K) is h(K) with h = f_u^-1 f_v. From h = f_i^-1 f_j, the larger
// one of the two is divided: f_i^-1 h, or h f_j, or both where they are equally large. Only maps for
// which h(K) can meet K are kept: discs say so. If there are finitely many and the identity is none
// of them, no sequence of them tends to it, so the open set condition holds (Bandt and Graf,
// Self-similar sets 7, Proc. AMS 114, 1992). If the identity is reached, two parts are one. All maps
// are exact, with rational numbers; discs are in doubles with a margin.

namespace algae {

namespace {

/// x -> (a x + b y + e, c x + d y + f), exactly: a, b, c, d, e, f.
using ExactMap = std::array<Rational, 6>;

ExactMap composed(const ExactMap& g, const ExactMap& h) {
    return {g[0] * h[0] + g[1] * h[2],        g[0] * h[1] + g[1] * h[3],
            g[2] * h[0] + g[3] * h[2],        g[2] * h[1] + g[3] * h[3],
            g[0] * h[4] + g[1] * h[5] + g[4], g[2] * h[4] + g[3] * h[5] + g[5]};
}

ExactMap inverse(const ExactMap& g) {
    const Rational area = g[0] * g[3] - g[1] * g[2];
    const Rational a = g[3] / area, b = -g[1] / area, c = -g[2] / area, d = g[0] / area;
    return {a, b, c, d, -(a * g[4] + b * g[5]), -(c * g[4] + d * g[5])};
}

/// The square of the factor of a similarity.
Rational square_of_ratio(const ExactMap& g) { return g[0] * g[0] + g[2] * g[2]; }

/// The map, if it is written with rational numbers.
std::optional<ExactMap> exact_map(const IteratedFunctions::Map& map) {
    ExactMap found;
    if (map.similarity) {
        const auto& [ratio, degrees] = *map.similarity;
        if (!ratio.exact || !degrees.exact) return std::nullopt;
        const Rational quarters = *degrees.exact / Rational(90);
        if (!quarters.is_integer() || !quarters.numerator().fits_int64()) return std::nullopt;
        constexpr std::array cosines{1L, 0L, -1L, 0L};
        const auto turn = static_cast<std::size_t>(quarters.numerator().to_int64() & 3);
        const Rational c = *ratio.exact * Rational(cosines[turn]),
                       s = *ratio.exact * Rational(cosines[(turn + 3) % 4]);
        found = {c, -s, s, c, 0, 0};
    }
    for (std::size_t k = map.similarity ? 4 : 0; k < 6; ++k) {
        if (!map.numbers[k].exact) return std::nullopt;
        found[k] = *map.numbers[k].exact;
    }
    return found;
}

Point image(const ExactMap& g, Point p) {
    return {g[0].to_double() * p.x + g[1].to_double() * p.y + g[4].to_double(),
            g[2].to_double() * p.x + g[3].to_double() * p.y + g[5].to_double()};
}

}  // namespace

Separation separation(const IteratedFunctions& system, const Budget& budget, std::size_t most) {
    if (system.states.size() != 1) return Separation::unknown;
    std::vector<ExactMap> maps, inverses;
    for (const auto& map : system.maps) {
        const auto exact = exact_map(map);
        if (!exact || !map.ratio || square_of_ratio(*exact).is_zero()) return Separation::unknown;
        maps.push_back(*exact);
        inverses.push_back(inverse(*exact));
    }
    // A disc around the attractor: maps take it into itself.
    Point centre;
    for (const ExactMap& map : maps) {
        const Point at = image(map, {0, 0});
        centre.x += at.x / static_cast<double>(maps.size());
        centre.y += at.y / static_cast<double>(maps.size());
    }
    double radius = 0;
    for (const ExactMap& map : maps) {
        const Point at = image(map, centre);
        radius = std::max(radius, std::hypot(at.x - centre.x, at.y - centre.y) /
                                      (1 - std::sqrt(square_of_ratio(map).to_double())));
    }
    const ExactMap identity{1, 0, 0, 1, 0, 0};
    std::set<ExactMap> seen;
    std::deque<ExactMap> open;
    bool coincide = false;
    const auto visit = [&](const ExactMap& map) {
        if (map == identity) coincide = true;
        const Point at = image(map, centre);
        const double own = radius * std::sqrt(square_of_ratio(map).to_double());
        if (std::hypot(at.x - centre.x, at.y - centre.y) > (radius + own) * (1 + 1e-9) + 1e-12)
            return;
        if (seen.insert(map).second) open.push_back(map);
    };
    for (std::size_t i = 0; i < maps.size(); ++i)
        for (std::size_t k = 0; k < maps.size(); ++k)
            if (i != k) visit(composed(inverses[i], maps[k]));
    while (!open.empty() && !coincide) {
        budget.check();
        if (seen.size() > most) return Separation::unknown;
        const ExactMap map = open.front();
        open.pop_front();
        const Rational size = square_of_ratio(map);
        std::vector<ExactMap> first{map};
        if (!(Rational(1) < size)) {
            first.clear();
            for (const ExactMap& smaller : inverses) first.push_back(composed(smaller, map));
        }
        for (const ExactMap& seen_from_part : first)
            if (size < Rational(1))
                visit(seen_from_part);
            else
                for (const ExactMap& part : maps) visit(composed(seen_from_part, part));
    }
    return coincide ? Separation::coincide : Separation::apart;
}

}  // namespace algae
