#pragma once

// Parametric systems whose rules multiply lengths by constants.

#include "dimension/dimension.hpp"

namespace algae {

/// How far something turns, counter-clockwise: by degrees, and so many times by the system's angle
/// where that is no rational number of degrees. The degrees are from 0 (included) to 360.
struct Rotation {
    Rational degrees = 0;
    std::int64_t angles = 0;

    bool is_zero() const { return degrees.is_zero() && angles == 0; }
    bool operator==(const Rotation&) const = default;
    friend bool operator<(const Rotation& left, const Rotation& right) {
        return left.angles != right.angles ? left.angles < right.angles
                                           : left.degrees < right.degrees;
    }
};

/// The turns one after the other.
///
/// Example: (Rotation{350} + Rotation{20}).degrees == Rational(10)
Rotation operator+(const Rotation& left, const Rotation& right);
Rotation operator-(const Rotation& turn);

/// e^(i turn), where the angle in degrees is as given.
ComplexBall direction(const Rotation& turn, const Expression& angle, long bits);

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
        Rotation turn;            // that it turns by itself
        bool matters = false;     // it steps, or leads to steps
    };
    std::vector<State> states;
    std::vector<Part> axiom;                               // without ratios
    Expression angle = quantity(Rational(90)).expression;  // the system's, in degrees

    static constexpr std::size_t most_states = 500;
};

/// Throws Error with the reason where a system is not of this kind: contexts, choices, lengths that
/// are not multiplied by constants, parameters with ever new values, figures in space; BoundReached
/// for more than `RatioGraph::most_states` states.
///
/// Example: ratio_graph(read_lsystem("axiom F(1); F(x) -> F(x/3)+(60)F(x/3)-(120)F(x/3)+(60)F(x/3)", "")).states.size() == 3
RatioGraph ratio_graph(const Model& system, const Budget& budget = {});

/// By state, whether it leads in every later generation to some state for which this holds.
std::vector<bool> drawing_in_all(const RatioGraph& graph, const std::vector<bool>& draws);

/// Whether all parts of the axiom that matter are of one length, as far as their formulas say.
bool has_one_length(const RatioGraph& graph);

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
        Rotation turn;
    };
    void check_evenness() const;

    std::size_t size_ = 0;
    std::vector<std::vector<Entry>> levels_;  // until turns have come back twice
    std::size_t preperiod_ = 0, period_ = 1;
    std::vector<bool> moves_;  // by row: whether the state itself steps
    Expression angle_;
    Budget budget_;
};

/// The parts of each state's figure outside branches.
std::vector<const RatioGraph::Part*> stem(const RatioGraph::State& state);

/// By state, whether it steps outside branches in every later generation, or leads to one that
/// does.
std::vector<bool> moving_for_ever(const RatioGraph& graph);

/// Whether the parts within a strongly connected component of states lie so that all of them count.
struct PartsApart {
    enum class Answer { apart, coincide, unknown };
    Answer answer = Answer::unknown;
    std::size_t ways = 0;  // in which parts meet
    std::string reason;    // why it is not known
};

/// By neighbour maps (`neighbour_maps.cpp`), of which at most `most` are looked at. `drawing`: by
/// state, whether it draws for ever.
PartsApart parts_apart(const RatioGraph& graph, const std::vector<std::size_t>& component,
                       const std::vector<bool>& drawing, const Budget& budget,
                       std::size_t most = 3'000);

// What rates and ratios are compared by.

/// The matrix of multiplication by a root of a monic polynomial.
///
/// Example: companion(Polynomial({-1, -1, 1})) == IntegerMatrix({{0, 1}, {1, 1}})
IntegerMatrix companion(const Polynomial& polynomial);

/// By the characteristic polynomial of a power of the companion matrix. Throws BoundReached where
/// degree and exponent multiply to more than 400.
///
/// Example: power(*AlgebraicInteger::largest_root(Polynomial({-2, 0, 1})), 2).integer() == Integer(2)
AlgebraicInteger power(const AlgebraicInteger& base, unsigned exponent);

/// log left / log right, if powers of both with exponents of at most 24 are equal and right is not
/// 1; powers that `power` refuses are not compared.
///
/// Example: exponent_between(AlgebraicInteger(8), AlgebraicInteger(4)) == Rational(3, 2)
std::optional<Rational> exponent_between(const AlgebraicInteger& left,
                                         const AlgebraicInteger& right);

}  // namespace algae
