#include "growth/annihilator.hpp"

#include <algorithm>
#include <numeric>
#include <random>

#include "base/error.hpp"
#include "growth/residues.hpp"

namespace algae {

namespace {

bool is_zero(const std::vector<Integer>& numbers) {
    return std::all_of(numbers.begin(), numbers.end(), [](const Integer& x) { return x.is_zero(); });
}

/// row * p(matrix), by Horner's rule.
std::vector<Integer> image(const Polynomial& p, const std::vector<Integer>& row, const GrowthMatrix& matrix,
                           const Budget& budget) {
    std::vector<Integer> sum(row.size());
    for (std::size_t k = p.coefficients().size(); k-- > 0;) {
        budget.check();
        sum = sum * matrix;
        const Integer& coefficient = p.coefficients()[k];
        if (coefficient.is_zero()) continue;
        for (std::size_t i = 0; i < row.size(); ++i)
            if (!row[i].is_zero()) sum[i] += row[i] * coefficient;
    }
    return sum;
}

/// The numbers row * matrix^n * column modulo a prime, for n < 2 size.
std::vector<Residue> residues_of(const std::vector<Integer>& row, const GrowthMatrix& matrix,
                                 const std::vector<Integer>& column, const PrimeField& field) {
    struct Entry {
        std::size_t column;
        Residue times;
    };
    std::vector<std::vector<Entry>> rows(matrix.size());
    for (std::size_t i = 0; i < matrix.size(); ++i)
        for (const auto& [j, times] : matrix.rows[i]) rows[i].push_back({j, field.residue(times)});
    std::vector<Residue> now, end, found;
    for (const Integer& x : row) now.push_back(field.residue(x));
    for (const Integer& x : column) end.push_back(field.residue(x));
    for (std::size_t n = 0; n < 2 * matrix.size(); ++n) {
        Residue sum = 0;
        for (std::size_t i = 0; i < now.size(); ++i) sum = field.add(sum, field.multiply(now[i], end[i]));
        found.push_back(sum);
        std::vector<Residue> next(now.size(), 0);
        for (std::size_t i = 0; i < now.size(); ++i)
            if (now[i] != 0)
                for (const auto& [j, times] : rows[i]) next[j] = field.add(next[j], field.multiply(now[i], times));
        now = std::move(next);
    }
    return found;
}

/// The residues of one number modulo more and more primes, and the number of least size they allow.
struct Reconstruction {
    std::vector<Integer> values;
    Integer modulus = 1;

    void restart(const std::vector<Residue>& residues, Residue prime) {
        values.assign(residues.size(), 0);
        modulus = 1;
        extend(residues, PrimeField(prime));
    }

    /// Returns whether the numbers stay as they are.
    bool extend(const std::vector<Residue>& residues, const PrimeField& field) {
        const Residue inverse = field.inverse(field.residue(modulus));
        const Integer larger = modulus * field.prime();
        bool stands = true;
        for (std::size_t i = 0; i < values.size(); ++i) {
            const Residue missing = field.multiply(field.subtract(residues[i], field.residue(values[i])), inverse);
            if (missing == 0) continue;
            stands = false;
            values[i] += modulus * missing;
            if (values[i] + values[i] > larger) values[i] -= larger;
        }
        modulus = larger;
        return stands;
    }
};

}  // namespace

bool annihilates(const Polynomial& p, const std::vector<Integer>& row, const GrowthMatrix& matrix,
                 const std::vector<Integer>& column, const Budget& budget) {
    std::vector<Integer> rest = image(p, row, matrix, budget);
    for (std::size_t n = 0; n < matrix.size() && !is_zero(rest); ++n) {
        budget.check();
        if (!dot(rest, column).is_zero()) return false;
        rest = rest * matrix;
    }
    return true;
}

Polynomial annihilator(const std::vector<Integer>& row, const GrowthMatrix& matrix,
                       const std::vector<Integer>& column, const Budget& budget) {
    Reconstruction found;
    std::size_t order = 0;
    for (Residue prime = prime_below(Residue{1} << 61);; prime = prime_below(prime)) {
        budget.check();
        const PrimeField field(prime);
        const std::vector<Residue> polynomial =
            shortest_recurrence_modulo(residues_of(row, matrix, column, field), field);
        if (polynomial.size() < order + 1) continue;  // a prime for which the sequence is simpler
        bool stands = false;
        if (polynomial.size() > order + 1 || found.values.empty()) {
            order = polynomial.size() - 1;
            found.restart(polynomial, prime);
            stands = std::all_of(found.values.begin(), found.values.end(),
                                 [](const Integer& x) { return bit_length(x) < 50; });
        } else {
            stands = found.extend(polynomial, field);
        }
        if (!stands) continue;
        Polynomial candidate(found.values);
        if (annihilates(candidate, row, matrix, column, budget)) return candidate;
    }
}

Polynomial annihilator(const std::vector<Integer>& row, const GrowthMatrix& matrix, const Budget& budget) {
    std::mt19937_64 random(2026);
    for (;;) {
        std::vector<Integer> column(row.size());
        for (Integer& x : column) x = static_cast<long>(random() >> 34);
        Polynomial found = annihilator(row, matrix, column, budget);
        if (is_zero(image(found, row, matrix, budget))) return found;
    }
}

}  // namespace algae
