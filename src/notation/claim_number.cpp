#include "notation/claim_number.hpp"

#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "notation/characters.hpp"
#include "notation/claim_growth.hpp"
#include "notation/claim_surd.hpp"
#include "notation/findings.hpp"

namespace algae {

namespace {

constexpr long largest_degree = 100;  // of a polynomial that is written out

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
