#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "turtle/turtle.hpp"

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

    /// Sets the point where the next line starts. Coordinates are in cells, y downward.
    void start(Point point) {
        here_ = point;
        marked_ = false;
    }
    /// Marks the cells of a line from where the last one ended. Throws Error if a coordinate is not
    /// a number; parts outside the bitmap are not drawn.
    void line_to(Point to) {
        const double x = to.x + offset_, y = to.y + offset_;
        if (marked_ && x >= 0 && x < right_edge_ && y >= 0 && y < bottom_edge_) [[likely]] {
            const auto column = static_cast<std::uint32_t>(x), row = static_cast<std::uint32_t>(y);
            // Differences of -1, 0 and 1 become 0, 1 and 2.
            if (column - column_ + 1 <= 2 && row - row_ + 1 <= 2) {
                here_ = to;
                if (column == column_ && row == row_) return;
                column_ = column;
                row_ = row;
                mark(column, row);
                return;
            }
        }
        long_line(to);
    }

    /// Marks the cells whose middles lie inside (nonzero winding). Not thickened.
    void polygon(std::span<const Point> corners);

    bool is_blank() const { return marks_.is_empty() && filling_.is_empty(); }

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
    /// A rectangle around cells.
    struct Bounds {
        std::uint32_t left = UINT32_MAX, right = 0, top = UINT32_MAX, bottom = 0;

        bool is_empty() const { return left > right; }
        void add(std::uint32_t from, std::uint32_t to, std::uint32_t row) {
            if (from < left) left = from;
            if (to > right) right = to;
            if (row < top) top = row;
            if (row > bottom) bottom = row;
        }
    };

    /// One row of the disc: the cells from `first` to `last` beside the marked one.
    struct Run {
        int row, first, last;
    };

    void mark(std::uint32_t column, std::uint32_t row) {
        bits_[row * words_ + (column >> 6)] |= std::uint64_t{1} << (column & 63);
        marks_.add(column, column, row);
    }
    void long_line(Point to);
    void dilate(std::vector<std::uint64_t>& rows, std::size_t row, std::size_t first,
                std::size_t last);

    int width_, height_, cells_;
    std::uint32_t columns_, rows_;
    std::size_t words_;  // in a row
    double offset_ = 0;  // of marks against middles of cells
    double right_edge_, bottom_edge_;
    Point here_{};
    std::uint32_t column_ = 0, row_ = 0;  // of the cell that holds `here_`
    bool marked_ = false;                 // whether that is so, and it is marked
    std::vector<Run> disc_;
    std::vector<std::uint64_t> bits_, filled_;
    Bounds marks_, filling_;  // of the marked cells and of filled polygons
    std::vector<std::uint64_t> run_, next_run_;
};

}  // namespace algae
