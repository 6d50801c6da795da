#pragma once

#include "environment/environment.hpp"

namespace algae {

/// `light R`: how much of the light from straight above reaches the turtle. It is the radius of the
/// widest vertical column of light around the turtle that no line above the turtle enters, divided
/// by R; 1 if it is R or more, 0 if a line is right above. Lines of the whole word count, but not
/// those that meet where the turtle stands (see Joint), and of each the part above the turtle only.
/// Up is z if the word leaves the plane, y if not. O(n log n) for n lines and queries where lines do
/// not stand above each other in great numbers.
class LightEnvironment : public Environment {
public:
    explicit LightEnvironment(double radius) : radius_(radius) {}
    std::vector<std::vector<double>> answers(const Traversal& course,
                                             std::span<const Query* const> queries,
                                             const Budget& budget) override;

private:
    double radius_;
};

}  // namespace algae
