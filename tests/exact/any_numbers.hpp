#pragma once
// Random numbers for the tests of this room: small ones, huge ones, and those next to the limits
// where a number changes its representation.

#include <rapidcheck.h>

#include <cstdint>
#include <vector>

#include "exact/exact.hpp"

namespace rc {

template <>
struct Arbitrary<algae::Integer> {
    static Gen<algae::Integer> arbitrary() {
        const auto near_a_limit = gen::map(
            gen::tuple(gen::element(0, 31, 53, 61, 62, 63, 64, 128), gen::inRange(-3, 4),
                       gen::arbitrary<bool>()),
            [](const std::tuple<int, int, bool>& parts) {
                const auto& [bits, offset, negative] = parts;
                const algae::Integer value =
                    algae::power(algae::Integer(2), static_cast<std::uint64_t>(bits)) + offset;
                return negative ? -value : value;
            });
        const auto huge = gen::map(
            gen::pair(gen::container<std::vector<std::uint64_t>>(gen::arbitrary<std::uint64_t>()),
                      gen::arbitrary<bool>()),
            [](const std::pair<std::vector<std::uint64_t>, bool>& parts) {
                algae::Integer value;
                for (const std::uint64_t word : parts.first)
                    value = value * algae::power(algae::Integer(2), 57) + word;
                return parts.second ? -value : value;
            });
        const auto small = gen::map(gen::arbitrary<std::int64_t>(),
                                    [](std::int64_t x) { return algae::Integer(x); });
        return gen::oneOf(small, near_a_limit, huge);
    }
};

template <>
struct Arbitrary<algae::Rational> {
    static Gen<algae::Rational> arbitrary() {
        return gen::map(gen::pair(gen::arbitrary<algae::Integer>(), gen::nonZero<algae::Integer>()),
                        [](const std::pair<algae::Integer, algae::Integer>& parts) {
                            return algae::Rational(parts.first, parts.second);
                        });
    }
};

}  // namespace rc

namespace algae {

inline IntegerMatrix any_matrix(std::size_t rows, std::size_t columns) {
    IntegerMatrix matrix(rows, columns);
    for (std::size_t i = 0; i < rows; ++i)
        for (std::size_t j = 0; j < columns; ++j)
            matrix(i, j) = *rc::gen::weightedOneOf<Integer>(
                {{4, rc::gen::map(rc::gen::inRange(-3, 4), [](int x) { return Integer(x); })},
                 {1, rc::gen::arbitrary<Integer>()}});
    return matrix;
}

/// A polynomial of a degree from the one given to the other, so not 0.
inline Polynomial any_polynomial(int least_degree, int largest_degree) {
    const int degree = *rc::gen::inRange(least_degree, largest_degree + 1);
    std::vector<Integer> coefficients;
    for (int i = 0; i < degree; ++i) coefficients.push_back(*rc::gen::inRange(-9, 10));
    coefficients.push_back(*rc::gen::element(-6, -2, -1, 1, 2, 3));
    return Polynomial(std::move(coefficients));
}

/// One of at most this degree, perhaps 0.
inline Polynomial any_polynomial(int largest_degree) {
    std::vector<Integer> coefficients;
    const int length = *rc::gen::inRange(0, largest_degree + 2);
    for (int i = 0; i < length; ++i) coefficients.push_back(*rc::gen::inRange(-9, 10));
    return Polynomial(std::move(coefficients));
}

}  // namespace algae
