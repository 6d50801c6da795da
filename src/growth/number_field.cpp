#include "growth/number_field.hpp"

namespace algae {

namespace {

Polynomial divided(const Polynomial& value, const Integer& divisor) {
    std::vector<Integer> coefficients;
    for (const Integer& x : value.coefficients()) coefficients.push_back(exact_divide(x, divisor));
    return Polynomial(std::move(coefficients));
}

}  // namespace

Polynomial NumberField::power(Polynomial base, std::size_t exponent) const {
    Polynomial result = reduced(1);
    for (base = reduced(base); exponent != 0; exponent >>= 1) {
        if (exponent & 1) result = multiply(result, base);
        if (exponent > 1) base = multiply(base, base);
    }
    return result;
}

AlgebraicNumber NumberField::simplified(const AlgebraicNumber& value) const {
    Polynomial numerator = reduced(value.numerator);
    Integer denominator = 1;
    const Polynomial below = reduced(value.denominator);
    if (below.degree() <= 0) {
        denominator = below.coefficient(0);
    } else {
        // The matrix of multiplication by the denominator d has a characteristic polynomial
        // x c(x) + c0 with d c(d) == -c0.
        const auto degree = static_cast<std::size_t>(modulus_.degree());
        IntegerMatrix matrix(degree, degree);
        Polynomial row = below;
        for (std::size_t i = 0; i < degree; ++i) {
            for (std::size_t j = 0; j < degree; ++j) matrix(i, j) = row.coefficient(j);
            row = multiply(row, Polynomial({0, 1}));
        }
        const Polynomial characteristic = characteristic_polynomial(matrix);
        Polynomial others;
        for (std::size_t k = degree; k >= 1; --k) others = multiply(others, below) + characteristic.coefficient(k);
        numerator = multiply(numerator, others);
        denominator = -characteristic.coefficient(0);
    }
    Integer divisor = gcd(content(numerator), denominator);
    if (sign(denominator) < 0) divisor.negate();
    return {divided(numerator, divisor), exact_divide(denominator, divisor)};
}

}  // namespace algae
