#pragma once

#include <cairo/cairo.h>

#include <cmath>
#include <cstring>
#include <sstream>
#include <string>
#include <vector>

namespace algae::test {

/// The pixels of a png, read back: red, green, blue and opacity from 0 to 255.
struct Pixels {
    int width = 0, height = 0;
    std::vector<unsigned char> values;  // four bytes a pixel: blue, green, red, opacity

    explicit Pixels(const std::string& png) {
        struct Source {
            const std::string& bytes;
            std::size_t at = 0;
        } source{png};
        cairo_surface_t* image = cairo_image_surface_create_from_png_stream(
            [](void* closure, unsigned char* into, unsigned int count) {
                Source& from = *static_cast<Source*>(closure);
                if (from.at + count > from.bytes.size()) return CAIRO_STATUS_READ_ERROR;
                std::memcpy(into, from.bytes.data() + from.at, count);
                from.at += count;
                return CAIRO_STATUS_SUCCESS;
            },
            &source);
        take(image);
        cairo_surface_destroy(image);
    }
    explicit Pixels(cairo_surface_t* image) { take(image); }

    int red(int x, int y) const { return at(x, y, 2); }
    int green(int x, int y) const { return at(x, y, 1); }
    int blue(int x, int y) const { return at(x, y, 0); }
    int opacity(int x, int y) const { return at(x, y, 3); }

private:
    void take(cairo_surface_t* image) {
        if (cairo_surface_status(image) != CAIRO_STATUS_SUCCESS) return;
        width = cairo_image_surface_get_width(image);
        height = cairo_image_surface_get_height(image);
        const auto* rows = cairo_image_surface_get_data(image);
        const auto stride = static_cast<std::size_t>(cairo_image_surface_get_stride(image));
        for (int y = 0; y < height; ++y) {
            const auto* row = rows + static_cast<std::size_t>(y) * stride;
            values.insert(values.end(), row, row + 4 * static_cast<std::size_t>(width));
        }
        if (cairo_image_surface_get_format(image) == CAIRO_FORMAT_RGB24)
            for (std::size_t i = 3; i < values.size(); i += 4) values[i] = 255;
    }
    int at(int x, int y, int part) const {
        return values.at(static_cast<std::size_t>((y * width + x) * 4 + part));
    }
};

/// The mean absolute difference of two pictures of one size, in percent of the grey scale.
inline double difference(const Pixels& left, const Pixels& right) {
    if (left.width != right.width || left.height != right.height) return 100;
    double sum = 0;
    for (std::size_t i = 0; i < left.values.size(); i += 4)
        for (std::size_t part = 0; part < 3; ++part)
            sum += std::abs(left.values[i + part] - right.values[i + part]);
    return 100 * sum / 255 / 3 / (static_cast<double>(left.values.size()) / 4);
}

}  // namespace algae::test
