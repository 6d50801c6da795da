#include "dimension/grid.hpp"

namespace algae {

std::vector<Point> even_offsets(std::size_t count) {
    constexpr double plastic = 1.32471795724474602596;  // x^3 = x + 1
    std::vector<Point> places;
    double x = 0, y = 0;
    for (std::size_t i = 0; i < count; ++i) {
        x = std::fmod(x + 1 / plastic, 1);
        y = std::fmod(y + 1 / (plastic * plastic), 1);
        places.push_back({x, y});
    }
    return places;
}

}  // namespace algae
