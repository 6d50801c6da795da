#include "growth/characteristic.hpp"

#include <algorithm>
#include <map>
#include <random>

#include "growth/annihilator.hpp"

namespace algae {

namespace {

constexpr std::size_t small_size = 60;         // where FLINT's general algorithm is fast
constexpr std::size_t most_identities = 120;   // how far powers of the matrix are worked out

Integer trace(const IntegerMatrix& matrix) {
    Integer sum;
    for (std::size_t i = 0; i < matrix.rows(); ++i) sum += matrix(i, i);
    return sum;
}

IntegerMatrix product(const GrowthMatrix& left, const IntegerMatrix& right) {
    IntegerMatrix found(right.rows(), right.columns());
    for (std::size_t i = 0; i < left.size(); ++i)
        for (const auto& [k, times] : left.rows[i])
            for (std::size_t j = 0; j < right.columns(); ++j)
                if (!right(k, j).is_zero()) found(i, j) += times * right(k, j);
    return found;
}

/// The sums of the first `count` powers of the roots of a monic polynomial, by Newton's identities.
std::vector<Integer> power_sums(const Polynomial& value, std::size_t count) {
    const auto degree = static_cast<std::size_t>(value.degree());
    const auto elementary = [&](std::size_t k) { return k <= degree ? value.coefficient(degree - k) : Integer(); };
    std::vector<Integer> sums;
    for (std::size_t k = 1; k <= count; ++k) {
        Integer sum = -elementary(k) * Integer(k);
        for (std::size_t j = 1; j < k; ++j) sum -= elementary(j) * sums[k - j - 1];
        sums.push_back(std::move(sum));
    }
    return sums;
}

/// The monic polynomial of this degree with these sums of powers of its roots.
Polynomial polynomial_with(const std::vector<Integer>& sums) {
    std::vector<Integer> falling{1};  // coefficients from the leading one
    for (std::size_t k = 1; k <= sums.size(); ++k) {
        Integer sum;
        for (std::size_t j = 1; j <= k; ++j) sum -= falling[k - j] * sums[j - 1];
        falling.push_back(exact_divide(sum, Integer(k)));
    }
    std::reverse(falling.begin(), falling.end());
    return Polynomial(std::move(falling));
}

/// How often x divides the minimal polynomial: from which power on the rank stays.
unsigned index_of_zero(const GrowthMatrix& matrix, std::size_t nonzero_roots) {
    IntegerMatrix power = dense(matrix);
    unsigned index = 1;
    while (rank(power) != nonzero_roots) {
        power = product(matrix, power);
        ++index;
    }
    return index;
}

Polynomial multiplied(const Factorisation& factors) {
    Polynomial product = factors.content;
    for (const auto& [factor, exponent] : factors.powers) product *= power(factor, exponent);
    return product;
}

void sort(Factorisation& factors) {
    std::sort(factors.powers.begin(), factors.powers.end(), [](const auto& left, const auto& right) {
        if (left.factor.degree() != right.factor.degree()) return left.factor.degree() < right.factor.degree();
        const auto &a = left.factor.coefficients(), &b = right.factor.coefficients();
        return std::lexicographical_compare(a.rbegin(), a.rend(), b.rbegin(), b.rend());
    });
}

Factorisation minimal_factors(const GrowthMatrix& matrix, const Factorisation& characteristic) {
    Factorisation found = characteristic;
    const Polynomial variable({0, 1});
    bool simple = true;
    std::size_t nonzero = 0;
    for (const auto& [factor, exponent] : characteristic.powers) {
        if (factor == variable) continue;
        simple = simple && exponent == 1;
        nonzero += static_cast<std::size_t>(factor.degree()) * exponent;
    }
    if (simple) {
        for (auto& [factor, exponent] : found.powers)
            if (factor == variable && exponent > 1) exponent = index_of_zero(matrix, nonzero);
        return found;
    }
    Polynomial rest = minimal_polynomial(dense(matrix));
    for (auto& [factor, exponent] : found.powers) {
        exponent = 0;
        while (const auto quotient = exact_divide(rest, factor)) {
            rest = *quotient;
            ++exponent;
        }
    }
    return found;
}

}  // namespace

Polynomial characteristic_polynomial(const GrowthMatrix& matrix, const Budget& budget) {
    const std::size_t size = matrix.size();
    if (size == 1) return Polynomial({matrix.rows[0].empty() ? Integer() : -matrix.rows[0][0].times, 1});
    if (size <= small_size) return characteristic_polynomial(dense(matrix));
    std::mt19937_64 random(2026);
    std::vector<Integer> row(size), column(size);
    for (Integer& x : row) x = static_cast<long>(random() >> 34);
    for (Integer& x : column) x = static_cast<long>(random() >> 34);
    const Polynomial found = annihilator(row, matrix, column, budget);
    const std::size_t missing = size - static_cast<std::size_t>(found.degree());
    if (missing > most_identities) return characteristic_polynomial(dense(matrix));
    std::vector<Integer> sums = power_sums(found, missing);
    IntegerMatrix power = IntegerMatrix::identity(size);
    for (std::size_t k = 0; k < missing; ++k) {
        budget.check();
        power = product(matrix, power);
        sums[k] = trace(power) - sums[k];
    }
    return found * polynomial_with(sums);
}

MatrixPolynomials matrix_polynomials(const GrowthMatrix& matrix, const Components& components, const Budget& budget) {
    MatrixPolynomials found;
    found.characteristic_factors.content = 1;
    auto& powers = found.characteristic_factors.powers;
    for (const Component& component : components.list)
        for (const auto& own : component.characteristic.powers) {
            const auto known = std::find_if(powers.begin(), powers.end(),
                                            [&](const auto& power) { return power.factor == own.factor; });
            if (known == powers.end())
                powers.push_back(own);
            else
                known->exponent += own.exponent;
        }
    sort(found.characteristic_factors);
    budget.check();
    found.minimal_factors = minimal_factors(matrix, found.characteristic_factors);
    found.characteristic = multiplied(found.characteristic_factors);
    found.minimal = multiplied(found.minimal_factors);
    return found;
}

MatrixPolynomials matrix_polynomials(const GrowthMatrix& matrix, const Budget& budget) {
    return matrix_polynomials(matrix, components(matrix, budget), budget);
}

}  // namespace algae
