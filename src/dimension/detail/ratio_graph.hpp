#pragma once

// Parametric systems whose rules multiply lengths by constants.

#include "dimension/dimension.hpp"

namespace algae {

/// How lengths pass from modules to those that they become, in a deterministic parametric system
/// without contexts whose turtle walks in the plane.
///
/// A state is a symbol with the values of those parameters that conditions and turns depend on. Its
/// modules differ only in their length, one parameter that every rule multiplies by constants;
/// those without one have the length 1. So all modules of a state become similar figures, the
/// longer ones larger ones.
struct RatioGraph {
    struct Part {
        bool is_fence = false, opens = false;  // [ or ]; the rest is then without meaning
        std::size_t state = 0;
        Expression ratio = {};  // of its length to that of the whole, an expression of constants
    };
    struct State {
        std::string name;         // "F", "F(*,2)"
        std::vector<Part> parts;  // what becomes of it, in order; itself where no rule fits
        bool draws = false;       // a step with the pen down
        bool moves = false;       // any step
        Rational degrees;         // that it turns by itself, counter-clockwise
        bool matters = false;     // it steps, or leads to steps
    };
    std::vector<State> states;
    std::vector<Part> axiom;  // without ratios

    static constexpr std::size_t most_states = 500;
};

/// Throws Error with the reason where a system is not of this kind: contexts, choices, lengths that
/// are not multiplied by constants, parameters with ever new values, figures in space; BoundReached
/// for more than `RatioGraph::most_states` states.
///
/// Example: ratio_graph(read_lsystem("axiom F(1); F(x) -> F(x/3)+(60)F(x/3)-(120)F(x/3)+(60)F(x/3)", "")).states.size() == 3
RatioGraph ratio_graph(const Model& system, const Budget& budget = {});

/// By state, whether it leads in every later generation to some state for which this holds.
std::vector<bool> lasting(const RatioGraph& graph, const std::vector<bool>& holds);

/// The D0L system that draws the same figures with steps of the length 1, where every rule
/// multiplies lengths by the same number and turns stay as they are: only the size of figures
/// differs.
std::optional<Model> with_equal_lengths(const RatioGraph& graph);

/// The factor m by which the ways from the beginnings to the ends of figures of a ratio graph grow
/// in each generation: the spectral radius of the matrix that has, for each part outside branches,
/// its ratio turned by its heading.
class WayGrowth {
public:
    /// Throws Error where no turtle moves for ever, or where ways do not grow evenly (looked at in
    /// floating point), BoundReached where turns come back only after more than 1,000 generations
    /// or too many states move.
    explicit WayGrowth(const RatioGraph& graph, const Budget& budget = {});

    static constexpr std::size_t most_moving = 40;

    /// With a radius of at most 2^-bits. Throws Error where ways vanish.
    Ball enclosure(long bits) const;

private:
    struct Entry {
        std::size_t row, column;
        Expression ratio;
        Rational degrees;
    };
    void check_evenness() const;

    std::size_t size_ = 0;
    std::vector<std::vector<Entry>> levels_;  // until turns have come back twice
    std::size_t preperiod_ = 0, period_ = 1;
    std::vector<bool> moves_;  // by row: whether the state itself steps
    Budget budget_;
};

}  // namespace algae
