#include <algorithm>
#include <charconv>
#include <random>

#include "dimension/detail/cells.hpp"
#include "dimension/detail/measures.hpp"

// Sets of points: read from text, put into cells, sampled from figures.
//
// Cells of points are coded as bits of their coordinates in turns, so that shifting the code by the
// number of columns gives the cell twice as wide. A sorted list of codes then gives the counts for
// all scales: after each shift it is still sorted, and equal neighbours are removed. As with
// segments, coordinates are rounded to 2^-20 of the finest cell before anything is decided.
//
// Samples of figures are chosen along the length that is drawn. The figure is drawn twice, first to
// measure the length, then to pick the places; it is never kept. Random numbers are made from the
// bits of a Mersenne twister by ldexp, because distributions of the standard library differ between
// machines.

namespace algae {

namespace {

constexpr std::size_t most_scales = 20;  // 21 bits for each of three columns
constexpr std::size_t longest_line_shown = 80;

/// A stretch of a line without separators, and where it starts.
struct Field {
    std::string_view text;
    std::size_t at = 0;
};

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r'; }

/// The fields of a line, commas and semicolons between them; white space alone also separates.
std::vector<Field> fields_of(std::string_view line) {
    std::vector<Field> fields;
    std::size_t at = 0;
    bool after_comma = false;  // then a field must follow
    while (true) {
        while (at < line.size() && is_blank(line[at])) ++at;
        const std::size_t start = at;
        while (at < line.size() && !is_blank(line[at]) && line[at] != ',' && line[at] != ';') ++at;
        const bool ends = at == line.size();
        if (at > start || after_comma || !ends)
            fields.push_back({line.substr(start, at - start), start});
        while (at < line.size() && is_blank(line[at])) ++at;
        after_comma = at < line.size() && (line[at] == ',' || line[at] == ';');
        if (after_comma) ++at;
        if (at == line.size() && !after_comma) return fields;
    }
}

std::optional<double> number_of(std::string_view text) {
    if (text.starts_with('+')) text.remove_prefix(1);
    double value = 0;
    const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (failure != std::errc() || end != text.data() + text.size() || text.empty())
        return std::nullopt;
    return value;
}

/// Where in the line a byte stands, in characters from 1.
std::size_t column_of(std::string_view line, std::size_t byte) {
    return 1 + static_cast<std::size_t>(
                   std::count_if(line.begin(), line.begin() + static_cast<std::ptrdiff_t>(byte),
                                 [](char c) { return (c & 0xc0) != 0x80; }));
}

[[noreturn]] void fail(const std::string& name, std::size_t number, std::string_view line,
                       std::size_t byte, std::string message) {
    const std::size_t column = column_of(line, byte);
    Diagnostic finding{{name, number, column}, std::move(message), std::string(line), column - 1};
    if (line.size() > longest_line_shown) finding.line.clear();
    throw Diagnostics({std::move(finding)});
}

}  // namespace

PointSet read_points(std::string_view text, const std::string& name) {
    PointSet set;
    set.columns = 0;
    std::size_t number = 0, first_line = 0;
    bool names_seen = false;
    while (!text.empty()) {
        ++number;
        const std::size_t end = std::min(text.find('\n'), text.size());
        const std::string_view whole = text.substr(0, end);
        text.remove_prefix(std::min(end + 1, text.size()));
        const std::string_view line = whole.substr(0, std::min(whole.find('#'), whole.size()));
        if (std::all_of(line.begin(), line.end(), is_blank)) continue;
        const std::vector<Field> fields = fields_of(line);
        if (set.points.empty() && !names_seen &&
            std::none_of(fields.begin(), fields.end(),
                         [](const Field& field) { return number_of(field.text); })) {
            names_seen = true;
            continue;
        }
        std::array<double, 3> point{};
        if (fields.size() > point.size())
            fail(name, number, whole, fields[3].at,
                 "expected 1 to 3 columns, found " + std::to_string(fields.size()));
        for (std::size_t i = 0; i < fields.size(); ++i) {
            const auto value = number_of(fields[i].text);
            if (!value || !std::isfinite(*value))
                fail(name, number, whole, fields[i].at,
                     "expected a number, found " +
                         (fields[i].text.empty()
                              ? "nothing"
                              : "'" + std::string(fields[i].text.substr(0, 40)) + "'"));
            point[i] = *value;
        }
        if (set.columns == 0) {
            set.columns = static_cast<int>(fields.size());
            first_line = number;
        } else if (fields.size() != static_cast<std::size_t>(set.columns)) {
            fail(name, number, whole, fields.back().at,
                 "expected " + counted(static_cast<std::uint64_t>(set.columns), "column") +
                     " as in line " + std::to_string(first_line) + ", found " +
                     std::to_string(fields.size()));
        }
        set.points.push_back(point);
    }
    if (set.points.empty()) throw Error(name + ": expected points, one a line, found none");
    return set;
}

std::optional<PointSet> dots_of(const Figure& figure, const Budget& budget) {
    constexpr std::size_t between_checks = 1u << 20;
    PointSet found;
    bool has_length = false;
    DrawnSegments canvas([&](Point from, Point to, bool) {
        has_length = has_length || from != to;
        if (has_length) return;
        if (found.points.size() % between_checks == 0)
            budget.check_memory((found.points.size() + between_checks) * sizeof(found.points[0]),
                                "the dots of a figure");
        found.points.push_back({to.x, to.y, 0});
    });
    figure.draw(canvas, 0, budget);
    if (has_length || found.points.empty()) return std::nullopt;
    return found;
}

namespace {

struct Range {
    std::array<double, 3> low{}, high{};
};

Range range_of(const PointSet& set) {
    if (set.points.empty()) throw Error("there are no points: expected something to measure");
    Range range{set.points.front(), set.points.front()};
    for (const auto& point : set.points)
        for (std::size_t i = 0; i < 3; ++i) {
            range.low[i] = std::min(range.low[i], point[i]);
            range.high[i] = std::max(range.high[i], point[i]);
        }
    return range;
}

double longest_side(const Range& range) {
    double side = 0;
    for (std::size_t i = 0; i < 3; ++i) side = std::max(side, range.high[i] - range.low[i]);
    if (!(side > 0)) throw Error("all points are the same: expected something to measure");
    if (!std::isfinite(side))
        throw Error("the points are too far apart for numbers to hold the distance");
    return side;
}

/// The bits of the coordinates in turns: cells of a cell twice as wide follow each other.
std::uint64_t code_of(const std::array<std::uint64_t, 3>& cell, int columns, std::size_t bits) {
    std::uint64_t code = 0;
    for (std::size_t bit = bits; bit-- > 0;)
        for (std::size_t i = 0; i < static_cast<std::size_t>(columns); ++i)
            code = code << 1 | (cell[i] >> bit & 1);
    return code;
}

void check_scales(std::size_t count, std::size_t offsets) {
    if (count == 0 || offsets == 0 || count > most_scales)
        throw Error("expected 1 to " + std::to_string(most_scales) +
                    " scales and at least one offset, found " + std::to_string(count) + " and " +
                    std::to_string(offsets));
}

}  // namespace

double distance(const std::array<double, 3>& a, const std::array<double, 3>& b) {
    const double x = b[0] - a[0], y = b[1] - a[1], z = b[2] - a[2];
    return std::sqrt(x * x + y * y + z * z);
}

double longest_side(const PointSet& points) { return longest_side(range_of(points)); }

std::vector<std::array<double, 3>> even_places(std::size_t count) {
    std::vector<std::array<double, 3>> places;
    double third = 0;
    for (const Point& offset : even_offsets(count)) {
        third = std::fmod(third + 0.6180339887498949, 1);
        places.push_back({offset.x, offset.y, third});
    }
    return places;
}

std::vector<std::uint64_t> cell_codes(const PointSet& set, std::size_t count,
                                      const std::array<double, 3>& shares, const Budget& budget) {
    check_scales(count, 1);
    const Range range = range_of(set);
    const double side = longest_side(range);
    const BoxScales scales{side, 2, count};
    const double parts = std::ldexp(1.0, Grid::fraction_bits) / scales.cell(count - 1);
    std::vector<std::uint64_t> codes(set.points.size());
    for (std::size_t k = 0; k < codes.size(); ++k) {
        if (k % 65536 == 0) budget.check();
        std::array<std::uint64_t, 3> cell{};
        for (std::size_t i = 0; i < 3; ++i)
            cell[i] = static_cast<std::uint64_t>(
                          (set.points[k][i] - range.low[i] + shares[i] * side) * parts + 0.5) >>
                      Grid::fraction_bits;
        codes[k] = code_of(cell, set.columns, count + 1);
    }
    return codes;
}

BoxCounts box_counts(const PointSet& set, std::size_t count, std::size_t offsets,
                     const Budget& budget) {
    check_scales(count, offsets);
    budget.check_memory(set.points.size() * (sizeof(set.points[0]) + sizeof(std::uint64_t)),
                        "the points and their cells");
    BoxCounts result;
    result.scales = {longest_side(set), 2, count};
    result.counts.resize(count);
    result.detail = set.detail;
    result.part = set.part;
    result.space = set.columns;
    PointSet sorted = set;
    std::sort(sorted.points.begin(), sorted.points.end());
    sorted.points.erase(std::unique(sorted.points.begin(), sorted.points.end()),
                        sorted.points.end());
    result.parts = sorted.points.size();
    for (const auto& shares : even_places(offsets)) {
        std::vector<std::uint64_t> codes = cell_codes(sorted, count, shares, budget);
        std::sort(codes.begin(), codes.end());
        auto last = codes.end();
        for (std::size_t scale = count; scale-- > 0;) {
            last = std::unique(codes.begin(), last);
            result.counts[scale].push_back(static_cast<std::uint64_t>(last - codes.begin()));
            for (auto code = codes.begin(); code != last; ++code) *code >>= set.columns;
        }
    }
    return result;
}

namespace {

/// A number from 0 to 1, without 1; the distributions of the standard library differ by machine.
double share(std::mt19937_64& random) {
    return std::ldexp(static_cast<double>(random() >> 11), -53);
}

/// So many places between 0 and 1, in order.
std::vector<double> places(std::size_t count, Spread spread, std::uint64_t seed) {
    std::mt19937_64 random(seed);
    std::vector<double> all;
    all.reserve(count);
    for (std::size_t i = 0; i < count; ++i)
        all.push_back(spread == Spread::independent
                          ? share(random)
                          : (static_cast<double>(i) + share(random)) / static_cast<double>(count));
    std::sort(all.begin(), all.end());
    return all;
}

}  // namespace

PointSet even_sample(const Figure& figure, std::size_t count, Spread spread, std::uint64_t seed,
                     const Budget& budget) {
    double whole = 0;
    DrawnSegments ruler([&](Point from, Point to, bool) { whole += distance(from, to); });
    figure.draw(ruler, 0, budget);
    if (!(whole > 0) || !std::isfinite(whole))
        throw Error("expected strokes with a length to measure, found a length of " +
                    std::to_string(whole));
    PointSet sample;
    sample.detail = figure.facts().step;
    budget.check_memory(count * (sizeof(sample.points[0]) + sizeof(double)),
                        "the points of a sample");
    sample.points.reserve(count);
    const std::vector<double> shares = places(count, spread, seed);
    double done = 0;
    DrawnSegments picker([&](Point from, Point to, bool) {
        const double length = distance(from, to);
        while (sample.points.size() < count) {
            const double part = (shares[sample.points.size()] * whole - done) / length;
            if (!(part < 1)) break;
            sample.points.push_back(
                {from.x + part * (to.x - from.x), from.y + part * (to.y - from.y), 0});
        }
        done += length;
    });
    figure.draw(picker, 0, budget);
    return sample;
}

PointSet even_sample(const PointSet& points, std::size_t count, std::uint64_t seed) {
    if (points.points.size() <= count) return points;
    PointSet sample = points;
    sample.points.clear();
    std::mt19937_64 random(seed);
    for (std::size_t i = 0; i < points.points.size(); ++i) {
        const auto left = static_cast<double>(points.points.size() - i);
        if (left * share(random) < static_cast<double>(count - sample.points.size()))
            sample.points.push_back(points.points[i]);
    }
    return sample;
}

}  // namespace algae
