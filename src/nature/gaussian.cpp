#include "nature/gaussian.hpp"

#include <cmath>
#include <numbers>

namespace algae {

double Gaussians::at(std::uint64_t position) const {
    const std::uint64_t first = position & ~std::uint64_t{1};
    const double radius = std::sqrt(-2 * std::log(unit_interval(draws_.at(first))));
    const double angle = 2 * std::numbers::pi * unit_interval(draws_.at(first + 1));
    return radius * (position == first ? std::cos(angle) : std::sin(angle));
}

}  // namespace algae
