#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>

#include "dimension/detail/measures.hpp"
#include "watch/watch.hpp"

// The dimension of what a picture shows, from boxes of one pixel to half of the whole.
//
// A grid that lies badly counts too many boxes, and the mean over some places of it wavers. Here it is the mean over all of
// them: a box of e pixels touches the ink where its corner lies in the ink dilated by e - 1 pixels to the
// left and downward, so that the mean is the number of pixels of that divided by e^2 (the Minkowski sausage, with squares for discs).
//
// Such means follow e^-D only where e is small, which pixels do not allow: a filled square of S pixels touches (S / e + 1)^2 boxes and a
// straight stroke S / e + 1, as boxes at their edges hang over. And where pixels follow the grid of the set itself, as cells of an
// automaton do, too few small boxes are touched. So what is fitted is
//
//     boxes(e) = a e^-2 (e - d)^(2 - D) (1 + b (e / S)^c),  b >= 0, d < 1
//
// For a square and a stroke c is 1; for what fills the plane and has a boundary of the dimension B it is 2 - B. The value is the middle
// one of three, with c of 7/8 and boxes up to a quarter of the whole: from 1 pixel on with d as it fits best, from 3 and from 6 pixels on with d = 0.
// The interval holds what these say with c of 3/4 and 1 for boxes up to a half, a quarter and an eighth of the whole,
// and more on both sides. The exponents and the widening were found by trial on pictures of the sets of theory/dimension/coverage.tsv,
// 128 to 1,024 pixels wide, and on random sets of digits.

namespace algae {

namespace {

constexpr double correction = 0.875;  // c
constexpr std::array<double, 2> other_corrections{0.75, 1};
constexpr double parts_of_whole = 4;
constexpr std::array<double, 3> other_parts{2, 4, 8};
constexpr double widening = 0.6, least_widening = 0.01;
constexpr std::size_t fewest_sides = 5, least_across = 96;
constexpr double finest_shown = 3;  // pixels
constexpr double plane = 2;

/// From how many pixels on boxes are used, and whether d is fitted.
struct Way {
    double finest;
    bool shifts;
};
constexpr std::array<Way, 3> ways{{{1, true}, {3, false}, {6, false}}};

/// The ink by rows: the columns in which a row has it, in order.
struct Rows {
    std::vector<std::uint32_t> columns;
    std::vector<std::size_t> begin;  // of each row, and the end of the last one
};

Rows rows_of(const CellRectangle& ink, std::size_t filled, const Budget& budget) {
    budget.check_memory(filled * sizeof(std::uint32_t) + ink.rows * sizeof(std::size_t),
                        "the ink of a picture");
    Rows rows;
    rows.columns.reserve(filled);
    for (std::size_t y = 0; y < ink.rows; ++y) {
        rows.begin.push_back(rows.columns.size());
        for (std::size_t x = 0; x < ink.columns; ++x)
            if (ink.filled[y * ink.columns + x])
                rows.columns.push_back(static_cast<std::uint32_t>(x));
    }
    rows.begin.push_back(rows.columns.size());
    return rows;
}

/// The pixels of the ink dilated by a square of `side` pixels.
std::uint64_t dilated(const Rows& rows, std::size_t columns, std::int64_t side,
                      const Budget& budget) {
    constexpr std::int64_t never = -(std::int64_t{1} << 40);
    std::vector<std::int64_t> last(columns, never);  // the row with ink that was met last
    const auto height = static_cast<std::int64_t>(rows.begin.size()) - 1;
    std::uint64_t count = 0;
    for (std::int64_t y = 0; y < height + side - 1; ++y) {
        if (y % 64 == 0) budget.check();
        if (y < height) {
            const auto row = static_cast<std::size_t>(y);
            for (std::size_t i = rows.begin[row]; i < rows.begin[row + 1]; ++i)
                last[rows.columns[i]] = y;
        }
        std::int64_t reach = 0;  // the first column that is not covered, of those behind ink
        std::int64_t at = 0;
        for (const std::int64_t met : last) {
            if (y - met < side) {
                count += static_cast<std::uint64_t>(at + side - std::max(at, reach));
                reach = at + side;
            }
            ++at;
        }
    }
    return count;
}

/// What is fitted, with the logarithm of a.
struct Law {
    double constant = 0, dimension = 0, weight = 0, error = HUGE_VAL;
};

/// The boxes of a picture that are used.
class Used {
public:
    Used(const PictureCounts& counts, double least, double most, double exponent) {
        for (std::size_t i = 0; i < counts.sides.size(); ++i) {
            const auto side = static_cast<double>(counts.sides[i]);
            if (side < least || side > most) continue;
            sides_.push_back(side);
            areas_.push_back(std::log(counts.boxes[i]) + 2 * std::log(side));
            powers_.push_back(std::pow(side / static_cast<double>(counts.across), exponent));
        }
    }

    std::size_t size() const { return sides_.size(); }

    /// The law that comes nearest, of this dimension if one is given.
    Law nearest(bool shifts, std::optional<double> dimension = {}) const {
        constexpr int steps = 38;
        Law best;
        double shift = 0;
        if (!shifts) return nearest_at(0, dimension, true);
        for (int i = 0; i <= steps; ++i)
            if (const Law law = nearest_at(-1 + i * 0.05, dimension, false);
                law.error < best.error) {
                best = law;
                shift = -1 + i * 0.05;
            }
        return nearest_at(shift, dimension, true);
    }

private:
    /// Of a series of weights b the best one, and between its neighbours (golden section).
    Law nearest_at(double shift, std::optional<double> dimension, bool exactly) const {
        constexpr int weights = 40, rounds = 40;
        constexpr double golden = 0.6180339887498949;
        std::vector<double> logs;
        for (const double side : sides_) logs.push_back(std::log(side - shift));
        const auto law_at = [&](double place) {
            return line(logs, place <= 0 ? 0 : 0.01 * std::pow(1.23, place), dimension);
        };
        Law best = law_at(0);
        double low = -1;
        for (int i = 1; i <= weights; ++i)
            if (const Law law = law_at(i); law.error < best.error) {
                best = law;
                low = i - 1;
            }
        double high = low + 2;
        for (int i = 0; exactly && i < rounds; ++i) {
            const double left = high - golden * (high - low), right = low + golden * (high - low);
            const Law at_left = law_at(left), at_right = law_at(right);
            const bool is_left = at_left.error <= at_right.error;
            (is_left ? high : low) = is_left ? right : left;
            for (const Law& law : {at_left, at_right})
                if (law.error < best.error) best = law;
        }
        return best;
    }

    /// The line through the logarithms, less the correction of weight b.
    Law line(const std::vector<double>& logs, double weight,
             std::optional<double> dimension) const {
        const auto count = static_cast<double>(logs.size());
        double x = 0, y = 0, xx = 0, xy = 0, yy = 0;
        for (std::size_t i = 0; i < logs.size(); ++i) {
            const double area = areas_[i] - std::log1p(weight * powers_[i]);
            x += logs[i];
            y += area;
            xx += logs[i] * logs[i];
            xy += logs[i] * area;
            yy += area * area;
        }
        xx -= x * x / count, xy -= x * y / count, yy -= y * y / count;
        Law law;
        law.weight = weight;
        law.dimension = dimension.value_or(std::clamp(plane - xy / xx, 0.0, plane));
        const double slope = plane - law.dimension;
        law.constant = (y - slope * x) / count;
        law.error = yy - 2 * slope * xy + slope * slope * xx;
        return law;
    }

    std::vector<double> sides_, areas_, powers_;  // areas: the logarithm of e^2 times the boxes
};

Estimate estimate_of(const PictureCounts& counts) {
    const auto across = static_cast<double>(counts.across);
    std::array<double, ways.size()> values{};
    for (std::size_t i = 0; i < ways.size(); ++i)
        values[i] = Used(counts, ways[i].finest, across / parts_of_whole, correction)
                        .nearest(ways[i].shifts)
                        .dimension;
    std::ranges::sort(values);
    const double value = values[1];
    double low = value, high = value;
    for (const Way& way : ways)
        for (const double parts : other_parts)
            for (const double exponent : other_corrections) {
                const Used used(counts, way.finest, across / parts, exponent);
                if (used.size() < fewest_sides + (way.shifts ? 1 : 0)) continue;
                const double dimension = used.nearest(way.shifts).dimension;
                low = std::min(low, dimension);
                high = std::max(high, dimension);
            }
    const double more = widening * (high - low) + least_widening;
    return {value, std::max(low - more, 0.0), std::min(high + more, plane)};
}

}  // namespace

PictureCounts picture_counts(const CellRectangle& ink, const Budget& budget) {
    const auto filled = static_cast<std::size_t>(std::ranges::count(ink.filled, true));
    if (ink.filled.size() != ink.columns * ink.rows || filled == 0)
        throw Error("expected a rectangle of pixels with ink, found " +
                    std::to_string(ink.filled.size()) + " pixels without");
    const Rows rows = rows_of(ink, filled, budget);
    PictureCounts counts;
    counts.across = std::max(ink.columns, ink.rows);
    for (int halves = 0;; ++halves) {
        const auto side = static_cast<std::size_t>(std::llround(std::exp2(halves / 2.0)));
        if (side > counts.across) break;
        if (counts.sides.empty() || side > counts.sides.back()) counts.sides.push_back(side);
    }
    WorkCount sides("sizes of boxes", counts.sides.size());
    for (const std::size_t side : counts.sides) {
        ++sides;
        const auto width = static_cast<double>(side);
        counts.boxes.push_back(static_cast<double>(dilated(
                                   rows, ink.columns, static_cast<std::int64_t>(side), budget)) /
                               (width * width));
    }
    return counts;
}

BoxFit fit_picture(const PictureCounts& counts, const BoxCounts& shown) {
    BoxFit fit;
    fit.slopes = local_slopes(shown);
    const auto across = static_cast<double>(counts.across);
    if (counts.across < least_across) {
        fit.because =
            fmt::format("the picture is too small: expected ink that is {} pixels across, found {}",
                        least_across, counts.across);
        return fit;
    }
    const double most = across / parts_of_whole;
    for (std::size_t scale = shown.counts.size(); scale-- > 0;) {
        const double cell = shown.scales.cell(scale);
        if (cell < finest_shown || cell > most) continue;
        fit.first = scale;
        fit.last = std::max(fit.last, scale);
    }
    fit.estimate = estimate_of(counts);
    const Law law =
        Used(counts, finest_shown, most, correction).nearest(false, fit.estimate->value);
    // As a line and a term that grows from scale to scale, for the plot.
    const double whole = shown.scales.coarsest;
    fit.slope = law.dimension;
    fit.intercept = law.constant;
    fit.boundary = std::exp(law.constant - law.dimension * std::log(whole)) * law.weight *
                   std::pow(whole / across, correction);
    fit.rate = std::pow(shown.scales.ratio, law.dimension - correction);
    fit.because = fmt::format(
        "boxes up to {:.0f} pixels in all places of the grid, less what hangs over the outer shape "
        "and what single pixels hide",
        most);
    return fit;
}

}  // namespace algae
