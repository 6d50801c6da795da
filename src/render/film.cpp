#include "render/film.hpp"

#include <cairo.h>

#include <algorithm>
#include <cstring>
#include <memory>

#include "render/document.hpp"
#include "render/drawing.hpp"

namespace algae {
namespace {

constexpr double share_of_drawing = 0.7;  // the rest of the work is packing frames

/// The rows of an image surface, one after the other.
std::vector<std::uint32_t> pixels_of(cairo_surface_t* surface, int width, int height, bool opaque) {
    cairo_surface_flush(surface);
    const unsigned char* const data = cairo_image_surface_get_data(surface);
    const auto stride = static_cast<std::size_t>(cairo_image_surface_get_stride(surface));
    const auto across = static_cast<std::size_t>(width), down = static_cast<std::size_t>(height);
    std::vector<std::uint32_t> pixels(across * down);
    for (std::size_t y = 0; y < down; ++y)
        std::memcpy(pixels.data() + y * across, data + y * stride, across * sizeof(std::uint32_t));
    if (opaque)
        for (std::uint32_t& pixel : pixels) pixel |= 0xff000000u;
    return pixels;
}

/// The least rectangle in which two pictures differ; one pixel if they are equal.
PixelRectangle difference(const std::vector<std::uint32_t>& before,
                          const std::vector<std::uint32_t>& after, int width, int height) {
    int left = width, right = -1, top = height, bottom = -1;
    for (int y = 0; y < height; ++y) {
        const auto row = static_cast<std::ptrdiff_t>(y) * width;
        const auto begin = after.begin() + row, end = begin + width;
        const auto first = std::mismatch(begin, end, before.begin() + row).first;
        if (first == end) continue;
        auto last = end;
        while (*(last - 1) == before[static_cast<std::size_t>(last - 1 - after.begin())]) --last;
        left = std::min(left, static_cast<int>(first - begin));
        right = std::max(right, static_cast<int>(last - begin) - 1);
        top = std::min(top, y);
        bottom = y;
    }
    if (right < 0) return {0, 0, 1, 1};
    return {left, top, right - left + 1, bottom - top + 1};
}

FilmFrame cut_out(const std::vector<std::uint32_t>& picture, const PixelRectangle& area,
                  int width) {
    FilmFrame frame;
    frame.area = area;
    for (int y = area.top; y < area.top + area.height; ++y) {
        const auto row = picture.begin() + static_cast<std::ptrdiff_t>(y) * width + area.left;
        frame.pixels.insert(frame.pixels.end(), row, row + area.width);
    }
    return frame;
}

}  // namespace

void Film::show(std::size_t frame, std::vector<std::uint32_t>& picture) const {
    picture.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    const FilmFrame& change = frames.at(frame);
    auto from = change.pixels.begin();
    for (int y = change.area.top; y < change.area.top + change.area.height; ++y) {
        std::copy_n(from, change.area.width,
                    picture.begin() + static_cast<std::ptrdiff_t>(y) * width + change.area.left);
        from += change.area.width;
    }
}

Film film(std::span<const Plate> plates, const Plan& plan, const Budget& budget, Progress* progress,
          Drawn& drawn) {
    Film result;
    result.width = static_cast<int>(plan.page.width);
    result.height = static_cast<int>(plan.page.height);
    result.opaque = plan.background.has_value();
    drawn.width = plan.page.width;
    drawn.height = plan.page.height;
    double all = 0, done = 0;
    for (const Plate& plate : plates) all += work(*plate.figure);
    all /= share_of_drawing;
    std::uint64_t taken = 0;
    std::vector<std::uint32_t> before;
    for (std::size_t i = 0; i < plates.size(); ++i) {
        budget.check();
        const double next = done + work(*plates[i].figure);
        const Share share(progress, done / all, next / all);
        done = next;
        const std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)> surface(
            cairo_image_surface_create(result.opaque ? CAIRO_FORMAT_RGB24 : CAIRO_FORMAT_ARGB32,
                                       result.width, result.height),
            cairo_surface_destroy);
        const std::unique_ptr<cairo_t, decltype(&cairo_destroy)> context(
            cairo_create(surface.get()), cairo_destroy);
        check_cairo(context.get());
        if (plan.background) {
            const Colour& paper = *plan.background;
            cairo_set_source_rgb(context.get(), paper.red, paper.green, paper.blue);
            cairo_paint(context.get());
        }
        draw_plate(context.get(), plan, i, plates[i], budget, share, drawn);
        check_cairo(context.get());
        std::vector<std::uint32_t> picture =
            pixels_of(surface.get(), result.width, result.height, result.opaque);
        const PixelRectangle area = i == 0
                                        ? PixelRectangle{0, 0, result.width, result.height}
                                        : difference(before, picture, result.width, result.height);
        taken += sizeof(std::uint32_t) * static_cast<std::uint64_t>(area.width) *
                 static_cast<std::uint64_t>(area.height);
        budget.check_memory(taken, "what changes from frame to frame of an animation");
        result.frames.push_back(cut_out(picture, area, result.width));
        before = std::move(picture);
    }
    return result;
}

}  // namespace algae
