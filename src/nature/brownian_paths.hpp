#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "nature/brownian.hpp"
#include "nature/relative.hpp"

namespace algae {

/// Pictures of fractional Brownian motion: in one dimension the graph of X(t), in two and three the
/// path whose coordinates are independent; one for each H and each number of levels.
class BrownianPaths : public Relative {
public:
    std::vector<double> hurst{0.5};
    double sigma = 1;
    std::pair<int, int> levels{10, 10};
    int dimensions = 1;
    bool exact = true;  // otherwise by midpoint displacement
    std::uint64_t seed = 1;

    /// Throws Error on parameters out of range.
    void check() const;
    /// The coordinates of one path, one after the other.
    std::vector<std::vector<double>> coordinates(double h, int level, const Budget& budget) const;

    std::vector<RelativeFigure> figures(const Budget& budget) const override;
    std::vector<RelativeFact> facts(const Budget& budget) const override;
    /// In three dimensions the path of the last H and the most levels.
    std::optional<Scene> scene(const Budget& budget) const override;

private:
    std::vector<Vector> places(double h, int level, const Budget& budget) const;
};

}  // namespace algae
