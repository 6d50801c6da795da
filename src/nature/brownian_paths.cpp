#include "nature/brownian_paths.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "nature/graph_path.hpp"
#include "nature/path_figure.hpp"

namespace algae {

void BrownianPaths::check() const {
    if (hurst.empty()) throw Error("hurst: expected a number between 0 and 1, found none");
    for (const double h : hurst)
        for (const int level : {levels.first, levels.second}) check_parameters({h, sigma, level});
    if (dimensions < 1 || dimensions > 3)
        throw Error(fmt::format("dimensions: expected 1, 2 or 3, found {}", dimensions));
}

std::vector<std::vector<double>> BrownianPaths::coordinates(double h, int level,
                                                            const Budget& budget) const {
    std::vector<std::vector<double>> made;
    for (int k = 0; k < dimensions; ++k) {
        const Gaussians numbers(seed, static_cast<std::uint64_t>(k));
        made.push_back(exact ? exact_path({h, sigma, level}, numbers, budget)
                             : midpoint_path({h, sigma, level}, numbers, budget));
    }
    return made;
}

std::vector<Vector> BrownianPaths::places(double h, int level, const Budget& budget) const {
    const auto of = coordinates(h, level, budget);
    std::vector<Vector> made(of[0].size());
    for (std::size_t i = 0; i < made.size(); ++i)
        made[i] = {of[0][i], of[1][i], dimensions > 2 ? of[2][i] : 0};
    return made;
}

std::vector<RelativeFigure> BrownianPaths::figures(const Budget& budget) const {
    check();
    std::vector<RelativeFigure> made;
    for (const double h : hurst)
        for (int level = levels.first; level <= levels.second; ++level) {
            std::vector<Path> paths(1);
            if (dimensions == 1) {
                paths[0].points = graph_path(coordinates(h, level, budget)[0], 2);
            } else {
                const std::vector<Vector> all = places(h, level, budget);
                if (dimensions == 2)
                    for (const Vector& place : all) paths[0].points.push_back({place.x, place.y});
                else
                    paths[0].points = seen_path(all);
            }
            std::string caption = fmt::format("H = {}", h);
            if (levels.first != levels.second)
                caption = fmt::format("{}{}{} displacement{}", hurst.size() > 1 ? caption : "",
                                      hurst.size() > 1 ? ", " : "", level, level == 1 ? "" : "s");
            made.push_back({std::make_unique<PathFigure>(std::move(paths), settings),
                            (title.empty() ? name : title) + ", " + caption, caption});
        }
    return made;
}

std::vector<RelativeFact> BrownianPaths::facts(const Budget& budget) const {
    check();
    std::vector<RelativeFact> found;
    found.push_back({"method", exact ? "exact, by circulant embedding" : "midpoint displacement",
                     exact ? "exact" : "midpoint"});
    found.push_back({"seed", std::to_string(seed), seed});
    for (const double h : hurst) {
        const std::string of = hurst.size() > 1 ? fmt::format("_for_H_{}", h) : "";
        const double dimension = dimensions == 1 ? 2 - h : std::min(1 / h, 1.0 * dimensions);
        found.push_back({"dimension" + of,
                         dimensions == 1
                             ? fmt::format("2 - H = {:.6g} almost surely, of the graph", dimension)
                             : fmt::format("min(1/H, {}) = {:.6g} almost surely, of the path",
                                           dimensions, dimension),
                         dimension});
        if (levels.second >= 3) {
            const double estimate = estimated_hurst(coordinates(h, levels.second, budget)[0]);
            found.push_back(
                {"estimated_H" + of,
                 fmt::format("{:.4f}, from second differences of the first coordinate", estimate),
                 estimate});
        }
        if (exact || levels.second < 2) continue;
        const BrownianMotion two{h, sigma, 2};
        const double wanted = sigma * sigma * std::exp2(-2 * h);
        const double middle = midpoint_increment_variance(two, 1, 3);
        found.push_back(
            {"variance_over_half_the_time" + of,
             fmt::format("{:.6g} at the beginning and {:.6g} in the middle; {}",
                         midpoint_increment_variance(two, 0, 2), middle,
                         h == 0.5 ? "the same, as it should be"
                                  : fmt::format("fractional Brownian motion has {:.6g} everywhere",
                                                wanted)),
             {{"beginning", midpoint_increment_variance(two, 0, 2)},
              {"middle", middle},
              {"wanted", wanted}}});
    }
    return found;
}

std::optional<Scene> BrownianPaths::scene(const Budget& budget) const {
    check();
    if (dimensions != 3) return std::nullopt;
    Scene made = path_scene(places(hurst.back(), levels.second, budget), settings);
    made.name = title.empty() ? name : title;
    return made;
}

}  // namespace algae
