#pragma once

#include <cstdint>
#include <vector>

#include "turtle/figure.hpp"

namespace algae {

/// A straight stroke of a figure of many, with the index of its colour.
struct Link {
    Point from, to;
    std::uint32_t colour = 0;
    bool operator==(const Link&) const = default;
};

/// Many separate strokes of one thickness with round ends, drawn in order: such as the particles of an
/// aggregate, each joined to the one that it touches.
class LinkFigure : public Figure {
public:
    /// `thickness` is a length in the plane, or 0 for the line width; `detail` that of a link.
    LinkFigure(std::vector<Link> links, double thickness, double detail, Settings settings = {});

    const Box& box() const override { return box_; }
    const Integer& segments() const override { return facts_.segments; }
    const Facts& facts() const override { return facts_; }
    std::optional<std::uint64_t> strokes() const override { return links_.size(); }
    const Settings& settings() const override { return settings_; }
    void draw(Canvas& canvas, double resolution, const Budget& budget) const override;

    const std::vector<Link>& links() const { return links_; }

private:
    std::vector<Link> links_;
    double thickness_;
    Settings settings_;
    Facts facts_;
    Box box_;
};

}  // namespace algae
