#include "turtle/turtle.hpp"

#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "model/model.hpp"

// The exact lattice of a turtle in the plane: directions, motions and coordinates.
//
// A turtle that turns by a rational part p/q of a full turn and walks in unit steps stands on numbers
// of Z[zeta_m], where m is a common multiple of 4 and of the denominators of angle, start and spin. A
// heading is an exponent of zeta_m, so turning is addition modulo m (Compass), and a place is an
// integer combination of powers of zeta_m, which CyclotomicRing adds without rounding.
//
// LatticeMotions makes what a word does to the turtle the value of a monoid, so that a fold over the
// derivation tells the end, the number of segments and the box of generation n without its word. The
// box needs the support function of the drawing: in every of the m directions, how far the drawing
// reaches. It determines the convex hull, unions by maximum, moves by rotation and addition, and its
// values stay in the ring: twice the real part of zeta^-k p is p rotated plus its conjugate. All
// comparisons are therefore of real numbers of the ring, and exact.
//
// Where the denominators are too large for a ring (above 360, or m above 3600) directions are doubles
// from a table, and beyond a table of 360,000 entries angles are rounded to 2^-60 of a turn. Even then
// opposite directions are exactly opposite, and those along axes and diagonals come out as they should.

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
    return static_cast<std::int64_t>(
        std::llround((turns - std::floor(turns)) * static_cast<double>(rounded_order)));
}

}  // namespace

Compass::Compass(const Drawing& drawing, std::uint64_t n) {
    const Quantity angle = drawing.angle.value_or(quantity(Rational(90)));
    const Quantity start = drawing.start ? drawing.start->heading : quantity(Rational(0));
    const Quantity spin = drawing.spin.value_or(quantity(Rational(0)));
    const double start_degrees = start.value + spin.value * static_cast<double>(n);
    if (angle.exact && start.exact && spin.exact) {
        const Rational turn = part_of_turn(*angle.exact);
        const Rational first = part_of_turn(*start.exact + *spin.exact * Rational(Integer(n)));
        Rational mirrored = turn;
        if (drawing.clockwise && !turn.is_zero()) mirrored = Rational(1) - turn;
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
    turn_ = normal(drawing.clockwise ? -rounded_units(angle.value) : rounded_units(angle.value));
    start_ = normal(rounded_units(start_degrees));
}

/// Folded into one eighth of a turn first, so that directions along the axes and diagonals come out
/// exactly as they should and opposite ones are exactly opposite.
std::complex<double> Compass::computed(Heading heading) const {
    const Heading quarter = order_ / 4;
    const Heading within = heading % quarter;
    const bool flipped = 2 * within > quarter;
    const double part =
        static_cast<double>(flipped ? quarter - within : within) / static_cast<double>(order_);
    double x = std::cos(2 * std::numbers::pi * part), y = std::sin(2 * std::numbers::pi * part);
    const Heading folded = flipped ? quarter - within : within;
    if (12 * folded == order_) y = 0.5;  // 30 degrees
    if (8 * folded == order_) y = x;     // 45 degrees
    if (flipped) std::swap(x, y);
    switch (heading / quarter) {
        case 0:
            return {x, y};
        case 1:
            return {-y, x};
        case 2:
            return {-x, -y};
        default:
            return {y, -x};
    }
}

LatticeMotions::LatticeMotions(std::int64_t order, bool reaching)
    : ring_(static_cast<long>(order)), reaching_(reaching) {}

CyclotomicInteger LatticeMotions::reach_of(const CyclotomicInteger& point,
                                           std::int64_t direction) const {
    CyclotomicInteger along = ring_.rotate(point, static_cast<long>(-direction));
    ring_.add(along, ring_.conjugate(along));
    return along;
}

//> append
void LatticeMotions::append(value_type& left, const value_type& right) const {
    const long m = ring_.order();
    if (!right.reach.empty()) {
        const bool first = left.reach.empty();
        if (first) left.reach.resize(static_cast<std::size_t>(m));
        for (long k = 0; k < m; ++k) {
            CyclotomicInteger candidate = reach_of(left.move, k);
            const long local = static_cast<long>((k - left.turn + m) % m);
            ring_.add(candidate, right.reach[static_cast<std::size_t>(local)]);
            CyclotomicInteger& known = left.reach[static_cast<std::size_t>(k)];
            if (first || ring_.compare_real(known, candidate) < 0) known = std::move(candidate);
        }
    }
    ring_.add_rotated(left.move, right.move, static_cast<long>(left.turn));
    left.turn = (left.turn + right.turn) % m;
    left.segments += right.segments;
}
//< append

LatticeMotions::value_type LatticeMotions::step(bool drawn) const {
    value_type value{ring_.one(), 0, drawn ? 1 : 0, {}};
    if (!drawn || !reaching_) return value;
    for (long k = 0; k < ring_.order(); ++k) {
        CyclotomicInteger ahead = reach_of(value.move, k);  // the end; the start reaches 0
        if (ring_.real_part_sign(ahead) < 0) ahead = ring_.zero();
        value.reach.push_back(std::move(ahead));
    }
    return value;
}

LatticeMotions::value_type LatticeMotions::turned(std::int64_t units) const {
    value_type value = one();
    const long m = ring_.order();
    value.turn = ((units % m) + m) % m;
    return value;
}

Compass::Heading Compass::turn_of(Command command) const {
    switch (command) {
        case Command::left:
            return turn_;
        case Command::right:
            return -turn_;
        case Command::back:
            return half();
        default:
            return 0;
    }
}

LatticeMotions::value_type LatticeMotions::of(Command command, const Compass& compass,
                                              std::int64_t unit) const {
    switch (command) {
        case Command::draw:
        case Command::draw_unmarked:
            return step(true);
        case Command::move:
            return step(false);
        default:
            return turned(compass.turn_of(command) / unit);
    }
}

Coordinate::Coordinate(const CyclotomicRing& ring, CyclotomicInteger number, Part part,
                       Rational factor, Rational offset)
    : exact_(Exact{ring, std::move(number), part, std::move(factor), std::move(offset)}) {
    if (const auto known = rational()) {
        value_ = known->to_double();
    } else {
        const auto point = ring.to_complex(exact_->number);
        value_ = (part == Part::real ? point.real() : point.imag()) * exact_->factor.to_double() +
                 exact_->offset.to_double();
    }
}

std::optional<Rational> Coordinate::rational() const {
    if (!exact_) return std::nullopt;
    const auto part = exact_->part == Part::real ? exact_->ring.real_rational(exact_->number)
                                                 : exact_->ring.imaginary_rational(exact_->number);
    if (!part) return std::nullopt;
    return *part * exact_->factor + exact_->offset;
}

std::string Coordinate::decimal(int digits) const {
    if (!exact_) {
        const std::string text = fmt::format("{:.{}f}", value_, digits);
        return text.find_first_of("123456789") == std::string::npos && text.starts_with('-')
                   ? text.substr(1)
                   : text;
    }
    if (const auto known = rational()) return algae::decimal(*known, digits);
    return algae::decimal(
        [&](long bits) {
            const Ball part = exact_->part == Part::real
                                  ? exact_->ring.real_part(exact_->number, bits)
                                  : exact_->ring.imaginary_part(exact_->number, bits);
            return part * Ball(exact_->factor, bits) + Ball(exact_->offset, bits);
        },
        digits);
}

std::string Coordinate::text(int digits) const {
    std::string text = decimal(digits);
    if (text.find('.') == std::string::npos) return text;
    text.erase(text.find_last_not_of('0') + 1);
    if (text.ends_with('.')) text.pop_back();
    return text;
}

}  // namespace algae
