#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "system/expression.hpp"
#include "system/solid_setting.hpp"
#include "system/space_settings.hpp"
#include "word/alphabet.hpp"

namespace algae {

/// A colour, each part from 0 to 1.
struct Colour {
    double red = 0, green = 0, blue = 0;
    bool operator==(const Colour&) const = default;
};

/// The shapes that a stamp may have.
enum class StampShape : unsigned char { square, circle, triangle };

/// How a system wants to be drawn. Whatever a file does not say is absent here and has the value
/// given in the comment.
struct Settings {
    std::optional<Quantity> angle;    // degrees that + and - turn by; 90
    std::optional<Quantity> step;     // length of F and f in generation 0; 1
    std::optional<Quantity> shrink;   // factor on the step per generation; 1
    struct Start {
        Quantity x, y, heading;       // heading in degrees, 0 along +x, counter-clockwise
        bool operator==(const Start&) const = default;
    };
    std::optional<Start> start;       // 0 0 0
    std::optional<Quantity> spin;     // degrees added to the start heading per generation; 0
    std::optional<Quantity> scale;    // factor of the symbol * on the turtle's own step; * ignored
    std::optional<Quantity> narrow;   // factor of the symbol ! on the line width; ! ignored
    std::optional<Quantity> width;    // line width, in points of the picture; 1
    bool clockwise = false;           // `turn clockwise`: + turns right
    std::vector<Symbol> plotters;     // `plot F`: F(x,y) draws a line to the point (x,y)
    struct Stamp {
        Symbol symbol = 0;
        StampShape shape = StampShape::square;
        bool operator==(const Stamp&) const = default;
    };
    std::vector<Stamp> stamps;        // `stamp S square`: S leaves a filled shape where it stands
    std::vector<SolidSetting> solids;      // `solid F box width`: F is a box, its parameter the width
    std::vector<SurfaceSetting> surfaces;  // `surface K leaf`: K leaves a surface
    std::optional<Triple> tropism;    // direction that steps bend to, as strong as it is long; none
    std::optional<Quantity> susceptibility;  // factor on how far they bend; 1
    std::optional<CameraSetting> camera;     // of figures in space; -60 15
    std::optional<Direction> light;   // where it comes from; over the camera's left shoulder
    std::optional<Quantity> fog;      // share that the farthest part takes of the background; 0
    std::vector<std::string> colours;  // `colour`: names or #rrggbb, the first for the start, the
                                       // symbol ' goes on to the next; `along`: hue by position
    std::optional<std::pair<std::uint64_t, std::uint64_t>> generations;  // `generation 0..6`
    std::optional<std::pair<std::uint64_t, std::uint64_t>> seeds;        // `seed 1..3`; 1

    bool operator==(const Settings&) const = default;
};

}  // namespace algae
