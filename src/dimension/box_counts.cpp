#include <algorithm>
#include <bit>
#include <numeric>
#include <tuple>

#include "dimension/detail/cells.hpp"
#include "watch/watch.hpp"

// Counting the cells that a figure touches, in one pass over its segments and some nanoseconds for
// each.
//
// A point is rounded to 2^-20 of a cell, and from then on everything is decided in integers: points
// of a lattice whose doubles differ in the last digits are one point, and half-open cells give
// every point exactly one cell. `walk_cells` (cells.hpp) goes from cell to cell along a segment by
// comparing integers (Amanatides and Woo 1987). Most segments are shorter than a cell: one that
// stays in its cell costs two comparisons inline (`TouchedCells::step`), and a step to one of the
// four neighbours does without the walk. Figures on a lattice send blocks of strokes, so that neither the
// turtle nor a call stands between one stroke and the next (`TouchedCells::follow`).
//
// Cells are bits in tiles of 8 by 8, in Morton order, so that the four cells of a cell twice as
// wide are neighbours in memory: for ratio 2, only the finest scale is marked, and the coarser
// counts are made of it by joining bits (`take_counts`). Dense sets hold all tiles; sparse ones
// hold those that are touched, in a hash table with linear probing, sorted before the counts are
// taken.
//
// Several grids (offsets, and scales for other ratios) are counted in the same pass. Offsets come
// from Roberts' sequence, so results are the same on every machine.

namespace algae {

std::vector<Point> even_offsets(std::size_t count) {
    constexpr double plastic = 1.32471795724474602596;  // x^3 = x + 1
    std::vector<Point> places;
    double x = 0, y = 0;
    for (std::size_t i = 0; i < count; ++i) {
        x = std::fmod(x + 1 / plastic, 1);
        y = std::fmod(y + 1 / (plastic * plastic), 1);
        places.push_back({x, y});
    }
    return places;
}

namespace {

constexpr int first_table_bits = 10;

std::uint64_t number_of_bits(const std::vector<std::uint64_t>& words, std::size_t count) {
    return std::accumulate(words.begin(), words.begin() + static_cast<std::ptrdiff_t>(count),
                           std::uint64_t{0}, [](std::uint64_t sum, std::uint64_t word) {
                               return sum + static_cast<unsigned>(std::popcount(word));
                           });
}

}  // namespace

CellSet::CellSet(int bits, Storage storage, const Budget& budget)
    : storage_(storage), budget_(budget) {
    if (storage == Storage::dense) {
        const std::uint64_t tiles = std::uint64_t{1} << 2 * std::max(bits - 3, 0);
        budget.check_memory(tiles * sizeof(std::uint64_t), "the bits for the cells of a grid");
        words_.assign(tiles, 0);
    } else {
        shift_ = 64 - first_table_bits;
        words_.assign(std::size_t{1} << first_table_bits, 0);
        keys_.assign(words_.size(), nobody);
    }
}

std::size_t CellSet::slot(std::uint64_t tile) {
    const std::size_t mask = keys_.size() - 1;
    std::size_t at = home(tile);
    while (keys_[at] != tile) {
        if (keys_[at] == nobody) {
            if (4 * (tiles_ + 1) > 3 * keys_.size()) {
                grow();
                return slot(tile);
            }
            ++tiles_;
            keys_[at] = tile;
            break;
        }
        at = (at + 1) & mask;
    }
    return at;
}

void CellSet::grow() {
    // While tiles move, the old table and the new one take memory.
    budget_.check_memory(memory() * 3, "the tiles for the cells of a grid");
    budget_.check();
    const std::vector<std::uint64_t> keys =
        std::exchange(keys_, std::vector(keys_.size() * 2, nobody));
    const std::vector<std::uint64_t> words =
        std::exchange(words_, std::vector(keys_.size(), std::uint64_t{0}));
    --shift_;
    const std::size_t mask = keys_.size() - 1;
    for (std::size_t i = 0; i < keys.size(); ++i) {
        if (keys[i] == nobody) continue;
        std::size_t at = home(keys[i]);
        while (keys_[at] != nobody) at = (at + 1) & mask;
        keys_[at] = keys[i];
        words_[at] = words[i];
    }
    last_tile_ = nobody;
}

void CellSet::sort_tiles() {
    std::vector<std::pair<std::uint64_t, std::uint64_t>> tiles;
    budget_.check_memory(memory() + tiles_ * sizeof(tiles[0]), "the tiles for the cells of a grid");
    tiles.reserve(tiles_);
    for (std::size_t i = 0; i < keys_.size(); ++i)
        if (keys_[i] != nobody) tiles.emplace_back(keys_[i], words_[i]);
    std::sort(tiles.begin(), tiles.end());
    for (std::size_t i = 0; i < tiles.size(); ++i) std::tie(keys_[i], words_[i]) = tiles[i];
}

std::vector<std::uint64_t> CellSet::take_counts(int halvings) {
    if (storage_ == Storage::sparse) sort_tiles();
    std::size_t count = storage_ == Storage::dense ? words_.size() : tiles_;
    std::vector<std::uint64_t> counts{number_of_bits(words_, count)};
    for (int i = 0; i < halvings; ++i) {
        // Four tiles that follow each other become one, at or before the place of the first.
        std::size_t kept = 0;
        for (std::size_t from = 0; from < count;) {
            std::uint64_t tile = 0;
            if (storage_ == Storage::dense) {
                for (int k = 0; k < 4 && from < count; ++k, ++from)
                    tile |= quarters(words_[from]) << 16 * k;
            } else {
                const std::uint64_t key = keys_[from] >> 2;
                for (; from < count && keys_[from] >> 2 == key; ++from)
                    tile |= quarters(words_[from]) << 16 * (keys_[from] & 3);
                keys_[kept] = key;
            }
            words_[kept++] = tile;
        }
        count = kept;
        counts.push_back(number_of_bits(words_, count));
    }
    std::fill(words_.begin(), words_.end(), 0);
    std::fill(keys_.begin(), keys_.end(), nobody);
    tiles_ = 0;
    last_tile_ = nobody;
    return counts;
}

namespace {

constexpr std::int64_t cell_width = std::int64_t{1} << Grid::fraction_bits;
constexpr int most_bits = 31;

/// How many bits a column needs that lies so many cells from the origin.
int bits_for(double reach) {
    int bits = 3;
    while (bits <= most_bits && !(reach < std::ldexp(1.0, bits))) ++bits;
    if (bits > most_bits)
        throw BoundReached(Bound::method, "the finest cells are too fine: expected at most 2^" +
                                              std::to_string(most_bits) +
                                              " of them side by side; use fewer scales");
    return bits;
}

}  // namespace

TouchedCells::TouchedCells(const Grid& grid, int bits, CellSet::Storage storage,
                           const Budget& budget)
    : grid_(grid),
      scale_(static_cast<double>(cell_width) / grid.cell),
      end_(std::ldexp(1.0, bits + Grid::fraction_bits)),
      cells_(bits, storage, budget) {}

TouchedCells::TouchedCells(const Grid& grid, double reach, const Budget& budget)
    : TouchedCells(grid, bits_for(reach + 1),
                   reach + 1 < std::ldexp(1.0, CellSet::most_dense_bits) ? CellSet::Storage::dense
                                                                         : CellSet::Storage::sparse,
                   budget) {}

Morton TouchedCells::crossed(Pen pen, GridPoint to) {
    const bool right = to.x > pen.here.x, up = to.y > pen.here.y;
    walk_cells(pen.here, to, [&](const Crossing& crossing) {
        if (crossing.sideways) right ? pen.cell.right() : pen.cell.left();
        if (crossing.upright) up ? pen.cell.up() : pen.cell.down();
        cells_.mark(pen.cell);
    });
    return pen.cell;
}

void TouchedCells::outside(Point point) const {
    throw Error("the figure has the point (" + std::to_string(point.x) + ", " +
                std::to_string(point.y) +
                "), expected all points to lie within its box, which numbers can hold");
}

void BoxCounter::block(const StrokeBlock& block, Point from) {
    if (block.strokes.empty()) return;
    if (lifted_ && !block.strokes.front().lifted)
        for (TouchedCells& grid : grids_) grid.start(here_);
    for (TouchedCells& grid : grids_) grid.follow(block.strokes, from);
    for (const StrokeBlock::Stroke& stroke : block.strokes) segments_ += stroke.lifted ? 0 : 1;
    const StrokeBlock::Stroke& last = block.strokes.back();
    here_ = {from.x + last.to.x, from.y + last.to.y};
    lifted_ = last.lifted;
}

void BoxCounter::polygon(std::span<const Point> corners) {
    if (corners.empty()) return;
    move_to(corners.back());
    for (const Point corner : corners) line_to(corner);
    lifted_ = true;
}

double BoxScales::cell(std::size_t scale) const {
    return coarsest / std::pow(ratio, static_cast<double>(scale));
}

BoxScales scales_of(const Box& box, double ratio, std::size_t count) {
    const double side = std::max(box.breadth(), box.height());
    if (box.empty) throw Error("nothing is drawn: expected something to measure");
    if (!std::isfinite(side) || !(side > 0))
        throw Error("expected a figure that is wider or higher than a point, found a size of " +
                    std::to_string(side));
    return {side, ratio, count};
}

double BoxCounts::mean(std::size_t scale) const {
    const auto& all = counts[scale];
    return std::accumulate(all.begin(), all.end(), 0.0) / static_cast<double>(all.size());
}

namespace {

/// How many cells the farthest corner of the box is from the grid's origin.
double reach(const Grid& grid, const Box& box) {
    return std::max(box.high.x - grid.origin.x, box.high.y - grid.origin.y) / grid.cell;
}

}  // namespace

BoxCounts box_counts(const Figure& figure, const BoxScales& scales, std::span<const Point> offsets,
                     const Budget& budget) {
    const Box& box = figure.box();
    if (box.empty) throw Error("nothing is drawn: expected something to measure");
    if (scales.count == 0 || offsets.empty() || !(scales.coarsest > 0) || !(scales.ratio > 1))
        throw Error(
            "expected at least one scale and one offset, a cell wider than 0 and a ratio above 1");
    const bool halves = scales.ratio == 2;
    Budget share = budget;  // of each grid
    share.memory /= offsets.size() * (halves ? 1 : scales.count);
    std::vector<TouchedCells> grids;
    for (std::size_t scale = halves ? scales.count - 1 : 0; scale < scales.count; ++scale)
        for (const Point offset : offsets) {
            const double cell = scales.cell(scale);
            const Grid grid = Grid::before(box, cell, offset, halves ? scales.coarsest : cell);
            grids.emplace_back(grid, reach(grid, box), share);
        }
    BoxCounter counter(std::move(grids));
    WorkCount segments("segments being counted");
    const Integer& all = figure.segments();
    if (all < Integer(std::uint64_t{1} << 62)) segments.at(all.to_uint64());
    figure.draw(counter, 0, budget);

    BoxCounts result;
    result.scales = scales;
    result.detail = figure.facts().step;
    result.parts = counter.segments();
    if (halves) {
        result.counts.resize(scales.count);
        for (TouchedCells& grid : counter.grids()) {
            auto counts = grid.cells().take_counts(static_cast<int>(scales.count) - 1);
            for (std::size_t scale = 0; scale < scales.count; ++scale)
                result.counts[scale].push_back(counts[scales.count - 1 - scale]);
        }
    } else {
        for (std::size_t i = 0; i < counter.grids().size(); ++i) {
            if (i % offsets.size() == 0) result.counts.emplace_back();
            result.counts.back().push_back(counter.grids()[i].cells().take_counts(0).front());
        }
    }
    return result;
}

}  // namespace algae
