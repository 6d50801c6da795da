#include <algorithm>
#include <limits>
#include <map>
#include <optional>
#include <random>

#include "exact/exact.hpp"
#include "growth/growth.hpp"
#include "watch/watch.hpp"

// From the matrix to formulas: the shortest recurrence, the generating function and the closed form of lengths.
//
// The shortest recurrence is found modulo primes of 61 bits (Berlekamp and Massey), lifted to integers by the Chinese remainder
// theorem, and only then proved: the candidate is checked against the matrix exactly, on as many terms as the space has dimensions that the
// row goes through, at most as there are letters. Letters that grow alike are one before that (`lumped`): of 8,301 states of a plant 1,366 are left. A prime for which the sequence is simpler only costs another round. In the closed form, roots that are
// zeta times one number for roots of unity zeta are taken together, so that periodic factors appear as residues of n
// and not as complex roots. What has no form that a person would write stays enclosed, and the text says so.

namespace algae {

namespace {

bool is_zero(const std::vector<Integer>& numbers) {
    return std::all_of(numbers.begin(), numbers.end(),
                       [](const Integer& x) { return x.is_zero(); });
}

/// row * p(matrix), by Horner's rule.
std::vector<Integer> image(const Polynomial& p, const std::vector<Integer>& row,
                           const GrowthMatrix& matrix, const Budget& budget) {
    std::vector<Integer> sum(row.size());
    WorkCount coefficients("coefficient", p.coefficients().size());
    for (std::size_t k = p.coefficients().size(); k-- > 0;) {
        budget.check();
        ++coefficients;
        sum = sum * matrix;
        const Integer& coefficient = p.coefficients()[k];
        if (coefficient.is_zero()) continue;
        for (std::size_t i = 0; i < row.size(); ++i)
            if (!row[i].is_zero()) sum[i] += row[i] * coefficient;
    }
    return sum;
}

/// The numbers row * matrix^n * column modulo a prime, as many of them as are asked for.
class ResidueTerms {
public:
    ResidueTerms(const std::vector<Integer>& row, const GrowthMatrix& matrix,
                 const std::vector<Integer>& column, const PrimeField& field)
        : field_(field), rows_(matrix.size()) {
        for (std::size_t i = 0; i < matrix.size(); ++i)
            for (const auto& [j, times] : matrix.rows[i])
                rows_[i].push_back({j, field.residue(times)});
        for (const Integer& x : row) now_.push_back(field.residue(x));
        for (const Integer& x : column) end_.push_back(field.residue(x));
    }

    /// The first ones.
    const std::vector<Residue>& first(std::size_t count, const Budget& budget) {
        while (found_.size() < count) {
            budget.check();
            Residue sum = 0;
            for (std::size_t i = 0; i < now_.size(); ++i)
                sum = field_.add(sum, field_.multiply(now_[i], end_[i]));
            found_.push_back(sum);
            std::vector<Residue> next(now_.size(), 0);
            for (std::size_t i = 0; i < now_.size(); ++i)
                if (now_[i] != 0)
                    for (const auto& [j, times] : rows_[i])
                        next[j] = field_.add(next[j], field_.multiply(now_[i], times));
            now_ = std::move(next);
        }
        return found_;
    }

private:
    struct Entry {
        std::size_t column;
        Residue times;
    };

    const PrimeField& field_;
    std::vector<std::vector<Entry>> rows_;
    std::vector<Residue> now_, end_, found_;
};

/// The coefficients of `shortest_recurrence_modulo`.
std::vector<Residue> recurrence_modulo(const std::vector<Residue>& terms, const PrimeField& field,
                                       const Budget& budget);

/// A row, a matrix and a column that give the same numbers row * matrix^n * column.
struct Lumped {
    std::vector<Integer> row;
    GrowthMatrix matrix;
    std::vector<Integer> column;
};

/// States that cannot be told apart by the column, however many steps are made, as one: the coarsest partition in which
/// states of one class have the same entry of the column and, for each class, the same sum of entries of the matrix there (Kemeny
/// and Snell, Finite Markov Chains, 1960, 6.3). Found by refinement, in rounds of O(entries log entries); where it takes many of
/// them, as in a long chain, the states stay as they are.
Lumped lumped(const std::vector<Integer>& row, const GrowthMatrix& matrix,
              const std::vector<Integer>& column, const Budget& budget) {
    std::vector<std::size_t> of(matrix.size());  // the class of a state
    std::size_t classes = 0;
    const auto sums_of = [&](std::size_t state) {
        std::map<std::size_t, Integer> sums;
        for (const auto& [to, times] : matrix.rows[state]) sums[of[to]] += times;
        return sums;
    };
    {
        std::map<Integer, std::size_t> numbers;
        for (std::size_t i = 0; i < of.size(); ++i)
            of[i] = numbers.try_emplace(column[i], numbers.size()).first->second;
        classes = numbers.size();
    }
    constexpr int most_rounds = 100;
    for (int round = 0;; ++round) {
        if (round == most_rounds) return {row, matrix, column};
        budget.check();
        std::map<std::pair<std::size_t, std::map<std::size_t, Integer>>, std::size_t> numbers;
        std::vector<std::size_t> next(of.size());
        for (std::size_t i = 0; i < of.size(); ++i)
            next[i] = numbers.try_emplace({of[i], sums_of(i)}, numbers.size()).first->second;
        of = std::move(next);
        if (numbers.size() == classes) break;
        classes = numbers.size();
    }
    Lumped found{std::vector<Integer>(classes), {}, std::vector<Integer>(classes)};
    found.matrix.rows.resize(classes);
    std::vector<bool> seen(classes, false);
    for (std::size_t i = 0; i < of.size(); ++i) {
        found.row[of[i]] += row[i];
        if (seen[of[i]]) continue;
        seen[of[i]] = true;
        found.column[of[i]] = column[i];
        for (const auto& [to, times] : sums_of(i)) found.matrix.rows[of[i]].push_back({to, times});
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
            const Residue missing =
                field.multiply(field.subtract(residues[i], field.residue(values[i])), inverse);
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

namespace {

/// Whether the sequence rest * matrix^n * column is 0 for the first n, or `rest` becomes 0 before.
bool begins_with_zeros(std::vector<Integer> rest, const GrowthMatrix& matrix,
                       const std::vector<Integer>& column, std::size_t count,
                       const Budget& budget) {
    for (std::size_t n = 0; n < count && !is_zero(rest); ++n) {
        budget.check();
        if (!dot(rest, column).is_zero()) return false;
        rest = rest * matrix;
    }
    return true;
}

/// The recurrence of the sequence row * matrix^n * column, a candidate at a time, until one is proved; nothing after so many that
/// are not.
template <class Proves>
std::optional<Polynomial> recurrence(const std::vector<Integer>& row, const GrowthMatrix& matrix,
                                     const std::vector<Integer>& column, Proves proves,
                                     std::size_t most_candidates, const Budget& budget) {
    Reconstruction found;
    std::size_t order = 0;
    // Twice as many terms as there are states decide. Mostly far fewer do, some more than twice the order; where these were too few, the
    // candidate fails.
    constexpr std::size_t margin = 64;
    const std::size_t all_terms = 2 * matrix.size();
    std::size_t failed = 0;
    WorkCount primes("prime modulus");
    for (Residue prime = prime_below(Residue{1} << 61); failed < most_candidates;
         prime = prime_below(prime)) {
        budget.check();
        ++primes;
        const PrimeField field(prime);
        ResidueTerms terms(row, matrix, column, field);
        std::vector<Residue> polynomial;
        for (std::size_t count = failed == 0 ? 2 * order + margin : all_terms;; count *= 2) {
            count = std::min(count, all_terms);
            polynomial = recurrence_modulo(terms.first(count, budget), field, budget);
            if (count == all_terms || count >= 2 * (polynomial.size() - 1) + margin) break;
        }
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
        if (proves(candidate)) return candidate;
        ++failed;
    }
    return std::nullopt;
}

}  // namespace

bool annihilates(const Polynomial& p, const std::vector<Integer>& row, const GrowthMatrix& matrix,
                 const std::vector<Integer>& column, const Budget& budget) {
    return begins_with_zeros(image(p, row, matrix, budget), matrix, column, matrix.size(), budget);
}

Polynomial annihilator(const std::vector<Integer>& all_row, const GrowthMatrix& all,
                       const std::vector<Integer>& all_column, const Budget& budget) {
    const auto [row, matrix, column] = lumped(all_row, all, all_column, budget);
    // What is left of the row goes through a space of as many dimensions as the row does, mostly few of all.
    std::optional<std::size_t> dimensions;
    const auto proves = [&, &row = row, &matrix = matrix,
                         &column = column](const Polynomial& candidate) {
        if (4 * candidate.coefficients().size() >= matrix.size())
            return annihilates(candidate, row, matrix, column, budget);
        if (!dimensions)
            dimensions = static_cast<std::size_t>(annihilator(row, matrix, budget).degree());
        return begins_with_zeros(image(candidate, row, matrix, budget), matrix, column, *dimensions,
                                 budget);
    };
    return *recurrence(row, matrix, column, proves, std::numeric_limits<std::size_t>::max(),
                       budget);
}

Polynomial annihilator(const std::vector<Integer>& row, const GrowthMatrix& matrix,
                       const Budget& budget) {
    const auto proves = [&](const Polynomial& candidate) {
        return is_zero(image(candidate, row, matrix, budget));
    };
    std::mt19937_64 random(2026);
    for (;;) {
        std::vector<Integer> column(row.size());
        for (Integer& x : column) x = static_cast<long>(random() >> 34);
        if (const auto found = recurrence(row, matrix, column, proves, 3, budget)) return *found;
    }
}

namespace {

__extension__ typedef unsigned __int128 Wide;

/// Miller and Rabin's test with bases that settle it for all numbers of 64 bits.
bool is_prime(Residue n) {
    if (n < 2) return false;
    for (const Residue p : {2u, 3u, 5u, 7u, 11u, 13u, 17u, 19u, 23u, 29u, 31u, 37u})
        if (n % p == 0) return n == p;
    const PrimeField field(n);
    Residue odd = n - 1;
    int twos = 0;
    for (; odd % 2 == 0; odd /= 2) ++twos;
    for (const Residue base : {2u, 3u, 5u, 7u, 11u, 13u, 17u, 19u, 23u, 29u, 31u, 37u}) {
        Residue x = field.power(base, odd);
        if (x == 1 || x == n - 1) continue;
        bool composite = true;
        for (int i = 1; i < twos && composite; ++i) {
            x = field.multiply(x, x);
            composite = x != n - 1;
        }
        if (composite) return false;
    }
    return true;
}

}  // namespace

Residue PrimeField::residue(const Integer& value) const {
    return remainder(value, Integer(prime_)).to_uint64();
}

Residue PrimeField::multiply(Residue left, Residue right) const {
    return static_cast<Residue>(static_cast<Wide>(left) * right % prime_);
}

Residue PrimeField::power(Residue base, std::uint64_t exponent) const {
    Residue result = 1 % prime_;
    for (; exponent != 0; exponent >>= 1) {
        if (exponent & 1) result = multiply(result, base);
        base = multiply(base, base);
    }
    return result;
}

Residue prime_below(Residue bound) {
    do --bound;
    while (!is_prime(bound));
    return bound;
}

namespace {

/// The field of the rational numbers, as PrimeField is one of residues.
struct Rationals {
    Rational add(const Rational& left, const Rational& right) const { return left + right; }
    Rational subtract(const Rational& left, const Rational& right) const { return left - right; }
    Rational multiply(const Rational& left, const Rational& right) const { return left * right; }
    Rational inverse(const Rational& value) const { return Rational(1) / value; }
};

/// The connection polynomial c of the shortest recurrence, c[0] a(n) + c[1] a(n-1) + ... == 0 with c[0] == 1, and
/// the order, from which on it holds (Berlekamp 1968, Massey 1969).
template <class Field, class Number>
std::pair<std::vector<Number>, std::size_t> connection(const std::vector<Number>& terms,
                                                       const Field& field, const Budget& budget) {
    const Number zero(0);
    std::vector<Number> now{Number(1)}, before = now;  // before the last jump
    std::size_t order = 0, shift = 1;
    Number last(1);
    for (std::size_t n = 0; n < terms.size(); ++n, ++shift) {
        budget.check();
        Number wrong = zero;
        for (std::size_t i = 0; i < now.size() && i <= n; ++i)
            if (now[i] != zero) wrong = field.add(wrong, field.multiply(now[i], terms[n - i]));
        if (wrong == zero) continue;
        const Number factor = field.multiply(wrong, field.inverse(last));
        std::vector<Number> next = now;
        next.resize(std::max(now.size(), before.size() + shift), zero);
        for (std::size_t i = 0; i < before.size(); ++i)
            next[i + shift] = field.subtract(next[i + shift], field.multiply(factor, before[i]));
        if (2 * order <= n) {
            order = n + 1 - order;
            before = std::move(now);
            last = wrong;
            shift = 0;
        }
        now = std::move(next);
    }
    return {std::move(now), order};
}

std::vector<Residue> recurrence_modulo(const std::vector<Residue>& terms, const PrimeField& field,
                                       const Budget& budget) {
    auto [found, order] = connection(terms, field, budget);
    found.resize(order + 1, 0);
    std::reverse(found.begin(), found.end());
    return found;
}

}  // namespace

std::vector<Residue> shortest_recurrence_modulo(const std::vector<Residue>& terms,
                                                const PrimeField& field) {
    return recurrence_modulo(terms, field, {});
}

SequenceSpecification recurrence_of_terms(const std::vector<Rational>& terms) {
    const auto [found, order] = connection(terms, Rationals(), {});
    SequenceSpecification result;
    for (std::size_t i = 1; i < found.size(); ++i) result.coefficients.push_back(-found[i]);
    while (!result.coefficients.empty() && result.coefficients.back().is_zero())
        result.coefficients.pop_back();
    result.initial.assign(terms.begin(), terms.begin() + static_cast<std::ptrdiff_t>(order));
    result.terms = terms.size();
    return result;
}

namespace {

/// Adds a summand with its sign: "a - b".
void add(std::string& sum, std::string summand) {
    if (sum.empty())
        sum = std::move(summand);
    else if (summand.starts_with('-'))
        sum += " - " + summand.substr(1);
    else
        sum += " + " + summand;
}

/// A coefficient before a power: "-", "3", nothing for 1.
std::string factor_text(const Integer& coefficient) {
    return coefficient == 1 ? "" : coefficient == -1 ? "-" : to_string(coefficient);
}

/// "1 - 5x + 4x^2".
std::string rising(const Polynomial& value) {
    if (value.is_zero()) return "0";
    std::string text;
    for (std::size_t k = 0; k < value.coefficients().size(); ++k) {
        const Integer& coefficient = value.coefficients()[k];
        if (coefficient.is_zero()) continue;
        add(text, k == 0   ? to_string(coefficient)
                  : k == 1 ? factor_text(coefficient) + "x"
                           : factor_text(coefficient) + "x^" + std::to_string(k));
    }
    return text;
}

std::size_t terms(const Polynomial& value) {
    return static_cast<std::size_t>(std::count_if(value.coefficients().begin(),
                                                  value.coefficients().end(),
                                                  [](const Integer& x) { return !x.is_zero(); }));
}

std::string fenced(const Polynomial& value) {
    return terms(value) > 1 ? "(" + rising(value) + ")" : rising(value);
}

}  // namespace

std::vector<Integer> Recurrence::values(std::size_t count) const {
    std::vector<Integer> found(
        initial.begin(), initial.begin() + static_cast<long>(std::min(count, initial.size())));
    const auto& q = polynomial.coefficients();
    while (found.size() < count) {
        Integer next;
        const std::size_t start = found.size() - order();
        for (std::size_t j = 0; j < order(); ++j)
            if (!q[j].is_zero()) next -= q[j] * found[start + j];
        found.push_back(std::move(next));
    }
    return found;
}

std::string Recurrence::text() const {
    std::string sum;
    for (std::size_t j = 1; j <= order(); ++j) {
        const Integer coefficient = -polynomial.coefficients()[order() - j];
        if (coefficient.is_zero()) continue;
        add(sum, factor_text(coefficient) + "a(n-" + std::to_string(j) + ")");
    }
    return "a(n) = " + (sum.empty() ? "0" : sum);
}

Recurrence shortest_recurrence(const std::vector<Integer>& row, const GrowthMatrix& matrix,
                               const std::vector<Integer>& column, const Budget& budget) {
    std::vector<Integer> coefficients = annihilator(row, matrix, column, budget).coefficients();
    Recurrence found;
    while (coefficients[found.exceptions].is_zero()) ++found.exceptions;
    coefficients.erase(coefficients.begin(),
                       coefficients.begin() + static_cast<long>(found.exceptions));
    found.polynomial = Polynomial(std::move(coefficients));
    std::vector<Integer> now = row;
    for (std::size_t n = 0; n < found.holds_from(); ++n) {
        found.initial.push_back(dot(now, column));
        now = now * matrix;
    }
    return found;
}

Recurrence shortest_recurrence(const D0L& system, const Budget& budget) {
    const GrowthMatrix matrix = growth_matrix(system);
    return shortest_recurrence(axiom_counts(system), matrix, std::vector<Integer>(matrix.size(), 1),
                               budget);
}

GeneratingFunction generating_function(const Recurrence& recurrence) {
    const Polynomial denominator = reversed(recurrence.polynomial);
    std::vector<Integer> numerator = (Polynomial(recurrence.initial) * denominator).coefficients();
    numerator.resize(std::min(numerator.size(), recurrence.initial.size()));
    return {Polynomial(std::move(numerator)), denominator};
}

std::string to_string(const GeneratingFunction& function) {
    if (function.denominator == Polynomial(1)) return rising(function.numerator);
    return fenced(function.numerator) + "/" + fenced(function.denominator);
}

namespace {

/// value(x + t) as a series in t: the k-th coefficient is the k-th derivative over k!.
std::vector<Polynomial> taylor(Polynomial value, std::size_t count) {
    std::vector<Polynomial> found;
    for (std::size_t k = 0; k < count; ++k) {
        found.push_back(value);
        std::vector<Integer> next;
        for (std::size_t i = 1; i < value.coefficients().size(); ++i)
            next.push_back(exact_divide(value.coefficients()[i] * Integer(i), Integer(k + 1)));
        value = Polynomial(std::move(next));
    }
    return found;
}

/// A product of series with coefficients in a field, up to `count` of them.
std::vector<Polynomial> product(const NumberField& field, const std::vector<Polynomial>& left,
                                const std::vector<Polynomial>& right, std::size_t count) {
    std::vector<Polynomial> found(count);
    for (std::size_t i = 0; i < count && i < left.size(); ++i)
        for (std::size_t j = 0; i + j < count && j < right.size(); ++j)
            found[i + j] += field.multiply(left[i], right[j]);
    return found;
}

std::vector<Polynomial> reduced(const NumberField& field, std::vector<Polynomial> series) {
    for (Polynomial& coefficient : series) coefficient = field.reduced(coefficient);
    return series;
}

/// N(z) with sum b(n) z^(-n-1) == N(z)/q(z), b the sequence from its exceptions on.
Polynomial numerator(const Recurrence& recurrence) {
    const std::size_t order = recurrence.order();
    std::vector<Integer> found(order);
    for (std::size_t t = 0; t < order; ++t)
        for (std::size_t j = t + 1; j <= order; ++j)
            found[t] += recurrence.polynomial.coefficient(j) *
                        recurrence.initial[recurrence.exceptions + j - 1 - t];
    return Polynomial(std::move(found));
}

/// (n - start)(n - start - 1)...: so many factors, as a polynomial in n.
Polynomial falling(std::size_t start, std::size_t count) {
    Polynomial product = 1;
    for (std::size_t i = 0; i < count; ++i) product *= Polynomial({-Integer(start + i), 1});
    return product;
}

/// The residues of N(z) z^n / q(z) at the roots of one factor of q, as polynomials in n.
ClosedFormTerm term(const Polynomial& above, const Polynomial& q, const Factorisation::Power& part,
                    std::size_t exceptions) {
    const NumberField field(part.factor);
    const std::size_t e = part.exponent;
    const Polynomial others = *exact_divide(q, power(part.factor, e));
    // N(r+t) and others(r+t) (f(r+t)/t)^e as series in t.
    const std::vector<Polynomial> up = reduced(field, taylor(above, e));
    std::vector<Polynomial> slope = reduced(field, taylor(part.factor, e + 1));
    slope.erase(slope.begin());
    std::vector<Polynomial> down = reduced(field, taylor(others, e));
    for (std::size_t i = 0; i < e; ++i) down = product(field, down, slope, e);
    // Their quotient: the i-th coefficient is quotient[i] / down[0]^(i+1).
    std::vector<Polynomial> powers{1};
    for (std::size_t i = 0; i < e; ++i) powers.push_back(field.multiply(powers.back(), down[0]));
    std::vector<Polynomial> quotient;
    for (std::size_t i = 0; i < e; ++i) {
        Polynomial sum = field.multiply(up[i], powers[i]);
        for (std::size_t j = 1; j <= i; ++j)
            sum -= field.multiply(field.multiply(down[j], quotient[i - j]), powers[j - 1]);
        quotient.push_back(std::move(sum));
    }
    // a(n) gets sum_i quotient[i]/down[0]^(i+1) binomial(n-s, e-1-i) r^(n-s-(e-1-i)).
    Integer factorial = 1;
    for (std::size_t i = 2; i < e; ++i) factorial *= Integer(i);
    const Polynomial denominator = field.multiply(
        field.multiply(powers[e], field.power(Polynomial({0, 1}), exceptions + e - 1)), factorial);
    std::vector<Polynomial> numerators(e);
    for (std::size_t i = 0; i < e; ++i) {
        const std::size_t lower = e - 1 - i;
        Integer rest = factorial;  // over lower!
        for (std::size_t j = 2; j <= lower; ++j) rest = exact_divide(rest, Integer(j));
        const Polynomial weight = field.multiply(field.multiply(quotient[i], powers[e - 1 - i]),
                                                 field.power(Polynomial({0, 1}), i));
        const Polynomial in_n = falling(exceptions, lower);
        for (std::size_t k = 0; k <= lower; ++k)
            numerators[k] += weight * Polynomial(in_n.coefficient(k) * rest);
    }
    ClosedFormTerm found{part.factor, {}};
    for (const Polynomial& numerator : numerators) {
        const AlgebraicNumber coefficient{numerator, denominator};
        found.coefficients.push_back(part.factor.degree() <= ClosedForm::largest_written_degree
                                         ? field.simplified(coefficient)
                                         : coefficient);
    }
    return found;
}

}  // namespace

ClosedForm::ClosedForm(const Recurrence& recurrence, const Budget& budget)
    : exceptions_(recurrence.initial.begin(),
                  recurrence.initial.begin() + static_cast<long>(recurrence.exceptions)) {
    if (recurrence.order() == 0) return;
    const Polynomial above = numerator(recurrence);
    WorkCount factors("factor of the polynomial");
    for (const auto& part : factorise(recurrence.polynomial).powers) {
        budget.check();
        ++factors;
        terms_.push_back(term(above, recurrence.polynomial, part, recurrence.exceptions));
    }
}

Ball ClosedForm::value(std::uint64_t n, long bits) const {
    Ball sum(0, bits);
    for (const ClosedFormTerm& term : terms_)
        for (const Root& root : roots(term.polynomial, bits)) {
            const ComplexBall r{root.real, root.imaginary};
            ComplexBall factor{Ball(0, bits), Ball(0, bits)};
            Ball power_of_n(1, bits);
            for (const AlgebraicNumber& coefficient : term.coefficients) {
                factor = factor + value_at(coefficient.numerator, r) /
                                      value_at(coefficient.denominator, r) *
                                      ComplexBall{power_of_n, Ball(0, bits)};
                power_of_n *= Ball(n, bits);
            }
            sum += (factor * power(r, n)).real;
        }
    return sum;
}

std::string ClosedForm::text() const {
    std::string text = closed_form_text(terms_);
    if (!exceptions_.empty()) text += ", for n >= " + std::to_string(exceptions_.size());
    return text;
}

ClosedForm closed_form(const D0L& system, const Budget& budget) {
    return ClosedForm(shortest_recurrence(system, budget), budget);
}

namespace {

/// A factor before a power: "", "-", "7*", "(n + 2)*", "-2n*".
std::string before_power(const Polynomial& factor) {
    if (factor == Polynomial(1)) return "";
    if (factor == Polynomial(-1)) return "-";
    const std::string text = to_string(factor, "n");
    return (terms(factor) > 1 ? "(" + text + ")" : text) + "*";
}

/// A number as the base of a power: "4", "(-1)", "sqrt(2)", "((1+sqrt(5))/2)".
std::string base(const std::string& number) {
    if (number == "i" || number.find_first_not_of("0123456789") == std::string::npos) return number;
    if (number.starts_with("sqrt(") && number.find(')') == number.size() - 1) return number;
    return "(" + number + ")";
}

/// The terms with rational roots over one denominator: "(7*4^n - 4)/3".
std::string rational_part(const std::vector<const ClosedFormTerm*>& parts) {
    Integer below = 1;
    for (const auto* part : parts)
        for (const auto& coefficient : part->coefficients)
            below = lcm(below, coefficient.denominator.coefficient(0));
    std::string sum;
    std::size_t summands = 0;
    for (const auto* part : parts) {
        std::vector<Integer> factors;
        for (const auto& coefficient : part->coefficients)
            factors.push_back(coefficient.numerator.coefficient(0) *
                              exact_divide(below, coefficient.denominator.coefficient(0)));
        const Polynomial factor(std::move(factors));
        const Integer root = -part->polynomial.coefficient(0);
        summands += root == 1 ? terms(factor) : 1;
        if (root == 1)
            add(sum, to_string(factor, "n"));
        else
            add(sum, before_power(factor) + base(to_string(root)) + "^n");
    }
    if (below == 1) return sum;
    return (summands > 1 ? "(" + sum + ")" : sum) + "/" + to_string(below);
}

/// The coefficient of one power of n for one root of a quadratic polynomial.
QuadraticNumber at_root(const AlgebraicNumber& coefficient, const QuadraticNumber& root) {
    const Integer below = coefficient.denominator.coefficient(0);
    return combination(Rational(coefficient.numerator.coefficient(0), below),
                       Rational(coefficient.numerator.coefficient(1), below), root);
}

std::string fenced(const std::string& number) {
    return number.find_first_of("+-/*", 1) == std::string::npos ? number : "(" + number + ")";
}

std::string with_power_of_n(const std::string& number, std::size_t k) {
    if (k == 0) return number;
    const std::string n = k == 1 ? "n" : "n^" + std::to_string(k);
    return number == "1" ? n : number == "-1" ? "-" + n : fenced(number) + "*" + n;
}

std::string quadratic_part(const ClosedFormTerm& part, const QuadraticNumber& root) {
    std::string factor;
    std::size_t summands = 0;
    for (std::size_t k = part.coefficients.size(); k-- > 0;) {
        const QuadraticNumber coefficient = at_root(part.coefficients[k], root);
        if (coefficient.rational.is_zero() && coefficient.factor.is_zero()) continue;
        add(factor, with_power_of_n(to_string(coefficient), k));
        ++summands;
    }
    const std::string power = base(to_string(root)) + "^n";
    if (factor == "1") return power;
    if (factor == "-1") return "-" + power;
    return (summands > 1 ? "(" + factor + ")" : fenced(factor)) + "*" + power;
}

/// "(2*r^2 - r + 1)/23".
std::string in_root(const AlgebraicNumber& coefficient) {
    const std::string above = to_string(coefficient.numerator, "r");
    if (coefficient.denominator == Polynomial(1)) return above;
    return (terms(coefficient.numerator) > 1 ? "(" + above + ")" : above) + "/" +
           to_string(coefficient.denominator);
}

std::string general_part(const ClosedFormTerm& part) {
    std::string text = "sum over the roots r of " + to_string(part.polynomial) + " of ";
    if (part.polynomial.degree() > ClosedForm::largest_written_degree)
        return text + "c(r)*r^n, c(r) the residue of the generating function";
    std::string factor;
    for (std::size_t k = part.coefficients.size(); k-- > 0;)
        if (!part.coefficients[k].numerator.is_zero())
            add(factor, with_power_of_n(in_root(part.coefficients[k]), k));
    return text + fenced(factor) + "*r^n";
}

}  // namespace

std::string closed_form_text(const std::vector<ClosedFormTerm>& parts) {
    std::vector<const ClosedFormTerm*> rational;
    for (const ClosedFormTerm& part : parts)
        if (part.polynomial.degree() == 1) rational.push_back(&part);
    std::stable_sort(rational.begin(), rational.end(), [](const auto* left, const auto* right) {
        return abs(left->polynomial.coefficient(0)) > abs(right->polynomial.coefficient(0));
    });
    std::string sum;
    for (const ClosedFormTerm& part : parts) {
        if (part.polynomial.degree() != 2) continue;
        const QuadraticNumber root = larger_root(part.polynomial);
        add(sum, quadratic_part(part, root));
        add(sum, quadratic_part(part, root.conjugate()));
    }
    for (const ClosedFormTerm& part : parts)
        if (part.polynomial.degree() > 2) add(sum, general_part(part));
    if (rational.empty()) return sum.empty() ? "0" : sum;
    if (sum.empty()) return rational_part(rational);
    // The exponential terms first; a rational part that outgrows them is read first too.
    const bool first = abs(rational.front()->polynomial.coefficient(0)) > 1;
    std::string text = first ? rational_part(rational) : sum;
    add(text, first ? sum : rational_part(rational));
    return text;
}

namespace {

std::string digits(const Ball& value) {
    std::string text = decimal([&](long) { return value; }, 12);
    if (text.find('.') != std::string::npos) {
        while (text.ends_with('0')) text.pop_back();
        if (text.ends_with('.')) text.pop_back();
    }
    return text;
}

}  // namespace

std::vector<std::string> root_lines(const ClosedForm& form, long largest_degree) {
    std::vector<std::string> lines;
    for (const ClosedFormTerm& part : form.terms()) {
        if (part.polynomial.degree() <= 2 || part.polynomial.degree() > largest_degree) continue;
        std::string line = "the roots of " + to_string(part.polynomial) + " are";
        bool first = true;
        for (const Root& root : roots(part.polynomial, 128)) {
            const auto above = sign(root.imaginary);
            if (!root.is_real && above && *above < 0) continue;
            line += first ? " " : ", ";
            first = false;
            line += digits(root.real);
            if (!root.is_real) line += " +- " + digits(root.imaginary) + "i";
        }
        lines.push_back(std::move(line));
    }
    return lines;
}

}  // namespace algae
