#include "render/render.hpp"

#include <cairo/cairo.h>
#include <doctest/doctest.h>

#include <set>

#include "exact/exact.hpp"

using namespace algae;

namespace {

/// A PNG with these pixels, row by row from the top; each is opacity, red, green, blue.
std::string png(int width, int height, const std::vector<std::uint32_t>& pixels) {
    cairo_surface_t* image = cairo_image_surface_create(CAIRO_FORMAT_ARGB32, width, height);
    unsigned char* data = cairo_image_surface_get_data(image);
    for (int i = 0; i < width * height; ++i)
        *reinterpret_cast<std::uint32_t*>(
            data + (i / width) * cairo_image_surface_get_stride(image) + 4 * (i % width)) =
            pixels[static_cast<std::size_t>(i)];
    cairo_surface_mark_dirty(image);
    std::string bytes;
    cairo_surface_write_to_png_stream(
        image,
        [](void* to, const unsigned char* from, unsigned int count) {
            static_cast<std::string*>(to)->append(reinterpret_cast<const char*>(from), count);
            return CAIRO_STATUS_SUCCESS;
        },
        &bytes);
    cairo_surface_destroy(image);
    return bytes;
}

constexpr std::uint32_t black = 0xff000000, white = 0xffffffff, grey = 0xff808080, clear = 0;

using Places = std::set<std::array<double, 3>>;

Places places(const PointSet& set) { return Places(set.points.begin(), set.points.end()); }

}  // namespace

TEST_CASE("dark pixels are ink, on white paper, wherever the threshold is") {
    const std::string image = png(3, 2, {black, grey, white, clear, black, white});
    CHECK(is_png(image));
    CHECK(!is_png("axiom F"));
    const PointSet ink = ink_of(image, "a.png", {}, Budget());
    CHECK(ink.detail == 1);
    CHECK(ink.part == "pixel");
    CHECK(places(ink) == Places{{0, 1, 0}, {1, 0, 0}});
    CHECK(places(ink_of(image, "a.png", {0.6, false}, Budget())) ==
          Places{{0, 1, 0}, {1, 1, 0}, {1, 0, 0}});
    CHECK(places(ink_of(image, "a.png", {0.6, true}, Budget())) ==
          Places{{2, 1, 0}, {0, 0, 0}, {2, 0, 0}});
}

TEST_CASE("images that cannot be measured say why") {
    CHECK_THROWS_WITH_AS(
        ink_of(png(2, 1, {white, clear}), "a.png", {}, Budget()),
        "a.png: all 2 x 1 pixels are paper at the threshold 0.50, expected some of both", Error);
    CHECK_THROWS_WITH_AS(
        ink_of(png(2, 1, {black, black}), "a.png", {}, Budget()),
        "a.png: all 2 x 1 pixels are ink at the threshold 0.50, expected some of both", Error);
    CHECK_THROWS_WITH_AS(ink_of(png(2, 1, {black, white}), "a.png", {1.5, false}, Budget()),
                         "the threshold is 1.500000, expected 0 (black) to 1 (white)", Error);
    CHECK_THROWS_AS(ink_of(png(2, 1, {black, white}).substr(0, 30), "a.png", {}, Budget()), Error);
}
