#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <string>

#include "exact/exact.hpp"
#include "notation/notation.hpp"
#include "notation/random_text.hpp"
#include "system/system.hpp"

using namespace algae;

namespace {

std::string text(const std::string& written) { return to_text(read_expression(written)); }

Quantity value(const std::string& written) { return evaluate(read_expression(written), {}); }

std::optional<Rational> exact(const std::string& written) { return value(written).exact; }

std::string failure(const std::string& written) {
    try {
        value(written);
        return {};
    } catch (const Diagnostics& error) {
        const Diagnostic& finding = error.findings().front();
        return std::to_string(finding.place.column) + ' ' + finding.message;
    }
}

}  // namespace

TEST_CASE("as few brackets as needed") {
    CHECK(text("((x+y)/2)") == "(x+y)/2");
    CHECK(text("(x+y)+(z)") == "x+y+z");
    CHECK(text("x+(y+z)") == "x+(y+z)");
    CHECK(text("x-(y-z)") == "x-(y-z)");
    CHECK(text("x/(y*z)") == "x/(y*z)");
    CHECK(text("(2^3)^4") == "(2^3)^4");
    CHECK(text("2^(3^4)") == "2^3^4");
    CHECK(text("-(2^2)") == "-2^2");
    CHECK(text("(-2)^2") == "(-2)^2");
    CHECK(text("2^(-x)") == "2^-x");
    CHECK(text("(2^-x)*3") == "2^-x*3");
    CHECK(text("-(-x)") == "--x");
    CHECK(text("!(x = y)") == "!(x = y)");
    CHECK(text("(!x) = y") == "!x = y");
    CHECK(text("(x <= 3) & ((y > 0) | z)") == "x <= 3 & (y > 0 | z)");
    CHECK(text("(x < 3) = (y < 3)") == "(x < 3) = (y < 3)");
    CHECK(text("min( x , max(y,2) )") == "min(x,max(y,2))");
    CHECK(text("x==1 && y>=2 || z") == "x = 1 & y >= 2 | z");
    CHECK(text("1e3+.50+1E-2") == "1000+0.5+0.01");
}

TEST_CASE("precedence") {
    CHECK(exact("-2^2") == Rational(-4));
    CHECK(exact("2^3^2") == Rational(512));
    CHECK(exact("2^-1*4") == Rational(2));
    CHECK(exact("7-2-1") == Rational(4));
    CHECK(exact("8/2/2") == Rational(2));
    CHECK(exact("1+2*3") == Rational(7));
    CHECK(exact("1+1 = 2") == Rational(1));
    CHECK(exact("!0 & 2 > 1 | 0") == Rational(1));
    CHECK(exact("1 | 0 & 0") == Rational(1));
    CHECK(exact("--3") == Rational(3));
    CHECK(exact("3--3") == Rational(6));
}

TEST_CASE("values stay exact where they can") {
    CHECK(exact("1/3+1/6") == Rational(1, 2));
    CHECK(exact("25.7") == Rational(257, 10));
    CHECK(exact("(2/3)^-2") == Rational(9, 4));
    CHECK(exact("sqrt(9/16)") == Rational(3, 4));
    CHECK(exact("sqrt(0)") == Rational(0));
    CHECK(exact("sqrt(10^40)") == power(Rational(10), 20));
    CHECK(exact("min(3,1/2,2)+max(1,5/2)") == Rational(3));
    CHECK(exact("abs(-3)+floor(-1/2)+ceil(1/2)") == Rational(3));
    CHECK(exact("sin(30)+sin(-30)+sin(390)") == Rational(1, 2));
    CHECK(exact("cos(60)+cos(90)+cos(180)+cos(-300)") == Rational(0));
    CHECK(exact("tan(45)+tan(180)+tan(135)-tan(225)") == Rational(-1));
    CHECK(exact("0^0") == Rational(1));
    CHECK(exact("1^(10^30)+(-1)^(10^30)+0^(10^30)") == Rational(2));
    CHECK(exact("sqrt(2) > 1.4") == Rational(1));
    CHECK_FALSE(exact("sqrt(2)").has_value());
    CHECK_FALSE(exact("sqrt(2)*0").has_value());
    CHECK_FALSE(exact("4^0.5").has_value());
    CHECK_FALSE(exact("sin(45)").has_value());
    CHECK(value("2^0.5*4").value == doctest::Approx(5.656854249));
    CHECK(value("atan(1)+asin(1)+acos(0)").value == doctest::Approx(225));
    CHECK(value("exp(log(5))").value == doctest::Approx(5));
    CHECK(value("0.999^100000").value == doctest::Approx(3.54e-44).epsilon(0.01));
}

TEST_CASE("what has no value is refused at its place") {
    CHECK(failure("1+2/(1-1)") == "6 division by 0 in '2/(1-1)'");
    CHECK(failure("x+1") == "1 expected a number or a constant, found 'x'");
    CHECK(failure("0^-1") == "1 a negative power of 0 in '0^-1'");
    CHECK(failure("(-8)^(1/3)") ==
          "2 a power of a negative number that is not whole in '(-8)^(1/3)'");
    CHECK(failure("1+sqrt(-1)") == "3 the square root of a negative number in 'sqrt(-1)'");
    CHECK(failure("asin(2)") == "1 'asin(2)' needs a number from -1 to 1");
    CHECK(failure("tan(90)") == "1 'tan(90)' has no value");
    CHECK(failure("exp(1000)") == "1 the value of 'exp(1000)' is too large");
    CHECK(failure("9^9^9^9") == "3 the value of '9^9^9' is too large");
}

TEST_CASE("quantities are written as a person would") {
    CHECK(to_text(quantity(Rational(257, 10)).expression) == "25.7");
    CHECK(to_text(quantity(Rational(-1, 3)).expression) == "-1/3");
    CHECK(to_text(quantity(Rational(-2)).expression) == "-2");
    CHECK(shortest_text(power(Rational(10), 30)) == "1e30");
    CHECK(shortest_text(Rational(-3) * power(Rational(10), -30)) == "-3e-30");
    CHECK(shortest_text(Rational(1, 1024)) == "0.0009765625");
    CHECK(shortest_text(Rational("123456789012345678901234567890")) ==
          "123456789012345678901234567890");
    CHECK(shortest_text(Rational("12345678901234567890123000")) == "12345678901234567890123e3");
}

TEST_CASE("an expression printed is read back as the same expression") {
    CHECK(rc::check([] {
        const Expression expression =
            read_expression(random_text::expression({"x", "y_2", "ä"}, 5));
        const std::string printed = to_text(expression);
        RC_ASSERT(read_expression(printed) == expression);
        RC_ASSERT(to_text(read_expression(printed)) == printed);
    }));
    CHECK(rc::check([](int numerator, unsigned denominator) {
        const Quantity written = quantity(Rational(numerator, denominator % 1000 + 1));
        const Expression again = read_expression(to_text(written.expression));
        RC_ASSERT(again == written.expression);
        RC_ASSERT(evaluate(again, {}).exact == written.exact);
    }));
}

namespace {

/// Letters with operators of a dialect between them; blanks are skipped.
std::string read_in(const ExpressionDialect& dialect, const std::string& written) {
    const Source source(written, "x");
    const char* here = written.data();
    const char* const end = here + written.size();
    std::string met;
    ExpressionReader reader;
    reader.next = [&](const char* place) {
        while (place != end && *place == ' ') ++place;
        return place;
    };
    reader.operand = [&](const char*& place) {
        if (place == end || *place < 'a' || *place > 'z') throw unexpected("a letter", place);
        return read_expression(std::string(1, *place++));
    };
    reader.met = [&](const char* place) { met += *place; };
    try {
        const Expression read = read_expression(here, end, source, dialect, reader);
        return to_text(read) + " met " + met + " left '" + std::string(here, end) + "'";
    } catch (const SyntaxError& error) {
        return std::to_string(error.where - written.data()) + ' ' + error.message;
    }
}

}  // namespace

TEST_CASE("expressions in the dialect of another program") {
    using Binding = ExpressionDialect::Binding;
    using Powers = ExpressionDialect::Powers;
    ExpressionDialect dialect{{{"plus", "+", Binding::sum},
                               {"-", "-", Binding::sum},
                               {"*", "*", Binding::product},
                               {"**", "^", Binding::power}},
                              {{"-", "-", Binding::prefix}, {"+", "", Binding::prefix}}};
    CHECK(read_in(dialect, "a plus b*c") == "a+b*c met p* left ''");
    CHECK(read_in(dialect, "a - b - -c )") == "a-b--c met --- left ')'");
    CHECK(read_in(dialect, "+a*+ -b") == "a*-b met +*+- left ''");
    CHECK(read_in(dialect, "-a**b") == "-a^b met -* left ''");
    CHECK(read_in(dialect, "a**b**--c") == "a^b^--c met **-- left ''");
    CHECK(read_in(dialect, "a ** ?") == "5 expected a letter, found ");
    dialect.powers = Powers::to_the_left;
    CHECK(read_in(dialect, "a**b**c") == "(a^b)^c met ** left ''");
    dialect.powers = Powers::in_brackets;
    CHECK(read_in(dialect, "-a**-b*c") == "-a^-b*c met -*-* left ''");
    const std::string ask = " expected brackets that say which power is taken first, found ";
    CHECK(read_in(dialect, "a**b**c") == "4" + ask);
    CHECK(read_in(dialect, "a**-b**c") == "5" + ask);
    CHECK(read_in(dialect, "a**--b") == "4 expected a letter, found ");
    CHECK(read_in(dialect, "a**+b") == "3 expected a letter, found ");
    dialect.spaced = true;
    CHECK(read_in(dialect, "a* b *c") == "a*b met * left '*c'");
    CHECK(read_in(dialect, "a*") == "a met  left '*'");
}
