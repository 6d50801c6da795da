#include "nature/path_figure.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace algae {

namespace {

double distance(Point a, Point b) { return std::hypot(a.x - b.x, a.y - b.y); }

}  // namespace

PathFigure::PathFigure(std::vector<Path> paths, Settings settings)
    : paths_(std::move(paths)), settings_(std::move(settings)) {
    std::uint64_t lines = 0;
    double length = 0;
    for (const Path& path : paths_) {
        for (const Point& point : path.points) box_.add(point);
        if (path.filled) {
            ++strokes_;
            continue;
        }
        if (!path.points.empty()) lines += path.points.size() - 1;
        for (std::size_t i = 1; i < path.points.size(); ++i)
            length += distance(path.points[i - 1], path.points[i]);
    }
    strokes_ += lines;
    facts_.segments = Integer(lines);
    if (box_.empty) return;
    facts_.low = {Coordinate(box_.low.x), Coordinate(box_.low.y)};
    facts_.high = {Coordinate(box_.high.x), Coordinate(box_.high.y)};
    if (!paths_.back().points.empty()) {
        const Point end = paths_.back().points.back();
        facts_.end = {Coordinate(end.x), Coordinate(end.y)};
    }
    facts_.step = lines > 0 ? length / static_cast<double>(lines) : 0;
}

void PathFigure::draw(Canvas& canvas, double resolution, const Budget& budget) const {
    std::uint64_t done = 0;
    std::uint32_t colour = 0;
    double width = 1;
    std::optional<Colour> paint;
    std::optional<double> length_width;
    const auto at = [&] {
        if ((++done & 0xfff) == 0) budget.check();
        if (canvas.wants_position())
            canvas.position(static_cast<double>(done - 1) / static_cast<double>(strokes_));
    };
    for (const Path& path : paths_) {
        if (path.points.empty()) continue;
        if (path.paint && path.paint != paint)
            canvas.paint(*path.paint);
        else if (!path.paint && (paint || path.colour != colour))
            canvas.colour(colour = path.colour);
        paint = path.paint;
        if (path.length_width && path.length_width != length_width)
            canvas.width_as_length(*path.length_width);
        else if (!path.length_width && (length_width || path.width != width))
            canvas.width(width = path.width);
        length_width = path.length_width;
        if (path.filled) {
            at();
            canvas.polygon(path.points);
            continue;
        }
        Point last = path.points.front();
        canvas.move_to(last);
        for (std::size_t i = 1; i < path.points.size(); ++i) {
            at();
            const Point point = path.points[i];
            if (i + 1 < path.points.size() && distance(last, point) < resolution) continue;
            canvas.line_to(point);
            last = point;
        }
    }
}

}  // namespace algae
