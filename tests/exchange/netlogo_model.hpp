#pragma once
// The NetLogo model itself, slowly: rules as a list, the chain rewritten letter by letter, a stack of
// turtles whose headings are 0 in the north and grow clockwise.

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace algae::exchange_tests {

struct NetlogoModel {
    struct Rule {
        char letter;
        std::string successor, command;
    };
    struct Line {
        long double x0, y0, x1, y1;
    };
    struct Turtle {
        long double x, y, heading, step;
    };
    std::vector<Rule> rules;
    std::string chain;
    long double d = 1, delta = 90, x0 = 0, y0 = 0, delta_0 = 0, k_shorten = 1, d_delta = 0, k = 1;
    bool has_k = false;
    std::vector<Line> lines = {};
    std::vector<Turtle> stamps = {};

    const Rule* rule(char letter) const {
        for (const Rule& rule : rules)
            if (rule.letter == letter) return &rule;
        return nullptr;
    }
    void restart() {
        std::string next;
        for (const char letter : chain)
            next += rule(letter) ? rule(letter)->successor : std::string(1, letter);
        chain = next;
        d *= k_shorten;
        delta_0 += d_delta;
    }
    void draw() {
        lines.clear();
        stamps.clear();
        std::vector<Turtle> turtles{{x0, y0, delta_0, d}};
        for (const char letter : chain) {
            const std::string command =
                rule(letter) ? rule(letter)->command : std::string(1, letter);
            Turtle& turtle = turtles.back();
            if (command == "F" || command == "f") {
                const Turtle before = turtle;
                const long double radians = turtle.heading * std::numbers::pi_v<long double> / 180;
                turtle.x += turtle.step * std::sin(radians);
                turtle.y += turtle.step * std::cos(radians);
                if (command == "F") lines.push_back({before.x, before.y, turtle.x, turtle.y});
            }
            if (command == "+") turtle.heading -= delta;
            if (command == "-") turtle.heading += delta;
            if (command == "[") turtles.push_back(Turtle(turtle));
            if (command == "]") turtles.pop_back();
            if (command == "*" && has_k) turtle.step *= k;
            if (command == "S") stamps.push_back(turtle);
        }
    }
};

}  // namespace algae::exchange_tests
