#pragma once

#include <string>

typedef struct _cairo cairo_t;

namespace algae {

/// How texts of graphs are written: DejaVu Sans, or what the machine has in its place.
struct GraphFont {
    double size = 12;
    bool bold = false;
};

/// How wide a text with a subscript is, in points. No pixels are looked at, so it is the same for
/// all formats.
double text_width(const std::string& text, const std::string& subscript, const GraphFont& font);

/// Writes a text with a subscript; `x` is its middle (share 0.5), its left (0) or its right end
/// (1), `y` the middle of a capital letter.
void write_text(cairo_t* context, const std::string& text, const std::string& subscript,
                const GraphFont& font, double x, double y, double share = 0.5);

}  // namespace algae
