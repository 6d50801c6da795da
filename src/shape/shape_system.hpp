#pragma once

#include <memory>
#include <string>
#include <vector>

#include "shape/box.hpp"
#include "system/lsystem.hpp"
#include "system/view.hpp"

namespace algae {

/// A system of shape rules: boxes that are divided, all at once in each step. A symbol without a
/// rule stays. A box is a module with three parameters, its sizes along X, Y and Z.
struct ShapeSystem {
    /// A distance that some condition asks for (see NearestBoxes).
    struct Distance {
        std::string text;  // distance(X,wall)
        std::size_t axis;
        Symbol symbol;
    };
    std::shared_ptr<const LSystem> system;
    std::vector<ShapeBox> axiom;
    std::vector<std::vector<std::size_t>> rules;  // by symbol: indices into system->rules
    std::vector<Distance> distances;              // each once
};

/// The system as one of shape rules, if it is one: every rule is div, repeat or I, of a symbol with
/// three parameters or none and perhaps a condition; no contexts, probabilities below 1, tables or
/// terminals. Modules of the axiom are boxes: with three arguments, their sizes; with six, their
/// origin and sizes; with none, the unit cube. O(size of the system). Throws `Diagnostics` for
/// arguments without a value, Error for boxes with sizes that are not above 0.
View<ShapeSystem> as_shape(const LSystem& system);

/// The quantity as a rational number: one that is not rational is rounded to the shortest decimal
/// that reads back as the same double.
Rational rational(const Quantity& quantity);

}  // namespace algae
