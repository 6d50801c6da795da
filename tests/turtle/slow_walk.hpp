#pragma once
// A slow second route to scenes: every frame a matrix of long doubles made by multiplication, branches by recursion.

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

namespace algae::slow_walk {

using Real = long double;
using Place = std::array<Real, 3>;
using Matrix = std::array<Place, 3>;  // by row; heading, left and up are the columns

struct Module {
    char symbol = 0;
    std::vector<double> values;
};

inline std::string text(const std::vector<Module>& word) {
    std::string out;
    for (const Module& module : word) {
        out += module.symbol;
        for (std::size_t i = 0; i < module.values.size(); ++i) {
            char number[40];
            std::snprintf(number, sizeof number, "%.17g", module.values[i]);
            out += (i == 0 ? "(" : ",") + std::string(number);
        }
        if (!module.values.empty()) out += ')';
    }
    return out;
}

inline Matrix product(const Matrix& a, const Matrix& b) {
    Matrix out{};
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j)
            for (std::size_t k = 0; k < 3; ++k) out[i][j] += a[i][k] * b[k][j];
    return out;
}

/// Counter-clockwise about an axis of unit length, by the quaternion of half the angle.
inline Matrix rotation(const Place& axis, Real radians) {
    const Real w = std::cos(radians / 2), s = std::sin(radians / 2);
    const Real x = s * axis[0], y = s * axis[1], z = s * axis[2];
    return {{{1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)},
             {2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)},
             {2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)}}};
}

inline Real radians(Real degrees) { return degrees * std::numbers::pi_v<Real> / 180; }

struct Stroke {
    Place from{}, to{};
    Real diameter = -1;  // below 0: a line
    std::optional<std::size_t> before;
    std::size_t depth = 0;  // open brackets
};

struct Solid {
    char symbol = 0;
    Place middle{};
    Matrix frame{};
    std::vector<double> values;
};

/// What is known of a turtle that bends to `tropism`, a solid B, a rotation R, a translation T.
struct Walk {
    Place tropism{};
    Real susceptibility = 1;
    bool before = false;  // it bends before steps and moves, by one radian at most
    std::vector<Stroke> strokes;
    std::vector<Solid> solids;
    Place end{};

    struct State {
        Matrix frame{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
        Place here{};
        Real diameter = -1, susceptibility = 1;
        std::optional<std::size_t> last;
    };

    void all(const std::vector<Module>& word) {
        std::size_t next = 0;
        State first;
        first.susceptibility = susceptibility;
        branch(word, next, first, 0);
    }

private:
    static Place column(const Matrix& matrix, std::size_t j) {
        return {matrix[0][j], matrix[1][j], matrix[2][j]};
    }
    static void turn(State& state, const Place& own_axis, Real degrees) {
        state.frame = product(state.frame, rotation(own_axis, radians(degrees)));
    }
    void bend(State& state) const {
        const Place h = column(state.frame, 0);
        const Place axis{h[1] * tropism[2] - h[2] * tropism[1],
                         h[2] * tropism[0] - h[0] * tropism[2],
                         h[0] * tropism[1] - h[1] * tropism[0]};
        const Real size = std::sqrt(axis[0] * axis[0] + axis[1] * axis[1] + axis[2] * axis[2]);
        if (size == 0) return;
        const Place unit{axis[0] / size, axis[1] / size, axis[2] / size};
        Real angle = state.susceptibility * size;
        if (before && angle > 1) angle = 1;
        if (before && angle < -1) angle = -1;
        state.frame = product(rotation(unit, angle), state.frame);
    }

    void branch(const std::vector<Module>& word, std::size_t& next, State state,
                std::size_t depth) {
        while (next < word.size()) {
            const Module& module = word[next++];
            const auto value = [&](std::size_t i) -> Real { return module.values[i]; };
            switch (module.symbol) {
                case '[':
                    branch(word, next, state, depth + 1);
                    break;
                case ']':
                    return;
                case '+':
                    turn(state, {0, 0, 1}, value(0));
                    break;
                case '-':
                    turn(state, {0, 0, 1}, -value(0));
                    break;
                case '&':
                    turn(state, {0, 1, 0}, value(0));
                    break;
                case '^':
                    turn(state, {0, 1, 0}, -value(0));
                    break;
                case '\\':
                    turn(state, {1, 0, 0}, -value(0));
                    break;
                case '/':
                    turn(state, {1, 0, 0}, value(0));
                    break;
                case 'R':
                    turn(state, {1, 0, 0}, value(0));
                    turn(state, {0, 1, 0}, value(1));
                    turn(state, {0, 0, 1}, value(2));
                    break;
                case 'T':
                    for (std::size_t i = 0; i < 3; ++i)
                        for (std::size_t j = 0; j < 3; ++j)
                            state.here[i] += state.frame[i][j] * value(j);
                    state.last.reset();
                    break;
                case 'E':
                    state.susceptibility = module.values.size() == 1
                                               ? value(0)
                                               : value(0) * state.susceptibility + value(1);
                    break;
                case '!':
                    state.diameter = value(0);
                    break;
                case 'f':
                case 'F': {
                    if (before) bend(state);
                    Stroke stroke;
                    stroke.from = state.here;
                    for (std::size_t i = 0; i < 3; ++i)
                        state.here[i] += value(0) * state.frame[i][0];
                    stroke.to = state.here;
                    stroke.diameter = state.diameter;
                    stroke.before = state.last;
                    stroke.depth = depth;
                    state.last.reset();
                    if (module.symbol == 'f') break;
                    state.last = strokes.size();
                    strokes.push_back(stroke);
                    if (!before) bend(state);
                    break;
                }
                default:
                    solids.push_back({module.symbol, state.here, state.frame, module.values});
            }
        }
        end = state.here;
    }
};

/// Whether a stroke begins a branch: another one of those that begin at the same end goes on.
inline bool is_branch(const std::vector<Stroke>& strokes, std::size_t stroke) {
    if (!strokes[stroke].before) return false;
    for (std::size_t other = 0; other < strokes.size(); ++other) {
        if (other == stroke || strokes[other].before != strokes[stroke].before) continue;
        if (strokes[other].depth < strokes[stroke].depth) return true;
        if (strokes[other].depth == strokes[stroke].depth && other < stroke) return true;
    }
    return false;
}

}  // namespace algae::slow_walk
