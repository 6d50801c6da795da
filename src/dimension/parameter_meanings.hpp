#pragma once

#include <compare>
#include <cstddef>
#include <map>

#include "system/lsystem.hpp"

namespace algae {

/// What the parameters of a system's modules are to the way of its turtle. Backward from what the
/// turtle does: what conditions and turns depend on are numbers, what lengths of steps depend on are
/// lengths, and everything else (widths, colours, ages that nobody asks for) is of no account. What
/// is both is a number.
class ParameterMeanings {
public:
    enum class Meaning : unsigned char { none, length, number };

    /// Throws Error where the length of a step stands in a condition or turns something.
    explicit ParameterMeanings(const LSystem& system);

    /// Of a parameter of modules with this symbol and so many parameters.
    Meaning of(Symbol symbol, std::size_t arity, std::size_t place) const;

private:
    struct Slot {
        Symbol symbol;
        std::size_t arity, place;
        auto operator<=>(const Slot&) const = default;
    };
    void spread(const LSystem& system, Meaning meaning);
    std::map<Slot, Meaning> meanings_;
};

/// Whether a symbol makes the turtle step, and whether it draws then.
enum class Step : unsigned char { none, draw, move };
Step step_of(const Alphabet& alphabet, Symbol symbol);

}  // namespace algae
