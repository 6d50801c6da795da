#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <optional>
#include <utility>

namespace algae {

/// A point of space or a way in it: x and y are those of the plane, z upward out of it.
struct Vector {
    double x = 0, y = 0, z = 0;

    bool operator==(const Vector&) const = default;
    friend Vector operator+(const Vector& a, const Vector& b) {
        return {a.x + b.x, a.y + b.y, a.z + b.z};
    }
    friend Vector operator-(const Vector& a, const Vector& b) {
        return {a.x - b.x, a.y - b.y, a.z - b.z};
    }
    friend Vector operator*(double factor, const Vector& a) {
        return {factor * a.x, factor * a.y, factor * a.z};
    }
};

/// The inner product.
///
/// Example: dot(Vector{1, 2, 3}, Vector{4, 5, 6}) == 32
inline double dot(const Vector& a, const Vector& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

/// The vector product.
///
/// Example: cross(Vector{1, 0, 0}, Vector{0, 1, 0}) == Vector{0, 0, 1}
inline Vector cross(const Vector& a, const Vector& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

inline double length(const Vector& a) { return std::sqrt(dot(a, a)); }

/// What a turn by some angle needs.
struct Turn {
    double cosine = 1, sine = 0;
};

/// The turn by so many degrees. Multiples of 90 degrees are exact, of 30 and 45 as exact as doubles
/// allow, and opposite turns are exactly opposite. The angle must be finite.
///
/// Example: turn_by(-270).sine == 1
inline Turn turn_by(double degrees) {
    double rest = std::fmod(degrees, 360.0);  // exact
    const bool mirrored = rest < 0;
    rest = std::fabs(rest);
    const int quarters = static_cast<int>(rest / 90);
    rest -= 90.0 * quarters;
    const bool flipped = rest > 45;
    const double part = (flipped ? 90 - rest : rest) * (std::numbers::pi / 180);
    double cosine = std::cos(part), sine = std::sin(part);
    if (rest == 30 || rest == 60) sine = 0.5;
    if (rest == 45) sine = cosine;
    if (flipped) std::swap(cosine, sine);
    switch (quarters) {
        case 1:
            cosine = -std::exchange(sine, cosine);
            break;
        case 2:
            cosine = -cosine, sine = -sine;
            break;
        case 3:
            sine = -std::exchange(cosine, sine);
            break;
        default:
            break;
    }
    return {cosine, mirrored ? -sine : sine};
}

/// Turns by degrees, those that were asked for lately without working them out again.
class Turns {
public:
    const Turn& by(double degrees) {
        const auto bits = std::bit_cast<std::uint64_t>(degrees);
        Known& known = known_[bits * 0x9E3779B97F4A7C15u >> 58];
        if (known.degrees != degrees) known = {degrees, turn_by(degrees)};
        return known.turn;
    }

private:
    struct Known {
        double degrees = 0;
        Turn turn;
    };
    std::array<Known, 64> known_;
};

/// The way a turtle looks in space: heading, left and up, unit vectors with heading x left = up.
///
/// Turns are those of Abelson and diSessa (1982) as Prusinkiewicz and Lindenmayer (1990, 1.5) write
/// them, [H' L' U'] = [H L U] R, with the signs by which the commands do what they are called: a
/// positive `yaw` goes to the left, `pitch` down, `roll` to the left. Turns by multiples of 90
/// degrees are exact; the rounding of others is taken out every few turns, so that the vectors
/// stay orthonormal to 1e-14 however many there are.
class Attitude {
public:
    const Vector& heading() const { return heading_; }
    const Vector& left() const { return left_; }
    const Vector& up() const { return up_; }

    /// About up: + is a positive turn, the heading goes towards left.
    void yaw(const Turn& turn) { rotate(heading_, left_, turn); }
    /// About left: & is a positive turn, the heading goes away from up.
    void pitch(const Turn& turn) { rotate(heading_, up_, {turn.cosine, -turn.sine}); }
    /// About the heading: \ is a positive turn, left goes away from up.
    void roll(const Turn& turn) { rotate(left_, up_, {turn.cosine, -turn.sine}); }
    /// About up by 180 degrees.
    void turn_back() {
        heading_ = -1.0 * heading_;
        left_ = -1.0 * left_;
    }
    /// Turns by an angle in radians about the axis heading x `to`, so that the heading goes towards `to`;
    /// nothing if they are parallel.
    void bend(const Vector& to, double radians) {
        const Vector across = cross(heading_, to);
        const double size = length(across);
        if (!(size > 0)) return;
        const Vector axis = (1 / size) * across;
        const double cosine = std::cos(radians), sine = std::sin(radians);
        for (Vector* const vector : {&heading_, &left_, &up_})
            *vector = cosine * *vector + sine * cross(axis, *vector) +
                      (1 - cosine) * dot(axis, *vector) * axis;
        if (++turns_ % 16 == 0) straighten();
    }
    /// Rolls until left is level and up does not look down: L' = V x H / |V x H| with V = (0,0,1).
    /// False, and nothing done, if the heading is vertical, so that every left is level.
    bool level() {
        const double size = std::hypot(heading_.x, heading_.y);
        if (!(size > 1e-9)) return false;
        left_ = {-heading_.y / size, heading_.x / size, 0};
        up_ = cross(heading_, left_);
        return true;
    }

private:
    /// Turns two of the vectors in their plane, `first` towards `second`.
    void rotate(Vector& first, Vector& second, const Turn& turn) {
        const Vector before = first;
        first = turn.cosine * first + turn.sine * second;
        second = turn.cosine * second - turn.sine * before;
        if (++turns_ % 16 == 0) straighten();
    }
    /// Makes the vectors orthonormal again (Gram and Schmidt); exactly orthonormal ones stay.
    void straighten() {
        heading_ = (1 / length(heading_)) * heading_;
        left_ = left_ - dot(heading_, left_) * heading_;
        left_ = (1 / length(left_)) * left_;
        up_ = cross(heading_, left_);
    }

    Vector heading_{1, 0, 0}, left_{0, 1, 0}, up_{0, 0, 1};
    std::uint32_t turns_ = 0;
};

}  // namespace algae
