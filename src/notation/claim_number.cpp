#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "dimension/dimension.hpp"
#include "growth/growth.hpp"
#include "notation/detail/claim_reading.hpp"

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

Integer parse_number(ClaimScanner& scanner, const char* what) {
    constexpr std::size_t longest = 1000;
    const std::string_view rest = scanner.rest();
    std::size_t digits = 0;
    while (digits < rest.size() && is_digit(static_cast<unsigned char>(rest[digits]))) ++digits;
    if (digits == 0) throw unexpected(what, scanner.here);
    if (digits > longest)
        throw SyntaxError{scanner.here,
                          "a number of more than " + std::to_string(longest) + " digits"};
    scanner.here += digits;
    return Integer(rest.substr(0, digits));
}

namespace {

constexpr long largest_degree = 100;     // of a polynomial that is written out
constexpr long most_root = 24;           // N^(1/24)
constexpr int deepest = 50;              // brackets in each other
constexpr std::size_t most_digits = 30;  // of numbers under logarithms

bool is_digit_next(ClaimScanner& scanner) {
    const std::string_view rest = scanner.rest();
    return !rest.empty() && is_digit(static_cast<unsigned char>(rest.front()));
}

/// A natural number of at most 30 digits; messages call it `what`.
Integer parse_short(ClaimScanner& scanner, const char* what) {
    const char* const where = scanner.rest().data();
    Integer number = parse_number(scanner, what);
    if (static_cast<std::size_t>(scanner.here - where) > most_digits)
        throw SyntaxError{
            where, "expected a number of at most " + std::to_string(most_digits) + " digits"};
    return number;
}

/// A number from 1 to `most`. Throws `SyntaxError`.
long parse_small(ClaimScanner& scanner, long most, const char* what) {
    const char* const where = scanner.rest().data();
    const Integer number = parse_number(scanner, what);
    if (number > most || number < 1)
        throw SyntaxError{where, std::string("expected ") + what + " from 1 to " +
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

/// Reads sums, products and quotients of natural numbers and square roots of one of them, such as
/// `(1+sqrt(5))/2`, or the root of one such number, `sqrt((3+sqrt(5))/2)`, `10^(1/4)`: an algebraic
/// integer of at least 1. Throws `SyntaxError`.
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

/// The digits, and the point or bar within them.
std::string_view take_rational(ClaimScanner& scanner) {
    const std::string_view rest = scanner.rest();
    std::size_t length = 0;
    const auto digits = [&] {
        while (length < rest.size() && is_digit(static_cast<unsigned char>(rest[length]))) ++length;
    };
    digits();
    const std::size_t whole = length;
    if (length < rest.size() && (rest[length] == '.' || rest[length] == '/')) {
        ++length;
        digits();
        if (length == whole + 1) length = whole;
    }
    if (whole == 0) throw unexpected("'log' or a number", scanner.here);
    if (length > 1000) throw SyntaxError{scanner.here, "a number of more than 1000 digits"};
    scanner.here += length;
    return rest.substr(0, length);
}

bool is_decimal(ClaimScanner scanner) {
    return is_digit_next(scanner) && take_rational(scanner).find('.') != std::string_view::npos;
}

Rational rational_of(std::string_view text) {
    try {
        return Rational(text);
    } catch (const Error& error) {
        throw SyntaxError{text.data(), error.what()};
    }
}

/// Reads `x^3 - x^2 - 2`, monic, of degree at most 100. Throws `SyntaxError`.
Polynomial parse_polynomial(ClaimScanner& scanner) {
    const char* const where = scanner.rest().data();
    Polynomial sum;
    bool minus = scanner.take("-");
    do {
        Integer coefficient(1);
        const bool has_number = is_digit_next(scanner);
        if (has_number) coefficient = parse_number(scanner, "a coefficient");
        std::size_t exponent = 0;
        if (scanner.take("x"))
            exponent =
                scanner.take("^")
                    ? static_cast<std::size_t>(parse_small(scanner, largest_degree, "an exponent"))
                    : 1;
        else if (!has_number)
            throw unexpected("a polynomial in x", scanner.here);
        const Polynomial term = Polynomial::monomial(coefficient, exponent);
        sum += minus ? -term : term;
        minus = scanner.rest().starts_with('-');
    } while (scanner.take("-") || scanner.take("+"));
    if (sum.degree() < 1 || sum.leading_coefficient() != 1)
        throw SyntaxError{
            where, "expected a polynomial that begins with a power of x, found " + to_string(sum)};
    return sum;
}

/// Reads `12`, `sqrt 10`, `10^(1/4)`, `(1+sqrt(5))/2`, `sqrt((3+sqrt(5))/2)`,
/// `the largest real root of x^3 - x^2 - 2` or `2.618, the square root of a root of x^2 - 3x + 1`: an
/// algebraic integer of at least 1. Throws `SyntaxError`.
AlgebraicInteger parse_algebraic(ClaimScanner& scanner) {
    const auto take_words = [](ClaimScanner& from, std::initializer_list<std::string_view> words) {
        ClaimScanner ahead = from;
        for (const std::string_view word : words)
            if (!ahead.take_word(word)) return false;
        from = ahead;
        return true;
    };
    if (take_words(scanner, {"the", "largest", "real", "root", "of"})) {
        const char* const where = scanner.rest().data();
        return checked(AlgebraicInteger::largest_root(parse_polynomial(scanner)), where);
    }
    ClaimScanner ahead = scanner;
    if (ahead.take("(") && (ahead.name() == "the" || is_decimal(ahead))) {
        const AlgebraicInteger number = parse_algebraic(ahead);
        if (!ahead.take(")")) throw unexpected("')'", ahead.here);
        scanner = ahead;
        return number;
    }
    ahead = scanner;
    if (is_digit_next(ahead)) {
        const std::string_view number = take_rational(ahead);
        if (number.find('.') != std::string_view::npos) {
            if (!ahead.take(",") ||
                !take_words(ahead, {"the", "square", "root", "of", "a", "root", "of"}))
                throw unexpected(
                    "', the square root of a root of' and a polynomial, as a decimal "
                    "number is not exact",
                    ahead.here);
            scanner = ahead;
            const char* const where = scanner.rest().data();
            const double near = rational_of(number).to_double();
            return checked(root_near(of_roots(parse_polynomial(scanner), 2), near), where);
        }
    }
    return parse_surd(scanner);
}

DimensionValue parse_logarithms(ClaimScanner& scanner) {
    const AlgebraicInteger over = parse_algebraic(scanner);
    if (!scanner.take("/")) throw unexpected("'/' and a second logarithm", scanner.here);
    if (!scanner.take_word("log")) throw unexpected("'log'", scanner.here);
    const char* const where = scanner.rest().data();
    const AlgebraicInteger under = parse_algebraic(scanner);
    if (under.integer() == Integer(1))
        throw SyntaxError{where, "expected a number above 1, as log 1 is 0"};
    return DimensionValue(Rational(1), over, under);
}

}  // namespace

DimensionValue parse_dimension_value(ClaimScanner& scanner) {
    const auto one = [&] {
        if (scanner.take_word("log")) return parse_logarithms(scanner);
        return DimensionValue(rational_of(take_rational(scanner)));
    };
    const DimensionValue first = one();
    while (scanner.take("=")) {
        const std::string_view text = scanner.rest();
        const DimensionValue next = one();
        const std::string_view written =
            text.substr(0, static_cast<std::size_t>(scanner.here - text.data()));
        const std::size_t point = written.find('.');
        bool same = compare(first, next) == Order::equal;
        if (!same && point != std::string_view::npos &&
            is_digit(static_cast<unsigned char>(written.front()))) {
            const int digits = static_cast<int>(written.size() - point - 1);
            same = decimal([&](long bits) { return first.enclosure(bits); }, digits) == written;
        }
        if (!same)
            throw SyntaxError{written.data(), "expected the number before '=' again, found " +
                                                  quoted(written) +
                                                  ", which is not known to be it"};
    }
    return first;
}

}  // namespace algae
