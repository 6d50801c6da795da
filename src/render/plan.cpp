#include "render/plan.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "base/error.hpp"
#include "system/colour.hpp"
#include "render/annotations.hpp"
#include "render/palette.hpp"

namespace algae {
namespace {

constexpr double largest_png = 20'000;     // pixels a side
constexpr double largest_vector = 14'400;  // points a side: what PDF readers take (ISO 32000)
constexpr double panel_line_width = 0.6;   // points, unless somebody says otherwise

double largest(PictureFormat format) {
    return format == PictureFormat::png ? largest_png : largest_vector;
}

std::string number(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.10g", value);
    return text;
}

std::string with_unit(double value, PictureFormat format) {
    return number(value) + (format == PictureFormat::png ? " pixels" : " points");
}

void check_length(const char* what, std::optional<double> value, double least, double most,
                  PictureFormat format) {
    if (!value || (*value >= least && *value <= most)) return;
    throw Error(std::string("the ") + what + " must be from " + number(least) + " to " +
                with_unit(most, format) + " in " + format_name(format) + ", not " + number(*value));
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

/// `unset`: the width where neither options nor figure say one.
double line_width(const Figure& figure, const PictureOptions& options, double unset) {
    if (options.line_width) return *options.line_width;
    const std::optional<Quantity>& own = figure.settings().width;
    if (!own) return unset;
    if (!(own->value > 0 && own->value <= largest_vector))
        throw Error("the setting width must be above 0 and at most " + number(largest_vector) +
                    ", not " + number(own->value));
    return own->value;
}

/// Finds the widest stroke of a figure whose symbol ! widens.
class WidestStroke final : public Canvas {
public:
    void move_to(Point) override {}
    void line_to(Point) override { widest = std::max(widest, std::fabs(factor_)); }
    void polygon(std::span<const Point>) override {}
    void width(double factor) override { factor_ = factor; }
    void width_as_length(double) override { factor_ = 0; }  // is part of the box
    void colour(std::uint32_t) override {}
    void position(double) override {}
    double widest = 1;

private:
    double factor_ = 1;
};

/// How wide the widest stroke is, as a multiple of the line width. Only where strokes may grow
/// wider does this take a pass over the figure.
double widest_stroke(const Figure& figure, const Budget& budget) {
    const std::optional<Quantity>& narrow = figure.settings().narrow;
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

}  // namespace

const std::vector<std::string>& colours_of(const Figure& figure, const PictureOptions& options) {
    return options.colours.empty() ? figure.settings().colours : options.colours;
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
    if (options.background && *options.background != "transparent")
        result.background = colour_named(*options.background);
    else if (!options.background && format == PictureFormat::png)
        result.background = Colour{1, 1, 1};

    LayoutWishes wishes;
    std::vector<Box> boxes;
    for (const Plate& plate : plates) boxes.push_back(room_for(*plate.figure));
    if (arrangement == Arrangement::panels)
        wishes.columns = std::min(options.columns.value_or(panel_columns(boxes)), plates.size());
    const double unset = wishes.columns > 1 && format != PictureFormat::png ? panel_line_width : 1;
    bool captions = false;
    result.margin = options.margin;
    for (const Plate& plate : plates) {
        const Palette known(colours_of(*plate.figure, options), 1);  // throws if not
        result.widths.push_back(line_width(*plate.figure, options, unset));
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
    wishes.longest = format == PictureFormat::png ? 1000 : 600;
    wishes.margin = result.margin;
    wishes.common_scale = options.common_scale;
    if (arrangement == Arrangement::panels && plates.size() > 1) wishes.gap = wishes.longest / 40;
    const double longer = std::max(options.width.value_or(0), options.height.value_or(0));
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
    check_room("width", options.width ? options.width : longest, 2 * static_cast<double>(wishes.columns) * wishes.margin +
                   static_cast<double>(wishes.columns - 1) * wishes.gap,
               format);
    check_room(
        "height", options.height ? options.height : longest,
        static_cast<double>(rows + 1) * wishes.margin +
            static_cast<double>(rows - 1) * wishes.gap + static_cast<double>(rows) * wishes.caption,
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
    Layout& page = result.page;
    if (format == PictureFormat::png) {
        page.width = std::ceil(page.width - 1e-6);
        page.height = std::ceil(page.height - 1e-6);
    }
    check_length("width", page.width, 1, largest(format), format);
    check_length("height", page.height, 1, largest(format), format);
    if (format == PictureFormat::png) {
        const std::string what =
            "a picture of " + number(page.width) + " x " + with_unit(page.height, format);
        budget.check_memory(static_cast<std::uint64_t>(4 * page.width * page.height), what.c_str());
    }
    return result;
}

}  // namespace algae
