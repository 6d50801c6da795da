#include "growth/closed_form.hpp"

#include "growth/complex_ball.hpp"

namespace algae {

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
        for (std::size_t j = 0; i + j < count && j < right.size(); ++j) found[i + j] += field.multiply(left[i], right[j]);
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
            found[t] += recurrence.polynomial.coefficient(j) * recurrence.initial[recurrence.exceptions + j - 1 - t];
    return Polynomial(std::move(found));
}

/// (n - start)(n - start - 1)...: so many factors, as a polynomial in n.
Polynomial falling(std::size_t start, std::size_t count) {
    Polynomial product = 1;
    for (std::size_t i = 0; i < count; ++i) product *= Polynomial({-Integer(start + i), 1});
    return product;
}

/// The residues of N(z) z^n / q(z) at the roots of one factor of q, as polynomials in n.
ClosedFormTerm term(const Polynomial& above, const Polynomial& q, const Factorisation::Power& part, std::size_t exceptions) {
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
    const Polynomial denominator =
        field.multiply(field.multiply(powers[e], field.power(Polynomial({0, 1}), exceptions + e - 1)), factorial);
    std::vector<Polynomial> numerators(e);
    for (std::size_t i = 0; i < e; ++i) {
        const std::size_t lower = e - 1 - i;
        Integer rest = factorial;  // over lower!
        for (std::size_t j = 2; j <= lower; ++j) rest = exact_divide(rest, Integer(j));
        const Polynomial weight = field.multiply(
            field.multiply(quotient[i], powers[e - 1 - i]), field.power(Polynomial({0, 1}), i));
        const Polynomial in_n = falling(exceptions, lower);
        for (std::size_t k = 0; k <= lower; ++k) numerators[k] += weight * Polynomial(in_n.coefficient(k) * rest);
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
    for (const auto& part : factorise(recurrence.polynomial).powers) {
        budget.check();
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
                factor = factor + value_at(coefficient.numerator, r) / value_at(coefficient.denominator, r) *
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

}  // namespace algae
