#include "growth/incidence.hpp"

#include <algorithm>
#include <string>

#include "base/error.hpp"
#include "fold/lifts.hpp"

namespace algae {

namespace {

/// Below this, iterating costs no more than squaring, and it does for large alphabets in any case.
constexpr std::uint64_t iterated_generations = 256;
constexpr std::size_t squared_letters = 200;

std::vector<std::size_t> positions(const D0L& system) {
    std::vector<std::size_t> position(system.alphabet->size(), 0);
    for (std::size_t i = 0; i < system.letters.size(); ++i) position[system.letters[i]] = i;
    return position;
}

std::vector<Integer> count(const D0L& system, const Word& word) {
    const auto position = positions(system);
    std::vector<Integer> counts(system.letters.size());
    for (const Symbol a : word) counts[position[a]] += 1;
    return counts;
}

void check_size(const std::vector<Integer>& numbers, const Budget& budget) {
    std::uint64_t bits = 0;
    for (const Integer& number : numbers) bits += bit_length(number);
    budget.check_memory(bits / 8, "the numbers of letters");
}

std::vector<Integer> iterate(const D0L& system, std::vector<Integer> counts, std::uint64_t n,
                             const Budget& budget) {
    // How often a letter occurs in a successor, without the zeros of the matrix.
    struct Share {
        std::size_t to;
        Integer times;
    };
    const auto position = positions(system);
    std::vector<std::vector<Share>> shares(system.letters.size());
    for (std::size_t i = 0; i < system.letters.size(); ++i) {
        Word letters = system.successor(system.letters[i]);
        std::sort(letters.begin(), letters.end());
        for (const Symbol a : letters) {
            if (shares[i].empty() || shares[i].back().to != position[a]) shares[i].push_back({position[a], 0});
            shares[i].back().times += 1;
        }
    }
    for (; n > 0; --n) {
        budget.check();
        std::vector<Integer> next(counts.size());
        for (std::size_t i = 0; i < counts.size(); ++i) {
            if (counts[i].is_zero()) continue;
            for (const Share& share : shares[i]) next[share.to] += counts[i] * share.times;
        }
        if (next == counts) break;  // and so for ever
        counts = std::move(next);
        check_size(counts, budget);
    }
    return counts;
}

}  // namespace

IntegerMatrix incidence_matrix(const D0L& system) {
    const std::size_t size = system.letters.size();
    const auto position = positions(system);
    IntegerMatrix matrix(size, size);
    for (std::size_t i = 0; i < size; ++i)
        for (const Symbol a : system.successor(system.letters[i])) matrix(i, position[a]) += 1;
    return matrix;
}

std::vector<Integer> parikh_vector(const D0L& system, std::uint64_t n, const Budget& budget) {
    std::vector<Integer> counts = count(system, system.axiom);
    const std::size_t size = counts.size();
    if (n <= iterated_generations || size > squared_letters) return iterate(system, std::move(counts), n, budget);
    const std::uint64_t largest_bits = budget.memory * 8 / (3 * size * size);
    const auto check = [&](const IntegerMatrix& matrix) {
        budget.check();
        for (std::size_t i = 0; i < size; ++i)
            for (std::size_t j = 0; j < size; ++j)
                if (bit_length(matrix(i, j)) > largest_bits)
                    throw BoundReached("the numbers of letters in generation " + std::to_string(n) +
                                       " would take more than the " + std::to_string(budget.memory >> 20) +
                                       " MiB allowed by --max-memory");
    };
    IntegerMatrix square = incidence_matrix(system);
    for (;;) {
        if (n & 1) counts = counts * square;
        n >>= 1;
        if (n == 0) return counts;
        square = square * square;
        check(square);
    }
}

Integer length(const D0L& system, std::uint64_t n, const Budget& budget) {
    Integer sum = 0;
    for (const Integer& letters : parikh_vector(system, n, budget)) sum += letters;
    return sum;
}

}  // namespace algae
