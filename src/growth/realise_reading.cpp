#include "growth/realise_specification.hpp"

#include <algorithm>
#include <cctype>

#include "base/error.hpp"

namespace algae {

namespace {

using Coefficients = std::vector<Rational>;  // of a polynomial in n, from the constant one upwards

constexpr std::size_t highest_degree = 200;

Coefficients sum(Coefficients left, const Coefficients& right, const Rational& times) {
    left.resize(std::max(left.size(), right.size()));
    for (std::size_t i = 0; i < right.size(); ++i) left[i] += times * right[i];
    while (!left.empty() && left.back().is_zero()) left.pop_back();
    return left;
}

Coefficients product(const Coefficients& left, const Coefficients& right) {
    if (left.empty() || right.empty()) return {};
    Coefficients result(left.size() + right.size() - 1);
    for (std::size_t i = 0; i < left.size(); ++i)
        for (std::size_t j = 0; j < right.size(); ++j) result[i + j] += left[i] * right[j];
    return result;
}

/// Reads a specification from left to right.
class Reader {
public:
    explicit Reader(const std::string& text) : text_(text) {}

    bool at_end() {
        skip();
        return at_ == text_.size();
    }
    bool take(char c) {
        skip();
        if (at_ == text_.size() || text_[at_] != c) return false;
        ++at_;
        return true;
    }
    void expect(char c, const std::string& why) {
        if (!take(c)) fail(std::string("expected '") + c + "' " + why);
    }
    bool digit_follows() {
        skip();
        return at_ < text_.size() && std::isdigit(static_cast<unsigned char>(text_[at_])) != 0;
    }
    bool letter_follows() {
        skip();
        return at_ < text_.size() && std::isalpha(static_cast<unsigned char>(text_[at_])) != 0;
    }
    bool follows(char c) {
        skip();
        return at_ < text_.size() && text_[at_] == c;
    }
    char letter() { return text_[at_++]; }
    Rational natural(const std::string& what = "a number") {
        if (!digit_follows()) fail("expected " + what);
        const std::size_t begin = at_;
        while (at_ < text_.size() && std::isdigit(static_cast<unsigned char>(text_[at_])) != 0) ++at_;
        return Rational(Integer(std::string_view(text_).substr(begin, at_ - begin)));
    }
    std::size_t small(const std::string& what, std::size_t most) {
        const std::size_t begin = at_;
        const Rational value = natural(what + " written as a number");
        if (value > Rational(most)) {
            at_ = begin;
            skip();
            fail("expected " + what + " of at most " + std::to_string(most));
        }
        return static_cast<std::size_t>(value.numerator().to_uint64());
    }
    [[noreturn]] void fail(const std::string& expected) {
        skip();
        throw Error("the sequence \"" + text_ + "\", place " + std::to_string(at_ + 1) + ": " + expected + ", found " +
                    (at_ < text_.size() ? std::string("\"") + text_.substr(at_, 12) + '"' : std::string("its end")));
    }

private:
    void skip() {
        while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_])) != 0) ++at_;
    }
    const std::string& text_;
    std::size_t at_ = 0;
};

Rational signed_number(Reader& in) {
    const bool minus = in.take('-');
    Rational value = in.natural();
    if (in.take('/')) {
        const Rational divisor = in.natural();
        if (divisor.is_zero()) in.fail("expected a divisor other than 0");
        value /= divisor;
    }
    return minus ? -value : value;
}

std::vector<Rational> terms(Reader& in) {
    std::vector<Rational> values;
    do {
        if (in.follows('.')) {
            for (int i = 0; i < 3; ++i) in.expect('.', "of the dots that stand for further terms");
            break;
        }
        values.push_back(signed_number(in));
    } while (in.take(','));
    if (!in.at_end()) in.fail("expected a comma between terms");
    return values;
}

/// A polynomial: sums of products of powers; a number, ) or n before ( or n multiplies it.
Coefficients polynomial(Reader& in, int depth = 0);

Coefficients atom(Reader& in, int depth) {
    if (depth > 100) in.fail("expected at most 100 brackets within each other");
    if (in.take('(')) {
        Coefficients inside = polynomial(in, depth + 1);
        in.expect(')', "after what it encloses");
        return inside;
    }
    if (in.digit_follows()) {
        const Rational value = in.natural();
        return value.is_zero() ? Coefficients{} : Coefficients{value};
    }
    if (in.take('n')) return {0, 1};
    in.fail("expected a number, n or '('");
}

Coefficients power(Reader& in, int depth) {
    const Coefficients base = atom(in, depth);
    if (!in.take('^')) return base;
    const std::size_t exponent = in.small("an exponent", highest_degree);
    Coefficients result{1};
    for (std::size_t i = 0; i < exponent; ++i) {
        result = product(result, base);
        if (result.size() > highest_degree + 1) in.fail("expected a degree of at most " + std::to_string(highest_degree));
    }
    return result;
}

Coefficients factors_of(Reader& in, int depth) {
    Coefficients value = power(in, depth);
    for (;;) {
        if (in.take('/')) {
            const Coefficients divisor = power(in, depth);
            if (divisor.size() != 1) in.fail("expected a number other than 0 as the divisor");
            for (Rational& coefficient : value) coefficient /= divisor[0];
        } else if (in.take('*') || in.follows('(') || in.follows('n')) {
            value = product(value, power(in, depth));
            if (value.size() > highest_degree + 1) in.fail("expected a degree of at most " + std::to_string(highest_degree));
        } else {
            return value;
        }
    }
}

Coefficients polynomial(Reader& in, int depth) {
    Coefficients value;
    Rational times = in.take('-') ? -1 : 1;
    for (;;) {
        value = sum(value, factors_of(in, depth), times);
        if (in.take('+'))
            times = 1;
        else if (in.take('-'))
            times = -1;
        else
            return value;
    }
}

SequenceSpecification of_polynomial(const Coefficients& polynomial) {
    SequenceSpecification sequence;
    const std::size_t order = std::max<std::size_t>(polynomial.size(), 1);
    for (std::size_t n = 0; n < order; ++n) {
        Rational value = 0;
        for (std::size_t i = polynomial.size(); i-- > 0;) value = value * Rational(n) + polynomial[i];
        sequence.initial.push_back(value);
    }
    Rational binomial = 1;  // f has order-th difference 0
    for (std::size_t i = 1; i <= order; ++i) {
        binomial = binomial * Rational(order + 1 - i) / Rational(i);
        sequence.coefficients.push_back(i % 2 == 1 ? binomial : -binomial);
    }
    return sequence;
}

/// "a(n) = 2a(n-1) - a(n-3) + 5; 1, 1, 2".
SequenceSpecification recurrence(Reader& in) {
    const char name = in.letter();
    in.expect('(', "as in a(n)");
    in.expect('n', "as in a(n)");
    in.expect(')', "as in a(n)");
    in.expect('=', "after a(n)");
    std::vector<Rational> coefficients;
    Rational constant = 0, times = in.take('-') ? -1 : 1;
    for (;;) {
        Rational value = times;
        if (in.digit_follows()) {
            value *= in.natural();
            if (in.take('/')) {
                const Rational divisor = in.natural();
                if (divisor.is_zero()) in.fail("expected a divisor other than 0");
                value /= divisor;
            }
            in.take('*');
            if (!in.letter_follows()) {
                constant += value;
                value = 0;
            }
        }
        if (in.letter_follows()) {
            in.expect(name, "as on the left side");
            in.expect('(', "as in a(n-1)");
            in.expect('n', "as in a(n-1)");
            in.expect('-', "as in a(n-1)");
            const std::size_t back = in.small("a number of steps back", 1000);
            if (back == 0) in.fail("expected an earlier term than a(n)");
            in.expect(')', "as in a(n-1)");
            if (coefficients.size() < back) coefficients.resize(back);
            coefficients[back - 1] += value;
        } else if (!value.is_zero()) {
            in.fail("expected a number or an earlier term");
        }
        if (in.take('+'))
            times = 1;
        else if (in.take('-'))
            times = -1;
        else
            break;
    }
    while (!coefficients.empty() && coefficients.back().is_zero()) coefficients.pop_back();
    in.expect(';', "and first values after the recurrence");
    SequenceSpecification sequence{coefficients, terms(in), 0};
    if (sequence.initial.size() < coefficients.size())
        in.fail("expected " + std::to_string(coefficients.size()) + " first values, as many as the recurrence goes back");
    if (!constant.is_zero()) {  // the difference of two neighbours has no constant
        Rational next = constant;
        for (std::size_t i = 0; i < coefficients.size(); ++i)
            next += coefficients[i] * sequence.initial[sequence.initial.size() - 1 - i];
        sequence.initial.push_back(next);
        sequence.coefficients.assign(coefficients.size() + 1, 0);
        sequence.coefficients[0] = 1;
        for (std::size_t i = 0; i < coefficients.size(); ++i) {
            sequence.coefficients[i] += coefficients[i];
            sequence.coefficients[i + 1] -= coefficients[i];
        }
    }
    return sequence;
}

}  // namespace

SequenceSpecification read_specification(const std::string& text) {
    Reader in(text);
    if (in.at_end()) in.fail("expected terms such as 1,1,2,3, a recurrence or a polynomial in n");
    if (text.find('=') != std::string::npos) {
        if (!in.letter_follows()) in.fail("expected a(n) on the left side of the recurrence");
        return recurrence(in);
    }
    if (text.find(',') != std::string::npos) return recurrence_of_terms(terms(in));
    const Coefficients value = polynomial(in);
    if (!in.at_end()) in.fail("expected an operator or the end of the polynomial");
    return of_polynomial(value);
}

}  // namespace algae
