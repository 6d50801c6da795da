#pragma once

#include <complex>
#include <span>
#include <vector>

#include "oracle/turtle.hpp"
#include "turtle/turtle.hpp"

namespace algae {

/// A canvas that keeps what is drawn on it.
class Recording : public Canvas {
public:
    void move_to(Point point) override {
        here_ = at(point);
        down_ = true;
        ++moves;
    }
    void line_to(Point point) override {
        if (!down_) lost = true;
        strokes.push_back({here_, at(point), width_, colour_});
        here_ = at(point);
    }
    void polygon(std::span<const Point> corners) override {
        auto& polygon = polygons.emplace_back();
        for (const Point corner : corners) polygon.push_back(at(corner));
        down_ = false;
    }
    void width(double factor) override { width_ = factor; }
    void width_as_length(double length) override { lengths.push_back(length); }
    void colour(std::uint32_t index) override { colour_ = index; }
    void position(double fraction) override { positions.push_back(fraction); }
    bool wants_position() const override { return wanting; }

    std::vector<oracle::Stroke> strokes;
    std::vector<std::vector<oracle::Spot>> polygons;
    std::vector<double> positions;
    std::vector<double> lengths;  // widths that are lengths
    std::size_t moves = 0;
    bool lost = false;  // a stroke came before the pen was set down
    bool wanting = false;

private:
    static oracle::Spot at(Point point) { return {point.x, point.y}; }

    oracle::Spot here_;
    double width_ = 1;
    unsigned colour_ = 0;
    bool down_ = false;
};

inline bool near(oracle::Real x, oracle::Real y) {
    return std::abs(x - y) <= 1e-9L * (1 + std::abs(x));
}
inline bool near(oracle::Spot x, oracle::Spot y) {
    return std::abs(x - y) <= 1e-9L * (1 + std::abs(x));
}

}  // namespace algae
