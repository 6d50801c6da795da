#include <fmt/args.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "nature/detail/figures.hpp"

// Figures whose geometry is computed, not drawn by a turtle: broken lines and polygons, many dots,
// many links.
//
// Such a figure knows its box and facts when it is made (`PlainFigure`), and sends its strokes to a
// canvas in drawing order. A resolution above 0 says how fine the canvas is, so that what it cannot
// show is left out: points of a line nearer than that to the last one drawn, and of dots all but
// one in a cell of that size.
//
// Dots are not kept: they are sent again whenever they are drawn (`SendDots`), so that 10^8 points
// of a chaos game take no memory. With a resolution, a byte for each cell holds the colour of the
// last dot there; the cells are then drawn colour by colour.

namespace algae {

void require(bool holds, std::string_view text, std::initializer_list<Said> values) {
    if (holds) return;
    fmt::dynamic_format_arg_store<fmt::format_context> arguments;
    for (const Said& value : values)
        std::visit([&](const auto& said) { arguments.push_back(said); }, value);
    throw Error(fmt::vformat(text, arguments));
}

Colour mixed(const Colour& from, const Colour& to, double share) {
    return {from.red + share * (to.red - from.red), from.green + share * (to.green - from.green),
            from.blue + share * (to.blue - from.blue)};
}

GeneratorFact::GeneratorFact(std::string of, std::string said, const nlohmann::ordered_json& known)
    : key(std::move(of)),
      text(std::move(said)),
      value(std::make_shared<const nlohmann::ordered_json>(known)) {}

void PlainFigure::take_corners() {
    if (box_.empty) return;
    facts_.low = {Coordinate(box_.low.x), Coordinate(box_.low.y)};
    facts_.high = {Coordinate(box_.high.x), Coordinate(box_.high.y)};
}

PathFigure::PathFigure(std::vector<Path> paths, FigureStyle style)
    : PlainFigure(std::move(style)), paths_(std::move(paths)) {
    std::uint64_t lines = 0, polygons = 0;
    double length = 0;
    for (const Path& path : paths_) {
        for (const Point& point : path.points) box_.add(point);
        if (path.filled) {
            ++polygons;
            continue;
        }
        if (!path.points.empty()) lines += path.points.size() - 1;
        for (std::size_t i = 1; i < path.points.size(); ++i)
            length += distance(path.points[i - 1], path.points[i]);
    }
    strokes_ = lines + polygons;
    facts_.segments = Integer(lines);
    if (box_.empty) return;
    take_corners();
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
            canvas.position(static_cast<double>(done - 1) / static_cast<double>(*strokes_));
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

namespace {

void draw_dot(Canvas& canvas, Point place) {
    canvas.move_to(place);
    canvas.line_to(place);
}

}  // namespace

PointFigure::PointFigure(SendDots send, std::uint64_t count, const Box& box, FigureStyle style)
    : PlainFigure(std::move(style)), send_(std::move(send)) {
    strokes_ = count;
    box_ = box;
    facts_.segments = Integer(count);
    facts_.step = 0;
    take_corners();
}

void PointFigure::draw(Canvas& canvas, double resolution, const Budget& budget) const {
    if (resolution > 0) return draw_cells(canvas, resolution, budget);
    const bool position = canvas.wants_position();
    std::uint64_t done = 0;
    std::uint32_t colour = 0;
    send_(
        [&](std::span<const Dot> dots) {
            for (const Dot& dot : dots) {
                if (position)
                    canvas.position(static_cast<double>(done) / static_cast<double>(*strokes_));
                if (dot.colour != colour) canvas.colour(colour = dot.colour);
                draw_dot(canvas, dot.place);
                ++done;
            }
        },
        budget);
}

void PointFigure::draw_cells(Canvas& canvas, double resolution, const Budget& budget) const {
    if (box_.empty) return;
    const auto cells = [&](double length) {
        return static_cast<std::uint64_t>(length / resolution) + 1;
    };
    if (!(box_.breadth() / resolution < 1e9 && box_.height() / resolution < 1e9))
        throw Error("a picture of points has more than 10^9 cells a side");
    const std::uint64_t columns = cells(box_.breadth()), rows = cells(box_.height());
    budget.check_memory(columns * rows, "the cells of a picture of points");
    std::vector<std::uint8_t> grid(columns * rows);  // 0: blank, otherwise 1 + the colour
    const double inverse = 1 / resolution, left = box_.low.x, low = box_.low.y;
    bool colours_used[256] = {};
    send_(
        [&](std::span<const Dot> dots) {
            for (const Dot& dot : dots) {
                const double x = (dot.place.x - left) * inverse, y = (dot.place.y - low) * inverse;
                if (!(x >= 0 && y >= 0)) continue;
                const auto column = static_cast<std::uint64_t>(x),
                           row = static_cast<std::uint64_t>(y);
                if (column >= columns || row >= rows) continue;
                const auto kept = static_cast<std::uint8_t>(
                    dot.colour < 255 ? dot.colour + 1 : (dot.colour - 255) % 254 + 2);
                grid[row * columns + column] = kept;
                colours_used[kept] = true;
            }
        },
        budget);
    for (std::size_t kept = 1; kept < 256; ++kept) {
        if (!colours_used[kept]) continue;
        canvas.colour(static_cast<std::uint32_t>(kept - 1));
        for (std::uint64_t row = 0; row < rows; ++row) {
            if ((row & 0x3f) == 0) budget.check();
            const std::uint8_t* const line = grid.data() + row * columns;
            for (std::uint64_t column = 0; column < columns; ++column)
                if (line[column] == kept)
                    draw_dot(canvas, {left + (static_cast<double>(column) + 0.5) * resolution,
                                      low + (static_cast<double>(row) + 0.5) * resolution});
        }
    }
}

LinkFigure::LinkFigure(std::vector<Link> links, double thickness, double detail, FigureStyle style)
    : PlainFigure(std::move(style)), links_(std::move(links)), thickness_(thickness) {
    for (const Link& link : links_) {
        box_.add(link.from);
        box_.add(link.to);
    }
    strokes_ = links_.size();
    facts_.segments = Integer(*strokes_);
    facts_.step = detail;
    facts_.widest = thickness;
    if (box_.empty) return;
    take_corners();
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

GeneratorFigure pictured(const Generator& of, std::unique_ptr<Figure> figure,
                         const std::string& what) {
    return {std::move(figure), of.heading() + ", " + what, what};
}

GeneratorFigure pictured(const Generator& of, std::vector<Path> paths, const std::string& what) {
    return pictured(of, std::make_unique<PathFigure>(std::move(paths), of.style), what);
}

BestLine best_line(const std::vector<Point>& points) {
    Point mean;
    for (const Point& point : points) {
        mean.x += point.x / static_cast<double>(points.size());
        mean.y += point.y / static_cast<double>(points.size());
    }
    double over = 0, under = 0;
    for (const Point& point : points) {
        over += (point.x - mean.x) * (point.y - mean.y);
        under += (point.x - mean.x) * (point.x - mean.x);
    }
    if (!(under > 0)) return {0, mean.y, true};
    return {over / under, mean.y - over / under * mean.x, false};
}

std::vector<Point> graph_path(const std::vector<double>& values, double breadth) {
    if (values.empty()) return {};
    const auto [low, high] = std::minmax_element(values.begin(), values.end());
    const double scale = *high > *low ? 1 / (*high - *low) : 0;
    const double last = std::max<double>(static_cast<double>(values.size()) - 1, 1);
    std::vector<Point> points;
    points.reserve(values.size());
    for (std::size_t i = 0; i < values.size(); ++i)
        points.push_back({breadth * static_cast<double>(i) / last, (values[i] - *low) * scale});
    return points;
}

std::unique_ptr<Figure> tile_figure(const Tile& tile, const Budget& budget) {
    constexpr std::size_t across = 400;
    const Colour colours[] = {{0.71, 0.28, 0.16}, {0.38, 0.58, 0.67}, {0.92, 0.76, 0.47},
                              {0.58, 0.69, 0.53}, {0.63, 0.57, 0.72}, {0.75, 0.8, 0.84},
                              {0.84, 0.66, 0.6}};
    constexpr std::size_t count = std::size(colours);
    std::vector<std::vector<Point>> outlines = tile_outlines(tile, across, budget);
    // Corners are those of a grid, so tiles that touch each other share some.
    std::map<std::pair<double, double>, std::set<std::size_t>> corners;
    for (std::size_t k = 0; k < outlines.size(); ++k)
        for (const Point& corner : outlines[k]) corners[{corner.x, corner.y}].insert(k);
    std::vector<std::set<std::size_t>> beside(outlines.size());
    for (const auto& [corner, tiles] : corners)
        for (const std::size_t k : tiles) beside[k].insert(tiles.begin(), tiles.end());
    std::vector<std::size_t> chosen;
    std::vector<Path> paths;
    for (std::size_t k = 0; k < outlines.size(); ++k) {
        std::size_t colour = k == 0 ? 0 : 1;
        while (k > 0 && colour + 1 < count &&
               std::any_of(beside[k].begin(), beside[k].end(),
                           [&](std::size_t i) { return i < k && chosen[i] == colour; }))
            ++colour;
        chosen.push_back(colour);
        Path path;
        path.filled = true;
        path.points = std::move(outlines[k]);
        path.paint = colours[colour];
        paths.push_back(std::move(path));
    }
    return std::make_unique<PathFigure>(std::move(paths));
}

}  // namespace algae
