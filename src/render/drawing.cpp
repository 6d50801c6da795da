#include "render/drawing.hpp"

#include <cairo.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "render/annotations.hpp"
#include "render/cells.hpp"
#include "render/document.hpp"
#include "render/layers.hpp"
#include "render/palette.hpp"

namespace algae {
namespace {

constexpr double image_resolution = 4;  // pixels a point of an image in a vector format
constexpr double detail_of_layers = 0.5;  // points: how fine a view is in a vector format
constexpr double chord_pixels = 0.35;   // parts of a figure smaller than this become chords
constexpr std::uint64_t few_strokes = 20'000, many_strokes = 500'000;
constexpr std::uint32_t hues = 360, hues_of_cells = 128;

bool is_fine(const Figure& figure, const Frame& frame) {
    const std::optional<std::uint64_t> strokes = figure.strokes();
    if (!strokes || *strokes > many_strokes) return true;
    const double pixels =
        (figure.box().breadth() * frame.scale + 1) * (figure.box().height() * frame.scale + 1);
    return *strokes > few_strokes && static_cast<double>(*strokes) > pixels;
}

/// Draws one figure in cells on an image surface.
void draw_cells(cairo_t* context, const PixelRectangle& area, const Frame& frame,
                const Figure& figure, const Pen& pen, const Budget& budget, const Share& share,
                Drawn& drawn) {
    budget.check_memory(cells_memory(area.width, area.height), "a picture drawn in cells");
    CellCanvas canvas(context, area, cells_per_pixel(area.width, area.height), frame, pen, budget,
                      share);
    const std::optional<std::uint64_t> strokes = figure.strokes();
    const bool join = !strokes || *strokes > many_strokes;
    figure.draw(canvas, join ? chord_pixels / frame.scale : 0, budget);
    canvas.finish();
    drawn.lines += canvas.lines();
    drawn.polygons += canvas.polygons();
}

/// Draws one figure whose parts hide each other on an image surface.
void draw_layers(cairo_t* context, const PixelRectangle& area, const Frame& frame,
                 const Figure& figure, const Pen& pen, const Budget& budget, const Share& share,
                 Drawn& drawn) {
    LayerCanvas canvas(cairo_get_target(context), area, frame, pen, budget, share);
    figure.draw(canvas, 1 / frame.scale, budget);
    canvas.finish();
    drawn.lines += canvas.lines();
    drawn.polygons += canvas.polygons();
}

/// The whole pixels of a cell and its margin, within the picture.
PixelRectangle pixels_of(const Cell& cell, const Plan& plan) {
    const double margin = plan.margin;
    const auto whole = [](double value) { return static_cast<int>(value); };
    PixelRectangle area;
    area.left = whole(std::max(0.0, std::floor(cell.left - margin)));
    area.top = whole(std::max(0.0, std::floor(cell.top - margin)));
    area.width =
        whole(std::min(plan.page.width, std::ceil(cell.left + cell.width + margin))) - area.left;
    area.height =
        whole(std::min(plan.page.height, std::ceil(cell.top + cell.height + margin))) - area.top;
    return area;
}

/// Draws one figure as an image and puts it into a vector format.
void draw_image(cairo_t* context, const Cell& cell, const Plan& plan, const Figure& figure, Pen pen,
                const Budget& budget, const Share& share, Drawn& drawn) {
    const double margin = plan.margin;
    const double more = image_resolution;
    const double width = std::ceil((cell.width + 2 * margin) * more);
    const double height = std::ceil((cell.height + 2 * margin) * more);
    budget.check_memory(static_cast<std::uint64_t>(4 * width * height), "an image in the picture");
    // PostScript has no half-transparent images.
    const bool opaque = plan.format == PictureFormat::ps || plan.format == PictureFormat::eps;
    const std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)> image(
        cairo_image_surface_create(opaque ? CAIRO_FORMAT_RGB24 : CAIRO_FORMAT_ARGB32,
                                   static_cast<int>(width), static_cast<int>(height)),
        cairo_surface_destroy);
    const std::unique_ptr<cairo_t, decltype(&cairo_destroy)> on_image(cairo_create(image.get()),
                                                                      cairo_destroy);
    if (opaque) {
        const Colour paper = plan.background.value_or(Colour{1, 1, 1});
        cairo_set_source_rgb(on_image.get(), paper.red, paper.green, paper.blue);
        cairo_paint(on_image.get());
    }
    const double left = cell.left - margin, top = cell.top - margin;
    const Frame frame{cell.frame.scale * more, (cell.frame.x - left) * more,
                      (cell.frame.y - top) * more};
    pen.width *= more;
    const auto draw = figure.is_layered() ? draw_layers : draw_cells;
    draw(on_image.get(), {0, 0, static_cast<int>(width), static_cast<int>(height)}, frame, figure,
         pen, budget, share, drawn);
    cairo_save(context);
    cairo_translate(context, left, top);
    cairo_scale(context, 1 / more, 1 / more);
    cairo_set_source_surface(context, image.get(), 0, 0);
    cairo_paint(context);
    cairo_restore(context);
    drawn.as_image = true;
}

void draw_figure(cairo_t* context, const Cell& cell, const Plan& plan, const Figure& figure,
                 double width, const Budget& budget, const Share& share, Drawn& drawn) {
    using Route = PictureOptions::Route;
    const PictureOptions& options = plan.options;
    const bool pixels = plan.format == PictureFormat::png;
    const std::optional<std::uint64_t> strokes = figure.strokes();
    const bool too_many = !strokes || *strokes > options.most_strokes;
    const bool layered = figure.is_layered();
    const bool fine =
        !(layered && pixels) &&
        (options.route == Route::cells ||
         (options.route == Route::automatic && (pixels ? is_fine(figure, cell.frame) : too_many)));
    const Palette palette(colours_of(figure, options), fine ? hues_of_cells : hues);
    const Pen pen{width, options.flat_ends, &palette};
    drawn.fine = drawn.fine || fine;
    if (layered && pixels) {
        draw_layers(context, pixels_of(cell, plan), cell.frame, figure, pen, budget, share, drawn);
    } else if (fine && pixels) {
        draw_cells(context, pixels_of(cell, plan), cell.frame, figure, pen, budget, share, drawn);
    } else if (fine) {
        draw_image(context, cell, plan, figure, pen, budget, share, drawn);
    } else {
        StrokeCanvas canvas(context, cell.frame, pen, budget, share, strokes);
        figure.draw(canvas, layered ? detail_of_layers / cell.frame.scale : 0, budget);
        canvas.finish();
        drawn.lines += canvas.lines();
        drawn.polygons += canvas.polygons();
    }
}

/// Writes a caption in the middle under a cell, in smaller letters if it is too long. Where a
/// machine has no fonts, Cairo draws its own.
void draw_caption(cairo_t* context, const Cell& cell, const std::string& caption, double top,
                  double font_size, const std::optional<Colour>& background) {
    if (caption.empty()) return;
    cairo_select_font_face(context, "sans-serif", CAIRO_FONT_SLANT_NORMAL,
                           CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(context, font_size);
    cairo_text_extents_t extents{};
    cairo_text_extents(context, caption.c_str(), &extents);
    if (extents.x_advance > cell.width) {
        cairo_set_font_size(context, std::max(font_size * cell.width / extents.x_advance, 0.5));
        cairo_text_extents(context, caption.c_str(), &extents);
    }
    const bool dark =
        background &&
        0.299 * background->red + 0.587 * background->green + 0.114 * background->blue < 0.5;
    const double grey = dark ? 1 : 0;
    cairo_set_source_rgb(context, grey, grey, grey);
    cairo_move_to(context, cell.left + (cell.width - extents.x_advance) / 2,
                  top + 1.4 * font_size);
    cairo_show_text(context, caption.c_str());
    cairo_new_path(context);
    check_cairo(context);
}

}  // namespace

double work(const Figure& figure) {
    return 1.0 +
           static_cast<double>(std::min(figure.strokes().value_or(many_strokes), many_strokes));
}

void draw_plate(cairo_t* context, const Plan& plan, std::size_t i, const Plate& plate,
                const Budget& budget, const Share& share, Drawn& drawn) {
    const Figure& figure = *plate.figure;
    const Cell& cell = plan.page.cells[i];
    if (figure.box().empty)
        drawn.blank.push_back(i);
    else
        draw_figure(context, cell, plan, figure, plan.widths[i], budget, share, drawn);
    draw_annotations(context, plan, cell, figure);
    const double top = cell.caption_top + (plan.options.scale_bar ? 1.6 * plan.font_size : 0);
    draw_caption(context, cell, plate.caption, top, plan.font_size, plan.background);
}

}  // namespace algae
