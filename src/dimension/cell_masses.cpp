#include "dimension/cell_masses.hpp"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "base/error.hpp"
#include "dimension/cell_walk.hpp"
#include "dimension/drawn_segments.hpp"
#include "dimension/morton.hpp"

namespace algae {

namespace {

constexpr double most_cells = 2147483648.0;  // side by side: 31 bits a coordinate

/// The bits of one coordinate of a code.
std::uint64_t bits_of(int coordinate, int columns) {
    std::uint64_t mask = 0;
    for (int bit = coordinate; bit < 64; bit += columns) mask |= std::uint64_t{1} << bit;
    return mask;
}

/// Steps to the neighbours on one axis; one beyond 0 has a code that no cell has.
std::uint64_t next(std::uint64_t code, std::uint64_t axis) {
    return (code & ~axis) | (((code | ~axis) + 1) & axis);
}
std::uint64_t previous(std::uint64_t code, std::uint64_t axis) {
    return (code & ~axis) | (((code & axis) - 1) & axis);
}

}  // namespace

void CellMasses::merge() {
    budget_.check();
    std::sort(masses_.begin(), masses_.end(),
              [](const CellMass& a, const CellMass& b) { return a.code < b.code; });
    std::size_t kept = 0;
    for (std::size_t i = 0; i < masses_.size(); ++i)
        if (kept > 0 && masses_[kept - 1].code == masses_[i].code)
            masses_[kept - 1].mass += masses_[i].mass;
        else
            masses_[kept++] = masses_[i];
    masses_.resize(kept);
    limit_ = std::max(limit_, 2 * kept);
    budget_.check_memory(3 * kept * sizeof(CellMass), "the lengths in the cells of a grid");
}

std::vector<CellMass> drawn_masses(const Figure& figure, const Grid& grid, const Budget& budget) {
    const Box& box = figure.box();
    const double most = (most_cells - 1) * grid.cell;
    if (!(box.low.x >= grid.origin.x && box.low.y >= grid.origin.y &&
          box.high.x - grid.origin.x < most && box.high.y - grid.origin.y < most))
        throw Error("expected a figure within 2^31 cells right of and above the grid's origin");
    CellMasses masses(budget);
    DrawnSegments canvas([&](Point start, Point end, bool) {
        const GridPoint from = grid.at(start), to = grid.at(end);
        const double length = std::hypot(end.x - start.x, end.y - start.y);
        const bool right = to.x > from.x, up = to.y > from.y;
        Morton cell(static_cast<std::uint64_t>(from.column()),
                    static_cast<std::uint64_t>(from.row()));
        double done = 0;
        walk_cells(from, to, [&](const Crossing& crossing) {
            const double share = crossing.share();
            masses.add(cell.code, (share - done) * length);
            done = share;
            if (crossing.sideways) right ? cell.right() : cell.left();
            if (crossing.upright) up ? cell.up() : cell.down();
        });
        masses.add(cell.code, (1 - done) * length);
    });
    figure.draw(canvas, 0, budget);
    return masses.take();
}

std::vector<CellMass> in_cells_twice_as_wide(const std::vector<CellMass>& cells, int columns) {
    std::vector<CellMass> wider;
    for (const CellMass& cell : cells) {
        const std::uint64_t code = cell.code >> columns;
        if (!wider.empty() && wider.back().code == code)
            wider.back().mass += cell.mass;
        else
            wider.push_back({code, cell.mass});
    }
    return wider;
}

std::vector<double> masses_around(const std::vector<CellMass>& cells, int columns) {
    std::unordered_map<std::uint64_t, double> mass_of;
    mass_of.reserve(cells.size());
    for (const CellMass& cell : cells) mass_of.emplace(cell.code, cell.mass);
    std::vector<double> around;
    around.reserve(cells.size());
    std::vector<std::uint64_t> codes;
    for (const CellMass& cell : cells) {
        codes.assign(1, cell.code);
        for (int i = 0; i < columns; ++i) {
            const std::uint64_t axis = bits_of(i, columns);
            for (std::size_t k = codes.size(); k-- > 0;) {
                codes.push_back(next(codes[k], axis));
                codes.push_back(previous(codes[k], axis));
            }
        }
        double sum = 0;
        for (const std::uint64_t code : codes)
            if (const auto found = mass_of.find(code); found != mass_of.end()) sum += found->second;
        around.push_back(sum);
    }
    return around;
}

}  // namespace algae
