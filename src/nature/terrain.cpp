#include "nature/terrain.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "dimension/divider.hpp"
#include "nature/contour.hpp"
#include "nature/path_figure.hpp"
#include "nature/relief.hpp"
#include "space/view.hpp"

namespace algae {

namespace {

constexpr std::size_t shown_squares = 256;  // along an edge, in the solid view
constexpr std::size_t shown_lines = 64;     // of the grid

Relief relief_of(const HeightField& field, double water) {
    const auto [low, high] = std::minmax_element(field.heights.begin(), field.heights.end());
    return {*low, height_at_share(field, water), *high};
}

std::vector<Path> lines_of(const std::vector<Stroke>& strokes, const Colour& paint, double width) {
    std::vector<Path> paths;
    for (const Stroke& stroke : strokes) {
        Path path;
        path.points = stroke;
        path.paint = paint;
        path.width = width;
        paths.push_back(std::move(path));
    }
    return paths;
}

void append(std::vector<Path>& to, std::vector<Path> from) {
    to.insert(to.end(), std::make_move_iterator(from.begin()), std::make_move_iterator(from.end()));
}

std::vector<Path> contours(const HeightField& field, const Relief& relief, std::uint64_t lines,
                           const Budget& budget) {
    std::vector<Path> paths;
    for (std::uint64_t i = 1; i <= lines; ++i) {
        const double share = static_cast<double>(i) / static_cast<double>(lines + 1);
        const double height = relief.low + share * (relief.high - relief.low);
        Colour paint = relief_colour(relief, height);
        for (double* part : {&paint.red, &paint.green, &paint.blue}) *part *= 0.7;  // on white
        append(paths, lines_of(contour_lines(field, height, budget), paint, 0.7));
    }
    append(paths, lines_of(contour_lines(field, relief.water, budget), {0.05, 0.2, 0.4}, 1.6));
    return paths;
}

/// The lines of the grid in space, those farther away first.
std::vector<Path> grid(const HeightField& field, const Camera& camera) {
    std::size_t every = 1;
    while ((field.side - 1) / every > shown_lines) every *= 2;
    SpaceBox box;
    const auto place = [&](std::size_t column, std::size_t row) -> Vector {
        return {field.spacing() * static_cast<double>(column),
                field.spacing() * static_cast<double>(row), field.at(column, row)};
    };
    for (std::size_t i = 0; i < field.heights.size(); ++i)
        box.add(place(i % field.side, i / field.side));
    const Projection projection(camera, box);
    std::vector<Path> paths;
    const auto add = [&](auto at) {
        Path path;
        for (std::size_t i = 0; i < field.side; i += every) {
            const Seen seen = projection(at(i));
            path.points.push_back({seen.x, seen.y});
        }
        paths.push_back(std::move(path));
    };
    for (std::size_t k = 0; k < field.side; k += every) {
        add([&](std::size_t i) { return place(i, k); });
        add([&](std::size_t i) { return place(k, i); });
    }
    return paths;
}

}  // namespace

void Terrain::check() const {
    check_surface(surface);
    if (levels)
        for (const int level : {levels->first, levels->second})
            check_surface({surface.hurst, surface.sigma, level});
    if (!(water >= 0 && water <= 1))
        throw Error(fmt::format("water: expected a share from 0 to 1, found {}", water));
    if (lines > 1000) throw Error(fmt::format("lines: expected 0 to 1000, found {}", lines));
    if (views.empty()) throw Error("view: expected map, contours, solid, coast or grid");
    check_camera(camera);
}

HeightField Terrain::field(int level, const Budget& budget) const {
    const BrownianMotion wanted{surface.hurst, surface.sigma, level};
    const Gaussians numbers(seed, 0);
    return exact ? exact_surface(wanted, numbers, budget) : diamond_square(wanted, numbers, budget);
}

std::vector<RelativeFigure> Terrain::figures(const Budget& budget) const {
    check();
    std::vector<RelativeFigure> made;
    const auto [first, last] = levels.value_or(std::pair(surface.levels, surface.levels));
    for (int level = first; level <= last; ++level) {
        const HeightField heights = field(level, budget);
        const Relief relief = relief_of(heights, water);
        for (const View view : views) {
            std::unique_ptr<Figure> figure;
            std::string what;
            const auto paths = [&](std::vector<Path> drawn, const char* view_name) {
                figure = std::make_unique<PathFigure>(std::move(drawn), settings);
                what = view_name;
            };
            switch (view) {
                case View::map:
                    paths(relief_map(heights, relief, budget), "map");
                    break;
                case View::contours:
                    paths(contours(heights, relief, lines, budget), "contour lines");
                    break;
                case View::coast:
                    paths(lines_of(contour_lines(heights, relief.water, budget), {}, 1), "coast");
                    break;
                case View::grid:
                    paths(grid(heights, camera), "grid");
                    break;
                case View::solid: {
                    ViewChoices choices;
                    choices.camera = camera;
                    figure = std::make_unique<SpaceView>(
                        relief_scene(heights, relief, shown_squares, budget), settings,
                        SceneFacts{}, choices, budget);
                    what = "solid view";
                    break;
                }
            }
            std::string caption = views.size() > 1 ? what : fmt::format("H = {}", surface.hurst);
            if (levels)
                caption = fmt::format("{} by {} squares", heights.side - 1, heights.side - 1);
            made.push_back(
                {std::move(figure), (title.empty() ? name : title) + ", " + what, caption});
        }
    }
    return made;
}

RelativeFigure Terrain::measured_figure(const Budget& budget) const {
    check();
    const HeightField heights = field(surface.levels, budget);
    std::vector<Stroke> coast = contour_lines(heights, height_at_share(heights, water), budget);
    if (coast.empty()) throw Error(name + ": there is no coast, as there is no water or no land");
    return {std::make_unique<PathFigure>(lines_of(coast, {}, 1), settings),
            (title.empty() ? name : title) + ", coast", "coast"};
}

std::vector<RelativeFact> Terrain::facts(const Budget& budget) const {
    check();
    const HeightField heights = field(surface.levels, budget);
    const Relief relief = relief_of(heights, water);
    const std::vector<Stroke> coast = contour_lines(heights, relief.water, budget);
    double total = 0;
    std::size_t closed = 0;
    for (const Stroke& line : coast) {
        closed += line.front() == line.back() ? 1 : 0;
        for (std::size_t i = 1; i < line.size(); ++i)
            total += std::hypot(line[i].x - line[i - 1].x, line[i].y - line[i - 1].y);
    }
    std::vector<RelativeFact> found;
    found.push_back({"method", exact ? "exact" : "midpoint displacement of squares",
                     exact ? "exact" : "midpoint"});
    found.push_back({"points", fmt::format("{} by {}", heights.side, heights.side), heights.side});
    found.push_back({"seed", std::to_string(seed), seed});
    found.push_back(
        {"heights",
         fmt::format("{:.6g} to {:.6g}, water at {:.6g}", relief.low, relief.high, relief.water),
         {{"low", relief.low}, {"high", relief.high}, {"water", relief.water}}});
    found.push_back({"coast",
                     fmt::format("{} line{}, {} of them closed, {:.6g} long at this spacing",
                                 coast.size(), coast.size() == 1 ? "" : "s", closed, total),
                     {{"lines", coast.size()}, {"closed", closed}, {"length", total}}});
    found.push_back(
        {"dimension",
         fmt::format(
             "{:.6g} of the surface (3 - H) and {:.6g} of its coast (2 - H) almost surely{}",
             3 - surface.hurst, 2 - surface.hurst, exact ? "" : ", if the method were exact"),
         {{"surface", 3 - surface.hurst}, {"coast", 2 - surface.hurst}}});
    return found;
}

std::optional<Scene> Terrain::scene(const Budget& budget) const {
    check();
    const HeightField heights = field(surface.levels, budget);
    Scene made = relief_scene(heights, relief_of(heights, water), heights.side, budget);
    made.name = title.empty() ? name : title;
    return made;
}

}  // namespace algae
