#include "render/palette.hpp"

#include <algorithm>

#include "system/colour.hpp"

namespace algae {

Palette::Palette(const std::vector<std::string>& colours, std::uint32_t hues) : hues_(hues) {
    for (const std::string& text : colours) {
        const bool along = text == "along";
        entries_.push_back({along ? Colour{} : colour_named(text), along});
        runs_along_ = runs_along_ || along;
    }
    if (entries_.empty()) entries_.push_back({});
}

std::uint32_t Palette::shade(std::uint32_t index, double position) const {
    const auto entry = static_cast<std::uint32_t>(index % entries_.size());
    if (!entries_[entry].along) return entry;
    const double step = std::clamp(position, 0.0, 1.0) * hues_;
    return static_cast<std::uint32_t>(entries_.size()) +
           std::min(static_cast<std::uint32_t>(step), hues_ - 1);
}

Colour Palette::colour(std::uint32_t shade) const {
    if (shade < entries_.size()) return entries_[shade].colour;
    return hue(360.0 * (shade - static_cast<double>(entries_.size())) / hues_);
}

}  // namespace algae
