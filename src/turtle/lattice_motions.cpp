#include "turtle/lattice_motions.hpp"

namespace algae {

LatticeMotions::LatticeMotions(std::int64_t order, bool reaching)
    : ring_(static_cast<long>(order)), reaching_(reaching) {}

CyclotomicInteger LatticeMotions::reach_of(const CyclotomicInteger& point, std::int64_t direction) const {
    CyclotomicInteger along = ring_.rotate(point, static_cast<long>(-direction));
    ring_.add(along, ring_.conjugate(along));
    return along;
}

//> append
void LatticeMotions::append(value_type& left, const value_type& right) const {
    const long m = ring_.order();
    if (!right.reach.empty()) {
        const bool first = left.reach.empty();
        if (first) left.reach.resize(static_cast<std::size_t>(m));
        for (long k = 0; k < m; ++k) {
            CyclotomicInteger candidate = reach_of(left.move, k);
            const long local = static_cast<long>((k - left.turn + m) % m);
            ring_.add(candidate, right.reach[static_cast<std::size_t>(local)]);
            CyclotomicInteger& known = left.reach[static_cast<std::size_t>(k)];
            if (first || ring_.compare_real(known, candidate) < 0) known = std::move(candidate);
        }
    }
    ring_.add_rotated(left.move, right.move, static_cast<long>(left.turn));
    left.turn = (left.turn + right.turn) % m;
    left.segments += right.segments;
}
//< append

LatticeMotions::value_type LatticeMotions::step(bool drawn) const {
    value_type value{ring_.one(), 0, drawn ? 1 : 0, {}};
    if (!drawn || !reaching_) return value;
    for (long k = 0; k < ring_.order(); ++k) {
        CyclotomicInteger ahead = reach_of(value.move, k);  // the end; the start reaches 0
        if (ring_.real_part_sign(ahead) < 0) ahead = ring_.zero();
        value.reach.push_back(std::move(ahead));
    }
    return value;
}

LatticeMotions::value_type LatticeMotions::turned(std::int64_t units) const {
    value_type value = one();
    const long m = ring_.order();
    value.turn = ((units % m) + m) % m;
    return value;
}

}  // namespace algae
