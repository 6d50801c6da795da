#include <algorithm>
#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/strong_components.hpp>
#include <cmath>
#include <deque>
#include <numbers>
#include <set>

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
constexpr double margin = 1e-6;  // of discs, in the length of the longest way

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
    Place scaled(Place at) const {
        return {at.x * scale[0].x + at.y * scale[1].x, at.x * scale[0].y + at.y * scale[1].y};
    }
    std::int64_t determinant() const {
        return std::abs(scale[0].x * scale[1].y - scale[0].y * scale[1].x);
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

/// Coordinates of a vector in two independent ones; nothing if they are not whole.
std::optional<Place> coordinates(const std::vector<Vector>& basis, const Vector& vector) {
    for (std::size_t i = 0; i < vector.size(); ++i)
        for (std::size_t k = i + 1; k < vector.size(); ++k) {
            const auto minor = [&](const Vector& a, const Vector& b) {
                return Integer(a[i]) * Integer(b[k]) - Integer(a[k]) * Integer(b[i]);
            };
            const Integer whole = minor(basis[0], basis[1]);
            if (whole.is_zero()) continue;
            const Rational x(minor(vector, basis[1]), whole), y(minor(basis[0], vector), whole);
            if (!x.is_integer() || !y.is_integer()) return std::nullopt;
            const Integer a = x.numerator(), b = y.numerator();
            if (!a.fits_int64() || !b.fits_int64()) return std::nullopt;
            Place found{a.to_int64(), b.to_int64()};
            if (std::abs(found.x) > largest_coordinate || std::abs(found.y) > largest_coordinate)
                throw BoundReached(Bound::digits, "positions in a lattice need too many digits");
            for (std::size_t c = 0; c < vector.size(); ++c)
                if (found.x * basis[0][c] + found.y * basis[1][c] != vector[c]) return std::nullopt;
            return found;
        }
    return std::nullopt;
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

/// Residues of the lattice modulo nu, each by its shortest vector.
std::vector<Place> residues(const Lattice& lattice) {
    const std::int64_t count = lattice.determinant();
    if (count > most_digits)
        throw BoundReached(Bound::method, "a cell has " + std::to_string(count) +
                                              " parts, more than " + std::to_string(most_digits));
    const auto residue = [&](Place at) {
        const auto modulo = [&](std::int64_t x) { return ((x % count) + count) % count; };
        return Place{modulo(at.x * lattice.scale[1].y - at.y * lattice.scale[1].x),
                     modulo(at.y * lattice.scale[0].x - at.x * lattice.scale[0].y)};
    };
    for (std::int64_t side = 2;; side *= 2) {
        std::vector<Place> near;
        for (std::int64_t x = -side; x <= side; ++x)
            for (std::int64_t y = -side; y <= side; ++y) near.push_back({x, y});
        std::stable_sort(near.begin(), near.end(), [&](Place a, Place b) {
            return std::abs(lattice.value(a)) < std::abs(lattice.value(b)) - 1e-9;
        });
        std::set<Place> seen;
        std::vector<Place> found;
        for (const Place at : near)
            if (seen.insert(residue(at)).second) found.push_back(at);
        if (static_cast<std::int64_t>(found.size()) == count) return found;
    }
}

class CellCensus {
public:
    CellCensus(const RecurrentSet& set, const Lattice& lattice, const Reached& reached,
               const Budget& budget, std::size_t most)
        : set_(set), lattice_(lattice), budget_(budget), most_(most), digits_(residues(lattice)) {
        find_parts(reached);
        find_disc();
        find_pairs();
        leave_out_dead_ends();
        find_states();
        find_full();
    }

    CellGrowth growth() const {
        CellGrowth out;
        out.kinds = states_.size();
        out.has_interior = std::find(full_.begin(), full_.end(), true) != full_.end();
        out.boundary = boundary_rate();
        return out;
    }

private:
    struct Move {
        std::size_t to;  // turned piece
        Place by;
    };
    struct Pair {
        std::size_t turned;
        Place at;                                               // seen from the cell
        std::vector<std::pair<std::size_t, std::size_t>> next;  // part of the cell, pair
    };

    void find_parts(const Reached& reached) {
        std::map<Turned, std::size_t> numbers;
        for (const Turned& at : reached.pieces) {
            numbers.emplace(at, turned_.size());
            turned_.push_back(at);
        }
        const auto number = [&](std::size_t piece, std::int64_t heading) {
            return numbers.at({piece, normal_heading(heading, set_.order())});
        };
        const Displacement& displacement = set_.displacement();
        const auto place = [&](const Vector& vector) {
            const auto found = coordinates(lattice_.basis, vector);
            if (!found) throw Error("a position lies beside its lattice");
            return *found;
        };
        for (const Turned& at : turned_) {
            auto& own = moves_.emplace_back();
            for (const RecurrentSet::Part& part : set_.parts(at.piece))
                own.push_back(
                    {number(part.piece, at.heading + lattice_.shift + part.heading),
                     place(displacement.turned(part.offset, at.heading + lattice_.shift))});
            const double angle = 2 * std::numbers::pi * static_cast<double>(at.heading) /
                                 static_cast<double>(set_.order());
            centres_.push_back(std::polar(1.0, angle) * set_.disc(at.piece).centre);
        }
        for (const RecurrentSet::Part& part : set_.axiom()) {
            Vector offset = part.offset;
            displacement.subtract(offset, set_.axiom().front().offset);
            axiom_.push_back({number(part.piece, part.heading), place(offset)});
        }
    }

    /// A disc around the cell at 0.
    void find_disc() {
        std::complex<double> middle = 0;
        for (const Place digit : digits_) middle += lattice_.value(digit);
        middle /= static_cast<double>(digits_.size());
        double farthest = 0;
        for (const Place digit : digits_)
            farthest = std::max(farthest, std::abs(lattice_.value(digit) - middle));
        centre_ = middle / (lattice_.factor - 1.0);
        radius_ = farthest / (std::abs(lattice_.factor) - 1) * (1 + 1e-9);
    }

    bool may_meet(std::size_t turned, Place at) const {
        return std::abs(lattice_.value(at) + centres_[turned] - centre_) <=
               radius_ + set_.disc(turned_[turned].piece).radius + margin;
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
        const double area = std::abs((std::conj(lattice_.values[0]) * lattice_.values[1]).imag());
        for (const Move& part : axiom_) {
            const double reach = radius_ + set_.disc(turned_[part.to].piece).radius + margin;
            const std::complex<double> middle =
                lattice_.value(part.by) + centres_[part.to] - centre_;
            // Coordinates of the middle, and how far a disc goes in each of them.
            const double x = (std::conj(middle) * lattice_.values[1]).imag() /
                             (std::conj(lattice_.values[0]) * lattice_.values[1]).imag();
            const double y = (std::conj(lattice_.values[0]) * middle).imag() /
                             (std::conj(lattice_.values[0]) * lattice_.values[1]).imag();
            const double across = reach * std::abs(lattice_.values[1]) / area + 1;
            const double up = reach * std::abs(lattice_.values[0]) / area + 1;
            if (across * up > 1e7)
                throw BoundReached(Bound::method, "the set meets more than 10000000 cells");
            const auto whole = [](double at) { return static_cast<std::int64_t>(std::floor(at)); };
            for (std::int64_t i = whole(x - across); i <= whole(x + across); ++i)
                for (std::int64_t k = whole(y - up); k <= whole(y + up); ++k) {
                    const Place seen = part.by - Place{i, k};
                    if (may_meet(part.to, seen)) starts_[{i, k}].push_back(number(part.to, seen));
                }
        }
        WorkCount done("pairs of cells");
        for (std::size_t k = 0; k < pairs_.size(); ++k) {
            if (k % 256 == 0) budget_.check();
            done.at(k);
            const std::size_t turned = pairs_[k].turned;
            const Place at = lattice_.scaled(pairs_[k].at);
            std::vector<std::pair<std::size_t, std::size_t>> next;
            for (const Move& part : moves_[turned])
                for (std::size_t d = 0; d < digits_.size(); ++d) {
                    const Place seen = at + part.by - digits_[d];
                    if (may_meet(part.to, seen)) next.emplace_back(d, number(part.to, seen));
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
        for (auto& [cell, own] : starts_) {
            state_of(own);
        }
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

    const RecurrentSet& set_;
    const Lattice& lattice_;
    const Budget& budget_;
    std::size_t most_;
    std::vector<Place> digits_;
    std::vector<Turned> turned_;
    std::vector<std::vector<Move>> moves_;  // by turned piece
    std::vector<std::complex<double>> centres_;
    std::vector<Move> axiom_;
    std::complex<double> centre_;
    double radius_ = 0;
    std::map<std::pair<std::size_t, Place>, std::size_t> numbers_;
    std::vector<Pair> pairs_;
    std::map<Place, std::vector<std::size_t>> starts_;  // by cell
    std::map<std::vector<std::size_t>, std::size_t> state_numbers_;
    std::vector<const std::vector<std::size_t>*> sets_;
    std::vector<std::vector<std::size_t>> states_;
    std::vector<bool> full_;
    std::uint64_t held_ = 0;
};

}  // namespace

CellGrowth cell_growth(const RecurrentSet& set, const Budget& budget, std::size_t most) {
    for (std::int64_t shift = 0; shift < set.order(); ++shift) {
        const Reached reached = reached_in(set, shift, budget);
        if (const auto lattice = lattice_in(set, reached, shift))
            return CellCensus(set, *lattice, reached, budget, most).growth();
    }
    throw Error("positions lie in no lattice of the plane");
}

}  // namespace algae
