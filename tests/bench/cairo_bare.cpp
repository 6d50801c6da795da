// Koch's snowflake by bare Cairo calls: what a picture costs at least.
//
//     cairo_bare FORMAT GENERATION FILE [LINES_PER_PATH]
//
// draws what `algae draw FILE -n GENERATION -o FILE` draws of the snowflake, with the corners computed
// by recursion and the file written by Cairo itself. One path for all lines unless LINES_PER_PATH
// says otherwise.
#include <cairo-pdf.h>
#include <cairo-ps.h>
#include <cairo-svg.h>
#include <cairo.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>

namespace {

struct Point {
    double x, y;
};

struct Pen {
    cairo_t* context;
    long lines_per_path, pending;

    void move_to(Point point) const { cairo_move_to(context, point.x, point.y); }
    void line_to(Point point) {
        cairo_line_to(context, point.x, point.y);
        if (++pending != lines_per_path) return;
        cairo_stroke(context);
        move_to(point);
        pending = 0;
    }
};

void koch(Pen& pen, Point from, Point to, int generation) {
    if (generation == 0) return pen.line_to(to);
    const double dx = (to.x - from.x) / 3, dy = (to.y - from.y) / 3, h = std::sqrt(3.0) / 2;
    const Point a{from.x + dx, from.y + dy}, c{to.x - dx, to.y - dy};
    const Point b{a.x + dx / 2 + dy * h, a.y + dy / 2 - dx * h};
    koch(pen, from, a, generation - 1);
    koch(pen, a, b, generation - 1);
    koch(pen, b, c, generation - 1);
    koch(pen, c, to, generation - 1);
}

}  // namespace

int main(int count, char** arguments) {
    if (count < 4) {
        std::fprintf(stderr, "usage: cairo_bare svg|pdf|ps|png GENERATION FILE [LINES_PER_PATH]\n");
        return 2;
    }
    const std::string format = arguments[1];
    const int generation = std::atoi(arguments[2]);
    const char* path = arguments[3];
    const auto start = std::chrono::steady_clock::now();

    const bool pixels = format == "png";
    const double longest = pixels ? 1000 : 600, margin = 10;
    const double height = longest, side = (longest - 2 * margin) * std::sqrt(3.0) / 2;
    const double width = pixels ? std::ceil(side + 2 * margin) : side + 2 * margin;
    cairo_surface_t* surface =
        pixels            ? cairo_image_surface_create(CAIRO_FORMAT_RGB24, static_cast<int>(width),
                                                       static_cast<int>(height))
        : format == "svg" ? cairo_svg_surface_create(path, width, height)
        : format == "pdf" ? cairo_pdf_surface_create(path, width, height)
                          : cairo_ps_surface_create(path, width, height);
    cairo_t* context = cairo_create(surface);
    if (pixels) {
        cairo_set_source_rgb(context, 1, 1, 1);
        cairo_paint(context);
        cairo_set_source_rgb(context, 0, 0, 0);
    }
    cairo_set_line_width(context, 1);
    cairo_set_line_cap(context, CAIRO_LINE_CAP_ROUND);
    cairo_set_line_join(context, CAIRO_LINE_JOIN_ROUND);
    Pen pen{context, count > 4 ? std::atol(arguments[4]) : -1, 0};
    // The star of side s is s * 2 / sqrt 3 high; the first two corners lie a quarter below the top.
    const double s = side, top = margin + (longest - 2 * margin) / 4;
    const Point a{margin, top}, b{margin + s, top}, c{margin + s / 2, top + s * std::sqrt(3.0) / 2};
    pen.move_to(a);
    koch(pen, a, b, generation);
    koch(pen, b, c, generation);
    koch(pen, c, a, generation);
    cairo_stroke(context);
    if (pixels) cairo_surface_write_to_png(surface, path);
    cairo_destroy(context);
    cairo_surface_finish(surface);
    cairo_surface_destroy(surface);
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
    std::printf("%.4f\n", taken.count());
}
