#pragma once

#include <cmath>
#include <numbers>

#include "rewrite/program.hpp"

namespace algae {

/// The sine of an angle in degrees, exact where it is -1, -1/2, 0, 1/2 or 1.
inline double sine_of_degrees(double degrees) {
    double angle = std::fmod(degrees, 360.0);
    if (angle < 0) angle += 360;
    if (angle == 0 || angle == 180) return 0;
    if (angle == 30 || angle == 150) return 0.5;
    if (angle == 90) return 1;
    if (angle == 210 || angle == 330) return -0.5;
    if (angle == 270) return -1;
    return std::sin(angle * std::numbers::pi / 180);
}

inline double cosine_of_degrees(double degrees) {
    double angle = std::fmod(degrees, 360.0);
    if (angle < 0) angle += 360;
    if (angle == 90 || angle == 270) return 0;
    if (angle == 60 || angle == 300) return 0.5;
    if (angle == 0) return 1;
    if (angle == 120 || angle == 240) return -0.5;
    if (angle == 180) return -1;
    return std::cos(angle * std::numbers::pi / 180);
}

/// Not a number at odd multiples of 90 degrees.
inline double tangent_of_degrees(double degrees) {
    double angle = std::fmod(degrees, 180.0);
    if (angle < 0) angle += 180;
    if (angle == 90) return std::nan("");
    if (angle == 0) return 0;
    if (angle == 45) return 1;
    if (angle == 135) return -1;
    return std::tan(angle * std::numbers::pi / 180);
}

/// The value of an operation with one operand; not finite where there is none.
template <Program::Operation operation>
double unary(double x) {
    using enum Program::Operation;
    if constexpr (operation == negate) return -x;
    if constexpr (operation == invert) return x == 0 ? 1 : 0;
    if constexpr (operation == truth) return x != 0 ? 1 : 0;
    if constexpr (operation == abs) return std::abs(x);
    if constexpr (operation == floor) return std::floor(x);
    if constexpr (operation == ceil) return std::ceil(x);
    if constexpr (operation == sin) return sine_of_degrees(x);
    if constexpr (operation == cos) return cosine_of_degrees(x);
    if constexpr (operation == tan) return tangent_of_degrees(x);
    if constexpr (operation == asin) return std::asin(x) * 180 / std::numbers::pi;
    if constexpr (operation == acos) return std::acos(x) * 180 / std::numbers::pi;
    if constexpr (operation == atan) return std::atan(x) * 180 / std::numbers::pi;
    if constexpr (operation == sqrt) return std::sqrt(x);
    if constexpr (operation == exp) return std::exp(x);
    if constexpr (operation == log) return std::log(x);
}

/// The value of an operation with two operands; not finite where there is none.
template <Program::Operation operation>
double binary(double x, double y) {
    using enum Program::Operation;
    if constexpr (operation == add) return x + y;
    if constexpr (operation == subtract) return x - y;
    if constexpr (operation == multiply) return x * y;
    if constexpr (operation == divide) return x / y;
    if constexpr (operation == power) return std::pow(x, y);
    if constexpr (operation == minimum) return y < x ? y : x;
    if constexpr (operation == maximum) return x < y ? y : x;
    if constexpr (operation == less) return x < y ? 1 : 0;
    if constexpr (operation == less_equal) return x <= y ? 1 : 0;
    if constexpr (operation == greater) return x > y ? 1 : 0;
    if constexpr (operation == greater_equal) return x >= y ? 1 : 0;
    if constexpr (operation == equal) return x == y ? 1 : 0;
    if constexpr (operation == unequal) return x != y ? 1 : 0;
    if constexpr (operation == both) return x != 0 && y != 0 ? 1 : 0;
    if constexpr (operation == either) return x != 0 || y != 0 ? 1 : 0;
}

#define ALGAE_CASE(name, shape)    \
    case Program::Operation::name: \
        return visit.template shape<Program::Operation::name>();

/// visit.one<operation>() or visit.two<operation>(), for an operation on one or two numbers.
template <class Visit>
decltype(auto) dispatch(Program::Operation operation, Visit&& visit) {
    switch (operation) {
        ALGAE_CASE(negate, one)
        ALGAE_CASE(invert, one) ALGAE_CASE(truth, one) ALGAE_CASE(abs, one) ALGAE_CASE(floor, one)
            ALGAE_CASE(ceil, one) ALGAE_CASE(sin, one) ALGAE_CASE(cos, one) ALGAE_CASE(tan, one)
                ALGAE_CASE(asin, one) ALGAE_CASE(acos, one) ALGAE_CASE(atan, one)
                    ALGAE_CASE(sqrt, one) ALGAE_CASE(exp, one) ALGAE_CASE(log, one)
                        ALGAE_CASE(add, two) ALGAE_CASE(subtract, two) ALGAE_CASE(multiply, two)
                            ALGAE_CASE(divide, two) ALGAE_CASE(power, two) ALGAE_CASE(minimum, two)
                                ALGAE_CASE(maximum, two) ALGAE_CASE(less, two)
                                    ALGAE_CASE(less_equal, two) ALGAE_CASE(greater, two)
                                        ALGAE_CASE(greater_equal, two) ALGAE_CASE(equal, two)
                                            ALGAE_CASE(unequal, two) ALGAE_CASE(both, two) default
            : return visit.template two<Program::Operation::either>();
    }
}

#undef ALGAE_CASE

}  // namespace algae
