#include <cairo.h>

#include <algorithm>
#include <cstdint>
#include <cstring>

#include "exact/exact.hpp"
#include "render/detail/document.hpp"
#include "render/render.hpp"

// The ink of an image: the points whose dimension is measured.
//
// A PNG is read by Cairo, whose pixels have their colours multiplied by their opacity already; they are put on a white sheet. How light a
// pixel is weighs red, green and blue as ITU-R BT.709 does, and a threshold tells ink from paper. An image that is all ink or all
// paper at its threshold is an error and not a set, because nothing was told apart. Points stand a pixel apart, x to the right and y upward.

namespace algae {

namespace {

constexpr std::string_view signature = "\x89PNG\r\n\x1a\n";

cairo_status_t read_bytes(void* source, unsigned char* to, unsigned int count) {
    auto& rest = *static_cast<std::string_view*>(source);
    if (count > rest.size()) return CAIRO_STATUS_READ_ERROR;
    std::memcpy(to, rest.data(), count);
    rest.remove_prefix(count);
    return CAIRO_STATUS_SUCCESS;
}

/// How light a pixel is on a white sheet, 0 to 1. Its colours are multiplied with its opacity already.
double lightness(std::uint32_t pixel, bool has_alpha) {
    const double opacity = has_alpha ? static_cast<double>(pixel >> 24) : 255;
    const double red = pixel >> 16 & 255, green = pixel >> 8 & 255, blue = pixel & 255;
    return (0.2126 * red + 0.7152 * green + 0.0722 * blue + 255 - opacity) /
           255;  // weights of ITU-R BT.709
}

}  // namespace

bool is_png(std::string_view bytes) { return bytes.starts_with(signature); }

PointSet ink_of(std::string_view png, const std::string& name, const InkOptions& options,
                const Budget& budget) {
    if (!(options.threshold >= 0 && options.threshold <= 1))
        throw Error("the threshold is " + std::to_string(options.threshold) +
                    ", expected 0 (black) to 1 (white)");
    constexpr std::size_t size_at = 16;  // width and height, four bytes each, the highest first
    const auto number = [&](std::size_t from) {
        std::uint64_t value = 0;
        for (std::size_t i = 0; i < 4 && from + i < png.size(); ++i)
            value = value << 8 | static_cast<unsigned char>(png[from + i]);
        return value;
    };
    // The decoder has all pixels, and a copy of them.
    budget.check_memory(number(size_at) * number(size_at + 4) * 8, "the pixels of the image");
    std::string_view rest = png;
    const OwnedSurface image(cairo_image_surface_create_from_png_stream(read_bytes, &rest));
    if (const cairo_status_t status = cairo_surface_status(image.get());
        status != CAIRO_STATUS_SUCCESS)  // "out of memory" too is what Cairo says of a damaged one
        throw Error(name + ": expected a PNG image, found one that is damaged or ends too early");
    const cairo_format_t format = cairo_image_surface_get_format(image.get());
    if (format != CAIRO_FORMAT_ARGB32 && format != CAIRO_FORMAT_RGB24)
        throw Error(name + ": expected an image with 8 bits for each colour");
    cairo_surface_flush(image.get());
    const int width = cairo_image_surface_get_width(image.get()),
              height = cairo_image_surface_get_height(image.get());
    const int stride = cairo_image_surface_get_stride(image.get());
    const unsigned char* const data = cairo_image_surface_get_data(image.get());
    PointSet ink;
    ink.detail = 1;
    ink.part = "pixel";
    for (int row = 0; row < height; ++row) {
        budget.check();
        budget.check_memory(ink.points.size() * sizeof(ink.points[0]), "the pixels of the image");
        for (int column = 0; column < width; ++column) {
            std::uint32_t pixel = 0;
            std::memcpy(&pixel, data + static_cast<std::ptrdiff_t>(row) * stride + 4 * column,
                        sizeof pixel);
            const bool dark = lightness(pixel, format == CAIRO_FORMAT_ARGB32) < options.threshold;
            if (dark != options.invert)
                ink.points.push_back(
                    {static_cast<double>(column), static_cast<double>(height - 1 - row), 0});
        }
    }
    const std::size_t pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    if (ink.points.empty() || ink.points.size() == pixels)
        throw Error(name + ": all " + std::to_string(width) + " x " + std::to_string(height) +
                    " pixels are " + (ink.points.empty() ? "paper" : "ink") + " at the threshold " +
                    std::to_string(options.threshold).substr(0, 4) + ", expected some of both");
    return ink;
}

}  // namespace algae
