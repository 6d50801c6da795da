#include "turtle/pieces.hpp"

#include <algorithm>

namespace algae {

namespace {

using Value = Pieces::value_type;

/// Grows the disc of `left` to hold another one.
void enclose(Value& left, std::complex<double> centre, double radius) {
    if (radius < 0) return;
    if (left.radius < 0) {
        left.centre = centre;
        left.radius = radius;
        return;
    }
    const std::complex<double> way = centre - left.centre;
    const double distance = std::abs(way);
    if (distance + radius <= left.radius) return;
    if (distance + left.radius <= radius) {
        left.centre = centre;
        left.radius = radius;
        return;
    }
    const double grown = (distance + left.radius + radius) / 2;
    left.centre += way * ((grown - left.radius) / distance);
    left.radius = grown;
}

}  // namespace

void Pieces::append(Value& left, const Value& right) const {
    const std::complex<double> look = left.size * compass_->direction(left.turn);
    enclose(left, left.move + look * right.centre, right.radius < 0 ? right.radius : left.size * right.radius);
    left.move += look * right.move;
    left.turn = compass_->sum(left.turn, right.turn);
    left.size *= right.size;
    left.width *= right.width;
    left.colours += right.colours;
    left.letters += right.letters;
}

Value Pieces::branch(const Value& twig) const {
    Value value;
    value.centre = twig.centre;
    value.radius = twig.radius;
    value.letters = twig.letters + 2;
    return value;
}

}  // namespace algae
