#include "nature/cells.hpp"

#include <array>
#include <utility>

#include "base/error.hpp"

namespace algae {

CellGrid::CellGrid(std::size_t width, std::size_t height, const Budget& budget)
    : columns(width), rows(height) {
    if (width == 0 || height == 0) throw Error("a grid has at least one cell");
    if (width > budget.memory / 4 / height)
        throw Error("a grid of " + std::to_string(width) + " x " + std::to_string(height) +
                    " cells does not fit in the " + std::to_string(budget.memory >> 20) +
                    " MiB allowed" + budget.by(Bound::memory));
    cells.resize(width * height);
}

class CellDevelopment::Engine {
public:
    virtual ~Engine() = default;
    virtual void step() = 0;
    virtual std::uint64_t work() const = 0;  // of a step, in words or cells
    virtual CellGrid grid() const = 0;
};

/// A row of bits: cell x is bit x % 64 of word 1 + x / 64. The bit before the first cell and the one
/// behind the last hold what stands there.
class CellDevelopment::Bits final : public Engine {
public:
    Bits(const CellRule& rule, const CellGrid& start, const CellBoundary& boundary)
        : count_(start.columns),
          boundary_(boundary),
          row_(count_ / 64 + 3),
          next_(count_ / 64 + 3) {
        for (std::size_t x = 0; x < count_; ++x)
            if (start.cells[x]) row_[1 + x / 64] |= std::uint64_t{1} << (x & 63);
        // Coefficients of the products of the bits whose numbers are set, by Moebius inversion.
        for (std::size_t product = 0; product < 8; ++product) {
            bool coefficient = false;
            for (std::size_t local = 0; local < 8; ++local)
                if ((local & ~product) == 0) coefficient ^= rule.table[local] != 0;
            factors_[product] = coefficient ? ~std::uint64_t{0} : 0;
        }
    }

    void step() override {
        const std::size_t last = count_ - 1;
        const std::uint64_t outside = boundary_.outside ? 1 : 0;
        const std::uint64_t before =
            boundary_.periodic ? row_[1 + last / 64] >> (last & 63) & 1 : outside;
        const std::uint64_t behind = boundary_.periodic ? row_[1] & 1 : outside;
        row_[0] = before << 63;
        const std::uint64_t bit = std::uint64_t{1} << (count_ & 63);
        std::uint64_t& edge = row_[1 + count_ / 64];
        edge = (edge & (bit - 1)) | (behind ? bit : 0);
        const std::size_t words = count_ / 64 + 1;
        const std::uint64_t* const row = row_.data() + 1;
        std::uint64_t* const next = next_.data() + 1;
        const auto [one, r, c, cr, l, lr, lc, lcr] = factors_;
        for (std::size_t i = 0; i < words; ++i) {
            const std::uint64_t own = row[i];
            const std::uint64_t left = own << 1 | *(row + i - 1) >> 63;
            const std::uint64_t right = own >> 1 | row[i + 1] << 63;
            const std::uint64_t without_left = one ^ (right & (r ^ (own & cr))) ^ (own & c);
            const std::uint64_t with_left = l ^ (right & (lr ^ (own & lcr))) ^ (own & lc);
            next[i] = without_left ^ (left & with_left);
        }
        next_[1 + count_ / 64] &= bit - 1;
        next_[2 + count_ / 64] = 0;
        row_.swap(next_);
    }

    std::uint64_t work() const override { return count_ / 64 + 1; }

    CellGrid grid() const override {
        CellGrid grid;
        grid.columns = count_;
        grid.cells.resize(count_);
        for (std::size_t x = 0; x < count_; ++x)
            grid.cells[x] = static_cast<std::uint8_t>(row_[1 + x / 64] >> (x & 63) & 1);
        return grid;
    }

private:
    std::size_t count_;
    CellBoundary boundary_;
    std::vector<std::uint64_t> row_, next_;
    std::array<std::uint64_t, 8> factors_{};
};

/// A byte for each cell, with a border as wide as the radius around the grid.
class CellDevelopment::Bytes final : public Engine {
public:
    Bytes(const CellRule& rule, const CellGrid& start, const CellBoundary& boundary)
        : rule_(rule),
          columns_(start.columns),
          rows_(start.rows),
          boundary_(boundary),
          border_(static_cast<std::size_t>(rule.radius())),
          border_rows_(rule.dimensions == 1 ? 0 : border_),
          stride_(columns_ + 2 * border_),
          now_(stride_ * (rows_ + 2 * border_rows_), boundary.outside),
          next_(now_) {
        for (std::size_t y = 0; y < rows_; ++y)
            for (std::size_t x = 0; x < columns_; ++x) now_[place(x, y)] = start.at(x, y);
        for (const CellOffset& offset : rule.neighbourhood)
            offsets_.push_back(offset.row * static_cast<std::ptrdiff_t>(stride_) + offset.column);
    }

    void step() override {
        if (boundary_.periodic) wrap();
        for (std::size_t y = 0; y < rows_; ++y)
            for (std::size_t x = 0; x < columns_; ++x) {
                const std::uint8_t* const cell = now_.data() + place(x, y);
                std::size_t local = 0;
                for (const std::ptrdiff_t offset : offsets_)
                    local = local * rule_.states + cell[offset];
                next_[place(x, y)] = rule_.table[local];
            }
        now_.swap(next_);
    }

    std::uint64_t work() const override { return columns_ * rows_; }

    CellGrid grid() const override {
        CellGrid grid;
        grid.columns = columns_;
        grid.rows = rows_;
        for (std::size_t y = 0; y < rows_; ++y)
            for (std::size_t x = 0; x < columns_; ++x) grid.cells.push_back(now_[place(x, y)]);
        return grid;
    }

private:
    std::size_t place(std::size_t x, std::size_t y) const {
        return (y + border_rows_) * stride_ + x + border_;
    }

    /// Fills the border with what stands on the other side, however small the grid is.
    void wrap() {
        for (std::size_t row = 0; row < rows_ + 2 * border_rows_; ++row)
            for (std::size_t column = 0; column < stride_; ++column) {
                const bool inside = row >= border_rows_ && row < border_rows_ + rows_ &&
                                    column >= border_ && column < border_ + columns_;
                if (inside) {
                    column = border_ + columns_ - 1;
                    continue;
                }
                const std::size_t x = (column + columns_ * border_ - border_) % columns_;
                const std::size_t y = (row + rows_ * border_rows_ - border_rows_) % rows_;
                now_[row * stride_ + column] = now_[place(x, y)];
            }
    }

    CellRule rule_;
    std::size_t columns_, rows_;
    CellBoundary boundary_;
    std::size_t border_, border_rows_, stride_;
    std::vector<std::uint8_t> now_, next_;
    std::vector<std::ptrdiff_t> offsets_;
};

CellDevelopment::CellDevelopment(const CellRule& rule, const CellGrid& start,
                                 const CellBoundary& boundary) {
    if (rule.dimensions == 1 && start.rows != 1)
        throw Error("a rule of one dimension is for one row of cells");
    for (const std::uint8_t state : start.cells)
        if (state >= rule.states)
            throw Error("the state " + std::to_string(state) +
                        " of a cell is out of range: expected 0 to " +
                        std::to_string(rule.states - 1));
    if (rule.is_elementary())
        engine_ = std::make_unique<Bits>(rule, start, boundary);
    else
        engine_ = std::make_unique<Bytes>(rule, start, boundary);
}

CellDevelopment::~CellDevelopment() = default;
CellDevelopment::CellDevelopment(CellDevelopment&&) noexcept = default;

void CellDevelopment::step(std::uint64_t n, const Budget& budget) {
    constexpr std::uint64_t work_between_checks = 1 << 20;
    std::uint64_t work = 0;
    for (std::uint64_t i = 0; i < n; ++i) {
        engine_->step();
        if ((work += engine_->work()) < work_between_checks) continue;
        budget.check();
        work = 0;
    }
}

CellGrid CellDevelopment::grid() const { return engine_->grid(); }

}  // namespace algae
