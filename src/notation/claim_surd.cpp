#include "notation/claim_surd.hpp"

#include <string>
#include <string_view>
#include <utility>

#include "growth/radicals.hpp"
#include "notation/characters.hpp"
#include "notation/claim_growth.hpp"
#include "notation/findings.hpp"

namespace algae {

namespace {

constexpr long most_root = 24;           // N^(1/24)
constexpr int deepest = 50;              // brackets in each other
constexpr std::size_t most_digits = 30;  // of numbers under logarithms

QuadraticNumber root_of(const Integer& number) {
    const Polynomial polynomial({-number, Integer(0), Integer(1)});
    for (const Polynomial& factor : factors_of(polynomial))
        if (factor.degree() == 1) return {Rational(abs(factor.coefficient(0))), Rational(0), 1};
    return larger_root(polynomial);
}

/// Sums, products and quotients of natural numbers and square roots of one of them.
class Surd {
public:
    explicit Surd(ClaimScanner& scanner) : scanner_(scanner) {}

    QuadraticNumber sum() {
        QuadraticNumber value = product();
        for (;;) {
            const bool minus = scanner_.rest().starts_with('-');
            if (!minus && !scanner_.rest().starts_with('+')) return value;
            const char* const where = scanner_.rest().data();
            ++scanner_.here;
            const QuadraticNumber right = product();
            const Rational sign(minus ? -1 : 1);
            value = {value.rational + sign * right.rational, value.factor + sign * right.factor,
                     common(value, right, where)};
        }
    }

    QuadraticNumber atom() {
        if (scanner_.take_word("sqrt")) {
            const char* const where = scanner_.rest().data();
            const QuadraticNumber number = atom();
            if (!number.factor.is_zero() || !number.rational.is_integer() ||
                number.rational < Rational(1))
                throw SyntaxError{where,
                                  "expected a natural number, as a root within a sum or "
                                  "product is one of a natural number"};
            return root_of(number.rational.numerator());
        }
        if (scanner_.take("(")) {
            if (++depth_ > deepest) throw SyntaxError{scanner_.here, "too many brackets"};
            const QuadraticNumber value = sum();
            if (!scanner_.take(")")) throw unexpected("')'", scanner_.here);
            --depth_;
            return value;
        }
        if (!is_digit_next(scanner_)) throw unexpected("a number, 'sqrt' or '('", scanner_.here);
        return {Rational(parse_short(scanner_, "a number")), Rational(0), 1};
    }

    /// With `*`, and with `/` unless a logarithm comes next.
    QuadraticNumber product() {
        QuadraticNumber value = atom();
        for (;;) {
            const char* const where = scanner_.rest().data();
            if (scanner_.take("*")) {
                const QuadraticNumber right = atom();
                const Integer radicand = common(value, right, where);
                value = {value.rational * right.rational +
                             value.factor * right.factor * Rational(radicand),
                         value.rational * right.factor + value.factor * right.rational, radicand};
            } else if (is_division()) {
                scanner_.take("/");
                const Integer divisor = parse_short(scanner_, "a number or 'log'");
                if (divisor.is_zero()) throw SyntaxError{where, "division by 0"};
                value.rational /= Rational(divisor);
                value.factor /= Rational(divisor);
            } else {
                return value;
            }
        }
    }

private:
    bool is_division() {
        ClaimScanner ahead = scanner_;
        return ahead.take("/") && ahead.name() != "log";
    }

    static Integer common(const QuadraticNumber& left, const QuadraticNumber& right,
                          const char* where) {
        if (left.factor.is_zero()) return right.radicand;
        if (!right.factor.is_zero() && left.radicand != right.radicand)
            throw SyntaxError{where, "expected roots of one number, found roots of " +
                                         to_string(left.radicand) + " and " +
                                         to_string(right.radicand)};
        return left.radicand;
    }

    ClaimScanner& scanner_;
    int depth_ = 0;
};

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

}  // namespace

bool is_digit_next(ClaimScanner& scanner) {
    const std::string_view rest = scanner.rest();
    return !rest.empty() && is_digit(static_cast<unsigned char>(rest.front()));
}

Integer parse_short(ClaimScanner& scanner, const char* what) {
    const char* const where = scanner.rest().data();
    Integer number = parse_number(scanner, what);
    if (static_cast<std::size_t>(scanner.here - where) > most_digits)
        throw SyntaxError{
            where, "expected a number of at most " + std::to_string(most_digits) + " digits"};
    return number;
}

long parse_small(ClaimScanner& scanner, long most, const char* what) {
    const char* const where = scanner.rest().data();
    const Integer number = parse_number(scanner, what);
    if (number > most || number < 1)
        throw SyntaxError{where, std::string("expected ") + what + " from 1 to " +
                                     std::to_string(most) + ", found " + to_string(number)};
    return static_cast<long>(number.to_uint64());
}

Polynomial of_roots(const Polynomial& polynomial, long k) {
    std::vector<Integer> coefficients(static_cast<std::size_t>(polynomial.degree() * k) + 1);
    for (long i = 0; i <= polynomial.degree(); ++i)
        coefficients[static_cast<std::size_t>(i * k)] =
            polynomial.coefficient(static_cast<std::size_t>(i));
    return Polynomial(std::move(coefficients));
}

std::vector<Polynomial> factors_of(const Polynomial& polynomial) {
    std::vector<Polynomial> factors;
    for (const auto& [factor, exponent] : factorise(polynomial).powers) factors.push_back(factor);
    return factors;
}

AlgebraicInteger parse_surd(ClaimScanner& scanner) {
    const char* const where = scanner.rest().data();
    const bool is_root = scanner.name() == "sqrt";
    ClaimScanner ahead = scanner;
    if (is_root) ahead.take_word("sqrt");
    const QuadraticNumber alone = Surd(ahead).atom();  // if nothing is added to it
    if (!is_root && ahead.take("^")) {
        if (!ahead.take("(") || !ahead.take("1") || !ahead.take("/"))
            throw unexpected("'(1/' and a number after '^'", ahead.here);
        const long k = parse_small(ahead, most_root, "a root");
        if (!ahead.take(")")) throw unexpected("')'", ahead.here);
        scanner = ahead;
        return root(alone, k, where);
    }
    const std::string_view rest = ahead.rest();
    if (is_root &&
        (rest.empty() || std::string_view("*+-").find(rest.front()) == std::string_view::npos)) {
        scanner = ahead;
        return root(alone, 2, where);
    }
    return root(Surd(scanner).sum(), 1, where);
}

}  // namespace algae
