#include "oracle/addresses.hpp"

#include <algorithm>
#include <cmath>

namespace oracle {

std::vector<std::pair<double, double>> addressed_points(const std::vector<Placed>& maps,
                                                        std::size_t length, double x, double y,
                                                        std::size_t state) {
    if (length == 0) return {{x, y}};
    std::vector<std::pair<double, double>> found;
    for (const Placed& map : maps) {
        if (map.from != state) continue;
        const auto& [a, b, c, d, e, f] = map.numbers;
        for (const auto& [px, py] : addressed_points(maps, length - 1, x, y, map.to))
            found.emplace_back(a * px + b * py + e, c * px + d * py + f);
    }
    return found;
}

double farthest_from(const std::vector<std::pair<double, double>>& first,
                     const std::vector<std::pair<double, double>>& second) {
    double farthest = 0;
    for (const auto& [x, y] : first) {
        double nearest = INFINITY;
        for (const auto& [u, v] : second) nearest = std::min(nearest, std::hypot(x - u, y - v));
        farthest = std::max(farthest, nearest);
    }
    return farthest;
}

}  // namespace oracle
