#include "nature/occupancy.hpp"

namespace algae {

Occupancy::Occupancy(int half_exponent, const Budget& budget)
    : exponent_(half_exponent), half_(std::int64_t{1} << half_exponent) {
    const std::size_t cells = std::size_t{4} << (2 * exponent_);
    budget.check_memory(cells / 3, "the grid of an aggregate");
    for (int level = 0; level <= exponent_; ++level) {
        taken_.emplace_back((cells >> (2 * level)) / 64 + 1);
        near_.emplace_back((cells >> (2 * level)) / 64 + 1);
    }
}

void Occupancy::take(std::int64_t x, std::int64_t y) {
    const std::int64_t column = x + half_, row = y + half_;
    for (std::size_t level = 0; level < near_.size(); ++level) {
        const std::size_t here = index(static_cast<int>(level), column, row);
        if (bit(taken_[level], here)) break;  // then also on all coarser grids
        set(taken_[level], here);
        const std::int64_t side = std::int64_t{2} << (exponent_ - static_cast<int>(level));
        const std::int64_t c = column >> level, r = row >> level;
        for (std::int64_t y_near = r - 1; y_near <= r + 1; ++y_near)
            for (std::int64_t x_near = c - 1; x_near <= c + 1; ++x_near)
                if (x_near >= 0 && y_near >= 0 && x_near < side && y_near < side)
                    set(near_[level], static_cast<std::size_t>(y_near * side + x_near));
    }
}

}  // namespace algae
