#include "dimension/displacement.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/error.hpp"
#include "dimension/leading_factor.hpp"
#include "dimension/short_basis.hpp"
#include "growth/complex_ball.hpp"
#include "growth/residues.hpp"

namespace algae {

namespace {

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

/// The first rows that span the same space as all, by elimination modulo a prime: independent modulo
/// a prime, they are independent.
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
    for (std::complex<double>& number : basis_) number *= late / std::abs(late) / found;
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

}  // namespace algae
