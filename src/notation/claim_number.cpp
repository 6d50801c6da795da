#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "dimension/dimension.hpp"
#include "growth/growth.hpp"
#include "notation/detail/claim_reading.hpp"
#include "notation/detail/grammar.hpp"
#include "notation/detail/operator_stack.hpp"

// Numbers in claims, as `algae dimension` prints them: `log 4 / log 3`, `log((1+sqrt(5))/2) / log 2`, `3/2 =
// 1.5`.
//
// What stands under a logarithm is an algebraic integer of at least 1. It is written with square roots of one
// natural number, as a root of such a number, `10^(1/4)`, or by a monic polynomial and which of its roots is
// meant. A sum or product of surds stays in one real quadratic field, where arithmetic is exact
// (`QuadraticNumber`); its minimal polynomial follows from trace and norm, and the k-th root of a number
// satisfies the polynomial p(x^k) (`of_roots`). An `AlgebraicInteger` is the irreducible factors of such a
// polynomial with a function that encloses the number as tightly as asked, which tells which root it is. A
// decimal is not exact: it only picks a root, or it says again, rounded, what stands before `=`.

namespace algae {

namespace x3 = grammar::x3;
using grammar::sets;
using grammar::told;
using grammar::wanted;
using grammar::word;

Integer natural_number(std::string_view digits) {
    constexpr std::size_t longest = 1000;
    if (digits.size() > longest)
        throw SyntaxError{digits.data(),
                          "a number of more than " + std::to_string(longest) + " digits"};
    return Integer(digits);
}

namespace {

constexpr long largest_degree = 100;     // of a polynomial that is written out
constexpr long most_root = 24;           // N^(1/24)
constexpr std::size_t deepest = 50;      // brackets in each other
constexpr std::size_t most_digits = 30;  // of numbers under logarithms

/// A number under a logarithm. Throws `SyntaxError` where it has more than 30 digits.
QuadraticNumber short_number(std::string_view digits) {
    Integer number = natural_number(digits);
    if (digits.size() > most_digits)
        throw SyntaxError{digits.data(), "expected a number of at most " +
                                             std::to_string(most_digits) + " digits"};
    return {Rational(std::move(number)), Rational(0), 1};
}

/// A number from 1 to `most`; messages call it `what`. Throws `SyntaxError`.
long small_number(std::string_view digits, long most, const char* what) {
    const Integer number = natural_number(digits);
    if (number > most || number < 1)
        throw SyntaxError{digits.data(), std::string("expected ") + what + " from 1 to " +
                                             std::to_string(most) + ", found " + to_string(number)};
    return static_cast<long>(number.to_uint64());
}

/// The monic polynomial of the k-th roots of the roots.
Polynomial of_roots(const Polynomial& polynomial, long k) {
    std::vector<Integer> coefficients(static_cast<std::size_t>(polynomial.degree() * k) + 1);
    for (long i = 0; i <= polynomial.degree(); ++i)
        coefficients[static_cast<std::size_t>(i * k)] =
            polynomial.coefficient(static_cast<std::size_t>(i));
    return Polynomial(std::move(coefficients));
}

/// The different irreducible factors.
std::vector<Polynomial> factors_of(const Polynomial& polynomial) {
    std::vector<Polynomial> factors;
    for (const auto& [factor, exponent] : factorise(polynomial).powers) factors.push_back(factor);
    return factors;
}

QuadraticNumber root_of(const Integer& number) {
    const Polynomial polynomial({-number, Integer(0), Integer(1)});
    for (const Polynomial& factor : factors_of(polynomial))
        if (factor.degree() == 1) return {Rational(abs(factor.coefficient(0))), Rational(0), 1};
    return larger_root(polynomial);
}

/// What the operator `+`, `-`, `*` or `/` at this place makes of two numbers. The right one of a division is
/// rational. Throws `SyntaxError`.
QuadraticNumber combined_numbers(const QuadraticNumber& left, const QuadraticNumber& right,
                                 const char* operation) {
    if (const auto made = combined(left, *operation, right)) return *made;
    if (right.is_rational()) throw SyntaxError{operation, "division by 0"};
    throw SyntaxError{operation, "expected roots of one number, found roots of " +
                                     to_string(left.radicand) + " and " +
                                     to_string(right.radicand)};
}

/// The root of a number that stands at this place. Throws `SyntaxError` unless it is a natural one.
QuadraticNumber root_within_sum(const QuadraticNumber& number, const char* where) {
    if (!number.factor.is_zero() || !number.rational.is_integer() || number.rational < Rational(1))
        throw SyntaxError{where,
                          "expected a natural number, as a root within a sum or "
                          "product is one of a natural number"};
    return root_of(number.rational.numerator());
}

/// Reads sums, products and quotients of natural numbers and square roots of one of them, with `/` unless a
/// logarithm comes next; or only the first operand of such a sum. Throws `SyntaxError`.
QuadraticNumber parse_sum(const char*& here, const char* end, bool only_operand) {
    using Numbers = std::vector<QuadraticNumber>;
    enum Binding { sum, product, root };
    OperatorStack<QuadraticNumber> stack;
    const auto on_root = told([&](std::string_view at) {
        stack.prefix(root, [at](Numbers of) { return root_within_sum(of[0], at.data()); });
    });
    const auto on_open = told([&](std::string_view at) {
        stack.open([](Numbers held) { return held[0]; });
        if (stack.depth() > deepest) throw SyntaxError{at.data() + 1, "too many brackets"};
    });
    const auto on_close = [&](auto&) { stack.close(); };
    const auto on_number = told([&](std::string_view text) { stack.operand(short_number(text)); });
    const auto infix = [&](Binding binding) {
        return told([&stack, binding](std::string_view at) {
            stack.infix(binding,
                        [at](Numbers of) { return combined_numbers(of[0], of[1], at.data()); });
        });
    };
    const auto is_open = [&](auto& c) { x3::_pass(c) = stack.depth() > 0; };
    const auto goes_on = [&](auto& c) { x3::_pass(c) = stack.depth() > 0 || !only_operand; };

    const auto prefix = (word("sqrt") >> grammar::here[on_root]) | x3::raw[x3::lit('(')][on_open];
    const auto division = x3::raw['/' >> !word("log")][infix(product)] >>
                          wanted("a number or 'log'")[grammar::digits[on_number]];
    const auto behind =
        (x3::eps[is_open] >> x3::lit(')')[on_close]) | (x3::eps[goes_on] >> division);
    const auto next = x3::eps[goes_on] >> (x3::raw[x3::lit('*')][infix(product)] |
                                           x3::raw[x3::char_("+-")][infix(sum)]);
    const auto operand =
        *prefix >> wanted("a number, 'sqrt' or '('")[grammar::digits[on_number]] >> *behind;
    grammar::read(here, end, operand % next);
    const QuadraticNumber whole = stack.finish();
    if (stack.depth() > 0) throw unexpected("')'", here);
    return whole;
}

/// The k-th root of a real quadratic number.
AlgebraicInteger root(const QuadraticNumber& number, long k, const char* where) {
    const Rational trace = number.rational * Rational(2);
    const Rational norm = number.rational * number.rational -
                          number.factor * number.factor * Rational(number.radicand);
    const bool is_rational = number.factor.is_zero();
    if (is_rational ? !number.rational.is_integer() : !trace.is_integer() || !norm.is_integer())
        throw SyntaxError{where, "expected an algebraic integer, found " + to_string(number)};
    const Polynomial polynomial =
        is_rational ? Polynomial({-number.rational.numerator(), Integer(1)})
                    : Polynomial({norm.numerator(), -trace.numerator(), Integer(1)});
    const auto enclose = [&](long bits) {
        const Ball value = Ball(number.rational, bits + 16) +
                           Ball(number.factor, bits + 16) * sqrt(Ball(number.radicand, bits + 16));
        return k == 1 ? value : exp(log(value) / Ball(k, bits + 16));
    };
    if (compare(enclose(64), Ball(1, 64)) == Order::less)
        throw SyntaxError{where, "expected a number of at least 1"};
    return AlgebraicInteger(factors_of(of_roots(polynomial, k)), enclose);
}

/// Reads sums, products and quotients of natural numbers and square roots of one of them, such as
/// `(1+sqrt(5))/2`, or the root of one such number, `sqrt((3+sqrt(5))/2)`, `10^(1/4)`: an algebraic
/// integer of at least 1. Throws `SyntaxError`.
AlgebraicInteger parse_surd(const char*& here, const char* end) {
    QuadraticNumber number;
    long degree = 1;  // of the root
    const char* where = here;
    const auto on_degree =
        told([&](std::string_view text) { degree = small_number(text, most_root, "a root"); });
    const auto sum = [&](bool only_operand) {
        return grammar::into(number, [only_operand](const char*& first, const char* last) {
            return parse_sum(first, last, only_operand);
        });
    };
    const auto in_power = [](char token) {
        return wanted("'(1/' and a number after '^'")[x3::lit(token)];
    };
    const auto power = '^' >> in_power('(') >> in_power('1') >> in_power('/') >>
                       wanted("a root")[grammar::digits[on_degree]] >> wanted("')'")[x3::lit(')')];
    // What stands behind a root tells whether it is one of a whole number like these.
    const auto square_root =
        word("sqrt") >> sum(true) >> !x3::char_("*+-") >> x3::eps[sets(degree, 2)];
    grammar::read(here, end,
                  grammar::place(where) >> (square_root | (sum(true) >> power) | sum(false)));
    return root(number, degree, where);
}

/// The real root above 0 that lies nearest.
std::optional<AlgebraicInteger> root_near(const Polynomial& polynomial, double near) {
    std::optional<Ball> best;
    for (const Root& root : roots(polynomial, 256))
        if (root.is_real && compare(root.real, Ball(0, 256)) == Order::greater &&
            (!best || std::abs(root.real.midpoint() - near) < std::abs(best->midpoint() - near)))
            best = root.real;
    if (!best) return std::nullopt;
    return AlgebraicInteger(factors_of(polynomial), [&](long) { return *best; });
}

AlgebraicInteger checked(const std::optional<AlgebraicInteger>& number, const char* where) {
    if (!number || compare(number->enclosure(64), Ball(1, 64)) == Order::less)
        throw SyntaxError{where, "expected a polynomial with such a root of at least 1"};
    return *number;
}

Rational rational_of(std::string_view text) {
    try {
        return Rational(text);
    } catch (const Error& error) {
        throw SyntaxError{text.data(), error.what()};
    }
}

/// Digits, with a point or bar within them.
const auto fraction =
    x3::raw[x3::lexeme[+x3::char_('0', '9') >> -(x3::char_("./") >> +x3::char_('0', '9'))]];

bool is_decimal(std::string_view number) {
    constexpr std::size_t longest = 1000;
    if (number.size() > longest)
        throw SyntaxError{number.data(),
                          "a number of more than " + std::to_string(longest) + " digits"};
    return number.find('.') != std::string_view::npos;
}

/// Reads `x^3 - x^2 - 2`, of degree at most 100, and monic if that is wanted. Throws `SyntaxError`.
Polynomial parse_polynomial(const char*& here, const char* end, bool monic = true) {
    Polynomial sum;
    const char* where = here;
    bool minus = false;
    std::optional<Integer> coefficient;
    std::size_t exponent = 0;
    const auto on_sign = told([&](std::string_view sign) { minus = sign == "-"; });
    const auto on_coefficient =
        told([&](std::string_view text) { coefficient = natural_number(text); });
    const auto on_exponent = told([&](std::string_view text) {
        exponent = static_cast<std::size_t>(small_number(text, largest_degree, "an exponent"));
    });
    const auto has_coefficient = [&](auto& c) { x3::_pass(c) = coefficient.has_value(); };
    const auto on_term = [&](auto&) {
        const Polynomial term = Polynomial::monomial(coefficient.value_or(1), exponent);
        sum += minus ? -term : term;
        coefficient.reset();
        exponent = 0;
    };
    const auto power = x3::lit('x')[sets(exponent, std::size_t{1})] >>
                       -('^' >> wanted("an exponent")[grammar::digits[on_exponent]]);
    const auto term = -grammar::digits[on_coefficient] >>
                      wanted("a polynomial in x")[power | x3::eps[has_coefficient]] >>
                      x3::eps[on_term];
    grammar::read(here, end,
                  grammar::place(where) >> -x3::raw[x3::lit('-')][on_sign] >>
                      term % x3::raw[x3::char_("+-")][on_sign]);
    if (sum.degree() < 1 && !monic)
        throw SyntaxError{where, "expected a polynomial in x, found " + to_string(sum)};
    if (monic && (sum.degree() < 1 || sum.leading_coefficient() != 1))
        throw SyntaxError{
            where, "expected a polynomial that begins with a power of x, found " + to_string(sum)};
    return sum;
}

/// Reads `12`, `sqrt 10`, `10^(1/4)`, `(1+sqrt(5))/2`, `sqrt((3+sqrt(5))/2)`,
/// `the largest real root of x^3 - x^2 - 2` or `2.618, the square root of a root of x^2 - 3x + 1`: an
/// algebraic integer of at least 1. Throws `SyntaxError`.
AlgebraicInteger parse_algebraic(const char*& here, const char* end) {
    std::optional<AlgebraicInteger> number;
    std::string_view near;
    const char* where = here;
    const auto at_decimal = [&](auto& c) {
        near = grammar::text_of(x3::_attr(c));
        x3::_pass(c) = is_decimal(near);
    };
    const auto largest_root = grammar::into(number, [&](const char*& first, const char* last) {
        return checked(AlgebraicInteger::largest_root(parse_polynomial(first, last)), where);
    });
    const auto nearest_root = grammar::into(number, [&](const char*& first, const char* last) {
        const double value = rational_of(near).to_double();
        return checked(root_near(of_roots(parse_polynomial(first, last), 2), value), where);
    });
    const auto is_exact =
        "', the square root of a root of' and a polynomial, as a decimal number is not exact";
    const auto largest = word("the") >> word("largest") >> word("real") >> word("root") >>
                         word("of") >> grammar::place(where) >> largest_root;
    const auto square_root_of = word("the") >> word("square") >> word("root") >> word("of") >>
                                word("a") >> word("root") >> word("of");
    const auto nearest = fraction[at_decimal] >> wanted(is_exact)[x3::lit(',')] >>
                         wanted(is_exact)[square_root_of] >> grammar::place(where) >> nearest_root;
    const auto bracketed = '(' >> &(word("the") | fraction[at_decimal]) >>
                           grammar::into(number, parse_algebraic) >> wanted("')'")[x3::lit(')')];
    grammar::read(here, end, largest | bracketed | nearest | grammar::into(number, parse_surd));
    return std::move(*number);
}

}  // namespace

ClaimedNumber parse_claimed_number(const char*& here, const char* end) {
    ClaimedNumber read;
    const char* const where = here;
    const auto largest = grammar::into(read.polynomial, [&](const char*& first, const char* last) {
        const Polynomial written = parse_polynomial(first, last, false);
        std::optional<Ball> greatest;
        std::optional<Polynomial> found;
        for (const Polynomial& factor : factors_of(written))
            for (const Root& root : roots(factor, 256))
                if (root.is_real && (!greatest || compare(*greatest, root.real) == Order::less)) {
                    greatest = root.real;
                    found = factor;
                }
        if (!found)
            throw SyntaxError{
                where, "expected a polynomial with a real root, found " + to_string(written)};
        for (const Root& root : roots(*found, 64)) read.root += root.is_real;
        --read.root;
        return *found;
    });
    const auto surd = grammar::into(read.polynomial, [&](const char*& first, const char* last) {
        const QuadraticNumber number = parse_sum(first, last, false);
        const Rational trace = number.rational * Rational(2),
                       norm = number.rational * number.rational -
                              number.factor * number.factor * Rational(number.radicand);
        // Numerators of x - r, or x^2 - trace x + norm.
        const bool is_rational = number.factor.is_zero();
        const Rational one = is_rational ? -number.rational : norm,
                       next = is_rational ? Rational(1) : -trace;
        const Integer common = one.denominator() * next.denominator();
        std::vector<Integer> terms;
        for (const Rational& term : {one, next, Rational(1)})
            terms.push_back((term * Rational(common)).numerator());
        if (is_rational) terms.pop_back();
        read.root = !is_rational && number.factor > Rational(0);
        return factors_of(Polynomial(std::move(terms))).front();
    });
    grammar::read(
        here, end,
        (word("the") >> word("largest") >> word("real") >> word("root") >> word("of") >> largest) |
            surd);
    if (read.polynomial.leading_coefficient() < 0) read.polynomial = -read.polynomial;
    read.text = trimmed(std::string_view(where, static_cast<std::size_t>(here - where)));
    return read;
}

DimensionValue parse_dimension_value(const char*& here, const char* end) {
    std::optional<AlgebraicInteger> over;
    std::optional<DimensionValue> first, next;
    const char* where = here;
    const auto divisor = grammar::into(next, [&](const char*& from, const char* last) {
        const AlgebraicInteger under = parse_algebraic(from, last);
        if (under.integer() == Integer(1))
            throw SyntaxError{where, "expected a number above 1, as log 1 is 0"};
        return DimensionValue(Rational(1), *over, under);
    });
    const auto on_fraction = told([&](std::string_view text) {
        is_decimal(text);
        next.emplace(rational_of(text));
    });
    const auto on_value = told([&](std::string_view written) {
        if (!first) {
            first = *next;
            return;
        }
        bool same = compare(*first, *next) == Order::equal;
        const std::size_t point = written.find('.');
        if (!same && point != std::string_view::npos &&
            is_digit(static_cast<unsigned char>(written.front()))) {
            const int digits = static_cast<int>(written.size() - point - 1);
            same = decimal([&](long bits) { return first->enclosure(bits); }, digits) == written;
        }
        if (!same)
            throw SyntaxError{written.data(), "expected the number before '=' again, found " +
                                                  quoted(written) +
                                                  ", which is not known to be it"};
    });
    const auto logarithms = word("log") >> grammar::into(over, parse_algebraic) >>
                            wanted("'/' and a second logarithm")[x3::lit('/')] >>
                            wanted("'log'")[word("log")] >> grammar::place(where) >> divisor;
    const auto value = logarithms | wanted("'log' or a number")[fraction[on_fraction]];
    grammar::read(here, end, x3::raw[value][on_value] % '=');
    return std::move(*first);
}

}  // namespace algae
