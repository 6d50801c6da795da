#pragma once
// environment: what communication modules are told by the world around the turtle; open L-systems.

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "base/budget.hpp"
#include "turtle/pose.hpp"

namespace algae {

/// A straight line that a turtle draws, and the module of the word that it belongs to.
struct Segment {
    Vector from, to;
    std::size_t module = 0;  // its position in the word

    bool operator==(const Segment&) const = default;
};

/// What a communication module asks: where the turtle is when it comes to it, and with which
/// parameters.
struct Query {
    std::string name;                // of the module: "?E"
    std::size_t module = 0;          // its position in the word
    std::vector<double> parameters;  // before they are filled
    Vector position;
    Attitude attitude;
};

/// The way of a turtle over a word: what it draws and what it is asked on the way.
struct Traversal {
    std::uint64_t generation = 0;
    std::vector<Segment> segments;  // in the order of the word
    std::vector<Query> queries;     // likewise

    /// Whether some segment leaves the plane z = 0. What is up is z then, and y otherwise.
    bool is_in_space() const;
};

/// What fills the parameters of communication modules (Mech and Prusinkiewicz 1996).
class Environment {
public:
    virtual ~Environment() = default;

    /// For each of these queries of the course the new parameters, as many as it has. Called once a
    /// generation, in the order of generations. Throws Error, naming generation and module, if
    /// something goes wrong.
    virtual std::vector<std::vector<double>> answers(const Traversal& course,
                                                     std::span<const Query* const> queries,
                                                     const Budget& budget) = 0;
};

/// The module as messages name it: "?E(1,2) at position 7 of generation 3".
std::string place_of(const Query& query, const Traversal& course);

}  // namespace algae
