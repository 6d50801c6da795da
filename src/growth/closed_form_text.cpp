#include <algorithm>

#include "growth/closed_form.hpp"
#include "growth/radicals.hpp"

namespace algae {

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

std::size_t terms(const Polynomial& value) {
    return static_cast<std::size_t>(std::count_if(value.coefficients().begin(), value.coefficients().end(),
                                                  [](const Integer& x) { return !x.is_zero(); }));
}

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
        for (const auto& coefficient : part->coefficients) below = lcm(below, coefficient.denominator.coefficient(0));
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
    return (terms(coefficient.numerator) > 1 ? "(" + above + ")" : above) + "/" + to_string(coefficient.denominator);
}

std::string general_part(const ClosedFormTerm& part) {
    std::string text = "sum over the roots r of " + to_string(part.polynomial) + " of ";
    if (part.polynomial.degree() > ClosedForm::largest_written_degree)
        return text + "c(r)*r^n, c(r) the residue of the generating function";
    std::string factor;
    for (std::size_t k = part.coefficients.size(); k-- > 0;)
        if (!part.coefficients[k].numerator.is_zero()) add(factor, with_power_of_n(in_root(part.coefficients[k]), k));
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
