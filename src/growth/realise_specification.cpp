#include "growth/realise_specification.hpp"

#include <algorithm>

namespace algae {

std::vector<Rational> SequenceSpecification::values(std::size_t count) const {
    std::vector<Rational> all(initial.begin(), initial.begin() + static_cast<std::ptrdiff_t>(std::min(count, initial.size())));
    while (all.size() < count) {
        Rational next = 0;
        for (std::size_t i = 0; i < coefficients.size(); ++i)
            if (!coefficients[i].is_zero()) next += coefficients[i] * all[all.size() - 1 - i];
        all.push_back(next);
    }
    return all;
}

std::string SequenceSpecification::text() const {
    std::string text = "a(n) =";
    bool first = true;
    for (std::size_t i = 0; i < coefficients.size(); ++i) {
        const Rational& c = coefficients[i];
        if (c.is_zero()) continue;
        text += sign(c) < 0 ? (first ? " -" : " - ") : (first ? " " : " + ");
        if (abs(c) != Rational(1)) text += to_string(abs(c)) + ' ';
        text += "a(n-" + std::to_string(i + 1) + ")";
        first = false;
    }
    if (first) text += " 0";
    text += " for n >= " + std::to_string(initial.size());
    for (std::size_t i = 0; i < initial.size(); ++i) text += (i == 0 ? "; " : ", ") + to_string(initial[i]);
    return text;
}

SequenceSpecification recurrence_of_terms(const std::vector<Rational>& terms) {
    std::vector<Rational> connection{1}, before{1};  // 1 - c1 x - c2 x^2 ..., now and before the last jump
    std::size_t order = 0, since = 1;
    Rational discrepancy_before = 1;
    for (std::size_t n = 0; n < terms.size(); ++n) {
        Rational discrepancy = 0;
        for (std::size_t i = 0; i < connection.size() && i <= n; ++i)
            if (!connection[i].is_zero()) discrepancy += connection[i] * terms[n - i];
        if (discrepancy.is_zero()) {
            ++since;
            continue;
        }
        std::vector<Rational> next = connection;
        const Rational times = discrepancy / discrepancy_before;
        next.resize(std::max(next.size(), before.size() + since));
        for (std::size_t i = 0; i < before.size(); ++i) next[i + since] -= times * before[i];
        if (2 * order <= n) {
            order = n + 1 - order;
            before = std::move(connection);
            discrepancy_before = discrepancy;
            since = 1;
        } else {
            ++since;
        }
        connection = std::move(next);
    }
    SequenceSpecification result;
    for (std::size_t i = 1; i < connection.size(); ++i) result.coefficients.push_back(-connection[i]);
    while (!result.coefficients.empty() && result.coefficients.back().is_zero()) result.coefficients.pop_back();
    result.initial.assign(terms.begin(), terms.begin() + static_cast<std::ptrdiff_t>(order));
    result.terms = terms.size();
    return result;
}

SequenceSpecification reduced(const SequenceSpecification& sequence) {
    SequenceSpecification result = recurrence_of_terms(sequence.values(2 * std::max<std::size_t>(sequence.initial.size(), 1)));
    result.terms = sequence.terms;
    return result;
}

SequenceSpecification shifted(const SequenceSpecification& sequence, std::size_t shift) {
    SequenceSpecification result = sequence;
    const auto values = sequence.values(sequence.initial.size() + shift);
    result.initial.assign(values.begin() + static_cast<std::ptrdiff_t>(shift), values.end());
    return reduced(result);
}

}  // namespace algae
