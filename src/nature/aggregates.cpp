#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <unordered_set>

#include "nature/detail/aggregates.hpp"
#include "nature/detail/figures.hpp"
#include "watch/watch.hpp"

// Pictures of a growing cluster, and its dimension by the radius of gyration.
//
// Each particle is drawn as a link from the one that it came to touch, coloured by age. Of a
// cluster on the grid, where a particle may touch several, the link goes to the first of the
// neighbours that was there before it.
//
// The radius of gyration R of the first n particles grows as n^(1/D). D is the slope of log n
// against log R by least squares, over doublings of n up to the whole cluster.

namespace algae {

namespace {

constexpr std::uint32_t shades = 64;

/// From a dark blue over green to a light yellow, evenly light (after the map viridis).
std::vector<std::string> shades_of_age() {
    constexpr Colour stops[] = {{0.267, 0.005, 0.329}, {0.254, 0.265, 0.530},
                                {0.164, 0.471, 0.558}, {0.135, 0.659, 0.518},
                                {0.478, 0.821, 0.318}, {0.890, 0.830, 0.130}};
    const auto byte = [](double part) { return static_cast<int>(std::lround(255 * part)); };
    std::vector<std::string> found;
    for (std::uint32_t i = 0; i < shades; ++i) {
        const double at = 5.0 * i / (shades - 1);
        const auto k = std::min<std::size_t>(static_cast<std::size_t>(at), 4);
        const Colour shade = mixed(stops[k], stops[k + 1], at - static_cast<double>(k));
        found.push_back(fmt::format("#{:02x}{:02x}{:02x}", byte(shade.red), byte(shade.green),
                                    byte(shade.blue)));
    }
    return found;
}

Point point(const GridCell& cell) {
    return {static_cast<double>(cell.x), static_cast<double>(cell.y)};
}

/// The cells, each from an earlier one beside it.
std::vector<Link> joined(const std::vector<GridCell>& cells) {
    const auto key = [](const GridCell& cell) {
        return static_cast<std::uint64_t>(static_cast<std::uint32_t>(cell.x)) << 32 |
               static_cast<std::uint32_t>(cell.y);
    };
    std::unordered_set<std::uint64_t> earlier;
    earlier.reserve(cells.size());
    std::vector<Link> links;
    links.reserve(cells.size());
    for (const GridCell& cell : cells) {
        Link link{point(cell), point(cell)};
        for (const auto& [x, y] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
            const GridCell beside{cell.x + x, cell.y + y};
            if (!earlier.contains(key(beside))) continue;
            link.from = point(beside);
            break;
        }
        earlier.insert(key(cell));
        links.push_back(link);
    }
    return links;
}

}  // namespace

void Aggregates::check() const {
    require(!particles.empty(), "particles: expected at least one number");
    for (const std::uint64_t count : particles)
        require(count > 0 && count <= most, "particles: expected 1 to {}, found {}", {most, count});
    require(!off_lattice || !region, "region: clusters off the lattice have none");
    require(!by_steps || region, "steps: expected a region, which single steps need");
    GridAggregate::checked(region);
}

const std::vector<Link>& Aggregates::links(std::uint64_t count, const Budget& budget) const {
    if (kept_count_ != count || count == 0) kept_ = grown(count, budget);
    kept_count_ = count;
    return kept_;
}

std::vector<Link> Aggregates::grown(std::uint64_t count, const Budget& budget) const {
    check();
    budget.check_memory(count * (sizeof(Link) + 40), "an aggregate");
    WorkCount joining("particle", count);
    if (off_lattice) {
        FreeAggregate cluster(seed, budget);
        for (std::uint64_t i = 0; i < count; ++i, ++joining) cluster.grow();
        std::vector<Link> found;
        found.reserve(count + 1);
        for (std::size_t i = 0; i < cluster.centres().size(); ++i)
            found.push_back({cluster.centres()[cluster.touched()[i]], cluster.centres()[i]});
        return found;
    }
    GridAggregate cluster(seed, region, budget);
    for (std::uint64_t i = 0; i < count && !(region && stop_at_border && cluster.fills_region());
         ++i, ++joining)
        by_steps ? cluster.grow_by_steps() : cluster.grow();
    return joined(cluster.cells());
}

std::vector<GeneratorFigure> Aggregates::figures(const Budget& budget) const {
    check();
    const auto& all = links(*std::max_element(particles.begin(), particles.end()), budget);
    FigureStyle drawn = style;
    if (drawn.colours.empty()) drawn.colours = shades_of_age();
    std::vector<GeneratorFigure> made;
    for (const std::uint64_t wanted : particles) {
        const std::uint64_t count = std::min<std::uint64_t>(wanted, all.size() - 1);
        std::vector<Link> part(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(count) + 1);
        for (std::size_t i = 0; i < part.size(); ++i)
            part[i].colour = static_cast<std::uint32_t>(i * drawn.colours.size() / part.size());
        made.push_back(pictured(
            *this, std::make_unique<LinkFigure>(std::move(part), off_lattice ? 0.9 : 0.7, 1, drawn),
            fmt::format("{} particles", count)));
    }
    return made;
}

std::vector<GeneratorFact> Aggregates::facts(const Budget& budget) const {
    const auto& all = links(*std::max_element(particles.begin(), particles.end()), budget);
    double radius = 0;
    for (const Link& link : all) radius = std::max(radius, std::hypot(link.to.x, link.to.y));
    std::vector<GeneratorFact> found;
    found.push_back({"particles", std::to_string(all.size() - 1), all.size() - 1});
    found.push_back({"seed", std::to_string(seed), seed});
    found.push_back({"grown",
                     off_lattice ? "off the lattice"
                     : by_steps  ? "on the square grid, step by step"
                                 : "on the square grid, by jumps",
                     off_lattice ? "off lattice"
                     : by_steps  ? "steps"
                                 : "jumps"});
    if (region)
        found.push_back(
            {"region", fmt::format("{} by {} cells", 2 * *region + 1, 2 * *region + 1), *region});
    found.push_back({"radius", fmt::format("{:.6g}", radius), radius});
    if (const auto dimension = gyration_dimension(all, 8))
        found.push_back(
            {"dimension_by_radius_of_gyration",
             fmt::format("{:.4f}, over the last doublings of the particles", *dimension),
             *dimension});
    return found;
}

std::optional<double> gyration_dimension(const std::vector<Link>& links, std::size_t doublings) {
    // Sums up to each particle give the radius about the centre of mass.
    std::vector<std::size_t> counts;
    for (std::size_t count = links.size(); count >= 16 && counts.size() <= doublings; count /= 2)
        counts.push_back(count);
    if (counts.size() < 4) return std::nullopt;
    std::reverse(counts.begin(), counts.end());
    double x = 0, y = 0, squares = 0;
    std::size_t next = 0;
    std::vector<Point> points;
    for (std::size_t i = 0; i < links.size() && next < counts.size(); ++i) {
        const Point at = links[i].to;
        x += at.x, y += at.y, squares += at.x * at.x + at.y * at.y;
        if (i + 1 != counts[next]) continue;
        const double n = static_cast<double>(i + 1);
        const double gyration = squares / n - (x * x + y * y) / (n * n);
        points.push_back({std::log(gyration) / 2, std::log(n)});
        ++next;
    }
    const BestLine line = best_line(points);
    if (line.is_level) return std::nullopt;
    return line.slope;
}

}  // namespace algae
