#include <algorithm>
#include <cmath>
#include <numbers>

#include "nature/detail/iterated_functions.hpp"
#include "watch/watch.hpp"

// The attractor of an iterated function system, to a given accuracy, without chance.
//
// Box: how far a set reaches in a direction is its support function, and that of an image follows
// from that of the set in the transposed direction. Support in 720 directions, bounded between them
// by a positive combination of two neighbours, is iterated from a disc around 0 that holds the
// attractor; each round makes all bounds tighter.
//
// Points: a grid of cells is filled from a point of the attractor. The first point found in a cell
// is kept and mapped by all maps; its images are points of the attractor again. Later points of the
// same cell are dropped. If no two points of a cell are farther apart than d and no map has a norm
// above s, the error of dropping is d + s d + s^2 d + ... = d / (1 - s), so cells of the side
// accuracy (1 - s) / sqrt 2 suffice. The work is cells times maps, however the images overlap.

namespace algae {

namespace {

using Map = IteratedFunctions::Map;
constexpr std::size_t directions = 720;
constexpr int most_rounds = 3000;
constexpr double finest_share = 2048;
/// How far a set reaches in each of the directions.
using Support = std::vector<double>;

double angle(std::size_t direction) {
    return 2 * std::numbers::pi * static_cast<double>(direction) / directions;
}

/// An upper bound of how far the image of a set reaches in a direction: `shift`, and a positive
/// combination of what the set reaches in two neighbouring directions.
struct SupportBound {
    double shift = 0, before_share = 0, after_share = 0;
    std::size_t before = 0, after = 0;

    double operator()(const Support& support) const {
        return shift + before_share * support[before] + after_share * support[after];
    }
};

SupportBound bound_of(const AffineMap& map, std::size_t direction) {
    const double x = std::cos(angle(direction)), y = std::sin(angle(direction));
    SupportBound bound;
    bound.shift = x * map.e + y * map.f;
    const double turned_x = map.a * x + map.c * y, turned_y = map.b * x + map.d * y;
    const double length = std::hypot(turned_x, turned_y), step = angle(1);
    double place = std::atan2(turned_y, turned_x) / step;
    if (place < 0) place += directions;
    const double nearest = std::round(place);
    if (std::fabs(place - nearest) < 1e-9) place = nearest;
    const double whole = std::floor(place), part = (place - whole) * step;
    bound.before = static_cast<std::size_t>(whole) % directions;
    bound.after = (bound.before + 1) % directions;
    bound.before_share = length * std::sin(step - part) / std::sin(step);
    bound.after_share = length * std::sin(part) / std::sin(step);
    return bound;
}

/// A radius around 0 for each state that holds its attractor.
std::vector<double> radii(const IteratedFunctions& system) {
    std::vector<double> radius(system.states.size(), 0);
    for (int round = 0; round < most_rounds; ++round) {
        std::vector<double> next = radius;
        for (const Map& map : system.maps)
            next[map.from] = std::max(
                next[map.from], std::hypot(map.map.e, map.map.f) + norm(map.map) * radius[map.to]);
        double change = 0;
        for (std::size_t i = 0; i < next.size(); ++i)
            change = std::max(change, (next[i] - radius[i]) / (next[i] + 1e-300));
        radius = std::move(next);
        if (change < 1e-12) break;
    }
    // What the rounds left out, and rounding.
    const double s = std::min(system.contraction(), 1 - 1e-9);
    for (double& one : radius) one = one * (1 + 1e-9 + 1e-12 / (1 - s)) + 1e-300;
    return radius;
}

/// The grid of one state's cells, and which of them hold a point.
struct Cells {
    double left = 0, low = 0, inverse = 1;
    std::uint64_t columns = 1, rows = 1;
    std::vector<std::uint64_t> bits;

    /// Marks the cell of a point; whether it was not marked before.
    bool mark(Point p) {
        const auto place = [](double x, std::uint64_t count) {
            return x > 0 ? std::min(static_cast<std::uint64_t>(x), count - 1) : 0;
        };
        const std::uint64_t cell =
            place((p.y - low) * inverse, rows) * columns + place((p.x - left) * inverse, columns);
        const std::uint64_t bit = std::uint64_t{1} << (cell & 63);
        if (bits[cell >> 6] & bit) return false;
        bits[cell >> 6] |= bit;
        return true;
    }
};

}  // namespace

std::vector<Box> attractor_boxes(const IteratedFunctions& system) {
    std::vector<Support> supports;
    for (const double radius : radii(system)) supports.emplace_back(directions, radius);
    std::vector<std::vector<SupportBound>> bounds;
    for (const Map& map : system.maps) {
        auto& own = bounds.emplace_back();
        for (std::size_t k = 0; k < directions; ++k) own.push_back(bound_of(map.map, k));
    }
    for (int round = 0; round < most_rounds; ++round) {
        std::vector<Support> next(supports.size(), Support(directions, -INFINITY));
        for (std::size_t m = 0; m < bounds.size(); ++m) {
            const Map& map = system.maps[m];
            for (std::size_t k = 0; k < directions; ++k)
                next[map.from][k] = std::max(next[map.from][k], bounds[m][k](supports[map.to]));
        }
        double change = 0, size = 0;
        for (std::size_t i = 0; i < next.size(); ++i)
            for (std::size_t k = 0; k < directions; ++k) {
                next[i][k] = std::min(next[i][k], supports[i][k]);
                change = std::max(change, supports[i][k] - next[i][k]);
                size = std::max(size, std::fabs(next[i][k]));
            }
        supports = std::move(next);
        if (change <= 1e-10 * size) break;
    }
    std::vector<Box> boxes;
    for (const Support& support : supports) {
        Box box;
        box.add(Point{-support[directions / 2], -support[directions / 4 * 3]});
        box.add(Point{support[0], support[directions / 4]});
        boxes.push_back(box);
    }
    return boxes;
}

namespace {

/// A point of the attractor of each state, to the precision of doubles.
std::vector<Point> attractor_points(const IteratedFunctions& system) {
    std::vector<const Map*> first(system.states.size());
    for (const Map& map : system.maps)
        if (!first[map.from]) first[map.from] = &map;
    std::vector<Point> points(system.states.size());
    for (int round = 0; round < 100 * most_rounds; ++round) {
        std::vector<Point> next;
        for (const Map* map : first) next.push_back(map->map(points[map->to]));
        if (next == points) break;
        points = std::move(next);
    }
    return points;
}

}  // namespace

void send_attractor(const IteratedFunctions& system, double accuracy, const TakeDots& take,
                    const Budget& budget) {
    const std::vector<Box> boxes = attractor_boxes(system);
    const double side = accuracy * (1 - system.contraction()) / std::numbers::sqrt2;
    std::vector<Cells> grids;
    double bits = 0;
    for (const Box& box : boxes) bits += (box.breadth() / side + 1) * (box.height() / side + 1);
    budget.check_memory(bits < 1e18 ? static_cast<std::uint64_t>(bits / 8) : ~std::uint64_t{0},
                        "the cells of an attractor whose maps contract so little");
    for (const Box& box : boxes) {
        Cells cells{box.low.x, box.low.y, 1 / side, 1, 1, {}};
        cells.columns += static_cast<std::uint64_t>(box.breadth() / side);
        cells.rows += static_cast<std::uint64_t>(box.height() / side);
        cells.bits.resize((cells.columns * cells.rows + 63) / 64);
        grids.push_back(std::move(cells));
    }
    std::vector<std::vector<std::size_t>> into(
        system.states.size());  // the maps of each state's points
    for (std::size_t m = 0; m < system.maps.size(); ++m) into[system.maps[m].to].push_back(m);

    struct Found {
        Point place;
        std::size_t state;
    };
    std::vector<Found> open;
    std::vector<Dot> dots;
    constexpr std::size_t at_a_time = 1 << 14;
    const auto visit = [&](std::size_t state, Point place, std::size_t map) {
        if (!grids[state].mark(place)) return;
        open.push_back({place, state});
        if (state != 0) return;
        dots.push_back({place, static_cast<std::uint32_t>(map)});
        if (dots.size() < at_a_time) return;
        take(dots);
        dots.clear();
    };
    const std::vector<Point> begin = attractor_points(system);
    for (std::size_t state = 0; state < begin.size(); ++state) visit(state, begin[state], 0);
    WorkCount points("points");
    for (std::uint64_t done = 0; !open.empty(); ++done) {
        if ((done & 0xffff) == 0) {
            budget.check();
            points.at(done);
            budget.check_memory(open.size() * sizeof(Found), "the points of an attractor");
        }
        const Found next = open.back();
        open.pop_back();
        for (const std::size_t m : into[next.state])
            visit(system.maps[m].from, system.maps[m].map(next.place), m);
    }
    take(dots);
}

namespace {

class AttractorFigure final : public PlainFigure {
public:
    explicit AttractorFigure(const IteratedFunctions& system)
        : PlainFigure(system.style), system_(system) {
        box_ = attractor_boxes(system_).front();
        take_corners();
        facts_.step = std::max(box_.breadth(), box_.height()) / finest_share;
    }

    void draw(Canvas& canvas, double resolution, const Budget& budget) const override {
        const double cell = resolution > 0 ? resolution : facts_.step;
        if (!(cell > 0)) {  // one point
            canvas.move_to(box_.low);
            canvas.line_to(box_.low);
            return;
        }
        const SendDots send = [&](const TakeDots& take, const Budget& within) {
            send_attractor(system_, 2 * cell, take, within);
        };
        PointFigure(send, 0, box_, style_).draw(canvas, cell, budget);
    }

private:
    IteratedFunctions system_;
};

}  // namespace

std::unique_ptr<Figure> attractor_figure(const IteratedFunctions& system) {
    return std::make_unique<AttractorFigure>(system);
}

}  // namespace algae
