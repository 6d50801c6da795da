#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "turtle/figure.hpp"

namespace algae {

/// A point of a figure, with the index of its colour in the figure's list.
struct Dot {
    Point place;
    std::uint32_t colour = 0;
    bool operator==(const Dot&) const = default;
};

/// Takes some dots, in drawing order.
using TakeDots = std::function<void(std::span<const Dot>)>;
/// Sends all dots of a figure, the same ones each time; some thousands at a time are fast.
using SendDots = std::function<void(const TakeDots&, const Budget&)>;

/// Many points, each drawn as a round dot as wide as the figure's line width (one pixel, or 1 point of
/// vector formats, unless `width` says otherwise). With a resolution, each cell of that size is
/// drawn once, in the colour of its last dot: any number of dots costs their making, and the memory
/// of a byte a cell.
class PointFigure : public Figure {
public:
    explicit PointFigure(std::vector<Dot> dots, Settings settings = {});
    /// The dots are made whenever they are drawn; `count` of them, within `box`. Colours beyond 255
    /// start again from 1 where there is a resolution.
    PointFigure(SendDots send, std::uint64_t count, const Box& box, Settings settings = {});

    const Box& box() const override { return box_; }
    /// The number of dots.
    const Integer& segments() const override { return facts_.segments; }
    const Facts& facts() const override { return facts_; }
    std::optional<std::uint64_t> strokes() const override { return count_; }
    const Settings& settings() const override { return settings_; }
    void draw(Canvas& canvas, double resolution, const Budget& budget) const override;

private:
    void draw_cells(Canvas& canvas, double resolution, const Budget& budget) const;
    void find_facts();

    SendDots send_;
    std::uint64_t count_;
    Box box_;
    Settings settings_;
    Facts facts_;
};

}  // namespace algae
