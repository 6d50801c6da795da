#pragma once
// The procedures Lsystem and GRAFICO of the worksheet, written down line by line.

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "exact/exact.hpp"
#include "turtle/turtle.hpp"

namespace algae::slow_maple {

/// A module: a character and its parameters. Letters of strings have none.
struct Module {
    char letter;
    std::vector<double> parameters;
};
using Modules = std::vector<Module>;

inline std::string rewritten(const std::string& axiom, const std::vector<std::string>& rules,
                             unsigned n) {
    std::string word = axiom;
    for (unsigned step = 0; step < n; ++step) {
        std::string next;
        for (const char letter : word) {
            std::size_t found = 0;
            for (std::size_t i = 0; i + 1 < rules.size() && found == 0; i += 2)
                if (rules[i] == std::string(1, letter)) found = i + 1;
            next += found ? rules[found] : std::string(1, letter);
        }
        word = next;
    }
    return word;
}

inline Modules rewritten(
    Modules word, const std::map<char, std::function<Modules(std::vector<double>)>>& functions,
    unsigned n) {
    for (unsigned step = 0; step < n; ++step) {
        Modules next;
        for (const Module& module : word) {
            if (module.letter < 'A' || module.letter > 'Z') {
                next.push_back(module);
                continue;
            }
            for (const Module& part : functions.at(module.letter)(module.parameters))
                next.push_back(part);
        }
        word = next;
    }
    return word;
}

inline Modules modules_of(const std::string& word) {
    Modules modules;
    for (const char letter : word) modules.push_back({letter, {}});
    return modules;
}

struct Line {
    Vector from, to;
};

/// GRAFICO in space. In strings every turn is by `increment`, and @ is nothing.
inline std::vector<Line> drawn(const Modules& word, double increment, double heading = 0) {
    struct State {
        Vector at, h{1, 0, 0}, l{0, 1, 0}, u{0, 0, 1};
    } state;
    std::vector<State> memory;
    std::vector<Line> lines;
    const double pi = std::acos(-1.0);
    const auto mixed = [](Vector a, double c, Vector b, double s) {
        return Vector{a.x * c + b.x * s, a.y * c + b.y * s, a.z * c + b.z * s};
    };
    const auto turn = [&](char letter, double phi) {
        const double c = std::cos(phi), s = std::sin(phi);
        const State old = state;
        if (letter == '+') {
            state.h = mixed(old.h, c, old.l, s);
            state.l = mixed(old.h, -s, old.l, c);
        } else if (letter == '&') {
            state.h = mixed(old.h, c, old.u, -s);
            state.u = mixed(old.h, s, old.u, c);
        } else {
            state.l = mixed(old.l, c, old.u, -s);
            state.u = mixed(old.l, s, old.u, c);
        }
    };
    turn('+', heading * pi / 180);
    for (const Module& module : word) {
        const double first = module.parameters.empty() ? 0 : module.parameters[0];
        const double length = module.parameters.empty() ? 1 : first;
        const double phi = (module.parameters.empty() ? increment : first) * pi / 180;
        switch (module.letter) {
            case 'F':
            case 'f': {
                const Vector to = mixed(state.at, 1, state.h, length);
                if (module.letter == 'F') lines.push_back({state.at, to});
                state.at = to;
                break;
            }
            case '+':
                turn('+', phi);
                break;
            case '-':
                turn('+', -phi);
                break;
            case '&':
                turn('&', phi);
                break;
            case '^':
                turn('&', -phi);
                break;
            case '?':
                turn('?', phi);
                break;
            case '/':
                turn('?', -phi);
                break;
            case '|':
                turn('+', pi);
                break;
            case '@':
                if (increment == 0) {  // of modules
                    const double norm = std::hypot(state.h.x, state.h.y);
                    state.l = {-state.h.y / norm, state.h.x / norm, 0};
                    state.u = {state.h.y * state.l.z - state.h.z * state.l.y,
                               state.h.z * state.l.x - state.h.x * state.l.z,
                               state.h.x * state.l.y - state.h.y * state.l.x};
                }
                break;
            case '[':
                memory.push_back(state);
                break;
            case ']':
                state = memory.back();
                memory.pop_back();
                break;
            default:
                break;
        }
    }
    return lines;
}

}  // namespace algae::slow_maple
