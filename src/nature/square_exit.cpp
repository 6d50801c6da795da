#include "nature/square_exit.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "base/error.hpp"
#include "rewrite/draws.hpp"

namespace algae {

double square_exit_chance(std::int64_t r, std::int64_t y) {
    if (r < 1 || y <= -r || y >= r)
        throw Error("a side of a square: expected |y| < r, found r = " + std::to_string(r) +
                    " and y = " + std::to_string(y));
    const double n = 2 * static_cast<double>(r);
    double sum = 0, sign = 1;
    for (std::int64_t k = 1; k < 2 * r; k += 2, sign = -sign) {
        const double part = std::numbers::pi * static_cast<double>(k) / n;
        // cosh a = 2 - cos(part) = 1 + 2 sin(part / 2)^2, so sinh(a / 2) = sin(part / 2).
        const double growth = std::asinh(std::sin(part / 2)) * n;
        if (growth > 50) break;  // from here on all terms are below 1e-21
        sum += sign * std::sin(part * static_cast<double>(y + r)) / std::cosh(growth);
    }
    return std::max(sum / n, 0.0);
}

const SquareExits& SquareExits::tables() {
    static const SquareExits made;
    return made;
}

SquareExits::SquareExits() {
    for (int exponent = 0; exponent <= most; ++exponent) {
        const std::int64_t r = std::int64_t{1} << exponent;
        const std::size_t count = static_cast<std::size_t>(2 * r - 1);
        std::vector<double> share(count);  // of what each entry would have if all had the same
        double sum = 0;
        for (std::size_t i = 0; i < count; ++i)
            sum += share[i] = square_exit_chance(r, static_cast<std::int64_t>(i) + 1 - r);
        std::vector<std::uint32_t> poor, rich;
        for (std::size_t i = 0; i < count; ++i) {
            share[i] *= static_cast<double>(count) / sum;
            (share[i] < 1 ? poor : rich).push_back(static_cast<std::uint32_t>(i));
        }
        std::vector<Entry> table(count);
        for (std::size_t i = 0; i < count; ++i)
            table[i] = {std::uint64_t{1} << 62, static_cast<std::uint32_t>(i)};
        while (!poor.empty() && !rich.empty()) {
            const std::uint32_t taker = poor.back(), giver = rich.back();
            poor.pop_back();
            table[taker] = {static_cast<std::uint64_t>(share[taker] * 0x1p62), giver};
            share[giver] -= 1 - share[taker];
            if (share[giver] < 1) {
                rich.pop_back();
                poor.push_back(giver);
            }
        }
        tables_.push_back(std::move(table));
    }
}

SquareExits::Step SquareExits::at(int exponent, std::uint64_t first, std::uint64_t second) const {
    const std::vector<Entry>& table = tables_[static_cast<std::size_t>(exponent)];
    std::size_t entry = Draws::scaled(first, table.size());
    if (second >> 2 >= table[entry].threshold) entry = table[entry].other;
    const std::int64_t r = std::int64_t{1} << exponent;
    const std::int64_t along = static_cast<std::int64_t>(entry) + 1 - r;
    switch (second & 3) {
        case 0:
            return {r, along};
        case 1:
            return {-r, along};
        case 2:
            return {along, r};
        default:
            return {along, -r};
    }
}

}  // namespace algae
