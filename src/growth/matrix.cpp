
#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>
#include <random>
#include <string>

#include "exact/exact.hpp"
#include "growth/growth.hpp"
#include "watch/watch.hpp"

// The growth matrix of a D0L system and what its graph says.
//
// Entry (i, j) counts letter j in the successor of letter i, so Parikh vectors of generations are a row vector times powers of
// the matrix (Rozenberg and Salomaa 1980, I.3). Powers are sparse steps while numbers are short, squarings when n is large, and
// every step asks the budget, because lengths of generation n have about n digits. The strongly connected
// components of the graph of letters, in topological order, carry the rest: each has its own characteristic polynomial, and
// chains of components with equal rates give the degree of the polynomial factor in the growth. Primitivity is decided by powers of
// the matrix of zeros and ones.

namespace algae {

namespace {

std::vector<std::size_t> positions(const D0L& system) {
    std::vector<std::size_t> position(system.alphabet->size(), 0);
    for (std::size_t i = 0; i < system.letters.size(); ++i) position[system.letters[i]] = i;
    return position;
}

/// How often each number occurs.
std::vector<GrowthMatrix::Entry> counted_row(std::vector<std::size_t> columns) {
    std::sort(columns.begin(), columns.end());
    std::vector<GrowthMatrix::Entry> row;
    for (const std::size_t column : columns) {
        if (row.empty() || row.back().column != column) row.push_back({column, 0});
        row.back().times += 1;
    }
    return row;
}

}  // namespace

GrowthMatrix growth_matrix(const D0L& system) {
    const auto position = positions(system);
    GrowthMatrix matrix;
    for (const Symbol letter : system.letters) {
        std::vector<std::size_t> columns;
        for (const Symbol a : system.successor(letter)) columns.push_back(position[a]);
        matrix.rows.push_back(counted_row(std::move(columns)));
    }
    return matrix;
}

GrowthMatrix growth_matrix(const Morphism& rules) {
    GrowthMatrix matrix;
    for (const Word& image : rules.images())
        matrix.rows.push_back(counted_row({image.begin(), image.end()}));
    return matrix;
}

GrowthMatrix growth_matrix(const IntegerMatrix& matrix) {
    GrowthMatrix sparse;
    sparse.rows.resize(matrix.rows());
    for (std::size_t i = 0; i < matrix.rows(); ++i)
        for (std::size_t j = 0; j < matrix.columns(); ++j)
            if (!matrix(i, j).is_zero()) sparse.rows[i].push_back({j, matrix(i, j)});
    return sparse;
}

IntegerMatrix dense(const GrowthMatrix& matrix) {
    IntegerMatrix full(matrix.size(), matrix.size());
    for (std::size_t i = 0; i < matrix.size(); ++i)
        for (const auto& [column, times] : matrix.rows[i]) full(i, column) = times;
    return full;
}

std::vector<Integer> axiom_counts(const D0L& system) {
    const auto position = positions(system);
    std::vector<Integer> counts(system.letters.size());
    for (const Symbol a : system.axiom) counts[position[a]] += 1;
    return counts;
}

std::vector<Integer> operator*(const std::vector<Integer>& row, const GrowthMatrix& matrix) {
    if (row.size() != matrix.size())
        throw Error("expected a row of " + std::to_string(matrix.size()) +
                    " numbers, found one of " + std::to_string(row.size()));
    std::vector<Integer> next(row.size());
    for (std::size_t i = 0; i < row.size(); ++i) {
        if (row[i].is_zero()) continue;
        for (const auto& [column, times] : matrix.rows[i])
            if (times == 1)
                next[column] += row[i];
            else
                next[column] += row[i] * times;
    }
    return next;
}

std::vector<Integer> operator*(const GrowthMatrix& matrix, const std::vector<Integer>& column) {
    if (column.size() != matrix.size())
        throw Error("expected a column of " + std::to_string(matrix.size()) +
                    " numbers, found one of " + std::to_string(column.size()));
    std::vector<Integer> next(column.size());
    for (std::size_t i = 0; i < column.size(); ++i)
        for (const auto& [j, times] : matrix.rows[i]) next[i] += column[j] * times;
    return next;
}

std::vector<Integer> lengths(const D0L& system, std::uint64_t count, const Budget& budget) {
    const GrowthMatrix matrix = growth_matrix(system);
    std::vector<Integer> counts = axiom_counts(system), found;
    std::uint64_t bits = 0;
    WorkCount generations("generation", count);
    for (std::uint64_t n = 0; n < count; ++n) {
        budget.check();
        generations.at(n);
        found.push_back(std::accumulate(counts.begin(), counts.end(), Integer()));
        budget.check_memory((bits += bit_length(found.back()) + 64) / 8, "the lengths");
        counts = counts * matrix;
    }
    return found;
}

namespace {

/// Below this, iterating costs no more than squaring, and it does for large alphabets in any case.
constexpr std::uint64_t iterated_generations = 256;
constexpr std::size_t squared_letters = 200;
constexpr std::uint64_t iterated_estimate = 10'000;  // generations of a large alphabet looked ahead

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
                for (std::size_t j = 0; j < size; ++j)
                    product[i * size + j] += left * entries[k * size + j];
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
    WorkCount generations("generation", n);
    for (; n > 0; --n, ++generations) {
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
    if (n <= iterated_generations || size > squared_letters)
        return iterate(system, std::move(counts), n, budget);
    check_estimate(system, n, size * size, budget);
    IntegerMatrix square = incidence_matrix(system);
    WorkCount squarings("squaring", static_cast<std::uint64_t>(std::bit_width(n)));
    for (;; ++squarings) {
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
                    for (const Symbol a : system.successor(system.letters[i]))
                        next[position[a]] += counts[i];
            exponent += ScaledMatrix::rescale(next);
            counts = std::move(next);
        }
    } else {
        ScaledMatrix power{size, std::vector<double>(size * size, 0), 0};
        for (std::size_t i = 0; i < size; ++i)
            for (const Symbol a : system.successor(system.letters[i]))
                power.entries[i * size + position[a]] += 1;
        for (;; power.square()) {
            budget.check();
            if (n & 1) {
                std::vector<double> next(size, 0);
                for (std::size_t i = 0; i < size; ++i)
                    for (std::size_t j = 0; j < size; ++j)
                        next[j] += counts[i] * power.entries[i * size + j];
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

namespace {

/// The part of the matrix that stays within a component.
GrowthMatrix part(const GrowthMatrix& matrix, const Component& component,
                  const std::vector<std::size_t>& of_letter, std::vector<std::size_t>& place) {
    const std::size_t self = of_letter[component.letters.front()];
    for (std::size_t i = 0; i < component.letters.size(); ++i) place[component.letters[i]] = i;
    GrowthMatrix found;
    found.rows.resize(component.letters.size());
    for (std::size_t i = 0; i < component.letters.size(); ++i) {
        for (const auto& [column, times] : matrix.rows[component.letters[i]])
            if (of_letter[column] == self) found.rows[i].push_back({place[column], times});
        std::sort(found.rows[i].begin(), found.rows[i].end(),
                  [](const auto& a, const auto& b) { return a.column < b.column; });
    }
    return found;
}

/// The greatest common divisor of all distance(from) + 1 - distance(to).
std::uint64_t cyclicity(const GrowthMatrix& part) {
    std::vector<std::int64_t> distance(part.size(), -1);
    std::vector<std::size_t> queue{0};
    distance[0] = 0;
    std::uint64_t divisor = 0;
    for (std::size_t i = 0; i < queue.size(); ++i)
        for (const auto& entry : part.rows[queue[i]]) {
            if (distance[entry.column] < 0) {
                distance[entry.column] = distance[queue[i]] + 1;
                queue.push_back(entry.column);
            }
            divisor = std::gcd(divisor, static_cast<std::uint64_t>(std::abs(
                                            distance[queue[i]] + 1 - distance[entry.column])));
        }
    return divisor;
}

Integer row_sum(const std::vector<GrowthMatrix::Entry>& row) {
    Integer sum;
    for (const auto& entry : row) sum += entry.times;
    return sum;
}

void analyse(Component& component, const GrowthMatrix& part, const Budget& budget) {
    component.characteristic = factorise(characteristic_polynomial(part, budget));
    if (part.rows[0].empty())
        return;  // a letter that never returns: another one would have a way back
    component.cyclicity = cyclicity(part);
    Integer least = row_sum(part.rows[0]), most = least;
    for (const auto& row : part.rows) {
        least = std::min(least, row_sum(row));
        most = std::max(most, row_sum(row));
    }
    if (least == most)
        component.rate = Rate(most);
    else
        component.rate = spectral_radius(component.characteristic.powers, most);
}

}  // namespace

Components components(const GrowthMatrix& matrix, const Budget& budget) {
    std::vector<std::vector<std::size_t>> successors(matrix.size());
    for (std::size_t i = 0; i < matrix.size(); ++i)
        for (const auto& entry : matrix.rows[i]) successors[i].push_back(entry.column);
    Components found;
    found.of_letter = strong_components(successors);
    std::vector<std::size_t> place(matrix.size());
    for (std::size_t i = 0; i < matrix.size(); ++i) {
        found.list.resize(std::max(found.list.size(), found.of_letter[i] + 1));
        found.list[found.of_letter[i]].letters.push_back(i);
    }
    WorkCount parts("component", found.list.size());
    for (std::size_t c = 0; c < found.list.size(); ++c) {
        budget.check();
        parts.at(c + 1);
        Component& component = found.list[c];
        for (const std::size_t letter : component.letters)
            for (const auto& entry : matrix.rows[letter])
                if (found.of_letter[entry.column] != c)
                    component.below.push_back(found.of_letter[entry.column]);
        std::sort(component.below.begin(), component.below.end());
        component.below.erase(std::unique(component.below.begin(), component.below.end()),
                              component.below.end());
        analyse(component, part(matrix, component, found.of_letter, place), budget);
    }
    return found;
}

namespace {

constexpr std::size_t small_size = 60;        // where FLINT's general algorithm is fast
constexpr std::size_t most_identities = 120;  // how far powers of the matrix are worked out

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
    const auto elementary = [&](std::size_t k) {
        return k <= degree ? value.coefficient(degree - k) : Integer();
    };
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
    std::sort(factors.powers.begin(), factors.powers.end(),
              [](const auto& left, const auto& right) {
                  if (left.factor.degree() != right.factor.degree())
                      return left.factor.degree() < right.factor.degree();
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
    if (size == 1)
        return Polynomial({matrix.rows[0].empty() ? Integer() : -matrix.rows[0][0].times, 1});
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

MatrixPolynomials matrix_polynomials(const GrowthMatrix& matrix, const Components& components,
                                     const Budget& budget) {
    MatrixPolynomials found;
    found.characteristic_factors.content = 1;
    auto& powers = found.characteristic_factors.powers;
    for (const Component& component : components.list)
        for (const auto& own : component.characteristic.powers) {
            const auto known = std::find_if(powers.begin(), powers.end(), [&](const auto& power) {
                return power.factor == own.factor;
            });
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

namespace {

/// A square matrix of zeros and ones, 64 to a word.
class BooleanMatrix {
public:
    explicit BooleanMatrix(const GrowthMatrix& matrix) : BooleanMatrix(matrix.size()) {
        for (std::size_t i = 0; i < size_; ++i)
            for (const auto& entry : matrix.rows[i]) set(i, entry.column);
    }

    friend BooleanMatrix operator*(const BooleanMatrix& left, const BooleanMatrix& right) {
        BooleanMatrix product(left.size_);
        for (std::size_t i = 0; i < left.size_; ++i)
            for (std::size_t k = 0; k < left.size_; ++k)
                if (left.has(i, k))
                    for (std::size_t w = 0; w < left.words_; ++w)
                        product.bits_[i * left.words_ + w] |= right.bits_[k * left.words_ + w];
        return product;
    }

    bool is_full() const {
        for (std::size_t i = 0; i < size_; ++i)
            for (std::size_t j = 0; j < size_; ++j)
                if (!has(i, j)) return false;
        return true;
    }
    void add_identity() {
        for (std::size_t i = 0; i < size_; ++i) set(i, i);
    }

private:
    explicit BooleanMatrix(std::size_t size)
        : size_(size), words_((size + 63) / 64), bits_(size * words_, 0) {}
    bool has(std::size_t i, std::size_t j) const {
        return (bits_[i * words_ + j / 64] >> (j % 64) & 1) != 0;
    }
    void set(std::size_t i, std::size_t j) {
        bits_[i * words_ + j / 64] |= std::uint64_t{1} << (j % 64);
    }

    std::size_t size_, words_;
    std::vector<std::uint64_t> bits_;
};

/// Whether some power not beyond size - 1 of matrix + 1 is full.
bool is_irreducible(const GrowthMatrix& matrix) {
    BooleanMatrix power(matrix);
    if (matrix.size() == 1) return power.is_full();
    power.add_identity();
    for (std::size_t steps = 1; steps < matrix.size(); steps *= 2) power = power * power;
    return power.is_full();
}

}  // namespace

Primitivity primitivity(const GrowthMatrix& matrix) {
    Primitivity found;
    const std::uint64_t size = matrix.size();
    if (size == 0) return found;
    found.irreducible = is_irreducible(matrix);
    if (!found.irreducible) return found;
    // Once a power is full all later ones are, and Wielandt's bound says when it must be.
    const std::uint64_t bound = (size - 1) * (size - 1) + 1;
    std::vector<BooleanMatrix> doubled{BooleanMatrix(matrix)};
    while ((std::uint64_t{1} << (doubled.size() - 1)) < bound && !doubled.back().is_full())
        doubled.push_back(doubled.back() * doubled.back());
    if (!doubled.back().is_full()) return found;
    if (doubled.size() == 1) {
        found.exponent = 1;
        return found;
    }
    doubled
        .pop_back();  // the largest power of two that is not enough, and what must be added to it
    BooleanMatrix power = doubled.back();
    std::uint64_t exponent = std::uint64_t{1} << (doubled.size() - 1);
    for (std::size_t k = doubled.size() - 1; k-- > 0;) {
        BooleanMatrix next = power * doubled[k];
        if (next.is_full()) continue;
        power = std::move(next);
        exponent += std::uint64_t{1} << k;
    }
    found.exponent = exponent + 1;
    return found;
}

namespace {

/// One of the two recurrences.
struct Extreme {
    bool most;
    std::vector<Integer> lengths;      // by symbol: of what it becomes in some number of steps
    std::vector<std::size_t> choices;  // by place in OL::letters: the choice of the first of them

    Integer length(const Word& word) const {
        Integer sum;
        for (const Symbol a : word) sum += lengths[a];
        return sum;
    }

    void step(const OL& system) {
        std::vector<Integer> next(lengths.size());
        for (std::size_t i = 0; i < system.letters.size(); ++i) {
            const auto& successors = system.successors[system.letters[i]];
            Integer& best = next[system.letters[i]];
            for (std::size_t k = 0; k < successors.size(); ++k) {
                Integer candidate = length(successors[k]);
                if (k != 0 && !(most ? candidate > best : candidate < best)) continue;
                best = std::move(candidate);
                choices[i] = k;
            }
        }
        lengths = std::move(next);
    }
};

}  // namespace

LengthBounds length_bounds(const OL& system, std::uint64_t n, const Budget& budget) {
    const std::vector<Integer> ones(system.alphabet->size(), 1);
    const std::vector<std::size_t> first(system.letters.size(), 0);
    Extreme least{false, ones, first}, most{true, ones, first};
    LengthBounds found;
    std::uint64_t bits = 0;
    for (std::uint64_t k = 0;; ++k) {
        budget.check();
        found.least.push_back(least.length(system.axiom));
        found.most.push_back(most.length(system.axiom));
        budget.check_memory((bits += 2 * bit_length(found.most.back()) + 128) / 8, "the lengths");
        if (k == n) break;
        least.step(system);
        most.step(system);
    }
    found.least_choice = least.choices;
    found.most_choice = most.choices;
    return found;
}

D0L chosen_system(const OL& system, const std::vector<std::size_t>& choices) {
    std::vector<Word> images;
    for (const auto& successors : system.successors) images.push_back(successors.front());
    for (std::size_t i = 0; i < system.letters.size(); ++i)
        images[system.letters[i]] = system.successors[system.letters[i]][choices.at(i)];
    return make_d0l(system.alphabet, system.axiom, std::move(images), system.name);
}

}  // namespace algae
