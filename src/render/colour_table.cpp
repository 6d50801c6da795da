#include "render/colour_table.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace algae {
namespace {

constexpr std::size_t most_colours = 256;

/// A colour of the pictures and how much it counts.
struct Shade {
    std::uint32_t colour;
    double weight;
    double part(std::size_t i) const { return (colour >> (16 - 8 * i)) & 0xff; }
};

/// A run of shades that become one colour of the table.
struct Group {
    std::size_t first, last;
    std::array<double, 3> mean{};
    std::size_t widest = 0;  // the part, red, green or blue, with the largest error
    double error = 0;        // the sum of squares of the distances from the mean

    Group(const std::vector<Shade>& shades, std::size_t from, std::size_t to)
        : first(from), last(to) {
        double weight = 0;
        for (std::size_t at = first; at < last; ++at) {
            weight += shades[at].weight;
            for (std::size_t i = 0; i < 3; ++i) mean[i] += shades[at].weight * shades[at].part(i);
        }
        for (double& part : mean) part /= weight;
        std::array<double, 3> errors{};
        for (std::size_t at = first; at < last; ++at)
            for (std::size_t i = 0; i < 3; ++i) {
                const double distance = shades[at].part(i) - mean[i];
                errors[i] += shades[at].weight * distance * distance;
            }
        widest = static_cast<std::size_t>(std::max_element(errors.begin(), errors.end()) -
                                          errors.begin());
        error = last - first > 1 ? errors[0] + errors[1] + errors[2] : 0;
    }

    std::uint32_t colour() const {
        std::uint32_t packed = 0;
        for (const double part : mean)
            packed = packed << 8 | static_cast<std::uint32_t>(std::lround(part));
        return packed;
    }
};

}  // namespace

void ColourTable::count(std::span<const std::uint32_t> pixels) {
    constexpr std::uint32_t full = std::numeric_limits<std::uint32_t>::max();
    for (const std::uint32_t pixel : pixels) {
        std::uint32_t& cell = table_[pixel & 0xffffffu];
        if (cell != full) ++cell;
    }
}

void ColourTable::choose() {
    std::vector<Shade> shades;
    for (std::size_t colour = 0; colour < table_.size(); ++colour)
        if (table_[colour] > 0)
            shades.push_back({static_cast<std::uint32_t>(colour),
                              std::sqrt(static_cast<double>(table_[colour]))});
    if (shades.empty()) shades.push_back({0, 1});
    exact_ = shades.size() <= most_colours;
    const auto put = [this](std::uint32_t colour) {
        colours_.push_back(colour);
        return static_cast<std::uint32_t>(colours_.size() - 1);
    };
    if (exact_) {
        for (const Shade& shade : shades) table_[shade.colour] = put(shade.colour);
        return;
    }
    const auto most = std::max_element(
        shades.begin(), shades.end(),
        [](const Shade& left, const Shade& right) { return left.weight < right.weight; });
    table_[most->colour] = put(most->colour);
    shades.erase(most);
    std::vector<Group> groups{Group(shades, 0, shades.size())};
    while (groups.size() < most_colours - 1) {
        const auto worst = std::max_element(
            groups.begin(), groups.end(),
            [](const Group& left, const Group& right) { return left.error < right.error; });
        if (worst->error == 0) break;
        const std::size_t part = worst->widest, first = worst->first, last = worst->last;
        const double mean = worst->mean[part];
        const auto middle =
            std::stable_partition(shades.begin() + static_cast<std::ptrdiff_t>(first),
                                  shades.begin() + static_cast<std::ptrdiff_t>(last),
                                  [&](const Shade& shade) { return shade.part(part) <= mean; });
        const auto cut = static_cast<std::size_t>(middle - shades.begin());
        *worst = Group(shades, first, cut);
        groups.emplace_back(shades, cut, last);
    }
    for (const Group& group : groups) {
        const std::uint32_t place = put(group.colour());
        for (std::size_t at = group.first; at < group.last; ++at) table_[shades[at].colour] = place;
    }
}

}  // namespace algae
