#include "growth/recurrence.hpp"

#include <algorithm>

#include "growth/annihilator.hpp"

namespace algae {

namespace {

/// "1 - 5x + 4x^2".
std::string rising(const Polynomial& value) {
    if (value.is_zero()) return "0";
    std::string text;
    for (std::size_t k = 0; k < value.coefficients().size(); ++k) {
        const Integer& coefficient = value.coefficients()[k];
        if (coefficient.is_zero()) continue;
        const bool negative = sign(coefficient) < 0;
        text += text.empty() ? (negative ? "-" : "") : (negative ? " - " : " + ");
        if (k == 0 || abs(coefficient) != 1) text += to_string(abs(coefficient));
        if (k > 0) text += k == 1 ? "x" : "x^" + std::to_string(k);
    }
    return text;
}

std::size_t terms(const Polynomial& value) {
    return static_cast<std::size_t>(std::count_if(value.coefficients().begin(), value.coefficients().end(),
                                                  [](const Integer& x) { return !x.is_zero(); }));
}

std::string fenced(const Polynomial& value) {
    return terms(value) > 1 ? "(" + rising(value) + ")" : rising(value);
}

}  // namespace

std::vector<Integer> Recurrence::values(std::size_t count) const {
    std::vector<Integer> found(initial.begin(), initial.begin() + static_cast<long>(std::min(count, initial.size())));
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
        const bool negative = sign(coefficient) < 0;
        sum += sum.empty() ? (negative ? "-" : "") : (negative ? " - " : " + ");
        if (abs(coefficient) != 1) sum += to_string(abs(coefficient));
        sum += "a(n-" + std::to_string(j) + ")";
    }
    return "a(n) = " + (sum.empty() ? "0" : sum);
}

Recurrence shortest_recurrence(const std::vector<Integer>& row, const GrowthMatrix& matrix,
                               const std::vector<Integer>& column, const Budget& budget) {
    std::vector<Integer> coefficients = annihilator(row, matrix, column, budget).coefficients();
    Recurrence found;
    while (coefficients[found.exceptions].is_zero()) ++found.exceptions;
    coefficients.erase(coefficients.begin(), coefficients.begin() + static_cast<long>(found.exceptions));
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
    return shortest_recurrence(axiom_counts(system), matrix, std::vector<Integer>(matrix.size(), 1), budget);
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

}  // namespace algae
