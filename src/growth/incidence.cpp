#include "growth/incidence.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "base/error.hpp"
#include "growth/growth_matrix.hpp"

namespace algae {

namespace {

/// Below this, iterating costs no more than squaring, and it does for large alphabets in any case.
constexpr std::uint64_t iterated_generations = 256;
constexpr std::size_t squared_letters = 200;
constexpr std::uint64_t iterated_estimate = 10'000;  // generations of a large alphabet looked ahead

std::vector<std::size_t> positions(const D0L& system) {
    std::vector<std::size_t> position(system.alphabet->size(), 0);
    for (std::size_t i = 0; i < system.letters.size(); ++i) position[system.letters[i]] = i;
    return position;
}

void check_size(const std::vector<Integer>& numbers, const Budget& budget) {
    std::uint64_t bits = 0;
    for (const Integer& number : numbers) bits += bit_length(number);
    budget.check_memory(bits / 8, "the numbers of letters");
}

/// Throws BoundReached if so many numbers of the size of the length would be too much.
void check_estimate(const D0L& system, std::uint64_t n, std::size_t numbers, const Budget& budget) {
    const double bits = estimated_log2_length(system, n, budget);
    const double digits = bits * std::log10(2.0);
    if (digits > static_cast<double>(budget.letters))
        throw BoundReached(Bound::letters,
                           "the length of generation " + std::to_string(n) + " alone has about " +
                               std::to_string(static_cast<std::uint64_t>(std::min(digits, 1e19))) +
                               " digits, more than the " + std::to_string(budget.letters) +
                               " allowed" + budget.by(Bound::letters));
    if (bits / 8 * 3 * static_cast<double>(numbers) > static_cast<double>(budget.memory))
        throw BoundReached(Bound::memory, "the numbers of letters in generation " +
                                              std::to_string(n) + " would take more than the " +
                                              std::to_string(budget.memory >> 20) + " MiB allowed" +
                                              budget.by(Bound::memory));
}

/// A square matrix of doubles with a common power of two.
struct ScaledMatrix {
    std::size_t size;
    std::vector<double> entries;
    double exponent = 0;

    void square() {
        std::vector<double> product(size * size, 0);
        for (std::size_t i = 0; i < size; ++i)
            for (std::size_t k = 0; k < size; ++k) {
                const double left = entries[i * size + k];
                if (left == 0) continue;
                for (std::size_t j = 0; j < size; ++j) product[i * size + j] += left * entries[k * size + j];
            }
        entries = std::move(product);
        exponent = 2 * exponent + rescale(entries);
    }

    /// Divides by the power of two at the largest entry and returns the exponent.
    static double rescale(std::vector<double>& numbers) {
        double largest = 0;
        for (const double number : numbers) largest = std::max(largest, number);
        if (largest == 0) return 0;
        const int shift = std::ilogb(largest);
        for (double& number : numbers) number = std::scalbn(number, -shift);
        return shift;
    }
};

std::vector<Integer> iterate(const D0L& system, std::vector<Integer> counts, std::uint64_t n,
                             const Budget& budget) {
    const GrowthMatrix matrix = growth_matrix(system);
    for (; n > 0; --n) {
        budget.check();
        std::vector<Integer> next = counts * matrix;
        if (next == counts) break;  // and so for ever
        counts = std::move(next);
        check_size(counts, budget);
    }
    return counts;
}

}  // namespace

IntegerMatrix incidence_matrix(const D0L& system) { return dense(growth_matrix(system)); }

std::vector<Integer> parikh_vector(const D0L& system, std::uint64_t n, const Budget& budget) {
    std::vector<Integer> counts = axiom_counts(system);
    const std::size_t size = counts.size();
    if (size > squared_letters) check_estimate(system, n, size, budget);
    if (n <= iterated_generations || size > squared_letters) return iterate(system, std::move(counts), n, budget);
    check_estimate(system, n, size * size, budget);
    IntegerMatrix square = incidence_matrix(system);
    for (;;) {
        if (n & 1) counts = counts * square;
        n >>= 1;
        if (n == 0) return counts;
        budget.check();
        square = square * square;
    }
}

double estimated_log2_length(const D0L& system, std::uint64_t n, const Budget& budget) {
    const auto position = positions(system);
    const std::size_t size = system.letters.size();
    std::vector<double> counts(size, 0);
    for (const Symbol a : system.axiom) counts[position[a]] += 1;
    double exponent = 0;
    if (size > squared_letters) {
        for (std::uint64_t k = 0; k < std::min(n, iterated_estimate); ++k) {
            budget.check();
            std::vector<double> next(size, 0);
            for (std::size_t i = 0; i < size; ++i)
                if (counts[i] != 0)
                    for (const Symbol a : system.successor(system.letters[i])) next[position[a]] += counts[i];
            exponent += ScaledMatrix::rescale(next);
            counts = std::move(next);
        }
    } else {
        ScaledMatrix power{size, std::vector<double>(size * size, 0), 0};
        for (std::size_t i = 0; i < size; ++i)
            for (const Symbol a : system.successor(system.letters[i])) power.entries[i * size + position[a]] += 1;
        for (;; power.square()) {
            budget.check();
            if (n & 1) {
                std::vector<double> next(size, 0);
                for (std::size_t i = 0; i < size; ++i)
                    for (std::size_t j = 0; j < size; ++j) next[j] += counts[i] * power.entries[i * size + j];
                exponent += power.exponent + ScaledMatrix::rescale(next);
                counts = std::move(next);
            }
            n >>= 1;
            if (n == 0) break;
        }
    }
    double sum = 0;
    for (const double number : counts) sum += number;
    return std::log2(sum) + exponent;
}

Integer length(const D0L& system, std::uint64_t n, const Budget& budget) {
    Integer sum = 0;
    for (const Integer& letters : parikh_vector(system, n, budget)) sum += letters;
    return sum;
}

}  // namespace algae
