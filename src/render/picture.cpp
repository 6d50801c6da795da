#include <cairo.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "exact/exact.hpp"
#include "render/detail/document.hpp"
#include "render/detail/drawing.hpp"
#include "render/detail/palette.hpp"
#include "render/render.hpp"
#include "system/system.hpp"

// Pictures, pages and panels: everything about a picture is decided and checked in a Plan before the first stroke, so that a
// wrong option or a figure that cannot be drawn makes no file at all.
//
// A plan is made in this order. Options are within the limits of the format (a png has at most 20,000 pixels a side; a vector
// format 14,400 points, which PDF readers take, ISO 32000). Some figure has a stroke, and no coordinate is beyond the range of
// numbers. The margin is at least half the widest stroke. That needs a pass over the figure only where the setting `narrow` lets
// the symbol ! widen strokes; where widths are lengths, they are part of the box. Then the captions' letters get their
// size, layout.cpp places the cells, a png is rounded up to whole pixels, and its memory is asked of the budget.
//
// Strokes whose width nobody says are 1 point wide in a picture of the usual size, wider in a larger one, and thinner where they
// would cover more than half of the box around the figure.
//
// Panels in a row have smaller letters, and in vector formats thinner strokes (0.6 points). Pages and frames of an animation are
// of one size; with a common scale all frames share the box of all figures, so that a figure grows and stays where it is.
//
// Below a figure come its scale bar, of a round length, and its caption, in smaller letters if it is too long; labels stand at
// points of the figure. All are written by Cairo in its own choice of a sans-serif font, black, or white on a dark background.

namespace algae {

namespace {

constexpr std::array names{"svg", "pdf", "png", "ps", "eps"};
constexpr double panel_line_width = 0.6;  // points, unless somebody says otherwise

std::string with_unit(double value, PictureFormat format) {
    return rounded_decimal(value, 10) + (format == PictureFormat::png ? " pixels" : " points");
}

void check_length(const char* what, std::optional<double> value, double least, double most,
                  PictureFormat format) {
    if (!value || (*value >= least && *value <= most)) return;
    throw Error(std::string("the ") + what + " must be from " + rounded_decimal(least, 10) +
                " to " + with_unit(most, format) + " in " + format_name(format) + ", not " +
                rounded_decimal(*value, 10));
}

void check_options(const PictureOptions& options, PictureFormat format) {
    const double most = largest(format);
    check_length("width", options.width, 1, most, format);
    check_length("height", options.height, 1, most, format);
    check_length("margin", options.margin, 0, most / 2, format);
    check_length("line width", options.line_width, 0.001, most, format);
    check_length("font size", options.font_size, 1, most, format);
    if (options.columns && *options.columns == 0)
        throw Error("a row of panels must have at least 1 column, not 0");
}

void check_figures(std::span<const Plate> plates) {
    if (plates.empty()) throw Error("there is no figure to draw");
    bool blank = true;
    for (const Plate& plate : plates) {
        const Box& box = plate.figure->box();
        if (!std::isfinite(box.low.x + box.low.y + box.high.x + box.high.y) ||
            !std::isfinite(box.breadth() + box.height()))
            throw Error(plate.name +
                        " reaches beyond the range of numbers; its step or shrink "
                        "makes it too large to draw");
        blank = blank && box.empty;
    }
    if (blank)
        throw Error(plates.front().name +
                    " draws nothing: symbols that draw are F, G, F_x and "
                    "polygons in braces");
}

/// `unset`: the width where neither options nor figure say one. What they leave grows with the picture, `growth` times.
double line_width(const Figure& figure, const PictureOptions& options, double unset,
                  double growth) {
    if (options.line_width) return *options.line_width;
    const std::optional<Quantity>& own = figure.style().width;
    if (!own) return growth * unset;
    if (!(own->value > 0 && own->value <= largest_vector))
        throw Error("the setting width must be above 0 and at most " +
                    rounded_decimal(largest_vector, 10) + ", not " +
                    rounded_decimal(own->value, 10));
    return std::min(growth * own->value, largest_vector);
}

/// A width that nobody said, thinner where strokes would cover most of the figure's box, so that they do not run together.
double thinned(double width, const Figure& figure, double scale) {
    constexpr double most = 0.5, least = 0.4;  // of the box, and of the width
    const Facts& facts = figure.facts();
    const Box& box = figure.box();
    const double room = box.breadth() * box.height() * scale;
    const double ink = facts.segments.to_double() * std::fabs(facts.step) * width;
    if (!(room > 0) || !std::isfinite(ink) || ink <= most * room) return width;
    return width * std::max(least, most * room / ink);
}

/// Finds the widest stroke of a figure whose symbol ! widens.
class WidestStroke final : public Canvas {
public:
    void move_to(Point) override {}
    void line_to(Point) override { widest = std::max(widest, std::fabs(factor_)); }
    void polygon(std::span<const Point>) override {}
    void width(double factor) override { factor_ = factor; }
    void width_as_length(double) override { factor_ = 0; }  // is part of the box
    double widest = 1;

private:
    double factor_ = 1;
};

/// How wide the widest stroke is, as a multiple of the line width. Only where strokes may grow
/// wider does this take a pass over the figure.
double widest_stroke(const Figure& figure, const Budget& budget) {
    const std::optional<Quantity>& narrow = figure.style().narrow;
    if (!narrow || std::fabs(narrow->value) <= 1) return 1;
    WidestStroke measure;
    const double extent = std::max(figure.box().breadth(), figure.box().height());
    figure.draw(measure, extent / 4000, budget);
    return measure.widest;
}

/// The box that a figure needs, with its strokes where their widths are lengths.
Box room_for(const Figure& figure) {
    Box box = figure.box();
    const double half = figure.facts().widest / 2;
    if (box.empty || !(half > 0)) return box;
    box.add(Point{box.low.x - half, box.low.y - half});
    box.add(Point{box.high.x + half, box.high.y + half});
    return box;
}

/// The height of letters that suits a picture, smaller where several captions share its width.
double caption_size(double longer, std::size_t columns) {
    return std::clamp(longer / (15 * static_cast<double>(columns)), longer / 80, longer / 50);
}

/// Throws Error if a side holds nothing but margins and captions.
void check_room(const char* what, std::optional<double> side, double taken, PictureFormat format) {
    if (side && *side - taken < 1)
        throw Error(std::string("margins and captions leave no room in a ") + what + " of " +
                    with_unit(*side, format));
}

/// Throws Error if a figure has no scale for the bar that the options ask for, or no place for a label.
void check_annotations(const Plate& plate, const PictureOptions& options) {
    if (options.scale_bar && !plate.figure->has_scale())
        throw Error(
            "a scale bar: lengths differ from near to far in perspective; expected an orthographic "
            "camera");
    for (const PointLabel& label : options.labels)
        if (!plate.figure->place(label.place))
            throw Error(
                "the label \"" + label.text + "\" at " + rounded_decimal(label.place.x, 10) + ',' +
                rounded_decimal(label.place.y, 10) + ',' + rounded_decimal(label.place.z, 10) +
                " lies nowhere in " + plate.name + ", which stays in the plane");
}

}  // namespace

const char* format_name(PictureFormat format) { return names[static_cast<std::size_t>(format)]; }

PictureFormat picture_format(std::string_view path) {
    if (const auto found = format_of(names, path)) return static_cast<PictureFormat>(*found);
    throw Error("expected a picture file ending in .svg, .pdf, .png, .ps or .eps, found \"" +
                std::string(path) + "\"");
}

Point label_corner(const Plan& plan, Point at, double width) {
    return {std::clamp(at.x + plan.font_size / 4, 0.0, std::max(0.0, plan.page.width - width)),
            std::clamp(at.y - plan.font_size / 4, plan.font_size,
                       std::max(plan.font_size, plan.page.height))};
}

double scale_bar_length(double breadth) {
    const double goal = breadth / 4, power = std::pow(10, std::floor(std::log10(goal)));
    const double times = goal / power;
    const double round = times < 2 ? 1 : times < 5 ? 2 : 5;
    // Written out in decimals and read back, so that it is the nearest number to its name.
    return std::stod(rounded_decimal(round * power, 10));
}

double narrowed(double pen, double factor) {
    constexpr double least = 0.4;
    return std::max(pen * std::fabs(factor), std::min(pen, least));
}

const std::vector<std::string>& colours_of(const Figure& figure, const PictureOptions& options) {
    return options.colours.empty() ? figure.style().colours : options.colours;
}

Plan plan(std::span<const Plate> plates, PictureFormat format, Arrangement arrangement,
          const PictureOptions& options, const Budget& budget) {
    check_options(options, format);
    if (arrangement == Arrangement::pages && plates.size() > 1 && format != PictureFormat::pdf &&
        format != PictureFormat::ps)
        throw Error(std::string("a ") + format_name(format) +
                    " file holds one page; several generations need pdf or ps, or stand side "
                    "by side as panels");
    check_figures(plates);

    Plan result;
    result.format = format;
    result.arrangement = arrangement;
    result.options = options;
    result.background = background_of(options.background, format);

    LayoutWishes wishes;
    std::vector<Box> boxes;
    for (const Plate& plate : plates) boxes.push_back(room_for(*plate.figure));
    if (arrangement == Arrangement::panels)
        wishes.columns = std::min(options.columns.value_or(panel_columns(boxes)), plates.size());
    const double unset = wishes.columns > 1 && format != PictureFormat::png ? panel_line_width : 1;
    wishes.longest = format == PictureFormat::png ? 1000 : 600;
    const double longer = std::max(options.width.value_or(0), options.height.value_or(0));
    const double growth = std::max(1.0, longer / wishes.longest);
    bool captions = false;
    result.margin = options.margin;
    for (const Plate& plate : plates) {
        const Palette known(colours_of(*plate.figure, options), 1);  // throws if not
        result.widths.push_back(line_width(*plate.figure, options, unset, growth));
        result.margin = std::max(result.margin,
                                 result.widths.back() * widest_stroke(*plate.figure, budget) / 2);
        captions = captions || !plate.caption.empty();
        check_annotations(plate, options);
    }

    if (!(result.margin <= largest(format) / 2))
        throw Error("the widest stroke is " + with_unit(2 * result.margin, format) +
                    " wide: the setting narrow lets the symbol ! widen strokes too much");
    wishes.width = options.width;
    wishes.height = options.height;
    wishes.margin = result.margin;
    wishes.common_scale = options.common_scale;
    if (arrangement == Arrangement::panels && plates.size() > 1) wishes.gap = wishes.longest / 40;
    result.font_size = options.font_size.value_or(
        caption_size(longer > 0 ? longer : wishes.longest, wishes.columns));
    const double lines = (captions ? 1 : 0) + (options.scale_bar ? 1 : 0);
    wishes.caption = lines * 1.6 * result.font_size;
    const std::size_t rows = arrangement == Arrangement::panels
                                 ? (plates.size() + wishes.columns - 1) / wishes.columns
                                 : 1;
    // With neither side given, both are at most the longest.
    const std::optional<double> longest =
        options.width || options.height ? std::nullopt : std::optional(wishes.longest);
    check_room("width", options.width ? options.width : longest,
               2 * static_cast<double>(wishes.columns) * wishes.margin +
                   static_cast<double>(wishes.columns - 1) * wishes.gap,
               format);
    check_room("height", options.height ? options.height : longest,
               static_cast<double>(rows + 1) * wishes.margin +
                   static_cast<double>(rows - 1) * wishes.gap +
                   static_cast<double>(rows) * wishes.caption,
               format);

    if (arrangement == Arrangement::frames && options.common_scale) {
        Box all;
        for (const Box& box : boxes) all.add(box);
        boxes.assign(boxes.size(), all);
    }
    if (arrangement == Arrangement::pages || arrangement == Arrangement::frames) {
        const std::vector<Layout> pages = page_layouts(boxes, wishes);
        result.page.width = pages.front().width;
        result.page.height = pages.front().height;
        for (const Layout& page : pages) result.page.cells.push_back(page.cells.front());
    } else {
        result.page = layout(boxes, wishes);
    }
    for (std::size_t i = 0; i < plates.size(); ++i)
        if (!options.line_width && !plates[i].figure->style().width)
            result.widths[i] =
                thinned(result.widths[i], *plates[i].figure, result.page.cells[i].frame.scale);
    Layout& page = result.page;
    if (format == PictureFormat::png) {
        page.width = std::ceil(page.width - 1e-6);
        page.height = std::ceil(page.height - 1e-6);
    }
    check_length("width", page.width, 1, largest(format), format);
    check_length("height", page.height, 1, largest(format), format);
    if (format == PictureFormat::png) {
        const std::string what = "a picture of " + rounded_decimal(page.width, 10) + " x " +
                                 with_unit(page.height, format);
        budget.check_memory(static_cast<std::uint64_t>(4 * page.width * page.height), what.c_str());
    }
    return result;
}

namespace {

/// Black, or white on a dark background.
void choose_ink(cairo_t* context, const std::optional<Colour>& background) {
    const bool dark =
        background &&
        0.299 * background->red + 0.587 * background->green + 0.114 * background->blue < 0.5;
    const double grey = dark ? 1 : 0;
    set_colour(context, {grey, grey, grey});
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
    choose_font(context, "sans-serif", size);
    show_text(context, rounded_decimal(length, 10), left + wide + size / 2, middle + 0.35 * size);
    cairo_restore(context);
}

void draw_label(cairo_t* context, const Plan& plan, const Cell& cell, const Figure& figure,
                const PointLabel& label) {
    const auto place = figure.place(label.place);
    if (!place) return;
    const Point at = cell.frame(*place);
    cairo_save(context);
    choose_font(context, "sans-serif", plan.font_size);
    const auto [x, y] = label_corner(plan, at, text_width(context, label.text));
    // A halo lets it be read on strokes.
    cairo_move_to(context, x, y);
    cairo_text_path(context, label.text.c_str());
    cairo_set_line_width(context, plan.font_size / 4);
    cairo_set_line_join(context, CAIRO_LINE_JOIN_ROUND);
    set_colour(context, plan.background.value_or(Colour{1, 1, 1}));
    cairo_stroke(context);
    choose_ink(context, plan.background);
    show_text(context, label.text, x, y);
    cairo_restore(context);
}

/// Draws the scale bar below a figure at the left, with its length in the units of the file, and the
/// labels at their points.
void draw_annotations(cairo_t* context, const Plan& plan, const Cell& cell, const Figure& figure) {
    if (plan.options.scale_bar && !figure.box().empty) draw_scale_bar(context, plan, cell);
    for (const PointLabel& label : plan.options.labels)
        draw_label(context, plan, cell, figure, label);
    if (plan.options.scale_bar || !plan.options.labels.empty()) check_cairo(context);
}

/// Writes a caption in the middle under a cell, in smaller letters if it is too long. Where a
/// machine has no fonts, Cairo draws its own.
void draw_caption(cairo_t* context, const Cell& cell, const std::string& caption, double top,
                  double font_size, const std::optional<Colour>& background) {
    if (caption.empty()) return;
    choose_font(context, "sans-serif", font_size);
    double width = text_width(context, caption);
    if (width > cell.width) {
        cairo_set_font_size(context, std::max(font_size * cell.width / width, 0.5));
        width = text_width(context, caption);
    }
    choose_ink(context, background);
    show_text(context, caption, cell.left + (cell.width - width) / 2, top + 1.4 * font_size);
    check_cairo(context);
}

Drawn draw(std::span<const Plate> plates, Output& output, const Plan& plan, const Budget& budget,
           Progress* progress) {
    Drawn drawn;
    drawn.width = plan.page.width;
    drawn.height = plan.page.height;
    Document document(plan.format, plan.page.width, plan.page.height, plan.background, output,
                      budget);
    document.say(plan.options.title, plan.options.author);
    double all = 0, done = 0;
    for (const Plate& plate : plates) all += work(*plate.figure);
    all *= 1.1;  // the rest is writing
    for (std::size_t i = 0; i < plates.size(); ++i) {
        if (plan.arrangement == Arrangement::pages && i > 0) document.next_page();
        const double next = done + work(*plates[i].figure);
        const Share share(progress, done / all, next / all);
        draw_plate(document.context(), plan, i, plates[i], budget, share, drawn);
        done = next;
    }
    document.finish();
    if (progress) progress->report(1);
    return drawn;
}

Drawn draw_to(const Target& target, std::span<const Plate> plates, PictureFormat format,
              Arrangement arrangement, const PictureOptions& options, const Budget& budget,
              Progress* progress) {
    const Plan decided = plan(plates, format, arrangement, options, budget);
    Drawn drawn;
    write_to(target,
             [&](Output& output) { drawn = draw(plates, output, decided, budget, progress); });
    return drawn;
}

}  // namespace

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

Drawn draw_picture(const Plate& plate, const Target& target, PictureFormat format,
                   const PictureOptions& options, const Budget& budget, Progress* progress) {
    return draw_to(target, {&plate, 1}, format, Arrangement::one, options, budget, progress);
}

Drawn draw_pages(std::span<const Plate> plates, const Target& target, PictureFormat format,
                 const PictureOptions& options, const Budget& budget, Progress* progress) {
    return draw_to(target, plates, format, Arrangement::pages, options, budget, progress);
}

Drawn draw_panels(std::span<const Plate> plates, const Target& target, PictureFormat format,
                  const PictureOptions& options, const Budget& budget, Progress* progress) {
    return draw_to(target, plates, format, Arrangement::panels, options, budget, progress);
}

}  // namespace algae
