#include "nature/height_field.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdint>

#include "base/error.hpp"
#include "nature/fourier.hpp"

namespace algae {

namespace {

/// The covariance of the periodic field at a distance, in units in which the surface's diagonal is at
/// most 1; it is 0 from `range` on (Stein 2002, formulas 5 to 9).
class Embedding {
public:
    explicit Embedding(double hurst) : exponent_(2 * hurst) {
        if (exponent_ <= 1.5) {
            parabola = exponent_ / 2;
            constant_ = 1 - exponent_ / 2;
            return;
        }
        range = 2;
        tail_ = exponent_ * (2 - exponent_) / (3 * range * (range * range - 1));
        parabola = (exponent_ - tail_ * (range - 1) * (range - 1) * (range + 2)) / 2;
        constant_ = tail_ * std::pow(range - 1, 3) + 1 - parabola;
    }
    double operator()(double distance) const {
        if (distance <= 1)
            return constant_ - std::pow(distance, exponent_) + parabola * distance * distance;
        return distance < range ? tail_ * std::pow(range - distance, 3) / distance : 0;
    }

    double range = 1, parabola = 0;

private:
    double exponent_, tail_ = 0, constant_ = 0;
};

}  // namespace

void check_surface(const BrownianMotion& surface) {
    check_parameters(surface);
    if (surface.levels > most_surface_levels)
        throw Error(fmt::format("levels: expected 0 to {} for a surface, found {}",
                                most_surface_levels, surface.levels));
}

HeightField diamond_square(const BrownianMotion& surface, const Gaussians& numbers,
                           const Budget& budget) {
    check_surface(surface);
    const std::size_t squares = std::size_t{1} << surface.levels, last = squares;
    HeightField field{squares + 1, {}};
    budget.check_memory(field.side * field.side * sizeof(double), "a surface");
    field.heights.resize(field.side * field.side);
    std::uint64_t number = 0;
    for (const std::size_t row : {std::size_t{0}, last})
        for (const std::size_t column : {std::size_t{0}, last})
            field.at(column, row) = surface.sigma * numbers.at(number++);
    const auto deviation = [&](int half_step) {
        return surface.sigma * std::sqrt(std::exp2(-surface.hurst * half_step) *
                                         (1 - std::exp2(2 * surface.hurst - 2)));
    };
    for (int level = 1; level <= surface.levels; ++level) {
        const std::size_t half = squares >> level, edge = 2 * half;
        const double of_centres = deviation(2 * level - 1), of_edges = deviation(2 * level);
        for (std::size_t row = half; row < last; row += edge) {
            budget.check();
            for (std::size_t column = half; column < last; column += edge)
                field.at(column, row) =
                    (field.at(column - half, row - half) + field.at(column + half, row - half) +
                     field.at(column - half, row + half) + field.at(column + half, row + half)) /
                        4 +
                    of_centres * numbers.at(number++);
        }
        for (std::size_t row = 0; row <= last; row += half) {
            budget.check();
            for (std::size_t column = row / half % 2 == 0 ? half : 0; column <= last;
                 column += edge) {
                double sum = 0;
                int around = 0;
                const auto add = [&](std::size_t x, std::size_t y) {
                    sum += field.at(x, y);
                    ++around;
                };
                if (column >= half) add(column - half, row);
                if (column + half <= last) add(column + half, row);
                if (row >= half) add(column, row - half);
                if (row + half <= last) add(column, row + half);
                field.at(column, row) = sum / around + of_edges * numbers.at(number++);
            }
        }
    }
    return field;
}

HeightField exact_surface(const BrownianMotion& surface, const Gaussians& numbers,
                          const Budget& budget) {
    check_surface(surface);
    const Embedding covariance(surface.hurst);
    const std::size_t squares = std::size_t{1} << surface.levels;
    // The surface has the edge 1/2 here, so that its diagonal is below 1.
    const std::size_t period = squares * (covariance.range > 1 ? 8 : 4);
    const double spacing = 0.5 / static_cast<double>(squares);
    budget.check_memory(period * period * sizeof(std::complex<double>), "a surface");
    std::vector<std::complex<double>> values(period * period);
    const auto around = [&](std::size_t i) {
        return spacing * static_cast<double>(std::min(i, period - i));
    };
    for (std::size_t row = 0; row < period; ++row) {
        budget.check();
        for (std::size_t column = 0; column < period; ++column)
            values[row * period + column] = covariance(std::hypot(around(column), around(row)));
    }
    fourier_transform_square(values, period);
    budget.check();
    for (std::size_t i = 0; i < values.size(); ++i) {
        const double share = std::max(values[i].real(), 0.0) / static_cast<double>(values.size());
        values[i] = std::sqrt(share) * std::complex(numbers.at(2 * i + 2), numbers.at(2 * i + 3));
    }
    budget.check();
    fourier_transform_square(values, period);
    HeightField field{squares + 1, {}};
    field.heights.resize(field.side * field.side);
    // var(X(p) - X(q)) is 2 |p - q|^(2H) here, and lengths are half of those wanted.
    const double scale = surface.sigma * std::sqrt(std::exp2(2 * surface.hurst) / 2);
    const double slope = std::sqrt(2 * covariance.parabola) * spacing;
    for (std::size_t row = 0; row < field.side; ++row)
        for (std::size_t column = 0; column < field.side; ++column)
            field.at(column, row) =
                scale * (values[row * period + column].real() - values[0].real() +
                         slope * (static_cast<double>(column) * numbers.at(0) +
                                  static_cast<double>(row) * numbers.at(1)));
    return field;
}

double height_at_share(const HeightField& field, double share) {
    if (!(share >= 0 && share <= 1) || field.heights.empty())
        throw Error(fmt::format("expected a share from 0 to 1 of a surface, found {}", share));
    std::vector<double> sorted = field.heights;
    const auto place = static_cast<std::ptrdiff_t>(share * static_cast<double>(sorted.size() - 1));
    std::nth_element(sorted.begin(), sorted.begin() + place, sorted.end());
    return sorted[static_cast<std::size_t>(place)];
}

}  // namespace algae
