#pragma once
// Turtles that wander on whole coordinates, as the environments see them and as the oracle does.

#include <rapidcheck.h>

#include <vector>

#include "oracle/obstacles.hpp"
#include "turtle/turtle.hpp"

namespace algae {

struct RandomScene {
    struct Asked {
        std::size_t drawn;  // lines before it
        oracle::Place place;
    };
    Traversal course;
    std::vector<oracle::Line> lines;
    std::vector<Asked> asked;

    std::vector<const Query*> queries() const {
        std::vector<const Query*> out;
        for (const Query& query : course.queries) out.push_back(&query);
        return out;
    }
};

/// Lines, jumps back to earlier places and questions, in the plane or in space.
inline RandomScene random_scene() {
    const auto below = [](int bound) { return *rc::gen::inRange(0, bound); };
    const int dimension = 2 + below(2), most = *rc::gen::element(2, 5, 40);
    const auto vector = [](const oracle::Place& place) {
        return Vector{static_cast<double>(place[0]), static_cast<double>(place[1]),
                      static_cast<double>(place[2])};
    };
    RandomScene out;
    std::vector<oracle::Place> places{{}};
    oracle::Place here{};
    const std::size_t modules = static_cast<std::size_t>(below(60));
    for (std::size_t module = 0; module < modules; ++module) {
        const int kind = below(5);
        if (kind == 0) {
            here = places[static_cast<std::size_t>(below(static_cast<int>(places.size())))];
        } else if (kind == 1) {
            out.course.queries.push_back({"?E", module, {0}, vector(here), {}});
            out.asked.push_back({out.lines.size(), here});
        } else {
            oracle::Place next = here;
            for (int axis = 0; axis < dimension; ++axis)
                next[static_cast<std::size_t>(axis)] += below(2 * most + 1) - most;
            if (next == here) continue;
            out.lines.push_back({here, next});
            out.course.segments.push_back({vector(here), vector(next), module});
            places.push_back(here = next);
        }
    }
    return out;
}

}  // namespace algae
