#pragma once

#include <vector>

#include "nature/iterated_functions.hpp"
#include "nature/point_figure.hpp"

namespace algae {

/// For each state a box that holds its attractor, hardly larger than need be. By supporting lines in
/// 720 directions: how far a set reaches in a direction is how far its images reach, and each round
/// makes the bounds of all directions tighter.
std::vector<Box> attractor_boxes(const IteratedFunctions& system);

/// A point of the attractor of each state, to the precision of doubles.
std::vector<Point> attractor_points(const IteratedFunctions& system);

/// Sends points of the attractor of the first state such that each point of it lies within `accuracy`
/// of one of them; the colour is the number of the map. A grid of cells is filled from a point of the
/// attractor: the images of the first point in each cell are points of the attractor again. If no two
/// points of a cell are farther apart than d and no map has a norm above s, then no point of the
/// attractor is farther than d / (1 - s) from one that was sent. O(cells * maps), however the images
/// overlap; a bit for each cell of the boxes.
///
/// Throws BoundReached if the bits need more memory than the budget has.
void send_attractor(const IteratedFunctions& system, double accuracy, const TakeDots& take,
                    const Budget& budget);

/// The attractor, to twice the resolution with which it is drawn (a third of a pixel in pictures);
/// without one, to a part in 1024 of its longer side.
class AttractorFigure : public Figure {
public:
    explicit AttractorFigure(IteratedFunctions system);

    const Box& box() const override { return box_; }
    const Integer& segments() const override { return facts_.segments; }
    const Facts& facts() const override { return facts_; }
    /// Not known beforehand.
    std::optional<std::uint64_t> strokes() const override { return std::nullopt; }
    const Settings& settings() const override { return system_.settings; }
    void draw(Canvas& canvas, double resolution, const Budget& budget) const override;

private:
    IteratedFunctions system_;
    Box box_;
    Facts facts_;
};

}  // namespace algae
