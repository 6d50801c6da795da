#include <cairo.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <ostream>

#include "exact/exact.hpp"
#include "render/detail/document.hpp"
#include "render/detail/graph.hpp"
#include "render/render.hpp"
#include "system/system.hpp"

// A placed graph as a page that Cairo draws: labels of rows at the left, frames, edges, nodes, and keys and caption underneath.
//
// Texts are measured on a recording surface, which has no pixels, so that widths and with them the whole layout are the same
// for all formats. A subscript is a smaller text lowered beside its letter. The page is drawn in points from the
// upper left corner and scaled as a whole: to the width or height asked for, otherwise two pixels for a point in png, and smaller
// where the page would go beyond the largest size of the format (20,000 pixels, or 14,400 points, ISO 32000).
//
// The order of drawing says what covers what: guides of rows, frames, edges, nodes. Labels of straight edges stand on a
// patch of paper that covers the edge.

namespace algae {

namespace {

constexpr double subscript_size = 0.72;    // of the size of the text
constexpr double subscript_lowered = 0.2;  // of the size of the text
constexpr double capital_height = 0.729;   // of DejaVu Sans

void choose_font(cairo_t* context, const GraphFont& font, double factor = 1) {
    algae::choose_font(context, "DejaVu Sans", font.size * factor, font.bold);
}

double text_width(cairo_t* context, const std::string& text, const std::string& subscript,
                  const GraphFont& font) {
    choose_font(context, font);
    const double width = algae::text_width(context, text);
    if (subscript.empty()) return width;
    choose_font(context, font, subscript_size);
    return width + algae::text_width(context, subscript);
}

}  // namespace

double text_width(const std::string& text, const std::string& subscript, const GraphFont& font) {
    const OwnedSurface nothing(cairo_recording_surface_create(CAIRO_CONTENT_COLOR_ALPHA, nullptr));
    const OwnedContext context(cairo_create(nothing.get()));
    const double width = text_width(context.get(), text, subscript, font);
    check_cairo(context.get());
    return width;
}

void write_text(cairo_t* context, const std::string& text, const std::string& subscript,
                const GraphFont& font, double x, double y, double share) {
    const double width = text_width(context, text, subscript, font);
    const double baseline = y + font.size * capital_height / 2;
    choose_font(context, font);
    show_text(context, text, x - share * width, baseline);
    if (subscript.empty()) return;
    const double middle = x - share * width + text_width(context, text);
    choose_font(context, font, subscript_size);
    show_text(context, subscript, middle, baseline + subscript_lowered * font.size);
}

namespace {

constexpr double margin = 12;
constexpr double line_below = 18;  // height of keys, and of the caption
constexpr double swatch = 9;
constexpr double key_gap = 16;  // between two keys
constexpr double thinnest = 0.5, thin = 0.7, thick = 0.9;
constexpr double arrow_half = 2.6, thin_arrow_half = 1.7;
constexpr GraphFont small_font{graph_small_letters, false};

const Colour ink{0.1, 0.1, 0.12}, line_ink{0.38, 0.40, 0.44}, faint_ink{0.45, 0.47, 0.5};
const Colour thin_ink{0.55, 0.57, 0.61}, guide{0.91, 0.92, 0.93}, paper{1, 1, 1};

Colour darker(const Colour& colour, double share) {
    return {colour.red * share, colour.green * share, colour.blue * share};
}

void rounded_box(cairo_t* context, double left, double top, double right, double bottom,
                 double radius) {
    constexpr double quarter = std::numbers::pi / 2;
    cairo_new_sub_path(context);
    cairo_arc(context, right - radius, top + radius, radius, -quarter, 0);
    cairo_arc(context, right - radius, bottom - radius, radius, 0, quarter);
    cairo_arc(context, left + radius, bottom - radius, radius, quarter, 2 * quarter);
    cairo_arc(context, left + radius, top + radius, radius, 2 * quarter, 3 * quarter);
    cairo_close_path(context);
}

void arrow_head(cairo_t* context, const Point& from, const Point& to, double half) {
    const double x = to.x - from.x, y = to.y - from.y, size = std::hypot(x, y);
    if (size == 0) return;
    const double across_x = -y / size * half, across_y = x / size * half;
    cairo_move_to(context, to.x, to.y);
    cairo_line_to(context, from.x + across_x, from.y + across_y);
    cairo_line_to(context, from.x - across_x, from.y - across_y);
    cairo_close_path(context);
    cairo_fill(context);
}

double key_width(const Graph::Key& key) {
    return swatch + 5 + text_width(key.text, "", small_font);
}

/// A placed graph as a page: margins, labels of rows at the left, keys and caption underneath.
class GraphPage {
public:
    GraphPage(const Graph& graph, const GraphLayout& layout) : graph_(graph), layout_(layout) {
        double labels = 0;
        for (const std::string& label : graph.row_labels)
            labels = std::max(labels, text_width(label, "", small_font));
        for (const std::string& label : graph.step_labels)
            labels = std::max(labels, text_width(label, "", small_font));
        const double beside = labels > 0 ? labels + 14 : 0;
        for (const Graph::Key& key : graph.keys)
            keys_width_ += key_width(key) + (keys_width_ > 0 ? key_gap : 0);
        const double below = std::max(keys_width_, text_width(graph.caption, "", small_font));
        const double content = std::max(beside + layout.width, below);
        left_ = margin + beside + (content - beside - layout.width) / 2;
        width_ = content + 2 * margin;
        height_ = layout.height + 2 * margin + (graph.keys.empty() ? 0 : line_below) +
                  (graph.caption.empty() ? 0 : line_below);
    }

    /// In points.
    double width() const { return width_; }
    double height() const { return height_; }
    void draw(cairo_t* context) const {
        cairo_save(context);
        cairo_translate(context, left_, margin);
        draw_rows(context);
        draw_groups(context);
        draw_edges(context);
        draw_nodes(context);
        cairo_restore(context);
        draw_below(context);
    }

private:
    void draw_rows(cairo_t* context) const {
        for (std::size_t i = 0; i < graph_.row_labels.size() && i < graph_.rows.size(); ++i) {
            if (graph_.rows[i].empty() || graph_.row_labels[i].empty()) continue;
            const double y = layout_.nodes[graph_.rows[i].front()].y;
            set_colour(context, guide);
            cairo_set_line_width(context, thin);
            draw_line(context, {-8, y}, {layout_.width, y});
            set_colour(context, faint_ink);
            write_text(context, graph_.row_labels[i], "", small_font, -12, y, 1);
        }
        for (std::size_t i = 0; i < graph_.step_labels.size() && i + 1 < graph_.rows.size(); ++i) {
            if (graph_.rows[i].empty() || graph_.rows[i + 1].empty()) continue;
            const double above = layout_.nodes[graph_.rows[i].front()].y,
                         below = layout_.nodes[graph_.rows[i + 1].front()].y;
            set_colour(context, ink);
            write_text(context, graph_.step_labels[i], "", small_font, -12, (above + below) / 2, 1);
        }
    }
    void draw_groups(cairo_t* context) const {
        for (std::size_t i = 0; i < graph_.groups.size(); ++i) {
            const GraphLayout::Frame& frame = layout_.groups[i];
            rounded_box(context, frame.left, frame.top, frame.right, frame.bottom, 8);
            fill_and_outline(context, graph_.groups[i].fill, darker(graph_.groups[i].fill, 0.75),
                             thin);
            set_colour(context, ink);
            write_text(context, graph_.groups[i].label, "", small_font, frame.label.x,
                       frame.label.y);
        }
    }
    void draw_edges(cairo_t* context) const {
        constexpr double dashes[] = {3, 2.5};
        for (std::size_t i = 0; i < graph_.edges.size(); ++i) {
            const Graph::Edge& edge = graph_.edges[i];
            const GraphLayout::Line& line = layout_.edges[i];
            set_colour(context, edge.thin ? thin_ink : line_ink);
            cairo_set_line_width(context, edge.thin ? thinnest : thick);
            if (!line.points.empty()) cairo_move_to(context, line.points[0].x, line.points[0].y);
            for (std::size_t k = 1; k + 2 < line.points.size(); k += 3)
                cairo_curve_to(context, line.points[k].x, line.points[k].y, line.points[k + 1].x,
                               line.points[k + 1].y, line.points[k + 2].x, line.points[k + 2].y);
            if (edge.dashed) cairo_set_dash(context, dashes, 2, 0);
            cairo_stroke(context);
            cairo_set_dash(context, nullptr, 0, 0);
            if (line.tip)
                arrow_head(context, line.points.back(), *line.tip,
                           edge.thin ? thin_arrow_half : arrow_half);
            if (edge.label.empty()) continue;
            if (graph_.straight) {
                const double half = text_width(edge.label, "", small_font) / 2 + 1.5;
                set_colour(context, paper);
                rounded_box(context, line.label.x - half, line.label.y - 6, line.label.x + half,
                            line.label.y + 6, 5);
                cairo_fill(context);
            }
            set_colour(context, ink);
            write_text(context, edge.label, "", small_font, line.label.x, line.label.y);
        }
    }
    void draw_nodes(cairo_t* context) const {
        using enum Graph::Node::Shape;
        for (std::size_t i = 0; i < graph_.nodes.size(); ++i) {
            const Graph::Node& node = graph_.nodes[i];
            if (node.shape == start) continue;
            const Point middle = layout_.nodes[i], size = node_size(node);
            const double left = middle.x - size.x / 2, right = middle.x + size.x / 2;
            const double top = middle.y - size.y / 2, bottom = middle.y + size.y / 2;
            const Colour fill = node.fill.value_or(paper);
            if (node.shape == triangle) {
                cairo_move_to(context, middle.x, top);
                cairo_line_to(context, right, bottom);
                cairo_line_to(context, left, bottom);
                cairo_close_path(context);
            } else {
                const double inset = node.shape == bare ? 2 : 0;
                rounded_box(context, left + inset, top + inset, right - inset, bottom - inset,
                            node.shape == box ? 5 : size.y / 2 - inset);
            }
            if (node.shape == bare) {
                set_colour(context, fill);
                cairo_fill(context);
            } else {
                fill_and_outline(context, fill, node.fill ? darker(fill, 0.62) : line_ink,
                                 node.bold ? 1.6 : thick);
            }
            set_colour(context, ink);
            const bool low = node.shape == triangle;
            write_text(context, node.label, node.subscript,
                       {low ? graph_small_letters : graph_letters, node.bold}, middle.x,
                       low ? bottom - 7 : middle.y);
        }
    }
    void draw_below(cairo_t* context) const {
        double y = margin + layout_.height + line_below;
        if (!graph_.keys.empty()) {
            double x = (width_ - keys_width_) / 2;
            for (const Graph::Key& key : graph_.keys) {
                rounded_box(context, x, y - swatch / 2, x + swatch, y + swatch / 2, 2);
                fill_and_outline(context, key.fill, darker(key.fill, 0.62), thin);
                set_colour(context, ink);
                write_text(context, key.text, "", small_font, x + swatch + 5, y, 0);
                x += key_width(key) + key_gap;
            }
            y += line_below;
        }
        set_colour(context, ink);
        if (!graph_.caption.empty())
            write_text(context, graph_.caption, "", small_font, width_ / 2, y);
    }

    const Graph& graph_;
    const GraphLayout& layout_;
    double left_ = 0;  // of the graph
    double keys_width_ = 0;
    double width_ = 0, height_ = 0;
};

constexpr double pixels_of_a_point = 2;  // in png

void check_side(const char* what, const std::optional<double>& side, PictureFormat format) {
    if (!side || (*side >= 10 && *side <= largest(format))) return;
    throw Error(std::string("the ") + what + " must be from 10 to " +
                std::to_string(static_cast<long>(largest(format))) +
                (format == PictureFormat::png ? " pixels" : " points") + " in " +
                format_name(format) + ", not " + rounded_decimal(*side, 10));
}

}  // namespace

GraphPicture graph_picture(const Graph& graph, const Budget& budget) {
    struct Placed {
        Graph graph;
        GraphLayout layout;
    };
    const auto placed = std::make_shared<const Placed>(
        Placed{graph, graph.trees ? tree_layout(graph, budget) : graph_layout(graph, budget)});
    const GraphPage page(placed->graph, placed->layout);
    return {page.width(), page.height(),
            [placed](cairo_t* context) { GraphPage(placed->graph, placed->layout).draw(context); }};
}

double graph_scale(const GraphDrawn& page, PictureFormat format, const GraphOptions& options) {
    check_side("width", options.width, format);
    check_side("height", options.height, format);
    if (options.width || options.height)
        return std::min(options.width ? *options.width / page.width : HUGE_VAL,
                        options.height ? *options.height / page.height : HUGE_VAL);
    const double natural = format == PictureFormat::png ? pixels_of_a_point : 1;
    return std::min(natural, largest(format) / std::max(page.width, page.height));
}

GraphDrawn graph_page(const GraphDrawn& page, double scale, PictureFormat format) {
    const auto side = [&](double length) {
        const double scaled = length * scale;
        return format == PictureFormat::png ? std::clamp(std::ceil(scaled - 1e-6), 1.0, largest_png)
                                            : std::min(scaled, largest_vector);
    };
    return {side(page.width), side(page.height)};
}

namespace {

GraphDrawn draw(const Graph& graph, Output& output, PictureFormat format,
                const GraphOptions& options, const Budget& budget) {
    const std::optional<Colour> background = background_of(options.background, format);
    const GraphPicture picture = graph_picture(graph, budget);
    const GraphDrawn page{picture.width, picture.height};
    const double scale = graph_scale(page, format, options);
    const GraphDrawn drawn = graph_page(page, scale, format);
    if (format == PictureFormat::png)
        budget.check_memory(static_cast<std::uint64_t>(4 * drawn.width * drawn.height),
                            "the picture");
    Document document(format, drawn.width, drawn.height, background, output, budget);
    cairo_scale(document.context(), scale, scale);
    picture.draw(document.context());
    check_cairo(document.context());
    document.finish();
    return drawn;
}

}  // namespace

GraphDrawn draw_graph(const Graph& graph, const Target& target, PictureFormat format,
                      const GraphOptions& options, const Budget& budget) {
    check_side("width", options.width, format);
    check_side("height", options.height, format);
    GraphDrawn drawn;
    write_to(target, [&](Output& output) { drawn = draw(graph, output, format, options, budget); });
    return drawn;
}

}  // namespace algae
