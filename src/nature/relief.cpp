#include "nature/relief.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace algae {

namespace {

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
    const double s = std::clamp((share - a.share) / (b.share - a.share), 0.0, 1.0);
    return {a.colour.red + s * (b.colour.red - a.colour.red),
            a.colour.green + s * (b.colour.green - a.colour.green),
            a.colour.blue + s * (b.colour.blue - a.colour.blue)};
}

/// In steps that nobody sees, so that neighbours have the same colour more often.
Colour rounded(const Colour& colour, double light) {
    const auto part = [&](double value) {
        return std::round(std::clamp(value * light, 0.0, 1.0) * 51) / 51;
    };
    return {part(colour.red), part(colour.green), part(colour.blue)};
}

}  // namespace

Colour relief_colour(const Relief& relief, double height) {
    if (height < relief.water)
        return between(sea, (height - relief.low) / std::max(relief.water - relief.low, 1e-300));
    return between(land, (height - relief.water) / std::max(relief.high - relief.water, 1e-300));
}

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
    for (std::size_t row = 0; row < squares; ++row) {
        budget.check();
        for (std::size_t column = 0; column < squares;) {
            const Colour shade = colour(column, row);
            std::size_t end = column + 1;
            while (end < squares && colour(end, row) == shade) ++end;
            // One square further to the right and upward, to be covered by what comes there: so there
            // are no seams.
            const double left = spacing * static_cast<double>(column);
            const double right = spacing * std::min(static_cast<double>(end) + 1, reach);
            const double low = spacing * static_cast<double>(row);
            const double high = spacing * std::min(static_cast<double>(row) + 2, reach);
            Path path;
            path.points = {{left, low}, {right, low}, {right, high}, {left, high}};
            path.filled = true;
            path.paint = shade;
            made.push_back(std::move(path));
            column = end;
        }
        budget.check_memory(made.size() * (sizeof(Path) + 80), "a map");
    }
    return made;
}

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

}  // namespace algae
