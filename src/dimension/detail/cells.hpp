#pragma once

// The cells of a grid that segments touch, as boxes are counted and measures are put into boxes.

#include <cmath>
#include <cstdlib>

#include "dimension/dimension.hpp"

namespace algae {

/// A grid of squares. Cell (i, j) is the half-open square of the points with
/// i * cell <= x - origin.x < (i + 1) * cell, and the same for y: every point lies in exactly one
/// cell, so what runs along a border is counted once.
///
/// Coordinates are rounded to a fraction 2^-20 of a cell before anything is decided, and every
/// decision after that is exact. So points of a lattice whose doubles differ in the last digits are
/// one point, and a lattice point on a border stays on it.
struct Grid {
    Point origin;
    double cell = 1;

    static constexpr int fraction_bits = 20;

    /// The grid of this cell, moved by shares (0 <= share < 1) of `around`, whose cell (0, 0) holds
    /// the lower left corner of the box.
    static Grid before(const Box& box, double cell, Point shares, double around) {
        return {{box.low.x - shares.x * around, box.low.y - shares.y * around}, cell};
    }
    /// The place of a point in it, which must lie within 2^42 cells of the origin.
    struct GridPoint at(Point point) const;
    bool operator==(const Grid&) const = default;
};

/// A point in units of 2^-20 of a cell, relative to the origin of a grid.
struct GridPoint {
    std::int64_t x = 0, y = 0;

    std::int64_t column() const { return x >> Grid::fraction_bits; }
    std::int64_t row() const { return y >> Grid::fraction_bits; }
    bool operator==(const GridPoint&) const = default;
};

inline GridPoint Grid::at(Point point) const {
    const double parts = static_cast<double>(std::int64_t{1} << fraction_bits) / cell;
    return {static_cast<std::int64_t>(std::floor((point.x - origin.x) * parts + 0.5)),
            static_cast<std::int64_t>(std::floor((point.y - origin.y) * parts + 0.5))};
}

/// The border that a segment goes over from one cell to the next; both where it goes through a
/// corner.
struct Crossing {
    bool sideways = false, upright = false;
    std::int64_t way = 0, whole = 1;  // how far along the segment, in units that do not matter

    /// The share of the segment before the border.
    double share() const { return static_cast<double>(way) / static_cast<double>(whole); }
};

/// Goes from cell to cell along a segment (Amanatides and Woo 1987) and calls `step(crossing)` at
/// each border, decided exactly. A cell holds its left and lower borders. O(cells).
template <class Step>
void walk_cells(GridPoint from, GridPoint to, Step&& step) {
    __extension__ using Wide = __int128;
    constexpr std::int64_t cell_width = std::int64_t{1} << Grid::fraction_bits;
    const auto way_to_border = [](std::int64_t coordinate, bool upward) {
        const std::int64_t within = coordinate & (cell_width - 1);
        return upward ? cell_width - within : within;
    };
    const bool right = to.x > from.x, up = to.y > from.y;
    const std::int64_t width = std::abs(to.x - from.x), height = std::abs(to.y - from.y);
    std::int64_t columns = std::abs(to.column() - from.column()),
                 rows = std::abs(to.row() - from.row());
    std::int64_t way_right = way_to_border(from.x, right), way_up = way_to_border(from.y, up);
    // Which border comes first: that of the column if `ahead` is negative, that of the row if it is
    // positive. As a cell holds its left and lower borders, going right or up one is in the next
    // cell on the border already, going left or down only beyond it.
    Wide ahead = Wide{way_right} * height - Wide{way_up} * width;
    const Wide per_column = Wide{cell_width} * height, per_row = Wide{cell_width} * width;
    while (columns > 0 || rows > 0) {
        Crossing crossing{rows == 0 || ahead < 0, columns == 0 || ahead > 0, 0, 1};
        if (columns > 0 && rows > 0 && ahead == 0) {
            crossing.sideways = right || !up;
            crossing.upright = up || !right;
        }
        crossing.sideways = crossing.sideways && columns > 0;
        crossing.upright = crossing.upright && rows > 0;
        crossing.way = crossing.sideways ? way_right : way_up;
        crossing.whole = crossing.sideways ? width : height;
        if (crossing.sideways) {
            way_right += cell_width;
            ahead += per_column;
            --columns;
        }
        if (crossing.upright) {
            way_up += cell_width;
            ahead -= per_row;
            --rows;
        }
        step(crossing);
    }
}

/// The bits of a coordinate in the even places: 0b101 becomes 0b010001. Below 2^32.
///
/// Example: spread_bits(5) == 17
constexpr std::uint64_t spread_bits(std::uint64_t coordinate) {
    std::uint64_t bits = coordinate & 0xffffffffu;
    bits = (bits | bits << 16) & 0x0000ffff0000ffffu;
    bits = (bits | bits << 8) & 0x00ff00ff00ff00ffu;
    bits = (bits | bits << 4) & 0x0f0f0f0f0f0f0f0fu;
    bits = (bits | bits << 2) & 0x3333333333333333u;
    return (bits | bits << 1) & 0x5555555555555555u;
}

/// The place of a cell in Morton order (Morton 1966): the bits of column and row in turns. The four
/// cells of a square twice as wide follow each other, and so do the 64 of one eight times as wide.
struct Morton {
    static constexpr std::uint64_t columns = 0x5555555555555555u, rows = ~columns;

    std::uint64_t code = 0;

    constexpr Morton() = default;
    constexpr Morton(std::uint64_t column, std::uint64_t row)
        : code(spread_bits(column) | spread_bits(row) << 1) {}

    // A step to the next cell carries through the bits of one coordinate and leaves the other.
    constexpr void right() { code = (code & rows) | (((code | rows) + 1) & columns); }
    constexpr void left() { code = (code & rows) | (((code & columns) - 1) & columns); }
    constexpr void up() { code = (code & columns) | (((code | columns) + 1) & rows); }
    constexpr void down() { code = (code & columns) | (((code & rows) - 1) & rows); }
    /// By so many columns and rows, each -1, 0 or 1: numbers with spread bits are added as others are, with the bits
    /// between them set.
    constexpr void by(std::int64_t across, std::int64_t upward) {
        constexpr std::uint64_t ways[3][2] = {{columns, rows}, {0, 0}, {1, 2}};
        code = (((code | rows) + ways[across + 1][0]) & columns) |
               (((code | columns) + ways[upward + 1][1]) & rows);
    }
    bool operator==(const Morton&) const = default;
};

/// Which of the 16 quarters of an 8 by 8 tile hold a bit: bit k of the result stands for bits
/// 4 k to 4 k + 3, four cells that make one twice as wide.
///
/// Example: quarters(0xf0000000000000ffu) == 0x8003u
constexpr std::uint64_t quarters(std::uint64_t tile) {
    tile |= tile >> 1;
    tile |= tile >> 2;
    tile &= 0x1111111111111111u;
    tile = (tile | tile >> 3) & 0x0303030303030303u;
    tile = (tile | tile >> 6) & 0x000f000f000f000fu;
    tile = (tile | tile >> 12) & 0x000000ff000000ffu;
    return (tile | tile >> 24) & 0xffffu;
}

/// A set of cells as bits, in tiles of 8 by 8 cells in Morton order. Dense where all tiles are
/// kept, sparse where only tiles that hold something are, in a hash table. Marking takes a few
/// nanoseconds; both give the same counts.
class CellSet {
public:
    enum class Storage { dense, sparse };

    /// How many columns and rows a dense set should have at most: 2^13, 8 MB of bits.
    static constexpr int most_dense_bits = 13;

    /// For columns and rows from 0 to 2^bits - 1, bits at most 31. Throws BoundReached if a dense
    /// set would take more than the budget's memory; a sparse one throws from `mark`.
    CellSet(int bits, Storage storage, const Budget& budget);

    void mark(Morton cell) {
        const std::uint64_t tile = cell.code >> 6;
        if (storage_ == Storage::dense)
            words_[tile] |= std::uint64_t{1} << (cell.code & 63);
        else
            mark_sparse(tile, std::uint64_t{1} << (cell.code & 63));
    }

    /// How many cells are marked; then in squares of 2 by 2 of them, of 4 by 4, and so on:
    /// `halvings` + 1 numbers. Empties the set. O(tiles).
    std::vector<std::uint64_t> take_counts(int halvings);

    /// The bytes that the set takes.
    std::uint64_t memory() const {
        return (words_.capacity() + keys_.capacity()) * sizeof(std::uint64_t);
    }

private:
    static constexpr std::uint64_t nobody = ~std::uint64_t{0};

    void mark_sparse(std::uint64_t tile, std::uint64_t bit) {
        if (tile != last_tile_) {
            last_slot_ = slot(tile);
            last_tile_ = tile;
        }
        words_[last_slot_] |= bit;
    }
    /// Where the tile is in the table, put in if it was not.
    std::size_t slot(std::uint64_t tile);
    std::size_t home(std::uint64_t tile) const {
        return static_cast<std::size_t>((tile * 0x9E3779B97F4A7C15u) >> shift_);
    }
    void grow();
    /// Leaves the tiles that hold something in Morton order, at the front of both lists.
    void sort_tiles();

    Storage storage_;
    Budget budget_;
    std::vector<std::uint64_t> words_;
    std::vector<std::uint64_t> keys_;  // of tiles, where sparse
    std::size_t tiles_ = 0;
    int shift_ = 0;  // the top bits of a hash are the place
    std::uint64_t last_tile_ = nobody;
    std::size_t last_slot_ = 0;
};

/// The cells of one grid that segments touch.
class TouchedCells {
public:
    /// Everything touched must have coordinates of at most `reach` cells from the grid's origin to
    /// the right and upward. Dense if that is small. Throws BoundReached if it is 2^31 or more.
    TouchedCells(const Grid& grid, double reach, const Budget& budget);
    TouchedCells(const Grid& grid, int bits, CellSet::Storage storage, const Budget& budget);

    /// Where the next segment starts; marks its cell.
    void start(Point point) { start(pen_, at(point)); }
    /// Marks the cells of the segment from where the last one ended.
    void line_to(Point point) { step(pen_, at(point)); }
    /// The strokes of a block that begins at `from`, where the last segment ended.
    void follow(const std::vector<StrokeBlock::Stroke>& strokes, Point from) {
        Pen pen = pen_;  // in registers, whatever is marked
        for (const StrokeBlock::Stroke& stroke : strokes) {
            const GridPoint to = at({from.x + stroke.to.x, from.y + stroke.to.y});
            stroke.lifted ? start(pen, to) : step(pen, to);
        }
        pen_ = pen;
    }
    CellSet& cells() { return cells_; }

private:
    struct Pen {
        GridPoint here;
        Morton cell;  // of here
    };

    GridPoint at(Point point) const {
        // The comparison also holds back what is not a number.
        const double x = (point.x - grid_.origin.x) * scale_ + 0.5;
        const double y = (point.y - grid_.origin.y) * scale_ + 0.5;
        if (!(x >= 0 && x < end_ && y >= 0 && y < end_)) [[unlikely]]
            outside(point);
        return {static_cast<std::int64_t>(x), static_cast<std::int64_t>(y)};
    }
    void start(Pen& pen, GridPoint to) {
        pen = {to, Morton(static_cast<std::uint64_t>(to.column()),
                          static_cast<std::uint64_t>(to.row()))};
        cells_.mark(pen.cell);
    }
    /// Marks the cells behind the pen's up to the one of `to`.
    void step(Pen& pen, GridPoint to) {
        if (((to.x ^ pen.here.x) | (to.y ^ pen.here.y)) >> Grid::fraction_bits != 0) {
            const std::int64_t columns = to.column() - pen.here.column(),
                               rows = to.row() - pen.here.row();
            if (columns * columns + rows * rows > 1) {
                pen.cell = crossed(pen, to);
            } else {
                pen.cell.by(columns, rows);
                cells_.mark(pen.cell);
            }
        }
        pen.here = to;
    }
    /// The same where these are more than a neighbour; the last one.
    Morton crossed(Pen pen, GridPoint to);
    [[noreturn]] void outside(Point point) const;

    Grid grid_;
    double scale_;  // from the figure's units to parts of a cell
    double end_;
    Pen pen_;
    CellSet cells_;
};

/// Counts cells for several grids in one pass: a canvas on which a figure is drawn.
class BoxCounter final : public BlockCanvas {
public:
    explicit BoxCounter(std::vector<TouchedCells> grids) : grids_(std::move(grids)) {}

    void move_to(Point point) override {
        here_ = point;
        lifted_ = true;
    }
    void line_to(Point point) override {
        if (lifted_) {
            for (TouchedCells& grid : grids_) grid.start(here_);
            lifted_ = false;
        }
        for (TouchedCells& grid : grids_) grid.line_to(point);
        ++segments_;
    }
    void block(const StrokeBlock& block, Point from) override;
    /// Its outline.
    void polygon(std::span<const Point> corners) override;

    std::vector<TouchedCells>& grids() { return grids_; }
    /// How many segments were drawn.
    std::uint64_t segments() const { return segments_; }

private:
    std::vector<TouchedCells> grids_;
    Point here_;
    bool lifted_ = true;
    std::uint64_t segments_ = 0;
};

/// A canvas that gives every segment drawn to a function `use(from, to, joined)`, those of the
/// outlines of polygons too; `joined` where it goes on from the end of the one before.
template <class Use>
class DrawnSegments final : public Canvas {
public:
    explicit DrawnSegments(Use use) : use_(std::move(use)) {}

    void move_to(Point point) override {
        here_ = point;
        joined_ = false;
    }
    void line_to(Point point) override {
        use_(here_, point, joined_);
        here_ = point;
        joined_ = true;
    }
    void polygon(std::span<const Point> corners) override {
        if (corners.empty()) return;
        move_to(corners.back());
        for (const Point corner : corners) line_to(corner);
        joined_ = false;
    }

private:
    Use use_;
    Point here_;
    bool joined_ = false;
};

/// A cell, by its code (bits of its coordinates in turns, as Morton's), and how much of the measure
/// lies in it.
struct CellMass {
    std::uint64_t code = 0;
    double mass = 0;
    bool operator==(const CellMass&) const = default;
};

/// The length that a figure draws in each cell that it touches, in the half-open cells of a grid
/// and with Morton's codes; outlines of polygons count. A cell may be touched in a point, with mass
/// 0. O(segments * log(cells) + cells crossed).
///
/// Throws Error if the figure reaches beyond the grid's cells 0 to 2^31, BoundReached, Interrupted.
std::vector<CellMass> drawn_masses(const Figure& figure, const Grid& grid, const Budget& budget);

}  // namespace algae
