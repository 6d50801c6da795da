#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "dimension/detail/recurrent_set.hpp"

// The factor mu by which the ways of pieces grow, and the lattice in which the limit of the ways
// lies, exactly.
//
// Let M be the matrix over Z[zeta] that maps the ways of one level to those of the next. Where one
// eigenvalue mu outgrows all others, the ways divided by mu^k tend to an eigenvector v, and
// positions in the limit are combinations of zeta^i v(a). To compare positions exactly they need
// coordinates in the field Q(mu, zeta). The steps:
//
// 1. `LeadingFactor` replaces M by A = M + t zeta over the integers, t so large that the
//    eigenvalues of A for different embeddings of zeta lie apart. The polynomial that annihilates
//    the ways under A is factorised; the factor q with the root mu + t zeta is the minimal
//    polynomial of a generator of Q(mu, zeta). Applying the other factors to the ways leaves u,
//    their part that belongs to q. Several eigenvalues may be equally large and still agree where
//    the turns' period makes their powers equal; otherwise EqualFactors asks for more phases.
// 2. An element c of the field has the coordinates F(c)_i = c A^i u, i < deg q, which are integers
//    for the ways. The complex number is recovered by Lagrange's interpolation (`trace_dual`), in
//    balls.
// 3. The rows of zeta^j v(piece) span a lattice. A basis of it is shortened by the algorithm of
//    Lenstra, Lenstra and Lovasz (1982) with respect to all embeddings, so that multiplication by
//    mu and by zeta has small integer matrices; coordinates then are machine integers, and every
//    operation checks for overflow.
//
// The set is at last scaled so that the longest way has length 1, and turned as late generations
// are drawn.

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

/// The eigenvalue mu of the ways of an unfolding that outgrows all others, and the part of the ways
/// that belongs to it: step 1.
class LeadingFactor {
public:
    /// Looks at the pieces marked as moving. Throws what `Displacement` throws.
    LeadingFactor(const Unfolding& unfolding, const std::vector<bool>& moving,
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

    /// The moving pieces, and the place of one among them.
    const std::vector<std::size_t>& pieces() const { return pieces_; }
    std::size_t place(std::size_t piece) const { return places_[piece]; }

    /// The minimal polynomial q of mu + t zeta.
    const Polynomial& factor() const { return factor_; }
    /// mu + t zeta, and mu itself, to about so many bits.
    ComplexBall root(long bits) const {
        for (const Root& root : roots(factor_, bits))
            if (root.real.overlaps(near_.real) && root.imaginary.overlaps(near_.imaginary))
                return {root.real, root.imaginary};
        throw Error("a root of a polynomial was lost");
    }

    ComplexBall eigenvalue(long bits) const {
        const ComplexBall whole = root(bits), part = shift(bits);
        return {whole.real - part.real, whole.imaginary - part.imaginary};
    }

    /// A^i u for i from 0 to the degree of q, less one: u is the part of the ways that q
    /// annihilates, times an integer. By place.
    const std::vector<std::vector<CyclotomicInteger>>& powers() const { return powers_; }

private:
    /// A times the ways.
    std::vector<CyclotomicInteger> next(const std::vector<CyclotomicInteger>& ways) const {
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

    Polynomial annihilator_of(const std::vector<CyclotomicInteger>& ways,
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

    void choose(const Polynomial& annihilator, std::size_t phases) {
        if (annihilator.degree() < 1) throw Error("the turtle always comes back to where it began");
        const Factorisation factors = factorise(annihilator);
        const ComplexBall centre = shift(root_bits);
        std::vector<Candidate> candidates;
        for (std::size_t k = 0; k < factors.powers.size(); ++k)
            for (const Root& root : roots(factors.powers[k].factor, root_bits)) {
                const ComplexBall number{root.real, root.imaginary};
                const ComplexBall rest{number.real - centre.real,
                                       number.imaginary - centre.imaginary};
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

    /// t zeta
    ComplexBall shift(long bits) const {
        const Rational part(2, Integer(ring_.order()));
        return {cos_pi(part, bits) * Ball(times_, bits), sin_pi(part, bits) * Ball(times_, bits)};
    }

    CyclotomicRing ring_;
    std::vector<std::size_t> pieces_, places_;
    struct Entry {
        std::size_t place;
        std::int64_t heading;
    };
    std::vector<std::vector<Entry>> rows_;  // of M, by place
    std::size_t widest_ = 0;                // no eigenvalue of M is larger
    long times_ = 0;                        // t
    Polynomial factor_;
    ComplexBall near_{Ball(0, 64), Ball(0, 64)};  // mu + t zeta, apart from the other roots of q
    std::vector<std::vector<CyclotomicInteger>> powers_;
};

/// The complex numbers that the coordinates F(c)_i = c A^i u of a number c stand for: the part of u
/// that belongs to the root of the factor, by Lagrange's interpolation.
std::vector<ComplexBall> trace_dual(const Polynomial& factor, const ComplexBall& root) {
    // factor(x) / (x - root), by Horner's rule from the top, over its value at the root.
    const auto degree = static_cast<std::size_t>(factor.degree());
    const long bits = root.real.bits();
    std::vector<ComplexBall> quotient(degree, {Ball(0, bits), Ball(0, bits)});
    ComplexBall carry{Ball(0, bits), Ball(0, bits)};
    for (std::size_t k = degree; k-- > 0;) {
        carry = carry * root + ComplexBall{Ball(factor.coefficient(k + 1), bits), Ball(0, bits)};
        quotient[k] = carry;
    }
    const ComplexBall slope = value_at(derivative(factor), root);
    for (ComplexBall& coefficient : quotient) coefficient = coefficient / slope;
    return quotient;
}

/// The complex numbers that the rows of a basis stand for, for each of some roots of an irreducible
/// polynomial: with relative errors below 2^-digits. Rows are coordinates c A^i u of a number c
/// (see LeadingFactor). `roots` gives the roots to so many bits. Throws BoundReached where that
/// takes too many bits.
std::vector<std::vector<ComplexBall>> numbers_of(
    const IntegerMatrix& basis, const Polynomial& factor,
    const std::function<std::vector<ComplexBall>(long)>& roots, long digits, const Budget& budget) {
    for (long bits = 256 + digits;; bits *= 2) {
        budget.check();
        if (bits > (1 << 16))
            throw BoundReached(Bound::digits, "the lattice of positions needs too many digits");
        std::vector<std::vector<ComplexBall>> numbers;
        bool certain = true;
        for (const ComplexBall& root : roots(bits)) {
            const auto dual = trace_dual(factor, root);
            auto& of_root = numbers.emplace_back();
            for (std::size_t k = 0; k < basis.rows() && certain; ++k) {
                ComplexBall sum{Ball(0, bits), Ball(0, bits)};
                for (std::size_t i = 0; i < dual.size(); ++i)
                    sum = sum + dual[i] * ComplexBall{Ball(basis(k, i), bits), Ball(0, bits)};
                certain = sum.real.is_finite() && sum.imaginary.is_finite();
                if (!certain) break;
                // Quotients, as the numbers may be beyond every double.
                const Ball size = abs(sum.real) + abs(sum.imaginary);
                certain = (sum.real / size).has_radius_below(-digits) &&
                          (sum.imaginary / size).has_radius_below(-digits);
                of_root.push_back(std::move(sum));
            }
        }
        if (certain) return numbers;
    }
}

/// The numbers of a basis with all roots, as integers, to so many bits behind the first of the
/// smallest element.
IntegerMatrix embedded(const IntegerMatrix& basis, const LeadingFactor& leading, long digits,
                       const Budget& budget) {
    if (basis.rows() == 0) return {0, 2 * static_cast<std::size_t>(leading.factor().degree())};
    const auto all_roots = [&](long bits) {
        std::vector<ComplexBall> all;
        for (const Root& root : roots(leading.factor(), bits))
            all.push_back({root.real, root.imaginary});
        return all;
    };
    const auto numbers = numbers_of(basis, leading.factor(), all_roots, digits + 20, budget);
    Rational smallest;  // of basis elements that are not seen to be 0; they may be beyond doubles
    for (std::size_t k = 0; k < basis.rows(); ++k) {
        Rational size;
        for (const auto& of_root : numbers)
            size += abs(of_root[k].real.lower()) + abs(of_root[k].imaginary.lower());
        if (smallest.is_zero() || (!size.is_zero() && size < smallest)) smallest = size;
    }
    const auto bits = static_cast<std::int64_t>(bit_length(smallest.numerator())) -
                      static_cast<std::int64_t>(bit_length(smallest.denominator()));
    const Rational unit = power(Rational(2), bits - digits);
    IntegerMatrix out(basis.rows(), 2 * numbers.size());
    for (std::size_t k = 0; k < basis.rows(); ++k)
        for (std::size_t l = 0; l < numbers.size(); ++l) {
            const auto rounded = [&](const Ball& number) {
                return round_half_even((number / Ball(unit, number.bits())).lower());
            };
            out(k, 2 * l) = rounded(numbers[l][k].real);
            out(k, 2 * l + 1) = rounded(numbers[l][k].imaginary);
        }
    return out;
}

/// One step towards a basis of short elements. Says whether the basis changed.
bool shorten(IntegerMatrix& basis, const LeadingFactor& leading, const Budget& budget) {
    for (long digits = 40;; digits *= 2) {
        if (digits > 20'000)
            throw BoundReached(Bound::digits, "the lattice of positions needs too many digits");
        const IntegerMatrix rows = embedded(basis, leading, digits, budget);
        if (rank(rows) < rows.rows()) continue;
        const IntegerMatrix steps = reducing_matrix(rows);
        basis = steps * basis;
        return steps != IntegerMatrix::identity(basis.rows());
    }
}

/// A basis of the same lattice whose elements are small with all roots of the factor, so that mu
/// and zeta have small matrices in it: by the algorithm of Lenstra, Lenstra and Lovasz (1982).
/// Throws BoundReached where that takes too many digits.
IntegerMatrix short_basis(IntegerMatrix basis, const LeadingFactor& leading, const Budget& budget) {
    constexpr int most_rounds = 50;
    for (int round = 0; round < most_rounds && shorten(basis, leading, budget); ++round) {
    }
    return basis;
}

/// The pieces that some level moves along: the others have no way.
std::vector<bool> moving_pieces(const Unfolding& unfolding) {
    std::vector<bool> moving(unfolding.size(), false);
    for (std::size_t p = 0; p < unfolding.size(); ++p)
        moving[p] = unfolding.moves[p] != CyclotomicRing(unfolding.order).zero();
    for (bool changed = true; changed;) {
        changed = false;
        for (std::size_t p = 0; p < unfolding.size(); ++p)
            for (const Unfolding::Item& item : unfolding.paths[p])
                if (moving[item.piece] && !moving[p]) moving[p] = changed = true;
    }
    return moving;
}

/// matrix / divisor, whose entries are machine integers.
std::vector<Displacement::Vector> small_matrix(const IntegerMatrix& matrix,
                                               const Integer& divisor) {
    std::vector<Displacement::Vector> out(matrix.rows());
    for (std::size_t row = 0; row < matrix.rows(); ++row)
        for (std::size_t column = 0; column < matrix.columns(); ++column) {
            const Integer entry = exact_divide(matrix(row, column), divisor);
            if (!entry.fits_int64())
                throw BoundReached(Bound::digits,
                                   "the lattice of positions needs numbers beyond 64 bits");
            out[row].push_back(entry.to_int64());
        }
    return out;
}

IntegerMatrix wide(const std::vector<Displacement::Vector>& matrix) {
    IntegerMatrix out(matrix.size(), matrix.size());
    for (std::size_t i = 0; i < matrix.size(); ++i)
        for (std::size_t j = 0; j < matrix.size(); ++j) out(i, j) = Integer(matrix[i][j]);
    return out;
}

/// Rows of `images` are those of `generators` under a linear map: the map, on coordinates in the
/// basis (rows) of the lattice that the generators span.
std::vector<Displacement::Vector> map_on_lattice(const IntegerMatrix& generators,
                                                 const IntegerMatrix& images,
                                                 const std::vector<std::size_t>& independent,
                                                 const IntegerMatrix& basis,
                                                 const RationalInverse& basis_inverse) {
    const std::size_t rank = independent.size();
    IntegerMatrix from(rank, rank), to(rank, rank);
    for (std::size_t i = 0; i < rank; ++i)
        for (std::size_t j = 0; j < rank; ++j) {
            from(i, j) = generators(independent[i], j);
            to(i, j) = images(independent[i], j);
        }
    const auto from_inverse = inverse(from);
    const IntegerMatrix mapped = basis * (from_inverse->numerator * to) * basis_inverse.numerator;
    return small_matrix(mapped, from_inverse->denominator * basis_inverse.denominator);
}

/// The first rows that span the same space as all, by elimination modulo a prime: independent
/// modulo a prime, they are independent.
std::vector<std::size_t> independent_rows(const IntegerMatrix& matrix, std::size_t rank) {
    const PrimeField field(prime_below(Residue{1} << 61));
    std::vector<std::size_t> found, pivots;
    std::vector<std::vector<Residue>> reduced;
    for (std::size_t row = 0; row < matrix.rows() && found.size() < rank; ++row) {
        std::vector<Residue> values;
        for (std::size_t j = 0; j < matrix.columns(); ++j)
            values.push_back(field.residue(matrix(row, j)));
        for (std::size_t i = 0; i < reduced.size(); ++i) {
            const Residue times = values[pivots[i]];
            if (times == 0) continue;
            for (std::size_t j = 0; j < values.size(); ++j)
                values[j] = field.subtract(values[j], field.multiply(times, reduced[i][j]));
        }
        const auto pivot =
            std::find_if(values.begin(), values.end(), [](Residue x) { return x != 0; });
        if (pivot == values.end()) continue;
        pivots.push_back(static_cast<std::size_t>(pivot - values.begin()));
        const Residue unit = field.inverse(*pivot);
        for (Residue& value : values) value = field.multiply(value, unit);
        reduced.push_back(std::move(values));
        found.push_back(row);
    }
    return found;
}

/// mu^-k d_k of a piece for a late level k of its phase.
std::complex<double> late_way(const Unfolding& unfolding, std::size_t piece,
                              std::complex<double> factor) {
    const CyclotomicRing ring(static_cast<long>(unfolding.order));
    std::vector<std::complex<double>> ways;
    for (const CyclotomicInteger& move : unfolding.moves) ways.push_back(ring.to_complex(move));
    const std::size_t levels = (100 / unfolding.phases + 1) * unfolding.phases;
    for (std::size_t level = 0; level < levels; ++level) {
        std::vector<std::complex<double>> next(ways.size());
        for (std::size_t p = 0; p < ways.size(); ++p) {
            for (const Unfolding::Item& item : unfolding.paths[p])
                next[p] +=
                    std::polar(1.0, 2 * std::numbers::pi * static_cast<double>(item.heading) /
                                        static_cast<double>(unfolding.order)) *
                    ways[item.piece];
            next[p] /= factor;
        }
        ways = std::move(next);
    }
    return ways[piece];
}

}  // namespace

Displacement::Displacement(const Unfolding& unfolding, const Budget& budget)
    : order_(unfolding.order) {
    const CyclotomicRing ring(static_cast<long>(order_));
    const std::vector<bool> moving = moving_pieces(unfolding);
    const LeadingFactor leading(unfolding, moving, ring, budget);
    const std::size_t degree = ring.degree();
    const auto rank = static_cast<std::size_t>(leading.factor().degree());
    if (rank > largest_rank)
        throw BoundReached(Bound::method, "positions lie in a number field of degree " +
                                              std::to_string(rank) + ", more than " +
                                              std::to_string(largest_rank));

    // A row for zeta^j v(piece), for its image under zeta, and for that under mu.
    const auto coordinates = [&](const std::vector<std::vector<CyclotomicInteger>>& powers,
                                 std::size_t place, std::int64_t heading) {
        std::vector<Integer> row;
        for (std::size_t i = 0; i < rank; ++i)
            row.push_back(
                ring.rotate(powers[i][place], static_cast<long>(heading)).coefficients[0]);
        return row;
    };
    const auto& powers = leading.powers();  // A^i u for i < rank, by moving piece
    std::vector<std::vector<Integer>> generators, turned, scaled;
    for (std::size_t place = 0; place < leading.pieces().size(); ++place) {
        const auto image = [&](std::int64_t heading) {
            std::vector<Integer> sum(rank);
            for (const Unfolding::Item& item : unfolding.paths[leading.pieces()[place]]) {
                if (!moving[item.piece]) continue;
                const auto part =
                    coordinates(powers, leading.place(item.piece), item.heading + heading);
                for (std::size_t i = 0; i < rank; ++i) sum[i] += part[i];
            }
            return sum;
        };
        for (std::size_t j = 0; j < degree; ++j) {
            generators.push_back(coordinates(powers, place, static_cast<std::int64_t>(j)));
            turned.push_back(coordinates(powers, place, static_cast<std::int64_t>(j) + 1));
            scaled.push_back(image(static_cast<std::int64_t>(j)));
        }
        budget.check();
    }
    const IntegerMatrix rows(generators);
    const IntegerMatrix basis = short_basis(lattice_basis(rows), leading, budget);
    if (basis.rows() != rank) throw Error("the ways of the pieces do not span their field");
    const auto basis_inverse = inverse(basis);
    const auto independent = independent_rows(rows, rank);
    scale_ = map_on_lattice(rows, IntegerMatrix(scaled), independent, basis, *basis_inverse);
    polynomial_ = factorise(characteristic_polynomial(wide(scale_))).powers.front().factor;
    const Matrix turn =
        map_on_lattice(rows, IntegerMatrix(turned), independent, basis, *basis_inverse);
    Matrix power(rank, Vector(rank, 0));
    for (std::size_t i = 0; i < rank; ++i) power[i][i] = 1;
    for (std::int64_t heading = 0; heading < order_; ++heading) {
        turns_.push_back(power);
        for (Vector& row : power) row = product(row, turn);
    }

    const IntegerMatrix own = IntegerMatrix(generators) * basis_inverse->numerator;
    ways_.assign(unfolding.size(), Vector(rank, 0));
    for (std::size_t place = 0; place < leading.pieces().size(); ++place)
        for (std::size_t i = 0; i < rank; ++i)
            ways_[leading.pieces()[place]][i] =
                exact_divide(own(place * degree, i), basis_inverse->denominator).to_int64();

    const auto own_root = [&](long bits) { return std::vector<ComplexBall>{leading.root(bits)}; };
    const auto numbers = numbers_of(basis, leading.factor(), own_root, 60, budget);
    for (const ComplexBall& number : numbers.front())
        basis_.emplace_back(number.real.midpoint(), number.imaginary.midpoint());
    const ComplexBall factor = leading.eigenvalue(256);
    factor_ = {factor.real.midpoint(), factor.imaginary.midpoint()};
    // The longest way has length 1, and the direction of late generations turned back.
    std::size_t longest = 0;
    for (std::size_t p = 0; p < ways_.size(); ++p)
        if (std::abs(value(ways_[p])) > std::abs(value(ways_[longest]))) longest = p;
    const std::complex<double> late = late_way(unfolding, longest, factor_);
    const std::complex<double> found = value(ways_[longest]);
    const std::complex<double> frame = late / std::abs(late) / found;
    for (std::complex<double>& number : basis_) number *= frame;
}

Displacement::Vector Displacement::product(const Vector& row, const Matrix& matrix) {
    Vector out(row.size(), 0);
    for (std::size_t i = 0; i < row.size(); ++i) {
        if (row[i] == 0) continue;
        for (std::size_t j = 0; j < out.size(); ++j) {
            std::int64_t part = 0;
            if (__builtin_mul_overflow(row[i], matrix[i][j], &part) ||
                __builtin_add_overflow(out[j], part, &out[j]))
                throw BoundReached(Bound::digits, "positions need numbers beyond 64 bits");
        }
    }
    return out;
}

Displacement::Vector Displacement::turned(const Vector& vector, std::int64_t heading) const {
    heading = normal_heading(heading, order_);
    return heading == 0 ? vector : product(vector, turns_[static_cast<std::size_t>(heading)]);
}

void Displacement::add(Vector& left, const Vector& right) const {
    for (std::size_t i = 0; i < left.size(); ++i)
        if (__builtin_add_overflow(left[i], right[i], &left[i]))
            throw BoundReached(Bound::digits, "positions need numbers beyond 64 bits");
}

void Displacement::subtract(Vector& left, const Vector& right) const {
    for (std::size_t i = 0; i < left.size(); ++i)
        if (__builtin_sub_overflow(left[i], right[i], &left[i]))
            throw BoundReached(Bound::digits, "positions need numbers beyond 64 bits");
}

std::complex<double> Displacement::value(const Vector& vector) const {
    std::complex<double> sum = 0;
    for (std::size_t i = 0; i < vector.size(); ++i)
        sum += static_cast<double>(vector[i]) * basis_[i];
    return sum;
}

// With u = 2^-53: a basis element b stands for the number n times the frame, which is one complex number for
// all. n is known within 2^-60 of its size, rounded once, and multiplied once, which errs by at most sqrt(5) u of
// the size (Brent, Percival and Zimmermann, Error bounds on complex floating-point multiplication, 2007). A
// coordinate is rounded once, multiplied once, and rank - 1 additions follow, each of which errs by at most u of
// the sum of sizes so far. All together that is less than (rank + 8) u times the sum of sizes; twice that
// covers what is of second order, and the rounding of the sum of sizes itself.
double Displacement::error(const Vector& vector) const {
    double sizes = 0;
    for (std::size_t i = 0; i < vector.size(); ++i)
        sizes += std::abs(static_cast<double>(vector[i])) * std::abs(basis_[i]);
    return sizes * static_cast<double>(rank() + 8) * std::numeric_limits<double>::epsilon();
}

}  // namespace algae
