#include "cli/dimension_report.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace algae::cli {

namespace {

constexpr int digits = 30;

std::string status_name(ExactDimension::Status status) {
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

nlohmann::ordered_json formula_json(const std::optional<DimensionFormula>& formula) {
    if (!formula) return nullptr;
    return {{"formula", formula->text()},
            {"value", formula->enclosure(64).midpoint()},
            {"decimal", formula->decimal(digits)}};
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
    if (exact.status == ExactDimension::Status::exact) text += line("exact: ", *exact.value);
    if (exact.status == ExactDimension::Status::upper_bound)
        text += compare(exact.value->enclosure(64), Ball(2, 64)) == Order::greater
                    ? line("upper bound: 2, as for every set in the plane; the formula gives ",
                           *exact.value)
                    : line("upper bound: ", *exact.value);
    if (exact.status == ExactDimension::Status::unfinished) text += "exact: unfinished\n";
    if (exact.status == ExactDimension::Status::none) text += "exact: no formula\n";
    for (const std::string& condition : exact.conditions) text += "  " + condition + "\n";
    if (exact.value && exact.similarity && exact.similarity->text() != exact.value->text())
        text += line("with multiplicity, too large: ", *exact.similarity);
    if (exact.boundary) text += line("boundary: ", *exact.boundary);
    return text + "\n";
}

nlohmann::ordered_json box_json(const Measured& found) {
    const auto& [what, exact, generation, counts, fit] = found;
    nlohmann::ordered_json box{{"value", nullptr}, {"low", nullptr}, {"high", nullptr}};
    if (fit.estimate)
        box = {{"value", fit.estimate->value},
               {"low", fit.estimate->low},
               {"high", fit.estimate->high}};
    box["because"] = fit.because;
    box["offsets"] = counts.counts.front().size();
    nlohmann::ordered_json scales = nlohmann::ordered_json::array();
    for (std::size_t scale = 0; scale < counts.counts.size(); ++scale) {
        const auto [least, most] =
            std::minmax_element(counts.counts[scale].begin(), counts.counts[scale].end());
        nlohmann::ordered_json entry{{"cell", counts.scales.cell(scale)},
                                     {"cells", counts.mean(scale)},
                                     {"least", *least},
                                     {"most", *most}};
        entry["slope"] =
            scale < fit.slopes.size() ? nlohmann::ordered_json(fit.slopes[scale]) : nullptr;
        entry["used"] = fit.estimate && scale >= fit.first && scale <= fit.last;
        scales.push_back(std::move(entry));
    }
    box["scales"] = std::move(scales);
    return box;
}

std::string box_page(const Measured& found) {
    const auto& [what, exact, generation, counts, fit] = found;
    std::string text;
    if (fit.estimate)
        text += fmt::format("measured by boxes: {:.4f}, expected between {:.4f} and {:.4f}\n",
                            fit.estimate->value, fit.estimate->low, fit.estimate->high);
    else
        text += "measured by boxes: undecided\n";
    text += "  " + fit.because + "\n\n";
    text += fmt::format("  {:>12}  {:>14}  {:>12}  {:>12}  {:>8}\n", "cell", "cells touched",
                        "least", "most", "slope");
    for (std::size_t scale = 0; scale < counts.counts.size(); ++scale) {
        const auto [least, most] =
            std::minmax_element(counts.counts[scale].begin(), counts.counts[scale].end());
        const bool used = fit.estimate && scale >= fit.first && scale <= fit.last;
        text +=
            fmt::format("{} {:>12.6g}  {:>14.1f}  {:>12}  {:>12}  {:>8}\n", used ? '*' : ' ',
                        counts.scales.cell(scale), counts.mean(scale), *least, *most,
                        scale < fit.slopes.size() ? fmt::format("{:.4f}", fit.slopes[scale]) : "");
    }
    return text + fmt::format(
                      "\n  means over {} grids; the slope is that to the next finer scale; * "
                      "scales used\n",
                      counts.counts.front().size());
}

}  // namespace

nlohmann::ordered_json exact_json(const ExactDimension& exact) {
    nlohmann::ordered_json json{{"status", status_name(exact.status)},
                                {"formula", nullptr},
                                {"value", nullptr},
                                {"decimal", nullptr}};
    if (exact.value) json.update(formula_json(exact.value));
    json["conditions"] = exact.conditions;
    json["similarity"] = formula_json(exact.similarity);
    json["boundary"] = formula_json(exact.boundary);
    return json;
}

std::string dimension_page(const Measured& found) {
    return found.what + "\n\n" + (found.exact ? exact_page(*found.exact) : "") + box_page(found);
}

nlohmann::ordered_json dimension_json(const Measured& found) {
    nlohmann::ordered_json json{{"input", found.what}};
    if (found.generation) json["generation"] = *found.generation;
    if (found.exact) json["exact"] = exact_json(*found.exact);
    json["box"] = box_json(found);
    return json;
}

}  // namespace algae::cli
