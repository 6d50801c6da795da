#include <algorithm>
#include <cmath>
#include <deque>
#include <unordered_set>

#include "nature/detail/iterated_functions.hpp"
#include "watch/watch.hpp"

// Whether the parts of an attractor of similarities lie apart but for their edges: by neighbour maps.
//
// A part f_v(K_t) seen from the part f_u(K_s) is h(K_t) with h = f_u^-1 f_v. From h = f_i^-1 f_j, the
// larger one of the two is divided: f_i^-1 h, or h f_j, or both where they are equally large. Only
// maps for which h(K_t) can meet K_s are kept: discs say so. If there are finitely many and none is
// the identity between a state and itself, then a part has boundedly many others of about its size
// beside it, so the parts all count and the dimension is that of their ratios (Bandt and Graf,
// Self-similar sets 7, Proc. AMS 114, 1992: the open set condition; Das and Ngai for several
// states). If the identity is reached, two parts are one.
//
// A similarity of the plane is z -> c z + d or z -> c conj(z) + d. Its numbers are exact, in the
// field of the rational numbers and a root of unity; discs are in doubles with a margin.

namespace algae {

namespace {

using Number = CyclotomicNumber;

struct Similarity {
    Number factor, shift;
    bool reflects = false;

    bool operator==(const Similarity&) const = default;
};

/// How a part of the state `to` lies to one of the state `from`.
struct Neighbour {
    std::size_t from = 0, to = 0;
    Similarity map;

    bool operator==(const Neighbour&) const = default;
};

struct HashNeighbour {
    std::size_t operator()(const Neighbour& key) const {
        std::size_t hash = 2 * (key.from * 1'000'003 + key.to) + (key.map.reflects ? 1 : 0);
        for (const Number* number : {&key.map.factor, &key.map.shift}) {
            hash = hash * 0x9E3779B97F4A7C15u ^ hash_value(number->above);
            hash = hash * 0x9E3779B97F4A7C15u ^ hash_value(number->below);
        }
        return hash;
    }
};

/// What can be done with similarities whose numbers lie in a field.
class Similarities {
public:
    explicit Similarities(long order) : field_(order) {}

    const CyclotomicField& field() const { return field_; }

    Number linear(const Similarity& map, const Number& z) const {
        return field_.product(map.factor, map.reflects ? field_.conjugate(z) : z);
    }

    /// First `inner`, then `outer`.
    Similarity composed(const Similarity& outer, const Similarity& inner) const {
        return {linear(outer, inner.factor), field_.sum(linear(outer, inner.shift), outer.shift),
                outer.reflects != inner.reflects};
    }

    Similarity inverse(const Similarity& map) const {
        // Of z -> c conj(z) + d it is z -> conj(z / c) - conj(d / c).
        Number factor = field_.inverse(map.factor);
        Number shift = field_.difference(field_.rational(0), field_.product(factor, map.shift));
        if (map.reflects) {
            factor = field_.conjugate(factor);
            shift = field_.conjugate(shift);
        }
        return {std::move(factor), std::move(shift), map.reflects};
    }

    /// The square of the factor of distances.
    Number size(const Similarity& map) const {
        return field_.product(map.factor, field_.conjugate(map.factor));
    }

    bool is_identity(const Similarity& map) const {
        return !map.reflects && field_.is_zero(map.shift) && map.factor == field_.rational(1);
    }

    /// The map of a file, if it is written with numbers of the field.
    std::optional<Similarity> exactly(const IteratedFunctions::Map& map) const {
        Similarity found;
        const auto value = [&](std::size_t k) {
            const Quantity& number = map.numbers[k];
            return number.exact ? field_.rational(*number.exact)
                                : field_.value_of(number.expression);
        };
        const Number i = field_.zeta(field_.order() / 4);
        if (map.similarity) {
            const auto& [ratio, degrees] = *map.similarity;
            const auto size =
                ratio.exact ? field_.rational(*ratio.exact) : field_.value_of(ratio.expression);
            const auto turn = degrees.exact ? field_.direction(*degrees.exact) : std::nullopt;
            if (!size || !turn) return std::nullopt;
            found.factor = field_.product(*size, *turn);
        } else {
            const auto a = value(0), b = value(1), c = value(2), d = value(3);
            if (!a || !b || !c || !d) return std::nullopt;
            const auto negative = [&](const Number& x) {
                return field_.difference(field_.rational(0), x);
            };
            found.reflects = *d == negative(*a) && *b == *c;
            if (!found.reflects && (*d != *a || *b != negative(*c))) return std::nullopt;
            found.factor = field_.sum(*a, field_.product(i, *c));
        }
        const auto e = value(4), f = value(5);
        if (!e || !f || field_.is_zero(found.factor)) return std::nullopt;
        found.shift = field_.sum(*e, field_.product(i, *f));
        return found;
    }

private:
    CyclotomicField field_;
};

struct Disc {
    std::complex<double> centre;
    double radius = 0;
};

/// A map within the states looked at.
struct Step {
    std::size_t from, to;
    Similarity map, inverse;
    double ratio;
    std::complex<double> of_centre;
};

/// For each state a disc that its maps take the discs of others into.
void find_discs(std::vector<Disc>& discs, const std::vector<Step>& steps) {
    double farthest = 0, largest = 0;
    for (const Step& step : steps) {
        farthest = std::max(farthest, std::abs(step.of_centre - discs[step.from].centre));
        largest = std::max(largest, step.ratio);
    }
    for (Disc& disc : discs) disc.radius = farthest / (1 - largest);
    // Each round holds the sets, and is smaller.
    for (int round = 0; round < 60; ++round) {
        std::vector<double> radii(discs.size(), 0);
        for (const Step& step : steps)
            radii[step.from] =
                std::max(radii[step.from], std::abs(step.of_centre - discs[step.from].centre) +
                                               step.ratio * discs[step.to].radius);
        for (std::size_t k = 0; k < discs.size(); ++k) discs[k].radius = radii[k];
    }
}

/// The field in which all numbers of the maps lie, where there is one.
std::optional<long> common_order(std::span<const IteratedFunctions::Map> maps) {
    std::vector<const Expression*> numbers;
    std::vector<Expression> turns;  // cos degrees
    turns.reserve(maps.size());
    for (const auto& map : maps) {
        for (std::size_t k = map.similarity ? 4 : 0; k < 6; ++k)
            numbers.push_back(&map.numbers[k].expression);
        if (!map.similarity) continue;
        numbers.push_back(&map.similarity->first.expression);
        Expression turn;
        turn.kind = Expression::Kind::call;
        turn.name = "cos";
        turn.operands = {map.similarity->second.expression};
        turns.push_back(std::move(turn));
        numbers.push_back(&turns.back());
    }
    return cyclotomic_order(numbers);
}

}  // namespace

std::optional<Expression> exact_ratio(const IteratedFunctions::Map& map) {
    if (map.ratio) return map.ratio;
    const auto order = common_order(std::span(&map, 1));
    if (!order) return std::nullopt;
    const Similarities similarities(*order);
    const auto exact = similarities.exactly(map);
    if (!exact) return std::nullopt;
    Expression ratio;
    ratio.kind = Expression::Kind::call;
    ratio.name = "sqrt";
    if (const auto square = similarities.field().as_rational(similarities.size(*exact))) {
        ratio.operands = {quantity(*square).expression};
        return ratio;
    }
    Expression sum;
    sum.kind = Expression::Kind::binary;
    sum.name = "+";
    for (const std::size_t k : {std::size_t{0}, std::size_t{2}}) {
        Expression square;
        square.kind = Expression::Kind::binary;
        square.name = "*";
        square.operands = {map.numbers[k].expression, map.numbers[k].expression};
        sum.operands.push_back(std::move(square));
    }
    ratio.operands = {std::move(sum)};
    return ratio;
}

Separation separation(const IteratedFunctions& system, const std::vector<std::size_t>& states,
                      const Budget& budget, std::size_t most) {
    const auto order = common_order(system.maps);
    if (!order) return Separation::unknown;
    const Similarities similarities(*order);
    const CyclotomicField& field = similarities.field();
    std::vector<bool> inside(system.states.size());
    for (const std::size_t state : states) inside[state] = true;

    const std::vector<Box> boxes = attractor_boxes(system);
    std::vector<Disc> discs(system.states.size());
    for (const std::size_t state : states)
        discs[state].centre = {(boxes[state].low.x + boxes[state].high.x) / 2,
                               (boxes[state].low.y + boxes[state].high.y) / 2};
    std::vector<Step> steps;
    std::vector<std::vector<std::size_t>> from(system.states.size());
    for (const auto& map : system.maps) {
        if (!inside[map.from] || !inside[map.to]) continue;
        if (map.ratio && sign(enclosure(*map.ratio, 64)) == 0) continue;  // to a point
        const auto exact = similarities.exactly(map);
        if (!exact) return Separation::unknown;
        const std::complex<double> at = discs[map.to].centre;
        from[map.from].push_back(steps.size());
        steps.push_back({map.from, map.to, *exact, similarities.inverse(*exact),
                         std::abs(field.to_complex(exact->factor)),
                         field.to_complex(exact->factor) * (exact->reflects ? std::conj(at) : at) +
                             field.to_complex(exact->shift)});
    }
    find_discs(discs, steps);

    std::unordered_set<Neighbour, HashNeighbour> seen;
    std::deque<const Neighbour*> open;
    bool coincide = false;
    const auto visit = [&](Neighbour found) {
        if (found.from == found.to && similarities.is_identity(found.map)) coincide = true;
        const std::complex<double> factor = field.to_complex(found.map.factor),
                                   inner = discs[found.to].centre;
        const std::complex<double> at = factor * (found.map.reflects ? std::conj(inner) : inner) +
                                        field.to_complex(found.map.shift);
        const double reach = discs[found.from].radius + std::abs(factor) * discs[found.to].radius;
        if (std::abs(at - discs[found.from].centre) > reach * (1 + 1e-9) + 1e-12) return;
        const auto [place, is_new] = seen.insert(std::move(found));
        if (is_new) open.push_back(&*place);
    };
    for (const std::size_t state : states)
        for (const std::size_t i : from[state])
            for (const std::size_t k : from[state])
                if (i != k)
                    visit({steps[i].to, steps[k].to,
                           similarities.composed(steps[i].inverse, steps[k].map)});
    const Number one = field.rational(1);
    WorkCount neighbours("neighbours");
    while (!open.empty() && !coincide) {
        budget.check();
        neighbours.at(seen.size());
        if (seen.size() > most) return Separation::unknown;
        const Neighbour found = *open.front();
        open.pop_front();
        const auto size = field.compare(similarities.size(found.map), one);
        std::vector<Neighbour> first{found};
        if (size <= 0) {
            first.clear();
            for (const std::size_t i : from[found.from])
                first.push_back(
                    {steps[i].to, found.to, similarities.composed(steps[i].inverse, found.map)});
        }
        for (Neighbour& seen_from_part : first)
            if (size < 0)
                visit(std::move(seen_from_part));
            else
                for (const std::size_t k : from[found.to])
                    visit({seen_from_part.from, steps[k].to,
                           similarities.composed(seen_from_part.map, steps[k].map)});
    }
    return coincide ? Separation::coincide : Separation::apart;
}

namespace {

using Row = std::array<Number, 2>;     // a vector
using Matrix = std::array<Number, 4>;  // by rows

/// A map of a file as a matrix and a vector of real numbers of a field.
struct ExactMap {
    Matrix matrix;
    Row shift;
};

/// What can be done with real matrices of the plane over a field.
class ExactPlane {
public:
    explicit ExactPlane(long order) : field_(order) {}

    const CyclotomicField& field() const { return field_; }

    Number less(const Number& left, const Number& right) const {
        return field_.difference(left, right);
    }
    Number combined(const Number& a, const Number& x, const Number& b, const Number& y) const {
        return field_.sum(field_.product(a, x), field_.product(b, y));
    }
    Number determinant(const Matrix& m) const {
        return less(field_.product(m[0], m[3]), field_.product(m[1], m[2]));
    }
    Matrix product(const Matrix& a, const Matrix& b) const {
        return {combined(a[0], b[0], a[1], b[2]), combined(a[0], b[1], a[1], b[3]),
                combined(a[2], b[0], a[3], b[2]), combined(a[2], b[1], a[3], b[3])};
    }
    Row product(const Matrix& a, const Row& v) const {
        return {combined(a[0], v[0], a[1], v[1]), combined(a[2], v[0], a[3], v[1])};
    }
    Row sum(const Row& a, const Row& b) const {
        return {field_.sum(a[0], b[0]), field_.sum(a[1], b[1])};
    }
    Row difference(const Row& a, const Row& b) const {
        return {less(a[0], b[0]), less(a[1], b[1])};
    }
    Matrix identity() const {
        return {field_.rational(1), field_.rational(0), field_.rational(0), field_.rational(1)};
    }
    Matrix inverse(const Matrix& m) const {
        const Number factor = field_.inverse(determinant(m)), zero = field_.rational(0);
        return {field_.product(factor, m[3]), field_.product(factor, less(zero, m[1])),
                field_.product(factor, less(zero, m[2])), field_.product(factor, m[0])};
    }
    double real(const Number& value) const { return field_.to_complex(value).real(); }
    Point place(const Row& v) const { return {real(v[0]), real(v[1])}; }

    /// Throws Error where a number is not one of the field, or areas vanish.
    ExactMap exactly(const IteratedFunctions::Map& map) const {
        const auto value = [&](const Quantity& number) {
            const auto found =
                number.exact ? field_.rational(*number.exact) : field_.value_of(number.expression);
            if (!found) throw Error(map.name + " has a number that is not known exactly");
            return *found;
        };
        ExactMap found;
        if (map.similarity) {
            const Number ratio = value(map.similarity->first);
            const auto turn = map.similarity->second.exact
                                  ? field_.direction(*map.similarity->second.exact)
                                  : std::nullopt;
            if (!turn) throw Error(map.name + " turns by an angle that is not known exactly");
            const Number back = field_.conjugate(*turn), half = field_.rational(Rational(1, 2));
            const Number c = field_.product(half, field_.product(ratio, field_.sum(*turn, back)));
            const Number s = field_.product(field_.product(half, field_.zeta(-field_.order() / 4)),
                                            field_.product(ratio, less(*turn, back)));
            found.matrix = {c, less(field_.rational(0), s), s, c};
        } else {
            for (std::size_t k = 0; k < 4; ++k) found.matrix[k] = value(map.numbers[k]);
        }
        found.shift = {value(map.numbers[4]), value(map.numbers[5])};
        if (field_.is_zero(determinant(found.matrix)))
            throw Error(map.name + " makes a line or a point of the plane");
        return found;
    }

private:
    CyclotomicField field_;
};

/// The lattice that vectors and their images under a map span.
class SpannedLattice {
public:
    SpannedLattice(const ExactPlane& plane, const Matrix& map, const std::vector<Row>& vectors)
        : plane_(plane) {
        constexpr int most_rounds = 40;
        std::vector<Row> all = vectors;
        for (int round = 0;; ++round) {
            if (round == most_rounds) none();
            basis_ = basis_of(all);
            if (basis_.size() > 2 || basis_.empty()) none();
            all = basis_;
            bool is_closed = basis_.size() == 2;
            for (const Row& vector : basis_) {
                const Row image = plane.product(map, vector);
                if (basis_.size() == 2 && coordinates(image)) continue;
                is_closed = false;
                all.push_back(image);
            }
            if (is_closed) break;
            if (basis_of(all) == basis_) throw Error("all parts lie on a line");
        }
        reduce();
    }

    const std::vector<Row>& basis() const { return basis_; }
    Number area() const {
        return plane_.determinant({basis_[0][0], basis_[0][1], basis_[1][0], basis_[1][1]});
    }

    /// Nothing for what lies beside the lattice.
    std::optional<LatticeSet::Vector> coordinates(const Row& vector) const {
        const CyclotomicField& field = plane_.field();
        const Number whole = area();
        if (field.is_zero(whole)) return std::nullopt;
        const Number factor = field.inverse(whole);
        LatticeSet::Vector found{};
        const std::array<Matrix, 2> replaced{
            Matrix{vector[0], vector[1], basis_[1][0], basis_[1][1]},
            Matrix{basis_[0][0], basis_[0][1], vector[0], vector[1]}};
        for (std::size_t k = 0; k < 2; ++k) {
            const auto value =
                field.as_rational(field.product(factor, plane_.determinant(replaced[k])));
            if (!value || !value->is_integer()) return std::nullopt;
            constexpr std::int64_t largest = std::int64_t{1} << 30;
            if (abs(*value) > Rational(largest))
                throw BoundReached(Bound::digits, "positions in a lattice need too many digits");
            found[k] = value->numerator().to_int64();
        }
        return found;
    }

private:
    [[noreturn]] static void none() { throw Error("positions lie in no lattice of the plane"); }

    std::vector<Row> basis_of(const std::vector<Row>& vectors) const {
        const CyclotomicField& field = plane_.field();
        Integer common = 1;
        for (const Row& vector : vectors)
            for (const Number& number : vector) common = lcm(common, number.below);
        const std::size_t degree = field.degree();
        IntegerMatrix rows(vectors.size(), 2 * degree);
        for (std::size_t i = 0; i < vectors.size(); ++i)
            for (std::size_t k = 0; k < 2; ++k) {
                const Integer times = exact_divide(common, vectors[i][k].below);
                for (std::size_t c = 0; c < degree; ++c)
                    rows(i, k * degree + c) = times * vectors[i][k].above.coefficients[c];
            }
        const IntegerMatrix reduced = lattice_basis(rows);
        std::vector<Row> found;
        for (std::size_t i = 0; i < reduced.rows(); ++i) {
            Row& vector = found.emplace_back(Row{field.rational(0), field.rational(0)});
            for (std::size_t k = 0; k < 2; ++k)
                for (std::size_t c = 0; c < degree; ++c)
                    vector[k] = field.sum(
                        vector[k],
                        field.product(field.rational(Rational(reduced(i, k * degree + c), common)),
                                      field.zeta(static_cast<std::int64_t>(c))));
        }
        return found;
    }

    /// Short vectors (Gauss).
    void reduce() {
        const CyclotomicField& field = plane_.field();
        for (int round = 0; round < 200; ++round) {
            const Point first = plane_.place(basis_[0]), second = plane_.place(basis_[1]);
            const double one = std::hypot(first.x, first.y), two = std::hypot(second.x, second.y);
            if (two < one * (1 - 1e-9)) {
                std::swap(basis_[0], basis_[1]);
                continue;
            }
            const double times =
                std::round((first.x * second.x + first.y * second.y) / (one * one));
            if (times == 0 || !(std::fabs(times) < 1e9)) return;
            const Number factor = field.rational(Rational(static_cast<std::int64_t>(times)));
            const Row shorter = plane_.difference(basis_[1], {field.product(factor, basis_[0][0]),
                                                              field.product(factor, basis_[0][1])});
            const Point found = plane_.place(shorter);
            if (std::hypot(found.x, found.y) >= two * (1 - 1e-9)) return;
            basis_[1] = shorter;
        }
    }

    const ExactPlane& plane_;
    std::vector<Row> basis_;
};

}  // namespace

LatticeSet lattice_set(const IteratedFunctions& system, const Budget& budget) {
    constexpr std::size_t most_states = 300;
    const auto order = common_order(system.maps);
    if (!order) throw Error("numbers are not in one field of roots of unity");
    const ExactPlane plane(*order);
    const CyclotomicField& field = plane.field();
    std::vector<ExactMap> maps;
    for (const auto& map : system.maps) maps.push_back(plane.exactly(map));
    // A first state that does not come back and whose maps keep areas only places the others.
    const bool places = !system.recurrent_states().front() &&
                        std::all_of(system.maps.begin(), system.maps.end(), [](const auto& map) {
                            return map.from != 0 || !(norm(map.map) < 1);
                        });
    const auto first = std::find_if(system.maps.begin(), system.maps.end(),
                                    [&](const auto& map) { return !places || map.from != 0; });
    if (first == system.maps.end()) throw Error("no map comes back");
    const std::size_t first_number = static_cast<std::size_t>(first - system.maps.begin());
    const Matrix factor = plane.inverse(maps[first_number].matrix);  // M

    struct State {
        std::size_t state;
        Matrix turn;
    };
    std::vector<State> states;
    LatticeSet out;
    const auto number = [&](std::size_t state, const Matrix& turn) {
        for (std::size_t k = 0; k < states.size(); ++k)
            if (states[k].state == state && states[k].turn == turn) return k;
        if (states.size() == most_states)
            throw Error("maps differ by more than turns and reflections of a finite group");
        states.push_back({state, turn});
        out.shapes.push_back(state);
        return states.size() - 1;
    };
    std::vector<std::pair<std::size_t, Row>> whole;
    const Row origin{field.rational(0), field.rational(0)};
    if (places)
        for (std::size_t m = 0; m < maps.size(); ++m) {
            if (system.maps[m].from != 0) continue;
            whole.emplace_back(number(system.maps[m].to, maps[m].matrix),
                               plane.difference(maps[m].shift, maps.front().shift));
        }
    else
        whole.emplace_back(number(0, plane.identity()), origin);
    // Of one state, the fixed point of the first map is put to 0.
    Row middle = origin;
    if (system.states.size() == 1) {
        const Matrix& own = maps.front().matrix;
        const Matrix one = plane.identity();
        middle =
            plane.product(plane.inverse({plane.less(one[0], own[0]), plane.less(one[1], own[1]),
                                         plane.less(one[2], own[2]), plane.less(one[3], own[3])}),
                          maps.front().shift);
    }
    std::vector<std::vector<std::pair<std::size_t, Row>>> parts;
    std::vector<Row> vectors;
    for (std::size_t s = 0; s < states.size(); ++s) {
        budget.check();
        const State at = states[s];
        auto& own = parts.emplace_back();
        const Row centre = plane.product(at.turn, middle);
        for (std::size_t m = 0; m < maps.size(); ++m) {
            if (system.maps[m].from != at.state) continue;
            const Matrix turn = plane.product(factor, plane.product(at.turn, maps[m].matrix));
            const std::size_t to = number(system.maps[m].to, turn);
            const Row by = plane.sum(
                plane.product(factor,
                              plane.difference(plane.product(at.turn, maps[m].shift), centre)),
                plane.product(turn, middle));
            own.emplace_back(to, by);
            vectors.push_back(by);
        }
    }
    for (const auto& [state, by] : whole) vectors.push_back(by);
    const SpannedLattice lattice(plane, factor, vectors);
    const auto vector_of = [&](const Row& vector) {
        const auto found = lattice.coordinates(vector);
        if (!found) throw Error("positions lie in no lattice of the plane");
        return *found;
    };
    for (const auto& own : parts) {
        out.parts.emplace_back();
        for (const auto& [state, by] : own) out.parts.back().push_back({state, vector_of(by)});
    }
    for (const auto& [state, by] : whole) out.whole.push_back({state, vector_of(by)});
    for (std::size_t k = 0; k < 2; ++k) {
        out.places[k] = plane.place(lattice.basis()[k]);
        out.scale[k] = vector_of(plane.product(factor, lattice.basis()[k]));
    }
    for (std::size_t k = 0; k < 4; ++k) out.linear[k] = plane.real(factor[k]);
    const Number area = lattice.area();
    out.cell_square = field.as_rational(field.product(area, area));
    return out;
}

}  // namespace algae
