#include "turtle/compass.hpp"

#include <cmath>
#include <numbers>

namespace algae {

namespace {

constexpr std::int64_t largest_exact_denominator = 360;
constexpr std::int64_t largest_table = 360'000;
constexpr std::int64_t rounded_order = std::int64_t{1} << 60;

/// The part of a full turn, from 0 on and below 1.
Rational part_of_turn(const Rational& degrees) {
    const Rational turns = degrees / Rational(360);
    return turns - Rational(floor(turns));
}

/// Degrees as a number of units of 2^-60 turn.
std::int64_t rounded_units(double degrees) {
    const double turns = degrees / 360.0;
    return static_cast<std::int64_t>(std::llround((turns - std::floor(turns)) * static_cast<double>(rounded_order)));
}

}  // namespace

Compass::Compass(const Settings& settings, std::uint64_t n) {
    const Quantity angle = settings.angle.value_or(quantity(Rational(90)));
    const Quantity start = settings.start ? settings.start->heading : quantity(Rational(0));
    const Quantity spin = settings.spin.value_or(quantity(Rational(0)));
    const double start_degrees = start.value + spin.value * static_cast<double>(n);
    if (angle.exact && start.exact && spin.exact) {
        const Rational turn = part_of_turn(*angle.exact);
        const Rational first = part_of_turn(*start.exact + *spin.exact * Rational(Integer(n)));
        Rational mirrored = turn;
        if (settings.clockwise && !turn.is_zero()) mirrored = Rational(1) - turn;
        const Integer common = lcm(Integer(4), lcm(turn.denominator(), first.denominator()));
        exact_ = turn.denominator() <= largest_exact_denominator &&
                 first.denominator() <= largest_exact_denominator && common <= 3600;
        if (exact_ || common <= largest_table) {
            order_ = common.to_int64();
            turn_ = (mirrored * Rational(common)).numerator().to_int64();
            start_ = (first * Rational(common)).numerator().to_int64();
            table_.reserve(static_cast<std::size_t>(order_));
            for (Heading h = 0; h < order_; ++h) table_.push_back(computed(h));
            return;
        }
    }
    exact_ = false;
    order_ = rounded_order;
    turn_ = normal(settings.clockwise ? -rounded_units(angle.value) : rounded_units(angle.value));
    start_ = normal(rounded_units(start_degrees));
}

/// Folded into one eighth of a turn first, so that directions along the axes and diagonals come out
/// exactly as they should and opposite ones are exactly opposite.
std::complex<double> Compass::computed(Heading heading) const {
    const Heading quarter = order_ / 4;
    const Heading within = heading % quarter;
    const bool flipped = 2 * within > quarter;
    const double part = static_cast<double>(flipped ? quarter - within : within) / static_cast<double>(order_);
    double x = std::cos(2 * std::numbers::pi * part), y = std::sin(2 * std::numbers::pi * part);
    const Heading folded = flipped ? quarter - within : within;
    if (12 * folded == order_) y = 0.5;  // 30 degrees
    if (8 * folded == order_) y = x;     // 45 degrees
    if (flipped) std::swap(x, y);
    switch (heading / quarter) {
        case 0: return {x, y};
        case 1: return {-y, x};
        case 2: return {-x, -y};
        default: return {y, -x};
    }
}

}  // namespace algae
