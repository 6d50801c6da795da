#include "render/label_places.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace algae {

namespace {

/// How much of a line lies in the rectangle (Liang and Barsky 1984).
double length_within(const LabelPlace& label, Point from, Point to) {
    double enter = 0, leave = 1;
    const auto clip = [&](double start, double way, double low, double high) {
        if (std::fabs(way) < 1e-12) {
            if (start < low || start > high) leave = -1;
            return;
        }
        const double a = (low - start) / way, b = (high - start) / way;
        enter = std::max(enter, std::min(a, b));
        leave = std::min(leave, std::max(a, b));
    };
    const double dx = to.x - from.x, dy = to.y - from.y;
    clip(from.x, dx, label.middle.x - label.width / 2, label.middle.x + label.width / 2);
    clip(from.y, dy, label.middle.y - label.height / 2, label.middle.y + label.height / 2);
    return leave > enter ? (leave - enter) * std::hypot(dx, dy) : 0;
}

/// How far two intervals of these middles and lengths overlap.
double overlap(double a, double length_a, double b, double length_b) {
    return std::max(0.0, (length_a + length_b) / 2 - std::fabs(a - b));
}

}  // namespace

double LabelPlaces::cost(const LabelPlace& label) const {
    constexpr double outside = 50, on_label = 6, on_line = 2, on_disc = 3;  // per unit
    double sum = 0;
    const Point& at = label.middle;
    sum += outside * (std::max(0.0, low_.x - (at.x - label.width / 2)) +
                      std::max(0.0, at.x + label.width / 2 - high_.x) +
                      std::max(0.0, low_.y - (at.y - label.height / 2)) +
                      std::max(0.0, at.y + label.height / 2 - high_.y));
    for (const LabelPlace& other : labels_)
        sum += on_label * overlap(at.x, label.width + 2, other.middle.x, other.width) *
               overlap(at.y, label.height + 2, other.middle.y, other.height);
    for (const auto& [from, to] : lines_) sum += on_line * length_within(label, from, to);
    for (const auto& [middle, radius] : discs_)
        sum += on_disc * overlap(at.x, label.width, middle.x, 2 * radius) *
               overlap(at.y, label.height, middle.y, 2 * radius);
    return sum;
}

LabelPlace LabelPlaces::place(const std::vector<Point>& middles, double width, double height) {
    LabelPlace best{middles.front(), width, height};
    double least = std::numeric_limits<double>::infinity();
    double preference = 0;
    for (const Point& middle : middles) {
        const LabelPlace label{middle, width, height};
        const double here = cost(label) + preference;
        preference += 0.5;
        if (here >= least) continue;
        least = here;
        best = label;
    }
    labels_.push_back(best);
    return best;
}

}  // namespace algae
