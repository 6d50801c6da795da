#include "render/graph_label.hpp"

#include <cairo.h>

#include <memory>

#include "render/document.hpp"

namespace algae {

namespace {

constexpr double subscript_size = 0.72;    // of the size of the text
constexpr double subscript_lowered = 0.2;  // of the size of the text
constexpr double capital_height = 0.729;   // of DejaVu Sans

void choose_font(cairo_t* context, const GraphFont& font, double factor = 1) {
    cairo_select_font_face(context, "DejaVu Sans", CAIRO_FONT_SLANT_NORMAL,
                           font.bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(context, font.size * factor);
}

double advance(cairo_t* context, const std::string& text) {
    cairo_text_extents_t extents{};
    cairo_text_extents(context, text.c_str(), &extents);
    return extents.x_advance;
}

double text_width(cairo_t* context, const std::string& text, const std::string& subscript,
                  const GraphFont& font) {
    choose_font(context, font);
    double width = advance(context, text);
    if (!subscript.empty()) {
        choose_font(context, font, subscript_size);
        width += advance(context, subscript);
    }
    return width;
}

}  // namespace

double text_width(const std::string& text, const std::string& subscript, const GraphFont& font) {
    const std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)> nothing(
        cairo_recording_surface_create(CAIRO_CONTENT_COLOR_ALPHA, nullptr), cairo_surface_destroy);
    const std::unique_ptr<cairo_t, decltype(&cairo_destroy)> context(cairo_create(nothing.get()),
                                                                     cairo_destroy);
    const double width = text_width(context.get(), text, subscript, font);
    check_cairo(context.get());
    return width;
}

void write_text(cairo_t* context, const std::string& text, const std::string& subscript,
                const GraphFont& font, double x, double y, double share) {
    const double width = text_width(context, text, subscript, font);
    const double baseline = y + font.size * capital_height / 2;
    choose_font(context, font);
    cairo_move_to(context, x - share * width, baseline);
    cairo_show_text(context, text.c_str());
    if (!subscript.empty()) {
        const double middle = x - share * width + advance(context, text);
        choose_font(context, font, subscript_size);
        cairo_move_to(context, middle, baseline + subscript_lowered * font.size);
        cairo_show_text(context, subscript.c_str());
    }
    cairo_new_path(context);
}

}  // namespace algae
