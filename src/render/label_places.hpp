#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "turtle/canvas.hpp"

namespace algae {

/// A rectangle for a label, by its middle; x to the right, y downward, as in a picture.
struct LabelPlace {
    Point middle;
    double width = 0, height = 0;
};

/// Finds places for labels in a picture where they cover little: what stands in the way is told
/// first, and every label found stands in the way of the next.
class LabelPlaces {
public:
    LabelPlaces(Point low, Point high) : low_(low), high_(high) {}

    /// A line that labels should not cover.
    void avoid(Point from, Point to) { lines_.emplace_back(from, to); }
    /// A disc that labels should not cover.
    void avoid(Point middle, double radius) { discs_.emplace_back(middle, radius); }

    /// Of the middles that may be, earlier ones better, the one at which a label of this size is least
    /// in the way. O(places * things in the way).
    LabelPlace place(const std::vector<Point>& middles, double width, double height);

private:
    double cost(const LabelPlace& label) const;

    Point low_, high_;
    std::vector<std::pair<Point, Point>> lines_;
    std::vector<std::pair<Point, double>> discs_;
    std::vector<LabelPlace> labels_;
};

}  // namespace algae
