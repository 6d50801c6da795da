#pragma once

#include <cmath>
#include <complex>
#include <cstddef>
#include <vector>

#include "dimension/recurrent_set.hpp"

namespace algae {

/// A complex number whose products are four multiplications: no care is taken of infinite ones.
struct Number {
    double x = 0, y = 0;

    Number() = default;
    Number(double real, double imaginary) : x(real), y(imaginary) {}
    Number(std::complex<double> number) : x(number.real()), y(number.imag()) {}
    friend Number operator+(Number a, Number b) { return {a.x + b.x, a.y + b.y}; }
    friend Number operator*(Number a, Number b) {
        return {a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x};
    }
    double real() const { return x; }
    double imag() const { return y; }
};

inline Number polar(double size, double angle) { return std::polar(size, angle); }

/// The parts of a set as numbers, ready to be walked down.
struct Descent {
    struct Part {
        std::size_t piece;
        std::size_t heading;
        Number offset;  // in units of the whole
    };
    std::vector<std::vector<Part>> parts;
    struct Disc {
        Number centre;
        double radius;
    };
    std::vector<Disc> discs;
    std::vector<Number> points;  // one of each piece
    std::vector<Part> axiom;
    std::vector<Number> turns;
    Number shrink;   // 1/mu
    double smaller;  // its size

    explicit Descent(const RecurrentSet& set);
};

/// A piece somewhere: it covers start + unit * K_piece, where |unit| = size.
struct Placed {
    std::size_t piece;
    Number start, unit;
    double size;
};

/// A box around a set.
struct Extent {
    double left = INFINITY, right = -INFINITY, low = INFINITY, high = -INFINITY;
};

/// A box around the set turned by an angle, from the discs of parts so many levels below.
Extent extent_of(const Descent& descent, double turn, int levels);

}  // namespace algae
