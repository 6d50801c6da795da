#include <algorithm>
#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/strong_components.hpp>
#include <cmath>
#include <deque>
#include <numbers>
#include <set>
#include <tuple>

#include "dimension/detail/recurrent_set.hpp"
#include "watch/watch.hpp"

// The topological boundary of the whole recurrent set, by the cells of a tiling.
//
// Where parts meet is not where the set ends: parts of several components overlap, the parts of an
// axiom cover each other's boundaries. So the set K is laid over a tiling of the plane that is
// independent of it and that the same factor refines. Let all positions lie in a lattice L of the
// plane that nu = mu zeta^j maps to itself; j is chosen so that there is one (Levy's curve has it
// for the frame that turns by an eighth in each level). With a complete system D of residues of L
// modulo nu L, the attractor T of nu T = union of T + d over D has copies T + z, z in L, that cover
// the plane, each point a bounded number of times, and every cell of level n + 1 has one parent.
// (Bandt, arXiv 2503.10430, counts boundaries of tiles in this way.)
//
// 1. `pairs`: all ways in which a piece lies to a cell that it meets: finitely many, because L is
//    discrete. Discs say who may meet; a pair meets exactly if an infinite path begins at it.
// 2. `states`: a cell with the pieces that meet it. Its cells of the next level follow from this
//    set. A state that never leads to a cell without pieces is full: as K is closed and cells become
//    small, the cell lies in K. Otherwise it is partly covered.
// 3. A cell that meets K and is not full is within its diameter of the boundary, and every point of
//    the boundary lies in such a cell of each level. So the rate at which they multiply gives the box
//    dimension of the boundary, and its Hausdorff dimension: they are a graph-directed set of cells
//    that cover each point a bounded number of times (Mauldin and Williams 1988).

namespace algae {

namespace {

using Vector = Displacement::Vector;

/// Coordinates in the basis of a lattice of the plane.
struct Place {
    std::int64_t x = 0, y = 0;
    auto operator<=>(const Place&) const = default;
    friend Place operator+(Place a, Place b) { return {a.x + b.x, a.y + b.y}; }
    friend Place operator-(Place a, Place b) { return {a.x - b.x, a.y - b.y}; }
};

constexpr std::int64_t largest_coordinate = std::int64_t{1} << 30;
constexpr std::int64_t most_digits = 4096;

/// A lattice of the plane that nu = mu zeta^shift maps to itself and that holds all positions.
struct Lattice {
    std::int64_t shift = 0;
    std::vector<Vector> basis;  // two vectors
    std::array<std::complex<double>, 2> values;
    std::array<Place, 2> scale;  // nu times the basis
    std::complex<double> factor;

    std::complex<double> value(Place at) const {
        return static_cast<double>(at.x) * values[0] + static_cast<double>(at.y) * values[1];
    }
};

/// A piece turned by a heading.
struct Turned {
    std::size_t piece;
    std::int64_t heading;
    auto operator<=>(const Turned&) const = default;
};

/// nu times a vector.
Vector refined(const Displacement& displacement, const Vector& vector, std::int64_t shift) {
    return displacement.turned(displacement.scaled(vector), shift);
}

/// The turned pieces that the axiom leads to in a frame that turns by `shift` in each level, and the
/// positions that they are moved by.
struct Reached {
    std::set<Turned> pieces;
    std::vector<Vector> moves;
};

Reached reached_in(const RecurrentSet& set, std::int64_t shift, const Budget& budget) {
    Reached out;
    std::set<Vector> moves;
    std::deque<Turned> open;
    const auto visit = [&](std::size_t piece, std::int64_t heading) {
        const Turned found{piece, normal_heading(heading, set.order())};
        if (out.pieces.insert(found).second) open.push_back(found);
    };
    const Displacement& displacement = set.displacement();
    for (const RecurrentSet::Part& part : set.axiom()) {
        Vector move = part.offset;
        displacement.subtract(move, set.axiom().front().offset);
        moves.insert(std::move(move));
        visit(part.piece, part.heading);
    }
    while (!open.empty()) {
        budget.check();
        const Turned at = open.front();
        open.pop_front();
        for (const RecurrentSet::Part& part : set.parts(at.piece)) {
            moves.insert(displacement.turned(part.offset, at.heading + shift));
            visit(part.piece, at.heading + shift + part.heading);
        }
    }
    moves.erase(displacement.zero());
    out.moves.assign(moves.begin(), moves.end());
    return out;
}

IntegerMatrix rows_of(const std::vector<Vector>& vectors, std::size_t columns) {
    IntegerMatrix out(vectors.size(), columns);
    for (std::size_t i = 0; i < vectors.size(); ++i)
        for (std::size_t k = 0; k < columns; ++k) out(i, k) = Integer(vectors[i][k]);
    return out;
}

/// A vector as a combination of two independent ones, if it is one.
std::optional<std::array<Rational, 2>> shares(const std::vector<Vector>& basis,
                                              const Vector& vector) {
    for (std::size_t i = 0; i < vector.size(); ++i)
        for (std::size_t k = i + 1; k < vector.size(); ++k) {
            const auto minor = [&](const Vector& a, const Vector& b) {
                return Integer(a[i]) * Integer(b[k]) - Integer(a[k]) * Integer(b[i]);
            };
            const Integer whole = minor(basis[0], basis[1]);
            if (whole.is_zero()) continue;
            const std::array found{Rational(minor(vector, basis[1]), whole),
                                   Rational(minor(basis[0], vector), whole)};
            for (std::size_t c = 0; c < vector.size(); ++c)
                if (found[0] * Rational(basis[0][c]) + found[1] * Rational(basis[1][c]) !=
                    Rational(vector[c]))
                    return std::nullopt;
            return found;
        }
    return std::nullopt;
}

/// Coordinates of a vector in two independent ones; nothing if they are not whole.
std::optional<Place> coordinates(const std::vector<Vector>& basis, const Vector& vector) {
    const auto found = shares(basis, vector);
    if (!found || !(*found)[0].is_integer() || !(*found)[1].is_integer()) return std::nullopt;
    const Integer x = (*found)[0].numerator(), y = (*found)[1].numerator();
    if (!x.fits_int64() || !y.fits_int64()) return std::nullopt;
    const Place at{x.to_int64(), y.to_int64()};
    if (std::abs(at.x) > largest_coordinate || std::abs(at.y) > largest_coordinate)
        throw BoundReached(Bound::digits, "positions in a lattice need too many digits");
    return at;
}

/// Two vectors of the same lattice that are as short as can be (Gauss).
void reduce(std::vector<Vector>& basis, const Displacement& displacement) {
    for (int round = 0; round < 200; ++round) {
        const auto first = displacement.value(basis[0]), second = displacement.value(basis[1]);
        if (std::abs(second) < std::abs(first) * (1 - 1e-9)) {
            std::swap(basis[0], basis[1]);
            continue;
        }
        const double times = std::round((second / first).real());
        if (times == 0 || !(std::abs(times) < 1e9)) return;
        if (std::abs(second - times * first) >= std::abs(second) * (1 - 1e-9)) return;
        for (std::size_t i = 0; i < basis[1].size(); ++i)
            basis[1][i] -= static_cast<std::int64_t>(times) * basis[0][i];
    }
}

/// The lattice of all positions in this frame, if it is one of the plane.
std::optional<Lattice> lattice_in(const RecurrentSet& set, const Reached& reached,
                                  std::int64_t shift) {
    const Displacement& displacement = set.displacement();
    const std::size_t columns = displacement.rank();
    if (reached.moves.empty()) return std::nullopt;
    std::vector<Vector> vectors = reached.moves;
    for (std::size_t size = 0;;) {
        const IntegerMatrix rows = lattice_basis(rows_of(vectors, columns));
        if (rows.rows() != 2 && rows.rows() != 1) return std::nullopt;
        std::vector<Vector> basis;
        for (std::size_t i = 0; i < rows.rows(); ++i) {
            basis.emplace_back();
            for (std::size_t k = 0; k < columns; ++k) {
                if (!rows(i, k).fits_int64()) return std::nullopt;
                basis.back().push_back(rows(i, k).to_int64());
            }
        }
        vectors = basis;
        bool is_closed = true;
        for (const Vector& vector : basis) {
            const Vector image = refined(displacement, vector, shift);
            if (basis.size() == 2 && coordinates(basis, image)) continue;
            vectors.push_back(image);
            is_closed = false;
        }
        if (is_closed) {
            vectors = basis;
            break;
        }
        if (++size > 64) return std::nullopt;
    }
    Lattice out;
    out.shift = shift;
    out.basis = std::move(vectors);
    reduce(out.basis, displacement);
    for (std::size_t i = 0; i < 2; ++i) {
        out.values[i] = displacement.value(out.basis[i]);
        const auto image = coordinates(out.basis, refined(displacement, out.basis[i], shift));
        if (!image) return std::nullopt;
        out.scale[i] = *image;
    }
    const double area = (std::conj(out.values[0]) * out.values[1]).imag();
    if (std::abs(area) < 1e-3 * std::norm(out.values[0])) return std::nullopt;  // all on a line
    out.factor =
        displacement.factor() * std::polar(1.0, 2 * std::numbers::pi * static_cast<double>(shift) /
                                                    static_cast<double>(set.order()));
    return out;
}

Place place_of(const LatticeSet::Vector& vector) { return {vector[0], vector[1]}; }

/// Residues of the lattice modulo nu, each by its shortest vector.
std::vector<Place> residues(const LatticeSet& lattice) {
    const std::int64_t count = std::abs(lattice.determinant());
    if (count > most_digits)
        throw BoundReached(Bound::method, "a cell has " + std::to_string(count) +
                                              " parts, more than " + std::to_string(most_digits));
    for (std::int64_t side = 2;; side *= 2) {
        std::vector<Place> near;
        for (std::int64_t x = -side; x <= side; ++x)
            for (std::int64_t y = -side; y <= side; ++y) near.push_back({x, y});
        const auto far = [&](Place at) {
            const Point found = lattice.place({at.x, at.y, 0});
            return std::hypot(found.x, found.y);
        };
        std::stable_sort(near.begin(), near.end(),
                         [&](Place a, Place b) { return far(a) < far(b) - 1e-9; });
        std::set<std::array<std::int64_t, 2>> seen;
        std::vector<Place> found;
        for (const Place at : near)
            if (seen.insert(residue(lattice, {at.x, at.y, 0})).second) found.push_back(at);
        if (static_cast<std::int64_t>(found.size()) == count) return found;
    }
}

class CellCensus {
public:
    CellCensus(const LatticeSet& set, const Budget& budget, std::size_t most)
        : set_(set), budget_(budget), most_(most), digits_(residues(set)), with_cell_(set) {
        // The cell is one more state.
        auto& cell = with_cell_.parts.emplace_back();
        for (const Place digit : digits_) cell.push_back({set.parts.size(), {digit.x, digit.y, 0}});
        discs_ = discs_of(with_cell_);
        find_pairs();
        leave_out_dead_ends();
        find_states();
        find_full();
    }

    CellGrowth growth(CellQuestion question) const {
        CellGrowth out;
        out.kinds = states_.size();
        out.has_interior = std::find(full_.begin(), full_.end(), true) != full_.end();
        if (question == CellQuestion::boundary)
            out.boundary = boundary_rate();
        else
            std::tie(out.area_low, out.area_high) = area();
        return out;
    }

private:
    struct Pair {
        std::size_t turned;
        Place at;                                               // seen from the cell
        std::vector<std::pair<std::size_t, std::size_t>> next;  // part of the cell, pair
    };

    std::complex<double> value(Place at) const {
        const Point found = set_.place({at.x, at.y, 0});
        return {found.x, found.y};
    }

    Place scaled(Place at) const { return place_of(set_.scaled({at.x, at.y, 0})); }

    bool may_meet(std::size_t turned, Place at) const {
        return std::abs(value(at) + discs_[turned].centre - discs_.back().centre) <=
               discs_[turned].radius + discs_.back().radius;
    }

    std::size_t number(std::size_t turned, Place at) {
        const auto [place, is_new] = numbers_.try_emplace({turned, at}, pairs_.size());
        if (is_new) {
            if (pairs_.size() == most_)
                throw BoundReached(Bound::method, "more than " + std::to_string(most_) +
                                                      " ways in which a part may meet a cell");
            pairs_.push_back({turned, at, {}});
            if (pairs_.size() % 1024 == 0)
                budget_.check_memory(pairs_.size() * 400, "the parts that meet a cell");
        }
        return place->second;
    }

    void find_pairs() {
        // All cells that a piece of the axiom may meet.
        const std::complex<double> first = value({1, 0}), second = value({0, 1});
        const double area = (std::conj(first) * second).imag();
        for (const LatticeSet::Part& part : set_.whole) {
            const double reach = discs_.back().radius + discs_[part.state].radius;
            const Place by = place_of(part.by);
            const std::complex<double> middle =
                value(by) + discs_[part.state].centre - discs_.back().centre;
            // Coordinates of the middle, and how far a disc goes in each of them.
            const double x = (std::conj(middle) * second).imag() / area;
            const double y = (std::conj(first) * middle).imag() / area;
            const double across = reach * std::abs(second / area) + 1;
            const double up = reach * std::abs(first / area) + 1;
            if (across * up > 1e7)
                throw BoundReached(Bound::method, "the set meets more than 10000000 cells");
            const auto whole = [](double at) { return static_cast<std::int64_t>(std::floor(at)); };
            for (std::int64_t i = whole(x - across); i <= whole(x + across); ++i)
                for (std::int64_t k = whole(y - up); k <= whole(y + up); ++k) {
                    const Place seen = by - Place{i, k};
                    if (may_meet(part.state, seen))
                        starts_[{i, k}].push_back(number(part.state, seen));
                }
        }
        WorkCount done("pairs of cells");
        for (std::size_t k = 0; k < pairs_.size(); ++k) {
            if (k % 256 == 0) budget_.check();
            done.at(k);
            const std::size_t turned = pairs_[k].turned;
            const Place at = scaled(pairs_[k].at);
            std::vector<std::pair<std::size_t, std::size_t>> next;
            for (const LatticeSet::Part& part : set_.parts[turned])
                for (std::size_t d = 0; d < digits_.size(); ++d) {
                    const Place seen = at + place_of(part.by) - digits_[d];
                    if (may_meet(part.state, seen)) next.emplace_back(d, number(part.state, seen));
                }
            pairs_[k].next = std::move(next);
        }
    }

    void leave_out_dead_ends() {
        std::vector<std::vector<std::size_t>> before(pairs_.size());
        std::vector<std::size_t> left(pairs_.size(), 0), dead;
        for (std::size_t k = 0; k < pairs_.size(); ++k) {
            left[k] = pairs_[k].next.size();
            for (const auto& [digit, next] : pairs_[k].next) before[next].push_back(k);
            if (left[k] == 0) dead.push_back(k);
        }
        for (std::size_t i = 0; i < dead.size(); ++i)
            for (const std::size_t k : before[dead[i]])
                if (--left[k] == 0) dead.push_back(k);
        const auto is_dead = [&](std::size_t pair) { return left[pair] == 0; };
        for (Pair& pair : pairs_)
            std::erase_if(pair.next, [&](const auto& next) { return is_dead(next.second); });
        for (auto& [cell, own] : starts_) std::erase_if(own, is_dead);
    }

    static constexpr std::size_t nowhere = ~std::size_t{0};

    std::size_t state_of(std::vector<std::size_t> pairs) {
        if (pairs.empty()) return nowhere;
        std::sort(pairs.begin(), pairs.end());
        pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
        const std::size_t size = pairs.size();
        const auto [place, is_new] = state_numbers_.try_emplace(std::move(pairs), states_.size());
        if (is_new) {
            if (states_.size() == most_)
                throw BoundReached(Bound::method,
                                   "more than " + std::to_string(most_) +
                                       " kinds of cells by the parts that meet them");
            held_ += 120 + 8 * (size + digits_.size());
            if (states_.size() % 256 == 0) budget_.check_memory(held_, "the kinds of cells");
            states_.push_back({});
            sets_.push_back(&place->first);
        }
        return place->second;
    }

    void find_states() {
        for (auto& [cell, own] : starts_)
            if (const std::size_t state = state_of(own); state != nowhere) begin_.push_back(state);
        std::vector<std::vector<std::size_t>> parts(digits_.size());
        WorkCount done("states of cells");
        for (std::size_t k = 0; k < states_.size(); ++k) {
            if (k % 64 == 0) budget_.check();
            done.at(k);
            for (auto& own : parts) own.clear();
            for (const std::size_t pair : *sets_[k])
                for (const auto& [digit, next] : pairs_[pair].next) parts[digit].push_back(next);
            std::vector<std::size_t> next;
            for (const auto& own : parts) next.push_back(state_of(own));
            states_[k] = std::move(next);
        }
    }

    /// All but those that lead to a cell without pieces.
    void find_full() {
        full_.assign(states_.size(), true);
        std::vector<std::vector<std::size_t>> before(states_.size());
        std::vector<std::size_t> open;
        for (std::size_t k = 0; k < states_.size(); ++k)
            for (const std::size_t next : states_[k]) {
                if (next != nowhere) {
                    before[next].push_back(k);
                } else if (full_[k]) {
                    full_[k] = false;
                    open.push_back(k);
                }
            }
        while (!open.empty()) {
            const std::size_t k = open.back();
            open.pop_back();
            for (const std::size_t b : before[k])
                if (full_[b]) {
                    full_[b] = false;
                    open.push_back(b);
                }
        }
    }

    /// The rate at which the cells multiply that are touched and not full: the largest of those of
    /// the strongly connected components of their states.
    Rate boundary_rate() const {
        boost::adjacency_list<boost::vecS, boost::vecS, boost::directedS> graph(states_.size());
        for (std::size_t k = 0; k < states_.size(); ++k)
            for (const std::size_t next : states_[k])
                if (!full_[k] && next != nowhere && !full_[next]) boost::add_edge(k, next, graph);
        std::vector<std::size_t> component(states_.size());
        const std::size_t count = boost::strong_components(
            graph,
            boost::make_iterator_property_map(component.begin(), get(boost::vertex_index, graph)));
        std::vector<std::vector<std::size_t>> members(count);
        for (std::size_t k = 0; k < states_.size(); ++k)
            if (!full_[k]) members[component[k]].push_back(k);
        Rate best(1);
        for (const auto& own : members) {
            budget_.check();
            const GrowthMatrix matrix = lumped(own, component);
            if (matrix.size() == 0) continue;
            if (most_of(matrix) < best.enclosure(64).midpoint() * (1 - 1e-9)) continue;
            const Rate rate =
                rate_of_paths(std::vector<Integer>(matrix.size(), Integer(1)), matrix, budget_);
            if (rate > best) best = rate;
        }
        return best;
    }

    /// The states of a component with how often they lead to each other; states that lead equally
    /// often to the same ones count as one, which keeps the rate. Empty without a cycle.
    GrowthMatrix lumped(const std::vector<std::size_t>& own,
                        const std::vector<std::size_t>& component) const {
        std::unordered_map<std::size_t, std::size_t> classes;
        for (const std::size_t state : own) classes[state] = 0;
        const auto is_within = [&](std::size_t state, std::size_t next) {
            return next != nowhere && !full_[next] && component[next] == component[state];
        };
        for (std::size_t count = 1;;) {
            std::map<std::vector<std::size_t>, std::size_t> seen;
            std::unordered_map<std::size_t, std::size_t> finer;
            for (const std::size_t state : own) {
                std::vector<std::size_t> key;
                for (const std::size_t next : states_[state])
                    if (is_within(state, next)) key.push_back(classes[next]);
                if (key.empty()) return {};
                std::sort(key.begin(), key.end());
                key.push_back(classes[state]);
                finer[state] = seen.try_emplace(std::move(key), seen.size()).first->second;
            }
            classes = std::move(finer);
            if (seen.size() == count) break;
            count = seen.size();
            budget_.check();
        }
        std::map<std::size_t, std::map<std::size_t, Integer>> rows;
        for (const std::size_t state : own) {
            auto& row = rows[classes[state]];
            if (!row.empty()) continue;
            for (const std::size_t next : states_[state])
                if (is_within(state, next)) row[classes[next]] += Integer(1);
        }
        GrowthMatrix matrix;
        for (const auto& [number, row] : rows) {
            auto& entries = matrix.rows.emplace_back();
            for (const auto& [column, times] : row) entries.push_back({column, times});
        }
        return matrix;
    }

    /// A number that the spectral radius does not exceed (Collatz and Wielandt), close to it.
    static double most_of(const GrowthMatrix& matrix) {
        std::vector<double> vector(matrix.size(), 1), next(matrix.size());
        double most = INFINITY;
        for (int round = 0; round < 200; ++round) {
            double largest = 0, sum = 0;
            for (std::size_t k = 0; k < matrix.size(); ++k) {
                next[k] = vector[k] * 1e-3;  // a share of itself, so that periods die out
                for (const auto& [column, times] : matrix.rows[k])
                    next[k] += times.to_double() * vector[column];
                largest = std::max(largest, next[k] / vector[k] - 1e-3);
                sum = std::max(sum, next[k]);
            }
            most = std::min(most, largest);
            for (std::size_t k = 0; k < matrix.size(); ++k)
                vector[k] = std::max(next[k] / sum, 1e-250);
        }
        return most * (1 + 1e-9);
    }

    /// The sum of the covered shares of the cells that the whole meets. The share of a state is the mean of those of
    /// its cells, 1 where it is full and 0 without pieces: the only solution, as every other state leads to an empty
    /// cell. It lies between how many cells of a deep level are full and how many are touched; the simplest numbers between
    /// these are tried, which solve the equations or do not.
    std::pair<Rational, Rational> area() const {
        constexpr int levels = 400;
        if (begin_.empty()) return {};
        const std::vector<std::size_t> classes = classes_of_shares();
        const std::size_t count = *std::max_element(classes.begin(), classes.end()) + 1;
        std::vector<std::size_t> some(count);  // states, one of each class
        for (std::size_t k = 0; k < states_.size(); ++k) some[classes[k]] = k;
        std::vector<Integer> low(count, Integer(0)), high(count, Integer(1));
        for (std::size_t c = 0; c < count; ++c)
            if (full_[some[c]]) low[c] = 1;
        const Integer parts(static_cast<std::int64_t>(digits_.size()));
        Integer cells = 1;
        for (int level = 0; level < levels; ++level) {
            budget_.check();
            for (auto* const counts : {&low, &high}) {
                std::vector<Integer> next(count, Integer(0));
                for (std::size_t c = 0; c < count; ++c)
                    for (const std::size_t part : states_[some[c]])
                        if (part != nowhere) next[c] += (*counts)[classes[part]];
                *counts = std::move(next);
            }
            cells *= parts;
        }
        Integer least = 0, most = 0;
        for (const std::size_t state : begin_) {
            least += low[classes[state]];
            most += high[classes[state]];
        }
        std::vector<Rational> shares;
        for (std::size_t c = 0; c < count; ++c) {
            if (c % 64 == 0) budget_.check();
            shares.push_back(full_[some[c]] ? Rational(1)
                                            : simplest_between(Rational(low[c], cells),
                                                               Rational(high[c], cells)));
        }
        const Rational times(parts);
        for (std::size_t c = 0; c < count; ++c) {
            if (full_[some[c]]) continue;
            Rational sum = 0;
            for (const std::size_t part : states_[some[c]])
                if (part != nowhere) sum += shares[classes[part]];
            if (sum != times * shares[c]) return {Rational(least, cells), Rational(most, cells)};
        }
        Rational sum = 0;
        for (const std::size_t state : begin_) sum += shares[classes[state]];
        return {sum, sum};
    }

    /// The number with the smallest denominator from one that is not negative to another.
    static Rational simplest_between(const Rational& low, const Rational& high) {
        const Rational whole(floor(low));
        if (whole == low) return whole;
        if (!(high < whole + Rational(1))) return whole + Rational(1);
        return whole + Rational(1) / simplest_between(Rational(1) / (high - whole),
                                                      Rational(1) / (low - whole));
    }

    /// Full states are one class, and states are as long of one class as their cells are.
    std::vector<std::size_t> classes_of_shares() const {
        std::vector<std::size_t> classes(states_.size());
        for (std::size_t k = 0; k < states_.size(); ++k) classes[k] = full_[k] ? 1 : 0;
        for (std::size_t count = 0;;) {
            budget_.check();
            std::map<std::vector<std::size_t>, std::size_t> seen;
            std::vector<std::size_t> finer(states_.size());
            for (std::size_t k = 0; k < states_.size(); ++k) {
                std::vector<std::size_t> key;
                if (!full_[k])
                    for (const std::size_t next : states_[k])
                        key.push_back(next == nowhere ? nowhere : classes[next]);
                std::sort(key.begin(), key.end());
                key.push_back(classes[k]);
                finer[k] = seen.try_emplace(std::move(key), seen.size()).first->second;
            }
            classes = std::move(finer);
            if (seen.size() == count) return classes;
            count = seen.size();
        }
    }

    const LatticeSet& set_;
    const Budget& budget_;
    std::size_t most_;
    std::vector<Place> digits_;
    LatticeSet with_cell_;
    std::vector<RecurrentSet::Disc> discs_;  // that of the cell comes last
    std::map<std::pair<std::size_t, Place>, std::size_t> numbers_;
    std::vector<Pair> pairs_;
    std::map<Place, std::vector<std::size_t>> starts_;  // by cell
    std::vector<std::size_t> begin_;                    // their states
    std::map<std::vector<std::size_t>, std::size_t> state_numbers_;
    std::vector<const std::vector<std::size_t>*> sets_;
    std::vector<std::vector<std::size_t>> states_;
    std::vector<bool> full_;
    std::uint64_t held_ = 0;
};

/// The positions and turned pieces of a recurrent set in a frame whose positions lie in a lattice.
LatticeSet in_lattice(const RecurrentSet& set, const Reached& reached, const Lattice& lattice) {
    const Displacement& displacement = set.displacement();
    LatticeSet out;
    std::map<Turned, std::size_t> numbers;
    for (const Turned& at : reached.pieces) numbers.emplace(at, numbers.size());
    const auto part_of = [&](std::size_t piece, std::int64_t heading, const Vector& vector) {
        const auto found = coordinates(lattice.basis, vector);
        if (!found) throw Error("a position lies beside its lattice");
        return LatticeSet::Part{numbers.at({piece, normal_heading(heading, set.order())}),
                                {found->x, found->y, 0}};
    };
    for (const Turned& at : reached.pieces) {
        out.shapes.push_back(at.piece);
        auto& own = out.parts.emplace_back();
        for (const RecurrentSet::Part& part : set.parts(at.piece)) {
            const std::int64_t heading = at.heading + lattice.shift;
            own.push_back(part_of(part.piece, heading + part.heading,
                                  displacement.turned(part.offset, heading)));
        }
    }
    for (const RecurrentSet::Part& part : set.axiom()) {
        Vector offset = part.offset;
        displacement.subtract(offset, set.axiom().front().offset);
        out.whole.push_back(part_of(part.piece, part.heading, offset));
    }
    for (std::size_t i = 0; i < 2; ++i) {
        out.places[i] = {lattice.values[i].real(), lattice.values[i].imag()};
        out.scale[i] = {lattice.scale[i].x, lattice.scale[i].y, 0};
    }
    const double across = lattice.factor.real(), up = lattice.factor.imag();
    out.linear = {across, -up, up, across};
    return out;
}

/// Sets the area of a cell in the square of the distance from the beginning of the axiom's way to its end, or of its first part that
/// has one. A multiplication X = t/2 + s J by a complex number, where J turns by a right angle and 4 s^2 = 4 det X - t^2, gives
/// |v|^2 = det(v, J v), so a cell is as large as sqrt(4 det X - t^2) / det(v, (2X - t) v) of |v|^2.
void set_cell(LatticeSet& out, const RecurrentSet& set, const Lattice& lattice) {
    const Displacement& displacement = set.displacement();
    Vector way = displacement.zero(), first = way, here = way;
    std::vector<Vector> saved;
    for (const Unfolding::Item& item : set.unfolding().axiom) {
        if (item.kind == Unfolding::Item::Kind::push) {
            saved.push_back(here);
        } else if (item.kind == Unfolding::Item::Kind::pop) {
            here = std::move(saved.back());
            saved.pop_back();
        } else {
            const Vector step = displacement.turned(displacement.way(item.piece), item.heading);
            if (first == displacement.zero()) first = step;
            displacement.add(here, step);
        }
    }
    const bool is_closed = here == displacement.zero();
    const auto unit = shares(lattice.basis, is_closed ? first : here);
    if (!unit || ((*unit)[0].is_zero() && (*unit)[1].is_zero())) return;
    std::vector<std::array<std::array<Rational, 2>, 2>> turns;  // rows: images of the basis
    turns.push_back({{{Rational(lattice.scale[0].x), Rational(lattice.scale[0].y)},
                      {Rational(lattice.scale[1].x), Rational(lattice.scale[1].y)}}});
    for (std::int64_t heading = 1; heading < set.order(); ++heading) {
        const auto one = shares(lattice.basis, displacement.turned(lattice.basis[0], heading));
        const auto two = shares(lattice.basis, displacement.turned(lattice.basis[1], heading));
        if (one && two) turns.push_back({*one, *two});
    }
    for (const auto& x : turns) {
        const Rational trace = x[0][0] + x[1][1];
        const Rational whole = x[0][0] * x[1][1] - x[0][1] * x[1][0];
        const Rational square = Rational(4) * whole - trace * trace;
        if (!(Rational(0) < square)) continue;
        std::array<Rational, 2> image;
        for (std::size_t k = 0; k < 2; ++k)
            image[k] =
                Rational(2) * ((*unit)[0] * x[0][k] + (*unit)[1] * x[1][k]) - trace * (*unit)[k];
        const Rational area = (*unit)[0] * image[1] - (*unit)[1] * image[0];
        out.cell_square = square / (area * area);
        out.unit =
            is_closed ? "the square of the distance from the beginning of its first part to its end"
                      : "the square of the distance from its beginning to its end";
        return;
    }
}

}  // namespace

Point LatticeSet::place(const Vector& vector) const {
    Point found;
    for (std::size_t k = 0; k < rank; ++k) {
        found.x += static_cast<double>(vector[k]) * places[k].x;
        found.y += static_cast<double>(vector[k]) * places[k].y;
    }
    return found;
}

LatticeSet::Vector LatticeSet::scaled(const Vector& vector) const {
    Vector found{};
    for (std::size_t i = 0; i < rank; ++i)
        for (std::size_t k = 0; k < rank; ++k) found[k] += vector[i] * scale[i][k];
    return found;
}

std::int64_t LatticeSet::determinant() const {
    return scale[0][0] * scale[1][1] - scale[0][1] * scale[1][0];
}

std::array<std::int64_t, 2> residue(const LatticeSet& set, const LatticeSet::Vector& vector) {
    const std::int64_t count = std::abs(set.determinant());
    const auto modulo = [&](std::int64_t x) { return ((x % count) + count) % count; };
    const auto& [x, y, none] = vector;
    return {modulo(x * set.scale[1][1] - y * set.scale[1][0]),
            modulo(y * set.scale[0][0] - x * set.scale[0][1])};
}

/// From discs around the beginnings that are large enough, towards smaller ones around the middles of their parts.
std::vector<RecurrentSet::Disc> discs_of(const LatticeSet& set) {
    const double a = set.linear[0], b = set.linear[1], c = set.linear[2], d = set.linear[3];
    const double whole = a * d - b * c;
    // The norm of a matrix of the plane is half the sum of two lengths.
    const double norm = (std::hypot(a + d, c - b) + std::hypot(a - d, b + c)) / 2;
    const double shrinking = norm / std::abs(whole);  // of the inverse
    if (!(shrinking < 1)) throw Error("some distances do not become smaller in parts");
    const auto smaller = [&](std::complex<double> at) {
        return std::complex<double>{(d * at.real() - b * at.imag()) / whole,
                                    (a * at.imag() - c * at.real()) / whole};
    };
    std::vector<std::vector<std::complex<double>>> offsets;
    double farthest = 0;
    for (const auto& own : set.parts) {
        auto& places = offsets.emplace_back();
        for (const LatticeSet::Part& part : own) {
            const Point at = set.place(part.by);
            places.push_back(smaller({at.x, at.y}));
            farthest = std::max(farthest, std::abs(places.back()));
        }
    }
    const double first = farthest / (1 - shrinking);
    std::vector<RecurrentSet::Disc> discs(set.parts.size(), {0, first});
    constexpr int rounds = 60;
    constexpr double wider = 1e-6;
    for (int round = 0; round < rounds; ++round) {
        std::vector<RecurrentSet::Disc> next = discs;
        for (std::size_t s = 0; s < discs.size(); ++s) {
            if (set.parts[s].empty()) continue;
            std::vector<RecurrentSet::Disc> inner;
            for (std::size_t i = 0; i < set.parts[s].size(); ++i) {
                const auto& of = discs[set.parts[s][i].state];
                inner.push_back({smaller(of.centre) + offsets[s][i], of.radius * shrinking});
            }
            const RecurrentSet::Disc tighter = around(inner);
            if (tighter.radius < discs[s].radius) next[s] = tighter;
        }
        discs = std::move(next);
    }
    for (RecurrentSet::Disc& disc : discs) disc.radius += wider * (disc.radius + first);
    return discs;
}

LatticeSet lattice_set(const RecurrentSet& set, const Budget& budget) {
    if (const std::size_t phases = set.unfolding().phases; phases > 1)
        throw Error("late generations approach " + std::to_string(phases) + " sets in turn");
    for (std::int64_t shift = 0; shift < set.order(); ++shift) {
        const Reached reached = reached_in(set, shift, budget);
        if (const auto lattice = lattice_in(set, reached, shift)) {
            LatticeSet found = in_lattice(set, reached, *lattice);
            set_cell(found, set, *lattice);
            return found;
        }
    }
    throw Error("positions lie in no lattice of the plane");
}

CellGrowth cell_growth(const LatticeSet& set, CellQuestion question, const Budget& budget,
                       std::size_t most) {
    return CellCensus(set, budget, most).growth(question);
}

std::optional<LogRatio> boundary_dimension(const LatticeSet& set, const Budget& budget,
                                           std::size_t most) {
    constexpr double rounding = 1e-9;
    const auto& [a, b, c, d] = set.linear;
    const double size = std::hypot(a, c);
    const auto differ = [&](double x, double y) { return std::fabs(x - y) > rounding * size; };
    if (set.rank != 2) throw Error("the lattice lies densely in the plane");
    if ((differ(a, d) || differ(b, -c)) && (differ(a, -d) || differ(b, c)))
        throw Error("the whole is not similar to what it is made of");
    const CellGrowth cells = cell_growth(set, CellQuestion::boundary, budget, most);
    if (!cells.has_interior) return std::nullopt;
    return LogRatio(cells.boundary,
                    ScalingRatio::square_root(Integer(std::abs(set.determinant()))));
}

CellGrowth cell_growth(const RecurrentSet& set, const Budget& budget, std::size_t most) {
    return cell_growth(lattice_set(set, budget), CellQuestion::boundary, budget, most);
}

}  // namespace algae
