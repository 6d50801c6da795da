#include "render/detail/mask.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

#include "exact/exact.hpp"
#include "render/detail/document.hpp"

// A bitmap for figures that are finer than the pixels of their picture: what a word of any length costs is then its pixels.
//
// Each pixel has `cells` by `cells` bits. A line marks the cells along it (a digital line); parts outside are clipped
// (Liang and Barsky 1984). In the usual case, the next point is in the same cell or in one of its neighbours, and one comparison of
// unsigned differences decides it, inline. Nothing is as thick as a stroke yet: marks are widened all at once when the bitmap is
// taken, a row of bits at a time, by the runs of a disc. Narrow runs come first, so that one row of bits is widened
// step by step, 64 cells with each operation. A ring of as many rows as the disc has is enough. The coverage of a pixel is then the count
// of its bits. Polygons are filled into a bitmap of their own by the nonzero rule, because they are not thickened.
//
// Subtle: a disc of an even number of rows stands around a corner of cells, one of an odd number around the middle of a cell. Only
// the diameter is rounded, so that thin lines are true on average, and marks of even discs are offset by half a cell.

namespace algae {
namespace {

/// The part of a line inside [0, right] x [0, bottom] (Liang and Barsky 1984).
std::optional<std::pair<Point, Point>> clipped(Point from, Point to, double right, double bottom) {
    double enters = 0, leaves = 1;
    const double dx = to.x - from.x, dy = to.y - from.y;
    const auto cut = [&](double towards, double room) {
        if (towards == 0) return room >= 0;
        const double at = room / towards;
        if (towards < 0)
            enters = std::max(enters, at);
        else
            leaves = std::min(leaves, at);
        return enters <= leaves;
    };
    if (!cut(-dx, from.x) || !cut(dx, right - from.x) || !cut(-dy, from.y) ||
        !cut(dy, bottom - from.y))
        return std::nullopt;
    const auto at = [&](double part) {
        return Point{std::clamp(from.x + part * dx, 0.0, right),
                     std::clamp(from.y + part * dy, 0.0, bottom)};
    };
    return std::pair{at(enters), at(leaves)};
}

}  // namespace

Mask::Mask(int width, int height, int cells, double diameter)
    : width_(width),
      height_(height),
      cells_(cells),
      columns_(static_cast<std::uint32_t>(width * cells)),
      rows_(static_cast<std::uint32_t>(height * cells)),
      words_((columns_ + 63) / 64),
      right_edge_(columns_),
      bottom_edge_(rows_),
      bits_(words_ * rows_) {
    set_diameter(diameter);
}

void Mask::set_diameter(double diameter) {
    // A disc of an even number of rows stands around a corner of cells, one of an odd number
    // around the middle of a cell: rounding the diameter alone keeps thin lines true on average.
    diameter = diameter >= 1 ? std::min(diameter, 2.0 * (columns_ + rows_)) : 1;
    const int rows = static_cast<int>(std::lround(diameter));
    const bool even = rows % 2 == 0;
    offset_ = even ? 0.5 : 0;
    marked_ = false;
    disc_.clear();
    const int first = -(rows / 2);
    for (int row = first; row < first + rows; ++row) {
        const double away = even ? row + 0.5 : row;
        const double half = std::sqrt(std::max(diameter * diameter / 4 - away * away, 0.25));
        const int beside = even ? std::max(1, static_cast<int>(std::lround(half)))
                                : static_cast<int>(std::lround(half - 0.5));
        disc_.push_back({row, -beside, even ? beside - 1 : beside});
    }
    // Narrow rows first, so that one row of bits can be widened step by step.
    std::stable_sort(disc_.begin(), disc_.end(),
                     [](const Run& a, const Run& b) { return a.first > b.first; });
}

void Mask::long_line(Point to) {
    must_be_finite(here_.x + here_.y + to.x + to.y);
    const Point from{here_.x + offset_, here_.y + offset_};
    const Point target{to.x + offset_, to.y + offset_};
    here_ = to;
    marked_ = false;
    const auto part =
        clipped(from, target, std::nextafter(right_edge_, 0.0), std::nextafter(bottom_edge_, 0.0));
    if (!part) return;
    const auto [start, end] = *part;
    const double dx = end.x - start.x, dy = end.y - start.y;
    const int steps = static_cast<int>(std::ceil(std::max(std::fabs(dx), std::fabs(dy))));
    for (int step = 0; step <= steps; ++step) {
        const double t = steps == 0 ? 0 : static_cast<double>(step) / steps;
        column_ = static_cast<std::uint32_t>(std::clamp(start.x + t * dx, 0.0, right_edge_ - 1));
        row_ = static_cast<std::uint32_t>(std::clamp(start.y + t * dy, 0.0, bottom_edge_ - 1));
        mark(column_, row_);
    }
    marked_ = end == target;
}

void Mask::polygon(std::span<const Point> corners) {
    if (corners.size() < 3) return;
    if (filled_.empty()) filled_.resize(bits_.size());
    double top = rows_, bottom = 0;
    for (const Point& corner : corners) {
        must_be_finite(corner.x + corner.y);
        top = std::min(top, corner.y);
        bottom = std::max(bottom, corner.y);
    }
    const int first = std::max(0, static_cast<int>(std::ceil(std::max(top, 0.0) - 0.5)));
    const int last = static_cast<int>(std::floor(std::min<double>(bottom, rows_) - 0.5));
    std::vector<std::pair<double, int>> crossings;
    for (int row = first; row <= last; ++row) {
        const double y = row + 0.5;
        crossings.clear();
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const Point a = corners[i], b = corners[(i + 1) % corners.size()];
            if ((a.y <= y) == (b.y <= y)) continue;
            crossings.emplace_back(a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x), a.y < b.y ? 1 : -1);
        }
        std::ranges::sort(crossings);
        int winding = 0;
        for (std::size_t i = 0; i + 1 < crossings.size(); ++i) {
            winding += crossings[i].second;
            if (winding == 0) continue;
            const double right = std::min<double>(crossings[i + 1].first, columns_);
            const int begin = static_cast<int>(std::ceil(std::max(crossings[i].first, 0.0) - 0.5));
            const int end = static_cast<int>(std::ceil(right - 0.5));
            if (begin >= end) continue;
            std::uint64_t* words = filled_.data() + static_cast<std::size_t>(row) * words_;
            for (int column = begin; column < end;) {
                const int in_word = column & 63, count = std::min(64 - in_word, end - column);
                const std::uint64_t ones =
                    count == 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << count) - 1;
                words[column >> 6] |= ones << in_word;
                column += count;
            }
            filling_.add(static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end - 1),
                         static_cast<std::uint32_t>(row));
        }
    }
}

/// Adds the thickened row of bits to those of `rows` (a ring of as many rows as the disc has) that
/// the disc reaches. Only the words from `first` to `last` hold anything.
void Mask::dilate(std::vector<std::uint64_t>& rows, std::size_t row, std::size_t first,
                  std::size_t last) {
    const std::size_t count = last - first + 1, ring = disc_.size();
    run_.assign(bits_.begin() + static_cast<std::ptrdiff_t>(row * words_ + first),
                bits_.begin() + static_cast<std::ptrdiff_t>(row * words_ + last + 1));
    next_run_.resize(count);
    int left = 0, right = 0;  // how far the bits have been spread
    const auto spread = [&](bool both) {
        for (std::size_t i = 0; i < count; ++i) {
            const std::uint64_t word = run_[i];
            const std::uint64_t after = i + 1 < count ? run_[i + 1] << 63 : 0;
            const std::uint64_t before = i > 0 ? run_[i - 1] >> 63 : 0;
            next_run_[i] = word | word >> 1 | after | (both ? word << 1 | before : 0);
        }
        run_.swap(next_run_);
        ++left;
        if (both) ++right;
    };
    for (const Run& run : disc_) {
        while (left < -run.first) spread(right < run.last);
        const auto target = static_cast<std::ptrdiff_t>(row) + run.row;
        if (target < 0 || target >= static_cast<std::ptrdiff_t>(rows_)) continue;
        std::uint64_t* into = rows.data() + (static_cast<std::size_t>(target) % ring) * count;
        for (std::size_t i = 0; i < count; ++i) into[i] |= run_[i];
    }
}

Mask::Coverage Mask::take() {
    Coverage result;
    if (is_blank()) return result;
    int reach_up = 0, reach_down = 0, reach_aside = 0;
    for (const Run& run : disc_) {
        reach_up = std::max(reach_up, -run.row);
        reach_down = std::max(reach_down, run.row);
        reach_aside = std::max({reach_aside, -run.first, run.last});
    }
    // The cells that may be covered, then the pixels and words they lie in.
    long left = filling_.left, right = filling_.right, top = filling_.top, bottom = filling_.bottom;
    if (!marks_.is_empty()) {
        left = std::min(left, static_cast<long>(marks_.left) - reach_aside);
        right = std::max(right, static_cast<long>(marks_.right) + reach_aside);
        top = std::min(top, static_cast<long>(marks_.top) - reach_up);
        bottom = std::max(bottom, static_cast<long>(marks_.bottom) + reach_down);
    }
    const auto pixel = [this](long cell, int size) {
        return static_cast<int>(std::clamp<long>(cell, 0, static_cast<long>(size) * cells_ - 1)) /
               cells_;
    };
    result.left = pixel(left, width_);
    result.top = pixel(top, height_);
    result.width = pixel(right, width_) - result.left + 1;
    result.height = pixel(bottom, height_) - result.top + 1;
    result.stride = (static_cast<std::size_t>(result.width) + 3) / 4 * 4;
    result.values.assign(result.stride * static_cast<std::size_t>(result.height), 0);

    const std::size_t first = static_cast<std::size_t>(result.left * cells_) / 64;
    const std::size_t last =
        static_cast<std::size_t>((result.left + result.width) * cells_ - 1) / 64;
    const std::size_t count = last - first + 1, ring = disc_.size();
    std::vector<std::uint64_t> rows(ring * count);
    std::vector<std::uint16_t> sums(static_cast<std::size_t>(result.width));
    const unsigned cells = static_cast<unsigned>(cells_);
    const std::uint64_t ones = (std::uint64_t{1} << cells) - 1;

    long source = std::max<long>(0, static_cast<long>(result.top) * cells_ - reach_down);
    for (int y = result.top; y < result.top + result.height; ++y) {
        std::fill(sums.begin(), sums.end(), 0);
        for (long row = static_cast<long>(y) * cells_; row < (y + 1L) * cells_; ++row) {
            // All rows whose discs reach this one.
            for (; source <= row + reach_up && source < static_cast<long>(rows_); ++source)
                if (!marks_.is_empty() && source >= marks_.top && source <= marks_.bottom)
                    dilate(rows, static_cast<std::size_t>(source), first, last);
            std::uint64_t* covered = rows.data() + (static_cast<std::size_t>(row) % ring) * count;
            if (!filled_.empty()) {
                const std::uint64_t* filled =
                    filled_.data() + static_cast<std::size_t>(row) * words_ + first;
                for (std::size_t i = 0; i < count; ++i) covered[i] |= filled[i];
            }
            for (std::size_t i = 0; i < count; ++i) {
                std::uint64_t word = covered[i];
                if (word == 0) continue;
                covered[i] = 0;
                // Pixels of this word; those outside the rectangle have no bits in it.
                const long base = static_cast<long>((first + i) * (64 / cells)) - result.left;
                while (word != 0) {
                    const long at = std::countr_zero(word) / static_cast<int>(cells);
                    const std::uint64_t bits = word >> (at * cells) & ones;
                    word &= ~(ones << (at * cells));
                    if (base + at >= 0 && base + at < result.width)
                        sums[static_cast<std::size_t>(base + at)] = static_cast<std::uint16_t>(
                            sums[static_cast<std::size_t>(base + at)] + std::popcount(bits));
                }
            }
        }
        unsigned char* values =
            result.values.data() + static_cast<std::size_t>(y - result.top) * result.stride;
        const unsigned all = cells * cells;
        for (std::size_t x = 0; x < sums.size(); ++x)
            values[x] = static_cast<unsigned char>((sums[x] * 255u + all / 2) / all);
    }

    const auto clear = [this](std::vector<std::uint64_t>& bits, Bounds& cells_in) {
        for (std::size_t row = cells_in.top; !cells_in.is_empty() && row <= cells_in.bottom; ++row)
            std::fill(
                bits.begin() + static_cast<std::ptrdiff_t>(row * words_ + cells_in.left / 64),
                bits.begin() + static_cast<std::ptrdiff_t>(row * words_ + cells_in.right / 64 + 1),
                0);
        cells_in = {};
    };
    clear(bits_, marks_);
    clear(filled_, filling_);
    marked_ = false;
    return result;
}

}  // namespace algae
