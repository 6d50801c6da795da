#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <unordered_set>

#include "render/detail/figure_text.hpp"

// For a plotter the paths of each pen (colour and width) become the edges of a graph whose nodes are points, those that lie within a
// thousandth of a millionth of the figure's size being one. Edges count once. A connected component is drawn in as few trails as its
// nodes of odd degree allow: these are paired by edges that are not drawn, the component then has a circuit of Euler (Hierholzer
// 1873), and the circuit falls into trails where such an edge was. Trails are put into order by always going to the nearest end,
// looked for in a grid of buckets.

namespace algae {

namespace {

/// Gives points numbers, the same to points that lie together.
class NumberedPlaces {
public:
    explicit NumberedPlaces(double grid) : grid_(grid) {}

    std::uint32_t number(Point point) {
        const std::int64_t x = std::llround(point.x / grid_), y = std::llround(point.y / grid_);
        for (const std::int64_t dx : {0, -1, 1})
            for (const std::int64_t dy : {0, -1, 1})
                if (const auto found = cells_.find({x + dx, y + dy}); found != cells_.end())
                    return found->second;
        const auto fresh = static_cast<std::uint32_t>(points.size());
        cells_.emplace(Cell{x, y}, fresh);
        points.push_back(point);
        return fresh;
    }

    std::vector<Point> points;

private:
    struct Cell {
        std::int64_t x, y;
        bool operator==(const Cell&) const = default;
    };
    struct Hash {
        std::size_t operator()(const Cell& cell) const {
            const std::uint64_t mixed = static_cast<std::uint64_t>(cell.x) * 0x9E3779B97F4A7C15u ^
                                        static_cast<std::uint64_t>(cell.y) * 0xC2B2AE3D27D4EB4Fu;
            return static_cast<std::size_t>(mixed ^ mixed >> 29);
        }
    };

    double grid_;
    std::unordered_map<Cell, std::uint32_t, Hash> cells_;
};

/// The segments of one pen as a graph, and its trails.
class Trails {
public:
    /// False if the segment is there already.
    bool add(std::uint32_t from, std::uint32_t to) {
        const auto [low, high] = std::minmax(from, to);
        if (!known_.insert(std::uint64_t{high} << 32 | low).second) return false;
        ends_.emplace_back(from, to);
        return true;
    }

    /// Trails through all segments, as few as there can be; each is a list of nodes.
    std::vector<std::vector<std::uint32_t>> found() {
        number_nodes();
        pair_odd_nodes();
        std::vector<std::vector<std::uint32_t>> trails;
        used_.assign(ends_.size(), 0);
        next_.assign(nodes_.size(), 0);
        for (std::uint32_t start = 0; start < nodes_.size(); ++start)
            if (has_more(start)) split(circuit(start), trails);
        return trails;
    }

private:
    static constexpr std::uint32_t none = ~std::uint32_t{0};

    void number_nodes() {
        std::unordered_map<std::uint32_t, std::uint32_t> numbers;
        for (auto& [from, to] : ends_)
            for (std::uint32_t* end : {&from, &to}) {
                const auto [entry, is_new] =
                    numbers.try_emplace(*end, static_cast<std::uint32_t>(nodes_.size()));
                if (is_new) nodes_.push_back(*end);
                *end = entry->second;
            }
        at_.resize(nodes_.size());
        for (std::uint32_t i = 0; i < ends_.size(); ++i) link(i);
        drawn_ = ends_.size();
    }
    void link(std::uint32_t edge) {
        at_[ends_[edge].first].push_back(edge);
        if (ends_[edge].second != ends_[edge].first) at_[ends_[edge].second].push_back(edge);
    }
    /// Joins nodes of odd degree of the same component by edges that are not drawn.
    void pair_odd_nodes() {
        std::vector<char> seen(nodes_.size());
        std::vector<std::uint32_t> waiting, odd;
        for (std::uint32_t start = 0; start < nodes_.size(); ++start) {
            if (seen[start]) continue;
            odd.clear();
            waiting = {start};
            seen[start] = 1;
            while (!waiting.empty()) {
                const std::uint32_t node = waiting.back();
                waiting.pop_back();
                std::size_t degree = 0;
                for (const std::uint32_t edge : at_[node]) {
                    const auto [from, to] = ends_[edge];
                    degree += from == to ? 2 : 1;
                    const std::uint32_t other = from == node ? to : from;
                    if (!seen[other]) {
                        seen[other] = 1;
                        waiting.push_back(other);
                    }
                }
                if (degree % 2 == 1) odd.push_back(node);
            }
            for (std::size_t i = 0; i + 1 < odd.size(); i += 2) {
                ends_.emplace_back(odd[i], odd[i + 1]);
                link(static_cast<std::uint32_t>(ends_.size() - 1));
            }
        }
    }
    bool has_more(std::uint32_t node) {
        while (next_[node] < at_[node].size() && used_[at_[node][next_[node]]]) ++next_[node];
        return next_[node] < at_[node].size();
    }
    struct Step {
        std::uint32_t node, edge;  // the edge by which it was reached
    };
    /// A circuit of Euler through the component.
    std::vector<Step> circuit(std::uint32_t start) {
        std::vector<Step> way{{start, none}}, found;
        while (!way.empty()) {
            const std::uint32_t node = way.back().node;
            if (!has_more(node)) {
                found.push_back(way.back());
                way.pop_back();
                continue;
            }
            const std::uint32_t edge = at_[node][next_[node]++];
            used_[edge] = 1;
            const auto [from, to] = ends_[edge];
            way.push_back({from == node ? to : from, edge});
        }
        return found;
    }
    /// Cuts a circuit where its edges are not drawn.
    void split(const std::vector<Step>& round, std::vector<std::vector<std::uint32_t>>& trails) {
        const std::size_t count = round.size() - 1;  // edges; the last node is the first
        std::size_t first = 0;
        while (first < count && round[first].edge < drawn_) ++first;
        const bool closed = first == count;
        std::vector<std::uint32_t> trail;
        const auto end = [&] {
            if (trail.size() > 1) trails.push_back(trail);
            trail.clear();
        };
        if (closed) first = count - 1;
        // The edge of a step leads from it to the next one, as the way is found backwards.
        for (std::size_t i = 0; i < count; ++i) {
            const std::size_t at = (first + 1 + i) % count;
            if (trail.empty()) trail.push_back(nodes_[round[at].node]);
            if (round[at].edge >= drawn_ && round[at].edge != none) {
                end();
                continue;
            }
            trail.push_back(nodes_[round[at + 1].node]);
        }
        end();
    }

    std::unordered_set<std::uint64_t> known_;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> ends_;  // of edges, drawn ones first
    std::vector<std::uint32_t> nodes_;                           // their numbers outside
    std::vector<std::vector<std::uint32_t>> at_;                 // edges of each node
    std::vector<char> used_;
    std::vector<std::size_t> next_;
    std::size_t drawn_ = 0;
};

/// Finds the nearest end of a path that is not taken yet.
class NearestEnds {
public:
    NearestEnds(const std::vector<FigurePath>& paths, const Box& box) : paths_(paths) {
        const double size = std::max({box.breadth(), box.height(), 1e-300});
        const double across = std::clamp(std::sqrt(static_cast<double>(paths.size())), 1.0, 1000.0);
        cell_ = size / across;
        low_ = box.low;
        columns_ = static_cast<std::int64_t>(across) + 1;
        buckets_.resize(static_cast<std::size_t>(columns_ * columns_));
        for (std::uint32_t i = 0; i < paths.size(); ++i) {
            bucket(paths[i].points.front()).push_back(2 * i);
            if (!paths[i].filled) bucket(paths[i].points.back()).push_back(2 * i + 1);
        }
        left_ = paths.size();
        taken_.assign(paths.size(), 0);
    }

    bool any() const { return left_ > 0; }
    /// 2 i for the start of path i, 2 i + 1 for its end; the path counts as taken.
    std::uint32_t take(Point from) {
        double best = HUGE_VAL;
        std::uint32_t found = 0;
        const std::int64_t x = place(from.x - low_.x), y = place(from.y - low_.y);
        for (std::int64_t ring = 0; ring <= columns_; ++ring) {
            if (best<HUGE_VAL&& static_cast<double>(ring - 1) * cell_> best) break;
            for (std::int64_t dx = -ring; dx <= ring; ++dx)
                for (std::int64_t dy = -ring; dy <= ring;
                     dy += std::abs(dx) == ring || ring == 0 ? 1 : 2 * ring)
                    look(x + dx, y + dy, from, best, found);
        }
        taken_[found / 2] = 1;
        --left_;
        return found;
    }

private:
    std::int64_t place(double offset) const {
        return std::clamp<std::int64_t>(static_cast<std::int64_t>(offset / cell_), 0, columns_ - 1);
    }
    std::vector<std::uint32_t>& bucket(Point point) {
        return buckets_[static_cast<std::size_t>(place(point.x - low_.x) * columns_ +
                                                 place(point.y - low_.y))];
    }
    void look(std::int64_t x, std::int64_t y, Point from, double& best, std::uint32_t& found) {
        if (x < 0 || y < 0 || x >= columns_ || y >= columns_) return;
        auto& ends = buckets_[static_cast<std::size_t>(x * columns_ + y)];
        std::erase_if(ends, [&](std::uint32_t end) { return taken_[end / 2] != 0; });
        for (const std::uint32_t end : ends) {
            const auto& points = paths_[end / 2].points;
            const double far = distance(from, end % 2 == 0 ? points.front() : points.back());
            if (far < best || (far == best && end < found)) {
                best = far;
                found = end;
            }
        }
    }

    const std::vector<FigurePath>& paths_;
    double cell_ = 1;
    Point low_;
    std::int64_t columns_ = 1;
    std::vector<std::vector<std::uint32_t>> buckets_;
    std::vector<char> taken_;
    std::size_t left_ = 0;
};

}  // namespace

double travel_of(const FigurePaths& figure) {
    double sum = 0;
    for (std::size_t i = 1; i < figure.paths.size(); ++i) {
        const FigurePath& before = figure.paths[i - 1];
        const Point from = before.filled ? before.points.front() : before.points.back();
        sum += distance(from, figure.paths[i].points.front());
    }
    return sum;
}

FigurePaths for_plotter(const FigurePaths& figure, double grid, const Budget& budget,
                        FigureTextDrawn& drawn) {
    FigurePaths result;
    // Pens differ by colour and width; who drew a stroke is nothing to them.
    std::vector<std::uint32_t> pen_of;
    for (PathStyle style : figure.styles) {
        style.letter.clear();
        const auto found = std::ranges::find(result.styles, style);
        pen_of.push_back(static_cast<std::uint32_t>(found - result.styles.begin()));
        if (found == result.styles.end()) result.styles.push_back(style);
    }
    NumberedPlaces places(grid);
    Point pen;
    for (std::uint32_t style = 0; style < result.styles.size(); ++style) {
        budget.check();
        Trails trails;
        std::vector<FigurePath> paths;
        Box box;
        for (const FigurePath& path : figure.paths) {
            if (pen_of[path.style] != style) continue;
            for (const Point point : path.points) box.add(point);
            if (path.filled) {
                paths.push_back({style, true, path.points, {}});
                ++result.polygons;
                continue;
            }
            std::uint32_t from = places.number(path.points.front());
            for (std::size_t i = 1; i < path.points.size(); ++i) {
                const std::uint32_t to = places.number(path.points[i]);
                if (from != to && trails.add(from, to))
                    ++result.strokes;
                else
                    ++drawn.repeated;
                from = to;
            }
        }
        for (const auto& trail : trails.found()) {
            FigurePath& path = paths.emplace_back();
            path.style = style;
            for (const std::uint32_t node : trail) path.points.push_back(places.points[node]);
        }
        NearestEnds ends(paths, box);
        if (style == 0 && !paths.empty()) pen = paths.front().points.front();
        while (ends.any()) {
            const std::uint32_t end = ends.take(pen);
            FigurePath path = std::move(paths[end / 2]);
            paths[end / 2].points = {path.points.front(), path.points.back()};  // for the search
            if (end % 2 == 1) std::ranges::reverse(path.points);
            pen = path.filled ? path.points.front() : path.points.back();
            result.paths.push_back(std::move(path));
        }
    }
    return result;
}

}  // namespace algae
