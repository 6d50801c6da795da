// Claims about dimensions: the numbers they hold, and what is said where they cannot be read.
#include <doctest/doctest.h>

#include "dimension/dimension.hpp"
#include "notation/claim_said.hpp"

using namespace algae;

namespace {

const std::string system_line = "let G = D0L { axiom F; F -> F+F--F+F; angle 60 }\n";

ClaimedDimension value(const std::string& text) {
    return said_in<HasDimension>(
               claim(system_line + "show dimension(G) = " + text).statements.at(0).statement)
        .dimension;
}
double number(const std::string& text) { return value(text).value->enclosure(64).midpoint(); }
std::string said(const std::string& text) { return claim_messages(system_line + "show " + text); }

}  // namespace

TEST_CASE("numbers as the command prints them") {
    CHECK(number("log 4 / log 3") == doctest::Approx(1.2618595071));
    CHECK(number("log 4/log 3") == doctest::Approx(1.2618595071));
    CHECK(number("log 6 / log sqrt 10") == doctest::Approx(1.5563025008));
    CHECK(number("log 2 / log 10^(1/4)") == doctest::Approx(1.2041199827));
    CHECK(number("log 2 / log (1+sqrt(5))/2") == doctest::Approx(1.4404200904));
    CHECK(number("log 2 / log sqrt((3+sqrt(5))/2)") == doctest::Approx(1.4404200904));
    CHECK(number("log 2 / log ((3+sqrt(5))/2)^(1/2)") == doctest::Approx(1.4404200904));
    CHECK(number("log 2 / log 2*sqrt(2)") == doctest::Approx(2.0 / 3));
    CHECK(number("log 1+sqrt(2) / log 2") == doctest::Approx(1.2715533031));
    CHECK(number("log the largest real root of x^3 - x^2 - 2 / log sqrt 2") ==
          doctest::Approx(1.5236270862));
    CHECK(number("log 2 / log 1.61803, the square root of a root of x^2 - 3x + 1") ==
          doctest::Approx(1.4404200904));
    CHECK(number("log (the largest real root of x^3 - x^2 - 2) / log sqrt 2") ==
          doctest::Approx(1.5236270862));
    CHECK(number("log 2 / log (1.61803, the square root of a root of x^2 - 3x + 1)") ==
          doctest::Approx(1.4404200904));
    CHECK(number("log ((3+sqrt(5))/2) / log ((1+sqrt(5))/2) = 2") == doctest::Approx(2));
    CHECK(number("log 8 / log 4 = 3/2") == 1.5);
    CHECK(number("2") == 2);
    CHECK(number("1.25") == 1.25);
    CHECK(value("log 4 / log 3 = 1.26186").text == "log 4 / log 3 = 1.26186");
}

TEST_CASE("what dimensions are compared by") {
    const auto statement = [](const std::string& text) {
        return claim(system_line + "show " + text).statements.at(0).statement;
    };
    CHECK(is_said<HasDimension>(statement("dimension(G) = 1")));
    CHECK(is_said<BoundaryHasDimension>(statement("boundary (G) = 1")));
    CHECK(statement("dimension(G) != 1").negated);
    CHECK(statement("not dimension(G) <= 1").negated);
    CHECK(said_in<HasDimension>(statement("dimension(G) <= 1")).dimension.comparison ==
          Comparison::at_most);
    CHECK(said_in<BoundaryHasDimension>(statement("boundary(G) >= 1")).dimension.comparison ==
          Comparison::at_least);
    CHECK(said_in<HasDimension>(statement("dimension(G) = 1")).system->drawing.angle.has_value());
}

TEST_CASE("what cannot be read is said with its place") {
    CHECK(said("dimension(H) = 1") == "3:16: expected a name that is defined above, found 'H'");
    CHECK(said("dimension G") == "3:16: expected '(' after 'dimension', found 'G'");
    CHECK(said("dimension(G) > 1") ==
          "3:19: expected '=', '!=', '<=' or '>=' and a number, found '>'");
    CHECK(said("dimension(G) =") == "3:20: expected 'log' or a number, found the end of the line");
    CHECK(said("dimension(G) = log 4") ==
          "3:26: expected '/' and a second logarithm, found the end of the line");
    CHECK(said("dimension(G) = log 4 / log 1") == "3:33: expected a number above 1, as log 1 is 0");
    CHECK(said("dimension(G) = log 0 / log 3") == "3:25: expected a number of at least 1");
    CHECK(said("dimension(G) = log (1+sqrt(5))/3 / log 3") ==
          "3:25: expected an algebraic integer, found (1+sqrt(5))/3");
    CHECK(said("dimension(G) = log 1+sqrt(2)+sqrt(3) / log 3") ==
          "3:34: expected roots of one number, found roots of 2 and 3");
    CHECK(
        said("dimension(G) = log 1.5 / log 3") ==
        "3:29: expected ', the square root of a root of' and a polynomial, as a decimal number is "
        "not exact, found '/'");
    CHECK(said("dimension(G) = log the largest real root of 2x^2 - 1 / log 3") ==
          "3:50: expected a polynomial that begins with a power of x, found 2x^2 - 1");
    CHECK(said("dimension(G) = log the largest real root of x^2 + 1 / log 3") ==
          "3:50: expected a polynomial with such a root of at least 1");
    CHECK(said("dimension(G) = log 8 / log 4 = 4/3") ==
          "3:37: expected the number before '=' again, found '4/3', which is not known to be it");
    CHECK(said("dimension(G) = log 10^(1/99) / log 3") ==
          "3:31: expected a root from 1 to 24, found 99");
    CHECK(claim_messages("let dimension = {a}") ==
          "2:5: expected another name, 'dimension' has a meaning in claims");
    CHECK(claim_messages("let A = {a}\nshow dimension(A) = 1") ==
          "3:16: expected a system, found 'A', a language");
}
