#include "oracle/cells.hpp"

namespace oracle {

Rows next_cells(const Rows& cells, const std::vector<std::pair<int, int>>& neighbours,
                const Next& next, int outside) {
    const int height = static_cast<int>(cells.size()), width = static_cast<int>(cells[0].size());
    const auto state = [&](int x, int y) {
        if (outside < 0)
            return cells[static_cast<std::size_t>(((y % height) + height) % height)]
                        [static_cast<std::size_t>(((x % width) + width) % width)];
        if (x < 0 || y < 0 || x >= width || y >= height) return outside;
        return cells[static_cast<std::size_t>(y)][static_cast<std::size_t>(x)];
    };
    Rows after = cells;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            std::vector<int> seen;
            for (const auto& [right, down] : neighbours) seen.push_back(state(x + right, y + down));
            after[static_cast<std::size_t>(y)][static_cast<std::size_t>(x)] = next(seen);
        }
    return after;
}

}  // namespace oracle
