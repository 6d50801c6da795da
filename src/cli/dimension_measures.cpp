#include "cli/dimension_measures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/error.hpp"
#include "cli/command.hpp"
#include "cli/output.hpp"
#include "dimension/correlation.hpp"
#include "dimension/divider.hpp"
#include "dimension/lacunarity.hpp"
#include "dimension/mass.hpp"
#include "render/plot_dimension.hpp"

namespace algae::cli {

namespace {

constexpr std::size_t most_cells = 1024;  // a side, for lacunarity of figures
constexpr double information_order = 1;
constexpr std::array orders{-5., -4., -3., -2., -1., 0., 1., 2., 3., 4., 5.};

/// A measure, and what its table calls the scales and the values.
struct Measure {
    const char *name, *title, *scale, *value;
};
constexpr Measure measures[] = {
    {"divider", "dividers", "opening", "length"},
    {"mass", "sandboxes", "radius", "mean mass"},
    {"correlation", "the correlation sum", "radius", "share of pairs"},
    {"information", "the information in boxes", "box", "information"},
    {"multifractal", "shares of boxes", "box", "sum of p^q"},
    {"lacunarity", "lacunarity", "box", "lacunarity"},
};

const Measure& named(const std::string& name) {
    const auto* found = std::find_if(std::begin(measures), std::end(measures),
                                     [&](const Measure& measure) { return measure.name == name; });
    if (found == std::end(measures))
        throw Error(
            "--measure: expected boxes, divider, mass, correlation, information, "
            "multifractal or lacunarity, found " +
            name);
    return *found;
}

/// The strokes that join points in their order, and the mean distance along them.
Scaling divider_of(const PointSet& points, const Budget& budget) {
    if (points.detail > 0 || points.columns != 2)
        throw Error(
            "--measure divider walks along strokes: expected a system or points of the "
            "plane in their order, found " +
            (points.detail > 0 ? points.part + "s"
                               : "points with " + std::to_string(points.columns) +
                                     (points.columns == 1 ? " column" : " columns")));
    Stroke stroke;
    double length = 0;
    for (const auto& point : points.points) {
        if (!stroke.empty())
            length += std::hypot(point[0] - stroke.back().x, point[1] - stroke.back().y);
        stroke.push_back({point[0], point[1]});
    }
    return divider({stroke}, length / static_cast<double>(stroke.size()), budget);
}

nlohmann::ordered_json estimate_json(const Scaling& scaling) {
    if (!scaling.estimate) return {{"value", nullptr}, {"low", nullptr}, {"high", nullptr}};
    return {{"value", scaling.estimate->value},
            {"low", scaling.estimate->low},
            {"high", scaling.estimate->high}};
}

bool is_used(const Scaling& scaling, std::size_t i) {
    return scaling.estimate && i >= scaling.first && i <= scaling.last;
}

nlohmann::ordered_json scales_json(const Scaling& scaling) {
    nlohmann::ordered_json scales = nlohmann::ordered_json::array();
    for (std::size_t i = 0; i < scaling.sizes.size(); ++i) {
        nlohmann::ordered_json entry{{"size", scaling.sizes[i]}, {"value", scaling.values[i]}};
        entry["slope"] =
            i < scaling.slopes.size() ? nlohmann::ordered_json(scaling.slopes[i]) : nullptr;
        entry["used"] = is_used(scaling, i);
        scales.push_back(std::move(entry));
    }
    return scales;
}

nlohmann::ordered_json json_of(const OtherMeasured& found) {
    nlohmann::ordered_json json{{"input", found.what},
                                {"measure", found.measure},
                                {"scales", scales_json(found.scaling)},
                                {"estimate", estimate_json(found.scaling)},
                                {"because", found.scaling.because}};
    if (found.spectrum.empty()) return json;
    json["spectrum"] = nlohmann::ordered_json::array();
    for (const auto& [order, scaling] : found.spectrum) {
        nlohmann::ordered_json entry{{"q", order}};
        entry.update(estimate_json(scaling));
        entry["because"] = scaling.because;
        json["spectrum"].push_back(std::move(entry));
    }
    return json;
}

std::string spectrum_page(const std::vector<GeneralisedDimension>& spectrum) {
    std::string text = fmt::format("  {:>4}  {:>8}  {:>8}  {:>8}\n", "q", "D_q", "low", "high");
    for (const auto& [order, scaling] : spectrum)
        text += scaling.estimate ? fmt::format("  {:>4}  {:>8.4f}  {:>8.4f}  {:>8.4f}\n", order,
                                               scaling.estimate->value, scaling.estimate->low,
                                               scaling.estimate->high)
                                 : fmt::format("  {:>4}  undecided\n", order);
    return text + "\n  for q below 0 of boxes three times as wide, which nothing barely touches\n";
}

std::string scales_page(const Measure& measure, const Scaling& scaling) {
    std::string text =
        fmt::format("  {:>12}  {:>14}  {:>8}\n", measure.scale, measure.value, "slope");
    for (std::size_t i = 0; i < scaling.sizes.size(); ++i)
        text +=
            fmt::format("{} {:>12.6g}  {:>14.6g}  {:>8}\n", is_used(scaling, i) ? '*' : ' ',
                        scaling.sizes[i], scaling.values[i],
                        i < scaling.slopes.size() ? fmt::format("{:.4f}", scaling.slopes[i]) : "");
    return text +
           "\n  the slope is the dimension that this scale and the next finer one give; * scales "
           "used\n";
}

std::string page_of(const OtherMeasured& found) {
    const Measure& measure = named(found.measure);
    const Scaling& scaling = found.scaling;
    std::string text = found.what + "\n\nmeasured by " + measure.title;
    if (!found.spectrum.empty()) text += ", q = 0";
    text += scaling.estimate ? fmt::format(": {:.4f}, expected between {:.4f} and {:.4f}\n",
                                           scaling.estimate->value, scaling.estimate->low,
                                           scaling.estimate->high)
                             : ": undecided\n";
    text += "  " + scaling.because + "\n\n";
    return text +
           (found.spectrum.empty() ? scales_page(measure, scaling) : spectrum_page(found.spectrum));
}

/// The order that the verb gives as the estimate of a spectrum.
const Scaling& of_order_zero(const std::vector<GeneralisedDimension>& spectrum) {
    return std::find_if(spectrum.begin(), spectrum.end(),
                        [](const GeneralisedDimension& one) { return one.order == 0; })
        ->scaling;
}

/// `generalised` gives the dimensions of some orders; `other` measures the rest by name.
template <class Generalised, class Other>
OtherMeasured measured_with(const std::string& measure, std::string what, Generalised generalised,
                            Other other) {
    OtherMeasured found{std::move(what), named(measure).name, {}, {}};
    if (measure == "information") {
        found.scaling = generalised(std::span(&information_order, 1))[0].scaling;
    } else if (measure == "multifractal") {
        found.spectrum = generalised(std::span<const double>(orders));
        found.scaling = of_order_zero(found.spectrum);
    } else {
        found.scaling = other();
    }
    return found;
}

}  // namespace

void check_measure(const std::string& measure) {
    if (measure != "boxes") named(measure);
}

OtherMeasured measured_otherwise(const std::string& measure, std::string what, const Figure& figure,
                                 std::size_t grids, const Budget& budget) {
    return measured_with(
        measure, std::move(what),
        [&](std::span<const double> some) {
            return generalised_dimensions(figure, some, grids, budget);
        },
        [&] {
            if (measure == "divider") return divider(figure, budget);
            if (measure == "mass") return mass(figure, {}, budget);
            if (measure == "correlation") return correlation(figure, {}, budget);
            return lacunarity(drawn_cells(figure, most_cells, budget), budget);
        });
}

OtherMeasured measured_otherwise(const std::string& measure, std::string what,
                                 const PointSet& points, std::size_t grids, const Budget& budget) {
    return measured_with(
        measure, std::move(what),
        [&](std::span<const double> some) {
            return generalised_dimensions(points, {}, some, grids, budget);
        },
        [&] {
            if (measure == "divider") return divider_of(points, budget);
            if (measure == "mass") return mass(points, {}, budget);
            if (measure == "correlation") return correlation(points, {}, budget);
            return lacunarity(filled_cells(points, budget), budget);
        });
}

void check_plotted(const std::string& measure) {
    if (measure != "divider" && measure != "mass" && measure != "correlation")
        throw Error("--plot is for --measure boxes, divider, mass and correlation");
}

void plot_measured(const OtherMeasured& found, const std::string& path, const Budget& budget) {
    const Measure& measure = named(found.measure);
    draw_scaling_plot({found.what, measure.value, measure.scale, found.scaling}, path, budget);
}

int print_measured(const OtherMeasured& found, bool json) {
    print(json ? json_of(found).dump(2) + "\n" : page_of(found));
    return found.scaling.estimate ? success : undecided;
}

}  // namespace algae::cli
