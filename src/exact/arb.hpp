#pragma once
// For the .cpp files of this room only: what a Ball is made of.

#include "exact/ball.hpp"
#include "exact/flint.hpp"

namespace algae {

struct Ball::Enclosure {
    arb_t value;

    Enclosure() { arb_init(value); }
    Enclosure(const Enclosure& other) {
        arb_init(value);
        arb_set(value, other.value);
    }
    Enclosure& operator=(const Enclosure&) = delete;
    ~Enclosure() { arb_clear(value); }
};

/// Access for this room: an enclosure to be written, and one to be read.
struct BallHandle {
    static arb_struct* of(Ball& value);
    static const arb_struct* of(const Ball& value);
};

inline arb_struct* arb(Ball& value) { return BallHandle::of(value); }
inline const arb_struct* arb(const Ball& value) { return BallHandle::of(value); }

/// A Ball for a result of this precision, 0 at first.
inline Ball ball(long bits) { return Ball(0, bits); }

}  // namespace algae
