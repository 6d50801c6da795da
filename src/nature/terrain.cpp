#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "nature/detail/figures.hpp"
#include "nature/detail/height_field.hpp"
#include "watch/watch.hpp"

// Landscapes: a random surface with water up to some height, as a map, as contour lines, as a
// coast, as a grid and as a solid.
//
// Colours follow from heights relative to the lowest point, the water and the highest point. The
// map is lit from the north-west, as usual on maps (Horn 1981), with slopes exaggerated as if the
// land were a third as high as it is wide. Colours are rounded in steps too small to be seen, so
// that squares side by side often have the same one and become one rectangle. Rectangles reach one
// square further to the right and upward and are covered by what comes there, so that no seams
// show.
//
// The coast is the contour line at the height of the water, and what is measured of a landscape:
// its dimension is 2 - H almost surely where the surface is exact.

namespace algae {

namespace {

/// The heights of a landscape that its colours depend on.
struct Relief {
    double low = 0, water = 0, high = 1;  // the lowest, the water's, the highest
};

struct Stop {
    double share;
    Colour colour;
};

constexpr std::array<Stop, 3> sea{
    {{0, {0.09, 0.23, 0.42}}, {0.7, {0.24, 0.48, 0.68}}, {1, {0.55, 0.76, 0.85}}}};

constexpr std::array<Stop, 8> land{{{0, {0.87, 0.82, 0.63}},
                                    {0.04, {0.62, 0.72, 0.42}},
                                    {0.25, {0.33, 0.55, 0.28}},
                                    {0.5, {0.45, 0.52, 0.27}},
                                    {0.65, {0.55, 0.45, 0.32}},
                                    {0.8, {0.56, 0.53, 0.50}},
                                    {0.88, {0.93, 0.94, 0.96}},
                                    {1, {1, 1, 1}}}};

template <std::size_t count>
Colour between(const std::array<Stop, count>& stops, double share) {
    std::size_t i = 1;
    while (i + 1 < count && stops[i].share < share) ++i;
    const Stop &a = stops[i - 1], &b = stops[i];
    return mixed(a.colour, b.colour, std::clamp((share - a.share) / (b.share - a.share), 0.0, 1.0));
}

/// In steps that nobody sees, so that neighbours have the same colour more often.
Colour rounded(const Colour& colour, double light) {
    const auto part = [&](double value) {
        return std::round(std::clamp(value * light, 0.0, 1.0) * 51) / 51;
    };
    return {part(colour.red), part(colour.green), part(colour.blue)};
}

/// The colour of a height: blue below the water, darker where it is deep; sand, green, brown, grey
/// and snow above it.
Colour relief_colour(const Relief& relief, double height) {
    if (height < relief.water)
        return between(sea, (height - relief.low) / std::max(relief.water - relief.low, 1e-300));
    return between(land, (height - relief.water) / std::max(relief.high - relief.water, 1e-300));
}

/// A map of the squares of a surface, in the colours of their mean heights, lit from the upper left
/// as usual on maps (Horn, Hill shading and the reflectance map, 1981); water is flat. Neighbours
/// of one colour are one rectangle.
std::vector<Path> relief_map(const HeightField& field, const Relief& relief, const Budget& budget) {
    std::vector<Path> made;
    const double spacing = field.spacing();
    const std::size_t squares = field.side - 1;
    // Slopes seem as steep as if the land were a third as high as it is wide.
    const double exaggeration = 1 / (3 * std::max(relief.high - relief.low, 1e-300));
    const auto colour = [&](std::size_t column, std::size_t row) {
        const double a = field.at(column, row), b = field.at(column + 1, row);
        const double c = field.at(column, row + 1), d = field.at(column + 1, row + 1);
        const double mean = (a + b + c + d) / 4;
        if (mean < relief.water) return rounded(relief_colour(relief, mean), 1);
        const double east = (b + d - a - c) / (2 * spacing) * exaggeration;
        const double north = (c + d - a - b) / (2 * spacing) * exaggeration;
        // Light from the north-west, 45 degrees high.
        const double cosine =
            (0.5 * east - 0.5 * north + 0.7071) / std::sqrt(1 + east * east + north * north);
        return rounded(relief_colour(relief, mean), 0.55 + 0.6 * std::max(cosine, 0.0));
    };
    const double reach = static_cast<double>(squares);
    WorkCount rows("row of the land", squares);
    for (std::size_t row = 0; row < squares; ++row) {
        budget.check();
        rows.at(row);
        for (std::size_t column = 0; column < squares;) {
            const Colour shade = colour(column, row);
            std::size_t end = column + 1;
            while (end < squares && colour(end, row) == shade) ++end;
            // One square further to the right and upward, to be covered by what comes there: so
            // there are no seams.
            const double left = spacing * static_cast<double>(column);
            const double right = spacing * std::min(static_cast<double>(end) + 1, reach);
            const double low = spacing * static_cast<double>(row);
            const double high = spacing * std::min(static_cast<double>(row) + 2, reach);
            made.push_back({.points = {{left, low}, {right, low}, {right, high}, {left, high}},
                            .filled = true,
                            .paint = shade});
            column = end;
        }
        budget.check_memory(made.size() * (sizeof(Path) + 80), "a map");
    }
    return made;
}

/// The squares of a surface as faces in space, two triangles each, in the colours of their heights;
/// what lies below the water is the water's surface. `shown` are drawn along an edge at most: of
/// finer surfaces every second, fourth, ... point.
Scene relief_scene(const HeightField& field, const Relief& relief, std::size_t shown,
                   const Budget& budget) {
    std::size_t every = 1;
    while ((field.side - 1) / every > shown && (field.side - 1) % (2 * every) == 0) every *= 2;
    const std::size_t squares = (field.side - 1) / every;
    budget.check_memory(squares * squares * 2 * (sizeof(Face) + 3 * sizeof(Vector)), "a landscape");
    Scene scene;
    const auto place = [&](std::size_t column, std::size_t row) -> Vector {
        return {field.spacing() * static_cast<double>(column * every),
                field.spacing() * static_cast<double>(row * every),
                std::max(field.at(column * every, row * every), relief.water) - relief.water};
    };
    const auto add = [&](std::size_t ax, std::size_t ay, std::size_t bx, std::size_t by,
                         std::size_t cx, std::size_t cy) {
        const double mean = (field.at(ax * every, ay * every) + field.at(bx * every, by * every) +
                             field.at(cx * every, cy * every)) /
                            3;
        Paint paint;
        paint.colour = relief_colour(relief, mean);
        const std::array<Vector, 3> corners{place(ax, ay), place(bx, by), place(cx, cy)};
        scene.add_face(corners, paint);
    };
    for (std::size_t row = 0; row < squares; ++row) {
        budget.check();
        for (std::size_t column = 0; column < squares; ++column) {
            add(column, row, column + 1, row, column + 1, row + 1);
            add(column, row, column + 1, row + 1, column, row + 1);
        }
    }
    return scene;
}

constexpr std::size_t shown_squares = 256;  // along an edge, in the solid view
constexpr std::size_t shown_lines = 64;     // of the grid

/// Of the views in their order.
constexpr const char* view_names[] = {"map", "contour lines", "solid view", "coast", "grid"};

Relief relief_of(const HeightField& field, double water) {
    const auto [low, high] = std::minmax_element(field.heights.begin(), field.heights.end());
    return {*low, height_at_share(field, water), *high};
}

std::vector<Path> lines_of(const std::vector<Stroke>& strokes, const Colour& paint, double width) {
    std::vector<Path> paths;
    for (const Stroke& stroke : strokes)
        paths.push_back({.points = stroke, .width = width, .paint = paint});
    return paths;
}

std::vector<Path> contours(const HeightField& field, const Relief& relief, std::uint64_t lines,
                           const Budget& budget) {
    std::vector<Path> paths;
    const auto add = [&](double height, const Colour& paint, double width) {
        std::ranges::move(lines_of(contour_lines(field, height, budget), paint, width),
                          std::back_inserter(paths));
    };
    for (std::uint64_t i = 1; i <= lines; ++i) {
        const double share = static_cast<double>(i) / static_cast<double>(lines + 1);
        const double height = relief.low + share * (relief.high - relief.low);
        Colour paint = relief_colour(relief, height);
        for (double* part : {&paint.red, &paint.green, &paint.blue}) *part *= 0.7;  // on white
        add(height, paint, 0.7);
    }
    add(relief.water, {0.05, 0.2, 0.4}, 1.6);
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
    for (std::size_t k = 0; k < field.side; k += every)
        for (const bool along : {true, false}) {
            Path& path = paths.emplace_back();
            for (std::size_t i = 0; i < field.side; i += every) {
                const Seen seen = projection(along ? place(i, k) : place(k, i));
                path.points.push_back({seen.x, seen.y});
            }
        }
    return paths;
}

}  // namespace

void Terrain::check() const {
    check_surface(surface);
    if (levels)
        for (const int level : {levels->first, levels->second})
            check_surface({surface.hurst, surface.sigma, level});
    require(water >= 0 && water <= 1, "water: expected a share from 0 to 1, found {}", {water});
    require(lines <= 1000, "lines: expected 0 to 1000, found {}", {lines});
    require(!views.empty(), "view: expected map, contours, solid, coast or grid");
    check_camera(camera);
}

HeightField Terrain::field(int level, const Budget& budget) const {
    const BrownianMotion wanted{surface.hurst, surface.sigma, level};
    const Gaussians numbers(seed, 0);
    return exact ? exact_surface(wanted, numbers, budget) : diamond_square(wanted, numbers, budget);
}

std::vector<GeneratorFigure> Terrain::figures(const Budget& budget) const {
    check();
    std::vector<GeneratorFigure> made;
    const auto [first, last] = levels.value_or(std::pair(surface.levels, surface.levels));
    for (int level = first; level <= last; ++level) {
        const HeightField heights = field(level, budget);
        const Relief relief = relief_of(heights, water);
        for (const View view : views) {
            const std::string what = view_names[static_cast<std::size_t>(view)];
            std::unique_ptr<Figure> figure;
            if (view == View::solid) {
                ViewChoices choices;
                choices.camera = camera;
                figure = std::make_unique<SpaceView>(
                    relief_scene(heights, relief, shown_squares, budget), style, SceneFacts{},
                    choices, budget);
            } else {
                figure = std::make_unique<PathFigure>(
                    view == View::map        ? relief_map(heights, relief, budget)
                    : view == View::contours ? contours(heights, relief, lines, budget)
                    : view == View::grid
                        ? grid(heights, camera)
                        : lines_of(contour_lines(heights, relief.water, budget), {}, 1),
                    style);
            }
            std::string caption = views.size() > 1 ? what : fmt::format("H = {}", surface.hurst);
            if (levels)
                caption = fmt::format("{} by {} squares", heights.side - 1, heights.side - 1);
            made.push_back({std::move(figure), heading() + ", " + what, caption});
        }
    }
    return made;
}

GeneratorFigure Terrain::measured_figure(const Budget& budget) const {
    check();
    const HeightField heights = field(surface.levels, budget);
    std::vector<Stroke> coast = contour_lines(heights, height_at_share(heights, water), budget);
    require(!coast.empty(), "{}: there is no coast, as there is no water or no land", {name});
    return pictured(*this, lines_of(coast, {}, 1), "coast");
}

std::vector<GeneratorFact> Terrain::facts(const Budget& budget) const {
    check();
    const HeightField heights = field(surface.levels, budget);
    const Relief relief = relief_of(heights, water);
    const std::vector<Stroke> coast = contour_lines(heights, relief.water, budget);
    double total = 0;
    std::size_t closed = 0;
    for (const Stroke& line : coast) {
        closed += line.front() == line.back() ? 1 : 0;
        for (std::size_t i = 1; i < line.size(); ++i) total += distance(line[i], line[i - 1]);
    }
    std::vector<GeneratorFact> found;
    found.push_back({"method", exact ? "exact" : "midpoint displacement of squares",
                     exact ? "exact" : "midpoint"});
    found.push_back({"points", fmt::format("{} by {}", heights.side, heights.side), heights.side});
    found.push_back({"seed", std::to_string(seed), seed});
    found.push_back(
        {"heights",
         fmt::format("{:.6g} to {:.6g}, water at {:.6g}", relief.low, relief.high, relief.water),
         {{"low", relief.low}, {"high", relief.high}, {"water", relief.water}}});
    found.push_back({"coast",
                     fmt::format("{}, {} of them closed, {:.6g} long at this spacing",
                                 counted(coast.size(), "line"), closed, total),
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
    made.name = heading();
    return made;
}

}  // namespace algae
