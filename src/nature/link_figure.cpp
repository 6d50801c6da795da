#include "nature/link_figure.hpp"

#include <utility>

namespace algae {

LinkFigure::LinkFigure(std::vector<Link> links, double thickness, double detail, Settings settings)
    : links_(std::move(links)), thickness_(thickness), settings_(std::move(settings)) {
    for (const Link& link : links_) {
        box_.add(link.from);
        box_.add(link.to);
    }
    facts_.segments = Integer(static_cast<std::uint64_t>(links_.size()));
    facts_.step = detail;
    facts_.widest = thickness;
    if (box_.empty) return;
    facts_.low = {Coordinate(box_.low.x), Coordinate(box_.low.y)};
    facts_.high = {Coordinate(box_.high.x), Coordinate(box_.high.y)};
    facts_.end = {Coordinate(links_.back().to.x), Coordinate(links_.back().to.y)};
}

void LinkFigure::draw(Canvas& canvas, double, const Budget& budget) const {
    if (thickness_ > 0) canvas.width_as_length(thickness_);
    const bool position = canvas.wants_position();
    std::uint32_t colour = 0;
    for (std::size_t i = 0; i < links_.size(); ++i) {
        if (i % 4096 == 0) budget.check();
        const Link& link = links_[i];
        if (position) canvas.position(static_cast<double>(i) / static_cast<double>(links_.size()));
        if (link.colour != colour) canvas.colour(colour = link.colour);
        canvas.move_to(link.from);
        canvas.line_to(link.to);
    }
}

}  // namespace algae
