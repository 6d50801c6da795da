// The dimension of a figure, exact and measured, as a page and as JSON.
//
// The two never share a number: `exact` holds a formula and digits that are proved, `box` and `estimate` a
// slope with the interval in which it is expected. A row of the table compares them.

#include "report/report.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace algae {

namespace {

constexpr MeasureNames measures[] = {
    {"boxes", "boxes", "cell", "cells touched"},
    {"divider", "dividers", "opening", "length"},
    {"mass", "sandboxes", "radius", "mean mass"},
    {"correlation", "the correlation sum", "radius", "share of pairs"},
    {"information", "the information in boxes", "box", "information"},
    {"multifractal", "shares of boxes", "box", "sum of p^q"},
    {"lacunarity", "lacunarity", "box", "lacunarity"},
};

constexpr int digits = 30;

const char* status_name(ExactDimension::Status status) {
    switch (status) {
        case ExactDimension::Status::exact:
            return "exact";
        case ExactDimension::Status::upper_bound:
            return "upper bound";
        case ExactDimension::Status::unfinished:
            return "unfinished";
        default:
            return "none";
    }
}

// What the fits of box counts and of other measures have in common.

template <class Fit>
bool is_used(const Fit& fit, std::size_t scale) {
    return fit.estimate && scale >= fit.first && scale <= fit.last;
}

template <class Fit>
std::string slope_text(const Fit& fit, std::size_t scale) {
    return scale < fit.slopes.size() ? fmt::format("{:.4f}", fit.slopes[scale]) : "";
}

/// Adds the slope at a scale and whether the fit uses it.
template <class Fit>
Json with_slope(Json entry, const Fit& fit, std::size_t scale) {
    entry.set("slope", scale < fit.slopes.size() ? Json(fit.slopes[scale]) : Json());
    return entry.set("used", is_used(fit, scale));
}

/// What was measured, and why no other number.
template <class Fit>
std::string fit_text(const std::string& title, const Fit& fit, const std::string& more = "") {
    const auto& estimate = fit.estimate;
    return "measured by " + title +
           (estimate ? fmt::format(": {:.4f}, expected between {:.4f} and {:.4f}", estimate->value,
                                   estimate->low, estimate->high)
                     : ": undecided") +
           "\n  " + fit.because + "\n" + more + "\n";
}

Json estimate_json(const std::optional<Estimate>& estimate) {
    if (!estimate) return {{"value", nullptr}, {"low", nullptr}, {"high", nullptr}};
    return {{"value", estimate->value}, {"low", estimate->low}, {"high", estimate->high}};
}

/// The exact value that measured ones are compared with, where it is known.
std::optional<double> compared_with(const DimensionReport& found) {
    if (!found.exact || found.exact->status != ExactDimension::Status::exact || !found.fit.estimate)
        return std::nullopt;
    const auto& others = found.exact->others;
    return (others ? others->box : *found.exact->value).enclosure(64).midpoint();
}

/// The interval was written with so many digits, and its ends count.
bool holds(const Estimate& estimate, double value) {
    return estimate.low <= value + 1e-12 && value - 1e-12 <= estimate.high;
}

std::string comparison_text(const DimensionReport& found) {
    const auto exact = compared_with(found);
    if (!exact) return "";
    std::string text =
        fmt::format("  error against the exact value: {:+.4f}", found.fit.estimate->value - *exact);
    if (found.exact->almost_surely)
        text += ", of one figure of many";
    else if (!holds(*found.fit.estimate, *exact))
        text += "; the interval does not hold it: the measurement is wrong, not the exact value";
    return text + "\n";
}

Json formula_json(const std::optional<DimensionFormula>& formula) {
    if (!formula) return nullptr;
    return {{"formula", formula->text()},
            {"value", formula->enclosure(64).midpoint()},
            {"decimal", formula->decimal(digits)}};
}

/// Whether the formula of an upper bound is more than the dimension of the plane, which is a better
/// bound then.
bool exceeds_plane(const ExactDimension& exact) {
    return (exact.status == ExactDimension::Status::upper_bound ||
            exact.status == ExactDimension::Status::unfinished) &&
           exact.value && compare(exact.value->enclosure(64), Ball(2, 64)) == Order::greater;
}

Json exact_json(const ExactDimension& exact) {
    Json json{{"status", status_name(exact.status)},
              {"formula", nullptr},
              {"value", nullptr},
              {"decimal", nullptr}};
    const bool is_unfinished = exact.status == ExactDimension::Status::unfinished;
    Json bound = formula_json(exact.value);
    if (exceeds_plane(exact))
        bound.update({{"value", 2.0}, {"decimal", decimal(Rational(2), digits)}});
    if (exact.value && is_unfinished)
        json.set("at_most", std::move(bound));
    else if (exact.value)
        json.update(bound);
    json.set("conditions", exact.conditions);
    json.set("almost_surely", exact.almost_surely);
    json.set("similarity", formula_json(exact.similarity));
    json.set("boundary", formula_json(exact.boundary));
    if (exact.others) {
        const ExactDimension::Others& others = *exact.others;
        return json.set("box", formula_json(others.box))
            .set("packing", formula_json(others.box))
            .set("assouad", formula_json(others.assouad))
            .set("lower", formula_json(others.lower))
            .set("hausdorff_measure", others.measure);
    }
    // The packing dimension lies between those of Hausdorff and of boxes.
    for (const char* const dimension : {"box", "packing"})
        json.set(dimension, exact.status == ExactDimension::Status::exact
                                ? formula_json(exact.value)
                                : Json());
    for (const char* const dimension : {"assouad", "lower"})
        json.set(dimension, exact.is_regular ? formula_json(exact.value) : Json());
    json.set("hausdorff_measure", exact.is_regular ? Json("positive and finite") : Json());
    return json;
}

std::string exact_page(const ExactDimension& exact) {
    std::string text;
    const auto line = [](const std::string& what, const DimensionFormula& dimension) {
        const std::string formula = dimension.text();
        if (dimension.ratio_sum())
            return what + dimension.decimal(digits) + ", the s of " + formula + "\n";
        return what + formula + (dimension.rational() ? "" : " = " + dimension.decimal(digits)) +
               "\n";
    };
    const std::string surely = exact.almost_surely ? ", with probability 1: " : ": ";
    const std::string unfinished =
        exact.almost_surely ? "exact, with probability 1: unfinished" : "exact: unfinished";
    if (exact.status == ExactDimension::Status::exact) text += line("exact" + surely, *exact.value);
    if (exact.status == ExactDimension::Status::upper_bound)
        text += exceeds_plane(exact)
                    ? line("upper bound: 2, as for every set in the plane; the formula gives ",
                           *exact.value)
                    : line("upper bound" + surely, *exact.value);
    if (exact.status == ExactDimension::Status::unfinished)
        text += exceeds_plane(exact)
                    ? line("exact: unfinished, at most 2; the formula gives ", *exact.value)
                : exact.value ? line(unfinished + ", at most ", *exact.value)
                              : unfinished + "\n";
    if (exact.status == ExactDimension::Status::none) text += "exact: no formula\n";
    for (const std::string& condition : exact.conditions) text += "  " + condition + "\n";
    if (exact.value && exact.similarity && exact.similarity->text() != exact.value->text())
        text += line("with multiplicity, too large: ", *exact.similarity);
    if (exact.boundary) text += line("boundary: ", *exact.boundary);
    if (exact.others)
        text += line("boxes and packing: ", exact.others->box) +
                line("Assouad: ", exact.others->assouad) + line("lower: ", exact.others->lower) +
                "the Hausdorff measure of the dimension is " + exact.others->measure + "\n";
    if (exact.is_regular)
        text +=
            "the Assouad and the lower dimension are the same, and the Hausdorff measure is "
            "positive and finite\n";
    return text + "\n";
}

Json box_json(const DimensionReport& found) {
    const BoxCounts& counts = found.counts;
    const BoxFit& fit = found.fit;
    Json box = estimate_json(fit.estimate);
    box.set("because", fit.because);
    const auto compared = compared_with(found);
    box.set("error", compared ? Json(fit.estimate->value - *compared) : Json());
    box.set("holds_exact", compared ? Json(holds(*fit.estimate, *compared)) : Json());
    box.set("noise", counts.noise > 0 ? Json(counts.noise) : Json());
    box.set("offsets", counts.counts.empty() ? 0 : counts.counts.front().size());
    Json scales = Json::array();
    for (std::size_t scale = 0; scale < counts.counts.size(); ++scale) {
        const auto [least, most] =
            std::minmax_element(counts.counts[scale].begin(), counts.counts[scale].end());
        scales.add(with_slope({{"cell", counts.scales.cell(scale)},
                               {"cells", counts.mean(scale)},
                               {"least", *least},
                               {"most", *most}},
                              fit, scale));
    }
    box.set("scales", std::move(scales));
    return box;
}

std::string box_page(const DimensionReport& found) {
    const BoxCounts& counts = found.counts;
    const BoxFit& fit = found.fit;
    std::string text = fit_text("boxes", fit, comparison_text(found));
    if (counts.counts.empty()) return text;
    text += fmt::format("  {:>12}  {:>14}  {:>12}  {:>12}  {:>8}\n", "cell", "cells touched",
                        "least", "most", "slope");
    for (std::size_t scale = 0; scale < counts.counts.size(); ++scale) {
        const auto [least, most] =
            std::minmax_element(counts.counts[scale].begin(), counts.counts[scale].end());
        text += fmt::format("{} {:>12.6g}  {:>14.1f}  {:>12}  {:>12}  {:>8}\n",
                            is_used(fit, scale) ? '*' : ' ', counts.scales.cell(scale),
                            counts.mean(scale), *least, *most, slope_text(fit, scale));
    }
    return text + fmt::format(
                      "\n  means over {} grids; the slope is that to the next finer scale; * "
                      "scales used\n",
                      counts.counts.front().size());
}

}  // namespace

const MeasureNames& names_of(Measure measure) {
    return measures[static_cast<std::size_t>(measure)];
}

namespace {

/// The digits of a bound, whose denominator is a power of 10.
std::string digits_of(const Rational& bound) { return shortest_text(bound); }

std::string bounds_page(const DimensionReport& found) {
    if (!found.bounds) return "";
    const DimensionBounds& bounds = *found.bounds;
    std::string text = "proved: between " + digits_of(bounds.low) + " and " +
                       digits_of(bounds.high) + "\n  from below by " + bounds.low_by +
                       "\n  from above by " + bounds.high_by + "\n";
    if (!found.is_within())
        text += "  they are " + digits_of(bounds.width()) + " apart, more than " +
                shortest_text(found.within) + "\n";
    return text + "\n";
}

Json bounds_json(const DimensionReport& found) {
    const DimensionBounds& bounds = *found.bounds;
    return {{"low", digits_of(bounds.low)},
            {"high", digits_of(bounds.high)},
            {"low_by", bounds.low_by},
            {"high_by", bounds.high_by},
            {"within", shortest_text(found.within)},
            {"reached", found.is_within()}};
}

/// "yes", "no" or "not decided", and why.
std::string finding_text(const Tile::Finding& finding) {
    const char* const answer = finding.answer == Tile::Answer::yes  ? "yes"
                               : finding.answer == Tile::Answer::no ? "no"
                                                                    : "not decided";
    return answer + (finding.because.empty() ? "" : ": " + finding.because);
}

std::string area_text(const Tile& tile) {
    if (tile.area_square)
        return square_root_text(*tile.area_square) + (tile.unit.empty() ? "" : " of " + tile.unit);
    const auto cells = [&](const Rational& count) {
        return to_string(count) + (count == 1 ? " cell" : " cells");
    };
    const std::string of = tile.is_periodic ? " of its tiling" : " of its lattice";
    if (tile.cells) return cells(*tile.cells) + of;
    if (!tile.cells_between) return "not decided";
    constexpr int few = 6;
    const auto& [low, high] = *tile.cells_between;
    const Rational unit = power(Rational(10), few);
    return "between " + shortest_text(Rational(floor(low * unit)) / unit) + " and " +
           shortest_text(Rational(ceiling(high * unit)) / unit) + " cells" + of;
}

std::string neighbours_text(const Tile& tile) {
    std::string text = std::to_string(tile.least_neighbours);
    if (tile.most_neighbours != tile.least_neighbours)
        text += " to " + std::to_string(tile.most_neighbours);
    return text +
           (tile.is_periodic ? " in the tiling by its lattice" : " in the tiling that it makes");
}

/// The lines on a tile; its area stands in the first one unless another one says what it is.
std::string tile_lines(const Tile& tile) {
    std::string text;
    if (tile.most_neighbours > 0) text += "  neighbours: " + neighbours_text(tile) + "\n";
    text += "  connected: " + finding_text(tile.connected) + "\n";
    text += "  like a disc: " + finding_text(tile.disk_like) + "\n";
    if (tile.disk_like.answer != Tile::Answer::yes) {
        text += "  interior connected: " + finding_text(tile.interior_connected) + "\n";
        if (tile.infinitely_many.answer == Tile::Answer::yes)
            text += "  components of the interior: infinitely many, as " +
                    tile.infinitely_many.because + "\n";
    }
    return text;
}

std::string tile_page(const DimensionReport& found) {
    if (!found.tile)
        return found.no_tile.empty() ? "" : "tile: not decided: " + found.no_tile + "\n\n";
    const Tile& tile = *found.tile;
    if (tile.cells && tile.cells->is_zero()) return "";
    if (tile.is_tile.answer != Tile::Answer::yes)
        return "tile: " + finding_text(tile.is_tile) + "\n  area: " + area_text(tile) + "\n\n";
    return "tile: its parts overlap in sets of the area 0\n  area: " + area_text(tile) + "\n" +
           tile_lines(tile) + "\n";
}

Json finding_json(const Tile::Finding& finding) {
    const Json answer = finding.answer == Tile::Answer::undecided
                            ? Json()
                            : Json(finding.answer == Tile::Answer::yes);
    return {{"answer", answer}, {"because", finding.because}};
}

Json tile_json(const Tile& tile) {
    Json area{{"exact", tile.area_square ? Json(square_root_text(*tile.area_square)) : Json()},
              {"unit", tile.unit},
              {"cells", tile.cells ? Json(to_string(*tile.cells)) : Json()},
              {"at_least", Json()},
              {"at_most", Json()}};
    if (tile.cells_between) {
        area.set("at_least", tile.cells_between->first.to_double());
        area.set("at_most", tile.cells_between->second.to_double());
    }
    Json neighbours = Json::array(), basis = Json::array();
    for (const LatticeSet::Part& neighbour : tile.neighbours) {
        Json by = Json::array();
        for (std::size_t k = 0; k < tile.set.rank; ++k) by.add(neighbour.by[k]);
        neighbours.add({{"state", neighbour.state}, {"moved_by", std::move(by)}});
    }
    for (std::size_t k = 0; k < tile.set.rank; ++k) {
        Json place = Json::array();
        place.add(tile.set.places[k].x);
        place.add(tile.set.places[k].y);
        basis.add(std::move(place));
    }
    return {{"is_tile", finding_json(tile.is_tile)},
            {"area", std::move(area)},
            {"least_neighbours", tile.least_neighbours},
            {"most_neighbours", tile.most_neighbours},
            {"periodic", tile.is_periodic},
            {"basis", std::move(basis)},
            {"neighbours", std::move(neighbours)},
            {"connected", finding_json(tile.connected)},
            {"disk_like", finding_json(tile.disk_like)},
            {"interior_connected", finding_json(tile.interior_connected)},
            {"interior_infinitely_many", finding_json(tile.infinitely_many)}};
}

}  // namespace

std::string to_text(const RauzyReport& report) {
    const RauzyFractal& found = report.found;
    const auto rate = [](const Rate& of) {
        return of.integer() ? of.exact() : of.exact() + " = " + of.decimal(11);
    };
    std::string text = report.what + "\n\nlengths grow by " + rate(found.factor) +
                       ", a Pisot unit; the fractal has a part for each of " +
                       counted(report.letters.size(), "letter") + "\n";
    text += "parts meet in " + counted(found.neighbours.size(), "way") +
            "; pairs of parts that meet multiply by " + rate(found.meeting) + "\n";
    text += found.tiles
                ? "proved: the parts tile, periodically and self-replicating: such pairs multiply "
                  "less than parts\n"
                : "proved: the parts do not tile: such pairs multiply as fast as parts\n";
    if (found.boundary(64))
        text += "boundary " + found.boundary_text() + " = " +
                decimal([&](long bits) { return *found.boundary(bits); }, 12) +
                "\n  the box and the Hausdorff dimension of the boundary of each part\n";
    else if (found.tiles)
        text +=
            "boundary: parts shrink differently in different directions, and no formula is "
            "known here\n";
    text += found.connected         ? "proved: the fractal and each of its parts are connected\n"
            : found.parts_connected ? "proved: each part is connected, the fractal is not\n"
                                    : "proved: some part is not connected\n";
    if (report.tile && report.tile->is_tile.answer == Tile::Answer::yes)
        text += "in the periodic tiling:\n" + tile_lines(*report.tile);
    return text;
}

Json to_json(const RauzyReport& report) {
    const RauzyFractal& found = report.found;
    Json neighbours = Json::array();
    for (const RauzyNeighbour& pair : found.neighbours) {
        neighbours.add({{"part", report.letters[pair.first]},
                        {"other", report.letters[pair.other]},
                        {"moved_by", Json(pair.vector)}});
    }
    Json boundary;
    if (found.boundary(64))
        boundary = {{"formula", found.boundary_text()},
                    {"decimal", decimal([&](long bits) { return *found.boundary(bits); }, digits)}};
    return {{"input", report.what},
            {"letters", Json(report.letters)},
            {"factor", found.factor.exact()},
            {"meeting", found.meeting.exact()},
            {"tiles", found.tiles},
            {"parts_connected", found.parts_connected},
            {"connected", found.connected},
            {"boundary", std::move(boundary)},
            {"neighbours", std::move(neighbours)},
            {"tile", report.tile ? tile_json(*report.tile) : Json()}};
}

std::string to_text(const DimensionReport& found) {
    return found.what + "\n\n" + (found.exact ? exact_page(*found.exact) : "") + tile_page(found) +
           bounds_page(found) + box_page(found);
}

Json to_json(const DimensionReport& found) {
    Json json{{"input", found.what}};
    if (found.generation) json.set("generation", *found.generation);
    if (found.exact) {
        json.set("exact", exact_json(*found.exact));
        json.set("tile", found.tile               ? tile_json(*found.tile)
                         : !found.no_tile.empty() ? Json{{"reason", found.no_tile}}
                                                  : Json());
    }
    if (found.bounds) json.set("bounds", bounds_json(found));
    json.set("box", box_json(found));
    return json;
}

namespace {

Json scales_json(const Scaling& scaling) {
    Json scales = Json::array();
    for (std::size_t i = 0; i < scaling.sizes.size(); ++i) {
        scales.add(
            with_slope({{"size", scaling.sizes[i]}, {"value", scaling.values[i]}}, scaling, i));
    }
    return scales;
}

std::string spectrum_page(const ScalingReport& found) {
    std::string text = fmt::format("  {:>4}  {:>8}  {:>8}  {:>8}{}\n", "q", "D_q", "low", "high",
                                   found.exact ? "     exact" : "");
    for (std::size_t k = 0; k < found.spectrum.size(); ++k) {
        const auto& [order, scaling] = found.spectrum[k];
        text += scaling.estimate ? fmt::format("  {:>4}  {:>8.4f}  {:>8.4f}  {:>8.4f}", order,
                                               scaling.estimate->value, scaling.estimate->low,
                                               scaling.estimate->high)
                                 : fmt::format("  {:>4}  undecided{:>19}", order, "");
        text += (found.exact ? fmt::format("  {:>8.6f}", (*found.exact)[k]) : "") + "\n";
    }
    if (found.exact)
        text +=
            "\n  exact: the solution of sum p^q r^((1 - q) D_q) = 1 over the chances p and the "
            "ratios r of the maps\n";
    return text + "\n  for q below 0 of boxes three times as wide, which nothing barely touches\n";
}

std::string information_text(const ScalingReport& found) {
    if (!found.exact) return "";
    return fmt::format(
        "exact: {:.6f}, sum p log p / sum p log r over the chances p and the ratios r of the "
        "maps\n\n",
        found.exact->front());
}

std::string scales_page(const MeasureNames& measure, const Scaling& scaling) {
    std::string text =
        fmt::format("  {:>12}  {:>14}  {:>8}\n", measure.scale, measure.value, "slope");
    for (std::size_t i = 0; i < scaling.sizes.size(); ++i)
        text += fmt::format("{} {:>12.6g}  {:>14.6g}  {:>8}\n", is_used(scaling, i) ? '*' : ' ',
                            scaling.sizes[i], scaling.values[i], slope_text(scaling, i));
    return text +
           "\n  the slope is the dimension that this scale and the next finer one give; * scales "
           "used\n";
}

}  // namespace

std::string to_text(const ScalingReport& found) {
    const MeasureNames& measure = names_of(found.measure);
    const Scaling& scaling = found.scaling;
    const std::string title = measure.title + std::string(found.spectrum.empty() ? "" : ", q = 0");
    return found.what + "\n\n" + fit_text(title, scaling) +
           (found.spectrum.empty() ? information_text(found) + scales_page(measure, scaling)
                                   : spectrum_page(found));
}

Json to_json(const ScalingReport& found) {
    Json json{{"input", found.what},
              {"measure", names_of(found.measure).name},
              {"scales", scales_json(found.scaling)},
              {"estimate", estimate_json(found.scaling.estimate)},
              {"because", found.scaling.because},
              {"noise", found.scaling.noise > 0 ? Json(found.scaling.noise) : Json()}};
    if (found.measure == Measure::information)
        json.set("exact", found.exact ? Json(found.exact->front()) : Json());
    if (found.spectrum.empty()) return json;
    Json spectrum = Json::array();
    for (std::size_t k = 0; k < found.spectrum.size(); ++k) {
        const auto& [order, scaling] = found.spectrum[k];
        Json entry{{"q", order}};
        entry.update(estimate_json(scaling.estimate));
        entry.set("exact", found.exact ? Json((*found.exact)[k]) : Json());
        spectrum.add(entry.set("because", scaling.because));
    }
    return json.set("spectrum", std::move(spectrum));
}

namespace {

using Found = ExactDimension::Status;

constexpr std::size_t formula_width = 38, longest_reason = 90;

/// The formula; roots of long polynomials by their degree.
std::string short_formula(const DimensionFormula& formula) {
    const std::string whole = formula.text();
    if (whole.size() <= formula_width) return whole;
    if (!formula.log_ratio()) return whole.substr(0, formula_width - 4) + " ...";
    const LogRatio& ratio = *formula.log_ratio();
    const auto part = [](const std::string& text, const char* name, long degree) {
        return text.size() <= formula_width / 2 ? text
                                                : fmt::format("{} of degree {}", name, degree);
    };
    const Polynomial& rate = ratio.rate().minimal_polynomial();
    const auto& square = ratio.ratio().square();
    return "log " + part(ratio.rate().exact(), "root", rate.degree()) + " / log " +
           part(ratio.ratio().text(), "mu", square ? 2 * square->minimal_polynomial().degree() : 0);
}

std::string shortened(std::string text) {
    if (text.size() <= longest_reason) return text;
    text.resize(text.find_last_of(' ', longest_reason));
    return text + " ...";
}

}  // namespace

std::string dimension_header(std::size_t width, bool quick) {
    return fmt::format("{:<{}}  {:<{}}  {:>10}  {:>8}{}\n", "curve", width, "formula",
                       formula_width, "dimension", "boundary",
                       quick ? "" : "  measured                    difference");
}

std::string to_line(const DimensionRow& row, std::size_t width) {
    if (!row.exact.value)
        return fmt::format("{:<{}}  {}\n", row.name, width, shortened(row.exact.conditions.back()));
    const bool exact = row.exact.status == Found::exact;
    std::string text = fmt::format(
        "{:<{}}  {:<{}}  {:>2}{:.6f}  {:>8}", row.name, width, short_formula(*row.exact.value),
        formula_width, exact ? "" : "<=", row.value(),
        row.exact.boundary ? fmt::format("{:.6f}", row.exact.boundary->enclosure(64).midpoint())
                           : "");
    if (row.fit && row.fit->estimate) {
        const Estimate& found = *row.fit->estimate;
        text += fmt::format("  {:.4f} in [{:.4f}, {:.4f}]", found.value, found.low, found.high);
        if (const auto difference = row.difference()) {
            text += fmt::format("  {:+.4f}", *difference);
            if (!holds(found, row.value())) text += ", outside";
        }
    } else if (!row.unmeasured.empty()) {
        text += "  undecided: " + shortened(row.unmeasured);
    }
    text = text.substr(0, text.find_last_not_of(' ') + 1);
    if (row.exact.almost_surely) text += "  with probability 1";
    if (row.exact.status == Found::unfinished && row.unmeasured.empty())
        text += "  " + shortened(row.exact.conditions.back());
    return text + "\n";
}

Json to_json(const DimensionRow& row, bool quick) {
    Json json{{"name", row.name}, {"title", row.title}, {"exact", exact_json(row.exact)}};
    if (quick) return json;
    json.set("measured", row.fit && row.fit->estimate ? estimate_json(row.fit->estimate) : Json());
    json.set("difference", row.difference());
    if (!row.unmeasured.empty()) json.set("because", row.unmeasured);
    return json;
}

}  // namespace algae
