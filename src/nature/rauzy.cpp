#include <algorithm>
#include <cmath>
#include <complex>
#include <functional>
#include <map>
#include <numbers>
#include <set>
#include <utility>

#include "nature/detail/figures.hpp"

// Let M be the matrix of a unit Pisot substitution, row a counting the letters of the image of a, and let M r = x r
// with r over Q(x). For the root beta > 1 the number t(v) = v r(beta) of a vector v of letters grows by beta when v becomes v M;
// for each other root alpha, u(v) = v r(alpha) shrinks. The parts T_a, the closure of the u of the prefixes that are
// followed by a, satisfy
//
//     T_a = union over the images of letters b with b -> p a s of alpha T_b + u(p).
//
// The self-replicating set has T_a + u(v) for all vectors v and letters a with 0 <= t(v) < t(a); it covers the plane, each point
// equally often (Ito and Rao 2006). So pairs are (a, v, b) with -t(a) < t(v) < t(b), other than (a, 0, a). The parts of a
// pair are pairs again: from b -> p a s and c -> q d e to (b, (v + q - p) M^-1, c), for T_a and T_d + u(v). Those that stay
// within a bound are finitely many, and two parts meet exactly if there is an infinite path from their pair. (Siegel and Thuswaldner,
// Topological properties of Rauzy fractals, 2009, whose boundary graph this is.)
//
// Pairs of level n multiply like rate^n. They cover the boundary, by parts of the measure beta^-n; so the covering is a
// tiling exactly if the rate is smaller than beta. Then the dimension of the boundary is log rate over the logarithm of the
// contraction, where that is a similarity. The parts are all connected exactly if, for each, the graph of its parts that meet is
// (Hata 1985; Luo, Akiyama and Thuswaldner 2004).
//
// Doubles bound the search, with a wide margin: more pairs only die out later. Whether t lies between two bounds is decided
// exactly, by enclosures, as t(v) = t(b) for v = b only.

namespace algae {

namespace {

using LetterCounts = std::vector<std::int64_t>;
using Complex = std::complex<double>;

constexpr std::size_t most_letters = 6, most_vectors = 4'000'000, most_pairs = 200'000;

/// A place of a letter in the image of another one.
struct Occurrence {
    std::size_t whole;
    LetterCounts before;
};

class Substitution {
public:
    explicit Substitution(const D0L& system) : letters_(system.letters) {
        const std::size_t size = letters_.size();
        const auto expected = [](const std::string& what) {
            throw Error("expected a substitution of 2 to " + std::to_string(most_letters) +
                        " letters whose matrix has the determinant 1 or -1, an irreducible "
                        "characteristic polynomial and one eigenvalue of size 1 or more, found " +
                        what);
        };
        if (size < 2 || size > most_letters) expected(counted(size, "letter"));
        std::map<Symbol, std::size_t> place;
        for (std::size_t a = 0; a < size; ++a) place[letters_[a]] = a;
        matrix_ = IntegerMatrix(size, size);
        places_.resize(size);
        for (std::size_t b = 0; b < size; ++b) {
            LetterCounts before(size, 0);
            for (const Symbol letter : system.successor(letters_[b])) {
                const std::size_t a = place.at(letter);
                places_[a].push_back({b, before});
                ++before[a];
                matrix_(b, a) += 1;
            }
        }
        const Integer unit = determinant(matrix_);
        if (unit != 1 && unit != -1) expected("the determinant " + to_string(unit));
        polynomial_ = characteristic_polynomial(matrix_);
        const auto factors = factorise(polynomial_).powers;
        if (factors.size() != 1 || factors[0].exponent != 1)
            expected("the characteristic polynomial " + to_string(polynomial_) +
                     ", which is not irreducible");
        inverse_ = inverse(matrix_)->numerator;
        if (inverse(matrix_)->denominator != 1) expected("a matrix without an inverse");
        for (const Root& root : roots(polynomial_, bits)) {
            const Ball square = root.real * root.real + root.imaginary * root.imaginary;
            const Order order = compare(square, Ball(1, bits));
            if (order == Order::less) {
                conjugates_.push_back(root);
            } else if (order != Order::greater || !root.is_real || factor_ ||
                       compare(root.real, Ball(0, bits)) != Order::greater) {
                expected("the characteristic polynomial " + to_string(polynomial_));
            } else {
                factor_ = root;
            }
        }
    }

    static constexpr long bits = 256;

    std::size_t size() const { return letters_.size(); }
    const std::vector<Symbol>& letters() const { return letters_; }
    const IntegerMatrix& matrix() const { return matrix_; }
    const Polynomial& polynomial() const { return polynomial_; }
    const std::vector<Occurrence>& places(std::size_t letter) const { return places_[letter]; }
    const Root& factor() const { return *factor_; }
    const std::vector<Root>& conjugates() const { return conjugates_; }

    /// v M^-1.
    LetterCounts before(const LetterCounts& vector) const {
        LetterCounts found(size(), 0);
        for (std::size_t a = 0; a < size(); ++a)
            for (std::size_t b = 0; b < size(); ++b)
                found[b] += vector[a] * inverse_(a, b).to_int64();
        return found;
    }

    /// r of a root, exactly a column of (p(x) - p(M)) / (x - M): real and imaginary parts.
    std::vector<std::pair<Ball, Ball>> column(const Root& root) const {
        // The quotient's coefficients by Horner's rule; each times a power of M.
        const auto degree = static_cast<std::size_t>(polynomial_.degree());
        std::vector<std::pair<Ball, Ball>> quotient(degree, {Ball(0, bits), Ball(0, bits)});
        Ball real(0, bits), imaginary(0, bits);
        for (std::size_t k = degree; k-- > 0;) {
            const Ball next = real * root.real - imaginary * root.imaginary +
                              Ball(polynomial_.coefficient(k + 1), bits);
            imaginary = real * root.imaginary + imaginary * root.real;
            real = next;
            quotient[k] = {real, imaginary};
        }
        std::vector<std::pair<Ball, Ball>> found(size(), {Ball(0, bits), Ball(0, bits)});
        std::vector<Integer> power(size());
        power[0] = 1;
        for (std::size_t k = 0; k < degree; ++k) {
            for (std::size_t a = 0; a < size(); ++a) {
                found[a].first += quotient[k].first * Ball(power[a], bits);
                found[a].second += quotient[k].second * Ball(power[a], bits);
            }
            power = matrix_ * power;
        }
        return found;
    }

private:
    std::vector<Symbol> letters_;
    IntegerMatrix matrix_, inverse_;
    Polynomial polynomial_;
    std::vector<std::vector<Occurrence>> places_;  // by letter: where it stands
    std::optional<Root> factor_;
    std::vector<Root> conjugates_;
};

/// The numbers u and t of vectors.
class Embedding {
public:
    explicit Embedding(const Substitution& of) : size_(of.size()) {
        for (const auto& [real, imaginary] : of.column(of.factor())) heights_.push_back(real);
        // Eigenvectors are positive or negative as a whole.
        if (sign(heights_[0]) == -1)
            for (Ball& height : heights_) height = -height;
        for (const Root& root : of.conjugates()) {
            if (!root.is_real && sign(root.imaginary) == -1) continue;  // conjugate to another one
            std::vector<Complex> column;
            for (const auto& [real, imaginary] : of.column(root))
                column.emplace_back(real.midpoint(), imaginary.midpoint());
            factors_.emplace_back(root.real.midpoint(), root.imaginary.midpoint());
            columns_.push_back(std::move(column));
        }
    }

    std::size_t planes() const { return columns_.size(); }
    Complex factor(std::size_t plane) const { return factors_[plane]; }
    Complex place(const LetterCounts& vector, std::size_t plane) const {
        Complex found = 0;
        for (std::size_t a = 0; a < size_; ++a)
            found += static_cast<double>(vector[a]) * columns_[plane][a];
        return found;
    }
    double height(const LetterCounts& vector) const {
        double found = 0;
        for (std::size_t a = 0; a < size_; ++a)
            found += static_cast<double>(vector[a]) * heights_[a].midpoint();
        return found;
    }
    double height(std::size_t letter) const { return heights_[letter].midpoint(); }

    /// The sign of t of the vector, exactly: it is 0 for 0 only, as the heights are independent over the
    /// rational numbers.
    int sign_of_height(const LetterCounts& vector) const {
        if (std::all_of(vector.begin(), vector.end(), [](auto x) { return x == 0; })) return 0;
        Ball found(0, Substitution::bits);
        for (std::size_t a = 0; a < size_; ++a)
            found += heights_[a] * Ball(Integer(vector[a]), Substitution::bits);
        const auto known = sign(found);
        if (!known) throw BoundReached(Bound::digits, "heights of vectors need too many digits");
        return *known;
    }

    /// Rows of the real coordinates of the unit vectors, t first.
    std::vector<std::vector<double>> coordinates() const {
        std::vector<std::vector<double>> rows;
        for (std::size_t a = 0; a < size_; ++a) {
            std::vector<double> row{heights_[a].midpoint()};
            for (std::size_t k = 0; k < planes(); ++k) {
                row.push_back(columns_[k][a].real());
                if (factors_[k].imag() != 0) row.push_back(columns_[k][a].imag());
            }
            rows.push_back(std::move(row));
        }
        return rows;
    }

private:
    std::size_t size_;
    std::vector<Ball> heights_;
    std::vector<Complex> factors_;
    std::vector<std::vector<Complex>> columns_;
};

/// For each letter, how large its number in the vectors is at most whose coordinates are at most so large.
std::vector<std::int64_t> largest_numbers(std::vector<std::vector<double>> rows,
                                          const std::vector<double>& limits) {
    const std::size_t size = rows.size();
    // The inverse, by elimination: vector = coordinates * inverse.
    std::vector<std::vector<double>> inverse(size, std::vector<double>(size, 0));
    for (std::size_t i = 0; i < size; ++i) inverse[i][i] = 1;
    for (std::size_t column = 0; column < size; ++column) {
        std::size_t pivot = column;
        for (std::size_t i = column; i < size; ++i)
            if (std::fabs(rows[i][column]) > std::fabs(rows[pivot][column])) pivot = i;
        std::swap(rows[pivot], rows[column]);
        std::swap(inverse[pivot], inverse[column]);
        const double scale = rows[column][column];
        for (std::size_t k = 0; k < size; ++k) {
            rows[column][k] /= scale;
            inverse[column][k] /= scale;
        }
        for (std::size_t i = 0; i < size; ++i) {
            if (i == column) continue;
            const double times = rows[i][column];
            for (std::size_t k = 0; k < size; ++k) {
                rows[i][k] -= times * rows[column][k];
                inverse[i][k] -= times * inverse[column][k];
            }
        }
    }
    std::vector<std::int64_t> found;
    for (std::size_t a = 0; a < size; ++a) {
        double most = 0;
        for (std::size_t k = 0; k < size; ++k) most += limits[k] * std::fabs(inverse[k][a]);
        found.push_back(static_cast<std::int64_t>(std::floor(most * (1 + 1e-9) + 1e-9)));
    }
    return found;
}

/// The pairs that may meet, with what they lead to; those that lead nowhere are left out.
class Pairs {
public:
    Pairs(const Substitution& of, const Budget& budget)
        : of_(of), projection_(of), budget_(budget) {
        find_limits();
        find_all();
        find_next();
        leave_out_dead_ends();
    }

    const std::vector<RauzyNeighbour>& list() const { return list_; }
    const std::vector<std::vector<std::size_t>>& next() const { return next_; }
    bool meet(const RauzyNeighbour& pair) const { return numbers_.contains(pair); }

private:
    void find_limits() {
        // |T| <= largest |u(p)| / (1 - |alpha|); twice that, and a margin, for pairs.
        for (std::size_t plane = 0; plane < projection_.planes(); ++plane) {
            double largest = 0;
            for (std::size_t a = 0; a < of_.size(); ++a)
                for (const Occurrence& place : of_.places(a))
                    largest = std::max(largest, std::abs(projection_.place(place.before, plane)));
            limits_.push_back(2 * largest / (1 - std::abs(projection_.factor(plane))) * 1.001 +
                              1e-6);
        }
    }

    bool is_near(const LetterCounts& vector) const {
        for (std::size_t plane = 0; plane < projection_.planes(); ++plane)
            if (std::abs(projection_.place(vector, plane)) > limits_[plane]) return false;
        return true;
    }

    /// Whether -t(first) < t(vector) < t(other).
    bool is_between(const RauzyNeighbour& pair) const {
        LetterCounts below = pair.vector, above = pair.vector;
        ++below[pair.first];
        --above[pair.other];
        return projection_.sign_of_height(below) > 0 && projection_.sign_of_height(above) < 0;
    }

    void find_all() {
        const std::size_t size = of_.size();
        double highest = 0;
        for (std::size_t a = 0; a < size; ++a) highest = std::max(highest, projection_.height(a));
        std::vector<double> limits{highest};
        for (std::size_t plane = 0; plane < projection_.planes(); ++plane) {
            limits.push_back(limits_[plane]);
            if (projection_.factor(plane).imag() != 0) limits.push_back(limits_[plane]);
        }
        const auto most = largest_numbers(projection_.coordinates(), limits);
        double count = 1;
        for (const std::int64_t each : most) count *= 2.0 * static_cast<double>(each) + 1;
        if (!(count < static_cast<double>(most_vectors)))
            throw BoundReached(Bound::method, "more than " + std::to_string(most_vectors) +
                                                  " vectors between which parts may meet");
        LetterCounts vector;
        for (const std::int64_t each : most) vector.push_back(-each);
        for (std::uint64_t looked = 0;; ++looked) {
            if (looked % 4096 == 0) budget_.check();
            if (std::fabs(projection_.height(vector)) < highest * 1.001 && is_near(vector))
                for (std::size_t a = 0; a < size; ++a)
                    for (std::size_t b = 0; b < size; ++b) add({a, b, vector});
            std::size_t k = 0;
            while (k < size && vector[k] == most[k]) {
                vector[k] = -most[k];
                ++k;
            }
            if (k == size) return;
            ++vector[k];
        }
    }

    void add(RauzyNeighbour pair) {
        if (!is_between(pair)) return;
        if (pair.first == pair.other && pair.vector == LetterCounts(of_.size(), 0)) return;
        if (list_.size() == most_pairs)
            throw BoundReached(Bound::method, "more than " + std::to_string(most_pairs) +
                                                  " pairs of parts that may meet");
        numbers_.emplace(pair, list_.size());
        list_.push_back(std::move(pair));
    }

    void find_next() {
        for (const RauzyNeighbour& pair : list_) {
            auto& found = next_.emplace_back();
            for (const Occurrence& one : of_.places(pair.first))
                for (const Occurrence& two : of_.places(pair.other)) {
                    LetterCounts sum = pair.vector;
                    for (std::size_t k = 0; k < sum.size(); ++k)
                        sum[k] += two.before[k] - one.before[k];
                    const auto at = numbers_.find({one.whole, two.whole, of_.before(sum)});
                    if (at != numbers_.end()) found.push_back(at->second);
                }
        }
    }

    void leave_out_dead_ends() {
        std::vector<std::vector<std::size_t>> before(list_.size());
        std::vector<std::size_t> left, dead;
        for (std::size_t k = 0; k < list_.size(); ++k) {
            left.push_back(next_[k].size());
            for (const std::size_t to : next_[k]) before[to].push_back(k);
            if (left[k] == 0) dead.push_back(k);
        }
        for (std::size_t i = 0; i < dead.size(); ++i)
            for (const std::size_t k : before[dead[i]])
                if (--left[k] == 0) dead.push_back(k);
        std::vector<std::size_t> place(list_.size());
        std::vector<RauzyNeighbour> alive;
        std::vector<std::vector<std::size_t>> next;
        for (std::size_t k = 0; k < list_.size(); ++k) {
            if (left[k] == 0) continue;
            place[k] = alive.size();
            alive.push_back(std::move(list_[k]));
            next.push_back(std::move(next_[k]));
        }
        for (auto& each : next) {
            std::erase_if(each, [&](std::size_t to) { return left[to] == 0; });
            for (std::size_t& to : each) to = place[to];
        }
        list_ = std::move(alive);
        next_ = std::move(next);
        numbers_.clear();
        for (std::size_t k = 0; k < list_.size(); ++k) numbers_.emplace(list_[k], k);
    }

    const Substitution& of_;
    Embedding projection_;
    const Budget& budget_;
    std::vector<double> limits_;  // of |u|, by plane
    std::vector<RauzyNeighbour> list_;
    std::vector<std::vector<std::size_t>> next_;
    std::map<RauzyNeighbour, std::size_t> numbers_;
};

/// Whether a graph of so many nodes is connected.
bool is_connected(std::size_t count, const std::function<bool(std::size_t, std::size_t)>& joined) {
    std::set<std::size_t> reached{0};
    std::vector<std::size_t> open{0};
    while (!open.empty()) {
        const std::size_t k = open.back();
        open.pop_back();
        for (std::size_t i = 0; i < count; ++i)
            if (!reached.contains(i) && (joined(k, i) || joined(i, k))) {
                reached.insert(i);
                open.push_back(i);
            }
    }
    return reached.size() == count;
}

/// Whether the parts of each T_a hang together.
bool all_connected(const Substitution& of, const Pairs& pairs) {
    for (std::size_t a = 0; a < of.size(); ++a) {
        const auto& places = of.places(a);
        const bool is = is_connected(places.size(), [&](std::size_t i, std::size_t k) {
            LetterCounts apart = places[k].before;
            for (std::size_t n = 0; n < apart.size(); ++n) apart[n] -= places[i].before[n];
            return pairs.meet({places[i].whole, places[k].whole, of.before(apart)});
        });
        if (!is) return false;
    }
    return true;
}

bool has_similar_conjugates(const Substitution& of) {
    return of.size() == 2 || (of.size() == 3 && !of.conjugates().front().is_real);
}

}  // namespace

bool RauzyNeighbour::operator<(const RauzyNeighbour& right) const {
    if (first != right.first) return first < right.first;
    if (other != right.other) return other < right.other;
    return vector < right.vector;
}

std::string RauzyFractal::boundary_text() const {
    const std::string times = letters.size() == 2 ? "" : std::to_string(letters.size() - 1) + " ";
    const auto name = [](const Rate& rate) {
        const std::string exact = rate.exact();
        const bool is_short =
            std::all_of(exact.begin(), exact.end(), [](char c) { return c >= '0' && c <= '9'; });
        return is_short ? exact : "(" + exact + ")";
    };
    return times + "log " + name(meeting) + " / log " + name(factor);
}

std::optional<Ball> RauzyFractal::boundary(long bits) const {
    if (!is_similar || !tiles) return std::nullopt;
    const long planes = static_cast<long>(letters.size()) - 1;
    return Ball(planes, bits) * log(meeting.enclosure(bits)) / log(factor.enclosure(bits));
}

RauzyFractal rauzy_fractal(const D0L& system, const Budget& budget) {
    const Substitution of(system);
    const Pairs pairs(of, budget);
    RauzyFractal found;
    found.letters = of.letters();
    const Integer above = floor(of.factor().real.upper()) + 1;
    found.factor = Rate(of.polynomial(), Rational(above));
    found.neighbours = pairs.list();
    found.is_similar = has_similar_conjugates(of);
    GrowthMatrix matrix;
    for (const auto& next : pairs.next()) {
        std::map<std::size_t, Integer> counts;
        for (const std::size_t to : next) counts[to] += 1;
        auto& row = matrix.rows.emplace_back();
        for (const auto& [column, times] : counts) row.push_back({column, times});
    }
    if (matrix.size() > 0)
        for (const Component& component : components(matrix, budget).list)
            if (component.rate && *component.rate > found.meeting) found.meeting = *component.rate;
    found.tiles = found.meeting < found.factor;
    found.parts_connected = all_connected(of, pairs);
    const LetterCounts zero(of.size(), 0);
    found.connected =
        found.parts_connected && is_connected(of.size(), [&](std::size_t a, std::size_t b) {
            return a != b && pairs.meet({a, b, zero});
        });
    return found;
}

IteratedFunctions rauzy_functions(const D0L& system, const Budget& budget) {
    const Substitution of(system);
    if (of.size() != 3 || !has_similar_conjugates(of))
        throw Error(
            "expected a substitution of three letters with complex conjugates, which has a "
            "fractal in the plane, found the characteristic polynomial " +
            to_string(of.polynomial()));
    budget.check();
    const Embedding projection(of);
    const Complex alpha = projection.factor(0);
    const double unit = std::abs(projection.place({1, 0, 0}, 0));
    // Decimals, as they are written in files.
    const auto written = [](double value) {
        constexpr int digits = 12;
        return quantity(Rational(decimal(exactly(value), digits)));
    };
    IteratedFunctions found;
    found.name = system.name;
    found.states = {"all"};
    found.style.colours = {"#b5482a", "#e0a33a", "#2f6f8f"};  // of the parts
    for (const Symbol letter : of.letters()) found.states.push_back(system.alphabet->name(letter));
    const auto add = [&](std::size_t from, std::size_t to, Complex factor, Complex offset) {
        IteratedFunctions::Map map;
        map.from = from;
        map.to = to;
        map.numbers = {written(factor.real()), written(-factor.imag()), written(factor.imag()),
                       written(factor.real()), written(offset.real()),  written(offset.imag())};
        map.map = {map.numbers[0].value, map.numbers[1].value, map.numbers[2].value,
                   map.numbers[3].value, map.numbers[4].value, map.numbers[5].value};
        map.name = "map " + std::to_string(found.maps.size() + 1);
        found.maps.push_back(std::move(map));
    };
    for (std::size_t a = 0; a < of.size(); ++a) add(0, a + 1, 1, 0);
    for (std::size_t a = 0; a < of.size(); ++a)
        for (const Occurrence& place : of.places(a))
            add(a + 1, place.whole + 1, alpha, projection.place(place.before, 0) / unit);
    found.check();
    return found;
}

LatticeSet rauzy_lattice_set(const D0L& system, const Budget& budget) {
    const Substitution of(system);
    if (of.size() != 3)
        throw Error("expected three letters, whose fractal lies in the plane, found " +
                    std::to_string(of.size()));
    const Embedding projection(of);
    LatticeSet found;
    found.rank = 3;
    const auto vector_of = [](const LetterCounts& counts) {
        return LatticeSet::Vector{counts[0], counts[1], counts[2]};
    };
    // T_a = alpha (T_b + u(p M^-1)), and so on; an axis each for two real conjugates.
    for (std::size_t a = 0; a < 3; ++a) {
        LetterCounts unit(3, 0);
        unit[a] = 1;
        found.scale[a] = vector_of(of.before(unit));
        const Complex first = projection.place(unit, 0);
        found.places[a] = projection.planes() == 1
                              ? Point{first.real(), first.imag()}
                              : Point{first.real(), projection.place(unit, 1).real()};
        found.parts.emplace_back();
        for (const Occurrence& place : of.places(a))
            found.parts.back().push_back({place.whole, vector_of(of.before(place.before))});
        found.shapes.push_back(a);
        found.whole.push_back({a, {}});
    }
    const Complex factor = 1.0 / projection.factor(0);
    found.linear = {factor.real(), -factor.imag(), factor.imag(), factor.real()};
    if (projection.planes() == 2)
        found.linear = {factor.real(), 0, 0, (1.0 / projection.factor(1)).real()};
    if (rauzy_fractal(system, budget).tiles) found.periods = {{{1, 0, -1}, {0, 1, -1}}};
    return found;
}

namespace {

/// A face of the stepped plane: the parallelogram from a vector along the two other letters than its own.
struct Face {
    LetterCounts at;
    std::size_t letter;
};

/// Parts in the plane as polygons.
class Patches {
public:
    Patches(const Substitution& of, const Budget& budget) : of_(of), projection_(of) {
        if (of.size() != 3)
            throw Error("expected three letters, whose fractal lies in the plane, found " +
                        std::to_string(of.size()));
        // All parts are divided equally often: only then their faces fit together.
        std::vector<std::vector<Face>> faces;
        for (std::size_t a = 0; a < of.size(); ++a) faces.push_back({{LetterCounts(3, 0), a}});
        std::size_t level = 0;
        for (std::size_t all = 0; all < enough && level < most_levels; ++level) {
            budget.check();
            all = 0;
            for (auto& of_letter : faces) {
                of_letter = divided(of_letter);
                all += of_letter.size();
            }
        }
        for (const auto& of_letter : faces) polygons_.push_back(outline(of_letter, level));
    }

    const std::vector<std::vector<Point>>& polygons() const { return polygons_; }
    const Embedding& projection() const { return projection_; }

    /// Where a vector lies, so that the first letter has the length 1.
    Point moved_by(const LetterCounts& vector) const {
        const Complex at = place(vector);
        return {at.real(), at.imag()};
    }

    /// How far a point of the parts is from 0, at most.
    double reach() const {
        double farthest = 0;
        for (const auto& polygon : polygons_)
            for (const Point& corner : polygon)
                farthest = std::max(farthest, std::hypot(corner.x, corner.y));
        return farthest;
    }

    /// By how much the coordinates of the embedding are larger, at most.
    double unit() const {
        double largest = 0;
        for (std::size_t plane = 0; plane < projection_.planes(); ++plane)
            largest = std::max(largest, std::abs(projection_.place({1, 0, 0}, plane)));
        return largest;
    }

private:
    static constexpr std::size_t enough = 30'000, most_levels = 60;

    std::vector<Face> divided(const std::vector<Face>& faces) const {
        std::vector<Face> found;
        for (const Face& face : faces)
            for (const Occurrence& each : of_.places(face.letter)) {
                LetterCounts sum = face.at;
                for (std::size_t k = 0; k < sum.size(); ++k) sum[k] += each.before[k];
                found.push_back({of_.before(sum), each.whole});
            }
        return found;
    }

    /// In the plane where the first letter lies at 1, or at (1, 1) where each axis has a factor of its own.
    Complex place(const LetterCounts& vector) const {
        const auto on = [&](std::size_t plane) {
            return projection_.place(vector, plane) / projection_.place({1, 0, 0}, plane);
        };
        return projection_.planes() == 1 ? on(0) : Complex(on(0).real(), on(1).real());
    }

    /// After so many steps.
    Complex shrunk(Complex at, std::size_t level) const {
        const auto power = static_cast<double>(level);
        if (projection_.planes() == 1) return at * std::pow(projection_.factor(0), power);
        return {at.real() * std::pow(projection_.factor(0).real(), power),
                at.imag() * std::pow(projection_.factor(1).real(), power)};
    }

    /// The edges of the faces that only one of them has, as one polygon: from loop to loop and back, which adds no area.
    std::vector<Point> outline(const std::vector<Face>& faces, std::size_t level) const {
        std::map<LetterCounts, std::vector<LetterCounts>> edges;
        const auto add = [&](const LetterCounts& from, const LetterCounts& to) {
            auto& back = edges[to];
            const auto at = std::find(back.begin(), back.end(), from);
            if (at == back.end())
                edges[from].push_back(to);
            else
                back.erase(at);
        };
        for (const Face& face : faces) {
            std::size_t j = (face.letter + 1) % 3, k = (face.letter + 2) % 3;
            const Complex along = place(one(j)), across = place(one(k));
            if (along.real() * across.imag() - along.imag() * across.real() < 0) std::swap(j, k);
            LetterCounts corner = face.at, next = corner;
            const auto go = [&](std::size_t letter, int by) {
                next[letter] += by;
                add(corner, next);
                corner = next;
            };
            go(j, 1), go(k, 1), go(j, -1), go(k, -1);
        }
        std::vector<Point> polygon;
        const auto put = [&](const LetterCounts& corner) {
            const Complex at = shrunk(place(corner), level);
            polygon.push_back({at.real(), at.imag()});
        };
        for (auto from = edges.begin(); from != edges.end();) {
            if (from->second.empty()) {
                ++from;
                continue;
            }
            const LetterCounts begin = from->first;
            put(begin);
            LetterCounts last = begin, here = from->second.back();
            from->second.pop_back();
            while (here != begin) {
                put(here);
                auto& out = edges[here];
                const auto chosen = std::min_element(out.begin(), out.end(), [&](auto& x, auto& y) {
                    return turn(last, here, x) < turn(last, here, y);
                });
                last = std::exchange(here, *chosen);
                out.erase(chosen);
            }
            put(begin);
            if (begin != edges.begin()->first) polygon.push_back(polygon.front());
        }
        return polygon;
    }

    /// How far to turn clockwise from where one came from to where one goes: as the inside lies on the left, the least such turn
    /// stays with the same loop where several touch.
    double turn(const LetterCounts& from, const LetterCounts& at, const LetterCounts& to) const {
        const Complex here = place(at);
        const double angle = std::arg((place(from) - here) / (place(to) - here));
        return angle > 0 ? angle : angle + 2 * std::numbers::pi;
    }

    LetterCounts one(std::size_t letter) const {
        LetterCounts vector(3, 0);
        vector[letter] = 1;
        return vector;
    }

    const Substitution& of_;
    Embedding projection_;
    std::vector<std::vector<Point>> polygons_;  // by letter
};

/// Vectors with 0 <= t(v) < t(a) whose place is at most so far away, for each letter a.
std::vector<std::pair<LetterCounts, std::size_t>> stepped_plane(const Patches& patches,
                                                                double reach) {
    const Embedding& projection = patches.projection();
    double highest = 0;
    for (std::size_t a = 0; a < 3; ++a) highest = std::max(highest, projection.height(a));
    const auto most = largest_numbers(projection.coordinates(),
                                      {highest, reach * patches.unit(), reach * patches.unit()});
    std::vector<std::pair<LetterCounts, std::size_t>> found;
    for (std::int64_t i = -most[0]; i <= most[0]; ++i)
        for (std::int64_t j = -most[1]; j <= most[1]; ++j)
            for (std::int64_t k = -most[2]; k <= most[2]; ++k) {
                const LetterCounts vector{i, j, k};
                const double height = projection.height(vector);
                if (height < -1 || height > highest + 1) continue;
                const Point at = patches.moved_by(vector);
                if (std::hypot(at.x, at.y) > reach || projection.sign_of_height(vector) < 0)
                    continue;
                for (std::size_t a = 0; a < 3; ++a) {
                    LetterCounts above = vector;
                    --above[a];
                    if (projection.sign_of_height(above) < 0) found.emplace_back(vector, a);
                }
            }
    return found;
}

}  // namespace

std::vector<std::vector<Point>> rauzy_polygons(const D0L& system, const Budget& budget) {
    const Substitution of(system);
    return Patches(of, budget).polygons();
}

std::unique_ptr<Figure> rauzy_figure(const D0L& system, RauzyPicture picture,
                                     const Budget& budget) {
    const Substitution of(system);
    const Patches patches(of, budget);
    const double reach = 3 * patches.reach();
    std::vector<Path> paths;
    const Colour colours[] = {{0.71, 0.28, 0.16}, {0.88, 0.64, 0.23}, {0.18, 0.44, 0.56}};
    const auto add = [&](std::size_t letter, Point by, double paler) {
        Path path;
        path.filled = true;
        path.paint = mixed(colours[letter], {1, 1, 1}, paler);
        for (const Point& corner : patches.polygons()[letter])
            path.points.push_back({corner.x + by.x, corner.y + by.y});
        paths.push_back(std::move(path));
    };
    if (picture == RauzyPicture::fractal) {
        for (std::size_t a = 0; a < 3; ++a) add(a, {}, 0);
    } else if (picture == RauzyPicture::self_replicating) {
        for (const auto& [vector, letter] : stepped_plane(patches, reach))
            add(letter, patches.moved_by(vector),
                0.15 * static_cast<double>(((vector[0] - vector[1]) % 3 + 3) % 3));
    } else {
        const Point x = patches.moved_by({1, 0, -1}), y = patches.moved_by({0, 1, -1});
        // A move by i x + k y at most so far away has |i| and |k| at most this.
        const double area = std::fabs(x.x * y.y - x.y * y.x);
        const auto most = static_cast<long>(
            reach * std::max(std::hypot(x.x, x.y), std::hypot(y.x, y.y)) / area + 1);
        for (long i = -most; i <= most; ++i)
            for (long k = -most; k <= most; ++k) {
                budget.check();
                const double over = static_cast<double>(i), up = static_cast<double>(k);
                const Point by{over * x.x + up * y.x, over * x.y + up * y.y};
                if (std::hypot(by.x, by.y) > reach) continue;
                const long kind = ((i - k) % 3 + 3) % 3;  // neighbours differ
                const double paler = i == 0 && k == 0 ? 0 : 0.3 + 0.2 * static_cast<double>(kind);
                for (std::size_t a = 0; a < 3; ++a) add(a, by, paler);
            }
    }
    return std::make_unique<PathFigure>(std::move(paths));
}

}  // namespace algae
