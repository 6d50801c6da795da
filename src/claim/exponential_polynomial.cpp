#include "claim/exponential_polynomial.hpp"

#include <algorithm>
#include <optional>

#include "base/error.hpp"

namespace algae {

namespace {

using Terms = std::map<Rational, std::vector<Rational>>;

constexpr std::size_t highest_degree = 200;
constexpr std::size_t most_terms = 1000;

[[noreturn]] void fail(const Expression& part, const std::string& expected) {
    const std::string where = part.place.line == 0 ? "" : to_string(part.place) + ": ";
    throw Error(where + "expected " + expected + ", found " + to_text(part));
}

void trim(Terms& terms) {
    for (auto entry = terms.begin(); entry != terms.end();) {
        auto& coefficients = entry->second;
        while (!coefficients.empty() && coefficients.back().is_zero()) coefficients.pop_back();
        entry = coefficients.empty() ? terms.erase(entry) : std::next(entry);
    }
}

Terms sum(Terms left, const Terms& right, const Rational& times) {
    for (const auto& [base, coefficients] : right) {
        auto& target = left[base];
        target.resize(std::max(target.size(), coefficients.size()));
        for (std::size_t i = 0; i < coefficients.size(); ++i) target[i] += times * coefficients[i];
    }
    trim(left);
    return left;
}

Terms product(const Terms& left, const Terms& right, const Expression& part) {
    Terms result;
    for (const auto& [base, coefficients] : left)
        for (const auto& [other, factors] : right) {
            auto& target = result[base * other];
            target.resize(std::max(target.size(), coefficients.size() + factors.size() - 1));
            for (std::size_t i = 0; i < coefficients.size(); ++i)
                for (std::size_t j = 0; j < factors.size(); ++j)
                    target[i + j] += coefficients[i] * factors[j];
            if (target.size() > highest_degree || result.size() > most_terms)
                fail(part, "a smaller formula");
        }
    trim(result);
    return result;
}

Terms constant(const Rational& value) {
    Terms terms{{Rational(1), {value}}};
    trim(terms);
    return terms;
}

/// The value of terms without n.
std::optional<Rational> constant_of(const Terms& terms) {
    if (terms.empty()) return Rational(0);
    if (terms.size() > 1 || terms.begin()->first != Rational(1) || terms.begin()->second.size() > 1)
        return std::nullopt;
    return terms.begin()->second.front();
}

std::optional<long> small_integer(const Rational& value) {
    for (long n = -1000; n <= 1000; ++n)
        if (value == Rational(n)) return n;
    return std::nullopt;
}

Terms read(const Expression& expression);

Terms read_power(const Expression& expression) {
    const Terms base = read(expression.operands[0]), exponent = read(expression.operands[1]);
    if (const auto value = constant_of(exponent)) {
        const auto times = small_integer(*value);
        if (!times || *times < 0) fail(expression.operands[1], "an exponent from 0 to 1000");
        Terms result = constant(Rational(1));
        for (long i = 0; i < *times; ++i) result = product(result, base, expression);
        return result;
    }
    // r^(s n + t)
    const auto root = constant_of(base);
    if (!root || root->is_zero())
        fail(expression.operands[0],
             "a number that is not 0 as base of a power with n in its exponent");
    const bool linear = exponent.size() == 1 && exponent.begin()->first == Rational(1) &&
                        exponent.begin()->second.size() == 2;
    if (!linear) fail(expression.operands[1], "an exponent like 2n+1");
    const auto slope = small_integer(exponent.begin()->second[1]),
               start = small_integer(exponent.begin()->second[0]);
    if (!slope || !start) fail(expression.operands[1], "an exponent with whole numbers up to 1000");
    return {{power(*root, *slope), {power(*root, *start)}}};
}

Terms read_binary(const Expression& expression) {
    if (expression.name == "^") return read_power(expression);
    const Terms left = read(expression.operands[0]), right = read(expression.operands[1]);
    if (expression.name == "+") return sum(left, right, Rational(1));
    if (expression.name == "-") return sum(left, right, Rational(-1));
    if (expression.name == "*") return product(left, right, expression);
    if (expression.name == "/") {
        const auto divisor = constant_of(right);
        if (!divisor || divisor->is_zero())
            fail(expression.operands[1], "a number that is not 0 to divide by");
        return sum({}, left, Rational(1) / *divisor);
    }
    fail(expression, "a formula in n made by + - * / ^");
}

Terms read(const Expression& expression) {
    switch (expression.kind) {
        case Expression::Kind::number:
            return constant(expression.value);
        case Expression::Kind::name:
            if (expression.name == "n") return {{Rational(1), {Rational(0), Rational(1)}}};
            fail(expression, "n");
        case Expression::Kind::unary:
            if (expression.name == "-") return sum({}, read(expression.operands[0]), Rational(-1));
            fail(expression, "a formula in n made by + - * / ^");
        case Expression::Kind::binary:
            return read_binary(expression);
        default:
            fail(expression, "a formula in n made by + - * / ^");
    }
}

}  // namespace

Rational ExponentialPolynomial::operator()(std::uint64_t n) const {
    Rational value(0);
    for (const auto& [base, coefficients] : terms) {
        Rational polynomial(0);
        for (std::size_t i = coefficients.size(); i-- > 0;)
            polynomial = polynomial * Rational(n) + coefficients[i];
        value += polynomial * power(base, static_cast<std::int64_t>(n));
    }
    return value;
}

std::size_t ExponentialPolynomial::order() const {
    std::size_t order = 0;
    for (const auto& [base, coefficients] : terms) order += coefficients.size();
    return order;
}

ExponentialPolynomial exponential_polynomial(const Expression& expression) {
    return {read(expression)};
}

}  // namespace algae
