#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "turtle/canvas.hpp"

namespace algae {

/// A bitmap with `cells` by `cells` bits for each pixel, for figures finer than the pixels: lines
/// are marked at a few nanoseconds a cell, then thickened all at once, and the bits of each pixel
/// counted. What remains of a figure of any length is its pixels.
///
/// The route: digital lines, dilation by a disc in runs of bits, area coverage by counting.
class Mask {
public:
    /// Strokes will be `diameter` cells thick, at least 1. Memory: width * height * cells^2 bits.
    Mask(int width, int height, int cells, double diameter);

    /// Marks the cells of a line. Coordinates are in cells, y downward. Throws Error if one is not
    /// a number; parts outside the bitmap are not drawn.
    void line(Point from, Point to) {
        const double x = to.x + offset_, y = to.y + offset_;
        const double u = from.x + offset_, v = from.y + offset_;
        if (inside(x, y) && inside(u, v)) [[likely]] {
            const auto column = static_cast<std::uint32_t>(x), row = static_cast<std::uint32_t>(y);
            const auto column0 = static_cast<std::uint32_t>(u), row0 = static_cast<std::uint32_t>(v);
            // Differences of -1, 0 and 1 become 0, 1 and 2.
            if (column - column0 + 1 <= 2 && row - row0 + 1 <= 2) {
                mark(column0, row0);
                mark(column, row);
                return;
            }
        }
        long_line({u, v}, {x, y});
    }

    /// Marks the cells whose middles lie inside (nonzero winding). Not thickened.
    void polygon(std::span<const Point> corners);

    bool is_blank() const { return left_ > right_ && filled_top_ > filled_bottom_; }

    /// The pixels touched since the last call, as a rectangle of coverages from 0 to 255 in rows
    /// of `stride` bytes. Leaves the bitmap blank.
    struct Coverage {
        int left = 0, top = 0, width = 0, height = 0;
        std::size_t stride = 0;  // a multiple of 4
        std::vector<unsigned char> values;
    };
    Coverage take();

    /// The thickness for lines marked from now on; the bitmap must be blank.
    void set_diameter(double diameter);

private:
    /// One row of the disc: the cells from `first` to `last` beside the marked one.
    struct Run {
        int row, first, last;
    };

    bool inside(double x, double y) const {
        return x >= 0 && x < columns_ && y >= 0 && y < rows_;
    }
    void mark(std::uint32_t column, std::uint32_t row) {
        bits_[row * words_ + (column >> 6)] |= std::uint64_t{1} << (column & 63);
        if (column < left_) left_ = column;
        if (column > right_) right_ = column;
        if (row < top_) top_ = row;
        if (row > bottom_) bottom_ = row;
    }
    void long_line(Point from, Point to);
    void dilate(std::vector<std::uint64_t>& rows, std::size_t row, std::size_t first,
                std::size_t last);

    int width_, height_, cells_;
    std::uint32_t columns_, rows_;
    std::size_t words_;  // in a row
    double offset_ = 0;
    std::vector<Run> disc_;
    std::vector<std::uint64_t> bits_, filled_;
    std::uint32_t left_, right_, top_, bottom_;  // of the marked cells; left > right when none
    std::uint32_t filled_left_, filled_right_, filled_top_, filled_bottom_;
    std::vector<std::uint64_t> run_, next_run_;
};

}  // namespace algae
