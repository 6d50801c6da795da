#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <optional>

#include "nature/detail/cells.hpp"
#include "nature/detail/figures.hpp"
#include "watch/watch.hpp"

// Cellular automata on a line and in the plane: rules, development, pictures.
//
// A rule is a table: the states of the neighbourhood are read as the digits of a number, the first
// cell being the most significant, and the table says the next state for each number. Numbers of
// rules as Wolfram counts them, codes of totalistic rules and texts such as B3/S23 are all expanded
// to such a table.
//
// Development has two engines. Elementary rules work on 64 cells at a time: a function of three
// bits is a sum of products over the field of two elements, whose eight coefficients follow from
// the table by Moebius inversion; a step is then a dozen word operations on the row and its two
// shifts. All others keep a byte for each cell and a border as wide as the radius, which is filled
// from the other side or with the fixed state before each step, so that no neighbour needs a test.
//
// In pictures, cells of one state side by side are one rectangle. Formats without a resolution get
// narrow rectangles over the edges between rows as well, so that no light falls through.

namespace algae {

namespace {

constexpr std::size_t largest_cell_table = std::size_t{1} << 24;

/// The last `count` digits of a number in base `base`, the last one first; throws if it has more.
std::vector<std::uint8_t> digits(Integer number, std::uint32_t base, std::size_t count,
                                 const char* what) {
    std::vector<std::uint8_t> found;
    const Integer original = number, divisor(base);
    for (std::size_t i = 0; i < count; ++i) {
        const Integer digit = remainder(number, divisor);
        found.push_back(static_cast<std::uint8_t>(digit.to_double()));
        number = exact_divide(number - digit, divisor);
    }
    if (!number.is_zero() || original < Integer(0)) {
        const std::string most = std::to_string(base) + "^" + std::to_string(count);
        throw Error(fmt::format(
            "the {} {} is out of range: expected 0 to {}", what, to_string(original),
            count <= 64 ? to_string(power(Integer(base), count) - Integer(1)) : most + " - 1"));
    }
    return found;
}

CellRule blank(std::uint32_t states, const std::vector<CellOffset>& neighbourhood) {
    CellRule rule;
    rule.states = states;
    rule.neighbourhood = neighbourhood;
    const auto in_row = [](const CellOffset& offset) { return offset.row == 0; };
    rule.dimensions = std::ranges::all_of(neighbourhood, in_row) ? 1 : 2;
    return rule;
}

}  // namespace

std::vector<std::uint8_t> local_configuration(std::size_t number, std::uint32_t states,
                                              std::size_t cells) {
    std::vector<std::uint8_t> found(cells);
    for (std::size_t i = cells; i-- > 0; number /= states)
        found[i] = static_cast<std::uint8_t>(number % states);
    return found;
}

int CellRule::radius() const {
    int farthest = 0;
    for (const CellOffset& offset : neighbourhood)
        farthest = std::max({farthest, std::abs(offset.column), std::abs(offset.row)});
    return farthest;
}

bool CellRule::is_elementary() const {
    return states == 2 && neighbourhood == line_neighbourhood(1);
}

std::vector<CellOffset> line_neighbourhood(int radius) {
    std::vector<CellOffset> found;
    for (int x = -radius; x <= radius; ++x) found.push_back({x, 0});
    return found;
}

std::vector<CellOffset> moore_neighbourhood(int radius) {
    std::vector<CellOffset> found;
    for (int y = -radius; y <= radius; ++y)
        for (int x = -radius; x <= radius; ++x) found.push_back({x, y});
    return found;
}

std::vector<CellOffset> neumann_neighbourhood(int radius) {
    std::vector<CellOffset> found;
    for (const CellOffset& offset : moore_neighbourhood(radius))
        if (std::abs(offset.column) + std::abs(offset.row) <= radius) found.push_back(offset);
    return found;
}

namespace {

/// The number of entries of a table. Throws Error if there are more than 2^24.
std::size_t cell_table_size(std::uint32_t states, std::size_t neighbours) {
    std::size_t size = 1;
    for (std::size_t i = 0; i < neighbours; ++i) {
        require(size <= largest_cell_table / states,
                "a table for {} cells of {} states has more than 2^24 entries",
                {std::uint64_t{neighbours}, std::uint64_t{states}});
        size *= states;
    }
    return size;
}

}  // namespace

CellRule numbered_rule(const Integer& number, std::uint32_t states,
                       const std::vector<CellOffset>& neighbourhood) {
    CellRule rule = blank(states, neighbourhood);
    rule.table = digits(number, states, cell_table_size(states, neighbourhood.size()), "rule");
    rule.text = "rule " + to_string(number);
    return rule;
}

CellRule totalistic_rule(const Integer& code, std::uint32_t states,
                         const std::vector<CellOffset>& neighbourhood) {
    CellRule rule = blank(states, neighbourhood);
    const std::size_t cells = neighbourhood.size(), size = cell_table_size(states, cells);
    const auto by_sum = digits(code, states, cells * (states - 1) + 1, "code");
    for (std::size_t number = 0; number < size; ++number) {
        std::size_t sum = 0;
        for (const std::uint8_t state : local_configuration(number, states, cells)) sum += state;
        rule.table.push_back(by_sum[sum]);
    }
    rule.text = "code " + to_string(code);
    return rule;
}

CellRule life_rule(std::string_view text, const std::vector<CellOffset>& neighbourhood) {
    CellRule rule = blank(2, neighbourhood);
    const std::size_t cells = neighbourhood.size(), slash = text.find('/');
    const auto counts = [&](std::string_view part, char first) {
        std::vector<bool> found(cells);
        const bool right = !part.empty() && (part.front() == first || part.front() == first + 32);
        for (const char digit : part.substr(right ? 1 : 0)) {
            require(right && digit >= '0' && digit <= '9' &&
                        static_cast<std::size_t>(digit - '0') < cells,
                    "expected a rule such as B3/S23 with numbers of neighbours from 0 to {}, found "
                    "'{}'",
                    {std::uint64_t{cells - 1}, text});
            found[static_cast<std::size_t>(digit - '0')] = true;
        }
        require(right, "expected a rule such as B3/S23, found '{}'", {text});
        return found;
    };
    const auto born = counts(text.substr(0, slash), 'B');
    const auto survives =
        counts(slash == std::string_view::npos ? std::string_view() : text.substr(slash + 1), 'S');
    const auto own = static_cast<std::size_t>(
        std::find(neighbourhood.begin(), neighbourhood.end(), CellOffset{}) -
        neighbourhood.begin());
    for (std::size_t number = 0; number < cell_table_size(2, cells); ++number) {
        const auto local = local_configuration(number, 2, cells);
        const auto living = static_cast<std::size_t>(std::count(local.begin(), local.end(), 1));
        rule.table.push_back(local[own] ? survives[living - 1] : born[living]);
    }
    rule.text = text;
    return rule;
}

CellGrid::CellGrid(std::size_t width, std::size_t height, const Budget& budget)
    : columns(width), rows(height) {
    require(width > 0 && height > 0, "a grid has at least one cell");
    require(width <= budget.memory / 4 / height,
            "a grid of {} x {} cells does not fit in the {} MiB allowed{}",
            {std::uint64_t{width}, std::uint64_t{height}, budget.memory >> 20,
             budget.by(Bound::memory)});
    cells.resize(width * height);
}

class CellDevelopment::Engine {
public:
    virtual ~Engine() = default;
    virtual void step() = 0;
    virtual std::uint64_t work() const = 0;  // of a step, in words or cells
    virtual CellGrid grid() const = 0;
};

/// A row of bits: cell x is bit x % 64 of word 1 + x / 64. The bit before the first cell and the
/// one behind the last hold what stands there.
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
    require(rule.dimensions != 1 || start.rows == 1,
            "a rule of one dimension is for one row of cells");
    for (const std::uint8_t state : start.cells)
        require(state < rule.states, "the state {} of a cell is out of range: expected 0 to {}",
                {std::uint64_t{state}, std::uint64_t{rule.states - 1}});
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
    std::optional<WorkCount> generations;
    if (n > 1) generations.emplace("generation", n);  // who steps one by one counts
    for (std::uint64_t i = 0; i < n; ++i) {
        engine_->step();
        if (generations) generations->at(i + 1);
        if ((work += engine_->work()) < work_between_checks) continue;
        budget.check();
        work = 0;
    }
}

CellGrid CellDevelopment::grid() const { return engine_->grid(); }

namespace {

/// Cells of one state side by side, from `first` up to `last`, which is not one of them.
struct Run {
    std::size_t first, last;
    std::uint8_t state;
};

std::vector<Run> runs(const CellGrid& grid, std::size_t row) {
    std::vector<Run> found;
    for (std::size_t x = 0; x < grid.columns;) {
        const std::uint8_t state = grid.at(x, row);
        std::size_t end = x + 1;
        while (end < grid.columns && grid.at(end, row) == state) ++end;
        if (state != 0) found.push_back({x, end, state});
        x = end;
    }
    return found;
}

/// A grid of cells as unit squares, the first row on top, its lower left corner at (0, -rows).
/// State 0 is left blank, state s has the colour of index s - 1. Other paths may be drawn besides.
class CellFigure final : public PlainFigure {
public:
    CellFigure(CellGrid grid, std::vector<Path> besides, FigureStyle style)
        : PlainFigure(std::move(style)), grid_(std::move(grid)), besides_(std::move(besides)) {
        std::uint64_t strokes = 0;
        box_.add(Point{0, -static_cast<double>(grid_.rows)});
        box_.add(Point{static_cast<double>(grid_.columns), 0});
        for (std::size_t row = 0; row < grid_.rows; ++row) strokes += runs(grid_, row).size();
        for (const Path& path : besides_) {
            for (const Point& point : path.points) box_.add(point);
            strokes += path.points.size();
        }
        facts_.segments = Integer(0);  // cells are polygons
        facts_.step = 1;
        strokes_ = strokes;
        take_corners();
    }

    /// Cells of one state side by side are one rectangle. Without a resolution, rectangles below
    /// each other are tied together, so that no light falls between them.
    void draw(Canvas& canvas, double resolution, const Budget& budget) const override {
        constexpr double tie = 0.25;  // how far ties reach into the cells on both sides
        std::uint32_t colour = 0;
        const auto rectangle = [&](double left, double right, double low, double high,
                                   std::uint8_t state) {
            if (state - 1u != colour) canvas.colour(colour = state - 1u);
            const std::array<Point, 4> corners{
                {{left, low}, {right, low}, {right, high}, {left, high}}};
            canvas.polygon(corners);
        };
        std::vector<Run> above;
        for (std::size_t row = 0; row < grid_.rows; ++row) {
            if ((row & 0x3f) == 0) budget.check();
            if (canvas.wants_position())
                canvas.position(static_cast<double>(row) / static_cast<double>(grid_.rows));
            const double top = -static_cast<double>(row);
            std::vector<Run> here = runs(grid_, row);
            for (const Run& run : here)
                rectangle(static_cast<double>(run.first), static_cast<double>(run.last), top - 1,
                          top, run.state);
            if (resolution <= 0) {
                std::size_t i = 0;
                for (const Run& run : here) {
                    while (i < above.size() && above[i].last <= run.first) ++i;
                    for (std::size_t k = i; k < above.size() && above[k].first < run.last; ++k)
                        if (above[k].state == run.state)
                            rectangle(static_cast<double>(std::max(run.first, above[k].first)),
                                      static_cast<double>(std::min(run.last, above[k].last)),
                                      top - tie, top + tie, run.state);
                }
            }
            above = std::move(here);
        }
        if (colour != 0) canvas.colour(0);
        if (!besides_.empty()) PathFigure(besides_, style_).draw(canvas, resolution, budget);
    }

private:
    CellGrid grid_;
    std::vector<Path> besides_;
};

/// The table of a rule on a line above a picture as wide as `columns`: each local configuration
/// over the state that follows it, from the one of the highest number to that of 0 (as the digits
/// of the rule's number are written).
std::vector<Path> table_paths(const CellRule& rule, double columns) {
    const std::size_t cells = rule.neighbourhood.size(), entries = rule.table.size();
    const double gap = 1, entry = static_cast<double>(cells) + gap;
    const double scale = columns / (static_cast<double>(entries) * entry - gap);
    const double low = 2;  // free rows of the picture between it and the table
    std::vector<Path> filled, frames;
    const auto cell = [&](double column, double row, std::uint8_t state) {
        const double x = column * scale, y = low + row * scale;
        const std::vector<Point> corners{
            {x, y}, {x + scale, y}, {x + scale, y + scale}, {x, y + scale}};
        if (state != 0) filled.push_back({corners, state - 1u, true});
        frames.push_back({corners, 0, false});
        frames.back().points.push_back(corners.front());
    };
    for (std::size_t i = 0; i < entries; ++i) {
        const std::size_t number = entries - 1 - i;
        const double left = static_cast<double>(i) * entry;
        cell(left + (static_cast<double>(cells) - 1) / 2, 0, rule.table[number]);
        const auto local = local_configuration(number, rule.states, cells);
        for (std::size_t k = cells; k-- > 0;) cell(left + static_cast<double>(k), 1.5, local[k]);
    }
    filled.insert(filled.end(), frames.begin(), frames.end());
    return filled;
}

FigureStyle with_colours(FigureStyle style, std::uint32_t states) {
    if (style.colours.empty() && states > 2)
        style.colours = {"black",    "firebrick", "steelblue", "goldenrod",
                         "seagreen", "orchid",    "sienna",    "grey"};
    return style;
}

std::size_t alive(const CellGrid& grid) {
    return grid.cells.size() -
           static_cast<std::size_t>(std::count(grid.cells.begin(), grid.cells.end(), 0));
}

}  // namespace

CellGrid CellularAutomaton::space_time(std::uint64_t first, std::uint64_t last,
                                       const Budget& budget) const {
    CellGrid all(start.columns, last - first + 1, budget);
    CellDevelopment development(rule, start, boundary);
    development.step(first, budget);
    WorkCount counted("generation", last);
    for (std::uint64_t n = first; n <= last; ++n) {
        counted.at(n);
        const CellGrid row = development.grid();
        std::copy(row.cells.begin(), row.cells.end(),
                  all.cells.begin() + static_cast<std::ptrdiff_t>((n - first) * start.columns));
        if (n < last) development.step(1, budget);
    }
    return all;
}

CellGrid CellularAutomaton::generation(std::uint64_t n, const Budget& budget) const {
    CellDevelopment development(rule, start, boundary);
    development.step(n, budget);
    return development.grid();
}

std::vector<GeneratorFigure> CellularAutomaton::figures(const Budget& budget) const {
    const std::string what = title.empty() ? rule.text : title;
    const FigureStyle own = with_colours(style, rule.states);
    std::vector<GeneratorFigure> found;
    if (rule.dimensions == 1) {
        CellGrid all = space_time(generations.front(), generations.back(), budget);
        std::vector<Path> table;
        if (legend) table = table_paths(rule, static_cast<double>(all.columns));
        found.push_back(
            {std::make_unique<CellFigure>(std::move(all), std::move(table), own), what, what});
        return found;
    }
    CellDevelopment development(rule, start, boundary);
    std::uint64_t now = 0;
    for (const std::uint64_t n : generations) {
        development.step(n - now, budget);
        now = n;
        found.push_back({std::make_unique<CellFigure>(development.grid(), std::vector<Path>(), own),
                         what + ", generation " + std::to_string(n), "n = " + std::to_string(n)});
    }
    return found;
}

std::vector<GeneratorFact> CellularAutomaton::facts(const Budget& budget) const {
    constexpr std::uint64_t most_counted = 1000, most_listed = 16;
    constexpr std::size_t most_shown = 32;
    std::vector<GeneratorFact> found;
    found.push_back({"rule", rule.text, rule.text});
    if (rule.dimensions == 1 && rule.table.size() <= most_shown) {
        std::string text;
        nlohmann::ordered_json table;
        for (std::size_t number = 0; number < rule.table.size(); ++number) {
            const std::string local =
                state_text(local_configuration(number, rule.states, rule.neighbourhood.size()));
            text += (text.empty() ? "" : " ") + local + "->" + state_character(rule.table[number]);
            table[local] = rule.table[number];
        }
        found.push_back({"table", text, table});
    }
    found.push_back({"states", std::to_string(rule.states), rule.states});
    std::string cells = std::to_string(start.columns);
    if (rule.dimensions == 2) cells += " x " + std::to_string(start.rows);
    found.push_back({"cells",
                     cells + (boundary.periodic ? ", edges joined" : ""),
                     {start.columns, start.rows}});
    std::string counts;
    nlohmann::ordered_json all = nlohmann::ordered_json::array();
    CellDevelopment development(rule, start, boundary);
    const std::uint64_t last = std::min(generations.back(), most_counted);
    WorkCount counted("generation", last);
    for (std::uint64_t n = 0; n <= last; ++n) {
        counted.at(n);
        const std::size_t count = alive(development.grid());
        all.push_back(count);
        if (n <= most_listed) counts += (n ? ", " : "") + std::to_string(count);
        if (n < last) development.step(1, budget);
    }
    found.push_back({"cells_alive", counts + (last > most_listed ? ", ..." : ""), all});
    return found;
}

char state_character(std::uint8_t state) {
    return static_cast<char>(state < 10 ? '0' + state : 'a' + (state - 10));
}

std::string state_text(std::span<const std::uint8_t> states) {
    std::string text;
    for (const std::uint8_t state : states) text += state_character(state);
    return text;
}

std::string grid_text(const CellGrid& grid) {
    std::string text;
    for (std::size_t row = 0; row < grid.rows; ++row)
        text += state_text(std::span(grid.cells).subspan(row * grid.columns, grid.columns)) + '\n';
    return text;
}

}  // namespace algae
