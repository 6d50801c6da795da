#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "turtle/turtle.hpp"

namespace algae {

/// The colours a figure is drawn in. The list may name schemes such as `along`, which are many colours by position in the word, in
/// a bounded number of shades.
class Palette {
public:
    /// The number of no colour.
    static constexpr std::uint32_t no_shade = 0xffffffff;

    /// Throws Error on an unknown colour. An empty list is black alone.
    Palette(const std::vector<std::string>& colours, std::uint32_t hues);

    /// A number for what is drawn with the colour of this index at this position, 0 to 1. Equal
    /// numbers are equal colours. Beyond the list its colours come round again.
    std::uint32_t shade(std::uint32_t index, double position) const;
    Colour colour(std::uint32_t shade) const;
    /// Whether some colour depends on the position.
    bool runs_along() const { return runs_along_; }

private:
    struct Entry {
        Colour colour;
        std::string scheme;  // empty if it is one colour
    };
    std::vector<Entry> entries_;
    std::uint32_t hues_;
    bool runs_along_ = false;
};

}  // namespace algae
