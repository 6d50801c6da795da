#pragma once

#include "environment/environment.hpp"

namespace algae {

/// `collision R`: 1 if a line of the word comes within R of the turtle, on the border too, else 0.
/// Lines of the whole word count, before the module and behind it, but not those that meet where the
/// turtle stands (see Joint). O(n log n) for n lines and queries where lines do not crowd.
class CollisionEnvironment : public Environment {
public:
    explicit CollisionEnvironment(double radius) : radius_(radius) {}
    std::vector<std::vector<double>> answers(const Traversal& course,
                                             std::span<const Query* const> queries,
                                             const Budget& budget) override;

private:
    double radius_;
};

}  // namespace algae
