#include <algorithm>

#include "growth/growth.hpp"

// Letters: how long each lasts, which letters prolong themselves to an infinite word, and how often each letter occurs in the
// long run. Frequencies are exact numbers of the field of the rate.

namespace algae {

std::vector<std::optional<std::uint64_t>> lifetimes(const GrowthMatrix& matrix) {
    std::vector<Word> images;  // a letter of an image counts once
    for (const auto& row : matrix.rows) {
        Word& image = images.emplace_back();
        for (const auto& entry : row) image.push_back(static_cast<Symbol>(entry.column));
    }
    std::vector<std::optional<std::uint64_t>> found;
    for (const std::uint64_t lifetime : lifetimes(Morphism(std::move(images))))
        found.push_back(lifetime == lasts ? std::nullopt : std::optional(lifetime));
    return found;
}

std::vector<Prolongation> prolongations(const D0L& system) {
    const auto lifetime = lifetimes(system.rules);
    const auto is_mortal = [&](Symbol a) { return lifetime[a] != lasts; };
    const auto die_within = [&](auto from, auto to, std::uint64_t steps) {
        return std::all_of(from, to,
                           [&](Symbol a) { return is_mortal(a) && lifetime[a] <= steps; });
    };
    const auto leftmost = [&](Symbol a) {
        const Word& word = system.successor(a);
        return std::find_if(word.begin(), word.end(), [&](Symbol b) { return !is_mortal(b); });
    };
    std::vector<Prolongation> found;
    for (const Symbol a : system.letters) {
        if (is_mortal(a)) continue;
        std::uint64_t power = 1;
        Symbol b = *leftmost(a);
        for (; b != a && power <= system.letters.size(); ++power) b = *leftmost(b);
        if (b != a) continue;
        bool begins = true, fixed = true, infinite = false;
        for (std::uint64_t step = 1; step <= power && begins; ++step) {
            const Word& word = system.successor(b);
            const auto next = leftmost(b);
            begins = die_within(word.begin(), next, power - step);
            fixed = fixed && die_within(next + 1, word.end(), power - step);
            infinite = infinite ||
                       std::any_of(next + 1, word.end(), [&](Symbol c) { return !is_mortal(c); });
            b = *next;
        }
        if (begins) found.push_back({a, power, fixed, infinite});
    }
    return found;
}

namespace {

long longest_coefficient(const Polynomial& value) {
    std::uint64_t longest = 0;
    for (const Integer& x : value.coefficients()) longest = std::max(longest, bit_length(x));
    return static_cast<long>(longest);
}

GrowthOrder order_of(const std::vector<Integer>& counts, const Components& components) {
    const auto letters = letter_orders(components);
    GrowthOrder most;
    for (std::size_t i = 0; i < counts.size(); ++i)
        if (!counts[i].is_zero() && grows_slower(most, letters[i])) most = letters[i];
    return most;
}

/// For each letter N(z) with sum_n counts(n) z^(-n-1) == N(z)/annihilator(z), without what its largest
/// root does not see: reduced modulo its minimal polynomial. At that root the numbers are
/// proportional to the limits of the shares.
std::vector<Polynomial> residues(const std::vector<Integer>& counts, const GrowthMatrix& matrix,
                                 const Polynomial& annihilator, const Polynomial& minimal,
                                 const Budget& budget) {
    const auto degree = static_cast<std::size_t>(minimal.degree());
    std::vector<std::vector<Integer>> sums(counts.size(), std::vector<Integer>(degree));
    std::vector<Integer> row(counts.size());
    for (std::size_t t = annihilator.coefficients().size(); t-- > 1;) {
        budget.check();
        if (t + 1 < annihilator.coefficients().size()) row = row * matrix;
        const Integer& coefficient = annihilator.coefficients()[t];
        for (std::size_t i = 0; i < counts.size(); ++i) {
            if (!coefficient.is_zero() && !counts[i].is_zero()) row[i] += coefficient * counts[i];
            // sum := z sum + row[i] modulo the minimal polynomial
            std::vector<Integer>& sum = sums[i];
            const Integer carried = sum.back();
            for (std::size_t k = degree; k-- > 1;) sum[k] = std::move(sum[k - 1]);
            sum[0] = row[i];
            if (!carried.is_zero())
                for (std::size_t k = 0; k < degree; ++k)
                    sum[k] -= carried * minimal.coefficients()[k];
        }
    }
    std::vector<Polynomial> found;
    for (auto& sum : sums) found.emplace_back(std::move(sum));
    return found;
}

/// The limits, for counts whose shares have some.
std::vector<Frequency> limits(const std::vector<Integer>& counts, const GrowthMatrix& matrix,
                              const Polynomial& annihilator, const Rate& rate,
                              const Budget& budget) {
    const std::vector<Polynomial> above =
        residues(counts, matrix, annihilator, rate.minimal_polynomial(), budget);
    Polynomial below;
    for (const Polynomial& share : above) below += share;
    std::vector<Frequency> found;
    for (const Polynomial& share : above) found.emplace_back(rate, share, below);
    return found;
}

}  // namespace

Frequency::Frequency(const Rate& rate, const Polynomial& above, const Polynomial& below)
    : rate_(rate), above_(above), below_(below) {
    if (rate.degree() > ClosedForm::largest_written_degree) return;
    number_ = NumberField(rate.minimal_polynomial()).simplified({above, below});
    above_ = number_->numerator;
    below_ = number_->denominator;
}

std::string Frequency::exact() const {
    if (!number_) return "a number in the field of r";
    const Integer below = number_->denominator.coefficient(0);
    const Rational first(number_->numerator.coefficient(0), below);
    if (number_->numerator.degree() < 1) return to_string(first);
    if (rate_.degree() == 2)
        return to_string(combination(first, Rational(number_->numerator.coefficient(1), below),
                                     larger_root(rate_.minimal_polynomial())));
    const std::string above = to_string(number_->numerator, "r");
    return below == 1 ? above : "(" + above + ")/" + to_string(below);
}

Ball Frequency::enclosure(long bits) const {
    const long more =
        bits + 64 + std::max(longest_coefficient(above_), longest_coefficient(below_));
    const Ball r = rate_.enclosure(more);
    return above_(r) / below_(r);
}

std::string Frequency::decimal(int digits_after_point) const {
    if (number_ && number_->numerator.degree() < 1)
        return algae::decimal(
            Rational(number_->numerator.coefficient(0), number_->denominator.coefficient(0)),
            digits_after_point);
    return algae::decimal([this](long bits) { return enclosure(bits); }, digits_after_point);
}

bool operator==(const Frequency& left, const Frequency& right) {
    if (left.number_ && left.number_->numerator.degree() < 1) return left.number_ == right.number_;
    return left.rate_ == right.rate_ && left.above_ == right.above_ && left.below_ == right.below_;
}

LetterFrequencies letter_frequencies(const std::vector<Integer>& counts, const GrowthMatrix& matrix,
                                     const Components& parts, const Budget& budget) {
    LetterFrequencies found;
    const GrowthOrder order = order_of(counts, parts);
    if (order.kind == GrowthKind::zero) return found;
    const Polynomial polynomial = annihilator(counts, matrix, budget);
    found.period = limit_period(polynomial, order, parts);
    if (found.period == 1) {
        found.limits.push_back(limits(counts, matrix, polynomial, order.rate, budget));
        return found;
    }
    if (found.period > Integer(LetterFrequencies::largest_period)) return found;
    const GrowthMatrix section = growth_matrix(power(dense(matrix), found.period));
    const Components section_parts = components(section, budget);
    std::vector<Integer> row = counts;
    for (Integer r = 0; r < found.period; r += 1) {
        found.limits.push_back(limits(row, section, annihilator(row, section, budget),
                                      order_of(row, section_parts).rate, budget));
        row = row * matrix;
    }
    if (std::all_of(found.limits.begin(), found.limits.end(),
                    [&](const auto& limit) { return limit == found.limits.front(); })) {
        found.limits.resize(1);
        found.period = 1;
    }
    return found;
}

LetterFrequencies letter_frequencies(const D0L& system, const Budget& budget) {
    const GrowthMatrix matrix = growth_matrix(system);
    return letter_frequencies(axiom_counts(system), matrix, components(matrix, budget), budget);
}

}  // namespace algae
