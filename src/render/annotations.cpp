#include "render/annotations.hpp"

#include <cairo.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "base/error.hpp"
#include "render/document.hpp"

namespace algae {

namespace {

std::string number(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.10g", value);
    return text;
}

/// Black, or white on a dark background.
void choose_ink(cairo_t* context, const std::optional<Colour>& background) {
    const bool dark = background && 0.299 * background->red + 0.587 * background->green + 0.114 * background->blue < 0.5;
    const double grey = dark ? 1 : 0;
    cairo_set_source_rgb(context, grey, grey, grey);
}

void choose_letters(cairo_t* context, double size) {
    cairo_select_font_face(context, "sans-serif", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(context, size);
}

void draw_scale_bar(cairo_t* context, const Plan& plan, const Cell& cell) {
    const double length = scale_bar_length(cell.width / cell.frame.scale);
    const double size = plan.font_size, wide = length * cell.frame.scale, tick = size / 4;
    const double left = cell.left, middle = cell.caption_top + 0.9 * size;
    cairo_save(context);
    choose_ink(context, plan.background);
    cairo_set_line_width(context, std::max(0.5, size / 14));
    cairo_set_line_cap(context, CAIRO_LINE_CAP_BUTT);
    cairo_move_to(context, left, middle);
    cairo_line_to(context, left + wide, middle);
    for (const double x : {left, left + wide}) {
        cairo_move_to(context, x, middle - tick);
        cairo_line_to(context, x, middle + tick);
    }
    cairo_stroke(context);
    choose_letters(context, size);
    cairo_move_to(context, left + wide + size / 2, middle + 0.35 * size);
    cairo_show_text(context, number(length).c_str());
    cairo_new_path(context);
    cairo_restore(context);
}

void draw_label(cairo_t* context, const Plan& plan, const Cell& cell, const Figure& figure, const PointLabel& label) {
    const auto place = figure.place(label.place);
    if (!place) return;
    const Point at = cell.frame(*place);
    cairo_save(context);
    choose_ink(context, plan.background);
    choose_letters(context, plan.font_size);
    cairo_text_extents_t extents{};
    cairo_text_extents(context, label.text.c_str(), &extents);
    // To the right of the point and above it, as far as the picture reaches.
    const double x = std::clamp(at.x + plan.font_size / 4, 0.0, std::max(0.0, plan.page.width - extents.x_advance));
    const double y = std::clamp(at.y - plan.font_size / 4, plan.font_size, std::max(plan.font_size, plan.page.height));
    cairo_move_to(context, x, y);
    cairo_show_text(context, label.text.c_str());
    cairo_new_path(context);
    cairo_restore(context);
}

}  // namespace

double scale_bar_length(double breadth) {
    const double goal = breadth / 4, power = std::pow(10, std::floor(std::log10(goal)));
    const double times = goal / power;
    const double round = times < 2 ? 1 : times < 5 ? 2 : 5;
    // Written out in decimals and read back, so that it is the nearest number to its name.
    return std::stod(number(round * power));
}

void check_annotations(const Plate& plate, const PictureOptions& options) {
    if (options.scale_bar && !plate.figure->has_scale())
        throw Error("a scale bar: lengths differ from near to far in perspective; expected an orthographic camera");
    for (const PointLabel& label : options.labels)
        if (!plate.figure->place(label.place))
            throw Error("the label \"" + label.text + "\" at " + number(label.place.x) + ',' + number(label.place.y) + ',' +
                        number(label.place.z) + " lies nowhere in " + plate.name + ", which stays in the plane");
}

void draw_annotations(cairo_t* context, const Plan& plan, const Cell& cell, const Figure& figure) {
    if (plan.options.scale_bar && !figure.box().empty) draw_scale_bar(context, plan, cell);
    for (const PointLabel& label : plan.options.labels) draw_label(context, plan, cell, figure, label);
    if (plan.options.scale_bar || !plan.options.labels.empty()) check_cairo(context);
}

}  // namespace algae
