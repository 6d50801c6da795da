#include "cli/dimension_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <vector>

#include "base/error.hpp"
#include "cli/command.hpp"
#include "cli/dimension_report.hpp"
#include "cli/input.hpp"
#include "cli/output.hpp"
#include "dimension/exact_dimension.hpp"
#include "dimension/limit_fit.hpp"
#include "notation/gallery.hpp"
#include "notation/read.hpp"

namespace algae::cli {

namespace {

using Found = ExactDimension::Status;
using Json = nlohmann::ordered_json;

constexpr std::size_t formula_width = 38, longest_reason = 90;

struct Entry {
    std::string name;
    LSystem system;
};

/// All systems of the gallery, or of a folder, in order of their names.
std::vector<Entry> entries(const std::string& folder, const Budget& budget) {
    std::vector<Entry> all;
    if (folder.empty()) {
        for (const GalleryEntry& entry : gallery())
            all.push_back(
                {std::string(entry.name), read_lsystem(entry.text, std::string(entry.name))});
        return all;
    }
    std::error_code ignored;
    if (!std::filesystem::is_directory(folder, ignored))
        throw Error(folder + ": expected a folder with .lsys files for --table");
    std::vector<std::filesystem::path> files;
    for (const auto& file : std::filesystem::recursive_directory_iterator(folder))
        if (file.is_regular_file() && file.path().extension() == ".lsys")
            files.push_back(file.path());
    if (files.empty()) throw Error(folder + ": expected .lsys files in this folder, found none");
    std::sort(files.begin(), files.end());
    for (const auto& file : files)
        all.push_back({file.stem().string(), open_system(file.string(), budget)});
    return all;
}

/// One system, what its rules give and what was measured.
struct Row {
    std::string name, title;
    ExactDimension exact;
    std::optional<BoxFit> fit;
    std::string unmeasured;   // why it was not, where it was to be
    bool unfinished = false;  // because the budget was used up

    /// The number that measurements are compared with: an upper bound above 2 is 2.
    double value() const { return std::min(exact.value->enclosure(64).midpoint(), 2.0); }
    std::optional<double> difference() const {
        if (!fit || !fit->estimate || exact.status != Found::exact) return std::nullopt;
        return fit->estimate->value - value();
    }
};

Row row_of(const Entry& entry, const DimensionTable& table, const Budget& budget) {
    Row row{entry.name, entry.system.title, {}, {}, {}};
    try {
        row.exact = exact_dimension(entry.system, budget);
    } catch (const BoundReached& bound) {
        row.exact.status = Found::unfinished;
        row.exact.conditions.push_back(bound.what());
    }
    row.unfinished = row.exact.status == Found::unfinished;
    if (row.unfinished) row.unmeasured = row.exact.conditions.back();
    if (row.unfinished || row.exact.status == Found::none || table.quick) return row;
    if (!row.exact.limit) {
        row.unmeasured = "the rules do not lead to similar parts of one size";
        return row;
    }
    LimitCounting counting;
    counting.places = table.grids;
    counting.most_cells = table_cells;
    try {
        row.fit = measure_limit(row.exact, counting, budget).fit;
        if (!row.fit->estimate) row.unmeasured = row.fit->because;
    } catch (const BoundReached& bound) {
        row.unmeasured = bound.what();
        row.unfinished = is_of_budget(bound.bound());
    }
    return row;
}

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

std::string line(const Row& row, std::size_t width) {
    const bool exact = row.exact.status == Found::exact;
    std::string text = fmt::format(
        "{:<{}}  {:<{}}  {:>2}{:.6f}  {:>8}", row.name, width, short_formula(*row.exact.value),
        formula_width, exact ? "" : "<=", row.value(),
        row.exact.boundary ? fmt::format("{:.6f}", row.exact.boundary->enclosure(64).midpoint())
                           : "");
    if (row.fit && row.fit->estimate) {
        const Estimate& found = *row.fit->estimate;
        text += fmt::format("  {:.4f} in [{:.4f}, {:.4f}]", found.value, found.low, found.high);
        if (const auto difference = row.difference()) text += fmt::format("  {:+.4f}", *difference);
    } else if (!row.unmeasured.empty()) {
        text += "  undecided: " + shortened(row.unmeasured);
    }
    return text.substr(0, text.find_last_not_of(' ') + 1) + "\n";
}

Json json_of(const Row& row, bool quick) {
    Json json{{"name", row.name}, {"title", row.title}, {"exact", exact_json(row.exact)}};
    if (quick) return json;
    Json measured = nullptr;
    if (row.fit && row.fit->estimate)
        measured = {{"value", row.fit->estimate->value},
                    {"low", row.fit->estimate->low},
                    {"high", row.fit->estimate->high}};
    json["measured"] = measured;
    json["difference"] = row.difference() ? Json(*row.difference()) : Json(nullptr);
    if (!row.unmeasured.empty()) json["because"] = row.unmeasured;
    return json;
}

}  // namespace

int print_dimension_table(const DimensionTable& table, const Budget& budget) {
    const std::vector<Entry> all = entries(table.folder, budget);
    std::size_t width = 0;
    for (const Entry& entry : all) width = std::max(width, entry.name.size());
    Json array = Json::array();
    std::string without, unfinished;
    bool complete = true;
    if (!table.json)
        print(fmt::format("{:<{}}  {:<{}}  {:>10}  {:>8}{}\n", "curve", width, "formula",
                          formula_width, "dimension", "boundary",
                          table.quick ? "" : "  measured                    difference"));
    ProgressBar bar("dimension");
    for (std::size_t i = 0; i < all.size(); ++i) {
        const Row row = row_of(all[i], table, budget);
        complete = complete && !row.unfinished;
        const auto named_reason = [&] {
            return fmt::format("{:<{}}  {}\n", row.name, width,
                               shortened(row.exact.conditions.back()));
        };
        if (table.json)
            array.push_back(json_of(row, table.quick));
        else if (row.exact.status == Found::none)
            without += named_reason();
        else if (row.exact.status == Found::unfinished)
            unfinished += named_reason();
        else
            print(line(row, width));
        bar.report(static_cast<double>(i + 1) / static_cast<double>(all.size()));
    }
    if (table.json) print(array.dump(2) + "\n");
    if (!without.empty()) print("\nno formula:\n" + without);
    if (!unfinished.empty()) print("\nunfinished:\n" + unfinished);
    return complete ? success : undecided;
}

}  // namespace algae::cli
