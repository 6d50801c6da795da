#include "nature/random_walks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "nature/graph_path.hpp"
#include "nature/path_figure.hpp"

namespace algae {

namespace {

std::vector<Vector> longest(const RandomWalks& walks, const Budget& budget) {
    walks.check();
    RandomWalk walk = walks.walk;
    walk.steps = *std::max_element(walks.steps.begin(), walks.steps.end());
    return random_walk(walk, budget);
}

}  // namespace

void RandomWalks::check() const {
    if (steps.empty() || *std::min_element(steps.begin(), steps.end()) == 0)
        throw Error("steps: expected at least 1, found 0");
    RandomWalk short_walk = walk;
    short_walk.steps = 0;
    random_walk(short_walk, {});
}

std::vector<RelativeFigure> RandomWalks::figures(const Budget& budget) const {
    const std::vector<Vector> all = longest(*this, budget);
    std::vector<RelativeFigure> made;
    for (const std::uint64_t count : steps) {
        const std::vector<Vector> places(all.begin(),
                                         all.begin() + static_cast<std::ptrdiff_t>(count) + 1);
        Path path;
        if (walk.dimensions == 1) {
            std::vector<double> heights;
            for (const Vector& place : places) heights.push_back(place.x);
            path.points = graph_path(heights, 2);
        } else if (walk.dimensions == 2) {
            for (const Vector& place : places) path.points.push_back({place.x, place.y});
        } else {
            path.points = seen_path(places);
        }
        const std::string what =
            fmt::format("{} step{}, seed {}", count, count == 1 ? "" : "s", walk.seed);
        made.push_back({std::make_unique<PathFigure>(std::vector<Path>{std::move(path)}, settings),
                        (title.empty() ? name : title) + ", " + what, what});
    }
    return made;
}

std::vector<RelativeFact> RandomWalks::facts(const Budget& budget) const {
    const std::vector<Vector> all = longest(*this, budget);
    std::vector<RelativeFact> found;
    found.push_back({"dimensions", std::to_string(walk.dimensions), walk.dimensions});
    found.push_back({"seed", std::to_string(walk.seed), walk.seed});
    for (const std::uint64_t count : steps) {
        const Vector end = all[count];
        // Each of `count` steps adds the square of the deviation in each dimension.
        const double expected =
            walk.deviation * std::sqrt(static_cast<double>(count) * walk.dimensions);
        const double distance = length(end);
        found.push_back(
            {fmt::format("after_{}_steps", count),
             fmt::format(
                 "{:.6g} from the start; the root of the mean square of all walks is {:.6g}",
                 distance, expected),
             {{"distance", distance}, {"expected", expected}}});
    }
    return found;
}

std::optional<Scene> RandomWalks::scene(const Budget& budget) const {
    if (walk.dimensions != 3) return std::nullopt;
    Scene made = path_scene(longest(*this, budget), settings);
    made.name = title.empty() ? name : title;
    return made;
}

}  // namespace algae
