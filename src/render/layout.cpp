#include <algorithm>
#include <cmath>
#include <limits>

#include "render/detail/layout.hpp"

// Where things stand in a picture: figures in cells, and labels where they cover little.
//
// A layout is rows of cells of one size. With width and height given, the cells share what margins, gaps and captions leave.
// With one of them, the other is the least that holds every figure; with none, the longer side is that of the wishes. In a row of
// several cells none is more than twice as high as wide unless the wishes say so, and straight lines, which would ask for the
// highest or widest cells but fit into any, decide the size only where there is nothing else. A figure stands in the middle of its
// cell; with a common scale, in the middle of its cell's lower side, so that figures of one row stand on one line.
//
// Labels are placed one after the other, each at the middle that costs least of those offered: what it would cover of lines, discs
// and earlier labels, and what lies outside of the picture, weighted; earlier middles win where costs are alike. This is
// greedy: a label that is placed stays.

namespace algae {

namespace {

constexpr double unbounded = std::numeric_limits<double>::infinity();

/// The largest scale at which the box fits. A single point fits at any scale: 1 then.
double fitting_scale(const Box& box, double width, double height) {
    const double scale = std::min(box.breadth() > 0 ? width / box.breadth() : unbounded,
                                  box.height() > 0 ? height / box.height() : unbounded);
    return std::isfinite(scale) ? scale : 1;
}

/// The scale at which all boxes fit; infinite if none has an extent.
double common_scale(std::span<const Box> boxes, double width, double height) {
    double scale = unbounded;
    for (const Box& box : boxes)
        if (box.breadth() > 0 || box.height() > 0)
            scale = std::min(scale, fitting_scale(box, width, height));
    return scale;
}

/// The figure in the middle of its cell.
Frame centred(const Box& box, const Cell& cell, double scale) {
    return {scale, cell.left + cell.width / 2 - scale * (box.low.x / 2 + box.high.x / 2),
            cell.top + cell.height / 2 + scale * (box.low.y / 2 + box.high.y / 2)};
}

/// The figure in the middle of its cell's lower side, where figures of one scale stand in a row.
Frame standing(const Box& box, const Cell& cell, double scale) {
    Frame frame = centred(box, cell, scale);
    frame.y = cell.top + cell.height + scale * box.low.y;
    return frame;
}

/// Straight lines would have the highest or widest cells, but fit into any: they decide the size of
/// cells only where there is nothing else.
bool is_straight(const Box& box) { return box.breadth() == 0 || box.height() == 0; }

struct Size {
    double width = 0, height = 0;
};

/// The least cell that holds every figure when none may be larger than width times height.
Size tight_cell(std::span<const Box> boxes, double width, double height, bool one_scale) {
    const double common = common_scale(boxes, width, height);
    const bool all_straight = std::ranges::all_of(boxes, is_straight);
    Size size;
    for (const Box& box : boxes) {
        if (is_straight(box) && !all_straight) continue;
        const double scale =
            one_scale && std::isfinite(common) ? common : fitting_scale(box, width, height);
        size.width = std::max(size.width, std::min(width, scale * box.breadth()));
        size.height = std::max(size.height, std::min(height, scale * box.height()));
    }
    return size;
}

}  // namespace

std::size_t panel_columns(std::span<const Box> boxes) {
    constexpr double wide = 2.5;  // times as wide as high
    double breadth = 0, height = 0;
    for (const Box& box : boxes) {
        const double longer = std::max(box.breadth(), box.height());
        if (longer == 0) continue;
        breadth = std::max(breadth, box.breadth() / longer);
        height = std::max(height, box.height() / longer);
    }
    if (breadth > wide * height) {
        constexpr double steep = 1.3;  // the picture is not much higher than wide
        std::size_t columns = 1;
        const auto rows_high = [&] {
            return static_cast<double>((boxes.size() + columns - 1) / columns) * height;
        };
        while (rows_high() > steep * static_cast<double>(columns) * breadth) ++columns;
        return columns;
    }
    const std::size_t rows = (boxes.size() + 4) / 5;
    return rows == 0 ? 1 : (boxes.size() + rows - 1) / rows;
}

Layout layout(std::span<const Box> boxes, const LayoutWishes& wishes) {
    const std::size_t columns = std::max<std::size_t>(1, std::min(wishes.columns, boxes.size()));
    const std::size_t rows = std::max<std::size_t>(1, (boxes.size() + columns - 1) / columns);
    const double across = static_cast<double>(columns), down = static_cast<double>(rows);
    const double gaps_across = 2 * across * wishes.margin + (across - 1) * wishes.gap;
    const double gaps_down =
        (down + 1) * wishes.margin + (down - 1) * wishes.gap + down * wishes.caption;
    const auto share = [](double whole, double gaps, double parts) {
        return std::max((whole - gaps) / parts, 1.0);
    };

    // One figure fills the longest side; several in a row share it, and are not too tall for that.
    const double steepest = boxes.size() == 1 || columns == 1 ? unbounded : 2;
    Size cell;
    if (wishes.width && wishes.height) {
        cell = {share(*wishes.width, gaps_across, across), share(*wishes.height, gaps_down, down)};
    } else if (wishes.height) {
        const double height = share(*wishes.height, gaps_down, down);
        const bool flat =
            std::ranges::all_of(boxes, [](const Box& box) { return box.height() == 0; });
        const double width = std::min(
            height * steepest, flat ? share(wishes.longest, gaps_across, across) : unbounded);
        cell = {tight_cell(boxes, width, height, wishes.common_scale).width, height};
    } else if (wishes.width) {
        const double width = share(*wishes.width, gaps_across, across);
        const bool upright =
            std::ranges::all_of(boxes, [](const Box& box) { return box.breadth() == 0; });
        const double height = std::min(
            width * steepest, upright ? share(wishes.longest, gaps_down, down) : unbounded);
        cell = {width, tight_cell(boxes, width, height, wishes.common_scale).height};
    } else {
        const double width = share(wishes.longest, gaps_across, across);
        const double height = share(wishes.longest, gaps_down, down);
        cell = tight_cell(boxes, width, std::min(height, width * steepest), wishes.common_scale);
    }

    Layout result;
    result.width = wishes.width.value_or(across * cell.width + gaps_across);
    result.height = wishes.height.value_or(down * cell.height + gaps_down);
    const double common = common_scale(boxes, cell.width, cell.height);
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        const double column = static_cast<double>(i % columns),
                     row = static_cast<double>(i / columns);
        Cell place;
        place.width = cell.width;
        place.height = cell.height;
        place.left = wishes.margin + column * (cell.width + 2 * wishes.margin + wishes.gap);
        place.top =
            wishes.margin + row * (cell.height + wishes.margin + wishes.gap + wishes.caption);
        place.caption_top = place.top + cell.height;
        const Box& box = boxes[i];
        place.frame = wishes.common_scale && std::isfinite(common)
                          ? standing(box, place, common)
                          : centred(box, place, fitting_scale(box, cell.width, cell.height));
        result.cells.push_back(place);
    }
    return result;
}

std::vector<Layout> page_layouts(std::span<const Box> boxes, LayoutWishes wishes) {
    wishes.columns = 1;
    const bool all_straight = std::ranges::all_of(boxes, is_straight);
    double width = 0, height = 0;
    for (const Box& box : boxes) {
        if (is_straight(box) && (box.empty || !all_straight)) continue;
        const Layout alone = layout(std::span(&box, 1), wishes);
        width = std::max(width, alone.width);
        height = std::max(height, alone.height);
    }
    wishes.width = width;
    wishes.height = height;
    std::vector<Layout> pages;
    for (const Box& box : boxes) pages.push_back(layout(std::span(&box, 1), wishes));
    if (!wishes.common_scale || pages.empty()) return pages;
    const Cell& any = pages.front().cells.front();
    const double scale = common_scale(boxes, any.width, any.height);
    for (std::size_t i = 0; i < pages.size() && std::isfinite(scale); ++i) {
        Cell& cell = pages[i].cells.front();
        cell.frame = standing(boxes[i], cell, scale);
    }
    return pages;
}

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
