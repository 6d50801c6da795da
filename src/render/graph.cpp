#include "render/graph.hpp"

#include <cairo.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ostream>

#include "base/error.hpp"
#include "render/document.hpp"
#include "render/graph_page.hpp"
#include "render/output.hpp"
#include "render/tree_layout.hpp"
#include "system/colour.hpp"

namespace algae {

namespace {

constexpr double pixels_of_a_point = 2;    // in png
constexpr double largest_png = 20'000;     // pixels a side
constexpr double largest_vector = 14'400;  // points a side: what PDF readers take (ISO 32000)

double largest(PictureFormat format) {
    return format == PictureFormat::png ? largest_png : largest_vector;
}

void check_side(const char* what, const std::optional<double>& side, PictureFormat format) {
    if (!side || (*side >= 10 && *side <= largest(format))) return;
    char value[32];
    std::snprintf(value, sizeof value, "%.10g", *side);
    throw Error(std::string("the ") + what + " must be from 10 to " +
                std::to_string(static_cast<long>(largest(format))) +
                (format == PictureFormat::png ? " pixels" : " points") + " in " +
                format_name(format) + ", not " + value);
}

std::optional<Colour> background_of(const GraphOptions& options, PictureFormat format) {
    if (options.background) {
        if (*options.background == "transparent") return std::nullopt;
        return colour_named(*options.background);
    }
    if (format == PictureFormat::png) return Colour{1, 1, 1};
    return std::nullopt;
}

/// From points of the page to units of the picture.
double scale_of(const GraphPage& page, PictureFormat format, const GraphOptions& options) {
    if (options.width || options.height)
        return std::min(options.width ? *options.width / page.width() : HUGE_VAL,
                        options.height ? *options.height / page.height() : HUGE_VAL);
    const double natural = format == PictureFormat::png ? pixels_of_a_point : 1;
    return std::min(natural, largest(format) / std::max(page.width(), page.height()));
}

GraphDrawn draw(const Graph& graph, Output& output, PictureFormat format,
                const GraphOptions& options, const Budget& budget) {
    const std::optional<Colour> background = background_of(options, format);
    const GraphLayout layout =
        graph.trees ? tree_layout(graph, budget) : graph_layout(graph, budget);
    const GraphPage page(graph, layout);
    const double scale = scale_of(page, format, options);
    const auto side = [&](double length) {
        const double scaled = length * scale;
        return format == PictureFormat::png ? std::clamp(std::ceil(scaled - 1e-6), 1.0, largest_png)
                                            : std::min(scaled, largest_vector);
    };
    const GraphDrawn drawn{side(page.width()), side(page.height())};
    if (format == PictureFormat::png)
        budget.check_memory(static_cast<std::uint64_t>(4 * drawn.width * drawn.height),
                            "the picture");
    Document document(format, drawn.width, drawn.height, background, output, budget);
    cairo_scale(document.context(), scale, scale);
    page.draw(document.context());
    check_cairo(document.context());
    document.finish();
    return drawn;
}

}  // namespace

GraphDrawn draw_graph(const Graph& graph, const std::string& path, PictureFormat format,
                      const GraphOptions& options, const Budget& budget) {
    check_side("width", options.width, format);
    check_side("height", options.height, format);
    FileOutput file(path);
    const GraphDrawn drawn = draw(graph, file, format, options, budget);
    file.commit();
    return drawn;
}

GraphDrawn draw_graph(const Graph& graph, std::ostream& stream, PictureFormat format,
                      const GraphOptions& options, const Budget& budget) {
    check_side("width", options.width, format);
    check_side("height", options.height, format);
    StreamOutput output(stream);
    const GraphDrawn drawn = draw(graph, output, format, options, budget);
    output.finish();
    return drawn;
}

}  // namespace algae
